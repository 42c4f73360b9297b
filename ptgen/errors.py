"""The family of errors that ptgen raises, and the problems that they carry.

Every error that a user can cause is a `PtgenError`. It holds one or more `Problem` records; each says
where, what was found, what was wanted and what to do.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

__all__ = ["ControlError", "ModelError", "Problem", "PtgenError", "RunError", "TestbedError", "nearest"]


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong, in a form that a person can act upon.

    Attributes
    ----------
    where : str
        The key inside the file, such as ``components.cardan2.stiffness``; empty for the file itself.
    what : str
        What was wanted and what was found.
    remedy : str
        What to do about it.
    """

    where: str
    what: str
    remedy: str

    def text(self, file: str = "") -> str:
        """Return the problem as one line, ``file: key: what; remedy``."""
        place = ": ".join(part for part in (file, self.where) if part)
        return f"{place}: {self.what}; {self.remedy}" if place else f"{self.what}; {self.remedy}"


class PtgenError(Exception):
    """An error that the user can mend.

    Parameters
    ----------
    problems : sequence of Problem
        All problems that were found.
    file : str
        The file in which they were found; empty when no file is concerned.
    """

    def __init__(self, problems: Problem | Sequence[Problem], file: str = "") -> None:
        self.problems: tuple[Problem, ...] = (problems,) if isinstance(problems, Problem) else tuple(problems)
        self.file = file
        super().__init__("\n".join(problem.text(file) for problem in self.problems))


class TestbedError(PtgenError):
    """A test bed file or a scenario file has problems."""

    __test__ = False  # the name begins with Test, but it is no test case


class ModelError(PtgenError):
    """A bed is readable, but no model can be made of it."""


class ControlError(PtgenError):
    """No controller exists for the roles that were asked for."""


class RunError(PtgenError):
    """Building or running the emitted code failed."""


def nearest(word: str, known: Iterable[str]) -> str:
    """Return a hint that names the known word nearest to `word`, or all of them.

    Examples
    --------
    >>> nearest("stifness", ["stiffness", "damping"])
    'did you mean "stiffness"?'
    >>> nearest("x", ["stiffness", "damping"])
    'known are: damping, stiffness'
    """
    names = sorted(known)
    close = difflib.get_close_matches(word, names, n=1)
    return f'did you mean "{close[0]}"?' if close else "known are: " + ", ".join(names)

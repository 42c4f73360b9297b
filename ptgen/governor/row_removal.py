r"""Which rows of a constraint set are needed: removal of those that bind by less than a stated share of the limit.

A row says that a torque command some steps ahead keeps its limit, :math:`-s_i \le w_i + c_{i,k} \xi \le s_i`, with the
limit :math:`s_i`, the torque at rest :math:`w_i`, measured disturbance included, and the distance from rest
:math:`\xi`. A linear program finds by how much a row can be violated while the kept ones hold,

.. math:: \max\; w_i + c_{i,k} \xi - (1 + \varepsilon) s_i \quad\text{over the states that can occur.}

If that is not positive, the row may go. All of it is homogeneous in :math:`(w, \xi)`; so if the kept rows hold with
:math:`s / (1 + \varepsilon)`, all removed ones hold with s, and removal is safe: it costs the share
:math:`\varepsilon / (1 + \varepsilon)` of the torque limits, no more.

The states that can occur:

- no state alone asks a machine for more than `OCCURRING` times its limit, at any time ahead;
- at rest the torque keeps :math:`|w_i| \le (1 - \varepsilon_\infty) s_i`, which is seen to before (7.34);
- the limit is between the machine's torque at its largest speed (field weakening) and its largest torque; machines vary
  on their own.
"""

from __future__ import annotations

import io
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import Problem, RunError

__all__ = ["OCCURRING", "Needed", "RowFamily", "needed_rows"]

Array = NDArray[np.float64]

OCCURRING = 2.0
"""How many times its limit a state alone may ask a machine for."""

_SELECTION = "ptgen.governor.row_selection"
"""The module that solves the linear programs, run as a program."""


@dataclass(frozen=True)
class RowFamily:
    """All rows of a horizon, as shares of the machines' largest limits.

    Attributes
    ----------
    rows : ndarray (m, K, n)
        ``c[i, k]`` for the steps k = 0 .. K - 1.
    least_limit : ndarray (m,)
        The least limit of each machine as a share of its largest.
    stationary_reserve : float
        eps_inf.
    """

    rows: Array
    least_limit: Array
    stationary_reserve: float

    @property
    def scale(self) -> Array:
        """What a state may be, (n,)."""
        largest = np.abs(self.rows).max(axis=(0, 1))
        return np.asarray(OCCURRING / np.where(largest > 0, largest, 1.0), dtype=np.float64)


@dataclass(frozen=True)
class Needed:
    """The rows that are needed.

    Attributes
    ----------
    steps : tuple of ndarray
        For each machine the steps k >= 0 whose rows are kept, in order; 0 is always among them.
    binding : ndarray (m, K)
        By how much each row that was removed can still be violated while the kept ones hold, as a share of the limit;
        a bound from above, at most the epsilon asked for, and negative if there is room left. Zero for kept rows.
    programs : int
        How many linear programs were solved.
    """

    steps: tuple[NDArray[np.int64], ...]
    binding: Array
    programs: int


def needed_rows(
    family: RowFamily, epsilon: float, progress: Callable[[float], None] | None = None, horizon: int | None = None
) -> Needed:
    """Return rows that are enough.

    Parameters
    ----------
    family : RowFamily
    epsilon : float
        Share of the limit by which a row may bind and yet be removed.
    progress : callable, optional
        Called now and then with the share of the work that is done.
    horizon : int, optional
        Keep no row behind this step; those behind are looked at all the same, and `binding` may exceed `epsilon` there.

    Notes
    -----
    Machine by machine, from the present on: the first row that binds by more than epsilon calls for another one, which
    is put as far ahead as those between allow. In the end all rows are looked at with all that are kept.
    The linear programs are solved in a process of their own: HiGHS has to be loaded by itself there, because CasADi
    brings another version of the same library.

    Raises
    ------
    RunError
        If that process fails.
    """
    stream = io.BytesIO()
    np.savez(
        stream,
        rows=family.rows,
        least_limit=family.least_limit,
        numbers=np.array([family.stationary_reserve, epsilon, -1.0 if horizon is None else horizon]),
    )
    content = _run(stream.getvalue(), progress)
    try:
        with np.load(io.BytesIO(content)) as found:
            steps = tuple(found[f"steps_{i}"].astype(np.int64) for i in range(len(family.rows)))
            return Needed(steps, found["binding"], int(found["programs"]))
    except (OSError, ValueError, KeyError, EOFError) as error:
        raise RunError(_failed(f"its answer cannot be read ({error})")) from None


def _run(content: bytes, progress: Callable[[float], None] | None) -> bytes:
    """Run the selection on `content` and return what it answers; its first lines tell the progress."""
    try:
        process = subprocess.Popen(
            [sys.executable, "-m", _SELECTION], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
    except OSError as error:
        raise RunError(_failed(f"it cannot be started ({error.strerror or error})")) from None
    with process:
        try:
            pipe: Any = process.stdin
            pipe.write(content)
            pipe.close()
            answer: Any = process.stdout
            for line in answer:
                if line == b"answer\n":
                    return bytes(answer.read())
                if progress is not None:
                    progress(float(line))
            process.wait()
            pipe = process.stderr
            said = pipe.read().decode(errors="replace").strip().splitlines()
        except BrokenPipeError:
            said = ["it ended before it had read the rows"]
        finally:
            if process.poll() is None:
                process.kill()
    raise RunError(_failed(said[-1] if said else f"it ended with code {process.returncode}"))


def _failed(why: str) -> Problem:
    what = f"the rows that are needed could not be selected: {why}"
    return Problem("governor", what, "check that the package highspy is installed")

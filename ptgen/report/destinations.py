"""Where reports are written to, checked before the work that leads to them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from ptgen.errors import Problem, RunError

__all__ = ["check_destination"]


def check_destination(path: Path, suffixes: Sequence[str], option: str) -> None:
    """Check, before long work is done for it, that a file can be written.

    Parameters
    ----------
    path : Path
        The file to be written.
    suffixes : sequence of str
        The suffixes that ptgen can write, such as ``".svg"``.
    option : str
        The option of the command line that named the file; errors point to it.

    Raises
    ------
    RunError
        If the suffix is another one, or the folder does not exist or cannot be written to.
    """
    known = ", ".join(suffixes[:-1]) + f" or {suffixes[-1]}" if len(suffixes) > 1 else suffixes[0]
    if path.suffix.lower() not in suffixes:
        ending = f'"{path.suffix}"' if path.suffix else "none"
        raise RunError(
            Problem(option, f"must name a file that ends in {known}, got {path.name!r}, whose ending is {ending}",
                    f"write e.g. {option} {path.with_suffix(suffixes[0]).name}"),
            str(path),
        )  # fmt: skip
    if path.is_dir():
        raise RunError(Problem(option, "is a folder", f"name a file in it that ends in {known}"), str(path))
    folder = path.parent
    if not folder.is_dir():
        raise RunError(Problem(option, f'the folder "{folder}" does not exist', "create it first"), str(path))
    if not os.access(folder, os.W_OK | os.X_OK):
        raise RunError(Problem(option, f'the folder "{folder}" cannot be written to', "choose another one"), str(path))

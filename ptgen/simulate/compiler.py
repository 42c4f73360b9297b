"""Finding a C compiler and making a shared library with it."""

from __future__ import annotations

import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from ptgen.errors import Problem, RunError

__all__ = ["FLAGS", "compile_library", "find_compiler"]

FLAGS = ("-std=c99", "-O2", "-ffp-contract=off", "-fPIC", "-shared")
"""Without contraction of a*b+c, results are the same on every processor."""


def find_compiler() -> tuple[str, ...]:
    """Return the command of a C compiler: ``$CC``, else ``cc``, ``gcc``, ``clang``, else that of ziglang.

    Raises
    ------
    RunError
        If there is none.
    """
    named = os.environ.get("CC")
    if named:
        command = tuple(shlex.split(named))
        if command and shutil.which(command[0]):
            return command
        raise RunError(
            Problem(
                "", f"the compiler named by the environment variable CC, {named!r}, is not found", "correct or unset CC"
            )
        )
    for name in ("cc", "gcc", "clang"):
        if shutil.which(name):
            return (name,)
    if importlib.util.find_spec("ziglang") is not None:
        return (sys.executable, "-m", "ziglang", "cc")
    raise RunError(
        Problem("", "no C compiler is found", "install one (package gcc or clang), or: pip install 'ptgen[cc]'")
    )


def compile_library(sources: Sequence[Path], library: Path, compiler: Sequence[str] | None = None) -> None:
    """Compile `sources` into the shared library `library`, written whole or not at all.

    Raises
    ------
    RunError
        If the compiler fails; the error holds its first messages.
    """
    command = tuple(compiler) if compiler else find_compiler()
    handle, name = tempfile.mkstemp(dir=library.parent, prefix=f".{library.name}.")
    os.close(handle)
    temporary = Path(name)
    try:
        result = subprocess.run(
            [*command, *FLAGS, "-o", str(temporary), *map(str, sources), "-lm"],
            capture_output=True,
            text=True,
            check=False,
        )
        if result.returncode != 0:
            said = "\n".join(result.stderr.strip().splitlines()[:10])
            raise RunError(
                Problem("", f"the compiler {shlex.join(command)} failed:\n{said}\n", "try another one with CC=clang")
            )
        temporary.replace(library)
    finally:
        temporary.unlink(missing_ok=True)

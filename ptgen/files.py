"""Writing files so that nobody ever sees half of one."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from ptgen.errors import Problem, PtgenError, RunError

__all__ = ["cache_folder", "replace_file", "write_file", "write_files"]


def cache_folder() -> Path:
    """Return the folder for what can be made again: ``$XDG_CACHE_HOME/ptgen`` or ``~/.cache/ptgen``, else a new one.

    Raises
    ------
    RunError
        If there is none, and none can be made.
    """
    base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "ptgen"
    try:
        base.mkdir(parents=True, exist_ok=True)
        if os.access(base, os.W_OK):
            return base
    except OSError:
        pass
    try:
        return Path(tempfile.mkdtemp(prefix="ptgen-"))
    except OSError as error:
        what = f"no folder for compiled code can be made ({error})"
        raise RunError(Problem("", what, "set XDG_CACHE_HOME to a folder you may write")) from None


def replace_file(path: Path, content: bytes, check: Callable[[Path], None]) -> None:
    """Write new content of a file that is there to a temporary file beside it, check that one, and rename it.

    Permissions stay; a link stays a link.

    Parameters
    ----------
    path : Path
    content : bytes
    check : callable
        Takes the temporary file; what it raises leaves the old one as it is.

    Raises
    ------
    PtgenError
        If the file does not exist or cannot be written.
    """
    try:
        target = path.resolve(strict=True)
        mode = target.stat().st_mode & 0o777
        if not mode & 0o222 or not os.access(target, os.W_OK):
            what = "cannot be written (it is read-only)"
            raise PtgenError(Problem("", what, "allow writing, or copy the file first"), str(path))
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
        temporary = Path(name)
        try:
            with os.fdopen(handle, "wb") as stream:
                stream.write(content)
            check(temporary)
            temporary.chmod(mode)
            temporary.replace(target)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise
    except OSError as error:
        what = f"cannot be written ({error.strerror or error})"
        raise PtgenError(Problem("", what, "check file and folder, and that you may write there"), str(path)) from None


def write_file(path: Path, content: str | bytes) -> None:
    """Write `content` to a temporary file beside `path`, then rename it.

    Raises
    ------
    PtgenError
        If the folder does not exist or cannot be written.
    """
    data = content.encode("utf-8") if isinstance(content, str) else content
    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        temporary = Path(name)
        try:
            with os.fdopen(handle, "wb") as stream:
                stream.write(data)
            temporary.chmod(0o644)
            temporary.replace(path)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise
    except OSError as error:
        what = f"cannot be written ({error.strerror or error})"
        raise PtgenError(
            Problem("", what, "check that the folder exists and that you may write there"), str(path)
        ) from None


def write_files(directory: Path, contents: Mapping[str, str | bytes]) -> list[Path]:
    """Write several files below `directory`, which is made if needed; return their paths.

    Files that are already there with the same content keep their time, so that nothing is compiled anew.

    Raises
    ------
    PtgenError
        As `write_file`.
    """
    paths = []
    for name, content in contents.items():
        path = directory / name
        data = content.encode("utf-8") if isinstance(content, str) else content
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            what = f"cannot be made ({error.strerror or error})"
            raise PtgenError(Problem("", what, "choose another output folder"), str(path.parent)) from None
        if not path.is_file() or path.read_bytes() != data:
            write_file(path, data)
        paths.append(path)
    return paths

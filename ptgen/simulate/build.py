"""From a bed to loaded code: emit, compile, load."""

from __future__ import annotations

import hashlib
from pathlib import Path

from ptgen.emit.c_expressions import Precision
from ptgen.emit.project import project_files
from ptgen.files import cache_folder, write_files
from ptgen.project import Project
from ptgen.simulate.compiler import FLAGS, compile_library, find_compiler
from ptgen.simulate.library import Library

__all__ = ["build"]


def build(project: Project, directory: Path | None = None, precision: Precision = "double") -> Library:
    """Emit, compile and load the code of a bed.

    Parameters
    ----------
    project : Project
    directory : Path, optional
        Where the C project and the library go. Without it they go to a cache, in which the same code is compiled
        only once.
    precision : {"double", "float"}

    Raises
    ------
    PtgenError
        From any stage; `RunError` if there is no compiler or it fails.
    """
    files = project_files(project, precision)
    prefix = project.testbed.name
    compiler = find_compiler()
    digest = hashlib.sha256(repr((sorted(files.items()), compiler, FLAGS)).encode()).hexdigest()
    folder = directory if directory is not None else cache_folder() / f"{prefix}-{digest[:16]}"
    write_files(folder, files)
    # The name tells the content: a library that is loaded already is never replaced.
    library = folder / f"lib{prefix}-{digest[:16]}.so"
    if not library.exists():
        sources = [name for name in files if name.endswith(".c") and "/" not in name and name != f"{prefix}_main.c"]
        compile_library([folder / name for name in sources], library, compiler)
    return Library(library.resolve(), prefix, project.blocks(), precision)

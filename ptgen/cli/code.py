"""Commands that write code: generate, build."""

from __future__ import annotations

from pathlib import Path

from ptgen.cli.options import AsJson, BedFile, Directory, Precision, PrecisionOption
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts
from ptgen.errors import Problem, RunError

__all__ = ["build", "generate"]


@reported
def generate(
    file: BedFile,
    output: Directory,
    precision: PrecisionOption = Precision.double,
    as_json: AsJson = False,
) -> None:
    """Write the C project of a bed: controller, plant, their support and a runner."""
    from ptgen.emit.project import generate as emit
    from ptgen.project import Project

    _check_folder(output)
    project = Project.read(file)
    files = emit(project, output, precision.value)
    if as_json:
        print_json(
            {
                "name": project.testbed.name,
                "directory": str(output),
                "precision": precision.value,
                "files": [str(path) for path in files],
            }
        )
    else:
        print_parts([f"{len(files)} files in {output}", *(f"  {_inside(path, output)}" for path in files)])


@reported
def build(
    file: BedFile,
    output: Directory,
    precision: PrecisionOption = Precision.double,
    as_json: AsJson = False,
) -> None:
    """Write the C project of a bed and compile it to a shared library."""
    from ptgen.project import Project
    from ptgen.simulate.build import build as compile_project

    _check_folder(output)
    project = Project.read(file)
    library = compile_project(project, output, precision.value)
    if as_json:
        print_json(
            {
                "name": project.testbed.name,
                "directory": str(output),
                "precision": precision.value,
                "library": str(library.path),
            }
        )
    else:
        print_parts([str(library.path)])


def _check_folder(path: Path) -> None:
    """Check that `path` is a folder or does not exist yet; folders above it are made with it."""
    if path.is_dir():
        return
    if path.exists():
        raise RunError(Problem("--output", "is a file, not a folder", "name a folder"), str(path))


def _inside(path: Path, folder: Path) -> Path:
    return path.relative_to(folder) if path.is_relative_to(folder) else path

"""Whatever comes in, in whatever order: no torque beyond a machine, no NaN, no undefined behaviour, no dead end."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from governor.governed_beds import governed

from ptgen.emit.project import project_files
from ptgen.files import write_files
from ptgen.project import Project

pytestmark = pytest.mark.compile

DRIVER = Path(__file__).parent / "controller_fuzz.c"
COMPILER = next((name for name in ("gcc", "clang", "cc") if shutil.which(name)), None)
SANITIZERS = "address,undefined,float-cast-overflow"


def driver(project: Project, folder: Path, *flags: str) -> Path:
    """Return the compiled driver of a bed."""
    assert COMPILER is not None
    prefix, block = project.testbed.name, project.controller
    write_files(folder, project_files(project))
    values = {s.name: s.value for s in block.parameters}
    ratings = ", ".join(repr(values[s.name.replace("_torque_ref", "_torque_max")]) for s in block.outputs)
    ratios = " ".join(
        f"in.{s.name} = {values[f'{s.name}_least']!r};" for s in block.inputs if f"{s.name}_least" in values
    )
    parts = [folder / f"{prefix}_{part}.c" for part in ("controller", "support", "governor")]
    sources = [str(DRIVER), *(str(part) for part in parts if part.is_file())]
    options = [f"-DBED={prefix}", f'-DCONTROLLER_HEADER="{prefix}_controller.h"', f"-DRATINGS={ratings}"]
    options += [f"-DGEARBOX_RATIOS={ratios}", f"-I{folder}"]
    program = folder / "fuzz"
    command = [COMPILER, "-std=c99", "-ffp-contract=off", *flags, *options, "-o", str(program), *sources, "-lm"]
    subprocess.run(command, check=True, capture_output=True, text=True)
    return program


def said(program: Path, rounds: int, seed: int, checked: bool) -> str:
    result = subprocess.run(
        [program, str(rounds), str(seed), str(int(checked))], check=False, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stdout + result.stderr[:3000]
    assert result.stderr == ""
    return result.stdout


@pytest.fixture(params=["none", "sequential_modified", "own"])
def any_project(request: pytest.FixtureRequest, project: Project) -> Project:
    """Every bed without and with a reference governor, and with that of its file."""
    if request.param != "own":
        return governed(project, request.param)
    if not project.testbed.governor.is_chosen:
        pytest.skip("the file has no governor")
    return project


@pytest.mark.skipif(COMPILER is None, reason="needs a C compiler with sanitizers")
def test_sanitizers_find_nothing(any_project: Project, tmp_path: Path) -> None:
    """Divisions by zero are defined in IEEE arithmetic, and unchecked parameters make some; all else is watched."""
    project = any_project
    program = driver(project, tmp_path, "-O1", "-g", f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=all")
    for seed, checked in ((1, True), (2, False)):
        said(program, 300, seed, checked)


@pytest.mark.skipif(COMPILER is None, reason="needs a C compiler")
def test_a_million_steps_with_anything(any_project: Project, tmp_path: Path) -> None:
    project = any_project
    program = driver(project, tmp_path, "-O2")
    for seed in (3, 4):
        for checked in (True, False):
            found = re.match(r"(\d+) steps, (\d+) with a fault", said(program, 1000, seed, checked))
            assert found is not None
            steps, faults = map(int, found.groups())
            assert steps >= 300_000
            assert 0.1 < faults / steps < 0.95  # the controller runs for a good part of it

"""The emitted project: reproducible, equal to what is committed, free of warnings, well behaved."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.emit.friction_source import uses_friction
from ptgen.emit.project import generate, project_files
from ptgen.errors import PtgenError
from ptgen.project import Project

BEDS = Path(__file__).resolve().parents[2] / "testbeds"
STRICT = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-pedantic", "-Werror"]


@pytest.mark.parametrize("stem", sorted(path.stem for path in BEDS.glob("*.toml")))
def test_generated_folder_is_what_the_beds_give(stem: str, projects: dict[str, Project], root: Path) -> None:
    """If this fails on purpose: run ``make generated`` and look at the differences before committing them."""
    project = projects[stem.replace("-", "_")]
    folder = root / "generated" / project.testbed.name.replace("_", "-")
    committed = {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    emitted = {name: text.encode() if isinstance(text, str) else text for name, text in project_files(project).items()}
    assert sorted(committed) == sorted(emitted)
    differing = [name for name in emitted if committed[name] != emitted[name]]
    assert differing == []


def test_emission_is_reproducible(root: Path) -> None:
    path = root / "testbeds" / "differential.toml"
    assert project_files(Project.read(path)) == project_files(Project.read(path))


@pytest.mark.compile
@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_compiles_without_warnings(compiler: str, precision: str, project: Project, tmp_path: Path) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    generate(project, tmp_path, precision)
    sources = sorted(tmp_path.glob("*.c"))
    assert len(sources) == 5 + bool(uses_friction(project.plant)) + project.testbed.governor.is_chosen
    for source in sources:
        command = [compiler, *STRICT, "-c", str(source), "-o", str(source.with_suffix(".o"))]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stderr
        assert result.stderr == ""


def test_c_obeys_the_rules_for_embedded_code(project: Project) -> None:
    for name, text in project_files(project).items():
        if not name.endswith(".c") or name.startswith("casadi") or name.endswith("_main.c"):
            continue
        assert isinstance(text, str)
        assert not re.search(r"\b(malloc|calloc|realloc|free|alloca) *\(|\bgoto\b", text), name
        # What is static is constant, or a function.
        globals_ = [line for line in re.findall(r"^static (?!const).*", text, re.M) if "(" not in line]
        assert globals_ == [], f"{name} has a global that changes"
        assert not re.search(r"__DATE__|__TIME__", text)
        assert "Emitted by ptgen" in text


@pytest.mark.compile
def test_program_runs_a_csv_of_references(projects, tmp_path: Path) -> None:
    generate(projects["differential"], tmp_path)
    program = tmp_path / "main"
    subprocess.run(["cc", "-std=c99", "-O2", "-o", program, *tmp_path.glob("*.c"), "-lm"], check=True)
    references = tmp_path / "references.csv"
    references.write_text("time,diff_input_torque_ref,M2_speed_ref,M3_speed_ref\n0,0,0,0\n1,100,10,10\n2,100,10,10\n")
    result = subprocess.run([program, references, "2", "100"], capture_output=True, text=True, check=True)
    rows = [line.split(",") for line in result.stdout.splitlines()]
    assert len(rows) == 201
    last = dict(zip(rows[0], map(float, rows[-1]), strict=True))
    assert abs(last["M2_speed"] - 10) < 0.5 and abs(last["diff_input_torque"] - 100) < 5
    assert subprocess.run([program], capture_output=True, check=False).returncode == 2


def test_casadi_files_load_and_agree(project: Project, tmp_path: Path) -> None:
    generate(project, tmp_path)
    block, prefix = project.plant, project.testbed.name
    prepare = ca.Function.load(str(tmp_path / "casadi" / f"{prefix}_plant_prepare.casadi"))
    step = ca.Function.load(str(tmp_path / "casadi" / f"{prefix}_plant_step.casadi"))
    parameters = [signal.value for signal in block.parameters]
    states = np.zeros(len(CasadiBlock.names(block.states)))
    inputs = np.full(len(block.inputs), 100.0)
    _, outputs = step(parameters, prepare(parameters), states, inputs)
    evaluator = NumpyBlock(block)
    defaults = evaluator.defaults()
    given = {signal.name: np.array(100.0) for signal in block.inputs}
    _, expected = evaluator.step(defaults, evaluator.prepare(defaults), evaluator.initial(), given)
    assert np.allclose(outputs.full().ravel(), [float(expected[s.name]) for s in block.outputs], rtol=1e-12)


def test_nothing_is_written_into_a_file_that_stands_in_the_way(projects, tmp_path: Path) -> None:
    target = tmp_path / "out"
    target.write_text("precious")
    with pytest.raises(PtgenError, match="cannot be made"):
        generate(projects["back_to_back"], target)
    assert target.read_text() == "precious"


def test_files_with_equal_content_keep_their_time(projects, tmp_path: Path) -> None:
    paths = generate(projects["back_to_back"], tmp_path)
    times = [path.stat().st_mtime_ns for path in paths]
    assert [path.stat().st_mtime_ns for path in generate(projects["back_to_back"], tmp_path)] == times

"""Ratios that change at run time in closed loop: evaluators, recordings, the runner, what is refused."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

from ptgen.block.block import Block
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.emit.project import generate, recorded_signals
from ptgen.errors import RunError
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import CompiledBlock
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario

pytestmark = pytest.mark.compile

H = 1e-4
MACHINE = """
[components.{name}]
type = "machine"
inertia = "{inertia} kg m^2"
torque_max = "900 N m"
speed_rated = "3000 rpm"
speed_max = "9000 rpm"
inverter = {{ model = "lag", dead_time = "130 us", time_constant = "250 us" }}
sensor = {{ time_constant = "100 us" }}
"""
BED = f"""
[testbed]
name = "shifting"
sample_time = "100 us"
connections = ["M1 - flange1 - shaft1 - gearbox - bearing - clutch - shaft2 - flange2 - M2"]
{MACHINE.format(name="M1", inertia=1.0)}
{MACHINE.format(name="M2", inertia=3.0)}
[components.flange1]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "380 kN m/rad"
[components.flange2]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "380 kN m/rad"
[components.shaft1]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "3 N m s/rad"
[components.shaft2]
type = "shaft"
stiffness = "60 kN m/rad"
damping = "5 N m s/rad"
[components.gearbox]
type = "gearbox"
ratio = 2.0
ratio_range = [0.5, 4.0]
inertia = "0.05 kg m^2"
[components.bearing]
type = "bearing"
coulomb = "1 N m"
[components.clutch]
type = "clutch"
capacity = "800 N m"
inertia_output = "0.1 kg m^2"

[control]
speed = ["M1", "M2"]
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    file = tmp_path_factory.mktemp("bed") / "bed.toml"
    file.write_text(BED, encoding="utf-8")
    return Project.read(file)


@pytest.fixture(scope="module")
def plant(project: Project) -> CompiledBlock:
    return build(project).plant


def inputs(k: int) -> dict[str, float]:
    """Return the inputs of a step: the ratio rests, runs and jumps."""
    ratio = 2.0 + (0.0 if k < 10 else 0.01 * (k - 10) if k < 60 else 1.0)
    torques = {"M1_torque_ref": 200 * np.sin(0.2 * k) + 100, "M2_torque_ref": -150.0}
    return {**torques, "clutch_actuation": 0.7, "gearbox_ratio": ratio}


def along_numpy(block: Block, steps: int) -> list[dict[str, float]]:
    evaluator = NumpyBlock(block)
    parameters = evaluator.defaults()
    derived, states, rows = evaluator.prepare(parameters), evaluator.initial(), []
    for k in range(steps):
        given = {name: np.asarray(value, dtype=float) for name, value in inputs(k).items()}
        states, outputs = evaluator.step(parameters, derived, states, given)
        assert evaluator.measure(parameters, derived, states) == outputs
        rows.append({name: float(value) for name, value in outputs.items()})
    return rows


def along_c(compiled: CompiledBlock, steps: int) -> list[dict[str, float]]:
    params = compiled.defaults()
    status, state = compiled.init(params)
    assert status == 0
    rows = []
    for k in range(steps):
        status, outputs = compiled.step(state, params, inputs(k))
        assert status == 0, compiled.status_text(status)
        rows.append(outputs)
    return rows


def along_casadi(block: Block, steps: int) -> list[dict[str, float]]:
    functions = CasadiBlock(block)
    given = np.concatenate([np.full(s.size, s.value) for s in block.parameters])
    derived = functions.prepare(given)
    states = np.concatenate([np.full(s.size, s.value) for s in block.states])
    rows = []
    for k in range(steps):
        values = inputs(k)
        states, outputs = functions.step(given, derived, states, [values[s.name] for s in block.inputs])
        rows.append(dict(zip(functions.names(block.outputs), np.array(outputs.full())[:, 0].tolist(), strict=True)))
    return rows


def test_three_evaluators_agree_while_the_ratio_changes(project: Project, plant: CompiledBlock) -> None:
    reference = along_c(plant, 90)
    for rows in (along_numpy(project.plant, 90), along_casadi(project.plant, 90)):
        for name in reference[0]:
            expected, got = (np.array([row[name] for row in table]) for table in (reference, rows))
            assert np.abs(got - expected).max() < 1e-9 * (1 + np.abs(expected).max()), name


def test_only_steps_that_change_the_ratio_prepare_anew(plant: CompiledBlock) -> None:
    params = plant.defaults()
    _, state = plant.init(params)
    steps = {k: inputs(k) for k in (0, 30, 31)}
    seen = []
    for k, repeat in ((0, 3), (30, 3), (31, 1)):
        for _ in range(repeat):
            plant.step(state, params, steps[k])
            seen.append(plant.read(state, "K"))
    assert all(np.array_equal(seen[0], seen[k]) for k in (1, 2))
    assert all(np.array_equal(seen[3], seen[k]) for k in (4, 5))
    assert not np.array_equal(seen[2], seen[3]) and not np.array_equal(seen[5], seen[6])
    fresh = NumpyBlock(plant.block)
    states = {**fresh.initial(), "gearbox_ratio_now": np.asarray(steps[31]["gearbox_ratio"])}
    assert seen[6] == pytest.approx(fresh.prepare(fresh.defaults(), states)["K"], rel=1e-9, abs=1e-12)


def test_a_ratio_out_of_range_is_refused_and_changes_nothing(plant: CompiledBlock) -> None:
    params = plant.defaults()
    _, state = plant.init(params)
    plant.step(state, params, inputs(40))
    before = bytes(state)
    for ratio in (0.4, 4.1, float("nan"), -2.0):
        status, _ = plant.step(state, params, {**inputs(41), "gearbox_ratio": ratio})
        assert plant.status_text(status) == "the input gearbox_ratio is outside its range 0.5 to 4"
        assert bytes(state) == before


def test_a_ratio_that_cannot_be_prepared_is_refused_and_changes_nothing(plant: CompiledBlock) -> None:
    """A body tuned to be so light that the exponential has no room for it any more."""
    params = plant.defaults()
    _, state = plant.init(params)
    for k in range(20):
        plant.step(state, params, inputs(k))
    params.clutch_inertia_output = 1e-9
    before = bytes(state)
    status, outputs = plant.step(state, params, inputs(20))
    assert plant.status_text(status).startswith("the parameters are too far")
    assert bytes(state) == before and outputs == plant.measure(state, params)
    status, _ = plant.step(state, plant.defaults(), inputs(20))
    assert status == 0


def run(project: Project, ratios: dict[str, Profile], **options) -> Recording:
    rest = Profile((0.0,), (0.0,), "lines")
    speed = Profile((0.0, 0.05), (0.0, 20.0), "lines")
    pressed = {"clutch": Profile((0.0,), (1.0,), "lines")}
    references = {"speed.M1": rest, "speed.M2": speed}
    return simulate(project, Scenario("case", "", "", 0.05, H, references, pressed, ratios=ratios), **options)


def test_recording_holds_the_ratio_in_the_middle_of_each_step(project: Project) -> None:
    course = Profile((10 * H, 20 * H), (2.0, 3.0), "lines")
    got = run(project, {"gearbox": course}).signals["gearbox_ratio"]
    assert got[:30] == pytest.approx(np.interp((np.arange(30) + 0.5) * H, course.time, course.value), abs=1e-12)


def test_a_gearbox_without_an_entry_keeps_its_ratio(project: Project) -> None:
    assert np.all(run(project, {}).signals["gearbox_ratio"] == 2.0)


def test_event_driven_plant_takes_constant_ratios_and_refuses_others(project: Project) -> None:
    constant = {"gearbox": Profile((0.0,), (2.5,), "lines")}
    emitted, events = run(project, constant), run(project, constant, method="events")
    assert np.all(events.signals["gearbox_ratio"] == 2.5)
    for name in ("M1_speed", "M2_speed"):
        assert np.abs(emitted.signals[name] - events.signals[name]).max() < 1e-3, name
    with pytest.raises(RunError) as caught:
        run(project, {"gearbox": Profile((0.0, 0.1), (2.0, 3.0), "lines")}, method="events")
    assert caught.value.problems[0].where == "ratios.gearbox"


def test_emitted_program_reads_ratios(project: Project, tmp_path: Path) -> None:
    """Without a column for it a ratio is that of the bed file."""
    generate(project, tmp_path)
    names = [signal.name for signal in recorded_signals(project)]
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-pedantic", "-Werror"]
    sources = [str(path) for path in sorted(tmp_path.glob("*.c"))]
    program = tmp_path / "runner"
    subprocess.run(["cc", *flags, "-O1", *sources, "-o", str(program), "-lm"], check=True)
    for head, row, expected in (("time,gearbox_ratio", "0,3.5", 3.5), ("time,M2_speed_ref", "0,1", 2.0)):
        (tmp_path / "profiles.csv").write_text(f"{head}\n{row}\n", encoding="ascii")
        result = subprocess.run(
            [str(program), str(tmp_path / "profiles.csv"), "0.01", "50"], check=True, capture_output=True, text=True
        )
        last = result.stdout.splitlines()[-1].split(",")
        assert float(last[1 + names.index("gearbox_ratio")]) == expected

"""The governor in the emitted controller: off it is not there, on it keeps limits, and nothing gets stuck."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from block import agreement
from controller_steps import Bench, Compiled, Controller
from governor.governed_beds import calm, governed

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.emit.project import generate
from ptgen.errors import ControlError
from ptgen.governor.shaping import governor_signals
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario, load, load_scenario

STRICT = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-pedantic", "-Werror"]

SWITCHES = ("load_compensation", "acceleration_torque")

SCENARIOS = {
    "all_wheel_drive": "all-wheel-drive-run",
    "back_to_back": "back-to-back-steps",
    "centre_differential": "centre-differential-run",
    "centre_differential_locked": "centre-differential-locked-run",
    "clutch_rig": "clutch-rig-engagement",
    "differential": "differential-torque-steps",
    "differential_gearboxes": "differential-gearboxes-run",
    "differential_governed": "differential-governed-run",
    "differential_output_torque": "differential-output-torque-run",
    "transmission": "transmission-run",
    "transmission_fixed_gear": "transmission-fixed-gear-run",
}


@pytest.fixture(scope="module")
def governed_bed(project: Project) -> Project:
    return governed(project, "sequential_modified")


@pytest.mark.compile
def test_without_it_every_bit_is_the_same(project: Project, governed_bed: Project) -> None:
    """With `governor` = 0 the outputs are those of the block without a governor, through faults and resets."""
    rng = np.random.default_rng(1)
    plain = build(governed(project, "none")).controller
    off = build(governed_bed).controller
    loops = []
    for compiled, changes in ((plain, {}), (off, {"governor": 0.0})):
        parameters = compiled.parameters(changes)
        status, state = compiled.init(parameters)
        assert status == 0
        loops.append((compiled, parameters, state))
    inputs = {s.name: 0.0 for s in plain.block.inputs}
    faults = 0
    for step in range(4000):
        for name in inputs:
            inputs[name] += rng.normal() * (0.2 if "speed" in name else 10.0)
            inputs[name] *= 0.999
        for parameter in project.design.decoupling.model.changing:
            inputs[parameter.symbol.name] = parameter.value
        given = {**inputs, "reset": float(step % 97 == 0)}
        if step % 400 > 380:
            given["M1_speed"] = np.nan
        results = [compiled.step(state, parameters, given) for compiled, parameters, state in loops]
        assert results[0] == results[1], step
        faults += results[0][0] != 0
    assert 0 < faults < 4000


@pytest.mark.compile
@pytest.mark.parametrize("seed", [None, 2, 3])
def test_all_evaluators_agree(governed_bed: Project, seed: int | None) -> None:
    block, compiled = governed_bed.controller, build(governed_bed).controller
    size = 300
    batch, rng = agreement.random_batch(block, size, seed or 1), np.random.default_rng(seed or 1)
    batch.states["running"] = (rng.random(size) < 0.9).astype(float)
    shares = 10.0 ** rng.uniform(-3, 0, size)
    for values in (batch.states, batch.inputs):
        calm(block, values, shares)
    found = set()
    for kind in (0.0, 1.0, 2.0):
        parameters = NumpyBlock(block).defaults() if seed is None else agreement.random_parameters(block, seed)
        parameters["governor"] = np.array(kind)
        reference = agreement.by_numpy(block, parameters, batch)
        found |= set(reference["governor_status"].tolist())
        for other in (agreement.by_casadi(block, parameters, batch), agreement.by_c(compiled, parameters, batch)):
            difference, where = agreement.largest_difference(block, reference, other)
            # A limit that is kept is a small difference of large numbers here: speeds that are far from each other.
            assert difference < (1e-9 if kind else 1e-12), where
    assert found == {0.0, 1.0, 2.0}


@pytest.mark.compile
@pytest.mark.parametrize("changed", [False, True])
def test_all_evaluators_agree_on_the_optimal_governor(projects: dict[str, Project], changed: bool) -> None:
    """Where it is in force, and where parameters are not those of the design and the sequential one holds."""
    bed = projects["differential_governed"]
    block, compiled, size = bed.controller, build(bed).controller, 300
    batch, rng = agreement.random_batch(block, size, 1), np.random.default_rng(1)
    designed = dict.fromkeys(SWITCHES, 1.0) | {s.name: s.value for s in block.parameters if s.name == "M1_damping"}
    for values in (batch.states, batch.inputs):
        calm(block, values, 10.0 ** rng.uniform(-3, 0, size))
    batch.states.update(running=np.ones(size), fault=np.zeros(size))
    for name, value in designed.items():
        batch.states.update({f"{name}_{end}": np.full(size, value) for end in ("now", "target")})
        batch.states[f"{name}_step"] = np.zeros(size)
    parameters = NumpyBlock(block).defaults()
    if changed:
        parameters["M2_speed_gain"] = 0.9 * parameters["M2_speed_gain"]
    reference = agreement.by_numpy(block, parameters, batch)
    found = set(reference["governor_status"].tolist())
    assert found == {4.0} if changed else found >= {0.0, 1.0, 2.0} and 4.0 not in found
    for other in (agreement.by_casadi(block, parameters, batch), agreement.by_c(compiled, parameters, batch)):
        difference, where = agreement.largest_difference(block, reference, other)
        assert difference < 1e-9, where


@pytest.mark.compile
def test_optimal_governor_keeps_limits_and_its_parameters_can_be_chosen(
    projects: dict[str, Project], root: Path
) -> None:
    """It runs its scenario with what the prediction allows; without prediction it keeps the limits of every step."""
    bed = projects["differential_governed"]
    assert bed.testbed.governor.kind == "optimal"
    scenario = load_scenario(root / "scenarios" / "differential-governed-run.toml", bed.testbed)
    recording = simulate(bed, scenario)
    assert not recording.signals["fault"].any()
    status = recording.signals["governor_status"]
    assert {0.0, 1.0} <= set(status.tolist()) <= {0.0, 1.0, 2.0}
    assert 0 < recording.signals["governor_iterations"].max() <= bed.testbed.governor.iterations
    for signal, end in (("diff_input_torque_ref", 200.0), ("M2_speed_ref", 0.0), ("M3_speed_ref", 0.0)):
        assert recording.signals[f"{signal}_shaped"][-1] == pytest.approx(end, abs=1e-9)


@pytest.mark.compile
@pytest.mark.parametrize("kind", ["sequential", "sequential_modified", "optimal"])
def test_compiles_strictly_and_runs_its_scenario(project: Project, kind: str, root: Path, tmp_path: Path) -> None:
    if kind == "optimal" and project.design.decoupling.model.changing:
        pytest.skip("a ratio changes: refused, see below")
    bed = governed(project, kind, **({"horizon": "0 s"} if kind == "optimal" else {}))
    generate(bed, tmp_path, "float" if kind == "sequential" else "double")
    compiler = next((name for name in ("gcc", "clang") if shutil.which(name)), None)
    for source in sorted(tmp_path.glob("*.c")) if compiler else []:
        command = [compiler, *STRICT, "-c", str(source), "-o", str(source.with_suffix(".o"))]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stderr
    scenario = load_scenario(root / "scenarios" / f"{SCENARIOS[bed.testbed.name]}.toml", bed.testbed)
    recording = simulate(bed, replace(scenario, duration=min(scenario.duration, 12.0)))
    assert not recording.signals["fault"].any()
    names = [signal.name for signal in governor_signals(bed.controller)]
    assert set(names) <= set(recording.signals) and "governor_status" in names
    assert all(np.isfinite(recording.signals[name]).all() for name in names)


def hard() -> dict[str, Profile]:
    """References that ask for more than the machines have: all at once, against each other, beyond the limits."""
    time = (0.0, 0.2, 0.5, 1.0, 1.5, 2.0, 2.5)
    return {
        "torque.M1": Profile(time, (0.0, 300.0, 800.0, 500.0, -1500.0, 1500.0, 0.0), "steps"),
        "speed.M2": Profile(time, (0.0, 0.0, 50.0, 50.0, 30.0, 260.0, 0.0), "steps"),
        "speed.M3": Profile(time, (0.0, 0.0, 50.0, 20.0, 60.0, 260.0, 0.0), "steps"),
    }


@pytest.mark.compile
@pytest.mark.parametrize("kind", [1.0, 2.0])
def test_limits_are_kept(projects: dict[str, Project], kind: float) -> None:
    """With (7.43) every command stays within the narrowed limits, always; with (7.41) not if references turn round."""
    bed = governed(projects["differential_governed"], "sequential_modified")
    scenario = Scenario("hard", "", "", 3.5, 1e-3, hard())
    slack = {}
    for chosen in (0.0, kind):
        recording = simulate(bed, scenario, parameters={"governor": chosen})
        assert not recording.signals["fault"].any()
        slack[chosen] = {name: np.abs(recording.signals[f"governor_slack_{name}"]) for name in ("M1", "M2", "M3")}
    assert max(values.max() for values in slack[0.0].values()) > 10_000.0
    for name, values in slack[kind].items():
        if kind == 2.0:
            assert values.max() == 0.0, name
        assert np.mean(values > 1.0) < 0.1, name


@pytest.mark.compile
def test_stationary_limit_of_the_testing_torque(projects: dict[str, Project]) -> None:
    """7.3.3: the torque reference stops at (1 - eps_1) (1 - eps_inf) of what M1 has."""
    bed = governed(projects["differential_governed"], "sequential_modified")
    torque = {"torque.M1": Profile((0.0, 0.1), (0.0, 1000.0), "steps")}
    rest = {f"speed.{name}": Profile((0.0,), (0.0,), "lines") for name in ("M2", "M3")}
    recording = simulate(bed, Scenario("step", "", "", 1.0, 1e-3, torque | rest))
    assert recording.signals["diff_input_torque_ref_shaped"][-1] == pytest.approx(930.0 * 0.95 * 0.98, rel=1e-6)
    assert recording.signals["governor_status"][-1] == 1.0


@pytest.mark.compile
def test_switching_does_not_jump(projects: dict[str, Project]) -> None:
    """Shaped references go on from where they are, on and off, and arrive; only (7.43) takes them back at once.

    What it takes back was beyond the limit of the torque, so the torque does not jump either.
    """
    bed = governed(projects["differential_governed"], "sequential_modified")
    library = build(bed)
    bench = Bench(bed, library)
    wanted = {"M2_speed_ref": 60.0, "M3_speed_ref": 60.0, "diff_input_torque_ref": 300.0}
    largest = dict.fromkeys(("M2", "M3"), 0.00021 * bench.params.M2_speed_ref_rate)
    before = dict.fromkeys(largest, 0.0)
    for chosen, steps in ((2.0, 400), (0.0, 30), (1.0, 60), (0.0, 20), (2.0, 3000)):
        bench.change(governor=chosen)
        for _ in range(steps):
            bench.run(1, **wanted)
            for name in largest:
                now = library.controller.read(bench.state, f"{name}_speed_ref_shaped")
                assert now - before[name] <= largest[name]
                assert now >= before[name] or chosen == 2.0
                before[name] = float(now)
    for name in largest:
        assert before[name] == 60.0


def test_nothing_that_is_not_finite_gets_in(projects: dict[str, Project]) -> None:
    bed = governed(projects["differential"], "sequential")
    controller = Controller(bed.controller, {"hold_time": 0.0})
    good = {"M2_speed_ref": 5.0, "M3_speed_ref": 5.0}
    controller.step(**good)
    shaped = [s.name for s in bed.controller.states if s.name.endswith("_shaped")]
    for name in (s.name for s in bed.controller.inputs):
        for value in (np.nan, np.inf, -np.inf):
            with np.errstate(all="ignore"):
                controller.step(**{**good, name: value})
            assert all(np.isfinite(controller.state(name)) for name in shaped)


@pytest.mark.compile
def test_a_start_after_a_fault_begins_where_the_bed_is(projects: dict[str, Project]) -> None:
    bed = governed(projects["differential"], "sequential_modified")
    controller = Compiled(build(bed), {})
    turning = {"M1_speed": 95.5, "M2_speed": 50.0, "M3_speed": 50.0, "M2_speed_ref": 50.0, "M3_speed_ref": 50.0}
    controller.step(**turning)
    assert controller.state("M2_speed_ref_shaped") == 50.0


def test_optimal_with_a_changing_ratio_is_refused(projects: dict[str, Project]) -> None:
    bed = governed(projects["transmission_fixed_gear"], "optimal", horizon="0 s")
    with pytest.raises(ControlError, match="changes at run time"):
        _ = bed.controller


def test_super_twisting_is_refused(root: Path) -> None:
    testbed = load(root / "testbeds" / "differential.toml")
    tuning = testbed.tuning.model_copy(update={"speed_control": {"M2": "super_twisting"}})
    bed = governed(Project(replace(testbed, tuning=tuning)), "none")
    bed.testbed = replace(bed.testbed, governor=bed.testbed.governor.model_copy(update={"kind": "sequential"}))
    with pytest.raises(ControlError, match="super-twisting"):
        _ = bed.controller

"""Actuated friction elements in scenarios: what is recorded, what reaches the plant, what is refused."""

from __future__ import annotations

import math
import subprocess
from pathlib import Path

import numpy as np
import pytest
from clutched_beds import BRAKED, CLUTCHED

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


def bed(folder: Path, text: str) -> Project:
    path = folder / "bed.toml"
    path.write_text(text, encoding="utf-8")
    return Project.read(path)


@pytest.fixture(scope="module")
def clutched(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return bed(tmp_path_factory.mktemp("bed"), CLUTCHED)


@pytest.fixture(scope="module")
def plant(clutched: Project) -> CompiledBlock:
    return build(clutched).plant


REST = Profile((0.0,), (0.0,), "lines")


def run(project: Project, speed: Profile, actuations: dict[str, Profile], **options) -> Recording:
    """Run the bed with a speed of M1, while that of M2 is zero."""
    duration = options.pop("duration", 0.02)
    references = {"speed.M1": speed, "speed.M2": REST}
    scenario = Scenario("case", "", "", duration, H, references, actuations)
    return simulate(project, scenario, **options)


def test_recording_holds_the_actuation_of_each_step(clutched: Project) -> None:
    ramp = Profile((0.0, 10 * H), (0.0, 1.0), "lines")
    got = run(clutched, REST, {"clutch1": ramp}).signals["clutch1_actuation"]
    assert got[:10] == pytest.approx((np.arange(10) + 0.5) / 10, abs=1e-12)
    assert np.all(got[10:] == 1.0)


def test_steps_act_from_their_time_on(clutched: Project) -> None:
    steps = Profile((0.0, 5 * H, 7 * H), (1.0, 0.25, 0.75), "steps")
    got = run(clutched, REST, {"clutch1": steps}).signals["clutch1_actuation"]
    assert got[:9].tolist() == [1.0] * 5 + [0.25] * 2 + [0.75] * 2


def test_an_element_that_is_not_named_stays_open(clutched: Project) -> None:
    recording = run(clutched, Profile((0.0, 0.5), (0.0, 50.0), "lines"), {}, duration=0.5)
    assert not recording.signals["clutch1_actuation"].any()
    assert not recording.signals["clutch1_torque"].any()
    assert recording.signals["clutch1_speed"][-1] > 20


def test_signals_stand_in_their_order(clutched: Project) -> None:
    names = [signal.name for signal in recorded_signals(clutched)]
    assert names[:3] == ["M1_speed_ref", "M2_speed_ref", "clutch1_actuation"]
    assert names[-1] == "fault"
    recording = run(clutched, REST, {})
    assert list(recording.signals) == names and recording.units["clutch1_actuation"] == ""


def test_a_clutch_slips_at_its_actuated_capacity_and_then_sticks(clutched: Project) -> None:
    speed = Profile((0.0, 0.3, 1.0, 1.2), (0.0, 10.0, 10.0, 0.0), "lines")
    closing = Profile((0.6, 0.7, 1.4, 1.5), (0.0, 0.4, 0.4, 1.0), "lines")
    recording = run(clutched, speed, {"clutch1": closing}, duration=2.0)
    torque, slip = recording.signals["clutch1_torque"], recording.signals["clutch1_speed"]
    between = (recording.time > 0.61) & (recording.time < 1.0)
    capacity = 200.0 * recording.signals["clutch1_actuation"]
    assert np.all(slip[between] > 0)
    assert torque[between] == pytest.approx(capacity[between], abs=0.3)
    assert np.all(slip[recording.time > 1.7] == 0.0)
    assert np.abs(torque).max() <= 250.0


def test_actuations_beyond_their_range_are_named(clutched: Project) -> None:
    for method in ("emitted", "events"):
        for value in (1.5, -0.1, math.nan):
            with pytest.raises(RunError, match="the input clutch1_actuation is outside its range 0 to 1"):
                run(clutched, REST, {"clutch1": Profile((0.0,), (value,), "lines")}, method=method, duration=1e-3)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, -1e-9, 1.0 + 1e-9, 1e300])
def test_bad_actuations_leave_the_plant_as_it_was(plant: CompiledBlock, bad: float) -> None:
    params = plant.defaults()
    _, state = plant.init(params)
    sound = {"M1_torque_ref": 100.0, "M2_torque_ref": -20.0, "clutch1_actuation": 0.3}
    for _ in range(30):
        assert plant.step(state, params, sound)[0] == 0
    before, outputs = bytes(state), plant.measure(state, params)
    status, got = plant.step(state, params, sound | {"clutch1_actuation": bad})
    assert status == 1102
    assert plant.status_text(status) == "the input clutch1_actuation is outside its range 0 to 1"
    assert bytes(state) == before
    assert got == outputs and all(math.isfinite(value) for value in got.values())
    assert plant.step(state, params, sound)[0] == 0


def test_the_first_bad_input_is_named(plant: CompiledBlock) -> None:
    params = plant.defaults()
    _, state = plant.init(params)
    inputs = {"M1_torque_ref": 0.0, "M2_torque_ref": math.inf, "clutch1_actuation": math.nan}
    status, _ = plant.step(state, params, inputs)
    assert (status, plant.status_text(status)) == (1101, "the input M2_torque_ref is not finite")


def test_an_element_that_is_always_pressed_has_no_input(tmp_path: Path) -> None:
    project = bed(tmp_path, BRAKED)
    assert project.testbed.actuated == ("brakeA",)
    assert [s.name for s in project.plant.inputs if s.name.endswith("_actuation")] == ["brakeA_actuation"]


@pytest.mark.parametrize("precision", ["double", "float"])
def test_program_takes_actuations_by_name(clutched: Project, tmp_path: Path, precision) -> None:
    generate(clutched, tmp_path, precision)
    program = tmp_path / "main"
    subprocess.run(["cc", "-std=c99", "-O2", "-o", program, *tmp_path.glob("*.c"), "-lm"], check=True)
    profiles = tmp_path / "profiles.csv"
    profiles.write_text("clutch1_actuation,time,M1_speed_ref\n0,0,0\n1,0.1,10\n1,2,10\n")
    result = subprocess.run([program, profiles, "1", "100"], capture_output=True, text=True, check=True)
    rows = [line.split(",") for line in result.stdout.splitlines()]
    last = dict(zip(rows[0], map(float, rows[-1]), strict=True))
    assert last["clutch1_actuation"] == 1.0 and last["clutch1_torque"] > 10
    profiles.write_text("time,clutch1_actuation\n0,2\n")
    result = subprocess.run([program, profiles, "0.01"], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and "clutch1_actuation is outside its range" in result.stderr
    profiles.write_text("time,clutch2_actuation\n0,2\n")
    result = subprocess.run([program, profiles, "0.01"], capture_output=True, text=True, check=False)
    assert result.returncode == 2 and 'unknown column "clutch2_actuation"' in result.stderr
    usage = subprocess.run([program], capture_output=True, text=True, check=False).stderr
    assert "references and actuations: M1_speed_ref M2_speed_ref clutch1_actuation\n" in usage

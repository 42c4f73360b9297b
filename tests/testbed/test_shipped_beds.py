"""The beds and scenarios that ptgen ships can be read, and say what their sources say."""

from __future__ import annotations

import hashlib
import math
import pickle
from pathlib import Path

import pytest

import ptgen.testbed
from ptgen.testbed import Testbed

ROOT = Path(__file__).parents[2]
BEDS = sorted((ROOT / "testbeds").glob("*.toml"))
SCENARIOS = sorted((ROOT / "scenarios").glob("*.toml"))


def bed_of(scenario: Path) -> Path:
    return max((bed for bed in BEDS if scenario.stem.startswith(bed.stem)), key=lambda bed: len(bed.stem))


@pytest.mark.parametrize("path", BEDS, ids=lambda path: path.stem)
def test_bed_is_read(path: Path) -> None:
    bed = ptgen.testbed.load(path)
    assert bed.name == path.stem.replace("-", "_")
    alone = hashlib.sha256(path.read_bytes()).hexdigest()
    parts = any(component.type_name == "part" for component in bed.components.values())
    assert (bed.digest == alone) is not parts, "what a part consists of belongs to the bed too"
    assert bed.sample_time == 1e-4
    assert set(bed.roles.torque) | set(bed.roles.speed) == set(bed.machines)
    assert bed.assumed
    assert parts or pickle.loads(pickle.dumps(bed)) == bed


def test_differential() -> None:
    bed = ptgen.testbed.load(ROOT / "testbeds" / "differential.toml")
    assert [f"{c.left} {c.right}" for c in bed.connections] == [
        "M1.shaft flange1.machine",
        "flange1.uut cardan1.left",
        "cardan1.right diff.input",
        "diff.output1 cardan2.left",
        "cardan2.right flange2.uut",
        "flange2.machine M2.shaft",
        "diff.output2 cardan3.left",
        "cardan3.right flange3.uut",
        "flange3.machine M3.shaft",
    ]
    assert {name for name, sign in bed.orientation.items() if sign == -1} == {"flange2", "flange3"}
    assert bed.roles.torque == {"M1": "diff.input"} and bed.roles.speed == ("M2", "M3")
    assert bed.components["flange1"].stiffness == 380e3
    assert bed.tuning.speed_bandwidth == 30.0


def test_differential_with_gearboxes() -> None:
    bed = ptgen.testbed.load(ROOT / "testbeds" / "differential-gearboxes.toml")
    backward = {name for name, sign in bed.orientation.items() if sign == -1}
    assert backward == {"flange2", "flange3", "gearbox2", "gearbox3"}
    parts = bed.components
    drive = (parts["M1"].inertia + parts["gearbox1"].inertia) * (parts["gearbox1"].ratio * parts["diff"].ratio) ** 2
    soft = 1 / (1 / (parts["cardan1"].stiffness * parts["diff"].ratio ** 2) + 1 / (2 * parts["cardan2"].stiffness))
    omega = math.sqrt(soft / drive)
    assert omega / (2 * math.pi) == pytest.approx(1.3, abs=0.1)
    assert parts["cardan1"].damping / parts["cardan1"].stiffness * omega / 2 == pytest.approx(0.02, rel=0.05)


def test_back_to_back_resonates_at_17_hz() -> None:
    parts = ptgen.testbed.load(ROOT / "testbeds" / "back-to-back.toml").components
    stiffness = 1 / sum(1 / parts[name].stiffness for name in ("flange1", "shaft1", "flange2"))
    omega = math.sqrt(stiffness * (1 / parts["M1"].inertia + 1 / parts["M2"].inertia))
    assert omega / (2 * math.pi) == pytest.approx(17.0, abs=0.05)
    assert parts["M1"].torque_max * parts["M1"].speed_rated == pytest.approx(575e3, rel=1e-3)


@pytest.mark.parametrize("path", SCENARIOS, ids=lambda path: path.stem)
def test_scenario_stays_within_the_machines(path: Path) -> None:
    """Starts at rest; the ramps of each speed-controlled machine fit into its envelope, or a governor sees to that."""
    bed = ptgen.testbed.load(bed_of(path))
    scenario = ptgen.testbed.load_scenario(path, bed)
    assert scenario.name == path.stem and scenario.title
    assert len(scenario.references) == len(bed.machines)
    for key, profile in scenario.references.items():
        assert profile.value[0] == 0.0, key
        assert profile.time[-1] <= scenario.duration
        machine = bed.components[key.partition(".")[2]]
        if key.startswith("speed."):
            assert max(map(abs, profile.value)) < machine.speed_rated or bed.governor.is_chosen
        if key.startswith("speed.") and not bed.governor.is_chosen:
            for i in range(1, len(profile.time)):
                ramp = (profile.value[i] - profile.value[i - 1]) / (profile.time[i] - profile.time[i - 1])
                assert abs(ramp) * machine.inertia < 0.5 * machine.torque_max


def test_every_bed_has_a_scenario() -> None:
    assert {bed_of(path) for path in SCENARIOS} == set(BEDS)


def test_file_given_as_text() -> None:
    bed = ptgen.testbed.load(str(BEDS[0]))
    assert isinstance(bed, Testbed) and bed.file == str(BEDS[0])

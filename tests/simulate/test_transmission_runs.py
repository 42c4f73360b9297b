"""The bed for transmissions: shifts without load as in Section 5.8.2, and shifts that nobody tells the controller."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

pytestmark = pytest.mark.compile

CLOSES = 14.6
"""When the next clutch of the downshift begins to close (s)."""


@pytest.fixture(scope="module", params=["transmission", "transmission_nine_speed"])
def bed(request: pytest.FixtureRequest, projects: dict[str, Project]) -> tuple[Project, Library]:
    project = projects[request.param]
    return project, build(project)


@pytest.fixture(scope="module")
def transmission(projects: dict[str, Project]) -> tuple[Project, Library]:
    project = projects["transmission"]
    return project, build(project)


def run(bed: tuple[Project, Library], name: str, controller: str = "decoupling", **parameters: float) -> Recording:
    """Run a scenario up to 17 s, that is over the downshift."""
    project, library = bed
    file = Path(__file__).resolve().parents[2] / "scenarios" / f"{name}.toml"
    scenario = replace(load_scenario(file, project.testbed), duration=17.0, record_every=1e-3)
    return simulate(project, scenario, controller=controller, parameters=parameters, library=library)


def left(recording: Recording) -> np.ndarray:
    """Return how far M1 is from where the ratio wants it (rad/s)."""
    signals = recording.signals
    return np.asarray(signals["M1_speed"] - signals["gears_ratio_limited"] * signals["M2_speed"])


def test_peaks_after_the_downshift_are_at_least_halved(bed: tuple[Project, Library]) -> None:
    """Section 5.8.2: torques at both flanges, the speed of M2, and the time until all is quiet."""
    proposed = run(bed, "transmission-run")
    conventional = run(bed, "transmission-conventional", "conventional")
    after = proposed.time >= CLOSES
    for signal in ("flange1_torque", "flange2_torque"):
        peaks = [np.abs(recording.signals[signal][after]).max() for recording in (proposed, conventional)]
        assert 2 * peaks[0] < peaks[1], (signal, peaks)
        quiet = [
            recording.time[after][np.abs(recording.signals[signal][after]) > 25.0].max()
            for recording in (proposed, conventional)
            if (np.abs(recording.signals[signal][after]) > 25.0).any()
        ]
        assert len(quiet) < 2 or quiet[0] - CLOSES < 0.5 * (quiet[1] - CLOSES)
    shift = proposed.time >= CLOSES - 0.7
    errors = [
        np.abs(recording.signals["M2_speed"] - recording.signals["M2_speed_ref"])[shift].max()
        for recording in (proposed, conventional)
    ]
    assert 10 * errors[0] < errors[1]
    k = np.searchsorted(proposed.time, CLOSES)
    assert 5 * abs(left(proposed)[k]) < abs(
        conventional.signals["gears_ratio"][k] * 31.4 - conventional.signals["M1_speed"][k]
    )


def test_open_transmission_makes_the_damping_a_speed_controller(transmission: tuple[Project, Library]) -> None:
    """No shaft pulls at M1: d (omega_1 - i omega_2) alone accelerates it, so it lags by I d(i omega_2)/dt / d."""
    project, _ = transmission
    inertia = 0.4 + 0.01 + 0.10 + 0.04 + 0.05  # rotor, flange, converter, and the gearbox's input
    rate = (5.503 - 3.333) / 0.5 * 300 * np.pi / 30
    lag = {}
    for name, switch in (("without", 0.0), ("with", 1.0)):
        recording = run(transmission, "transmission-run", acceleration_torque=switch, M1_torque_integral_gain=0.0)
        pause = (recording.time > CLOSES - 0.25) & (recording.time < CLOSES)
        lag[name] = float(left(recording)[pause].mean())
    assert lag["without"] == pytest.approx(-inertia * rate / project.design.gains.damping["M1"], rel=0.05)
    assert abs(lag["with"]) < 0.4 * abs(lag["without"])


def test_conventional_control_does_not_look_at_the_ratio(transmission: tuple[Project, Library]) -> None:
    project, library = transmission
    file = Path(__file__).resolve().parents[2] / "scenarios" / "transmission-conventional.toml"
    scenario = replace(load_scenario(file, project.testbed), duration=14.55, record_every=1e-3)
    other = replace(scenario, ratios={**scenario.ratios, "gears": replace(scenario.ratios["gears"], value=(1.0,) * 4)})
    first, second = (
        simulate(project, s, controller="conventional", parameters={"M1_sensor_inertia_M2": 0.0}, library=library)
        for s in (scenario, other)
    )
    assert first.signals["gears_ratio"].max() != second.signals["gears_ratio"].max()
    np.testing.assert_array_equal(first.signals["M1_torque_ref"], second.signals["M1_torque_ref"])


def test_estimated_ratio_follows_a_transmission_that_shifts_by_itself(transmission: tuple[Project, Library]) -> None:
    """Powershifts 1-2-3 under load: within half a second the ratio is that of the gear, and the torque is back."""
    run_ = run(transmission, "transmission-self-shift", gears_ratio_source=1.0)
    t, signals = run_.time, run_.signals
    for begin, end, ratio in ((1.0, 6.0, 5.503), (7.0, 11.0, 3.333), (12.0, 16.0, 2.315)):
        inside = (t > begin) & (t < end)
        assert set(signals["gears_ratio_limited"][inside]) == {ratio}
        steady = (t > begin + 1.0) & (t < end)
        assert np.abs(signals["gears_input_torque"] - 150.0)[steady].max() < 5.0
    assert np.abs(signals["M2_speed"] - signals["M2_speed_ref"]).max() < 2.0
    assert not signals["fault"].any()


@pytest.mark.parametrize("gear", ["4", "9"])
def test_a_gear_that_changes_at_standstill_is_found_when_the_bed_starts(
    transmission: tuple[Project, Library], tmp_path: Path, gear: str
) -> None:
    """With the ratio of the old gear the damping would brake the output where its speed does not tell the new one."""
    project, library = transmission
    file = tmp_path / "standstill.toml"
    file.write_text(
        f"""
[scenario]
duration = "8 s"
record_every = "10 ms"
[references.torque.M1]
time = ["2 s", "2.5 s"]
value = ["0 N m", "80 N m"]
[references.speed.M2]
time = ["2.5 s", "5 s"]
value = ["0 rpm", "300 rpm"]
[actuations.converter]
lockup = {{ time = ["0 s"], value = [1] }}
[gears]
gears = "{gear}"
[[shifts]]
component = "gears"
time = "0.5 s"
to = "1"
kind = "non-overlapping"
"""
    )
    scenario = load_scenario(file, project.testbed)
    signals = simulate(project, scenario, parameters={"gears_ratio_source": 1.0}, library=library).signals
    assert signals["gears_ratio_limited"][-1] == pytest.approx(5.503, rel=1e-9)
    assert signals["M2_speed"][-1] == pytest.approx(300 * np.pi / 30, rel=0.01)
    assert signals["flange1_torque"][-1] == pytest.approx(80.0, abs=2.0)
    assert np.abs(signals["flange2_torque"]).max() < 4 * 80 * 5.503, "it was 3300 N m for good"

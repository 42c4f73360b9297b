"""Scenarios in closed loop: tracking, decoupling, damping, recording, interruption."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ptgen.analysis.closed_loop import closed_loop_poles
from ptgen.errors import RunError
from ptgen.plant.plant import plant_block
from ptgen.project import Project
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario, load_scenario

pytestmark = pytest.mark.compile


def run(project: Project, root: Path, name: str, **options) -> Recording:
    return simulate(project, load_scenario(root / "scenarios" / f"{name}.toml", project.testbed), **options)


def torque_error(recording: Recording) -> np.ndarray:
    return recording.signals["diff_input_torque_ref"] - recording.signals["diff_input_torque"]


def test_testing_torque_during_speed_ramps(projects, root) -> None:
    """Decoupled, the rms error is at least ten times smaller than with the conventional controller."""
    project = projects["differential"]
    errors = {}
    for controller in ("decoupling", "conventional"):
        recording = run(project, root, "differential-speed-ramps", controller=controller)
        errors[controller] = np.sqrt(np.mean(torque_error(recording) ** 2))
    assert errors["conventional"] > 10 * errors["decoupling"]


def largest_ringing(recording: Recording) -> float:
    """Return the largest deviation from two to six periods of the 21.9 Hz mode after a torque step, per step."""
    reference, torque = (recording.signals[f"diff_input_torque{end}"] for end in ("_ref", ""))
    steps = np.flatnonzero(np.abs(np.diff(reference)) > 50.0) + 1
    assert len(steps) > 3
    shares = []
    for start in steps:
        since = recording.time - recording.time[start]
        after = (since > 2 / 21.9) & (since < 6 / 21.9)
        assert np.ptp(reference[after]) == 0
        size = abs(reference[start] - reference[start - 1])
        shares.append(np.abs(torque[after] - reference[after]).max() / size)
    return max(shares)


def test_torque_step_does_not_ring(projects, root) -> None:
    """Two periods of the mode after a step the torque is within 1 %; conventionally half of it rings."""
    project = projects["differential"]
    assert largest_ringing(run(project, root, "differential-torque-steps")) < 0.01
    assert largest_ringing(run(project, root, "differential-torque-steps", controller="conventional")) > 0.5


@pytest.mark.parametrize(
    ("name", "size"), [("back_to_back", 1000.0), ("differential", 400.0), ("differential_gearboxes", 1e4)]
)
def test_torque_step_hardly_overshoots(name: str, size: float, projects) -> None:
    """Critical damping and the torque model: below 2 %; with the bare reference the integrator overshoots."""
    project = projects[name]
    torque_step, speed_ramp = Profile((0.0, 3.0), (0.0, size), "steps"), Profile((0.0, 1.0), (0.0, 30.0), "lines")
    keys = project.design.controller.references
    references = {key: torque_step if key.startswith("torque") else speed_ramp for key in keys}
    scenario = Scenario(name="step", file="", digest="", duration=7.0, record_every=1e-3, references=references)
    torque = project.design.controller.references["torque.M1"].removesuffix("_ref")
    peaks = [
        simulate(project, scenario, parameters=parameters).signals[torque].max() / size
        for parameters in ({}, {"M1_torque_model": 0.0})
    ]
    assert 0.999 < peaks[0] < 1.02
    assert peaks[1] > 1.1


def test_closed_loop_pole_of_the_first_mode_is_damped(torque_project: Project) -> None:
    project = torque_project
    omega = next(iter(project.design.gains.natural_frequency.values())) / (2 * np.pi)
    full = project.reduced.full  # gaps closed, and what control takes for locked
    plant = project.plant if full is project.plant_model else plant_block(full, project.testbed.sample_time)
    for pole in closed_loop_poles(project.controller, plant):
        assert pole.damping_ratio > 0
        if 0.2 * omega < pole.frequency_hz < 3 * omega:
            assert pole.damping_ratio >= 0.5, pole


def test_conventional_controller_leaves_the_mode_undamped(projects) -> None:
    project = projects["differential"]
    poles = closed_loop_poles(project.controller, project.plant, project.design.controller.conventional)
    assert any(20 < pole.frequency_hz < 24 and pole.damping_ratio < 0.1 for pole in poles)


def test_references_are_reached(project: Project, root: Path) -> None:
    course = {"back_to_back": "steps", "clutch_rig": "engagement"}.get(project.testbed.name, "run")
    recording = run(project, root, f"{project.testbed.name.replace('_', '-')}-{course}")
    for key, signal in project.design.controller.references.items():
        if key.startswith("speed"):
            wanted, got = recording.signals[signal], recording.signals[signal.removesuffix("_ref")]
            wanted = recording.signals.get(f"{signal}_shaped", wanted)  # what a governor makes of it
            # A machine that accelerates with all it has lags by what its speed controller needs for that.
            share = 0.05 if project.testbed.governor.is_chosen else 0.02
            assert np.sqrt(np.mean((wanted - got) ** 2)) < share * np.abs(wanted).max() + 0.3
    assert not recording.signals["fault"].any()


def test_recording_is_decimated_and_in_order(projects, root, tmp_path) -> None:
    project = projects["back_to_back"]
    scenario = load_scenario(root / "scenarios" / "back-to-back-steps.toml", project.testbed)
    shares: list[float] = []
    recording = simulate(project, scenario, progress=shares.append)
    assert recording.steps == round(scenario.duration / 1e-4)
    assert len(recording.time) == round(scenario.duration / scenario.record_every)
    assert np.allclose(np.diff(recording.time), scenario.record_every)
    assert shares == sorted(shares) and shares[-1] == pytest.approx(1.0, abs=0.01)
    recording.write_csv(tmp_path / "run.csv")
    table = np.genfromtxt(tmp_path / "run.csv", delimiter=",", names=True, deletechars="", skip_header=0)
    assert len(table) == len(recording.time)
    first_line = (tmp_path / "run.csv").read_text().splitlines()[0]
    assert first_line.startswith("time (s),") and "M2_speed (rad/s)" in first_line


def test_interruption_leaves_nothing(projects, root) -> None:
    def stop(share: float) -> None:
        if share > 0.3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(projects["back_to_back"], root, "back-to-back-steps", progress=stop)


def test_anti_windup_keeps_the_overshoot_small(projects) -> None:
    """A step that holds the machine at its limit for a while overshoots no more than a small one.

    A PI controller with a double pole overshoots by 1/e^2 = 13.5 % on its own.
    """
    project = projects["back_to_back"]
    scenario = Scenario(
        name="step",
        file="",
        digest="",
        duration=3.0,
        record_every=1e-3,
        references={
            "torque.M1": Profile((0.0,), (0.0,), "steps"),
            "speed.M2": Profile((0.0,), (150.0,), "steps"),
        },
    )
    recording = simulate(project, scenario)
    command, speed = recording.signals["M2_torque_ref"], recording.signals["M2_speed"]
    assert np.count_nonzero(np.abs(command) >= 3049.0) > 200
    assert speed.max() < 1.135 * 150.0
    assert abs(speed[-1] - 150.0) < 0.5


def test_unknown_parameter_is_named(projects, root) -> None:
    with pytest.raises(RunError, match='did you mean "M1_damping"'):
        run(projects["back_to_back"], root, "back-to-back-steps", parameters={"M1_dampin": 1.0})


def test_parameter_out_of_range_is_named(projects, root) -> None:
    with pytest.raises(RunError, match="M1_inertia"):
        run(projects["back_to_back"], root, "back-to-back-steps", parameters={"M1_inertia": -1.0})


def test_coupling_shrinks_with_the_sampling_time() -> None:
    """On the reduced plant without lag, the sampled law's coupling error vanishes with the step."""
    from coupling import coupling_by_sample_time

    table = coupling_by_sample_time([4e-4, 2e-4, 1e-4, 5e-5])
    errors = np.array([error for _, error in table])
    assert np.all(errors[1:] < 0.75 * errors[:-1]), table


def test_parts_that_coast_are_not_called_unstable(projects) -> None:
    """Between open clutches the middle of the rig turns as it likes."""
    project = projects["clutch_rig"]
    for parameters in ({}, project.design.controller.conventional):
        poles = closed_loop_poles(project.controller, project.plant, parameters)
        assert not any(pole.is_unstable for pole in poles)
        assert any(abs(pole.z - 1) < 1e-9 for pole in poles)

"""How much speed ramps disturb the torque, and torque steps the speeds, on full plants."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ptgen.analysis.closed_loop import closed_loop_poles
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario

RPM = 2 * np.pi / 60


def rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def coupling(project: Project, torque: float, speed: float, ramp: float) -> dict[str, tuple[float, float]]:
    """Return for each controller the rms torque error of a speed ramp and the rms speed error of a torque step.

    All machines that control a speed follow the same ramp, from `speed` (rpm) to half as much again in `ramp` (s), at
    constant `torque` (N m); later the torque is stepped by half. Each is judged from its beginning until 4 s later.
    """
    roles = project.testbed.roles
    (machine,) = roles.torque
    ends = (0.5, 4.5, 10.0, 10.0 + ramp)
    profile = Profile(ends, (0.0, speed * RPM, speed * RPM, 1.5 * speed * RPM), "lines")
    references = {f"speed.{name}": profile for name in roles.speed}
    references[f"torque.{machine}"] = Profile((1.0, 3.0, 20.0, 20.001), (0.0, torque, torque, 1.5 * torque), "lines")
    scenario = Scenario(name="coupling", file="", digest="", duration=24.0, record_every=1e-3, references=references)
    library = build(project)
    names = project.design.controller.references
    result = {}
    for controller in ("decoupling", "conventional"):
        recording = simulate(project, scenario, controller=controller, library=library)
        t, signals = recording.time, recording.signals

        def error(key: str, signals=signals) -> np.ndarray:
            return signals[names[key].removesuffix("_ref")] - signals[names[key]]

        # What of the errors was there before is none of the ramp's, or of the step's.
        in_ramp, in_step = (t > 10.0) & (t < 14.0), (t > 20.0) & (t < 24.0)
        torque_error = error(f"torque.{machine}")
        before = torque_error[(t > 9.9) & (t < 10.0)].mean()
        speeds = [error(f"speed.{name}") for name in roles.speed]
        speed_error = max(rms(e[in_step] - e[(t > 19.9) & (t < 20.0)].mean()) for e in speeds)
        result[controller] = (rms(torque_error[in_ramp] - before), speed_error)
    return result


@pytest.mark.compile
@pytest.mark.parametrize(
    ("name", "torque", "speed", "ramp"),
    [
        ("differential", 300.0, 500.0, 1.0),
        ("differential_output_torque", 300.0, 500.0, 1.0),
        ("differential_gearboxes", 8e3, 600.0, 3.0),
        ("all_wheel_drive", 300.0, 400.0, 1.0),
        ("back_to_back", 1000.0, 1000.0, 2.0),
    ],
)
def test_coupling_is_smaller_than_conventional(
    name: str, torque: float, speed: float, ramp: float, projects: dict[str, Project], root: Path
) -> None:
    """At least a hundred times; measured are 190 to 5400 times for the torque, 200 to 1400 times for the speeds."""
    found = coupling(projects[name], torque, speed, ramp)
    for mine, theirs in zip(found["decoupling"], found["conventional"], strict=True):
        assert theirs > 100 * mine, found


def test_first_mode_of_the_gearboxes(projects: dict[str, Project]) -> None:
    """Figure 5.12: undamped or growing with the conventional controller; damped to 0.7 with active damping."""
    project = projects["differential_gearboxes"]
    gains = project.design.controller.conventional
    for name in ("M2", "M3"):  # speed controllers of 60 rad/s hold the load machines, as in the source
        gains = gains | {f"{name}_speed_gain": 618.0, f"{name}_speed_integral_gain": 9270.0}
    for integral, stable in ((gains["M1_torque_integral_gain"], True), (1.0, False)):
        poles = closed_loop_poles(project.controller, project.plant, gains | {"M1_torque_integral_gain": integral})
        (mode,) = [pole for pole in poles if 1.2 < pole.frequency_hz < 1.5 and pole.s.imag > 0]
        assert abs(mode.damping_ratio) < 0.03
        assert mode.is_unstable != stable
    damped = [pole for pole in closed_loop_poles(project.controller, project.plant) if pole.frequency_hz < 5.0]
    assert all(pole.damping_ratio >= 0.7 for pole in damped), damped

"""Shifts without load: the acceleration torque for the changing ratio (5.46), (5.62) brings M1 to its new speed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ptgen.project import Project
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

SHIFTS = (5.3, 9.3, 13.3)


@pytest.mark.compile
def test_shift_hardly_loads_the_transmission(projects: dict[str, Project], root: Path) -> None:
    """Section 5.8.2: less synchronisation is left; without the term M1 is dragged to its speed by the shafts."""
    project = projects["transmission_fixed_gear"]
    scenario = load_scenario(root / "scenarios" / "transmission-fixed-gear-run.toml", project.testbed)
    peaks = {}
    for name, controller, parameters in (
        ("whole", "decoupling", {}),
        ("without term", "decoupling", {"acceleration_torque": 0.0}),
        ("conventional", "conventional", {}),
    ):
        recording = simulate(project, scenario, controller=controller, parameters=parameters)
        error = recording.signals["gearbox_input_torque"] - recording.signals["gearbox_input_torque_ref"]
        t = recording.time
        peaks[name] = np.array([np.abs(error[(t > start) & (t < start + 0.35)]).max() for start in SHIFTS])
        settled = np.searchsorted(t, [start + 0.6 for start in SHIFTS])
        speeds = [recording.signals[f"{machine}_speed"][settled] for machine in ("M1", "M2")]
        assert speeds[0] / speeds[1] == pytest.approx([2.1, 1.67, 2.1], rel=1e-2)
    assert np.all(peaks["without term"] > 5 * peaks["whole"]), peaks
    assert np.all(peaks["conventional"] > 5 * peaks["whole"]), peaks


@pytest.mark.compile
def test_torque_of_the_parts_between_is_no_testing_torque(projects: dict[str, Project], root: Path) -> None:
    """The flange behind the sensor accelerates with d(i omega_2)/dt: left out, that stays as an error of the torque."""
    project = projects["transmission_fixed_gear"]
    assert project.design.gains.sensor_ratio["M1"] == {"M2": "gearbox_ratio"}
    assert project.design.gains.sensor_inertia["M1"]["M2"] == pytest.approx(-0.01, rel=1e-3)
    scenario = load_scenario(root / "scenarios" / "transmission-fixed-gear-run.toml", project.testbed)
    mean = {}
    for name, parameters in (("with", {}), ("without", {"M1_sensor_inertia_M2": 0.0})):
        recording = simulate(project, scenario, parameters=parameters)
        error = recording.signals["gearbox_input_torque"] - recording.signals["gearbox_input_torque_ref"]
        t = recording.time
        mean[name] = np.array([error[(t > start + 0.1) & (t < start + 0.3)].mean() for start in SHIFTS])
    assert np.all(np.abs(mean["with"]) < 0.05 * np.abs(mean["without"])), mean

"""Sensors that fail in closed loop, unstable loops, and runs in which nothing may trip."""

from __future__ import annotations

from pathlib import Path

import pytest
from injected_faults import SPEED, TORQUE, run

from ptgen.errors import RunError
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

pytestmark = pytest.mark.compile


@pytest.fixture(scope="module")
def library(projects: dict[str, Project]) -> Library:
    return build(projects["differential"])


CAUGHT = [
    ("M2_speed", "frozen", "M2_speed: frozen", 0.05),
    ("M2_speed", "drops to zero", "M2_speed: disagrees", 0.002),
    ("M2_speed", "sign flipped", "M2_speed: disagrees", 0.002),
    ("M2_speed", "reads half", "M2_speed: disagrees", 0.2),
    ("M1_speed", "frozen", "M1_speed: frozen", 0.1),
    ("M1_speed", "offset 50 rad/s", "M1_speed: disagrees", 0.002),
    ("flange1_torque", "drops to zero", "flange1_torque: frozen", 0.05),
    ("flange1_torque", "sign flipped", "M1_speed: disagrees", 0.1),
    ("flange2_torque", "offset 40 % of the machine", "M2_speed: disagrees", 0.3),
]


@pytest.mark.parametrize(("signal", "kind", "text", "within"), CAUGHT)
def test_failed_sensor_is_found_and_named(signal: str, kind: str, text: str, within: float, library: Library) -> None:
    found = run(library, signal, (SPEED if "speed" in signal else TORQUE)[kind])
    assert found.text.startswith(text) and found.after <= within


def test_torques_of_before_are_held_not_those_of_the_failure(library: Library) -> None:
    """A speed that drops to zero asks for full torque until it is found out; that torque is not held."""
    found = run(library, "M2_speed", SPEED["drops to zero"])
    assert max(found.worst.values()) > 0.8
    for name, share in found.held.items():
        assert abs(share - found.before[name]) < 0.12, name


def test_the_same_run_without_failure_does_not_trip(library: Library) -> None:
    assert run(library, "M2_speed", None).text == ""


def test_halved_limits_find_smaller_errors(library: Library) -> None:
    """The default leaves room for torques that are wrong by a fifth of the machine's; a calibrated bed needs less."""
    assert run(library, "flange2_torque", TORQUE["sign flipped"]).text == ""
    tight = {"M2_disagreement_limit": 0.5 * library.controller.defaults().M2_disagreement_limit}
    assert run(library, "flange2_torque", None, tight).text == ""
    assert run(library, "flange2_torque", TORQUE["sign flipped"], tight).text.startswith("M2_speed: disagrees")


@pytest.mark.parametrize(
    ("bed", "scenario", "controller", "parameters"),
    [
        ("differential", "differential-torque-steps", "decoupling", {"M1_damping": 60 * 261.282}),
        ("differential", "differential-torque-steps", "conventional", {"M1_torque_integral_gain": 50.0}),
        ("differential_gearboxes", "differential-gearboxes-run", "conventional", {"M1_torque_integral_gain": 20.0}),
        ("back_to_back", "back-to-back-steps", "decoupling", {"M2_speed_gain": 60e3}),
    ],
)
def test_unstable_loop_is_stopped(bed: str, scenario: str, controller, parameters, projects, root: Path) -> None:
    """Within six half swings of hammering from limit to limit; whatever it is called, the torques go to zero."""
    project = projects[bed]
    loaded = load_scenario(root / "scenarios" / f"{scenario}.toml", project.testbed)
    with pytest.raises(RunError, match="oscillates"):
        simulate(project, loaded, controller=controller, parameters=parameters)


@pytest.mark.parametrize("controller", ["decoupling", "conventional"])
def test_no_shipped_scenario_trips(controller, projects: dict[str, Project], root: Path) -> None:
    for name, prefix in (
        ("differential", "differential-standstill"),
        ("differential", "differential-speed-ramps"),
        ("differential", "differential-torque-steps"),
        ("back_to_back", "back-to-back-steps"),
        ("clutch_rig", "clutch-rig-engagement"),
    ):
        loaded = load_scenario(root / "scenarios" / f"{prefix}.toml", projects[name].testbed)
        assert not simulate(projects[name], loaded, controller=controller).signals["fault"].any()

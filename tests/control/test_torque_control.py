"""Torque control (5.99), and the estimate of the testing torque with known losses (5.96)."""

from __future__ import annotations

import numpy as np
import pytest
from controller_steps import Compiled, Controller
from hypothesis import given
from hypothesis import strategies as st
from mechanism.bed_text import Bed, differential_bed, two_machines

from ptgen.project import Project
from ptgen.simulate.build import build

H = 1e-4
PROJECT = Project(differential_bed().load())
values = st.floats(-60, 60)


@given(values, values, values, st.floats(-0.9, 3), st.floats(0, 1.5))
def test_pi_control_with_feedforward(
    reference: float, torque: float, integral: float, gain: float, forward: float
) -> None:
    """(5.99) at standstill, where neither damping nor acceleration adds anything; the first output is what it says."""
    changes = {"M1_torque_gain": gain, "M1_feedforward": forward, "M1_torque_model": 0.0, "acceleration_torque": 0.0}
    controller = Controller(PROJECT.controller, changes)
    controller.step()
    controller.states["M1_torque_integral"] = np.array(integral)
    measured = {"flange1_torque": torque, "diff_input_torque_ref": reference}
    command = controller.step(**measured)["M1_torque_ref"]
    assert command == pytest.approx(forward * reference + gain * (reference - torque) + integral, abs=1e-6)
    grown = integral + H * PROJECT.design.gains.torque_integral["M1"] * (reference - torque)
    bound = float(controller.parameters["M1_torque_integral_limit"])
    assert controller.state("M1_torque_integral") == pytest.approx(np.clip(grown, -bound, bound), abs=1e-9)


@pytest.mark.parametrize("gain", [0.0, 2.0])
def test_the_integrator_does_not_wind_up_at_the_limit(gain: float) -> None:
    controller = Controller(PROJECT.controller, {"M1_torque_gain": gain, "M1_torque_model": 0.0})
    for _ in range(200):
        controller.step(diff_input_torque_ref=2000.0)
    assert controller.state("M1_torque_integral") == 0.0


def test_gain_of_the_file_is_emitted() -> None:
    bed = differential_bed()
    bed.control = {"torque_gain": "0.4"}
    signal = next(s for s in Project(bed.load()).controller.parameters if s.name == "M1_torque_gain")
    assert (signal.value, signal.least, signal.least_allowed) == (0.4, -1.0, False)


# --- known losses


def geared(speed: list[str], torque: list[str]) -> Project:
    """Return M1 and M2 with a gearbox between flange and place, whose loss torque is known."""
    bed = Bed()
    bed.add("flange1", "torque_flange", inertia=0.03, stiffness=380e3)
    bed.add("shaft1", "shaft", stiffness=20e3)
    bed.add("box", "gearbox", ratio=4.0, inertia=0.05)
    bed = two_machines(["flange1", "box", "shaft1"], bed, place="box.output")
    bed.control = {"losses": {"box": {"speed": speed, "torque": torque}}}
    return Project(bed.load())


CASES = {
    "from zero": (["0 rad/s", "10 rad/s", "40 rad/s"], ["0 N m", "5 N m", "8 N m"]),
    "without zero": (["10 rad/s", "40 rad/s"], ["5 N m", "8 N m"]),
    "both directions": (["-30 rad/s", "5 rad/s", "40 rad/s"], ["-4 N m", "2 N m", "8 N m"]),
}


HELD = {"box_output_torque_ref_rate": 1e-9}
"""The reference of the first step starts at the estimate of the testing torque, and stays there."""


def share_of(project: Project) -> float:
    (share,) = project.design.decoupling.law.estimate_losses
    return float(share.subs(project.design.decoupling.values))


@pytest.mark.compile
@pytest.mark.parametrize("case", CASES)
def test_known_loss_is_the_map(case: str) -> None:
    """The estimate holds the loss torque times the ratio, clamped at the ends, in NumPy and in C."""
    project = geared(*CASES[case])
    library = build(project)
    speeds, torques = (np.array([float(text.split()[0]) for text in column]) for column in CASES[case])
    if speeds[0] >= 0:
        keep = speeds > 0
        speeds, torques = (np.concatenate([-each[keep][::-1], each[keep]]) for each in (speeds, torques))
    assert abs(share_of(project)) == pytest.approx(4.0)
    for speed in np.linspace(-60.0, 60.0, 49):
        for controller in (Controller(project.controller, HELD), Compiled(library, HELD)):
            controller.step(M1_speed=speed, M2_speed=speed / 4, M2_speed_ref=speed / 4)
            expected = share_of(project) * np.interp(speed, speeds, torques)
            assert controller.state("box_output_torque_ref_limited") == pytest.approx(expected, abs=1e-9)


def test_a_torque_at_standstill_is_reached_at_once() -> None:
    """The direction of a loss at 0 rpm is unknown; it is there within a hundredth of the next speed."""
    project = geared(["0 rad/s", "10 rad/s"], ["3 N m", "4 N m"])
    for speed, expected in ((0.0, 0.0), (0.1, 3.01), (-0.1, -3.01), (5.0, 3.5), (-20.0, -4.0)):
        controller = Controller(project.controller, HELD)
        controller.step(M1_speed=speed, M2_speed=speed / 4, M2_speed_ref=speed / 4)
        wanted = share_of(project) * expected
        assert controller.state("box_output_torque_ref_limited") == pytest.approx(wanted, abs=1e-9)


# --- a ratio that changes


def shifted() -> Project:
    bed = Bed()
    for name in ("flange1", "flange2"):
        bed.add(name, "torque_flange", inertia=0.03, stiffness=380e3)
    bed.add("shaft1", "shaft", stiffness=20e3)
    bed.add("shaft2", "shaft", stiffness=60e3)
    bed.add("box", "gearbox", ratio=2.0, inertia=0.02, ratio_range=[1.0, 4.0])
    return Project(two_machines(["flange1", "shaft1", "box", "shaft2", "flange2"], bed).load())


def test_a_changing_ratio_adds_its_rate_and_no_more_than_its_rate() -> None:
    """(5.62): the torque that M1 needs while the ratio changes is I1 (di/dt) omega2, at the limited rate."""
    project = shifted()
    assert "box_ratio" in {s.name for s in project.controller.inputs}
    assert "box_ratio" not in {s.name for s in project.controller.parameters}
    rate = next(s.value for s in project.controller.parameters if s.name == "box_ratio_rate")
    assert rate == pytest.approx((4.0 - 1.0) / 0.5)
    inertia, speed = project.design.gains.inertia_estimate["M1"], 10.0
    controller = Controller(project.controller, {"M1_damping": 0.0})
    turning = {"M2_speed": speed, "M2_speed_ref": speed}
    assert controller.step(box_ratio=2.0, M1_speed=2 * speed, **turning)["M1_torque_ref"] == pytest.approx(
        0.0, abs=1e-9
    )
    for k in range(1, 4):
        ratio = 2.0 + k * H * rate
        torque = controller.step(box_ratio=3.0, M1_speed=ratio * speed, **turning)["M1_torque_ref"]
        assert controller.state("box_ratio_limited") == pytest.approx(ratio)
        assert torque == pytest.approx(inertia * rate * speed, rel=1e-6)
    for _ in range(3):
        controller.step(box_ratio=5.0, M1_speed=20.0, **turning)
    controller.set({"box_ratio_rate": 1e9})
    controller.step(box_ratio=5.0, M1_speed=20.0, **turning)
    assert controller.state("box_ratio_limited") == 4.0, "beyond its range"


def test_without_a_changing_ratio_nothing_is_emitted() -> None:
    assert not [
        s.name
        for s in PROJECT.controller.signals()
        if "ratio_limited" in s.name or ("_per_" in s.name and "ratio" in s.name)
    ]

"""The torque-speed envelope, Figure 7.1, and the share of it that is kept for the damping."""

from __future__ import annotations

import numpy as np
import pytest
from controller_steps import Controller
from hypothesis import given
from hypothesis import strategies as st
from mechanism.bed_text import differential_bed

from ptgen.project import Project

PROJECT = Project(differential_bed().load())
TORQUE, RATED, LARGEST = 1000.0, 300.0, 900.0


def largest(speed: float, sign: float) -> float:
    """Return the torque of M2 at a speed when the speed control asks for all it can get in one direction."""
    controller = Controller(PROJECT.controller, {"M2_speed_plausible": 1e6, "M2_speed_ref_plausible": 1e6})
    return sign * controller.step(M2_speed=speed, M2_speed_ref=speed + sign * 1e4)["M2_torque_ref"]


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_full_torque_then_constant_power(sign: float) -> None:
    for speed in np.linspace(-LARGEST, LARGEST, 37):
        expected = TORQUE if abs(speed) <= RATED else TORQUE * RATED / abs(speed)
        assert largest(float(speed), sign) == pytest.approx(expected)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_beyond_the_largest_speed_nothing_accelerates_further(sign: float) -> None:
    """Accelerating torque goes to zero in a straight line within 5 %; braking torque stays."""
    for excess, left in ((0.0, 1.0), (0.0125, 0.75), (0.025, 0.5), (0.05, 0.0), (0.4, 0.0)):
        speed = sign * LARGEST * (1 + excess)
        power = TORQUE * RATED / abs(speed)
        assert largest(speed, sign) == pytest.approx(left * power, abs=1e-9)
        assert largest(speed, -sign) == pytest.approx(power)


@given(st.floats(-1, 1), st.floats(-1, 1), st.floats(-800, 800))
def test_neither_reference_nor_acceleration_can_use_up_the_damping(asked: float, pull: float, speed: float) -> None:
    """Whatever the speed controllers ask for, damping within its reserve reaches M1, also in field weakening."""
    controller = Controller(PROJECT.controller, {"M1_inertia_estimate": 50.0})
    reserve = float(controller.parameters["M1_damping_reserve"])
    room = reserve * TORQUE * RATED / max(RATED, abs(speed))
    ratio, damping = 1.91, float(controller.parameters["M1_damping"])
    twist = pull * room / damping
    outputs = {}
    for share in (0.0, 1.0):
        inputs = {
            "M1_speed": speed,
            "M2_speed": (speed + twist) / ratio,
            "M3_speed": (speed + twist) / ratio,
            "M2_speed_ref": 1000.0 * asked,
            "M3_speed_ref": 1000.0 * asked,
            "diff_input_torque_ref": 1500.0 * asked,
        }
        outputs[share] = Controller(
            PROJECT.controller, {"M1_inertia_estimate": 50.0, "M1_damping": share * damping}
        ).step(**inputs)["M1_torque_ref"]
    assert outputs[1.0] - outputs[0.0] == pytest.approx(damping * twist, abs=1e-6)

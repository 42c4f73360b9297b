"""References: limits of their rates, where they start, speeds as mean and difference."""

from __future__ import annotations

import numpy as np
import pytest
from controller_steps import Controller
from hypothesis import given
from hypothesis import strategies as st
from mechanism.bed_text import differential_bed

from ptgen.control.plausibility import largest_torque
from ptgen.project import Project

H = 1e-4


def paired(**control: object) -> Project:
    bed = differential_bed()
    bed.control = {"speed_pairs": {"rear": ["M2", "M3"]}, **control}
    return Project(bed.load())


PAIRED, PLAIN = paired(), Project(differential_bed().load())


def test_default_rates_are_what_the_bed_can_follow() -> None:
    gains, model = PLAIN.design.gains, PLAIN.model
    assert gains.speed_rate == pytest.approx({"M2": 1000.0 / 10.3, "M3": 1000.0 / 8.0}, rel=1e-5)
    fastest = largest_torque(model, model.signals["diff.input"]) * gains.natural_frequency["M1"]
    assert gains.torque_rate["M1"] == pytest.approx(fastest, rel=1e-5)


def test_rates_of_the_file_win() -> None:
    project = paired(speed_rate="500 rpm/s", torque_rate="20 kN m/s")
    values = {signal.name: signal.value for signal in project.controller.parameters}
    assert values["rear_speed_mean_ref_rate"] == pytest.approx(500 * 2 * np.pi / 60)
    assert values["diff_input_torque_ref_rate"] == pytest.approx(20e3)


@given(st.floats(-100, 100), st.floats(-100, 100), st.floats(1, 1e6))
def test_a_reference_moves_no_faster_than_its_rate_and_arrives(start: float, end: float, rate: float) -> None:
    """It starts where the machine is, also if that turns already."""
    controller = Controller(PLAIN.controller, {"M2_speed_ref_rate": rate})
    values = [start]
    for _ in range(20):
        controller.step(M2_speed=start, M2_speed_ref=end)
        values.append(controller.state("M2_speed_ref_limited"))
    steps = np.diff(values)
    assert np.abs(steps).max() <= rate * H * (1 + 1e-9) + 1e-12
    expected = start + np.clip(end - start, -20 * rate * H, 20 * rate * H)
    assert values[-1] == pytest.approx(expected, abs=1e-9)


def test_a_flying_start_and_a_start_after_a_fault_do_not_brake() -> None:
    """The references of the first step are where the bed is, so nothing is asked for that was not wanted."""
    rates = {"M2_speed_ref_rate": 1.0, "M3_speed_ref_rate": 1.0}
    controller = Controller(PLAIN.controller, {**rates, "hold_time": 0.0})
    turning = {"M1_speed": 95.5, "M2_speed": 50.0, "M3_speed": 50.0, "M2_speed_ref": 50.0, "M3_speed_ref": 50.0}
    assert controller.step(**turning) == pytest.approx(
        dict.fromkeys(("M1_torque_ref", "M2_torque_ref", "M3_torque_ref"), 0.0)
    )
    controller.step(**{**turning, "M2_speed": np.nan})
    assert controller.state("running") == 0.0


@given(st.floats(-50, 50), st.floats(-50, 50), st.floats(-50, 50))
def test_mean_and_difference_are_the_two_speeds(mean: float, difference: float, turning: float) -> None:
    """Both controllers are the same but for their references."""
    speeds = {"M2_speed": turning, "M3_speed": -turning}
    pair = Controller(PAIRED.controller).step(rear_speed_mean_ref=mean, rear_speed_difference_ref=difference, **speeds)
    plain = Controller(PLAIN.controller).step(
        M2_speed_ref=mean + difference / 2, M3_speed_ref=mean - difference / 2, **speeds
    )
    assert pair == pytest.approx(plain, abs=1e-8)
    assert PAIRED.design.controller.references == {
        "torque.M1": "diff_input_torque_ref",
        "speed_mean.rear": "rear_speed_mean_ref",
        "speed_difference.rear": "rear_speed_difference_ref",
    }

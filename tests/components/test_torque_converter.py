"""Torque converter: (3.37)-(3.41), its torques in all quadrants, and what its maps must not be."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from loose_component import COAST, EXAMPLES, REVERSE, case, is_zero, loose_model, symbols_of
from scipy.interpolate import PchipInterpolator

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.friction.event_fluid import EventFluid
from ptgen.testbed.problems import validated

NAMES = ("torque_converter", "torque converter with all maps")
REFERENCE = 2000 * np.pi / 30
DRIVE: dict[str, Any] = EXAMPLES["torque_converter"]["drive"]  # type: ignore[assignment]
SPEEDS = st.floats(-700, 700)


def fluid_of(component: Component) -> EventFluid:
    (fluid,) = component.elements("x").fluids
    return EventFluid(fluid, REFERENCE)


FLUIDS = {name: fluid_of(case(name)) for name in NAMES}


def numbers(texts: Sequence[str]) -> list[float]:
    return [float(text.removesuffix(" N m")) for text in texts]


def test_maps_of_the_file_are_3_38_and_3_39() -> None:
    for share, ratio, torque in zip(
        DRIVE["speed_ratio"], DRIVE["torque_ratio"], numbers(DRIVE["pump_torque"]), strict=True
    ):
        for pump in (40.0, REFERENCE, 500.0):
            T_p, T_t = FLUIDS["torque_converter"].torques(pump, share * pump)
            scale = (pump / REFERENCE) ** 2
            assert T_p == pytest.approx(torque * scale, abs=1e-9)
            assert T_t == pytest.approx(ratio * torque * scale, abs=1e-9)


def test_coast_and_reverse_maps_hold_where_they_were_measured() -> None:
    fluid = FLUIDS["torque converter with all maps"]
    for share, ratio, torque in zip(
        COAST["speed_ratio"], COAST["torque_ratio"], numbers(COAST["turbine_torque"]), strict=True
    ):
        assert fluid.torques(share * REFERENCE, REFERENCE) == pytest.approx([-ratio * torque, -torque], abs=1e-9)
    for share, ratio, torque in zip(
        REVERSE["speed_ratio"], REVERSE["torque_ratio"], numbers(REVERSE["pump_torque"]), strict=True
    ):
        assert fluid.torques(REFERENCE, share * REFERENCE) == pytest.approx([torque, ratio * torque], abs=1e-9)


@given(st.floats(0, 1))
def test_curves_are_those_of_fritsch_and_carlson(share: float) -> None:
    points = [-1, *DRIVE["speed_ratio"]]
    torque, ratio = numbers(DRIVE["pump_torque"]), DRIVE["torque_ratio"]
    T_p = float(PchipInterpolator(points, [torque[0], *torque])(share))
    T_t = T_p * float(PchipInterpolator(points, [ratio[0], *ratio])(share))
    assert FLUIDS["torque_converter"].torques(REFERENCE, share * REFERENCE) == pytest.approx([T_p, T_t], abs=1e-9)


@pytest.mark.parametrize(("pump", "turbine", "T_p", "T_t"), [(1, 0, 180, 360), (1, -0.6, 180, 360), (0, 1, -180, -180)])
def test_stall_and_what_is_left_out_of_the_file(pump: float, turbine: float, T_p: float, T_t: float) -> None:
    torques = FLUIDS["torque_converter"].torques(pump * REFERENCE, turbine * REFERENCE)
    assert torques == pytest.approx([T_p, T_t])


@pytest.mark.parametrize("share", [0.0, 0.1, 0.35, 0.77, 0.95, 1.0])
def test_coasting_and_turning_backward_it_is_a_fluid_coupling(share: float) -> None:
    fluid = FLUIDS["torque_converter"]
    T_p, _ = fluid.torques(REFERENCE, share * REFERENCE)
    assert fluid.torques(share * REFERENCE, REFERENCE) == pytest.approx([-T_p, -T_p], abs=1e-9)
    assert fluid.torques(-REFERENCE, -share * REFERENCE) == pytest.approx([-T_p, -T_p], abs=1e-9)
    assert fluid.torques(-share * REFERENCE, -REFERENCE) == pytest.approx([T_p, T_p], abs=1e-9)


@pytest.mark.parametrize("name", NAMES)
@given(pump=SPEEDS, turbine=SPEEDS)
def test_loss_is_heat_in_all_quadrants(name: str, pump: float, turbine: float) -> None:
    T_p, T_t = FLUIDS[name].torques(pump, turbine)
    assert T_p * pump - T_t * turbine >= -1e-9 * (1 + abs(T_p * pump))


@pytest.mark.parametrize("name", NAMES)
@given(angle=st.floats(0, 2 * np.pi))
def test_torques_are_continuous_and_vanish_at_rest(name: str, angle: float) -> None:
    fluid, step = FLUIDS[name], 1e-7
    here, there = (fluid.torques(REFERENCE * np.cos(a), REFERENCE * np.sin(a)) for a in (angle, angle + step))
    assert np.abs(here - there).max() < 4000 * step
    assert np.abs(fluid.torques(1e-9 * np.cos(angle), 1e-9 * np.sin(angle))).max() < 1e-15
    assert fluid.torques(0.0, 0.0).tolist() == [0.0, 0.0]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("quarter", range(8))
def test_sectors_meet_at_their_borders(name: str, quarter: int) -> None:
    angle = np.pi / 4 * quarter
    before, after = (
        FLUIDS[name].torques(REFERENCE * np.cos(angle + side), REFERENCE * np.sin(angle + side))
        for side in (-1e-12, 1e-12)
    )
    assert before == pytest.approx(after, abs=1e-6)


def test_pump_and_turbine_follow_3_40_and_3_41() -> None:
    """The lock-up clutch and the fluid are what stands between the two."""
    component = case("torque_converter")
    p, model = symbols_of(component), loose_model(component)
    T_1, T_2, T_c, T_p, T_t = sp.symbols("T_1 T_2 T_c T_p T_t")
    assert [friction.name for friction in model.frictions] == ["x.lockup"]
    rate = model.accelerations()
    found = rate.u * sp.Matrix([T_1, -T_2]) + rate.f * sp.Matrix([T_c, T_p, T_t])
    pump, turbine = ((model.velocity_rows[f"x.{side}"] * found)[0] for side in ("pump", "turbine"))
    assert is_zero(p["inertia_pump"] * pump - (T_1 - T_c - T_p))
    assert is_zero(p["inertia_turbine"] * turbine - (T_c + T_t - T_2))


# --- errors


def problems_of(**changes: object) -> list[str]:
    table = {"type": "torque_converter", **copy.deepcopy(EXAMPLES["torque_converter"]), **changes}
    _, problems = validated(CATALOGUE["torque_converter"], table, "components", "tc")
    assert all(problem.remedy for problem in problems)
    return [f"{problem.where}: {problem.what}; {problem.remedy}" for problem in problems]


def drive(**changes: object) -> dict[str, object]:
    return {"drive": {**DRIVE, **changes}}


@pytest.mark.parametrize(
    ("changes", "where", "words"),
    [
        (drive(speed_ratio=[0, 0.2, 0.4, 0.4, 0.8, 0.9, 1]), "drive.speed_ratio[3]", "must rise strictly, got 0.4"),
        (drive(speed_ratio=[0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1]), "drive.speed_ratio[0]", "must begin at 0, got 0.1"),
        (
            drive(speed_ratio=[0, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95]),
            "drive.speed_ratio[6]",
            "leave a gap, add the point at 1",
        ),
        (drive(speed_ratio=[0, 0.2, 0.4, 0.4 + 1e-9, 0.8, 0.9, 1]), "drive.speed_ratio[3]", "is only 1e-09 above"),
        (drive(torque_ratio=[2, 1]), "drive.torque_ratio", "as many entries as speed_ratio (7), got 2"),
        (drive(pump_torque=["1 N m"]), "drive.pump_torque", "as many entries as speed_ratio (7), got 1"),
        (drive(speed_ratio=[]), "drive.speed_ratio", "needs two points at least, got 0"),
        (drive(torque_ratio=[2, 1.75, 1.5, 1.6, 1.02, 1, 1]), "drive.torque_ratio[3]", "must not rise"),
        (drive(torque_ratio=[2, 1.75, 1.5, 1.3, 1.3, 1, 1]), "drive.torque_ratio[4]", "at most 1.25"),
        (drive(torque_ratio=[2, 1.75, 1.5, 1.3, 1.2, 1.1, 1.1]), "drive.torque_ratio[6]", "at most 1 there"),
        (drive(torque_ratio=[2, -1.75, 1.5, 1.3, 1.2, 1.1, 1.1]), "drive.torque_ratio[1]", "must be >= 0"),
        (drive(pump_torque=["180 N m"] * 6 + ["1 N m"]), "drive.pump_torque[6]", "must be 0 N m at equal speeds"),
        (drive(pump_torque=["180 N m"] * 5 + ["-2 N m", "0 N m"]), "drive.pump_torque[5]", "must be >= 0 N m"),
        (drive(pump_torque=["0 N m"] * 7), "drive.pump_torque[0]", "must be > 0 N m at stall"),
        (
            drive(pump_torque=["180 N m", "30 N m", "180 N m", "165 N m", "130 N m", "80 N m", "0 N m"]),
            "drive.pump_torque[2]",
            "faster than the square of the speed ratio",
        ),
        (
            drive(speed_ratio=[0, 0.5, 1], torque_ratio=[2, 2, 1], pump_torque=["90 N m", "90 N m", "0 N m"]),
            "drive.torque_ratio",
            "between the speed ratios 0.5 and 1 create energy",
        ),
        (
            {"reverse": {**REVERSE, "torque_ratio": [1.2, 1.8, 1.9]}},
            "reverse.torque_ratio[2]",
            "does not meet the drive",
        ),
        ({"reverse": {**REVERSE, "speed_ratio": [-1, -0.5, -0.1]}}, "reverse.speed_ratio[2]", "must end at 0"),
        ({"reverse": {**REVERSE, "torque_ratio": [-1.2, 1.8, 2]}}, "reverse.torque_ratio[0]", "must be at least -1"),
        ({"coast": {**COAST, "speed_ratio": [0, 0.5, 0.9, 1.1]}}, "coast.speed_ratio[3]", "must end at 1, got 1.1"),
        ({"coast": {**COAST, "torque_ratio": [0.8, 2.2, 0.9, 1]}}, "coast.torque_ratio[1]", "at most 2 there"),
        ({"coast": {**COAST, "turbine_torque": ["9 N m"] * 4}}, "coast.turbine_torque[3]", "must be 0 N m"),
        ({"lockup": {"capacity": "3 N m", "stribeck_speed": "3 rpm"}}, "lockup", "stribeck_speed needs static"),
        ({"drive": {"speed_ratio": [0, 1]}}, "drive.pump_torque", "is missing"),
    ],
)
def test_impossible_maps_are_refused(changes: dict[str, object], where: str, words: str) -> None:
    found = problems_of(**changes)
    assert any(text.startswith(f"components.tc.{where}: ") and words in text for text in found), found


@given(
    st.lists(st.floats(0, 1) | st.sampled_from([0.0, 5e-324, 1e-6, 0.5, 0.9999995, 1.0]), min_size=1, max_size=6),
    st.lists(st.floats(0, 3) | st.sampled_from([1e-300, 1e15]), min_size=6, max_size=6),
    st.lists(st.floats(0, 300) | st.sampled_from([1e-300, 1e15]), min_size=6, max_size=6),
)
def test_whatever_the_maps_are_they_are_refused_or_make_sense(
    share: list[float], ratio: list[float], torque: list[float]
) -> None:
    share, count = sorted({0.0, *share, 1.0}), len({0.0, *share, 1.0})
    given_map = {
        "speed_ratio": share,
        "torque_ratio": sorted([*ratio, 1.0, 1.0][:count], reverse=True),
        "pump_torque": [f"{value!r} N m" for value in [*torque, *torque][: count - 1]] + ["0 N m"],
    }
    table = {"type": "torque_converter", **EXAMPLES["torque_converter"], "drive": given_map}
    component, problems = validated(CATALOGUE["torque_converter"], table, "components", "tc")
    assert problems or component is not None
    if component is None:
        return
    fluid = fluid_of(component)
    for angle in np.linspace(0, 2 * np.pi, 97):
        speeds = REFERENCE * np.array([np.cos(angle), np.sin(angle)])
        T_p, T_t = fluid.torques(*speeds)
        assert np.isfinite([T_p, T_t]).all()
        assert T_p * speeds[0] - T_t * speeds[1] >= -1e-6 * REFERENCE * (1 + max(torque))


def test_all_problems_of_a_converter_are_told_at_once() -> None:
    wrong = drive(torque_ratio=[2, 1.75, 1.8, 1.25, 1.3, 1, 1])
    found = problems_of(**wrong, inertia_pump="-1 kg m^2", coast={**COAST, "speed_ratio": [0.1, 0.5, 0.4, 1]})
    places = {text.partition(":")[0].removeprefix("components.tc.") for text in found}
    assert places == {
        "inertia_pump",
        "drive.torque_ratio[2]",
        "drive.torque_ratio[4]",
        "coast.speed_ratio[0]",
        "coast.speed_ratio[2]",
    }

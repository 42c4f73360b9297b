"""Table 3.1 of the source, every formula and every printed digit, from the layout alone."""

from __future__ import annotations

import pytest
import sympy as sp
from gear_layouts import NINE_SPEED_GEARS, nine_speed

from ptgen.gears import GearAnalysis, State, analyse_gears, gear_ratios, shift_table_problems

g1, g2, g3, g4 = sp.symbols("g1:5", positive=True)

PRINTED = {
    "R": (-g1 * g2 * (1 + g3) / (1 + g2), "-4.932"),
    "1": ((1 + g1 + g2) * (1 + g3) / (1 + g2), "5.503"),
    "2": (1 + g3, "3.333"),
    "3": ((1 + g3) * g2 / (1 + g2), "2.315"),
    "4": ((1 + g3 + g4) / (1 + g4), "1.661"),
    "5": (g2 * g4 / (g2 * g4 - 1), "1.211"),
    "6": (sp.Integer(1), "1.000"),
    "7": (g4 / (1 + g4 - (1 + g2) / (1 + g1 + g2)), "0.865"),
    "8": (g4 / (1 + g4), "0.717"),
    "9": (g1 * g2 * g4 / (1 + g2 + g1 * g2 + g1 * g2 * g4), "0.601"),
}


@pytest.fixture(scope="module")
def found() -> GearAnalysis:
    return analyse_gears(nine_speed(loss=0.01), NINE_SPEED_GEARS)


@pytest.fixture(scope="module")
def unnamed() -> GearAnalysis:
    """The same without a shift table: gears are found and counted."""
    return analyse_gears(nine_speed())


@pytest.mark.parametrize("gear", PRINTED)
def test_formula(found: GearAnalysis, gear: str) -> None:
    own = found.gear(gear)
    assert own is not None and own.formula is not None
    assert sp.simplify(own.formula - PRINTED[gear][0]) == 0


@pytest.mark.parametrize("gear", PRINTED)
def test_printed_digits(found: GearAnalysis, gear: str) -> None:
    own = found.gear(gear)
    assert own is not None
    assert f"{float(own.ratio):.3f}" == PRINTED[gear][1]


def test_the_layout_has_these_gears_and_no_other(unnamed: GearAnalysis) -> None:
    assert [f"{float(gear.ratio):.3f}" for gear in unnamed.gears] == [digits for _, digits in PRINTED.values()]
    assert [gear.name for gear in unnamed.gears] == list(PRINTED)


def test_combinations_found_are_those_of_the_table(unnamed: GearAnalysis) -> None:
    for gear in unnamed.gears:
        # Fourth gear needs C and F only; the table holds P2.sun with B, which carries nothing.
        assert set(gear.needed) <= set(NINE_SPEED_GEARS[gear.name])
        assert (set(NINE_SPEED_GEARS[gear.name]) - set(gear.needed)) == ({"B"} if gear.name == "4" else set())


def test_neutral_of_the_table_is_neutral(found: GearAnalysis) -> None:
    neutral = next(one for one in found.combinations if one.engaged == ("B", "C"))
    assert neutral.state is State.NEUTRAL and neutral.degrees_of_freedom == 2
    assert found.neutral == ("B", "C")


def test_idle_brake_carries_no_torque_and_is_said_to_be_idle(found: GearAnalysis) -> None:
    fourth = found.gear("4")
    assert fourth is not None
    assert fourth.idle == ("B",) and fourth.ideal.elements["B"] == 0.0
    assert {tuple(sorted(way)) for way in fourth.alternatives} == {
        ("C", "F"),
        ("A", "C", "F"),
        ("B", "C", "F"),
        ("C", "D", "F"),
        ("C", "E", "F"),
    }


def test_spread_and_steps(found: GearAnalysis) -> None:
    assert found.spread == pytest.approx(9.15, abs=0.005)
    assert list(found.steps) == list("12345678")
    assert found.steps["1"] == pytest.approx(5.503 / 3.333, abs=1e-3)


@pytest.mark.parametrize(
    ("start", "end", "release", "engage"),
    [("1", "2", "B", "D"), ("3", "1", "D", "E"), ("2", "1", "D", "B"), ("8", "9", "E", "B")],
)
def test_every_neighbour_is_one_change_away(
    found: GearAnalysis, start: str, end: str, release: str, engage: str
) -> None:
    change = found.change(start, end)
    assert change is not None
    assert (change.release, change.apply) == ((release,), (engage,)) and not change.before and not change.after
    for low, high in zip("12345678", "23456789", strict=True):
        step = found.change(low, high)
        assert step is not None and step.is_single


def test_a_far_change_needs_more(found: GearAnalysis) -> None:
    change = found.change("1", "9")
    assert change is not None and not change.is_single
    assert set(change.release) == {"C", "E"} and set(change.apply) == {"A", "F"}


def test_shift_table_has_no_problems() -> None:
    assert shift_table_problems(nine_speed(), NINE_SPEED_GEARS) == []


def test_ratios_for_others() -> None:
    ratios = gear_ratios(nine_speed(), NINE_SPEED_GEARS)
    assert list(ratios) == list(PRINTED)
    assert ratios["2"] == pytest.approx(10 / 3, rel=1e-15)

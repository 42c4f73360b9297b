"""Degrees of freedom, tie-ups, neutrals and gears of every combination, against linear algebra by brute force."""

from __future__ import annotations

import random

import pytest
import sympy as sp
from gear_layouts import DUAL_CLUTCH_GEARS, Gearing, dual_clutch, nine_speed

from ptgen.errors import ModelError
from ptgen.gears import Layout, State, analyse_gears, layout_of
from ptgen.gears.changes import Exchange
from ptgen.gears.combinations import combinations
from ptgen.gears.joined import exact


def random_layout(seed: int) -> Layout:
    chance = random.Random(seed)
    gearing = Gearing()
    flanges = []
    for number in range(1, chance.randint(1, 3) + 1):
        sun = chance.randint(20, 50)
        gearing.set(f"P{number}", sun, sun + chance.randint(2, 70), double=chance.random() < 0.3)
        flanges += [f"P{number}.{part}" for part in ("sun", "ring", "carrier")]
    members = [f"m{k}" for k in range(chance.randint(3, 5))]
    members[:2] = ["input", "output"]
    joined: dict[str, list[str]] = {member: [] for member in members}
    for flange in flanges:
        joined[chance.choice(members)].append(flange)
    for k in range(chance.randint(2, 5)):
        name = f"E{k}"
        if chance.random() < 0.5:
            gearing.brake(name)
            joined[chance.choice(members)].append(f"{name}.left")
        else:
            gearing.clutch(name)
            for end in ("input", "output"):
                joined[chance.choice(members)].append(f"{name}.{end}")
    for member, parts in joined.items():
        gearing.member(member, *parts)
    return gearing.layout()


@pytest.mark.parametrize("seed", range(25))
def test_random_layouts_against_brute_force(seed: int) -> None:
    layout = random_layout(seed)
    rows = [layout.train_vector(train) for train in layout.trains]
    input_, output = (layout.unit_vector(member) for member in (layout.input, layout.output))
    for found in combinations(layout):
        engaged = [layout.element_vector(e) for e in layout.elements if e.name in found.engaged]
        matrix = sp.Matrix([*rows, *engaged]) if rows or engaged else sp.zeros(0, len(layout.members))
        rank = matrix.rank()
        free = [sp.Matrix.vstack(matrix, sp.Matrix([row])).rank() > rank for row in (input_, output)]
        both = sp.Matrix.vstack(matrix, sp.Matrix([input_]), sp.Matrix([output])).rank() - rank
        state = State.TIE_UP if not all(free) else State.NEUTRAL if both == 2 else State.GEAR
        assert found.degrees_of_freedom == len(layout.members) - rank
        assert found.state is state
        assert found.blocked == tuple(n for n, ok in zip(("input", "output"), free, strict=True) if not ok)
        bare = rank - sp.Matrix(rows).rank() if rows else rank
        assert len(found.redundant) == len(engaged) - bare


@pytest.mark.parametrize("seed", range(25))
def test_formulas_of_random_gears_have_the_value_of_the_numbers(seed: int) -> None:
    found = analyse_gears(random_layout(seed))
    values = {symbol: sp.Rational(v.numerator, v.denominator) for symbol, v in found.layout.values.items()}
    for gear in found.gears:
        assert gear.formula is None or gear.formula.subs(values) == sp.Rational(str(gear.ratio))
        for speed in gear.speeds.values():
            assert speed.formula is None or speed.formula.subs(values) == sp.Rational(str(speed.value))


def test_sixty_four_combinations_of_the_nine_speed_set() -> None:
    found = combinations(nine_speed())
    assert len(found) == 64 and len({one.engaged for one in found}) == 64
    assert found[0].engaged == () and found[0].degrees_of_freedom == 4
    triples = [one for one in found if len(one.engaged) == 3]
    assert {one.engaged for one in triples if one.state is State.TIE_UP} == {
        tuple(names) for names in ("ABD", "ABE", "ACD", "ACE", "ADE", "ADF", "BDE")
    }
    assert all(one.state is State.TIE_UP for one in found if len(one.engaged) > 3)


def test_redundant_elements_are_named() -> None:
    everything = combinations(nine_speed())[-1]
    assert everything.degrees_of_freedom == 0 and everything.redundant == ("E", "F")


def test_equal_teeth_make_gears_that_no_formula_has() -> None:
    """Two sets side by side on the same sun and ring: the carriers turn alike only if the ratios are equal."""

    def side_by_side(second: int) -> Layout:
        gearing = Gearing()
        gearing.set("P1", 30, 60)
        gearing.set("P2", 40, second)
        gearing.member("sun", "P1.sun", "P2.sun")
        gearing.member("ring", "P1.ring", "P2.ring")
        gearing.member("input", "P1.carrier")
        gearing.member("output", "P2.carrier")
        return gearing.layout()

    equal = analyse_gears(side_by_side(80))
    assert [gear.engaged for gear in equal.gears] == [()]
    assert equal.gears[0].ratio == 1 and equal.gears[0].formula is None
    assert not analyse_gears(side_by_side(81)).gears


def test_preselected_gears_are_the_same_gear() -> None:
    found = analyse_gears(dual_clutch(), DUAL_CLUTCH_GEARS)
    assert [gear.name for gear in found.gears] == ["R", "1", "2", "3", "4"]
    first = found.gear("1")
    assert first is not None and ("K1", "S1", "S2") in first.alternatives
    assert ("K1", "S1", "S3") not in first.alternatives  # both on one shaft: that ties up
    assert first.ideal.output_torque == pytest.approx(-47 / 13)
    assert first.speeds["outer"].value is None  # turns idle, at any speed


def test_preselection_makes_a_change_of_one_clutch_for_the_other() -> None:
    found = analyse_gears(dual_clutch(), DUAL_CLUTCH_GEARS)
    change = found.change("1", "2")
    assert change is not None and change.is_single
    assert (change.release, change.apply) == (("K1",), ("K2",))
    assert change.before == Exchange((), ("S2",)) and change.after == Exchange(("S1",), ())
    same_shaft = found.change("1", "3")
    assert same_shaft is not None and same_shaft.is_single and same_shaft.release == ("S1",)
    reverse = found.change("R", "1")
    assert reverse is not None and (reverse.release, reverse.apply) == (("SR",), ("S1",))


def test_names_without_a_prefix_and_members_with_their_flanges() -> None:
    layout = nine_speed()
    assert layout.flanges["b"] == ("P2.ring", "P3.sun", "P4.sun", "E.input")
    assert layout.input == "input" and layout.output == "output"


def test_an_element_that_is_always_pressed_is_a_joint_and_not_a_shift_element() -> None:
    gearing = Gearing()
    gearing.clutch("K")
    gearing.member("input", "K.input")
    gearing.member("output", "K.output")
    assert [gear.engaged for gear in analyse_gears(gearing.layout()).gears] == [("K",)]
    from dataclasses import replace

    from ptgen.elements import Elements

    pressed = Elements(
        frictions=tuple(replace(friction, actuated=False) for friction in gearing.frictions),
        connections=tuple(gearing.connections),
    )
    layout = layout_of(pressed, "input", "output", {})
    assert layout.elements == () and layout.input == layout.output


def test_too_many_elements_are_told() -> None:
    gearing = Gearing()
    names = [f"K{k}" for k in range(15)]
    gearing.clutch(*names)
    gearing.member("input", *(f"{name}.input" for name in names))
    gearing.member("output", *(f"{name}.output" for name in names))
    with pytest.raises(ModelError, match="15 shift elements"):
        analyse_gears(gearing.layout())


@pytest.mark.parametrize("teeth", [(46, 98), (37, 71), (13, 47), (97, 100)])
def test_quotients_of_teeth_are_found_again(teeth: tuple[int, int]) -> None:
    number = exact(teeth[1] / teeth[0])
    assert number * teeth[0] == teeth[1]

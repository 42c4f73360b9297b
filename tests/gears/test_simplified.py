"""Simplified gearboxes of Section 3.7.2 have the inertia, slips and clutch torques of the gear set in both gears."""

from __future__ import annotations

import itertools
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from gear_layouts import Gearing
from hypothesis import given, settings
from hypothesis import strategies as st

from ptgen.errors import ModelError
from ptgen.gears import GearAnalysis, Layout, SimplifiedGearbox, analyse_gears, layout_of_part, simplified_gearbox
from ptgen.testbed.parts import read_part

NEIGHBOURS = [*itertools.pairwise("123456789"), ("R", "1"), ("3", "1"), ("2", "4")]


@cache
def nine_speed() -> GearAnalysis:
    part = read_part(Path("parts/nine-speed.toml"))(type="part", file="parts/nine-speed.toml")
    return analyse_gears(layout_of_part(part), part.description.gears)


def velocities(layout: Layout, locked: tuple[str, ...], ends: tuple[float, float]) -> np.ndarray:
    """Return the velocities of all members, from those of input and output, by least squares of all rows."""
    rows = [layout.train_vector(train) for train in layout.trains]
    rows += [layout.element_vector(element) for element in layout.elements if element.name in locked]
    rows += [layout.unit_vector(layout.input), layout.unit_vector(layout.output)]
    matrix = np.array(rows, dtype=float)
    right = np.zeros(len(rows))
    right[-2:] = ends
    found, _, rank, _ = np.linalg.lstsq(matrix, right, rcond=None)
    assert rank == len(layout.members)
    return np.asarray(found)


def energy(layout: Layout, speeds: np.ndarray) -> float:
    return sum(0.5 * float(j) * speeds[layout.members.index(m)] ** 2 for m, j in layout.inertias.items())


def model_energy(box: SimplifiedGearbox, ends: tuple[float, float]) -> float:
    return 0.5 * box.inertia_input * ends[0] ** 2 + 0.5 * box.inertia_output * ends[1] ** 2


def assert_model_is_the_gear_set(layout: Layout, box: SimplifiedGearbox, output: float, other: float) -> None:
    m12 = box.masses[1]
    i, j = box.clutches[0].ratio, box.clutches[-1].ratio
    for clutch in box.clutches:
        ends = (clutch.ratio * output, output)
        own = energy(layout, velocities(layout, box.locked, ends))
        assert 0.5 * clutch.inertia * output**2 == pytest.approx(own, rel=1e-12)
        if box.is_exact:
            assert model_energy(box, ends) == pytest.approx(own, rel=1e-12)
    ends = (other, output)
    speeds = velocities(layout, box.locked, ends)
    for clutch in box.clutches:
        row = np.array(layout.element_vector(next(e for e in layout.elements if e.name == clutch.element)), dtype=float)
        slip = clutch.factor * (other - clutch.ratio * output)
        assert row @ speeds == pytest.approx(slip, rel=1e-10, abs=1e-10 * np.abs(speeds).max())
    if box.is_exact:
        own = energy(layout, speeds)
        lost = -m12 / (i + j) * (other - i * output) * (other - j * output)
        assert own - model_energy(box, ends) == pytest.approx(lost, rel=1e-10, abs=1e-12 * own)


@pytest.mark.parametrize("pair", NEIGHBOURS, ids="-".join)
def test_models_have_the_energy_of_the_nine_speed_set_in_both_gears(pair):
    found = nine_speed()
    box = simplified_gearbox(found, pair)
    assert [clutch.ratio for clutch in box.clutches] == [float(found.gear(name).ratio) for name in pair]
    assert box.inertia_input > 0
    assert box.inertia_output > 0
    assert len(box.locked) == 2
    assert box.own_motions == 0
    for output, other in ((40.0, 100.0), (-7.0, 33.0)):
        assert_model_is_the_gear_set(found.layout, box, output, other)


@given(
    inertias=st.lists(st.floats(1e-4, 1.0), min_size=12, max_size=12),
    pair=st.sampled_from(NEIGHBOURS),
    speeds=st.tuples(st.floats(1.0, 500.0), st.floats(-500.0, 500.0)),
)
@settings(max_examples=40, deadline=None)
def test_models_have_the_energy_whatever_the_inertias(inertias, pair, speeds):
    found = nine_speed()
    given_ = dict(zip(found.layout.members, map(Fraction, inertias), strict=True))
    layout = replace(found.layout, inertias=given_)
    box = simplified_gearbox(replace(found, layout=layout), pair)
    assert box.inertia_input > 0
    assert box.inertia_output > 0
    assert_model_is_the_gear_set(layout, box, *speeds)
    if not box.is_exact:
        i, j = (clutch.ratio for clutch in box.clutches)
        m11, m12, m22 = box.masses
        assert min(m11 + 2 * m12 / (i + j), m22 + 2 * m12 * i * j / (i + j)) <= 0


def test_inertias_of_the_models_are_the_only_ones_that_fit_both_gears():
    m11, m12, m22, i, j, wi, wo = sp.symbols("m11 m12 m22 i j w_i w_o")
    a, b = sp.symbols("I_gbi I_gbo")
    in_gear = [a * k**2 + b - (m11 * k**2 + 2 * m12 * k + m22) for k in (i, j)]
    solution = sp.solve(in_gear, [a, b])
    assert sp.simplify(solution[a] - (m11 + 2 * m12 / (i + j))) == 0
    assert sp.simplify(solution[b] - (m22 + 2 * m12 * i * j / (i + j))) == 0
    own = (m11 * wi**2 + 2 * m12 * wi * wo + m22 * wo**2) / 2
    model = (solution[a] * wi**2 + solution[b] * wo**2) / 2
    assert sp.simplify(own - model + m12 / (i + j) * (wi - i * wo) * (wi - j * wo)) == 0


@pytest.mark.parametrize("gear", [*"123456789", "R"])
def test_one_gear_is_exact(gear):
    found = nine_speed()
    box = simplified_gearbox(found, [gear])
    assert box.is_exact
    (clutch,) = box.clutches
    assert clutch.element in found.gear(gear).needed
    assert_model_is_the_gear_set(found.layout, box, 30.0, 12.0)


def dual_clutch() -> GearAnalysis:
    """Return two gears in parallel, each with a clutch and a synchroniser."""
    gearing = Gearing()
    gearing.pair("G1", 20, 60, reversing=False)
    gearing.pair("G2", 20, 40, reversing=False)
    gearing.clutch("K1", "K2", "S1", "S2")
    gearing.member("input", "K1.input", "K2.input")
    gearing.member("shaft1", "K1.output", "G1.input")
    gearing.member("shaft2", "K2.output", "G2.input")
    gearing.member("loose1", "G1.output", "S1.input")
    gearing.member("loose2", "G2.output", "S2.input")
    gearing.member("output", "S1.output", "S2.output")
    layout = gearing.layout()
    sizes = {"input": 0.01, "shaft1": 0.02, "shaft2": 0.03, "loose1": 0.001, "loose2": 0.001, "output": 0.05}
    layout = replace(layout, inertias={name: Fraction(str(value)) for name, value in sizes.items()})
    return analyse_gears(layout, {"1": ("K1", "S1"), "2": ("K2", "S2")})


def test_preselected_gears_are_locked_and_shafts_count_at_the_side_that_they_turn_with():
    box = simplified_gearbox(dual_clutch(), ["1", "2"])
    assert box.locked == ("S1", "S2")
    assert [clutch.element for clutch in box.clutches] == ["K1", "K2"]
    assert [clutch.factor for clutch in box.clutches] == [1.0, 1.0]
    assert box.inertia_input == pytest.approx(0.01)
    assert box.inertia_output == pytest.approx(0.05 + 0.002 + 9 * 0.02 + 4 * 0.03)
    assert box.masses[1] == 0.0


def test_members_that_turn_by_themselves_follow_without_torque():
    found = dual_clutch()
    box = simplified_gearbox(found, ["1"])
    assert box.own_motions == 1
    assert box.inertia_output == pytest.approx(0.05 + 0.001 + 9 * 0.02)


def test_what_cannot_be_simplified_is_said():
    with pytest.raises(ModelError, match=r"from gear 1 to gear 6 B and C must be released .* R, 2, 3, 4, 7"):
        simplified_gearbox(nine_speed(), ["1", "6"])
    with pytest.raises(ModelError, match='"10" is no gear of the shift table'):
        simplified_gearbox(nine_speed(), ["10"])
    with pytest.raises(ModelError, match="one gear or two different ones"):
        simplified_gearbox(nine_speed(), ["2", "2"])
    light = replace(nine_speed(), layout=replace(nine_speed().layout, inertias={}))
    with pytest.raises(ModelError, match="the input moves no inertia"):
        simplified_gearbox(light, ["1", "2"])


def test_the_torque_of_an_element_scales_with_its_lever():
    found = nine_speed()
    elements = [
        replace(element, static=2400.0, stribeck_speed=2.0, viscous=0.5) if element.name == "B" else element
        for element in found.layout.elements
    ]
    layout = replace(found.layout, elements=tuple(elements))
    clutch = simplified_gearbox(replace(found, layout=layout), ["1", "2"]).clutches[0]
    size = abs(clutch.factor)
    assert clutch.element == "B"
    assert size == pytest.approx(1.536178, abs=1e-6)
    assert clutch.capacity == pytest.approx(size * 2000.0)
    assert clutch.static == pytest.approx(size * 2400.0)
    assert clutch.stribeck_speed == pytest.approx(2.0 / size)
    assert clutch.viscous == pytest.approx(size**2 * 0.5)

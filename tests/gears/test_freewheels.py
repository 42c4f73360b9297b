"""Freewheels lock and overrun by themselves, in the sense that the torque and the speeds demand."""

from __future__ import annotations

import pytest
import sympy as sp
from gear_layouts import Gearing

from ptgen.elements import Constraint
from ptgen.gears import Layout, analyse_gears, gear_ratios, shift_table_problems
from ptgen.report.gears_words import findings


def two_speed(sense: int = 1) -> Layout:
    """A reduction whose ring a freewheel holds against the housing, and a clutch for the direct gear."""
    gearing = Gearing()
    gearing.set("P1", 30, 60, loss=0.01)
    gearing.clutch("A", "K")
    gearing.freewheel("W")
    ends = ("W.output", "W.input") if sense > 0 else ("W.input", "W.output")
    gearing.member("input", "A.input")
    gearing.member("sun", "A.output", "P1.sun", "K.input")
    gearing.member("ring", "P1.ring", ends[0])
    gearing.member("housing", ends[1])
    gearing.member("output", "P1.carrier", "K.output")
    gearing.constraints.append(Constraint("housing", {"housing": sp.Integer(1)}))
    return gearing.layout("two-speed")


TABLE = {"1": ["A"], "2": ["A", "K"]}


def test_freewheel_holds_the_ring_against_the_torque_of_first_gear() -> None:
    """The sun pushes the ring backwards; W has the housing as its input and holds a ring that turns backwards."""
    layout = two_speed()
    assert gear_ratios(layout, TABLE) == {"1": 3.0, "2": 1.0}
    assert shift_table_problems(layout, TABLE) == []
    found = analyse_gears(layout, TABLE)
    first, second = found.gear("1"), found.gear("2")
    assert first is not None and second is not None
    assert first.engaged == ("A", "W") and first.overruns == ("W",)
    assert first.ideal.elements["W"] == pytest.approx(2.0)
    assert first.drive is not None and first.coast is None
    assert second.engaged == ("A", "K") and second.slips["W"].value == -1 and second.coast is not None
    assert "1: W holds in drive and overruns in coast" in list(findings(found))


def test_the_other_way_round_it_neither_holds_nor_lets_go() -> None:
    (problem, *_) = shift_table_problems(two_speed(sense=-1), {"1": ["A"]})
    assert problem.where == "gears.1" and "output turns independently of the input" in problem.what

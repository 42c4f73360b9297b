"""Words, tables and figures of gears, for gear sets of every kind."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest
from rich.console import Console

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "gears"))

from gear_layouts import DUAL_CLUTCH_GEARS, NINE_SPEED_GEARS, Gearing, dual_clutch, nine_speed

from ptgen.gears import GearAnalysis, analyse_gears
from ptgen.report.gears_figure import lever_figure, lever_positions
from ptgen.report.gears_plain import gears_json
from ptgen.report.gears_text import combinations_text, gear_text, gears_text


def printed(parts) -> str:
    console = Console(width=160, record=True, file=io.StringIO())
    for part in parts:
        console.print(part)
    return console.export_text()


@pytest.fixture(scope="module")
def dual() -> GearAnalysis:
    return analyse_gears(dual_clutch(), DUAL_CLUTCH_GEARS)


def test_losses_add_columns_of_efficiency() -> None:
    lossy = printed(gears_text(analyse_gears(nine_speed(loss=0.01), NINE_SPEED_GEARS)))
    assert "drive" in lossy and "98.64 %" in lossy
    assert "drive" not in printed(gears_text(analyse_gears(nine_speed(), NINE_SPEED_GEARS)))


def test_preselection_is_marked_and_named(dual: GearAnalysis) -> None:
    assert "K1>K2*" in printed(gears_text(dual))
    gear = dual.gear("1")
    assert gear is not None
    text = printed(gear_text(dual, gear))
    assert "to 2: close S2, then release K1 and apply K2, then open S1" in text
    assert "free" in text


def test_layout_without_a_shift_table_and_without_elements() -> None:
    gearing = Gearing()
    gearing.pair("G1", 20, 50)
    gearing.member("input", "G1.input")
    gearing.member("output", "G1.output")
    found = analyse_gears(gearing.layout("one pair"))
    text = printed(gears_text(found))
    assert "one pair: 0 shift elements" in text and "-2.500" in text
    assert gears_json(found)["gears"][0]["formula"] == "-i1"
    assert lever_figure(found).axes


def test_gear_beside_the_table_is_told() -> None:
    table = {name: elements for name, elements in NINE_SPEED_GEARS.items() if name != "5"}
    text = printed(gears_text(analyse_gears(nine_speed(), table)))
    assert "(B+D+F) gives 1.211, a gear that the shift table does not name" in text


def test_all_combinations_of_a_dual_clutch_transmission(dual: GearAnalysis) -> None:
    text = printed(combinations_text(dual))
    assert "gear 1, S2 idle" in text and "tie-up" in text


def test_double_pinions_have_the_ring_inside_the_lever() -> None:
    gearing = Gearing()
    gearing.set("P1", 30, 90, double=True)
    gearing.member("input", "P1.sun")
    gearing.member("output", "P1.ring")
    (train,) = gearing.layout().trains
    # omega_s - 3 omega_r = -2 omega_c: the ring turns at (omega_s + 2 omega_c) / 3.
    assert lever_positions(train) == pytest.approx({"sun": 1.0, "ring": 1 / 3, "carrier": 0.0})


def test_speeds_in_the_diagram_are_those_of_the_members() -> None:
    found = analyse_gears(nine_speed(), NINE_SPEED_GEARS)
    gear = found.gear("7")
    assert gear is not None
    figure = lever_figure(found, gear)
    panel = next(axes for axes in figure.axes if axes.get_title(loc="left").startswith("P3"))
    line = next(line for line in panel.lines if line.get_marker() == "o")
    assert sorted(line.get_xdata()) == pytest.approx(
        sorted(float(gear.speeds[member].value or 0) for member in ("b", "output", "r3"))
    )
    ratio = 84 / 36
    s, c, r = (line.get_xdata()[list(line.get_ydata()).index(y)] for y in (1.0, 1 / (1 + ratio), 0.0))
    assert s + ratio * r == pytest.approx((1 + ratio) * c)

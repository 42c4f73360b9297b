"""Gears of a gear set as text for the terminal: shift table, torques, changes; one gear; all combinations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from ptgen.gears.analysis import GearAnalysis
from ptgen.gears.changes import Change
from ptgen.gears.gear import Gear
from ptgen.gears.statics import Balance
from ptgen.report.gears_words import (
    change_text,
    combination_text,
    findings,
    number_text,
    plural,
    ratio_text,
    summary,
    train_text,
    way_text,
)
from ptgen.report.quantities import percent

__all__ = ["combinations_text", "gear_text", "gears_text"]


def gears_text(found: GearAnalysis) -> Iterator[RenderableType]:
    """Yield the shift table with formulas, the torques of the elements, and the changes between gears."""
    yield Text(f"{found.layout.title}: {summary(found)}")
    yield from _ratios(found)
    yield _shift_table(found)
    if found.spread is not None:
        yield Text(f"spread {found.spread:.3f}")
    for sentence in findings(found):
        yield Text(sentence)
    if found.layout.elements:
        yield _heading("Torques per unit of input torque, without losses")
        yield _torques(found)
    if len(found.listed) > 1:
        yield _heading("Changes: released > applied")
        yield _changes(found)
        yield Text("·  needs more than one element released and one applied")
        if any(change.is_single and (change.before or change.after) for change in found.changes):
            yield Text("*  idle elements open or close before or after it, without load; --gear names them")


def combinations_text(found: GearAnalysis) -> Iterator[RenderableType]:
    """Yield every combination of shift elements, and what it does."""
    yield Text(f"{found.layout.title}: {summary(found)}")
    table = Table(
        *found.layout.element_names, "degrees of freedom", "ratio", "what it is", "redundant", box=box.SIMPLE_HEAD
    )
    makes = {engaged: gear for gear in found.gears for engaged in gear.alternatives}
    for one in found.combinations:
        marks = ["X" if name in one.engaged else "" for name in found.layout.element_names]
        ratio = "" if one.ratio is None else number_text(one.ratio)
        what = combination_text(one, makes.get(one.engaged))
        table.add_row(*marks, str(one.degrees_of_freedom), ratio, what, ", ".join(one.redundant))
    yield table


def gear_text(found: GearAnalysis, gear: Gear) -> Iterator[RenderableType]:
    """Yield everything about one gear."""
    yield Text(f"{found.layout.title}, gear {gear.name}: {' '.join(gear.engaged)} engaged")
    formula = f" = {ratio_text(gear.formula)}" if gear.formula is not None else ""
    freedom = f"{plural(gear.degrees_of_freedom, 'degree')} of freedom"
    yield Text(f"  ratio{formula} = {float(gear.ratio):.6g}, {freedom}")
    yield from _ratios(found)
    for sentence in findings(found):
        if sentence.startswith(f"{gear.name}: "):
            yield Text(f"  {sentence.removeprefix(f'{gear.name}: ')}")
    yield _heading("Speeds per unit of input speed")
    yield _speeds(found, gear)
    if gear.slips:
        yield _heading("Relative speeds of open elements")
        yield _slips(gear)
    yield _heading("Torques per unit of input torque")
    yield _element_torques(found, gear)
    yield _heading("Gears in mesh: torque and power that each flange takes in, without losses")
    yield _trains(found, gear.ideal)
    if gear.ideal.recirculating:
        yield Text(
            f"{percent(gear.ideal.recirculating)} of the input power circulates through {', '.join(gear.ideal.circle)}"
        )
    if found.has_losses:
        yield Text(f"efficiency {_efficiency(gear.drive)} in drive, {_coast(gear)} in coast")
    singles = [change for change in found.changes if change.start == gear.name and change.is_single]
    if singles:
        yield _heading("Single changes from here")
        yield from (Text(f"  {way_text(change)}") for change in singles)


def _heading(text: str) -> Text:
    return Text(f"\n{text}", style="bold")


def _ratios(found: GearAnalysis) -> Iterator[RenderableType]:
    yield from (Text(f"  {train_text(train)}") for train in found.layout.trains if train.symbol is not None)


def _shift_table(found: GearAnalysis) -> Table:
    names = found.layout.element_names
    losses = ("drive", "coast") if found.has_losses else ()
    table = Table("gear", *names, "ratio", "", "step", *losses, box=box.SIMPLE_HEAD)
    for column in table.columns[len(names) + 2 :]:
        column.justify = "right"
    rows = list(found.gears)
    first = next((k for k, gear in enumerate(rows) if gear in found.forward), len(rows))
    steps = found.steps
    for position, gear in enumerate([*rows, None]):
        if position == first and found.neutral is not None:
            marks = ["X" if name in found.neutral else "" for name in names]
            table.add_row("N", *marks, "output free", "", "", *("" for _ in losses))
        if gear is None:
            continue
        marks = ["(X)" if name in gear.idle else "X" if name in gear.engaged else "" for name in names]
        step = f"{steps[gear.name]:.3f}" if gear.name in steps else ""
        shown = [_efficiency(gear.drive), _coast(gear)] if losses else []
        formula = ratio_text(gear.formula) or "(these ratios only)"
        table.add_row(gear.name, *marks, formula, number_text(gear.ratio), step, *shown)
    return table


def _efficiency(one: Balance | None) -> str:
    return "locks itself" if one is None else f"{100 * one.efficiency:.2f} %"


def _coast(gear: Gear) -> str:
    return "overruns" if gear.overruns else _efficiency(gear.coast)


def _torques(found: GearAnalysis) -> Table:
    circulates = any(gear.ideal.recirculating for gear in found.listed)
    last = ("circulating power",) if circulates else ()
    table = Table("gear", *found.layout.element_names, "output", *last, box=box.SIMPLE_HEAD)
    for column in table.columns[1:]:
        column.justify = "right"
    for gear in found.listed:
        torques = [
            number_text(gear.ideal.elements[name]) if name in gear.ideal.elements else ""
            for name in found.layout.element_names
        ]
        shown = [percent(gear.ideal.recirculating) if gear.ideal.recirculating else ""] if circulates else []
        table.add_row(gear.name, *torques, number_text(gear.ideal.output_torque), *shown)
    return table


def _changes(found: GearAnalysis) -> Table:
    gears = found.listed
    table = Table("from, to", *(gear.name for gear in gears), box=box.SIMPLE_HEAD)
    ways: Mapping[tuple[str, str], Change] = {(change.start, change.end): change for change in found.changes}
    for start in gears:
        cells = [change_text(ways[start.name, end.name]) if (start.name, end.name) in ways else "" for end in gears]
        table.add_row(start.name, *cells)
    return table


def _speeds(found: GearAnalysis, gear: Gear) -> Table:
    table = Table("member", "speed", "formula", "flanges", box=box.SIMPLE_HEAD)
    table.columns[1].justify = "right"
    for member, speed in gear.speeds.items():
        flanges = ", ".join(found.layout.flanges[member])
        table.add_row(member, number_text(speed.value, 4), ratio_text(speed.formula), flanges)
    return table


def _slips(gear: Gear) -> Table:
    table = Table("element", "relative speed", "formula", box=box.SIMPLE_HEAD)
    table.columns[1].justify = "right"
    for name, speed in gear.slips.items():
        table.add_row(name, number_text(speed.value, 4), ratio_text(speed.formula))
    return table


def _element_torques(found: GearAnalysis, gear: Gear) -> Table:
    sides = [("without losses", gear.ideal)]
    if found.has_losses:
        sides += [(name, one) for name, one in (("drive", gear.drive), ("coast", gear.coast)) if one is not None]
    table = Table("", *(name for name, _ in sides), box=box.SIMPLE_HEAD)
    for column in table.columns[1:]:
        column.justify = "right"
    for name in gear.engaged:
        table.add_row(name, *(number_text(one.elements[name], 4) for _, one in sides))
    table.add_row("output", *(number_text(one.output_torque, 4) for _, one in sides))
    return table


def _trains(found: GearAnalysis, one: Balance) -> Table:
    table = Table("", "flange", "member", "torque", "power", "rolling power", box=box.SIMPLE_HEAD)
    for column in table.columns[3:]:
        column.justify = "right"
    for train in found.layout.trains:
        load = one.trains[train.name]
        if train.symbol is None and not any(load.torques.values()):
            continue  # the velocity of planets, which nothing else acts on
        for position, (flange, member) in enumerate(train.members.items()):
            name, rolling = (train.name, number_text(load.rolling_power, 4)) if position == 0 else ("", "")
            torque, power = number_text(load.torques[flange], 4), number_text(load.powers[flange], 4)
            shown = flange if len(train.members) > 1 else "held"
            table.add_row(name, shown, member, torque, power, rolling)
    return table

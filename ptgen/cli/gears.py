"""The command that finds the gears of a gear set from its layout: gears."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ptgen.cli.options import AsJson
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts
from ptgen.errors import Problem, RunError, nearest

if TYPE_CHECKING:
    from ptgen.components.part import Part

__all__ = ["gears"]


@reported
def gears(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE",
            help="A part file, or a test bed file that has parts (.toml); parts that come with ptgen by their name.",
            show_default=False,
        ),
    ],
    component: Annotated[
        str | None, typer.Option("--component", metavar="NAME", help="Which part of a bed, if it has several.")
    ] = None,
    gear: Annotated[
        str | None, typer.Option("--gear", metavar="GEAR", help="Show everything about one gear, or draw it alone.")
    ] = None,
    every: Annotated[
        bool, typer.Option("--all", help="Show every combination of shift elements, tie-ups and neutrals too.")
    ] = False,
    simplify: Annotated[
        str | None,
        typer.Option(
            "--simplify",
            metavar="GEAR[,GEAR]",
            help="Print simplified gearboxes (models I and II) of one or two gears.",
        ),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FIGURE", help="Draw the lever diagram (.svg, .png or .pdf).")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Find gears, neutrals and tie-ups of a gear set; ratios as formulas, speeds, torques, losses, changes."""
    from ptgen.gears import analyse_gears, layout_of_part, simplified_gearbox
    from ptgen.report.figures import check_figure, save_figure

    if plot is not None:
        check_figure(plot, "--plot")
    part = _part(file, component, checked=not every)
    found = analyse_gears(layout_of_part(part), part.description.gears)
    chosen = None if gear is None else found.gear(gear)
    if gear is not None and chosen is None:
        what = f'"{gear}" is no gear of {found.layout.title}'
        raise RunError(Problem("--gear", what, nearest(gear, [own.name for own in found.gears])), str(file))
    if plot is not None:
        from ptgen.report.gears_figure import lever_figure

        save_figure(lever_figure(found, chosen), plot)
    if simplify is not None:
        for option, given in (("--gear", gear), ("--all", every), ("--plot", plot)):
            if given:
                what = f"{option} and --simplify show different things"
                raise RunError(Problem(option, what, "leave one of them out"), str(file))
        box = simplified_gearbox(found, [name.strip() for name in simplify.split(",")])
        if as_json:
            from ptgen.report.gears_simplified import simplified_json

            print_json(simplified_json(box))
        else:
            from ptgen.report.gears_simplified import simplified_text

            print_parts(simplified_text(box, component or "gears"))
        return
    if as_json:
        from ptgen.report.gears_plain import gear_json, gears_json

        print_json(gears_json(found) if chosen is None else gear_json(chosen))
        return
    from ptgen.report.gears_text import combinations_text, gear_text, gears_text

    if chosen is not None:
        print_parts(gear_text(found, chosen))
    elif not every:
        print_parts(gears_text(found))
    if every:
        print_parts(combinations_text(found))


def _part(file: Path, component: str | None, *, checked: bool) -> Part:
    """Return the part that a part file describes, or the one that is meant of a bed."""
    from ptgen.components.part import Part
    from ptgen.testbed import load
    from ptgen.testbed.parts import find_part, read_part
    from ptgen.testbed.text import read_toml

    file = find_part(str(file), Path()) or file
    if "part" in read_toml(file, "part file").tables:
        if component is not None:
            raise RunError(Problem("--component", "is for beds, and this is a part file", "leave it out"), str(file))
        return read_part(file, shift_table=checked)(type="part", file=str(file))
    parts = {name: own for name, own in load(file).components.items() if isinstance(own, Part)}
    return parts[_meant(parts, component, file)]


def _meant(parts: Mapping[str, Part], component: str | None, file: Path) -> str:
    if not parts:
        what = "neither describes a part nor has one"
        raise RunError(Problem("", what, "name a part file, or a bed with a component of type part"), str(file))
    if component is None:
        if len(parts) > 1:
            what = f"the bed has several parts: {', '.join(parts)}"
            raise RunError(Problem("--component", what, "name the one that is meant"), str(file))
        return next(iter(parts))
    if component not in parts:
        what = f'"{component}" is no part of this bed'
        raise RunError(Problem("--component", what, nearest(component, parts)), str(file))
    return component

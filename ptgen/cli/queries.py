"""Commands that answer questions about a bed: check, show, derive, modal, schema."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ptgen.cli.frictions import dependence_text, dependent_among, kinds
from ptgen.cli.options import AsJson, BedFile
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts
from ptgen.errors import ModelError, Problem, RunError, nearest

if TYPE_CHECKING:
    from ptgen.components.part import PartDescription
    from ptgen.mechanism.model import Model

__all__ = ["check", "derive", "modal", "schema", "show"]


@reported
def check(file: BedFile, as_json: AsJson = False) -> None:
    """Check a test bed file, and that a model and a controller can be made of it; or a part file."""
    from ptgen.project import Project
    from ptgen.report.plain import bed_json
    from ptgen.testbed.parts import is_part, read_part

    if is_part(file):
        _check_part(read_part(file).description, as_json)
        return
    project = Project.read(file)
    project.blocks()  # every stage that could find a problem
    found = bed_json(project)
    frictions = {friction.name: kinds(friction) for friction in project.model.frictions}
    dependent = dependent_among(project.model, frictions)
    if as_json:
        elements = [{"name": name, "kinds": words} for name, words in frictions.items()]
        print_json({**found, "friction_elements": elements, "dependent": dependent})
        return
    torque = ", ".join(f"{machine} the torque at {place}" for machine, place in found["torque"].items())
    speed = ", ".join(found["speed"])
    roles = "; ".join(part for part in (torque, f"{speed} speed" if speed else "") if part)
    print_parts(
        [
            f"{file}: sound",
            f"  {found['title']}: {found['components']} components, {len(found['machines'])} machines",
            f"  model of order {found['order']}, {found['reduced_order']} after reduction",
            f"  controlled: {roles}",
            *(["  friction elements:"] if frictions else []),
            *(f"    {name}: {', '.join(words)}" for name, words in frictions.items()),
            *(f"  {dependence_text(names)}" for names in dependent),
        ]
    )


def _check_part(part: PartDescription, as_json: bool) -> None:
    if as_json:
        print_json({"title": part.title, "flanges": list(part.exposed), "components": len(part.components)})
        return
    lines = [
        f"{part.file}: sound",
        f"  {part.title}: a part of {len(part.components)} components and {len(part.members)} members",
        f"  flanges: {', '.join(part.exposed)}",
        *([f"  gears: {', '.join(part.gears)}; see ptgen gears"] if part.gears else []),
    ]
    print_parts(lines)


@reported
def show(
    file: BedFile,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FIGURE", help="Draw the bed to this file (.svg, .png or .pdf)."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Show the components of a bed, their values and what is assumed; draw the bed."""
    from ptgen.report.figures import check_figure, save_figure
    from ptgen.testbed import load

    if output is not None:
        check_figure(output, "--output")
    bed = load(file)
    if output is not None:
        from ptgen.report.bed_drawing import bed_figure

        save_figure(bed_figure(bed), output)
    if as_json:
        from ptgen.report.bed_tree import bed_values

        print_json(bed_values(bed))
    else:
        from ptgen.report.bed_tree import bed_tree

        print_parts([bed_tree(bed)])


@reported
def derive(
    file: BedFile,
    as_json: AsJson = False,
    latex: Annotated[bool, typer.Option("--latex", help="Print a fragment of a LaTeX document.")] = False,
) -> None:
    """Derive the model, its reduction and the decoupling law."""
    from ptgen.project import Project
    from ptgen.report.derivation import derivation

    if as_json and latex:
        raise RunError(Problem("--latex", "cannot be combined with --json", "leave out one of them"))
    found = derivation(Project.read(file))
    if as_json:
        from ptgen.report.plain import derivation_json

        print_json(derivation_json(found))
    elif latex:
        from ptgen.report.derivation_latex import derivation_latex

        sys.stdout.write(derivation_latex(found))
    else:
        from ptgen.report.derivation_text import derivation_text

        print_parts(derivation_text(found))


@reported
def modal(
    file: BedFile,
    lock: Annotated[
        list[str] | None, typer.Option("--lock", metavar="ELEMENT", help="A friction element that sticks; repeatable.")
    ] = None,
    free: Annotated[
        list[str] | None,
        typer.Option("--free", metavar="ELEMENT", help="A friction element that is free, the default."),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FIGURE", help="Draw the mode shapes (.svg, .png or .pdf).")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Compute the modes of the full model, with friction elements locked or free."""
    from ptgen.mechanism.modes import modes
    from ptgen.project import Project
    from ptgen.report.figures import check_figure, save_figure

    if plot is not None:
        check_figure(plot, "--plot")
    project = Project.read(file)
    locked, released = _elements(project.model, lock or (), free or (), project.testbed.file)
    found = modes(project.model, locked)
    dependent = dependent_among(project.model, locked)
    if plot is not None:
        from ptgen.report.modes_figure import modes_figure

        save_figure(modes_figure(found, project.testbed, locked), plot)
    if as_json:
        from ptgen.report.plain import modes_json

        print_json({"name": project.testbed.name, **modes_json(found, locked, released), "dependent": dependent})
    else:
        from ptgen.report.modes_text import modes_text

        print_parts([*modes_text(found, locked, released), *map(dependence_text, dependent)])


@reported
def schema(
    part: Annotated[bool, typer.Option("--part", help="The schema of part files instead.")] = False,
    scenario: Annotated[bool, typer.Option("--scenario", help="The schema of scenario files instead.")] = False,
    as_json: AsJson = True,
) -> None:
    """Print the JSON Schema of test bed files, or of part or scenario files, for editors."""
    from ptgen.testbed import json_schema

    del as_json  # it is JSON in any case; the option is there because every query has it
    sys.stdout.write(json.dumps(json_schema("scenario" if scenario else "part" if part else "bed"), indent=2) + "\n")


def _elements(model: Model, lock: Sequence[str], free: Sequence[str], file: str) -> tuple[list[str], list[str]]:
    """Return the locked and the free friction elements, in the order of the model."""
    names = [friction.name for friction in model.frictions]
    hint = f"known are: {', '.join(names)}" if names else "it has none"
    problems = [
        Problem(
            option,
            f'"{name}" is no friction element of this bed',
            f"{nearest(name, names)} ({hint})" if names else hint,
        )
        for option, wanted in (("--lock", lock), ("--free", free))
        for name in wanted
        if name not in names
    ]
    problems += [
        Problem("--lock", f'"{name}" is to be locked and free', "leave out one of the options")
        for name in dict.fromkeys(lock)
        if name in free
    ]
    if problems:
        raise ModelError(problems, file)
    return [name for name in names if name in lock], [name for name in names if name not in lock]

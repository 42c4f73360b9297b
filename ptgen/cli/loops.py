"""The command that proves the sampled closed loop: analyse."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ptgen.cli.options import AsJson, BedFile, ControllerKind
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts
from ptgen.errors import Problem, PtgenError, RunError

__all__ = ["analyse"]


@reported
def analyse(
    file: BedFile,
    lock: Annotated[
        list[str] | None, typer.Option("--lock", metavar="ELEMENT", help="A friction element that sticks; repeatable.")
    ] = None,
    free: Annotated[
        list[str] | None,
        typer.Option(
            "--free", metavar="ELEMENT", help="A friction element that slips, though the file takes it for locked."
        ),
    ] = None,
    controller: Annotated[
        ControllerKind, typer.Option("--controller", help="The controller that the bed runs with.")
    ] = ControllerKind.decoupling,
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set", metavar="NAME=VALUE", help="A parameter of plant or controller, in SI units; repeatable."
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option("--plot", metavar="FIGURE", help="Draw loops, poles and step responses (.svg, .png or .pdf)."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Prove that the sampled closed loop is stable: margins, what limits them, couplings and their causes."""
    from ptgen.loops.loop_analysis import analyse as run
    from ptgen.project import Project
    from ptgen.report.figures import check_figure, save_figure

    if plot is not None:
        check_figure(plot, "--plot")
    project = Project.read(file)
    parameters, problems = _settings(settings or ())
    found = None
    try:
        found = run(project, locked=lock or (), free=free or (), controller=controller.value, parameters=parameters)
    except PtgenError as error:
        if not problems:
            raise
        problems += error.problems
    if problems or found is None:
        raise RunError(problems, project.testbed.file)
    if plot is not None:
        from ptgen.report.loop_figure import loop_figure

        save_figure(loop_figure(found), plot)
    if as_json:
        from ptgen.report.loop_plain import loop_json

        print_json(loop_json(found))
    else:
        from ptgen.report.loop_text import loop_text

        print_parts(loop_text(found))


def _settings(texts: list[str] | tuple[()]) -> tuple[dict[str, float], list[Problem]]:
    """Return parameters by name, and what is wrong with the texts."""
    parameters: dict[str, float] = {}
    problems = []
    for text in texts:
        name, sign, value = text.partition("=")
        try:
            parameters[name.strip()] = float(value)
        except ValueError:
            what = f'"{text}" is not NAME=VALUE with a number' if sign else f'"{text}" has no "="'
            problems.append(Problem("--set", what, "write for example M1_damping=150, in SI units"))
    return parameters, problems

"""The command that runs scenarios: simulate."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich import box
from rich.table import Table
from rich.text import Text

from ptgen.cli.options import AsJson, BedFile, ControllerKind, MethodKind
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts, progress
from ptgen.errors import Problem, RunError

if TYPE_CHECKING:
    from ptgen.simulate.recording import Recording

__all__ = ["parsed_parameters", "simulate"]


@reported
def simulate(
    file: BedFile,
    scenario: Annotated[
        Path,
        typer.Option("--scenario", "-s", metavar="SCENARIO", help="The scenario file (.toml).", show_default=False),
    ],
    controller: Annotated[
        ControllerKind, typer.Option("--controller", help="The controller that the bed runs with.")
    ] = ControllerKind.decoupling,
    method: Annotated[
        MethodKind,
        typer.Option(
            "--method",
            help="The plant as emitted, or simulated from event to event with tight tolerances, to compare with; slow.",
        ),
    ] = MethodKind.emitted,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="CSV", help="Write the recording to this file (.csv).")
    ] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FIGURE", help="Draw the recording (.svg, .png or .pdf).")
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="A parameter of controller or plant that differs from its default, in SI units; may be repeated.",
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Compile controller and plant of a bed and run a scenario with them."""
    from ptgen.project import Project
    from ptgen.report.destinations import check_destination
    from ptgen.report.figures import check_figure, save_figure
    from ptgen.simulate.build import build
    from ptgen.simulate.run import simulate as run
    from ptgen.testbed import load_scenario

    if output is not None:
        check_destination(output, (".csv",), "--output")
    if plot is not None:
        check_figure(plot, "--plot")
    parameters = parsed_parameters(settings or [])
    project = Project.read(file)
    course = load_scenario(scenario, project.testbed)
    with progress(course.title or course.name) as (show, advance):
        show("compile")
        library = build(project)
        show("run")
        recording = run(
            project,
            course,
            controller=controller.value,
            method=method.value,
            library=library,
            progress=advance,
            parameters=parameters,
        )
    if output is not None:
        recording.write_csv(output)
    if plot is not None:
        from ptgen.report.recording_figure import recording_figure

        title = f"{project.testbed.title} – {course.title or course.name} ({controller.value} controller)"
        save_figure(recording_figure(recording, project, title=title), plot)
    if as_json:
        named = {"name": project.testbed.name, "scenario": course.name}
        print_json({**named, "controller": controller.value, "method": method.value, **recording.summary()})
    else:
        print_parts(_summary(recording))


def parsed_parameters(settings: Sequence[str]) -> dict[str, float]:
    """Return the parameters in settings such as ``"M1_damping=40"``.

    Raises
    ------
    RunError
        With every setting that is no name and number, or that names a parameter twice.
    """
    parameters: dict[str, float] = {}
    problems = []
    for setting in settings:
        name, _, text = (part.strip() for part in setting.partition("="))
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not name or not math.isfinite(value):
            problems.append(
                Problem("--set", f'"{setting}" is no NAME=VALUE', "write a number in SI units, such as M1_damping=40")
            )
        elif name in parameters:
            problems.append(Problem("--set", f'"{name}" is set twice', "set it once"))
        else:
            parameters[name] = value
    if problems:
        raise RunError(problems)
    return parameters


def _summary(recording: Recording) -> list[Table | str]:
    from ptgen.report.quantities import readable
    from ptgen.report.shifts_text import shift_lines

    document = recording.summary()
    table = Table("signal", "min", "max", "rms", "final", box=box.SIMPLE_HEAD, pad_edge=False)
    for column in table.columns[1:]:
        column.justify = "right"
    for name, numbers in document["signals"].items():
        unit = recording.units.get(name, "")
        table.add_row(Text(name), *(readable(numbers[key], unit, 4) for key in ("min", "max", "rms", "final")))
    speed = f"{recording.steps} steps in {recording.wall_s:.3g} s, {recording.realtime_factor:.4g} times real time"
    return [speed, *shift_lines(recording.shifts), table]

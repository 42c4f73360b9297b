"""The command for reference governors: govern."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from ptgen.cli.options import AsJson, BedFile
from ptgen.cli.outcome import reported
from ptgen.cli.output import print_json, print_parts, progress
from ptgen.errors import Problem, RunError

if TYPE_CHECKING:
    from ptgen.loops.governed_run import GovernedRun
    from ptgen.testbed.governor_settings import GovernorSettings
    from ptgen.testbed.testbed import Testbed

__all__ = ["GovernorChoice", "govern"]


class GovernorChoice(StrEnum):
    """The reference governors that there are."""

    none = "none"
    sequential = "sequential"
    sequential_modified = "sequential_modified"
    optimal = "optimal"


@reported
def govern(
    file: BedFile,
    scenario: Annotated[
        Path | None,
        typer.Option("--scenario", "-s", metavar="SCENARIO", help="Run this scenario (.toml) with the governor."),
    ] = None,
    governor: Annotated[
        GovernorChoice | None,
        typer.Option(
            "--governor",
            help="The governor, in the place of the one in the bed file; the best possible one if it has none.",
        ),
    ] = None,
    horizon: Annotated[
        str | None,
        typer.Option(
            "--horizon", metavar="TIME", help='Of the optimal governor: "0", "auto", or a time such as "0.5 s".'
        ),
    ] = None,
    compare: Annotated[
        bool, typer.Option("--compare", help="Run all governors: none, sequential, optimal with several settings.")
    ] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="Refuse a scenario that asks a machine for more than it has at rest.")
    ] = False,
    solver: Annotated[
        str | None,
        typer.Option(
            "--solver", metavar="NAME", help="Check the emitted solver and the rows left out with this one (highs)."
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot", metavar="PATH", help="Draw the runs: one figure (.svg, .png or .pdf), or all into a folder."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Compute what a reference governor needs, show it, and compare governors on a scenario."""
    from ptgen.loops.governor_study import choices_of, study_governors
    from ptgen.project import Project
    from ptgen.testbed import load_scenario

    _check_plot(plot, scenario)
    project = Project.read(file)
    settings = _settings(project.testbed, governor, horizon)
    if compare and scenario is None:
        raise RunError(Problem("--compare", "needs a scenario to run", "name one with --scenario"))
    course = load_scenario(scenario, project.testbed) if scenario is not None else None
    with progress(project.testbed.title) as (show, advance):
        study = study_governors(
            project,
            settings,
            course,
            choices_of(settings, compare),
            strict=strict,
            solver=solver,
            show=show,
            progress=advance,
        )
    if plot is not None:
        _draw(study.runs, plot, f"{study.title} – {study.scenario}")
    if as_json:
        from ptgen.report.governor_plain import governor_json

        print_json(governor_json(study))
    else:
        from ptgen.report.governor_text import governor_text

        print_parts(governor_text(study))


def _settings(bed: Testbed, governor: GovernorChoice | None, horizon: str | None) -> GovernorSettings:
    """Return the settings of the bed file with those of the command line in their place.

    A bed without a governor gets the optimal one, or the best one without prediction if a ratio changes at run time.
    """
    given = bed.governor
    changes: dict[str, object] = {}
    if governor is not None:
        changes["kind"] = governor.value
    elif not given.is_chosen:
        changes["kind"] = "sequential_modified" if bed.ratios else "optimal"
    if horizon is not None:
        changes["horizon"] = _horizon(horizon, bed.sample_time)
    settings = given.model_copy(update=changes)
    if horizon is not None and settings.kind != "optimal":
        what = f'is for the optimal governor, and the one chosen is "{settings.kind}"'
        raise RunError(Problem("--horizon", what, "add --governor optimal, or leave it out"))
    return settings


def _horizon(text: str, sample_time: float) -> float | None:
    """Return a horizon (s); None is to be found."""
    from ptgen.units import QuantityError, parse

    if text.strip() == "auto":
        return None
    if text.strip() == "0":
        return 0.0
    try:
        value = parse(text, "s")
    except QuantityError as error:
        raise RunError(Problem("--horizon", str(error), 'write "0", "auto" or e.g. "0.5 s"')) from None
    if value == 0:
        return 0.0
    if not sample_time <= value < 1e4:
        what = f"must be at least one step, {sample_time:g} s, or 0, got {value:g} s"
        raise RunError(Problem("--horizon", what, 'write "0" for no prediction, or e.g. "0.5 s"'))
    return value


def _check_plot(plot: Path | None, scenario: Path | None) -> None:
    from ptgen.report.figures import check_figure

    if plot is None:
        return
    if scenario is None:
        raise RunError(Problem("--plot", "draws runs, and there is no scenario", "name one with --scenario"))
    if plot.suffix:
        check_figure(plot, "--plot")
    elif plot.exists() and not plot.is_dir():
        raise RunError(Problem("--plot", "is a file without an ending", "name a folder, or e.g. runs.svg"), str(plot))


def _draw(runs: Sequence[GovernedRun], plot: Path, title: str) -> None:
    from ptgen.report import governor_figure
    from ptgen.report.figures import save_figure

    plant = [run for run in runs if run.bed == "plant"]
    if plot.suffix:
        save_figure(governor_figure.overview_figure(plant, title), plot)
        return
    try:
        plot.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RunError(
            Problem("--plot", f"the folder cannot be made ({error})", "choose another one"), str(plot)
        ) from None
    for bed, chosen in (("nominal", [run for run in runs if run.bed == "nominal"]), ("plant", plant)):
        for name, draw in (
            ("references", governor_figure.references_figure),
            ("torques", governor_figure.torques_figure),
            ("controlled", governor_figure.controlled_figure),
        ):
            where = "nominal loop" if bed == "nominal" else "whole bed"
            save_figure(draw(chosen, f"{title} ({where})"), plot / f"{bed}-{name}.svg")

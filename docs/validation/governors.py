"""Reference governors beside Figures 7.5 to 7.14 of the source."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from ptgen.loops.governed_run import Choice, GovernedRun
from ptgen.loops.governor_study import study_governors
from ptgen.report.governor_figure import overview_figure
from ptgen.testbed import load_scenario
from validation.case import ROOT, Case, Number, bed

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_CHOICES = (
    Choice("sequential"),
    Choice("sequential_modified"),
    Choice("optimal", 0.0, 1.0, 100.0),
    Choice("optimal", None, 1.0, 1.0),
    Choice("optimal", None, 1.0, 100.0),
)


@cache
def _runs(name: str) -> dict[str, GovernedRun]:
    """Return the runs of a scenario on the whole bed by what their governor is called."""
    project = bed("differential-governed")
    scenario = load_scenario(ROOT / "scenarios" / f"{name}.toml", project.testbed)
    study = study_governors(project, project.testbed.governor, scenario, _CHOICES)
    return {run.choice.label: run for run in study.runs if run.bed == "plant"}


def _beyond(run: GovernedRun, machine: str = "M1") -> float:
    return next(entry.most for entry in run.beyond_limit if entry.machine == machine)


def _through(run: GovernedRun, signal: str, at: float) -> float:
    """Return how long the change of a reference near a time takes to pass the governor (s)."""
    point = next(p for p in run.set_points if p.signal == signal and abs(p.at - at) < 0.06)
    return float("nan") if point.shaped_after is None else point.shaped_after


def _figure_7_5() -> tuple[list[Number], Figure]:
    runs = _runs("differential-governed-steps")
    torque, speed = "diff_input_torque_ref", "M2_speed_ref"
    numbers = [
        Number("M1 beyond its limit, sequential", _beyond(runs["sequential"]), "N m", "a violation near 3 s"),
        Number("M1 beyond its limit, (7.43)", _beyond(runs["sequential modified"]), "N m", "avoided"),
        Number(
            "M1 beyond its limit, optimal, horizon 0", _beyond(runs["optimal, 1 : 100, horizon 0"]), "N m", "slight"
        ),
        Number("M1 beyond its limit, optimal", _beyond(runs["optimal, 1 : 100"]), "N m", "maintained"),
    ]
    for label in ("optimal, 1 : 1", "optimal, 1 : 100", "sequential"):
        source = {"optimal, 1 : 1": "torque first", "optimal, 1 : 100": "speeds first"}.get(
            label, "torque goes on, too"
        )
        numbers.append(Number(f"torque of 0.7 s through, {label}", _through(runs[label], torque, 0.7), "s", source))
        numbers.append(Number(f"speeds of 0.65 s through, {label}", _through(runs[label], speed, 0.65), "s", source))
    return numbers, overview_figure(list(runs.values()), "Steps at the limits, whole bed", points=1200)


def _figure_7_13() -> tuple[list[Number], Figure]:
    runs = _runs("differential-governed-field-weakening")
    optimal = runs["optimal, 1 : 100"]
    shaped = optimal.recording.signals["diff_input_torque_ref_shaped"]
    time = optimal.recording.time
    most = float(shaped[(time > 0.3) & (time < 0.5)].max())
    numbers = [
        Number("torque that is let through of 1000 N m", most, "N m", "865.8, by (7.34)"),
        Number("M1 beyond its limit, sequential", _beyond(runs["sequential"]), "N m", "insignificant"),
        Number("M1 beyond its limit, (7.43)", _beyond(runs["sequential modified"]), "N m", "reduced"),
        Number("M1 beyond its limit, optimal", _beyond(optimal), "N m", "reduced"),
    ]
    return numbers, overview_figure(list(runs.values()), "Field weakening, whole bed", points=1200)


CASES = (
    Case(
        "figure-7-5",
        "Figures 7.5, 7.6, 7.7, 7.11 and 7.12: reference governors",
        "Steps that ask for more torque than there is: the horizon hardly changes the references; without prediction "
        "the limit of M1 is exceeded for a moment near 3 s, with (7.43) it is not; with the larger weight the speeds "
        "are adjusted first; sequential and optimal governor differ where torque and speeds change at once.",
        "Agrees. The references of the source are known from pictures only, and drawn anew so that its text holds "
        "([scenario](../scenarios/differential-governed-steps.toml)).",
        _figure_7_5,
    ),
    Case(
        "figure-7-13",
        "Figures 7.13 and 7.14: reference governors with stationary limits and field weakening",
        "1000 N m are asked for and cut down; above the rated speed of the loads acceleration decreases; speeds wait "
        "while M1 is busy with the torque; some insignificant violations of the limits of M1.",
        "Agrees but for the size of the violations without prediction: the testing torque of ptgen follows a step as "
        "fast as the shaft allows, and the torque that damps the step comes on top of what the speeds were given.",
        _figure_7_13,
    ),
)

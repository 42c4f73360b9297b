"""The reference governors of a bed: their sets, their order of steps, and runs of a scenario that compare them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import ControlError, Problem, RunError
from ptgen.governor.constraint_set import ConstraintSet, torque_limits
from ptgen.governor.prediction import Prediction
from ptgen.governor.set_cache import cached_constraint_set
from ptgen.governor.shaping import KINDS, governor_signals
from ptgen.governor.step_order import step_order
from ptgen.loops.governed_run import Choice, Followed, GovernedRun, excess, set_points, solver_work
from ptgen.loops.governor_check import SolverCheck, check_solver
from ptgen.loops.nominal_run import nominal_run
from ptgen.loops.stationary_demand import (
    Beyond,
    StationaryLimits,
    beyond_at_rest,
    machine_references,
    stationary_limits,
)
from ptgen.plant.layout import signal_name
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed.governor_settings import GovernorSettings, check_governor
from ptgen.testbed.scenario import Scenario

__all__ = [
    "GovernorStudy",
    "OrderedStep",
    "ShorterHorizon",
    "choices_of",
    "governed_project",
    "study_governors",
]

Array = NDArray[np.float64]

_ROWS = 100_000
"""Rows of a recording above which not every step is recorded."""

_SHARES = (0.0, 0.04, 0.12, 0.4)
"""Shorter horizons that are looked at, as shares of the one that is enough."""


@dataclass(frozen=True)
class OrderedStep:
    """A step of the sequential governor.

    Attributes
    ----------
    machine, reference : str
        The machine whose limits are looked at, and its reference, which is placed.
    earlier : tuple of str
        References placed before that its torque depends on; they give way for it.
    later : tuple of str
        References that its torque depends on though they come later; they count as unchanged.
    """

    machine: str
    reference: str
    earlier: tuple[str, ...]
    later: tuple[str, ...]


@dataclass(frozen=True)
class ShorterHorizon:
    """What a horizon that is not long enough leaves out.

    Attributes
    ----------
    steps : int
    kept : int
        Rows that are kept of it.
    binding : ndarray (m,)
        Most by which rows behind it can bind, over all states that can occur, as a share of each machine's limit.
    """

    steps: int
    kept: int
    binding: Array


@dataclass(frozen=True)
class GovernorStudy:
    """Everything that was found out about the governors of a bed.

    Attributes
    ----------
    name, title : str
    settings : GovernorSettings
    prediction : Prediction
    stationary : StationaryLimits
    order : tuple of OrderedStep
    constraints : ConstraintSet or None
        Of the optimal governor with the horizon asked for; None if only others are looked at.
    shorter : tuple of ShorterHorizon
        What shorter horizons than the automatic one leave out.
    scenario : str
        Its title; empty without one.
    beyond : tuple of Beyond
        What the scenario asks for that machines do not have at rest.
    check : SolverCheck or None
    runs : tuple of GovernedRun
    """

    name: str
    title: str
    settings: GovernorSettings
    prediction: Prediction
    stationary: StationaryLimits
    order: tuple[OrderedStep, ...]
    constraints: ConstraintSet | None
    shorter: tuple[ShorterHorizon, ...]
    scenario: str
    beyond: tuple[Beyond, ...]
    check: SolverCheck | None
    runs: tuple[GovernedRun, ...]


def choices_of(settings: GovernorSettings, compare: bool) -> tuple[Choice, ...]:
    """Return the governors to run: the one of the settings, or all of them beside it.

    Parameters
    ----------
    settings : GovernorSettings
    compare : bool
        Whether to run no governor, both sequential ones, and the optimal one with equal weights and with the speeds
        first, without prediction and with the horizon of the settings.
    """
    if not compare:
        weights = (settings.torque_weight, settings.speed_weight)
        return (Choice(settings.kind, settings.horizon if settings.kind == "optimal" else None, *weights),)
    simple = (Choice("none"), Choice("sequential"), Choice("sequential_modified"))
    if settings.kind != "optimal":
        return simple
    ahead = (settings.horizon,) if settings.horizon == 0 else (0.0, settings.horizon)
    return simple + tuple(Choice("optimal", horizon, 1.0, weight) for horizon in ahead for weight in (1.0, 100.0))


def governed_project(project: Project, settings: GovernorSettings) -> Project:
    """Return the bed with other settings of its governor.

    Raises
    ------
    ControlError
        If the rest of the bed file does not allow that governor.
    """
    bed = project.testbed
    if settings == bed.governor:
        return project
    names = {machine: bed.tuning.speed_control_of(machine) for machine in bed.roles.speed}
    problems = check_governor(settings.kind, names, bed.components)
    if problems:
        raise ControlError(problems, bed.file)
    return Project(replace(bed, governor=settings))


def study_governors(
    project: Project,
    settings: GovernorSettings,
    scenario: Scenario | None = None,
    choices: Sequence[Choice] = (),
    *,
    strict: bool = False,
    solver: str | None = None,
    show: Callable[[str], None] = lambda _: None,
    progress: Callable[[float], None] = lambda _: None,
) -> GovernorStudy:
    """Compute the sets of a bed's governors, and run them on a scenario.

    Parameters
    ----------
    project : Project
    settings : GovernorSettings
        They stand in the place of those in the bed file.
    scenario : Scenario, optional
    choices : sequence of Choice
        The governors to run; the horizon of each optimal one has a set of its own.
    strict : bool
        Whether to refuse a scenario that asks a machine for more than it has at rest.
    solver : str, optional
        Check the optimal governor against this one of `ptgen.loops.governor_check.SOLVERS`.
    show, progress : callable, optional
        Told what is being done, and which share of it is.

    Raises
    ------
    PtgenError
        From any stage: an unstable loop, a horizon that is too short, a solver that is not there, code that cannot be
        built; with `strict` all that a scenario asks too much.
    """
    bed = governed_project(project, settings)
    prediction = bed.prediction
    limits = stationary_limits(bed, prediction, settings)
    beyond = () if scenario is None else beyond_at_rest(bed, scenario, limits)
    if strict and beyond and scenario is not None:
        raise RunError([entry.problem() for entry in beyond], scenario.file)
    constraints = checked = None
    shorter: tuple[ShorterHorizon, ...] = ()
    if settings.kind == "optimal":
        show(f"constraint set, {_horizon_text(settings.horizon)}")
        constraints = _set_of(bed, settings, progress)
        shorter = () if settings.horizon is not None else _shorter(bed, constraints, settings, show, progress)
        if solver is not None:
            show(f"comparison with {solver}")
            checked = check_solver(constraints, settings, solver, progress)
    elif solver is not None:
        what = f'checks the optimal governor, and the one chosen is "{settings.kind}"'
        raise RunError(Problem("--solver", what, "add --governor optimal, or leave it out"))
    runs: list[GovernedRun] = []
    if scenario is not None and choices:
        every = max(1, -(-round(scenario.duration / bed.testbed.sample_time) // _ROWS))
        fine = replace(scenario, record_every=every * bed.testbed.sample_time)
        highest = max((settings.kind, *(choice.kind for choice in choices)), key=KINDS.index)
        built: dict[float | None, tuple[Project, Library]] = {}
        for choice in choices:
            horizon = choice.horizon if choice.kind == "optimal" else settings.horizon
            if horizon not in built:
                show(f"controller, {_horizon_text(horizon)}")
                one = governed_project(project, settings.model_copy(update={"horizon": horizon, "kind": highest}))
                built[horizon] = one, build(one)
            runs += _runs(*built[horizon], fine, choice, limits, settings, show, progress)
    return GovernorStudy(
        name=project.testbed.name,
        title=project.testbed.title,
        settings=settings,
        prediction=prediction,
        stationary=limits,
        order=_order(prediction),
        constraints=constraints,
        shorter=shorter,
        scenario="" if scenario is None else scenario.title or scenario.name,
        beyond=beyond,
        check=checked,
        runs=tuple(runs),
    )


def _set_of(
    project: Project, settings: GovernorSettings, progress: Callable[[float], None], *, check: bool = True
) -> ConstraintSet:
    limits = torque_limits(project.reduced.full)
    return cached_constraint_set(project.prediction, limits, settings, progress, check=check)


def _shorter(
    project: Project,
    whole: ConstraintSet,
    settings: GovernorSettings,
    show: Callable[[str], None],
    progress: Callable[[float], None],
) -> tuple[ShorterHorizon, ...]:
    found = []
    for steps in sorted({int(share * whole.horizon) for share in _SHARES}):
        show(f"horizon {steps} steps")
        given = settings.model_copy(update={"horizon": steps * project.testbed.sample_time})
        part = _set_of(project, given, progress, check=False)
        behind = part.binding[:, steps + 1 :]
        most = behind.max(axis=1) if behind.shape[1] else np.zeros(len(part.steps))
        found.append(ShorterHorizon(steps, sum(part.counts) + len(part.steps), np.maximum(most, 0.0)))
    return tuple(found)


def _horizon_text(horizon: float | None) -> str:
    return "automatic horizon" if horizon is None else f"horizon {horizon:g} s"


def _order(prediction: Prediction) -> tuple[OrderedStep, ...]:
    acts = prediction.D != 0
    order, done, steps = step_order(acts), set[int](), []
    for machine in order:
        others = [k for k in np.flatnonzero(acts[machine]) if k != machine]
        steps.append(
            OrderedStep(
                prediction.machines[machine],
                prediction.references[machine],
                tuple(prediction.references[k] for k in others if k in done),
                tuple(prediction.references[k] for k in others if k not in done),
            )
        )
        done.add(machine)
    return tuple(steps)


def _runs(
    project: Project,
    library: Library,
    scenario: Scenario,
    choice: Choice,
    limits: StationaryLimits,
    settings: GovernorSettings,
    show: Callable[[str], None],
    progress: Callable[[float], None],
) -> list[GovernedRun]:
    """Run one governor on the nominal loop and on the whole bed."""
    block = project.controller
    wanted = {
        "governor": float(KINDS.index(choice.kind)),
        "governor_torque_weight": choice.torque_weight,
        "governor_speed_weight": choice.speed_weight,
    }
    parameters = {name: value for name, value in wanted.items() if block.signal(name) is not None}
    watched = {signal.name: signal.unit for signal in governor_signals(block)}
    show(f"{choice.label}, nominal loop")
    nominal = nominal_run(project, scenario, library, parameters, watched, progress)
    show(f"{choice.label}, whole bed")
    plant = simulate(project, scenario, library=library, parameters=parameters, progress=progress)
    return [
        _judged(project, scenario, choice, name, recording, limits, settings)
        for name, recording in (("nominal", nominal), ("plant", plant))
    ]


def _judged(
    project: Project,
    scenario: Scenario,
    choice: Choice,
    bed: str,
    recording: Recording,
    limits: StationaryLimits,
    settings: GovernorSettings,
) -> GovernedRun:
    """Return a run with the numbers that it is judged by."""
    signals, time, machines = recording.signals, recording.time, limits.machines
    interval = float(time[1] - time[0]) if len(time) > 1 else recording.sample_time
    wanted = machine_references(project, scenario, time)
    decoupling = project.design.decoupling
    outputs = {machine: f"{machine}_speed" for machine in machines}
    outputs |= {
        decoupling.machines[decoupling.actuators[k]]: signal_name(decoupling.outputs[k])
        for k in range(decoupling.torque_count)
    }
    followed = tuple(
        Followed(machine, limits.references[k], limits.units[k], outputs[machine], wanted[:, k])
        for k, machine in enumerate(machines)
    )
    speeds = np.column_stack([signals[f"{machine}_speed"] for machine in machines])
    envelope = limits.envelope(speeds)
    available = {machine: envelope[:, k] for k, machine in enumerate(machines)}
    demands = {machine: signals[f"governor_demand_{machine}"] for machine in machines}
    share = 1 - settings.reserve
    points = [
        set_points(item, time, signals[item.output], signals.get(item.shaped) if choice.kind != "none" else None)
        for item in followed
    ]
    slack = {name: signals[f"governor_slack_{name}"] for name in machines if f"governor_slack_{name}" in signals}
    kept = {name: signals[name] for item in followed for name in (item.output, item.shaped) if name in signals}
    return GovernedRun(
        choice=choice,
        bed=bed,
        recording=replace(recording, signals=kept),
        followed=followed,
        limits=available,
        demands=demands,
        beyond_limit=tuple(excess(name, time, demands[name], available[name], interval) for name in machines),
        beyond_reserve=tuple(excess(name, time, demands[name], share * available[name], interval) for name in machines),
        set_points=tuple(point for some in points for point in some),
        solver=solver_work(signals.get("governor_status"), signals.get("governor_iterations"), slack, machines),
    )

"""The governors of a bed as text for the terminal: limits, order of steps, constraint set, and what runs were like."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from ptgen.governor.constraint_set import ConstraintSet
from ptgen.loops.governed_run import Excess, GovernedRun, SetPoint
from ptgen.loops.governor_check import SolverCheck
from ptgen.loops.governor_study import GovernorStudy, OrderedStep
from ptgen.loops.listing import listed
from ptgen.loops.stationary_demand import StationaryLimits
from ptgen.report.governor_plain import STATUS_NAMES
from ptgen.report.quantities import percent, readable

__all__ = ["governor_text"]

_BEDS = {
    "nominal": "Runs on the nominal loop, which the governor predicts with",
    "plant": "Runs on the whole bed, in emitted C",
}


def governor_text(study: GovernorStudy) -> Iterator[RenderableType]:
    """Yield all of a study."""
    settings = study.settings
    kind = settings.kind.replace("_", " ")
    period = readable(study.prediction.sample_time, "s")
    yield Text(f"{study.title}: reference governor {kind}, sampled every {period}")
    yield Text(
        f"  kept free: {percent(settings.reserve)} of every torque, at rest and of speeds another "
        f"{percent(settings.stationary_reserve)}"
    )
    yield _heading("Limits")
    yield _limits(study.stationary)
    yield from (Text(f"  {sentence}") for sentence in _stationary(study.stationary))
    yield _heading("Order of the sequential governor")
    for number, step in enumerate(study.order, start=1):
        yield Text(f"  {number}. {_step(step)}")
    if study.constraints is not None:
        yield _heading("Constraint set of the optimal governor")
        yield from (Text(f"  {sentence}") for sentence in _set(study.constraints, settings.horizon is None))
        yield _rows(study.constraints)
        if study.shorter:
            yield Text("  With a shorter horizon, rows behind it could still bind by this share of a limit:")
            yield _shorter(study, study.constraints)
    if study.check is not None:
        yield Text(f"\n{_check(study.check)}")
    if study.beyond:
        yield _heading(f"More than the machines have at rest: {study.scenario}")
        yield from (Text(f"  {beyond.problem().what}") for beyond in study.beyond)
    for bed, title in _BEDS.items():
        runs = [run for run in study.runs if run.bed == bed]
        if runs:
            yield _heading(f"{title}: {study.scenario}")
            yield _run_table(runs)
            yield from (Text(f"  {sentence}") for sentence in _run_notes(runs))
            yield Text("\n  Time until each set-point is reached (2 % of the change), run by run:")
            yield _point_table(runs)


def _heading(text: str) -> Text:
    return Text(f"\n{text}\n{'=' * len(text)}")


def _right(table: Table, first: int = 1) -> Table:
    for column in table.columns[first:]:
        column.justify = "right"
    return table


def _limits(limits: StationaryLimits) -> Table:
    table = _right(Table("machine", "torque", "up to", "at rest", "largest speed", box=box.SIMPLE_HEAD))
    for k, machine in enumerate(limits.machines):
        table.add_row(
            machine,
            readable(limits.torque_max[k], "N m"),
            readable(limits.speed_rated[k], "rad/s"),
            readable(limits.torque_share[k] * limits.torque_max[k], "N m", 4),
            readable(limits.speed_share * limits.speed_max[k], "rad/s", 4),
        )
    return table


def _stationary(limits: StationaryLimits) -> Iterator[str]:
    for k, (reference, unit) in enumerate(zip(limits.references, limits.units, strict=True)):
        if unit != "N m":
            continue
        largest, machine = limits.largest(k)
        parts = [
            f"{limits.machines[i]} {limits.torque[i, k]:.4g}"
            for i in range(len(limits.machines))
            if limits.torque[i, k] != 0
        ]
        yield (
            f"{reference}: torque at rest per N m: {', '.join(parts)}; let through up to "
            f"{readable(largest, 'N m', 4)}, then {machine} is at its limit"
        )


def _step(step: OrderedStep) -> str:
    head = f"{step.reference}, within the torque of {step.machine}"
    if not step.earlier and not step.later:
        return f"{head}, which depends on no other reference at once"
    parts = []
    if step.earlier:
        act, are = ("acts", "it is") if len(step.earlier) == 1 else ("act", "they are")
        give = "gives" if len(step.earlier) == 1 else "give"
        parts.append(f"which {listed(step.earlier)} {act} on too: {are} placed before, and {give} way")
    if step.later:
        act, come = ("acts", "comes") if len(step.later) == 1 else ("act", "come")
        parts.append(f"which {listed(step.later)} {act} on too, but {come} later: taken for unchanged")
    return f"{head}, {'; '.join(parts)}"


def _set(found: ConstraintSet, automatic: bool) -> Iterator[str]:
    h = found.prediction.sample_time
    how = "longer ones add nothing" if automatic else "as given"
    yield f"horizon {found.horizon} steps, {readable(found.horizon * h, 's', 3)} ({how}); rows looked at up to " + (
        f"{readable(found.looked_at * h, 's', 3)}, behind which nothing moves"
    )
    yield (
        f"{found.all_rows} inequalities as the source writes them, {found.kept_rows} kept; the others up to there "
        f"bind by at most {percent(found.removal)} of a limit, and limits are tightened by {percent(found.loss)} for "
        f"them: leaving rows out costs no more torque than that, and is safe"
    )
    behind = found.binding[:, found.horizon + 1 :]
    if not automatic and behind.size and behind.max() > found.removal * (1 + 1e-6):
        yield f"Behind this horizon torques can still exceed their limits, by up to {percent(float(behind.max()))}"
    yield f"{found.programs} linear programs"


def _rows(found: ConstraintSet) -> Table:
    table = _right(Table("machine", "rows", "kept", "first", "last", box=box.SIMPLE_HEAD))
    h = found.prediction.sample_time
    for machine, steps in zip(found.prediction.machines, found.steps, strict=True):
        ends = (
            [readable(float(steps[k]) * h, "s", 3) if len(steps) else "" for k in (0, -1)] if len(steps) else ["", ""]
        )
        table.add_row(machine, str(found.horizon + 1), str(len(steps) + 1), *ends)
    return table


def _shorter(study: GovernorStudy, found: ConstraintSet) -> Table:
    machines = found.prediction.machines
    table = _right(Table("horizon", "rows kept", *machines, box=box.SIMPLE_HEAD), first=0)
    h = found.prediction.sample_time
    whole = [(found.horizon, sum(found.counts) + len(machines), found.binding.max(axis=1))]
    for steps, kept, most in [*((s.steps, s.kept, s.binding) for s in study.shorter), *whole]:
        table.add_row(readable(steps * h, "s", 3), str(kept), *(percent(float(value)) for value in most))
    return table


def _check(check: SolverCheck) -> str:
    unsolved = f"; {check.unsolved} times it found nothing" if check.unsolved else ""
    return (
        f"Compared with {check.solver} on all {check.rows} rows in {check.situations} situations: at most "
        f"{percent(max(check.loss, 0.0))} less let through, rows violated by at most "
        f"{percent(max(check.violation, 0.0))}{unsolved}"
    )


def _run_table(runs: Sequence[GovernedRun]) -> Table:
    machines = list(runs[0].demands)
    head = ["", "governor", *(f"{name} beyond" for name in machines), "held back", "iterations", "slack"]
    table = _right(Table(*head, box=box.SIMPLE_HEAD), first=2)
    for column in table.columns[:2]:
        column.no_wrap = True
    for number, run in enumerate(runs, start=1):
        work, is_governed = run.solver, run.choice.kind != "none"
        total = sum(work.statuses.values())
        held = total - work.statuses.get(0, 0)
        is_optimal = run.choice.kind == "optimal"
        slack = "\n".join(f"{name} {readable(value, 'N m', 3)}" for name, value in work.slack.items() if value > 0)
        table.add_row(
            str(number),
            run.choice.label,
            *(_excess(entry) for entry in run.beyond_limit),
            percent(held / total) if is_governed and total else "",
            f"{work.mean_iterations:.2g} to {work.most_iterations}" if is_optimal else "",
            slack if is_governed else "",
        )
    return table


def _run_notes(runs: Sequence[GovernedRun]) -> Iterator[str]:
    yield (
        "Beyond: most by which the torque that the law asks for exceeds the limit of the machine, and for how long. "
        "Held back: share of the time."
    )
    if any(run.choice.kind == "optimal" for run in runs):
        yield "Iterations: mean where something binds, and most. Slack: by how much limits were widened, at most."
    for code in (2, 3, 4):
        steps = {k: run.solver.statuses.get(code, 0) for k, run in enumerate(runs, 1) if run.choice.kind != "none"}
        if any(steps.values()):
            told = ", ".join(f"{count} steps of run {k}" for k, count in steps.items() if count)
            yield f"Status {code}, {STATUS_NAMES[code]}: {told}."


def _excess(entry: Excess) -> str:
    if entry.at is None:
        return "-"
    return f"{readable(entry.most, 'N m', 3)},\n{readable(float(f'{entry.lasting:.2g}'), 's', 3)}"


def _point_table(runs: Sequence[GovernedRun]) -> Table:
    numbers = [str(number) for number in range(1, len(runs) + 1)]
    table = _right(Table("reference", "at", "to", *numbers, box=box.SIMPLE_HEAD))
    table.columns[0].no_wrap = True
    for points in zip(*(run.set_points for run in runs), strict=True):
        first = points[0]
        target = readable(float(np.round(first.target, 9)), first.unit, 4)
        table.add_row(first.signal, f"{first.at:.4g} s", target, *(_after(point) for point in points))
    return table


def _after(point: SetPoint) -> str:
    return "not" if point.reached_after is None else readable(point.reached_after, "s", 3)

"""A tuning as text for the terminal."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from ptgen.analysis.demands import Check
from ptgen.loops.loop_tuning import GainResult, LoopTuning, Obstacle, WishResult
from ptgen.report.loop_verdict import delay_text, mode_text
from ptgen.report.quantities import percent, readable

__all__ = ["tuning_text"]


def tuning_text(found: LoopTuning, written: bool | None = None) -> Iterator[RenderableType]:
    """Yield the verdict, the wishes, what stands in the way, margins and gains.

    Parameters
    ----------
    found : LoopTuning
    written : bool, optional
        Whether the bed file was changed; None if it was not asked for.
    """
    demands = found.demands
    yield Text(
        f"{found.title}: demanded are a delay margin of {delay_text(demands.delay, found.sample_time)}, each machine "
        f"alone and all together, and a disk margin of {demands.disk:.3g}"
    )
    for sentence in (*found.notes, *_verdict(found)):
        yield Text(f"  {sentence}")
    yield _wishes(found)
    for result in found.wishes:
        if result.obstacle is not None:
            yield Text(f"  More {result.wish.key} is not held: {_obstacle(result.obstacle, found)}")
    if found.is_found:
        yield Text("\nMargins with what is held\n=========================")
        yield _margins(found)
        yield Text("Gains, and where the continuous loop is stable, all else as it is\n" + "=" * 65)
        yield _gains(found.gains)
    for title, names in (("locked", found.locked), ("free", found.free)):
        if names:
            yield Text(f"{title}: {', '.join(names)}")
    if written is not None:
        yield Text(
            f"{found.file}: {_written(found)}" if written else f"{found.file}: nothing to change, nothing written"
        )
    elif found.changes:
        yield Text(f"Nothing was written; --write would write {_written(found, '')}.")


def _written(found: LoopTuning, verb: str = "written: ") -> str:
    return verb + ", ".join(f"{key} = {value}" for key, value in found.changes.items())


def _verdict(found: LoopTuning) -> Iterator[str]:
    if found.obstacle is None:
        yield "The wishes hold as they are."
        return
    yield f"The wishes do not hold: {_obstacle(found.obstacle, found)}"
    if found.is_found:
        reduced = [result for result in found.wishes if result.is_reduced]
        parts = ", ".join(f"{result.wish.key} {result.text}" for result in reduced)
        yield f"The best that was found: {parts}{', the others as wished' if len(reduced) < len(found.wishes) else ''}."
        if not found.is_robust:
            yield "Take care: 5 or 10 % less of these does not hold, they lie in a narrow range."
        return
    if found.least is not None:
        yield f"Nor does a hundredth of all wishes: {_obstacle(found.least, found)}"
    yield "No smaller wishes were found that hold, so it is not the bandwidths that limit the margin."
    for help in found.helps:
        if help.is_switch:
            yield (
                f"With the parameter {help.name} of the controller at {help.value:g} all wishes hold; what that costs "
                f"in coupling, ptgen analyse --set {help.name}={help.value:g} tells."
            )
        else:
            yield f"With {help.value:g} times the {help.name} all wishes hold."
    if not found.helps:
        yield (
            "No switch of the law and no larger wish alone helps either: ask for less margin, or change the drive or "
            "the component named above."
        )


def _obstacle(obstacle: Obstacle, found: LoopTuning) -> str:
    check = obstacle.check
    whose = f"the {obstacle.controls} loop of {check.machine}" if check.machine else "the loop"
    at = f"at {check.frequency_hz:.3g} Hz" if np.isfinite(check.frequency_hz) and check.frequency_hz > 0 else ""
    sentence = (
        {
            "stability": f"the sampled loop is unstable {at}, nearest to its limit is {whose}",
            "proof": f"without sampling and delays, on the reduced bed, {whose} is unstable already {at}",
            "common_delay": f"all torques may come {_delay(check, found)} later, then it swings {at}; most "
            f"sensitive is {whose}",
            "delay": f"{whose} may come {_delay(check, found)} later, then it swings {at}",
            "disk": f"the disk margin is {check.value:.3g} {at}, most sensitive is {whose}",
        }[check.kind]
        .replace("  ", " ")
        .rstrip()
    )
    if not at:
        return f"{sentence}."
    sentence += f"; {mode_text(obstacle.mode, check.frequency_hz)}"
    budget = obstacle.budget
    if budget is not None and check.kind != "proof":
        shares = ", ".join(f"{name} {degrees:.2g}" for name, degrees in budget.degrees.items())
        sentence += f". The drive takes {budget.total:.2g} deg there ({shares})"
    return f"{sentence}."


def _delay(check: Check, found: LoopTuning) -> str:
    return delay_text(check.value, found.sample_time)


def _wishes(found: LoopTuning) -> Table:
    table = Table("wish", "wanted", "held", "share", "alone", box=box.SIMPLE_HEAD)
    for column in table.columns[1:]:
        column.justify = "right"
    for result in found.wishes:
        table.add_row(
            result.wish.key, result.wish.text, result.text or "nothing", _share(result.share), _alone(result, found)
        )
    return table


def _alone(result: WishResult, found: LoopTuning) -> str:
    """Return which share would do with all others as wished."""
    return "" if found.holds_as_wished else _share(result.alone) if result.alone is not None else "not enough"


def _share(share: float | None) -> str:
    return "" if share is None else percent(share)


def _margins(found: LoopTuning) -> Table:
    table = Table("margin", "demanded", "held", "at", box=box.SIMPLE_HEAD)
    for column in table.columns[1:]:
        column.justify = "right"
    names = {"disk": "disk margin", "common_delay": "delay of all machines"}
    for check in found.held_checks:
        if check.kind in ("stability", "proof"):
            continue
        name = names.get(check.kind, f"delay of {check.machine}")
        time = check.kind != "disk"
        values = [
            (delay_text(value, found.sample_time) if time else f"{value:.3g}") if value else "none"
            for value in (check.wanted, check.value)
        ]
        table.add_row(name, *values, f"{check.frequency_hz:.3g} Hz" if np.isfinite(check.frequency_hz) else "")
    return table


def _gains(gains: tuple[GainResult, ...]) -> Table:
    table = Table("gain", "value", "stable", box=box.SIMPLE_HEAD)
    table.columns[1].justify = "right"
    for gain in gains:
        ranges = ", ".join(_range(low, high) for low, high in gain.intervals)
        table.add_row(gain.name, readable(gain.value, gain.unit, 6), ranges)
    return table


def _range(low: float, high: float) -> str:
    if np.isinf(low) and np.isinf(high):
        return "any"
    return (
        f"above {low:.4g}" if np.isinf(high) else f"below {high:.4g}" if np.isinf(low) else f"{low:.4g} to {high:.4g}"
    )

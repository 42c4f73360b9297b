"""Runs with reference governors as figures: references, torques, controlled quantities, after Figures 7.5 to 7.14."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ptgen.loops.governed_run import Excess, Followed, GovernedRun
from ptgen.report.curves import thinned
from ptgen.report.figures import GREY, LIGHT, PALETTE, REFERENCE, new_figure, set_headline
from ptgen.report.quantities import readable, shown_unit
from ptgen.units import from_si

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["controlled_figure", "overview_figure", "references_figure", "torques_figure"]

Array = NDArray[np.float64]

_POINTS = 6000
_HEIGHT = 2.3


def references_figure(runs: Sequence[GovernedRun], title: str) -> Figure:
    """Draw what was asked for and what each governor made of it, a panel for every reference, as Figure 7.5."""
    followed = runs[0].followed
    figure, panels = _stacked(len(followed), f"{title}: references")
    for axes, item in zip(panels, followed, strict=True):
        _references(axes, runs, item)
    return figure


def torques_figure(runs: Sequence[GovernedRun], title: str) -> Figure:
    """Draw the torques that the law asks for and their limits, a panel for every machine, as Figure 7.6."""
    machines = list(runs[0].demands)
    figure, panels = _stacked(len(machines), f"{title}: torques before any limit")
    for axes, machine in zip(panels, machines, strict=True):
        _torques(axes, runs, machine)
    return figure


def controlled_figure(runs: Sequence[GovernedRun], title: str) -> Figure:
    """Draw the controlled quantities and the shaped references that they follow, as Figure 7.7."""
    followed = runs[0].followed
    figure, panels = _stacked(len(followed), f"{title}: controlled quantities")
    for axes, item in zip(panels, followed, strict=True):
        _controlled(axes, runs, item)
    return figure


def overview_figure(runs: Sequence[GovernedRun], title: str, points: int = _POINTS) -> Figure:
    """Draw references beside torques, with about so many points for every curve."""
    followed, machines = runs[0].followed, list(runs[0].demands)
    rows = max(len(followed), len(machines))
    figure = new_figure(15.0, _HEIGHT * rows + 0.9)
    set_headline(figure, title)
    grid = figure.subplots(rows, 2, sharex=True, squeeze=False)
    for k in range(rows):
        if k < len(followed):
            _references(grid[k, 0], runs, followed[k], points)
        if k < len(machines):
            _torques(grid[k, 1], runs, machines[k], points)
    for axes in grid[-1]:
        axes.set_xlabel("time (s)", fontsize=9)
    entries: dict[str, Artist] = {}
    for axes in grid.ravel():
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            entries.setdefault(label.partition(":  ")[0], handle)
        if axes.get_legend() is not None:
            axes.get_legend().remove()
    figure.legend(
        list(entries.values()), list(entries), loc="outside lower center", ncols=4, fontsize=8.5, frameon=False
    )
    return figure


def _stacked(count: int, title: str) -> tuple[Figure, list[Axes]]:
    figure = new_figure(10.5, _HEIGHT * count + 0.9)
    set_headline(figure, title)
    panels = list(figure.subplots(count, 1, sharex=True, squeeze=False)[:, 0])
    panels[-1].set_xlabel("time (s)", fontsize=9)
    figure.align_ylabels(panels)
    return figure, panels


def _references(axes: Axes, runs: Sequence[GovernedRun], item: Followed, points: int = _POINTS) -> None:
    scale = _prepared(axes, item.signal, item.unit, item.wanted)
    for k, run in enumerate(runs):
        if run.choice.kind == "none" or item.shaped not in run.recording.signals:
            continue
        _line(
            axes,
            run,
            scale * run.recording.signals[item.shaped],
            k,
            f"{run.choice.label}:  {_reached(run, item)}",
            points,
        )
    time = runs[0].recording.time
    axes.plot(*thinned(time, scale * item.wanted, points), color=REFERENCE, lw=0.9, ls=(0, (4, 2)), label="wanted")
    _finished(axes, time)


def _torques(axes: Axes, runs: Sequence[GovernedRun], machine: str, points: int = _POINTS) -> None:
    time = runs[0].recording.time
    limits = [run.limits[machine] for run in runs]
    scale = _prepared(axes, f"{machine}", "N m", limits[0])
    for k, run in enumerate(runs):
        beyond = next(entry for entry in run.beyond_limit if entry.machine == machine)
        _line(axes, run, scale * run.demands[machine], k, f"{run.choice.label}:  {_excess(beyond)}", points)
    # All runs have nearly the same speeds; where they differ, the limit of the last run is as good as any.
    for sign in (1, -1):
        label = "limit" if sign > 0 else None
        axes.plot(*thinned(time, sign * scale * limits[-1], points), color=GREY, lw=1.1, ls=":", label=label, zorder=2)
    highest = scale * max(float(limit.max()) for limit in limits)
    low, high = axes.get_ylim()
    axes.set_ylim(max(low, -1.6 * highest), min(high, 1.6 * highest))
    _finished(axes, time)


def _controlled(axes: Axes, runs: Sequence[GovernedRun], item: Followed) -> None:
    scale = _prepared(axes, item.output, item.unit, item.wanted)
    for k, run in enumerate(runs):
        _line(axes, run, scale * run.recording.signals[item.output], k, f"{run.choice.label}:  {_reached(run, item)}")
        if item.shaped in run.recording.signals and run.choice.kind != "none":
            shaped = scale * run.recording.signals[item.shaped]
            colour = PALETTE[k % len(PALETTE)]
            axes.plot(*thinned(run.recording.time, shaped, _POINTS), color=colour, lw=0.8, ls=(0, (4, 2)), zorder=2)
    _finished(axes, runs[0].recording.time)


def _prepared(axes: Axes, name: str, unit: str, values: Array) -> float:
    """Give axes a title and a unit; return the factor of that unit."""
    shown = shown_unit(float(np.max(np.abs(values), initial=0.0)), unit)
    axes.set_title(name, fontsize=9.5, loc="left")
    axes.set_ylabel(shown, fontsize=9)
    axes.grid(True, color=LIGHT, lw=0.6)
    axes.tick_params(labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    return from_si(1.0, unit, shown)


def _line(axes: Axes, run: GovernedRun, values: Array, k: int, label: str, points: int = _POINTS) -> None:
    axes.plot(
        *thinned(run.recording.time, values, points),
        color=PALETTE[k % len(PALETTE)],
        lw=max(0.9, 3.0 - 0.4 * k),  # of curves that lie on each other all are seen
        zorder=3 + k,
        label=label,
    )


def _finished(axes: Axes, time: Array) -> None:
    if len(time) > 1:
        axes.set_xlim(time[0], time[-1])
    axes.legend(loc="upper left", bbox_to_anchor=(1.005, 1.0), fontsize=7.5, frameon=False, borderaxespad=0.0)


def _reached(run: GovernedRun, item: Followed) -> str:
    """Return how long the changes of a reference took, longest first said."""
    own = [point for point in run.set_points if point.signal == item.signal]
    reached = [point.reached_after for point in own if point.reached_after is not None]
    if not own:
        return "no change"
    missed = len(own) - len(reached)
    mean = f"reached after {readable(float(np.mean(reached)), 's', 3)} on average" if reached else ""
    return ", ".join(part for part in (mean, f"{missed} of {len(own)} not reached" if missed else "") if part)


def _excess(entry: Excess) -> str:
    if entry.at is None:
        return "within"
    return f"+{readable(entry.most, 'N m', 3)} at {entry.at:.3g} s, for {readable(entry.lasting, 's', 2)}"

"""Mode shapes as test bed engineers draw them: amplitudes along the power flow, one picture per mode."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ptgen.mechanism.modes import Mode
from ptgen.report.bed_tree import chains
from ptgen.report.figures import GREY, INK, LIGHT, PALETTE, new_figure, set_headline
from ptgen.report.quantities import percent
from ptgen.testbed.testbed import Testbed

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Path", "modes_figure", "paths"]

_COLUMNS = 2
_RIGID = (INK, *PALETTE[3:])
"""Colours of rigid-body modes, which share their axes; those of elastic modes tell the paths apart."""


@dataclass(frozen=True)
class Path:
    """Bodies that follow each other along the power flow.

    Attributes
    ----------
    bodies : tuple of str
        Their velocities.
    elastic : tuple of bool
        For each body but the first, whether a shaft leads to it; otherwise gears or friction do.
    """

    bodies: tuple[str, ...]
    elastic: tuple[bool, ...]


def paths(bed: Testbed, shown: Collection[str]) -> tuple[Path, ...]:
    """Return the paths of a bed with the velocities in `shown`, each of them once.

    What stands in no chain, such as the relative motion in a differential, makes a path of its own.
    """
    found: list[Path] = []
    placed: set[str] = set()
    for chain in chains(bed):
        bodies: list[str] = []
        elastic: list[bool] = []
        sprung = False
        for index, flange in enumerate(chain):
            name = flange.partition(".")[0]
            inside = index > 0 and chain[index - 1].partition(".")[0] == name
            sprung = sprung or (inside and bool(bed.components[name].elements(name).springs))
            if flange not in shown or flange in placed:
                continue
            if bodies:
                elastic.append(sprung)
            bodies.append(flange)
            placed.add(flange)
            sprung = False
        if bodies:
            found.append(Path(tuple(bodies), tuple(elastic)))
    found += [Path((name,), ()) for name in shown if name not in placed]
    return tuple(found)


def modes_figure(modes: Sequence[Mode], bed: Testbed, locked: Collection[str] = ()) -> Figure:
    """Draw the shapes of modes.

    Parameters
    ----------
    modes : sequence of Mode
    bed : Testbed
        The bed that they belong to.
    locked : collection of str
        Friction elements that stick, for the title.
    """
    rigid = [mode for mode in modes if mode.frequency_hz == 0]
    elastic = [mode for mode in modes if mode.frequency_hz > 0]
    groups = [*([rigid] if rigid else []), *([mode] for mode in elastic)]
    shown = paths(bed, list(modes[0].shape)) if modes else ()
    columns = min(_COLUMNS, max(1, len(groups)))
    rows = max(1, -(-len(groups) // columns))
    bodies = sum(len(path.bodies) for path in shown)
    figure = new_figure(columns * max(4.2, 0.42 * bodies + 1.0), 1.75 * rows + 1.9)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    state = f", locked: {', '.join(locked)}" if locked else ""
    set_headline(figure, f"{bed.title}: modes{state}")
    for index, axes in enumerate(grid.flat):
        if index >= len(groups):
            axes.set_visible(False)
            continue
        _draw(axes, groups[index], shown)
        if index + columns >= len(groups):
            _name_bodies(axes, shown, reserve=index // columns == rows - 1)
        if index % columns == 0:
            axes.set_ylabel("amplitude", fontsize=8)
    return figure


def _draw(axes: Axes, group: Sequence[Mode], shown: Sequence[Path]) -> None:
    axes.axhline(0.0, color=GREY, lw=0.8, zorder=1)
    rigid = group[0].frequency_hz == 0
    offset = 0.16 if len(group) > 1 else 0.0
    for number, mode in enumerate(group):
        shift = offset * (number - (len(group) - 1) / 2)
        start = 0
        for branch, path in enumerate(shown):
            colour = _RIGID[number % len(_RIGID)] if rigid else PALETTE[branch % len(PALETTE)]
            xs = [start + k + shift for k in range(len(path.bodies))]
            ys = [mode.shape[name] for name in path.bodies]
            for k, sprung in enumerate(path.elastic):
                style = "-" if sprung else (0, (1, 1.5))
                axes.plot(xs[k : k + 2], ys[k : k + 2], color=colour, lw=1.4, ls=style, zorder=3)
            axes.vlines(xs, 0.0, ys, color=colour, lw=1.0, alpha=0.55, zorder=2)
            axes.plot(xs, ys, ls="none", marker="o", ms=4.5, color=colour, zorder=4)
            start += len(path.bodies)
    boundary = 0
    for path in shown[:-1]:
        boundary += len(path.bodies)
        axes.axvline(boundary - 0.5, color=LIGHT, lw=0.8, zorder=0)
    axes.set_title(_title(group), fontsize=9.5, loc="left")
    axes.set_ylim(-1.18, 1.18)
    axes.set_yticks([-1, 0, 1])
    axes.set_xlim(-0.6, sum(len(path.bodies) for path in shown) - 0.4)
    axes.tick_params(labelsize=8, bottom=False, labelbottom=False)
    for side in ("top", "right", "bottom"):
        axes.spines[side].set_visible(False)


def _title(group: Sequence[Mode]) -> str:
    mode = group[0]
    if mode.frequency_hz > 0:
        return f"{mode.frequency_hz:.3g} Hz, damping {percent(mode.damping_ratio)}"
    return "rigid body" if len(group) == 1 else f"rigid body, {len(group)} modes"


def _name_bodies(axes: Axes, shown: Sequence[Path], *, reserve: bool) -> None:
    names = [name.removesuffix(".shaft") for path in shown for name in path.bodies]
    axes.set_xticks(range(len(names)), names, rotation=90, fontsize=8, color=INK)
    axes.tick_params(labelbottom=True)
    for label in axes.get_xticklabels():  # the last row makes the room; an empty cell below needs none
        label.set_in_layout(reserve)

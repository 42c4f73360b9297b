"""The lever diagram of a gear set: its levers with what joins them, and the speeds of all gears or of one.

The three speeds of a planetary set lie on a straight line over a lever on which the distances of sun, carrier and ring
are as ``g`` to 1, so that each gear is one line in the diagram of each set.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ptgen.gears.analysis import GearAnalysis
from ptgen.gears.gear import Gear
from ptgen.gears.layout import Train, TrainKind
from ptgen.report.figures import GREY, INK, LIGHT, ORANGE, new_figure, set_headline
from ptgen.report.gears_schematic import draw_schematic
from ptgen.report.gears_words import number_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["lever_figure", "lever_positions"]

_PANEL, _PANEL_AXIS = 3.1, 2.6
"""Width of a panel and of its axis (inches)."""
_MEMBERS, _MEMBERS_AXIS = 8.0, 7.0
"""Width of the figure of a gear set without planetary sets, and of its axis (inches)."""
_SAME = 0.008
"""Speeds nearer than this share of the axis are one."""
_CHARACTER = 0.078
"""Width of a character (inches)."""
_CLEAR = {"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.85}
"""What lies behind a text."""


def lever_positions(train: Train) -> dict[str, float]:
    """Return the heights of a set's flanges on its lever, from 0 to 1, with the sun above the ring.

    Examples
    --------
    >>> from fractions import Fraction
    >>> import sympy as sp
    >>> g = sp.Symbol("g1", positive=True)
    >>> row = {"sun": sp.Integer(1), "ring": g, "carrier": -1 - g}
    >>> numbers = {"sun": Fraction(1), "ring": Fraction(2), "carrier": Fraction(-3)}
    >>> lever_positions(Train("P1", TrainKind.PLANETARY_SET, {}, row, numbers, g, Fraction(2)))
    {'sun': 1.0, 'carrier': 0.3333333333333333, 'ring': 0.0}
    """
    numbers = {flange: float(number) for flange, number in train.numbers.items()}
    raw = {"sun": 1.0, "carrier": numbers["sun"] / (numbers["sun"] + numbers["ring"]), "ring": 0.0}
    least, most = min(raw.values()), max(raw.values())
    return {flange: (height - least) / (most - least) for flange, height in raw.items()}


def lever_figure(found: GearAnalysis, gear: Gear | None = None) -> Figure:
    """Draw the levers of a gear set and the speeds of its members.

    Parameters
    ----------
    found : GearAnalysis
    gear : Gear, optional
        The only gear to draw, with its numbers; all listed gears otherwise.
    """
    sets = [train for train in found.layout.trains if train.kind is TrainKind.PLANETARY_SET]
    gears = found.listed if gear is None else (gear,)
    colours = _colours(found, gears)
    title = f"{found.layout.title}: speeds in {'all gears' if gear is None else f'gear {gear.name}'}"
    if not sets:
        figure = new_figure(_MEMBERS, 0.38 * len(found.layout.members) + 1.8)
        _draw_members(figure.subplots(), found, gears, colours)
        set_headline(figure, title)
        return figure
    figure = new_figure(max(6.5, _PANEL * len(sets) + 0.8), 7.6)
    grid = figure.add_gridspec(2, len(sets), height_ratios=[1.0, 1.15])
    positions = {train.name: lever_positions(train) for train in sets}
    draw_schematic(figure.add_subplot(grid[0, :]), found.layout, sets, positions, gear)
    limits = _limits(gears, [member for train in sets for member in train.members.values()])
    for number, train in enumerate(sets):
        axes = figure.add_subplot(grid[1, number])
        _draw_set(axes, train, positions[train.name], gears, colours, limits)
    set_headline(figure, title)
    return figure


def _colours(found: GearAnalysis, gears: Sequence[Gear]) -> Mapping[str, object]:
    """Return a colour for each gear: forward ones from blue to green, the others in orange."""
    from matplotlib import colormaps

    forward = [gear.name for gear in gears if gear in found.forward]
    scale = colormaps["viridis"]
    shades = {name: scale(0.8 * k / max(1, len(forward) - 1)) for k, name in enumerate(forward)}
    return {gear.name: shades.get(gear.name, ORANGE) for gear in gears}


def _limits(gears: Sequence[Gear], members: Sequence[str]) -> tuple[float, float]:
    known = [gear.speeds[member].value for gear in gears for member in members]
    speeds = [0.0, 1.0, *(float(value) for value in known if value is not None)]
    margin = 0.09 * (max(speeds) - min(speeds))
    return min(speeds) - margin, max(speeds) + margin


def _draw_set(
    axes: Axes,
    train: Train,
    heights: Mapping[str, float],
    gears: Sequence[Gear],
    colours: Mapping[str, object],
    limits: tuple[float, float],
) -> None:
    for height in heights.values():
        axes.axhline(height, color=LIGHT, lw=0.9, zorder=1)
    axes.axvline(0.0, color=INK, lw=1.1, zorder=2)
    axes.axvline(1.0, color=GREY, lw=0.9, ls=(0, (3, 3)), zorder=2)
    low, high = min(heights, key=lambda f: heights[f]), max(heights, key=lambda f: heights[f])
    ends: dict[str, list[tuple[float, str]]] = {low: [], high: []}
    order = [gear.name for gear in gears]
    for gear in gears:
        speeds = {flange: gear.speeds[member].value for flange, member in train.members.items()}
        if any(value is None for value in speeds.values()):
            continue
        upwards = sorted(heights, key=lambda f: heights[f])
        xs = [float(speeds[flange] or 0) for flange in upwards]
        axes.plot(xs, [heights[f] for f in upwards], color=colours[gear.name], lw=1.7, marker="o", ms=3.5, zorder=3)
        for flange in ends:
            ends[flange].append((float(speeds[flange] or 0), gear.name))
        if len(gears) == 1:
            for flange, x in zip(upwards, xs, strict=True):
                axes.annotate(
                    number_text(x),
                    (x, heights[flange]),
                    (5, 4),
                    textcoords="offset points",
                    fontsize=8.5,
                    color=INK,
                    bbox=_CLEAR,
                    zorder=5,
                )
    if len(gears) > 1:
        for flange, above in ((high, True), (low, False)):
            _label(axes, ends[flange], heights[flange], (limits[1] - limits[0], _PANEL_AXIS), order, above=above)
    axes.set_xlim(*limits)
    axes.set_ylim(-0.27, 1.27)
    axes.set_yticks(list(heights.values()), [_flange_label(train, flange) for flange in heights], fontsize=8.5)
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", labelsize=8)
    axes.set_xlabel("speed / input speed", fontsize=8.5)
    axes.set_title(f"{train.name}, {train.symbol} = {float(train.ratio):.4g}", fontsize=9.5, loc="left")
    for side in ("top", "right", "left"):
        axes.spines[side].set_visible(False)


def _flange_label(train: Train, flange: str) -> str:
    return f"{flange[0].upper()}  {train.members[flange]}"


def _label(
    axes: Axes,
    ends: Sequence[tuple[float, str]],
    height: float,
    span: tuple[float, float],
    order: Sequence[str],
    *,
    above: bool,
) -> None:
    """Write the names of gears at the ends of their lines; in several rows, where they would meet.

    `span` is the range of the axis and its length (inches), `order` the names of all gears.
    """
    width, length = span
    groups: list[tuple[float, list[str]]] = []
    for x, name in sorted(ends, key=lambda end: end[0]):
        if groups and x - groups[-1][0] < _SAME * width:
            groups[-1][1].append(name)
        else:
            groups.append((x, [name]))
    taken: list[float] = []
    for x, names in groups:
        text = _runs(names, order)
        half = 0.5 * _CHARACTER * width / length * (len(text) + 0.6)
        row = next((k for k, edge in enumerate(taken) if edge <= x - half), len(taken))
        taken[row : row + 1] = [x + half]
        offset = 5 + 10 * row
        axes.annotate(
            text,
            (x, height),
            (0, offset if above else -offset),
            textcoords="offset points",
            ha="center",
            va="bottom" if above else "top",
            fontsize=8.5,
            color=INK,
            bbox=_CLEAR,
            zorder=5,
        )


def _runs(names: Sequence[str], order: Sequence[str]) -> str:
    """Return names as a text, neighbours in `order` as one run.

    Examples
    --------
    >>> _runs(["1", "3", "4", "5"], ["R", "1", "2", "3", "4", "5"])
    '1,3–5'
    """
    places = sorted(order.index(name) for name in names)
    runs: list[list[int]] = []
    for place in places:
        if runs and place == runs[-1][-1] + 1:
            runs[-1].append(place)
        else:
            runs.append([place])
    parts = [[order[run[0]], order[run[-1]]] if len(run) > 2 else [] for run in runs]
    return ",".join(
        "–".join(part) if part else ",".join(order[place] for place in run)
        for part, run in zip(parts, runs, strict=True)
    )


def _draw_members(axes: Axes, found: GearAnalysis, gears: Sequence[Gear], colours: Mapping[str, object]) -> None:
    """Draw the speeds of the members of a gear set without planetary sets."""
    members = list(found.layout.members)
    axes.axvline(0.0, color=INK, lw=1.1)
    for row, member in enumerate(members):
        axes.axhline(row, color=LIGHT, lw=0.9, zorder=1)
        known = [(gear, gear.speeds[member].value) for gear in gears]
        ends = [(float(value), gear.name) for gear, value in known if value is not None]
        for x, name in ends:
            axes.plot([x], [row], marker="o", ms=6, color=colours[name], zorder=3)
        if len(gears) == 1:
            for x, _ in ends:
                axes.annotate(number_text(x), (x, row), (5, 4), textcoords="offset points", fontsize=8.5, color=INK)
            continue
        _label(axes, ends, row, (_span(gears, members), _MEMBERS_AXIS), [gear.name for gear in gears], above=False)
    axes.set_yticks(range(len(members)), members, fontsize=8.5)
    axes.invert_yaxis()
    axes.set_ylim(len(members) - 0.3, -0.6)
    axes.set_xlabel("speed / input speed", fontsize=8.5)
    axes.tick_params(axis="y", length=0)
    for side in ("top", "right", "left"):
        axes.spines[side].set_visible(False)


def _span(gears: Sequence[Gear], members: Sequence[str]) -> float:
    low, high = _limits(gears, members)
    return high - low

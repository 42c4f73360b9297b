"""The levers of a gear set side by side, the members that join them, and the elements that couple and hold them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from ptgen.gears.gear import Gear
from ptgen.gears.layout import Layout, ShiftElement, Train
from ptgen.report.figures import BLUE, GREY, INK, ORANGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_schematic"]

_CLEAR = {"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.85}
"""What lies behind a text."""

Node = tuple[float, float]

_REACH = 0.22
"""How far brakes are from a lever, as a share of the distance of levers."""
_RISES = (0.0, -0.1, 0.1, -0.18, 0.18)
"""How far brakes may be below or above the point that they hold, as a share of the lever."""
_ROOM = 0.16
"""Room that a brake takes."""


def draw_schematic(
    axes: Axes,
    layout: Layout,
    sets: Sequence[Train],
    positions: Mapping[str, Mapping[str, float]],
    gear: Gear | None = None,
) -> None:
    """Draw the levers.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
    layout : Layout
    sets : sequence of Train
        The planetary sets, left to right.
    positions : mapping of str to mapping of str to float
        Set -> heights of its flanges.
    gear : Gear, optional
        Its engaged elements stand out.
    """
    nodes: dict[str, list[Node]] = {}
    for x, train in enumerate(sets):
        heights = positions[train.name]
        axes.plot([x, x], [min(heights.values()), max(heights.values())], color=INK, lw=3.5, zorder=3)
        axes.text(x, 1.3, train.name, ha="center", va="bottom", fontsize=10, fontweight="bold")
        for flange, height in heights.items():
            nodes.setdefault(train.members[flange], []).append((float(x), height))
            axes.plot([x], [height], marker="o", ms=7, color=INK, mfc="white", mew=1.6, zorder=5)
            axes.annotate(
                flange[0].upper(), (x, height), (7, 4), textcoords="offset points", fontsize=9, color=INK, zorder=6
            )
    lines = [(node, node) for own in nodes.values() for node in own]
    for member, own in nodes.items():
        own.sort()
        lines += list(pairwise(own))
        _draw_member(axes, member, own)
    for name, outward in ((layout.input, False), (layout.output, True)):
        if name in nodes:
            _draw_end(axes, nodes[name][-1 if outward else 0], outward=outward, last=len(sets) - 1)
    engaged = layout.element_names if gear is None else gear.engaged
    clutches = {element.name: _nearest(element, nodes) for element in layout.elements if not element.is_brake}
    for name, ends in clutches.items():
        if ends is not None:
            lines.append(ends)
            _draw_clutch(axes, name, *ends, *_pen(name in engaged))
    brakes = [(element.name, next(iter(element.row))) for element in layout.elements if element.is_brake]
    held = [("", next(iter(train.members.values()))) for train in layout.trains if len(train.members) == 1]
    for name, member in (*brakes, *held):
        if member in nodes:
            node, end = _free_place(nodes[member], lines)
            lines.append((node, end))
            _draw_brake(axes, name, node, end, *_pen(not name or name in engaged))
    axes.set_xlim(-0.75, len(sets) - 0.25)
    axes.set_ylim(-0.38, 1.45)
    axes.set_axis_off()


def _draw_member(axes: Axes, member: str, nodes: Sequence[Node]) -> None:
    """Join the nodes of a member, past the levers that lie between them."""
    from matplotlib.patches import FancyArrowPatch

    for (x1, y1), (x2, y2) in pairwise(nodes):
        bend = 0.0 if x2 - x1 <= 1 else -0.25
        axes.add_patch(
            FancyArrowPatch(
                (x1, y1), (x2, y2), arrowstyle="-", connectionstyle=f"arc3,rad={bend}", color=BLUE, lw=1.6, zorder=2
            )
        )
    if len(nodes) > 1:
        (x1, y1), (x2, y2) = nodes[:2]
        place = (x1 + 0.27 * (x2 - x1), y1 + 0.27 * (y2 - y1))
        axes.annotate(
            member, place, (0, 4), textcoords="offset points", ha="center", va="bottom", fontsize=8.5, color=BLUE
        )


def _draw_end(axes: Axes, node: Node, *, outward: bool, last: int) -> None:
    x, y = node
    word = "output" if outward else "input"
    reach = 0.55 if (x == last if outward else x == 0) else 0.4
    start, end = ((x, y), (x + reach, y)) if outward else ((x - reach, y), (x, y))
    arrow = {"arrowstyle": "-|>", "color": ORANGE, "lw": 1.8, "shrinkA": 4, "shrinkB": 4}
    axes.annotate("", end, start, arrowprops=arrow, zorder=4)
    axes.annotate(
        word,
        (x + reach if outward else x - reach, y),
        (0, 6),
        textcoords="offset points",
        ha="right" if outward else "left",
        va="bottom",
        fontsize=9,
        color=ORANGE,
    )


def _pen(engaged: bool) -> tuple[str, float]:
    """Return colour and width of the lines of an element."""
    return (INK, 1.8) if engaged else (GREY, 1.1)


def _nearest(element: ShiftElement, nodes: Mapping[str, list[Node]]) -> tuple[Node, Node] | None:
    """Return the nearest two points of the members that a clutch couples; None if one of them is on no lever."""
    ends = [nodes[member] for member in element.row if member in nodes]
    if len(ends) != 2:
        return None
    pairs = ((a, b) for a in ends[0] for b in ends[1])
    return min(pairs, key=lambda pair: (abs(pair[0][0] - pair[1][0]), abs(pair[0][1] - pair[1][1])))


def _free_place(nodes: Sequence[Node], lines: Sequence[tuple[Node, Node]]) -> tuple[Node, Node]:
    """Return a point of a member, and where a brake on it is farthest from everything else."""
    places = [
        (node, (node[0] + side * _REACH, node[1] + rise)) for node in nodes for side in (-1, 1) for rise in _RISES
    ]

    def room(place: tuple[Node, Node]) -> float:
        x, y = place[1]
        return min(_distance((x + shift, y), line) for line in lines for shift in (-0.06, 0.0, 0.06))

    return max(places, key=lambda place: (round(min(room(place), _ROOM), 3), -abs(place[1][1] - place[0][1])))


def _distance(point: Node, line: tuple[Node, Node]) -> float:
    (x, y), ((x1, y1), (x2, y2)) = point, line
    along = (x2 - x1) ** 2 + (y2 - y1) ** 2
    share = 0.0 if along == 0 else min(1.0, max(0.0, ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / along))
    return math.hypot(x - x1 - share * (x2 - x1), y - y1 - share * (y2 - y1))


def _draw_brake(axes: Axes, name: str, node: Node, end: Node, colour: str, width: float) -> None:
    """Draw an arm from a point of a lever to the housing."""
    side = 1 if end[0] > node[0] else -1
    axes.plot([node[0], node[0] + 0.4 * (end[0] - node[0]), end[0]], [node[1], end[1], end[1]], color=colour, lw=width)
    axes.plot([end[0], end[0]], [end[1] - 0.07, end[1] + 0.07], color=colour, lw=width)
    for k in range(4):
        height = end[1] - 0.05 + 0.035 * k
        axes.plot([end[0] + side * 0.025, end[0]], [height - 0.025, height], color=colour, lw=0.9)
    alignment = "left" if side > 0 else "right"
    place = (end[0] + side * 0.04, end[1])
    axes.text(*place, name, ha=alignment, va="center", fontsize=10, color=colour, fontweight="bold", zorder=6)


def _draw_clutch(axes: Axes, name: str, first: Node, second: Node, colour: str, width: float) -> None:
    """Draw a line with two plates between two members, beside the lever if both lie on it."""
    (x1, y1), (x2, y2) = first, second
    if x1 == x2:
        x = x1 + 0.22
        middle = (y1 + y2) / 2
        axes.plot([x1, x, x], [y1, y1, middle + 0.025], color=colour, lw=width, zorder=2)
        axes.plot([x2, x, x], [y2, y2, middle - 0.025], color=colour, lw=width, zorder=2)
        for height in (middle - 0.025, middle + 0.025):
            axes.plot([x - 0.05, x + 0.05], [height, height], color=colour, lw=2.2, zorder=2)
        place = (x + 0.06, middle)
        alignment = "left"
    else:
        share = 0.5 if abs((x1 + x2) / 2 % 1) == 0.5 else 0.5 + 0.5 / (x2 - x1)  # between levers, not on one
        mx, my = x1 + share * (x2 - x1), y1 + share * (y2 - y1)
        axes.plot([x1, x2], [y1, y2], color=colour, lw=width, ls=(0, (4, 2)), zorder=2)
        for shift in (-0.012, 0.012):
            axes.plot([mx + shift, mx + shift], [my - 0.05, my + 0.05], color=colour, lw=2.2, zorder=3)
        place = (mx, my - 0.12)
        alignment = "center"
    axes.text(*place, name, ha=alignment, va="center", fontsize=10, color=colour, fontweight="bold", bbox=_CLEAR)

"""The levers of a gear set side by side, the members that join them, and the elements that couple and hold them."""

from __future__ import annotations

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

_REACH = 0.3
"""How far the arms of elements reach from a lever, as a share of the distance of levers."""


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
    for member, own in nodes.items():
        own.sort()
        _draw_member(axes, member, own)
    for name, outward in ((layout.input, False), (layout.output, True)):
        if name in nodes:
            _draw_end(axes, nodes[name][-1 if outward else 0], outward=outward, last=len(sets) - 1)
    engaged = layout.element_names if gear is None else gear.engaged
    used: dict[Node, int] = {}
    for element in layout.elements:
        _draw_element(axes, element, nodes, used, element.name in engaged)
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


def _draw_element(
    axes: Axes, element: ShiftElement, nodes: Mapping[str, list[Node]], used: dict[Node, int], engaged: bool
) -> None:
    colour = INK if engaged else GREY
    width = 1.8 if engaged else 1.1
    ends = [nodes[member] for member in element.row if member in nodes]
    if element.is_brake and ends:
        node = min(ends[0], key=lambda own: (used.get(own, 0), own[0]))
        used[node] = used.get(node, 0) + 1
        _draw_brake(axes, element.name, node, used[node], colour, width)
    elif len(ends) == 2:
        first, second = min(
            ((a, b) for a in ends[0] for b in ends[1]),
            key=lambda pair: (abs(pair[0][0] - pair[1][0]), abs(pair[0][1] - pair[1][1])),
        )
        _draw_clutch(axes, element.name, first, second, colour, width)


def _draw_brake(axes: Axes, name: str, node: Node, count: int, colour: str, width: float) -> None:
    """Draw an arm to the housing, left of the lever and below it for every further one."""
    x, y = node
    end = (x - _REACH, y - 0.1 * count)
    axes.plot([x, x - 0.12, end[0]], [y, end[1], end[1]], color=colour, lw=width, zorder=2)
    for k in range(4):
        height = end[1] - 0.06 + 0.04 * k
        axes.plot([end[0] - 0.03, end[0]], [height - 0.03, height], color=colour, lw=0.9, zorder=2)
    axes.plot([end[0], end[0]], [end[1] - 0.075, end[1] + 0.075], color=colour, lw=width, zorder=2)
    axes.annotate(
        name, (end[0] - 0.04, end[1]), (-3, 0), textcoords="offset points", ha="right", va="center", fontsize=10,
        color=colour, fontweight="bold",
    )  # fmt: skip


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
        mx, my = (x1 + x2) / 2, (y1 + y2) / 2
        axes.plot([x1, x2], [y1, y2], color=colour, lw=width, ls=(0, (4, 2)), zorder=2)
        for shift in (-0.012, 0.012):
            axes.plot([mx + shift, mx + shift], [my - 0.05, my + 0.05], color=colour, lw=2.2, zorder=3)
        place = (mx, my - 0.12)
        alignment = "center"
    axes.text(*place, name, ha=alignment, va="center", fontsize=10, color=colour, fontweight="bold", bbox=_CLEAR)

"""The symbols of components in a drawing: machines as rotors, shafts as springs, gearboxes as trapezoids.

Couplings, brakes and bearings have the symbols of gear schemes: facing plates, a disk between shoes that hang on the
housing, journals between hatched blocks; a freewheel points to what it drives, a torque converter has two shells that
face each other.

Each symbol is drawn around a place of the grid and ends its stubs at `HALF` to the left and right of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from ptgen.report.figures import GREY, INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["HALF", "HEIGHT", "draw_symbol"]

HALF = 0.36
"""Half the width of a symbol, stubs included."""

HEIGHT = 0.26
"""Half the height of the largest symbol."""

_LINE = 1.5
_PALE = "#F4F4F4"


def draw_symbol(axes: Axes, kind: str, x: float, y: float, *, colour: str, text: str, mirrored: bool) -> None:
    """Draw the symbol of a component.

    Parameters
    ----------
    axes : Axes
    kind : str
        Type of the component; unknown ones become a box with their name.
    x, y : float
        Where its middle is.
    colour : str
        Fill of machines.
    text : str
        What stands inside machines and boxes.
    mirrored : bool
        Whether it is entered at its second flange.
    """
    draw = _SYMBOLS.get(kind)
    if draw is None:
        _box(axes, x, y, text)
    else:
        draw(axes, x, y, colour, text, mirrored)


def _stubs(axes: Axes, x: float, y: float, inner: float) -> None:
    for side in (-1, 1):
        axes.plot([x + side * inner, x + side * HALF], [y, y], color=INK, lw=_LINE, solid_capstyle="butt", zorder=1)


def _patch(axes: Axes, corners: list[tuple[float, float]], face: str) -> None:
    from matplotlib.patches import Polygon

    axes.add_patch(Polygon(corners, closed=True, facecolor=face, edgecolor=INK, linewidth=_LINE, zorder=2))


def _label(axes: Axes, x: float, y: float, text: str, colour: str = INK, size: float = 9.0) -> None:
    axes.text(x, y, text, ha="center", va="center", fontsize=size, color=colour, fontweight="bold", zorder=3)


def _machine(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    from matplotlib.patches import Circle

    axes.add_patch(Circle((x, y), HEIGHT, facecolor=colour, edgecolor=INK, linewidth=_LINE, zorder=2))
    _label(axes, x, y, text, "white", 11)


def _shaft(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    reach, swing = 0.22, 0.09
    _stubs(axes, x, y, reach)
    count = 8
    xs = [x - reach + 2 * reach * k / count for k in range(count + 1)]
    ys = [y, *(y + swing * (-1) ** k for k in range(count - 1)), y]
    axes.plot(xs, ys, color=INK, lw=_LINE, solid_joinstyle="round", zorder=2)


def _torque_flange(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    from matplotlib.patches import Rectangle

    _stubs(axes, x, y, 0.09)
    for left in (x - 0.1, x + 0.04):
        axes.add_patch(
            Rectangle((left, y - 0.2), 0.06, 0.4, facecolor="#BFD7EA", edgecolor=INK, linewidth=_LINE, zorder=2)
        )
    axes.plot([x - 0.04, x + 0.04], [y, y], color=INK, lw=_LINE, ls=(0, (1, 1)), zorder=2)


def _inertia(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    from matplotlib.patches import Rectangle

    _stubs(axes, x, y, 0.1)
    axes.add_patch(Rectangle((x - 0.1, y - 0.22), 0.2, 0.44, facecolor=GREY, edgecolor=INK, linewidth=_LINE, zorder=2))


def _gearbox(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.17)
    small, large = 0.1, 0.24
    left, right = (large, small) if mirrored else (small, large)
    _patch(axes, [(x - 0.18, y - left), (x - 0.18, y + left), (x + 0.18, y + right), (x + 0.18, y - right)], _PALE)
    _label(axes, x, y, text, size=8.0)


def _bar(axes: Axes, x: float, low: float, high: float, width: float = 3.0) -> None:
    axes.plot([x, x], [low, high], color=INK, lw=width, solid_capstyle="butt", zorder=3)


def _clutch(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.05)
    for side in (-1, 1):
        _bar(axes, x + side * 0.05, y - 0.22, y + 0.22)
    for low in (y + 0.1, y - 0.2):  # the linings
        _patch(axes, [(x - 0.03, low), (x - 0.03, low + 0.1), (x + 0.03, low + 0.1), (x + 0.03, low)], GREY)


def _torque_converter(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    from matplotlib.patches import Arc

    _stubs(axes, x, y, 0.16)
    for side in (-1, 1):  # two shells that face each other, with blades
        turn = 90.0 if side < 0 else -90.0
        shell = Arc((x + side * 0.03, y), 0.26, 0.46, theta1=turn, theta2=turn + 180.0, color=INK, lw=_LINE, zorder=3)
        axes.add_patch(shell)
        _bar(axes, x + side * 0.03, y - 0.23, y + 0.23, width=_LINE)
    tip = -0.015 if mirrored else 0.015
    _patch(axes, [(x + tip, y), (x - tip, y + 0.05), (x - tip, y - 0.05)], INK)


def _freewheel(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.13)
    tip = -0.13 if mirrored else 0.13
    _patch(axes, [(x + tip, y), (x - tip, y + 0.19), (x - tip, y - 0.19)], _PALE)
    _bar(axes, x + tip, y - 0.2, y + 0.2)


def _housing(axes: Axes, x: float, y: float, up: int) -> None:
    """Draw the housing: a line with hatching on the side to which `up` points."""
    axes.plot([x - 0.15, x + 0.15], [y, y], color=INK, lw=_LINE, zorder=2)
    for k in range(5):
        foot = x - 0.13 + 0.065 * k
        axes.plot([foot, foot + 0.04], [y, y + up * 0.05], color=INK, lw=0.9, zorder=2)


def _brake(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.0)
    _bar(axes, x, y - 0.17, y + 0.17)
    for side in (-1, 1):
        left, right = sorted((x + side * 0.03, x + side * 0.1))
        _patch(axes, [(left, y + 0.04), (left, y + 0.17), (right, y + 0.17), (right, y + 0.04)], GREY)
        axes.plot([x + side * 0.065] * 2, [y + 0.17, y + 0.23], color=INK, lw=_LINE, zorder=2)
    _housing(axes, x, y + 0.23, 1)


def _bearing(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.0)
    for up in (-1, 1):
        near, far = y + up * 0.04, y + up * 0.16
        _patch(axes, [(x - 0.08, near), (x - 0.08, far), (x + 0.08, far), (x + 0.08, near)], _PALE)
        axes.plot([x - 0.08, x + 0.08], [near, far], color=INK, lw=1.0, zorder=3)
        axes.plot([x - 0.08, x + 0.08], [far, near], color=INK, lw=1.0, zorder=3)
        _housing(axes, x, far, up)


def _wheels(axes: Axes, x: float, y: float) -> None:
    """Draw two gears that mesh, seen from the side: the upper one smaller."""
    for low, high in ((y - 0.2, y + 0.06), (y + 0.06, y + 0.22)):
        _patch(axes, [(x - 0.06, low), (x - 0.06, high), (x + 0.06, high), (x + 0.06, low)], _PALE)


def _gear_pair(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.06)
    _wheels(axes, x, y)


def _planetary_set(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.1)
    _bar(axes, x, y - 0.05, y + 0.05)  # sun, planet and ring, and the arm of the carrier
    for side in (-1, 1):
        _patch(
            axes,
            [
                (x - 0.06, y + side * 0.05),
                (x - 0.06, y + side * 0.17),
                (x + 0.06, y + side * 0.17),
                (x + 0.06, y + side * 0.05),
            ],
            _PALE,
        )
        _bar(axes, x, y + side * 0.19, y + side * 0.25, width=5.0)
        axes.plot([x, x + 0.1, x + 0.1], [y + side * 0.11, y + side * 0.11, y], color=INK, lw=_LINE, zorder=3)


def _synchroniser(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.08)
    turn = -1 if mirrored else 1
    sleeve = [
        (x - turn * 0.14, y - 0.2),
        (x - turn * 0.14, y + 0.2),
        (x - turn * 0.02, y + 0.2),
        (x - turn * 0.02, y - 0.2),
    ]
    cone = [
        (x + turn * 0.02, y - 0.12),
        (x + turn * 0.02, y + 0.12),
        (x + turn * 0.12, y + 0.2),
        (x + turn * 0.12, y - 0.2),
    ]
    _patch(axes, sleeve, _PALE)
    _patch(axes, cone, GREY)


def _clutched_gearbox(axes: Axes, x: float, y: float, clutches: Sequence[float], mirrored: bool) -> None:
    _stubs(axes, x, y, 0.24)
    _patch(axes, [(x - 0.24, y - 0.26), (x - 0.24, y + 0.26), (x + 0.24, y + 0.26), (x + 0.24, y - 0.26)], _PALE)
    turn = -1 if mirrored else 1
    for level in clutches:
        for side in (-1, 1):
            _bar(axes, x + turn * (side * 0.035 - 0.1), y + level - 0.08, y + level + 0.08)
        small, large = 0.04, 0.09
        left, right = (large, small) if mirrored else (small, large)
        middle = x + turn * 0.1
        corners = [(middle - 0.06, level - left), (middle - 0.06, level + left), (middle + 0.06, level + right)]
        corners.append((middle + 0.06, level - right))
        _patch(axes, [(across, y + up) for across, up in corners], "white")


def _single_clutch_gearbox(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _clutched_gearbox(axes, x, y, (0.0,), mirrored)


def _double_clutch_gearbox(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _clutched_gearbox(axes, x, y, (0.12, -0.12), mirrored)


def _part(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _stubs(axes, x, y, 0.24)
    _patch(axes, [(x - 0.24, y - 0.26), (x - 0.24, y + 0.26), (x + 0.24, y + 0.26), (x + 0.24, y - 0.26)], _PALE)
    for place in (x - 0.1, x + 0.1):
        _wheels(axes, place, y)


def _differential(axes: Axes, x: float, y: float, colour: str, text: str, mirrored: bool) -> None:
    _patch(axes, [(x - 0.24, y), (x + 0.24, y + 0.28), (x + 0.24, y - 0.28)], _PALE)
    axes.plot([x + 0.06] * 2, [y - 0.1, y + 0.1], color=INK, lw=_LINE, zorder=3)
    axes.plot([x + 0.06, x + 0.17], [y, y], color=INK, lw=_LINE, zorder=3)
    axes.plot([x + 0.17] * 2, [y - 0.06, y + 0.06], color=INK, lw=_LINE, zorder=3)


def _box(axes: Axes, x: float, y: float, text: str) -> None:
    _stubs(axes, x, y, 0.24)
    corners = [(x - 0.25, y - 0.2), (x - 0.25, y + 0.2), (x + 0.25, y + 0.2), (x + 0.25, y - 0.2)]
    _patch(axes, corners, _PALE)
    _label(axes, x, y, text, size=6.5)


_SYMBOLS: Mapping[str, Callable[[Axes, float, float, str, str, bool], None]] = {
    "machine": _machine,
    "shaft": _shaft,
    "torque_flange": _torque_flange,
    "inertia": _inertia,
    "gearbox": _gearbox,
    "clutch": _clutch,
    "freewheel": _freewheel,
    "torque_converter": _torque_converter,
    "brake": _brake,
    "bearing": _bearing,
    "differential": _differential,
    "bevel_differential": _differential,
    "epicyclic_differential": _differential,
    "planetary_set": _planetary_set,
    "gear_pair": _gear_pair,
    "synchroniser": _synchroniser,
    "single_clutch_gearbox": _single_clutch_gearbox,
    "double_clutch_gearbox": _double_clutch_gearbox,
    "part": _part,
}

"""A bed as a block drawing: its components along the power flow, with names, main values and roles."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from ptgen.report.bed_layout import Layout, layout
from ptgen.report.bed_symbols import HALF, HEIGHT, draw_symbol
from ptgen.report.figures import BLUE, GREY, INK, ORANGE, new_figure
from ptgen.report.quantities import readable
from ptgen.testbed.testbed import Testbed

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["bed_figure"]

_COLUMN, _ROW = 1.32, 1.62
"""Inches between columns and between rows."""

_MAIN = (
    "inertia",
    "inertia_drive",
    "stiffness",
    "torque_max",
    "speed_max",
    "ratio",
    "coulomb",
    "capacity",
    "backlash",
    "play",
)
"""The values that are written below a symbol, if the component has them."""

_PREFIXES = {"ratio": "i = ", "backlash": "gap ", "play": "gap "}
"""What is written before a value that does not explain itself."""


def bed_figure(bed: Testbed) -> Figure:
    """Draw a bed.

    Returns
    -------
    Figure
        Machines in the colour of their role; ``*`` marks values that are assumed.
    """
    places = layout(bed)
    left, right, low, high = places.extent
    width, height = (right - left + 1.1) * _COLUMN, (high - low + 1.1) * _ROW + 0.9
    figure = new_figure(max(width, 7.0), height, arranged=False)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    ratio = _ROW / _COLUMN
    _wires(axes, bed, places, ratio)
    for name, (x, row) in places.places.items():
        _component(axes, bed, name, x, row * ratio)
    axes.set_aspect("equal")
    spare = (max(width, 7.0) - width) / 2 / _COLUMN
    axes.set_xlim(left - 0.55 - spare, right + 0.55 + spare)
    axes.set_ylim(low * ratio - 0.8 * ratio - 0.15, high * ratio + 0.5 * ratio + 0.4)
    axes.axis("off")
    axes.text(0.012, 0.985, bed.title, transform=axes.transAxes, ha="left", va="top", fontsize=13, fontweight="bold")
    _legend(axes, bed, max(width, 7.0))
    return figure


def _wires(axes: Axes, bed: Testbed, places: Layout, ratio: float) -> None:
    for wire in places.wires:
        start, end = (_port(bed, places, flange, ratio) for flange in (wire.left, wire.right))
        points = [start, *((x, row * ratio) for x, row in wire.passes), end]
        xs, ys = [start[0]], [start[1]]
        for (x0, y0), (x1, y1) in pairwise(points):
            if abs(y1 - y0) > 1e-9:
                middle = (x0 + x1) / 2
                xs += [middle, middle]
                ys += [y0, y1]
            xs.append(x1)
            ys.append(y1)
        axes.plot(xs, ys, color=INK, lw=1.5, solid_joinstyle="round", zorder=1)
    for machine, flanges in _torque_places(bed).items():
        _mark(axes, bed, places, ratio, machine, flanges)


def _mark(axes: Axes, bed: Testbed, places: Layout, ratio: float, machine: str, flanges: list[str]) -> None:
    """Mark where the torque of a machine holds: in a component, at one flange, or at several as their sum."""
    text, side = f"torque of {machine}", "center"
    if flanges[0] in places.places:
        column, row = places.places[flanges[0]]
        ports, shift = [(column, row * ratio)], (0, 22)
    else:
        ports = [_port(bed, places, flange, ratio) for flange in flanges]
        entering = any(connection.right == flanges[0] for connection in bed.connections)
        # Between two ports there is no wire.
        shift = (-6 if entering else 8, -14 if len(ports) == 1 else -3)
        side = "right" if entering else "left"
        text = text if len(ports) == 1 else f"sum: {text}"
    for x, y in ports:
        axes.plot([x], [y], marker="o", ms=6, mfc="white", mec=ORANGE, mew=2, zorder=4)
    place = (ports[0][0], sum(y for _, y in ports) / len(ports))
    axes.annotate(text, place, xytext=shift, textcoords="offset points", ha=side, fontsize=7.5, color=ORANGE, zorder=4)


def _port(bed: Testbed, places: Layout, flange: str, ratio: float) -> tuple[float, float]:
    """Return where a connection meets its component: at the left if it enters it, else at the right."""
    name, _, port = flange.partition(".")
    x, row = places.places[name]
    y = row * ratio
    enters = any(connection.right == flange for connection in bed.connections)
    x += -_reach(bed, name) if enters else _reach(bed, name)
    flanges = bed.components[name].flange_names()
    if len(flanges) > 2 and port != flanges[0]:
        others = flanges[1:]
        y += 0.16 * (len(others) - 1) - 0.32 * others.index(port)
    return x, y


def _reach(bed: Testbed, name: str) -> float:
    component = bed.components[name]
    if component.is_machine:
        return HEIGHT
    return 0.24 if len(component.flange_names()) > 2 else HALF


def _torque_places(bed: Testbed) -> dict[str, list[str]]:
    """Return the flanges, or the component, at which the torque of each torque-controlled machine holds."""
    found: dict[str, list[str]] = {}
    for machine, place in bed.roles.torque.items():
        name, _, port = place.partition(".")
        flanges = bed.components[name].flange_names()
        if port in flanges:
            wanted = [place]
        elif port:  # a sum, such as the outputs
            wanted = [f"{name}.{flange}" for flange in flanges[1:]]
        else:
            wanted = [name]
        if connected := [flange for flange in wanted if flange == name or _connected(bed, flange)]:
            found[machine] = connected
    return found


def _connected(bed: Testbed, flange: str) -> bool:
    return any(flange in (connection.left, connection.right) for connection in bed.connections)


def _component(axes: Axes, bed: Testbed, name: str, x: float, y: float) -> None:
    component = bed.components[name]
    colour, text = GREY, component.type_name.replace("_", "\n")
    if component.is_machine:
        colour, text = (
            (ORANGE, "T") if name in bed.roles.torque else (BLUE, "n") if name in bed.roles.speed else (GREY, "M")
        )
    elif component.type_name == "gearbox":
        text = "i"
    mirrored = any(connection.right == f"{name}.{component.flange_names()[-1]}" for connection in bed.connections)
    draw_symbol(axes, component.type_name, x, y, colour=colour, text=text, mirrored=mirrored)
    axes.text(x, y + 0.36, name, ha="center", va="bottom", fontsize=9, fontweight="bold", color=INK)
    lines = _main_values(bed, name)
    axes.text(x, y - 0.34, "\n".join(lines), ha="center", va="top", fontsize=7, color=INK, linespacing=1.35)


def _main_values(bed: Testbed, name: str) -> list[str]:
    component = bed.components[name]
    whole = f"components.{name}" in bed.assumed
    lines = []
    for parameter in component.parameters(name):
        field = parameter.symbol.name.removeprefix(f"{name}_")
        if field not in _MAIN:
            continue
        mark = "*" if whole or f"components.{name}.{field}" in bed.assumed else ""
        shown = readable(parameter.value, parameter.unit, 4).replace("^2", "²")
        lines.append(f"{_PREFIXES.get(field, '')}{shown}{mark}")
    return lines


def _legend(axes: Axes, bed: Testbed, width: float) -> None:
    """Explain the colours below the drawing, which is `width` inches wide."""
    entries = []
    if bed.roles.torque:
        entries.append((ORANGE, "T  controls a torque, at ○"))
    if bed.roles.speed:
        entries.append((BLUE, "n  controls its own speed"))
    x = 0.012
    for colour, text in entries:
        axes.text(x, 0.02, f"● {text}", transform=axes.transAxes, fontsize=8, color=colour, va="bottom")
        x += 2.1 / width
    if bed.assumed:
        axes.text(0.988, 0.02, "* assumed", transform=axes.transAxes, fontsize=8, color=INK, ha="right", va="bottom")

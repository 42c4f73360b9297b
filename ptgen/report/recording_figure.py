"""A recording as stacked axes over one time: speeds, controlled torques, flange torques, commands, friction."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ptgen.elements import FrictionRole, SensorKind
from ptgen.plant.layout import identifier, signal_name
from ptgen.project import Project
from ptgen.report.curves import thinned
from ptgen.report.figures import GREY, LIGHT, PALETTE, REFERENCE, new_figure, set_headline
from ptgen.report.quantities import shown_unit
from ptgen.units import from_si

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ptgen.simulate.recording import Recording

__all__ = ["Curve", "Panel", "panels", "recording_figure"]


@dataclass(frozen=True)
class Curve:
    """A curve: a signal, what it is called, and how it is drawn.

    Attributes
    ----------
    name : str
        What the legend calls it; empty for curves that need no entry.
    values : ndarray (n,)
        In SI units.
    colour : str
    style : {"signal", "reference", "limit"}
    """

    name: str
    values: NDArray[np.float64]
    colour: str
    style: str = "signal"


@dataclass(frozen=True)
class Panel:
    """One of the stacked axes; `unit` is the SI unit of its curves."""

    title: str
    unit: str
    curves: tuple[Curve, ...]


def panels(recording: Recording, project: Project) -> tuple[Panel, ...]:
    """Sort the signals of a recording into panels; a panel without signals is left out."""
    signals = recording.signals
    machines = project.testbed.machines
    colours = {name: PALETTE[index % len(PALETTE)] for index, name in enumerate(machines)}
    references = project.design.controller.references

    speeds: list[Curve] = []
    commands: list[Curve] = []
    for machine in machines:
        colour = colours[machine]
        speeds += _reference(signals, references.get(f"speed.{machine}"))
        speeds += _signal(signals, f"{machine}_speed", machine, colour)
        commands += _limits(project, signals, machine, colour)
        commands += _signal(signals, f"{machine}_torque_ref", machine, colour)
    for pair in project.testbed.tuning.speed_pairs:
        speeds += _pair(signals, references[f"speed_mean.{pair}"], references[f"speed_difference.{pair}"])
    torques: list[Curve] = []
    for machine, place in project.testbed.roles.torque.items():
        torques += _reference(signals, references.get(f"torque.{machine}"))
        torques += _signal(signals, signal_name(place), place, colours[machine])
    sensors = [sensor for sensor in project.model.sensors if sensor.kind is SensorKind.TORQUE]
    flanges: list[Curve] = []
    slips: list[Curve] = []
    holds: list[Curve] = []
    actuations: list[Curve] = []
    for index, sensor in enumerate(sensors):
        flanges += _signal(signals, sensor.name, sensor.of, PALETTE[index % len(PALETTE)])
    # Losses slip with the speed of a machine, which is drawn already.
    frictions = [friction for friction in project.model.frictions if friction.role is not FrictionRole.LOSS]
    for index, friction in enumerate(frictions):
        name, colour = identifier(friction), PALETTE[index % len(PALETTE)]
        slips += _signal(signals, f"{name}_speed", friction.name, colour)
        holds += _signal(signals, f"{name}_torque", friction.name, colour)
        actuations += _signal(signals, f"{name}_actuation", friction.name, colour)
    all_panels = (
        Panel("speeds", "rad/s", tuple(speeds)),
        Panel("controlled torque", "N m", tuple(torques)),
        Panel("measured torques", "N m", tuple(flanges)),
        Panel("air-gap torques, commanded", "N m", tuple(commands)),
        Panel("actuations", "", tuple(actuations)),
        Panel("friction torques", "N m", tuple(holds)),
        Panel("friction velocities", "rad/s", tuple(slips)),
    )
    return tuple(panel for panel in all_panels if panel.curves)


def _signal(signals: Mapping[str, NDArray[np.float64]], key: str, name: str, colour: str) -> list[Curve]:
    return [Curve(name, signals[key], colour)] if key in signals else []


def _pair(signals: Mapping[str, NDArray[np.float64]], mean: str, difference: str) -> list[Curve]:
    """Return the two speeds that their mean and their difference ask for."""
    if mean not in signals or difference not in signals:
        return []
    halves = (0.5 * signals[difference], -0.5 * signals[difference])
    return [Curve("", signals[mean] + half, REFERENCE, "reference") for half in halves]


def _reference(signals: Mapping[str, NDArray[np.float64]], key: str | None) -> list[Curve]:
    return [Curve("", signals[key], REFERENCE, "reference")] if key is not None and key in signals else []


def _limits(project: Project, signals: Mapping[str, NDArray[np.float64]], machine: str, colour: str) -> list[Curve]:
    """Return the torque-speed envelope of a machine along the run, Figure 7.1 of the source."""
    speed = signals.get(f"{machine}_speed")
    drive = next(torque.drive for torque in project.model.inputs if torque.name == machine)
    if speed is None:
        return []
    values = project.model.values
    rated = float(values[drive.speed_rated])
    most = float(values[drive.torque_max]) * rated / np.maximum(rated, np.abs(speed))
    return [Curve("", most, colour, "limit"), Curve("", -most, colour, "limit")]


def recording_figure(recording: Recording, project: Project, title: str = "") -> Figure:
    """Draw a recording.

    Parameters
    ----------
    recording : Recording
    project : Project
        The bed that was simulated.
    title : str
        What stands above; by default the title of the bed.
    """
    drawn = panels(recording, project)
    figure = new_figure(9.0, 1.9 * len(drawn) + 1.0)
    grid = figure.subplots(max(1, len(drawn)), 1, sharex=True, squeeze=False)[:, 0]
    set_headline(figure, title or project.testbed.title)
    for axes, panel in zip(grid, drawn, strict=False):
        _draw(axes, panel, recording.time)
        for shift in recording.shifts:
            axes.axvspan(shift.start, shift.end, color=LIGHT, alpha=0.6, lw=0, zorder=0)
    for shift in recording.shifts:
        place = (shift.start, 1.0)
        grid[0].annotate(
            f"{shift.before} to {shift.to}",
            place,
            xycoords=grid[0].get_xaxis_transform(),
            xytext=(2, -9),
            textcoords="offset points",
            fontsize=7.5,
            color=GREY,
            annotation_clip=True,
        )
    grid[-1].set_xlabel("time (s)", fontsize=9)
    if len(recording.time) > 1:
        grid[-1].set_xlim(recording.time[0], recording.time[-1])
    figure.align_ylabels(list(grid))
    return figure


def _draw(axes: Axes, panel: Panel, time: NDArray[np.float64]) -> None:
    kept = [curve.values for curve in panel.curves if curve.style != "limit"]
    size = max((float(np.max(np.abs(values))) for values in kept if len(values)), default=0.0)
    unit = shown_unit(size, panel.unit)
    scale = from_si(1.0, panel.unit, unit)
    for curve in panel.curves:
        xs, ys = thinned(time, scale * curve.values)
        look = {"signal": ("-", 1.3, 1.0, 3), "reference": ((0, (4, 2)), 0.9, 0.9, 4), "limit": (":", 1.0, 0.7, 2)}
        style, width, alpha, order = look[curve.style]
        axes.plot(xs, ys, color=curve.colour, ls=style, lw=width, alpha=alpha, zorder=order)
    low, high = _range([scale * values for values in kept])
    axes.set_ylim(low, high)
    axes.set_title(panel.title, fontsize=9.5, loc="left")
    axes.set_ylabel(unit, fontsize=9)
    axes.grid(True, color=LIGHT, lw=0.6)
    axes.tick_params(labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    limits = [scale * curve.values for curve in panel.curves if curve.style == "limit"]
    _legend(axes, panel, limits_seen=any(bool(np.any((low < y) & (y < high))) for y in limits))


def _range(values: Sequence[NDArray[np.float64]]) -> tuple[float, float]:
    """Return limits around the signals; torque limits that are far away stay outside."""
    finite = np.concatenate([entry[np.isfinite(entry)] for entry in values]) if values else np.zeros(0)
    if not len(finite):
        return -1.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    margin = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
    return low - margin, high + margin


def _legend(axes: Axes, panel: Panel, *, limits_seen: bool) -> None:
    from matplotlib.lines import Line2D

    handles = [Line2D([], [], color=c.colour, lw=1.8, label=c.name) for c in panel.curves if c.name]
    styles = {curve.style for curve in panel.curves}
    if "reference" in styles:
        handles.append(Line2D([], [], color=REFERENCE, lw=0.9, ls=(0, (4, 2)), label="reference"))
    if limits_seen:
        handles.append(Line2D([], [], color=GREY, lw=1.0, ls=":", label="limit"))
    axes.legend(
        handles=handles, loc="upper left", bbox_to_anchor=(1.005, 1.0), fontsize=8, frameon=False, borderaxespad=0.0
    )

"""The closed loop as a figure: Bode diagrams with margins, poles with lines of equal damping, step responses."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ptgen.analysis.frequency import FrequencyResponse, frequency_grid, others_closed
from ptgen.loops.loop_analysis import LoopAnalysis, LoopResult
from ptgen.report.figures import BLUE, GREEN, GREY, INK, LIGHT, ORANGE, PALETTE, new_figure, set_headline

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["loop_figure"]

_RAYS = (0.1, 0.2, 0.4, 0.7)
_RPM = 60 / (2 * np.pi)
_WIDTH = 3.7


def loop_figure(found: LoopAnalysis) -> Figure:
    """Draw an analysis: a column for every loop, then the poles, then a row of step responses."""
    count = len(found.loop_machines)
    columns = count + 1
    figure = new_figure(max(_WIDTH * columns, 9.0), 8.6)
    state = f", locked: {', '.join(found.locked)}" if found.locked else ""
    stable = "" if found.is_stable else " – UNSTABLE"
    title = f"{found.title}: closed loop with the {found.controller} controller{state}{stable}"
    set_headline(figure, title)
    grid = figure.add_gridspec(4, columns, height_ratios=(1.15, 1.0, 1.0, 0.8))
    loop, steps = found.family.loop(found.chosen)
    omega = frequency_grid(loop)
    L = FrequencyResponse(loop, steps)(omega)
    results = {result.margins.machine: result for result in found.loops}
    first: tuple[Axes, Axes] | None = None
    for k, machine in enumerate(loop.machines):
        upper = figure.add_subplot(grid[0, k], sharey=first[0] if first else None)
        lower = figure.add_subplot(grid[1, k], sharex=upper, sharey=first[1] if first else None)
        first = first or (upper, lower)
        _bode(upper, lower, machine, results.get(machine), omega / (2 * np.pi), -others_closed(L, k))
        if k == 0:
            upper.set_ylabel("loop gain", fontsize=8)
            lower.set_ylabel("phase (deg)", fontsize=8)
    _poles(figure.add_subplot(grid[0:2, columns - 1]), found)
    time, responses = found.referenced.steps(_horizon(found), rows=900)
    for j, reference in enumerate(found.referenced.references):
        own = figure.add_subplot(grid[2, j])
        cross = figure.add_subplot(grid[3, j], sharex=own)
        _steps(own, cross, found, j, reference, time, responses)
    notes = figure.add_subplot(grid[2:, columns - 1])
    _legend(notes, found)
    return figure


def _bode(
    upper: Axes,
    lower: Axes,
    machine: str,
    result: LoopResult | None,
    frequency: NDArray[np.float64],
    transfer: NDArray[np.complex128],
) -> None:
    size, phase = np.abs(transfer), np.degrees(np.unwrap(np.angle(transfer)))
    phase -= 360 * np.round((phase[0] + 135) / 360)
    telling = [*result.margins.crossovers_hz, result.critical_hz] if result is not None else [frequency[-1] / 1000]
    low = max(frequency[0], 0.05 * min(telling))
    upper.loglog(frequency, size, color=BLUE, lw=1.3)
    wrapped = (phase + 180) % 360 - 180
    wrapped[1:][abs(np.diff(wrapped)) > 180] = np.nan  # no line from one edge to the other
    lower.semilogx(frequency, wrapped, color=BLUE, lw=1.3)
    upper.axhline(1.0, color=GREY, lw=0.8)
    for level in (-180, 0, 180):
        lower.axhline(level, color=GREY if level else LIGHT, lw=0.8, ls="-")
    upper.set_ylim(1e-3, 1e3)
    upper.set_xlim(low, frequency[-1])
    lower.set_ylim(-190, 190)
    lower.set_yticks([-180, -90, 0, 90, 180])
    lower.set_xlabel("Hz", fontsize=8)
    kind = f"{result.controls} loop of {machine}" if result is not None else f"loop of {machine}"
    upper.set_title(kind, fontsize=9.5, loc="left")
    if result is not None:
        margins = result.margins
        for value, at in ((margins.gain_up, margins.gain_up_hz), (margins.gain_down, margins.gain_down_hz)):
            if np.isfinite(value) and value > 0 and at > 0:
                upper.plot([at, at], [1 / value, 1.0], color=ORANGE, lw=2)
                text = f"x {value:.3g}"
                place = "top" if value > 1 else "bottom"
                _note(upper, text, at, 1 / value, (3, -2), place)
        if np.isfinite(margins.phase_deg):
            at = margins.phase_hz
            angle = float(np.interp(at, frequency, (phase + 180) % 360 - 180))
            edge = 180.0 if angle > 0 else -180.0
            lower.plot([at, at], [edge, edge - np.sign(edge) * margins.phase_deg], color=ORANGE, lw=2)
            label = f"{margins.phase_deg:.3g}°"
            _note(lower, label, at, edge, (4, -10 if edge > 0 else 4), "baseline")
        upper.axvline(result.critical_hz, color=GREEN, lw=0.9, ls=(0, (4, 2)))
        lower.axvline(result.critical_hz, color=GREEN, lw=0.9, ls=(0, (4, 2)))
    for axes in (upper, lower):
        _plain(axes)
        axes.grid(color=LIGHT, lw=0.4)
    upper.tick_params(labelbottom=False)


def _note(axes: Axes, text: str, x: float, y: float, shift: tuple[int, int], place: str) -> None:
    axes.annotate(
        text,
        (x, y),
        textcoords="offset points",
        xytext=shift,
        fontsize=7.5,
        color=ORANGE,
        va=place,
    )


def _poles(axes: Axes, found: LoopAnalysis) -> None:
    """Draw poles in the left half plane with the logarithm of the frequency as radius."""
    poles = [pole for pole in found.poles if not pole.is_neutral and pole.s.imag >= 0]
    nyquist = 0.5 / found.sample_time
    poles = [pole for pole in poles if pole.frequency_hz < nyquist]
    slowest = min((pole.frequency_hz for pole in poles), default=1.0)
    start = np.floor(np.log10(max(slowest, 1e-3))) - 0.3
    far = np.log10(nyquist) - start
    for damping in _RAYS:
        x, y = -damping * far, np.sqrt(1 - damping**2) * far
        axes.plot([0, x], [0, y], color=LIGHT, lw=0.8, zorder=1)
        axes.annotate(f"{damping:g}", (x, y), fontsize=7, color=GREY, ha="center", va="bottom")
    angle = np.linspace(np.pi / 2, np.pi, 60)
    for decade in range(int(np.ceil(start)), int(np.floor(np.log10(nyquist))) + 1):
        radius = decade - start
        axes.plot(radius * np.cos(angle), radius * np.sin(angle), color=LIGHT, lw=0.8, zorder=1)
        axes.annotate(f"{10.0**decade:g}", (-radius, 0), fontsize=7, color=GREY, ha="center", va="top",
                      xytext=(0, -3), textcoords="offset points")  # fmt: skip
    for pole in poles:
        radius = np.log10(pole.frequency_hz) - start
        x, y = -pole.damping_ratio * radius, np.sqrt(max(0.0, 1 - pole.damping_ratio**2)) * radius
        axes.plot(x, y, ls="none", marker="x", ms=6, mew=1.6, color=ORANGE if pole.is_unstable else INK, zorder=3)
    axes.axvline(0, color=GREY, lw=0.8)
    axes.axhline(0, color=GREY, lw=0.8)
    axes.set_aspect("equal")
    axes.set_xlim(-1.05 * far, 0.12 * far)
    axes.set_ylim(-0.06 * far, 1.1 * far)
    axes.set_axis_off()
    axes.set_title("poles: Hz outwards, damping ratio on the rays", fontsize=9.5, loc="left")


def _steps(
    own: Axes,
    cross: Axes,
    found: LoopAnalysis,
    j: int,
    reference: str,
    time: NDArray[np.float64],
    responses: NDArray[np.float64],
) -> None:
    is_torque = reference.startswith("torque.")
    step, unit, scale = (100.0, "N m", 1.0) if is_torque else (10.0, "rpm", _RPM)
    amount = step / scale
    names = found.referenced.references
    own.plot(time, responses[:, j, j] * step, color=BLUE, lw=1.3)
    own.axhline(step, color=GREY, lw=0.8, ls=(0, (4, 2)))
    own.set_title(f"{reference}: step of {step:g} {unit}", fontsize=9.5, loc="left")
    own.set_ylabel(unit, fontsize=8)
    others = [i for i in range(len(names)) if i != j]
    units = set()
    for number, i in enumerate(others):
        other = 1.0 if names[i].startswith("torque.") else _RPM
        name = "N m" if names[i].startswith("torque.") else "rpm"
        units.add(name)
        cross.plot(time, responses[:, i, j] * amount * other, color=PALETTE[1 + number % 5], lw=1.1,
                   label=f"{names[i]} ({name})")  # fmt: skip
    cross.set_xlabel("s", fontsize=8)
    cross.set_ylabel("others: " + ", ".join(sorted(units)), fontsize=8)
    if others:
        cross.legend(fontsize=6.5, frameon=False, loc="best")
    for axes in (own, cross):
        _plain(axes)
        axes.grid(color=LIGHT, lw=0.4)
    own.tick_params(labelbottom=False)


def _legend(axes: Axes, found: LoopAnalysis) -> None:
    """Say what the marks mean and what the margins of all machines are."""
    from ptgen.report.loop_verdict import delay_text, grade

    lines = [
        "blue: the loop, broken at the torque command",
        "orange: gain and phase margins",
        "green, dashed: where the loop is nearest to instability",
    ]
    if found.margins is not None:
        disk = found.margins.disk
        lines += [
            "",
            f"all machines at once: {grade(disk)}",
            f"  torques x {disk.gain_down:.3g} to x {disk.gain_up:.3g}, or {disk.phase_deg:.3g}° each",
            f"  common delay {delay_text(found.margins.delay.time, found.sample_time)}",
        ]
    axes.set_axis_off()
    axes.text(0.0, 0.98, "\n".join(lines), fontsize=8, va="top", color=INK, transform=axes.transAxes)


def _horizon(found: LoopAnalysis) -> float:
    """Return a duration (s) in which all but the slowest motions are over."""
    rates = [-pole.s.real for pole in found.poles if not pole.is_neutral and pole.s.real < 0]
    return float(np.clip(6 / min(rates, default=10.0), 0.1, 4.0))


def _plain(axes: Axes) -> None:
    axes.tick_params(labelsize=7.5)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)

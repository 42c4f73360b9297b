"""The analysis of the closed loop as text for the terminal."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from ptgen.analysis.limits import NearMode
from ptgen.loops.causes import HORIZON
from ptgen.loops.loop_analysis import LoopAnalysis
from ptgen.report.loop_verdict import delay_text, gain_text, mode_text, shares_text, verdict
from ptgen.report.quantities import percent, readable

__all__ = ["algebraic_sentence", "loop_text"]

_POLES = 14
"""Poles shown: the slowest and the least damped."""


def loop_text(found: LoopAnalysis) -> Iterator[RenderableType]:
    """Yield the verdict and the tables."""
    yield Text(f"{found.title}: {found.law} controller, sampled every {readable(found.sample_time, 's')}")
    for sentence in verdict(found):
        yield Text(f"  {sentence}")
    if found.loops:
        yield _heading("Loops, each broken at its torque command, all others closed")
        yield _loops(found)
        for loop in found.loops:
            yield Text(
                f"  {loop.margins.machine}: critical at {loop.critical_hz:.3g} Hz, "
                f"{mode_text(loop.mode, loop.critical_hz)}"
            )
    if found.margins is not None:
        disk = found.margins.disk
        yield _heading("All machines at once")
        yield Text(
            f"  disk margin {disk.alpha:.4g} at {disk.frequency_hz:.3g} Hz: each torque on its own "
            f"x {disk.gain_down:.3g} to x {disk.gain_up:.3g}, or {disk.phase_deg:.3g} deg"
        )
        delay = found.margins.delay
        swings = f"; it then swings at {delay.frequency_hz:.3g} Hz" if np.isfinite(delay.time) else ""
        yield Text(f"  common delay {delay_text(delay.time, found.sample_time)}{swings}")
    yield _heading("Poles")
    yield _poles(found)
    yield _heading("Loop through measured torques")
    yield Text(f"  {algebraic_sentence(found)}")
    yield _heading(f"Couplings, rms over {readable(HORIZON, 's')}")
    yield _couplings(found)
    for title, names in (("locked", found.locked), ("free", found.free)):
        if names:
            yield Text(f"{title}: {', '.join(names)}")


def algebraic_sentence(found: LoopAnalysis) -> str:
    """Return the algebraic loop in words."""
    loop = found.algebraic
    fed = {name: gain for name, gain in loop.gains.items() if abs(gain) > 1e-12}
    if loop.radius < 1e-12:
        return "None: no torque flange that the law uses reads the air-gap torque of its own machine at once."
    gains = ", ".join(f"{name} {percent(gain)}" for name, gain in fed.items())
    if loop.is_stable:
        return (
            f"Torque that a flange reads back at once: {gains}; spectral radius {loop.radius:.3g}, below 1: from "
            f"step to step it dies away, to 1 % in {np.ceil(loop.settling_steps):.0f} steps."
        )
    return (
        f"Torque that a flange reads back at once: {gains}; spectral radius {loop.radius:.3g}, not below 1: the "
        f"compensation builds up from step to step; reduce load_compensation."
    )


def _heading(text: str) -> Text:
    return Text(f"\n{text}\n{'=' * len(text)}")


def _loops(found: LoopAnalysis) -> Table:
    table = Table("machine", "loop", "gain", "phase", "at", "delay", "swings at", "gain one at", box=box.SIMPLE_HEAD)
    for column in table.columns[3:7]:
        column.justify = "right"
    for loop in found.loops:
        margins = loop.margins
        finite = np.isfinite(margins.phase_deg)
        table.add_row(
            margins.machine,
            loop.controls,
            gain_text(margins.gain_up, margins.gain_down),
            f"{margins.phase_deg:.3g} deg" if finite else "any",
            f"{margins.phase_hz:.3g} Hz" if finite else "",
            delay_text(margins.delay.time, found.sample_time),
            f"{margins.delay.frequency_hz:.3g} Hz" if np.isfinite(margins.delay.time) else "",
            ", ".join(f"{f:.3g}" for f in margins.crossovers_hz) + (" Hz" if margins.crossovers_hz else "never"),
        )
    return table


def _poles(found: LoopAnalysis) -> Table:
    table = Table("frequency", "damping", "decays in", "near", box=box.SIMPLE_HEAD)
    for column in table.columns[:3]:
        column.justify = "right"
    upper = [(k, pole) for k, pole in enumerate(found.poles) if pole.s.imag >= 0]
    weak = sorted(upper, key=lambda item: item[1].damping_ratio)[: _POLES // 2]
    slow = [item for item in upper if item not in weak][: _POLES - len(weak)]
    for k, pole in sorted(weak + slow, key=lambda item: item[1].frequency_hz):
        mode = found.pole_modes.get(k)
        if pole.is_neutral:
            table.add_row("0 Hz", "", "", "a part that coasts")
            continue
        decay = readable(-1 / pole.s.real, "s", 3) if pole.s.real < 0 else "grows"
        near = "" if mode is None else f"{_mode_name(mode)}: {shares_text(mode)}"
        table.add_row(f"{pole.frequency_hz:.4g} Hz", percent(pole.damping_ratio), decay, near)
    if len(upper) > _POLES:
        table.add_row("", "", "", f"and {len(upper) - len(weak) - len(slow)} more, faster and better damped")
    return table


def _mode_name(mode: NearMode) -> str:
    held = f", {', '.join(mode.held)} held" if mode.held else ""
    return f"{mode.frequency_hz:.4g} Hz{held}"


def _couplings(found: LoopAnalysis) -> Table:
    kinds = [
        ("torque", "speed", "N m per rad/s^2"),
        ("speed", "torque", "rad/s per N m"),
        ("torque", "torque", "N m per N m"),
        ("speed", "speed", "rad/s per rad/s^2"),
    ]
    shown = [kind for kind in kinds if found.causes[0].coupling.worst(*kind[:2]) is not None]
    names = {
        ("torque", "speed"): "torque, during a ramp of a speed",
        ("speed", "torque"): "speed, after a step of a torque",
        ("torque", "torque"): "torque, after a step of another",
        ("speed", "speed"): "speed, during a ramp of another",
    }
    table = Table("what is in it", *(f"{names[kind[:2]]} ({kind[2]})" for kind in shown), box=box.SIMPLE_HEAD)
    for column in table.columns[1:]:
        column.justify = "right"
    for cause in found.causes:
        cells = []
        for kind in shown:
            worst = cause.coupling.worst(*kind[:2])
            cells.append("" if worst is None else f"{worst[0]:.2g}" if worst[0] > 1e-9 else "0")
        table.add_row(cause.description, *cells)
    return table

"""The analysis of the closed loop as plain data: what ``ptgen analyse --json`` prints, in SI units and Hz."""

from __future__ import annotations

from typing import Any

from ptgen.analysis.coupling import Coupling
from ptgen.analysis.limits import NearMode
from ptgen.analysis.margins import Delay
from ptgen.loops.causes import HORIZON
from ptgen.loops.loop_analysis import LoopAnalysis, LoopResult, Margins
from ptgen.report.loop_verdict import verdict

__all__ = ["loop_json", "mode_json"]


def loop_json(found: LoopAnalysis) -> dict[str, Any]:
    """Return an analysis as plain data; numbers that are not finite stand for "never" or "any"."""
    return {
        "name": found.name,
        "title": found.title,
        "controller": found.controller,
        "structure": found.structure,
        "experimental": list(found.experimental),
        "locked": list(found.locked),
        "free": list(found.free),
        "parameters": dict(found.parameters),
        "sample_time": found.sample_time,
        "stable": found.is_stable,
        "verdict": list(verdict(found)),
        "continuous": None if found.continuous is None else found.continuous.verdict.name.lower(),
        "loops": [_loop(loop) for loop in found.loops],
        "margins": _margins(found.margins),
        "disk_mode": mode_json(found.disk_mode),
        "delay_mode": mode_json(found.delay_mode),
        "poles": [
            {
                "re": pole.s.real,
                "im": pole.s.imag,
                "frequency_hz": pole.frequency_hz,
                "damping_ratio": pole.damping_ratio,
                "neutral": pole.is_neutral,
                "unstable": pole.is_unstable,
                "mode": mode_json(found.pole_modes.get(k)),
            }
            for k, pole in enumerate(found.poles)
        ],
        "levers": [{"wish": x.wish, "factor": x.factor, "margins": _margins(x.margins)} for x in found.levers],
        "algebraic_loop": {
            "machines": list(found.algebraic.machines),
            "matrix": found.algebraic.matrix.tolist(),
            "spectral_radius": found.algebraic.radius,
            "gains": found.algebraic.gains,
            "stable": found.algebraic.is_stable,
        },
        "coupling": {
            "horizon": HORIZON,
            "causes": [
                {"cause": cause.name, "description": cause.description, "rms": _coupling(cause.coupling)}
                for cause in found.causes
            ],
        },
    }


def _loop(loop: LoopResult) -> dict[str, Any]:
    margins = loop.margins
    return {
        "machine": margins.machine,
        "controls": loop.controls,
        "gain_up": margins.gain_up,
        "gain_up_hz": margins.gain_up_hz,
        "gain_down": margins.gain_down,
        "gain_down_hz": margins.gain_down_hz,
        "phase_deg": margins.phase_deg,
        "phase_is_lag": margins.phase_is_lag,
        "phase_hz": margins.phase_hz,
        "delay": _delay(margins.delay),
        "crossovers_hz": list(margins.crossovers_hz),
        "critical_hz": loop.critical_hz,
        "mode": mode_json(loop.mode),
        "phase_budget_deg": dict(loop.budget.degrees),
    }


def _delay(delay: Delay) -> dict[str, float]:
    return {"time": delay.time, "frequency_hz": delay.frequency_hz}


def _margins(margins: Margins | None) -> dict[str, Any] | None:
    if margins is None:
        return None
    disk = margins.disk
    return {
        "disk": {
            "alpha": disk.alpha,
            "frequency_hz": disk.frequency_hz,
            "gain_down": disk.gain_down,
            "gain_up": disk.gain_up,
            "phase_deg": disk.phase_deg,
        },
        "common_delay": _delay(margins.delay),
    }


def mode_json(mode: NearMode | None) -> dict[str, Any] | None:
    """Return a mode as plain data."""
    if mode is None:
        return None
    return {
        "number": mode.number,
        "held": list(mode.held),
        "frequency_hz": mode.frequency_hz,
        "damping_ratio": mode.damping_ratio,
        "strained": mode.strained,
        "strain_share": mode.strain_share,
        "moving": mode.moving,
        "kinetic_share": mode.kinetic_share,
    }


def _coupling(coupling: Coupling) -> dict[str, dict[str, float]]:
    """Return the error of every quantity, by the reference that moves and then by the one that is disturbed."""
    names = coupling.references
    return {
        moved: {of: float(coupling.rms[i, j]) for i, of in enumerate(names) if i != j} for j, moved in enumerate(names)
    }

"""Supervision of the controller: only sound inputs are used, and after a fault the torques go to zero."""

from __future__ import annotations

import sympy as sp

from ptgen.block.block import Call, Signal
from ptgen.control.plausibility import plausible_speed, plausible_torque
from ptgen.control.writer import ControllerWriter, signal_symbol
from ptgen.plant.layout import signal_name

__all__ = ["release", "supervise"]


def supervise(w: ControllerWriter, names: list[str]) -> dict[str, sp.Symbol]:
    """Return the supervised value of each input by name, and latch the first fault."""
    fault = w.state("fault", "", "0, or the number of the input that failed")
    sound = []
    result = {}
    for number, name in enumerate(names, start=1):
        unit = "rad/s" if "_speed" in name else "N m"
        text = "reference" if name.endswith("_ref") else "measured"
        w.inputs[name] = Signal(name, unit, text)
        bound = w.parameter(f"{name}_plausible", unit, f"largest plausible {name}", _plausible(w, name), allowed=False)
        w.state(f"{name}_held", unit, f"last sound value of {name}")
        w.statements.append(
            Call("guard", (f"{name}_held", f"{name}_sound"), (name, bound.name, f"{name}_held"), "supervision")
        )
        sound.append((number, signal_symbol(f"{name}_sound")))
        result[name] = signal_symbol(f"{name}_held")
    for number, flag in sound:
        unseen = sp.And(fault < sp.Rational(1, 2), flag < sp.Rational(1, 2))
        w.assign("fault", sp.Piecewise((sp.Integer(number), unseen), (fault, True)), "the first fault is latched")
    return result


def _plausible(w: ControllerWriter, name: str) -> float:
    if name in w.plausible:
        return w.plausible[name]
    for machine in w.design.machines:
        if name in (f"{machine}_speed_ref", f"{machine}_speed"):
            return plausible_speed(w.full, machine)
    signals = {
        **{signal_name(place) + "_ref": form for place, form in w.full.signals.items()},
        **w.full.signals,
    }
    return plausible_torque(w.full, signals[name])


def release(w: ControllerWriter, commands: dict[int, sp.Symbol], h: sp.Symbol) -> tuple[Signal, ...]:
    """Return the outputs: the commands, or after a fault the last ones on their way to zero.

    A command that is not finite, or beyond the machine's torque, is a fault as well: parameters that overflow, or
    that were changed without being checked, do not reach the machine either.
    """
    fault = signal_symbol("fault")
    outputs = []
    for machine, name in enumerate(w.design.machines):
        w.state(f"{name}_last", "N m", f"last torque of {name} before a fault")
        largest = sp.Float("1.01") * signal_symbol(f"{name}_torque_max")  # a limited command may exceed it by rounding
        w.assign(f"{name}_largest", largest)
        w.statements.append(
            Call(
                "guard",
                (f"{name}_released", f"{name}_released_sound"),
                (commands[machine].name, f"{name}_largest", f"{name}_last"),
                "only sound torques leave",
            )
        )
        outputs.append(Signal(f"{name}_torque_ref", "N m", f"air-gap torque reference of {name}"))
    for number, signal in enumerate(outputs, start=len(w.inputs) + 1):
        sound = signal_symbol(f"{signal.name.removesuffix('_torque_ref')}_released_sound")
        unseen = sp.And(fault < sp.Rational(1, 2), sound < sp.Rational(1, 2))
        w.assign("fault", sp.Piecewise((sp.Integer(number), unseen), (fault, True)), "the first fault is latched")
    authority = w.state("authority", "", "1, going to 0 along the ramp after a fault", 1.0)
    failed = fault > sp.Rational(1, 2)
    ramped = sp.Max(0, authority - h / signal_symbol("fault_ramp"))
    w.assign("authority", sp.Piecewise((ramped, failed), (authority, True)), "ramp to zero torque")
    for name in w.design.machines:
        last, released = signal_symbol(f"{name}_last"), signal_symbol(f"{name}_released")
        w.assign(last.name, sp.Piecewise((last, failed), (released, True)))
        w.assign(f"{name}_torque_ref", last * authority)
    return tuple(outputs)

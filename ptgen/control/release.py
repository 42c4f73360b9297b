"""What leaves the controller: sound torques within the machines' limits, or after a fault their ramp to zero."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ptgen.block.block import Fault, Signal
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of

__all__ = ["release"]

HALF = sp.Rational(1, 2)


CALM_TIME = sp.Rational(1, 50)
"""Time (s) over which torques are smoothed; monitors find faults within a fraction of it or show up slowly."""

FIRST_LATE_FAULT = 3000
"""Faults from this status on are found by monitors, some time after they began."""


def release(w: ControllerWriter, commands: dict[int, sp.Symbol], h: sp.Symbol) -> tuple[Signal, ...]:
    """Return the outputs: the commands, or after a fault the last ones on their way to zero.

    A command that is not finite, or beyond the machine's torque, is a fault as well: parameters that overflow, or
    that were changed without being checked, do not reach the machine either. No output exceeds the torque of the
    machine in the test bed file, whatever the parameters; ``<M>_torque_max`` can only be less.

    After a fault of an input the last sound torques are held; after one that monitors found, which takes time, those of
    before, smoothed over `CALM_TIME`. After a reset the torques return along the ramp.
    """
    causes, outputs, ratings = [], [], {}
    for machine, name in enumerate(w.design.machines):
        rating = ratings[name] = _rating(w, machine)
        w.state(f"{name}_last", "N m", f"last torque of {name} before a fault", monitor=True)
        largest = sp.Float("1.01") * smallest_of(signal_symbol(f"{name}_torque_max"), rating)  # room for rounding
        w.derive(f"{name}_largest", "N m", f"torque of {name} that is a fault", largest)
        w.call(
            "guard",
            (f"{name}_released", f"{name}_released_sound"),
            (commands[machine].name, f"{name}_largest", f"{name}_last"),
            "only sound torques leave",
        )
        output = Signal(f"{name}_torque_ref", "N m", f"air-gap torque reference of {name}")
        fault = Fault(
            7001 + machine,
            f"fault_{output.name}",
            f"{output.name}: the command is not finite, or beyond the torque of the machine",
        )
        causes.append((fault, signal_symbol(f"{name}_released_sound") > HALF))
        outputs.append(output)
    w.latch(causes, "cause_of_commands", "the first fault is latched")
    fault = signal_symbol("fault")
    failed = fault > HALF
    # The ramp goes down after a fault, and up otherwise; NaN gives zero.
    slope = w.derive("ramp_step", "", "change of the released share per step", h / signal_symbol("fault_ramp"))
    authority = signal_symbol("authority")
    w.assign("authority_wanted", authority + sp.Piecewise((-slope, failed), (slope, True)), "ramp of the torques")
    w.call("share", (authority.name,), ("authority_wanted",), "ramp of the torques")
    w.assign("running", sp.Piecewise((sp.Integer(0), failed), (1, True)), "ramp of the torques")
    for name in w.design.machines:
        released = signal_symbol(f"{name}_released")
        w.assign(f"{name}_last", released, "ramp of the torques", condition=fault <= HALF)
        _remember(w, name, h)
    for name, rating in ratings.items():
        applied = signal_symbol(f"{name}_last") * authority
        w.assign(f"{name}_torque_ref", greatest_of(-rating, smallest_of(rating, applied)))
    return tuple(outputs)


def _remember(w: ControllerWriter, name: str, h: sp.Symbol) -> None:
    """Go on, after a fault that took time to be found, with the torque of before: the last ones may be its work."""
    fault = signal_symbol("fault")
    calm = w.state(f"{name}_calm", "N m", f"smoothed torque of {name}, that of before a fault", monitor=True)
    share = w.derive("calm_share", "", "share of a new torque in the smoothed ones", h / (h + CALM_TIME))
    w.assign(f"{name}_calmer", calm + share * (signal_symbol(f"{name}_last") - calm), "the torque of before")
    w.call(
        "guard",
        (calm.name, f"{name}_calm_sound"),
        (f"{name}_calmer", f"{name}_largest", calm.name),
        "the torque of before",
    )
    w.assign(f"{name}_last", calm, "the torque of before", condition=fault > FIRST_LATE_FAULT - HALF)


def _rating(w: ControllerWriter, machine: int) -> sp.Float:
    """Return the torque of the machine in the test bed file, and let the parameter not exceed it."""
    name = w.design.machines[machine]
    parameter = w.parameters[f"{name}_torque_max"]
    w.parameters[parameter.name] = replace(parameter, most=parameter.value)
    return sp.Float(parameter.value, 17)

"""Supervision of the controller's inputs: only sound values are used; the first fault is latched, and reset on request.

Statuses of the controller, by the number k of the input or output, counted from 1:

====== ==========================================================================================
k      input k was not finite, or larger than plausible, for longer than ``hold_time``
3000+k input k is frozen, see `ptgen.control.watching`
4000+k input k, a speed, is beyond ``<M>_overspeed``
5000+k input k, a speed, disagrees with the torques that act on its rotor
6000+k input k, a torque, oscillates
7000+k the command of output k was not finite, or beyond the torque of its machine
8000+k the command of output k oscillates
====== ==========================================================================================

Numbers from 1000 to 2999 are those of every block: failed preparation, refused parameters.
"""

from __future__ import annotations

import sympy as sp
from sympy.logic.boolalg import And, Boolean

from ptgen.block.block import Fault, Signal
from ptgen.control.plausibility import overspeed, plausible
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol

__all__ = ["supervise"]

HALF = sp.Rational(1, 2)

NEVER_SOUND = 1e30
"""For how long an input was bad that has never been sound (s): there is no value to bridge it with."""


def supervise(w: ControllerWriter, names: list[str], h: sp.Symbol) -> dict[str, sp.Symbol]:
    """Return the supervised value of each input by name, and latch the first fault.

    Parameters
    ----------
    w : ControllerWriter
    names : list of str
        Inputs in their order: references, then measured signals.
    h : Symbol
        Step of the controller.
    """
    hold_time = w.parameter(
        "hold_time", "s", "bad samples are bridged for that long, and no longer", w.tuning.hold_time
    )
    w.derive("bridged_time", "s", "for how long bad samples are bridged, with room for rounding", hold_time + HALF * h)
    w.state("fault", "", "0, or the status of the first fault", monitor=True)
    w.state("authority", "", "share of the torques that is released; goes along the ramp", 1.0, monitor=True)
    w.state("running", "", "1 if the last step ran without a fault, 0 before and after", monitor=True)
    w.state("refused", "", "1 while the parameters of the last update are refused", monitor=True)
    causes, sound, measured = [], [], {}
    for number, name in enumerate(names, start=1):
        cause, flag = _bridge(w, name, number, h)
        causes.append(cause)
        sound.append(flag)
        measured[name] = signal_symbol(f"{name}_held")
    for machine, name in enumerate(w.design.machines):
        sensor = w.speed_sensor(machine)
        if sensor in measured:
            cause, flag = _limit_speed(w, name, sensor, names.index(sensor) + 1, h)
            causes.append(cause)
            sound.append(flag)
    _reset(w, sound)
    w.latch(causes, "cause_of_inputs", "the first fault is latched")
    return measured


def _bridge(w: ControllerWriter, name: str, number: int, h: sp.Symbol) -> tuple[tuple[Fault, Boolean], Boolean]:
    """Hold the last sound value of an input; return what it says of a fault, and whether this sample is sound."""
    unit = "rad/s" if "_speed" in name else "" if name in w.plausible else "N m"
    text = "reference" if name.endswith("_ref") else "measured"
    bound = w.plausible[name] if name in w.plausible else plausible(w.full, w.design.machines, name)
    at_rest = {parameter.symbol.name: parameter.value for parameter in w.design.model.changing}
    w.inputs[name] = Signal(name, unit, text, value=at_rest.get(name, 0.0))
    largest = w.parameter(f"{name}_plausible", unit, f"largest plausible {name}", bound, allowed=False)
    held = w.state(f"{name}_held", unit, f"last sound value of {name}")
    time = w.state(f"{name}_bad_time", "s", f"for how long {name} was bad", NEVER_SOUND, monitor=True)
    flag = signal_symbol(f"{name}_sound")
    w.call("guard", (held.name, flag.name), (name, largest, held), "supervision: bad samples are bridged")
    w.call("lasting", (time.name,), (flag, time, h, "hold_time"))
    fault = Fault(number, f"fault_{name}", f"{name}: not finite or not plausible")
    return (fault, time <= signal_symbol("bridged_time")), sp.Abs(signal_symbol(name)) <= largest


def _limit_speed(
    w: ControllerWriter, machine: str, sensor: str, number: int, h: sp.Symbol
) -> tuple[tuple[Fault, Boolean], Boolean]:
    limit = w.parameter(
        f"{machine}_overspeed",
        "rad/s",
        f"speed of {machine} that is a fault",
        overspeed(w.full, machine),
        allowed=False,
    )
    time = w.state(f"{machine}_overspeed_time", "s", f"for how long {machine} was too fast", monitor=True)
    speed = signal_symbol(f"{sensor}_held")
    flag = w.assign(
        f"{machine}_slow_enough", sp.Piecewise((sp.Integer(1), sp.Abs(speed) <= limit), (0, True)), "overspeed"
    )
    w.call("lasting", (time.name,), (flag, time, h, "hold_time"))
    fault = Fault(4000 + number, f"fault_{sensor}_overspeed", f"{sensor}: overspeed")
    return (fault, time <= signal_symbol("bridged_time")), sp.Abs(speed) <= limit


def _reset(w: ControllerWriter, sound: list[Boolean]) -> None:
    """Take back the latched fault on request: rising edge of `reset`, all inputs sound, and no torque any more.

    A request that comes while the torques are still on their way to zero waits for that.
    """
    w.inputs["reset"] = Signal("reset", "", "0 or 1; its rising edge takes back a fault whose cause is gone")
    before = w.state("reset_before", "", "reset in the step before", 1.0, monitor=True)
    request = w.state("reset_request", "", "1 while a reset waits for zero torque", monitor=True)
    fault, refused = signal_symbol("fault"), signal_symbol("refused")
    text = "reset on request, when the cause is gone"
    # false for NaN and infinity
    pressed = sp.Piecewise((sp.Integer(1), sp.Abs(signal_symbol("reset") - 1) <= HALF), (0, True))
    pressed = w.assign("reset_pressed", pressed, text)
    asked = greatest_of(pressed - before, request) * (1 - refused)
    zero = sp.Integer(0)
    asked = sp.Piecewise((asked, And(*sound)), (zero, True))
    wanted = sp.Piecewise((asked, fault > HALF), (zero, True), evaluate=False)
    w.assign(request.name, wanted, text)
    w.assign(before.name, pressed, text)
    accepted = sp.Piecewise((request, signal_symbol("authority") <= 0), (0, True))
    w.assign(fault.name, fault * (1 - accepted), text)
    w.assign(request.name, sp.Piecewise((request, fault > HALF), (0, True)), text)

r"""Signals that are plausible and yet wrong: frozen, in disagreement with each other, oscillating.

Where sensors give the torque on a rotor (`ptgen.control.measured_law.Law`), its speed is known twice: measured, and
integrated from the torques. The integral forgets with the leak :math:`\lambda`,

.. math::
    I_m \dot{\hat\omega} = s\,u + \sigma^T y + \lambda I_m (\omega - \hat\omega),

so an error :math:`\Delta T` of the torques that stays leads to the difference
:math:`\omega - \hat\omega = \Delta T / (\lambda I_m)`, and an error of the speed shows at once and is forgotten in
:math:`1 / \lambda`. The monitors of a machine rest on this difference:

* *disagreement*: it is beyond ``<M>_disagreement_limit`` for longer than ``hold_time``;
* *frozen speed*: it is beyond ``<M>_frozen_limit``, and the speed has been the same to the last bit for longer than
  ``frozen_time``;
* *frozen torque*: the same of a sensor in the balance, while the command to the machine has moved.

A signal that is constant because nothing moves does not make the difference, so references, a bed at rest and
quantised sensors do not trip.

*Oscillation* is watched on every torque sensor and on the command of every machine: half swings of the high-passed
torque beyond ``<signal>_oscillation_limit`` are counted, and forgotten at one per period of ``oscillation_frequency``.
The sixth trips. A step or a ramp makes one or two; an unstable loop that drives a machine from limit to limit goes on.
"""

from __future__ import annotations

import sympy as sp
from sympy.logic.boolalg import Boolean, Or

from ptgen.block.block import Fault
from ptgen.control.measured_law import Balance
from ptgen.control.plausibility import disagreement_limit, first_frequency, oscillation_limit
from ptgen.control.writer import ControllerWriter, signal_symbol
from ptgen.elements import SensorKind

__all__ = ["watch"]

LEAK = 5.0
FROZEN_SHARE = 0.25
MOVED_SHARE = 0.05
SWINGS = 6.0
COMMAND_SHARE = 0.5


def watch(w: ControllerWriter, names: list[str], measured: dict[str, sp.Symbol], h: sp.Symbol) -> None:
    """Write the monitors, and latch the first fault that they find.

    Parameters
    ----------
    w : ControllerWriter
    names : list of str
        The supervised inputs in their order.
    measured : dict of str to Symbol
        Their values.
    h : Symbol
        Step of the controller.
    """
    causes: list[tuple[Fault, Boolean]] = []
    for name in w.design.machines:
        applied = signal_symbol(f"{name}_last") * signal_symbol("authority")
        w.assign(f"{name}_applied", applied, "torque commands of the step before")
    beside: dict[str, str] = {}
    unknown = {p.symbol for p in w.design.model.changing if p.symbol.name not in w.run_time}
    for machine, balance in enumerate(w.design.law.balance):
        needed = [] if balance is None else [name for k, name in enumerate(w.design.sensors) if balance.sensors[k] != 0]
        if balance is None or not {w.speed_sensor(machine), *needed} <= measured.keys():
            continue
        if (set(balance.sensors.free_symbols) | balance.share.free_symbols) & unknown:
            continue
        difference = _difference(w, machine, balance, measured, h)
        causes += _speed(w, machine, difference, names, measured, h)
        for name in needed:
            if _kind(w, name) is SensorKind.TORQUE and name not in beside:
                beside[name] = w.design.machines[machine]
                causes.append(_frozen_torque(w, machine, name, difference, names, measured, h))
    frequency = w.parameter(
        "oscillation_frequency",
        "Hz",
        "slowest oscillation of a torque that is watched",
        float(f"{0.5 * first_frequency(w.full):.3g}"),
    )
    w.derive("forgotten_swings", "", "half swings that are forgotten per step", h * frequency)
    w.derive("mean_share", "", "share of a step in the mean of a torque", sp.Float(6.2832) * h * frequency)
    for number, name in enumerate(names, start=1):
        if name in w.design.sensors and _kind(w, name) is SensorKind.TORQUE:
            limit = oscillation_limit(w.full, w.full.signals[name], beside.get(name))
            fault = Fault(6000 + number, f"fault_{name}_oscillation", f"{name}: oscillates beyond its limit")
            causes.append(_oscillation(w, fault, name, measured[name], measured[name], limit))
    for machine, name in enumerate(w.design.machines):
        output = f"{name}_torque_ref"
        fault = Fault(8001 + machine, f"fault_{output}_oscillation", f"{output}: the command oscillates")
        limit = COMMAND_SHARE * w.full.values[w.full.inputs[machine].drive.torque_max]
        causes.append(_oscillation(w, fault, output, _applied(w, machine), sp.Integer(0), limit))
    w.latch(causes, "cause_of_watching", "the first fault is latched")


def _kind(w: ControllerWriter, sensor: str) -> SensorKind:
    return next(s.kind for s in w.design.model.sensors if s.name == sensor)


def _applied(w: ControllerWriter, machine: int) -> sp.Symbol:
    """Return the torque command of the step before."""
    return signal_symbol(f"{w.design.machines[machine]}_applied")


def _difference(
    w: ControllerWriter, machine: int, balance: Balance, measured: dict[str, sp.Symbol], h: sp.Symbol
) -> sp.Symbol:
    """Return the size of the difference between measured and integrated speed of a machine."""
    name, speed = w.design.machines[machine], measured[w.speed_sensor(machine)]
    leak = w.parameter("disagreement_leak", "1/s", "rate at which the integrated speeds forget", LEAK)
    forget = w.derive("disagreement_share", "", "share of the difference that is forgotten per step", h * leak)
    gain = w.derive(
        f"{name}_per_step", "rad/s/(N m)", f"change of speed of {name} per torque in a step", h / w.rotor(name)
    )
    integrated = w.state(f"{name}_integrated", "rad/s", f"speed of {name} from the torques", monitor=True)
    share = w.coefficient(f"{name}_balance_share", f"share of the torque of {name} on its rotor", balance.share)
    text = "speed from the torques on the rotor"
    torque = share * _applied(w, machine) + w.sensor_sum(f"{name}_balance", balance.sensors, measured)
    before = w.assign(f"{name}_integrated_before", w.previous(integrated, speed), text)
    w.assign(integrated.name, before + gain * torque + forget * (speed - before))
    return w.assign(f"{name}_difference", sp.Abs(speed - integrated))


def _speed(
    w: ControllerWriter,
    machine: int,
    difference: sp.Symbol,
    names: list[str],
    measured: dict[str, sp.Symbol],
    h: sp.Symbol,
) -> list[tuple[Fault, Boolean]]:
    """Watch a speed: frozen, or in disagreement with the torques."""
    name, sensor = w.design.machines[machine], w.speed_sensor(machine)
    number = names.index(sensor) + 1
    value = disagreement_limit(w.full, name, LEAK)
    limit = w.parameter(
        f"{name}_disagreement_limit",
        "rad/s",
        f"largest difference between measured and integrated speed of {name}",
        value,
        allowed=False,
    )
    frozen_limit = w.parameter(
        f"{name}_frozen_limit",
        "rad/s",
        f"the same while a signal of {name} stays the same to the last bit",
        float(f"{FROZEN_SHARE * value:.3g}"),
        allowed=False,
    )
    frozen_time = w.parameter("frozen_time", "s", "for how long a frozen signal stays the same", w.tuning.frozen_time)
    time = w.state(f"{name}_disagreement_time", "s", f"for how long the speed of {name} disagreed", monitor=True)
    agrees = w.assign(
        f"{name}_agrees", sp.Piecewise((sp.Integer(1), difference <= limit), (0, True)), "speed against torques"
    )
    w.call("lasting", (time.name,), (agrees, time, h, "hold_time"), "speed against torques")
    still = _still(w, sensor, measured[sensor], h)
    frozen = Fault(
        3000 + number, f"fault_{sensor}_frozen", f"{sensor}: frozen while the torques accelerate the machine"
    )
    apart = Fault(5000 + number, f"fault_{sensor}_disagreement", f"{sensor}: disagrees with the integrated torque")
    return [
        (frozen, Or(still <= frozen_time, difference <= frozen_limit)),
        (apart, time <= signal_symbol("bridged_time")),
    ]


def _still(w: ControllerWriter, sensor: str, value: sp.Symbol, h: sp.Symbol) -> sp.Symbol:
    """Return for how long a signal has been the same to the last bit."""
    before = w.state(f"{sensor}_before", w.inputs[sensor].unit, f"{sensor} in the step before", monitor=True)
    time = w.state(f"{sensor}_still_time", "s", f"for how long {sensor} has been the same", monitor=True)
    w.call("still", (time.name,), (value, before, w.previous(time, sp.Integer(0)), h), f"{sensor} to the last bit")
    w.assign(before.name, value, f"{sensor} to the last bit")
    return time


def _frozen_torque(
    w: ControllerWriter,
    machine: int,
    sensor: str,
    difference: sp.Symbol,
    names: list[str],
    measured: dict[str, sp.Symbol],
    h: sp.Symbol,
) -> tuple[Fault, Boolean]:
    name, number = w.design.machines[machine], names.index(sensor) + 1
    still = _still(w, sensor, measured[sensor], h)
    command = w.state(f"{sensor}_command", "N m", f"command to {name} when {sensor} last changed", monitor=True)
    applied = _applied(w, machine)
    w.assign(command.name, sp.Piecewise((command, still > 0), (applied, True)), f"{sensor} to the last bit")
    least = w.derive(
        f"{name}_moved_torque",
        "N m",
        f"change of the command to {name} that a torque must follow",
        sp.Float(MOVED_SHARE) * signal_symbol(f"{name}_torque_max"),
    )
    fault = Fault(3000 + number, f"fault_{sensor}_frozen", f"{sensor}: frozen while the torque of the machine changes")
    changes, agrees = still <= signal_symbol("frozen_time"), difference <= signal_symbol(f"{name}_frozen_limit")
    return fault, Or(changes, agrees, sp.Abs(applied - command) <= least)


def _oscillation(
    w: ControllerWriter, fault: Fault, name: str, torque: sp.Symbol, start: sp.Expr, amplitude: float
) -> tuple[Fault, Boolean]:
    limit = w.parameter(
        f"{name}_oscillation_limit", "N m", f"amplitude with which {name} may oscillate", amplitude, allowed=False
    )
    mean = w.state(f"{name}_mean", "N m", f"{name} without its oscillation", monitor=True)
    side = w.state(f"{name}_side", "", f"side on which {name} last was beyond the limit", monitor=True)
    count = w.state(f"{name}_swings", "", f"half swings of {name}, forgotten in time", monitor=True)
    before = w.assign(f"{name}_mean_before", w.previous(mean, start), f"oscillation of {name}")
    swing = w.assign(f"{name}_swing", torque - before)
    w.assign(mean.name, before + signal_symbol("mean_share") * swing)
    counted = w.previous(count, sp.Integer(0))
    w.call("swings", (side.name, count.name), (swing, limit, side, counted, "forgotten_swings"))
    return fault, count <= sp.Float(SWINGS - 0.5)

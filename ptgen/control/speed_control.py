"""Speed control of a machine: the controller that was chosen, load torque compensation, limits, net torque."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import sympy as sp

from ptgen.control.envelope import Envelope
from ptgen.control.observer_control import observer_control
from ptgen.control.pi_control import pi_control
from ptgen.control.speed_law import SpeedLaw
from ptgen.control.super_twisting import super_twisting
from ptgen.control.switches import Switch
from ptgen.control.writer import ControllerWriter
from ptgen.testbed.feedback import SpeedControlName

__all__ = ["SPEED_CONTROLS", "SpeedCommand", "speed_control"]

SPEED_CONTROLS: Mapping[SpeedControlName, Callable[[ControllerWriter, str, sp.Expr, sp.Expr, sp.Expr], SpeedLaw]] = {
    "pi": pi_control,
    "observer": observer_control,
    "super_twisting": super_twisting,
}
"""What begins each kind of speed control."""


@dataclass(frozen=True)
class SpeedCommand:
    """Torque command of a speed-controlled machine, and the net torque on its rotor that follows from it (N m)."""

    command: sp.Symbol
    net: sp.Expr


def speed_control(
    w: ControllerWriter,
    machine: int,
    position: int,
    switch: Switch,
    compensation: sp.Expr,
    envelope: Envelope,
    reference: sp.Expr,
    measured: Mapping[str, sp.Symbol],
) -> SpeedCommand:
    r"""Write the speed control of a machine (5.84), (5.92), (5.52), (5.74).

    The net torque on the rotor, :math:`I_m \dot\omega_m`, is what the acceleration torque of the torque-controlled
    machines is computed from. It is known from command and sensors whatever the load torque compensation is set to:
    with the switch at zero it is not what the controller asks for, but that less the load.

    Parameters
    ----------
    w : ControllerWriter
    machine, position : int
        The machine among the machines, and its output among the outputs.
    switch : Switch
        Of the load torque compensation.
    compensation : Expr
        The whole of it (N m).
    envelope : Envelope
    reference : Expr
        Speed reference (rad/s).
    measured : mapping
    """
    name, law = w.design.machines[machine], w.design.law
    gain = w.gains.speed[name]
    w.parameter(f"{name}_speed_gain", "N m s/rad", f"proportional gain of the speed of {name}", gain, allowed=False)
    share = w.coefficient(
        f"{name}_share", f"share of its virtual input in the torque of {name}", law.P[machine, position]
    )
    inverse = w.coefficient(f"{name}_per_torque", "virtual input per torque", 1 / law.P[machine, position])
    speed = measured[w.speed_sensor(machine)]
    error = w.assign(f"{name}_speed_error", reference - speed)
    full = w.assign(f"{name}_compensation", compensation, "load torque compensation (5.52), (5.74)")
    given = w.assign(
        f"{name}_given_away", (switch.before - switch.now) * full * inverse, "so that a switch does not jump"
    )
    controller = SPEED_CONTROLS[w.tuning.speed_control_of(name)](w, name, error, speed, given)
    wanted = w.assign(f"{name}_wanted", share * controller.asked + switch.now * full)
    command = w.assign(f"{name}_command", envelope.clamp(wanted), "torque-speed envelope")
    controller.finish(w.assign(f"{name}_cut", (command - wanted) * inverse, "what the limit cuts off"))
    net = (command - full) * inverse  # with the whole compensation the law is the balance of the rotor
    if w.design.torque_count:
        net = w.assign(f"{name}_net", net, "net torque on the rotor")
    return SpeedCommand(command, net)

"""Speed control of a machine: PI, load torque compensation, limits, anti-windup."""

from __future__ import annotations

import sympy as sp

from ptgen.control.writer import ControllerWriter

__all__ = ["limit", "speed_control"]


def limit(w: ControllerWriter, machine: int, measured: dict[str, sp.Symbol]) -> sp.Symbol:
    """Return the torque that is available to a machine at its speed."""
    name, drive = w.design.machines[machine], w.design.model.inputs[machine].drive
    rated = w.of_bed(drive.speed_rated)
    speed = measured[w.speed_sensor(machine)]
    available = w.of_bed(drive.torque_max) * rated / sp.Max(rated, sp.Abs(speed))
    return w.assign(f"{name}_available", available, "torque-speed envelope, Figure 7.1")


def speed_control(
    w: ControllerWriter,
    machine: int,
    position: int,
    compensation: sp.Expr,
    limit: sp.Symbol,
    measured: dict[str, sp.Symbol],
    h: sp.Symbol,
) -> tuple[sp.Expr, sp.Symbol]:
    """Return what the torque limit leaves of the controller output, and the torque command (5.84), (5.52), (5.74)."""
    name = w.design.machines[machine]
    gain = w.parameter(
        f"{name}_speed_gain",
        "N m s/rad",
        f"proportional gain of the speed of {name}",
        w.gains.speed[name],
        allowed=False,
    )
    integral_gain = w.parameter(
        f"{name}_speed_integral_gain",
        "N m/rad",
        f"integral gain of the speed of {name}",
        w.gains.speed_integral[name],
    )
    integral = w.state(f"{name}_speed_integral", "N m", f"integrator of the speed control of {name}")
    error = w.assign(f"{name}_speed_error", measured[f"{name}_speed_ref"] - measured[w.speed_sensor(machine)])
    asked = w.assign(f"{name}_asked", gain * error + integral, "PI speed control (5.84)")
    compensate = w.assign(f"{name}_compensation", compensation, "load torque compensation (5.52), (5.74)")
    share = w.of_bed(sp.factor(w.design.law.P[machine, position]))
    command = w.assign(
        f"{name}_command", sp.Max(-limit, sp.Min(limit, share * asked + compensate)), "torque-speed envelope"
    )
    realised = w.assign(f"{name}_virtual", (command - compensate) / share, "what the limit leaves of it")
    conditioned = error + (realised - asked) / gain
    w.assign(integral.name, integral + h * integral_gain * conditioned, "conditioning anti-windup")
    return realised, command

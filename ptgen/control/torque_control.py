"""Torque control of a machine: feedforward, integrator against a torque model, acceleration torque, damping."""

from __future__ import annotations

import sympy as sp

from ptgen.control.writer import ControllerWriter, signal_symbol
from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.layout import signal_name

__all__ = ["torque_control", "unread_torque"]


def torque_control(
    w: ControllerWriter,
    index: int,
    machine: int,
    estimate: sp.Expr,
    decoupling: sp.Expr,
    limit: sp.Symbol,
    measured: dict[str, sp.Symbol],
    h: sp.Symbol,
) -> sp.Symbol:
    """Return the torque command (5.99), (5.62), (5.78)."""
    design, name = w.design, w.design.machines[machine]
    place = signal_name(design.outputs[index])
    w.parameter(f"{name}_damping", "N m s/rad", f"active damping by {name} (5.81)", w.gains.damping[name])
    w.parameter(
        f"{name}_inertia_estimate",
        "kg m^2",
        f"inertia that {name} accelerates (5.78)",
        w.gains.inertia_estimate[name],
        allowed=False,
    )
    feedforward = w.parameter(
        f"{name}_feedforward", "", f"share of the torque reference fed forward to {name}", w.tuning.feedforward
    )
    proportional = w.parameter(f"{name}_torque_gain", "", f"proportional gain of the torque control of {name}", 0.0)
    integral_gain = w.parameter(
        f"{name}_torque_integral_gain",
        "1/s",
        f"integral gain of the torque control of {name}",
        w.gains.torque_integral[name],
    )
    reserve = w.parameter(
        f"{name}_damping_reserve",
        "",
        f"share of the torque of {name} kept for damping",
        w.tuning.damping_reserve,
        most=1.0,
    )
    bound = w.parameter(
        f"{name}_torque_integral_limit",
        "N m",
        f"limit of the torque integrator of {name}",
        _integral_limit(w, index, machine),
    )
    integral = w.state(f"{name}_torque_integral", "N m", f"integrator of the torque control of {name}")
    torque = w.assign(f"{place}_estimate", estimate, "testing torque from the sensors (5.95), (5.98)")
    reference = measured[f"{place}_ref"]
    expected = _expected_torque(w, name, reference, h)
    error = w.assign(f"{name}_torque_error", expected - torque)
    share = w.of_bed(sp.factor(design.law.P[machine, index]))
    virtual = w.assign(
        f"{name}_virtual", feedforward * reference + proportional * error + integral, "torque control (5.99)"
    )
    wanted = w.assign(f"{name}_wanted", share * virtual + decoupling, "with the acceleration torque (5.62), (5.78)")
    room = (1 - reserve) * limit
    kept = w.assign(f"{name}_kept", sp.Max(-room, sp.Min(room, wanted)), "reserve for active damping")
    row = w.design.law.R[machine, :]
    damp = w.assign(f"{name}_damping_torque", w.sensor_sum(row, measured), "active damping (5.62), (5.78)")
    command = w.assign(f"{name}_command", sp.Max(-limit, sp.Min(limit, kept + damp)), "torque-speed envelope")
    # The integrator stands while the machine is at its limit and the error would drive it further.
    beyond = (wanted - kept) * error * share
    grown = integral + h * integral_gain * error
    limited = sp.Max(-bound, sp.Min(bound, grown))
    w.assign(integral.name, sp.Piecewise((integral, beyond > 0), (limited, True)), "limited integrator")
    return command


def unread_torque(w: ControllerWriter, machine: int, virtual: dict[int, sp.Expr]) -> sp.Expr:
    """Return the torque that accelerates what lies between the sensors and the place of the testing torque."""
    name = w.design.machines[machine]
    terms = []
    for position, value in virtual.items():
        other = w.design.machines[w.design.actuators[position]]
        inertia = w.gains.sensor_inertia[name][other]
        symbol = w.parameter(
            f"{name}_sensor_inertia_{other}",
            "kg m^2",
            f"torque of {name} that its sensors miss, per acceleration of {other}",
            inertia,
            None,
        )
        rotor = w.of_bed(
            w.design.model.body_inertias[next(iter(w.design.model.inputs[w.design.actuators[position]].row))]
        )
        terms.append(symbol * value / rotor)
    return sp.Add(*terms)


def _expected_torque(w: ControllerWriter, name: str, reference: sp.Symbol, h: sp.Symbol) -> sp.Expr:
    """Return the torque that the feedforward alone should give by now: the reference behind (5.57).

    The controller corrects what differs from it. Against the bare reference the integrator would charge during
    every change and let the torque overshoot.
    """
    stiffness = w.gains.stiffness[name]
    c = w.parameter(
        f"{name}_model_stiffness", "N m/rad", f"stiffness in the torque model of {name}", float(f"{stiffness:.6g}")
    )
    d = w.parameter(
        f"{name}_model_damping", "N m s/rad", f"damping in the torque model of {name}", w.gains.damping[name]
    )
    share = w.parameter(f"{name}_torque_model", "", f"switch of the torque model of {name}, 0 to 1", 1.0, most=1.0)
    model = w.state(f"{name}_model_torque", "N m", f"torque that the feedforward to {name} should give")
    rate = w.state(f"{name}_model_rate", "N m/s", f"rate of the torque model of {name}")
    force = c * (reference - model) - d * rate
    w.assign(rate.name, rate + h * force / signal_symbol(f"{name}_inertia_estimate"), "torque model (5.57), (5.76)")
    w.assign(model.name, model + h * rate)
    return share * model + (1 - share) * reference


def _integral_limit(w: ControllerWriter, index: int, machine: int) -> float:
    share = float(evaluate_matrix(sp.Matrix([[w.design.law.P[machine, index]]]), w.design.values)[0, 0])
    torque_max = w.full.values[w.full.inputs[machine].drive.torque_max]
    return float(f"{abs(0.5 * torque_max / share):.3g}")

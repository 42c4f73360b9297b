"""Torque control of a machine: feedforward, integrator against a torque model, acceleration torque, damping."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ptgen.control.envelope import Envelope
from ptgen.control.references import Reference, limited
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of
from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.layout import signal_name

__all__ = [
    "TorqueFeedback",
    "active_damping",
    "torque_command",
    "torque_feedback",
    "torque_reference",
    "unread_torque",
]


@dataclass(frozen=True)
class TorqueFeedback:
    """What feedforward and feedback of a controlled torque ask for: virtual input and error (N m)."""

    virtual: sp.Symbol
    error: sp.Symbol


def torque_reference(
    w: ControllerWriter, index: int, machine: int, steady: sp.Expr, measured: Mapping[str, sp.Symbol]
) -> Reference:
    """Return the limited reference of a torque; it starts where the testing torque is while nothing accelerates.

    It stands before the control of the speeds, whose torques the whole estimate would need.
    """
    place = signal_name(w.design.outputs[index])
    start = w.assign(f"{place}_steady", steady, "testing torque while nothing accelerates (5.95), (5.96)")
    signal, rate = f"{place}_ref", w.gains.torque_rate[w.design.machines[machine]]
    now = limited(w, signal, "N m", measured[signal], start, rate, here=True)
    return Reference(signal, "N m", now, signal_symbol(f"{signal}_step"), start)


def torque_feedback(
    w: ControllerWriter, index: int, machine: int, estimate: sp.Expr, reference: sp.Expr, start: sp.Expr
) -> TorqueFeedback:
    """Write the I or PI control of a torque (5.99).

    Parameters
    ----------
    w : ControllerWriter
    index, machine : int
        The torque among the controlled ones, and its machine.
    estimate : Expr
        Of the torque, from sensors and net torques (N m).
    reference : Expr
    start : Expr
        Where the torque model starts (N m).
    """
    design, name = w.design, w.design.machines[machine]
    place = signal_name(design.outputs[index])
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
    proportional = w.parameter(
        f"{name}_torque_gain",
        "",
        f"proportional gain of the torque control of {name}, above -1 (5.115a)",
        w.tuning.torque_gain,
        least=-1.0,
        allowed=False,
    )
    torque = w.assign(f"{place}_estimate", estimate, "testing torque from the sensors (5.95), (5.96), (5.98)")
    expected = _expected_torque(w, name, reference, start)
    error = w.assign(f"{name}_torque_error", expected - torque)
    integral = w.state(f"{name}_torque_integral", "N m", f"integrator of the torque control of {name}")
    before = w.assign(f"{name}_integral_before", w.previous(integral, sp.Integer(0)), "torque control (5.99)")
    virtual = w.assign(f"{name}_virtual", feedforward * reference + proportional * error + before)
    return TorqueFeedback(virtual, error)


def active_damping(
    w: ControllerWriter, machine: int, dampings: Mapping[sp.Symbol, sp.Symbol], measured: Mapping[str, sp.Symbol]
) -> sp.Symbol:
    """Write what the law adds from the sensors: active damping, and torques that would couple the outputs.

    Parameters
    ----------
    w : ControllerWriter
    machine : int
    dampings : mapping
        Symbol of each damping in the law -> its value in this step.
    measured : mapping
    """
    name, row = w.design.machines[machine], w.design.law.R[machine, :]
    rest = row.subs(dict.fromkeys(dampings, 0))
    torque = w.sensor_sum(f"{name}_from", rest, measured)
    for symbol, now in dampings.items():
        rates = row.diff(symbol)
        if any(entry != 0 for entry in rates):
            whose = symbol.name.removesuffix("_damping")
            twist = w.assign(
                f"{name}_twist_rate_{whose}",
                w.sensor_sum(f"{name}_twist_{whose}", rates, measured),
                "active damping (5.62), (5.78)",
            )
            torque += now * twist
    return w.assign(f"{name}_damping_torque", torque, "active damping (5.62), (5.78)")


def torque_command(
    w: ControllerWriter,
    index: int,
    machine: int,
    feedback: TorqueFeedback,
    wanted: sp.Expr,
    damping: sp.Expr,
    envelope: Envelope,
) -> sp.Symbol:
    """Write limits and integrator of a torque-controlled machine; return its command (5.62), (5.78).

    Reference, feedback and acceleration torque together leave a share of the envelope to the damping, so that neither
    they nor a speed controller that asks for a large acceleration can use up what keeps the shaft from ringing.
    """
    design, name = w.design, w.design.machines[machine]
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
    growth = w.derive(
        f"{name}_torque_growth", "", "growth of the integrator per error", signal_symbol("sample_time") * integral_gain
    )
    share = w.coefficient(f"{name}_share", f"share of its virtual input in {name}", design.law.P[machine, index])
    before = signal_symbol(f"{name}_integral_before")
    asked = w.assign(f"{name}_wanted", wanted, "with the acceleration torque (5.62), (5.78)")
    kept = w.assign(f"{name}_kept", envelope.clamp(asked, 1 - reserve), "reserve for active damping")
    command = w.assign(f"{name}_command", envelope.clamp(kept + damping), "torque-speed envelope")
    # The integrator stands while the machine is at its limit and the error would drive it further.
    beyond = (asked - kept) * feedback.error * share
    limited_integral = greatest_of(-bound, smallest_of(bound, before + growth * feedback.error))
    w.assign(
        f"{name}_torque_integral",
        sp.Piecewise((before, beyond > 0), (limited_integral, True)),
        "limited integrator",
    )
    return command


def unread_torque(
    w: ControllerWriter,
    machine: int,
    net: Mapping[int, sp.Symbol],
    rates: Mapping[str, sp.Expr],
    measured: Mapping[str, sp.Symbol],
) -> sp.Expr:
    """Return the torque that accelerates what lies between the sensors and the place of the testing torque.

    Parameters
    ----------
    w : ControllerWriter
    machine : int
    net : mapping of int to Symbol
        Torque on the rotor of each speed-controlled machine (N m), by the positions of the outputs.
    rates : mapping of str to Expr
        Of the ratios that change (1/s).
    measured : mapping of str to Symbol
    """
    name = w.design.machines[machine]
    terms = []
    for position, value in net.items():
        other = w.design.machines[w.design.actuators[position]]
        ratio = w.gains.sensor_ratio[name].get(other)
        symbol = w.parameter(
            f"{name}_sensor_inertia_{other}",
            "kg m^2",
            f"torque of {name} that its sensors miss, per acceleration of {other}{f' times {ratio}' if ratio else ''}",
            w.gains.sensor_inertia[name][other],
            None,
        )
        per_torque = w.derive(f"{name}_unread_{other}", "", "the same per net torque", symbol / w.rotor(other))
        if ratio is None:
            terms.append(per_torque * value)
            continue
        now = next(w.of_bed(changing.symbol) for changing in w.design.model.changing if changing.symbol.name == ratio)
        terms.append(per_torque * now * value)
        if ratio in rates:
            speed = measured[w.speed_sensor(w.design.actuators[position])]
            terms.append(symbol * speed * rates[ratio])
    return sp.Add(*terms)


def _expected_torque(w: ControllerWriter, name: str, reference: sp.Expr, start: sp.Expr) -> sp.Expr:
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
    h, inertia = signal_symbol("sample_time"), signal_symbol(f"{name}_inertia_estimate")
    pull = w.derive(f"{name}_model_pull", "1/s", "rate of the torque model per missing torque", h * c / inertia)
    drag = w.derive(f"{name}_model_drag", "", "decay of that rate in a step", h * d / inertia)
    model = w.state(f"{name}_model_torque", "N m", f"torque that the feedforward to {name} should give")
    rate = w.state(f"{name}_model_rate", "N m/s", f"rate of the torque model of {name}")
    source = "torque model (5.57), (5.76)"
    expected = w.assign(f"{name}_model_before", w.previous(model, start, here=True), source)
    moving = w.assign(f"{name}_rate_before", w.previous(rate, sp.Integer(0)), source)
    w.assign(rate.name, moving + pull * (reference - expected) - drag * moving, source)
    w.assign(model.name, expected + h * rate)
    return share * model + (1 - share) * reference


def _integral_limit(w: ControllerWriter, index: int, machine: int) -> float:
    share = float(evaluate_matrix(sp.Matrix([[w.design.law.P[machine, index]]]), w.design.values)[0, 0])
    torque_max = w.full.values[w.full.inputs[machine].drive.torque_max]
    return float(f"{abs(0.5 * torque_max / share):.3g}")

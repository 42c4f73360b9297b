r"""The controller as a block: supervision, speed and torque control, decoupling law, limits.

Every step runs in this order:

1. *Supervision.* An input that is not finite, or larger than plausible, is replaced by its last sound value; the
   fault is latched with the number of the signal, and the last torques are taken to zero along a ramp.
2. *Switches and dampings* follow their parameters along a ramp, references pass rate limiters, ratios that change too.
   What has passed them may be shaped by a governor, see `ptgen.control.shaper`.
3. *Speed control.* PI (5.84) with anti-windup by conditioning (Hanus), or P with disturbance observer (5.92).
4. *Load torque compensation* (5.52), (5.74): the machine's own flange torque, times `load_compensation`.
5. *Torque control.* Feedforward and feedback (5.99) on the testing torque from the sensors (5.95), (5.96), (5.98). The
   integrator compares it with what the feedforward should give by now, the reference behind (5.57); it is limited,
   and stands while the machine is at its limit.
6. *Decoupling* (5.62), (5.78): torque for the acceleration of the rotors that control a speed, times
   `acceleration_torque`, and active damping. The other parts leave a reserve for the damping.
7. *Limits.* The torque-speed envelope, Figure 7.1.

A step that follows a fault, and the first one, starts anew: references where the bed is, integrators empty. The state
`running` tells it; linearise the block with `running` at one, that is after a step.

The conventional controller (Figure 5.10) is the same block with all three switched off.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ptgen.block.block import Assign, Block
from ptgen.control.decoupling import Decoupling
from ptgen.control.envelope import envelope
from ptgen.control.loss_map import loss_torques
from ptgen.control.ratios import changing_ratios, ratio_bounds, ratio_inputs
from ptgen.control.references import pair_bounds, reference_inputs, speed_references
from ptgen.control.release import release
from ptgen.control.shaper import Shaper, shaped_reference
from ptgen.control.speed_control import speed_control
from ptgen.control.supervision import supervise
from ptgen.control.switches import follow
from ptgen.control.torque_control import (
    TorqueFeedback,
    active_damping,
    torque_command,
    torque_feedback,
    torque_reference,
    unread_torque,
)
from ptgen.control.tuning import Gains
from ptgen.control.unlimited_law import unlimited_law
from ptgen.control.watching import watch
from ptgen.control.writer import ControllerWriter, signal_symbol
from ptgen.mechanism.model import Model
from ptgen.plant.layout import signal_name
from ptgen.testbed.testbed import Tuning

__all__ = ["ControllerBlock", "controller_block", "conventional_parameters"]


@dataclass(frozen=True)
class ControllerBlock:
    """The controller's block, and the parameter values that make it the conventional controller."""

    block: Block
    conventional: dict[str, float]
    references: dict[str, str]
    """Reference of a scenario (``torque.M1``) to input of the block."""


def controller_block(
    decoupling: Decoupling,
    gains: Gains,
    tuning: Tuning,
    full: Model,
    sample_time: float,
    shaper: Shaper | None = None,
    gears: Mapping[str, Sequence[float]] | None = None,
) -> ControllerBlock:
    """Return the controller of a bed as a block.

    Parameters
    ----------
    decoupling : Decoupling
    gains : Gains
    tuning : Tuning
    full : Model
        The full model; it tells which signals are plausible.
    sample_time : float
        Nominal step (s).
    shaper : Shaper, optional
        What the references pass before the control law.
    gears : mapping of str to sequence of float, optional
        Ratios of the gears of components that are ratios for control.
    """
    w = ControllerWriter(decoupling, gains, tuning, full)
    law = decoupling.law
    torque_machines = decoupling.actuators[: decoupling.torque_count]
    speed_machines = decoupling.actuators[decoupling.torque_count :]
    h = w.parameter("sample_time", "s", "step of the controller", sample_time, allowed=False)
    w.parameter("fault_ramp", "s", "time from a fault to zero torque", tuning.fault_ramp, allowed=False)
    references = reference_inputs(decoupling, tuning)
    w.plausible |= pair_bounds(w) | ratio_bounds(decoupling)
    names = [*references.values(), *ratio_inputs(decoupling), *_used_sensors(w)]
    measured = supervise(w, names, h)
    supervision = len(w.statements)
    w.parameter("load_compensation", "", "switch of the load torque compensation, 0 to 1", 1.0, most=1.0)
    w.parameter("acceleration_torque", "", "switch of the acceleration torque, 0 to 1", 1.0, most=1.0)
    load = follow(w, "load_compensation")
    accelerate = follow(w, "acceleration_torque").now if torque_machines else sp.Integer(1)
    dampings = {}
    for machine, symbol in zip(torque_machines, decoupling.damping, strict=True):
        name = decoupling.machines[machine]
        w.parameter(symbol.name, "N m s/rad", f"active damping by {name} (5.81)", gains.damping[name])
        dampings[symbol] = follow(w, symbol.name, "N m s/rad").now
    envelopes = {machine: envelope(w, machine, measured) for machine in range(len(decoupling.machines))}
    ratio_rates, sure = changing_ratios(w, measured, gears or {})
    dampings = {symbol: sure * now for symbol, now in dampings.items()}
    watch(w, names, measured, h)
    losses = loss_torques(w, measured)
    limited = speed_references(w, measured)
    for index, machine in enumerate(torque_machines):
        name = decoupling.machines[machine]
        steady = w.sensor_sum(f"{name}_read", law.estimate_sensors[index, :], measured) + w.loss_sum(
            f"{name}_read", law.estimate_losses[index, :], losses
        )
        limited[name] = torque_reference(w, index, machine, steady, measured)
    of_machines = [limited[name] for name in decoupling.machines]
    law_begins = len(w.statements)
    given = {
        name: reference.limited if shaper is None else signal_symbol(shaped_reference(reference))
        for name, reference in limited.items()
    }
    net: dict[int, sp.Symbol] = {}
    commands: dict[int, sp.Symbol] = {}
    for position, machine in enumerate(speed_machines, start=decoupling.torque_count):
        name = decoupling.machines[machine]
        compensation = (
            w.sensor_sum(f"{name}_load", law.R[machine, :], measured)
            + w.loss_sum(f"{name}_load", law.R_losses[machine, :], losses)
            + w.rate_sum(f"{name}_load", machine, ratio_rates, measured)
        )
        result = speed_control(w, machine, position, load, compensation, envelopes[machine], given[name], measured)
        commands[machine], net[position] = result.command, result.net
    feedback: dict[int, TorqueFeedback] = {}
    for index, machine in enumerate(torque_machines):
        name = decoupling.machines[machine]
        estimate = (
            limited[name].present
            + w.virtual_sum(f"{name}_read", law.estimate_virtual[index, :], net)
            + unread_torque(w, machine, net, ratio_rates, measured)
        )
        feedback[index] = torque_feedback(w, index, machine, estimate, given[name], limited[name].present)
    asked = {index: part.virtual for index, part in feedback.items()}
    for index, machine in enumerate(torque_machines):
        name, row = decoupling.machines[machine], law.P[machine, :]
        accelerating = w.virtual_sum(f"{name}_with", row, net) + w.rate_sum(
            f"{name}_with", machine, ratio_rates, measured
        )
        wanted = (
            w.virtual_sum(f"{name}_share", row, asked)
            + w.loss_sum(f"{name}_with", law.R_losses[machine, :], losses)
            + accelerate * accelerating
        )
        damping = active_damping(w, machine, dampings, measured)
        commands[machine] = torque_command(w, index, machine, feedback[index], wanted, damping, envelopes[machine])
    if shaper is not None:
        control = w.statements[law_begins:]
        del w.statements[law_begins:]
        anew = [s for s in control if isinstance(s, Assign) and s.condition is not None]
        w.statements += anew  # what starts anew does so before the law is looked at
        shaped = [signal_symbol(shaped_reference(reference)) for reference in of_machines]
        ordered = [envelopes[machine] for machine in range(len(of_machines))]
        unlimited = unlimited_law(
            control,
            ordered,
            shaped,
            [commands[machine] for machine in range(len(of_machines))],
            [f"{signal_name(place)}_estimate" for place in decoupling.outputs[: decoupling.torque_count]],
        )
        shaper.shape(w, of_machines, unlimited, ordered, measured, losses)
        w.statements += [statement for statement in control if statement not in anew]
    outputs = release(w, commands, h)
    block = Block(
        name="controller",
        description=f"controller of the bed {decoupling.model.name}",
        parameters=tuple(w.parameters.values()),
        inputs=tuple(w.inputs.values()),
        outputs=outputs,
        states=tuple(w.states.values()),
        derived=tuple(w.derived.values()),
        prepare=tuple(w.preparation),
        step=(*w.statements[:supervision], *w.restart, *w.statements[supervision:]),
        faults=tuple(w.faults),
        arrays=tuple(w.arrays.values()),
        tables=tuple(w.tables.values()),
    )
    return ControllerBlock(block, conventional_parameters(decoupling, gains), references)


def _used_sensors(w: ControllerWriter) -> list[str]:
    """Return the sensors that the law, the estimates or the torque limits need."""
    design, law = w.design, w.design.law
    speeds = {w.speed_sensor(machine) for machine in range(len(design.machines))}
    return [
        name
        for k, name in enumerate(design.sensors)
        if name in speeds
        or any(balance is not None and balance.sensors[k] != 0 for balance in law.balance)
        or any(entry != 0 for entry in law.R[:, k])
        or any(entry != 0 for entry in law.estimate_sensors[:, k])
        or any(loss.speed[k] != 0 for loss in law.known_losses)
        or any(entry != 0 for rows in law.ratio_rates.values() for entry in rows[:, k])
    ]


def conventional_parameters(design: Decoupling, gains: Gains) -> dict[str, float]:
    """Return the parameters that make the block the conventional controller, Figure 5.10.

    Parameters
    ----------
    design : Decoupling
    gains : Gains
    """
    values = {"load_compensation": 0.0, "acceleration_torque": 0.0}
    for machine in design.actuators[: design.torque_count]:
        name = design.machines[machine]
        values[f"{name}_damping"] = 0.0
        values[f"{name}_torque_model"] = 0.0
        values[f"{name}_torque_integral_gain"] = gains.conventional_integral[name]
    return values

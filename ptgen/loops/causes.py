"""Couplings that sampling, dead time, lag and neglected parts leave between torques and speeds, cause by cause."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from ptgen.analysis.coupling import Coupling, ReferencedLoop, continuous_coupling, referenced_loop, sampled_coupling
from ptgen.analysis.linear import Linearisation
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.model import Model
from ptgen.plant.layout import signal_name
from ptgen.plant.plant import plant_block
from ptgen.project import Project

__all__ = ["HORIZON", "Cause", "couplings_by_cause", "followed_outputs"]

HORIZON = 1.0
"""Time (s) over which couplings are measured."""


@dataclass(frozen=True)
class Cause:
    """Couplings with one more cause: a name, and the errors."""

    name: str
    description: str
    coupling: Coupling


def followed_outputs(project: Project) -> dict[str, tuple[str, dict[str, float]]]:
    """Return the controller's input of every reference, and the shares of the plant's outputs in what follows it."""
    decoupling, pairs = project.design.decoupling, project.testbed.tuning.speed_pairs
    owners = [decoupling.machines[machine] for machine in decoupling.actuators]
    shares = {"speed_mean": (0.5, 0.5), "speed_difference": (1.0, -1.0)}
    result = {}
    for reference, signal in project.design.controller.references.items():
        kind, _, name = reference.partition(".")
        if kind in shares:
            seen = [decoupling.outputs[owners.index(machine)] for machine in pairs[name]]
            result[reference] = (signal, dict(zip(seen, shares[kind], strict=True)))
            continue
        place = decoupling.outputs[owners.index(name)]
        result[reference] = (signal, {signal_name(place) if kind == "torque" else place: 1.0})
    return result


def couplings_by_cause(
    project: Project,
    full: Model,
    locked: tuple[str, ...],
    chosen: Mapping[str, float],
    everything: ReferencedLoop,
) -> tuple[Cause, ...]:
    """Return the couplings, cause by cause; those of the emitted loop last."""
    decoupling, h = project.design.decoupling, project.testbed.sample_time
    controller, followed = Linearisation(project.design.controller.block), followed_outputs(project)
    conventional = project.design.controller.conventional
    law = {name: value for name, value in chosen.items() if name not in conventional}
    reduced_model = project.reduced.model
    if missing := {f.name for f in reduced_model.frictions} & set(locked):
        reduced_model = assemble(project.reduced.mechanism.with_locked_frictions(missing), first="machines")
    values = {s.name: s.value for s in project.design.controller.block.parameters} | law
    # On the reduced bed the law is exact with the inertias of that bed.
    reduced = {symbol.name: decoupling.values[symbol] for symbol in decoupling.inertia_estimate}
    reduced |= {name: 0.0 for name in values if "_sensor_inertia_" in name}

    sensing = any(sensor.time_constant is not None for sensor in full.sensors)
    sensing = sensing or any(torque.drive.computation_delay is not None for torque in full.inputs)

    def of(
        model: Model, dead_time: bool, lag: bool, parameters: Mapping[str, float], sensors: bool = False
    ) -> Coupling:
        inputs = tuple(
            replace(
                torque,
                drive=replace(
                    torque.drive,
                    dead_time=torque.drive.dead_time if dead_time else None,
                    time_constant=torque.drive.time_constant if lag else None,
                    computation_delay=torque.drive.computation_delay if sensors else None,
                ),
            )
            for torque in model.inputs
        )
        plain = tuple(sensor if sensors else replace(sensor, time_constant=None) for sensor in model.sensors)
        plant = Linearisation(plant_block(replace(model, inputs=inputs, sensors=plain), h))
        return sampled_coupling(referenced_loop(controller, plant, followed, parameters), HORIZON)

    small = {**law, **reduced}
    causes = [
        Cause("rounding", "continuous law, reduced bed", continuous_coupling(decoupling, values, HORIZON)),
        Cause("sampling", "emitted controller, reduced bed", of(reduced_model, False, False, small)),
        Cause("dead_time", "and dead time of the inverters", of(reduced_model, True, False, small)),
        Cause("lag", "and lag of the inverters", of(reduced_model, True, True, small)),
        *(
            [Cause("sensors", "and sensor filters and computation", of(reduced_model, True, True, small, True))]
            if sensing
            else []
        ),
        Cause("neglected", "emitted controller, full bed with ideal inverters", of(full, False, False, law)),
    ]
    own = sampled_coupling(everything, HORIZON)
    if all(chosen.get(name) == value for name, value in conventional.items()) and conventional:
        causes.append(Cause("conventional", "conventional controller, full bed", own))
        return tuple(causes)
    causes.append(Cause("everything", "emitted controller, full bed", own))
    causes.append(
        Cause(
            "conventional", "conventional controller, full bed", of(full, True, True, {**chosen, **conventional}, True)
        )
    )
    return tuple(causes)

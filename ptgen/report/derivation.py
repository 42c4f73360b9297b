"""The derivation of a bed's control, from the model to the law: what `ptgen derive` shows, before it is written."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.analysis.closed_loop import Pole, closed_loop_poles
from ptgen.analysis.continuous_proof import ContinuousProof
from ptgen.block.block import Block
from ptgen.control.decoupling import Decoupling
from ptgen.control.friction_states import FrictionState, other_friction_states
from ptgen.elements import SensorKind, Spring
from ptgen.mechanism.applied_rules import AppliedRule
from ptgen.mechanism.model import Model
from ptgen.mechanism.modes import Mode
from ptgen.plant.layout import signal_name
from ptgen.plant.plant import plant_block
from ptgen.project import Project
from ptgen.report.formulas import Equation, Kind, Term
from ptgen.report.motion import Motion, motion

__all__ = ["Derivation", "Gain", "derivation"]


@dataclass(frozen=True)
class Gain:
    """A gain of the controller in SI units."""

    machine: str
    description: str
    value: float
    unit: str


@dataclass(frozen=True)
class Derivation:
    """All parts of the derivation.

    Attributes
    ----------
    title, name : str
    model, reduced : Model
    motion, reduced_motion : Motion
        Equations of motion of both.
    gaps : tuple of Spring
        Shafts with backlash; the equations have their gaps closed.
    rules : tuple of AppliedRule
    modes_before, modes_after : tuple of Mode
    definitions : mapping of Symbol to Expr
        Equivalent shafts, of which each is made from those before it.
    values : dict of Symbol to float
        Value of every parameter.
    decoupling : Decoupling
    law : mapping of str to Equation
        The law of each machine; each term tells what it is there for.
    estimates : tuple of Equation
        Controlled torques from sensors.
    gains : tuple of Gain
    conventional : mapping of str to float
        Parameters that make the controller the conventional one.
    closed_loop : mapping of str to tuple of Pole
        Poles of the sampled closed loop, dead time and lag included, for both controllers. Gaps are closed, and
        elements that the reduced model takes for locked are locked here too; the others are without friction.
    friction_states : tuple of FrictionState
        What becomes of the roles while a friction element is not in the state that the law is made for.
    stability : ContinuousProof
        Of the reduced model's closed loop, without sampling.
    """

    title: str
    name: str
    model: Model
    reduced: Model
    motion: Motion
    reduced_motion: Motion
    gaps: tuple[Spring, ...]
    rules: tuple[AppliedRule, ...]
    modes_before: tuple[Mode, ...]
    modes_after: tuple[Mode, ...]
    definitions: Mapping[sp.Symbol, sp.Expr]
    reduced_parameters: Mapping[str, float]
    values: dict[sp.Symbol, float]
    decoupling: Decoupling
    law: Mapping[str, Equation]
    estimates: tuple[Equation, ...]
    gains: tuple[Gain, ...]
    conventional: Mapping[str, float]
    closed_loop: Mapping[str, tuple[Pole, ...]]
    stability: ContinuousProof
    friction_states: tuple[FrictionState, ...]

    @property
    def internal_eigenvalues(self) -> NDArray[np.complex128]:
        """Eigenvalues of the internal dynamics (1/s)."""
        return self.decoupling.internal_eigenvalues

    @property
    def locked(self) -> tuple[str, ...]:
        """Friction elements that the reduced model takes for locked."""
        return tuple(rule.element for rule in self.rules if rule.rule == "lock")

    @property
    def used_definitions(self) -> dict[sp.Symbol, sp.Expr]:
        """Definitions of the equivalent shafts that the reduced model or the law needs, damping left out."""
        return {symbol: made for symbol, made in self.definitions.items() if symbol.name.endswith("_stiffness")}


def derivation(project: Project) -> Derivation:
    """Collect the derivation of a bed."""
    reduced, design = project.reduced, project.design
    decoupling = design.decoupling
    variants = {"decoupling": {}, "conventional": design.controller.conventional}
    plant = _linear_plant(project)
    return Derivation(
        title=project.testbed.title,
        name=project.testbed.name,
        model=project.control_model,
        reduced=reduced.model,
        motion=motion(project.control_model, project.control_mechanism.orientation),
        reduced_motion=motion(reduced.model),
        gaps=tuple(spring for spring in project.control_mechanism.springs if spring.backlash is not None),
        rules=reduced.rules,
        modes_before=reduced.modes_before,
        modes_after=reduced.modes_after,
        definitions=reduced.definitions,
        reduced_parameters=reduced.parameters,
        values={**project.control_model.values, **decoupling.values, **design.tuned_inertia},
        decoupling=decoupling,
        law=_laws(decoupling),
        estimates=_estimates(decoupling),
        gains=_gains(project),
        conventional=design.controller.conventional,
        closed_loop={
            name: closed_loop_poles(project.design.controller.block, plant, values) for name, values in variants.items()
        },
        stability=project.proof,
        friction_states=other_friction_states(
            project.control_mechanism,
            project.control_bed.reduction,
            project.testbed.roles,
            decoupling.structure,
            len(reduced.model.twists),
        ),
    )


def _linear_plant(project: Project) -> Block:
    """Return the plant of the state that the controller is made for: gaps closed, and locked what it takes for locked.

    At rest a bed stands inside its gaps, and open clutches part it; poles there would say nothing.
    """
    full = project.reduced.full
    return project.plant if full is project.plant_model else plant_block(full, project.testbed.sample_time)


def _virtual(decoupling: Decoupling, row: sp.Matrix) -> list[tuple[sp.Expr, str]]:
    """Return coefficients and machines of the virtual inputs in a row over the outputs."""
    owners = [decoupling.machines[machine] for machine in decoupling.actuators]
    return [(sp.factor(row[k]), name) for k, name in enumerate(owners) if row[k] != 0]


def _laws(decoupling: Decoupling) -> dict[str, Equation]:
    """Return the law of each machine: its own controller first, then the others, then the sensors."""
    torque_machines = {decoupling.machines[i] for i in decoupling.actuators[: decoupling.torque_count]}
    kinds = {sensor.name: sensor.kind for sensor in decoupling.model.sensors}
    laws = {}
    for index, name in enumerate(decoupling.machines):
        controls_torque = name in torque_machines
        own = "output of its own torque controller" if controls_torque else "output of its own speed controller"
        virtual = _virtual(decoupling, decoupling.law.P[index, :])
        terms = [Term(c, Kind.SIGNAL, f"v_{other}", own) for c, other in virtual if other == name]
        for coefficient, other in virtual:
            if other != name:
                note = f"decoupling from the torque control of {other}"
                if other not in torque_machines:
                    note = f"acceleration torque: what the bed needs when {other} accelerates"
                terms.append(Term(coefficient, Kind.SIGNAL, f"v_{other}", note))
        for position, sensor in enumerate(decoupling.sensors):
            coefficient = decoupling.law.R[index, position]
            if coefficient == 0:
                continue
            if coefficient.free_symbols & set(decoupling.damping):
                note = "active damping"
            elif kinds[sensor] is SensorKind.TORQUE and not controls_torque:
                note = "load torque compensation"
            else:
                note = "decoupling by a measured signal"
            terms.append(Term(sp.factor(coefficient), Kind.SIGNAL, sensor, note))
        terms += _added(decoupling, index)
        laws[name] = Equation((Term(sp.Integer(1), Kind.AIR_GAP, name),), tuple(terms))
    return laws


def _added(decoupling: Decoupling, index: int) -> list[Term]:
    """Return what known losses and changing ratios add to the law of a machine."""
    law = decoupling.law
    terms = [
        Term(sp.factor(coefficient), Kind.SIGNAL, f"{loss.component}_loss", "loss torque from its map")
        for coefficient, loss in zip(law.R_losses[index, :], law.known_losses, strict=True)
        if coefficient != 0
    ]
    for ratio, share in law.ratio_rates.items():
        rate = sp.Symbol(f"{ratio}_rate")
        terms += [
            Term(sp.factor(coefficient) * rate, Kind.SIGNAL, sensor, f"acceleration torque while {ratio} changes")
            for coefficient, sensor in zip(share[index, :], decoupling.sensors, strict=True)
            if coefficient != 0
        ]
    return terms


def _estimates(decoupling: Decoupling) -> tuple[Equation, ...]:
    """Return every controlled torque as a sum of measured signals."""
    result = []
    for index in range(decoupling.torque_count):
        terms = [
            Term(sp.factor(coefficient), Kind.SIGNAL, sensor, "measured")
            for coefficient, sensor in zip(decoupling.law.estimate_sensors[index, :], decoupling.sensors, strict=True)
            if coefficient != 0
        ]
        terms += [
            Term(coefficient, Kind.SIGNAL, f"v_{name}", "torque that accelerates the parts in between")
            for coefficient, name in _virtual(decoupling, decoupling.law.estimate_virtual[index, :])
        ]
        terms += [
            Term(sp.factor(coefficient), Kind.SIGNAL, f"{loss.component}_loss", "loss torque from its map")
            for coefficient, loss in zip(
                decoupling.law.estimate_losses[index, :], decoupling.law.known_losses, strict=True
            )
            if coefficient != 0
        ]
        left = Term(sp.Integer(1), Kind.SIGNAL, signal_name(decoupling.outputs[index]))
        result.append(Equation((left,), tuple(terms)))
    return tuple(result)


def _gains(project: Project) -> tuple[Gain, ...]:
    found, machines = project.design.gains, project.testbed.machines
    wanted = (
        (found.stiffness, "stiffness that it swings against", "N m/rad"),
        (found.natural_frequency, "natural frequency of that motion", "rad/s"),
        (found.damping, "active damping", "N m s/rad"),
        (found.inertia_estimate, "inertia that it accelerates", "kg m^2"),
        (found.torque_integral, "integral gain of the torque control", "1/s"),
        (found.conventional_integral, "the same, conventional controller", "1/s"),
        (found.speed, "proportional gain of the speed control", "N m s/rad"),
        (found.speed_integral, "integral gain of the speed control", "N m/rad"),
    )
    return tuple(
        Gain(machine, description, table[machine], unit)
        for machine in machines
        for table, description, unit in wanted
        if machine in table
    )

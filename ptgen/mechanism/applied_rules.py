"""The rules that a reduction has applied, each with the numbers that justify it."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.elements import FluidCoupling, Spring
from ptgen.mechanism.idle_parts import IdlePart, component_of
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.modes import Mode
from ptgen.mechanism.participation import Participation
from ptgen.mechanism.series import SeriesShafts
from ptgen.testbed.testbed import ReductionSettings

__all__ = [
    "AppliedRule",
    "backlash_rule",
    "condensation_rules",
    "damping_rule",
    "drive_rules",
    "fluid_rule",
    "idle_rule",
    "inertia_rule",
    "lock_rule",
    "loss_rule",
    "reference_rules",
    "rigid_rule",
    "sensor_rules",
]


@dataclass(frozen=True)
class AppliedRule:
    """One rule that was applied to one element.

    Attributes
    ----------
    rule : str
        ``as ratio``, ``close backlash``, ``lock``, ``leave out``, ``drop losses``, ``drop damping``,
        ``idealise drive``, ``idealise sensor``, ``drop inertia``, ``rigidise``, ``condense`` or ``refer``.
    element : str
        The element it was applied to.
    why : str
        The justification in words, numbers included.
    numbers : mapping of str to float
        The numbers behind it.
    """

    rule: str
    element: str
    why: str
    numbers: Mapping[str, float]


def backlash_rule(mechanism: Mechanism, spring: Spring) -> AppliedRule:
    """Return the rule that closes the gap of a shaft, with the torque that twists it by as much as the gap."""
    gap, stiffness = (
        float(evaluate_matrix(sp.Matrix([[part]]), mechanism.values)[0, 0])
        for part in (sp.sympify(spring.backlash), spring.stiffness)
    )
    degrees, torque = math.degrees(gap), stiffness * gap
    return AppliedRule(
        "close backlash",
        spring.name,
        f"as long as its torque keeps its sign the gap of {degrees:.3g} degrees stays closed; "
        f"{torque:.4g} N m twist the shaft by as much",
        {"gap_degrees": degrees, "torque": torque},
    )


def lock_rule(mechanism: Mechanism, name: str) -> AppliedRule:
    """Return the rule that takes a friction element for locked, with the least torque that it then holds."""
    friction = next(f for f in mechanism.frictions if f.name == name)

    def value(expression: sp.Expr) -> float:
        return float(evaluate_matrix(sp.Matrix([[expression]]), mechanism.values)[0, 0])

    least = 1.0 if friction.ripple is None else 1.0 - value(friction.ripple.amplitude)
    held = least * value(friction.at_rest)
    load = 0.0 if friction.load is None else least * value(friction.load.coefficient)
    if friction.one_way:
        why = f"it stays engaged while its torque is above {0.0 - held:.4g} N m"
    else:
        share = f" and {100 * load:.3g} % of the torque at {friction.load.place}" if friction.load and load else ""
        why = f"it sticks up to {held:.4g} N m{share}{', fully actuated' if friction.actuated else ''}"
    return AppliedRule("lock", name, f"asked for in the file; {why}", {"at_rest": held, "load": load})


def fluid_rule(fluid: FluidCoupling, locked: Collection[str]) -> AppliedRule:
    """Return the rule that leaves out the torques of a fluid."""
    if f"{fluid.name.rpartition('.')[0]}.lockup" not in locked:
        why = "no linear function of the speeds; its torques are disturbances of pump and turbine"
        return AppliedRule("leave out", fluid.name, why, {})
    why = "pump and turbine turn as one while the lock-up clutch sticks, and at 0 rad/s of slip the fluid has no torque"
    return AppliedRule("leave out", fluid.name, why, {"slip": 0.0})


def idle_rule(mechanism: Mechanism, part: IdlePart) -> AppliedRule:
    """Return the rule that leaves out a part that no machine acts on, with its inertia."""
    inertia = sum(
        float(evaluate_matrix(sp.Matrix([[body.inertia]]), mechanism.values)[0, 0])
        for body in mechanism.bodies
        if body.velocity in part.velocities
    )
    means = f" while {', '.join(part.frictions)} slip" if part.frictions else ""
    return AppliedRule(
        "leave out",
        ", ".join(part.names),
        f"no machine acts on these {inertia:.3g} kg m^2{means}",
        {"inertia": inertia},
    )


def loss_rule(mechanism: Mechanism, name: str) -> AppliedRule:
    """Return the rule that leaves out a loss, with its torque."""
    friction = next(f for f in mechanism.frictions if f.name == name)
    values = mechanism.values
    coulomb = evaluate_matrix(sp.Matrix([[friction.coulomb]]), values)[0, 0]
    load = evaluate_matrix(sp.Matrix([[friction.load.coefficient]]), values)[0, 0] if friction.load else 0.0
    share = f" and {100 * load:.3g} % of the torque" if friction.load else ""
    return AppliedRule(
        "drop losses",
        name,
        f"the torque controller's integrator covers {coulomb:g} N m{share}",
        {"coulomb": coulomb, "load": load},
    )


def drive_rules(mechanism: Mechanism, before: tuple[Mode, ...]) -> list[AppliedRule]:
    """Return the rules that make drives ideal, with the phase that their delay costs at the first mode."""
    elastic = [mode.frequency_hz for mode in before if mode.frequency_hz > 0]
    rules = []
    for torque in mechanism.torques:
        drive = torque.drive
        parts = [part for part in (drive.time_constant, drive.dead_time, drive.computation_delay) if part is not None]
        if not parts or not elastic:
            continue
        delay = sum(mechanism.values[part] for part in parts)
        degrees = 360.0 * delay * elastic[0]
        why = f"{1e6 * delay:.0f} us are {degrees:.2g} degrees of phase at the first mode, {elastic[0]:.3g} Hz"
        rules.append(AppliedRule("idealise drive", torque.name, why, {"delay": delay, "phase_degrees": degrees}))
    return rules


def sensor_rules(mechanism: Mechanism, before: tuple[Mode, ...]) -> list[AppliedRule]:
    """Return the rules that make sensors ideal, with the phase that their low pass costs at the first mode."""
    elastic = [mode.frequency_hz for mode in before if mode.frequency_hz > 0]
    rules = []
    for sensor in mechanism.sensors:
        if sensor.time_constant is None or not elastic:
            continue
        lag = mechanism.values[sensor.time_constant]
        degrees = math.degrees(math.atan(2 * math.pi * elastic[0] * lag))
        why = f"{1e6 * lag:.0f} us are {degrees:.2g} degrees of phase at the first mode, {elastic[0]:.3g} Hz"
        rules.append(AppliedRule("idealise sensor", sensor.name, why, {"lag": lag, "phase_degrees": degrees}))
    return rules


def rigid_rule(name: str, participation: Participation, settings: ReductionSettings) -> AppliedRule:
    """Return the rule that makes a spring rigid, with its share of the strain energy."""
    share = participation.strain(name)
    reason = "asked for in the file; " if name in settings.rigid else ""
    return AppliedRule(
        "rigidise",
        name,
        f"{reason}it holds at most {100 * share:.2g} % of the strain energy of the kept modes",
        {"strain_share": share, "threshold": float(settings.stiffness_share)},
    )


def inertia_rule(
    mechanism: Mechanism, velocity: str, participation: Participation, settings: ReductionSettings
) -> AppliedRule:
    """Return the rule that drops a body, with its share of the kinetic energy."""
    share = participation.kinetic(velocity)
    body = next(item for item in mechanism.bodies if item.velocity == velocity)
    inertia = evaluate_matrix(sp.Matrix([[body.inertia]]), mechanism.values)[0, 0]
    reason = "asked for in the file; " if component_of(velocity) in settings.drop else ""
    return AppliedRule(
        "drop inertia",
        velocity,
        f"{reason}{inertia:.3g} kg m^2 hold at most {100 * share:.2g} % of the kinetic energy of the kept modes",
        {"inertia": inertia, "kinetic_share": share, "threshold": float(settings.inertia_share)},
    )


def condensation_rules(series: SeriesShafts, model: Model, damping: NDArray[np.float64]) -> list[AppliedRule]:
    """Return the rules that join springs, with stiffness and damping of the equivalent shafts."""
    values = model.values
    stiffness = evaluate_matrix(model.stiffness, values)
    rules = []
    for name, parts in series.members.items():
        c, d = values[_symbol(series, name, "stiffness")], values[_symbol(series, name, "damping")]
        why = f"in series they act as one shaft of {c:.6g} N m/rad and {d:.3g} N m s/rad"
        rules.append(AppliedRule("condense", ", ".join(parts), why, {"stiffness": c, "damping": d}))
    for index, twist in enumerate(model.twists):
        members = [name for name, row in model.spring_rows.items() if row[0, index] != 0]
        if len(members) < 2:
            continue
        c, d = float(stiffness[index, index]), float(damping[index, index])
        row = evaluate_matrix(model.twist_rows, values)[index]
        terms = " ".join(
            f"{value:+.4g} {name.removesuffix('.shaft')}"
            for name, value in zip(model.coordinates, row, strict=True)
            if value
        )
        why = f"in static balance {', '.join(members)} act as one shaft of {c:.6g} N m/rad on {terms}"
        rules.append(AppliedRule("condense", twist, why, {"stiffness": c, "damping": d}))
    return rules


def _symbol(series: SeriesShafts, name: str, quantity: str) -> sp.Symbol:
    return next(symbol for symbol in series.definitions if symbol.name == f"{name}_{quantity}")


def reference_rules(mechanism: Mechanism, model: Model) -> list[AppliedRule]:
    """List the ratios that the choice of the machines' velocities as coordinates has eliminated."""
    rules = []
    for constraint in mechanism.constraints:
        free = sorted(
            {symbol for value in constraint.row.values() for symbol in sp.sympify(value).free_symbols},
            key=lambda symbol: symbol.name,
        )
        if len(constraint.row) == 2 and len(free) == 1:
            ratio = model.values[free[0]]
            why = f"quantities behind it are referred to the machine's side with the ratio {ratio:g}"
            rules.append(AppliedRule("refer", constraint.owner, why, {"ratio": ratio}))
    return rules


def damping_rule(after: tuple[Mode, ...]) -> AppliedRule:
    """Return the rule that drops internal damping, with the damping ratio that goes with it."""
    elastic = [mode for mode in after if mode.frequency_hz > 0]
    largest = max((mode.damping_ratio for mode in elastic), default=0.0)
    return AppliedRule(
        "drop damping",
        "shafts",
        f"internal damping gives the kept modes a damping ratio of {largest:.2g}; active damping replaces it",
        {"damping_ratio": largest},
    )

"""Model reduction: the smallest model that keeps the modes in which the machines take part.

The modes to keep are the rigid-body modes and as many elastic ones, from the lowest up, as there are twists
between the machines. A part may go if it takes hardly any share in any motion made of these modes:

* an inertia is dropped if its share of the kinetic energy stays below `inertia_share`;
* a shaft is made rigid if its share of the strain energy stays below `stiffness_share`, where an inertia that
  must stay would otherwise keep it as a state;
* velocities without inertia are condensed statically (`ptgen.mechanism.assembly`);
* losses, internal damping, lag and delay of the drives and filters of the sensors are left out, torques of fluids too,
  and the gaps of shafts are closed.

Friction elements that couple, such as clutches and limited slips, act as disturbances; those that the file names in
`locked` are rigid, in the full model too that the reduced one is compared with. What no machine acts on while they slip
is left out (`ptgen.mechanism.idle_parts`).

Every rule that was applied is listed with the numbers that justify it, and with the modes before and after.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.elements import Friction, FrictionRole, Spring
from ptgen.errors import ModelError, Problem, nearest
from ptgen.mechanism.applied_rules import (
    AppliedRule,
    backlash_rule,
    condensation_rules,
    damping_rule,
    drive_rules,
    fluid_rule,
    idle_rule,
    inertia_rule,
    lock_rule,
    loss_rule,
    reference_rules,
    rigid_rule,
    sensor_rules,
)
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.idle_parts import component_of, idle_parts, without_parts
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.modes import Mode, modes
from ptgen.mechanism.participation import Participation
from ptgen.mechanism.series import join_series
from ptgen.testbed.testbed import ReductionSettings

__all__ = ["ReducedModel", "is_left_to_integrators", "reduce_mechanism"]


_SYMBOLIC_MACHINES = 3
"""With more machines stiffnesses enter the reduced model as numbers; ratios, inertias and damping stay symbols.

Around a tree of differentials the formulas of the torque split over unequal shafts grow beyond what anybody reads.
"""


@dataclass(frozen=True)
class ReducedModel:
    """A reduced model, and how it came about.

    Attributes
    ----------
    model : Model
        Undamped, over the velocities of the machines; friction that couples acts as a disturbance.
    mechanism : Mechanism
        The reduced elements.
    original : Mechanism
        The elements before reduction, gaps closed and what the file names locked.
    full : Model
        The full model of these.
    rules : tuple of AppliedRule
    modes_before, modes_after : tuple of Mode
        Modes of the full model, without what no machine acts on, and of the reduced model; friction elements are free
        unless they are locked.
    equivalent_damping : ndarray (n_e, n_e)
        Damping of the twists (N m s/rad) as (3.7) gives it; left out of `model`.
    parameters : mapping of str to float
        The numbers of the reduced model in SI units.
    definitions : mapping of Symbol to Expr
        Parameters of equivalent shafts in terms of those of the bed.
    """

    model: Model
    mechanism: Mechanism
    original: Mechanism
    full: Model
    rules: tuple[AppliedRule, ...]
    modes_before: tuple[Mode, ...]
    modes_after: tuple[Mode, ...]
    equivalent_damping: NDArray[np.float64]
    parameters: Mapping[str, float]
    definitions: Mapping[sp.Symbol, sp.Expr]


def reduce_mechanism(mechanism: Mechanism, settings: ReductionSettings, full: Model | None = None) -> ReducedModel:
    """Reduce a mechanism for controller design.

    Parameters
    ----------
    mechanism : Mechanism
    settings : ReductionSettings
        Thresholds, components that must be rigid, kept or dropped, and friction elements that are locked.
    full : Model, optional
        The full model with closed gaps and nothing locked, if it was assembled already.

    Raises
    ------
    ModelError
        If a component named in the settings has nothing that could be kept, dropped or made rigid, a name in
        `locked` is no friction element, or a machine cannot turn while these are locked.

    References
    ----------
    Section 5.3 of the source: (5.1)-(5.14); Appendix B.
    """
    _check_settings(mechanism, settings)
    rules = [backlash_rule(mechanism, spring) for spring in mechanism.springs if spring.backlash is not None]
    rules += [fluid_rule(fluid, settings.locked) for fluid in mechanism.fluids]
    rules += [lock_rule(mechanism, name) for name in sorted(set(settings.locked))]
    mechanism = mechanism.with_closed_backlash().without_fluids()
    if settings.locked:
        mechanism, full = mechanism.with_locked_frictions(set(settings.locked)), None
    full = full or assemble(mechanism)
    _check_rotors(full, settings)
    idle = idle_parts(mechanism, settings.keep)
    rules += [idle_rule(mechanism, part) for part in idle]
    driven = without_parts(mechanism, idle)
    compared = assemble(driven) if idle else full
    before = modes(compared)

    kept = {friction.name for friction in driven.frictions}
    losses = {friction.name for friction in mechanism.frictions if is_left_to_integrators(friction)} & kept
    rules += [loss_rule(mechanism, name) for name in sorted(losses)]
    reduced = driven.without_frictions(losses)
    rules += drive_rules(mechanism, before)
    rules += sensor_rules(mechanism, before)

    participation = Participation(compared, before, _machine_twists(compared))
    removable = _removable(reduced, participation, settings)
    stay = {body.velocity for body in reduced.bodies} - removable - set(reduced.machine_velocities)
    rigid = set(settings.rigid) & {spring.name for spring in reduced.springs}
    if stay:
        rigid |= {
            spring.name
            for spring in reduced.springs
            if participation.strain(spring.name) <= settings.stiffness_share and spring.name not in settings.keep
        }
    rules += [rigid_rule(name, participation, settings) for name in sorted(rigid)]
    reduced = reduced.with_rigid_springs(rigid)

    rules += [inertia_rule(reduced, velocity, participation, settings) for velocity in sorted(removable)]
    reduced = reduced.without_bodies(removable)

    series = join_series(reduced)
    reduced = _with_numbers(series.mechanism) if len(mechanism.torques) > _SYMBOLIC_MACHINES else series.mechanism
    undamped = replace(
        _viscous_free(reduced),
        springs=tuple(replace(spring, damping=sp.Integer(0)) for spring in reduced.springs),
    )
    model = assemble(undamped, first="machines")
    damping = _equivalent_damping(model, reduced)
    after = modes(replace(model, damping=sp.Matrix(damping)))
    rules += condensation_rules(series, model, damping)
    rules += reference_rules(reduced, model)
    rules.append(damping_rule(after))
    return ReducedModel(
        model=model,
        mechanism=undamped,
        original=mechanism,
        full=full,
        rules=tuple(rules),
        modes_before=before,
        modes_after=after,
        equivalent_damping=damping,
        parameters=_parameters(model, damping),
        definitions=series.definitions,
    )


def is_left_to_integrators(friction: Friction) -> bool:
    """Tell whether an element is left to the integrators of the controllers: a loss, or a brake against the housing."""
    return friction.role is FrictionRole.LOSS or (friction.role is FrictionRole.COUPLING and len(friction.row) == 1)


def _with_numbers(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism with the values of all stiffnesses in place of their symbols."""
    values = mechanism.values

    def number(spring: Spring) -> sp.Rational:
        return _simplest_fraction(float(evaluate_matrix(sp.Matrix([[spring.stiffness]]), values)[0, 0]))

    return replace(mechanism, springs=tuple(replace(spring, stiffness=number(spring)) for spring in mechanism.springs))


def _simplest_fraction(value: float) -> sp.Rational:
    """Return a fraction with a short denominator that is right to ten digits.

    Exact elimination multiplies these numbers; with long ones the polynomials' greatest common divisors take most of
    the time of a design. Shafts in series are such fractions: 380 and 40 kN m/rad give 36190 + 10/21 N m/rad.
    """
    exact = sp.Rational(value)
    for digits in range(16):
        near = exact.limit_denominator(10**digits)
        if abs(near - exact) <= abs(exact) / 10**10:
            return near
    return exact


def _check_settings(mechanism: Mechanism, settings: ReductionSettings) -> None:
    springs = {spring.name for spring in mechanism.springs}
    bodies = {component_of(body.velocity) for body in mechanism.bodies}
    machines = {torque.name for torque in mechanism.torques}
    problems = []
    for key, known in (("rigid", springs), ("keep", springs | bodies), ("drop", bodies - machines)):
        for name in getattr(settings, key):
            if name not in known:
                what = f'"{name}" has nothing to which this applies'
                problems.append(Problem(f"reduction.{key}", what, nearest(name, known)))
    frictions = [friction.name for friction in mechanism.frictions]
    for name in settings.locked:
        if name not in frictions:
            what = f'"{name}" is no friction element of this bed'
            remedy = nearest(name, frictions) if frictions else "remove it: the bed has none"
            problems.append(Problem("reduction.locked", what, remedy))
    changing = {parameter.symbol: parameter.owner for parameter in mechanism.changing}
    for friction in mechanism.frictions:
        symbols = set().union(*(sp.sympify(entry).free_symbols for entry in friction.row.values()))
        owner = next((name for symbol, name in changing.items() if symbol in symbols), None)
        if friction.name in settings.locked and owner is not None:
            what = f'"{friction.name}" acts through a ratio that changes at run time'
            problems.append(Problem("reduction.locked", what, f'write as_ratio = ["{owner}"] in [reduction] instead'))
    if problems:
        raise ModelError(problems)


def _check_rotors(full: Model, settings: ReductionSettings) -> None:
    """Raise if a locked element holds a machine, such as a brake on its shaft."""
    held = [
        torque.name
        for torque in full.inputs
        if all(entry == 0 for velocity in torque.row for entry in full.velocity_rows[velocity])
    ]
    if held:
        what = f"{', '.join(held)} cannot turn with {', '.join(dict.fromkeys(settings.locked))} locked"
        raise ModelError(Problem("reduction.locked", what, "remove the element that holds it from the list"))


def _viscous_free(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism whose friction elements are pure disturbances."""
    return replace(mechanism, frictions=tuple(replace(f, viscous=sp.Integer(0)) for f in mechanism.frictions))


def _machine_twists(full: Model) -> int:
    """Return the number of independent twists between the machines once all else is without inertia.

    The machines can move in as many ways as they have independent speeds; the ways that strain nothing are no
    twists.
    """
    E = full.numeric().twist_rows
    rotors = np.vstack(
        [evaluate_matrix(full.velocity_rows[next(iter(torque.row))], full.values) for torque in full.inputs]
    )
    unstrained = scipy.linalg.null_space(E) if E.size else np.eye(len(full.coordinates))
    free = int(np.linalg.matrix_rank(rotors @ unstrained)) if unstrained.size else 0
    return int(np.linalg.matrix_rank(rotors)) - free


def _removable(mechanism: Mechanism, participation: Participation, settings: ReductionSettings) -> set[str]:
    rotors = set(mechanism.machine_velocities)
    result = set()
    for body in mechanism.bodies:
        name = component_of(body.velocity)
        if body.velocity in rotors or name in settings.keep:
            continue
        if name in settings.drop or participation.kinetic(body.velocity) <= settings.inertia_share:
            result.add(body.velocity)
    return result


def _equivalent_damping(model: Model, mechanism: Mechanism) -> NDArray[np.float64]:
    """Return ``Psi' D Psi`` over the twists: every shaft's damping with the share of the twist that it takes."""
    size = len(model.twists)
    result = np.zeros((size, size))
    for spring in mechanism.springs:
        share = evaluate_matrix(model.spring_rows[spring.name], model.values)
        result += evaluate_matrix(sp.Matrix([[spring.damping]]), model.values)[0, 0] * share.T @ share
    return result


def _parameters(model: Model, damping: NDArray[np.float64]) -> dict[str, float]:
    """Return inertias, twist rows, stiffnesses and friction rows of the reduced model by name."""
    values = model.values
    numeric = model.numeric()
    result: dict[str, float] = {}
    for i, name in enumerate(model.coordinates):
        result[f"inertia {name}"] = float(numeric.mass[i, i])
        for j in range(i):
            if numeric.mass[i, j] != 0:
                result[f"inertia {model.coordinates[j]} {name}"] = float(numeric.mass[i, j])
    for i, twist in enumerate(model.twists):
        result[f"stiffness {twist}"] = float(numeric.stiffness[i, i])
        result[f"damping {twist}"] = float(damping[i, i])
        for j in range(i):
            if numeric.stiffness[i, j] != 0:
                result[f"stiffness {model.twists[j]} {twist}"] = float(numeric.stiffness[i, j])
        for j, name in enumerate(model.coordinates):
            result[f"twist {twist} {name}"] = float(numeric.twist_rows[i, j])
    for i, friction in enumerate(model.frictions):
        for j, name in enumerate(model.coordinates):
            result[f"slip {friction.name} {name}"] = float(
                evaluate_matrix(model.friction_rows[i, j : j + 1], values)[0, 0]
            )
    return result

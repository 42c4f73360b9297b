"""Model reduction: the smallest model that keeps the modes in which the machines take part.

The modes to keep are the rigid-body modes and as many elastic ones, from the lowest up, as there are twists
between the machines. A part may go if it takes hardly any share in any motion made of these modes:

* an inertia is dropped if its share of the kinetic energy stays below `inertia_share`;
* a shaft is made rigid if its share of the strain energy stays below `stiffness_share`, where an inertia that
  must stay would otherwise keep it as a state;
* velocities without inertia are condensed statically (`ptgen.mechanism.assembly`);
* losses, internal damping, lag and dead time of the drives are left out.

Every rule that was applied is listed with the numbers that justify it, and with the modes before and after.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.elements import FrictionRole
from ptgen.errors import ModelError, Problem, nearest
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.modes import Mode, modes
from ptgen.mechanism.series import SeriesShafts, join_series
from ptgen.testbed.testbed import ReductionSettings

__all__ = ["AppliedRule", "ReducedModel", "reduce_mechanism"]


@dataclass(frozen=True)
class AppliedRule:
    """One rule that was applied to one element.

    Attributes
    ----------
    rule : str
        ``drop losses``, ``drop damping``, ``idealise drive``, ``drop inertia``, ``rigidise``, ``condense`` or
        ``refer``.
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


@dataclass(frozen=True)
class ReducedModel:
    """A reduced model, and how it came about.

    Attributes
    ----------
    model : Model
        Undamped, over the velocities of the machines; the limited slip acts as a disturbance.
    mechanism : Mechanism
        The reduced elements.
    original : Mechanism
        The elements before reduction.
    rules : tuple of AppliedRule
    modes_before, modes_after : tuple of Mode
        Modes of the full and of the reduced model, friction elements free.
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
        Thresholds, and components that must be rigid, kept or dropped.
    full : Model, optional
        The full model, if it was assembled already.

    Raises
    ------
    ModelError
        If a component named in the settings has nothing that could be kept, dropped or made rigid.

    References
    ----------
    Section 5.3 of the source: (5.1)-(5.14); Appendix B.
    """
    _check_settings(mechanism, settings)
    full = full or assemble(mechanism)
    before = modes(full)
    rules: list[AppliedRule] = []

    losses = {f.name for f in mechanism.frictions if f.role is FrictionRole.LOSS}
    rules += [_loss_rule(mechanism, name) for name in sorted(losses)]
    reduced = mechanism.without_frictions(losses)
    rules += _drive_rules(mechanism, before)

    participation = _Participation(full, before, _machine_twists(full))
    removable = _removable(reduced, participation, settings)
    stay = {body.velocity for body in reduced.bodies} - removable - set(reduced.machine_velocities)
    rigid = set(settings.rigid)
    if stay:
        rigid |= {
            spring.name
            for spring in reduced.springs
            if participation.strain(spring.name) <= settings.stiffness_share and spring.name not in settings.keep
        }
    rules += [_rigid_rule(name, participation, settings) for name in sorted(rigid)]
    reduced = reduced.with_rigid_springs(rigid)

    rules += [_inertia_rule(reduced, velocity, participation, settings) for velocity in sorted(removable)]
    reduced = reduced.without_bodies(removable)

    series = join_series(reduced)
    reduced = series.mechanism
    undamped = replace(
        _viscous_free(reduced),
        springs=tuple(replace(spring, damping=sp.Integer(0)) for spring in reduced.springs),
    )
    model = assemble(undamped, first="machines")
    damping = _equivalent_damping(model, reduced)
    after = modes(replace(model, damping=sp.Matrix(damping)))
    rules += _condensation_rules(series, model, damping)
    rules += _reference_rules(reduced, model)
    rules.append(_damping_rule(after))
    return ReducedModel(
        model=model,
        mechanism=undamped,
        original=mechanism,
        rules=tuple(rules),
        modes_before=before,
        modes_after=after,
        equivalent_damping=damping,
        parameters=_parameters(model, damping),
        definitions=series.definitions,
    )


class _Participation:
    """Shares of elements in the motions that the reduced model must keep."""

    def __init__(self, full: Model, before: tuple[Mode, ...], twists: int) -> None:
        self._values = full.values
        self._full = full
        rigid = [mode.vector for mode in before if mode.frequency_hz == 0]
        elastic = [mode for mode in before if mode.frequency_hz > 0][:twists]
        self.kept = tuple(mode.frequency_hz for mode in elastic)
        # The vectors have unit kinetic energy and are orthogonal in it, so shares are sums of squares.
        self._all = np.array(rigid + [mode.vector for mode in elastic])
        self._elastic = np.array([mode.vector / (2 * np.pi * mode.frequency_hz) for mode in elastic])

    def kinetic(self, velocity: str) -> float:
        """Return the largest share of a body in the kinetic energy of any kept motion."""
        row = evaluate_matrix(self._full.body_rows[velocity], self._values)[0]
        inertia = evaluate_matrix(sp.Matrix([[self._full.body_inertias[velocity]]]), self._values)[0, 0]
        return float(inertia * np.sum((self._all @ row) ** 2))

    def strain(self, spring: str) -> float:
        """Return the largest share of a spring in the strain energy of any kept elastic motion."""
        if not len(self._elastic):
            return 0.0
        row = self._full.spring_rows[spring] * self._full.twist_rows
        stiffness = evaluate_matrix(sp.Matrix([[self._full.spring_stiffness[spring]]]), self._values)[0, 0]
        return float(stiffness * np.sum((self._elastic @ evaluate_matrix(row, self._values)[0]) ** 2))


def _component(velocity: str) -> str:
    return velocity.split(".", 1)[0]


def _check_settings(mechanism: Mechanism, settings: ReductionSettings) -> None:
    springs = {spring.name for spring in mechanism.springs}
    bodies = {_component(body.velocity) for body in mechanism.bodies}
    machines = {torque.name for torque in mechanism.torques}
    problems = []
    for key, known in (("rigid", springs), ("keep", springs | bodies), ("drop", bodies - machines)):
        for name in getattr(settings, key):
            if name not in known:
                what = f'"{name}" has nothing to which this applies'
                problems.append(Problem(f"reduction.{key}", what, nearest(name, known)))
    if problems:
        raise ModelError(problems)


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


def _removable(mechanism: Mechanism, participation: _Participation, settings: ReductionSettings) -> set[str]:
    rotors = set(mechanism.machine_velocities)
    result = set()
    for body in mechanism.bodies:
        name = _component(body.velocity)
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


def _loss_rule(mechanism: Mechanism, name: str) -> AppliedRule:
    friction = next(f for f in mechanism.frictions if f.name == name)
    values = mechanism.values
    coulomb = evaluate_matrix(sp.Matrix([[friction.coulomb]]), values)[0, 0]
    load = evaluate_matrix(sp.Matrix([[friction.load.coefficient]]), values)[0, 0] if friction.load else 0.0
    return AppliedRule(
        "drop losses",
        name,
        f"the torque controller's integrator covers {coulomb:g} N m and {100 * load:.3g} % of the torque",
        {"coulomb": coulomb, "load": load},
    )


def _drive_rules(mechanism: Mechanism, before: tuple[Mode, ...]) -> list[AppliedRule]:
    elastic = [mode.frequency_hz for mode in before if mode.frequency_hz > 0]
    rules = []
    for torque in mechanism.torques:
        parts = [part for part in (torque.drive.time_constant, torque.drive.dead_time) if part is not None]
        if not parts or not elastic:
            continue
        delay = sum(mechanism.values[part] for part in parts)
        degrees = 360.0 * delay * elastic[0]
        why = f"{1e6 * delay:.0f} us are {degrees:.2g} degrees of phase at the first mode, {elastic[0]:.3g} Hz"
        rules.append(AppliedRule("idealise drive", torque.name, why, {"delay": delay, "phase_degrees": degrees}))
    return rules


def _rigid_rule(name: str, participation: _Participation, settings: ReductionSettings) -> AppliedRule:
    share = participation.strain(name)
    reason = "asked for in the file; " if name in settings.rigid else ""
    return AppliedRule(
        "rigidise",
        name,
        f"{reason}it holds at most {100 * share:.2g} % of the strain energy of the kept modes",
        {"strain_share": share, "threshold": float(settings.stiffness_share)},
    )


def _inertia_rule(
    mechanism: Mechanism, velocity: str, participation: _Participation, settings: ReductionSettings
) -> AppliedRule:
    share = participation.kinetic(velocity)
    body = next(item for item in mechanism.bodies if item.velocity == velocity)
    inertia = evaluate_matrix(sp.Matrix([[body.inertia]]), mechanism.values)[0, 0]
    reason = "asked for in the file; " if _component(velocity) in settings.drop else ""
    return AppliedRule(
        "drop inertia",
        velocity,
        f"{reason}{inertia:.3g} kg m^2 hold at most {100 * share:.2g} % of the kinetic energy of the kept modes",
        {"inertia": inertia, "kinetic_share": share, "threshold": float(settings.inertia_share)},
    )


def _condensation_rules(series: SeriesShafts, model: Model, damping: NDArray[np.float64]) -> list[AppliedRule]:
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


def _reference_rules(mechanism: Mechanism, model: Model) -> list[AppliedRule]:
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


def _damping_rule(after: tuple[Mode, ...]) -> AppliedRule:
    elastic = [mode for mode in after if mode.frequency_hz > 0]
    largest = max((mode.damping_ratio for mode in elastic), default=0.0)
    return AppliedRule(
        "drop damping",
        "shafts",
        f"internal damping gives the kept modes a damping ratio of {largest:.2g}; active damping replaces it",
        {"damping_ratio": largest},
    )


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

"""From a mechanism to its minimal model: coordinates, static condensation, twists, signals.

1. ``v = S z``: coordinates are chosen greedily from an ordered list of candidate velocities, and ``S`` follows
   by exact elimination of all constraints.
2. Velocities without inertia are condensed statically: with ``Psi = [I; -K_mm^-1 K_mk]`` stiffness becomes
   ``Psi' K Psi`` and damping ``Psi' D Psi``. Equivalent shafts (3.6), (3.7), (B.25), (B.27), the equivalent
   stiffness (5.2), (5.10) and the torque split (5.1) are all this one rule.
3. Twist states are a maximal independent set of spring twists.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ptgen.elements import Row, Spring
from ptgen.errors import ModelError, Problem
from ptgen.mechanism import exact
from ptgen.mechanism.coordinates import Coordinates, First, choose_coordinates, with_exact_loops
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import LinearForm, Model
from ptgen.mechanism.signals import SignalForms

__all__ = ["assemble"]

_FRACTION_SYMBOLS = 24
"""Ratios and inertias up to which an entry of the inertia matrix is brought to one fraction."""


def assemble(mechanism: Mechanism, first: First = "frictions") -> Model:
    """Derive the minimal equations of motion.

    Parameters
    ----------
    mechanism : Mechanism
        The elements of the bed.
    first : {"frictions", "machines"}
        Which velocities become coordinates first: those of the friction elements (the friction-state transform
        of source Section 4.2, for simulation), or those of the machines (for control).

    Raises
    ------
    ModelError
        If a velocity has neither inertia nor stiffness, a friction element or a shaft with backlash acts where
        there is no inertia, or inertias are coupled rigidly by a ratio that changes at run time.
    """
    mechanism, fixed = with_exact_loops(mechanism, first)
    coordinates = choose_coordinates(mechanism, first)
    if first == "frictions":
        _check_massless(mechanism, coordinates)
    condensed = _condense(mechanism, coordinates, first)
    _check_changing(mechanism, condensed, first)
    return _model(mechanism, condensed, fixed)


@dataclass(frozen=True)
class _Condensed:
    """Everything over the coordinates that carry inertia.

    `follow` maps them to all velocities, `offset` gives the displacement of all velocities per unit of friction
    or contact torque that the condensed part takes statically. `is_static` tells whether there is such a part.
    """

    names: tuple[str, ...]
    follow: sp.Matrix
    offset: sp.Matrix
    is_static: bool


def _condense(mechanism: Mechanism, coordinates: Coordinates, first: First) -> _Condensed:
    velocities = mechanism.velocities
    kept, S = coordinates.with_inertia, coordinates.S
    if kept == len(coordinates.names):
        columns = len(mechanism.frictions) + len(_contacts(mechanism)) + 2 * len(mechanism.fluids)
        return _Condensed(coordinates.names, S, sp.zeros(len(velocities), columns), False)
    springs = exact.stack([exact.row_vector(s.row, velocities) for s in mechanism.springs], len(velocities)) * S
    acting = [f.row for f in mechanism.frictions] + [spring.row for spring in _contacts(mechanism)]
    acting += _fluid_rows(mechanism)
    frictions = exact.stack([exact.row_vector(row, velocities) for row in acting], len(velocities)) * S
    K = springs.T * sp.diag(*[spring.stiffness for spring in mechanism.springs]) * springs
    try:
        solved = exact.solve(K[kept:, kept:], K[kept:, :kept].row_join(frictions[:, kept:].T))
    except exact.SingularMatrixError:
        loose = ", ".join(coordinates.names[kept:])
        raise ModelError(
            Problem(
                loose,
                "has neither inertia nor a shaft that holds it, so its motion is not determined",
                "give one of its components an inertia, or connect it through a shaft",
            )
        ) from None
    Psi = sp.eye(kept).col_join(-solved[:, :kept])
    offset = sp.zeros(kept, frictions.shape[0]).col_join(-solved[:, kept:])
    return _Condensed(coordinates.names[:kept], exact.canonical(S * Psi), exact.canonical(S * offset), True)


def _fluid_rows(mechanism: Mechanism) -> list[Row]:
    return [row for fluid in mechanism.fluids for row in fluid.rows]


def _contacts(mechanism: Mechanism) -> list[Spring]:
    return [spring for spring in mechanism.springs if spring.backlash is not None]


def _check_massless(mechanism: Mechanism, coordinates: Coordinates) -> None:
    """Raise if a friction element or a contact can move while no body does.

    Its velocity must follow from those of the bodies.
    """
    velocities, S = mechanism.velocities, coordinates.S
    bodies = exact.stack(
        [exact.row_vector({body.velocity: sp.Integer(1)}, velocities) for body in mechanism.bodies], len(velocities)
    )
    rank = exact.rank(bodies * S)
    friction_text = "is a friction element on a velocity without inertia, where sticking and slipping are not defined"
    contact_text = "has backlash and an end without inertia, whose motion inside the gap is not determined"
    elements = [(friction.name, friction.row, friction_text) for friction in mechanism.frictions]
    elements += [(spring.name, spring.row, contact_text) for spring in _contacts(mechanism)]
    problems = [
        Problem(name, what, "give the component on one of its sides an inertia")
        for name, row, what in elements
        if exact.rank(bodies.col_join(exact.row_vector(row, velocities)) * S) > rank
    ]
    if problems:
        raise ModelError(problems)


def _check_changing(mechanism: Mechanism, condensed: _Condensed, first: First) -> None:
    """Raise if inertias are coupled rigidly by a ratio that changes: it would have to move them both at once."""
    follow = dict(zip(mechanism.velocities, condensed.follow.tolist(), strict=True))
    problems = []
    for parameter in mechanism.changing:
        bodies = [
            body.velocity
            for body in mechanism.bodies
            if any(parameter.symbol in sp.sympify(entry).free_symbols for entry in follow[body.velocity])
        ]
        if bodies:
            others = [
                coordinate
                for column, coordinate in enumerate(condensed.names)
                if any(follow[body][column] for body in bodies)
            ]
            what = (
                f"changes at run time, but couples the inertias of {', '.join(dict.fromkeys(bodies))} rigidly to "
                f"{', '.join(others)}"
            )
            remedy = "put a shaft on one side of the gearbox, with no inertia between the two, or remove ratio_range"
            if first == "machines":
                remedy = "name the shaft beside the gearbox in reduction.keep, or the inertia in reduction.drop"
            problems.append(Problem(f"components.{parameter.owner}.ratio_range", what, remedy))
    if problems:
        raise ModelError(problems)


def _twists(
    springs: Sequence[Spring], rows: sp.Matrix, changing: set[sp.Symbol], is_static: bool
) -> tuple[tuple[str, ...], sp.Matrix, sp.Matrix]:
    """Return names, rows ``E`` and the combination ``L`` with ``spring rows = L E``.

    A row is scaled so that its first coefficient is 1 in size: then the twist of a condensed chain is that
    between its ends, (5.5) of the source. Coefficients that change with a ratio cannot be scaled to 1, because the
    twist is the integral of the row; but where velocities were condensed (`is_static`) the source takes the equivalent
    stiffness across a changing ratio as constant over time, (5.44)-(5.46), and the twist as that between the ends.

    Where shafts meet in a point without inertia, the stiffnesses decide where that point goes, and with it every
    twist; then the rows are replaced by the reduced ones of the space that they span. What strains nothing is a matter
    of gear ratios alone, so these are free of stiffnesses.
    """
    independent = exact.independent_rows(rows)
    names, scaled = [], []
    for index in independent:
        row = rows[index, :]
        steady = [entry for entry in row if entry != 0 and not entry.free_symbols & changing]
        first = next(entry for entry in row if entry != 0) if is_static else sp.Integer(1)
        leading = next(iter(steady), first)
        factor = sp.Integer(1) if leading.is_Integer else sp.cancel(1 / leading)
        scaled.append(exact.canonical(row * factor))
        names.append(springs[index].name)
    E = exact.stack(scaled, rows.shape[1])
    stiffnesses: set[sp.Basic] = set().union(*(sp.sympify(spring.stiffness).free_symbols for spring in springs))
    if E.free_symbols & stiffnesses:
        E = exact.reduced_rows(E)
    L = exact.canonical(exact.row_combination(rows, E)) if independent else sp.zeros(rows.shape[0], 0)
    return tuple(names), E, L


def _mass(rows: sp.Matrix, inertias: Sequence[sp.Expr]) -> sp.Matrix:
    """Return the inertia matrix, in its entries one fraction each, or one term per inertia where these are many.

    A common denominator over all ratios and inertias of a gear set is nothing to read, and minutes to find.
    """
    names = rows.free_symbols.union(*(sp.sympify(inertia).free_symbols for inertia in inertias))
    if len(names) <= _FRACTION_SYMBOLS:
        return exact.canonical(rows.T * sp.diag(*inertias) * rows)
    result = sp.zeros(rows.shape[1], rows.shape[1])
    for index, inertia in enumerate(inertias):
        result += inertia * exact.canonical(rows[index, :].T * rows[index, :])
    return result


def _model(mechanism: Mechanism, condensed: _Condensed, fixed: tuple[sp.Symbol, ...]) -> Model:
    velocities, follow = mechanism.velocities, condensed.follow
    n_z, n_u = len(condensed.names), len(mechanism.torques)

    def rows(elements: Sequence[Row]) -> sp.Matrix:
        stacked = exact.stack([exact.row_vector(row, velocities) for row in elements], len(velocities))
        return exact.canonical(stacked * follow)

    body_rows = rows([{body.velocity: sp.Integer(1)} for body in mechanism.bodies])
    spring_rows = rows([spring.row for spring in mechanism.springs])
    changing = {parameter.symbol for parameter in mechanism.changing}
    twists, E, L = _twists(mechanism.springs, spring_rows, changing, condensed.is_static)
    linear = [sp.Integer(0 if spring.backlash is not None else 1) for spring in mechanism.springs]
    c = sp.diag(*[spring.stiffness * factor for spring, factor in zip(mechanism.springs, linear, strict=True)])
    d = sp.diag(*[spring.damping * factor for spring, factor in zip(mechanism.springs, linear, strict=True)])
    contacts = _contacts(mechanism)
    columns = len(mechanism.frictions) + len(contacts) + 2 * len(mechanism.fluids)
    velocity_rows = {name: follow[index, :] for index, name in enumerate(velocities)}
    n_e = len(twists)

    spring_torques: dict[str, LinearForm] = {}
    for index, spring in enumerate(mechanism.springs):
        if spring in contacts:
            unit = sp.zeros(1, columns)
            unit[0, len(mechanism.frictions) + contacts.index(spring)] = sp.Integer(1)
            spring_torques[spring.name] = LinearForm(
                z=sp.zeros(1, n_z), e=sp.zeros(1, n_e), u=sp.zeros(1, n_u), f=unit, a=sp.zeros(1, n_z)
            )
            continue
        twist = L[index, :]
        offset = exact.row_vector(spring.row, velocities) * condensed.offset
        spring_torques[spring.name] = LinearForm(
            z=exact.canonical(spring.damping * twist * E) if n_e else sp.zeros(1, n_z),
            e=exact.canonical(spring.stiffness * twist),
            u=sp.zeros(1, n_u),
            f=exact.canonical(spring.stiffness * offset),
            a=sp.zeros(1, n_z),
        )

    return Model(
        name=mechanism.name,
        coordinates=condensed.names,
        velocity_rows=velocity_rows,
        mass=_mass(body_rows, [body.inertia for body in mechanism.bodies]),
        twists=twists,
        twist_rows=E,
        stiffness=exact.canonical(L.T * c * L),
        damping=exact.canonical(L.T * d * L),
        inputs=mechanism.torques,
        input_rows=rows([torque.row for torque in mechanism.torques]),
        frictions=mechanism.frictions,
        friction_rows=rows([friction.row for friction in mechanism.frictions]),
        sensors=mechanism.sensors,
        signals=SignalForms(mechanism, velocity_rows, spring_torques, n_e).all(),
        parameters=mechanism.parameters,
        body_rows={body.velocity: body_rows[index, :] for index, body in enumerate(mechanism.bodies)},
        body_inertias={body.velocity: body.inertia for body in mechanism.bodies},
        spring_rows={spring.name: L[index, :] for index, spring in enumerate(mechanism.springs)},
        spring_stiffness={spring.name: spring.stiffness for spring in mechanism.springs},
        spring_damping={spring.name: spring.damping for spring in mechanism.springs},
        fixed=fixed,
        contacts=tuple(contacts),
        contact_rows=rows([spring.row for spring in contacts]),
        contact_twists=exact.stack([L[mechanism.springs.index(s), :] for s in contacts], n_e),
        fluids=mechanism.fluids,
        fluid_rows=rows(_fluid_rows(mechanism)),
    )

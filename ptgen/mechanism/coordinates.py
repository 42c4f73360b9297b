"""The choice of independent velocities: ``v = S z`` by exact elimination of all constraints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import sympy as sp

from ptgen.errors import ModelError, Problem
from ptgen.mechanism import exact
from ptgen.mechanism.mechanism import Mechanism

__all__ = ["Coordinates", "First", "choose_coordinates", "with_exact_loops"]

First = Literal["frictions", "machines"]


@dataclass(frozen=True)
class Coordinates:
    """``v = S z``; the first `with_inertia` coordinates carry all bodies."""

    names: tuple[str, ...]
    S: sp.Matrix
    with_inertia: int


def with_exact_loops(mechanism: Mechanism, first: First) -> tuple[Mechanism, tuple[sp.Symbol, ...]]:
    """Replace the ratios of rigid loops by their values.

    Over independent symbols a loop of gears would be locked, or would let velocities differ that are the same; it
    moves because its ratios agree as numbers. So the ratios stand as numbers as soon as they make a row of the
    constraints, or a velocity that would become a coordinate, depend on those before it.

    Raises
    ------
    ModelError
        If a ratio of such a loop changes at run time.
    """
    constraint_rows = _constraint_rows(mechanism)
    symbols = sorted(constraint_rows.free_symbols, key=lambda symbol: symbol.name)
    exact_values = {symbol: sp.Rational(str(mechanism.values[symbol])) for symbol in symbols}
    candidates, _ = _candidates(mechanism, first)
    rows = exact.stack([constraint_rows, *(row for _, row in candidates)], len(mechanism.velocities))
    independent = exact.independent_rows(rows.subs(exact_values))
    if not symbols or exact.independent_rows(rows) == independent:
        return mechanism, ()
    changing = {parameter.symbol for parameter in mechanism.changing}
    symbols = [symbol for symbol in symbols if symbol not in changing]
    exact_values = {symbol: exact_values[symbol] for symbol in symbols}
    if exact.independent_rows(rows.subs(exact_values)) != independent:
        raise _changing_loop(mechanism)
    constraints = tuple(
        replace(
            constraint,
            row={name: sp.sympify(value).subs(exact_values) for name, value in constraint.row.items()},
        )
        for constraint in mechanism.constraints
    )
    return replace(mechanism, constraints=constraints), tuple(symbols)


def _changing_loop(mechanism: Mechanism) -> ModelError:
    return ModelError(
        [
            Problem(
                f"components.{parameter.owner}.ratio_range",
                "stands in a rigid loop, which only turns as long as its ratios agree",
                "put a shaft into the loop, or remove ratio_range",
            )
            for parameter in mechanism.changing
        ]
    )


def _constraint_rows(mechanism: Mechanism) -> sp.Matrix:
    velocities = mechanism.velocities
    return exact.stack([exact.row_vector(c.row, velocities) for c in mechanism.constraints], len(velocities))


def _candidates(mechanism: Mechanism, first: First) -> tuple[list[tuple[str, sp.Matrix]], int]:
    """Return the velocities that may become coordinates, in order of preference, and how many carry inertia."""
    velocities = mechanism.velocities
    candidates: list[tuple[str, sp.Matrix]] = []

    def add_velocities(names: Sequence[str]) -> None:
        candidates.extend((name, exact.row_vector({name: sp.Integer(1)}, velocities)) for name in names)

    if first == "frictions":
        for friction in mechanism.frictions:
            unit = len(friction.row) == 1 and next(iter(friction.row.values())) == 1
            name = next(iter(friction.row)) if unit else friction.name
            candidates.append((name, exact.row_vector(friction.row, velocities)))
    add_velocities(mechanism.machine_velocities)
    add_velocities([body.velocity for body in mechanism.bodies])
    bearing_inertia = len(candidates)
    add_velocities(velocities)
    return candidates, bearing_inertia


def choose_coordinates(mechanism: Mechanism, first: First) -> Coordinates:
    """Choose coordinates greedily: friction velocities if they come first, machines, bodies, then the rest.

    Friction velocities that depend on a changing ratio come after the bodies: whenever there are coordinates in which
    no body's row depends on a changing ratio, then these are such ones.

    Notes
    -----
    Let ``R(i)`` be the rows of the bodies over coordinates that are velocities of bodies themselves, some rows being
    unit rows ``I``, the rest ``C(i)``. In other coordinates they are ``R(i) T(i)``; if that is constant, so is
    ``I T(i)``, and then ``C(i)``.
    """
    candidates, bearing_inertia = _candidates(mechanism, first)
    changing = {parameter.symbol for parameter in mechanism.changing}
    if changing and first == "frictions":
        count = len(mechanism.frictions)
        frictions, bodies, rest = candidates[:count], candidates[count:bearing_inertia], candidates[bearing_inertia:]
        over_bodies = _chosen(mechanism, bodies + frictions + rest, bearing_inertia).S
        varies = [bool((row * over_bodies).free_symbols & changing) for _, row in frictions]
        steady = [item for item, late in zip(frictions, varies, strict=True) if not late]
        moved = [item for item, late in zip(frictions, varies, strict=True) if late]
        candidates = steady + bodies + moved + rest
    return _chosen(mechanism, candidates, bearing_inertia)


def _chosen(mechanism: Mechanism, candidates: Sequence[tuple[str, sp.Matrix]], bearing_inertia: int) -> Coordinates:
    constraint_rows = _constraint_rows(mechanism)
    rows = exact.stack([constraint_rows, *(row for _, row in candidates)], len(mechanism.velocities))
    independent = exact.independent_rows(rows)
    fixed = constraint_rows.shape[0]
    chosen = [index - fixed for index in independent if index >= fixed]
    basis = exact.stack([rows[index, :] for index in independent], len(mechanism.velocities))
    count = len(chosen)
    right = sp.zeros(len(independent) - count, count).col_join(sp.eye(count))
    S = exact.solve(basis, right)
    return Coordinates(
        tuple(candidates[index][0] for index in chosen), S, sum(index < bearing_inertia for index in chosen)
    )

"""The choice of independent velocities: ``v = S z`` by exact elimination of all constraints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import sympy as sp

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
    """
    constraint_rows = _constraint_rows(mechanism)
    symbols = sorted(constraint_rows.free_symbols, key=lambda symbol: symbol.name)
    exact_values = {symbol: sp.Rational(str(mechanism.values[symbol])) for symbol in symbols}
    candidates, _ = _candidates(mechanism, first)
    rows = exact.stack([constraint_rows, *(row for _, row in candidates)], len(mechanism.velocities))
    if not symbols or exact.independent_rows(rows) == exact.independent_rows(rows.subs(exact_values)):
        return mechanism, ()
    constraints = tuple(
        replace(
            constraint,
            row={name: sp.sympify(value).subs(exact_values) for name, value in constraint.row.items()},
        )
        for constraint in mechanism.constraints
    )
    return replace(mechanism, constraints=constraints), tuple(symbols)


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
    """Choose coordinates greedily: friction velocities if they come first, machines, bodies, then the rest."""
    constraint_rows = _constraint_rows(mechanism)
    candidates, bearing_inertia = _candidates(mechanism, first)
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

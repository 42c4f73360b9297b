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


def with_exact_loops(mechanism: Mechanism) -> tuple[Mechanism, tuple[sp.Symbol, ...]]:
    """Replace the ratios of rigid loops by their values.

    Over independent symbols a loop of gears would be locked; it moves because its ratios agree as numbers.
    """
    rows = exact.stack(
        [exact.row_vector(constraint.row, mechanism.velocities) for constraint in mechanism.constraints],
        len(mechanism.velocities),
    )
    symbols = sorted(rows.free_symbols, key=lambda symbol: symbol.name)
    exact_values = {symbol: sp.Rational(str(mechanism.values[symbol])) for symbol in symbols}
    if not symbols or exact.rank(rows) == exact.rank(rows.subs(exact_values)):
        return mechanism, ()
    constraints = tuple(
        replace(
            constraint,
            row={name: sp.sympify(value).subs(exact_values) for name, value in constraint.row.items()},
        )
        for constraint in mechanism.constraints
    )
    return replace(mechanism, constraints=constraints), tuple(symbols)


def choose_coordinates(mechanism: Mechanism, first: First) -> Coordinates:
    """Choose coordinates greedily: friction velocities if they come first, machines, bodies, then the rest."""
    velocities = mechanism.velocities
    constraint_rows = [exact.row_vector(constraint.row, velocities) for constraint in mechanism.constraints]
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

    rows = exact.stack(constraint_rows + [row for _, row in candidates], len(velocities))
    independent = exact.independent_rows(rows)
    chosen = [index - len(constraint_rows) for index in independent if index >= len(constraint_rows)]
    basis = exact.stack([rows[index, :] for index in independent], len(velocities))
    count = len(chosen)
    right = sp.zeros(len(independent) - count, count).col_join(sp.eye(count))
    S = exact.solve(basis, right)
    return Coordinates(
        tuple(candidates[index][0] for index in chosen), S, sum(index < bearing_inertia for index in chosen)
    )

"""Velocities of all members per unit of the input's, as closed formulas of the ratios and as numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ptgen.gears.layout import Layout
from ptgen.gears.vectors import null_space

__all__ = ["Speed", "formula_speeds", "number_speeds", "slips"]


@dataclass(frozen=True)
class Speed:
    """A velocity per unit of the input's.

    Attributes
    ----------
    value : Fraction or None
        None if the gear leaves the velocity free.
    formula : sympy.Expr or None
        The same in the ratios g1, i1 and so on; None if it is free, or holds for the ratios' values only.
    """

    value: Fraction | None
    formula: sp.Expr | None


def number_speeds(layout: Layout, engaged: Sequence[str]) -> dict[str, Fraction | None]:
    """Return the velocity of every member per unit of the input's, at the values of the ratios; None if it is free."""
    rows = [layout.train_vector(train) for train in layout.trains]
    rows += [layout.element_vector(element) for element in layout.elements if element.name in engaged]
    basis = null_space(rows, len(layout.members))
    input_ = [vector[layout.members.index(layout.input)] for vector in basis]
    first = next(k for k, entry in enumerate(input_) if entry)
    speeds: dict[str, Fraction | None] = {}
    for position, member in enumerate(layout.members):
        own = [vector[position] for vector in basis]
        speed = own[first] / input_[first]
        speeds[member] = speed if all(a == speed * b for a, b in zip(own, input_, strict=True)) else None
    return speeds


def formula_speeds(layout: Layout, engaged: Sequence[str]) -> dict[str, sp.Expr]:
    """Return the velocities per unit of the input's as formulas, of those members whose velocity is determined."""
    order = [*(member for member in layout.members if member != layout.input), layout.input]
    rows: list[dict[str, sp.Expr]] = []
    for train in layout.trains:
        row: dict[str, sp.Expr] = {}
        for flange, coefficient in train.coefficients.items():
            member = train.members[flange]
            row[member] = row.get(member, sp.Integer(0)) + coefficient
        rows.append(row)
    for element in layout.elements:
        if element.name in engaged:
            rows.append({m: sp.Rational(c.numerator, c.denominator) for m, c in element.row.items()})
    if not rows:
        return {layout.input: sp.Integer(1)}
    matrix = sp.Matrix([[row.get(member, 0) for member in order] for row in rows])
    reduced, pivots = DomainMatrix.from_Matrix(matrix).to_field().to_sparse().rref()
    last = len(order) - 1
    if last in pivots:
        return {}
    found = {layout.input: sp.Integer(1)}
    entries = reduced.to_dok()
    for index, pivot in enumerate(pivots):
        others = {column for row, column in entries if row == index} - {pivot}
        if others <= {last}:
            entry = entries.get((index, last))
            value = reduced.domain.to_sympy(entry) if entry is not None else sp.Integer(0)
            found[order[pivot]] = sp.factor(-value)
    return found


def slips(layout: Layout, engaged: Sequence[str], speeds: Mapping[str, Speed]) -> dict[str, Speed]:
    """Return the relative velocity of every open element per unit of the input's velocity."""
    found = {}
    for element in layout.elements:
        if element.name in engaged:
            continue
        parts = [(speeds[member], factor) for member, factor in element.row.items()]
        value: Fraction | None = Fraction(0)
        formula: sp.Expr | None = sp.Integer(0)
        for speed, factor in parts:
            value = None if value is None or speed.value is None else value + factor * speed.value
            own = speed.formula
            rational = sp.Rational(factor.numerator, factor.denominator)
            formula = None if formula is None or own is None else formula + rational * own
        found[element.name] = Speed(value, None if formula is None else sp.factor(formula))
    return found

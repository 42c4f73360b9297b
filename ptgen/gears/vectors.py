"""Exact linear algebra on short vectors of rational numbers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

__all__ = ["Span", "Vector", "combined", "null_space", "parallel"]

Vector = list[Fraction]


@dataclass(frozen=True)
class Span:
    """What some vectors span, as vectors each of which has a first entry that all later ones lack.

    Attributes
    ----------
    vectors : tuple of Vector
    pivots : tuple of int
        Position of the entry of each vector that vanishes in the later ones.
    """

    vectors: tuple[Vector, ...] = ()
    pivots: tuple[int, ...] = ()

    @property
    def rank(self) -> int:
        """Number of independent vectors."""
        return len(self.vectors)

    def rest(self, vector: Vector) -> Vector:
        """Return what is left of a vector after elimination; zero if the span holds it."""
        for own, pivot in zip(self.vectors, self.pivots, strict=True):
            if vector[pivot]:
                factor = vector[pivot] / own[pivot]
                vector = [a - factor * b if b else a for a, b in zip(vector, own, strict=True)]
        return vector

    def with_vector(self, vector: Vector) -> Span | None:
        """Return the span with one vector more; None if it held the vector before."""
        rest = self.rest(vector)
        pivot = next((k for k, entry in enumerate(rest) if entry), None)
        return None if pivot is None else Span((*self.vectors, rest), (*self.pivots, pivot))


def null_space(rows: Iterable[Vector], width: int) -> list[Vector]:
    """Return a basis of the vectors ``x`` with ``row . x = 0`` for all rows.

    Examples
    --------
    >>> null_space([[Fraction(1), Fraction(2)]], 2)
    [[Fraction(-2, 1), Fraction(1, 1)]]
    """
    reduced: list[tuple[int, Vector]] = []
    for row in rows:
        for pivot, own in reduced:
            if row[pivot]:
                row = [a - row[pivot] * b for a, b in zip(row, own, strict=True)]
        lead = next((k for k, entry in enumerate(row) if entry), None)
        if lead is None:
            continue
        new = [entry / row[lead] for entry in row]
        reduced = [(p, [a - own[lead] * b for a, b in zip(own, new, strict=True)]) for p, own in reduced]
        reduced.append((lead, new))
    pivots = {pivot for pivot, _ in reduced}
    basis = []
    for free in (k for k in range(width) if k not in pivots):
        vector = [Fraction(0)] * width
        vector[free] = Fraction(1)
        for pivot, own in reduced:
            vector[pivot] = -own[free]
        basis.append(vector)
    return basis


def combined(row: Vector, basis: Sequence[Vector]) -> Vector:
    """Return the products of a row with each vector of a basis."""
    return [sum((a * b for a, b in zip(row, vector, strict=True) if a and b), Fraction(0)) for vector in basis]


def parallel(first: Vector, second: Vector) -> Fraction | None:
    """Return the factor with ``first = factor * second``, for vectors that are not zero; None if there is none."""
    pivot = next(k for k, entry in enumerate(second) if entry)
    factor = first[pivot] / second[pivot]
    return factor if all(a == factor * b for a, b in zip(first, second, strict=True)) else None

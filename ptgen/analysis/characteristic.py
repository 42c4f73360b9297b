"""Characteristic polynomials of the continuous closed loop, factor by factor.

The state matrix, in the coordinates of the normal form, is ordered by its strongly connected components: states that
act on each other in a circle. It is block triangular then, and its characteristic polynomial is the product of those
of the blocks. So decoupling shows as a product of small polynomials, one for each loop (5.106), (5.109), (5.114),
which can be judged by hand; without it, one polynomial of the full order remains (5.105).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import networkx as nx
import numpy as np
import sympy as sp
from numpy.typing import NDArray
from sympy.polys.rings import PolyElement, PolyRing

from ptgen.analysis.symbolic_loop import SymbolicLoop
from ptgen.mechanism.model import evaluate_matrix

__all__ = ["Factor", "characteristic_factors"]

_LARGEST_SPLIT = 4
"""Up to this degree the polynomial of a block is factored further, as that of an observer can be."""


@dataclass(frozen=True)
class Factor:
    """A factor of a characteristic polynomial.

    Attributes
    ----------
    loops : tuple of str
        The loops whose states it belongs to.
    coefficients : tuple of Expr (n + 1)
        Highest power first, the first one is 1.
    matrix : Matrix (n, n) or None
        A matrix that it is the characteristic polynomial of, where there is one at hand.
    """

    loops: tuple[str, ...]
    coefficients: tuple[sp.Expr, ...]
    matrix: sp.Matrix | None = field(default=None, compare=False)

    @property
    def name(self) -> str:
        """The loops in words."""
        return " and ".join(self.loops)

    @property
    def degree(self) -> int:
        """Degree of the factor."""
        return len(self.coefficients) - 1

    def polynomial(self, s: sp.Symbol) -> sp.Expr:
        """Return the polynomial in `s`."""
        return sp.Add(*[value * s ** (self.degree - k) for k, value in enumerate(self.coefficients)])

    def numbers(self, values: Mapping[sp.Symbol, float]) -> NDArray[np.float64]:
        """Return the coefficients in numbers, highest power first."""
        return np.asarray(evaluate_matrix(sp.Matrix([list(self.coefficients)]), values)[0], dtype=np.float64)

    def poles(self, values: Mapping[sp.Symbol, float]) -> NDArray[np.complex128]:
        """Return the zeros in numbers (1/s); of the matrix if it is known, as zeros that coincide lose digits."""
        if self.matrix is not None:
            return np.asarray(np.linalg.eigvals(evaluate_matrix(self.matrix, values)), dtype=np.complex128)
        return np.asarray(np.roots(self.numbers(values)), dtype=np.complex128)


def characteristic_factors(loop: SymbolicLoop) -> tuple[Factor, ...]:
    """Return the factors of the characteristic polynomial that the structure of the loop gives.

    Parameters
    ----------
    loop : SymbolicLoop
        With switches in a position, `SymbolicLoop.at`, or symbolic.

    Returns
    -------
    tuple of Factor
        In the order of the loops, internal dynamics last.

    References
    ----------
    Source (5.105), (5.106), (5.109), (5.114).
    """
    matrix = loop.normal_form()
    names = (*(item.name for item in loop.loops), "internal dynamics")
    blocks = _blocks(matrix)
    if len(blocks) == 1 and loop.internal_damping.is_zero_matrix:
        matrix = loop.A  # the same polynomial, from entries that are shorter
    factors = []
    for block in blocks:
        owners = {loop.owners[k] for k in block}
        loops = tuple(name for name in names if name in owners)
        part = matrix[block, block]
        split = _split(_characteristic_polynomial(part))
        factors += [Factor(loops, coefficients, part if len(split) == 1 else None) for coefficients in split]
    return tuple(sorted(factors, key=lambda factor: [names.index(name) for name in factor.loops]))


def _characteristic_polynomial(matrix: sp.Matrix) -> list[sp.Expr]:
    """Return the coefficients of ``det(s - A)``, highest power first.

    With rows free of fractions, ``A = D^-1 N``, it is ``det(s D - N) / det D``, a determinant of polynomials: there are
    no fractions to be reduced on the way, which would take most of the time.
    """
    size = matrix.rows
    s = sp.Dummy("s")
    rows, scale = [], sp.Integer(1)
    for i in range(size):
        fractions = [sp.fraction(sp.together(entry)) for entry in matrix[i, :]]
        common = sp.lcm_list([bottom for _, bottom in fractions])
        rows.append([-sp.cancel(common * top / bottom) for top, bottom in fractions])
        rows[-1][i] += s * common
        scale *= common
    symbols = sorted(matrix.free_symbols | scale.free_symbols, key=lambda symbol: symbol.name)
    ring = sp.ring([s, *symbols], sp.QQ)[0]
    expanded = _determinant([[ring.from_expr(entry) for entry in row] for row in rows], ring)
    found: list[list[tuple[tuple[int, ...], object]]] = [[] for _ in range(size + 1)]
    for powers, value in expanded.terms():
        found[size - powers[0]].append(((0, *powers[1:]), value))
    bottom = ring.from_expr(scale)
    fractions = [ring.from_terms(terms).cancel(bottom) for terms in found]
    return [top.as_expr() / low.as_expr() for top, low in fractions]


def _determinant(rows: list[list[PolyElement]], ring: PolyRing) -> PolyElement:
    """Return a determinant by expansion along the row with the fewest entries; the matrices of loops are sparse."""
    if not rows:
        return ring.one
    counts = [sum(1 for entry in row if entry) for row in rows]
    i = counts.index(min(counts))
    total = ring.zero
    for j, entry in enumerate(rows[i]):
        if entry:
            minor = [[*row[:j], *row[j + 1 :]] for k, row in enumerate(rows) if k != i]
            total += (-1) ** (i + j) * entry * _determinant(minor, ring)
    return total


def _blocks(matrix: sp.Matrix) -> list[list[int]]:
    """Return the strongly connected components of the states."""
    graph: nx.DiGraph[int] = nx.DiGraph()
    graph.add_nodes_from(range(matrix.rows))
    graph.add_edges_from((j, i) for i in range(matrix.rows) for j in range(matrix.cols) if matrix[i, j] != 0)
    return [sorted(component) for component in nx.strongly_connected_components(graph)]


def _split(coefficients: Sequence[sp.Expr]) -> list[tuple[sp.Expr, ...]]:
    """Split a polynomial over the rational functions of its parameters; each part has the leading coefficient 1."""
    degree = len(coefficients) - 1
    if degree > _LARGEST_SPLIT:
        return [tuple(coefficients)]
    if degree < 2:
        return [tuple(sp.factor(value) for value in coefficients)]
    s = sp.Dummy("s")
    _, parts = sp.Poly(list(coefficients), s).factor_list()
    result = []
    for part, power in parts:
        if part.degree() > 0:
            monic = tuple(sp.factor(value / part.LC()) for value in part.all_coeffs())
            result += [monic] * power
    return result

"""Exact elimination over the field of rational functions of the parameters.

All symbolic linear algebra of the mechanics goes through here. It uses `DomainMatrix`, whose entries are kept
in canonical form at every step; generic symbolic matrices would swell and be a hundred times slower.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp
from sympy.polys.matrices import DomainMatrix

__all__ = [
    "SingularMatrixError",
    "canonical",
    "independent_rows",
    "left_null_space",
    "preferred_solution",
    "rank",
    "reduced_rows",
    "row_combination",
    "row_vector",
    "solve",
    "stack",
]


class SingularMatrixError(ValueError):
    """A matrix that must be regular is singular for every value of its parameters."""


def _domain(matrix: sp.Matrix) -> DomainMatrix:
    return DomainMatrix.from_Matrix(matrix).to_field().to_sparse()


def canonical(matrix: sp.Matrix) -> sp.Matrix:
    """Return the matrix with every entry as a reduced fraction of polynomials.

    Examples
    --------
    >>> a, b = sp.symbols("a b")
    >>> canonical(sp.Matrix([[(a**2 - b**2) / (a - b)]]))
    Matrix([[a + b]])
    """
    if 0 in matrix.shape or not matrix.free_symbols:
        return matrix
    return _domain(matrix).to_Matrix()


def rank(matrix: sp.Matrix) -> int:
    """Return the generic rank of `matrix`."""
    if 0 in matrix.shape:
        return 0
    return int(_domain(matrix).rank())


def independent_rows(matrix: sp.Matrix) -> tuple[int, ...]:
    """Return the indices of a maximal independent set of rows, earlier rows preferred."""
    if 0 in matrix.shape:
        return ()
    _, pivots = _domain(matrix.T).rref()
    return tuple(int(pivot) for pivot in pivots)


def reduced_rows(matrix: sp.Matrix) -> sp.Matrix:
    """Return the reduced echelon form of `matrix`, whose rows are independent; it spans the same space.

    Examples
    --------
    >>> a = sp.Symbol("a")
    >>> reduced_rows(sp.Matrix([[1, a, 0], [1, 0, -a]]))
    Matrix([
    [1, 0, -a],
    [0, 1,  1]])
    """
    if 0 in matrix.shape:
        return matrix
    return _domain(matrix).rref()[0].to_Matrix()


def left_null_space(matrix: sp.Matrix) -> sp.Matrix:
    """Return a basis of the rows ``t`` with ``t matrix = 0``, one per row.

    Examples
    --------
    >>> a = sp.Symbol("a")
    >>> left_null_space(sp.Matrix([[1], [a], [0]]))
    Matrix([
    [-a, 1, 0],
    [ 0, 0, 1]])
    """
    if matrix.shape[1] == 0:
        return sp.eye(matrix.shape[0])
    basis = _domain(matrix.T).nullspace().to_Matrix()
    return canonical(sp.Matrix.vstack(sp.zeros(0, matrix.shape[0]), *(_leading_one(row) for row in _rows_of(basis))))


def solve(matrix: sp.Matrix, right: sp.Matrix) -> sp.Matrix:
    """Solve ``matrix X = right`` for square `matrix`.

    Raises
    ------
    SingularMatrixError
        If `matrix` is singular.

    Examples
    --------
    >>> a, b = sp.symbols("a b")
    >>> solve(sp.Matrix([[a, b], [0, a]]), sp.Matrix([[b], [a]]))
    Matrix([
    [0],
    [1]])
    """
    size = matrix.shape[0]
    if 0 in right.shape or size == 0:
        return sp.zeros(size, right.shape[1])
    reduced, pivots = _domain(matrix.row_join(right)).rref()
    if tuple(pivots[:size]) != tuple(range(size)):
        raise SingularMatrixError("matrix is singular")
    return reduced.to_Matrix()[:size, size:]


def row_combination(rows: sp.Matrix, basis: sp.Matrix) -> sp.Matrix:
    """Return ``L`` with ``rows = L basis``; the rows of `basis` are independent and span those of `rows`."""
    if basis.shape[0] == 0:
        return sp.zeros(rows.shape[0], 0)
    chosen = list(_domain(basis).rref()[1])
    return solve(basis[:, chosen].T, rows[:, chosen].T).T


def preferred_solution(matrix: sp.Matrix, right: sp.Matrix) -> sp.Matrix | None:
    """Solve ``matrix x = right`` with as many zeros as possible at the end of ``x``.

    The columns of `matrix` stand in the order of preference; columns that are not needed get zero.

    Returns
    -------
    Matrix (n, 1) or None
        None if there is no solution.
    """
    columns = matrix.shape[1]
    reduced, pivots = _domain(matrix.row_join(right)).rref()
    if columns in pivots:
        return None
    entries = reduced.to_Matrix()
    solution = sp.zeros(columns, 1)
    for index, pivot in enumerate(pivots):
        solution[pivot, 0] = entries[index, columns]
    return solution


def _rows_of(matrix: sp.Matrix) -> list[sp.Matrix]:
    return [matrix[k, :] for k in range(matrix.shape[0])]


def _leading_one(row: sp.Matrix) -> sp.Matrix:
    """Scale a row so that its last entry that is not zero is one."""
    last = next(entry for entry in reversed(list(row)) if entry != 0)
    return row / last


def row_vector(row: Mapping[str, sp.Expr], names: Sequence[str]) -> sp.Matrix:
    """Return the row ``{name: coefficient}`` as a matrix (1, n) over `names`."""
    return sp.Matrix([[row.get(name, sp.Integer(0)) for name in names]])


def stack(rows: Sequence[sp.Matrix], width: int) -> sp.Matrix:
    """Stack row vectors of length `width`, possibly none."""
    return sp.Matrix.vstack(sp.zeros(0, width), *rows)

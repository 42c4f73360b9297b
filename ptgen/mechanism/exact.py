"""Exact elimination over the field of rational functions of the parameters.

All symbolic linear algebra of the mechanics goes through here. It uses `DomainMatrix`, whose entries are kept
in canonical form at every step; generic symbolic matrices would swell and be a hundred times slower.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

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
    "valued",
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

    The columns of `matrix` stand in the order of preference; columns that are not needed get zero. Which columns and
    which equations are needed is found with a prime number in place of each parameter; only these are solved in
    symbols.

    Returns
    -------
    Matrix (n, 1) or None
        None if there is no solution.
    """
    columns = matrix.shape[1]
    sample = _at_primes(matrix.row_join(right))
    reduced, pivots = sample.rref()
    if columns in pivots:
        return None
    solved = reduced.to_Matrix()
    needed = [pivot for index, pivot in enumerate(pivots) if solved[index, columns] != 0]
    solution = sp.zeros(columns, 1)
    if needed:
        rows = sample.to_Matrix()[:, needed]
        equations = list(DomainMatrix.from_Matrix(rows.T).to_field().rref()[1])
        found = solve(matrix[equations, :][:, needed], right[equations, :])
        for position, column in enumerate(needed):
            solution[column, 0] = found[position, 0]
    return solution


def _at_primes(matrix: sp.Matrix) -> DomainMatrix:
    """Return the matrix with every symbol a prime of its own: what holds there holds for almost all values."""
    symbols = sorted(matrix.free_symbols, key=lambda symbol: symbol.name)
    table = {symbol: Fraction(sp.prime(25 + 3 * k)) for k, symbol in enumerate(symbols)}
    return DomainMatrix.from_Matrix(valued(matrix, table)).to_field()


def valued(matrix: sp.Matrix, values: Mapping[sp.Symbol, Fraction]) -> sp.Matrix:
    """Return a matrix of rational expressions at `values`, as rational numbers."""
    result = sp.zeros(*matrix.shape)
    for (row, column), entry in sp.SparseMatrix(matrix).todok().items():
        value = _value_at(entry, values)
        result[row, column] = sp.Rational(value.numerator, value.denominator)
    return result


def _value_at(expression: sp.Expr, values: Mapping[sp.Symbol, Fraction]) -> Fraction:
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Rational:
        return Fraction(int(expression.p), int(expression.q))
    if expression.is_Add:
        return sum((_value_at(argument, values) for argument in expression.args), Fraction(0))
    if expression.is_Mul:
        return math.prod((_value_at(argument, values) for argument in expression.args), start=Fraction(1))
    if expression.is_Pow and expression.exp.is_Integer:
        return _value_at(expression.base, values) ** int(expression.exp)
    raise TypeError(f"{expression} is no rational expression")


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

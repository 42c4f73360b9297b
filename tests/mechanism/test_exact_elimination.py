"""Exact linear algebra against sympy's generic matrices, numpy and the definitions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from ptgen.mechanism import exact

a, b, c = sp.symbols("a b c", positive=True)
_NUMBERS = st.fractions(min_value=-5, max_value=5, max_denominator=7)


@st.composite
def matrices(draw: st.DrawFn, rows: int | None = None, columns: int | None = None) -> sp.Matrix:
    rows = rows or draw(st.integers(1, 5))
    columns = columns or draw(st.integers(1, 5))
    numbers = draw(st.lists(_NUMBERS, min_size=rows * columns, max_size=rows * columns))
    return sp.Matrix(rows, columns, [sp.Rational(n.numerator, n.denominator) for n in numbers])


@given(st.data())
def test_solve_agrees_with_sympy_and_numpy(data: st.DataObject) -> None:
    size = data.draw(st.integers(1, 4))
    matrix, right = data.draw(matrices(size, size)), data.draw(matrices(size, 2))
    if matrix.det() == 0:
        with pytest.raises(exact.SingularMatrixError):
            exact.solve(matrix, right)
        return
    solution = exact.solve(matrix, right)
    assert matrix * solution == right
    assert solution == matrix.LUsolve(right)
    numeric = np.array(matrix, dtype=float)
    if np.linalg.cond(numeric) < 1e6:
        expected = np.linalg.solve(numeric, np.array(right, dtype=float))
        np.testing.assert_allclose(np.array(solution, dtype=float), expected, rtol=1e-8, atol=1e-8)


def test_solve_over_the_parameters() -> None:
    matrix = sp.Matrix([[a + b, -b, 0], [-b, b + c, -c], [0, -c, c + a]])
    right = sp.Matrix([[1, a], [0, b], [c, 0]])
    assert (matrix * exact.solve(matrix, right) - right).applyfunc(sp.cancel) == sp.zeros(3, 2)


def test_solve_sees_a_singularity_that_expansion_hides() -> None:
    matrix = sp.Matrix([[a + b, a**2 - b**2], [1, a - b]])
    with pytest.raises(exact.SingularMatrixError):
        exact.solve(matrix, sp.eye(2))


@pytest.mark.parametrize(("rows", "columns"), [(0, 0), (0, 3), (2, 0)])
def test_empty_right_hand_sides(rows: int, columns: int) -> None:
    assert exact.solve(sp.eye(rows), sp.zeros(rows, columns)).shape == (rows, columns)
    assert exact.rank(sp.zeros(rows, columns)) == 0
    assert exact.independent_rows(sp.zeros(rows, columns)) == ()


@given(matrices())
def test_rank_is_sympys(matrix: sp.Matrix) -> None:
    assert exact.rank(matrix) == matrix.rank()


@given(matrices())
def test_independent_rows_are_the_earliest_possible(matrix: sp.Matrix) -> None:
    """A row is taken exactly if it is independent of all rows before it."""
    ranks = [0] + [matrix[: k + 1, :].rank() for k in range(matrix.rows)]
    assert exact.independent_rows(matrix) == tuple(k for k in range(matrix.rows) if ranks[k + 1] > ranks[k])


@given(st.data())
def test_row_combination_reproduces_the_rows(data: st.DataObject) -> None:
    basis = data.draw(matrices(columns=4))
    assume(basis.rank() == basis.rows)
    weights = data.draw(matrices(columns=basis.rows))
    assert exact.row_combination(weights * basis, basis) == weights


@given(st.data())
def test_preferred_solution_uses_the_earliest_columns(data: st.DataObject) -> None:
    """It solves, and needs no column beyond the first block that can solve at all."""
    matrix = data.draw(matrices())
    right = data.draw(st.one_of(matrices(matrix.rows, 1), matrices(matrix.cols, 1).map(lambda x: matrix * x)))
    solution = exact.preferred_solution(matrix, right)
    solvable = [k for k in range(matrix.cols + 1) if matrix[:, :k].row_join(right).rank() == matrix[:, :k].rank()]
    if solution is None:
        assert not solvable
        return
    assert matrix * solution == right
    used = [k + 1 for k, value in enumerate(solution) if value != 0]
    assert max(used, default=0) <= solvable[0]
    independent = [k for k in range(matrix.cols) if matrix[:, : k + 1].rank() > matrix[:, :k].rank()]
    assert {k - 1 for k in used} <= set(independent)


def test_row_vector_and_stack() -> None:
    assert exact.row_vector({"y": a}, ["x", "y", "z"]) == sp.Matrix([[0, a, 0]])
    assert exact.stack([], 3).shape == (0, 3)
    assert exact.stack([sp.Matrix([[1, 2]]), sp.Matrix([[3, 4]])], 2) == sp.Matrix([[1, 2], [3, 4]])

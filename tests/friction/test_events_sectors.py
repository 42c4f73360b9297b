"""The box problem by enumeration of its sectors: the conditions that define it, and other ways to its solution."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.optimize

from ptgen.friction.sectors import enumerate_sectors


def random_problem(rng: np.random.Generator, n: int, rank: int) -> tuple[np.ndarray, ...]:
    rows = rng.normal(size=(n, rank))
    hi, lo = rng.uniform(0, 3, n), -rng.uniform(0, 3, n)
    hi[rng.random(n) < 0.15] = 0.0
    return rows @ rows.T, rows @ rng.normal(size=rank) * 4, lo, hi


@pytest.mark.parametrize(("n", "rank"), [(1, 1), (2, 2), (3, 3), (5, 5), (3, 2), (6, 4)])
def test_solution_is_the_minimum_over_the_box(n: int, rank: int) -> None:
    """min 1/2 T'KT - w'T is a bounded least-squares problem, which SciPy solves by another method."""
    rng = np.random.default_rng(n + 10 * rank)
    for _ in range(30):
        K, w, lo, hi = random_problem(rng, n, rank)
        solution = enumerate_sectors(K, w, lo, hi)
        assert solution.violation < 1e-9
        values, vectors = np.linalg.eigh(K)
        kept = values > 1e-9 * values.max()
        root = (vectors[:, kept] * np.sqrt(values[kept])).T
        target = (vectors[:, kept] / np.sqrt(values[kept])).T @ w
        free = hi > lo
        other = np.zeros(n)
        fit = scipy.optimize.lsq_linear(root[:, free], target, (lo[free], hi[free]), method="bvls", tol=1e-14)
        other[free] = fit.x
        np.testing.assert_allclose(solution.accelerations, w - K @ other, atol=1e-7)
        if rank == n:
            np.testing.assert_allclose(solution.torques, other, atol=1e-6)


@pytest.mark.parametrize(("n", "rank"), [(2, 1), (4, 2), (6, 4)])
def test_dependent_rows_give_the_least_torques(n: int, rank: int) -> None:
    """No other torques in the box with the same accelerations have a smaller norm."""
    rng = np.random.default_rng(n)
    for _ in range(20):
        K, w, lo, hi = random_problem(rng, n, rank)
        solution = enumerate_sectors(K, w, lo, hi)
        weight = np.diag(K)
        norm = weight @ solution.torques**2
        null = np.linalg.svd(K)[2][rank:]
        for _ in range(200):
            other = solution.torques + rng.normal(size=len(null)) * 10.0 ** rng.uniform(-4, 0) @ null
            if np.all(other <= hi) and np.all(other >= lo):
                assert weight @ other**2 >= norm * (1 - 1e-9)


def test_one_sided_limits() -> None:
    """A freewheel holds any positive torque, and slips against a negative one."""
    K, lo, hi = np.eye(1), np.array([-0.5]), np.array([np.inf])
    holding = enumerate_sectors(K, np.array([1e6]), lo, hi)
    assert holding.torques[0] == pytest.approx(1e6) and holding.accelerations[0] == 0
    slipping = enumerate_sectors(K, np.array([-2.0]), lo, hi)
    assert slipping.torques[0] == -0.5 and slipping.accelerations[0] == -1.5 and slipping.sector[0] == -1


def test_limits_that_exclude_zero_are_an_error() -> None:
    with pytest.raises(ValueError, match="contain zero"):
        enumerate_sectors(np.eye(1), np.ones(1), np.array([1.0]), np.array([2.0]))

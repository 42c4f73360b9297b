"""The checks of answers see what is wrong, and their proofs hold, whatever the multipliers."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import linprog

from ptgen.governor.checks import Convex, multipliers_at, optimality_gap, proves_infeasible


def random_program(seed: int, *, quadratic: bool, shift: float = 0.0) -> Convex:
    rng = np.random.default_rng(seed)
    n, count = 3, 12
    root = rng.normal(size=(n, n)) if quadratic else np.zeros((n, n))
    room = rng.uniform(0.2, 1.0, count)
    middle = shift * rng.normal(size=count)
    return Convex(
        root @ root.T,
        -rng.uniform(0.1, 1.0, n),
        rng.normal(size=(count, n)),
        middle - room,
        middle + room,
        np.zeros(n),
        np.ones(n),
    )


def admissible(program: Convex, rng: np.random.Generator) -> np.ndarray:
    """Points of the box that keep the rows; zero does."""
    points = rng.uniform(0.0, 1.0, (4000, 3)) * rng.uniform(0.0, 1.0, (4000, 1))
    values = points @ program.A.T
    return points[((values >= program.lower) & (values <= program.upper)).all(axis=1)]


@given(st.integers(0, 10_000), st.booleans())
def test_no_point_is_below_the_bound_whatever_the_multipliers(seed, quadratic):
    program = random_program(seed, quadratic=quadratic)
    rng = np.random.default_rng(seed + 1)
    points = admissible(program, rng)
    cost = 0.5 * np.einsum("ij,jk,ik->i", points, program.P, points) + points @ program.q
    z = rng.uniform(0, 1, 3)
    here = 0.5 * z @ program.P @ z + program.q @ z
    gap = optimality_gap(program, z, rng.normal(size=12) * rng.choice([0.0, 1.0], 12))
    assert here - gap <= cost.min(initial=0.0) + 1e-12


@given(st.integers(0, 10_000))
def test_own_multipliers_prove_an_optimum_and_nothing_else(seed):
    program = random_program(seed, quadratic=False)
    rows = np.vstack([program.A, -program.A])
    best = linprog(program.q, rows, np.concatenate([program.upper, -program.lower]), bounds=[(0, 1)] * 3).x
    assert optimality_gap(program, best, multipliers_at(program, best, 1e-9)) == pytest.approx(0.0, abs=1e-9)
    worse = 0.9 * best
    gap = optimality_gap(program, worse, multipliers_at(program, worse, 1e-9))
    assert gap >= program.q @ (worse - best) - 1e-9 > 1e-4


@given(st.integers(0, 10_000))
def test_proofs_of_infeasibility_agree_with_another_solver(seed):
    program = random_program(seed, quadratic=False, shift=0.7)
    rows = np.vstack([program.A, -program.A])
    found = linprog(0 * program.q, rows, np.concatenate([program.upper, -program.lower]), bounds=[(0, 1)] * 3)
    assert found.status in (0, 2)
    assert proves_infeasible(program) == (found.status == 2)


def test_variables_without_bounds():
    endless = np.full(2, np.inf)
    program = Convex(
        2 * np.eye(2), np.zeros(2), np.array([[1.0, 1.0]]), np.array([2.0]), np.array([5.0]), -endless, endless
    )
    z = np.ones(2)
    assert optimality_gap(program, z, multipliers_at(program, z, 1e-9)) == pytest.approx(0.0, abs=1e-12)
    # The cost is the squared distance, which is 2 at (1, 1) and 5 at (1, 2).
    assert optimality_gap(program, np.array([1.0, 2.0]), np.array([-2.0])) >= 3.0
    assert not proves_infeasible(program)


def test_a_gap_that_means_nothing_is_infinite():
    program = random_program(1, quadratic=True)
    assert optimality_gap(program, np.zeros(3), np.full(12, np.nan)) == np.inf
    assert optimality_gap(program, np.full(3, np.nan), np.zeros(12)) == np.inf

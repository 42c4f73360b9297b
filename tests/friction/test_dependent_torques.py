"""Torques of three elements on two velocities, such as a bearing on the input of a gearbox with two clutches."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
import pytest
from box_problems import BoxProblem, box_library

from ptgen.block import casadi_friction
from ptgen.friction.box import is_deficient, solve_box

pytestmark = pytest.mark.compile

ROOT = float(np.sqrt(np.finfo(float).eps))


def problems() -> Iterator[BoxProblem]:
    """Yield problems with velocities that the bed can have; elements in motion have their torques already."""
    rng = np.random.default_rng(7)
    for _ in range(300):
        ratios = rng.uniform(0.5, 6.0, 2) * rng.choice([-1, 1], 2)
        G = np.array([[1.0, -ratios[0]], [1.0, -ratios[1]], [1.0, 0.0]])
        K = G @ np.diag(10.0 ** rng.uniform(-4, -2, 2)) @ G.T
        w = K @ rng.normal(size=3) * 10.0 ** rng.uniform(0, 2.5)
        capacity = np.array([300.0, 400.0, 10.0 ** rng.uniform(0, 2)]) * (rng.random(3) > 0.1)
        lo, hi = -capacity, capacity.copy()
        moving = rng.random(3) < 0.3
        lo[moving] = hi[moving] = (capacity * rng.choice([-1, 1], 3))[moving]
        yield BoxProblem(K, w, lo, hi, np.clip(rng.normal(size=3) * 100.0, lo, hi), is_deficient(K))


@cache
def by_casadi() -> Any:
    return casadi_friction._faces(3, 1)


def solutions(problem: BoxProblem) -> tuple[np.ndarray, list[np.ndarray]]:
    """Return the torques by NumPy, and those by C and CasADi."""
    p = problem
    reference = solve_box(p.K, p.w, p.lo, p.hi, p.guess, True)
    in_c, _, status = box_library(3).solve(p)
    in_casadi, fits = by_casadi()(*map(ca.DM, (p.K, p.w, p.lo, p.hi, p.guess)))
    assert reference.solved and status >= 0 and float(fits) == 1.0
    return reference.T, [in_c, np.array(in_casadi).ravel()]


def test_evaluators_agree_in_what_is_unique_and_to_half_the_digits_in_what_is_not() -> None:
    """With a torque that is free to go from one element to the others they differ by that alone; velocities agree."""
    several = 0
    for problem in problems():
        assert problem.deficient
        undecided = problem.lo < problem.hi
        is_unique = undecided.sum() < 3  # any two of the three are independent
        several += not is_unique
        first, others = solutions(problem)
        scale = np.max(abs(first)) + np.max((abs(problem.w) + abs(problem.K) @ abs(first)) / np.diag(problem.K))
        null = np.linalg.svd(problem.K)[2][-1]
        for other in others:
            apart = other - first
            if is_unique:
                assert np.max(abs(apart)) <= 1e-10 * scale
            else:
                assert np.max(abs(apart)) <= 16 * ROOT * scale
                assert np.max(abs(apart - null * (null @ apart))) <= 1e-11 * scale
            assert np.max(abs(problem.K @ apart)) <= 1e-13 * np.max(np.diag(problem.K)) * scale
    assert 50 < several < 250


def test_torques_that_are_not_unique_are_of_least_norm() -> None:
    """Among all torques that leave the same velocities."""
    free = 0
    for problem in problems():
        T, _ = solutions(problem)
        inside = (problem.lo < T) & (problem.hi > T)
        if inside.all():
            null = np.linalg.svd(problem.K)[2][-1]
            weight = np.diag(problem.K)
            assert abs(null @ (weight * T)) <= 64 * ROOT * np.sqrt(weight @ null**2) * np.sqrt(weight @ T**2)
            free += 1
    assert free > 10

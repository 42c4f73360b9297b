"""The solver of held and slipping elements, in C and NumPy, against the enumeration of all sectors."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from box_problems import CHECKS, KINDS, box_library, write_sources

from ptgen.friction.box import ROUNDING, factorisations, is_deficient, solve_box
from ptgen.friction.sectors import enumerate_sectors
from ptgen.simulate.compiler import compile_library

PER_KIND = 16_000
DEPENDENT = ("gears", "unflagged", "flagged")


@pytest.mark.compile
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 6, 8])
def test_random_problems(n: int, kind: str, record_property: Callable[[str, object], None]) -> None:
    """See ``examine`` in ``box_problems.c`` for what is asked of each solution; without enumeration for 1 and 8."""
    report = box_library(n).run(kind, PER_KIND, enumerated=1 < n < 8)
    record_property("worst_work", report.worst_work)
    assert report.problems == PER_KIND
    assert report.failures == 0, f"number {report.first_failure}: not {CHECKS[report.first_check]}"
    assert report.worst_residual <= 1e-12 and report.worst_norm <= 1e-6
    assert report.work / PER_KIND < 2 + n / 2
    if n <= 2:
        assert report.worst_work == 0
    elif kind in DEPENDENT or report.fallbacks:
        assert report.worst_work <= 10 * (factorisations(n) + n)
    else:
        assert report.worst_work <= factorisations(n) + n
    if kind not in DEPENDENT:
        assert report.fallbacks <= PER_KIND // 1000


@pytest.mark.compile
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 6, 8])
def test_numpy_and_c_agree(n: int, kind: str) -> None:
    """How far two points may differ whose residuals are rounding is derived in ``box_problems.c``."""
    library = box_library(n)
    for number in range(40):
        problem = library.make(kind, number)
        K, w = problem.K, problem.w
        T, w_plus, status = library.solve(problem)
        other = solve_box(K, w, problem.lo, problem.hi, problem.guess, problem.deficient)
        assert status >= 0 and other.solved, number
        sizes = [abs(w) + abs(K) @ abs(torques) for torques in (T, other.T)]
        root = np.sqrt(np.diag(K))
        known = ROUNDING * np.finfo(float).eps * (sizes[0] + sizes[1])
        if kind in DEPENDENT or is_deficient(K):
            known = np.max(known / root) * root
        allowed = root * np.sqrt(2 * known @ abs(T - other.T)) + 2 * known
        assert np.all(abs(w_plus - other.w_plus) <= allowed), number
        if kind == "conditioned":
            assert np.all(abs(T - other.T) * root <= 1e-12 * np.max(sizes[0] / root)), number


@pytest.mark.compile
@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_dependent_torques_are_of_least_norm(n: int) -> None:
    library = box_library(n)
    compared = 0
    for number in range(300):
        problem = library.make("gears", number)
        if problem.deficient and np.all(problem.lo <= 0) and np.all(problem.hi >= 0):
            diagonal = np.diag(problem.K)
            expected = enumerate_sectors(problem.K, problem.w, problem.lo, problem.hi)
            T, _, _ = library.solve(problem)
            scale = np.sqrt(diagonal @ expected.torques**2)
            assert np.sqrt(diagonal) * abs(T - expected.torques) == pytest.approx(0, abs=1e-6 * scale), number
            compared += 1
    assert compared > 100


def test_elements_of_one_motion_share_the_torque() -> None:
    """Two clutches side by side, with 2 and 10 N m, hold 11 N m: the weaker one gives all that it can."""
    K, w, c = np.ones((2, 2)), np.array([11.0, 11.0]), np.array([2.0, 10.0])
    solution = solve_box(K, w, -c, c)
    assert list(solution.T) == [2.0, 9.0] and list(solution.w_plus) == [0.0, 0.0]
    three = solve_box(np.ones((3, 3)), np.full(3, 11.0), -np.array([2, 9, 9]), np.array([2.0, 9, 9]))
    assert pytest.approx([2.0, 4.5, 4.5], rel=1e-7) == three.T and not three.w_plus.any()


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_without_capacity_nothing_is_held(n: int) -> None:
    K = np.eye(n) + 0.5
    w = np.arange(n) - 1.0
    solution = solve_box(K, w, np.zeros(n), np.zeros(n))
    assert not solution.T.any() and list(solution.w_plus) == list(w)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 6])
def test_with_enough_capacity_everything_is_held(n: int) -> None:
    rng = np.random.default_rng(n)
    A = rng.normal(size=(n, n))
    K, w = A @ A.T + np.eye(n), rng.normal(size=n)
    solution = solve_box(K, w, np.full(n, -1e3), np.full(n, np.inf))
    assert not solution.w_plus.any()
    assert pytest.approx(np.linalg.solve(K, w), rel=1e-12) == solution.T


def test_nearly_dependent_elements_slip_by_what_little_holds_them() -> None:
    """A tiny inertia between two clutches in a row: it takes all but a part of 1e-15 of what a torque does alone."""
    for tiny in (1e-9, 1e-12, 1e-15):
        K = np.array([[1 / tiny + 1.0, -1 / tiny], [-1 / tiny, 1 / tiny + 2.0]])
        w = np.array([-5.0, 7.0])  # the outer inertias move apart by 2, which both have to hold
        c = np.array([0.1, 0.2])
        solution = solve_box(K, w, -c, c, deficient=True)
        assert pytest.approx([0.1, 0.1], abs=1e-6) == solution.T, tiny


def test_semidefinite_matrices_are_told_apart() -> None:
    assert not is_deficient(np.diag([1.0, 1e-12, 1e12]))
    assert is_deficient(np.ones((3, 3)))
    with pytest.raises(ValueError, match="not positive semidefinite"):
        is_deficient(np.array([[1.0, 2.0], [2.0, 1.0]]))
    with pytest.raises(ValueError, match="not positive semidefinite"):
        is_deficient(np.array([[1.0, 0.0], [0.0, 0.0]]))


@pytest.mark.compile
@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_single_precision(n: int, tmp_path: Path) -> None:
    write_sources(tmp_path, n, precision="float")
    compile_library([tmp_path / "box_friction.c", tmp_path / "box_support.c"], tmp_path / "box.so")
    solve = ctypes.CDLL(str(tmp_path / "box.so")).box_solve_box
    stride = (n + 3) // 4 * 4
    for kind in ("conditioned", "gears"):
        for number in range(500):
            problem = box_library(n).make(kind, number)
            K = np.zeros((n, stride), dtype=np.float32)
            K[:, :n] = problem.K
            w, lo, hi, T = (a.astype(np.float32) for a in (problem.w, problem.lo, problem.hi, problem.guess))
            w_plus = np.zeros(n, dtype=np.float32)
            deficient = kind == "gears" and problem.deficient
            status = solve(int(deficient), *(ctypes.c_void_p(a.ctypes.data) for a in (K, w, lo, hi, T, w_plus)))
            assert status >= 0, (kind, number)
            assert np.all((lo <= T) & (hi >= T)), (kind, number)
            size = abs(w) + abs(K[:, :n]) @ abs(T)
            if kind == "gears":
                root = np.sqrt(np.diag(K))
                size = np.max(size / root) * root
            inside = (lo < T) & (hi > T)
            assert np.all(abs(w - K[:, :n] @ T)[inside] <= 3e-4 * size[inside]), (kind, number)

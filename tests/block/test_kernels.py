"""The kernels against other people's programs and by their meaning."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st

from ptgen.block.casadi_evaluator import CASADI_KERNELS
from ptgen.block.kernels import KERNELS, delay, discretise, guard
from ptgen.emit.c_block import CBlock
from ptgen.friction.box import solve_box
from ptgen.project import Project


def test_every_kernel_has_all_implementations(projects: dict[str, Project]) -> None:
    assert set(KERNELS) == set(CASADI_KERNELS)
    import ptgen.emit.templates as templates

    support = (
        templates._environment()
        .get_template("support.h.jinja")
        .render(
            prefix="x",
            version="",
            template="",
            bed_file="",
            digest="",
            precision="double",
            max_order=1,
            zero="0.0",
            one="1.0",
            taylor_degree=18,
        )
    )
    for name in KERNELS:
        assert f"x_{name}(" in support, name


@pytest.mark.parametrize("seed", range(5))
def test_exponential_against_scipy(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n, m, t = 6, 2, 0.3
    A = rng.normal(size=(n, n + m))
    full = np.zeros((n + m, n + m))
    full[:n] = A
    expected = scipy.linalg.expm(full * t)[:n]
    scale = 10.0 ** rng.uniform(-1, 1, n + m)
    got = discretise(A, scale, np.array(t), 8)
    assert np.allclose(got, expected, rtol=1e-12, atol=1e-12)


def sectors(K: np.ndarray, w: np.ndarray, m: np.ndarray) -> np.ndarray:
    """Enumerate the sectors of the source's Table 4.1: each element slips either way or sticks."""
    n = len(w)
    for kinds in itertools.product((0, 1, -1), repeat=n):
        T = np.array([kind * limit for kind, limit in zip(kinds, m, strict=True)])
        free = [i for i, kind in enumerate(kinds) if kind == 0]
        if free:
            rest = [i for i in range(n) if i not in free]
            right = w[free] - K[np.ix_(free, rest)] @ T[rest]
            T[free] = np.linalg.solve(K[np.ix_(free, free)], right)
        plus = w - K @ T
        slack = 1e-12 * max(1.0, np.abs(w).max())
        sticks = all(abs(T[i]) <= m[i] * (1 + 1e-12) + 1e-300 for i in free)
        if sticks and all(kind * plus[i] >= -slack for i, kind in enumerate(kinds)):
            return T
    raise AssertionError("no sector fits")


@pytest.mark.parametrize("n", [1, 2])
def test_box_problem_is_one_of_the_sectors(n: int) -> None:
    rng = np.random.default_rng(n)
    for _ in range(5000):
        root = rng.normal(size=(n, n)) * 10.0 ** rng.uniform(-2, 2, (n, 1))
        K = root @ root.T + 1e-9 * np.eye(n) * np.trace(root @ root.T)
        w, m = rng.normal(size=n), np.abs(rng.normal(size=n)) * (rng.random(n) < 0.9)
        T, plus = solve_box(K, w, m)
        expected = sectors(K, w, m)
        assert np.allclose(K @ T, K @ expected, atol=1e-9 * max(1.0, np.abs(w).max()))
        assert np.all(np.abs(T) <= m)
        assert np.all(plus[np.abs(T) < m] == 0.0)
        # friction never feeds energy in: at the end of the step it opposes the motion
        assert np.all(T * plus >= 0)


def test_box_problem_refuses_what_it_has_no_form_for() -> None:
    with pytest.raises(ValueError, match="up to 2"):
        solve_box(np.eye(3), np.zeros(3), np.ones(3))


@given(st.lists(st.floats(-1e3, 1e3), min_size=20, max_size=40), st.integers(0, 6))
def test_delay_line_returns_what_went_in(values: list[float], steps: int) -> None:
    buffer = np.zeros(8)
    history = [0.0] * 10
    for value in values:
        buffer, late, early = delay(buffer, np.array(value), np.array(steps))
        history.append(value)
        assert late == history[-1 - steps]
        assert early == history[-2 - steps]


@given(st.floats(allow_nan=True, allow_infinity=True), st.floats(1e-3, 1e6), st.floats(-1e3, 1e3))
def test_guard_lets_only_plausible_values_through(value: float, bound: float, held: float) -> None:
    got, sound = guard(np.array(value), np.array(bound), np.array(held))
    if np.isfinite(value) and abs(value) <= bound:
        assert got == value and sound == 1.0
    else:
        assert got == held and sound == 0.0


def test_block_refuses_names_used_before_assignment(projects: dict[str, Project]) -> None:
    from dataclasses import replace

    import sympy as sp

    from ptgen.block.block import Assign

    block = projects["back_to_back"].controller
    with pytest.raises(ValueError, match="used before assignment"):
        replace(block, step=(Assign("a", sp.Symbol("nowhere")), *block.step))


def test_c_arrays_are_padded_to_four_rows(projects: dict[str, Project]) -> None:
    block = CBlock(projects["differential"].plant, "differential", "double")
    rows = next(field for field in block.derived if field.name == "transition").dimensions
    assert rows.startswith("[23]") and rows.endswith("[20]")

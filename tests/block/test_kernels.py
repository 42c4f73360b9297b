"""The kernels against other people's programs and by their meaning."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st

from ptgen.block.casadi_evaluator import CASADI_KERNELS
from ptgen.block.kernels import KERNELS, delay, discretise, guard, lasting, lookup, share, still, swings
from ptgen.emit.block_files import common_context
from ptgen.emit.c_block import CBlock
from ptgen.emit.fluid_source import fluid_context
from ptgen.emit.friction_source import friction_context
from ptgen.emit.governor_source import governor_context
from ptgen.emit.templates import render
from ptgen.project import Project


def test_every_kernel_has_all_implementations(projects: dict[str, Project]) -> None:
    assert set(KERNELS) == set(CASADI_KERNELS)
    context = {**common_context("x", "", "", "double"), "max_order": 1, **friction_context(elements=2, contacts=1)}
    context |= fluid_context()
    context |= governor_context(1, "double", order=(0, 0), states=1, table_rows=1, numbers=(1, 8))
    headers = "".join(render(f"{part}.h.jinja", **context) for part in ("support", "friction", "governor", "fluid"))
    for name in KERNELS:
        assert f"x_{name}(" in headers, name


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


@given(st.lists(st.booleans(), max_size=60), st.integers(0, 8))
def test_lasting_counts_bad_steps_less_good_ones(flags: list[bool], allowed: int) -> None:
    time, count = np.array(0.0), 0
    for flag in flags:
        time = lasting(np.array(float(flag)), time, np.array(0.1), np.array(0.1 * allowed))
        count = min(count, allowed) + 1 if not flag else max(min(count, allowed) - 1, 0)
        assert time == pytest.approx(0.1 * count, abs=1e-12)
        assert flag or count <= allowed or time > 0.1 * allowed + 0.05


@given(st.lists(st.sampled_from([0.0, 1.0, -1.0, 5e-324]), min_size=2, max_size=40))
def test_still_counts_steps_without_any_change(values: list[float]) -> None:
    time = np.array(0.0)
    for k in range(1, len(values)):
        time = still(np.array(values[k]), np.array(values[k - 1]), time, np.array(1.0))
        run = next((n for n in range(k + 1) if values[k - n] != values[k]), k + 1) - 1
        assert time == run


@given(st.lists(st.floats(-3.0, 3.0), max_size=60))
def test_swings_are_the_changes_of_side(values: list[float]) -> None:
    side, count = np.array(0.0), np.array(0.0)
    for value in values:
        side, count = swings(np.array(value), np.array(1.0), side, count, np.array(0.0))
    sides = [np.sign(value) for value in values if abs(value) > 1.0]
    assert count == sum(1 for a, b in zip([0.0, *sides], sides, strict=False) if a != b)
    assert swings(np.array(0.0), np.array(1.0), side, count, np.array(1e9))[1] == 0.0


@given(st.floats(allow_nan=True, allow_infinity=True))
def test_share_lies_between_zero_and_one(value: float) -> None:
    limited = share(np.array(value))
    assert limited == (value if 0.0 <= value <= 1.0 else 1.0 if value > 1.0 else 0.0)


def test_block_refuses_names_used_before_assignment(projects: dict[str, Project]) -> None:
    from dataclasses import replace

    import sympy as sp

    from ptgen.block.block import Assign

    block = projects["back_to_back"].controller
    with pytest.raises(ValueError, match="used before assignment"):
        replace(block, step=(Assign("a", sp.Symbol("nowhere")), *block.step))


def test_a_conditional_assignment_needs_a_value_to_keep(projects: dict[str, Project]) -> None:
    from dataclasses import replace

    import sympy as sp

    from ptgen.block.block import Assign

    block = projects["back_to_back"].controller
    anew = Assign("unknown", sp.Integer(0), condition=sp.Symbol("running", real=True) > 0)
    with pytest.raises(ValueError, match="left without a value"):
        replace(block, step=(*block.step, anew))


def test_c_arrays_are_padded_to_four_rows(projects: dict[str, Project]) -> None:
    block = CBlock(projects["differential"].plant, "differential", "double")
    rows = next(field for field in block.derived if field.name == "transition").dimensions
    assert rows.startswith("[23]") and rows.endswith("[20]")


@given(st.lists(st.tuples(st.floats(0.01, 50), st.floats(-20, 20)), min_size=2, max_size=7), st.floats(-300, 300))
def test_lookup_is_linear_interpolation(points: list[tuple[float, float]], value: float) -> None:
    """Constant beyond the ends; NumPy and CasADi."""
    grid = np.cumsum([step for step, _ in points]) - 60.0
    torque = np.array([height for _, height in points])
    slope = np.append(np.diff(torque) / np.diff(grid), 0.0)
    expected = np.interp(value, grid, torque)
    assert lookup(np.array(value), grid, slope, torque) == pytest.approx(expected, abs=1e-9)
    result = CASADI_KERNELS["lookup"](ca.DM(value), ca.DM(grid), ca.DM(slope), ca.DM(torque))
    assert float(result) == pytest.approx(expected, abs=1e-9)

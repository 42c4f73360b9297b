"""Constraint sets: what is removed is safe, what is kept is needed, horizons end where nothing is added."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.optimize
from hypothesis import given, settings
from hypothesis import strategies as st

from ptgen.errors import ControlError
from ptgen.governor.constraint_set import constraint_set, torque_limits
from ptgen.governor.prediction import predict_loop
from ptgen.governor.row_removal import OCCURRING, RowFamily, needed_rows
from ptgen.testbed.governor_settings import GovernorSettings


def settings_with(**values) -> GovernorSettings:
    return GovernorSettings().model_copy(update=values)


@pytest.fixture(scope="module")
def loop(projects):
    project = projects["differential"]
    return predict_loop(project.design, project.testbed), torque_limits(project.design.decoupling.model)


@pytest.fixture(scope="module")
def automatic(loop):
    return constraint_set(*loop, settings_with())


@st.composite
def families(draw):
    """Rows of random stable loops, a few machines and states, as shares of the limits."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    m, n, K = draw(st.integers(1, 3)), draw(st.integers(1, 4)), 60
    A = rng.normal(size=(n, n))
    A *= draw(st.floats(0.5, 0.95)) / abs(np.linalg.eigvals(A)).max()
    rows = np.empty((m, K, n))
    rows[:, 0] = rng.normal(size=(m, n))
    for k in range(1, K):
        rows[:, k] = rows[:, k - 1] @ A
    return RowFamily(rows, rng.uniform(0.3, 1.0, m), draw(st.sampled_from([0.0, 0.02])))


def largest_violation(family, steps, machine, k):
    """Return the same with scipy, straight from the definition: torque at rest w, limit s, distance from rest xi."""
    m, n = family.rows.shape[0], family.rows.shape[2]
    rows, right = [], []
    for i in range(m):
        for sign in (1, -1):
            for step in steps[i]:
                row = np.zeros(n + 2 * m)
                row[:n], row[n + i], row[n + m + i] = sign * family.rows[i, step], sign, -1.0
                rows.append(row)
            row = np.zeros(n + 2 * m)
            row[n + i], row[n + m + i] = sign, -(1 - family.stationary_reserve)
            rows.append(row)
    cost = np.zeros(n + 2 * m)
    cost[:n], cost[n + machine], cost[n + m + machine] = family.rows[machine, k], 1.0, -1.0
    largest = np.abs(family.rows).max(axis=(0, 1))
    bounds = [(-OCCURRING / c, OCCURRING / c) for c in largest] + [(-1, 1)] * m
    bounds += [(least, 1.0) for least in family.least_limit]
    right = np.zeros(len(rows))
    found = scipy.optimize.linprog(-cost, A_ub=np.array(rows), b_ub=right, bounds=bounds)
    s = found.x[n + m + machine]
    return -found.fun, s


@settings(max_examples=15)
@given(families(), st.sampled_from([0.001, 0.05]))
def test_removed_rows_bind_by_less_than_epsilon(family, epsilon):
    """For every row, kept or not, another program finds no larger violation than what is said of it."""
    found = needed_rows(family, epsilon)
    for machine in range(len(family.rows)):
        for k in range(0, family.rows.shape[1], 3):
            worst, s = largest_violation(family, found.steps, machine, k)
            assert worst <= epsilon * s + 1e-7
            assert found.binding[machine, k] <= epsilon + 1e-8


@settings(max_examples=10)
@given(families())
def test_kept_rows_hold_with_tightened_limits_then_all_rows_hold(family):
    """Random points on the border of the tightened set keep the whole limits."""
    epsilon = 0.05
    found, rng = needed_rows(family, epsilon), np.random.default_rng(0)
    m, _, n = family.rows.shape
    largest = np.abs(family.rows).max(axis=(0, 1))
    for _ in range(50):
        s = rng.uniform(family.least_limit, 1.0)
        xi = rng.uniform(-1, 1, n) / largest
        w = rng.uniform(-1, 1, m) * s * (1 - family.stationary_reserve)
        kept = max(float((abs(w[i] + family.rows[i, found.steps[i]] @ xi) / s[i]).max()) for i in range(m))
        factor = min(1 / (1 + epsilon) / kept, 1.0)
        for i in range(m):
            assert (abs(factor * (w[i] + family.rows[i] @ xi)) <= s[i] * (1 + 1e-9)).all()


def test_horizon_is_the_smallest_for_which_longer_ones_add_nothing(loop, automatic):
    """Behind it no row binds by more than epsilon; one step shorter, one does."""
    behind = automatic.binding[:, automatic.horizon + 1 :]
    assert behind.size
    assert behind.max() <= automatic.removal * (1 + 1e-6)
    h = loop[0].sample_time
    shorter = constraint_set(*loop, settings_with(horizon=0.8 * automatic.horizon * h), check=False)
    assert shorter.binding[:, shorter.horizon + 1 :].max() > automatic.removal


def test_half_a_second_has_the_rows_of_the_source(loop, automatic):
    """k* = 5000 are 30012 rows (7.31); far less are needed, and they are those of the automatic horizon."""
    given_horizon = constraint_set(*loop, settings_with(horizon=0.5))
    assert given_horizon.all_rows == 30012
    assert given_horizon.kept_rows < 30012 / 30
    assert given_horizon.counts == automatic.counts
    assert given_horizon.loss == pytest.approx(0.0005 / 1.0005)


def test_a_short_horizon_is_refused_with_machine_and_torque(loop):
    with pytest.raises(ControlError, match=r"governor.horizon: 0.05 s is too short: 0.0\d+ s ahead M1 .* N m .*take 0"):
        constraint_set(*loop, settings_with(horizon=0.05))


def test_no_horizon_predicts_nothing(loop):
    found = constraint_set(*loop, settings_with(horizon=0.0))
    assert found.counts == (0, 0, 0)
    assert found.rows_x().shape == (0, len(loop[0].A))
    assert found.all_rows == 12


def test_rows_are_what_the_loop_does(loop, automatic):
    """Simulated step by step from a random state, the commands are the present ones plus the rows."""
    p = loop[0]
    rng = np.random.default_rng(3)
    x, r = rng.normal(size=len(p.A)), rng.normal(size=len(p.references))
    now, rows_x, rows_r = p.C @ x + p.D @ r, automatic.rows_x(), automatic.rows_r()
    ahead = rows_x @ x + rows_r @ r
    state, position = x, 0
    future = []
    for _ in range(automatic.horizon + 1):
        future.append(p.C @ state + p.D @ r)
        state = p.A @ state + p.B @ r
    for machine, steps in enumerate(automatic.steps):
        for k in steps:
            assert now[machine] + ahead[position] == pytest.approx(future[k][machine], rel=1e-9, abs=1e-6)
            position += 1
    assert position == len(rows_x)


def test_full_set_has_every_row(automatic):
    full = automatic.full()
    assert full.counts == (automatic.horizon,) * 3
    assert full.loss == 0.0


def test_limits_are_those_of_the_drives(projects):
    limits = torque_limits(projects["differential"].design.decoupling.model)
    assert [limit.largest for limit in limits] == [930.0, 3700.0, 3700.0]
    assert limits[1].least == pytest.approx(3700 * 1800 / 6000)


def test_a_set_without_any_reserve_is_refused(loop):
    with pytest.raises(ControlError, match="both zero"):
        constraint_set(*loop, settings_with(stationary_reserve=0.0, removal=0.0))


def test_progress_goes_from_start_to_end(loop):
    told = []
    constraint_set(*loop, settings_with(removal=0.05), told.append)
    assert told == sorted(told)
    assert 0 <= told[0] < 0.1
    assert 0.9 < told[-1] <= 1.0

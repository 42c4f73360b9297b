"""The optimal governor against HiGHS, and in the cases that a solver of programs fears."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from governor_problems import Problems, Sizes, random_problems, tables
from hypothesis import given
from hypothesis import strategies as st
from reference_program import ReferenceProgram

from ptgen.shaping.optimal import LIMITED, MARGIN, NOT_SOLVED, NOTHING_BINDS, SLACK, optimal_governor

LARGER = Sizes(
    m=5, n=17, counts=(50, 47, 0, 60, 52), group=(0, 1, 1, 2, 2), order=(1, 1, 2, 2, 3, 3, 4, 4, 0, 0), seed=3
)
SMALL = Sizes(m=2, n=3, counts=(4, 3), group=(0, 0), order=(1, 1, 0, 0), seed=5)

REFUGE = np.array([-5.0, -5.0])

Result = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]


def govern(sizes: Sizes, p: Problems, chosen: float = 1.0, iterations: int | None = None) -> Result:
    rows_x, rows_r = tables(sizes)
    shared = (p.wanted, p.before, p.free, p.gain, p.least, p.most, p.deviation, rows_x, rows_r, p.weight, p.tie)
    bound = sizes.iterations if iterations is None else iterations
    return optimal_governor(np.array(chosen), *shared, np.array(sizes.group), p.before, *sizes.counts, bound)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(("sizes", "count"), [(Sizes(), 2000), (LARGER, 500)], ids=["three machines", "five machines"])
def test_agrees_with_highs_on_all_rows(sizes: Sizes, count: int, seed: int) -> None:
    """Ten thousand programs: the same worth, no row violated, and the same answer to whether there is a solution."""
    problems = random_problems(sizes, count, seed)
    shaped, slack, _, status = govern(sizes, problems)
    assert {*status} == {NOTHING_BINDS, LIMITED, SLACK}
    for k in range(count):
        program = ReferenceProgram(sizes, problems[k])
        h = program.share(shaped[k])
        lacking = program.violation(problems[k].before)
        assert slack[k] == pytest.approx(lacking if status[k] == SLACK else 0.0, abs=1e-9)
        span = 0.5 * (problems.most - problems.least)[k] + slack[k]
        expected = program.solve(slack[k] + (MARGIN * span if status[k] == SLACK else 0.0))
        assert expected.feasible
        assert abs(program.worth(h) - expected.worth) <= 1e-9 * max(program.worth(np.ones(len(h))), 1.0)
        assert np.all(program.violation(shaped[k]) <= slack[k] + 2e-9 * span)
        if status[k] == SLACK:
            assert not program.solve(np.zeros(sizes.m)).feasible
        if status[k] == NOTHING_BINDS:
            assert np.array_equal(shaped[k], problems.wanted[k])


def one(**changed: object) -> Problems:
    """Return a problem of two machines with a diagonal gain, in which nothing binds but what is changed."""
    values: dict[str, object] = {
        "wanted": [10.0, 20.0],
        "before": [0.0, 0.0],
        "free": [0.0, 0.0],
        "gain": [[1.0, 0.0], [0.0, 2.0]],
        "least": [-100.0, -100.0],
        "most": [100.0, 100.0],
        "reserve": [0.0, 0.0],
        "rate_step": [0.0, 0.0],
        "tie": 0.0,
        "modified": 0.0,
        "deviation": [0.0, 0.0, 0.0],
        "weight": [1.0, 1.0],
    }
    return Problems(**{name: np.array(value, dtype=float) for name, value in {**values, **changed}.items()})


def govern_one(
    p: Problems, rows_r: np.ndarray | None = None, group: tuple[float, ...] = (0, 0), bound: int = 24
) -> Result:
    rows_r = np.zeros((1, 2)) if rows_r is None else rows_r
    counts = (0, 0) if len(rows_r) == 1 else (len(rows_r), 0)
    shared = (p.wanted, p.before, p.free, p.gain, p.least, p.most, p.deviation, np.zeros((len(rows_r), 3)), rows_r)
    return optimal_governor(np.array(1.0), *shared, p.weight, p.tie, np.array(group), REFUGE, *counts, bound)


def test_nothing_binds_without_work() -> None:
    shaped, slack, iterations, status = govern_one(one())
    assert np.array_equal(shaped, [10.0, 20.0]) and not slack.any()
    assert iterations == 0 and status == NOTHING_BINDS


def test_one_machine_is_limited_alone() -> None:
    shaped, _, iterations, status = govern_one(one(most=[100.0, 30.0]))
    assert shaped[0] == 10.0 and shaped[1] == pytest.approx(15.0, abs=1e-12)
    assert iterations == 1 and status == LIMITED


@pytest.mark.parametrize(("weight", "expected"), [([1.0, 100.0], [0.0, 20.0]), ([100.0, 1.0], [10.0, 15.0])])
def test_weights_decide_what_gives_way(weight: list[float], expected: list[float]) -> None:
    p = one(gain=[[2.0, 2.0], [0.0, 0.0]], most=[[50.0, 100.0], [40.0, 100.0]][weight[0] < 2], weight=weight)
    assert govern_one(p)[0] == pytest.approx(expected, abs=1e-12)


def test_nothing_is_to_be_changed() -> None:
    """All changes zero: rows have no coefficients; a violation can only be answered by slack."""
    p = one(wanted=[0.0, 0.0], free=[130.0, 0.0])
    shaped, slack, _, status = govern_one(p)
    assert np.array_equal(shaped, [0.0, 0.0]) and status == SLACK
    assert slack == pytest.approx([30.0, 0.0])
    assert govern_one(replace(p, free=np.zeros(2)))[3] == NOTHING_BINDS


def test_one_change_is_zero() -> None:
    shaped, _, _, status = govern_one(one(wanted=[0.0, 80.0]))
    assert shaped == pytest.approx([0.0, 50.0]) and status == LIMITED


@pytest.mark.parametrize("spread", [0.0, 1e-15, 1e-12, 1e-9, 1e-6])
def test_parallel_rows(spread: float) -> None:
    rows = np.array([[0.0, 3.0]] * 20) + spread * np.arange(40.0).reshape(20, 2)
    shaped, _, iterations, status = govern_one(one(gain=[[30.0, 0.0], [0.0, 1.0]]), rows)
    assert status == LIMITED and iterations < 24
    commands = 30.0 * shaped[0] + rows @ (shaped - np.array([10.0, 20.0]))
    assert np.all(commands <= 100.0 * (1 + 1e-11))
    assert shaped[1] <= 20.0 and np.max(commands) == pytest.approx(100.0, rel=1e-9)


def test_limits_that_cross() -> None:
    shaped, slack, _, status = govern_one(one(least=[50.0, -100.0], most=[-50.0, 100.0]))
    assert status == SLACK and slack == pytest.approx([50.0, 0.0])
    assert shaped == pytest.approx([0.0, 20.0], abs=1e-5)


def test_slack_of_one_machine_leaves_the_others_their_limits() -> None:
    shaped, slack, _, status = govern_one(one(free=[150.0, 0.0], wanted=[10.0, 80.0]))
    assert status == SLACK and slack == pytest.approx([50.0, 0.0])
    assert shaped == pytest.approx([0.0, 50.0], abs=1e-5)


def test_violations_that_a_change_takes_back_need_no_slack() -> None:
    shaped, slack, _, status = govern_one(one(free=[-105.0, 0.0]))
    assert status == NOTHING_BINDS and not slack.any() and shaped[0] == 10.0


def test_tied_references_share_one_step() -> None:
    p = one(wanted=[80.0, 80.05], before=[0.0, 0.02], tie=0.1)
    shaped = govern_one(p, group=(1, 1))[0]
    assert shaped[1] == pytest.approx(50.0 + 0.02, abs=1e-9)  # the second machine has the larger gain
    share = (shaped - p.before) / (p.wanted - p.before)
    assert share[0] == pytest.approx(share[1], abs=1e-12)
    assert govern_one(p, group=(1, 2))[0][0] == 80.0
    assert govern_one(replace(p, tie=np.array(0.01)), group=(1, 1))[0][0] == 80.0


def test_fallback_if_it_is_not_chosen() -> None:
    p = random_problems(Sizes(), 5, 0)
    shaped, slack, iterations, status = govern(Sizes(), p, chosen=0.5)
    assert np.array_equal(shaped, p.before) and not slack.any() and not iterations.any() and not status.any()


def test_fallback_when_the_bound_is_hit() -> None:
    p = random_problems(Sizes(), 300, 7)
    needed = govern(Sizes(), p)[2]
    for bound in (0, 1, 3):
        shaped, _, iterations, status = govern(Sizes(), p, iterations=bound)
        assert np.array_equal(status == NOT_SOLVED, needed > bound)
        assert np.all(iterations <= bound)
        assert np.array_equal(shaped[needed > bound], p.before[needed > bound])


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300])
@pytest.mark.parametrize(
    "name", [f.name for f in fields(Problems) if f.name not in ("reserve", "rate_step", "modified")]
)
def test_what_is_not_finite_is_refused(name: str, value: float) -> None:
    p = one(most=[100.0, 30.0])
    array = np.array(getattr(p, name))
    array.flat[-1] = value
    shaped, _, iterations, status = govern_one(replace(p, **{name: array}))
    if np.isfinite(value) and name != "deviation":
        assert np.isfinite(shaped).all() and status in (NOTHING_BINDS, LIMITED, SLACK, NOT_SOLVED)
        return
    assert status == NOT_SOLVED and iterations == 0
    assert np.array_equal(shaped, REFUGE)


def test_a_fallback_that_is_not_finite_is_no_fallback() -> None:
    p = random_problems(SMALL, 1, 0)[0]
    rows_x, rows_r = tables(SMALL)
    shared = (p.wanted, p.before, p.free, p.gain, p.least, p.most, p.deviation * np.nan, rows_x, rows_r, p.weight)
    fallback = np.array([1.0, np.nan])
    shaped = optimal_governor(np.array(1.0), *shared, p.tie, np.zeros(2), fallback, *SMALL.counts, 9)[0]
    assert np.array_equal(shaped, [1.0, p.before[1]])


@given(st.integers(0, 2**32 - 1))
def test_references_stay_between_before_and_wanted(seed: int) -> None:
    p = random_problems(SMALL, 20, seed)
    shaped, slack, _, status = govern(SMALL, p)
    assert np.all(shaped >= np.minimum(p.before, p.wanted)) and np.all(shaped <= np.maximum(p.before, p.wanted))
    assert np.all(slack >= 0) and not np.any(status == NOT_SOLVED)
    assert np.array_equal(shaped[status == NOTHING_BINDS], p.wanted[status == NOTHING_BINDS])


@given(st.integers(0, 2**32 - 1), st.floats(0.05, 20.0))
def test_units_and_the_size_of_weights_do_not_matter(seed: int, factor: float) -> None:
    p = random_problems(SMALL, 20, seed)
    rows_x, rows_r = tables(SMALL)
    unit = np.array([factor, 1.0])
    shared = (
        p.wanted * unit,
        p.before * unit,
        p.free,
        p.gain / unit,
        p.least,
        p.most,
        p.deviation,
        rows_x,
        rows_r / unit,
    )
    rest = (p.weight * factor, p.tie, np.zeros(2), p.before * unit)
    expected = govern(SMALL, p)
    shaped, slack, _, status = optimal_governor(np.array(1.0), *shared, *rest, *SMALL.counts, SMALL.iterations)
    assert np.array_equal(status, expected[3])
    change = np.abs(p.wanted - p.before) + 1e-12
    assert np.all(np.abs(shaped / unit - expected[0]) <= 1e-6 * change + 1e-9 * np.abs(p.wanted))
    assert slack == pytest.approx(expected[1], abs=1e-8)


@given(st.integers(0, 2**32 - 1))
def test_more_torque_is_never_worth_less(seed: int) -> None:
    p = random_problems(SMALL, 20, seed)
    change = np.where(p.wanted == p.before, 1.0, p.wanted - p.before)
    worth = []
    for factor in (1.0, 1.2):
        shaped, _, _, status = govern(SMALL, replace(p, least=p.least * factor, most=p.most * factor))
        share = np.where(p.wanted == p.before, 1.0, (shaped - p.before) / change)
        worth.append(np.where(status == SLACK, np.nan, (share * p.weight).sum(axis=1)))
    with np.errstate(invalid="ignore"):
        assert not np.any(worth[1] < worth[0] - 1e-9 * p.weight.sum(axis=1))

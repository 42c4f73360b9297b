"""The sequential governor: limits, the projection of the source's Figure 7.10, ties, reserve, rates, (7.43)."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
import scipy.optimize
from governor_problems import Problems, Sizes, random_problems
from hypothesis import given
from hypothesis import strategies as st

from ptgen.shaping.sequential import sequential_governor
from ptgen.shaping.ties import leaders

DIFFERENTIAL = (1, 1, 2, 2, 0, 0)
"""Both speeds first, then the torque, whose machine accelerates the others."""

FIVE = Sizes(m=5, n=2, counts=(0,) * 5, group=(0, 1, 1, 2, 2), order=(1, 1, 2, 2, 3, 3, 4, 4, 0, 0))


def shape(p: Problems, order: tuple[int, ...] = DIFFERENTIAL, group: tuple[float, ...] = (0, 0, 0)) -> np.ndarray:
    shared = (p.wanted, p.before, p.free, p.gain, p.least, p.most)
    return sequential_governor(*shared, p.reserve, p.rate_step, p.tie, p.modified, np.array(group), *order)


def commands(p: Problems, shaped: np.ndarray) -> np.ndarray:
    return p.free + np.einsum("...ij,...j->...i", p.gain, shaped - p.before)


def excess(p: Problems, shaped: np.ndarray) -> np.ndarray:
    value = commands(p, shaped)
    return np.maximum(np.maximum(value - p.most, p.least - value), 0.0)


def bed(**changed: object) -> Problems:
    """Return a differential: 100 N m of the input machine per rad/s of each output, 300 N m of their own machines."""
    values: dict[str, object] = {
        "wanted": [0.0, 0.0, 0.0],
        "before": [0.0, 0.0, 0.0],
        "free": [0.0, 0.0, 0.0],
        "gain": [[1.0, 100.0, 100.0], [0.0, 300.0, 0.0], [0.0, 0.0, 300.0]],
        "least": [-900.0, -3000.0, -3000.0],
        "most": [900.0, 3000.0, 3000.0],
        "reserve": [0.0, 0.0, 0.0],
        "rate_step": [0.0, 0.0, 0.0],
        "tie": 0.0,
        "modified": 0.0,
        "deviation": [0.0],
        "weight": [1.0, 1.0, 1.0],
    }
    return Problems(**{name: np.array(value, dtype=float) for name, value in {**values, **changed}.items()})


def test_nothing_binds() -> None:
    p = bed(wanted=[300.0, 2.0, 3.0])
    assert np.array_equal(shape(p), p.wanted)


def test_each_machine_limits_its_own_reference() -> None:
    shaped = shape(bed(wanted=[0.0, 20.0, -4.0], gain=np.diag([1.0, 300.0, 300.0])))
    assert shaped == pytest.approx([0.0, 10.0, -4.0], abs=1e-12)


def test_opposite_speeds_leave_the_input_alone() -> None:
    """One output faster, the other slower by as much: no torque of the input machine."""
    p = bed(wanted=[0.0, 9.0, -9.0])
    assert np.array_equal(shape(p), p.wanted)


@pytest.mark.parametrize(
    ("wanted", "expected"), [([8.0, 6.0], [5.5, 3.5]), ([9.0, 9.0], [4.5, 4.5]), ([9.0, 1.0], [8.5, 0.5])]
)
def test_a_shared_limit_is_a_projection(wanted: list[float], expected: list[float]) -> None:
    """Figure 7.10: perpendicular to the limit of M1."""
    assert shape(bed(wanted=[0.0, *wanted]))[1:] == pytest.approx(expected, abs=1e-12)


def test_a_projection_ends_at_the_box() -> None:
    """The second speed cannot go back further than to where it was, so the first one takes the rest."""
    shaped = shape(bed(wanted=[0.0, 10.0, 1.0], free=[400.0, 0.0, 0.0]))
    assert shaped[1:] == pytest.approx([5.0, 0.0], abs=1e-12)
    shaped = shape(bed(wanted=[0.0, 10.0, -1.0], free=[400.0, 0.0, 0.0]))
    assert shaped[1:] == pytest.approx([6.0, -1.0], abs=1e-12)


@given(st.integers(0, 2**32 - 1))
def test_projection_against_bisection(seed: int) -> None:
    """The multiplier of the row found by other means, machines and units of any size."""
    rng = np.random.default_rng(seed)
    m = 5
    own, shared = rng.uniform(1, 100, m - 1), rng.normal(size=m - 1) * 30
    change = rng.normal(size=m - 1) * 10
    gain = np.diag([1.0, *own])
    gain[0, 1:] = shared
    limit = rng.uniform(10, 500)
    p = Problems(
        **{f.name: np.zeros(m) for f in fields(Problems)}
        | {"wanted": np.array([0.0, *change]), "gain": gain, "tie": np.array(0.0), "modified": np.array(0.0)}
        | {"least": np.array([-limit, *[-1e6] * (m - 1)]), "most": np.array([limit, *[1e6] * (m - 1)])}
    )
    lacking = max(abs(shared @ change) - limit, 0.0) * np.sign(shared @ change)

    def moved(multiplier: float) -> np.ndarray:
        free = change - multiplier * np.sign(lacking) * shared / own**2
        return np.where(change > 0, np.clip(free, 0, change), np.clip(free, change, 0))

    expected = change
    if lacking != 0.0:
        root = scipy.optimize.brentq(
            lambda x: abs(shared @ moved(x)) - limit if np.sign(shared @ moved(x)) == np.sign(lacking) else -limit,
            0.0,
            1e9,
            xtol=1e-14,
            rtol=1e-15,
        )
        expected = moved(root)
    shaped = shape(p, order=(1, 1, 2, 2, 3, 3, 4, 4, 0, 0), group=(0,) * m)
    assert shaped[1:] == pytest.approx(expected, abs=1e-7)
    assert abs(commands(p, shaped)[0]) <= limit * (1 + 1e-12)


def test_reserve_is_kept_from_others_but_not_from_the_own_reference() -> None:
    p = bed(wanted=[500.0, 9.0, 9.0], reserve=[200.0, 0.0, 0.0])
    shaped = shape(p)
    assert shaped[1:] == pytest.approx([3.5, 3.5], abs=1e-12)
    assert shaped[0] == pytest.approx(200.0, abs=1e-9)


def test_a_minimal_rate_of_the_torque_is_left() -> None:
    p = bed(wanted=[500.0, 9.0, 9.0])
    assert shape(p)[0] == pytest.approx(0.0, abs=1e-9)
    shaped = shape(replace(p, rate_step=np.array([100.0, 0.0, 0.0])))
    assert shaped == pytest.approx([100.0, 4.0, 4.0], abs=1e-9)
    down = shape(replace(p, wanted=np.array([-500.0, 9.0, 9.0]), rate_step=np.array([100.0, 0.0, 0.0])))
    assert down == pytest.approx([-500.0, 5.0, 5.0], abs=1e-9)  # what the torque gives up goes to the speeds


def test_a_reserve_larger_than_the_limits_leaves_others_the_middle() -> None:
    shaped = shape(bed(wanted=[0.0, 9.0, 1.0], reserve=[2000.0, 0.0, 0.0], free=[-100.0, 0.0, 0.0]))
    assert shaped[1:] == pytest.approx([1.0, 0.0], abs=1e-9)


def test_tied_speeds_go_on_by_the_same_share() -> None:
    p = bed(wanted=[0.0, 20.0, 20.05], before=[0.0, 0.01, 0.0], tie=0.1, most=[9e9, 3000.0, 1500.0], least=[-9e9] * 3)
    shaped = shape(p, group=(0, 1, 1))
    share = (shaped - p.before)[1:] / (p.wanted - p.before)[1:]
    assert share[0] == pytest.approx(share[1], rel=1e-12)
    assert shaped[2] == pytest.approx(5.0, abs=1e-12)
    assert shape(p, group=(0, 1, 2))[1] == pytest.approx(10.01, abs=1e-12)


def test_without_the_modification_a_violation_that_is_there_stays() -> None:
    """Beyond the limit without any change: (7.41) can only stand still, (7.43) goes back."""
    p = bed(wanted=[0.0, 9.0, 9.0], free=[1000.0, 0.0, 0.0])
    assert shape(p) == pytest.approx([0.0, 0.0, 0.0])
    q = replace(p, modified=np.array(1.0))
    assert commands(q, shape(q))[0] == pytest.approx(900.0)
    assert shape(q) == pytest.approx([0.0, -0.5, -0.5])
    tied = shape(replace(q, wanted=np.array([0.0, 9.0, 8.0]), tie=np.array(2.0)), group=(0, 1, 1))
    assert tied[1] - tied[2] == pytest.approx(1.0)  # tied references are shifted by the same amount


def test_the_modification_goes_back_as_far_as_the_machine_of_a_reference_allows() -> None:
    p = bed(free=[1500.0, -2700.0, 0.0], modified=1.0)
    shaped = shape(p)
    assert shaped == pytest.approx([0.0, -1.0, -5.0])
    assert np.all(excess(p, shaped) <= 1e-9)


@given(st.integers(0, 2**32 - 1))
def test_limits_are_kept_whatever_depends_on_what(seed: int) -> None:
    """With any gain: if all limits are kept without a change, they are kept with the change that is made."""
    p = random_problems(FIVE, 40, seed)
    rng = np.random.default_rng(seed)
    p = replace(p, gain=rng.normal(size=p.gain.shape) * 30, modified=np.zeros(40), tie=np.zeros(40))
    p = replace(p, free=np.clip(p.free, p.least, p.most))
    shaped = shape(p, FIVE.order, FIVE.group)
    assert np.all(excess(p, shaped) <= 3e-9 * (p.most - p.least))
    assert np.all(shaped >= np.minimum(p.before, p.wanted)) and np.all(shaped <= np.maximum(p.before, p.wanted))


@given(st.integers(0, 2**32 - 1))
def test_limits_are_kept_in_the_order_of_a_bed(seed: int) -> None:
    p = random_problems(FIVE, 40, seed)
    p = replace(p, modified=np.zeros(40), free=np.clip(p.free, p.least, p.most))
    shaped = shape(p, FIVE.order, FIVE.group)
    assert np.all(excess(p, shaped) <= 1e-9 * (p.most - p.least))
    fits = np.all(excess(p, p.wanted) == 0, axis=1) & ~p.reserve.any(axis=1) & ~p.rate_step.any(axis=1)
    assert np.array_equal(shaped[fits], p.wanted[fits])


@given(st.integers(0, 2**32 - 1))
def test_the_modification_never_passes_the_wanted_reference(seed: int) -> None:
    p = random_problems(FIVE, 40, seed)
    p = replace(p, modified=np.ones(40))
    plain = shape(replace(p, modified=np.zeros(40)), FIVE.order, (0,) * 5)
    free = shape(p, FIVE.order, (0,) * 5)
    side = np.sign(p.wanted - p.before)
    assert np.all(side * (free - p.wanted) <= 1e-12 * np.abs(p.wanted))
    # One that is tied may pass a wanted one that is closer than the tie, by what its partner moves too.
    shaped = shape(p, FIVE.order, FIVE.group)
    for index, reference in np.argwhere(side * (shaped - p.wanted) > 1e-12 * np.abs(p.wanted)):
        led = np.array(leaders(p.wanted[index], p.before[index], float(p.tie[index]), np.array(FIVE.group)))
        partners = led == led[reference]
        assert partners.sum() > 1
        assert abs(p.wanted[index] - p.before[index])[reference] < p.tie[index]
        assert np.ptp((shaped - p.wanted)[index][partners]) < 1e-9 * (1 + np.abs(p.wanted[index]).max())
    own = np.abs(p.gain[:, range(1, 5), range(1, 5)]) > 0
    worse = excess(p, free)[:, 1:] > excess(p, plain)[:, 1:] + 1e-9 * (p.most - p.least)[:, 1:]
    assert not np.any(worse & own)


@given(st.integers(0, 2**32 - 1), st.floats(0.05, 20.0))
def test_units_do_not_matter(seed: int, factor: float) -> None:
    p = random_problems(FIVE, 20, seed)
    p = replace(p, tie=np.zeros(20))
    unit = np.array([1.0, factor, 1.0, 1.0, 1.0 / factor])
    scaled = replace(
        p, wanted=p.wanted * unit, before=p.before * unit, gain=p.gain / unit, rate_step=p.rate_step * unit
    )
    difference = shape(scaled, FIVE.order, FIVE.group) / unit - shape(p, FIVE.order, FIVE.group)
    assert np.all(np.abs(difference) <= 1e-9 * (np.abs(p.wanted) + np.abs(p.before) + 1.0))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", [f.name for f in fields(Problems) if f.name not in ("deviation", "weight", "before")])
def test_what_is_not_finite_changes_nothing(name: str, value: float) -> None:
    p = bed(wanted=[1.0, 2.0, 3.0])
    array = np.array(getattr(p, name))
    array.flat[-1] = value
    assert np.array_equal(shape(replace(p, **{name: array})), p.before)


def test_results_that_would_not_be_finite_change_nothing() -> None:
    p = bed(wanted=[0.0, 1.7e308, 0.0], before=[0.0, -1.7e308, 0.0])
    assert np.array_equal(shape(p), p.before)


def test_a_reference_in_no_pair_is_not_limited() -> None:
    p = bed(wanted=[5e3, 20.0, 0.0])
    assert shape(p, order=(1, 1))[0] == 5e3


@pytest.mark.parametrize("modified", [0.0, 1.0])
def test_machines_that_a_reference_does_not_move(modified: float) -> None:
    """Zero gains everywhere: nothing to divide by."""
    p = bed(wanted=[1.0, 2.0, 3.0], gain=np.zeros((3, 3)), free=[1e4, 0.0, -1e4], modified=modified)
    assert np.array_equal(shape(p), p.wanted)


@pytest.mark.parametrize("modified", [0.0, 1.0])
def test_a_speed_with_little_to_go_is_not_driven_back(modified: float) -> None:
    """While standing still keeps a shared limit, (7.43) moves no reference away from the wanted one."""
    p = bed(wanted=[0.0, 0.3, 10.0], free=[800.0, 0.0, 0.0], modified=modified)
    shaped = shape(p)
    assert ((shaped >= p.before) & (shaped <= p.wanted)).all()
    assert excess(p, shaped).max() < 1e-9

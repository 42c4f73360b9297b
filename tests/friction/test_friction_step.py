"""Friction over a step with events inside: three evaluators, and what the result has to mean."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
import pytest
from box_problems import box_library
from hypothesis import given
from hypothesis import strategies as st

from ptgen.block import casadi_friction
from ptgen.friction.box import is_deficient, solve_box
from ptgen.friction.step import UNSOLVED, FrictionStep, step_friction

ELEMENTS = range(1, 7)


@dataclass(frozen=True)
class Step:
    """Arguments of one step."""

    K: np.ndarray
    w: np.ndarray
    w_free: np.ndarray
    slide: np.ndarray
    rest: np.ndarray
    guess: np.ndarray
    deficient: bool
    bits: int
    rest_before: np.ndarray | None = None

    @property
    def one_way(self) -> np.ndarray:
        return np.array([bool(self.bits >> i & 1) for i in range(len(self.w))])

    def by_numpy(self) -> FrictionStep:
        return step_friction(
            self.K,
            self.deficient,
            self.w,
            self.w_free,
            self.slide,
            self.rest,
            self.guess,
            self.one_way,
            self.rest_before,
        )

    def by_c(self) -> FrictionStep:
        arrays = (self.K, self.w, self.w_free, self.slide, self.rest, self.guess)
        return FrictionStep(
            *box_library(len(self.w)).friction_step(*arrays, self.deficient, self.bits, self.rest_before)
        )

    def by_casadi(self) -> FrictionStep:
        function = casadi_step(len(self.w), self.deficient, self.bits)
        before = np.zeros(len(self.w)) if self.rest_before is None else self.rest_before
        rows = (self.w, self.w_free, self.slide, self.rest, self.guess, before)
        mean, end, _, w_plus, status = function(self.K, *rows)
        return FrictionStep(*(np.array(value).ravel() for value in (mean, end, w_plus)), float(status))


@cache
def casadi_step(n: int, deficient: bool, bits: int) -> Any:
    names = ("w", "w_free", "slide", "rest", "guess", "rest_before")
    arguments = [ca.MX.sym("K", n, n), *(ca.MX.sym(name, n) for name in names)]
    results = casadi_friction.friction_step(*arguments, int(deficient), bits)
    return ca.Function("step", arguments, list(results))


def mechanism(rng: np.random.Generator, n: int, dependent: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return elements on bodies (n, bodies) and mobilities of the bodies: a tree, or fewer bodies than elements."""
    if dependent:
        bodies = int(rng.integers(1, n))
        G = rng.integers(-2, 3, (n, bodies)).astype(float)
        G[np.arange(n), rng.integers(0, bodies, n)] = 1.0
    else:
        bodies = n + 1
        G = np.eye(n, bodies, 1) - np.where(rng.random((n, 1)) < 0.8, np.eye(n, bodies), 0.0)
    return G, 10.0 ** rng.uniform(-1.0, 1.0, bodies)


def random_step(seed: int, n: int, dependent: bool = False, one_way: bool = False, follows: bool = False) -> Step:
    """Return a step with some elements at rest, some in motion, some that stop or turn.

    It `follows` another one if what that one left decides when elements have broken away.
    """
    rng = np.random.default_rng(seed)
    G, mobility = mechanism(rng, n, dependent)
    K = G @ np.diag(mobility) @ G.T
    slide = 10.0 ** rng.uniform(-1.0, 0.5, n) * (rng.random(n) > 0.1)
    rest = slide * (1.0 + (rng.random(n) < 0.5) * rng.uniform(0.0, 0.5, n))
    still = rng.random(n) < 0.4
    v = rng.normal(size=G.shape[1])
    if dependent:  # elements at rest tie the bodies, and with them other elements
        held = G[still]
        v -= np.linalg.pinv(held) @ held @ v if still.any() else 0.0
    w = G @ v
    w[still | (abs(w) < 1e-12)] = 0.0
    w_free = w + G @ (rng.normal(size=G.shape[1]) * mobility) * 3.0
    bits = 0
    if one_way:
        w_free -= w
        for i in np.flatnonzero(rng.random(n) < 0.5):
            bits |= 1 << int(i)
            w[i] = -abs(w[i])
        w_free += w
    guess = rng.uniform(-1.0, 1.0, n) * rest
    before = rest * rng.uniform(0.9, 1.1, n) if follows else np.zeros(n)
    return Step(K, w, w_free, slide, rest, guess, bool(n > 1 and is_deficient(K)), bits, before)


def assert_same(one: FrictionStep, other: FrictionStep, step: Step, tolerance: float) -> None:
    assert one.status == other.status
    speed = np.max(abs(step.w) + abs(step.w_free) + abs(step.K) @ step.rest)
    torque = np.max(step.rest) + np.max(abs(one.mean))
    assert one.w_plus == pytest.approx(other.w_plus, abs=tolerance * speed)
    assert one.mean == pytest.approx(other.mean, abs=tolerance * torque)
    assert one.end == pytest.approx(other.end, abs=tolerance * torque)


@pytest.mark.compile
@pytest.mark.parametrize("kind", ["two-way", "one-way", "dependent"])
@pytest.mark.parametrize("n", ELEMENTS)
def test_numpy_and_c_agree(n: int, kind: str) -> None:
    if kind == "dependent" and n == 1:
        pytest.skip("one element depends on nothing")
    for seed in range(300):
        step = random_step(seed, n, kind == "dependent", kind == "one-way", follows=seed % 2 == 0)
        result = step.by_numpy()
        assert result.status == 0.0, seed
        assert_same(result, step.by_c(), step, 1e-6 if step.deficient else 1e-9)


@pytest.mark.parametrize("kind", ["two-way", "one-way", "dependent"])
@pytest.mark.parametrize("n", ELEMENTS)
def test_numpy_and_casadi_agree(n: int, kind: str) -> None:
    if kind == "dependent" and n == 1:
        pytest.skip("one element depends on nothing")
    steps = [random_step(seed, n, kind == "dependent", kind == "one-way", seed % 2 == 0) for seed in range(1000)]
    first = next(step for step in steps if kind == "two-way" or step.bits or step.deficient)
    alike = [step for step in steps if (step.bits, step.deficient) == (first.bits, first.deficient)]
    for step in alike[: 100 if n <= 2 else (20 if n <= 4 else 6)]:
        assert_same(step.by_numpy(), step.by_casadi(), step, 1e-6 if step.deficient else 1e-9)


@pytest.mark.parametrize("n", ELEMENTS)
def test_without_event_it_is_the_box_problem(n: int) -> None:
    """Nothing that moves stops or turns; then it does not matter where in the step a torque acts."""
    compared = 0
    for seed in range(400):
        step = random_step(seed, n)
        plain = solve_box(step.K, step.w_free, -step.slide, step.slide)
        if np.all((step.w == 0) | (np.sign(plain.w_plus) == np.sign(step.w))):
            result = Step(step.K, step.w, step.w_free, step.slide, step.slide, step.guess, False, 0).by_numpy()
            assert result.mean == pytest.approx(plain.T, rel=1e-9, abs=1e-9 * np.max(step.slide + 1e-3))
            assert list(result.end) == list(result.mean)
            compared += 1
    assert compared >= 20


@pytest.mark.parametrize("w_free", [1.5, 0.4, -0.4, -1.2, -3.0])
def test_one_element_through_zero(w_free: float) -> None:
    """It needs w / (c K - slope) of the step to stop; then rest decides, and slide is what it goes on with."""
    K, w, slide, rest = 0.5, 1.0, 2.0, 2.5
    slope = w_free - w
    for side in (1.0, -1.0):
        arrays = [np.array([side * value]) for value in (w, w_free)]
        result = step_friction(
            np.array([[K]]), False, *arrays, np.array([slide]), np.array([rest]), np.zeros(1), np.zeros(1, dtype=bool)
        )
        falls = K * slide - slope
        if falls <= w:
            expected = w - falls, slide, slide
        else:
            duration = w / falls
            if abs(slope) <= K * rest:
                after, torque = 0.0, slope / K
            else:
                after, torque = (slope + K * slide) * (1 - duration), -slide
            expected = after, duration * slide + (1 - duration) * torque, torque
        got = [float(side * value[0]) for value in (result.w_plus, result.mean, result.end)]
        assert got == pytest.approx(expected, rel=1e-14, abs=1e-15)
        assert (got[0] == 0.0) == (expected[0] == 0.0)


def test_break_away_lets_the_others_ask_again() -> None:
    """Two clutches in a row hold a body together; when one breaks away, the other needs less, and holds."""
    K, w = np.array([[2.0, -1.0], [-1.0, 2.0]]), np.zeros(2)
    w_free = np.array([3.0, 0.0])  # holding both takes 2 and 1 N m
    result = step_friction(
        K, False, w, w_free, np.array([0.5, 0.6]), np.array([1.9, 0.9]), np.zeros(2), np.zeros(2, dtype=bool)
    )
    assert list(result.mean) == [0.5, 0.25]
    assert list(result.w_plus) == [2.25, 0.0]


@pytest.mark.parametrize("n", ELEMENTS)
def test_what_can_be_held_is_held_exactly(n: int) -> None:
    for seed in range(100):
        step = random_step(seed, n)
        w = np.zeros(n)
        needed = np.linalg.solve(step.K, step.w_free)
        rest = abs(needed) * 1.001 + 1e-9
        result = step_friction(step.K, False, w, step.w_free, 0.5 * rest, rest, step.guess, np.zeros(n, dtype=bool))
        assert not result.w_plus.any()
        assert result.mean == pytest.approx(needed, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("bits", [0, 1])
def test_one_way_element_pushed_forward_stops_at_once(bits: int) -> None:
    """Only from outside does it get a positive velocity; the step takes it away, however large the torque."""
    for n in (1, 2, 3):
        K = np.eye(n) + 0.2
        w = np.full(n, 0.5)
        result = Step(K, w, w + 0.1, np.full(n, 0.1), np.full(n, 0.1), np.zeros(n), False, bits).by_numpy()
        assert result.status == 0.0
        assert (result.w_plus[0] == 0.0) == bool(bits)


@pytest.mark.compile
@pytest.mark.parametrize("wrong", [-1.0, -1e-300, np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("which", ["slide", "rest"])
@pytest.mark.parametrize("n", [1, 2, 3, 5])
def test_unsound_capacity_is_named_and_counts_as_none(n: int, which: str, wrong: float) -> None:
    step = random_step(7, n)
    for first in range(n):
        spoilt, zeroed = {"slide": step.slide.copy(), "rest": step.rest.copy()}, {}
        spoilt[which][first:] = wrong
        for name in spoilt:
            zeroed[name] = np.where(np.arange(n) >= first, 0.0, getattr(step, name))
        others = (step.guess, step.deficient, step.bits)
        bad = Step(step.K, step.w, step.w_free, spoilt["slide"], spoilt["rest"], *others)
        good = Step(step.K, step.w, step.w_free, zeroed["slide"], zeroed["rest"], *others)
        for result, reference in ((bad.by_numpy(), good.by_numpy()), (bad.by_c(), good.by_c())):
            assert result.status == first + 1
            assert np.isfinite(result.mean).all() and np.isfinite(result.w_plus).all()
            assert list(result.mean) == list(reference.mean) and list(result.w_plus) == list(reference.w_plus)
    if not np.isinf(wrong) and n <= 2:
        result = bad.by_casadi()
        assert result.status == n and np.isfinite(result.mean).all()


PLAIN = st.sampled_from([0.0, 1.0, -1.0, 2.0, -2.0, 0.5, 1e-9, -1e-9, 1e6])
VALUES = st.one_of(PLAIN, st.floats(-10.0, 10.0))
AMOUNTS = st.one_of(PLAIN.map(abs), st.floats(0.0, 10.0))


@st.composite
def any_step(draw: st.DrawFn) -> Step:
    """Return a step of small whole mobilities: elements that reach zero together, hold by nothing to spare, depend."""
    n = draw(st.integers(1, 5))
    bodies = draw(st.integers(1, 4))
    G = np.array(draw(st.lists(st.lists(st.integers(-2, 2), min_size=bodies, max_size=bodies), min_size=n, max_size=n)))
    G[:, 0] = np.where(G.any(axis=1), G[:, 0], 1)
    K = G @ G.T.astype(float)

    def row(values: st.SearchStrategy[float], length: int) -> np.ndarray:
        return np.array(draw(st.lists(values, min_size=length, max_size=length)))

    w = G @ row(VALUES, bodies)
    rest = row(AMOUNTS, n)
    slide = rest * draw(st.sampled_from([0.0, 0.5, 1.0]))
    deficient = n > 1 and is_deficient(K)
    return Step(
        K, w, w + G @ row(VALUES, bodies), slide, rest, row(VALUES, n), deficient, draw(st.integers(0, 2**n - 1))
    )


@pytest.mark.compile
@given(any_step())
def test_any_step_is_sane(step: Step) -> None:
    for result in (step.by_numpy(), step.by_c()):
        assert result.status == 0.0
        for values in (result.mean, result.end, result.w_plus):
            assert np.isfinite(values).all()
        above = np.where(step.one_way, np.inf, step.rest) + 1e-12 * (1.0 + step.rest)
        assert np.all(result.mean >= -step.rest * (1 + 1e-12)) and np.all(result.mean <= above)
        size = abs(step.w) + abs(step.w_free) + abs(step.K) @ abs(result.mean)
        left = step.w_free - step.K @ result.mean - result.w_plus
        assert np.all(abs(left) <= 1e-10 * np.max(size) + 1e-300)


@pytest.mark.parametrize("n", ELEMENTS)
def test_without_drive_energy_only_falls(n: int) -> None:
    """With dw/ds = -K T and E = w' K^-1 w / 2 it is dE/ds = -w'T, and w_i T_i >= 0 in every piece of the step."""
    for seed in range(200):
        step = random_step(seed, n)
        result = Step(step.K, step.w, step.w, step.slide, step.rest, step.guess, False, 0).by_numpy()
        before, after = (w @ np.linalg.solve(step.K, w) for w in (step.w, result.w_plus))
        assert after <= before * (1 + 1e-12)
        if np.any((step.w != 0) & (step.slide > 0)):
            assert after < before


@pytest.mark.parametrize("n", ELEMENTS)
def test_two_half_steps_are_one(n: int) -> None:
    """Straight lines do not depend on how they are cut, so the work of the friction in a part has its sign too."""
    for seed in range(60):
        step = random_step(seed, n)
        whole = step.by_numpy()
        parts, w, T, total, dissipated = 16, step.w, step.guess, np.zeros(n), np.zeros(n)
        slope = step.w_free - step.w
        for _ in range(parts):
            part = Step(step.K / parts, w, w + slope / parts, step.slide, step.rest, T, step.deficient, 0).by_numpy()
            same = w * part.w_plus > 0
            dissipated += np.where(same, part.mean * (w + part.w_plus), 0.0)
            assert np.all(part.mean[same] * w[same] >= 0.0)
            w, T, total = part.w_plus, part.end, total + part.mean / parts
        speed = np.max(abs(step.w) + abs(step.w_free))
        assert w == pytest.approx(whole.w_plus, abs=1e-9 * speed)
        assert total == pytest.approx(whole.mean, abs=1e-9 * np.max(step.rest))
        assert np.all(dissipated >= 0.0)


@pytest.mark.parametrize("kind", ["two-way", "one-way", "dependent"])
@pytest.mark.parametrize("n", ELEMENTS)
def test_after_a_break_away_in_the_step_before_what_is_held_stays(n: int, kind: str) -> None:
    """Torques at the end never drive, and one inside its limits leaves no velocity, whenever others broke away."""
    if kind == "dependent" and n == 1:
        pytest.skip("one element depends on nothing")
    for seed in range(300):
        step = random_step(seed, n, kind == "dependent", kind == "one-way", follows=True)
        result = step.by_numpy()
        scale = np.max(abs(step.w) + abs(step.w_free))
        assert np.all(result.end * result.w_plus >= 0), seed
        inside = abs(result.end) < np.minimum(step.slide, step.rest) * (1 - 1e-9)
        assert np.all(abs(result.w_plus[inside]) <= 1e-12 * scale), seed


@pytest.mark.compile
def test_a_step_that_was_never_prepared_gives_no_torque() -> None:
    for n in (1, 2, 4):
        rows = (np.zeros(n), np.ones(n), np.ones(n), np.ones(n), np.ones(n))
        mean, torque, w_plus, status = box_library(n).friction_step(np.zeros((n, n)), *rows, False, 0)
        assert status == UNSOLVED
        assert not mean.any() and not torque.any() and list(w_plus) == [1.0] * n

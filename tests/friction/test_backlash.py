"""Torques of shafts with backlash over a step: the equation itself, its energy, three evaluators."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
import pytest
from box_problems import box_library
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from ptgen.block import casadi_friction
from ptgen.friction.backlash import backlash_step

Arguments = tuple[np.ndarray, ...]


def beyond(e: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the twist beyond the gap."""
    return e - np.clip(e, -b, b)


def mean_torque(e: float, end: float, b: float, c: float, d: float) -> float:
    """Return the torque that a step between two twists has, as it is defined."""
    p, p_end = (float(beyond(np.array(x), np.array(b))) for x in (e, end))
    if end == e:
        return c * p
    return 0.5 * c * (p_end**2 - p**2) / (end - e) + d * (p_end - p)


def random_shafts(seed: int, n: int, coupling: float = 0.3) -> Arguments:
    """Return shafts on both sides of their gaps and inside, that stay, enter, leave or cross."""
    rng = np.random.default_rng(seed)
    b = 10.0 ** rng.uniform(-4, -1, n) * (rng.random(n) > 0.05)
    A = rng.normal(size=(n, n)) * coupling
    scale = 10.0 ** rng.uniform(-3, 0, n)
    kappa = (np.eye(n) + A @ A.T) * np.sqrt(np.outer(scale, scale)) * 1e-4
    e = b * rng.choice([-3.0, -1.0, -0.5, 0.0, 0.5, 1.0, 1.01, 3.0], n)
    e_free = e + b * rng.choice([0.0, 1e-6, 0.5, 1.0, 2.0, 5.0], n) * rng.choice([-1.0, 1.0], n)
    c = rng.uniform(0.01, 2.0, n) / np.diag(kappa)
    d = rng.choice([0.0, 0.01, 0.5], n) / np.diag(kappa)
    return kappa, e, e_free, b, c, d


def test_torque_solves_the_equation() -> None:
    regions = set()
    for seed in range(3000):
        kappa, e, e_free, b, c, d = random_shafts(seed, 1)
        T = float(backlash_step(kappa, e, e_free, b, c, d)[0])
        k, start, free, gap, *law = (float(a.ravel()[0]) for a in (kappa, e, e_free, b, c, d))

        def excess(end: float, numbers: Sequence[float] = (k, start, free, gap, *law)) -> float:
            return end + numbers[0] * mean_torque(numbers[1], end, *numbers[3:]) - numbers[2]

        width = abs(start) + abs(free) + gap + 1e-12
        end = brentq(excess, -4 * width, 4 * width, xtol=1e-18, rtol=1e-15)
        assert free - k * T == pytest.approx(end, abs=1e-12 * width), seed
        regions.add((np.sign(beyond(e, b)[0]), np.sign(beyond(np.array([end]), b)[0])))
    assert regions >= {(-1, -1), (-1, 0), (0, -1), (0, 0), (0, 1), (1, 0), (1, 1), (1, -1)}


def energy_defect(kappa: np.ndarray, e: np.ndarray, T: np.ndarray, *rest: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return by how much each shaft's work differs from stored energy less damping, and what that is the sum of."""
    e_free, b, c, d = rest
    end = e_free - kappa @ T
    p, p_end = beyond(e, b), beyond(end, b)
    stored = 0.5 * c * p**2 - 0.5 * c * p_end**2
    damped = d * (p_end - p) * (end - e)
    assert np.all(damped >= 0.0)
    work = -T * (end - e)
    # Twists are known to the rounding of what they are differences of.
    known = abs(e) + abs(e_free) + abs(kappa) @ abs(T)
    size = (abs(T) + c * (abs(p) + abs(p_end)) + d * abs(end - e)) * known
    return abs(work - stored + damped), size


@pytest.mark.parametrize(("n", "tolerance"), [(1, 1e-12), (2, 1e-6), (3, 1e-6)])
def test_rattling_makes_no_energy(n: int, tolerance: float) -> None:
    """For one shaft to rounding; several shafts are solved in turn, and what is left of that is small."""
    for seed in range(1000):
        kappa, e, *rest = random_shafts(seed, n, coupling=0.1)
        T = backlash_step(kappa, e, *rest)
        defect, size = energy_defect(kappa, e, T, *rest)
        assert np.all(defect <= tolerance * np.max(size) + 1e-300), seed


def test_two_shafts_solve_their_equations_together() -> None:
    for seed in range(300):
        kappa, e, e_free, b, c, d = random_shafts(seed, 2, coupling=0.1)
        T = backlash_step(kappa, e, e_free, b, c, d)
        end = e_free - kappa @ T
        expected = [mean_torque(*(float(a[i]) for a in (e, end, b, c, d))) for i in range(2)]
        scale = (abs(e_free) + abs(e) + b + 1e-9) / np.diag(kappa)
        assert np.all(abs(T - expected) <= 1e-6 * np.max(scale * np.sqrt(np.diag(kappa))) / np.sqrt(np.diag(kappa))), (
            seed
        )


@cache
def casadi_step(n: int) -> Any:
    names = ("e", "e_free", "half_gap", "stiffness", "damping")
    arguments = [ca.MX.sym("kappa", n, n), *(ca.MX.sym(name, n) for name in names)]
    return ca.Function("backlash", arguments, [casadi_friction.backlash_step(*arguments)])


@pytest.mark.compile
@pytest.mark.parametrize("n", [1, 2, 3])
def test_three_evaluators_agree(n: int) -> None:
    library = box_library(1, contacts=n)
    for seed in range(1000):
        arguments = random_shafts(seed, n)
        T = backlash_step(*arguments)
        # At the edge of the gap rounding decides on which side it is solved for; the torque is the same but for that.
        kappa, e, e_free, b, *_ = arguments
        scale = np.sqrt(np.max((abs(e) + abs(e_free) + b) ** 2 / np.diag(kappa)) / np.diag(kappa))
        for other in (library.backlash_step(*arguments), np.array(casadi_step(n)(*arguments)).ravel()):
            assert np.all(abs(other - T) <= 1e-10 * scale + 1e-300), seed


@given(st.floats(-1, 1), st.floats(-1, 1), st.floats(0, 1), st.floats(0, 100), st.floats(0, 100), st.floats(1e-9, 1))
def test_any_shaft_is_sane(e: float, e_free: float, b: float, stiff: float, damped: float, kappa: float) -> None:
    """Also for shafts that are a hundred times as stiff as a step allows."""
    values = (e, e_free, b, stiff / kappa, damped / kappa)
    arguments = (np.array([[kappa]]), *(np.array([value]) for value in values))
    T = backlash_step(*arguments)
    assert np.isfinite(T).all()
    end = e_free - kappa * float(T[0])
    assert abs(end) <= max(abs(e), abs(e_free), b) * (1 + 1e-9) + 1e-100  # a stiff shaft may throw it to the other side
    defect, size = energy_defect(arguments[0], arguments[1], T, *arguments[2:])
    assert np.all(defect <= 1e-9 * size + 1e-300)


def test_a_rattling_disc_comes_to_rest() -> None:
    """One inertia between two stops, at a coarse step: its energy falls from step to step, and to nothing."""
    h, inertia, b, c = 1e-3, 0.01, np.array([0.01]), np.array([5e4])
    d = np.array([0.5 / h])
    kappa = np.array([[h * h / (2.0 * inertia)]])
    e, omega, energies = np.array([0.0]), np.array([20.0]), []
    for _ in range(400):
        T = backlash_step(kappa, e, e + h * omega, b, c, d)
        e, omega = e + h * omega - kappa[0] * T, omega - h * T / inertia
        energies.append(float(0.5 * inertia * omega[0] ** 2 + 0.5 * c[0] * beyond(e, b)[0] ** 2))
    assert np.all(np.diff(energies) <= 1e-12 * energies[0])
    assert energies[-1] < 0.05 * energies[0]

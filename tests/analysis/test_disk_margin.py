"""Disk margins: closed forms, real perturbations, and how tight the bound is."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.optimize
from hypothesis import given, settings
from hypothesis import strategies as st
from sampled_loops import MatrixFamily, radius, static
from test_margins import families

from ptgen.analysis.disk_margin import DiskMargin, disk_margin, structured_singular_value
from ptgen.analysis.frequency import FrequencyResponse, frequency_grid


def margin_of(family) -> DiskMargin:
    loop, steps = family.loop()
    return disk_margin(FrequencyResponse(loop, steps), frequency_grid(loop))


def test_disk_margin_of_one_loop_is_the_largest_of_s_minus_one_half():
    inertia, k, h = 2.0, 500.0, 1e-3
    family = MatrixFamily(([[0.0]], [[1 / inertia]], [[1.0]]), static([[-k]]), h)
    omega = np.linspace(1e-2, np.pi / h, 200_001)
    L = -h * k / inertia / (np.exp(1j * omega * h) - 1)
    assert margin_of(family).alpha == pytest.approx(1 / abs(1 / (1 - L) - 0.5).max(), rel=1e-6)


def test_gains_and_phase_of_a_disk():
    found = DiskMargin(2 / 3, 1.0)
    assert (found.gain_up, found.gain_down) == (pytest.approx(2.0), pytest.approx(0.5))
    assert found.phase_deg == pytest.approx(36.87, abs=0.01)
    assert DiskMargin(2.0, 1.0).gain_up == np.inf


@given(families(), st.integers(0, 2**32 - 1))
def test_no_perturbation_inside_the_disk_makes_the_loop_unstable(family, seed):
    """Real factors within the gain range, each machine its own, and random complex ones by their frequency response."""
    found = margin_of(family)
    rng, loop = np.random.default_rng(seed), family.delayed()
    low, high = found.gain_down, min(found.gain_up, 1e3)
    for _ in range(10):
        low = max(low, 1e-3)
        factors = low * (high / low) ** rng.uniform(0.01, 0.99, len(family.machines))
        assert radius(loop.closed(factors)) < 1


@given(families(most=1))
def test_a_perturbation_of_the_size_of_the_disk_reaches_instability(family):
    """For one machine the worst factor is known: it puts a pole on the unit circle."""
    found = margin_of(family)
    loop, steps = family.loop()
    omega = 2 * np.pi * found.frequency_hz
    L = FrequencyResponse(loop, steps)(omega)[0, 0]
    delta = 1 / (1 / (1 - L) - 0.5)
    factor = (1 + delta / 2) / (1 - delta / 2)
    assert abs(delta) == pytest.approx(found.alpha, rel=1e-3)
    assert factor * L == pytest.approx(1.0, abs=1e-9)


def worst_perturbation(M, rng) -> float:
    """Return the largest spectral radius of ``U M`` over diagonal unitary ``U``: grid or random starts, refined."""
    m = len(M)
    if m <= 3:
        grid = 2 * np.pi * np.arange(40) / 40
        phases = np.stack(np.meshgrid(*[grid] * (m - 1)), -1).reshape(-1, m - 1)
    else:
        phases = 2 * np.pi * rng.random((500, m - 1))

    def radii(phases):
        turned = np.exp(1j * np.insert(phases, 0, 0.0, axis=-1))
        return abs(np.linalg.eigvals(M * turned[..., :, None])).max(-1)

    starts = phases[np.argsort(-radii(phases))[:5]]
    options = {"xatol": 1e-6, "fatol": 1e-10}
    return max(
        -scipy.optimize.minimize(lambda p: -radii(p), p, method="Nelder-Mead", options=options).fun for p in starts
    )


@settings(max_examples=20)
@given(st.integers(2, 8), st.integers(0, 2**32 - 1))
def test_structured_bound_lies_between_perturbations_and_the_norm(m, seed):
    """No perturbation is worse than the bound, and up to three machines one is as bad."""
    rng = np.random.default_rng(seed)
    M = rng.normal(size=(m, m)) + 1j * rng.normal(size=(m, m))
    bound = structured_singular_value(M)
    assert bound <= np.linalg.norm(M, 2) * (1 + 1e-9)
    worst = worst_perturbation(M, rng)
    assert worst <= bound * (1 + 1e-6)
    if m <= 3:
        assert worst >= bound * (1 - 1e-4)

"""Margins: closed forms, package `control`, and eigenvalues just inside and just outside of every margin."""

from __future__ import annotations

import control
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sampled_loops import MatrixFamily, radius, static

from ptgen.analysis.frequency import FrequencyResponse, frequency_grid, others_closed
from ptgen.analysis.margins import common_delay_margin, loop_margins, machine_delay_margin


def test_rotor_on_a_proportional_controller():
    """``z - 1 + h k / I``: unstable from ``k = 2 I / h`` on, swinging at half the sampling rate."""
    inertia, k, h = 2.0, 50.0, 1e-3
    family = MatrixFamily(([[0.0]], [[1 / inertia]], [[1.0]]), static([[-k]]), h)
    (found,) = loop_margins(family)
    assert found.gain_up == pytest.approx(2 * inertia / (h * k), rel=1e-9)
    assert found.gain_up_hz == pytest.approx(0.5 / h)
    assert found.gain_down == 0.0
    # |L| = 1 where 2 sin(omega h / 2) = h k / I; the phase is -90 deg - omega h / 2
    omega = 2 / h * np.arcsin(h * k / (2 * inertia))
    assert found.crossovers_hz == pytest.approx([omega / (2 * np.pi)])
    assert found.phase_deg == pytest.approx(90 - np.degrees(omega * h / 2))
    assert found.delay.time == pytest.approx(np.radians(found.phase_deg) / omega, rel=2e-3)


def test_rotor_on_a_proportional_controller_with_one_step_of_delay():
    """``z (z - 1) + g``: on the unit circle at g = 1, with z = exp(j pi / 3)."""
    inertia, h = 1.0, 1e-3
    family = MatrixFamily(([[0.0]], [[1 / inertia]], [[1.0]]), static([[-0.25 * inertia / h]]), h, dead_time=h)
    (found,) = loop_margins(family)
    assert found.gain_up == pytest.approx(4.0, rel=1e-9)
    assert found.gain_up_hz == pytest.approx(1 / (6 * h), rel=1e-9)


def test_integrator_against_a_weakly_damped_mode():
    """An integrator on ``omega^2 / (s^2 + 2 zeta omega s + omega^2)`` is stable up to ``2 zeta omega``."""
    omega, zeta, gain, h = 2 * np.pi * 17, 0.014, 0.7, 1e-5
    A = [[0.0, 1.0], [-(omega**2), -2 * zeta * omega]]
    integrator = (np.eye(1), np.array([[-h * gain]]), np.eye(1), np.zeros((1, 1)))
    family = MatrixFamily((A, [[0.0], [omega**2]], [[1.0, 0.0]]), integrator, h)
    (found,) = loop_margins(family)
    assert found.gain_up == pytest.approx(2 * zeta * omega / gain, rel=0.03)
    assert found.gain_up_hz == pytest.approx(17, rel=1e-3)


def test_double_integrator_is_stable_for_small_gains_only_above_zero():
    """PI on a rotor: no gain is too small; with a negative mode in the plant there is a smallest one."""
    h = 1e-3
    pi = (np.eye(1), np.array([[-h * 200.0]]), np.eye(1), np.array([[-40.0]]))
    (found,) = loop_margins(MatrixFamily(([[0.0]], [[1.0]], [[1.0]]), pi, h))
    assert found.gain_down == 0.0
    pendulum = MatrixFamily(([[3.0]], [[1.0]], [[1.0]]), static([[-12.0]]), h)
    (found,) = loop_margins(pendulum)
    assert found.gain_down == pytest.approx(3 / 12, rel=1e-5)
    assert found.gain_down_hz == 0.0


def test_margins_are_those_of_package_control(projects):
    """`control` interpolates on a grid; its other way, over polynomials, fails at 10 kHz."""
    from ptgen.loops.loop_analysis import loop_family

    project = projects["differential"]
    family = loop_family(project, project.model)
    loop, steps = family.loop()
    omega = frequency_grid(loop)
    L = FrequencyResponse(loop, steps)(omega)
    for k, found in enumerate(loop_margins(family)):
        sampled = control.FrequencyResponseData(-others_closed(L, k), omega, smooth=True)
        gain, phase, _, gain_at, phase_at, _ = control.stability_margins(sampled)
        assert found.gain_up == pytest.approx(gain, rel=1e-3)
        assert found.phase_deg == pytest.approx(phase, rel=1e-4)
        assert found.gain_up_hz == pytest.approx(gain_at / (2 * np.pi), rel=1e-3)
        assert found.phase_hz == pytest.approx(phase_at / (2 * np.pi), rel=1e-3)


@st.composite
def families(draw, most=3):
    """Rotors in a chain of springs under speed control with random cross terms, sampled and behind a dead time."""
    m, seed = draw(st.integers(1, most)), draw(st.integers(0, 2**32 - 1))
    rng = np.random.default_rng(seed)
    bodies = m + int(rng.integers(0, 3))
    inertia, stiffness = 10 ** rng.uniform(-1, 1, bodies), 10 ** rng.uniform(1, 4, bodies - 1)
    E = -np.eye(bodies)[:-1] + np.eye(bodies)[1:]
    D = np.diag(10 ** rng.uniform(-2, -1) * np.sqrt(stiffness))
    A = np.zeros((2 * bodies - 1,) * 2)
    A[:bodies, :bodies] = -E.T @ D @ E / inertia[:, None]
    A[:bodies, bodies:], A[bodies:, :bodies] = -(E.T * stiffness) / inertia[:, None], E
    at = rng.permutation(bodies)[:m]
    B, C = np.zeros((len(A), m)), np.zeros((m, len(A)))
    B[at, range(m)], C[range(m), at] = 1 / inertia[at], 1.0
    h = 1e-3
    K = -np.diag(inertia[at]) @ (np.eye(m) + 0.2 * rng.normal(size=(m, m))) * 10 ** rng.uniform(0, 2)
    dead_time = rng.uniform(0, 3) * h
    while True:  # until the gains are small enough
        controller = (np.eye(m), 2.0 * h * K, np.eye(m), K)
        family = MatrixFamily((A, B, C), controller, h, dead_time=dead_time)
        if radius(family.delayed().closed()) < 1 - 1e-5:
            return family
        K = 0.5 * K
        assume(abs(K).max() > 1e-3)


@settings(max_examples=30)
@given(families())
def test_gain_margins_separate_stable_from_unstable(family):
    loop = family.delayed()
    for k, found in enumerate(loop_margins(family)):

        def largest(factor, k=k):
            return radius(loop.closed([factor if i == k else 1.0 for i in range(len(family.machines))]))

        if np.isfinite(found.gain_up):
            assert largest(1 + 0.98 * (found.gain_up - 1)) < 1
            assert largest(1 + 1.02 * (found.gain_up - 1)) > 1
        else:
            assert largest(1e3) < 1 + 1e-9
        if found.gain_down > 0:
            assert largest(1 - 0.98 * (1 - found.gain_down)) < 1
            assert largest(1 - 1.02 * (1 - found.gain_down)) > 1
        else:
            assert largest(0.01) < 1 + 1e-9


@settings(max_examples=30)
@given(families())
def test_delay_margins_separate_stable_from_unstable(family):
    everyone = [(family.machines, common_delay_margin(family))]
    everyone += [((name,), machine_delay_margin(family, name)) for name in family.machines]
    for machines, found in everyone:
        if not np.isfinite(found.time):
            assert radius(family.delayed(None, dict.fromkeys(machines, 0.0437)).closed()) < 1
            continue
        if found.time > 0.2:  # too many steps for eigenvalues
            continue
        for share in (0.2, 0.5, 0.8, 0.999):
            assert radius(family.delayed(None, dict.fromkeys(machines, share * found.time)).closed()) < 1
        assert radius(family.delayed(None, dict.fromkeys(machines, 1.002 * found.time)).closed()) > 1


@pytest.mark.parametrize("gap", [0.3, 0.9])
def test_a_rigid_flange_makes_the_delay_margin_jump(gap):
    """``u(k+1) = 1.2 u(k) - 0.5 u(k-1)`` is stable, ``u(k+2) = 1.2 u(k) - 0.5 u(k-1)`` is not.

    The sensor reads the command of the last step as long as the delay is below one; nothing swings until then.
    """
    h = 1e-3
    memory = (np.zeros((1, 1)), np.eye(1), np.array([[-0.5]]), np.array([[1.2]]))
    family = MatrixFamily(([[-3e5]], [[3e5]], [[1.0]]), memory, h, dead_time=gap * h)
    found = machine_delay_margin(family, "M1")
    assert found.time == pytest.approx((1 - gap) * h, rel=0.02)
    assert radius(family.delayed(None, {"M1": 0.9 * found.time}).closed()) < 1
    assert radius(family.delayed(None, {"M1": 1.02 * found.time}).closed()) > 1

"""Byrnes-Isidori form (5.37)-(5.41): outputs, their derivatives and what stays behind."""

from __future__ import annotations

import numpy as np
import sympy as sp
from control_laws import is_zero

from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project


def test_open_halves_swing_behind_the_speeds(projects: dict[str, Project]) -> None:
    """With the clutches open each half swings against its machine, whose speed is held: ``I s^2 + c`` twice."""
    decoupling = projects["clutch_rig"].design.decoupling
    form = decoupling.normal_form
    assert form is not None
    assert (decoupling.relative_degrees, decoupling.internal_order) == ((1, 1), 4)
    p = {symbol.name: symbol for symbol in decoupling.values}
    polynomial = form.internal_polynomial
    assert polynomial is not None
    s, printed = polynomial.gen, sp.Integer(1)
    for inertia, stiffness in (
        ("clutch1_inertia_input", "flange1_shaft1_stiffness"),
        ("clutch2_inertia_output", "shaft2_flange2_stiffness"),
    ):
        printed *= s**2 + p[stiffness] / p[inertia]
    assert is_zero(polynomial.as_expr() - printed)
    assert all(decoupling.internal_eigenvalues.real < 0)  # the damping of the shafts decides
    natural = np.sort(np.sqrt(np.roots([float(c.subs(decoupling.values)) for c in polynomial.all_coeffs()][::2]) + 0j))
    np.testing.assert_allclose(np.sort(abs(decoupling.internal_eigenvalues))[::2], np.sort(abs(natural)), rtol=1e-3)


def test_transformation_is_regular_and_keeps_the_poles(projects: dict[str, Project]) -> None:
    for project in projects.values():
        decoupling = project.design.decoupling
        form = decoupling.normal_form
        if form is None:
            continue
        values = {**decoupling.values, **dict.fromkeys(decoupling.damping, 3.0)}
        T = evaluate_matrix(form.transform, values)
        A = evaluate_matrix(decoupling.system.A + decoupling.system.B * decoupling.state_law.x, values)
        closed = evaluate_matrix(form.closed, values)
        np.testing.assert_allclose(T @ A, closed @ T, rtol=1e-8, atol=1e-6 * abs(T @ A).max())
        assert np.linalg.matrix_rank(T / np.linalg.norm(T, axis=1, keepdims=True)) == len(T)


def test_external_part_is_a_chain_of_integrators_per_output(projects: dict[str, Project]) -> None:
    """(5.40): every derivative is the next state, and only the output's own states return in the last one."""
    for project in projects.values():
        decoupling = project.design.decoupling
        form = decoupling.normal_form
        if form is None:
            continue
        start = 0
        for chain in decoupling.chains:
            degree = chain.relative_degree or 0
            for step in range(degree - 1):
                assert is_zero(form.closed[start + step, :] - sp.eye(len(form.names))[start + step + 1, :])
            last = form.closed[start + degree - 1, :].copy()
            last[0, start : start + degree] = sp.zeros(1, degree)
            assert is_zero(last), chain.name
            start += degree

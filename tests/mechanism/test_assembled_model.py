"""The assembled model of random beds against a second, numerical construction of the same mechanics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanism.bed_text import Bed
from mechanism.random_beds import chains, trees
from mechanism.reference_mechanics import Array, Reference

from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.mechanism.modes import modes

BEDS = st.one_of(chains(), trees())
SEEDS = st.integers(0, 2**32 - 1)


def state(model: Model, seed: int) -> tuple[Array, Array, Array, Array]:
    """Return random velocities, twists, air-gap torques and friction torques."""
    random = np.random.default_rng(seed)
    z, e = random.uniform(-50, 50, len(model.coordinates)), random.uniform(-0.02, 0.02, len(model.twists))
    u, T = random.uniform(-500, 500, len(model.inputs)), random.uniform(-50, 50, len(model.frictions))
    return z, e, u, T


def accelerations(model: Model, z: Array, e: Array, u: Array, T: Array) -> Array:
    A, B, F = model.numeric().state_matrices()
    return (A @ np.concatenate([z, e]) + B @ u + F @ T)[: len(z)]


def rows(model: Model, names: list[str]) -> Array:
    return np.vstack([evaluate_matrix(model.velocity_rows[name], model.values) for name in names])


def value(form: LinearForm, model: Model, z: Array, e: Array, u: Array, T: Array, a: Array) -> float:
    parts = [evaluate_matrix(part, model.values)[0] for part in (form.z, form.e, form.u, form.f, form.a)]
    return float(sum(part @ values for part, values in zip(parts, (z, e, u, T, a), strict=True)))


@settings(max_examples=12)
@given(BEDS)
def test_mass_is_symmetric_and_positive_definite(bed: Bed) -> None:
    model = assemble(Mechanism.of(bed.load()))
    assert model.mass.is_symmetric()
    mass = model.numeric().mass
    scale = np.sqrt(np.diag(mass))
    assert np.linalg.eigvalsh(mass / np.outer(scale, scale)).min() > 1e-9


@settings(max_examples=12)
@given(BEDS)
def test_eigenfrequencies_are_those_of_the_reference(bed: Bed) -> None:
    testbed = bed.load()
    expected = Reference(testbed).squared_frequencies()
    found = modes(assemble(Mechanism.of(testbed)))
    squared = np.array([(2 * np.pi * mode.frequency_hz) ** 2 for mode in found])
    assert len(squared) == len(expected)
    np.testing.assert_allclose(squared, expected, rtol=1e-9, atol=2e-9 * expected.max() + 1e-12)
    rigid = np.count_nonzero(expected < 1e-10 * expected.max()) if expected.max() > 1 else len(expected)
    assert [mode.frequency_hz for mode in found].count(0.0) == rigid


@settings(max_examples=8)
@given(trees())
def test_locked_friction_removes_its_motion(bed: Bed) -> None:
    testbed = bed.load()
    reference = Reference(testbed)
    model = assemble(Mechanism.of(testbed))
    expected = reference.squared_frequencies(("diff.limited_slip",))
    squared = [(2 * np.pi * mode.frequency_hz) ** 2 for mode in modes(model, ["diff.limited_slip"])]
    np.testing.assert_allclose(squared, expected, rtol=1e-9, atol=2e-9 * expected.max())
    rigid = assemble(Mechanism.of(testbed).with_locked_frictions({"diff.limited_slip"}))
    squared = [(2 * np.pi * mode.frequency_hz) ** 2 for mode in modes(rigid)]
    np.testing.assert_allclose(squared, expected, rtol=1e-9, atol=2e-9 * expected.max())


@settings(max_examples=12)
@given(BEDS, SEEDS)
def test_energy_changes_by_inputs_minus_friction_minus_damping(bed: Bed, seed: int) -> None:
    """Energies from the reference's bodies and springs, motion from the model."""
    testbed = bed.load()
    model = assemble(Mechanism.of(testbed))
    z, e, u, T = state(model, seed)
    a = accelerations(model, z, e, u, T)
    twist_rate = model.numeric().twist_rows @ z
    bodies = np.array([float(sp.sympify(x).subs(model.values)) for x in model.body_inertias.values()])
    speeds = np.vstack([evaluate_matrix(row, model.values) for row in model.body_rows.values()])
    springs = np.vstack(
        [evaluate_matrix(row, model.values) for row in model.spring_rows.values()] or [np.zeros((0, 0))]
    )
    part = testbed.components
    c = np.array([part[name].stiffness for name in model.spring_rows])
    d = np.array([part[name].damping for name in model.spring_rows])
    kinetic = bodies @ ((speeds @ z) * (speeds @ a))
    strain = c @ ((springs @ e) * (springs @ twist_rate)) if len(c) else 0.0
    damping = d @ (springs @ twist_rate) ** 2 if len(d) else 0.0
    slip = model.numeric().friction_rows @ z
    power = u @ (model.numeric().input_rows @ z) - slip @ (T + np.diag(model.numeric().viscous) * slip) - damping
    scale = abs(kinetic) + abs(strain) + abs(power) + abs(damping)
    assert abs(kinetic + strain - power) < 1e-9 * scale + 1e-9


@settings(max_examples=8)
@given(trees())
def test_friction_matrix_is_symmetric_and_positive_semidefinite(bed: Bed) -> None:
    numeric = assemble(Mechanism.of(bed.load())).numeric()
    K = numeric.friction_rows @ np.linalg.solve(numeric.mass, numeric.friction_rows.T)
    np.testing.assert_allclose(K, K.T, rtol=1e-9, atol=1e-12 * abs(K).max())
    assert np.linalg.eigvalsh(K).min() > -1e-12 * abs(K).max()


@settings(max_examples=8)
@given(trees())
def test_friction_velocities_come_first(bed: Bed) -> None:
    """The friction-state transform: the first coordinates are the slip velocities themselves."""
    model = assemble(Mechanism.of(bed.load()))
    count = len(model.frictions)
    expected = np.eye(count, len(model.coordinates))
    np.testing.assert_array_equal(model.numeric().friction_rows, expected)


@settings(max_examples=12)
@given(BEDS, SEEDS)
def test_accelerations_and_reactions_are_those_of_the_constrained_system(bed: Bed, seed: int) -> None:
    """Every velocity's rate, and the torque across every connection, against the KKT system of the whole bed."""
    for index, chain in enumerate(bed.chains):  # an inertia at every connection: nothing is condensed
        words = chain.split(" - ")
        joined = [words[0]]
        for position, word in enumerate(words[1:]):
            joined += [bed.add(f"disc{index}_{position}", "inertia", inertia=0.1 + 0.05 * position), word]
        bed.chains[index] = " - ".join(joined)
    bed.torque = {"M1": "disc0_0.left"}
    testbed = bed.load()
    reference = Reference(testbed)
    mechanism = Mechanism.of(testbed)
    model = assemble(replace(mechanism, observed=tuple(link.left for link in testbed.connections)))
    z, e, u, T = state(model, seed)
    shared = [name for name in reference.names if name in model.velocity_rows]
    a = accelerations(model, z, e, u, T)
    N = reference.N[[reference.names.index(name) for name in shared]]
    v = reference.N @ np.linalg.lstsq(N, rows(model, shared) @ z, rcond=None)[0]
    twists = np.array(
        [float(evaluate_matrix(model.spring_rows[name], model.values)[0] @ e) for name in reference.springs]
    )
    order = [reference.frictions.index(friction.name) for friction in model.frictions]
    torques = np.zeros(len(order))
    torques[order] = T
    force = reference.applied(v, twists, u, torques)
    rates, multipliers = reference.constrained(force)
    np.testing.assert_allclose(
        rows(model, shared) @ a, rates[[reference.names.index(name) for name in shared]], rtol=1e-7
    )
    scale = abs(force).max() + 1.0
    across = multipliers[-len(testbed.connections) :]
    found = [value(model.signals[link.left], model, z, e, u, T, a) for link in testbed.connections]
    np.testing.assert_allclose(found, across, atol=1e-7 * scale)

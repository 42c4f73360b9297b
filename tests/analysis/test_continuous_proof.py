"""Factors, conditions and verdicts of every bed against eigenvalues in numbers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
import sympy as sp
from analysis.proof_beds import all_symbols, five_machines
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mechanism.bed_text import differential_bed

from ptgen.analysis.characteristic import Factor, characteristic_factors
from ptgen.analysis.continuous_proof import Setting, Verdict, continuous_proof, equivalent_observer, prove
from ptgen.analysis.symbolic_loop import (
    ACCELERATION_TORQUE,
    LOAD_COMPENSATION,
    LoopKind,
    SymbolicLoop,
    numeric_matrix,
    symbolic_loop,
)
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project

POSITIONS = [(1, 1), (1, 0), (0, 1), (0, 0)]


def random_values(project: Project, loop: SymbolicLoop, seed: int) -> dict[sp.Symbol, float]:
    """Return random positive parameters and gains of usable sizes, and switches between 0 and 1."""
    random = np.random.default_rng(seed)
    values = {symbol: float(random.uniform(0.5, 3.0)) for symbol in all_symbols(project.design.decoupling, loop)}
    return values | {LOAD_COMPENSATION: random.uniform(), ACCELERATION_TORQUE: random.uniform()}


def product(factors: tuple[Factor, ...], values: Mapping[sp.Symbol, float]) -> np.ndarray:
    result = np.ones(1)
    for factor in factors:
        result = np.polymul(result, factor.numbers(values))
    return result


@pytest.fixture(scope="module", params=[LoopKind.SPEED_PI, LoopKind.SPEED_OBSERVER], ids=lambda kind: kind.value)
def kind(request: pytest.FixtureRequest) -> LoopKind:
    return request.param


@pytest.mark.parametrize("position", [None, *POSITIONS])
def test_factors_multiply_to_the_characteristic_polynomial(
    project: Project, kind: LoopKind, position: tuple[int, int] | None
) -> None:
    loop = symbolic_loop(project.design.decoupling, None, kind)
    switches = {} if position is None else dict(zip((LOAD_COMPENSATION, ACCELERATION_TORQUE), position, strict=True))
    factors = characteristic_factors(loop.at(switches))
    for seed in range(10):
        values = random_values(project, loop, seed) | switches
        expected = np.poly(evaluate_matrix(loop.A, values))
        np.testing.assert_allclose(product(factors, values), expected, rtol=1e-8, atol=1e-8 * np.max(abs(expected)))


def test_decoupled_loops_stand_alone(project: Project) -> None:
    """Each torque loop has degree three, each speed loop two, and neither knows a gain of another."""
    if project.testbed.tuning.structure == "individual":
        pytest.skip("its loops know each other")
    proof = continuous_proof(project.design, project.reduced)
    for proven in proof.setting("decoupling").factors:
        assert len(proven.factor.loops) == 1
        (name,) = proven.factor.loops
        if name == "internal dynamics":
            continue
        (loop,) = [loop for loop in proof.loop.loops if loop.name == name]
        assert proven.factor.degree == (3 if loop.kind is LoopKind.TORQUE else 2)
        found = set().union(*(value.free_symbols for value in proven.factor.coefficients))
        assert found & set(proof.loop.gains) == set(loop.gains)


def test_shipped_beds_are_stable_with_gains_inside_their_ranges(project: Project) -> None:
    proof = continuous_proof(project.design, project.reduced)
    decoupling = proof.setting(project.testbed.tuning.structure)
    assert decoupling.verdict is Verdict.STABLE
    assert all(gain.is_admissible for proven in decoupling.factors for gain in proven.gains)
    for setting in proof.settings:
        for proven in setting.factors:
            assert (proven.verdict is Verdict.STABLE) == bool(np.all(proven.poles.real < 0))


def test_loop_is_the_one_that_the_law_makes_from_sensors(torque_project: Project) -> None:
    """The same poles from plant, sensors and law in numbers, with integrators put around them."""
    design, gains = torque_project.design.decoupling, torque_project.design.gains
    values = design.values | torque_project.design.tuned_inertia
    values |= {symbol: gains.damping[symbol.name.removesuffix("_damping")] for symbol in design.damping}
    A, B, _ = design.model.numeric(values).state_matrices()
    n_z = len(design.model.coordinates)

    def over_states_and_inputs(name: str) -> tuple[np.ndarray, np.ndarray]:
        form = design.model.signals[name]
        z, e, u, a = (evaluate_matrix(part, values) for part in (form.z, form.e, form.u, form.a))
        return np.hstack([z, e]) + a @ A[:n_z], u + a @ B[:n_z]

    C, D = (np.vstack(part) for part in zip(*map(over_states_and_inputs, design.sensors), strict=True))
    outputs = np.vstack([over_states_and_inputs(name)[0] for name in design.outputs])
    P, R = evaluate_matrix(design.law.P, values), evaluate_matrix(design.law.R, values)
    through_sensors = np.linalg.inv(np.eye(len(P)) - R @ D)
    A, B = A + B @ through_sensors @ R @ C, B @ through_sensors @ P
    owners = [design.machines[machine] for machine in design.actuators]
    proportional = np.diag([gains.speed.get(name, 0.0) for name in owners])
    integral = np.diag([gains.speed_integral.get(name, gains.torque_integral.get(name, 0.0)) for name in owners])
    closed = np.block([[A - B @ proportional @ outputs, B], [-integral @ outputs, np.zeros_like(integral)]])
    setting = continuous_proof(torque_project.design, torque_project.reduced).setting("decoupling")
    expected = np.poly(closed)
    powers = np.max(abs(np.linalg.eigvals(closed))) ** np.arange(len(expected))
    found = product(tuple(proven.factor for proven in setting.factors), setting.values)
    np.testing.assert_allclose(found / powers, expected / powers, atol=1e-9)


@settings(max_examples=25)
@given(seed=st.integers(0, 2**32 - 1), position=st.sampled_from(POSITIONS))
def test_conditions_are_met_exactly_if_the_eigenvalues_are_on_the_left(
    projects: dict[str, Project], seed: int, position: tuple[int, int]
) -> None:
    project = projects["back_to_back"]
    loop = symbolic_loop(project.design.decoupling)
    random = np.random.default_rng(seed)
    values = random_values(project, loop, seed)
    for gain in loop.gains:
        values[gain] = float(random.uniform(-0.5, 3.0) if gain.name.endswith("gain") else random.uniform(0.0, 3.0))
    fixed = dict(zip((LOAD_COMPENSATION, ACCELERATION_TORQUE), map(float, position), strict=True))
    values |= fixed
    real = np.linalg.eigvals(evaluate_matrix(loop.A, values)).real
    assume(np.min(abs(real)) > 1e-6)
    setting = prove(loop, "random", fixed, values)
    assert (setting.verdict is Verdict.STABLE) == bool(np.max(real) < 0)
    assert _conditions_hold(setting) == bool(np.max(real) < 0)


def _conditions_hold(setting: Setting) -> bool:
    held = True
    for proven in setting.factors:
        assert proven.conditions is not None
        for condition in proven.conditions:
            expression = condition.expression.subs(proven.abbreviations)
            held &= float(sp.sympify(expression).subs(setting.values)) > 0
    return held


@settings(max_examples=25)
@given(seed=st.integers(0, 2**32 - 1), position=st.sampled_from(POSITIONS))
def test_interval_of_a_gain_is_where_the_eigenvalues_are_on_the_left(
    projects: dict[str, Project], seed: int, position: tuple[int, int]
) -> None:
    project = projects["back_to_back"]
    loop = symbolic_loop(project.design.decoupling)
    fixed = dict(zip((LOAD_COMPENSATION, ACCELERATION_TORQUE), map(float, position), strict=True))
    values = random_values(project, loop, seed) | fixed
    random = np.random.default_rng(seed)
    for proven in prove(loop, "random", fixed, values).factors:
        for gain in proven.gains:
            tried = float(random.uniform(-2.0, 6.0))
            zeros = proven.factor.poles(values | {gain.gain: tried})
            if np.min(abs(zeros.real)) > 1e-6:
                inside = any(low < tried < high for low, high in gain.intervals)
                assert inside == bool(np.max(zeros.real) < 0), (gain, tried)


def test_five_machines_factor_into_their_loops() -> None:
    project = five_machines()
    proof = continuous_proof(project.design, project.reduced)
    assert proof.loop.A.shape == (11, 11)
    assert [p.factor.name for p in proof.setting("decoupling").factors] == [loop.name for loop in proof.loop.loops]
    (coupled,) = proof.setting("damping alone").factors
    assert (coupled.factor.degree, coupled.conditions) == (11, None)
    values = dict(proof.setting("damping alone").values)
    eigenvalues = np.linalg.eigvals(numeric_matrix(proof.loop, values))
    np.testing.assert_allclose(np.sort(coupled.poles.real), np.sort(eigenvalues.real), rtol=1e-5, atol=1e-5)


def test_undamped_and_unstable_loops_are_told_apart(projects: dict[str, Project]) -> None:
    project = projects["back_to_back"]
    loop = symbolic_loop(project.design.decoupling)
    proof = continuous_proof(project.design, project.reduced)
    values, fixed = proof.setting("decoupling").values, proof.setting("decoupling").fixed
    damping, _, integral = loop.loops[0].gains
    undamped = prove(loop, "undamped", fixed, {**values, damping: 0.0, integral: 0.0})
    assert [proven.verdict for proven in undamped.factors] == [Verdict.NEUTRAL, Verdict.STABLE]
    assert undamped.verdict is Verdict.NEUTRAL
    unstable = prove(loop, "unstable", fixed, {**values, damping: 0.0})
    assert unstable.verdict is Verdict.UNSTABLE
    assert not unstable.factors[0].gains[0].is_admissible


def test_internal_dynamics_are_damped_by_the_shafts(projects: dict[str, Project]) -> None:
    project = projects["clutch_rig"]
    with_damping = continuous_proof(project.design, project.reduced).setting("decoupling")
    inside = [proven for proven in with_damping.factors if proven.factor.name == "internal dynamics"]
    assert sum(proven.factor.degree for proven in inside) == project.design.decoupling.internal_order
    poles = np.concatenate([proven.poles for proven in inside])
    expected = project.design.decoupling.internal_eigenvalues
    np.testing.assert_allclose(np.sort_complex(poles), np.sort_complex(expected), rtol=1e-3)
    bare = symbolic_loop(project.design.decoupling)
    assert prove(bare, "bare", with_damping.fixed, with_damping.values).verdict is Verdict.NEUTRAL


@given(st.floats(0.1, 100), st.floats(0.1, 1e3), st.floats(0.01, 0.99))
def test_observer_rejects_disturbances_exactly_as_a_pi_controller_with_real_poles(
    inertia: float, gain: float, share: float
) -> None:
    """I s w = v - T with v = k_p (r - w) + T_hat, d T_hat/dt = b (v - I dw/dt - T_hat), (5.85)-(5.93)."""
    integral = share * gain**2 / (4 * inertia)
    proportional, rate = equivalent_observer(gain, integral, inertia)
    # w = (share of r) + (share of T), both loops solved by hand for w at one complex frequency.
    s = 1.7 * gain / inertia + 0.9j
    pi_to_load = -s / (inertia * s**2 + gain * s + integral)
    pi_to_reference = (gain * s + integral) / (inertia * s**2 + gain * s + integral)
    unknowns = np.array([[inertia * s, -1, 0], [proportional, 1, -1], [rate * inertia * s, -rate, s + rate]])
    to_load = np.linalg.solve(unknowns, [-1, 0, 0])[0]
    to_reference = np.linalg.solve(unknowns, [0, proportional, 0])[0]
    assert to_load == pytest.approx(pi_to_load, rel=1e-9)
    assert to_reference == pytest.approx(proportional / (inertia * s + proportional), rel=1e-9)
    assert to_reference == pytest.approx(pi_to_reference * proportional * (s + rate) / (gain * s + integral), rel=1e-9)


def test_observer_has_no_complex_poles() -> None:
    with pytest.raises(ValueError, match="no observer has complex"):
        equivalent_observer(10.0, 100.0, 5.0)


def test_individual_torque_loops_on_one_twist_leave_an_integrator() -> None:
    """Both outputs of an open differential carry the same torque; nothing controls what their integrators differ by."""
    bed = differential_bed()
    bed.torque, bed.speed = {"M2": "flange2", "M3": "flange3"}, ["M1"]
    bed.control = {"structure": "individual"}
    project = Project(bed.load())
    first = continuous_proof(project.design, project.reduced).settings[0]
    assert (first.name, first.verdict) == ("individual", Verdict.NEUTRAL)
    shared = [p for p in first.factors if p.factor.loops == ("torque loop of M2", "torque loop of M3")]
    assert {p.factor.degree: p.verdict for p in shared} == {1: Verdict.NEUTRAL, 3: Verdict.STABLE}
    assert next(p for p in shared if p.factor.degree == 1).factor.coefficients == (1, 0)


def test_super_twisting_is_a_pi_controller_for_small_errors() -> None:
    bed = differential_bed()
    bed.torque, bed.speed = {"M1": "diff.input"}, ["M2", "M3"]
    bed.control = {"speed_control": {"M2": "super_twisting", "M3": "observer"}}
    project = Project(bed.load())
    proof = continuous_proof(project.design, project.reduced)
    kinds = {loop.machine: loop.kind for loop in proof.loop.loops}
    assert kinds == {"M1": LoopKind.TORQUE, "M2": LoopKind.SPEED_TWISTING, "M3": LoopKind.SPEED_OBSERVER}
    gains, values = project.design.gains.super_twisting["M2"], proof.settings[0].values
    by_name = {symbol.name: value for symbol, value in values.items()}
    error = 1e-6 * gains.layer
    law = gains.k1 * error / np.sqrt(error + gains.layer)
    assert by_name["M2_small_error_gain"] * error == pytest.approx(law, rel=1e-5)
    assert by_name["M2_small_error_integral_gain"] == pytest.approx(gains.k2 / gains.layer)
    assert by_name["M3_observer_bandwidth"] == project.design.gains.observer_bandwidth["M3"]
    assert proof.settings[0].verdict is Verdict.STABLE

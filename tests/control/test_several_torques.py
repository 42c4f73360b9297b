"""Several controlled torques: natural stiffness of each kept, cross terms cancelled from measured torques."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from control_laws import ClosedLoop, design, is_zero, symbols, wanted
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanism.bed_text import Bed, differential_bed

from ptgen.control.decoupling import Decoupling, decouple
from ptgen.elements import SensorKind
from ptgen.errors import ControlError
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project


def locked(shafts: tuple[float, float, float] = (5e4, 8e4, 3e4)) -> Decoupling:
    """Return the design of a locked differential, M1 on speed, M2 and M3 on torque (Section 6.3)."""
    bed = differential_bed("differential", shafts)
    bed.torque, bed.speed = {"M2": "flange2", "M3": "flange3"}, ["M1"]
    bed.reduction = {"drop": ["diff", "flange1", "flange2", "flange3"], "locked": ["diff.limited_slip"]}
    return design(bed)


def test_stiffness_is_what_a_machine_sees_while_the_others_stand() -> None:
    decoupling = locked()
    numeric = decoupling.model.numeric(decoupling.values)
    K = numeric.twist_rows.T @ numeric.stiffness @ numeric.twist_rows
    seen = evaluate_matrix(sp.Matrix([decoupling.stiffness]), decoupling.values)[0]
    np.testing.assert_allclose(seen, [K[1, 1], K[2, 2]], rtol=1e-12)
    assert K[1, 2] != 0  # the torques are coupled


def test_law_of_each_torque_uses_the_controlled_torques_themselves() -> None:
    decoupling = locked()
    kinds = {sensor.name: sensor.kind for sensor in decoupling.model.sensors}
    for machine in (1, 2):
        row = decoupling.law.R[machine, :]
        used = {name for name, share in zip(decoupling.sensors, row, strict=True) if share != 0}
        assert {name for name in used if kinds[name] is SensorKind.TORQUE} == {"flange2_torque", "flange3_torque"}


def test_twist_does_not_vanish_with_two_torques_but_with_one() -> None:
    """``u_2`` keeps a share of its own torque: the stiffness kept is that with M3 standing, not with T3 held."""
    decoupling = locked()
    p = symbols(decoupling)
    k2, k3, k23 = (p[f"{name}_equivalent_stiffness"] for name in ("M2", "M3", "M2_M3"))
    own = decoupling.law.R[1, decoupling.sensors.index("flange2_torque")]
    assert is_zero(own - k23**2 / (k2 * k3 - k23**2))
    assert is_zero(own.subs(k23, 0))


@settings(max_examples=4)
@given(shafts=st.tuples(*[st.floats(1e3, 1e6)] * 3), seed=st.integers(0, 2**32 - 1))
def test_closed_loop_is_diagonal_for_any_shafts(shafts: tuple[float, float, float], seed: int) -> None:
    decoupling = locked(shafts)
    random = np.random.default_rng(seed)
    damping = {symbol.name: float(random.uniform(1, 500)) for symbol in decoupling.damping}
    loop = ClosedLoop(decoupling, damping)
    for s in random.uniform(1, 200, 3) + 1j * random.uniform(1, 300, 3):
        to_v, _ = loop.transfer(s)
        expected = wanted(decoupling, damping, s)
        assert np.max(abs(to_v - expected) / abs(np.diag(expected))[:, None]) < 1e-6


@pytest.mark.parametrize("machine", ["M1", "M3"])
def test_any_two_machines_may_control_the_torques(machine: str) -> None:
    bed = differential_bed("differential")
    others = [name for name in ("M1", "M2", "M3") if name != machine]
    bed.torque, bed.speed = {name: f"flange{name[1]}" for name in others}, [machine]
    bed.reduction = {"drop": ["diff", "flange1", "flange2", "flange3"], "locked": ["diff.limited_slip"]}
    decoupling = design(bed)
    assert (decoupling.relative_degrees, decoupling.internal_order) == ((2, 2, 1), 0)


@settings(max_examples=3)
@given(seed=st.integers(0, 2**32 - 1))
def test_shipped_beds_are_decoupled_for_any_parameters(projects: dict[str, Project], seed: int) -> None:
    """Ratios, inertias and stiffnesses of every shipped bed multiplied by random factors: diagonal to rounding."""
    random = np.random.default_rng(seed)
    for project in projects.values():
        decoupling = project.design.decoupling
        if decoupling.structure != "decoupling" or not decoupling.torque_count:
            continue
        values = {
            parameter.symbol: parameter.value * random.uniform(0.5, 2) for parameter in decoupling.model.parameters
        }
        for symbol, made in decoupling.definitions.items():
            values[symbol] = float(evaluate_matrix(sp.Matrix([[made]]), {**decoupling.values, **values})[0, 0])
        own = {**decoupling.values, **values}
        damping = {symbol.name: 50 * random.uniform(0.5, 2) for symbol in decoupling.damping}
        loop = ClosedLoop(decoupling, damping, own)
        expected = wanted(decoupling, damping, 20 + 30j, own)
        to_v, _ = loop.transfer(20 + 30j)
        assert np.max(abs(to_v - expected) / abs(np.diag(expected))[:, None]) < 1e-6, project.testbed.name


def test_balance_of_every_rotor_is_exact(projects: dict[str, Project]) -> None:
    """``I_m d omega/dt = share u + sensors . y`` for random states, torques and slip torques."""
    random = np.random.default_rng(3)
    for project in projects.values():
        decoupling, model = project.design.decoupling, project.reduced.model
        A, B, F = model.numeric().state_matrices()
        x, u, T = random.normal(size=len(A)), random.normal(size=B.shape[1]), random.normal(size=F.shape[1])
        forms = [model.without_acceleration(model.signals[name]) for name in decoupling.sensors]
        y = [
            float(
                np.hstack([evaluate_matrix(form.z, model.values)[0], evaluate_matrix(form.e, model.values)[0]]) @ x
                + evaluate_matrix(form.u, model.values)[0] @ u
                + evaluate_matrix(form.f, model.values)[0] @ T
            )
            for form in forms
        ]
        rates = A @ x + B @ u + F @ T
        found = 0
        for machine, balance in enumerate(decoupling.law.balance):
            if balance is None:
                continue
            found += 1
            rotor = model.values[model.body_inertias[next(iter(model.inputs[machine].row))]]
            share = evaluate_matrix(sp.Matrix([[balance.share]]), decoupling.values)[0, 0]
            given_ = share * u[machine] + float(evaluate_matrix(balance.sensors, decoupling.values)[0] @ y)
            assert given_ == pytest.approx(rotor * rates[machine], rel=1e-9, abs=1e-9)
        assert found == len(project.testbed.machines), project.testbed.name


def test_known_losses_enter_the_estimate_as_in_5_96(projects: dict[str, Project]) -> None:
    project = projects["differential_gearboxes"]
    reduced, roles = project.reduced, project.testbed.roles
    plain = project.design.decoupling
    known = decouple(reduced, roles, losses=("gearbox2.input", "gearbox3.input"))
    assert [loss.component for loss in known.law.known_losses] == ["gearbox2", "gearbox3"]
    p = symbols(known)
    assert is_zero(known.law.estimate_losses - sp.Matrix([[p["gearbox2_ratio"], p["gearbox3_ratio"]]]))
    assert is_zero(known.law.R_losses[1:, :])  # the flanges beside M2 and M3 read the losses
    assert is_zero(plain.law.R - known.law.R)
    for loss, speed in zip(("M2_speed", "M3_speed"), known.law.known_losses, strict=True):
        assert speed.speed[known.sensors.index(loss)] == 1
        assert sum(abs(entry) for entry in speed.speed) == 1


def test_known_loss_that_no_sensor_shows_is_fed_forward(projects: dict[str, Project]) -> None:
    """Gearbox 1 lies behind flange 1: M1 gives the loss torque itself, ``v + T_l``."""
    project = projects["differential_gearboxes"]
    known = decouple(project.reduced, project.testbed.roles, losses=("gearbox1.input",))
    assert is_zero(known.law.R_losses - sp.Matrix([1, 0, 0]))
    assert "gearbox1_loss" in str(known.law_expressions()["M1"])


def coupled_rotors(flanges: bool) -> Bed:
    """Return a differential with a heavy cage that M2 and M3 turn rigidly."""
    bed = Bed()
    for index, inertia in enumerate((1.0, 10.3, 8.0), start=1):
        bed.machine(f"M{index}", inertia)
    bed.add("flange1", "torque_flange", inertia=1e-4, stiffness=4e6)
    bed.add("cardan1", "shaft", stiffness=5e4)
    radii = {"radius_output1": 0.08, "radius_output2": 0.06, "radius_pinion": 0.05}
    inertias = {"inertia_drive": 2.0, "inertia_cage": 5.0, "inertia_output1": 0.012, "inertia_output2": 0.009}
    slip = {"limited_slip": {"coulomb": 20.0}}
    bed.add("diff", "bevel_differential", ratio=2.5, inertia_pinion=0.003, **radii, **inertias, **slip)
    bed.chains = ["M1 - flange1 - cardan1 - diff.input", "diff.output1 - M2", "diff.output2 - M3"]
    if flanges:
        for k in (2, 3):
            bed.add(f"flange{k}", "torque_flange", inertia=1e-4, stiffness=4e6)
        bed.chains[1:] = [f"diff.output{k} - flange{k + 1} - M{k + 1}" for k in (1, 2)]
        bed.reduction["rigid"] = ["flange2", "flange3"]
    bed.torque, bed.speed = {"M1": "flange1"}, ["M2", "M3"]
    bed.reduction["keep"] = ["diff"]
    return bed


def test_rigidly_coupled_rotors_are_decoupled_by_their_flanges() -> None:
    """The inertia matrix has a cross term; with a flange beside each rotor the law has none, and takes seconds."""
    decoupling = design(coupled_rotors(flanges=True))
    assert decoupling.model.mass[1, 2] != 0
    assert is_zero(decoupling.law.P[1:, 1:] - sp.eye(2))
    damping = {"M1_damping": 40.0}
    to_v, _ = ClosedLoop(decoupling, damping).transfer(5 + 20j)
    expected = wanted(decoupling, damping, 5 + 20j)
    assert np.max(abs(to_v - expected) / abs(np.diag(expected))[:, None]) < 1e-7


def test_rigidly_coupled_rotors_without_flanges_are_refused() -> None:
    with pytest.raises(ControlError) as caught:
        design(coupled_rotors(flanges=False))
    assert "torque flange next to" in caught.value.problems[0].remedy

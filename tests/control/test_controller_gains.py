"""Gains: the poles that they give, the damping (5.81), and the inertia of a steady acceleration."""

from __future__ import annotations

import numpy as np
import pytest
from control_laws import ClosedLoop
from mechanism.bed_text import differential_bed

from ptgen.control.tuning import gains
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.testbed import Tuning


def inertia(project: Project, *names: str) -> float:
    return sum(project.testbed.components[name].inertia for name in names)


def test_speed_loop_has_a_double_pole_at_half_the_bandwidth(project: Project) -> None:
    found, wanted = project.design.gains, project.testbed.tuning.speed_bandwidth
    for name in project.testbed.roles.speed:
        I_m = inertia(project, name)
        poles = np.roots([I_m, found.speed[name], found.speed_integral[name]])
        np.testing.assert_allclose(poles, -wanted / 2, rtol=1e-6)


def test_torque_poles_are_5_79_and_5_81(torque_project: Project) -> None:
    """Eigenvalues of the closed loop of the reduced bed with the gains as they are emitted."""
    project = torque_project
    decoupling, found = project.design.decoupling, project.design.gains
    (machine,) = project.testbed.roles.torque
    inertias = dict.fromkeys(decoupling.inertia_estimate, found.inertia_estimate[machine])
    loop = ClosedLoop(decoupling, {f"{machine}_damping": found.damping[machine]}, inertias)
    poles = np.linalg.eigvals(loop.A + loop.B @ loop.of_x)
    moving = poles[abs(poles) > 1e-3 * abs(poles).max()]
    assert len(moving) == 2
    zeta, expected = project.testbed.tuning.damping_ratio, found.natural_frequency[machine]
    assert expected == pytest.approx(np.sqrt(found.stiffness[machine] / found.inertia_estimate[machine]))
    np.testing.assert_allclose(abs(moving), expected, rtol=5e-3)  # (5.79)
    np.testing.assert_allclose(-moving.real / abs(moving), zeta, rtol=1e-4)  # (5.81)


@pytest.mark.parametrize("zeta", [0.1, 0.5, 0.9])
def test_damping_follows_the_wanted_ratio(projects: dict[str, Project], zeta: float) -> None:
    project = projects["differential"]
    tuning = Tuning.model_validate({"damping_ratio": zeta})
    found = gains(project.design.decoupling, project.model, tuning, project.reduced.modes_before)
    c, I1, d = found.stiffness["M1"], found.inertia_estimate["M1"], found.damping["M1"]
    poles = np.roots([I1, d, c])
    np.testing.assert_allclose(-poles.real / abs(poles), zeta, rtol=1e-5)
    assert abs(poles[0]) == pytest.approx(found.natural_frequency["M1"])
    assert poles.imag.any()


def test_stiffness_is_that_of_the_reduced_bed(torque_project: Project) -> None:
    """What M1 sees while all the others stand: the first diagonal entry of E'CE."""
    project = torque_project
    numeric = project.reduced.model.numeric()
    (machine,) = project.testbed.roles.torque
    at = project.reduced.model.coordinates.index(f"{machine}.shaft")
    held = (numeric.twist_rows.T @ numeric.stiffness @ numeric.twist_rows)[at, at]
    assert project.design.gains.stiffness[machine] == pytest.approx(held)


@pytest.mark.parametrize(
    ("name", "parts", "referred"),
    [
        ("back_to_back", ["M1"], 0.0),
        ("differential", ["M1", "flange1"], 0.0),
        ("differential_gearboxes", ["M1", "flange1", "gearbox1"], 0.3 / 8.1**2),
    ],
)
def test_accelerated_inertia_is_all_that_stands_before_the_place(
    projects: dict[str, Project], name: str, parts: list[str], referred: float
) -> None:
    """With the testing torque at zero, M1 has to accelerate what lies between it and the place, and no more."""
    project = projects[name]
    expected = inertia(project, *parts) + referred
    assert project.design.gains.inertia_estimate["M1"] == pytest.approx(expected, rel=1e-5)


def test_steady_acceleration_leaves_the_testing_torque_alone(torque_project: Project) -> None:
    """The full model, accelerated steadily with the torque that the law adds: the torque at the place is zero."""
    project = torque_project
    model, design = project.model, project.design
    (machine,), (place,) = project.testbed.roles.torque, project.testbed.roles.torque.values()
    decoupling = design.decoupling
    numeric, E = model.numeric(), model.numeric().twist_rows
    own, *others = decoupling.actuators
    table = decoupling.values | {decoupling.inertia_estimate[0]: design.gains.inertia_estimate[machine]}
    share = evaluate_matrix(decoupling.law.P, table)[own, 1:]
    rotors = [inertia(project, decoupling.machines[k]) for k in others]
    acceleration = 10.0
    added = float(share @ (np.array(rotors) * acceleration))
    n_z, n_e = len(model.coordinates), len(model.twists)
    rows = numeric.input_rows[others]
    B = numeric.input_rows.T
    matrix = np.block(
        [
            [numeric.mass, E.T @ numeric.stiffness, -B[:, others]],
            [E, np.zeros((n_e, n_e + len(others)))],
            [rows, np.zeros((len(others), n_e + len(others)))],
        ]
    )
    right = np.concatenate([B[:, own] * added, np.zeros(n_e), np.full(len(others), acceleration)])
    solution, *_ = np.linalg.lstsq(matrix, right, rcond=None)
    np.testing.assert_allclose(matrix @ solution, right, atol=1e-6)
    a, e = solution[:n_z], solution[n_z : n_z + n_e]
    u = np.zeros(len(model.inputs))
    u[own], u[others] = added, solution[n_z + n_e :]
    form = model.signals[place]
    torque = sum(evaluate_matrix(part, model.values)[0] @ x for part, x in ((form.a, a), (form.e, e), (form.u, u)))
    assert abs(torque) < 5e-5 * abs(added)


def test_inertia_of_the_file_wins() -> None:
    bed = differential_bed()
    bed.reduction = {"drop": ["diff", "flange1", "flange2", "flange3"]}
    bed.control = {"inertia_estimate": {"M1": "1.5 kg m^2"}}
    project = Project(bed.load())
    assert project.design.gains.inertia_estimate["M1"] == 1.5


def test_conventional_integrator_stays_below_half_the_limit(project: Project) -> None:
    """Without active damping the integrator is limited by the weakest mode, zeta omega, or by the bandwidth."""
    found = project.design.gains
    elastic = [mode for mode in project.reduced.modes_before if mode.frequency_hz > 0]
    weakest = min(2 * np.pi * mode.frequency_hz * mode.damping_ratio for mode in elastic)
    for name, gain in found.conventional_integral.items():
        assert 0 < gain <= min(weakest, project.testbed.tuning.torque_bandwidth) * (1 + 1e-5)
        assert found.torque_integral[name] == project.testbed.tuning.torque_bandwidth

"""Lie derivatives and relative degrees against their definitions (5.24), (5.25), (5.29)."""

from __future__ import annotations

import pytest
import sympy as sp
from control_laws import design, expanded, is_zero, symbols
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanism.bed_text import Bed, differential_bed, two_machines

from ptgen.control.lie import AffineSystem, affine_system, derivatives
from ptgen.mechanism.model import LinearForm
from ptgen.project import Project

_ENTRY = st.sampled_from([0, 0, 0, 1, -1, 2])


def form(row: sp.Matrix, inputs: int, frictions: int = 1) -> LinearForm:
    n = row.shape[1]
    return LinearForm(row, sp.zeros(1, 0), sp.zeros(1, inputs), sp.zeros(1, frictions), sp.zeros(1, n))


@settings(max_examples=40)
@given(st.data())
def test_derivatives_follow_the_definition(data: st.DataObject) -> None:
    """``L_a h = (dh/dx) a`` (5.25), applied until an input appears (5.24)."""
    n, m = 4, 2
    fill = lambda rows, columns: sp.Matrix(  # noqa: E731  short, used three times
        rows, columns, data.draw(st.lists(_ENTRY, min_size=rows * columns, max_size=rows * columns))
    )
    A, B, F, h = fill(n, n), fill(n, m), fill(n, 1), fill(1, n)
    x = sp.Matrix(sp.symbols("x0:4"))
    chain = derivatives(AffineSystem(A, B, F), "y", form(h, m))
    function, expected = (h * x)[0], []
    degree = None
    for delta in range(1, n + 1):
        gradient = sp.Matrix([function]).jacobian(x)
        expected.append(function)
        inputs, disturbance = gradient * B, gradient * F
        function = sp.expand((gradient * A * x)[0])
        if any(entry != 0 for entry in inputs):
            degree = delta
            break
    assert chain.relative_degree == degree
    assert [sp.expand((row * x)[0]) for row in chain.rows] == [*map(sp.expand, expected), function]
    if degree is not None:
        assert chain.input_row == inputs
        assert chain.disturbance_row == disturbance


def test_input_in_the_output_itself_is_degree_zero() -> None:
    system = AffineSystem(sp.eye(2), sp.eye(2), sp.zeros(2, 1))
    direct = LinearForm(sp.Matrix([[1, 0]]), sp.zeros(1, 0), sp.Matrix([[0, 3]]), sp.zeros(1, 1), sp.zeros(1, 2))
    chain = derivatives(system, "y", direct)
    assert (chain.relative_degree, chain.input_row) == (0, sp.Matrix([[0, 3]]))


def test_state_equations_meet_newton(project: Project) -> None:
    """``M A_z = -E'C`` and ``de/dt = E z``: the affine system is the model and nothing else."""
    model = project.reduced.model
    system = affine_system(model)
    n_z = len(model.coordinates)
    assert system.order == model.order
    assert is_zero(model.mass * system.A[:n_z, n_z:] + model.twist_rows.T * model.stiffness)
    assert is_zero(model.mass * system.B[:n_z, :] - model.input_rows.T)
    assert system.A[n_z:, :n_z] == model.twist_rows


def transmission() -> Bed:
    """Two machines, shaft on the fast side only, so that the stiffness does not depend on the ratio."""
    bed = Bed()
    bed.add("flange1", "torque_flange", inertia=0.01, stiffness=4e5)
    bed.add("shaft1", "shaft", stiffness=5e4)
    bed.add("gear", "gearbox", ratio=3.5, inertia=0.02)
    bed.add("flange2", "torque_flange", inertia=0.01, stiffness=4e6)
    result = two_machines(["flange1", "shaft1", "gear", "flange2"], bed)
    result.reduction = {"drop": ["gear", "flange1", "flange2"], "rigid": ["flange1", "flange2"]}
    return result


def test_decoupling_matrix_is_5_48() -> None:
    decoupling = design(transmission())
    p = symbols(decoupling)
    c, i, I1, I2 = p["shaft1_stiffness"], p["gear_ratio"], p["M1_inertia_estimate"], p["M2_inertia"]
    assert is_zero(expanded(decoupling, decoupling.matrix) - sp.Matrix([[c / I1, -i * c / I2], [0, 1 / I2]]))
    assert (decoupling.relative_degrees, decoupling.internal_order) == ((2, 1), 0)


def test_changing_ratio_adds_its_term_of_5_46() -> None:
    """``- c omega_2 di/dt``, with the twist as a state and a stiffness that does not depend on the ratio."""
    decoupling = design(transmission())
    p = symbols(decoupling)
    rate = sp.Symbol("ratio_rate")
    model = decoupling.model
    place = decoupling.outputs[0]
    output = model.without_acceleration(model.signals[place])
    still = derivatives(decoupling.system, place, output)
    moving = derivatives(decoupling.system, place, output, {p["gear_ratio"]: rate})
    c = p["shaft1_stiffness"]
    assert is_zero(moving.rows[2] - still.rows[2] - sp.Matrix([[0, -c * rate, 0]]))
    assert moving.rows[:2] == still.rows[:2]
    second = c * (-c / p["M1_inertia_estimate"] - p["gear_ratio"] ** 2 * c / p["M2_inertia"])
    assert is_zero(still.rows[2] - sp.Matrix([[0, 0, second]]))  # the rest of (5.46)
    assert moving.input_row == still.input_row


def test_decoupling_matrix_is_5_69(projects: dict[str, Project]) -> None:
    decoupling = projects["differential_gearboxes"].design.decoupling
    p = symbols(decoupling)
    i = p["diff_ratio"] * p["gearbox1_ratio"] / p["gearbox2_ratio"]
    c1, c2 = p["cardan1_stiffness"] / p["gearbox1_ratio"] ** 2, p["cardan2_stiffness"] / p["gearbox2_ratio"] ** 2
    k = p["gearbox2_ratio"] * i * 2 * c1 * c2 / (i**2 * c1 + 2 * c2)
    I1, I2, I3 = p["M1_inertia_estimate"], *(p[f"M{n}_inertia"] + p[f"gearbox{n}_inertia"] for n in (2, 3))
    printed = sp.Matrix([[k / I1, -k * i / (2 * I2), -k * i / (2 * I3)], [0, 1 / I2, 0], [0, 0, 1 / I3]])
    same = {p["cardan3_stiffness"]: p["cardan2_stiffness"], p["gearbox3_ratio"]: p["gearbox2_ratio"]}
    assert is_zero((expanded(decoupling, decoupling.matrix) - printed).subs(same))


@pytest.mark.parametrize("kind", ["differential", "bevel_differential", "epicyclic_differential"])
def test_degrees_of_three_machines(kind: str) -> None:
    decoupling = design(differential_bed(kind))
    assert decoupling.relative_degrees == (2, 1, 1)
    assert (decoupling.system.order, decoupling.internal_order) == (4, 0)
    assert decoupling.internal_eigenvalues.size == 0

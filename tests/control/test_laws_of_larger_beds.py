"""Laws of shipped beds that the source does not treat: five machines, swapped roles, two torques at once."""

from __future__ import annotations

import sympy as sp
from control_laws import assert_decoupled, is_zero, symbols

from ptgen.mechanism import exact
from ptgen.project import Project


def test_five_machines_share_the_acceleration_torque(projects: dict[str, Project]) -> None:
    """A quarter of the total ratio from M1 to each wheel, as (5.78) has half of it for two outputs."""
    decoupling = projects["all_wheel_drive"].design.decoupling
    p, law = symbols(decoupling), decoupling.law_expressions()
    assert decoupling.relative_degrees == (2, 1, 1, 1, 1) and decoupling.internal_order == 0
    expected = sp.Symbol("v_M1") - p["M1_damping"] * sp.Symbol("M1_speed")
    for number in (2, 3, 4, 5):
        share = p["centre_ratio"] * p["front_ratio" if number < 4 else "rear_ratio"] / 4
        v, speed = sp.symbols(f"v_M{number} M{number}_speed")
        expected += share * (p["M1_inertia_estimate"] * v / p[f"M{number}_inertia"] + p["M1_damping"] * speed)
        assert is_zero(law[f"M{number}"] - (v - sp.Symbol(f"flange{number}_torque")))
    assert is_zero(law["M1"] - expected)
    assert_decoupled(decoupling)


def test_torque_at_an_output(projects: dict[str, Project]) -> None:
    """M2 swings against twice the input's speed over the ratio less the other output's: the law damps that motion."""
    decoupling = projects["differential_output_torque"].design.decoupling
    p, law = symbols(decoupling), decoupling.law_expressions()
    i, d = p["diff_ratio"], p["M2_damping"]
    v1, v2, v3, w1, w2, w3 = sp.symbols("v_M1 v_M2 v_M3 M1_speed M2_speed M3_speed")
    follow = p["M2_inertia_estimate"] * (2 / i * v1 / p["M1_inertia"] - v3 / p["M3_inertia"])
    assert is_zero(law["M2"] - (-v2 + follow - d * (w2 + w3 - 2 * w1 / i)))
    assert is_zero(law["M1"] - (v1 + sp.Symbol("flange1_torque")))
    assert is_zero(law["M3"] - (v3 - sp.Symbol("flange3_torque")))
    assert_decoupled(decoupling)


def test_two_torques_behind_a_locked_differential(projects: dict[str, Project]) -> None:
    """Three speeds and two twists, nothing hidden; the twists are those of M2 and M3 against M1."""
    project = projects["centre_differential_locked"]
    decoupling = project.design.decoupling
    assert decoupling.relative_degrees == (2, 2, 1) and decoupling.system.order == 5
    assert decoupling.internal_order == 0
    ratio = symbols(decoupling)["diff_ratio"]
    assert is_zero(decoupling.model.twist_rows - sp.Matrix([[-1 / ratio, 1, 0], [-1 / ratio, 0, 1]]))
    assert_decoupled(decoupling)


def test_plain_twists_span_those_of_the_shafts(projects: dict[str, Project]) -> None:
    model = projects["centre_differential_locked"].reduced.model
    rates = exact.stack([row * model.twist_rows for row in model.spring_rows.values()], len(model.coordinates))
    assert exact.rank(rates) == len(model.twists) == 2
    energy = sum(
        (model.spring_stiffness[name] * row.T * row for name, row in model.spring_rows.items()), sp.zeros(2, 2)
    )
    assert is_zero(energy - model.stiffness)

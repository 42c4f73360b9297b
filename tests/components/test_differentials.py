"""The three differentials, assembled by the general rules, against the printed equations of motion."""

from __future__ import annotations

import pytest
import sympy as sp
from loose_component import example, is_zero, loose_model, symbols_of

from ptgen.mechanism.model import Model

T_di, T_do1, T_do2, T_dl, T_dsl, w_di, w_3 = sp.symbols("T_di T_do1 T_do2 T_dl T_dsl omega_di omega_3", real=True)
DIFFERENTIALS = ("differential", "bevel_differential", "epicyclic_differential")


def accelerations(model: Model) -> sp.Matrix:
    """Return the accelerations of input and pinion; all torques as in the source, friction velocities first."""
    assert len(model.coordinates) == 2
    assert model.coordinates[0] == "x.input"
    rates = model.accelerations()
    return rates.u * sp.Matrix([T_di, -T_do1, -T_do2]) + rates.f * sp.Matrix([T_dl, T_dsl])


def symbols_and_model(name: str) -> tuple[dict[str, sp.Symbol], Model]:
    component = example(name)
    return symbols_of(component), loose_model(component)


def outputs(model: Model) -> list[sp.Expr]:
    z = sp.Matrix([w_di, w_3])
    return [(model.velocity_rows[f"x.output{k}"] * z)[0] for k in (1, 2)]


def static_torques(model: Model) -> tuple[sp.Expr, sp.Expr]:
    """Return both output torques at rest, from the accelerations set to zero."""
    solution = sp.solve(list(model.mass * accelerations(model)), [T_do1, T_do2], dict=True)[0]
    return solution[T_do1], solution[T_do2]


def test_bevel_differential_follows_3_16_to_3_19() -> None:
    p, model = symbols_and_model("bevel_differential")
    i, r1, r2, r3 = p["ratio"], p["radius_output1"], p["radius_output2"], p["radius_pinion"]
    I0, Ic, I1, I2, I3 = (p[f"inertia_{part}"] for part in ("drive", "cage", "output1", "output2", "pinion"))
    I_d = Ic + i**2 * I0
    D_c = I_d * (I1 * r3**2 / r1**2 + I2 * r3**2 / r2**2 + I3) + I1 * I2 * (r3 / r1 + r3 / r2) ** 2 + I1 * I3 + I2 * I3
    printed_di = (
        i**2 * (T_di - T_dl) * (I1 * r3**2 / r1**2 + I2 * r3**2 / r2**2 + I3)
        - i * T_dsl * (I2 * r3 / r2 - I1 * r3 / r1)
        - i * T_do1 * (I2 * r3**2 / r2**2 + I2 * r3**2 / (r1 * r2) + I3)
        - i * T_do2 * (I1 * r3**2 / r1**2 + I1 * r3**2 / (r1 * r2) + I3)
    )
    printed_3b = (
        i * (T_di - T_dl) * (I2 * r3 / r2 - I1 * r3 / r1)
        - T_dsl * (I_d + I1 + I2)
        - T_do1 * (I_d * r3 / r1 + I2 * r3 / r1 + I2 * r3 / r2)
        + T_do2 * (I_d * r3 / r2 + I1 * r3 / r1 + I1 * r3 / r2)
    )
    derived = accelerations(model)
    assert is_zero(derived[0] - printed_di / D_c)
    assert is_zero(derived[1] - printed_3b / D_c)
    assert is_zero(model.mass.det() * i**2 - D_c)  # (3.18)
    printed_outputs = [w_di / i + r3 / r1 * w_3, w_di / i - r3 / r2 * w_3]  # (3.19)
    assert is_zero(sp.Matrix(outputs(model)) - sp.Matrix(printed_outputs))


def test_bevel_differential_splits_torque_as_3_20() -> None:
    p, model = symbols_and_model("bevel_differential")
    i, r1, r2, r3 = p["ratio"], p["radius_output1"], p["radius_output2"], p["radius_pinion"]
    gamma0 = r1 * r2 / (r3 * (r1 + r2))  # (3.21)
    first, second = static_torques(model)
    assert is_zero(first - (r1 / (r1 + r2) * i * (T_di - T_dl) - gamma0 * T_dsl))
    assert is_zero(second - (r2 / (r1 + r2) * i * (T_di - T_dl) + gamma0 * T_dsl))
    weighted = [r / (r1 + r2) * speed for r, speed in zip((r1, r2), outputs(model), strict=True)]
    assert is_zero(i * sum(weighted) - w_di)  # (3.22)


def test_epicyclic_differential_follows_3_25_to_3_28() -> None:
    """With the sign of T_dsl in (3.25) corrected: the printed one would create power."""
    p, model = symbols_and_model("epicyclic_differential")
    r_r, r_s = p["radius_ring"], p["radius_sun"]
    r_p = (r_r - r_s) / 2
    I_c, I_r, I_s = p["inertia_carrier"], p["inertia_ring"], p["inertia_sun"]
    I_p = p["planets"] * p["inertia_planet"]
    D = I_c * (I_r * r_p**2 / r_r**2 + I_s * r_p**2 / r_s**2 + I_p) + I_r * I_s * (r_p / r_r + r_p / r_s) ** 2
    D += I_r * I_p + I_s * I_p  # (3.27)
    corrected_di = (
        (T_di - T_dl) * (I_r * r_p**2 / r_r**2 + I_s * r_p**2 / r_s**2 + I_p)
        - T_dsl * (I_s * r_p / r_s - I_r * r_p / r_r)
        - T_do1 * (I_s * r_p**2 / r_s**2 + I_s * r_p**2 / (r_r * r_s) + I_p)
        - T_do2 * (I_r * r_p**2 / r_r**2 + I_r * r_p**2 / (r_r * r_s) + I_p)
    )
    printed_3p = (
        (T_di - T_dl) * (I_s * r_p / r_s - I_r * r_p / r_r)
        - T_dsl * (I_c + I_r + I_s)
        - T_do1 * (I_c * r_p / r_r + I_s * r_p / r_s + I_s * r_p / r_r)
        + T_do2 * (I_c * r_p / r_s + I_r * r_p / r_r + I_r * r_p / r_s)
    )
    derived = accelerations(model)
    assert is_zero(derived[0] - corrected_di / D)
    assert is_zero(derived[1] - printed_3p / D)
    assert is_zero(model.mass.det() - D)
    printed_outputs = [w_di + r_p / r_r * w_3, w_di - r_p / r_s * w_3]  # (3.28)
    assert is_zero(sp.Matrix(outputs(model)) - sp.Matrix(printed_outputs))


def test_epicyclic_differential_splits_torque_as_3_29() -> None:
    p, model = symbols_and_model("epicyclic_differential")
    r_r, r_s = p["radius_ring"], p["radius_sun"]
    gamma1, gamma2 = r_r / (r_s + r_r), r_s / (r_s + r_r)
    gamma0 = r_r * r_s / ((r_r - r_s) / 2 * (r_r + r_s))  # (3.30)
    first, second = static_torques(model)
    assert is_zero(first - (gamma1 * (T_di - T_dl) - gamma0 * T_dsl))
    assert is_zero(second - (gamma2 * (T_di - T_dl) + gamma0 * T_dsl))
    speed1, speed2 = outputs(model)
    assert is_zero(gamma1 * speed1 + gamma2 * speed2 - w_di)  # (3.31)


def test_symmetric_differential_follows_c13_and_c14() -> None:
    p, model = symbols_and_model("differential")
    i, rho, I_di, I_3b = p["ratio"], p["pinion_ratio"], p["inertia"], p["inertia_pinion"]
    derived = accelerations(model)
    assert is_zero(I_di * derived[0] - (T_di - T_dl - T_do1 / i - T_do2 / i))
    assert is_zero(I_3b * derived[1] - (-T_do1 + T_do2 - T_dsl / rho))
    assert is_zero(sp.Matrix(outputs(model)) - sp.Matrix([w_di / i + rho * w_3, w_di / i - rho * w_3]))


def test_symmetric_bevel_differential_is_the_reduced_one() -> None:
    """With r1 = r2 and I1 = I2, (C.12) gives the two inertias of the reduced form."""
    b, bevel = symbols_and_model("bevel_differential")
    p, reduced = symbols_and_model("differential")
    i, r1, r3, I1, I3 = b["ratio"], b["radius_output1"], b["radius_pinion"], b["inertia_output1"], b["inertia_pinion"]
    symmetric = {b["radius_output2"]: r1, b["inertia_output2"]: I1}
    I_d = b["inertia_cage"] + i**2 * b["inertia_drive"]
    numerator = I_d * (2 * I1 * r3**2 / r1**2 + I3) + 4 * I1**2 * r3**2 / r1**2 + 2 * I1 * I3
    c12 = {
        p["ratio"]: i,
        p["pinion_ratio"]: r3 / r1,
        p["inertia"]: numerator / (i**2 * (2 * I1 * r3**2 / r1**2 + I3)),
        p["inertia_pinion"]: numerator / (I_d * r3 / r1 + 2 * I1 * r3 / r1),
    }
    assert is_zero(accelerations(bevel).subs(symmetric) - accelerations(reduced).subs(c12))


@pytest.mark.parametrize("name", DIFFERENTIALS)
def test_power_of_outside_torques_and_friction_is_the_rate_of_energy(name: str) -> None:
    _, model = symbols_and_model(name)
    z = sp.Matrix([w_di, w_3])
    speed1, speed2 = outputs(model)
    power = T_di * w_di - T_do1 * speed1 - T_do2 * speed2 - T_dl * w_di - T_dsl * w_3
    assert is_zero((z.T * model.mass * accelerations(model))[0] - power)


@pytest.mark.parametrize("name", DIFFERENTIALS)
def test_friction_matrix_is_symmetric(name: str) -> None:
    """(3.32): friction acts with the inverse of the inertia."""
    _, model = symbols_and_model(name)
    friction_matrix = -accelerations(model).jacobian([T_dl, T_dsl])
    assert is_zero(friction_matrix - friction_matrix.T)
    numeric = friction_matrix.subs(model.values)
    assert numeric.is_positive_definite

"""Shaft with backlash and gearbox with elastic teeth and play against Newton's law of both sides."""

from __future__ import annotations

import pytest
import sympy as sp
from loose_component import case, is_zero, loose_model, symbols_of

T_in, T_out, T_z, w_in, w_out, twist = sp.symbols("T_in T_out T_z w_in w_out twist", real=True)


def sides(name: str) -> tuple[sp.Expr, sp.Expr]:
    """Return the inertias of input and output."""
    component = case(name)
    p = symbols_of(component)
    named, other = p["inertia"], p["inertia_other"]
    return (named, other) if component.inertia_side == "input" else (other, named)


def test_play_is_a_contact_between_both_sides() -> None:
    """T_z is whatever the teeth transmit; the gap decides on it."""
    name = "gearbox with play"
    p = symbols_of(case(name))
    model = loose_model(case(name))
    (contact,) = model.contacts
    assert contact.backlash == p["play"]
    assert (contact.stiffness, contact.damping) == (p["mesh_stiffness"], p["mesh_damping"])
    rate = model.accelerations()
    found = rate.u * sp.Matrix([T_in, -T_out]) + rate.f * sp.Matrix([T_z])
    of_input, of_output = ((model.velocity_rows[f"x.{side}"] * found)[0] for side in ("input", "output"))
    I_1, I_2 = sides(name)
    assert is_zero(I_1 * of_input - (T_in - T_z / p["ratio"]))
    assert is_zero(I_2 * of_output - (T_z - T_out))
    rows = [model.velocity_rows[f"x.{side}"] for side in ("input", "output")]
    assert is_zero(model.contact_rows - (rows[0] / p["ratio"] - rows[1])), "the gap is one at the output"


def test_elastic_teeth_follow_newton_and_hooke() -> None:
    name = "gearbox with elastic teeth"
    p = symbols_of(case(name))
    model = loose_model(case(name))
    assert not model.contacts
    assert model.coordinates == ("x.input", "x.output")
    z = sp.Matrix([w_in, w_out])
    (twist_rate,) = model.twist_rows * z
    scale = sp.cancel(twist_rate / (w_in / p["ratio"] - w_out))
    teeth = p["mesh_stiffness"] * twist / scale + p["mesh_damping"] * (w_in / p["ratio"] - w_out)
    rates = model.accelerations()
    found = rates.z * z + rates.e * sp.Matrix([twist]) + rates.u * sp.Matrix([T_in, -T_out])
    I_1, I_2 = sides(name)
    assert is_zero(I_1 * found[0] - (T_in - teeth / p["ratio"]))
    assert is_zero(I_2 * found[1] - (teeth - T_out))


def test_two_inertias_of_rigid_gears_are_those_of_3_9() -> None:
    name = "gearbox with two inertias"
    p = symbols_of(case(name))
    model = loose_model(case(name))
    I_1, I_2 = sides(name)
    rate = (model.accelerations().u * sp.Matrix([T_in, -T_out]))[0]
    input_rate = model.velocity_rows["x.input"][0] * rate
    assert is_zero((I_1 + I_2 / p["ratio"] ** 2) * input_rate - (T_in - T_out / p["ratio"]))


def test_backlash_belongs_to_the_shaft() -> None:
    (spring,) = case("shaft with backlash").elements("x").springs
    assert spring.backlash == symbols_of(case("shaft with backlash"))["backlash"]
    (value,) = [p.value for p in case("shaft with backlash").parameters("x") if p.unit == "rad"]
    assert value == pytest.approx(0.5 * 3.141592653589793 / 180)
    assert case("shaft").elements("x").springs[0].backlash is None

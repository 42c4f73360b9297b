"""Clutch, brake, bearing and freewheel against their equations of motion; what their validators refuse."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from friction_laws import limit_of, torque_of
from hypothesis import given
from hypothesis import strategies as st
from loose_component import EXAMPLES, case, example, is_zero, loose_model, symbols_of

from ptgen.components.catalogue import CATALOGUE
from ptgen.elements import FrictionRole
from ptgen.testbed.problems import validated

T_i, T_o, T_c, w_1, w_2 = sp.symbols("T_i T_o T_c omega_1 omega_2", real=True)


def two_accelerations(name: str) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return the accelerations of input and output, and the slip, of a coupling alone."""
    model = loose_model(case(name))
    z = sp.Matrix([w_1, w_2])
    rates = model.accelerations()
    found = rates.z * z + rates.u * sp.Matrix([T_i, -T_o]) + rates.f * sp.Matrix([T_c])
    of_input, of_output = ((model.velocity_rows[f"x.{side}"] * found)[0] for side in ("input", "output"))
    return of_input, of_output, (model.friction_rows * z)[0]


@pytest.mark.parametrize("name", ["clutch", "dry clutch", "freewheel", "clutch that is always pressed"])
def test_coupling_follows_3_11(name: str) -> None:
    p = symbols_of(case(name))
    of_input, of_output, slip = two_accelerations(name)
    always = p["viscous"] * slip if name in ("freewheel", "clutch that is always pressed") else 0
    torque = T_c + always
    assert is_zero(p["inertia_input"] * of_input - (T_i - torque))
    assert is_zero(p["inertia_output"] * of_output - (torque - T_o))


def test_clutch_in_the_states_of_4_15_follows_4_16() -> None:
    """The first row of (4.15) as corrected: the velocity of the common inertia."""
    p = symbols_of(example("clutch"))
    I_ci, I_co = p["inertia_input"], p["inertia_output"]
    model = loose_model(example("clutch"))
    assert model.coordinates[0] == "x", "the slip is a state, as in the source"
    of_input, of_output, slip = two_accelerations("clutch")
    common = (I_ci * of_input + I_co * of_output) / (I_ci + I_co)
    assert is_zero(common - (T_i - T_o) / (I_ci + I_co))
    assert is_zero(of_input - of_output - (T_i / I_ci + T_o / I_co - (1 / I_ci + 1 / I_co) * T_c))
    assert is_zero(slip - w_1)


def test_locked_clutch_is_one_inertia() -> None:
    p = symbols_of(example("clutch"))
    model = loose_model(example("clutch"), locked={"x"})
    assert is_zero(model.mass - sp.Matrix([[p["inertia_input"] + p["inertia_output"]]]))


@pytest.mark.parametrize("name", ["brake", "brake that is always pressed", "bearing"])
def test_friction_against_the_housing_follows_newton(name: str) -> None:
    component = case(name)
    p = symbols_of(component)
    model = loose_model(component)
    assert model.coordinates == ("x.left",)
    rates = model.accelerations()
    rate = (rates.z * sp.Matrix([w_1]) + rates.u * sp.Matrix([T_i, -T_o]) + rates.f * sp.Matrix([T_c]))[0]
    always = 0 if name == "brake" else p["viscous"] * w_1
    assert is_zero(p["inertia"] * rate - (T_i - T_o - T_c - always))
    assert is_zero(loose_model(component).velocity_rows["x.right"][0] - 1)


def test_every_element_has_the_name_of_its_component_and_its_role() -> None:
    wanted = {
        "clutch": (FrictionRole.COUPLING, True, False),
        "brake": (FrictionRole.COUPLING, True, False),
        "bearing": (FrictionRole.LOSS, False, False),
        "freewheel": (FrictionRole.COUPLING, False, True),
    }
    for name, properties in wanted.items():
        (friction,) = example(name).elements("c1").frictions
        assert friction.name == "c1"
        assert (friction.role, friction.actuated, friction.one_way) == properties
    (friction,) = case("clutch that is always pressed").elements("c1").frictions
    assert not friction.actuated


@given(
    kinetic=st.floats(1, 500),
    above=st.floats(0, 300),
    speed=st.floats(0.1, 100),
    viscous=st.floats(0, 2),
    mu=st.floats(0, 1),
    w=st.floats(-200, 200),
)
def test_clutch_torque_is_3_12(kinetic: float, above: float, speed: float, viscous: float, mu: float, w: float) -> None:
    static = kinetic + above
    component = CATALOGUE["clutch"].model_validate(
        {
            "type": "clutch",
            "capacity": f"{kinetic!r} N m",
            "static": f"{static!r} N m",
            "stribeck_speed": f"{speed!r} rad/s",
            "viscous": f"{viscous!r} N m s/rad",
        }
    )
    (friction,) = component.elements("x").frictions
    values = {parameter.symbol: parameter.value for parameter in component.parameters("x")}
    wanted = mu * (kinetic + (static - kinetic) * math.exp(-abs(w) / speed) + viscous * abs(w)) * math.copysign(1, w)
    assert torque_of(friction, values, w, 0.0, 0.0, mu) == pytest.approx(wanted, rel=1e-9, abs=1e-9)
    assert limit_of(friction, values, 0.0, 0.0, mu) == pytest.approx(mu * static, rel=1e-9)


def test_dry_clutch_is_3_13() -> None:
    component = example("clutch", static=None, stribeck_speed=None, viscous=None, saturation=None, ripple=None)
    (friction,) = component.elements("x").frictions
    values = {parameter.symbol: parameter.value for parameter in component.parameters("x")}
    for w in (-50.0, 0.01, 50.0):
        assert torque_of(friction, values, w, 0.0, 0.0, 0.4) == pytest.approx(0.4 * math.copysign(300, w))


def test_disks_may_leave_their_inertia_to_the_neighbours() -> None:
    for name in ("clutch", "freewheel"):
        assert not example(name, inertia_input=None, inertia_output=None).elements("x").bodies
        (body,) = example(name, inertia_input=None).elements("x").bodies
        assert body.velocity == "x.output"
    for name in ("brake", "bearing"):
        assert not example(name, inertia=None).elements("x").bodies


RIPPLE = {"amplitude": 0.1, "order": 2}
REFUSED = [
    ("clutch", {"static": "200 N m"}, "", "static must not be below capacity, got 200 N m and 300 N m"),
    ("brake", {"static": "200 N m"}, "", "static must not be below capacity"),
    ("bearing", {"static": "0.5 N m"}, "", "static must not be below coulomb"),
    ("clutch", {"static": None}, "", "stribeck_speed needs static"),
    ("clutch", {"actuated": "yes"}, ".actuated", "must be true or false, got 'yes'"),
    ("clutch", {"actuated": 1}, ".actuated", "must be true or false, got 1"),
    ("bearing", {"actuated": True}, ".actuated", "unknown key"),
    ("clutch", {"capacity": "0 N m"}, ".capacity", "must be > 0 N m"),
    ("freewheel", {"drag": "-1 N m"}, ".drag", "must be >= 0 N m"),
    ("clutch", {"ripple": {**RIPPLE, "amplitude": 1.2}}, ".ripple.amplitude", "must be from 0 to 1, got 1.2"),
    ("clutch", {"ripple": {**RIPPLE, "amplitude": -0.2}}, ".ripple.amplitude", "must be >= 0"),
    ("clutch", {"ripple": {**RIPPLE, "order": 2.5}}, ".ripple.order", "whole number from 1 to 1000, got 2.5"),
    ("clutch", {"ripple": {**RIPPLE, "order": 0}}, ".ripple.order", "whole number from 1 to 1000, got 0"),
    ("clutch", {"ripple": {**RIPPLE, "order": True}}, ".ripple.order", "whole number"),
    ("clutch", {"ripple": {**RIPPLE, "phase": "2 s"}}, ".ripple.phase", "must be in rad or deg"),
    ("clutch", {"ripple": {"order": 1}}, ".ripple.amplitude", "is missing"),
    ("brake", {"saturation": {"slope": "1 N m s/rad"}}, ".saturation.speed", "is missing"),
    ("brake", {"saturation": 3}, ".saturation", "must be a table"),
    ("differential", {"loss": {"ripple": {"amplitude": 2, "order": 1}}}, ".loss.ripple.amplitude", "from 0 to 1"),
    ("shaft", {"backlash": "0 deg"}, ".backlash", "must be > 0 rad"),
    ("shaft", {"backlash": "-1 deg"}, ".backlash", "must be > 0 rad"),
    ("gearbox", {"play": "1 deg"}, "", "play needs a mesh_stiffness"),
    ("gearbox", {"mesh_damping": "1 N m s/rad"}, "", "mesh_damping needs a mesh_stiffness"),
]


@pytest.mark.parametrize(("name", "changes", "where", "text"), REFUSED)
def test_what_is_refused_says_where_and_what_to_do(
    name: str, changes: dict[str, object], where: str, text: str
) -> None:
    given = {"type": name, **EXAMPLES[name], **changes}
    record, problems = validated(
        CATALOGUE[name], {key: value for key, value in given.items() if value is not None}, "components", "x"
    )
    assert record is None
    (problem,) = problems
    assert problem.where == f"components.x{where}"
    assert text in problem.what
    assert problem.remedy


def test_defaults_of_the_sub_tables() -> None:
    component = example("clutch", ripple=RIPPLE)
    assert component.ripple.phase == 0.0
    symbols = {parameter.symbol.name for parameter in component.parameters("c1")}
    assert {"c1_ripple_amplitude", "c1_ripple_phase", "c1_saturation_slope", "c1_saturation_speed"} <= symbols
    assert "c1_ripple_order" not in symbols, "the order is no parameter: it decides on the code"

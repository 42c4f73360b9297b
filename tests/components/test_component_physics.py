"""Gearbox, shaft, flange and machine against their textbook equations; what their validators refuse."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from loose_component import EXAMPLES, example, is_zero, loose_model, symbols_of
from pydantic import ValidationError

from ptgen.elements import SensorKind

T_in, T_out = sp.symbols("T_in T_out", real=True)


@pytest.mark.parametrize("side", ["input", "output"])
def test_gearbox_follows_3_9_and_3_10(side: str) -> None:
    component = example("gearbox", inertia_side=side)
    p = symbols_of(component)
    i, inertia = p["ratio"], p["inertia"]
    model = loose_model(component)
    rate = (model.accelerations().u * sp.Matrix([T_in, -T_out]))[0]
    acceleration = {name: row[0] * rate for name, row in model.velocity_rows.items()}
    I_gbi = inertia if side == "input" else inertia / i**2
    I_gbo = i**2 * I_gbi
    assert is_zero(I_gbi * acceleration["x.input"] - (T_in - T_out / i))  # (3.9)
    assert is_zero(I_gbo * acceleration["x.output"] - (i * T_in - T_out))  # (3.10)
    assert is_zero(acceleration["x.input"] - i * acceleration["x.output"])  # (3.8)


def test_gearbox_may_reverse_the_sense() -> None:
    model = loose_model(example("gearbox", ratio=-2))
    rates = model.accelerations().u.subs(model.values)
    ratio = model.velocity_rows["x.output"][0] / model.velocity_rows["x.input"][0]
    assert ratio.subs(model.values) == pytest.approx(-0.5)
    assert rates[0, 0] > 0


@pytest.mark.parametrize("name", ["shaft", "torque_flange"])
def test_compliance_is_kelvin_voigt(name: str) -> None:
    """(3.4), (C.2): positive twist rate of the left against the right flange."""
    component = example(name)
    p = symbols_of(component)
    (spring,) = component.elements("x").springs
    left, right = component.flange_names()
    assert spring.row == {f"x.{left}": 1, f"x.{right}": -1}
    assert (spring.stiffness, spring.damping) == (p["stiffness"], p["damping"])


def test_torque_flange_measures_its_own_compliance() -> None:
    elements = example("torque_flange").elements("x")
    (sensor,) = elements.sensors
    assert (sensor.kind, sensor.of, sensor.name) == (SensorKind.TORQUE, "x", "x_torque")
    assert {body.velocity for body in elements.bodies} == {"x.uut", "x.machine"}
    without = example("torque_flange", inertia_machine=None).elements("x")
    assert {body.velocity for body in without.bodies} == {"x.uut"}


def test_inertia_follows_newton() -> None:
    component = example("inertia")
    model = loose_model(component)
    rate = (model.accelerations().u * sp.Matrix([T_in, -T_out]))[0]
    assert is_zero(symbols_of(component)["inertia"] * rate - (T_in - T_out))


def test_machine_follows_3_3() -> None:
    component = example("machine")
    p = symbols_of(component)
    elements = component.elements("x")
    (torque,), (body,), (sensor,) = elements.torques, elements.bodies, elements.sensors
    assert torque.row == {"x.shaft": 1}
    assert (body.velocity, body.inertia) == ("x.shaft", p["inertia"])
    assert (sensor.kind, sensor.of) == (SensorKind.SPEED, "x.shaft")
    assert torque.drive.time_constant == p["inverter_time_constant"]
    assert torque.drive.dead_time == p["inverter_dead_time"]


def test_ideal_inverter_has_no_dynamics() -> None:
    (torque,) = example("machine", inverter={"model": "ideal"}).elements("x").torques
    assert torque.drive.time_constant is None
    assert torque.drive.dead_time is None


@pytest.mark.parametrize(
    ("name", "changes", "text"),
    [
        ("machine", {"speed_max": "2000 rpm"}, "speed_max must not be below speed_rated"),
        ("machine", {"inverter": {"model": "ideal", "dead_time": "1 ms"}}, "takes no dead_time"),
        ("machine", {"inverter": {"model": "lag", "dead_time": "1 ms"}}, "needs a time_constant"),
        ("machine", {"inverter": {"model": "lag", "time_constant": "1 ms"}}, "needs a dead_time"),
        ("epicyclic_differential", {"radius_ring": "40 mm"}, "radius_ring must be greater than radius_sun"),
        ("epicyclic_differential", {"planets": 2.5}, "whole number"),
        ("gearbox", {"ratio": 0}, "must not be 0"),
        ("gearbox", {"inertia_side": "middle"}, "'input' or 'output'"),
    ],
)
def test_contradictions_are_refused(name: str, changes: dict[str, object], text: str) -> None:
    with pytest.raises(ValidationError, match=text):
        example(name, **changes)


@given(
    coulomb=st.floats(0, 1e3),
    load=st.floats(0, 0.5),
    viscous=st.floats(0, 10),
    part=st.sampled_from(["loss", "limited_slip"]),
    name=st.sampled_from([name for name in EXAMPLES if "limited_slip" in EXAMPLES[name]]),
)
def test_friction_law_is_3_34_and_3_35(coulomb: float, load: float, viscous: float, part: str, name: str) -> None:
    """Capacity T_0 + k_T |T_di| and viscous part, each friction by itself and with its numbers."""
    law = {"coulomb": f"{coulomb!r} N m", "load": load, "viscous": f"{viscous!r} N m s/rad"}
    component = example(name, loss=None, limited_slip=None).model_copy(
        update={part: getattr(example(name, **{part: law}), part)}
    )
    (friction,) = component.elements("x").frictions
    values = {parameter.symbol: parameter.value for parameter in component.parameters("x")}
    assert friction.name == f"x.{part}"
    assert friction.load is not None
    assert friction.load.place == "x.input"
    measured = [values[symbol] for symbol in (friction.coulomb, friction.load.coefficient, friction.viscous)]
    assert measured == pytest.approx([coulomb, load, viscous], rel=1e-14)
    assert friction.row == ({"x.input": 1} if part == "loss" else {component.elements("x").internal[-1]: 1})

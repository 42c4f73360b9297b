"""What holds for every component of the catalogue; a new one without an example fails here."""

from __future__ import annotations

import sys
from typing import get_args

import pytest
import sympy as sp
from friction_laws import limit_of, torque_of
from hypothesis import given
from hypothesis import strategies as st
from loose_component import CASES, EXAMPLES, case, example, loose_model
from pydantic import ValidationError

from ptgen import units
from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.elements import Elements, Row

TYPES = list(CATALOGUE)
SECTIONS = ("Flanges", "Equations", "Assumptions", "Reference")


def rows_of(elements: Elements) -> list[tuple[str, Row]]:
    owners = [
        *((spring.name, spring.row) for spring in elements.springs),
        *((friction.name, friction.row) for friction in elements.frictions),
        *((constraint.owner, constraint.row) for constraint in elements.constraints),
        *((torque.name, torque.row) for torque in elements.torques),
    ]
    return owners + [(body.velocity, {body.velocity: sp.Integer(1)}) for body in elements.bodies]


def expressions_of(elements: Elements) -> list[sp.Expr]:
    found = [coefficient for _, row in rows_of(elements) for coefficient in row.values()]
    found += [body.inertia for body in elements.bodies]
    for spring in elements.springs:
        found += [part for part in (spring.stiffness, spring.damping, spring.backlash) if part is not None]
    for friction in elements.frictions:
        found += [friction.coulomb, friction.viscous]
        found += [part for part in (friction.static, friction.stribeck_speed) if part is not None]
        if friction.load is not None:
            found.append(friction.load.coefficient)
        if friction.saturated is not None:
            found += [friction.saturated.slope, friction.saturated.speed]
        if friction.ripple is not None:
            found += [friction.ripple.amplitude, friction.ripple.phase]
    found += [fluid.reference_speed for fluid in elements.fluids]
    found += [sensor.time_constant for sensor in elements.sensors if sensor.time_constant is not None]
    for torque in elements.torques:
        drive = torque.drive
        found += [drive.torque_max, drive.speed_rated, drive.speed_max]
        found += [part for part in (drive.time_constant, drive.dead_time) if part is not None]
    return found


def test_every_type_has_an_example() -> None:
    assert set(EXAMPLES) == set(CATALOGUE)


@pytest.mark.parametrize("name", TYPES)
def test_type_name_is_the_one_in_the_catalogue(name: str) -> None:
    component = CATALOGUE[name]
    assert component.type_name == name
    assert get_args(component.model_fields["type"].annotation) == (name,)
    assert component.summary.strip()
    assert len(set(component.flange_names())) == len(component.flanges) > 0


@pytest.mark.parametrize("name", TYPES)
def test_module_reads_like_a_page_of_a_textbook(name: str) -> None:
    text = sys.modules[CATALOGUE[name].__module__].__doc__ or ""
    lines = text.splitlines()
    assert lines[0].endswith("."), "one-line summary first"
    places = [lines.index(section) for section in SECTIONS]
    assert places == sorted(places)
    for place in places:
        assert lines[place + 1].startswith("    ") and lines[place + 1].strip()
    assert ".. math::" in text


@pytest.mark.parametrize("name", CASES)
def test_parameters_have_symbol_unit_and_description(name: str) -> None:
    parameters = case(name).parameters("part")
    assert parameters
    assert len({parameter.symbol.name for parameter in parameters}) == len(parameters)
    for parameter in parameters:
        assert parameter.symbol.name.startswith("part_")
        assert len(parameter.description.split()) >= 2
        assert "\n" not in parameter.description
        if parameter.unit:
            assert units.parse(f"2 {parameter.unit}", parameter.unit) == 2
        assert parameter.symbol.is_positive or parameter.symbol.is_nonnegative or parameter.signed


@pytest.mark.parametrize("name", CASES)
def test_elements_speak_of_own_velocities_only(name: str) -> None:
    component = case(name)
    elements = component.elements("part")
    own = {f"part.{flange}" for flange in component.flange_names()}
    internal = set(elements.internal)
    assert not own & internal
    touched: set[str] = set()
    for owner, row in rows_of(elements):
        assert row, owner
        assert all(sp.sympify(coefficient) != 0 for coefficient in row.values()), owner
        touched |= set(row)
    assert touched == own | internal, "every flange and every internal velocity takes part"
    for place in elements.places:
        assert place.name.startswith("part.")
        assert set(place.flanges) <= own
    assert {place.name.removeprefix("part.") for place in elements.places} == set(component.place_names())
    for friction in elements.frictions:
        assert friction.load is None or friction.load.place in own
    spring_names = {spring.name for spring in elements.springs}
    assert all(sensor.of in own | spring_names for sensor in elements.sensors)
    assert all({fluid.pump, fluid.turbine} <= own for fluid in elements.fluids)
    for element in (*elements.frictions, *elements.springs, *elements.fluids):
        assert element.name == "part" or element.name.startswith("part.")


@pytest.mark.parametrize("name", CASES)
def test_elements_use_declared_parameters_and_all_of_them(name: str) -> None:
    component = case(name)
    elements = component.elements("part")
    used = set().union(*(sp.sympify(expression).free_symbols for expression in expressions_of(elements)))
    assert used == {parameter.symbol for parameter in component.parameters("part")}


@pytest.mark.parametrize("name", CASES)
def test_two_of_a_kind_share_nothing(name: str) -> None:
    component = case(name)
    names = [{owner for owner, _ in rows_of(component.elements(part))} for part in ("a", "b")]
    symbols = [{parameter.symbol for parameter in component.parameters(part)} for part in ("a", "b")]
    assert not names[0] & names[1]
    assert not symbols[0] & symbols[1]


@pytest.mark.parametrize("name", TYPES)
def test_component_cannot_be_changed(name: str) -> None:
    component = example(name)
    field = next(key for key in EXAMPLES[name] if key != "type")
    with pytest.raises(ValidationError, match="frozen"):
        setattr(component, field, 1.0)


@pytest.mark.parametrize("name", TYPES)
def test_unknown_field_is_refused(name: str) -> None:
    with pytest.raises(ValidationError, match="extra"):
        example(name, colour="red")


def quantities(component: Component) -> list[tuple[str, str, bool, bool]]:
    found = []
    for field in type(component).model_fields:
        for parameter in component.parameters("p"):
            if parameter.symbol.name == f"p_{field}":
                found.append((field, parameter.unit, parameter.positive, parameter.signed))
    return found


@pytest.mark.parametrize(
    ("name", "field", "unit", "positive", "signed"),
    [(name, *quantity) for name in TYPES for quantity in quantities(example(name))],
)
def test_range_of_every_quantity_is_checked(name: str, field: str, unit: str, positive: bool, signed: bool) -> None:
    zero = f"0 {unit}".strip() if unit else 0
    negative = f"-1 {unit}".strip() if unit else -1
    if positive:
        with pytest.raises(ValidationError, match="must"):
            example(name, **{field: zero})
    else:
        assert getattr(example(name, **{field: zero}), field) == 0
    if signed:
        assert getattr(example(name, **{field: negative}), field) == -1
    else:
        with pytest.raises(ValidationError, match="must"):
            example(name, **{field: negative})
    if unit:
        with pytest.raises(ValidationError, match="must"):
            example(name, **{field: "3 furlong"})


def has_own_inertia(name: str) -> bool:
    return not name.startswith(("shaft", "torque_flange"))


@pytest.mark.parametrize("name", list(filter(has_own_inertia, CASES)))
def test_component_alone_has_positive_definite_inertia(name: str) -> None:
    model = loose_model(case(name))
    mass = model.mass.subs(model.values)
    assert mass.is_symmetric()
    assert mass.is_positive_definite


RUBBING = [name for name in CASES if case(name).elements("x").frictions]


@pytest.mark.parametrize("name", RUBBING)
def test_friction_takes_exactly_torque_times_slip(name: str) -> None:
    """The kinetic energy, from bodies and velocities, changes by minus the friction power."""
    component = case(name)
    elements = component.elements("x")
    model = loose_model(component)
    z = sp.Matrix(sp.symbols(f"z0:{len(model.coordinates)}"))
    T = sp.Matrix(sp.symbols(f"T0:{len(elements.frictions)}"))
    rate = model.accelerations().f[:, : len(T)] * T
    velocity = {name: (row * z)[0] for name, row in model.velocity_rows.items()}
    slope = {name: (row * rate)[0] for name, row in model.velocity_rows.items()}
    energy_rate = sum(body.inertia * velocity[body.velocity] * slope[body.velocity] for body in elements.bodies)
    slip = [sum(value * velocity[key] for key, value in friction.row.items()) for friction in elements.frictions]
    power = sum(torque * speed for torque, speed in zip(T, slip, strict=True))
    assert sp.cancel(sp.together(energy_rate + power)) == 0


@pytest.mark.parametrize("name", RUBBING)
@given(w=st.floats(-300, 300), angle=st.floats(-10, 10), load=st.floats(-500, 500), actuation=st.floats(0, 1))
def test_friction_only_takes_power(name: str, w: float, angle: float, load: float, actuation: float) -> None:
    """And at rest it holds at least what it has when it begins to slip."""
    component = case(name)
    values = {parameter.symbol: parameter.value for parameter in component.parameters("x")}
    for friction in component.elements("x").frictions:
        if friction.one_way:
            w = -abs(w)
        assert torque_of(friction, values, w, angle, load, actuation) * w >= 0
        beginning = torque_of(friction, values, 1e-9, angle, load, actuation)
        assert abs(beginning) <= limit_of(friction, values, angle, load, actuation) * (1 + 1e-6) + 1e-6


@pytest.mark.parametrize("name", RUBBING)
def test_locked_friction_leaves_one_motion_less(name: str) -> None:
    model = loose_model(case(name))
    for friction in model.frictions:
        locked = loose_model(case(name), locked={friction.name})
        assert len(locked.coordinates) == len(model.coordinates) - 1

"""One valid example of every component, and the model of a component that stands alone."""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.elements import Drive, Torque
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model

RIPPLE = {"amplitude": 0.1, "order": 2, "phase": "-30 deg"}
SATURATION = {"slope": "0.5 N m s/rad", "speed": "10 rad/s"}
FRICTIONS = {
    "loss": {"coulomb": "2 N m", "load": 0.01, "viscous": "0.1 N m s/rad"},
    "limited_slip": {
        "coulomb": "20 N m",
        "load": 0.1,
        "viscous": "0.2 N m s/rad",
        "saturation": SATURATION,
        "ripple": RIPPLE,
    },
}
STRIBECK = {"static": "360 N m", "stribeck_speed": "20 rpm", "viscous": "0.1 N m s/rad"}

EXAMPLES: dict[str, dict[str, object]] = {
    "machine": {
        "inertia": "1 kg m^2",
        "torque_max": "500 N m",
        "speed_rated": "3000 rpm",
        "speed_max": "6000 rpm",
        "inverter": {"model": "lag", "dead_time": "100 us", "time_constant": "250 us"},
        "sensor": {"time_constant": "100 us"},
    },
    "inertia": {"inertia": "0.2 kg m^2"},
    "shaft": {"stiffness": "50 kN m/rad", "damping": "2 N m s/rad"},
    "torque_flange": {
        "inertia": "0.03 kg m^2",
        "inertia_machine": "0.02 kg m^2",
        "stiffness": "380 kN m/rad",
        "damping": "0.5 N m s/rad",
        "sensor": {"time_constant": "50 us"},
    },
    "gearbox": {"ratio": 8.1, "inertia": "1.05 kg m^2"},
    "single_clutch_gearbox": {
        "inertia_input": "0.13 kg m^2",
        "inertia_output": "0.4 kg m^2",
        "ratio": 3.333,
        "clutch": {"capacity": "500 N m", **STRIBECK, "static": "600 N m", "saturation": SATURATION, "ripple": RIPPLE},
    },
    "double_clutch_gearbox": {
        "inertia_input": "0.13 kg m^2",
        "inertia_output": "0.4 kg m^2",
        "ratio1": 5.503,
        "ratio2": 3.333,
        "clutch1": {"capacity": "300 N m", **STRIBECK},
        "clutch2": {"capacity": "500 N m", "viscous": "0.1 N m s/rad", "ripple": RIPPLE},
    },
    "clutch": {
        "inertia_input": "0.02 kg m^2",
        "inertia_output": "0.03 kg m^2",
        "capacity": "300 N m",
        **STRIBECK,
        "saturation": SATURATION,
        "ripple": RIPPLE,
    },
    "torque_converter": {
        "inertia_pump": "0.1 kg m^2",
        "inertia_turbine": "0.05 kg m^2",
        "reference_speed": "2000 rpm",
        "drive": {
            "speed_ratio": [0, 0.2, 0.4, 0.6, 0.8, 0.9, 1],
            "torque_ratio": [2, 1.75, 1.5, 1.25, 1.02, 1, 1],
            "pump_torque": ["180 N m", "185 N m", "180 N m", "165 N m", "130 N m", "80 N m", "0 N m"],
        },
        "lockup": {"capacity": "300 N m", **STRIBECK, "saturation": SATURATION, "ripple": RIPPLE},
    },
    "freewheel": {
        "inertia_input": "0.02 kg m^2",
        "inertia_output": "0.03 kg m^2",
        "drag": "0.5 N m",
        "viscous": "0.01 N m s/rad",
    },
    "brake": {"inertia": "0.1 kg m^2", "capacity": "300 N m", **STRIBECK, "ripple": RIPPLE},
    "bearing": {
        "inertia": "0.01 kg m^2",
        "coulomb": "1 N m",
        "static": "2 N m",
        "stribeck_speed": "10 rpm",
        "viscous": "0.01 N m s/rad",
        "saturation": SATURATION,
        "ripple": RIPPLE,
    },
    "differential": {
        "ratio": 2.85,
        "inertia": "0.3 kg m^2",
        "inertia_pinion": "1.5 kg m^2",
        "pinion_ratio": 0.8,
        **FRICTIONS,
    },
    "bevel_differential": {
        "ratio": 2.85,
        "radius_output1": "80 mm",
        "radius_output2": "60 mm",
        "radius_pinion": "50 mm",
        "inertia_drive": "0.02 kg m^2",
        "inertia_cage": "0.3 kg m^2",
        "inertia_output1": "0.05 kg m^2",
        "inertia_output2": "0.04 kg m^2",
        "inertia_pinion": "0.01 kg m^2",
        **FRICTIONS,
    },
    "planetary_set": {
        "ratio": 2.13,
        "inertia_sun": "0.002 kg m^2",
        "inertia_ring": "0.01 kg m^2",
        "inertia_carrier": "0.008 kg m^2",
        "inertia_planets": "0.0005 kg m^2",
        "loss": {"load": 0.02, "viscous": "0.01 N m s/rad"},
    },
    "gear_pair": {
        "ratio": 2.6,
        "inertia_input": "0.002 kg m^2",
        "inertia_output": "0.01 kg m^2",
        "loss": {"load": 0.01, "coulomb": "0.2 N m"},
    },
    "synchroniser": {
        "cone": "60 N m",
        "dog": "900 N m",
        "inertia_input": "0.002 kg m^2",
        "inertia_output": "0.003 kg m^2",
    },
    "epicyclic_differential": {
        "radius_ring": "90 mm",
        "radius_sun": "40 mm",
        "planets": 3,
        "inertia_carrier": "0.1 kg m^2",
        "inertia_ring": "0.05 kg m^2",
        "inertia_sun": "0.02 kg m^2",
        "inertia_planet": "0.004 kg m^2",
        **FRICTIONS,
    },
}

MESH = {
    "inertia_other": "0.4 kg m^2",
    "mesh_stiffness": "800 kN m/rad",
    "mesh_damping": "3 N m s/rad",
}

REVERSE = {
    "speed_ratio": [-1, -0.5, 0],
    "torque_ratio": [1.2, 1.8, 2],
    "pump_torque": ["230 N m", "200 N m", "180 N m"],
}
COAST = {
    "speed_ratio": [0, 0.5, 0.9, 1],
    "turbine_torque": ["150 N m", "120 N m", "60 N m", "0 N m"],
    "torque_ratio": [0.8, 0.9, 0.95, 1],
}

VARIANTS: dict[str, tuple[str, dict[str, object]]] = {
    "shaft with backlash": ("shaft", {"backlash": "0.5 deg"}),
    "gearbox with elastic teeth": ("gearbox", MESH),
    "gearbox with play": ("gearbox", {**MESH, "play": "0.1 deg", "inertia_side": "output"}),
    "gearbox with two inertias": ("gearbox", {"inertia_other": "0.4 kg m^2"}),
    "planetary set by teeth": ("planetary_set", {"ratio": None, "teeth": {"sun": 46, "ring": 98}, "loss": None}),
    "double-pinion planetary set": ("planetary_set", {"pinions": "double", "inertia_planets": None}),
    "gear pair by teeth": ("gear_pair", {"ratio": None, "teeth": {"input": 20, "output": 53}, "reversing": False}),
    "gearbox with a clutch and gears": ("single_clutch_gearbox", {"gears": {"1": 5.503, "2": 3.333, "R": -3.403}}),
    "gearbox with two clutches and gears": (
        "double_clutch_gearbox",
        {"gears": {"1": 5.503, "2": 3.333}, "ratio_range": [-4, 6]},
    ),
    "dry clutch": ("clutch", {"static": None, "stribeck_speed": None, "ripple": None, "saturation": None}),
    "clutch with a static limit": ("clutch", {"stribeck_speed": None}),
    "clutch that is always pressed": ("clutch", {"actuated": False}),
    "torque converter without lock-up": ("torque_converter", {"lockup": None}),
    "torque converter with all maps": ("torque_converter", {"reverse": REVERSE, "coast": COAST}),
    "brake that is always pressed": ("brake", {"actuated": False}),
}
"""Examples with other fields of a type than the one in `EXAMPLES`."""

CASES = (*EXAMPLES, *VARIANTS)
"""The names of all examples, see `case`."""


def case(name: str) -> Component:
    """Return the example of a type, or a variant of it."""
    type_name, changes = VARIANTS.get(name, (name, {}))
    return example(type_name, **changes)


def example(type_name: str, **changes: object) -> Component:
    """Return the example of a component type; a change to None removes the field."""
    fields = {"type": type_name, **EXAMPLES[type_name], **changes}
    given = {key: value for key, value in fields.items() if value is not None}
    return CATALOGUE[type_name].model_validate(given)


def loose_model(component: Component, name: str = "x", locked: Collection[str] = ()) -> Model:
    """Return the model of a component alone; the inputs are torques on its flanges, in their order."""
    elements = component.elements(name)
    flanges = [f"{name}.{flange}" for flange in component.flange_names()]
    zero = sp.Integer(0)
    drive = Drive(torque_max=zero, speed_rated=zero, speed_max=zero)
    mechanism = Mechanism(
        name="loose",
        velocities=(*flanges, *elements.internal),
        bodies=elements.bodies,
        constraints=elements.constraints,
        springs=elements.springs,
        frictions=elements.frictions,
        torques=tuple(Torque(flange, {flange: sp.Integer(1)}, drive) for flange in flanges),
        sensors=(),
        places=(),
        parameters=component.parameters(name),
        connections={},
        orientation={name: 1},
        observed=(),
        fluids=elements.fluids,
    )
    return assemble(mechanism.with_locked_frictions(set(locked), holding_ratios=True))


def symbols_of(component: Component, name: str = "x") -> dict[str, sp.Symbol]:
    """Return the parameter symbols of a component by field name."""
    return {p.symbol.name.removeprefix(f"{name}_"): p.symbol for p in component.parameters(name)}


def is_zero(value: sp.Expr | sp.Matrix) -> bool:
    """Tell whether a rational expression, or every entry of a matrix, is identically zero."""
    entries = list(value) if isinstance(value, sp.MatrixBase) else [value]
    return all(sp.cancel(sp.together(entry)) == 0 for entry in entries)

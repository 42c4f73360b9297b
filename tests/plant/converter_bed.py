"""Torque converters: one between two machines, and one alone with a torque on each wheel."""

from __future__ import annotations

from pathlib import Path

import sympy as sp
from plant.small_beds import two_machines

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.elements import Drive, Torque
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model
from ptgen.project import Project

__all__ = ["FILE", "converter", "converter_bed", "converter_model"]

MAPS = {
    "drive": {
        "speed_ratio": [0, 0.2, 0.4, 0.6, 0.8, 0.9, 1],
        "torque_ratio": [2, 1.75, 1.5, 1.25, 1.02, 1, 1],
        "pump_torque": ["180 N m", "185 N m", "180 N m", "165 N m", "130 N m", "80 N m", "0 N m"],
    },
    "coast": {
        "speed_ratio": [0, 0.5, 0.9, 1],
        "turbine_torque": ["150 N m", "120 N m", "60 N m", "0 N m"],
        "torque_ratio": [0.8, 0.9, 0.95, 1],
    },
    "reverse": {
        "speed_ratio": [-1, -0.5, 0],
        "torque_ratio": [1.2, 1.8, 2],
        "pump_torque": ["230 N m", "200 N m", "180 N m"],
    },
}

FILE = """
[components.tc]
type = "torque_converter"
inertia_pump = "0.1 kg m^2"
inertia_turbine = "0.05 kg m^2"
reference_speed = "2000 rpm"
lockup = { capacity = "400 N m" }
""" + "\n".join(
    f"{name} = {{ {', '.join(f'{key} = {values}' for key, values in table.items())} }}" for name, table in MAPS.items()
).replace("'", '"')


def converter_bed(folder: Path, place: str = "flange1") -> Project:
    """Return a bed of two machines with a converter between them; its controller takes the lock-up for locked."""
    reduction = '[reduction]\nlocked = ["tc.lockup"]\ndrop = ["tc"]\n'
    return two_machines(folder, "flange1 - tc - shaft1", f"{FILE}\n{reduction}", place=place)


def converter(**changes: object) -> Component:
    """Return a converter with all maps and a lock-up clutch."""
    fields = {
        "type": "torque_converter",
        "inertia_pump": "0.1 kg m^2",
        "inertia_turbine": "0.05 kg m^2",
        "reference_speed": "2000 rpm",
        "lockup": {"capacity": "400 N m"},
        **MAPS,
        **changes,
    }
    return CATALOGUE["torque_converter"].model_validate({k: v for k, v in fields.items() if v is not None})


def converter_model(component: Component) -> Model:
    """Return the model of a converter alone; the torque P drives the pump, the torque T the turbine."""
    elements, most = component.elements("tc"), sp.Integer(10**6)
    drive = Drive(torque_max=most, speed_rated=most, speed_max=most)
    one = sp.Integer(1)
    torques = (Torque("P", {"tc.pump": one}, drive), Torque("T", {"tc.turbine": one}, drive))
    mechanism = Mechanism(
        name="loose",
        velocities=("tc.pump", "tc.turbine"),
        bodies=elements.bodies,
        constraints=(),
        springs=(),
        frictions=elements.frictions,
        torques=torques,
        sensors=(),
        places=(),
        parameters=component.parameters("tc"),
        connections={},
        orientation={"tc": 1},
        observed=(),
        fluids=elements.fluids,
    )
    return assemble(mechanism)

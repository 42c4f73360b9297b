"""The one list of component types; adding a component means adding a line here."""

from __future__ import annotations

from ptgen.components.bearing import Bearing
from ptgen.components.bevel_differential import BevelDifferential
from ptgen.components.brake import Brake
from ptgen.components.clutch import Clutch
from ptgen.components.component import Component
from ptgen.components.differential import Differential
from ptgen.components.epicyclic_differential import EpicyclicDifferential
from ptgen.components.freewheel import Freewheel
from ptgen.components.gearbox import Gearbox
from ptgen.components.inertia import Inertia
from ptgen.components.machine import Machine
from ptgen.components.shaft import Shaft
from ptgen.components.torque_flange import TorqueFlange

__all__ = ["CATALOGUE"]

_TYPES: tuple[type[Component], ...] = (
    Machine,
    Inertia,
    Shaft,
    TorqueFlange,
    Gearbox,
    Clutch,
    Freewheel,
    Brake,
    Bearing,
    Differential,
    BevelDifferential,
    EpicyclicDifferential,
)

CATALOGUE: dict[str, type[Component]] = {component.type_name: component for component in _TYPES}

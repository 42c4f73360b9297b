"""The one list of component types; adding a component means adding a line here.

A part, `ptgen.components.part`, is none of them: it is an assembly of components from a file of its own.
"""

from __future__ import annotations

from ptgen.components.bearing import Bearing
from ptgen.components.bevel_differential import BevelDifferential
from ptgen.components.brake import Brake
from ptgen.components.clutch import Clutch
from ptgen.components.component import Component
from ptgen.components.differential import Differential
from ptgen.components.double_clutch_gearbox import DoubleClutchGearbox
from ptgen.components.epicyclic_differential import EpicyclicDifferential
from ptgen.components.freewheel import Freewheel
from ptgen.components.gear_pair import GearPair
from ptgen.components.gearbox import Gearbox
from ptgen.components.inertia import Inertia
from ptgen.components.machine import Machine
from ptgen.components.planetary_set import PlanetarySet
from ptgen.components.shaft import Shaft
from ptgen.components.single_clutch_gearbox import SingleClutchGearbox
from ptgen.components.synchroniser import Synchroniser
from ptgen.components.torque_converter import TorqueConverter
from ptgen.components.torque_flange import TorqueFlange

__all__ = ["CATALOGUE"]

_TYPES: tuple[type[Component], ...] = (
    Machine,
    Inertia,
    Shaft,
    TorqueFlange,
    Gearbox,
    SingleClutchGearbox,
    DoubleClutchGearbox,
    Clutch,
    TorqueConverter,
    Freewheel,
    Brake,
    Bearing,
    Differential,
    BevelDifferential,
    EpicyclicDifferential,
    PlanetarySet,
    GearPair,
    Synchroniser,
)

CATALOGUE: dict[str, type[Component]] = {component.type_name: component for component in _TYPES}

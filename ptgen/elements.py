"""The elements that components contribute: all that the mechanics ever sees of them.

A `Row` gives the coefficients of a relative velocity, ``{velocity name: coefficient}``. A row also says how
a torque acts: by virtual power, a torque ``T`` on a row ``r`` exerts ``r' T`` on the velocities.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

import sympy as sp

__all__ = [
    "Body",
    "Constraint",
    "Drive",
    "Elements",
    "Friction",
    "FrictionRole",
    "Load",
    "Parameter",
    "Place",
    "Row",
    "Sensor",
    "SensorKind",
    "Spring",
    "Torque",
]

Row = Mapping[str, sp.Expr]


@dataclass(frozen=True)
class Parameter:
    """A number of the bed that can be changed in the emitted code.

    Attributes
    ----------
    symbol : sympy.Symbol
        Its symbol, named ``<component>_<field>``.
    value : float
        Its value in `unit`.
    unit : str
        SI unit.
    description : str
        One line.
    positive : bool
        Whether zero is forbidden.
    signed : bool
        Whether negative values are allowed.
    """

    symbol: sp.Symbol
    value: float
    unit: str
    description: str
    positive: bool = False
    signed: bool = False


@dataclass(frozen=True)
class Body:
    """An inertia (kg m^2) on a velocity."""

    velocity: str
    inertia: sp.Expr


@dataclass(frozen=True)
class Constraint:
    """A relation ``row . v = 0`` that always holds; `owner` is the component."""

    owner: str
    row: Row


@dataclass(frozen=True)
class Spring:
    """A Kelvin-Voigt compliance on the twist rate ``row . v`` (source (3.4)).

    Its torque is ``stiffness * twist + damping * (row . v)`` and acts as ``-row' T``.
    """

    name: str
    row: Row
    stiffness: sp.Expr
    damping: sp.Expr


class FrictionRole(Enum):
    """What a friction element is there for; the reduction treats the roles differently."""

    LOSS = "loss"
    LIMITED_SLIP = "limited slip"


@dataclass(frozen=True)
class Load:
    """Dependence of a friction capacity on the torque at a flange: ``coefficient * |T(place)|``."""

    coefficient: sp.Expr
    place: str


@dataclass(frozen=True)
class Friction:
    """A set-valued torque on the relative velocity ``w = row . v``.

    While it slips, ``T = capacity * sign(w) + viscous * w``; while it sticks, ``w = 0`` and ``|T| <= capacity``
    with ``capacity = coulomb + load.coefficient * |T(load.place)|`` (source (3.34), (3.35)).
    """

    name: str
    row: Row
    coulomb: sp.Expr
    viscous: sp.Expr
    role: FrictionRole
    load: Load | None = None


@dataclass(frozen=True)
class Drive:
    """How an electric drive turns its torque reference into air-gap torque.

    Attributes
    ----------
    torque_max, speed_rated, speed_max : sympy.Expr
        The envelope: full torque up to the rated speed, then constant power (N m, rad/s, rad/s).
    time_constant : sympy.Expr or None
        First-order lag (s); None for an ideal inverter.
    dead_time : sympy.Expr or None
        Dead time (s); None for an ideal inverter.
    """

    torque_max: sp.Expr
    speed_rated: sp.Expr
    speed_max: sp.Expr
    time_constant: sp.Expr | None = None
    dead_time: sp.Expr | None = None


@dataclass(frozen=True)
class Torque:
    """The air-gap torque of a machine, acting on ``row``; `name` is the machine."""

    name: str
    row: Row
    drive: Drive


class SensorKind(Enum):
    """What a sensor measures."""

    SPEED = "speed"
    TORQUE = "torque"


@dataclass(frozen=True)
class Sensor:
    """A measured signal: the speed of a velocity, or the torque of a spring, named in `of`."""

    name: str
    kind: SensorKind
    of: str


@dataclass(frozen=True)
class Place:
    """A named sum of flange torques, such as the outputs of a differential: ``{flange: coefficient}``."""

    name: str
    flanges: Mapping[str, int]


@dataclass(frozen=True)
class Elements:
    """Everything that one component contributes; velocities are named ``<component>.<flange>``."""

    bodies: tuple[Body, ...] = ()
    constraints: tuple[Constraint, ...] = ()
    springs: tuple[Spring, ...] = ()
    frictions: tuple[Friction, ...] = ()
    torques: tuple[Torque, ...] = ()
    sensors: tuple[Sensor, ...] = ()
    places: tuple[Place, ...] = ()
    internal: tuple[str, ...] = field(default=())

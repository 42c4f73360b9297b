"""The elements that components contribute: all that the mechanics ever sees of them.

A `Row` gives the coefficients of a relative velocity, ``{velocity name: coefficient}``. A row also says how
a torque acts: by virtual power, a torque ``T`` on a row ``r`` exerts ``r' T`` on the velocities.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

import sympy as sp

__all__ = [
    "Body",
    "Constraint",
    "Drive",
    "Elements",
    "FluidCoupling",
    "FluidSector",
    "Friction",
    "FrictionRole",
    "Load",
    "Parameter",
    "Place",
    "Ripple",
    "Row",
    "Saturation",
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
    span : tuple of two floats, or None
        Least and largest value, if it changes while the bed runs: then it is an input of that name, and `value` holds
        at the start. None if it is constant.
    owner : str
        The component that it belongs to; empty for a parameter of the whole bed.
    """

    symbol: sp.Symbol
    value: float
    unit: str
    description: str
    positive: bool = False
    signed: bool = False
    span: tuple[float, float] | None = None
    owner: str = ""

    @property
    def key(self) -> str:
        """What is left of its name without that of its owner: its key in the file, with ``_`` between tables."""
        return str(self.symbol.name).removeprefix(f"{self.owner}_")


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

    Its torque is ``stiffness * twist + damping * (row . v)`` and acts as ``-row' T``. With a `backlash` the torque is
    zero in a gap of that width around the twist 0, and beyond it that of the rest of the twist (source (3.5)).
    """

    name: str
    row: Row
    stiffness: sp.Expr
    damping: sp.Expr
    backlash: sp.Expr | None = None


class FrictionRole(Enum):
    """What a friction element is there for; the reduction treats the roles differently."""

    LOSS = "loss"
    LIMITED_SLIP = "limited slip"
    COUPLING = "coupling"


@dataclass(frozen=True)
class Load:
    """Dependence of a friction capacity on the torque at a flange: ``coefficient * |T(place)|``."""

    coefficient: sp.Expr
    place: str


@dataclass(frozen=True)
class Saturation:
    """A torque that is linear in the velocity up to `speed` and constant beyond: ``slope * min(|w|, speed)``."""

    slope: sp.Expr
    speed: sp.Expr


@dataclass(frozen=True)
class Ripple:
    """Dependence of a capacity on the angle of its element: ``1 + amplitude * sin(order * angle + phase)``."""

    amplitude: sp.Expr
    order: int
    phase: sp.Expr


@dataclass(frozen=True)
class Friction:
    """A set-valued torque on the relative velocity ``w = row . v``.

    While it slips, ``T = capacity(w) * sign(w) + viscous * w`` with::

        capacity(w) = mu * (ripple * (coulomb + load * |T(place)| + (static - coulomb) * exp(-|w| / stribeck_speed))
                            + slope * min(|w|, speed))

    (source (3.12), (3.34), (3.35)). While it sticks, ``w = 0`` and ``|T|`` is at most
    ``mu * ripple * (static + load * |T(place)|)``.

    Attributes
    ----------
    name : str
    row : Row
    coulomb : sympy.Expr
        Kinetic capacity (N m).
    viscous : sympy.Expr
        Viscous friction (N m s/rad); that of an actuated element is scaled with the actuation like all the rest.
    role : FrictionRole
    load : Load or None
    static : sympy.Expr or None
        Capacity at rest (N m), not below `coulomb`; None if it is the same.
    stribeck_speed : sympy.Expr or None
        Velocity over which the capacity falls from `static` to `coulomb` (rad/s); None if it falls at once.
    saturated : Saturation or None
    ripple : Ripple or None
    actuated : bool
        Whether there is an input ``<name>_actuation``, mu = 0 to 1; otherwise mu = 1.
    one_way : bool
        Whether the element holds any positive torque, so that its velocity is never positive: a freewheel.
    """

    name: str
    row: Row
    coulomb: sp.Expr
    viscous: sp.Expr
    role: FrictionRole
    load: Load | None = None
    static: sp.Expr | None = None
    stribeck_speed: sp.Expr | None = None
    saturated: Saturation | None = None
    ripple: Ripple | None = None
    actuated: bool = False
    one_way: bool = False

    @property
    def linear_viscous(self) -> sp.Expr:
        """Viscous friction that is always there, so that it belongs to the linear part of the bed (N m s/rad)."""
        return sp.Integer(0) if self.actuated else self.viscous

    @property
    def at_rest(self) -> sp.Expr:
        """Capacity at rest without load, ripple and actuation (N m)."""
        return self.coulomb if self.static is None else self.static


@dataclass(frozen=True)
class FluidSector:
    """Torques of a fluid coupling where one wheel is the faster one: two curves over the other's share of its speed.

    Attributes
    ----------
    share : tuple of float (n,)
        Speed of the slower wheel over that of the faster one, strictly rising from -1 to 1.
    faster, slower : tuple of n - 1 tuples of float
        Torques at both wheels while the faster one turns at the reference speed (N m): from ``share[k]`` on the
        polynomial with the coefficients ``faster[k]``, up to four of them, and ``slower[k]``, up to seven, in rising
        powers of what is beyond ``share[k]``.
    """

    share: tuple[float, ...]
    faster: tuple[tuple[float, ...], ...]
    slower: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class FluidCoupling:
    r"""The torques of a fluid between a pump and a turbine, functions of both speeds.

    The faster wheel, of speed ``a``, decides on the sector and on the scale ``(a / reference_speed)^2`` of the curves.
    They give the torque ``T_p`` that the fluid takes from the pump, and ``T_t`` that it exerts on the turbine (source
    (3.40), (3.41)).

    Attributes
    ----------
    name : str
    pump, turbine : str
        The velocities.
    reference_speed : sympy.Expr
        Speed for which the curves are given (rad/s).
    sectors : tuple of four FluidSector
        In this order: the pump is faster and turns forward, the turbine is faster and turns forward, the pump is faster
        and turns backward, the turbine is faster and turns backward.
    """

    name: str
    pump: str
    turbine: str
    reference_speed: sp.Expr
    sectors: tuple[FluidSector, FluidSector, FluidSector, FluidSector]

    @property
    def rows(self) -> tuple[Row, Row]:
        """The rows on which ``T_p`` and ``T_t`` act like the torque of a friction element, as ``-row' T``."""
        return {self.pump: sp.Integer(1)}, {self.turbine: sp.Integer(-1)}


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
    computation_delay : sympy.Expr or None
        Time from the sampling of the sensors until the command that follows from them reaches the inverter (s); None
        if it takes none.
    """

    torque_max: sp.Expr
    speed_rated: sp.Expr
    speed_max: sp.Expr
    time_constant: sp.Expr | None = None
    dead_time: sp.Expr | None = None
    computation_delay: sp.Expr | None = None

    @property
    def delay(self) -> sp.Expr | None:
        """Time from the sampling of the sensors until a command acts: computation and dead time (s); None if none."""
        parts = [part for part in (self.dead_time, self.computation_delay) if part is not None]
        return sum(parts, sp.Integer(0)) if parts else None


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
    """A measured signal: the speed of a velocity, or the torque of a spring, named in `of`.

    With a `time_constant` (s) the signal passes a first-order low pass before it is measured.
    """

    name: str
    kind: SensorKind
    of: str
    time_constant: sp.Expr | None = None


@dataclass(frozen=True)
class Place:
    """A named sum of flange torques, such as the outputs of a differential: ``{flange: coefficient}``."""

    name: str
    flanges: Mapping[str, int]


@dataclass(frozen=True)
class Elements:
    """Everything that one component contributes; velocities are named ``<component>.<flange>``.

    `internal` are the velocities that are no flanges of it, and `connections` the pairs of velocities that are
    connected rigidly inside it; the left one drives the right one.
    """

    bodies: tuple[Body, ...] = ()
    constraints: tuple[Constraint, ...] = ()
    springs: tuple[Spring, ...] = ()
    frictions: tuple[Friction, ...] = ()
    torques: tuple[Torque, ...] = ()
    sensors: tuple[Sensor, ...] = ()
    places: tuple[Place, ...] = ()
    internal: tuple[str, ...] = ()
    connections: tuple[tuple[str, str], ...] = ()
    fluids: tuple[FluidCoupling, ...] = ()

"""What a test bed file says once it is checked: frozen, complete, in SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Literal

from pydantic import Field, field_validator

from ptgen.components.component import Component, Quantity, Record
from ptgen.elements import Friction, Parameter
from ptgen.testbed.feedback import LossMap, SpeedControl, SpeedControlName
from ptgen.testbed.gear_tables import GearTable, gear_tables, ratio_parameter
from ptgen.testbed.governor_settings import GovernorSettings

__all__ = ["Connection", "ReductionSettings", "Roles", "Structure", "Testbed", "Tuning"]

Structure = Literal["decoupling", "individual"]
"""Whether the machines are decoupled from each other, or each one works for its own quantity with active damping."""


@dataclass(frozen=True)
class Connection:
    """A rigid connection of two flanges; positive power flows from `left` to `right`.

    Attributes
    ----------
    left, right : str
        Flanges, such as ``"M1.shaft"`` and ``"flange1.machine"``.
    """

    left: str
    right: str


class Tuning(Record):
    """The wishes that a controller is designed for: section ``[control]`` without the roles.

    A bandwidth is written as ``"30 rad/s"`` or as ``"5 Hz"``.
    """

    structure: Structure = "decoupling"
    """Decoupling of all controlled quantities, or individual feedback with active damping, where that is impossible."""
    speed_bandwidth: Annotated[float, Quantity("rad/s", "bandwidth of the speed control")] = 30.0
    torque_bandwidth: Annotated[float, Quantity("rad/s", "bandwidth of the torque control")] = 20.0
    damping_ratio: Annotated[float, Quantity("", "wanted damping ratio of the torque poles (5.81)")] = 1.0
    feedforward: Annotated[float, Quantity("", "share of the torque reference that is fed forward", positive=False)] = (
        1.0
    )
    conventional_torque_bandwidth: (
        Annotated[float, Quantity("rad/s", "bandwidth of the torque control in the conventional controller")] | None
    ) = None
    fault_ramp: Annotated[float, Quantity("s", "time in which the torque is taken to zero after a fault")] = 0.05
    hold_time: Annotated[
        float, Quantity("s", "time for which bad samples are bridged before it is a fault", positive=False)
    ] = 0.001
    frozen_time: Annotated[
        float, Quantity("s", "time for which a frozen signal stays the same before it can be a fault")
    ] = 0.01
    inertia_estimate: dict[str, Annotated[float, Quantity("kg m^2", "inertia used for the acceleration torque")]] = (
        Field(default_factory=dict)
    )
    """Inertias that the acceleration torque of a machine is computed with; by default they are derived."""
    damping_reserve: Annotated[
        float, Quantity("", "share of the available torque that is kept for active damping", positive=False)
    ] = 0.1
    speed_control: SpeedControl = "pi"
    """Of all machines, or a table machine = kind: "pi" (5.84), "observer" (5.92), experimental: "super_twisting"."""
    observer_bandwidth: (
        Annotated[float, Quantity("rad/s", "bandwidth of the disturbance observer of the speed control (5.88)")] | None
    ) = None
    torque_gain: Annotated[
        float, Quantity("", "proportional gain of the torque control (5.99)", positive=False, signed=True)
    ] = 0.0
    delay_margin: (
        Annotated[float, Quantity("s", "additional delay that tune leaves room for", positive=False)] | None
    ) = None
    """Of each machine alone and of all together; by default three sample times."""
    disk_margin: Annotated[float, Quantity("", "disk margin that tune leaves", positive=False)] = 0.05
    """Below 2; at 0.05 every torque may be wrong by 5 % and 2.9 deg, each in its own way."""
    switch_time: Annotated[float, Quantity("s", "time in which a switch or a damping follows a change")] = 0.5
    speed_rate: Annotated[float, Quantity("rad/s^2", "largest rate of a speed reference")] | None = None
    torque_rate: Annotated[float, Quantity("N m/s", "largest rate of a torque reference")] | None = None
    speed_pairs: dict[str, tuple[str, ...]] = Field(default_factory=dict)
    """Name = two machines whose speed references are given as mean and difference, such as rear = ["M2", "M3"]."""
    losses: dict[str, LossMap] = Field(default_factory=dict)
    """Known loss torques: for each component a table with its speeds and torques (5.96)."""

    @field_validator("torque_gain")
    @classmethod
    def _above_minus_one(cls, value: float) -> float:
        if value <= -1:
            raise ValueError(f"must be above -1, got {value:g}; below, the torque loop has no stable gain (5.115a)")
        return value

    @field_validator("disk_margin")
    @classmethod
    def _below_two(cls, value: float) -> float:
        if value >= 2:
            raise ValueError(f"must be below 2, got {value:g}; no loop that does anything has a disk margin of 2")
        return value

    def speed_control_of(self, machine: str) -> SpeedControlName:
        """Return the kind of the speed control of a machine."""
        if isinstance(self.speed_control, str):
            return self.speed_control
        return self.speed_control.get(machine, "pi")

    @field_validator("feedforward")
    @classmethod
    def _at_most_two(cls, value: float) -> float:
        if value > 2:
            raise ValueError(f"must be 2 or less, got {value:g}; 1 feeds the whole torque reference forward")
        return value

    @field_validator("damping_ratio")
    @classmethod
    def _at_most_ten(cls, value: float) -> float:
        if value > 10:
            raise ValueError(f"must be 10 or less, got {value:g}; 1 is critical damping (5.81), more is only slower")
        return value

    @field_validator("damping_reserve")
    @classmethod
    def _share(cls, value: float) -> float:
        if value >= 1:
            raise ValueError(f"must be below 1, got {value:g}; it is a share of the available torque")
        return value


class ReductionSettings(Record):
    """How the model is reduced: section ``[reduction]``."""

    inertia_share: Annotated[
        float,
        Quantity("", "an inertia below this share of the kinetic energy of the kept modes is dropped", positive=False),
    ] = 0.05
    stiffness_share: Annotated[
        float,
        Quantity("", "a shaft below this share of the strain energy of the kept modes may be rigid", positive=False),
    ] = 0.02
    rigid: tuple[str, ...] = ()
    """Components that are made rigid in any case."""
    keep: tuple[str, ...] = ()
    """Components whose inertia and compliance are kept in any case."""
    drop: tuple[str, ...] = ()
    """Components whose inertia is dropped in any case."""
    locked: tuple[str, ...] = ()
    """Friction elements that the controller may take for locked, such as "clutch1" or "diff.limited_slip"."""
    as_ratio: tuple[str, ...] = ()
    """Components, such as transmissions, in whose place control sees a ratio that changes at run time."""
    gear_ratios: dict[str, dict[str, Annotated[float, Quantity("", "ratio of a gear", signed=True)]]] = Field(
        default_factory=dict
    )
    """Gears of components of as_ratio, such as gears = { 1 = 4.7, 2 = 3.1 }, if they are not to be their own."""
    design_gear: dict[str, str] = Field(default_factory=dict)
    """Gear in which control is designed, such as gears = "2"; by default the first that does not reverse the sense."""


@dataclass(frozen=True)
class Roles:
    """Which machine controls what.

    Attributes
    ----------
    torque : mapping of str to str
        Machine -> the place where its torque reference holds: a flange (``"diff.input"``), a sum of flanges
        (``"diff.outputs"``), or a shaft or torque flange (``"flange1"``).
    speed : tuple of str
        The machines that control their own speed.
    """

    torque: Mapping[str, str]
    speed: tuple[str, ...]


@dataclass(frozen=True)
class Testbed:
    """A checked test bed.

    Attributes
    ----------
    name : str
        The bed's name, a C identifier: the prefix of everything that is emitted.
    title : str
        What it is called in reports.
    file : str
        The file that it was read from.
    digest : str
        SHA-256 of the bytes of that file, in hexadecimal.
    sample_time : float
        Sampling time of the controller (s).
    components : mapping of str to Component
        In the order of the file.
    connections : tuple of Connection
        In the order of the chains.
    orientation : mapping of str to int
        +1 if the chains pass a two-flange component from its first to its second flange, -1 if the other way
        round; +1 for all other components.
    roles : Roles
        Which machine controls what.
    tuning : Tuning
        What the controller is designed for.
    reduction : ReductionSettings
        How the model is reduced.
    assumed : tuple of str
        Keys of the file whose values are assumed rather than measured.
    computation_delay : float
        Time from the sampling of the sensors until the command that follows from them reaches the inverters (s).
    governor : GovernorSettings
        What keeps the references within what the machines can do.
    """

    __test__ = False  # the name begins with Test, but it is no test case

    name: str
    title: str
    file: str
    digest: str
    sample_time: float
    components: Mapping[str, Component]
    connections: tuple[Connection, ...]
    orientation: Mapping[str, int]
    roles: Roles
    tuning: Tuning
    reduction: ReductionSettings
    assumed: tuple[str, ...] = ()
    computation_delay: float = 0.0
    governor: GovernorSettings = field(default_factory=GovernorSettings)

    @property
    def machines(self) -> tuple[str, ...]:
        """The names of the machines, in the order of the file."""
        return tuple(name for name, component in self.components.items() if component.is_machine)

    @cached_property
    def frictions(self) -> tuple[Friction, ...]:
        """The friction elements of all components, in the order of the file."""
        return tuple(f for name, component in self.components.items() for f in component.elements(name).frictions)

    @cached_property
    def ratios(self) -> dict[str, Parameter]:
        """The ratios that change at run time: of gearboxes in the order of the file, and those for control alone.

        The key is the name of the gearbox, ``gearbox1``, for its ``ratio``; others have a dot, ``gearbox1.ratio2``.
        """
        parameters = [p for name, component in self.components.items() for p in component.parameters(name)]
        changing = {p.owner if p.key == "ratio" else f"{p.owner}.{p.key}": p for p in parameters if p.span is not None}
        for name, table in self.gear_tables.items():
            parameter = ratio_parameter(table)
            if parameter is not None:
                changing.setdefault(name, parameter)
        return changing

    @cached_property
    def gear_tables(self) -> dict[str, GearTable]:
        """The gears of the components that are ratios for control, by their names."""
        settings = self.reduction
        return gear_tables(self.components, settings.as_ratio, settings.gear_ratios, settings.design_gear)

    @cached_property
    def actuated(self) -> tuple[str, ...]:
        """The names of the friction elements that a scenario can actuate, in the order of the file."""
        return tuple(friction.name for friction in self.frictions if friction.actuated)

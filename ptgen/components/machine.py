r"""Electric machine: the rotor, the inverter's torque loop, and the torque-speed envelope.

Flanges
    ``shaft``: the rotor. The air-gap torque is positive when it accelerates the rotor in the positive sense,
    whichever end of a chain the machine stands at.
Parameters
    see `Machine` and `Inverter`.
Equations
    .. math:: I_m \dot\omega = T_{ag} - T_s \qquad (3.3)

    Inverter, model ``lag``: :math:`\tau \dot T_{ag} + T_{ag} = T_{ag,ref}(t - t_d)`; model ``ideal``:
    :math:`T_{ag} = T_{ag,ref}`. The reference is limited to the envelope first: `torque_max` up to
    `speed_rated`, constant power above (source, Figure 7.1).

    With a `sensor` the measured speed :math:`y` follows that of the rotor: :math:`\tau \dot y + y = \omega`.
Assumptions
    Stiff rotor; no iron or windage losses; the torque loop is the same at every speed, which holds until the
    inverter runs out of voltage (source, Section 3.2, Figure 3.4).
Reference
    (3.3) and Section 3.2; dead time and lag as in Section 3.10; filters, Section 2.3.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import model_validator

from ptgen.components.component import Component, Flange, Quantity, Record
from ptgen.components.sensor_partial import SensorPartial
from ptgen.elements import Body, Drive, Elements, Sensor, SensorKind, Torque

__all__ = ["Inverter", "Machine"]


class Inverter(Record):
    """The torque loop of an inverter: ideal, or a dead time followed by a first-order lag."""

    model: Literal["ideal", "lag"]
    dead_time: Annotated[float, Quantity("s", "dead time of the torque loop", positive=False)] | None = None
    time_constant: Annotated[float, Quantity("s", "time constant of the torque loop")] | None = None

    @model_validator(mode="after")
    def _complete(self) -> Inverter:
        given = [key for key in ("dead_time", "time_constant") if getattr(self, key) is not None]
        if self.model == "ideal" and given:
            raise ValueError(f'an inverter with model = "ideal" takes no {given[0]}, or set model = "lag"')
        if self.model == "lag" and self.time_constant is None:
            raise ValueError('an inverter with model = "lag" needs a time_constant such as "250 us"')
        if self.model == "lag" and self.dead_time is None:
            raise ValueError('an inverter with model = "lag" needs a dead_time such as "100 us" (or "0 s")')
        return self


class Machine(Component):
    """An electric machine with its inverter."""

    type_name: ClassVar[str] = "machine"
    summary: ClassVar[str] = "electric machine with inverter and rotor"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("shaft"),)
    is_machine: ClassVar[bool] = True

    type: Literal["machine"]
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia of the rotor")]
    torque_max: Annotated[float, Quantity("N m", "largest air-gap torque up to the rated speed")]
    speed_rated: Annotated[float, Quantity("rad/s", "speed up to which the largest torque is available")]
    speed_max: Annotated[float, Quantity("rad/s", "largest admissible speed")]
    inverter: Inverter = Inverter(model="ideal")
    sensor: SensorPartial | None = None
    """The low pass of the encoder's speed; without it the sensor is ideal."""

    @model_validator(mode="after")
    def _ordered(self) -> Machine:
        if self.speed_max < self.speed_rated:
            raise ValueError("speed_max must not be below speed_rated; exchange them, or raise speed_max")
        return self

    def elements(self, name: str) -> Elements:
        shaft = f"{name}.shaft"
        lag = self.inverter.model == "lag"
        drive = Drive(
            torque_max=self.symbol(name, "torque_max"),
            speed_rated=self.symbol(name, "speed_rated"),
            speed_max=self.symbol(name, "speed_max"),
            time_constant=self.symbol(name, "inverter", "time_constant") if lag else None,
            dead_time=self.symbol(name, "inverter", "dead_time") if lag else None,
        )
        time_constant = None if self.sensor is None else self.symbol(name, "sensor", "time_constant")
        return Elements(
            bodies=(Body(shaft, self.symbol(name, "inertia")),),
            torques=(Torque(name, {shaft: sp.Integer(1)}, drive),),
            sensors=(Sensor(f"{name}_speed", SensorKind.SPEED, shaft, time_constant),),
        )

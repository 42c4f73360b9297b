r"""In-line torque sensor: a compliance, whose twist is what is measured, between two flange inertias.

Flanges
    ``machine`` faces the nearest machine, ``uut`` the unit under test; ptgen finds out from the connections
    which is which. The measured torque is positive when it drives the right-hand neighbour in the chain.
Equations
    .. math:: T_f = d_f (\omega_1 - \omega_f) + c_f (\varphi_1 - \varphi_f) \qquad (C.2)

    .. math:: I_f \dot\omega_f = T_f - T_s \qquad (C.3)

    With a `sensor` the measured torque :math:`y` follows the twist's torque: :math:`\tau \dot y + y = T_f`.
Assumptions
    Without a `sensor` the electronics is faster than the sampling; `inertia` is the part on the side of the unit under
    test, `inertia_machine` the part bolted to the machine.
Reference
    (C.2), (C.3), Section 2.3.1; filters, Section 2.3.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Component, Flange, Quantity
from ptgen.components.sensor_partial import SensorPartial
from ptgen.elements import Body, Elements, Sensor, SensorKind, Spring

__all__ = ["TorqueFlange"]


class TorqueFlange(Component):
    """An in-line torque sensor."""

    type_name: ClassVar[str] = "torque_flange"
    summary: ClassVar[str] = "in-line torque sensor"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("machine"), Flange("uut"))
    faces_machine: ClassVar[bool] = True

    type: Literal["torque_flange"]
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia on the side of the unit under test")]
    inertia_machine: Annotated[float, Quantity("kg m^2", "moment of inertia on the side of the machine")] | None = None
    stiffness: Annotated[float, Quantity("N m/rad", "torsional stiffness c_f")]
    damping: Annotated[float, Quantity("N m s/rad", "internal damping d_f", positive=False)] = 0.0
    sensor: SensorPartial | None = None
    """The low pass of the measured torque; without it the sensor is ideal."""

    def elements(self, name: str) -> Elements:
        machine, uut = f"{name}.machine", f"{name}.uut"
        bodies: tuple[Body, ...] = (Body(uut, self.symbol(name, "inertia")),)
        if self.inertia_machine is not None:
            bodies += (Body(machine, self.symbol(name, "inertia_machine")),)
        time_constant = None if self.sensor is None else self.symbol(name, "sensor", "time_constant")
        row = {machine: sp.Integer(1), uut: sp.Integer(-1)}
        return Elements(
            bodies=bodies,
            springs=(Spring(name, row, self.symbol(name, "stiffness"), self.symbol(name, "damping")),),
            sensors=(Sensor(f"{name}_torque", SensorKind.TORQUE, name, time_constant),),
        )

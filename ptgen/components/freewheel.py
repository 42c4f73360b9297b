r"""Freewheel, a one-way clutch: the input drives the output and is never faster than it.

Flanges
    ``input`` and ``output``. The torque is positive when the input drives the output.
Equations
    .. math:: I_i\,\dot\omega_i = T_i - T_f, \qquad I_o\,\dot\omega_o = T_f - T_o

    with :math:`\omega = \omega_i - \omega_o \le 0` always. It is engaged at :math:`\omega = 0`, where

    .. math:: T_f \ge -T_d

    takes the value that keeps :math:`\omega` there; it overruns at :math:`\omega < 0` with the drag

    .. math:: T_f = -T_d + k_v\,\omega
Assumptions
    It engages at once and without play; its rollers hold any torque. The inertias may be left to the neighbours.
Reference
    Signorini's law beside (3.11); the drag as in (3.12).
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Elements, Friction, FrictionRole

__all__ = ["Freewheel"]


class Freewheel(Component):
    """A one-way clutch."""

    type_name: ClassVar[str] = "freewheel"
    summary: ClassVar[str] = "freewheel (one-way clutch)"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))

    type: Literal["freewheel"]
    inertia_input: Annotated[float, Quantity("kg m^2", "moment of inertia I_i of the driving ring")] | None = None
    inertia_output: Annotated[float, Quantity("kg m^2", "moment of inertia I_o of the driven ring")] | None = None
    drag: Annotated[float, Quantity("N m", "Coulomb torque T_d while it overruns", positive=False)] = 0.0
    viscous: Annotated[float, Quantity("N m s/rad", "viscous friction k_v while it overruns", positive=False)] = 0.0

    def elements(self, name: str) -> Elements:
        row = {f"{name}.input": sp.Integer(1), f"{name}.output": sp.Integer(-1)}
        return Elements(
            bodies=self.disk_bodies(name),
            frictions=(
                Friction(
                    name,
                    row,
                    coulomb=self.symbol(name, "drag"),
                    viscous=self.symbol(name, "viscous"),
                    role=FrictionRole.COUPLING,
                    one_way=True,
                ),
            ),
        )

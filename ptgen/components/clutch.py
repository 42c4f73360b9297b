r"""Friction clutch: two disks that an actuation presses together.

Flanges
    ``input`` and ``output``. The torque is positive when the input drives the output.
Equations
    .. math:: I_{ci}\,\dot\omega_{ci} = T_{ci} - T_c, \qquad I_{co}\,\dot\omega_{co} = T_c - T_{co} \qquad (3.11)

    While it slips, with :math:`\omega = \omega_{ci} - \omega_{co}` and the actuation :math:`\mu_c` from 0 to 1,

    .. math:: T_c = \mu_c \left[T_{c,c} + (T_{c,s} - T_{c,c})\,e^{-|\omega| / \omega_{c,s}}
              + k_{c,v} |\omega|\right] \mathrm{sgn}(\omega) \qquad (3.12)

    Without `static` and `viscous` that is the dry clutch (3.13). While it sticks, :math:`T_c` is the torque that
    keeps both disks at one velocity, up to :math:`\mu_c T_{c,s}` (4.2).
Assumptions
    The torque follows the actuation at once. The disks' inertias may be left to the neighbours.
Reference
    (3.11)-(3.13), Section 3.5; (4.1), (4.2), Section 4.1.
Errata
    (4.2) prints the limit without the actuation; (4.1) at zero velocity has it.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Flange, Quantity
from ptgen.components.friction_partial import DiskPartial
from ptgen.elements import Elements, FrictionRole

__all__ = ["Clutch"]


class Clutch(DiskPartial):
    """A friction clutch."""

    type_name: ClassVar[str] = "clutch"
    summary: ClassVar[str] = "friction clutch"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))

    type: Literal["clutch"]
    inertia_input: Annotated[float, Quantity("kg m^2", "moment of inertia I_ci of the input disk")] | None = None
    inertia_output: Annotated[float, Quantity("kg m^2", "moment of inertia I_co of the output disk")] | None = None

    def elements(self, name: str) -> Elements:
        row = {f"{name}.input": sp.Integer(1), f"{name}.output": sp.Integer(-1)}
        return Elements(
            bodies=self.disk_bodies(name),
            frictions=(self.friction(name, row, FrictionRole.COUPLING, actuated=self.actuated),),
        )

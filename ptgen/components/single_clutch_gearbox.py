r"""Simplified gearbox, model I: one clutch and one gear stage, whose ratio changes at run time.

Flanges
    ``input`` and ``output``. Torques are positive when the input drives the output.
Equations
    .. math:: I_{gbi}\,\dot\omega_{gbi} = T_{gbi} - T_c, \qquad
              I_{gbo}\,\dot\omega_{gbo} = i_{gb} T_c - T_{gbo} \qquad (3.51)

    The clutch sits at the input of the gear stage; its torque is that of a clutch, (3.12), over

    .. math:: T_c = T_c(\omega_{gbi} - i_{gb}\,\omega_{gbo}) \qquad (3.52)

    The gear stage is ideal: :math:`T_c\,\omega_{gbi} - i_{gb} T_c\,\omega_{gbo}` is what the clutch turns into heat,
    and nothing else is lost, whatever the ratio does. A gear is shifted by opening the clutch, changing the ratio, and
    closing the clutch again; a ratio that changes while the clutch sticks makes it slip.
Assumptions
    Gear stage and clutch disks have no inertia; that of the gearbox is at its input and its output and the same in all
    gears. The clutch torque follows the actuation at once.
Reference
    (3.51), (3.52), Figure 3.22, Section 3.7.2; (3.12), Section 3.5.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.clutched_gearbox_partial import ClutchedGearboxPartial
from ptgen.components.component import Quantity
from ptgen.components.friction_partial import DiskLaw, friction_at
from ptgen.elements import Elements, FrictionRole

__all__ = ["SingleClutchGearbox"]


class SingleClutchGearbox(ClutchedGearboxPartial):
    """A gearbox as a clutch and one gear stage."""

    type_name: ClassVar[str] = "single_clutch_gearbox"
    summary: ClassVar[str] = "simplified gearbox with one clutch and a changing ratio (model I)"
    ratios: ClassVar[tuple[str, ...]] = ("ratio",)
    clutches: ClassVar[tuple[str, ...]] = ("clutch",)

    type: Literal["single_clutch_gearbox"]
    ratio: Annotated[
        float, Quantity("", "ratio of input speed to output speed; negative when the sense reverses", signed=True)
    ]
    clutch: DiskLaw
    """The clutch, with the keys of type "clutch" that concern friction."""

    def elements(self, name: str) -> Elements:
        row = {f"{name}.input": sp.Integer(1), f"{name}.output": -self.symbol(name, "ratio")}
        return Elements(
            bodies=self.disk_bodies(name),
            frictions=(friction_at(self, name, "clutch", row=row, role=FrictionRole.COUPLING, actuated=True),),
        )

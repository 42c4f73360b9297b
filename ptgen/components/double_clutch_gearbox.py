r"""Simplified gearbox, model II: two clutches with a gear stage each, whose ratios change at run time.

Flanges
    ``input`` and ``output``. Torques are positive when the input drives the output.
Equations
    .. math:: I_{gbi}\,\dot\omega_{gbi} = T_{gbi} - T_{c1} - T_{c2}, \qquad
              I_{gbo}\,\dot\omega_{gbo} = i_{gb1} T_{c1} + i_{gb2} T_{c2} - T_{gbo} \qquad (3.53)

    The clutches sit at the input of the gear stages; their torques are those of clutches, (3.12), over

    .. math:: T_{c1} = T_{c1}(\omega_{gbi} - i_{gb1}\,\omega_{gbo}), \qquad
              T_{c2} = T_{c2}(\omega_{gbi} - i_{gb2}\,\omega_{gbo}) \qquad (3.54)

    In the slip velocities that is (4.74) to (4.76). Both clutches can stick only where :math:`\omega_{gbo} = 0` or
    :math:`i_{gb1} = i_{gb2}`. A gear is shifted under load by opening one clutch while the other one closes; its ratio
    is set to that of the next gear before.
Assumptions
    Gear stages and clutch disks have no inertia; that of the gearbox is at its input and its output and the same in all
    gears. The clutch torques follow the actuations at once.
Reference
    (3.53), (3.54), Figure 3.23, Section 3.7.2; (4.74)-(4.76), Section 4.2.2; (3.12), Section 3.5.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.clutched_gearbox_partial import ClutchedGearboxPartial
from ptgen.components.component import Quantity
from ptgen.components.friction_partial import DiskLaw, friction_at
from ptgen.elements import Elements, FrictionRole

__all__ = ["DoubleClutchGearbox"]


class DoubleClutchGearbox(ClutchedGearboxPartial):
    """A gearbox as two clutches with a gear stage each."""

    type_name: ClassVar[str] = "double_clutch_gearbox"
    summary: ClassVar[str] = "simplified gearbox with two clutches and changing ratios (model II)"
    ratios: ClassVar[tuple[str, ...]] = ("ratio1", "ratio2")
    clutches: ClassVar[tuple[str, ...]] = ("clutch1", "clutch2")

    type: Literal["double_clutch_gearbox"]
    ratio1: Annotated[float, Quantity("", "input speed over output speed behind the first clutch", signed=True)]
    ratio2: Annotated[float, Quantity("", "input speed over output speed behind the second clutch", signed=True)]
    clutch1: DiskLaw
    """The first clutch, with the keys of type "clutch" that concern friction."""
    clutch2: DiskLaw
    """The second clutch."""

    def elements(self, name: str) -> Elements:
        frictions = (
            friction_at(
                self,
                name,
                clutch,
                row={f"{name}.input": sp.Integer(1), f"{name}.output": -self.symbol(name, ratio)},
                role=FrictionRole.COUPLING,
                actuated=True,
            )
            for clutch, ratio in zip(self.clutches, self.ratios, strict=True)
        )
        return Elements(bodies=self.disk_bodies(name), frictions=tuple(frictions))

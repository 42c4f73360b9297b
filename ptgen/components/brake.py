r"""Brake: a disk that an actuation presses against the housing.

Flanges
    ``left`` and ``right``, rigidly one velocity; either may stay open.
Equations
    .. math:: I \dot\omega = T_{left} - T_{right} - T_c

    :math:`T_c` is the torque (3.12) of a clutch whose output stands still: :math:`\omega_{co} = 0`.
Assumptions
    The housing is rigid; the torque follows the actuation at once. The inertia may be left to the neighbours.
Reference
    (3.12), (3.13), Section 3.5; (4.1), (4.2), Section 4.1.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Flange, Quantity
from ptgen.components.friction_partial import DiskPartial
from ptgen.elements import Body, Constraint, Elements, FrictionRole

__all__ = ["Brake"]


class Brake(DiskPartial):
    """A friction brake."""

    type_name: ClassVar[str] = "brake"
    summary: ClassVar[str] = "friction brake against the housing"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("left", True), Flange("right", True))

    type: Literal["brake"]
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia of the brake disk")] | None = None

    def elements(self, name: str) -> Elements:
        left, right = f"{name}.left", f"{name}.right"
        one = sp.Integer(1)
        return Elements(
            bodies=() if self.inertia is None else (Body(left, self.symbol(name, "inertia")),),
            constraints=(Constraint(name, {left: one, right: -one}),),
            frictions=(self.friction(name, {left: one}, FrictionRole.COUPLING, actuated=self.actuated),),
        )

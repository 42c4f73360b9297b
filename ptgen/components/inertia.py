r"""Rigid inertia, such as a flywheel, an adapter flange or a brake disc.

Flanges
    ``left`` and ``right``, rigidly one velocity; either may stay open.
Equations
    .. math:: I \dot\omega = T_{left} - T_{right}
Assumptions
    Rigid; balanced.
Reference
    (3.3) without a drive.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Body, Constraint, Elements

__all__ = ["Inertia"]


class Inertia(Component):
    """A rigid body on a shaft."""

    type_name: ClassVar[str] = "inertia"
    summary: ClassVar[str] = "rigid inertia"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("left", True), Flange("right", True))

    type: Literal["inertia"]
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia")]

    def elements(self, name: str) -> Elements:
        left, right = f"{name}.left", f"{name}.right"
        return Elements(
            bodies=(Body(left, self.symbol(name, "inertia")),),
            constraints=(Constraint(name, {left: sp.Integer(1), right: sp.Integer(-1)}),),
        )

r"""Bearing: friction of a shaft against the housing.

Flanges
    ``left`` and ``right``, rigidly one velocity; either may stay open.
Equations
    .. math:: I \dot\omega = T_{left} - T_{right} - T_b

    .. math:: T_b = \left[T_c + (T_s - T_c)\,e^{-|\omega| / \omega_s}\right] \mathrm{sgn}(\omega) + k_v\,\omega

    At rest :math:`T_b` is the torque that keeps the shaft there, up to :math:`T_s`.
Assumptions
    The friction does not depend on the load of the bearing. The inertia may be left to the neighbours.
Reference
    (3.12) with full actuation, Section 3.5; Figure 4.1d.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Flange, Quantity
from ptgen.components.friction_partial import FrictionPartial
from ptgen.elements import Body, Constraint, Elements, FrictionRole

__all__ = ["Bearing"]


class Bearing(FrictionPartial):
    """A bearing with friction."""

    type_name: ClassVar[str] = "bearing"
    summary: ClassVar[str] = "bearing friction"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("left", True), Flange("right", True))
    strength: ClassVar[str] = "coulomb"

    type: Literal["bearing"]
    coulomb: Annotated[float, Quantity("N m", "Coulomb friction torque T_c", positive=False)] = 0.0
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia of the part of the shaft in it")] | None = None

    def elements(self, name: str) -> Elements:
        left, right = f"{name}.left", f"{name}.right"
        one = sp.Integer(1)
        return Elements(
            bodies=() if self.inertia is None else (Body(left, self.symbol(name, "inertia")),),
            constraints=(Constraint(name, {left: one, right: -one}),),
            frictions=(self.friction(name, {left: one}, FrictionRole.LOSS, actuated=False),),
        )

r"""Torsionally flexible shaft without inertia (Kelvin-Voigt).

Flanges
    ``left`` and ``right``. The torque is positive when it drives the right-hand side.
Equations
    .. math:: T_s = d_s (\omega_1 - \omega_2) + c_s \int (\omega_1 - \omega_2)\,dt \qquad (3.4)
Assumptions
    Linear; no backlash; its inertia is added to the neighbours; cardan joints without angle.
Reference
    (3.4), Section 3.3.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Elements, Spring

__all__ = ["Shaft"]


class Shaft(Component):
    """A torsion spring with internal damping."""

    type_name: ClassVar[str] = "shaft"
    summary: ClassVar[str] = "torsionally flexible shaft, such as a cardan shaft"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("left"), Flange("right"))

    type: Literal["shaft"]
    stiffness: Annotated[float, Quantity("N m/rad", "torsional stiffness c_s")]
    damping: Annotated[float, Quantity("N m s/rad", "internal damping d_s", positive=False)] = 0.0

    def elements(self, name: str) -> Elements:
        row = {f"{name}.left": sp.Integer(1), f"{name}.right": sp.Integer(-1)}
        return Elements(springs=(Spring(name, row, self.symbol(name, "stiffness"), self.symbol(name, "damping")),))

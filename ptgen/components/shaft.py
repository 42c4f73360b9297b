r"""Torsionally flexible shaft without inertia (Kelvin-Voigt), on request with backlash.

Flanges
    ``left`` and ``right``. The torque is positive when it drives the right-hand side.
Equations
    .. math:: T_s = d_s (\omega_1 - \omega_2) + c_s \int (\omega_1 - \omega_2)\,dt \qquad (3.4)

    With backlash, for :math:`\Delta\varphi = \varphi_1 - \varphi_2` outside the gap,
    :math:`|\Delta\varphi| \ge \theta_{bl} / 2`,

    .. math:: T_s = d_s (\omega_1 - \omega_2)
              + c_s \left(\Delta\varphi - \frac{\theta_{bl}}{2}\,\mathrm{sgn}\,\Delta\varphi\right) \qquad (3.5)

    and :math:`T_s = 0` inside it.
Assumptions
    Linear outside the gap; its inertia is added to the neighbours; cardan joints without angle. Both ends of a shaft
    with backlash need an inertia. The model for the controller has the gap closed.
Reference
    (3.4), (3.5), Section 3.3.
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
    backlash: Annotated[float, Quantity("rad", "full width theta_bl of the gap")] | None = None

    def elements(self, name: str) -> Elements:
        row = {f"{name}.left": sp.Integer(1), f"{name}.right": sp.Integer(-1)}
        gap = None if self.backlash is None else self.symbol(name, "backlash")
        return Elements(springs=(Spring(name, row, self.symbol(name, "stiffness"), self.symbol(name, "damping"), gap),))

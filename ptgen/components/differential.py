r"""Symmetric differential in the reduced form that needs two inertias only.

Flanges
    ``input``, ``output1``, ``output2``. The place ``outputs`` is the sum of both output torques.
Equations
    .. math:: \omega_{do1,2} = \omega_{di} / i_d \pm \rho\,\omega_3, \qquad \rho = r_3 / r_1 \qquad (3.19)

    .. math:: I_{di}\dot\omega_{di} = T_{di} - T_{dl} - (T_{do1} + T_{do2}) / i_d \qquad (C.13)

    .. math:: I_{3b}\dot\omega_3 = -T_{do1} + T_{do2} - T_{dsl} / \rho \qquad (C.14)

    ``<name>.loss`` is T_dl (3.34), ``<name>.limited_slip`` is T_dsl (3.35).
Assumptions
    Symmetric gear set; ideal gears. The inertia that belongs to :math:`\omega_3` by energy is
    :math:`\rho I_{3b}`, because (C.14) is written for the output torques.
Reference
    (C.10)-(C.14), Section 3.6.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Quantity
from ptgen.components.differential_partial import DifferentialPartial
from ptgen.elements import Body, Constraint, Elements

__all__ = ["Differential"]


class Differential(DifferentialPartial):
    """A symmetric axle differential."""

    type_name: ClassVar[str] = "differential"
    summary: ClassVar[str] = "symmetric differential, reduced form (C.13), (C.14)"

    type: Literal["differential"]
    ratio: Annotated[float, Quantity("", "ratio i_d of input speed to mean output speed", signed=True)]
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia I_di, referred to the input")]
    inertia_pinion: Annotated[float, Quantity("kg m^2", "moment of inertia I_3b of the relative motion of the outputs")]
    pinion_ratio: Annotated[float, Quantity("", "radius of the pinion over radius of the output gears, r_3/r_1")] = 1.0

    def elements(self, name: str) -> Elements:
        input_, output1, output2, pinion = (f"{name}.{part}" for part in ("input", "output1", "output2", "pinion"))
        ratio, rho = self.symbol(name, "ratio"), self.symbol(name, "pinion_ratio")
        one = sp.Integer(1)
        return Elements(
            internal=(pinion,),
            bodies=(
                Body(input_, self.symbol(name, "inertia")),
                Body(pinion, rho * self.symbol(name, "inertia_pinion")),
            ),
            constraints=(
                Constraint(name, {output1: one, input_: -1 / ratio, pinion: -rho}),
                Constraint(name, {output2: one, input_: -1 / ratio, pinion: rho}),
            ),
            frictions=self.frictions(name, pinion),
            places=self.outputs(name),
        )

r"""Bevel gear differential from its radii and inertias; the torque split may be asymmetric.

Flanges
    ``input``, ``output1``, ``output2``. The place ``outputs`` is the sum of both output torques.
Equations
    .. math:: \omega_{di} = i_d\,\omega_c, \quad r_1\omega_{do1} = r_1\omega_c + r_3\omega_{3b}, \quad
              r_2\omega_{do2} = r_2\omega_c - r_3\omega_{3b} \qquad (3.14)

    The equations of motion (3.16), (3.17) follow from these rows and the five inertias by virtual power;
    the steady torque split is :math:`r_1 : r_2` (3.20).
    ``<name>.loss`` is T_dl (3.34) at the input, ``<name>.limited_slip`` is T_dsl (3.35) at the pinion.
Assumptions
    Ideal gears; one pinion stands for all.
Reference
    (3.14)-(3.22), Section 3.6.1.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Quantity
from ptgen.components.differential_partial import DifferentialPartial
from ptgen.elements import Body, Constraint, Elements

__all__ = ["BevelDifferential"]


class BevelDifferential(DifferentialPartial):
    """A bevel gear differential, symmetric or not."""

    type_name: ClassVar[str] = "bevel_differential"
    summary: ClassVar[str] = "bevel gear differential (3.14)-(3.22), asymmetric allowed"

    type: Literal["bevel_differential"]
    ratio: Annotated[float, Quantity("", "ratio i_d = r_c/r_0 of drive gear speed to cage speed", signed=True)]
    radius_output1: Annotated[float, Quantity("m", "radius r_1 of the gear at output 1")]
    radius_output2: Annotated[float, Quantity("m", "radius r_2 of the gear at output 2")]
    radius_pinion: Annotated[float, Quantity("m", "radius r_3 of the bevel pinion")]
    inertia_drive: Annotated[float, Quantity("kg m^2", "moment of inertia I_0 of input shaft and drive gear")]
    inertia_cage: Annotated[
        float, Quantity("kg m^2", "moment of inertia I_c of cage and pinions about the axis of the outputs")
    ]
    inertia_output1: Annotated[float, Quantity("kg m^2", "moment of inertia I_1 of output 1")]
    inertia_output2: Annotated[float, Quantity("kg m^2", "moment of inertia I_2 of output 2")]
    inertia_pinion: Annotated[float, Quantity("kg m^2", "moment of inertia I_3 of the pinion about its own axis")]

    def elements(self, name: str) -> Elements:
        input_, output1, output2, cage, pinion = (
            f"{name}.{part}" for part in ("input", "output1", "output2", "cage", "pinion")
        )
        r1, r2, r3 = (self.symbol(name, f"radius_{part}") for part in ("output1", "output2", "pinion"))
        one = sp.Integer(1)
        return Elements(
            internal=(cage, pinion),
            bodies=(
                Body(input_, self.symbol(name, "inertia_drive")),
                Body(cage, self.symbol(name, "inertia_cage")),
                Body(output1, self.symbol(name, "inertia_output1")),
                Body(output2, self.symbol(name, "inertia_output2")),
                Body(pinion, self.symbol(name, "inertia_pinion")),
            ),
            constraints=(
                Constraint(name, {input_: one, cage: -self.symbol(name, "ratio")}),
                Constraint(name, {output1: r1, cage: -r1, pinion: -r3}),
                Constraint(name, {output2: r2, cage: -r2, pinion: r3}),
            ),
            frictions=self.frictions(name, pinion),
            places=self.outputs(name),
        )

r"""Adapter gearbox with an ideal, constant ratio.

Flanges
    ``input`` and ``output``; :math:`i = \omega_{input} / \omega_{output}`. In a chain it is entered at the
    input; write ``gearbox.output`` to enter it at the output.
Equations
    .. math:: \omega_{gbi} = i\,\omega_{gbo} \qquad (3.8)

    .. math:: I_{gbi}\,\dot\omega_{gbi} = T_{gbi} - T_{gbo} / i \qquad (3.9)

    The inertia is given for one side; the other form, (3.10), follows: :math:`I_{gbo} = i^2 I_{gbi}`.
Assumptions
    Ideal gears: no play, no losses, no orders.
Reference
    (3.8)-(3.10), Section 3.4.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Body, Constraint, Elements

__all__ = ["Gearbox"]


class Gearbox(Component):
    """A gearbox between two shafts."""

    type_name: ClassVar[str] = "gearbox"
    summary: ClassVar[str] = "adapter gearbox with constant ratio"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))

    type: Literal["gearbox"]
    ratio: Annotated[
        float, Quantity("", "ratio of input speed to output speed; negative when the sense reverses", signed=True)
    ]
    inertia: Annotated[float, Quantity("kg m^2", "moment of inertia, referred to the side named in inertia_side")]
    inertia_side: Literal["input", "output"] = "input"

    def elements(self, name: str) -> Elements:
        input_, output = f"{name}.input", f"{name}.output"
        row = {input_: sp.Integer(1), output: -self.symbol(name, "ratio")}
        return Elements(
            bodies=(Body(f"{name}.{self.inertia_side}", self.symbol(name, "inertia")),),
            constraints=(Constraint(name, row),),
        )

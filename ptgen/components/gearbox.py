r"""Adapter gearbox with a constant ratio; on request its teeth are elastic, or have play.

Flanges
    ``input`` and ``output``; :math:`i = \omega_{input} / \omega_{output}`. In a chain it is entered at the
    input; write ``gearbox.output`` to enter it at the output.
Equations
    .. math:: \omega_{gbi} = i\,\omega_{gbo} \qquad (3.8)

    .. math:: I_{gbi}\,\dot\omega_{gbi} = T_{gbi} - T_{gbo} / i, \qquad I_{gbi} = I_1 + I_2 / i^2 \qquad (3.9)

    The inertia is given for one side; the other form, (3.10), follows: :math:`I_{gbo} = i^2 I_{gbi}`.

    With a `mesh_stiffness` the teeth lie between the two sides, and :math:`T_z` is their torque at the output:

    .. math:: I_1\,\dot\omega_{gbi} = T_{gbi} - T_z / i, \qquad I_2\,\dot\omega_{gbo} = T_z - T_{gbo}

    where :math:`T_z` is the torque (3.4) of a shaft with the velocities :math:`\omega_{gbi} / i` and
    :math:`\omega_{gbo}` at its ends; with `play`, that of a shaft with backlash (3.5).
Assumptions
    No losses, no orders. Without a mesh stiffness the gears are rigid and without play.
Reference
    (3.8)-(3.10), Section 3.4; (3.4), (3.5), Section 3.3.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import model_validator

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Body, Constraint, Elements, Spring

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
    inertia_other: Annotated[float, Quantity("kg m^2", "moment of inertia on the other side")] | None = None
    mesh_stiffness: Annotated[float, Quantity("N m/rad", "stiffness of the teeth, seen at the output")] | None = None
    mesh_damping: (
        Annotated[float, Quantity("N m s/rad", "damping of the teeth, at the output", positive=False)] | None
    ) = None
    play: Annotated[float, Quantity("rad", "full play of the teeth, seen at the output")] | None = None

    @model_validator(mode="after")
    def _mesh_complete(self) -> Gearbox:
        if self.mesh_stiffness is None:
            for key in ("play", "mesh_damping"):
                if getattr(self, key) is not None:
                    raise ValueError(f'{key} needs a mesh_stiffness; add it, such as "800 kN m/rad", or remove {key}')
        return self

    def elements(self, name: str) -> Elements:
        input_, output = f"{name}.input", f"{name}.output"
        one, ratio = sp.Integer(1), self.symbol(name, "ratio")
        other = {"input": output, "output": input_}[self.inertia_side]
        bodies = [Body(f"{name}.{self.inertia_side}", self.symbol(name, "inertia"))]
        if self.inertia_other is not None:
            bodies.append(Body(other, self.symbol(name, "inertia_other")))
        if self.mesh_stiffness is None:
            constraint = Constraint(name, {input_: one, output: -ratio})
            return Elements(bodies=tuple(bodies), constraints=(constraint,))
        # The gear that drives the output, before its teeth give way; the spring alone has the gearbox's name.
        gear = f"{name}.gear"
        teeth = Spring(
            name,
            {gear: one, output: -one},
            self.symbol(name, "mesh_stiffness"),
            sp.Integer(0) if self.mesh_damping is None else self.symbol(name, "mesh_damping"),
            None if self.play is None else self.symbol(name, "play"),
        )
        return Elements(
            internal=(gear,),
            bodies=tuple(bodies),
            constraints=(Constraint(gear, {input_: one, gear: -ratio}),),
            springs=(teeth,),
        )

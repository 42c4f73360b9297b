r"""Adapter gearbox; on request its ratio changes at run time, and its teeth are elastic or have play.

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
    With a `ratio_range` the ratio is an input and changes while the gearbox turns, as in a transmission that shifts or
    varies steplessly. The teeth stay without mass, so (3.8) and the ratio of the torques hold at every moment, and

    .. math:: \frac{d}{dt} (\omega_{gbi} - i\,\omega_{gbo}) = 0 \quad\Rightarrow\quad
        \dot\omega_{gbi} = i\,\dot\omega_{gbo} + \omega_{gbo} \frac{di}{dt} \qquad (5.46)

    At most one side may carry inertia rigidly; the other one is held by a shaft, which takes the change as twist. The
    teeth do no work, :math:`T_{gbi}\,\omega_{gbi} = T_{gbo}\,\omega_{gbo}` at every moment, so a change of the ratio
    moves energy between the two sides but neither adds nor takes any.
Assumptions
    No losses, no orders. Without a mesh stiffness the gears are rigid and without play. What changes the ratio is not
    modelled.
Reference
    (3.8)-(3.10), Section 3.4; (3.4), (3.5), Section 3.3; (5.46), Section 5.4.1.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import model_validator

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Body, Constraint, Elements, Spring

__all__ = ["Gearbox"]


class Gearbox(Component):
    """A gearbox between two shafts."""

    type_name: ClassVar[str] = "gearbox"
    summary: ClassVar[str] = "adapter gearbox with constant or changing ratio"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))

    type: Literal["gearbox"]
    ratio: Annotated[
        float, Quantity("", "ratio of input speed to output speed; negative when the sense reverses", signed=True)
    ]
    ratio_range: (
        tuple[
            Annotated[float, Quantity("", "least ratio while the bed runs", signed=True)],
            Annotated[float, Quantity("", "largest ratio while the bed runs", signed=True)],
        ]
        | None
    ) = None
    """Least and largest ratio, if it changes while the bed runs; `ratio` holds at the start."""
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

    @model_validator(mode="after")
    def _ratio_in_range(self) -> Gearbox:
        if self.ratio_range is None:
            return self
        least, most = self.ratio_range
        if least >= most:
            raise ValueError(
                f"ratio_range must rise, got [{least:g}, {most:g}]; "
                "exchange the two, or remove it if the ratio is constant"
            )
        if least < 0 < most:
            raise ValueError(
                f"ratio_range must not hold 0, where nothing would be transmitted, got [{least:g}, {most:g}]; "
                "give both ends the same sign"
            )
        if not least <= self.ratio <= most:
            raise ValueError(
                f"ratio must lie in ratio_range, from {least:g} to {most:g}, got {self.ratio:g}; "
                "it is the ratio at the start"
            )
        if self.inertia_other is not None and self.mesh_stiffness is None:
            raise ValueError(
                "ratio_range and inertia_other together would need an impulse at every change of the ratio; "
                "remove inertia_other, or put a mesh_stiffness between the two sides"
            )
        return self

    def spans(self) -> Mapping[str, tuple[float, float]]:
        """Return the range of the ratio, if it changes."""
        return {} if self.ratio_range is None else {"ratio": self.ratio_range}

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

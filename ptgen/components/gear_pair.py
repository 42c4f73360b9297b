r"""Fixed pair of gears on two parallel shafts.

Flanges
    ``input`` and ``output``; :math:`i = z_o / z_i` with the teeth of the gear on each.
Equations
    .. math:: \omega_i = -i\,\omega_o \quad\text{(external teeth, the sense reverses)}, \qquad
              \omega_i = i\,\omega_o \quad\text{(internal teeth, or an idler in between)}

    and by virtual power the torque at the output is that at the input times the same ratio.
    ``<name>.loss`` is the friction of the teeth, on the velocity of the input and proportional to its torque; its
    `load` is 1 less the efficiency.
Assumptions
    Rigid, ideal gears. The inertias may be left to what is connected.
Reference
    (3.8), Section 3.4, as a part of a transmission.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import Field, model_validator

from ptgen.components.component import Component, Flange, Quantity, Record, Switch
from ptgen.components.friction import MeshLoss, mesh_losses
from ptgen.elements import Constraint, Elements

__all__ = ["GearPair", "PairTeeth"]


class PairTeeth(Record):
    """Numbers of teeth of a pair of gears."""

    input: Annotated[int, Field(strict=True, ge=1, le=10000)]
    """Teeth of the gear at the input, z_i."""
    output: Annotated[int, Field(strict=True, ge=1, le=10000)]
    """Teeth of the gear at the output, z_o."""


class GearPair(Component):
    """Two gears that mesh."""

    type_name: ClassVar[str] = "gear_pair"
    summary: ClassVar[str] = "fixed pair of gears"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))

    type: Literal["gear_pair"]
    teeth: PairTeeth | None = None
    """Teeth of both gears; they give the ratio."""
    ratio: Annotated[float, Quantity("", "ratio i of input speed to output speed, without its sign")] | None = None
    reversing: Switch = True
    """Whether the output turns the other way, as with external teeth and no idler."""
    inertia_input: Annotated[float, Quantity("kg m^2", "moment of inertia of the gear at the input")] | None = None
    inertia_output: Annotated[float, Quantity("kg m^2", "moment of inertia of the gear at the output")] | None = None
    loss: MeshLoss | None = None

    @model_validator(mode="after")
    def _ratio_given_once(self) -> GearPair:
        if self.teeth is None and self.ratio is None:
            raise ValueError(
                "needs its ratio; add teeth = { input = 20, output = 53 }, or ratio = 2.65 of input to output speed"
            )
        if self.teeth is not None:
            ratio = self.teeth.output / self.teeth.input
            if self.ratio is not None and self.ratio != ratio:
                raise ValueError(
                    f"has teeth and ratio, which differ ({ratio:g}, {self.ratio:g}); remove one of the two"
                )
            object.__setattr__(self, "ratio", ratio)
        return self

    def elements(self, name: str) -> Elements:
        input_, output = f"{name}.input", f"{name}.output"
        one, ratio = sp.Integer(1), self.symbol(name, "ratio")
        return Elements(
            bodies=self.disk_bodies(name),
            constraints=(Constraint(name, {input_: one, output: ratio if self.reversing else -ratio}),),
            frictions=mesh_losses(self, name, {input_: one}, input_),
        )

r"""Synchroniser: a friction cone that brings a gear to the speed of its shaft, and dogs that then hold it.

Flanges
    ``input`` and ``output``. The torque is positive when the input drives the output.
Equations
    With :math:`\omega = \omega_{in} - \omega_{out}` and :math:`\mu` from 0 to 1, the travel of the sleeve,

    .. math:: T = \mu\,T_{cone}\,\mathrm{sgn}(\omega) \quad (\omega \ne 0), \qquad
              |T| \le \mu\,T_{dog} \quad (\omega = 0)

    which is the law (3.12) of a clutch whose torque at rest, that of the dogs, falls to the torque of the cone as soon
    as it slips. Pulled out under load the dogs let go when :math:`\mu\,T_{dog}` has fallen to the torque that they
    transmit.
Assumptions
    The sleeve does not pass the cone before the speeds are equal; the dogs have neither play nor stiffness.
Reference
    (3.12), Section 3.5, as a part of a transmission.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import model_validator

from ptgen.components.component import Component, Flange, Quantity
from ptgen.elements import Elements, Friction, FrictionRole

__all__ = ["Synchroniser"]


class Synchroniser(Component):
    """A synchronised dog clutch."""

    type_name: ClassVar[str] = "synchroniser"
    summary: ClassVar[str] = "dog clutch with a friction cone"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output"))

    type: Literal["synchroniser"]
    cone: Annotated[float, Quantity("N m", "friction torque T_cone of the cone at full actuation")]
    dog: Annotated[float, Quantity("N m", "largest torque T_dog that the dogs hold once they have engaged")]
    inertia_input: Annotated[float, Quantity("kg m^2", "moment of inertia of hub and sleeve")] | None = None
    inertia_output: Annotated[float, Quantity("kg m^2", "moment of inertia of the gear's ring of dogs")] | None = None

    @model_validator(mode="after")
    def _dogs_hold_more(self) -> Synchroniser:
        if self.dog < self.cone:
            raise ValueError(
                f"dog must not be below cone, got {self.dog:g} N m and {self.cone:g} N m; exchange the two"
            )
        return self

    def elements(self, name: str) -> Elements:
        row = {f"{name}.input": sp.Integer(1), f"{name}.output": sp.Integer(-1)}
        friction = Friction(
            name,
            row,
            coulomb=self.symbol(name, "cone"),
            viscous=sp.Integer(0),
            role=FrictionRole.COUPLING,
            static=self.symbol(name, "dog"),
            actuated=True,
        )
        return Elements(bodies=self.disk_bodies(name), frictions=(friction,))

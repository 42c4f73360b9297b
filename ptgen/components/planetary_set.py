r"""Planetary gear set of a transmission: sun, ring and carrier, each free to be driven, held or coupled.

Flanges
    ``sun``, ``ring`` and ``carrier``. A torque that drives a flange accelerates it.
Equations
    With the ratio :math:`g = r_r / r_s = z_r / z_s` (3.36), pitch radii or teeth,

    .. math:: \omega_s + g\,\omega_r = (1 + g)\,\omega_c \qquad\text{(single pinions)}, \qquad
              \omega_s - g\,\omega_r = (1 - g)\,\omega_c \qquad\text{(double pinions)}

    Single pinions have :math:`r_p = (r_r - r_s)/2` and turn, beside the motion of their carrier, with

    .. math:: \omega_p = \frac{r_r}{r_p} (\omega_r - \omega_c) = -\frac{r_s}{r_p} (\omega_s - \omega_c) \qquad (3.50)

    The equations of motion (3.47)-(3.49) follow by virtual power. ``<name>.loss`` is the friction of the teeth, on the
    velocity :math:`\omega_s - \omega_c` with which they roll and proportional to the torque of the sun; its `load` is
    1 less the efficiency of the set with a standing carrier.
Assumptions
    Rigid, ideal gears; all planets turn alike. The inertias may be left to what is connected.
Reference
    (3.36), (3.47)-(3.50), Section 3.7.1.
Errata
    (3.47)-(3.50) take the planets' own velocity relative to the carrier; see the page of the errata.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import Field, model_validator

from ptgen.components.component import Component, Flange, Quantity, Record
from ptgen.components.friction import MeshLoss, mesh_losses
from ptgen.elements import Body, Constraint, Elements

__all__ = ["PlanetarySet", "SetTeeth"]


class SetTeeth(Record):
    """Numbers of teeth of a planetary set."""

    sun: Annotated[int, Field(strict=True, ge=1, le=10000)]
    """Teeth of the sun gear, z_s."""
    ring: Annotated[int, Field(strict=True, ge=1, le=10000)]
    """Teeth of the ring gear, z_r."""


class PlanetarySet(Component):
    """A simple planetary gear set, with single or double pinions."""

    type_name: ClassVar[str] = "planetary_set"
    summary: ClassVar[str] = "planetary gear set of a transmission (3.47)-(3.50)"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("sun"), Flange("ring"), Flange("carrier"))

    type: Literal["planetary_set"]
    teeth: SetTeeth | None = None
    """Teeth of sun and ring; they give the ratio."""
    ratio: Annotated[float, Quantity("", "ratio g of the ring's to the sun's radius or teeth")] | None = None
    pinions: Literal["single", "double"] = "single"
    """Whether each planet meshes with both gears, or pairs of planets lie between them."""
    inertia_sun: Annotated[float, Quantity("kg m^2", "moment of inertia I_s of the sun gear")] | None = None
    inertia_ring: Annotated[float, Quantity("kg m^2", "moment of inertia I_r of the ring gear")] | None = None
    inertia_carrier: (
        Annotated[float, Quantity("kg m^2", "moment of inertia I_c of carrier and planets about the main axis")] | None
    ) = None
    inertia_planets: (
        Annotated[float, Quantity("kg m^2", "moment of inertia of all planets about their own axes, n_p I_p")] | None
    ) = None
    loss: MeshLoss | None = None

    @model_validator(mode="after")
    def _ratio_given_once(self) -> PlanetarySet:
        if self.teeth is None and self.ratio is None:
            raise ValueError(
                "needs its ratio; add teeth = { sun = 46, ring = 98 }, or ratio = 2.13 of the ring's to the sun's teeth"
            )
        if self.teeth is not None:
            ratio = self.teeth.ring / self.teeth.sun
            if self.ratio is not None and self.ratio != ratio:
                raise ValueError(
                    f"has teeth and ratio, which differ ({ratio:g}, {self.ratio:g}); remove one of the two"
                )
            object.__setattr__(self, "ratio", ratio)
        if self.ratio is not None and self.ratio <= 1:
            raise ValueError(
                f"the ring must be larger than the sun, got the ratio {self.ratio:g}; exchange the two numbers of teeth"
            )
        if self.pinions == "double" and self.inertia_planets is not None:
            raise ValueError(
                "inertia_planets is for single pinions, whose size follows from the ratio; "
                "add the planets to inertia_carrier, or give them to the set that shares them"
            )
        return self

    def elements(self, name: str) -> Elements:
        sun, ring, carrier, planets = (f"{name}.{part}" for part in ("sun", "ring", "carrier", "planets"))
        one, g = sp.Integer(1), self.symbol(name, "ratio")
        sense = 1 if self.pinions == "single" else -1
        constraints = [Constraint(name, {sun: one, ring: sense * g, carrier: -one - sense * g})]
        bodies = list(self.disk_bodies(name))
        internal: tuple[str, ...] = ()
        if self.inertia_planets is not None:
            internal = (planets,)
            bodies.append(Body(planets, self.symbol(name, "inertia_planets")))
            constraints.append(Constraint(name, {ring: 2 * g, carrier: -2 * g, planets: 1 - g}))
        return Elements(
            internal=internal,
            bodies=tuple(bodies),
            constraints=tuple(constraints),
            frictions=mesh_losses(self, name, {sun: one, carrier: -one}, sun),
        )

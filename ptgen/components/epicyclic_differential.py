r"""Epicyclic differential: carrier driven, ring gear and sun gear driving the outputs.

Flanges
    ``input`` (carrier), ``output1`` (ring), ``output2`` (sun). The place ``outputs`` is their sum.
Equations
    .. math:: r_r\omega_{do1} = r_r\omega_{di} + r_p\omega_{3p}, \quad
              r_s\omega_{do2} = r_s\omega_{di} - r_p\omega_{3p} \qquad (3.23)

    with :math:`r_p = (r_r - r_s)/2`. The equations of motion (3.25), (3.26) follow by virtual power; the
    steady torque split is :math:`r_r : r_s` (3.29).
    ``<name>.loss`` is T_dl (3.34) at the carrier, ``<name>.limited_slip`` is T_dsl (3.35), shared by the planets.
Assumptions
    Ideal gears; all planets turn alike.
Reference
    (3.23)-(3.31), Section 3.6.2.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import model_validator

from ptgen.components.component import Quantity
from ptgen.components.differential_partial import DifferentialPartial
from ptgen.elements import Body, Constraint, Elements

__all__ = ["EpicyclicDifferential"]


class EpicyclicDifferential(DifferentialPartial):
    """A differential made of one planetary gear set; its split is never symmetric."""

    type_name: ClassVar[str] = "epicyclic_differential"
    summary: ClassVar[str] = "epicyclic differential (3.23)-(3.31)"

    type: Literal["epicyclic_differential"]
    radius_ring: Annotated[float, Quantity("m", "radius r_r of the ring gear")]
    radius_sun: Annotated[float, Quantity("m", "radius r_s of the sun gear")]
    planets: Annotated[float, Quantity("", "number n_p of planets")]
    inertia_carrier: Annotated[
        float, Quantity("kg m^2", "moment of inertia I_c of carrier and planets about the main axis")
    ]
    inertia_ring: Annotated[float, Quantity("kg m^2", "moment of inertia I_r of ring gear and output 1")]
    inertia_sun: Annotated[float, Quantity("kg m^2", "moment of inertia I_s of sun gear and output 2")]
    inertia_planet: Annotated[float, Quantity("kg m^2", "moment of inertia I_p of one planet about its own axis")]

    @model_validator(mode="after")
    def _ring_outside(self) -> EpicyclicDifferential:
        if self.radius_ring <= self.radius_sun:
            raise ValueError("radius_ring must be greater than radius_sun; exchange them, or the outputs")
        if self.planets != int(self.planets):
            raise ValueError(f"planets must be a whole number, got {self.planets:g}")
        return self

    def elements(self, name: str) -> Elements:
        input_, output1, output2, planet = (f"{name}.{part}" for part in ("input", "output1", "output2", "planet"))
        ring, sun = self.symbol(name, "radius_ring"), self.symbol(name, "radius_sun")
        radius_planet = (ring - sun) / 2
        return Elements(
            internal=(planet,),
            bodies=(
                Body(input_, self.symbol(name, "inertia_carrier")),
                Body(output1, self.symbol(name, "inertia_ring")),
                Body(output2, self.symbol(name, "inertia_sun")),
                Body(planet, self.symbol(name, "planets") * self.symbol(name, "inertia_planet")),
            ),
            constraints=(
                Constraint(name, {output1: ring, input_: -ring, planet: -radius_planet}),
                Constraint(name, {output2: sun, input_: -sun, planet: radius_planet}),
            ),
            frictions=self.frictions(name, planet),
            places=self.outputs(name),
        )

"""What all differentials share: three flanges, two friction elements, and the sum of the outputs as a place.

The loss acts on the input, because it was measured to depend on the input's speed and torque (3.34); the limited slip
acts on the relative motion of the outputs, which is the pinion's or the planets' own rotation (3.35). With these
velocities as states each friction torque belongs to one state, which is what lets both be solved exactly.
"""

from __future__ import annotations

from typing import ClassVar, Literal

import sympy as sp

from ptgen.components.component import Component, Flange
from ptgen.components.friction import LoadDependentFriction, load_dependent
from ptgen.elements import Friction, FrictionRole, Place

__all__ = ["DifferentialPartial"]


class DifferentialPartial(Component):
    """Base of the differentials; each adds its bodies and constraints."""

    flanges: ClassVar[tuple[Flange, ...]] = (Flange("input"), Flange("output1"), Flange("output2"))

    loss: LoadDependentFriction | None = None
    limited_slip: LoadDependentFriction | None = None

    @classmethod
    def place_names(cls) -> tuple[str, ...]:
        return ("outputs",)

    def outputs(self, name: str) -> tuple[Place, ...]:
        """Return the place ``outputs``, the sum of both output torques."""
        return (Place(f"{name}.outputs", {f"{name}.output1": 1, f"{name}.output2": 1}),)

    def frictions(self, name: str, relative: str) -> tuple[Friction, ...]:
        """Return the loss (3.34) at the input and the limited slip (3.35) at the velocity `relative`, if given."""
        return (
            *self._friction(name, "loss", f"{name}.input", FrictionRole.LOSS),
            *self._friction(name, "limited_slip", relative, FrictionRole.LIMITED_SLIP),
        )

    def _friction(
        self, name: str, part: Literal["loss", "limited_slip"], velocity: str, role: FrictionRole
    ) -> tuple[Friction, ...]:
        if getattr(self, part) is None:
            return ()
        row = {velocity: sp.Integer(1)}
        return (load_dependent(self, name, part, row, role, f"{name}.input"),)

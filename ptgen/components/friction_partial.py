"""What clutches, brakes, bearings and gearboxes with clutches share: sliding surfaces with the law (3.12).

All obey the same law, because it is the same contact: two surfaces under a normal force with some lubricant in
between. They differ in what the velocity is taken against, and in whether somebody sets the normal force: that of a
clutch or a brake follows an actuation mu from 0 to 1, that of a bearing is always there. Since the actuation presses
the surfaces together, it scales all parts of the torque alike, the viscous one included, as (3.12) has it.

The keys of the law stand in the table of a component that is one friction element, and in a table of their own,
`DiskLaw`, in components that hold several or give their element a name.
"""

from __future__ import annotations

import functools
from typing import Annotated, Any, ClassVar

from pydantic import model_validator

from ptgen.components.component import Component, Quantity, Record, Switch
from ptgen.components.friction import FrictionRipple, FrictionSaturation, ripple_at, saturation_at
from ptgen.elements import Friction, FrictionRole, Row

__all__ = ["DiskLaw", "DiskPartial", "FrictionLaw", "FrictionPartial", "friction_at"]


class FrictionLaw(Record):
    """The law (3.12) of one pair of surfaces; what has it adds the key of its Coulomb torque."""

    strength: ClassVar[str]
    """The key of the Coulomb torque."""

    static: Annotated[float, Quantity("N m", "largest torque T_c,s that it holds at rest")] | None = None
    stribeck_speed: (
        Annotated[float, Quantity("rad/s", "velocity omega_c,s over which the torque falls from static")] | None
    ) = None
    viscous: Annotated[float, Quantity("N m s/rad", "viscous friction k_c,v", positive=False)] = 0.0
    saturation: FrictionSaturation | None = None
    ripple: FrictionRipple | None = None

    @model_validator(mode="after")
    def _stribeck(self) -> FrictionLaw:
        coulomb: float = getattr(self, self.strength)
        if self.static is None and self.stribeck_speed is not None:
            raise ValueError('stribeck_speed needs static; add static = "..." with the torque at rest, or remove it')
        if self.static is not None and self.static < coulomb:
            what = f"static must not be below {self.strength}, got {self.static:g} N m and {coulomb:g} N m"
            raise ValueError(f"{what}; exchange the two, or raise static")
        return self


class FrictionPartial(FrictionLaw, Component):
    """Base of the components that are one friction element."""

    def friction(self, name: str, row: Row, role: FrictionRole, *, actuated: bool) -> Friction:
        """Return the friction element of the component called `name`; it has the component's name."""
        return friction_at(self, name, row=row, role=role, actuated=actuated)


class DiskLaw(FrictionLaw):
    """Disks that are pressed together."""

    strength: ClassVar[str] = "capacity"

    capacity: Annotated[float, Quantity("N m", "Coulomb torque T_c,c at full actuation")]


class DiskPartial(DiskLaw, FrictionPartial):
    """Base of clutch and brake: disks that an actuation presses together."""

    actuated: Switch = True
    """Whether a scenario actuates it; otherwise it is always fully pressed."""


def friction_at(component: Component, name: str, *path: str, row: Row, role: FrictionRole, actuated: bool) -> Friction:
    """Return the friction element whose law stands at `path` of the component called `name`.

    Its name is that of the component, with the path: ``gearbox1.clutch``.
    """
    law: Any = functools.reduce(getattr, path, component)
    return Friction(
        ".".join((name, *path)),
        row,
        coulomb=component.symbol(name, *path, law.strength),
        viscous=component.symbol(name, *path, "viscous"),
        role=role,
        static=None if law.static is None else component.symbol(name, *path, "static"),
        stribeck_speed=None if law.stribeck_speed is None else component.symbol(name, *path, "stribeck_speed"),
        saturated=saturation_at(component, name, *path, "saturation"),
        ripple=ripple_at(component, name, *path, "ripple"),
        actuated=actuated,
    )

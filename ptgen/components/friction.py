"""The friction laws that components share, as they stand in the file."""

from __future__ import annotations

import functools
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, field_validator

from ptgen.components.component import Component, Quantity, Record
from ptgen.elements import Friction, FrictionRole, Load, Ripple, Row, Saturation

__all__ = [
    "FrictionRipple",
    "FrictionSaturation",
    "LoadDependentFriction",
    "MeshLoss",
    "load_dependent",
    "mesh_losses",
    "ripple_at",
    "saturation_at",
]

_HIGHEST_ORDER = 1000
"""Orders beyond this are slips of the pen: no sampled plant would follow them at any speed."""


def _order(value: object) -> object:
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= _HIGHEST_ORDER:
        what = f"must be a whole number from 1 to {_HIGHEST_ORDER}, got {value!r}"
        raise ValueError(f"{what}; write how often the torque swells per revolution, e.g. 2")
    return value


class FrictionSaturation(Record):
    r"""A part of the torque that grows with the velocity up to `speed` and is constant beyond.

    .. math:: T = k \min(|\omega|, \omega_{sat})\,\mathrm{sgn}(\omega)

    The source's term :math:`f_\omega` of Sections 3.6.3 and 3.8, without its factor :math:`|T_{di}|`.
    """

    slope: Annotated[float, Quantity("N m s/rad", "slope k of the torque at small velocities")]
    speed: Annotated[float, Quantity("rad/s", "velocity from which on that torque is constant")]


class FrictionRipple(Record):
    r"""Dependence of a friction capacity on the angle of its element, Section 3.8 of the source.

    .. math:: 1 + a \sin(n \varphi + \varphi_0), \qquad \varphi = \int \omega\,dt
    """

    amplitude: Annotated[float, Quantity("", "amplitude a of the swelling, as a share of the capacity", positive=False)]
    order: Annotated[int, BeforeValidator(_order), Field(json_schema_extra={"minimum": 1, "maximum": _HIGHEST_ORDER})]
    """How often the capacity swells per revolution, n."""
    phase: Annotated[float, Quantity("rad", "phase of the swelling at the start", positive=False, signed=True)] = 0.0

    @field_validator("amplitude")
    @classmethod
    def _share(cls, value: float) -> float:
        if value > 1:
            raise ValueError(f"must be from 0 to 1, got {value:g}; a capacity cannot be negative at any angle")
        return value


class LoadDependentFriction(Record):
    r"""Coulomb, load-dependent and viscous friction, the laws (3.34) and (3.35) of the source.

    .. math:: T = (T_0 + k_T |T_{di}|)\,\mathrm{sgn}(\omega) + k_\omega \omega

    At standstill the first part is set-valued: any torque up to the capacity that keeps the element sticking. On
    request the first part swells with the angle, and a part that saturates is added.
    """

    coulomb: Annotated[float, Quantity("N m", "Coulomb friction torque T_0", positive=False)] = 0.0
    load: Annotated[float, Quantity("", "friction torque per unit of input torque, k_T", positive=False)] = 0.0
    viscous: Annotated[float, Quantity("N m s/rad", "viscous friction, k_omega", positive=False)] = 0.0
    saturation: FrictionSaturation | None = None
    ripple: FrictionRipple | None = None


def _below_one(loss: LoadDependentFriction) -> LoadDependentFriction:
    if loss.load >= 1:
        raise ValueError(
            f"load must be below 1, got {loss.load:g}: teeth that lose 100 % transmit nothing; "
            "it is 1 less the efficiency, such as 0.02"
        )
    return loss


MeshLoss = Annotated[LoadDependentFriction, AfterValidator(_below_one)]
"""Friction of teeth: its load is 1 less their efficiency."""


def load_dependent(component: Component, name: str, part: str, row: Row, role: FrictionRole, place: str) -> Friction:
    """Return the friction element ``<name>.<part>`` with the law at `part` of the component called `name`.

    Parameters
    ----------
    component : Component
    name : str
    part : str
        The key of a `LoadDependentFriction`.
    row : Row
        The velocity that it acts on.
    role : FrictionRole
    place : str
        The flange whose torque its capacity depends on.
    """
    return Friction(
        f"{name}.{part}",
        row,
        coulomb=component.symbol(name, part, "coulomb"),
        viscous=component.symbol(name, part, "viscous"),
        role=role,
        load=Load(component.symbol(name, part, "load"), place),
        saturated=saturation_at(component, name, part, "saturation"),
        ripple=ripple_at(component, name, part, "ripple"),
    )


def mesh_losses(component: Component, name: str, rolling: Row, place: str) -> tuple[Friction, ...]:
    """Return the friction of teeth that roll with the velocity `rolling`, if the component has a ``loss``."""
    if _at(component, ("loss",)) is None:
        return ()
    return (load_dependent(component, name, "loss", rolling, FrictionRole.LOSS, place),)


def saturation_at(component: Component, name: str, *path: str) -> Saturation | None:
    """Return the saturated part of the friction law at `path` of the component called `name`, if there is one."""
    if _at(component, path) is None:
        return None
    return Saturation(component.symbol(name, *path, "slope"), component.symbol(name, *path, "speed"))


def ripple_at(component: Component, name: str, *path: str) -> Ripple | None:
    """Return the dependence on the angle at `path` of the component called `name`, if there is one."""
    law = _at(component, path)
    if law is None:
        return None
    return Ripple(component.symbol(name, *path, "amplitude"), law.order, component.symbol(name, *path, "phase"))


def _at(component: Component, path: tuple[str, ...]) -> Any:
    return functools.reduce(getattr, path, component)

"""The friction law that gears and differentials share."""

from __future__ import annotations

from typing import Annotated, Literal

from ptgen.components.component import Component, Quantity, Record
from ptgen.elements import Friction, FrictionRole, Load, Row

__all__ = ["LoadDependentFriction", "differential_frictions"]


class LoadDependentFriction(Record):
    r"""Coulomb, load-dependent and viscous friction, the laws (3.34) and (3.35) of the source.

    .. math:: T = (T_0 + k_T |T_{di}|)\,\mathrm{sgn}(\omega) + k_\omega \omega

    At standstill the first part is set-valued: any torque up to the capacity that keeps the element sticking.
    """

    coulomb: Annotated[float, Quantity("N m", "Coulomb friction torque T_0", positive=False)] = 0.0
    load: Annotated[float, Quantity("", "friction torque per unit of input torque, k_T", positive=False)] = 0.0
    viscous: Annotated[float, Quantity("N m s/rad", "viscous friction, k_omega", positive=False)] = 0.0


def differential_frictions(component: Component, name: str, loss_row: Row, slip_row: Row) -> tuple[Friction, ...]:
    """Return the loss (3.34) and the limited slip (3.35) of a differential, those of them that it has.

    Both depend on the torque at the input flange.
    """

    def friction(part: Literal["loss", "limited_slip"], row: Row, role: FrictionRole) -> tuple[Friction, ...]:
        if getattr(component, part) is None:
            return ()
        return (
            Friction(
                f"{name}.{part}",
                row,
                component.symbol(name, part, "coulomb"),
                component.symbol(name, part, "viscous"),
                role,
                Load(component.symbol(name, part, "load"), f"{name}.input"),
            ),
        )

    return friction("loss", loss_row, FrictionRole.LOSS) + friction("limited_slip", slip_row, FrictionRole.LIMITED_SLIP)

"""The friction law that gears and differentials share."""

from __future__ import annotations

from typing import Annotated

from ptgen.components.component import Quantity, Record

__all__ = ["LoadDependentFriction"]


class LoadDependentFriction(Record):
    r"""Coulomb, load-dependent and viscous friction, the laws (3.34) and (3.35) of the source.

    .. math:: T = (T_0 + k_T |T_{di}|)\,\mathrm{sgn}(\omega) + k_\omega \omega

    At standstill the first part is set-valued: any torque up to the capacity that keeps the element sticking.
    """

    coulomb: Annotated[float, Quantity("N m", "Coulomb friction torque T_0", positive=False)] = 0.0
    load: Annotated[float, Quantity("", "friction torque per unit of input torque, k_T", positive=False)] = 0.0
    viscous: Annotated[float, Quantity("N m s/rad", "viscous friction, k_omega", positive=False)] = 0.0

r"""Hydrodynamic torque converter with lock-up clutch: pump, turbine, and the fluid between them.

Flanges
    ``pump`` and ``turbine``. In a chain it is entered at the pump. A torque is positive when the pump drives the
    turbine.
Equations
    .. math:: I_p\,\dot\omega_p = T_1 - T_c - T_p \qquad (3.40)

    .. math:: I_t\,\dot\omega_t = T_c + T_t - T_2 \qquad (3.41)

    With the speed ratio :math:`\nu` and the maps of torque ratio :math:`\mu` and pump torque :math:`T_{pc}`

    .. math:: \nu = \frac{\omega_t}{\omega_p} \quad (3.37), \qquad T_t = \mu(\nu)\,T_p \quad (3.38), \qquad
        T_p = \left(\frac{\omega_p}{\omega_{pc}}\right)^2 T_{pc}(\nu) \quad (3.39)

    where the pump is the faster wheel, :math:`|\nu| \le 1`; where the turbine is, the torques grow with
    :math:`\omega_t^2` over :math:`1 / \nu`. So (3.37) never divides by zero. Between the points of the maps
    :math:`T_{pc}` and :math:`\mu` are monotone cubics. `ptgen.components.fluid_sectors` tells what holds in which
    quadrant.

    :math:`T_c` is the torque of the lock-up clutch, the friction element ``<name>.lockup`` on
    :math:`\omega_p - \omega_t` with the law (3.12).
Assumptions
    Stationary maps: the fluid has no inertia, and its torques follow the speeds at once. No torque without slip. The
    fluid never gives out more power than it takes. Turning backward the converter is a fluid coupling. Analyses of
    the linear bed leave the torques of the fluid out.
Reference
    (3.37)-(3.41), Figures 3.14 and 3.15, Section 3.7.1; (3.12), Section 3.5.
"""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

import sympy as sp
from pydantic import model_validator

from ptgen.components.component import Component, Flange, Quantity
from ptgen.components.converter_maps import CoastMap, DriveMap, ReverseMap
from ptgen.components.fluid_sectors import Gain, energy_gains, four_sectors
from ptgen.components.friction_partial import DiskLaw, friction_at
from ptgen.components.map_table import Finding, refuse
from ptgen.elements import Elements, FluidCoupling, FluidSector, FrictionRole

__all__ = ["TorqueConverter"]


class TorqueConverter(Component):
    """A torque converter."""

    type_name: ClassVar[str] = "torque_converter"
    summary: ClassVar[str] = "hydrodynamic torque converter with lock-up clutch"
    flanges: ClassVar[tuple[Flange, ...]] = (Flange("pump"), Flange("turbine"))

    type: Literal["torque_converter"]
    inertia_pump: Annotated[float, Quantity("kg m^2", "moment of inertia I_p of the pump")]
    inertia_turbine: Annotated[float, Quantity("kg m^2", "moment of inertia I_t of the turbine")]
    reference_speed: Annotated[float, Quantity("rad/s", "speed omega_pc of the faster wheel for which the maps hold")]
    drive: DriveMap
    """Torque ratio and pump torque over the speed ratio from 0 to 1."""
    reverse: ReverseMap | None = None
    """The same over the speed ratio from -1 to 0; without it the torques are those of stall."""
    coast: CoastMap | None = None
    """The turbine drives the pump; without it a fluid coupling with the pump torques of the drive map."""
    lockup: DiskLaw | None = None
    """The lock-up clutch, if there is one."""

    @model_validator(mode="after")
    def _maps_fit(self) -> TorqueConverter:
        found: list[Finding] = []
        if self.reverse is not None:
            found += [(("reverse", *where), text) for where, text in self.reverse.meets(self.drive)]
        refuse("TorqueConverter", found or [self._gain(gain) for gain in energy_gains(self.sectors())])
        return self

    def sectors(self) -> tuple[FluidSector, FluidSector, FluidSector, FluidSector]:
        """Return the torques of the fluid in all quadrants, see `ptgen.components.fluid_sectors`."""
        reverse = None if self.reverse is None else self.reverse.curve()
        coast = None if self.coast is None else self.coast.curve()
        return four_sectors(self.drive.curve(), reverse, coast)

    def _gain(self, gain: Gain) -> Finding:
        """Return what to say of points between which energy would be created."""
        points = self.sectors()[gain.sector].share
        first, last = points[gain.interval], points[gain.interval + 1]
        name = "coast" if gain.sector == 1 else "reverse" if last <= 0 and self.reverse is not None else "drive"
        what = f"the curves between the speed ratios {first:g} and {last:g} create energy at {gain.share:.3g}"
        return (name, "torque_ratio"), f"{what}; lower the torque ratios beside it, or add a point in between"

    def elements(self, name: str) -> Elements:
        pump, turbine = f"{name}.pump", f"{name}.turbine"
        reference = self.symbol(name, "reference_speed")
        fluid = FluidCoupling(f"{name}.fluid", pump, turbine, reference, self.sectors())
        row = {pump: sp.Integer(1), turbine: sp.Integer(-1)}
        lockup = () if self.lockup is None else ("lockup",)
        return Elements(
            bodies=self.disk_bodies(name),
            frictions=tuple(
                friction_at(self, name, part, row=row, role=FrictionRole.COUPLING, actuated=True) for part in lockup
            ),
            fluids=(fluid,),
        )

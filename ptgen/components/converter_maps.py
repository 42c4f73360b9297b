"""The maps of a torque converter as they stand in the file, and what makes them impossible."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Annotated, ClassVar, Self

from pydantic import model_validator

from ptgen.components.component import Quantity
from ptgen.components.fluid_sectors import Curve
from ptgen.components.map_table import Finding, MapTable, disorder, refuse

__all__ = ["CoastMap", "ConverterMap", "DriveMap", "ReverseMap"]

_Share = Annotated[float, Quantity("", "speed ratio", positive=False, signed=True)]
_Ratio = Annotated[float, Quantity("", "torque ratio", positive=False)]
_Torque = Annotated[float, Quantity("N m", "torque at the reference speed", positive=False)]


class ConverterMap(MapTable, ABC):
    """Base of the maps: points over a speed ratio that cover an interval without a gap."""

    begin: ClassVar[float] = 0.0
    end: ClassVar[float] = 1.0
    ends_without_torque: ClassVar[bool] = True
    torque_key: ClassVar[str] = "pump_torque"

    speed_ratio: tuple[_Share, ...]
    """Speed of the slower wheel over that of the faster one, strictly rising."""

    @model_validator(mode="after")
    def _possible(self) -> Self:
        refuse(type(self).__name__, self._shape() or self._physics())
        return self

    def _shape(self) -> list[Finding]:
        """Return what is wrong with the number of points, their order, and their ends."""
        share, found = self.speed_ratio, disorder(self.speed_ratio, "speed_ratio")
        count = len(share)
        for key in type(self).model_fields:
            values = getattr(self, key)
            if values is not None and len(values) != count:
                what = f"must have as many entries as speed_ratio ({count}), got {len(values)}"
                found.append(((key,), f"{what}; give one for each speed ratio"))
        if count < 2:
            what = f"needs two points at least, got {count}"
            return [*found, (("speed_ratio",), f"{what}; add those at {self.begin:g} and {self.end:g}")]
        if share[0] != self.begin:
            what = f"must begin at {self.begin:g}, got {share[0]:g}"
            found.append((("speed_ratio", 0), f"{what}; the map would leave a gap, add the point at {self.begin:g}"))
        if share[-1] != self.end:
            what = f"must end at {self.end:g}, got {share[-1]:g}"
            last = ", where no torque is left" if self.ends_without_torque else ""
            remedy = f"the map would leave a gap, add the point at {self.end:g}{last}"
            found.append((("speed_ratio", count - 1), f"{what}; {remedy}"))
        return found

    def _physics(self) -> list[Finding]:
        """Return the points that no fluid can have."""
        found: list[Finding] = []
        torque = getattr(self, self.torque_key)
        if self.ends_without_torque and torque[-1] != 0:
            what = f"must be 0 N m at equal speeds, got {torque[-1]:g} N m"
            remedy = "without slip the fluid does not circulate, and the curves of drive and coast meet there"
            found.append(((self.torque_key, len(torque) - 1), f"{what}; {remedy}"))
        for k, (share, ratio) in enumerate(zip(self.speed_ratio, self.ratios(), strict=True)):
            if ratio * share > 1 + 1e-12 and (torque[k] > 0 or share == 1):
                percent = 100 * ratio * share
                what = f"creates energy: {ratio:g} at speed ratio {share:g} is an efficiency of {percent:.4g} %"
                least = "at most" if share > 0 else "at least"
                found.append((("torque_ratio", k), f"{what}; it must be {least} {1 / share:.6g} there"))
        return found

    @abstractmethod
    def ratios(self) -> tuple[float, ...]:
        """Return the torque of the slower wheel over that of the faster one at each point."""


class DriveMap(ConverterMap):
    """The converter drives: the pump is faster than the turbine, and both turn forward."""

    torque_ratio: tuple[_Ratio, ...]
    """Turbine torque over pump torque, mu."""
    pump_torque: tuple[_Torque, ...]
    """Torque that the pump takes at the reference speed, T_pc."""

    def ratios(self) -> tuple[float, ...]:
        return self.torque_ratio

    def _physics(self) -> list[Finding]:
        found = super()._physics()
        share, ratio, torque = self.speed_ratio, self.torque_ratio, self.pump_torque
        if torque[0] == 0:
            found.append((("pump_torque", 0), "must be > 0 N m at stall, got 0 N m; a converter takes torque there"))
        for k in range(1, len(share)):
            if ratio[k] > ratio[k - 1]:
                what = f"must not rise with the speed ratio, got {ratio[k]:g} after {ratio[k - 1]:g}"
                remedy = "the flow turns less the faster the turbine is; correct the point"
                found.append((("torque_ratio", k), f"{what}; {remedy}"))
            if share[k - 1] > 0 and torque[k] * share[k - 1] ** 2 > torque[k - 1] * share[k] ** 2 * (1 + 1e-12):
                what = (
                    f"rises from {torque[k - 1]:g} N m to {torque[k]:g} N m, faster than the square of the speed ratio"
                )
                remedy = "at a held turbine the pump torque would fall as the pump gets faster; correct the point"
                found.append((("pump_torque", k), f"{what}; {remedy}"))
        return found

    def curve(self) -> Curve:
        """Return the torque of the pump, and that of the turbine by it."""
        return Curve(self.speed_ratio, self.pump_torque, self.torque_ratio)


class ReverseMap(ConverterMap):
    """The pump is faster and turns forward, the turbine turns backward."""

    begin: ClassVar[float] = -1.0
    end: ClassVar[float] = 0.0
    ends_without_torque: ClassVar[bool] = False

    torque_ratio: tuple[Annotated[float, Quantity("", "torque ratio", positive=False, signed=True)], ...]
    """Turbine torque over pump torque, mu."""
    pump_torque: tuple[_Torque, ...]
    """Torque that the pump takes at the reference speed."""

    def ratios(self) -> tuple[float, ...]:
        return self.torque_ratio

    def meets(self, drive: DriveMap) -> list[Finding]:
        """Return in which torques the map does not end where the drive map begins."""
        found: list[Finding] = []
        last = len(self.speed_ratio) - 1
        for key, unit in (("torque_ratio", ""), ("pump_torque", " N m")):
            here, there = getattr(self, key)[-1], getattr(drive, key)[0]
            if abs(here - there) > 1e-9 * abs(there):
                what = f"does not meet the drive map at speed ratio 0, got {here:g}{unit}, there {there:g}{unit}"
                found.append(((key, last), f"{what}; write the same value in both"))
        return found

    def curve(self) -> Curve:
        """Return the torque of the pump, and that of the turbine by it."""
        return Curve(self.speed_ratio, self.pump_torque, self.torque_ratio)


class CoastMap(ConverterMap):
    """The bed drives the converter: the turbine is faster than the pump, and both turn forward."""

    torque_key: ClassVar[str] = "turbine_torque"

    turbine_torque: tuple[_Torque, ...]
    """Torque that the turbine takes at the reference speed, over pump speed by turbine speed."""
    torque_ratio: tuple[_Ratio, ...] | None = None
    """Pump torque over turbine torque; 1 without it, a fluid coupling."""

    def ratios(self) -> tuple[float, ...]:
        return self.torque_ratio or (1.0,) * len(self.speed_ratio)

    def curve(self) -> Curve:
        """Return the torque of the turbine, which brakes it, and that of the pump by it."""
        return Curve(self.speed_ratio, tuple(-torque + 0.0 for torque in self.turbine_torque), self.ratios())

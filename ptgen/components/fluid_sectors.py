r"""The torques of a fluid coupling in all four quadrants, from the curves that were measured in some of them.

The plane of the two speeds has four sectors, by the faster wheel and its sense. In each the torques grow with the
square of the faster speed and depend on the other's share of it, from -1 to 1, so nothing is ever divided by zero:

====================== ================= ==================================================================
faster wheel           share             torques
====================== ================= ==================================================================
pump, forward          from 0 to 1       the drive map
pump, forward          from -1 to 0      the reverse map; without one those of stall
turbine, forward       from 0 to 1       the coast map; without one ``T_p = T_t = -`` pump torque of the drive map
turbine, forward       from -1 to 0      those of the coast map at 0
pump, backward         from 0 to 1       ``T_p = T_t = -`` pump torque of the drive map
turbine, backward      from 0 to 1       ``T_p = T_t =`` pump torque of the drive map
both, backward         from -1 to 0      between the value at 0 and that of the neighbouring sector at -1
====================== ================= ==================================================================

Blades are made for one sense of rotation; turning backward a converter is taken for a fluid coupling, without
multiplication of the torque. Neighbouring sectors have the same torques at their border.

Between the points the torque of the faster wheel and the ratio of the two are monotone cubics (Fritsch and Carlson), so
the efficiency between two points stays within what the ratios at both allow; the slower wheel's torque is the product.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.elements import FluidSector

__all__ = ["Curve", "Gain", "energy_gains", "four_sectors"]

_LOOKS = 32
"""How often the energy is looked at between two points."""

Polynomial = tuple[float, ...]


@dataclass(frozen=True)
class Curve:
    """Torque of the faster wheel (N m), and that of the slower one as a multiple of it, over the slower one's share."""

    share: tuple[float, ...]
    torque: tuple[float, ...]
    ratio: tuple[float, ...]

    def like_coupling(self, sign: float) -> Curve:
        """Return the curve of a fluid coupling of the same capacity: both torques are the same, times `sign`."""
        return Curve(self.share, tuple(sign * value + 0.0 for value in self.torque), (1.0,) * len(self.ratio))

    def from_minus_one(self) -> Curve:
        """Return the curve from -1 on; up to 0 it is constant."""
        return Curve((-1.0, *self.share), (self.torque[0], *self.torque), (self.ratio[0], *self.ratio))

    def ends(self) -> tuple[float, float]:
        """Return the torques of the faster and of the slower wheel at the first point."""
        return self.torque[0], self.ratio[0] * self.torque[0]

    def sector(self) -> FluidSector:
        """Return the curve as polynomials."""
        faster, ratio = _monotone(self.share, self.torque), _monotone(self.share, self.ratio)
        slower = tuple(_product(a, b) for a, b in zip(faster, ratio, strict=True))
        return FluidSector(self.share, faster, slower)


def four_sectors(
    drive: Curve, reverse: Curve | None, coast: Curve | None
) -> tuple[FluidSector, FluidSector, FluidSector, FluidSector]:
    """Return the curves of all sectors, in the order of `ptgen.elements.FluidCoupling`.

    Parameters
    ----------
    drive : Curve
        Pump faster, share from 0 to 1.
    reverse : Curve or None
        Pump faster, share from -1 to 0.
    coast : Curve or None
        Turbine faster, share from 0 to 1.
    """
    forward = drive.from_minus_one()
    if reverse is not None:
        parts = (reverse.share, drive.share), (reverse.torque, drive.torque), (reverse.ratio, drive.ratio)
        forward = Curve(*(first[:-1] + second for first, second in parts))
    braked = (coast or drive.like_coupling(-1.0)).from_minus_one()
    backward = [drive.like_coupling(sign).from_minus_one().sector() for sign in (-1.0, 1.0)]
    return (
        forward.sector(),
        braked.sector(),
        _joined(backward[0], braked.ends()[::-1]),
        _joined(backward[1], forward.ends()[::-1]),
    )


def _joined(sector: FluidSector, border: tuple[float, float]) -> FluidSector:
    """Return a sector that goes from the torques `border` at -1 to its own at 0, where it is flat."""
    faster, slower = (
        (_step(start, after[1][0]), *after[1:])
        for start, after in zip(border, (sector.faster, sector.slower), strict=True)
    )
    return FluidSector(sector.share, faster, slower)


def _step(start: float, end: float) -> Polynomial:
    """Return the cubic over an interval of length 1 that begins and ends without a slope."""
    return start, 0.0, 3.0 * (end - start), 2.0 * (start - end)


def _monotone(points: Sequence[float], values: Sequence[float]) -> tuple[Polynomial, ...]:
    from scipy.interpolate import PchipInterpolator  # takes a while to import, and few beds need it

    with np.errstate(over="ignore", under="ignore"):
        falling = PchipInterpolator(points, values).c
    return tuple(tuple(map(float, column[::-1])) for column in falling.T)


def _product(first: Polynomial, second: Polynomial) -> Polynomial:
    """Return the coefficients of a product, added up one after the other: the same on every machine."""
    result = [0.0] * (len(first) + len(second) - 1)
    for i, a in enumerate(first):
        for j, b in enumerate(second):
            result[i + j] += a * b
    return tuple(result)


@dataclass(frozen=True)
class Gain:
    """An interval of a sector in which the fluid would give out more power than it takes."""

    sector: int
    interval: int
    share: float


def energy_gains(sectors: Sequence[FluidSector]) -> list[Gain]:
    """Return the intervals of all sectors in which energy would be created, with the share where it is most.

    The fluid takes the power ``T_p w_p - T_t w_t``, which heats it.
    """
    found = []
    inside = (np.arange(_LOOKS) + 0.5) / _LOOKS
    for index, sector in enumerate(sectors):
        # The faster wheel puts power in, the slower one takes it out; for the turbine the torque counts the other way.
        sense = (1.0, -1.0, -1.0, 1.0)[index]
        rounding = 1e-9 * max(abs(part[0]) for part in (*sector.faster, *sector.slower))
        for interval, (begin, end) in enumerate(zip(sector.share, sector.share[1:], strict=False)):
            beyond = (end - begin) * inside
            faster, slower = (_at(curve[interval], beyond) for curve in (sector.faster, sector.slower))
            loss = sense * (faster - (begin + beyond) * slower)
            if loss.min() < -rounding:
                found.append(Gain(index, interval, float(begin + beyond[loss.argmin()])))
    return found


def _at(polynomial: Polynomial, beyond: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(np.polynomial.polynomial.polyval(beyond, polynomial), dtype=np.float64)

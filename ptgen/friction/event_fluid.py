"""The torques of a fluid for the event-driven reference, written down once more and not shared with the plant."""

from __future__ import annotations

from bisect import bisect_right

import numpy as np
from numpy.typing import NDArray

from ptgen.elements import FluidCoupling

__all__ = ["EventFluid"]


class EventFluid:
    """The torques of a fluid, sector by sector.

    Parameters
    ----------
    fluid : FluidCoupling
    reference_speed : float
        (rad/s)
    """

    def __init__(self, fluid: FluidCoupling, reference_speed: float) -> None:
        self._reference = reference_speed
        self._sectors = fluid.sectors

    def torques(self, pump: float, turbine: float) -> NDArray[np.float64]:
        """Return the torques that the fluid takes from the pump and exerts on the turbine (N m)."""
        if pump == turbine == 0:
            return np.zeros(2)
        turbine_leads = abs(turbine) > abs(pump)
        fast, slow = (turbine, pump) if turbine_leads else (pump, turbine)
        sector = self._sectors[(0 if fast > 0 else 2) + turbine_leads]
        interval = min(bisect_right(sector.share, slow / fast), len(sector.share) - 1) - 1
        beyond = slow / fast - sector.share[interval]
        pair = [
            float(np.polynomial.polynomial.polyval(beyond, curve[interval])) * (fast / self._reference) ** 2
            for curve in (sector.faster, sector.slower)
        ]
        return np.array(pair[::-1] if turbine_leads else pair)

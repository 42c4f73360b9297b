"""Poles of the emitted closed loop: plant and controller as they run, dead time and sampling included."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.analysis.frequency import NEUTRAL
from ptgen.analysis.linear import LoopFamily
from ptgen.block.block import Block

__all__ = ["Pole", "closed_loop_poles", "poles_of"]


@dataclass(frozen=True)
class Pole:
    """A pole of the sampled closed loop.

    Attributes
    ----------
    z : complex
        In the plane of the sampled system.
    s : complex
        ``log(z) / h`` (1/s).
    frequency_hz, damping_ratio : float
        Of the equivalent continuous pole.
    """

    z: complex
    s: complex
    frequency_hz: float
    damping_ratio: float

    @property
    def is_unstable(self) -> bool:
        """Whether the pole lies outside the unit circle by more than rounding; a part that coasts is on it."""
        return abs(self.z) > 1 + NEUTRAL

    @property
    def is_neutral(self) -> bool:
        """Whether the pole belongs to a part that coasts or a quantity that nothing changes."""
        return abs(self.z - 1) <= NEUTRAL


def poles_of(matrix: NDArray[np.float64], sample_time: float) -> tuple[Pole, ...]:
    """Return the poles of a sampled system by frequency; those at z = 0, which are delays, are left out."""
    poles = []
    for z in np.linalg.eigvals(matrix):
        if abs(z) < 1e-6:
            continue
        s = complex(np.log(complex(z)) / sample_time)
        size = abs(s)
        poles.append(Pole(complex(z), s, size / (2 * np.pi), float(-s.real / size) if size > 0 else 1.0))
    return tuple(sorted(poles, key=lambda pole: pole.frequency_hz))


def closed_loop_poles(
    controller: Block, plant: Block, parameters: Mapping[str, float] | None = None
) -> tuple[Pole, ...]:
    """Return the poles of one step of both blocks in closed loop, linearised at rest, by frequency.

    All friction elements are free, see `ptgen.plant.free`. States on which no torque depends are left out: latches,
    counters, monitors.

    Parameters
    ----------
    controller, plant : Block
        The plant with closed gaps; a gap would be open at rest.
    parameters : mapping, optional
        Parameters that differ from the defaults, by name.
    """
    loop = LoopFamily(controller, plant).delayed(parameters)
    return poles_of(loop.closed(), loop.sample_time)

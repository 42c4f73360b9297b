r"""Torques of a fluid between pump and turbine: NumPy reference.

The faster wheel decides on the sector and on the scale, :math:`a^2` with its speed a; the torques depend on the share
of the other wheel, :math:`x = b / a` from -1 to 1. So nothing is divided by a speed that may be zero.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["FASTER", "ROWS", "SLOWER", "fluid_torques"]

Array = NDArray[np.float64]

FASTER = 4
"""Coefficients of the torque of the faster wheel."""

SLOWER = 7
"""Coefficients of the torque of the slower wheel."""

ROWS = FASTER + SLOWER
"""Coefficients of both."""


def fluid_torques(pump: Array, turbine: Array, knots: Array, curves: Array) -> tuple[Array, Array]:
    """Return the torque that a fluid takes from the pump, and the one that it exerts on the turbine.

    Parameters
    ----------
    pump, turbine : ndarray (...)
        Speeds, by the reference speed. If one of them is not finite, or too large to be squared, both torques are zero.
    knots : ndarray (n, 4)
        Shares from which each polynomial holds, rising from -1; the rest of a column is above 1. The sectors are: pump
        faster and forward, turbine faster and forward, then the same backward.
    curves : ndarray (ROWS, 4 n)
        Coefficients of both torques, in rising powers of what is beyond that share (N m); n columns for each sector.

    References
    ----------
    Source (3.37)-(3.39).
    """
    pump, turbine = np.broadcast_arrays(np.asarray(pump, dtype=float), np.asarray(turbine, dtype=float))
    n = knots.shape[-2]
    with np.errstate(invalid="ignore", over="ignore"):
        by_turbine = np.abs(turbine) > np.abs(pump)
        leading, other = np.where(by_turbine, turbine, pump), np.where(by_turbine, pump, turbine)
        square = leading * leading
        turning = (square > 0.0) & np.isfinite(square + other)
        share = np.where(turning, other, 0.0) / np.where(turning, leading, 1.0)
    sector = by_turbine + 2 * (turning & (leading < 0.0))
    first = knots.T[sector]
    k = (share[..., None] >= first[..., 1:]).sum(axis=-1)
    c = curves.T[sector * n + k]
    beyond = share - np.take_along_axis(first, k[..., None], -1)[..., 0]
    faster, slower = _polynomial(c[..., :FASTER], beyond), _polynomial(c[..., FASTER:], beyond)
    scale = np.where(turning, square, 0.0)
    return scale * np.where(by_turbine, slower, faster), scale * np.where(by_turbine, faster, slower)


def _polynomial(coefficients: Array, x: Array) -> Array:
    result = coefficients[..., -1]
    for k in range(coefficients.shape[-1] - 2, -1, -1):
        result = result * x + coefficients[..., k]
    return np.asarray(result, dtype=np.float64)

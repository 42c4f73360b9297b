"""Curves of long runs, thinned so that figures stay small and look the same."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["POINTS", "thinned"]

POINTS = 20_000
"""Points per curve above which every few of them are drawn as their least and greatest value."""


def thinned(
    time: NDArray[np.float64], values: NDArray[np.float64], points: int = POINTS
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return a curve with fewer points that looks the same: least and greatest value of every few points."""
    size = len(values)
    if size <= points:
        return time, values
    step = -(-2 * size // points)
    whole = size - size % step
    blocks = values[:whole].reshape(-1, step)
    first = np.arange(len(blocks)) * step
    ends = np.sort(np.column_stack([first + blocks.argmin(axis=1), first + blocks.argmax(axis=1)]), axis=1).ravel()
    chosen = np.unique(np.concatenate([ends, [0, size - 1]]))
    return time[chosen], values[chosen]

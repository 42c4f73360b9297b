"""References that are led together: of one kind, wanted at the same value, and at the same value now."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["leaders"]

Array = NDArray[np.float64]


def leaders(wanted: Array, before: Array, tie: float, group: Array) -> list[int]:
    """Return the first reference that each reference is tied to; itself if it is free.

    Parameters
    ----------
    wanted, before : ndarray (m,)
        References as they are asked for, and shaped ones of the last step (rad/s or N m).
    tie : float
        Two references closer than this, before and wanted, are tied.
    group : ndarray (m,)
        References with the same positive number may be tied.

    Examples
    --------
    >>> leaders(np.array([0.0, 5.0, 5.1]), np.array([0.0, 2.0, 2.0]), 0.2, np.array([0.0, 1.0, 1.0]))
    [0, 1, 1]
    """
    result: list[int] = []
    for i in range(len(wanted)):
        leader = i
        for j in range(i):
            same = group[i] == group[j] and group[i] > 0
            if leader == i and same and abs(wanted[i] - wanted[j]) < tie and abs(before[i] - before[j]) < tie:
                leader = result[j]
        result.append(leader)
    return result

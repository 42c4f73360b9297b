"""How many digits of a matrix are emitted.

More would emit the rounding errors of the linear algebra at hand, which differ from machine to machine.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["rounded", "significant"]

_JUST_BELOW = 1 + 1e-6
"""A number this close below a power of ten counts as that power: which side it is on may be rounding."""


def rounded(matrix: NDArray[np.float64], digits: int = 7) -> NDArray[np.float64]:
    """Round every column to so many digits of its largest number.

    Examples
    --------
    >>> rounded(np.array([[100 / 3, 1.0], [1e-12, 2.0]]), 5)
    array([[33.333,  1.   ],
           [ 0.   ,  2.   ]])
    """
    result = np.zeros_like(matrix)
    for k, column in enumerate(matrix.T):
        largest = np.abs(column).max(initial=0.0)
        if largest > 0:
            decimals = digits - 1 - int(np.floor(np.log10(largest * _JUST_BELOW)))
            result[:, k] = [float(f"{value:.{max(decimals, 0)}f}") for value in column]
    return result + 0.0  # no negative zeros


def significant(matrix: NDArray[np.float64], digits: int = 9) -> NDArray[np.float64]:
    """Round every number to so many digits; what is far below the largest of its column is zero.

    Examples
    --------
    >>> significant(np.array([[100 / 3, 1e-12], [2e-3 / 3, 2.0]]), 5)
    array([[3.3333e+01, 0.0000e+00],
           [6.6667e-04, 2.0000e+00]])
    """
    size = np.abs(matrix)
    large = size > 1e-10 * size.max(axis=0, keepdims=True)
    texts = [f"{value:.{digits - 1}e}" for value in np.where(large, matrix, 0.0).ravel()]
    return np.array([float(text) for text in texts]).reshape(matrix.shape) + 0.0

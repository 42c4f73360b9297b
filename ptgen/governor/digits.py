"""How many digits of a matrix are emitted."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["nine_digits"]


def nine_digits(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """Round every number to nine digits: more would emit the rounding errors of the linear algebra at hand.

    Examples
    --------
    >>> nine_digits(np.array([[1 / 3, 0.0]]))
    array([[0.33333333, 0.        ]])
    """
    return np.array([float(f"{value:.8e}") for value in matrix.ravel()]).reshape(matrix.shape)

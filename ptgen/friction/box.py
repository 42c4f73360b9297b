r"""Friction torques of one step: the box-constrained complementarity problem, NumPy reference.

Given the friction velocities :math:`w` that the end of the step would have without friction torques and
:math:`w^+ = w - K T` with symmetric positive definite :math:`K`, find :math:`T` with

.. math::
    |T_i| \le m_i, \qquad w^+_i > 0 \Rightarrow T_i = m_i, \qquad w^+_i < 0 \Rightarrow T_i = -m_i,
    \qquad |T_i| < m_i \Rightarrow w^+_i = 0 .

The velocity of a sticking element is returned as exactly zero. For two elements three clamps give the nine
sectors of the source's Figure 4.7.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["MAX_ELEMENTS", "solve_box"]

MAX_ELEMENTS = 2
"""The number of elements up to which there is a closed form."""

Array = NDArray[np.float64]


def solve_box(K: Array, w: Array, m: Array) -> tuple[Array, Array]:
    """Solve the problem of the module for one or two elements.

    Parameters
    ----------
    K : ndarray (..., n, n)
        Friction matrix (rad/s per N m), symmetric positive definite.
    w : ndarray (..., n)
        Velocities without friction torques (rad/s).
    m : ndarray (..., n)
        Capacities (N m), not negative.

    Returns
    -------
    T : ndarray (..., n)
        Friction torques (N m).
    w_plus : ndarray (..., n)
        Velocities at the end of the step (rad/s).

    Raises
    ------
    ValueError
        If there are more than `MAX_ELEMENTS` elements.

    References
    ----------
    Source (4.26)-(4.67), Figure 4.7, Table 4.1.
    """
    n = w.shape[-1]
    if n == 1:
        T = np.clip(w / K[..., 0, :], -m, m)
    elif n == 2:
        K11, K12, K21, K22 = K[..., 0, 0], K[..., 0, 1], K[..., 1, 0], K[..., 1, 1]
        w1, w2, m1, m2 = w[..., 0], w[..., 1], m[..., 0], m[..., 1]
        t2 = np.clip((K11 * w2 - K21 * w1) / (K11 * K22 - K12 * K21), -m2, m2)
        T1 = np.clip((w1 - K12 * t2) / K11, -m1, m1)
        T2 = np.clip((w2 - K21 * T1) / K22, -m2, m2)
        T = np.stack([T1, T2], axis=-1)
    else:
        raise ValueError(f"there is a closed form for up to {MAX_ELEMENTS} friction elements, got {n}")
    w_plus = w - np.einsum("...ij,...j->...i", K, T)
    return T, np.where(abs(T) < m, 0.0, w_plus)

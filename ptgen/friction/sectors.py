r"""The box problem of friction by enumeration of its sectors, for any number of elements.

Given accelerations (or velocities) :math:`w` without friction torques and a symmetric positive semidefinite
:math:`K`, find torques :math:`T` and :math:`a = w - K T` with

.. math::
    l_i \le T_i \le h_i, \qquad a_i > 0 \Rightarrow T_i = h_i, \qquad a_i < 0 \Rightarrow T_i = l_i,
    \qquad l_i < T_i < h_i \Rightarrow a_i = 0 .

Each element stands at its upper limit, at its lower limit, or sticks: :math:`3^n` sectors, the source's Figure 4.7
for :math:`n = 2`. Every sector is solved, and the one that violates the conditions least is the solution. That needs
no iteration that could fail, so it serves as reference for all other solvers; its cost forbids it anywhere else.

The conditions are those of the minimum of :math:`\frac12 T'KT - w'T` over the box. So :math:`a` is unique. If
:math:`K` is singular, :math:`T` is not: then the one with the least :math:`\sum K_{ii} T_i^2` is taken. Pinning some
elements to their limits and taking the least norm of the others reaches it, because that is the form of the
Karush-Kuhn-Tucker conditions of the least norm within the box.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

__all__ = ["SectorSolution", "enumerate_sectors"]

Array = NDArray[np.float64]

_RANK = 1e-10
"""Eigenvalues of the scaled friction matrix below this are none."""

_ROUNDING = 1e-12
"""Violations below this part of the torques involved are rounding."""


@dataclass(frozen=True)
class SectorSolution:
    """Solution of the box problem.

    Attributes
    ----------
    torques : ndarray (n,)
        ``T`` (N m).
    accelerations : ndarray (n,)
        ``a = w - K T`` (rad/s^2), exactly zero for the elements that stick.
    sector : ndarray of int (n,)
        +1 at the upper limit, -1 at the lower one, 0 sticking.
    violation : float
        Largest violation of a condition (N m): a torque beyond its limit, or an acceleration against its torque
        times the inertia ``1 / K_ii`` that the element feels. Rounding, if the problem has a solution.
    """

    torques: Array
    accelerations: Array
    sector: NDArray[np.int64]
    violation: float


def enumerate_sectors(K: Array, w: Array, lo: Array, hi: Array) -> SectorSolution:
    """Solve the box problem of the module.

    Parameters
    ----------
    K : ndarray (n, n)
        Friction matrix, symmetric positive semidefinite with a positive diagonal.
    w : ndarray (n,)
        Accelerations without friction torques.
    lo, hi : ndarray (n,)
        Limits of the torques, ``lo <= 0 <= hi``; one or both may be infinite.

    Returns
    -------
    SectorSolution

    Raises
    ------
    ValueError
        If the limits do not contain zero.

    References
    ----------
    Source (4.32)-(4.67), Figure 4.7, Table 4.1 for two elements.

    Examples
    --------
    Of two clutches side by side, with 2 N m and 10 N m, which hold 11 N m, the weaker one gives all that it can:

    >>> capacity = np.array([2.0, 10.0])
    >>> solution = enumerate_sectors(np.ones((2, 2)), np.array([11.0, 11.0]), -capacity, capacity)
    >>> solution.torques.round(9), solution.accelerations
    (array([2., 9.]), array([0., 0.]))
    """
    n = len(w)
    if not (np.all(lo <= 0) and np.all(hi >= 0)):
        raise ValueError("the limits of friction torques contain zero")
    if n == 0:
        empty = np.zeros(0)
        return SectorSolution(empty, empty, np.zeros(0, dtype=np.int64), 0.0)
    root = np.sqrt(np.diag(K))
    scaled = K / np.outer(root, root)  # unit diagonal: torques and accelerations in one unit, and the norm that counts
    free, low, high = w / root, lo * root, hi * root
    sectors = _sectors(n)
    allowed = np.all(np.where(sectors > 0, np.isfinite(high), True) & np.where(sectors < 0, np.isfinite(low), True), 1)
    sectors = sectors[allowed]
    sticks = sectors == 0
    pinned = np.where(sectors > 0, _finite(high), np.where(sectors < 0, _finite(low), 0.0))
    T = pinned + _held(scaled, sticks, free - pinned @ scaled)
    a = free - T @ scaled
    beyond = np.maximum(0.0, np.maximum(T - high, low - T))
    against = np.where(sticks, np.abs(a), np.maximum(0.0, -sectors * a))
    violation = (np.maximum(beyond, against) / root).max(axis=1)
    rounding = _ROUNDING * float(((np.abs(free) + np.abs(_finite(high)) + np.abs(_finite(low))) / root).max())
    possible = np.flatnonzero(violation <= violation.min() + rounding)
    norm = np.linalg.norm(T[possible], axis=1)
    least = possible[norm <= norm.min() * (1 + 1e-9) + rounding * root.max()]
    best = least[np.argmax(sticks[least].sum(axis=1))]
    torques = np.clip(T[best] / root, lo, hi)
    accelerations = np.where(sticks[best], 0.0, w - K @ torques)
    return SectorSolution(torques, accelerations, sectors[best], float(violation[best]))


@lru_cache(maxsize=16)
def _sectors(n: int) -> NDArray[np.int64]:
    return np.array(list(itertools.product((0, 1, -1), repeat=n)), dtype=np.int64)


def _finite(limits: Array) -> Array:
    return np.where(np.isfinite(limits), limits, 0.0)


def _held(K: Array, sticks: NDArray[np.bool_], rest: Array) -> Array:
    """Return for every sector the torques of least norm that hold its sticking elements against `rest`."""
    patterns, which = np.unique(sticks, axis=0, return_inverse=True)
    masks = patterns.astype(float)
    restricted = K * masks[:, :, None] * masks[:, None, :]
    inverses = np.linalg.pinv(restricted, rcond=_RANK, hermitian=True)
    held = np.einsum("sij,sj->si", inverses[which.ravel()], rest * sticks)
    return np.asarray(held * sticks, dtype=np.float64)

r"""Torques of shafts with backlash over one step, without making energy: NumPy reference.

With the twist e, the gap of half width b and the twist beyond it, :math:`p(e) = e - \mathrm{clip}(e, -b, b)`, the
shaft stores :math:`V = \tfrac12 c\,p^2`. Its torque is held over a step of length h and is

.. math::
    T = \frac{V(e^+) - V(e)}{e^+ - e} + d\,\frac{p(e^+) - p(e)}{h}, \qquad e^+ = e_{free} - \kappa T,

the source's (3.5) as a mean over the step. Its work on the rest of the bed, which is solved exactly, is then exactly
:math:`-T\,(e^+ - e) = V(e) - V(e^+) - d\,(p^+ - p)(e^+ - e)/h`, and the last product is never negative because p grows
with e: rattling through the gap cannot make energy, however coarse the step. T grows with :math:`e^+` because V is
convex, so the equation has one solution; on each side of the gap, and inside, it is a quadratic equation.

Several such shafts are solved in turn, `SWEEPS` times; what one does to the twist of another within a step is small.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["SWEEPS", "backlash_step"]

Array = NDArray[np.float64]

SWEEPS = 12
"""Rounds over several shafts with backlash."""


def backlash_step(kappa: Array, e: Array, e_free: Array, half_gap: Array, stiffness: Array, damping: Array) -> Array:
    """Return the torques of shafts with backlash over one step.

    Parameters
    ----------
    kappa : ndarray (..., n, n)
        Twist lost over the step per torque (rad per N m), symmetric positive definite.
    e, e_free : ndarray (..., n)
        Twists at the start, and at the end without these torques (rad).
    half_gap : ndarray (..., n)
        Half of each gap (rad).
    stiffness : ndarray (..., n)
        Stiffness c (N m/rad).
    damping : ndarray (..., n)
        Damping over the step, d / h (N m/rad).

    References
    ----------
    Source (3.5).
    """
    n = e.shape[-1]
    batch = np.broadcast_shapes(kappa.shape[:-2], e.shape[:-1], e_free.shape[:-1], half_gap.shape[:-1])
    T = np.zeros((*batch, n))
    for _ in range(SWEEPS if n > 1 else 1):
        for i in range(n):
            others = np.einsum("...j,...j->...", kappa[..., i, :], T) - kappa[..., i, i] * T[..., i]
            free = e_free[..., i] - others
            T[..., i] = _torque(kappa[..., i, i], e[..., i], free, half_gap[..., i], stiffness[..., i], damping[..., i])
    return T


def _torque(kappa: Array, e: Array, free: Array, b: Array, c: Array, d: Array) -> Array:
    p = e - np.clip(e, -b, b)

    def left_at(end: Array) -> Array:
        """Return ``end + kappa T(end) - free`` for an end of the gap; it is zero at the end of the step, and grows."""
        change = end - e
        mean = np.where(change == 0, 0.0, -0.5 * c * p**2 / np.where(change == 0, 1.0, change))
        return np.asarray(end + kappa * (mean - d * p) - free)

    above, below = left_at(b) < 0, left_at(-b) > 0
    side = np.where(above, 1.0, np.where(below, -1.0, 0.0))
    outside = np.abs(side)
    alpha = np.where(side == 0, 0.0, e - side * b)  # beyond the gap at the end: alpha + outside * change
    a2 = 1.0 + outside * kappa * (d + 0.5 * c)
    a1 = e - free + kappa * (d * (alpha - p) + c * alpha * outside)
    a0 = 0.5 * kappa * c * (alpha**2 - p**2)
    root = np.sqrt(np.maximum(a1**2 - 4.0 * a2 * a0, 0.0))
    # Of the two roots the one on the side of the motion; the other one belongs to another piece of p.
    same = (side != 0) & (p * side > 0)
    upward = np.where(side == 0, p < 0, side > 0)
    change = np.where(upward, -a1 + root, -a1 - root) / (2.0 * a2)
    change = np.where(same, -a1 / a2, change)
    change = np.where((side == 0) & (p == 0), free - e, change)
    beyond = alpha + outside * change
    secant = np.where(same, 1.0, np.where(change == 0, 0.0, (beyond - p) / np.where(change == 0, 1.0, change)))
    return np.asarray(0.5 * c * (beyond + p) * secant + d * (beyond - p))

r"""Independent checks of what a solver returns.

They hold for convex programs with limits on both sides of every row,

    min 1/2 z'P z + q'z   with   lower <= A z <= upper,   lo <= z <= hi.

For *any* multipliers ``y`` of the rows, with ``g = P z + q`` and ``c = g + A'y``, every admissible ``w`` has

    f(w) >= f(z) + g'(w - z) = f(z) - g'z + c'w - y'A w
         >= f(z) - g'z + min_box c'w - sum_j max(y_j lower_j, y_j upper_j)

so the difference to the right-hand side bounds how far ``f(z)`` is above the optimum, whoever found ``z`` and ``y``. It
is zero if and only if the conditions of Karush, Kuhn and Tucker hold. Signs of multipliers need not be trusted. The
same inequality without ``f`` proves that no admissible point exists (Farkas).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

__all__ = ["Convex", "excess", "multipliers_at", "optimality_gap", "proves_infeasible"]

Array = NDArray[np.float64]

_FAR = 1e6
"""Bound taken for unbounded variables, which the governors scale to about one, in proofs of infeasibility."""


@dataclass(frozen=True)
class Convex:
    """A convex program; what it is, and no way of solving it.

    Attributes
    ----------
    P : ndarray (n, n)
        Symmetric, positive semidefinite. Variables without bounds have a positive definite block of their own.
    q : ndarray (n,)
    A : ndarray (N, n)
    lower, upper : ndarray (N,)
    lo, hi : ndarray (n,)
    """

    P: Array
    q: Array
    A: Array
    lower: Array
    upper: Array
    lo: Array
    hi: Array


def excess(values: Array, lower: Array, upper: Array) -> Array:
    """Return by how much each value is outside its limits; negative inside.

    Examples
    --------
    >>> excess(np.array([2.0, 0.5]), np.zeros(2), np.ones(2))
    array([ 1. , -0.5])
    """
    return np.maximum(values - upper, lower - values)


def optimality_gap(program: Convex, z: Array, multipliers: Array) -> float:
    """Return a bound of ``f(z)`` less the optimum, from any multipliers of the rows (N,); infinite if they are useless.

    Slightly negative values mean that ``z`` violates limits slightly.

    Examples
    --------
    >>> one = np.ones(1)
    >>> lp = Convex(np.zeros((1, 1)), -one, 2 * one[:, None], -one, one, 0 * one, one)  # max z, |2 z| <= 1
    >>> optimality_gap(lp, 0.5 * one, 0.5 * one), optimality_gap(lp, 0.25 * one, 0.5 * one)
    (0.0, 0.25)
    """
    if not (np.isfinite(multipliers).all() and np.isfinite(z).all()):
        return np.inf
    gradient = program.P @ z + program.q
    held = gradient + program.A.T @ multipliers
    bounded = np.isfinite(program.lo) & np.isfinite(program.hi)
    least = np.where(held > 0, program.lo, program.hi)[bounded] @ held[bounded]
    if not bounded.all():
        left = held[~bounded]
        block = program.P[np.ix_(~bounded, ~bounded)]
        try:
            least += left @ z[~bounded] - 0.5 * left @ np.linalg.solve(block, left)
        except np.linalg.LinAlgError:
            return np.inf
    return float(gradient @ z - least + _support(program, multipliers))


def multipliers_at(program: Convex, z: Array, tolerance: float) -> Array:
    """Return multipliers of the rows (N,) that explain `z` best, without asking a solver.

    The gradient is written as a combination of the limits that hold `z`, with signs as they must be, in the sense of
    least squares. If `z` is optimal, its optimality gap with them is zero.
    """
    values = program.A @ z
    above, below = (
        np.flatnonzero(values >= program.upper - tolerance),
        np.flatnonzero(values <= program.lower + tolerance),
    )
    unit = np.eye(len(z))
    columns = np.vstack(
        [
            program.A[above],
            -program.A[below],
            unit[z >= program.hi - tolerance],
            -unit[z <= program.lo + tolerance],
        ]
    )
    found = np.zeros(len(values))
    if len(columns):
        share, _ = nnls(columns.T, -(program.P @ z + program.q))
        np.add.at(found, above, share[: len(above)])
        np.add.at(found, below, -share[len(above) : len(above) + len(below)])
    return found


def proves_infeasible(program: Convex) -> bool:
    """Return whether rows and bounds provably contradict each other.

    The proof is a combination of rows and bounds, found by least squares, that no point fulfils; it is checked before
    it is believed. False means that none was found.

    Examples
    --------
    >>> one = np.ones(1)
    >>> proves_infeasible(Convex(np.zeros((1, 1)), one, one[:, None], 2 * one, 3 * one, 0 * one, one))
    True
    """
    lo, hi = np.maximum(program.lo, -_FAR), np.minimum(program.hi, _FAR)
    upper, lower = np.isfinite(program.upper), np.isfinite(program.lower)
    unit = np.eye(len(lo))
    rows = np.vstack([program.A[upper], -program.A[lower], unit, -unit])
    sides = np.concatenate([program.upper[upper], -program.lower[lower], hi, -lo])
    try:
        share, _ = nnls(np.vstack([rows.T, sides]), np.append(np.zeros(len(lo)), -1.0))
    except RuntimeError:  # its iterations ran out
        return False
    multipliers = np.zeros(len(program.A))
    multipliers[upper] += share[: upper.sum()]
    multipliers[lower] -= share[upper.sum() : upper.sum() + lower.sum()]
    total = np.abs(multipliers).sum()
    if total <= 0 or not np.isfinite(total):
        return False
    multipliers /= total
    held = program.A.T @ multipliers
    least = np.where(held > 0, lo, hi) @ held
    # Rounding of sums of a few products of numbers about one.
    return bool(least - _support(program, multipliers) > 1e-12)


def _support(program: Convex, multipliers: Array) -> float:
    """Return the largest value of ``y'a`` with ``a`` within the limits of the rows."""
    side = np.where(multipliers > 0, program.upper, program.lower)
    used = multipliers != 0
    return float(multipliers[used] @ side[used])

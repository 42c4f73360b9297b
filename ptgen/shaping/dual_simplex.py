r"""The linear program of the optimal governor: few unknowns, many rows, and a start that is nearly the solution.

.. math:: \min w^T s \quad\text{subject to}\quad l \le v - A s \le u, \quad 0 \le s \le 1

with :math:`w \ge 0`; s is how much each reference is held back. At s = 0 all prices are right already, so the dual
simplex starts there, takes in the most violated row, and drops the one of the active constraints whose price vanishes
first. If no row is violated nothing is done at all. Rows are normalised when they are taken in, so that pivots are
numbers without a unit. The inverse of the active constraints is updated by rank-one changes; at the end the vertex is
computed anew from the rows themselves, bounds first, so that an unknown at its bound is there to the last bit.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["FEASIBLE", "LEAST_PIVOT", "Outcome", "solve_program"]

Array = NDArray[np.float64]

FEASIBLE = 1e-12
"""Violations below this share of the limits are rounding."""

LEAST_PIVOT = 1e-10
"""Rates of change of prices below this are rounding."""


@dataclass(frozen=True)
class Outcome:
    """The vertex s, how many rows were taken in, and whether it is the solution; or `infeasible`."""

    s: Array
    iterations: int
    solved: bool
    infeasible: bool


@dataclass
class _Active:
    """Active constraints: normals (k,), sides, and which unknown a bound holds (-1 for a row)."""

    normals: Array
    sides: Array
    bounds: list[int]


def solve_program(
    v: Array, A: Array, lower: Array, upper: Array, scale: Array, weight: Array, most_iterations: int
) -> Outcome:
    """Return the vertex at which the program has its minimum.

    Parameters
    ----------
    v, lower, upper, scale : ndarray (N,)
        Values of the rows at s = 0, their limits, and by what their violations are measured.
    A : ndarray (N, k)
        By how much each unknown lowers the rows.
    weight : ndarray (k,)
    most_iterations : int
    """
    k = len(weight)
    s, price, inverse = np.zeros(k), weight.copy(), np.eye(k)
    active = _Active(np.eye(k), np.zeros(k), list(range(k)))
    iterations = 0
    while True:
        entering = _most_violated(v, A, lower, upper, scale, s)
        if entering is None:
            return Outcome(_vertex(active), iterations, solved=True, infeasible=False)
        if iterations == most_iterations:
            return Outcome(s, iterations, solved=False, infeasible=False)
        iterations += 1
        normal, side, bound = entering
        rates = inverse.T @ normal
        leaving = _leaving(price, rates)
        if leaving < 0:
            return Outcome(s, iterations, solved=False, infeasible=True)
        step = price[leaving] / rates[leaving]
        price = np.maximum(price - step * rates, 0.0)
        price[leaving] = step
        column = inverse[:, leaving] / rates[leaving]
        s = s + (side - normal @ s) * column
        inverse = inverse - np.outer(column, rates)
        inverse[:, leaving] = column
        active.normals[leaving], active.sides[leaving], active.bounds[leaving] = normal, side, bound


def _most_violated(
    v: Array, A: Array, lower: Array, upper: Array, scale: Array, s: Array
) -> tuple[Array, float, int] | None:
    """Return normal, side and bound of the most violated constraint ``normal . s >= side``; None if all hold."""
    k = len(s)
    values = v - A @ s
    above, below = (values - upper) / scale, (lower - values) / scale
    violations = np.concatenate([-s, s - 1.0, above, below])
    worst = int(np.argmax(violations))
    if not violations[worst] > FEASIBLE:
        return None
    if worst < 2 * k:
        normal = np.zeros(k)
        normal[worst % k] = 1.0 if worst < k else -1.0
        return normal, 0.0 if worst < k else -1.0, worst % k
    row, sign = (worst - 2 * k) % len(values), 1.0 if worst < 2 * k + len(values) else -1.0
    size = float(np.abs(A[row]).max())
    if not size > 0.0:
        return np.zeros(k), 1.0, -1
    normal = sign * A[row] / size
    side = v[row] - upper[row] if sign > 0.0 else lower[row] - v[row]
    return normal, float(side / size), -1


def _leaving(price: Array, rates: Array) -> int:
    """Return the active constraint whose price vanishes first; -1 if none does."""
    leaving, least = -1, np.inf
    for index, (cost, rate) in enumerate(zip(price, rates, strict=True)):
        if rate > LEAST_PIVOT and cost / rate < least:
            leaving, least = index, cost / rate
    return leaving


def _vertex(active: _Active) -> Array:
    """Return the point where the active constraints meet, by elimination with pivots; in [0, 1]."""
    k = len(active.sides)
    s = np.zeros(k)
    free = [g for g in range(k) if g not in active.bounds]
    for place, bound in enumerate(active.bounds):
        if bound >= 0:
            s[bound] = active.sides[place] * active.normals[place, bound]
    rows = [place for place, bound in enumerate(active.bounds) if bound < 0]
    if rows:
        s[free] = np.linalg.solve(active.normals[np.ix_(rows, free)], active.sides[rows] - active.normals[rows] @ s)
    return np.clip(s, 0.0, 1.0)

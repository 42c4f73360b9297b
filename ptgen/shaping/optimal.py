r"""The optimal governor: the references closest to the wanted ones for which the closed loop keeps its torque limits.

Reference i goes from its last shaped value on towards the wanted one by the share :math:`h_i`, and
:math:`\sum w_i h_i` is as large as the rows allow (source, (7.35), (7.36)). A row is the torque command of one machine
some steps ahead,

.. math:: u_i(\tilde r) + a_x^T (x - X r) + a_r^T (\tilde r - r),\qquad
          u(\tilde r) = u_0 + G (\tilde r - \tilde r_{k-1}),

and the commands of the present step, for which :math:`a_x = a_r = 0`, are always among them. If the limits cannot be
kept at all, those of each machine are widened by what it lacks if nothing is changed, which is always allowed.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ptgen.shaping.dual_simplex import solve_program
from ptgen.shaping.ties import leaders

__all__ = ["LARGEST", "LIMITED", "MARGIN", "NOTHING_BINDS", "NOT_SOLVED", "SLACK", "optimal_governor"]

Array = NDArray[np.float64]

LARGEST = 1e30
"""Deviations beyond this cannot be meant, and count as not finite."""

MARGIN = 1e-9
"""By which share of the limits more than what lacks they are widened: a program with room is safe from rounding."""

NOTHING_BINDS = 0.0
"""Status: the wanted references keep all limits."""

LIMITED = 1.0
"""Status: some reference is held back."""

SLACK = 2.0
"""Status: limits had to be widened."""

NOT_SOLVED = 3.0
"""Status: not solved within the bound of iterations, or an input is not finite; the fallback is taken."""


def optimal_governor(
    chosen: Array,
    wanted: Array,
    before: Array,
    free: Array,
    gain: Array,
    least: Array,
    most: Array,
    deviation: Array,
    rows_x: Array,
    rows_r: Array,
    weight: Array,
    tie: Array,
    group: Array,
    fallback: Array,
    *numbers: int,
) -> tuple[Array, Array, Array, Array]:
    """Return shaped references (m,), slack (m,) (N m), number of iterations, and status.

    All arrays may have leading batch axes.

    Parameters
    ----------
    chosen : ndarray ()
        At most 0.5: the fallback is taken, without any work.
    wanted, before : ndarray (m,)
        References as they are asked for, and shaped ones of the last step (rad/s or N m).
    free, gain : ndarray (m,), (m, m)
        Torque commands before any limit are ``free + gain (shaped - before)`` (N m).
    least, most : ndarray (m,)
        Limits of the commands (N m).
    deviation : ndarray (n,)
        State of the closed loop less the one at which it would rest with the wanted references.
    rows_x, rows_r : ndarray (N, n), (N, m)
        What each row adds to the command of its machine, from the deviation and from ``shaped - wanted``.
    weight : ndarray (m,)
        What a reference is worth; not negative.
    tie : ndarray ()
    group : ndarray (m,)
        References with the same positive number that are closer than `tie`, before and wanted, share one h.
    fallback : ndarray (m,)
        What is taken if there is no solution.
    *numbers : int
        How many rows each machine has, in their order, and the bound of iterations. Further rows are not used.
    """
    arrays = (chosen, wanted, before, free, gain, least, most, deviation, rows_x, rows_r, weight, tie, group, fallback)
    ranks = (0, 1, 1, 1, 2, 1, 1, 1, 2, 2, 1, 0, 1, 1)
    given = [np.asarray(array, dtype=np.float64) for array in arrays]
    batch = np.broadcast_shapes(*(a.shape[: a.ndim - rank] for a, rank in zip(given, ranks, strict=True)))
    given = [np.broadcast_to(a, batch + a.shape[a.ndim - rank :]) for a, rank in zip(given, ranks, strict=True)]
    m = given[1].shape[-1]
    shaped, slack, iterations, status = np.zeros((*batch, m)), np.zeros((*batch, m)), np.zeros(batch), np.zeros(batch)
    for index in np.ndindex(*batch):
        with np.errstate(over="ignore", invalid="ignore"):
            one = _one(*(a[index] for a in given), counts=numbers[:m], most_iterations=numbers[m])
        shaped[index], slack[index], iterations[index], status[index] = one
    return shaped, slack, iterations, status


def _one(
    chosen: Array,
    wanted: Array,
    before: Array,
    free: Array,
    gain: Array,
    least: Array,
    most: Array,
    deviation: Array,
    rows_x: Array,
    rows_r: Array,
    weight: Array,
    tie: Array,
    group: Array,
    fallback: Array,
    *,
    counts: tuple[int, ...],
    most_iterations: int,
) -> tuple[Array, Array, float, float]:
    """Return the result for one problem."""
    m = len(wanted)
    if not chosen > 0.5:
        return fallback, np.zeros(m), 0.0, NOTHING_BINDS
    refuge = np.where(np.isfinite(fallback), fallback, before)
    numbers = (wanted, before, free, gain, least, most, deviation, weight, tie, group)
    if not (all(np.isfinite(array).all() for array in numbers) and np.abs(deviation).max() <= LARGEST):
        return refuge, np.zeros(m), 0.0, NOT_SOLVED
    change = wanted - before
    machine = np.repeat(np.arange(m), counts)
    starts = np.cumsum([0, *counts[:-1]])  # the row of the present step comes first
    v = (free + gain @ change)[machine] + rows_x[: len(machine)] @ deviation
    v = np.insert(v, starts, free + gain @ change)
    slope = np.insert((gain[machine] + rows_r[: len(machine)]) * change, starts, gain * change, axis=0)
    machine = np.insert(machine, starts, np.arange(m))
    if not (np.isfinite(v).all() and np.isfinite(slope).all()):
        return refuge, np.zeros(m), 0.0, NOT_SOLVED
    leader = leaders(wanted, before, float(tie), group)
    collected = np.zeros((m, m))  # those that are led have no share of their own
    collected[np.arange(m), leader] = 1.0
    span = 0.5 * (most - least)
    scale = np.where(span > 0.0, span, 1.0)[machine]
    A, w = slope @ collected, weight @ collected
    outcome = solve_program(v, A, least[machine], most[machine], scale, w, most_iterations)
    iterations, slack = outcome.iterations, np.zeros(m)
    if outcome.infeasible:
        slack = _lacking(v - slope.sum(axis=1), machine, least, most)
        span = np.where(span > 0.0, span, 1.0) + slack
        wider = slack + MARGIN * span
        lower, upper = (least - wider)[machine], (most + wider)[machine]
        outcome = solve_program(v, A, lower, upper, span[machine], w, most_iterations - iterations)
        iterations += outcome.iterations
    held = collected @ outcome.s
    if not (outcome.solved and np.isfinite(held).all()):
        return refuge, slack, float(iterations), NOT_SOLVED
    shaped = np.where(held == 1.0, before, wanted - held * change)
    shaped = np.clip(shaped, np.minimum(before, wanted), np.maximum(before, wanted))
    status = SLACK if slack.any() else LIMITED if iterations else NOTHING_BINDS
    return shaped, slack, float(iterations), status


def _lacking(values: Array, machine: NDArray[np.intp], least: Array, most: Array) -> Array:
    """Return by how much each machine lacks torque if nothing is changed."""
    slack = np.zeros(len(least))
    np.maximum.at(slack, machine, np.maximum(values - most[machine], least[machine] - values))
    return slack

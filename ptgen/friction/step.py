r"""Friction over one step of a discretised bed: events inside the step, NumPy reference.

Over a step the friction velocities go from :math:`w` to :math:`w_{free}` if there are no friction torques, and to
:math:`w_{free} - K \bar T` with the mean torques :math:`\bar T`. Inside the step they are taken to move on straight
lines, :math:`dw/ds = (w_{free} - w) - K T(s)` with s from 0 to 1, and the torques follow from them:

* an element that slips has the torque :math:`\pm c_i` of its kinetic capacity, against its motion;
* elements at rest take the torques that hold them, up to their capacities at rest :math:`c^s_i` (`ptgen.friction.box`
  with rates in place of velocities);
* an element that cannot be held breaks away, and from then on has its kinetic capacity; with that all elements at rest
  are asked again, until no more of them breaks away. One that broke away together with others may be held by its
  kinetic capacity once they move: its torque never drives it;
* a velocity that reaches zero ends a piece of the step: from there the element is at rest, so it is held if its
  capacity at rest can hold it, and otherwise goes on through zero. Velocities that are zero but for rounding reach it
  together, those of elements that hold the same motion above all.

Without the last point an element that passes through zero would be held there until the end of the step, which leaves
an error of first order in the step. Steps without an event are one piece, and cost one solution of the box problem.
Every piece begins with an event, of which a step has few; after `pieces` of them the rest of the step is solved at
once, with the mean torques of the box problem.

*Breaking away* to a smaller capacity in motion lets the torque jump, so it matters when in the step it happens. The
torque that is needed to hold an element is a mean over the step, as it was over the step before; the element breaks
away where the straight line between both middles passes its capacity. That may be up to half a step ago: then the first
piece has a negative duration, which takes back what the element was held for too long.

The same rules hold in the event-driven reference, `ptgen.friction.events`, with the exact motion in place of the
straight lines. That a slope of the capacity is falling plays no part in them: at rest the capacity is :math:`c^s`,
in motion it is the kinetic one, and what decides between both is the velocity alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.friction.box import ROUNDING, residual_rounding, solve_box

__all__ = ["UNSOLVED", "FrictionStep", "friction_step", "pieces", "step_friction"]

Array = NDArray[np.float64]

_SAME = ROUNDING * float(np.finfo(np.float64).eps)

UNSOLVED = -1.0
"""Status of a step whose residual stayed above rounding; the torques are inside their bounds all the same."""


@dataclass(frozen=True)
class FrictionStep:
    """What `step_friction` returns.

    Attributes
    ----------
    mean : ndarray (n,)
        Mean torques of the step (N m).
    end : ndarray (n,)
        Torques at its end (N m).
    w_plus : ndarray (n,)
        Velocities at its end (rad/s), exactly zero at rest.
    status : float
        0; the number of the first element, from 1, whose capacity is no number from 0 up: it is taken as 0; or
        `UNSOLVED`.
    """

    mean: Array
    end: Array
    w_plus: Array
    status: float


def pieces(n: int) -> int:
    """Return into how many pieces between events a step of `n` elements is divided at most."""
    return 2 * n + 1


def step_friction(
    K: Array,
    deficient: bool,
    w: Array,
    w_free: Array,
    slide: Array,
    rest: Array,
    guess: Array,
    one_way: NDArray[np.bool_],
    rest_before: Array | None = None,
) -> FrictionStep:
    """Solve the friction of one step, see the module.

    Parameters
    ----------
    K : ndarray (n, n)
        Friction velocities lost over the step per mean friction torque (rad/s per N m).
    deficient : bool
        Whether K is singular, see `ptgen.friction.box.is_deficient`.
    w, w_free : ndarray (n,)
        Velocities at the start, and at the end without friction torques (rad/s).
    slide, rest : ndarray (n,)
        Capacities in motion and at rest (N m); one that is negative or not finite counts as zero.
    guess : ndarray (n,)
        Torques at the end of the last step (N m).
    one_way : ndarray of bool (n,)
        Elements that hold any positive torque.
    rest_before : ndarray (n,), optional
        Capacities at rest in the last step (N m); zero, the default, if nothing is known of it.

    References
    ----------
    Source Sections 4.2.1 and 4.2.2.
    """
    n = len(w)
    sound = np.isfinite(slide) & (slide >= 0) & np.isfinite(rest) & (rest >= 0)
    status = 0.0 if sound.all() else float(np.argmin(sound) + 1)
    slide, rest = np.where(sound, slide, 0.0), np.where(sound, rest, 0.0)
    rest_before = np.zeros(n) if rest_before is None else rest_before
    rate = w_free - w
    w, T, mean = w.copy(), guess, np.zeros(n)
    left = 1.0
    stopped = one_way & (w > 0)  # only a change of the state from outside can leave a one-way element there
    solved = True
    for piece in range(pieces(n) - 1):
        if stopped.any():
            break
        lo, hi = _bounds(w, slide, rest, one_way)
        solution = solve_box(K, rate, lo, hi, T, deficient)
        leaving = (lo < hi) & (solution.w_plus != 0) & (lo != -slide)
        if piece == 0 and leaving.any():
            unbounded = np.where(leaving, -np.inf, lo), np.where(leaving, np.inf, hi)
            held = solve_box(K, rate, *unbounded, solution.T, deficient)
            sign = np.sign(solution.w_plus)
            start = _broken_away(leaving & (rest_before > 0), sign * held.T - rest, rest_before - sign * guess)
            # What was held until then stays where it is: it would not have moved without a torque beyond the capacity.
            if not np.any((w * (w + start * held.w_plus) < 0) | ((w == 0) & (held.w_plus != 0))):
                mean, w, left = start * held.T, w + start * held.w_plus, 1.0 - start
        while leaving.any():
            lo, hi = np.where(leaving, -slide, lo), np.where(leaving & ~one_way, slide, hi)
            solution = solve_box(K, rate, lo, hi, solution.T, deficient)
            leaving = (lo < hi) & (solution.w_plus != 0) & (lo != -slide)
        solved &= solution.solved
        T, slope = solution.T, solution.w_plus
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            arrival = np.where(w * slope < 0, -w / slope, np.inf)
        duration = min(left, float(arrival.min()))
        rounding = residual_rounding(K, rate, T, deficient)
        reached = (arrival <= duration) | (np.abs(w + duration * slope) <= _SAME * np.abs(w) + duration * rounding)
        mean = mean + duration * T
        w = np.where(reached, 0.0, w + duration * slope)
        left -= duration
        if left <= 0:
            return FrictionStep(mean, T, w, status if solved else UNSOLVED)
    lo = np.where(w == 0, -rest, -slide)
    hi = np.where(one_way, np.inf, -lo)
    solution = solve_box(K, w / left + rate, lo, hi, T, deficient)
    solved &= solution.solved
    return FrictionStep(mean + left * solution.T, solution.T, left * solution.w_plus, status if solved else UNSOLVED)


def _broken_away(leaving: NDArray[np.bool_], over: Array, under: Array) -> float:
    """Return when the first of the `leaving` elements broke away: -1/2 is the middle of the last step, 1/2 of this one.

    `over` is by how much the torque that holds an element exceeds its capacity now, `under` by how much it fell short.
    """
    known = leaving & (over > 0) & (under >= 0)
    over, under = over[known], under[known]
    return float(np.min(0.5 - over / (over + under))) if known.any() else 0.0


def _bounds(w: Array, slide: Array, rest: Array, one_way: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return the torques that elements may have: one value in motion, an interval at rest."""
    at_rest = w == 0
    lo = np.where(at_rest, -rest, np.sign(w) * slide)
    hi = np.where(at_rest, np.where(one_way, np.inf, rest), lo)
    return lo, hi


def friction_step(
    K: Array, w: Array, w_free: Array, slide: Array, rest: Array, guess: Array, rest_before: Array, *numbers: int
) -> tuple[Array, Array, Array, Array, Array]:
    """Return `step_friction` for arrays with leading batch axes: mean, end, `rest` for the next step, w_plus, status.

    `numbers` are 1 if K is singular, else 0, and a number whose bits tell which elements are one-way.
    """
    deficient, bits = numbers
    n = w.shape[-1]
    batch = np.broadcast_shapes(w.shape[:-1], w_free.shape[:-1], slide.shape[:-1], K.shape[:-2])
    mean, end, w_plus, status = (np.zeros((*batch, *tail)) for tail in ((n,), (n,), (n,), ()))
    matrices = np.broadcast_to(K, (*batch, n, n))
    rows = [np.broadcast_to(a, (*batch, n)) for a in (w, w_free, slide, rest, guess, rest_before)]
    one_way = np.array([bool(bits >> i & 1) for i in range(n)])
    for index in np.ndindex(*batch):
        start, free, moving, standing, last, before = (row[index] for row in rows)
        step = step_friction(matrices[index], bool(deficient), start, free, moving, standing, last, one_way, before)
        mean[index], end[index], w_plus[index], status[index] = step.mean, step.end, step.w_plus, step.status
    return mean, end, rows[3].copy(), w_plus, status

"""Friction and backlash for the CasADi evaluator: the algorithms of `ptgen.friction` without branches.

Up to two elements have closed forms, and everything is one expression. For more, one round of sweep and face step is a
function that is repeated as often as is ever needed. Rounds at the solution change nothing but rounding; so a residual
counts as left only if it is above the rounding of the largest row. CasADi evaluates both sides of a branch and
multiplies them by 1 and 0, so both must be finite.
"""

from __future__ import annotations

import functools
import itertools
from typing import Any

import casadi as ca
import numpy as np

from ptgen.friction.backlash import SWEEPS
from ptgen.friction.box import DEFICIENT, LEAST_SHIFT, NO_PIVOT, ROUNDING, SMALLEST, STRICT_PASSES
from ptgen.friction.step import UNSOLVED, pieces

__all__ = ["backlash_step", "friction_step", "is_closed_form"]

_EPSILON = float(np.finfo(np.float64).eps)

_UNLIMITED = 1e30
"""Stands for an infinite bound (N m)."""

_TINY = 1e-300


def is_closed_form(n: int, deficient: int) -> bool:
    """Tell whether the friction of `n` elements, that may hold the same motion, is a closed expression."""
    return n <= 2


def friction_step(
    K: Any, w: Any, w_free: Any, slide: Any, rest: Any, guess: Any, rest_before: Any, deficient: int, bits: int
) -> Any:
    """Return mean torques, torques at the end, `rest`, velocities at the end, status; see `ptgen.friction.step`."""
    given = rest
    n = w.shape[0]
    rows = range(n)
    sound = [ca.logic_and(c >= 0, c < _UNLIMITED) for c in (*ca.vertsplit(slide), *ca.vertsplit(rest))]
    sound = [ca.logic_and(sound[i], sound[n + i]) for i in rows]
    status: Any = 0.0
    for i in reversed(rows):
        status = ca.if_else(sound[i], status, i + 1.0)
    slide = ca.vertcat(*[ca.if_else(sound[i], slide[i], 0.0) for i in rows])
    rest = ca.vertcat(*[ca.if_else(sound[i], rest[i], 0.0) for i in rows])
    one_way = [bool(bits >> i & 1) for i in rows]
    slope = w_free - w
    stopped: Any = 0.0
    for i in itertools.compress(rows, one_way):
        stopped = ca.if_else(w[i] > 0, 1.0, stopped)
    mean, v, left = _until_broken_away(K, w, slope, slide, rest, guess, rest_before, stopped, deficient, bits)
    # The first piece goes by the velocities at the start of the step, also if it begins at another time.
    state = ca.vertcat(v, mean, guess, left, 1.0, w, ca.vec(K), slope, slide, rest, stopped)
    piece = _piece(n, deficient, bits)
    if is_closed_form(n, deficient):
        for _ in range(pieces(n) - 1):
            state = piece(state)
    else:
        state = piece.fold(pieces(n) - 1)(state)
    v, mean, T, left, solved = state[:n], state[n : 2 * n], state[2 * n : 3 * n], state[3 * n], state[3 * n + 1]
    more = left > 0
    whole = ca.if_else(more, left, 1.0)
    lo = ca.vertcat(*[ca.if_else(v[i] == 0, -rest[i], -slide[i]) for i in rows])
    hi = ca.vertcat(*[_UNLIMITED if one_way[i] else -lo[i] for i in rows])
    end, rates, fits = _solve(K, v / whole + slope, lo, hi, T, deficient)
    mean = ca.if_else(more, mean + left * end, mean)
    status = ca.if_else(ca.logic_and(solved > 0, ca.if_else(more, fits, 1.0) > 0), status, UNSOLVED)
    return mean, ca.if_else(more, end, T), given, ca.if_else(more, left * rates, v), status


def _limits(v: Any, slide: Any, rest: Any, bits: int) -> tuple[Any, Any]:
    """Return the torques that elements may have: one value in motion, an interval at rest."""
    rows = range(v.shape[0])
    at_rest = [v[i] == 0 for i in rows]
    lo = ca.vertcat(*[ca.if_else(at_rest[i], -rest[i], ca.sign(v[i]) * slide[i]) for i in rows])
    hold = [_UNLIMITED if bits >> i & 1 else rest[i] for i in rows]
    return lo, ca.vertcat(*[ca.if_else(at_rest[i], hold[i], lo[i]) for i in rows])


def _leaving(lo: Any, hi: Any, rates: Any, slide: Any) -> list[Any]:
    """Return which elements break away from a capacity that is not that in motion."""
    moving = [ca.logic_and(lo[i] < hi[i], rates[i] != 0) for i in range(rates.shape[0])]
    return [ca.logic_and(part, lo[i] != -slide[i]) for i, part in enumerate(moving)]


def _until_broken_away(
    K: Any,
    w: Any,
    slope: Any,
    slide: Any,
    rest: Any,
    guess: Any,
    rest_before: Any,
    stopped: Any,
    deficient: int,
    bits: int,
) -> tuple[Any, Any, Any]:
    """Return mean torques, velocities and what is left of the step when the first element has broken away."""
    rows = range(w.shape[0])
    lo, hi = _limits(w, slide, rest, bits)
    end, rates, _ = _solve(K, slope, lo, hi, guess, deficient)
    leaving = _leaving(lo, hi, rates, slide)
    lo = ca.vertcat(*[ca.if_else(leaving[i], -_UNLIMITED, lo[i]) for i in rows])
    hi = ca.vertcat(*[ca.if_else(leaving[i], _UNLIMITED, hi[i]) for i in rows])
    held, moving, _ = _solve(K, slope, lo, hi, end, deficient)
    start: Any = 0.5
    some: Any = 0.0
    for i in rows:
        sign = ca.sign(rates[i])
        over, under = sign * held[i] - rest[i], rest_before[i] - sign * guess[i]
        known = ca.logic_and(ca.logic_and(leaving[i], rest_before[i] > 0), ca.logic_and(over > 0, under >= 0))
        start = ca.fmin(start, ca.if_else(known, 0.5 - over / ca.if_else(known, over + under, 1.0), 0.5))
        some = ca.if_else(known, 1.0, some)
    for i in rows:
        moved = ca.logic_and(w[i] == 0, moving[i] != 0)
        some = ca.if_else(ca.logic_or(moved, w[i] * (w[i] + start * moving[i]) < 0), 0.0, some)
    start = ca.if_else(ca.logic_and(some > 0, stopped == 0), start, 0.0)
    return start * held, w + start * moving, 1.0 - start


@functools.cache
def _piece(n: int, deficient: int, bits: int) -> Any:
    """Return the function of one piece of the step between events."""
    rows = range(n)
    kind: Any = ca.SX if is_closed_form(n, deficient) else ca.MX
    sizes = [n, n, n, 1, 1, n, n * n, n, n, n, 1]
    state = kind.sym("state", sum(sizes))
    v, mean, T, left, solved, judged, k, slope, slide, rest, stopped = ca.vertsplit(
        state, np.cumsum([0, *sizes]).tolist()
    )
    K = ca.reshape(k, n, n)
    active = ca.logic_and(left > 0, stopped == 0)
    lo, hi = _limits(judged, slide, rest, bits)
    end, rates, fits = _solve(K, slope, lo, hi, T, deficient)
    for _ in rows:
        leaving = _leaving(lo, hi, rates, slide)
        lo = ca.vertcat(*[ca.if_else(leaving[i], -slide[i], lo[i]) for i in rows])
        hi = ca.vertcat(*[hi[i] if bits >> i & 1 else ca.if_else(leaving[i], slide[i], hi[i]) for i in rows])
        end, rates, more = _solve(K, slope, lo, hi, end, deficient)
        fits = ca.fmin(fits, more)
    meets = [v[i] * rates[i] < 0 for i in rows]
    arrival = [ca.if_else(meets[i], -v[i] / ca.if_else(meets[i], rates[i], 1.0), 2.0) for i in rows]
    duration = functools.reduce(ca.fmin, arrival, left)
    size = _rounding(K, slope, end)
    if deficient:
        root = ca.sqrt(ca.diag(K))
        size = ca.mmax(size / root) * root
    ends = [v[i] + duration * rates[i] for i in rows]
    margin = [ROUNDING * _EPSILON * ca.fabs(v[i]) + duration * size[i] for i in rows]
    reached = [ca.logic_or(arrival[i] <= duration, ca.fabs(ends[i]) <= margin[i]) for i in rows]
    moved = ca.vertcat(*[ca.if_else(reached[i], 0.0, ends[i]) for i in rows])
    after = [
        ca.if_else(active, moved, v),
        ca.if_else(active, mean + duration * end, mean),
        ca.if_else(active, end, T),
        ca.if_else(active, left - duration, left),
        ca.if_else(active, ca.fmin(solved, fits), solved),
        ca.if_else(active, moved, v),
    ]
    return ca.Function(f"friction_piece_{n}", [state], [ca.vertcat(*after, state[sum(sizes[:6]) :])])


def _clip(value: Any, lo: Any, hi: Any) -> Any:
    return ca.fmax(lo, ca.fmin(hi, value))


def _solve(K: Any, w: Any, lo: Any, hi: Any, guess: Any, deficient: int) -> tuple[Any, Any, Any]:
    """Return torques, velocities that they leave, and 1 or 0 for whether the residual is rounding."""
    n = w.shape[0]
    fits: Any = 1.0
    if n == 1:
        T = _clip(w / K, lo, hi)
    elif n == 2:
        product = K[0, 0] * K[1, 1]
        determinant = ca.fmax(product - K[0, 1] * K[1, 0], NO_PIVOT * _EPSILON * product)
        T = _clamped_twice(K, w, lo, hi, (K[0, 0] * w[1] - K[1, 0] * w[0]) / determinant)
        if deficient:
            shared = _clamped_twice(K, w, lo, hi, w[1] / (2.0 * K[1, 1]))
            T = ca.if_else(_fits(K, w, lo, hi, shared, _rounding(K, w, shared)) > 0, shared, T)
    else:
        T, fits = _faces(n, deficient)(K, w, lo, hi, _clip(guess, lo, hi))
    rates = w - K @ T
    size = _rounding(K, w, T)
    result = []
    for i in range(n):
        off = ca.logic_or(ca.logic_and(rates[i] > 0, T[i] < hi[i]), ca.logic_and(rates[i] < 0, T[i] > lo[i]))
        result.append(ca.if_else(ca.logic_or(off, ca.fabs(rates[i]) <= size[i]), 0.0, rates[i]))
    return T, ca.vertcat(*result), fits


def _clamped_twice(K: Any, w: Any, lo: Any, hi: Any, second: Any) -> Any:
    t2 = _clip(second, lo[1], hi[1])
    T1 = _clip((w[0] - K[0, 1] * t2) / K[0, 0], lo[0], hi[0])
    return ca.vertcat(T1, _clip((w[1] - K[1, 0] * T1) / K[1, 1], lo[1], hi[1]))


def _rounding(K: Any, w: Any, T: Any) -> Any:
    return ROUNDING * _EPSILON * (ca.fabs(w) + ca.fabs(K) @ ca.fabs(T)) + SMALLEST


@functools.cache
def _faces(n: int, deficient: int) -> Any:
    """Return the function that solves the box problem of `n` elements."""
    K, T = ca.MX.sym("K", n, n), ca.MX.sym("T", n)
    w, lo, hi = (ca.MX.sym(name, n) for name in ("w", "lo", "hi"))
    rounds = _round(n).fold(3 * n + 6)

    def descend(H: Any, c: Any, start: Any) -> Any:
        return rounds(ca.vertcat(start, 0.0, ca.vec(H), c, lo, hi))[:n]

    root = ca.sqrt(ca.diag(K))

    def level(start: Any) -> Any:
        return ca.mmax(_rounding(K, w, start) / root) * root

    found = T
    if deficient:
        large, least = np.sqrt(_EPSILON), LEAST_SHIFT * _EPSILON
        middle = np.sqrt(large * least)
        added: Any = ca.DM.zeros(n)
        done: Any = 0.0
        before = large
        for k, rho in enumerate((large, large, large, large, middle, middle, least, least, least, least)):
            added = added * (rho / before)
            new = descend(K + rho * ca.diag(ca.diag(K)), w + added, found)
            found = ca.if_else(done > 0, found, new)
            size = _rounding(K, w, found) if k < STRICT_PASSES else level(found)
            done = ca.fmax(done, _fits(K, w, lo, hi, found, size))
            added = added + w - K @ found
            before = rho
        fits = _fits(K, w, lo, hi, found, DEFICIENT / ROUNDING * level(found))
    else:
        found = descend(K, w, T)
        fits = _fits(K, w, lo, hi, found, level(found))
    return ca.Function(f"box_{n}_{deficient}", [K, w, lo, hi, T], [found, fits])


def _fits(K: Any, w: Any, lo: Any, hi: Any, T: Any, size: Any) -> Any:
    r = w - K @ T
    fits: Any = 1.0
    for i in range(w.shape[0]):
        upper = ca.logic_or(T[i] >= hi[i], r[i] <= size[i])
        lower = ca.logic_or(T[i] <= lo[i], r[i] >= -size[i])
        good = ca.logic_or(lo[i] == hi[i], ca.logic_and(upper, lower))
        fits = ca.if_else(good, fits, 0.0)
    return fits


@functools.cache
def _round(n: int) -> Any:
    """Return the function of one face step, after a sweep if the last one reached the minimum of its face."""
    rows = range(n)
    sizes = [n, 1, n * n, n, n, n]
    state = ca.SX.sym("state", sum(sizes))
    start, reached, h, c, lo, hi = ca.vertsplit(state, np.cumsum([0, *sizes]).tolist())
    H = ca.reshape(h, n, n)
    T = ca.vertsplit(start)
    for i in rows:
        residual = c[i] - sum((H[i, j] * T[j] for j in rows), ca.SX(0))
        T[i] = ca.if_else(reached > 0, _clip(T[i] + residual / H[i, i], lo[i], hi[i]), T[i])
    free = [ca.if_else(ca.logic_and(T[i] > lo[i], T[i] < hi[i]), 1.0, 0.0) for i in rows]
    r = [c[i] - sum((H[i, j] * T[j] for j in rows), ca.SX(0)) for i in rows]
    held = _masked_solve(H, free, [c[i] - sum((H[i, j] * (1 - free[j]) * T[j] for j in rows), ca.SX(0)) for i in rows])
    target = [ca.if_else(free[i] > 0, held[i], T[i]) for i in rows]
    d = [target[i] - T[i] for i in rows]
    whole = [_clip(target[i], lo[i], hi[i]) for i in rows]
    stops = [whole[i] != target[i] for i in rows]
    room = [ca.if_else(stops[i], (whole[i] - T[i]) / ca.if_else(d[i] == 0, 1.0, d[i]), 1.0) for i in rows]
    least = functools.reduce(ca.fmin, room, ca.SX(1.0))
    part = [
        ca.if_else(ca.logic_and(stops[i], room[i] <= least), whole[i], _clip(T[i] + least * d[i], lo[i], hi[i]))
        for i in rows
    ]

    def lowered(end: list[Any]) -> Any:
        change = [end[i] - T[i] for i in rows]
        slopes = [sum((H[i, j] * change[j] for j in rows), ca.SX(0)) for i in rows]
        return sum((change[i] * (r[i] - 0.5 * slopes[i]) for i in rows), ca.SX(0))

    better = lowered(whole) > lowered(part)
    best = [ca.if_else(better, whole[i], part[i]) for i in rows]
    whole_step = 1.0 - functools.reduce(ca.fmax, [ca.if_else(stop, 1.0, 0.0) for stop in stops])
    return ca.Function(f"box_round_{n}", [state], [ca.vertcat(*best, whole_step, state[n + 1 :])])


def _masked_solve(H: Any, free: list[Any], r: list[Any]) -> list[Any]:
    """Solve ``H d = r`` on the free elements by Cholesky factorisation; the others get 0."""
    n = len(r)
    L: dict[tuple[int, int], Any] = {}
    y: list[Any] = []
    for j in range(n):
        for i in range(j, n):
            entry = free[i] * free[j] * H[i, j] + (1 - free[i] if i == j else 0)
            L[i, j] = entry - sum((L[i, k] * L[j, k] for k in range(j)), ca.SX(0))
        root = ca.sqrt(ca.fmax(L[j, j], NO_PIVOT * _EPSILON * H[j, j]))
        for i in range(j, n):
            L[i, j] = L[i, j] / root
        y.append((free[j] * r[j] - sum((L[j, k] * y[k] for k in range(j)), ca.SX(0))) / root)
    for i in reversed(range(n)):
        y[i] = (y[i] - sum((L[k, i] * y[k] for k in range(i + 1, n)), ca.SX(0))) / L[i, i]
    return y


def backlash_step(kappa: Any, e: Any, e_free: Any, half_gap: Any, stiffness: Any, damping: Any) -> Any:
    """Return the mean torques of shafts with backlash; see `ptgen.friction.backlash`."""
    n = e.shape[0]
    T: list[Any] = [0.0] * n
    for _ in range(SWEEPS if n > 1 else 1):
        for i in range(n):
            free = e_free[i] - sum((kappa[i, j] * T[j] for j in range(n) if j != i), 0.0)
            T[i] = _contact(kappa[i, i], e[i], free, half_gap[i], stiffness[i], damping[i])
    return ca.vertcat(*T)


def _contact(kappa: Any, e: Any, free: Any, b: Any, c: Any, d: Any) -> Any:
    p = e - _clip(e, -b, b)

    def left_at(end: Any) -> Any:
        change = end - e
        mean = ca.if_else(change == 0, 0.0, -0.5 * c * p**2 / ca.if_else(change == 0, 1.0, change))
        return end + kappa * (mean - d * p) - free

    side = ca.if_else(left_at(b) < 0, 1.0, ca.if_else(left_at(-b) > 0, -1.0, 0.0))
    outside = ca.fabs(side)
    alpha = ca.if_else(side == 0, 0.0, e - side * b)
    a2 = 1.0 + outside * kappa * (d + 0.5 * c)
    a1 = e - free + kappa * (d * (alpha - p) + c * alpha * outside)
    a0 = 0.5 * kappa * c * (alpha**2 - p**2)
    root = ca.sqrt(ca.fmax(a1**2 - 4.0 * a2 * a0, _TINY))
    same = ca.logic_and(side != 0, p * side > 0)
    upward = ca.if_else(side == 0, p < 0, side > 0)
    change = ca.if_else(upward, -a1 + root, -a1 - root) / (2.0 * a2)
    change = ca.if_else(same, -a1 / a2, change)
    change = ca.if_else(ca.logic_and(side == 0, p == 0), free - e, change)
    beyond = alpha + outside * change
    secant = ca.if_else(change == 0, 0.0, (beyond - p) / ca.if_else(change == 0, 1.0, change))
    secant = ca.if_else(same, 1.0, secant)
    return 0.5 * c * (beyond + p) * secant + d * (beyond - p)

"""The governors for the CasADi evaluator: the algorithms of `ptgen.shaping` without branches.

The sequential governor is one expression. An iteration of the optimal one is a function that is repeated as often as
may be needed; at the solution it changes nothing. CasADi evaluates both sides of a branch and multiplies them by 1 and
0, so both must be finite; whether an input that is not finite is noticed as in the other evaluators is not promised.
"""

from __future__ import annotations

import functools
from typing import Any

import casadi as ca
import numpy as np

from ptgen.shaping.dual_simplex import FEASIBLE, LEAST_PIVOT
from ptgen.shaping.optimal import LIMITED, MARGIN, NOT_SOLVED, NOTHING_BINDS, SLACK
from ptgen.shaping.sequential import TOLERANCE, UNLIMITED

__all__ = ["optimal_governor", "sequential_governor"]

_RUNNING, _SOLVED, _FAILED = 0.0, 1.0, 2.0

_LARGEST = 1e300


def _leaders(wanted: Any, before: Any, tie: Any, group: Any) -> list[list[Any]]:
    """Return for each reference and each leader 1 or 0 for whether the one leads the other."""
    m = wanted.shape[0]
    leads: list[list[Any]] = []
    for i in range(m):
        row: list[Any] = [1.0 if f == i else 0.0 for f in range(m)]
        for j in reversed(range(i)):
            same = ca.logic_and(group[i] > 0, group[i] == group[j])
            apart = ca.fmax(ca.fabs(wanted[i] - wanted[j]), ca.fabs(before[i] - before[j]))
            tied = ca.logic_and(same, apart < tie)
            row = [ca.if_else(tied, leads[j][f], row[f]) for f in range(m)]
        leads.append(row)
    return leads


def sequential_governor(*arguments: Any) -> Any:
    """Return shaped references; arguments as of `ptgen.shaping.sequential.sequential_governor`."""
    vectors, order = arguments[:11], tuple(int(number) for number in arguments[11:])
    return _sequential(vectors[0].shape[0], order)(*vectors)


@functools.cache
def _sequential(m: int, order: tuple[int, ...]) -> Any:
    """Return the function of the sequential governor."""
    names = ("wanted", "before", "free", "gain", "least", "most", "reserve", "rate_step", "tie", "modified", "group")
    sizes = {"gain": (m, m), "tie": (1, 1), "modified": (1, 1)}
    symbols = {name: ca.SX.sym(name, *sizes.get(name, (m, 1))) for name in names}
    shaped = _Sequence(symbols).solve(tuple(zip(order[::2], order[1::2], strict=True)))
    return ca.Function(f"sequential_governor_{m}", list(symbols.values()), [shaped], list(names), ["shaped"])


class _Sequence:
    """The expressions of `ptgen.shaping.sequential`."""

    def __init__(self, given: dict[str, Any]) -> None:
        self.given = given
        self.gain, self.free, self.least, self.most = (given[name] for name in ("gain", "free", "least", "most"))
        self.modified = given["modified"] > 0.5
        self.m = given["wanted"].shape[0]
        rows = range(self.m)
        change = given["wanted"] - given["before"]
        self.change = [change[i] for i in rows]
        self.unit = [ca.if_else(self.modified, 1.0, change[i]) for i in rows]
        self.leads = _leaders(given["wanted"], given["before"], given["tie"], given["group"])
        self.back = [ca.if_else(self.modified, ca.if_else(change[i] < 0, 0.0, -UNLIMITED), -1.0) for i in rows]
        self.forth = [
            ca.if_else(ca.logic_and(self.modified, ca.logic_not(change[i] > 0)), UNLIMITED, 0.0) for i in rows
        ]
        self.done: list[tuple[int, int]] = []
        self.row_of: dict[int, int] = {}

    def solve(self, pairs: tuple[tuple[int, int], ...]) -> Any:
        """Return the shaped references."""
        t: list[Any] = [ca.SX(0) for _ in range(self.m)]
        for row, own in pairs:
            if self.done:
                t = self._make_room(row, own, t)
            t[own] = self._place(row, own, t)
            self.done.append((row, own))
            self.row_of[own] = row
            t = self._follow(own, t)
        wanted, before = self.given["wanted"], self.given["before"]
        result = []
        for i in range(self.m):
            moved = ca.if_else(t[i] == 0, wanted[i], wanted[i] + t[i] * self.unit[i])
            kept = ca.fmax(ca.fmin(wanted[i], before[i]), ca.fmin(moved, ca.fmax(wanted[i], before[i])))
            kept = ca.if_else(t[i] > -1, kept, before[i])
            result.append(ca.if_else(self.modified, moved, kept))
        return ca.vertcat(*result)

    def _position(self, i: int, t: list[Any]) -> Any:
        return self.change[i] + t[i] * self.unit[i]

    def _moving(self, row: int, t: list[Any]) -> Any:
        return sum((self.gain[row, i] * self._position(i, t) for _, i in self.done), ca.SX(0))

    def _command(self, row: int, t: list[Any]) -> Any:
        return self.free[row] + self._moving(row, t)

    def _excess(self, row: int, t: list[Any]) -> Any:
        value = self._command(row, t)
        return ca.fmax(ca.fmax(value - self.most[row], self.least[row] - value), 0.0)

    def _make_room(self, row: int, own: int, t: list[Any]) -> list[Any]:
        reserve, middle = self.given["reserve"][row], 0.5 * (self.least[row] + self.most[row])
        lower, upper = self.least[row] + reserve, self.most[row] - reserve
        crossed = lower > upper
        lower, upper = ca.if_else(crossed, middle, lower), ca.if_else(crossed, middle, upper)
        change = self.change[own]
        small = ca.sign(change) * ca.fmin(ca.fabs(change), self.given["rate_step"][own])
        still = self._command(row, t)
        value = still + self.gain[row, own] * small
        coupled: Any = 0.0
        for other, _ in self.done:
            coupled = ca.logic_or(coupled, self.gain[other, own] != 0)
        above = ca.if_else(coupled, ca.fmax(still, value), value) - upper
        below = ca.if_else(coupled, ca.fmin(still, value), value) - lower
        lacking = ca.if_else(above > 0, above, ca.if_else(below < 0, below, 0.0))
        plain = self._give_way(row, lacking, t)
        towards = self._give_way(row, lacking, t, back=False)
        left = lacking + self._command(row, towards) - self._command(row, t)
        left = ca.if_else(left * lacking > 0, left, 0.0)
        further = self._give_way(row, left, towards)
        moved = [ca.if_else(self.modified, further[i], plain[i]) for i in range(self.m)]
        worse: Any = 0.0
        for other, _ in self.done:
            allowed = TOLERANCE * ca.fabs(self.most[other] - self.least[other]) + self._excess(other, t)
            worse = ca.logic_or(worse, self._excess(other, moved) > allowed)
        held = self._hold_back(row, lacking, t)
        return [
            ca.if_else(lacking == 0, t[i], ca.if_else(worse, held[i], moved[i])) if i in self.row_of else t[i]
            for i in range(self.m)
        ]

    def _give_way(self, row: int, lacking: Any, t: list[Any], back: bool = True) -> list[Any]:
        firsts = range(self.m)
        slope, effort, room = [], [], []
        for f in firsts:
            rate = self._led(row, f)
            shares = (self.leads[i][f] * (self.gain[self.row_of[i], i] * self.unit[i]) ** 2 for _, i in self.done)
            square = sum(shares, ca.SX(0))
            effort.append(ca.if_else(square > 0, ca.sqrt(ca.if_else(square > 0, square, 1.0)), 1.0))
            slope.append(rate / effort[f])
            direction = ca.if_else(rate * lacking > 0, -1.0, 1.0)
            room.append(ca.if_else(rate == 0, 0.0, self._room(f, direction, t, back)))
        full: list[Any] = [0.0 for _ in firsts]
        factor: Any = 0.0
        for turn in range(self.m + 1):
            left, stiffness = ca.fabs(lacking), ca.SX(0)
            for f in firsts:
                left = left - ca.if_else(full[f], ca.fabs(slope[f]) * room[f] * effort[f], 0.0)
                stiffness = stiffness + ca.if_else(full[f], 0.0, slope[f] ** 2)
            factor = ca.if_else(stiffness > 0, left / ca.if_else(stiffness > 0, stiffness, 1.0), 0.0)
            if turn < self.m:
                full = [ca.logic_or(full[f], factor * ca.fabs(slope[f]) >= room[f] * effort[f]) for f in firsts]
        steps = [
            -ca.sign(slope[f] * lacking) * ca.if_else(full[f], room[f], factor * ca.fabs(slope[f]) / effort[f])
            for f in firsts
        ]
        return [t[i] + sum(self.leads[i][f] * steps[f] for f in firsts) for i in range(self.m)]

    def _led(self, row: int, first: int) -> Any:
        return sum((self.leads[i][first] * self.gain[row, i] * self.unit[i] for _, i in self.done), ca.SX(0))

    def _room(self, first: int, direction: Any, t: list[Any], back: bool) -> Any:
        room = ca.SX(UNLIMITED)
        for row, i in self.done:
            own = ca.if_else(direction < 0, t[i] - self.back[i], self.forth[i] - t[i])
            if not back:
                own = ca.fmin(own, ca.fmax(-direction * self._position(i, t), 0.0))
            rate, value = direction * self._led(row, first), self._command(row, t)
            gap = ca.if_else(rate > 0, self.most[row] - value, value - self.least[row])
            kept = ca.fmin(own, gap / ca.if_else(rate == 0, 1.0, ca.fabs(rate)))
            own = ca.if_else(ca.logic_and(self.modified, rate != 0), kept, own)
            room = ca.fmin(room, ca.if_else(self.leads[i][first], own, UNLIMITED))
        return ca.fmax(room, 0.0)

    def _hold_back(self, row: int, lacking: Any, t: list[Any]) -> list[Any]:
        moving = self._moving(row, t)
        helps = moving * lacking > 0
        share = ca.fmin(ca.fmax(1.0 - lacking / ca.if_else(helps, moving, 1.0), 0.0), 1.0)
        share = ca.if_else(helps, share, 1.0)
        held = []
        for i in range(self.m):
            unit = ca.if_else(self.unit[i] == 0, 1.0, self.unit[i])
            held.append(ca.if_else(self.unit[i] == 0, t[i], (share * self._position(i, t) - self.change[i]) / unit))
        return held

    def _place(self, row: int, own: int, t: list[Any]) -> Any:
        gain = self.gain[row, own]
        rate = gain * self.unit[own]
        value = self._command(row, t) + gain * self.change[own]
        bound = _between(value, self.least[row], self.most[row])
        needed = ca.if_else(rate == 0, 0.0, (bound - value) / ca.if_else(rate == 0, 1.0, rate))
        result = ca.fmin(ca.fmax(needed, self.back[own]), self.forth[own])
        for other, _ in self.done:
            result = self._not_worse(other, own, result, t)
        return result

    def _not_worse(self, row: int, own: int, placed: Any, t: list[Any]) -> Any:
        gain = self.gain[row, own]
        rate, still = gain * self.unit[own], self._command(row, t)
        value = still + gain * (self.change[own] + placed * self.unit[own])
        bound = _between(value, ca.fmin(still, self.least[row]), ca.fmax(still, self.most[row]))
        target = placed + ca.if_else(rate == 0, 0.0, (bound - value) / ca.if_else(rate == 0, 1.0, rate))
        return ca.if_else(self.modified, target, ca.fmin(ca.fmax(target, -1.0), 0.0))

    def _follow(self, own: int, t: list[Any]) -> list[Any]:
        furthest = t[own]
        same = {
            i: sum((self.leads[i][f] * self.leads[own][f] for f in range(self.m)), ca.SX(0)) > 0 for _, i in self.done
        }
        for i, tied in same.items():
            furthest = ca.if_else(ca.logic_and(tied, ca.fabs(t[i]) > ca.fabs(furthest)), t[i], furthest)
        return [ca.if_else(same[i], furthest, t[i]) if i in same else t[i] for i in range(self.m)]


def _between(value: Any, lower: Any, upper: Any) -> Any:
    """Return `value`, or the bound that it is beyond; the upper one wins."""
    return ca.if_else(value > upper, upper, ca.if_else(value < lower, lower, value))


def optimal_governor(
    chosen: Any,
    wanted: Any,
    before: Any,
    free: Any,
    gain: Any,
    least: Any,
    most: Any,
    deviation: Any,
    rows_x: Any,
    rows_r: Any,
    weight: Any,
    tie: Any,
    group: Any,
    fallback: Any,
    *numbers: int,
) -> tuple[Any, Any, Any, Any]:
    """Return shaped references, slack, iterations and status; see `ptgen.shaping.optimal.optimal_governor`."""
    m = wanted.shape[0]
    counts, most_iterations = numbers[:m], numbers[m]
    change = wanted - before
    leads = _leaders(wanted, before, tie, group)
    collected = ca.vertcat(*[ca.horzcat(*row) for row in leads])
    command = free + gain @ change
    added = rows_x @ deviation
    machine, parts, slopes, start = [], [], [], 0
    for i, count in enumerate(counts):  # the row of the present step comes first
        machine += [i] * (count + 1)
        parts.append(command[i])
        slopes.append(gain[i, :])
        if count:
            parts.append(command[i] + added[start : start + count])
            slopes.append(ca.repmat(gain[i, :], count, 1) + rows_r[start : start + count, :])
        start += count
    v, slope = ca.vertcat(*parts), ca.vertcat(*slopes) @ ca.diag(change)
    span = 0.5 * (most - least)
    span = ca.if_else(span > 0, span, 1.0)
    still = v - ca.sum2(slope)
    lacking = ca.fmax(ca.fmax(still - most[machine], least[machine] - still), 0.0)
    slack = ca.vertcat(*[ca.mmax(lacking[[j for j, own in enumerate(machine) if own == i]]) for i in range(m)])
    wide = span + slack
    wider = slack + MARGIN * wide
    limits = [array[machine] for array in (least, most, span, least - wider, most + wider, wide)]
    w = collected.T @ weight
    start_state = [ca.MX.zeros(m), w, ca.vec(ca.MX.eye(m)), ca.vec(ca.MX.eye(m)), ca.MX.zeros(m), ca.DM(range(m))]
    state = ca.vertcat(*start_state, ca.MX.zeros(3))
    data = ca.vertcat(w, v, ca.vec(slope @ collected), *limits)
    iteration = _iteration(m, len(machine), most_iterations)
    for _ in range(most_iterations + 1):  # calls of one function: `fold` would copy the data each time
        state = iteration(state, data)
    _, _, _, normals, sides, bounds, count, phase, code = _split(state, m)
    solved = code == _SOLVED
    held = collected @ _vertex(ca.reshape(normals, m, m), sides, bounds)
    moved = ca.fmax(ca.fmin(wanted, before), ca.fmin(wanted - held * change, ca.fmax(wanted, before)))
    shaped = ca.if_else(held >= 1, before, ca.if_else(held > 0, moved, wanted))
    slack = ca.if_else(phase > 0, slack, 0.0)
    status = ca.if_else(ca.mmax(slack) > 0, SLACK, ca.if_else(count > 0, LIMITED, NOTHING_BINDS))
    status = ca.if_else(solved, status, NOT_SOLVED)
    asked = chosen > 0.5
    return (
        ca.if_else(ca.logic_and(asked, solved), shaped, fallback),
        ca.if_else(asked, slack, 0.0),
        ca.if_else(asked, count, 0.0),
        ca.if_else(asked, status, NOTHING_BINDS),
    )


def _split(state: Any, m: int) -> list[Any]:
    """Return s, prices, inverse, normals, sides, bounds, iterations, whether limits are widened, and the outcome."""
    sizes = [m, m, m * m, m * m, m, m, 1, 1, 1]
    return list(ca.vertsplit(state, np.cumsum([0, *sizes]).tolist()))


@functools.cache
def _iteration(m: int, N: int, most_iterations: int) -> Any:
    """Return the function of one iteration of the dual simplex, see `ptgen.shaping.dual_simplex`."""
    sizes = [m, N, N * m, *[N] * 6]
    state, data = ca.MX.sym("state", 2 * m * m + 4 * m + 3), ca.MX.sym("data", sum(sizes))
    weight, v, a, *limits = ca.vertsplit(data, np.cumsum([0, *sizes]).tolist())
    s, price, inverse_, normals_, sides, bounds, count, phase, code = _split(state, m)
    A, inverse, normals = ca.reshape(a, N, m), ca.reshape(inverse_, m, m), ca.reshape(normals_, m, m)
    lower, upper, scale = (
        ca.if_else(phase > 0, wide, tight) for tight, wide in zip(limits[:3], limits[3:], strict=True)
    )
    values = v - A @ s
    violations = ca.vertcat(-s, s - 1.0, (values - upper) / scale, (lower - values) / scale)
    worst = ca.mmax(violations)
    where = ca.fmin(ca.find(violations >= worst), 2 * m + 2 * N - 1)
    identity = ca.MX.eye(m)
    at_bound, side_of = where < 2 * m, ca.if_else(where < 2 * m + N, 1.0, -1.0)
    row = ca.fmax(where - 2 * m - ca.if_else(where < 2 * m + N, 0, N), 0)
    unknown = ca.if_else(where < m, where, where - m)
    unit = ca.vertcat(*[unknown == k for k in range(m)])
    raw = ca.if_else(at_bound, ca.if_else(where < m, unit, -unit), side_of * A[row, :].T)
    excess = ca.if_else(side_of > 0, v[row] - upper[row], lower[row] - v[row])
    side = ca.if_else(at_bound, ca.if_else(where < m, 0.0, -1.0), excess)
    size = ca.mmax(ca.fabs(raw))
    normal = raw / ca.if_else(size > 0, size, 1.0)
    side = ca.if_else(size > 0, side / ca.if_else(size > 0, size, 1.0), 1.0)
    bound = ca.if_else(at_bound, unknown, -1.0)
    rates = inverse.T @ normal
    leaving, least = ca.MX(-1.0), ca.MX(_LARGEST)
    for k in range(m):
        falls = rates[k] > LEAST_PIVOT
        ratio = ca.if_else(falls, price[k] / ca.if_else(falls, rates[k], 1.0), _LARGEST)
        better = ca.logic_and(falls, ratio < least)
        leaving, least = ca.if_else(better, ca.MX(float(k)), leaving), ca.if_else(better, ratio, least)
    none = leaving < 0
    step = ca.if_else(none, 0.0, least)
    chosen = ca.vertcat(*[leaving == k for k in range(m)])
    column = inverse @ chosen / ca.if_else(none, 1.0, ca.dot(chosen, rates))
    holds, spent = ca.logic_not(worst > FEASIBLE), count >= most_iterations
    going = ca.logic_and(ca.logic_not(holds), ca.logic_and(ca.logic_not(spent), code == _RUNNING))
    moves = ca.logic_and(going, ca.logic_not(none))
    restarts = ca.logic_and(going, ca.logic_and(none, phase == 0))
    fails = ca.logic_and(going, ca.logic_and(none, phase > 0))
    pivoted = [
        s + (side - ca.dot(normal, s)) * column,
        ca.if_else(chosen, step, ca.fmax(price - step * rates, 0.0)),
        ca.vec(inverse - column @ rates.T + (column - (inverse - column @ rates.T) @ chosen) @ chosen.T),
        ca.vec(normals + chosen @ (normal - normals.T @ chosen).T),
        ca.if_else(chosen, side, sides),
        ca.if_else(chosen, bound, bounds),
    ]
    start = [ca.MX.zeros(m), weight, ca.vec(identity), ca.vec(identity), ca.MX.zeros(m), ca.MX(ca.DM(range(m)))]
    kept = [s, price, inverse_, normals_, sides, bounds]
    after = [
        ca.if_else(moves, new, ca.if_else(restarts, first, old))
        for new, first, old in zip(pivoted, start, kept, strict=True)
    ]
    ended = ca.if_else(holds, _SOLVED, ca.if_else(ca.logic_or(spent, fails), _FAILED, _RUNNING))
    after += [count + going, ca.fmax(phase, restarts), ca.if_else(code == _RUNNING, ended, code)]
    return ca.Function(f"governor_iteration_{m}_{N}", [state, data], [ca.vertcat(*after)])


def _vertex(normals: Any, sides: Any, bounds: Any) -> Any:
    """Return the point where the active constraints meet; unknowns at a bound are exact."""
    m = sides.shape[0]
    hits = ca.vertcat(*[ca.horzcat(*[bounds[k] == g for g in range(m)]) for k in range(m)])
    at_row = bounds < 0
    fixed, at = ca.sum1(hits).T, hits.T @ ca.if_else(sides < 0, 1.0, 0.0)
    rows = ca.repmat(at_row, 1, m) * normals * ca.repmat(1.0 - fixed.T, m, 1)
    right = ca.if_else(at_row, sides - normals @ at, 0.0)
    free = ca.solve(rows + hits, right)
    return ca.fmin(ca.fmax(ca.if_else(fixed > 0, at, free), 0.0), 1.0)

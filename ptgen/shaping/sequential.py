r"""The sequential governor: one reference after the other, each as close to the wanted one as its machine allows.

The torque commands of this step are affine in the references, :math:`u = u_0 + G\,\Delta\tilde r` (source, (7.42)).
Each reference has its own row: the command of the machine that it asks most of. The references are taken in an order
in which the row of each depends on earlier ones, as far as there is one; later ones count as unchanged. For each
reference q with its row p:

1. If row p would be violated though q changes by no more than its minimal rate, and with a reserve of torque kept
   free, the earlier references give way: they are moved to the nearest point that keeps the row, see `_give_way`. For
   two equal machines that is the projection of the source's Figure 7.10. If that violated an earlier row,
   all of them are held back by the same share instead. With (7.43) they first give way as far as standing still,
   and go back only for what is lacking then.
   The change of q counts as well if it helps, unless an earlier row depends on q and might forbid it.
2. Reference q is moved as far back from the wanted value as row p needs, and so that no earlier row gets worse.

By (7.41) a reference stays between its last value and the wanted one. The modification (7.43) only keeps it from
passing the wanted one: it may go back, so that limits are kept that would be violated without any change. Tied
references move by as much as the one that has to move most, be it past a wanted one that is closer than the tie.

*Coordinates.* Reference i is at :math:`\Delta_i = \Delta_{i,wanted} + t_i e_i`. By (7.41) :math:`e_i` is the wanted
change and :math:`-1 \le t_i \le 0`, so tied references go on by the same share; by (7.43) :math:`e_i` is 1, so tied
references are shifted by the same amount.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.shaping.ties import leaders

__all__ = ["TOLERANCE", "UNLIMITED", "sequential_governor"]

Array = NDArray[np.float64]

UNLIMITED = 1e30
"""Stands for a coordinate without a bound."""

TOLERANCE = 1e-9
"""A row counts as worse only beyond this share of its limits."""


def sequential_governor(
    wanted: Array,
    before: Array,
    free: Array,
    gain: Array,
    least: Array,
    most: Array,
    reserve: Array,
    rate_step: Array,
    tie: Array,
    modified: Array,
    group: Array,
    *order: int,
) -> Array:
    """Return shaped references (m,); those of the last step if an input is not finite or results would not be.

    All arrays may have leading batch axes.

    Parameters
    ----------
    wanted, before : ndarray (m,)
        References as they are asked for, and shaped ones of the last step (rad/s or N m).
    free, gain : ndarray (m,), (m, m)
        Torque commands before any limit are ``free + gain (shaped - before)`` (N m).
    least, most : ndarray (m,)
        Limits of the commands (N m).
    reserve : ndarray (m,)
        What others must leave of the torque of each machine (N m).
    rate_step : ndarray (m,)
        Smallest change of each reference in a step for which others must leave room (rad/s or N m).
    tie : ndarray ()
    modified : ndarray ()
        Above 0.5: (7.43) instead of (7.41).
    group : ndarray (m,)
        References with the same positive number that are closer than `tie`, before and wanted, are led together.
    *order : int
        Row and reference of each step, one pair after the other. A reference that is in no pair is not limited.
    """
    arrays = (wanted, before, free, gain, least, most, reserve, rate_step, tie, modified, group)
    ranks = (1, 1, 1, 2, 1, 1, 1, 1, 0, 0, 1)
    given = [np.asarray(array, dtype=np.float64) for array in arrays]
    batch = np.broadcast_shapes(*(a.shape[: a.ndim - rank] for a, rank in zip(given, ranks, strict=True)))
    given = [np.broadcast_to(a, batch + a.shape[a.ndim - rank :]) for a, rank in zip(given, ranks, strict=True)]
    shaped = np.zeros((*batch, given[0].shape[-1]))
    pairs = tuple(zip(order[::2], order[1::2], strict=True))
    for index in np.ndindex(*batch):
        one = [a[index] for a in given]
        if not all(np.isfinite(array).all() for array in one):
            shaped[index] = one[1]
            continue
        names = ("wanted", "before", "free", "gain", "least", "most", "reserve", "rate_step")
        vectors = dict(zip(names, one, strict=False))
        with np.errstate(over="ignore", invalid="ignore"):
            problem = _Problem(**vectors, tie=float(one[8]), modified=bool(one[9] > 0.5), group=one[10])
            result = problem.solve(pairs)
        shaped[index] = result if np.isfinite(result).all() else one[1]
    return shaped


@dataclass
class _Problem:
    """One problem; see `sequential_governor`."""

    wanted: Array
    before: Array
    free: Array
    gain: Array
    least: Array
    most: Array
    reserve: Array
    rate_step: Array
    tie: float
    modified: bool
    group: Array

    def __post_init__(self) -> None:
        m = len(self.wanted)
        self.change = self.wanted - self.before
        self.unit = np.ones(m) if self.modified else self.change
        self.leader = leaders(self.wanted, self.before, self.tie, self.group)
        back = np.where(self.change < 0.0, 0.0, -UNLIMITED) if self.modified else np.full(m, -1.0)
        forth = np.where(self.change > 0.0, 0.0, UNLIMITED) if self.modified else np.zeros(m)
        self.box = np.stack([back, forth])
        self.t = np.zeros(m)
        self.row_of = np.full(m, -1)
        self.earlier: list[tuple[int, int]] = []

    def solve(self, pairs: tuple[tuple[int, int], ...]) -> Array:
        """Return the shaped references."""
        for row, own in pairs:
            self._make_room(row, own)
            self._place(row, own)
            self.earlier.append((row, own))
            self.row_of[own] = row
            self._follow(own)
        shaped = np.where(self.t == 0.0, self.wanted, self.wanted + self.t * self.unit)
        if self.modified:
            return shaped
        shaped = np.where(self.t == -1.0, self.before, shaped)
        return np.clip(shaped, np.minimum(self.wanted, self.before), np.maximum(self.wanted, self.before))

    def _position(self, reference: int, t: Array) -> float:
        return float(self.change[reference] + t[reference] * self.unit[reference])

    def _command(self, row: int, t: Array) -> float:
        """Return the command of a row with the earlier references as they are."""
        moving = sum(float(self.gain[row, i]) * self._position(i, t) for _, i in self.earlier)
        return float(self.free[row]) + moving

    def _make_room(self, row: int, own: int) -> None:
        """Let the earlier references give way if they leave too little for the reference `own`."""
        lower, upper = self.least[row] + self.reserve[row], self.most[row] - self.reserve[row]
        if lower > upper:
            lower = upper = 0.5 * (lower + upper)
        small = np.sign(self.change[own]) * min(abs(self.change[own]), self.rate_step[own])
        still = self._command(row, self.t)
        value = still + self.gain[row, own] * small
        # Earlier rows may keep `own` from moving, so it cannot be counted on.
        coupled = any(self.gain[other, own] != 0.0 for other, _ in self.earlier)
        above = (max(still, value) if coupled else value) - upper
        below = (min(still, value) if coupled else value) - lower
        lacking = above if above > 0.0 else below if below < 0.0 else 0.0
        if lacking == 0.0 or not self.earlier:
            return
        moved = self._give_way(row, lacking, self.t, back=not self.modified)
        if self.modified:  # back only as far as standing still is not enough
            left = lacking + self._command(row, moved) - self._command(row, self.t)
            moved = self._give_way(row, left, moved) if left * lacking > 0.0 else moved
        worse = False
        for other, _ in self.earlier:
            worst = TOLERANCE * abs(self.most[other] - self.least[other]) + self._excess(other, self.t)
            worse = worse or self._excess(other, moved) > worst
        if worse:
            moved = self._hold_back(row, lacking)
        self.t = moved

    def _excess(self, row: int, t: Array) -> float:
        value = self._command(row, t)
        return float(max(value - self.most[row], self.least[row] - value, 0.0))

    def _give_way(self, row: int, lacking: float, t: Array, back: bool = True) -> Array:
        r"""Return coordinates that take `lacking` off a row, as far as they may, with the least effort.

        The effort is :math:`\sum_i (G_{p_i i} \delta_i)^2`, in torque of each reference's own machine, so it does not
        depend on units. Its minimum on the strip and in the box has :math:`\delta_i = -\lambda a_i` up to the bounds;
        the share of those that are at their bound grows with :math:`\lambda`, so as many rounds as there are references
        find it.
        """
        firsts = sorted({self.leader[i] for _, i in self.earlier})
        slope, room, effort = np.zeros(len(firsts)), np.zeros(len(firsts)), np.zeros(len(firsts))
        for place, first in enumerate(firsts):
            tied = [i for _, i in self.earlier if self.leader[i] == first]
            rate = sum(self.gain[row, i] * self.unit[i] for i in tied)
            effort[place] = np.sqrt(sum((self.gain[self.row_of[i], i] * self.unit[i]) ** 2 for i in tied))
            effort[place] = effort[place] if effort[place] > 0.0 else 1.0
            slope[place] = rate / effort[place]
            direction = -1.0 if rate * lacking > 0.0 else 1.0
            room[place] = min(self._room(i, tied, direction, t, back) for i in tied) if rate != 0.0 else 0.0
        full, wanted = np.zeros(len(firsts), dtype=bool), abs(lacking)
        for _ in firsts:
            left = wanted - np.sum(np.abs(slope[full]) * room[full] * effort[full])
            stiffness = np.sum(slope[~full] ** 2)
            factor = left / stiffness if stiffness > 0.0 else 0.0
            full = full | (factor * np.abs(slope) >= room * effort)
        left = wanted - np.sum(np.abs(slope[full]) * room[full] * effort[full])
        stiffness = np.sum(slope[~full] ** 2)
        factor = left / stiffness if stiffness > 0.0 else 0.0
        moved = t.copy()
        for place, first in enumerate(firsts):
            step = room[place] if full[place] else factor * abs(slope[place]) / effort[place]
            direction = -np.sign(slope[place] * lacking)
            for i in (i for _, i in self.earlier if self.leader[i] == first):
                moved[i] += direction * step
        return moved

    def _room(self, reference: int, tied: list[int], direction: float, t: Array, back: bool) -> float:
        """Return how far a coordinate may move: in its box and, if it may go back, while its own row is kept."""
        low, high = self.box[:, reference]
        room = t[reference] - low if direction < 0.0 else high - t[reference]
        if not back:
            room = min(room, max(-direction * self._position(reference, t), 0.0))
        if self.modified:
            row = self.row_of[reference]
            rate = direction * sum(self.gain[row, i] for i in tied)
            value = self._command(row, t)
            gap = self.most[row] - value if rate > 0.0 else value - self.least[row]
            if rate != 0.0:
                room = min(room, gap / abs(rate))
        return float(max(room, 0.0))

    def _hold_back(self, row: int, lacking: float) -> Array:
        """Return coordinates of all earlier references held back by the same share."""
        moving = sum(self.gain[row, i] * self._position(i, self.t) for _, i in self.earlier)
        share = min(max(1.0 - lacking / moving, 0.0), 1.0) if moving * lacking > 0.0 else 1.0
        moved = self.t.copy()
        for _, i in self.earlier:
            if self.unit[i] != 0.0:
                moved[i] = (share * self._position(i, self.t) - self.change[i]) / self.unit[i]
        return moved

    def _place(self, row: int, own: int) -> None:
        """Move the reference `own` back as far as its row needs."""
        rate = self.gain[row, own] * self.unit[own]
        value = self._command(row, self.t) + self.gain[row, own] * self.change[own]
        t = 0.0
        if value > self.most[row] and rate != 0.0:
            t = (self.most[row] - value) / rate
        elif value < self.least[row] and rate != 0.0:
            t = (self.least[row] - value) / rate
        low, high = self.box[:, own]
        t = min(max(t, low), high)
        for other, _ in self.earlier:
            t = self._not_worse(other, own, t)
        self.t[own] = t

    def _not_worse(self, row: int, own: int, t: float) -> float:
        """Return the coordinate nearest to `t` for which a row is no worse than if `own` is not changed."""
        rate = self.gain[row, own] * self.unit[own]
        still = self._command(row, self.t)
        lower, upper = min(still, self.least[row]), max(still, self.most[row])
        value = still + self.gain[row, own] * (self.change[own] + t * self.unit[own])
        if rate != 0.0 and value > upper:
            t += (upper - value) / rate
        elif rate != 0.0 and value < lower:
            t += (lower - value) / rate
        return t if self.modified else min(max(t, -1.0), 0.0)

    def _follow(self, own: int) -> None:
        """Bring the references that are tied to `own`, and are placed, to the coordinate that is furthest back."""
        tied = [i for _, i in self.earlier if self.leader[i] == self.leader[own]]
        furthest = own
        for i in tied:
            furthest = i if abs(self.t[i]) > abs(self.t[furthest]) else furthest
        t = self.t[furthest]
        for i in tied:
            self.t[i] = t

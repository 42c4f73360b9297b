r"""Which friction elements of zero velocity are held, and what breaks loose if they are not.

`HeldElements` is about elements that stick; `Contest` decides at acceleration level which of them do. For rows
:math:`G_s` of elements at rest and the torques :math:`r` that they have to hold, there are torques within the limits
:math:`l, h` with :math:`G_s' T = r` if and only if

.. math::
    d' r \le \sum_i \max(l_i c_i, h_i c_i), \qquad c = G_s d,

for all virtual motions :math:`d` (principle of virtual power; the right-hand side is the support function of the set
that friction can hold, a zonotope). Its facets have the normals :math:`d` in which as many elements as possible stay
at rest, so that these motions suffice. Their :math:`c` are the cocircuits of the rows; with independent rows they are
the unit vectors, and each element is asked alone.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ptgen.errors import Problem, RunError
from ptgen.friction.event_bed import Array, Booleans, EventBed, Integers
from ptgen.friction.sectors import SectorSolution, enumerate_sectors

__all__ = ["ROUNDING", "Contest", "HeldElements", "at_rest", "closed"]

ROUNDING = 1e-13
"""Part of the quantities involved by which a condition may be violated."""

_RANK = 1e-10
"""Relative size below which a row is none."""

_LOAD_ITERATIONS = 2000
"""Iterations over the loads; each brings the error down by the gain of the loop."""


@dataclass(frozen=True)
class HeldElements:
    """What follows from which elements stick.

    Attributes
    ----------
    stuck : tuple of int
        The elements that stick.
    free : ndarray of int
        Coordinates that stay independent, ``y = z[free]``.
    N : ndarray (n_z, n_y)
        ``z = N y``.
    accelerate : ndarray (n_z, n_z)
        ``N (N'MN)^-1 N'``.
    react : ndarray (n_s, n_z)
        Torques that hold the elements, per torque on the coordinates.
    cocircuits : ndarray (n_m, n_s)
        Velocities of the elements in the virtual motions that decide whether they can be held.
    dependent : bool
        Whether their torques are not unique.
    """

    stuck: tuple[int, ...]
    free: Integers
    N: Array
    accelerate: Array
    react: Array
    cocircuits: Array
    dependent: bool

    @classmethod
    def of(cls, bed: EventBed, stuck: tuple[int, ...]) -> HeldElements:
        """Return what follows for the elements `stuck`."""
        M, rows = bed.M, bed.G[list(stuck)]
        N, free = _null_basis(rows)
        accelerate = N @ np.linalg.solve(N.T @ M @ N, N.T) if N.shape[1] else np.zeros_like(M)
        weight = np.sqrt(np.diag(bed.K)[list(stuck)])
        react = np.linalg.pinv(rows.T / weight, rcond=_RANK) / weight[:, None] if stuck else np.zeros((0, len(M)))
        react = react @ (np.eye(len(M)) - M @ accelerate)
        rank = len(M) - len(free)
        return cls(stuck, free, N, accelerate, react, _cocircuits(rows, rank), rank < len(stuck))

    def margins(self, torques: Array, lo: Array, hi: Array) -> Array:
        """Return for each of the motions how much more power friction can take, given torques that hold."""
        c = self.cocircuits
        with np.errstate(invalid="ignore"):
            most = np.where(c > 0, c * hi, np.where(c < 0, c * lo, 0.0)).sum(axis=1)
        return np.asarray(most - c @ torques, dtype=np.float64)


def _null_basis(rows: Array) -> tuple[Array, Integers]:
    """Return a basis of the null space in echelon form, and the coordinates that it leaves free.

    The basis of a row that is a coordinate has exact zeros there, so that this velocity is exactly zero.
    """
    reduced = rows.copy()
    pivots: list[int] = []
    scale = np.abs(rows).max(initial=0.0)
    for _ in range(len(rows)):
        rest = np.abs(reduced[len(pivots) :])
        if rest.max(initial=0.0) <= _RANK * scale:
            break
        first = len(pivots)
        best, column = divmod(int(np.argmax(rest)), rest.shape[1])
        reduced[[first, first + best]] = reduced[[first + best, first]]
        reduced[first] /= reduced[first, column]
        for other in range(len(reduced)):
            if other != first:
                reduced[other] -= reduced[other, column] * reduced[first]
        reduced[:first, column] = 0.0
        pivots.append(column)
    free = np.array([k for k in range(rows.shape[1]) if k not in pivots], dtype=np.int64)
    N = np.zeros((rows.shape[1], len(free)))
    N[free, np.arange(len(free))] = 1.0
    for row, column in enumerate(pivots):
        N[column] = -reduced[row, free]
    return N, free


def _cocircuits(rows: Array, rank: int) -> Array:
    """Return the velocities of all elements in the motions that leave as many of them at rest as possible.

    Examples
    --------
    Two clutches in a row break away alone, two side by side only together:

    >>> _cocircuits(np.eye(2), 2)
    array([[ 1.,  0.],
           [-1., -0.],
           [ 0.,  1.],
           [-0., -1.]])
    >>> _cocircuits(np.array([[1.0], [1.0]]), 1)
    array([[ 1.,  1.],
           [-1., -1.]])
    """
    count = len(rows)
    found: list[Array] = []
    if rank == count:
        found = list(np.eye(count))
    else:
        span = np.linalg.svd(rows, full_matrices=False)[2][:rank]
        seen = set()
        for resting in itertools.combinations(range(count), rank - 1):
            _, values, motions = np.linalg.svd(rows[list(resting)] @ span.T)
            if rank > 1 and values.min() <= _RANK * np.abs(rows).max():
                continue
            velocities = rows @ (motions[-1] @ span)
            velocities = velocities / velocities[np.argmax(np.abs(velocities))]
            velocities[np.abs(velocities) < 1e-9] = 0.0
            support = tuple(np.flatnonzero(velocities))
            if support not in seen:
                seen.add(support)
                found.append(velocities)
    return np.array([sign * each for each in found for sign in (1.0, -1.0)]).reshape(2 * len(found), count)


def closed(G: Array, rest: Booleans) -> Booleans:
    """Return the elements at rest with those that are then at rest too, because their rows depend on the others.

    Examples
    --------
    >>> closed(np.array([[1.0, 0.0], [0.0, 1.0], [2.0, -1.0]]), np.array([True, True, False]))
    array([ True,  True,  True])
    """
    if not rest.any():
        return rest
    N, _ = _null_basis(G[rest])
    moved = np.abs(G @ N).max(axis=1, initial=0.0)
    return np.asarray(rest | (moved <= _RANK * np.abs(G).max()), dtype=np.bool_)


def at_rest(bed: EventBed, z: Array, rest: Booleans) -> Array:
    """Return the velocities with those of the elements at rest zero, changed as little as the inertias allow."""
    if not rest.any():
        return z
    rows = bed.G[rest]
    spread = np.linalg.solve(bed.M, rows.T)
    settled = z - spread @ (np.linalg.pinv(rows @ spread, rcond=_RANK, hermitian=True) @ (rows @ z))
    N, free = _null_basis(rows)
    return np.asarray(N @ settled[free], dtype=np.float64)


@dataclass(frozen=True)
class Contest:
    """Who sticks and who breaks away among the elements of zero velocity, at acceleration level.

    Attributes
    ----------
    bed : EventBed
    time : float
        For messages (s).
    applied : ndarray (n_z,)
        All torques on the coordinates but those of friction (N m).
    loads : ndarray (n_l,)
        The loads without what friction torques and accelerations add to them (N m).
    kinetic : ndarray (n_f,)
        Kinetic capacities without load (N m).
    mu, ripple : ndarray (n_f,)
        Actuations, and the factors that depend on angles.
    slip : ndarray of int (n_f,)
        Sense of the elements that move, 0 for those of zero velocity.
    """

    bed: EventBed
    time: float
    applied: Array
    loads: Array
    kinetic: Array
    mu: Array
    ripple: Array
    slip: Integers

    def settle(self, forced: Mapping[int, int]) -> tuple[Integers, Array, float]:
        """Return the sense of slip of every element, the loads, and the size of the torques involved.

        Parameters
        ----------
        forced : mapping of int to int
            Elements that break away whatever their acceleration, and in which direction.

        Raises
        ------
        RunError
            If loads and friction torques have no common solution.
        """
        bed, rest = self.bed, self.slip == 0
        slip = self.slip.copy()
        for i, sign in forced.items():
            slip[i] = sign
        by_kinetic = np.zeros(bed.n_f, dtype=bool)
        while True:
            torques, solution, loads = self._solve(slip, by_kinetic)
            scale = max(1.0, float(np.abs(torques).max(initial=0.0)), float(np.abs(self.applied).max(initial=0.0)))
            rounding = 10 * ROUNDING * scale * np.diag(bed.K)
            rates = np.zeros(bed.n_f)
            rates[slip == 0] = solution.accelerations
            moving = np.where(np.abs(rates) > rounding, np.sign(rates), 0).astype(np.int64)
            broken = (moving != 0) & ~by_kinetic
            if broken.any():
                slip[broken] = moving[broken]
                continue
            accelerations = bed.G @ np.linalg.solve(bed.M, self.applied - bed.G.T @ torques)
            turned = rest & (slip * accelerations < -rounding)
            if not turned.any():
                return np.where(slip == 0, moving, slip), loads, scale
            slip[turned] = 0
            by_kinetic |= turned

    def _solve(self, slip: Integers, by_kinetic: Booleans) -> tuple[Array, SectorSolution, Array]:
        """Return all torques, the box problem of the elements at rest and the loads; by iteration over the loads."""
        bed, laws = self.bed, self.bed.laws
        resting = np.flatnonzero(slip == 0)
        K, rows = bed.K[np.ix_(resting, resting)], bed.G[resting]
        loads = np.zeros(len(self.loads))
        for _ in range(_LOAD_ITERATIONS):
            capacity = self.kinetic + laws.by_load(self.mu, self.ripple, loads)
            torques = slip * capacity
            lo, hi = laws.limits(self.mu, self.ripple, loads)
            lo = np.where(by_kinetic, -capacity, lo)[resting]
            hi = np.where(by_kinetic & ~laws.one_way, capacity, hi)[resting]
            w = rows @ np.linalg.solve(bed.M, self.applied - bed.G.T @ torques)
            solution = enumerate_sectors(K, w, lo, hi)
            torques[resting] = solution.torques
            rates = np.linalg.solve(bed.M, self.applied - bed.G.T @ torques)
            before, loads = loads, self.loads + bed.loads.f[:, : bed.n_f] @ torques + bed.loads.a @ rates
            change = np.abs(np.abs(loads) - np.abs(before)).max(initial=0.0)
            if change <= 1e-14 * max(1.0, float(np.abs(loads).max(initial=0.0))):
                return torques, solution, loads
        what = f"has capacities and a load that grow with each other without end at t = {self.time:.12g} s"
        remedy = "lower the dependence on the load; as it is, the element would jam"
        names = [bed.frictions[i] for i in np.flatnonzero(laws.load)]
        raise RunError([Problem(name, what, remedy) for name in names])

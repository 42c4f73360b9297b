r"""Friction torques that hold or let go: the box-constrained complementarity problem, NumPy reference.

Given velocities (or accelerations) :math:`w` that would be there without friction torques and
:math:`w^+ = w - K T` with symmetric positive semidefinite :math:`K`, find :math:`T` with

.. math::
    l_i \le T_i \le h_i, \qquad w^+_i > 0 \Rightarrow T_i = h_i, \qquad w^+_i < 0 \Rightarrow T_i = l_i,
    \qquad l_i < T_i < h_i \Rightarrow w^+_i = 0,

:math:`l \le 0 \le h`, one of them possibly infinite. These are the conditions for the minimum of
:math:`f(T) = \tfrac12 T'KT - w'T` over the box; so :math:`w^+` is unique, and T is where K is regular. The velocity of
an element that is held is returned as exactly zero.

*One and two elements* have closed forms. For two, three clamps give the nine sectors of the source's Figure 4.7: with
:math:`t_2` the clamped second torque of the unconstrained solution, clamp :math:`(w_1 - K_{12} t_2)/K_{11}` to the
first interval and :math:`(w_2 - K_{21} T_1)/K_{22}` to the second. What is left of the first residual is
:math:`K_{12} (t_2 - T_2)`, which is rounding even if the determinant is. Two elements that hold the same motion share
it: :math:`t_2 = w_2 / (2 K_{22})`.

*More elements:* coordinate descent finds a face of the box, factorisation the minimum on it.

1. A sweep of clamped coordinate minimisations, :math:`T_i \leftarrow \mathrm{clip}(T_i + r_i / K_{ii})` with the
   residual :math:`r = w - K T`, finds the elements at their bounds; it lifts those off that do not belong there. It is
   left out at first if a guess is given.
2. On the elements inside, solve :math:`K_{FF} T_F = w_F - K_{FB} T_B`. Of the longest step there inside the box and of
   the whole step clamped to the box take the one with the lower :math:`f`; those that reach a bound stay there; repeat
   until the whole step fits.
3. Done if every residual has the sign that its bound allows, up to rounding; else again from 1, or once from 2 if all
   that is left is rounding of the elements inside, with :math:`K_{FF} d = r_F` for the change d.

No part of it lets f grow, a sweep from a point that is no minimum lowers it, and 2 ends in the minimum of a face;
there are finitely many faces, so it ends, degenerate or not. The number of factorisations is bounded all the same, see
`factorisations`. With changes only, torques that should be zero would keep the rounding of their former values, which
is large in a row that has nothing else; solved for as a whole only, the search can hang between two faces that differ
by rounding. So it changes over after `PATIENCE`.

*Dependent elements* make K singular: `is_deficient`. Where those that may hold something at the moment are independent,
as in every gear of a gear set, their torques are unique all the same, and all is as above. Otherwise the torques of
least norm :math:`\sum K_{ii} T_i^2` are taken, by the method of multipliers: solve with
:math:`K + \rho\,\mathrm{diag} K` in place of K, add :math:`w - K T` to w, and again, until T solves the problem itself.
That is right for elements that slip too: what is added for them presses them to their bounds, and is, like all that
velocities of the bed can be, orthogonal to the torques that K does not resist. Rounding moves torques by about its
share of :math:`\rho` along these; so :math:`\rho` is lowered only late, for matrices that are nearly singular besides.
Rows that depend on each other agree no better than to the rounding of the largest of them, which is what is asked for
then.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "DEFICIENT",
    "LEAST_SHIFT",
    "NO_PIVOT",
    "PATIENCE",
    "ROUNDING",
    "SMALLEST",
    "STRICT_PASSES",
    "BoxSolution",
    "factorisations",
    "is_deficient",
    "residual_rounding",
    "solve_box",
]

Array = NDArray[np.float64]

_EPSILON = float(np.finfo(np.float64).eps)

ROUNDING = 64
"""Residuals below this multiple of the machine precision, relative to what they are sums of, are rounding."""

DEFICIENT = 1024
"""Pivots below this multiple of the machine precision, relative to the diagonal, belong to a singular matrix."""

SMALLEST = float(np.finfo(np.float64).tiny)
"""Residuals below this are rounding as well: no smaller number has all its digits."""

NO_PIVOT = 8
"""Pivots below this multiple of the machine precision, relative to the diagonal, are rounding."""

LEAST_SHIFT = 16
"""Multiple of the machine precision that is added to the diagonal at least, if K is singular."""

PATIENCE = 6
"""Factorisations after which minima are solved for as changes."""

STRICT_PASSES = 3
"""Rounds of the method of multipliers in which each residual is compared with its own row."""


@dataclass(frozen=True)
class BoxSolution:
    """What `solve_box` returns.

    Attributes
    ----------
    T : ndarray (n,)
        Friction torques (N m), inside the box.
    w_plus : ndarray (n,)
        Velocities that are left (rad/s), exactly zero for elements that are held.
    factorisations : int
        Number of factorisations that it took.
    solved : bool
        Whether the residual is down to rounding.
    """

    T: Array
    w_plus: Array
    factorisations: int
    solved: bool


def factorisations(n: int) -> int:
    """Return how many factorisations are allowed for `n` elements."""
    return 12 + 4 * n


def is_deficient(K: Array) -> bool:
    """Tell whether some of the elements hold the same motion, which makes K (n, n) singular.

    Raises
    ------
    ValueError
        If K is not positive semidefinite, or an element acts on nothing.
    """
    diagonal = np.diag(K)
    tolerance = DEFICIENT * _EPSILON
    if np.all(diagonal > 0):
        S = K / np.sqrt(np.outer(diagonal, diagonal))
        for j in range(len(S)):
            pivot = j + int(np.argmax(np.diag(S)[j:]))
            S[[j, pivot]] = S[[pivot, j]]
            S[:, [j, pivot]] = S[:, [pivot, j]]
            if S[j, j] <= tolerance:  # the largest that is left: all of it should be zero
                if np.min(np.diag(S)[j:]) < -tolerance:
                    break
                return True
            S[j + 1 :, j + 1 :] -= np.outer(S[j + 1 :, j], S[j, j + 1 :]) / S[j, j]
        else:
            return False
    raise ValueError("friction matrix is not positive semidefinite: a mode of the bed is too fast for the step")


def solve_box(
    K: Array, w: Array, lo: Array, hi: Array, guess: Array | None = None, deficient: bool | None = None
) -> BoxSolution:
    """Solve the problem of the module.

    Parameters
    ----------
    K : ndarray (n, n)
        Friction matrix (rad/s per N m), symmetric positive semidefinite.
    w : ndarray (n,)
        Velocities without friction torques (rad/s).
    lo, hi : ndarray (n,)
        Bounds (N m), ``lo <= 0 <= hi`` or ``lo == hi``; one of the two may be infinite.
    guess : ndarray (n,), optional
        Torques of a similar problem; those inside the bounds are taken to be so again.
    deficient : bool, optional
        What `is_deficient` says of K; it is asked if this is not given.

    References
    ----------
    Source (4.26)-(4.67), Figure 4.7, Table 4.1.
    """
    n = len(w)
    if deficient is None:
        deficient = is_deficient(K)
    if n == 1:
        T = np.clip(w / K[0], lo, hi)
        return BoxSolution(T, _rates(K, w, lo, hi, T), 0, True)
    if n == 2:
        T = _three_clamps(K, w, lo, hi, deficient)
        return BoxSolution(T, _rates(K, w, lo, hi, T), 0, True)
    return _Faces(K, w, lo, hi).solve(guess, deficient)


def _three_clamps(K: Array, w: Array, lo: Array, hi: Array, deficient: bool) -> Array:
    if deficient:
        T = _after(K, w, lo, hi, float(w[1] / (2.0 * K[1, 1])))
        if _what_is_left(K, w, lo, hi, T, _rounding(K, w, T)) == _SOLVED:
            return T
    product = float(K[0, 0] * K[1, 1])
    determinant = max(product - K[0, 1] * K[1, 0], NO_PIVOT * _EPSILON * product)
    return _after(K, w, lo, hi, float((K[0, 0] * w[1] - K[1, 0] * w[0]) / determinant))


def _after(K: Array, w: Array, lo: Array, hi: Array, second: float) -> Array:
    """Return the clamped torques that follow from the unclamped second one."""
    t2 = np.clip(second, lo[1], hi[1])
    T1 = np.clip((w[0] - K[0, 1] * t2) / K[0, 0], lo[0], hi[0])
    return np.array([T1, np.clip((w[1] - K[1, 0] * T1) / K[1, 1], lo[1], hi[1])])


def _rates(K: Array, w: Array, lo: Array, hi: Array, T: Array, size: Array | None = None) -> Array:
    """Return the velocities that T leaves, of the sign that the bounds allow, rounding taken off."""
    rates = w - K @ T
    rates = np.where(np.abs(rates) <= (_rounding(K, w, T) if size is None else size), 0.0, rates)
    return np.where(((hi > T) & (rates > 0)) | ((lo < T) & (rates < 0)), 0.0, rates)


def _rounding(K: Array, w: Array, T: Array) -> Array:
    """Return the size of a residual ``w - K T`` that is rounding."""
    return np.asarray(ROUNDING * _EPSILON * (np.abs(w) + np.abs(K) @ np.abs(T)) + SMALLEST)


_SOLVED, _INSIDE, _AT_BOUND = range(3)


def residual_rounding(K: Array, w: Array, T: Array, deficient: bool) -> Array:
    """Return the size of velocities ``w - K T`` (n,) that are rounding (rad/s)."""
    size = _rounding(K, w, T)
    return _level(K, size) if deficient else size


def _what_is_left(K: Array, w: Array, lo: Array, hi: Array, T: Array, size: Array) -> int:
    """Return whether residuals above `size` are left of no element, of elements inside only, or of some at a bound."""
    r = w - K @ T
    left = (lo < hi) & (((hi > T) & (r > size)) | ((lo < T) & (r < -size)))
    if not left.any():
        return _SOLVED
    return _AT_BOUND if np.any(left & ((lo >= T) | (hi <= T))) else _INSIDE


def _level(K: Array, size: Array) -> Array:
    """Return the size of the largest row, in the unit of each: dependent rows know each other's rounding only."""
    root = np.sqrt(np.diag(K))
    return np.asarray(np.max(size / root) * root)


class _Faces:
    """Descent over the faces of the box."""

    def __init__(self, K: Array, w: Array, lo: Array, hi: Array) -> None:
        self.K, self.w, self.lo, self.hi = K, w, lo, hi
        self.work = 0

    def solve(self, guess: Array | None, deficient: bool) -> BoxSolution:
        start = np.clip(np.zeros(len(self.w)), self.lo, self.hi)
        warm = guess is not None
        T = np.clip(guess, self.lo, self.hi) if guess is not None else start
        T, solved = self._descend(self.K, self.w, T, warm, _EPSILON**-0.5 if deficient else NO_PIVOT)
        if solved and (not deficient or self._is_unique(T)):
            return BoxSolution(T, _rates(self.K, self.w, self.lo, self.hi, T), self.work, True)
        T, size, solved = self._least_norm(T, warm, deficient)
        if not solved:  # from where that ended
            T, solved = self._descend(self.K, self.w, T, True)
            size = _rounding(self.K, self.w, T)
        if not solved:  # a residual that other rows cannot tell from rounding
            size = _level(self.K, size) * DEFICIENT / ROUNDING
            solved = _what_is_left(self.K, self.w, self.lo, self.hi, T, size) == _SOLVED
        return BoxSolution(T, _rates(self.K, self.w, self.lo, self.hi, T, size), self.work, solved)

    def _is_unique(self, T: Array) -> bool:
        """Tell whether the elements that may hold something hold independent motions, so that their torques are unique.

        The others have their torques already, such as open clutches. What is close to dependent counts as such. Those
        strictly inside their bounds are known to be independent, as T was solved for.
        """
        undecided = self.lo < self.hi
        if np.all((self.lo < T) & (self.hi > T) | ~undecided):
            return True
        return _solve_free(self.K, self.w, undecided, _EPSILON**-0.5) is not None

    def _least_norm(self, T: Array, warm: bool, deficient: bool) -> tuple[Array, Array, bool]:
        """Return the torques of least norm, residuals that are rounding, and whether all are."""
        K, w, lo, hi = self.K, self.w, self.lo, self.hi
        large, least = np.sqrt(_EPSILON), LEAST_SHIFT * _EPSILON
        middle = np.sqrt(large * least)
        added, before = np.zeros(len(T)), large
        shifts = (large, large, large, large, middle, middle, least, least, least, least)
        for k, rho in enumerate(shifts):
            added *= rho / before  # it is of the size of rho diag(K) T
            T, _ = self._descend(K + rho * np.diag(np.diag(K)), w + added, T, warm)
            size = _rounding(K, w, T)
            solved = _what_is_left(K, w, lo, hi, T, size) == _SOLVED
            if not solved and deficient and k >= STRICT_PASSES:
                size = _level(K, size) * (DEFICIENT / ROUNDING if k == len(shifts) - 1 else 1.0)
                solved = _what_is_left(K, w, lo, hi, T, size) == _SOLVED
            if solved:
                break
            added += w - K @ T
            warm, before = True, rho
        return T, size, solved

    def _descend(self, H: Array, c: Array, T: Array, warm: bool, no_pivot: float = NO_PIVOT) -> tuple[Array, bool]:
        """Return the minimum of f over the box, and whether it was reached within the allowed work."""
        start, refining = self.work, False
        while True:
            if not warm:
                T = self._sweep(H, c, T)
            free = (self.lo < T) & (self.hi > T)
            corner, whole = not free.any(), False
            while free.any() and not whole:
                self.work += 1
                target = self._minimum(H, c, T, free, refining or self.work - start > PATIENCE, no_pivot)
                if target is None:
                    return T, False
                T, free, whole = self._step(H, c, T, target, free)
            left = _what_is_left(H, c, self.lo, self.hi, T, _rounding(H, c, T))
            if left == _SOLVED:
                return T, True
            self.work += corner  # a sweep that ends in a corner counts as well
            if self.work - start >= factorisations(len(T)):
                return T, False
            refining = left == _INSIDE and not refining
            warm = refining

    def _sweep(self, H: Array, c: Array, T: Array) -> Array:
        T = T.copy()
        r = c - H @ T
        for i in range(len(T)):
            new = np.clip(_sum(T[i], r[i] / H[i, i]), self.lo[i], self.hi[i])
            r -= H[:, i] * (new - T[i])
            T[i] = new
        return T

    def _minimum(
        self, H: Array, c: Array, T: Array, free: NDArray[np.bool_], change_only: bool, no_pivot: float
    ) -> Array | None:
        """Return the minimum on a face, solved for as a whole or as the change from T; None if H is singular there."""
        d = _solve_free(H, c - H @ (T if change_only else np.where(free, 0.0, T)), free, no_pivot)
        if d is None:
            return None
        return np.where(free, _sum(T, d) if change_only else d, T)

    def _step(
        self, H: Array, c: Array, T: Array, target: Array, free: NDArray[np.bool_]
    ) -> tuple[Array, NDArray[np.bool_], bool]:
        """Return the torques after a step to the minimum on a face, those still free, and if it was reached."""
        d = target - T
        clamped = np.clip(target, self.lo, self.hi)
        if np.array_equal(clamped, target):
            return target, free, True
        beyond = clamped != target
        room = np.full(len(T), np.inf)
        room[beyond] = (clamped - T)[beyond] / d[beyond]
        first = int(np.argmin(room))
        short = np.clip(T + room[first] * d, self.lo, self.hi)
        short[first] = clamped[first]
        r = c - H @ T

        def lowered(candidate: Array) -> float:
            change = candidate - T
            return float(change @ (r - 0.5 * (H @ change)))

        best = clamped if lowered(clamped) > lowered(short) else short
        return best, free & (best > self.lo) & (best < self.hi), False


def _sum(T: Array, change: Array) -> Array:
    """Return ``T + change``, and zero where that is rounding."""
    total = T + change
    return np.where(np.abs(total) <= 4 * _EPSILON * np.abs(T), 0.0, total)


def _solve_free(H: Array, r: Array, free: NDArray[np.bool_], no_pivot: float = NO_PIVOT) -> Array | None:
    """Solve ``H d = r`` on the free elements, zero for the others; None if H is singular there."""
    A, y = H[np.ix_(free, free)], r[free]
    least = no_pivot * _EPSILON * np.diag(A)
    for j in range(len(A)):
        if not A[j, j] > least[j]:
            return None
        factors = A[j + 1 :, j] / A[j, j]
        A[j + 1 :, j + 1 :] -= np.outer(factors, A[j, j + 1 :])
        y[j + 1 :] -= factors * y[j]
    for j in reversed(range(len(A))):
        y[j] = (y[j] - A[j, j + 1 :] @ y[j + 1 :]) / A[j, j]
    d = np.zeros(len(r))
    d[free] = y
    return d

r"""Which rows of a constraint set are needed: removal of those that bind by less than a stated share of the limit.

A row says that a torque command some steps ahead keeps its limit, :math:`-s_i \le w_i + c_{i,k} \xi \le s_i`, with the
limit :math:`s_i`, the torque at rest :math:`w_i`, measured disturbance included, and the distance from rest
:math:`\xi`. A linear program finds by how much a row can be violated while the kept ones hold,

.. math:: \max\; w_i + c_{i,k} \xi - (1 + \varepsilon) s_i \quad\text{over the states that can occur.}

If that is not positive, the row may go. All of it is homogeneous in :math:`(w, \xi)`; so if the kept rows hold with
:math:`s / (1 + \varepsilon)`, all removed ones hold with s, and removal is safe: it costs the share
:math:`\varepsilon / (1 + \varepsilon)` of the torque limits, no more.

The states that can occur:

- no state alone asks a machine for more than `OCCURRING` times its limit, at any time ahead;
- at rest the torque keeps :math:`|w_i| \le (1 - \varepsilon_\infty) s_i`, which is seen to before (7.34);
- the limit is between the machine's torque at its largest speed (field weakening) and its largest torque; machines vary
  on their own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import highspy
import numpy as np
from numpy.typing import NDArray

__all__ = ["OCCURRING", "Needed", "RowFamily", "needed_rows"]

Array = NDArray[np.float64]

OCCURRING = 2.0
"""How many times its limit a state alone may ask a machine for."""

_TOLERANCE = 1e-9
"""What a linear program may leave of a violation, as a share of the limit."""

_SAMPLES = 7
"""How many rows between two kept ones are looked at before the farther one is kept; all are looked at in the end."""


@dataclass(frozen=True)
class RowFamily:
    """All rows of a horizon, as shares of the machines' largest limits.

    Attributes
    ----------
    rows : ndarray (m, K, n)
        ``c[i, k]`` for the steps k = 0 .. K - 1.
    least_limit : ndarray (m,)
        The least limit of each machine as a share of its largest.
    stationary_reserve : float
        eps_inf.
    """

    rows: Array
    least_limit: Array
    stationary_reserve: float

    @property
    def scale(self) -> Array:
        """What a state may be, (n,)."""
        largest = np.abs(self.rows).max(axis=(0, 1))
        return np.asarray(OCCURRING / np.where(largest > 0, largest, 1.0), dtype=np.float64)


@dataclass(frozen=True)
class Needed:
    """The rows that are needed.

    Attributes
    ----------
    steps : tuple of ndarray
        For each machine the steps k >= 0 whose rows are kept, in order; 0 is always among them.
    binding : ndarray (m, K)
        By how much each row that was removed can still be violated while the kept ones hold, as a share of the limit;
        a bound from above, at most the epsilon asked for, and negative if there is room left. Zero for kept rows.
    programs : int
        How many linear programs were solved.
    """

    steps: tuple[NDArray[np.int64], ...]
    binding: Array
    programs: int


def needed_rows(
    family: RowFamily, epsilon: float, progress: Callable[[float], None] | None = None, horizon: int | None = None
) -> Needed:
    """Return rows that are enough.

    Parameters
    ----------
    family : RowFamily
    epsilon : float
        Share of the limit by which a row may bind and yet be removed.
    progress : callable, optional
        Called now and then with the share of the work that is done.
    horizon : int, optional
        Keep no row behind this step; those behind are looked at all the same, and `binding` may exceed `epsilon` there.

    Notes
    -----
    Machine by machine, from the present on: the first row that binds by more than epsilon calls for another one, which
    is put as far ahead as those between allow. In the end all rows are looked at with all that are kept.
    """
    return _Selection(family, epsilon, progress, horizon).run()


class _Selection:
    """The linear program, and the rows kept so far."""

    def __init__(
        self, family: RowFamily, epsilon: float, progress: Callable[[float], None] | None, horizon: int | None
    ) -> None:
        self.rows = family.rows * family.scale
        self.m, self.K, self.n = self.rows.shape
        self.last = self.K - 1 if horizon is None else min(horizon, self.K - 1)
        self.epsilon = epsilon
        self.progress = progress
        self.programs = 0
        self.places: dict[tuple[int, int], int] = {}
        self.lp = _program(self.n, family)
        for machine in range(self.m):
            self.keep(machine, 0)

    def run(self) -> Needed:
        for machine in range(self.m):
            self._select(machine)
        binding = self._verify()
        steps = tuple(
            np.array(sorted(k for machine, k in self.places if machine == i), dtype=np.int64) for i in range(self.m)
        )
        return Needed(steps, binding, self.programs)

    def keep(self, machine: int, k: int) -> None:
        """Add a row, both signs."""
        self.places[machine, k] = self.lp.getNumRow()
        for sign, bound in ((1.0, self.n + machine), (-1.0, self.n + self.m + machine)):
            index = np.append(np.arange(self.n), bound).astype(np.int32)
            self.lp.addRow(-highspy.kHighsInf, 0.0, self.n + 1, index, np.append(sign * self.rows[machine, k], -1.0))

    def drop(self, machine: int, k: int) -> None:
        """Take back the row that was added last."""
        place = self.places.pop((machine, k))
        self.lp.deleteRows(2, np.array([place, place + 1], dtype=np.int32))

    def violation(self, machine: int, k: int) -> float:
        """Return by how much a row can be violated, less epsilon, as a share of the limit."""
        cost = np.zeros(self.n + 2 * self.m)
        cost[: self.n] = self.rows[machine, k]
        # w - (1 + epsilon) s with the room above s - w and below s + w as variables
        cost[self.n + machine] = -1.0 - self.epsilon / 2
        cost[self.n + self.m + machine] = -self.epsilon / 2
        self.lp.changeColsCost(len(cost), np.arange(len(cost), dtype=np.int32), cost)
        for anew in (False, True):
            if anew:  # numerical trouble from a basis of before
                self.lp.clearSolver()
            self.lp.run()
            self.programs += 1
            if self.lp.getModelStatus() == highspy.HighsModelStatus.kOptimal:
                return float(self.lp.getInfo().objective_function_value)
        return np.inf  # a row that cannot be judged is kept

    def _select(self, machine: int) -> None:
        k, kept, stride = 1, 0, 2
        while k <= self.last:
            room = self.violation(machine, k)
            self._tell(machine, k)
            if room <= _TOLERANCE:
                k += self._quiet(machine, k, room)
                continue
            farthest = self._farthest(machine, kept, k, stride)
            self.keep(machine, farthest)
            stride, kept, k = max(2, farthest - kept), farthest, farthest + 1

    def _farthest(self, machine: int, kept: int, first: int, stride: int) -> int:
        """Return how far ahead of the kept row the next one may be."""
        good, step = first, max(1, stride // 2)
        while step and good < self.last:
            candidate = min(good + step, self.last)
            self.keep(machine, candidate)
            fine = self._fine_between(machine, kept, candidate)
            self.drop(machine, candidate)
            if fine:
                good = candidate
            else:
                step //= 2
        return good

    def _fine_between(self, machine: int, first: int, last: int) -> bool:
        if last <= first + 1:
            return True
        middle = (first + last) / 2
        between = np.unique(np.linspace(first + 1, last - 1, _SAMPLES).astype(int))
        return all(
            self.violation(machine, int(k)) <= _TOLERANCE for k in sorted(between, key=lambda k: abs(k - middle))
        )

    def _quiet(self, machine: int, k: int, room: float) -> int:
        """Return how many steps on rows cannot have changed by more than what is left of the room."""
        end = min(self.K, k + 1 + 4096)
        change = np.abs(self.rows[machine, k + 1 : end] - self.rows[machine, k]).sum(axis=1)
        above = np.flatnonzero(room + change > _TOLERANCE)
        return 1 + (int(above[0]) if len(above) else len(change))

    def _verify(self) -> Array:
        binding = np.zeros((self.m, self.K))
        for machine in range(self.m):
            k = 1
            while k < self.K:
                if (machine, k) in self.places:
                    k += 1
                    continue
                room = self.violation(machine, k)
                self._tell(self.m + machine, k)
                if room > _TOLERANCE and k <= self.last:
                    self.keep(machine, k)
                    k += 1
                    continue
                count = self._quiet(machine, k, room) if room <= _TOLERANCE else 1
                change = np.abs(self.rows[machine, k : k + count] - self.rows[machine, k]).sum(axis=1)
                binding[machine, k : k + count] = room + change + self.epsilon
                k += count
        for machine, k in self.places:
            binding[machine, k] = 0.0
        return binding

    def _tell(self, part: int, k: int) -> None:
        if self.progress is not None:
            self.progress((part + k / self.K) / (2 * self.m))


def _program(n: int, family: RowFamily) -> highspy.Highs:
    """Return the program over the scaled distance from rest, and the room above and below the torque at rest."""
    lp = highspy.Highs()
    lp.setOptionValue("output_flag", False)
    lp.setOptionValue("threads", 1)
    lp.setOptionValue("presolve", "off")
    lp.setOptionValue("simplex_strategy", 4)  # primal: only costs change from one program to the next
    lp.setOptionValue("primal_feasibility_tolerance", 1e-10)
    lp.setOptionValue("dual_feasibility_tolerance", 1e-10)
    lp.changeObjectiveSense(highspy.ObjSense.kMaximize)
    m = len(family.least_limit)
    for _ in range(n):
        lp.addVar(-1.0, 1.0)
    for _ in range(2 * m):
        lp.addVar(0.0, 2.0)
    half = family.stationary_reserve / 2
    for machine, least in enumerate(family.least_limit):
        pair = np.array([n + machine, n + m + machine], dtype=np.int32)
        lp.addRow(2.0 * least, 2.0, 2, pair, np.array([1.0, 1.0]))
        for above, below in ((1.0 - half, -half), (-half, 1.0 - half)):
            lp.addRow(0.0, highspy.kHighsInf, 2, pair, np.array([above, below]))
    return lp

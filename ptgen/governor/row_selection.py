"""The selection of needed rows with HiGHS, as a program: rows on the standard input, progress and answer on the output.

See `ptgen.governor.row_removal`, which runs it. HiGHS is imported only when rows are selected: a process that has
loaded CasADi's solvers cannot load another version of it.
"""

from __future__ import annotations

import io
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.governor.row_removal import Needed, RowFamily

__all__ = ["main", "select_rows"]

Array = NDArray[np.float64]

_TOLERANCE = 1e-9
"""What a linear program may leave of a violation, as a share of the limit."""

_SAMPLES = 7
"""How many rows between two kept ones are looked at before the farther one is kept; all are looked at in the end."""

_TOLD = 0.002
"""Share of the work after which progress is told again."""


def select_rows(
    family: RowFamily, epsilon: float, horizon: int | None, progress: Callable[[float], None] | None
) -> Needed:
    """Return the rows that are needed; see `ptgen.governor.row_removal.needed_rows`."""
    return _Selection(family, epsilon, progress, horizon).run()


def main() -> None:
    """Read rows, select, and write what was found."""
    with np.load(io.BytesIO(sys.stdin.buffer.read())) as given:
        reserve, epsilon, last = (float(value) for value in given["numbers"])
        family = RowFamily(given["rows"], given["least_limit"], reserve)
    told = 0.0

    def tell(share: float) -> None:
        nonlocal told
        if share >= told + _TOLD:
            told = share
            sys.stdout.buffer.write(f"{share:.4f}\n".encode())
            sys.stdout.buffer.flush()

    found = select_rows(family, epsilon, None if last < 0 else int(last), tell)
    arrays: dict[str, Array | NDArray[np.int64]] = {f"steps_{i}": steps for i, steps in enumerate(found.steps)}
    stream = io.BytesIO()
    np.savez(stream, binding=found.binding, programs=np.array(found.programs), **arrays)  # type: ignore[arg-type]
    sys.stdout.buffer.write(b"answer\n" + stream.getvalue())


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
        import highspy

        self.unlimited: float = highspy.kHighsInf
        self.optimal = highspy.HighsModelStatus.kOptimal
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
            self.lp.addRow(-self.unlimited, 0.0, self.n + 1, index, np.append(sign * self.rows[machine, k], -1.0))

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
            if self.lp.getModelStatus() == self.optimal:
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


def _program(n: int, family: RowFamily) -> Any:
    """Return the program over the scaled distance from rest, and the room above and below the torque at rest."""
    import highspy

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


if __name__ == "__main__":
    main()

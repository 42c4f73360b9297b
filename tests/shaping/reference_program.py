"""The program of the optimal governor written down once more for HiGHS: maximise weight'h over the rows."""

from __future__ import annotations

from dataclasses import dataclass

import governor_problems
import numpy as np
import scipy.optimize

Array = np.ndarray

__all__ = ["ReferenceProgram", "Solution"]


@dataclass(frozen=True)
class Solution:
    """Share of each group, worth, and whether there is any."""

    h: Array
    worth: float
    feasible: bool


class ReferenceProgram:
    """One problem; unknowns are the shares h of the groups, found by plain comparison of references."""

    def __init__(self, sizes: governor_problems.Sizes, problem: governor_problems.Problems) -> None:
        self.problem, self.sizes = problem, sizes
        self.rows_x, self.rows_r = governor_problems.tables(sizes)
        self.groups: list[list[int]] = []
        for i in range(sizes.m):
            home = next((group for group in self.groups if any(self._tied(i, j) for j in group)), None)
            if home is None:
                self.groups.append([i])
            else:
                home.append(i)

    def _tied(self, i: int, j: int) -> bool:
        p, group = self.problem, self.sizes.group
        near = abs(p.wanted[i] - p.wanted[j]) < p.tie and abs(p.before[i] - p.before[j]) < p.tie
        return bool(group[i] == group[j] > 0 and near)

    def shaped(self, h: Array) -> Array:
        """Return the references for shares of the groups."""
        full = np.zeros(self.sizes.m)
        for share, group in zip(h, self.groups, strict=True):
            full[group] = share
        return self.problem.before + full * (self.problem.wanted - self.problem.before)

    def share(self, shaped: Array) -> Array:
        """Return the shares that shaped references stand for; 1 where nothing is to be changed."""
        change = self.problem.wanted - self.problem.before
        result = np.ones(len(self.groups))
        for k, group in enumerate(self.groups):
            i = max(group, key=lambda index: abs(change[index]))
            if change[i] != 0:
                result[k] = (shaped[i] - self.problem.before[i]) / change[i]
        return result

    def values(self, shaped: Array) -> list[Array]:
        """Return the rows of each machine, that of the present step first (N m)."""
        p = self.problem
        commands = p.free + p.gain @ (shaped - p.before)
        added = self.rows_x @ p.deviation + self.rows_r @ (shaped - p.wanted)
        parts = np.split(added[: sum(self.sizes.counts)], np.cumsum(self.sizes.counts)[:-1])
        return [command + np.append(0.0, part) for command, part in zip(commands, parts, strict=True)]

    def violation(self, shaped: Array) -> Array:
        """Return the largest violation of each machine (N m)."""
        p = self.problem
        limits = zip(self.values(shaped), p.least, p.most, strict=True)
        return np.array([max(np.max(v - high), np.max(low - v), 0.0) for v, low, high in limits])

    def worth(self, h: Array) -> float:
        """Return the objective."""
        return sum(share * self.problem.weight[group].sum() for share, group in zip(h, self.groups, strict=True))

    def solve(self, slack: Array) -> Solution:
        """Return what HiGHS finds with limits widened by `slack`."""
        count = len(self.groups)
        still = np.concatenate(self.values(self.shaped(np.zeros(count))))
        A = np.stack([np.concatenate(self.values(self.shaped(unit))) - still for unit in np.eye(count)], axis=1)
        machine = np.concatenate([np.full(n + 1, i) for i, n in enumerate(self.sizes.counts)])
        upper = (self.problem.most + slack)[machine] - still
        lower = (self.problem.least - slack)[machine] - still
        found = scipy.optimize.linprog(
            [-self.problem.weight[group].sum() for group in self.groups],
            np.concatenate([A, -A]),
            np.concatenate([upper, -lower]),
            bounds=[(0.0, 1.0)] * count,
            method="highs",
            options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10},
        )
        assert found.status in (0, 2), found.message
        if found.status == 2:
            return Solution(np.zeros(count), 0.0, feasible=False)
        return Solution(found.x, self.worth(found.x), feasible=True)

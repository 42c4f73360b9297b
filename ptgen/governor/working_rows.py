r"""Convex programs of few variables and many rows, solved with the few rows that matter, and proven for all of them.

At most as many rows bind as there are variables. So a program of a few rows is solved, the row of each machine that its
answer violates most is added, and so on until none is violated. What is left out never helped the answer, so
multipliers of the rows that were used prove its optimality for all rows, and its feasibility is checked on all rows.
Solvers whose work grows with the square of the number of rows then take part as well.

Soft rows have a slack of their owner: ``A z - s <= upper``, ``A z + s >= lower``, ``0 <= s <= s_most``, at a price.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import ControlError, Problem
from ptgen.governor.checks import Convex, excess, multipliers_at, optimality_gap, proves_infeasible
from ptgen.governor.conic_solver import ConicSolver

__all__ = ["Finding", "Softness", "WorkingRows"]

Array = NDArray[np.float64]

_CAPACITY = 16
"""Rows of the smallest program that is built; larger ones follow by doubling."""

_BINDS = 1e-9
"""Multipliers, and violations in shares of a limit, below this are taken for zero."""


@dataclass(frozen=True)
class Softness:
    """Slack variables, one for each owner of rows.

    Attributes
    ----------
    price : ndarray (m,)
        Cost of each.
    most : ndarray (m,)
        Upper bounds, finite.
    """

    price: Array
    most: Array


@dataclass(frozen=True)
class Finding:
    """What came out.

    Attributes
    ----------
    z : ndarray (n,)
    slack : ndarray (m,)
    violation : float
        Largest excess over rows and bounds.
    gap : float
        Bound of the cost above the optimum.
    proven : bool
        Whether violation and gap are within the tolerance.
    infeasible : bool
        Whether it is proven that no answer exists.
    binding : tuple of int
        Rows with a multiplier.
    message : str
        Why nothing is proven.
    """

    z: Array
    slack: Array
    violation: float
    gap: float
    proven: bool
    infeasible: bool
    binding: tuple[int, ...]
    message: str


class WorkingRows:
    """Solves programs of one shape with one solver.

    Parameters
    ----------
    solver : str
    variables, machines : int
        Machines own the rows; a row of owner -1 belongs to nobody, and is always taken.
    quadratic, soft : bool
    options : mapping, optional
        See `ConicSolver`.
    regularisation : float
        A multiple of the identity that is added to ``P`` for the solver; the checks are without it.
    tolerance : float
        Largest violation and gap of an answer that counts as proven.
    all_rows : bool
        Give the solver all rows at once.

    Raises
    ------
    ControlError
        If the solver is missing or cannot solve such programs, which is tried.
    """

    def __init__(
        self,
        solver: str,
        variables: int,
        machines: int,
        *,
        quadratic: bool,
        soft: bool,
        options: Mapping[str, Any] | None = None,
        regularisation: float = 0.0,
        tolerance: float = 1e-6,
        all_rows: bool = False,
    ) -> None:
        self._name, self._options = solver, options
        self._n, self._m, self._soft = variables, machines, soft
        self._size = variables + (machines if soft else 0)
        self._quadratic = quadratic or regularisation > 0
        self._regularisation = regularisation * np.eye(self._size)
        self._tolerance, self._all = tolerance, all_rows
        self._sized: dict[int, ConicSolver] = {}
        self._try_out()

    def solve(
        self, program: Convex, owner: NDArray[np.int64], start: Array, softness: Softness | None = None
    ) -> Finding:
        """Return the checked answer.

        Parameters
        ----------
        program : Convex
            Without slacks.
        owner : ndarray of int (N,)
        start : ndarray (n,)
            A point near which the answer is expected; the rows that it violates most are taken first.
        softness : Softness
            If rows are soft.
        """
        n = self._n
        z, slack = start, np.zeros(self._m)
        beyond = self._beyond(program, owner, z, slack)
        first = (owner < 0) | self._all
        first[np.argmax(beyond)] = True
        taken, message = np.flatnonzero(first), ""
        added = self._worst(beyond, owner, taken)
        while True:
            taken = np.concatenate([taken, added])
            small = self._part(program, owner, taken, softness)
            conic = self._solver(len(small.A))
            y, multipliers = conic.solve(self._given(small))
            if not np.isfinite(y).all():
                message = "gave no numbers"
                break
            outside = float(excess(y, small.lo, small.hi).max())
            y = np.clip(y, small.lo, small.hi)
            outside = max(outside, float(excess(small.A @ y, small.lower, small.upper).max()))
            z, slack = y[:n], y[n:] if self._soft else slack
            if outside > self._tolerance:
                message = f"violates what it was given by {outside:.2g}"
                break
            beyond = self._beyond(program, owner, z, slack)
            added = self._worst(beyond, owner, taken)
            if len(added) == 0:
                break
        if message:
            infeasible = softness is None and proves_infeasible(small)
            words = "" if infeasible else f"{self._name} {message} ({conic.last_words()})"
            return Finding(z, slack, np.inf, np.inf, False, infeasible, (), words)
        violation = max(0.0, outside, float(beyond.max()))
        gap = optimality_gap(small, y, multipliers)
        if not abs(gap) <= self._tolerance:  # perhaps only its multipliers are poor, or it gives none
            own = multipliers_at(small, y, self._tolerance)
            better = optimality_gap(small, y, own)
            if abs(better) < abs(gap):
                gap, multipliers = better, own
        proven = violation <= self._tolerance and abs(gap) <= self._tolerance
        if not proven:
            message = f"{self._name} is beyond limits by {violation:.2g} and above the optimum by {gap:.2g}"
            message += f" ({conic.last_words()})"
        rows = np.concatenate([taken, taken]) if self._soft else taken
        binding = tuple(int(row) for row in dict.fromkeys(rows[np.abs(multipliers) > _BINDS]))
        return Finding(z, slack, violation, gap, proven, False, binding, message)

    def _beyond(self, program: Convex, owner: NDArray[np.int64], z: Array, slack: Array) -> Array:
        """Return by how much each row is outside its limits, which give way by the slack of its owner."""
        beyond = excess(program.A @ z, program.lower, program.upper)
        return np.where(owner >= 0, beyond - slack[owner], beyond) if self._soft else beyond

    def _worst(self, beyond: Array, owner: NDArray[np.int64], taken: NDArray[np.int64]) -> NDArray[np.int64]:
        """Return the most violated row of each owner that is not taken yet."""
        left = np.flatnonzero(beyond > _BINDS)
        left = left[~np.isin(left, taken)]
        if len(left) == 0:
            return left
        order = left[np.argsort(-beyond[left], kind="stable")]
        _, first = np.unique(owner[order], return_index=True)
        return np.asarray(order[first], dtype=np.int64)

    def _part(
        self, program: Convex, owner: NDArray[np.int64], taken: NDArray[np.int64], softness: Softness | None
    ) -> Convex:
        """Return the program of some rows, with the slack variables behind the others."""
        A, lower, upper = program.A[taken], program.lower[taken], program.upper[taken]
        if softness is None:
            return Convex(program.P, program.q, A, lower, upper, program.lo, program.hi)
        n, size, count = self._n, self._size, len(taken)
        P = np.zeros((size, size))
        P[:n, :n] = program.P
        chosen = np.where(owner[taken, None] == np.arange(self._m), 1.0, 0.0)
        endless = np.full(count, np.inf)
        return Convex(
            P,
            np.concatenate([program.q, softness.price]),
            np.block([[A, -chosen], [A, chosen]]),
            np.concatenate([-endless, lower]),
            np.concatenate([upper, endless]),
            np.concatenate([program.lo, np.zeros(self._m)]),
            np.concatenate([program.hi, softness.most]),
        )

    def _given(self, program: Convex) -> Convex:
        """Return the program with what is added to make it easier to solve."""
        if not self._regularisation.any():
            return program
        P, q = program.P + self._regularisation, program.q
        # Around the upper bounds, where nothing is shaped; unbounded variables are zero there.
        goal = np.where(np.isfinite(program.hi), program.hi, 0.0)
        if self._soft:
            goal[self._n :] = 0.0
        return Convex(
            P, q - self._regularisation @ goal, program.A, program.lower, program.upper, program.lo, program.hi
        )

    def _solver(self, rows: int) -> ConicSolver:
        capacity = _CAPACITY
        while capacity < rows:
            capacity *= 2
        if capacity not in self._sized:
            self._sized[capacity] = ConicSolver(self._name, self._size, capacity, self._quadratic, self._options)
        return self._sized[capacity]

    def _try_out(self) -> None:
        """Solve programs with known answers."""
        n = self._size
        ones = np.ones(n)
        for share in (0.3, 0.75):
            q = -np.linspace(0.5, 1.0, n)
            P = np.zeros((n, n))
            if self._quadratic and not self._regularisation.any():  # slacks have a price, and no curvature
                P[: self._n, : self._n] = np.diag(-q[: self._n])
            rows = np.vstack([ones / n, np.linspace(1.0, -1.0, n)])
            known = Convex(P, q, rows, np.array([-1.0, -0.5]), np.array([share, 0.5]), 0 * ones, ones)
            z, multipliers = self._solver(2).solve(self._given(known))
            if np.isfinite(z).all():
                outside = max(
                    float(excess(rows @ z, known.lower, known.upper).max()), float(excess(z, 0 * z, ones).max())
                )
                gaps = [optimality_gap(known, z, found) for found in (multipliers, multipliers_at(known, z, 1e-6))]
                if outside < 1e-6 and min(abs(gap) for gap in gaps) < max(
                    1e-6, self._regularisation.max(initial=0.0) * n
                ):
                    continue
            kind = "quadratic" if self._quadratic else "linear"
            remedy = "take another one"
            if not self._quadratic:
                remedy = "take highs, or a regularisation such as 1e-6, or the quadratic governor"
            raise ControlError(
                Problem(
                    "solver",
                    f'"{self._name}" fails on a {kind} program with a known answer ({self._solver(2).last_words()})',
                    remedy,
                )
            )

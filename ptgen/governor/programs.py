r"""The governors as programs: scalar (7.12), vector as linear (7.36) and quadratic program (7.15), command (7.14).

All of them keep the predicted torques of `ptgen.governor.limit_rows` within their limits and bring the shaped
references ``r~`` as near to the wanted ones ``r`` as that allows, each in its own sense:

=====================  =================================  =========================================
scalar (7.12)          ``r~ = before + h (r - before)``   max ``h``, ``0 <= h <= 1``
vector, linear (7.36)  ``r~ = before + H (r - before)``   max ``sum_i weight_i h_i``, ``0 <= h_i <= 1``
vector, quadratic      the same (7.15)                    min ``(r - r~)' Q (r - r~)``
command (7.14)         ``r~`` anything                    min ``(r - r~)' Q (r - r~)``
=====================  =================================  =========================================

Standing still is always allowed. When it violates a limit, and nothing keeps the limits, there are two ways out:
*widened* limits, each by as much as standing still violates it, and then the program as before; or *penalised* slack
variables, as in the source: ``cost + sum_i penalty s_i / width_i`` with limits that give way by ``s_i``. Penalised
slack is found in one program; it may be used although the limits could be kept, when that is worth its price.

Two references of a group that are within `tie` of each other, wanted and before, are tied: they share their ``h``; the
command governor, which has none, keeps their difference between what it was and what is wanted.

Rows are scaled by half the width of their machine's limits, costs by that of standing still (command governor: by that
of the nearest point of the most violated row), so tolerances are shares of these. Every answer is checked, see
`ptgen.governor.checks`; one that is not proven is never passed on.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from itertools import pairwise
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import ControlError, Problem
from ptgen.governor.checks import Convex, excess
from ptgen.governor.limit_rows import LimitRows, Situation
from ptgen.governor.working_rows import Finding, Softness, WorkingRows
from ptgen.shaping.optimal import LIMITED, NOT_SOLVED, NOTHING_BINDS, SLACK
from ptgen.shaping.ties import leaders

__all__ = [
    "Answer",
    "CommandGovernor",
    "Governor",
    "QuadraticGovernor",
    "ScalarGovernor",
    "Status",
    "VectorGovernor",
    "tied",
]

Array = NDArray[np.float64]

_EXACT = 1e-12
"""What rounding makes of zero, in shares of a limit or of a way."""

_USED = 1e-9
"""Slack below this share of a limit is none."""


class Status(IntEnum):
    """What became of the references; the numbers are those of the emitted governor."""

    FREE = int(NOTHING_BINDS)
    """Nothing binds: they are the wanted ones."""
    LIMITED = int(LIMITED)
    """They are shaped, and the limits are kept."""
    SLACK = int(SLACK)
    """The limits cannot be kept, and give way."""
    UNSOLVED = int(NOT_SOLVED)
    """The solver gave no answer that could be proven; the references stay as they were."""


@dataclass(frozen=True)
class Answer:
    """What a governor makes of one situation.

    Attributes
    ----------
    h : ndarray (m,)
        Share of the way from the references of the last step to the wanted ones, 1 where there is none. In [0, 1],
        except for the command governor.
    references : ndarray (m,)
        Shaped references (N m, rad/s).
    slack : ndarray (m,)
        By how much the limits of each machine give way (N m).
    status : Status
    violation : float
        Largest violation of a row or bound, with slack, as share of the limit.
    gap : float
        Proven bound of the cost above the optimum, as share of what costs are scaled by.
    solver : str
        Who found it; empty if nobody had to be asked.
    binding : tuple of (int, int)
        Machine and step of each row that holds the references back.
    message : str
        Why it is not solved.
    """

    h: Array
    references: Array
    slack: Array
    status: Status
    violation: float
    gap: float
    solver: str
    binding: tuple[tuple[int, int], ...] = ()
    message: str = ""

    def accepted(self) -> Answer:
        """Return the answer itself if it is proven.

        Raises
        ------
        ControlError
            If it is not.
        """
        if self.status is Status.UNSOLVED:
            raise ControlError(
                Problem(
                    "governor",
                    f"no answer could be proven: {self.message}",
                    "take another solver or a larger tolerance",
                )
            )
        return self


@dataclass(frozen=True)
class _Ways:
    """How the references depend on the variables, ``r~ = origin + T z``, and what the variables cost."""

    origin: Array
    T: Array
    P: Array
    q: Array
    lo: Array
    hi: Array
    wanted: Array  # the variables of the wanted references
    still: float  # cost of standing still above that of the wanted references
    pairs: tuple[tuple[int, int], ...] = ()  # differences of references that stay in between


@dataclass(frozen=True)
class _Scaled:
    """Rows in one situation, in shares of half the width of their machine's limits."""

    width: Array  # (m,) N m
    at_before: Array
    slope: Array
    lower: Array
    upper: Array

    @classmethod
    def of(cls, rows: LimitRows, now: Situation) -> _Scaled:
        width = 0.5 * (now.most - now.least)
        # Limits that leave nothing, or contradict each other, are no measure.
        width = np.where(width > 0, width, np.maximum(1.0, np.maximum(np.abs(now.most), np.abs(now.least))))
        at_before, slope = rows.at_before(now)
        machine = rows.machine
        scale = width[machine]
        lower, upper = (now.least / width)[machine], (now.most / width)[machine]
        return cls(width, at_before / scale, slope / scale[:, None], lower, upper)


def tied(now: Situation, group: Sequence[int], tie: float) -> list[list[int]]:
    """Return the references that move together, as lists of two and more; see `ptgen.shaping.ties`.

    Parameters
    ----------
    now : Situation
    group : sequence of int (m,)
        References with the same positive number may be tied.
    tie : float
        They are when they differ by less than this (in their unit), wanted and before.
    """
    together: dict[int, list[int]] = {}
    for i, leader in enumerate(leaders(now.wanted, now.before, tie, np.asarray(group, dtype=np.float64))):
        together.setdefault(leader, []).append(i)
    return [some for some in together.values() if len(some) > 1]


class Governor(ABC):
    """A governor, built once and asked in every step.

    Parameters
    ----------
    rows : LimitRows
        Reduced or not.
    weight : sequence of float (m,), optional
        Positive weights of the references, one each by default; see the table above.
    cost : ndarray (m, m), optional
        ``Q`` of the quadratic programs, symmetric, positive definite; the diagonal of the weights by default. It
        compares N m with rad/s, so it deserves thought.
    group : sequence of int (m,), optional
        References with the same positive number may be tied; none by default.
    tie : float
        In the unit of the references (rad/s).
    slack : {"widened", "penalised"}
    penalty : float
        Of a slack of half the width of a machine's limits, in units of the cost of standing still.
    solver : str
        Any conic solver that CasADi has, see `ptgen.governor.conic_solver.present_solvers`.
    options : mapping, optional
        Of CasADi's interface of that solver.
    regularisation : float
        Makes linear programs quadratic, for solvers that need it. Answers are proven without it.
    tolerance : float
        Largest violation and gap of an answer that counts as proven.
    all_rows : bool
        Give the solver all rows at once, instead of those that matter.

    Raises
    ------
    ControlError
        If the solver is not there or cannot solve such programs, or values are not sensible.
    """

    quadratic: ClassVar[bool]
    bounded: ClassVar[bool] = True
    """Whether references stay between those of the last step and the wanted ones."""

    def __init__(
        self,
        rows: LimitRows,
        *,
        weight: Sequence[float] | None = None,
        cost: Array | None = None,
        group: Sequence[int] | None = None,
        tie: float = 0.0,
        slack: Literal["widened", "penalised"] = "widened",
        penalty: float = 1e4,
        solver: str = "highs",
        options: Mapping[str, Any] | None = None,
        regularisation: float = 0.0,
        tolerance: float = 1e-6,
        all_rows: bool = False,
    ) -> None:
        m = rows.machines
        self.rows, self.solver = rows, solver
        self.weight = np.ones(m) if weight is None else np.asarray(weight, dtype=np.float64)
        self.cost = np.diag(self.weight) if cost is None else np.asarray(cost, dtype=np.float64)
        self.group = tuple(group) if group is not None else (0,) * m
        self.tie, self.soft, self.penalty = tie, slack == "penalised", penalty
        self._tolerance = tolerance
        _check_values(self, slack, regularisation, tolerance)
        self._selection = WorkingRows(
            solver,
            self._variables(),
            m,
            quadratic=self.quadratic,
            soft=self.soft,
            options=options,
            regularisation=regularisation,
            tolerance=tolerance,
            all_rows=all_rows,
        )

    def solve(self, now: Situation) -> Answer:
        """Return the shaped references, checked."""
        values = (now.wanted, now.before, now.free, now.gain, now.least, now.most, now.deviation)
        if not all(np.isfinite(value).all() for value in values):
            return self._unsolved(now, "what the governor is given is not finite")
        rows = _Scaled.of(self.rows, now)
        machine = self.rows.machine
        sigma = np.zeros(self.rows.machines)
        np.maximum.at(sigma, machine, excess(rows.at_before, rows.lower, rows.upper))
        move = now.wanted - now.before
        at_wanted = rows.at_before + rows.slope @ move
        beyond = excess(at_wanted, rows.lower, rows.upper)
        if beyond.max() <= _EXACT:
            return self._free(now, Status.FREE, 0 * sigma, beyond)

        ways = self._ways(now, move, rows.slope, beyond)
        offset = rows.at_before + rows.slope @ (ways.origin - now.before)
        lower, upper = rows.lower - offset, rows.upper - offset
        program = Convex(ways.P, ways.q, rows.slope @ ways.T, lower, upper, ways.lo, ways.hi)
        program, owner = self._with_pairs(program, ways, now)
        if self.soft:
            # More slack than standing still costs altogether cannot pay.
            price = np.full(len(sigma), self.penalty)
            softness = Softness(price, np.full(len(sigma), (ways.still + price @ sigma) / self.penalty))
            found = self._selection.solve(program, owner, ways.wanted, softness)
            used = np.where(found.slack > _USED, found.slack, 0.0)
            return self._answer(now, ways, found, Status.SLACK if used.any() else Status.LIMITED, rows, used)
        found = self._selection.solve(program, owner, ways.wanted)
        if not found.infeasible or sigma.max() <= 0:
            return self._answer(now, ways, found, Status.LIMITED, rows, 0 * sigma)
        give = sigma[machine]
        beyond = excess(at_wanted, rows.lower - give, rows.upper + give)
        if beyond.max() <= _EXACT:
            return self._free(now, Status.SLACK, sigma * rows.width, beyond)
        give = np.concatenate([give, np.zeros(len(owner) - len(give))])
        wider = replace(program, lower=program.lower - give, upper=program.upper + give)
        found = self._selection.solve(wider, owner, ways.wanted)
        return self._answer(now, ways, found, Status.SLACK, rows, sigma)

    @abstractmethod
    def _variables(self) -> int:
        """Return how many variables there are."""

    @abstractmethod
    def _ways(self, now: Situation, move: Array, slope: Array, beyond: Array) -> _Ways:
        """Return variables and cost, given the way to the wanted references and what is violated there."""

    def _with_pairs(self, program: Convex, ways: _Ways, now: Situation) -> tuple[Convex, NDArray[np.int64]]:
        """Return the program with rows for pairs of references, and the owners of its rows."""
        if not ways.pairs:
            return program, self.rows.machine
        first, second = np.array(ways.pairs).T
        before, wanted = (r[first] - r[second] for r in (now.before, now.wanted))
        offset = ways.origin[first] - ways.origin[second]
        rows = ways.T[first] - ways.T[second]
        size = np.maximum(np.abs(rows).max(axis=1), np.finfo(np.float64).tiny)
        more = Convex(
            program.P,
            program.q,
            np.vstack([program.A, rows / size[:, None]]),
            np.concatenate([program.lower, (np.minimum(before, wanted) - offset) / size]),
            np.concatenate([program.upper, (np.maximum(before, wanted) - offset) / size]),
            program.lo,
            program.hi,
        )
        return more, np.concatenate([self.rows.machine, np.full(len(first), -1)])

    def _answer(
        self, now: Situation, ways: _Ways, found: Finding, status: Status, rows: _Scaled, give: Array
    ) -> Answer:
        """Return the answer for what was found, with limits that give way by shares `give` of their width."""
        if not found.proven:
            return self._unsolved(now, found.message or "nothing keeps the widened limits", found.violation, found.gap)
        references = ways.origin + ways.T @ found.z
        h = self._shares(now, ways, found.z, references)
        if self.bounded:
            arrived = h >= 1.0 - _EXACT
            h, references = np.where(arrived, 1.0, np.maximum(h, 0.0)), np.where(arrived, now.wanted, references)
        # Once more on all rows, for what is returned.
        machine = self.rows.machine
        torques = rows.at_before + rows.slope @ (references - now.before)
        left = float((excess(torques, rows.lower, rows.upper) - give[machine]).max())
        violation = max(found.violation, left)
        if not violation <= self._tolerance:
            return self._unsolved(now, f"limits are violated by {left:.2g}", violation, found.gap)
        binding = tuple((int(machine[j]), int(self.rows.step[j])) for j in found.binding if j < len(machine))
        return Answer(h, references, give * rows.width, status, violation, found.gap, self.solver, binding)

    def _shares(self, now: Situation, ways: _Ways, z: Array, references: Array) -> Array:
        """Return the shares ``h`` of variables."""
        del ways, z
        move = now.wanted - now.before
        moves = move != 0
        return np.where(moves, (references - now.before) / np.where(moves, move, 1.0), 1.0)

    def _free(self, now: Situation, status: Status, slack: Array, beyond: Array) -> Answer:
        h = np.ones(len(now.wanted))
        return Answer(h, now.wanted.copy(), slack, status, max(0.0, float(beyond.max())), 0.0, "")

    def _unsolved(self, now: Situation, message: str, violation: float = np.inf, gap: float = np.inf) -> Answer:
        h = np.zeros(len(now.wanted))
        slack = np.zeros(len(h))
        return Answer(h, now.before.copy(), slack, Status.UNSOLVED, violation, gap, self.solver, (), message)


class ScalarGovernor(Governor):
    """One share for all references (7.12), (7.13); weights and ties change nothing.

    Its answer is that of the row that is reached first on the way.
    """

    quadratic = False

    def _variables(self) -> int:
        return 1

    def _ways(self, now: Situation, move: Array, slope: Array, beyond: Array) -> _Ways:
        one = np.ones(1)
        return _Ways(now.before, move[:, None], np.zeros((1, 1)), -one, 0 * one, one, one, 1.0)

    def _shares(self, now: Situation, ways: _Ways, z: Array, references: Array) -> Array:
        return np.repeat(z, len(now.wanted))


class VectorGovernor(Governor):
    """One share for each reference, and a linear cost (7.35), (7.36)."""

    quadratic = False

    def _variables(self) -> int:
        return self.rows.machines

    def _ways(self, now: Situation, move: Array, slope: Array, beyond: Array) -> _Ways:
        T, weight, hi, still = self._merged(now, move)
        return _Ways(now.before, T, np.zeros_like(T), -weight / weight.sum(), 0 * hi, hi, hi, still)

    def _merged(self, now: Situation, move: Array) -> tuple[Array, Array, Array, float]:
        """Return directions, weights and upper bounds of the shares; tied references hang on the first of them."""
        T, weight, hi = np.diag(move), self.weight.copy(), np.ones(len(move))
        for first, *others in tied(now, self.group, self.tie):
            T[others, first], T[others, others] = move[others], 0.0
            weight[first] += weight[others].sum()
            weight[others] = hi[others] = 0.0
        return T, weight, hi, 1.0

    def _shares(self, now: Situation, ways: _Ways, z: Array, references: Array) -> Array:
        h = np.where(ways.hi > 0, z / np.where(ways.hi > 0, ways.hi, 1.0), 0.0)
        for first, *others in tied(now, self.group, self.tie):
            h[others] = h[first]
        return h


class QuadraticGovernor(VectorGovernor):
    """One share for each reference, and a quadratic cost (7.15)."""

    quadratic = True

    def _ways(self, now: Situation, move: Array, slope: Array, beyond: Array) -> _Ways:
        T, _, hi, _ = self._merged(now, move)
        whole = float(move @ self.cost @ move)
        if whole <= 0:  # nothing is to be moved
            return _Ways(now.before, T, np.eye(len(hi)), -hi, 0 * hi, hi, hi, 1.0)
        P, q = 2 * T.T @ self.cost @ T / whole, -2 * T.T @ self.cost @ move / whole
        idle = ~T.any(axis=0)  # shares that move nothing go where they may
        P[idle, idle], q[idle] = 2.0, -2.0 * hi[idle]
        # Variables are the shares, each times the root of what it costs: ways of very different cost trouble solvers.
        unit = np.sqrt(2.0 / np.diag(P))
        hi = hi / unit
        return _Ways(now.before, T * unit, P * np.outer(unit, unit), q * unit, 0 * hi, hi, hi, 1.0)


class CommandGovernor(Governor):
    """The nearest references that keep the limits (7.14), on the way to the wanted ones or not."""

    quadratic = True
    bounded = False

    def _variables(self) -> int:
        return self.rows.machines

    def _ways(self, now: Situation, move: Array, slope: Array, beyond: Array) -> _Ways:
        # The most violated row, in the metric of the cost, is as far away as the references have to go at least.
        metric = np.linalg.cholesky(np.linalg.inv(self.cost))
        reach = np.linalg.norm(slope @ metric, axis=1)
        over = (beyond > _EXACT) & (reach > 0)
        far = float((beyond[over] / reach[over]).max()) if over.any() else 1.0
        T = metric * far
        zero = np.zeros(len(move))
        endless = np.full(len(move), np.inf)
        pairs = tuple(pair for some in tied(now, self.group, self.tie) for pair in pairwise(some))
        still = float(move @ self.cost @ move) / far**2
        return _Ways(now.wanted, T, 2 * np.eye(len(move)), zero, -endless, endless, zero, still, pairs)


def _check_values(governor: Governor, slack: str, regularisation: float, tolerance: float) -> None:
    """Raise all problems with what a governor is given."""
    m, found = governor.rows.machines, []
    if governor.weight.shape != (m,) or not (governor.weight > 0).all():
        found.append(Problem("weight", f"wanted are {m} positive numbers, got {governor.weight}", "give one for each"))
    cost = governor.cost
    definite = cost.shape == (m, m) and np.array_equal(cost, cost.T) and (np.linalg.eigvalsh(cost) > 0).all()
    if not definite:
        found.append(Problem("cost", f"is no symmetric, positive definite matrix ({m}, {m})", "a diagonal one will do"))
    if len(governor.group) != m:
        found.append(
            Problem("group", f"wanted are {m} numbers, got {len(governor.group)}", "0 ties a reference to none")
        )
    if slack not in ("widened", "penalised"):
        found.append(Problem("slack", f'"{slack}" is unknown', 'take "widened" or "penalised"'))
    for name, value, least in (
        ("tie", governor.tie, 0.0),
        ("penalty", governor.penalty, np.nextafter(0.0, 1.0)),
        ("regularisation", regularisation, 0.0),
        ("tolerance", tolerance, np.finfo(np.float64).eps),
    ):
        if not least <= value < np.inf:
            found.append(Problem(name, f"must be at least {least:.3g} and finite, got {value}", "correct it"))
    if found:
        raise ControlError(found)

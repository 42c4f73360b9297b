"""A check of the optimal governor against another solver that is given every row of the horizon (7.36)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy.optimize
from numpy.typing import NDArray

from ptgen.errors import Problem, RunError, nearest
from ptgen.governor.constraint_set import ConstraintSet
from ptgen.shaping.optimal import LIMITED, optimal_governor
from ptgen.shaping.ties import leaders
from ptgen.testbed.governor_settings import GovernorSettings

__all__ = ["SOLVERS", "SolverCheck", "SolverName", "check_solver"]

SolverName = Literal["highs", "highs-ds", "highs-ipm"]

SOLVERS: tuple[SolverName, ...] = ("highs", "highs-ds", "highs-ipm")
"""Solvers of linear programs that can be compared with."""

Array = NDArray[np.float64]

_SITUATIONS = 60
_HELD = 80
"""Steps for which random references stay the same."""

_STRIDE = 7
"""Of the steps in which the governor holds back something, every so many are compared."""

_MOST_STEPS = 20_000


@dataclass(frozen=True)
class SolverCheck:
    """What came out of a comparison.

    Attributes
    ----------
    solver : str
    situations : int
        In which the governor held something back, and both were compared.
    rows : int
        Rows that it was given.
    loss : float
        Most by which the emitted solver lets less through, as a share of the sum of the weights: the price of the rows
        that were left out. Negative if it let through more.
    violation : float
        Most by which its references violate a row of the whole horizon, as a share of the limit; not positive if none.
    unsolved : int
        Situations for which that solver found nothing.
    """

    solver: str
    situations: int
    rows: int
    loss: float
    violation: float
    unsolved: int


def check_solver(
    constraints: ConstraintSet,
    settings: GovernorSettings,
    solver: str,
    progress: Callable[[float], None] = lambda _: None,
    situations: int = _SITUATIONS,
) -> SolverCheck:
    """Run the predicted loop with random references, and compare where the governor holds something back.

    Parameters
    ----------
    constraints : ConstraintSet
    settings : GovernorSettings
    solver : str
        One of `SOLVERS`.
    progress : callable, optional
        Told the share of the work that is done.
    situations : int
        How many to compare.

    Raises
    ------
    RunError
        If there is no such solver.
    """
    named = next((name for name in SOLVERS if name == solver), None)
    if named is None:
        raise RunError(
            Problem(
                "--solver", f'"{solver}" is unknown', f"{nearest(solver, SOLVERS)} (known are {', '.join(SOLVERS)})"
            )
        )
    loop, m = constraints.prediction, len(constraints.steps)
    speeds = np.array([not torque for torque in loop.torque_references])
    weight = np.where(speeds, settings.speed_weight, settings.torque_weight)
    group = speeds.astype(np.float64)
    rows = _rows_of(constraints.full())
    limits = (1 - settings.reserve) * np.array([limit.largest for limit in constraints.limits])
    tight = limits / (1 + constraints.removal)
    rows_x, rows_r, numbers = constraints.rows_x(), constraints.rows_r(), (*constraints.counts, settings.iterations)
    random, spread = np.random.default_rng(1), _spread(constraints, settings, speeds)
    x, before, wanted = np.zeros(len(loop.A)), np.zeros(m), np.zeros(m)
    compared = seen = unsolved = 0
    loss = violation = -np.inf
    for step in range(_MOST_STEPS):
        if step % _HELD == 0:
            wanted = spread * random.uniform(-1, 1, m)
            if speeds.any() and random.uniform() < 0.5:  # all speeds alike
                wanted[speeds] = wanted[speeds][0]
        free, away = loop.C @ x + loop.D @ before, x - loop.steady @ wanted
        shaped, _, _, status = optimal_governor(
            np.ones(()), wanted, before, free, loop.D, -tight, tight, away, rows_x, rows_r, weight,
            np.array(settings.tie), group, before, *numbers,
        )  # fmt: skip
        if status == LIMITED:
            seen += 1
            if seen % _STRIDE == 0:
                command = free + loop.D @ (wanted - before)
                values = command[rows.machine] + rows.x @ away  # with the wanted references
                slope = (loop.D[rows.machine] + rows.r) * (wanted - before)
                leader = leaders(wanted, before, settings.tie, group)
                best = _best(named, values, slope, limits[rows.machine], weight, leader)
                h = _shares(shaped, before, wanted)
                reached = np.abs(values - slope @ (1 - h)) / limits[rows.machine]
                violation = max(violation, float(reached.max() - 1))
                if best is None:
                    unsolved += 1
                else:
                    loss = max(loss, float(weight @ (best - h) / weight.sum()))
                compared += 1
                progress(compared / situations)
        if compared >= situations:
            break
        x, before = loop.A @ x + loop.B @ shaped, shaped
    return SolverCheck(named, compared, len(rows.machine), loss, violation, unsolved)


def _spread(constraints: ConstraintSet, settings: GovernorSettings, speeds: NDArray[np.bool_]) -> Array:
    """Return how far random references go: torques as far as they are let through at rest, speeds by much more."""
    loop = constraints.prediction
    share = (1 - settings.reserve) * (1 - settings.stationary_reserve)
    allowed = share * np.array([limit.largest for limit in constraints.limits])
    factors = np.abs(loop.stationary)
    with np.errstate(divide="ignore"):
        torques = np.where(factors > 0, allowed[:, None] / factors, np.inf).min(axis=0)
    steps = np.abs(np.diag(loop.D))
    return np.where(speeds, 5 * allowed / np.where(steps > 0, steps, 1.0), np.where(np.isfinite(torques), torques, 0.0))


def _shares(shaped: Array, before: Array, wanted: Array) -> Array:
    move = wanted - before
    return np.where(move != 0, (shaped - before) / np.where(move != 0, move, 1.0), 1.0)


@dataclass(frozen=True)
class _Rows:
    """Rows of a set, those of the present step first: machine (N,), coefficients (N, n) and (N, m)."""

    machine: NDArray[np.int64]
    x: Array
    r: Array


def _rows_of(constraints: ConstraintSet) -> _Rows:
    m, (n, _) = len(constraints.steps), constraints.prediction.B.shape
    machine = np.concatenate([np.arange(m), np.repeat(np.arange(m), constraints.counts)])
    rows_x = np.vstack([np.zeros((m, n)), constraints.rows_x()])
    return _Rows(machine, rows_x, np.vstack([np.zeros((m, m)), constraints.rows_r()]))


def _best(
    solver: SolverName, values: Array, slope: Array, limits: Array, weight: Array, leader: Sequence[int]
) -> Array | None:
    """Return the best shares (m,) of the way to the wanted references; None without a solution."""
    together = np.zeros((len(leader), len(leader)))
    together[np.arange(len(leader)), leader] = 1.0
    at_before = values - slope.sum(axis=1)
    steep = slope @ together / limits[:, None]
    room = np.concatenate([1 - at_before / limits, 1 + at_before / limits])
    found = scipy.optimize.linprog(
        -(weight @ together), np.vstack([steep, -steep]), room, bounds=(0.0, 1.0), method=solver
    )
    return None if found.x is None else np.asarray(together @ found.x)

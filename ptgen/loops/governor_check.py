"""A check of the optimal governor against another solver that is given every row of the horizon (7.36)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.governor.constraint_set import ConstraintSet
from ptgen.governor.limit_rows import LimitRows, Situation
from ptgen.governor.programs import Status, VectorGovernor
from ptgen.shaping.optimal import LIMITED, optimal_governor
from ptgen.testbed.governor_settings import GovernorSettings

__all__ = ["SolverCheck", "check_solver"]

Array = NDArray[np.float64]

_SITUATIONS = 60
_HELD = 80
"""Steps for which random references stay the same."""

_STRIDE = 7
"""Of the steps in which the governor holds back something, every so many are compared."""

_MOST_STEPS = 20_000

_TOLERANCE = 1e-6
"""What a proven answer may violate or miss, as a share."""


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
        Situations for which that solver found nothing that could be proven.
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
        Any conic solver that CasADi has, see `ptgen.governor.conic_solver.present_solvers`.
    progress : callable, optional
        Told the share of the work that is done.
    situations : int
        How many to compare.

    Raises
    ------
    ControlError
        If there is no such solver, or it refuses linear programs.
    """
    loop, m = constraints.prediction, len(constraints.steps)
    speeds = np.array([not torque for torque in loop.torque_references])
    weight = np.where(speeds, settings.speed_weight, settings.torque_weight)
    group = speeds.astype(np.float64)
    rows = LimitRows.predicted(constraints.full())
    whole = VectorGovernor(
        rows,
        weight=weight.tolist(),
        group=speeds.astype(int).tolist(),
        tie=settings.tie,
        solver=solver,
        tolerance=_TOLERANCE,
    )
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
                now = Situation(wanted, before, free, loop.D, -limits, limits, away)
                at_before, slope = rows.at_before(now)
                torques = at_before + slope @ (shaped - before)
                violation = max(violation, float((np.abs(torques) / limits[rows.machine]).max() - 1))
                best = whole.solve(now)
                if best.status is Status.UNSOLVED:
                    unsolved += 1
                else:
                    loss = max(loss, float(weight @ (best.h - _shares(shaped, before, wanted)) / weight.sum()))
                compared += 1
                progress(compared / situations)
        if compared >= situations:
            break
        x, before = loop.A @ x + loop.B @ shaped, shaped
    return SolverCheck(solver, compared, len(rows.machine), loss, violation, unsolved)


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

r"""The limits that a reference governor keeps over its horizon (7.30)-(7.34), as few rows as are needed.

A row is the torque command of one machine some steps ahead, and stands for both signs. With
:math:`\xi = x - X \tilde r`

.. math:: -s_i \le u_i(\tilde r) + C_i (A^k - I) \xi \le s_i, \qquad
          s_i = \frac{1 - \varepsilon_1}{1 + \varepsilon}\, T_{i,max}(\omega_i)

Limits are no part of the set: they are given in every step, and follow the speed (field weakening). Torques at rest,
(7.34), are kept by limiting the torque references before, with :math:`(1 - \varepsilon_\infty)` of the limits; what
rows may be removed for that, and at which price, see `ptgen.governor.row_removal`.

The set of a horizon :math:`k^*` in the source has :math:`2 m (k^* + 2)` rows.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import ControlError, Problem
from ptgen.governor.prediction import Prediction
from ptgen.governor.row_removal import RowFamily, needed_rows
from ptgen.mechanism.model import Model
from ptgen.testbed.governor_settings import GovernorSettings

__all__ = ["ConstraintSet", "TorqueLimit", "constraint_set", "torque_limits"]

Array = NDArray[np.float64]

_MOST_NUMBERS = 40_000_000
"""Numbers that all rows together may be: 320 MB."""


@dataclass(frozen=True)
class TorqueLimit:
    """Largest torque (N m) of a machine up to its rated speed, and the one at its largest speed."""

    largest: float
    least: float


@dataclass(frozen=True)
class ConstraintSet:
    """The rows that a governor keeps.

    Attributes
    ----------
    prediction : Prediction
    limits : tuple of TorqueLimit (m)
    reserve, stationary_reserve, removal : float
        eps_1, eps_inf, and the share by which removed rows may bind.
    horizon : int
        Steps ahead of the last row.
    steps : tuple of ndarray
        For each machine the steps k >= 1 of its rows; the present step is always a row besides.
    looked_at : int
        Steps ahead up to which rows were looked at; behind it all states that can occur are at rest.
    binding : ndarray (m, looked_at + 1)
        By how much rows that were removed can bind, see `ptgen.governor.row_removal.Needed`.
    programs : int
        How many linear programs it took.
    """

    prediction: Prediction
    limits: tuple[TorqueLimit, ...]
    reserve: float
    stationary_reserve: float
    removal: float
    horizon: int
    steps: tuple[NDArray[np.int64], ...]
    looked_at: int
    binding: Array
    programs: int

    @property
    def counts(self) -> tuple[int, ...]:
        """Number of rows of each machine, without that of the present step."""
        return tuple(len(steps) for steps in self.steps)

    @property
    def all_rows(self) -> int:
        """Number of inequalities of the source's set with this horizon, ``2 m (k* + 2)`` (7.31)."""
        return 2 * len(self.steps) * (self.horizon + 2)

    @property
    def kept_rows(self) -> int:
        """Number of inequalities that stand for them: both signs of each row, the present step included."""
        return 2 * (sum(self.counts) + len(self.steps))

    @property
    def loss(self) -> float:
        """Share of every torque limit that the removal of rows costs at most."""
        return self.removal / (1 + self.removal)

    def rows_x(self) -> Array:
        """Return what each row adds to the present command per state, ``C_i (A^k - I)`` (N, n), machine by machine."""
        p = self.prediction
        last = max((int(steps[-1]) for steps in self.steps if len(steps)), default=0)
        future = _future(p, last)
        parts = [future[i, steps] - p.C[i] for i, steps in enumerate(self.steps)]
        return np.vstack([np.zeros((0, len(p.A))), *parts])

    def rows_r(self) -> Array:
        """Return the same per reference, ``-C_i (A^k - I) X`` (N, m)."""
        return -self.rows_x() @ self.prediction.steady

    def full(self) -> ConstraintSet:
        """Return the set with every row of the horizon, and limits that are not tightened."""
        steps = tuple(np.arange(1, self.horizon + 1, dtype=np.int64) for _ in self.steps)
        return replace(self, steps=steps, removal=0.0, binding=np.zeros_like(self.binding))


def torque_limits(model: Model) -> tuple[TorqueLimit, ...]:
    """Return the torque limits of all machines, Figure 7.1."""
    limits = []
    for torque in model.inputs:
        drive, values = torque.drive, model.values
        largest = values[drive.torque_max]
        share = min(1.0, values[drive.speed_rated] / values[drive.speed_max])
        limits.append(TorqueLimit(largest, largest * share))
    return tuple(limits)


def constraint_set(
    prediction: Prediction,
    limits: Sequence[TorqueLimit],
    settings: GovernorSettings,
    progress: Callable[[float], None] | None = None,
    *,
    check: bool = True,
) -> ConstraintSet:
    """Return the constraint set of a loop.

    Parameters
    ----------
    prediction : Prediction
    limits : sequence of TorqueLimit (m)
    settings : GovernorSettings
        With ``horizon`` None the set has the smallest one for which longer ones add nothing.
    progress : callable, optional
        Called now and then with the share of the work that is done.
    check : bool
        Whether a horizon that is too short is refused. A horizon of zero, which predicts nothing, never is.

    Raises
    ------
    ControlError
        If the loop takes too long to settle, or the horizon is too short: it names machine, torque and a horizon that
        is long enough.

    References
    ----------
    Source (7.30)-(7.34); E. G. Gilbert, K. T. Tan: Linear systems with state and control constraints, IEEE Transactions
    on Automatic Control 36 (9), 1991, for the horizon behind which nothing is added.
    """
    family = _family(prediction, limits, settings)
    looked_at = family.rows.shape[1] - 1
    given = None if settings.horizon is None else round(settings.horizon / prediction.sample_time)
    needed = needed_rows(family, settings.removal, progress, given)
    last = max(int(steps[-1]) for steps in needed.steps)
    if check and given:
        _check_horizon(prediction, limits, settings, needed.binding, given, family)
    return ConstraintSet(
        prediction=prediction,
        limits=tuple(limits),
        reserve=settings.reserve,
        stationary_reserve=settings.stationary_reserve,
        removal=settings.removal,
        horizon=last if given is None else given,
        steps=tuple(steps[steps > 0] for steps in needed.steps),
        looked_at=looked_at,
        binding=needed.binding,
        programs=needed.programs,
    )


def _future(prediction: Prediction, last: int) -> Array:
    """Return ``C_i A^k`` (m, last + 1, n) for k = 0 .. last."""
    rows = np.empty((len(prediction.machines), last + 1, len(prediction.A)))
    rows[:, 0] = prediction.C
    for k in range(1, last + 1):
        rows[:, k] = rows[:, k - 1] @ prediction.A
    return rows


def _family(prediction: Prediction, limits: Sequence[TorqueLimit], settings: GovernorSettings) -> RowFamily:
    """Return all rows until every state that can occur is at rest: no row behind can bind any more."""
    largest = np.array([limit.largest for limit in limits]) * (1 - settings.reserve)
    least = np.array([limit.least / limit.largest for limit in limits])
    m, n = prediction.C.shape
    enough = max(settings.stationary_reserve, settings.removal)
    if enough <= 0:
        what = "stationary_reserve and removal are both zero, so a torque that settles never leaves its limit"
        raise ControlError(Problem("governor", what, "let one of them be above zero, such as removal = 0.001"))
    count = 1000
    while True:
        rows = _future(prediction, count) / largest[:, None, None]
        family = RowFamily(rows, least, settings.stationary_reserve)
        moving = np.flatnonzero(((np.abs(rows) @ family.scale) >= (enough * least)[:, None]).any(axis=0))
        last = int(moving[-1]) if len(moving) else 0
        if 2 * last <= count:  # quiet for as long as it took to become quiet
            return RowFamily(rows[:, : last + 2], least, settings.stationary_reserve)
        if m * n * 2 * count > _MOST_NUMBERS:
            slowest = abs(np.linalg.eigvals(prediction.A)).max()
            time = -prediction.sample_time / np.log(slowest)
            what = f"the closed loop settles with a time constant of {time:.3g} s, too slow to look ahead of"
            raise ControlError(Problem("control", what, "raise the bandwidths of speed and torque control"))
        count *= 2


def _check_horizon(
    prediction: Prediction,
    limits: Sequence[TorqueLimit],
    settings: GovernorSettings,
    binding: Array,
    given: int,
    family: RowFamily,
) -> None:
    """Refuse a horizon behind which rows can bind by more than what was asked for."""
    short = []
    for machine, name in enumerate(prediction.machines):
        beyond = binding[machine, given + 1 :]
        if not len(beyond) or beyond.max() <= settings.removal * (1 + 1e-6):
            continue
        worst = int(np.argmax(beyond))
        torque = beyond[worst] * limits[machine].largest * (1 - settings.reserve)
        time = (worst + given + 1) * prediction.sample_time
        short.append(f"{time:.3g} s ahead {name} may need up to {torque:.3g} N m more than its limit")
    if not short:
        return
    enough = max(int(steps[-1]) for steps in needed_rows(family, settings.removal).steps) * prediction.sample_time
    remedy = f"leave it out, or take {np.ceil(enough * 1000) / 1000:g} s; 0 s predicts nothing"
    given_time = f"{given * prediction.sample_time:g} s is too short"
    raise ControlError([Problem("governor.horizon", f"{given_time}: {text}", remedy) for text in short])

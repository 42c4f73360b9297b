"""What a run with a reference governor is judged by: torques beyond their limits, and when set-points are reached."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.simulate.recording import Recording
from ptgen.testbed.governor_settings import GovernorKind

__all__ = ["Choice", "Excess", "Followed", "GovernedRun", "SetPoint", "Solver", "excess", "set_points", "solver_work"]

Array = NDArray[np.float64]

BAND = 0.02
"""Share of a change within which a quantity has reached its set-point."""

_ROUNDING = 1e-6
"""Share of a limit by which a torque exceeds it by rounding alone."""

STATUS = {
    0: "nothing binds",
    1: "limited",
    2: "slack was needed",
    3: "not solved in time",
    4: "parameters differ from the design",
}
"""What the optimal governor may report about a step."""


@dataclass(frozen=True)
class Choice:
    """A governor and its settings.

    Attributes
    ----------
    kind : {"none", "sequential", "sequential_modified", "optimal"}
    horizon : float or None
        Of the optimal governor (s); None if it was found automatically.
    torque_weight, speed_weight : float
        Of the optimal governor, (7.36).
    """

    kind: GovernorKind
    horizon: float | None = None
    torque_weight: float = 1.0
    speed_weight: float = 100.0

    @property
    def label(self) -> str:
        """The governor in a few words, as in ``optimal, 1 : 100, horizon 0``."""
        if self.kind != "optimal":
            return {"none": "none", "sequential": "sequential", "sequential_modified": "sequential modified"}[self.kind]
        ahead = "" if self.horizon is None else f", horizon {self.horizon:.3g} s" if self.horizon else ", horizon 0"
        return f"optimal, {self.torque_weight:g} : {self.speed_weight:g}{ahead}"


@dataclass(frozen=True)
class Followed:
    """A reference of a machine and what comes of it, by the names of the signals in a recording.

    Attributes
    ----------
    machine : str
    signal : str
        The reference, such as ``M2_speed_ref``; shaped it is ``M2_speed_ref_shaped``.
    unit : str
    output : str
        The controlled quantity.
    wanted : ndarray (n,)
        As the scenario asks for it.
    """

    machine: str
    signal: str
    unit: str
    output: str
    wanted: Array

    @property
    def shaped(self) -> str:
        """Name of the shaped reference."""
        return f"{self.signal}_shaped"


@dataclass(frozen=True)
class Excess:
    """By how much the torque that the law asks of a machine exceeds what it may have.

    Attributes
    ----------
    machine : str
    most : float
        Largest excess (N m).
    at : float or None
        When (s); None if there is none.
    lasting : float
        How long the torque is beyond the limit, altogether (s).
    limit : float
        The limit at that time, or the least one in the run (N m).
    """

    machine: str
    most: float
    at: float | None
    lasting: float
    limit: float


@dataclass(frozen=True)
class SetPoint:
    """A change of a reference, and how long it takes.

    Attributes
    ----------
    signal, unit : str
    at : float
        When the reference begins to change (s).
    start, target : float
    shaped_after : float or None
        How long until the governor lets the reference through (s); None if it does not, or there is none.
    reached_after : float or None
        How long until the controlled quantity stays within 2 % of the change (s); None if it does not, before the
        reference changes again.
    """

    signal: str
    unit: str
    at: float
    start: float
    target: float
    shaped_after: float | None
    reached_after: float | None


@dataclass(frozen=True)
class Solver:
    """What the governor had to do.

    Attributes
    ----------
    statuses : mapping of int to int
        Number of steps with each status.
    mean_iterations : float
        In the steps in which something bound.
    most_iterations : int
    slack : mapping of str to float
        Largest slack of each machine (N m).
    """

    statuses: Mapping[int, int]
    mean_iterations: float
    most_iterations: int
    slack: Mapping[str, float]


@dataclass(frozen=True)
class GovernedRun:
    """A scenario with a governor on the nominal loop or on the whole bed.

    Attributes
    ----------
    choice : Choice
    bed : {"nominal", "plant"}
    recording : Recording
        Every step.
    followed : tuple of Followed (m)
    limits, demands : mapping of str to ndarray (n,)
        Torque-speed envelope of each machine, and what the law asks of it before any limit (N m).
    beyond_limit, beyond_reserve : tuple of Excess (m)
        With respect to the envelope, and to what the governor may use of it.
    set_points : tuple of SetPoint
    solver : Solver
    """

    choice: Choice
    bed: str
    recording: Recording
    followed: tuple[Followed, ...]
    limits: Mapping[str, Array]
    demands: Mapping[str, Array]
    beyond_limit: tuple[Excess, ...]
    beyond_reserve: tuple[Excess, ...]
    set_points: tuple[SetPoint, ...]
    solver: Solver


def excess(machine: str, time: Array, demand: Array, limit: Array, sample_time: float) -> Excess:
    """Return by how much a torque exceeds its limit.

    Parameters
    ----------
    machine : str
    time : ndarray (n,)
        (s)
    demand, limit : ndarray (n,)
        (N m)
    sample_time : float
        Interval between two entries (s).

    Examples
    --------
    >>> excess("M1", np.array([0.0, 0.1, 0.2]), np.array([5.0, -12.0, 9.0]), np.full(3, 10.0), 0.1)
    Excess(machine='M1', most=2.0, at=0.1, lasting=0.1, limit=10.0)
    """
    beyond = np.abs(demand) - limit
    worst = int(np.argmax(beyond))
    over = beyond > _ROUNDING * limit
    if not over.any():
        return Excess(machine, 0.0, None, 0.0, float(limit.min()))
    lasting = float(np.count_nonzero(over) * sample_time)
    return Excess(machine, float(beyond[worst]), float(time[worst]), lasting, float(limit[worst]))


def set_points(followed: Followed, time: Array, output: Array, shaped: Array | None) -> tuple[SetPoint, ...]:
    """Return the changes of a reference and how long each takes.

    Parameters
    ----------
    followed : Followed
    time : ndarray (n,)
        (s)
    output : ndarray (n,)
        The controlled quantity.
    shaped : ndarray (n,) or None
        The shaped reference.
    """
    wanted, found = followed.wanted, []
    segments = _changes(wanted)
    ends = [*(first + 1 for first, _ in segments), len(wanted)][1:]  # of each set-point: where the next change begins
    for (first, last), until in zip(segments, ends, strict=True):
        start, target = wanted[first], wanted[last]
        band = BAND * abs(target - start)
        reached = _settled(np.abs(output[last:until] - target) <= band)
        through = None
        if shaped is not None:
            through = _settled(np.abs(shaped[last:until] - target) <= 1e-9 * max(abs(target), abs(start)))
        found.append(
            SetPoint(
                followed.signal,
                followed.unit,
                float(time[first + 1]),
                float(start),
                float(target),
                None if through is None else float(time[last + through] - time[first + 1]),
                None if reached is None else float(time[last + reached] - time[first + 1]),
            )
        )
    return tuple(found)


def _changes(wanted: Array) -> list[tuple[int, int]]:
    """Return where a signal leaves a constant value, and where it has the next one."""
    moving = np.diff(wanted) != 0
    edges = np.flatnonzero(np.diff(np.concatenate([[False], moving, [False]]).astype(np.int8)))
    return [(int(first), int(last)) for first, last in zip(edges[::2], edges[1::2], strict=True)]


def _settled(inside: NDArray[np.bool_]) -> int | None:
    """Return from where on all entries are true."""
    if not len(inside) or not inside[-1]:
        return None
    outside = np.flatnonzero(~inside)
    return int(outside[-1] + 1) if len(outside) else 0


def solver_work(
    status: Array | None, iterations: Array | None, slack: Mapping[str, Array], machines: Sequence[str]
) -> Solver:
    """Return what the governor had to do from its recorded signals."""
    if status is None or iterations is None:
        return Solver({}, 0.0, 0, dict.fromkeys(machines, 0.0))
    codes, counts = np.unique(status.astype(np.int64), return_counts=True)
    busy = iterations[iterations > 0]
    return Solver(
        {int(code): int(count) for code, count in zip(codes, counts, strict=True)},
        float(busy.mean()) if len(busy) else 0.0,
        int(iterations.max()) if len(iterations) else 0,
        {name: float(slack[name].max()) if name in slack else 0.0 for name in machines},
    )

"""Commands on their way to the air gap, and profiles over time, as the emitted plant and closed loop take them."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Mapping

import numpy as np
import sympy as sp

from ptgen.elements import Torque
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.testbed.profile import Profile

__all__ = ["Commands", "course", "kinks", "value_at"]


class Commands:
    """Commands to one machine: limited by the torque-speed envelope, then late by computation and dead time.

    Parameters
    ----------
    torque : Torque
    model : Model
    values : mapping
        Value of every parameter, by symbol.
    sample_time : float
        Interval between two commands (s).

    Attributes
    ----------
    switch : float
        Time from the start of an interval until the newer of the two commands acts that share it (s).
    """

    def __init__(self, torque: Torque, model: Model, values: Mapping[sp.Symbol, float], sample_time: float) -> None:
        def value(expression: sp.Expr) -> float:
            return float(sp.sympify(expression).subs(values))

        drive = torque.drive
        self._torque_max, self._speed_rated = value(drive.torque_max), value(drive.speed_rated)
        self._speed = evaluate_matrix(model.velocity_rows[next(iter(torque.row))], values)[0]
        delay = 0.0 if drive.delay is None else value(drive.delay)
        depth = math.floor(delay / sample_time + 1e-6)
        self.switch = max(0.0, delay - depth * sample_time)
        self._last = [0.0] * (depth + 2)

    def push(self, reference: float, velocities: np.ndarray) -> None:
        """Take the command of a new interval, at whose start the bed has these velocities ``z`` (rad/s)."""
        speed = abs(float(self._speed @ velocities))
        most = self._torque_max * self._speed_rated / max(self._speed_rated, speed)
        self._last = [max(-most, min(most, reference)), *self._last[:-1]]

    def acting(self, since: float) -> float:
        """Return the command that acts `since` the start of the interval (s)."""
        return self._last[-2] if since > self.switch else self._last[-1]


def value_at(profile: Profile, time: float) -> float:
    """Return the value of a profile.

    Examples
    --------
    >>> value_at(Profile((0.0, 2.0), (0.0, 1.0), "lines"), 0.5)
    0.25
    >>> value_at(Profile((0.0, 2.0), (0.0, 1.0), "steps"), 2.0)
    1.0
    """
    k = max(0, bisect_right(profile.time, time) - 1)
    if profile.shape == "steps" or k + 1 >= len(profile.time) or time <= profile.time[k]:
        return profile.value[k]
    share = (time - profile.time[k]) / (profile.time[k + 1] - profile.time[k])
    return profile.value[k] + share * (profile.value[k + 1] - profile.value[k])


def kinks(profile: Profile, start: float, end: float) -> list[float]:
    """Return the points of a profile between two times, but not those at these times.

    Examples
    --------
    >>> kinks(Profile((0.0, 1.0, 2.0), (0.0, 1.0, 0.0), "lines"), 0.0, 2.0)
    [1.0]
    """
    margin = 1e-9 * (end - start)
    return list(profile.time[bisect_right(profile.time, start + margin) : bisect_right(profile.time, end - margin)])


def course(profile: Profile, start: float, end: float) -> Callable[[float], float] | float:
    """Return a profile between two times that have no kink in between: a number, or a straight line."""
    first, last = value_at(profile, start), value_at(profile, end)
    if profile.shape == "steps" or first == last:
        return value_at(profile, 0.5 * (start + end))
    return lambda time: first + (last - first) * (time - start) / (end - start)

"""What a step of the plant cannot represent: dead times that are too long, modes that are too fast."""

from __future__ import annotations

import numpy as np
import sympy as sp

from ptgen.errors import ModelError, Problem
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.modes import Mode, modes

__all__ = ["DELAY_CAPACITY", "check_delays", "too_fast"]

DELAY_CAPACITY = 16
"""Steps of dead time for which every delay line has room, one more than can be asked for."""


def check_delays(model: Model, sample_time: float, capacity: int = DELAY_CAPACITY) -> None:
    """Raise if computation and dead time of a drive take longer together than a delay line of `capacity` steps.

    Raises
    ------
    ModelError
        With every dead time that is too long, and the computation delay if it is.
    """
    longest = (capacity - 1) * sample_time
    problems: list[Problem] = []
    for torque in model.inputs:
        drive = torque.drive
        computation = 0.0 if drive.computation_delay is None else model.values[drive.computation_delay]
        dead_time = 0.0 if drive.dead_time is None else model.values[drive.dead_time]
        if computation + dead_time <= longest:
            continue
        key, most = ("testbed.computation_delay", longest - dead_time)
        what = f"is {1e6 * computation:.6g} us"
        if dead_time > computation:
            key, most = f"components.{torque.name}.inverter.dead_time", longest - computation
            what = f"is {1e6 * dead_time:.6g} us"
        if computation and dead_time:
            other = (
                ("computation_delay", computation)
                if dead_time > computation
                else (f"{torque.name}'s dead time", dead_time)
            )
            what += f", with {other[0]} {1e6 * (computation + dead_time):.6g} us"
        what += f", more than {capacity - 1} steps of the controller"
        remedy = f"check the unit, or take a longer sample_time: {1e6 * max(0.0, most):.6g} us are possible now"
        if not any(problem.where == key for problem in problems):
            problems.append(Problem(key, what, remedy))
    if problems:
        raise ModelError(problems)


def too_fast(model: Model, sample_time: float) -> ModelError:
    """Return the error for a mode that is too fast for the step, with the shaft that makes it so."""
    numeric = model.numeric()

    def taken(mode: Mode) -> float:
        """Return what friction torques take from a mode over a step; negative if the mode is too fast."""
        omega = 2 * np.pi * mode.frequency_hz
        size = float(np.sum((numeric.friction_rows @ mode.vector) ** 2))
        return size * (float(np.sin(omega * sample_time)) / omega if omega > 0 else sample_time)

    fastest = min(modes(model), key=taken)
    strain = {
        name: float((evaluate_matrix(row, model.values)[0] @ numeric.twist_rows @ fastest.vector) ** 2)
        * float(evaluate_matrix(sp.Matrix([[model.spring_stiffness[name]]]), model.values)[0, 0])
        for name, row in model.spring_rows.items()
    }
    shaft = max(strain, key=lambda name: strain[name])
    what = (
        f"is too long for the mode at {fastest.frequency_hz:.4g} Hz, whose friction could not be solved any more "
        f"(half the sampling rate is {0.5 / sample_time:.4g} Hz)"
    )
    remedy = (
        f"connect the flanges of {shaft}, which is the stiff part of that mode, directly instead; or raise the "
        f"inertias beside it; or take a sample_time of {1e6 / (4 * fastest.frequency_hz):.0f} us or less"
    )
    return ModelError(Problem("testbed.sample_time", what, remedy))

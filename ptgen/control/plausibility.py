"""How large a signal can be before it must be a fault."""

from __future__ import annotations

import numpy as np
import scipy.linalg

from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix

__all__ = ["largest_torque", "plausible_speed", "plausible_torque"]

SPEED_FACTOR = 1.5
TORQUE_FACTOR = 5.0


def plausible_speed(model: Model, machine: str) -> float:
    """Return the speed (rad/s) above which a measured or wanted speed of `machine` is a fault."""
    drive = next(torque.drive for torque in model.inputs if torque.name == machine)
    return SPEED_FACTOR * model.values[drive.speed_max]


def plausible_torque(model: Model, form: LinearForm) -> float:
    """Return the torque (N m) above which a signal is a fault: a multiple of the largest static one."""
    return float(f"{TORQUE_FACTOR * largest_torque(model, form):.3g}")


def largest_torque(model: Model, form: LinearForm) -> float:
    """Return the largest static torque (N m) that a single machine can cause in a signal while all others stand.

    Gear ratios between the machine and the place come in by themselves.
    """
    numeric = model.numeric()
    values = model.values
    E = numeric.twist_rows
    K = E.T @ numeric.stiffness @ E
    e_row, u_row = evaluate_matrix(form.e, values)[0], evaluate_matrix(form.u, values)[0]
    rotors = np.vstack([evaluate_matrix(model.velocity_rows[next(iter(t.row))], values) for t in model.inputs])
    largest = 0.0
    for index, torque in enumerate(model.inputs):
        others = np.delete(rotors, index, axis=0)
        free = scipy.linalg.null_space(others) if len(others) else np.eye(K.shape[0])
        motion, *_ = np.linalg.lstsq(free.T @ K @ free, free.T @ numeric.input_rows[index], rcond=1e-9)
        gain = abs(float(e_row @ E @ free @ motion + u_row[index]))
        largest = max(largest, gain * values[torque.drive.torque_max])
    # A shaft that is all but rigid has no static twist to speak of; the machines' own torque is the least bound.
    strongest = max(values[torque.drive.torque_max] for torque in model.inputs)
    return max(largest, 0.01 * strongest)

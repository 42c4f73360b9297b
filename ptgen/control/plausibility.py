"""How large a signal can be before it must be a fault."""

from __future__ import annotations

import numpy as np
import scipy.linalg

from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.mechanism.modes import modes
from ptgen.plant.layout import signal_name

__all__ = [
    "disagreement_limit",
    "first_frequency",
    "largest_torque",
    "oscillation_limit",
    "overspeed",
    "plausible",
    "plausible_speed",
    "plausible_torque",
]

SPEED_FACTOR = 1.5
OVERSPEED_FACTOR = 1.1
TORQUE_FACTOR = 5.0
TORQUE_ERROR = 0.2
LEAST_SPEED_ERROR = 0.03


def plausible(model: Model, machines: tuple[str, ...], name: str) -> float:
    """Return the largest plausible size (rad/s or N m) of an input of the controller.

    Parameters
    ----------
    model : Model
        The full model.
    machines : tuple of str
    name : str
        ``<M>_speed``, ``<M>_speed_ref``, a torque sensor, or ``<place>_ref``.
    """
    for machine in machines:
        if name in (f"{machine}_speed_ref", f"{machine}_speed"):
            return plausible_speed(model, machine)
    signals = {**{signal_name(place) + "_ref": form for place, form in model.signals.items()}, **model.signals}
    return plausible_torque(model, signals[name])


def overspeed(model: Model, machine: str) -> float:
    """Return the speed (rad/s) above which `machine` is too fast."""
    return float(f"{OVERSPEED_FACTOR * _drive(model, machine)[1]:.4g}")


def _drive(model: Model, machine: str) -> tuple[float, float]:
    """Return torque (N m) and speed (rad/s) of a machine at most."""
    drive = next(torque.drive for torque in model.inputs if torque.name == machine)
    return model.values[drive.torque_max], model.values[drive.speed_max]


def disagreement_limit(model: Model, machine: str, leak: float) -> float:
    """Return how far measured and integrated speed may differ (rad/s).

    A torque that is wrong by a fifth of the machine's for good makes that difference, with the leak in 1/s; a few
    percent of the largest speed are allowed in any case.
    """
    torque_max, speed_max = _drive(model, machine)
    torque = next(torque for torque in model.inputs if torque.name == machine)
    inertia = model.values[model.body_inertias[next(iter(torque.row))]]
    return float(f"{max(TORQUE_ERROR * torque_max / (inertia * leak), LEAST_SPEED_ERROR * speed_max):.3g}")


def first_frequency(model: Model) -> float:
    """Return the lowest natural frequency (Hz) of the bed with all friction elements free; 10 Hz if it has none."""
    return min((mode.frequency_hz for mode in modes(model) if mode.frequency_hz > 0), default=10.0)


def oscillation_limit(model: Model, form: LinearForm, machine: str | None) -> float:
    """Return the amplitude (N m) with which a torque may oscillate.

    The torque of the machine whose rotor it acts on; without such a machine what a single one can cause there.
    """
    if machine is not None:
        return _drive(model, machine)[0]
    return float(f"{largest_torque(model, form):.3g}")


def plausible_speed(model: Model, machine: str) -> float:
    """Return the speed (rad/s) above which a measured or wanted speed of `machine` is a fault."""
    return SPEED_FACTOR * _drive(model, machine)[1]


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

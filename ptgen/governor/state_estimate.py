r"""The states of the prediction from signals that the controller has.

Speeds are measured; twists follow from torques that are, :math:`\Delta\hat\varphi = \hat T / c` (source, behind
(7.36)). Every state takes the first of these ways that gives it:

1. speeds and testing torques (these are free of what inertias and losses add, see (5.95)-(5.98)),
2. with the other sensors,
3. with twists that do not change: a velocity between two shafts is then that of the machine,

first with combinations in which unknown friction torques cancel, then with others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.control.decoupling import Decoupling
from ptgen.elements import SensorKind
from ptgen.errors import ControlError, Problem
from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.layout import signal_name

__all__ = ["StateEstimate", "state_estimate"]

Array = NDArray[np.float64]

_RESIDUAL = 1e-9
"""What counts as zero of a row scaled to one."""


@dataclass(frozen=True)
class StateEstimate:
    """``x = E q`` with signals q of the controller.

    Attributes
    ----------
    values : ndarray (n, n_q)
    signals : tuple of str (n_q)
        Sensors by their name, ``<place>_torque`` for the testing torque as the controller estimates it at a place
        (its signal ``<place>_torque_estimate``), ``<machine>_torque`` for the air-gap torque that acts, and states of
        the controller by theirs.
    kinds : tuple of {"sensor", "estimate", "applied", "state"} (n_q)
    units : tuple of str (n_q)
    """

    values: Array
    signals: tuple[str, ...]
    kinds: tuple[str, ...]
    units: tuple[str, ...]


def state_estimate(
    decoupling: Decoupling,
    values: Mapping[sp.Symbol, float],
    sensors: tuple[Array, Array, Array],
    states: Sequence[str],
    units: Sequence[str],
) -> StateEstimate:
    """Return how to compute the states of the prediction.

    Parameters
    ----------
    decoupling : Decoupling
    values : mapping of Symbol to float
        Of all parameters of the reduced model.
    sensors : tuple of ndarray
        ``C`` (n_s, n_p), ``D`` (n_s, m), ``F`` (n_s, n_f) of ``y = C x + D u + F T``.
    states : sequence of str (n)
        States of the prediction.
    units : sequence of str (n)

    Raises
    ------
    ControlError
        If a state does not follow from the sensors.
    """
    model, m = decoupling.model, len(decoupling.machines)
    C_y, D_y, F_y = sensors
    n_p, n_f = C_y.shape[1], F_y.shape[1]
    places = [signal_name(place) for place in decoupling.outputs[: decoupling.torque_count]]
    forms = [
        model.without_acceleration(model.signals[place]) for place in decoupling.outputs[: decoupling.torque_count]
    ]
    rows = [np.hstack([evaluate_matrix(form.z, values), evaluate_matrix(form.e, values)]) for form in forms]
    C_t = np.vstack([np.zeros((0, n_p)), *rows])
    D_t = np.vstack([np.zeros((0, m)), *(evaluate_matrix(form.u, values) for form in forms)])
    F_t = np.vstack([np.zeros((0, n_f)), *(evaluate_matrix(form.f, values) for form in forms)])
    still = np.hstack([evaluate_matrix(model.twist_rows, values), np.zeros((len(model.twists),) * 2)])
    speeds = np.array([sensor.kind is SensorKind.SPEED for sensor in model.sensors])
    first = np.concatenate([speeds, np.ones(len(places), bool), np.zeros(len(still), bool)])
    second = np.concatenate([np.ones(len(speeds) + len(places), bool), np.zeros(len(still), bool)])
    seen = np.vstack([C_y, C_t, still])
    unknown = np.vstack([F_y, F_t, np.zeros((len(still), n_f))])
    fed = np.vstack([D_y, D_t, np.zeros((len(still), m))])
    names = [*decoupling.sensors, *places]
    signals = [*names, *(f"{name}_torque" for name in decoupling.machines)]
    kinds = ["sensor"] * len(decoupling.sensors) + ["estimate"] * len(places) + ["applied"] * m
    table = np.zeros((len(states), len(signals)))
    own = {name: k for k, name in enumerate(model.states)}
    of_controller: list[tuple[int, str]] = []
    problems = []
    for index, state in enumerate(states):
        machine = state.removesuffix("_torque before")
        if state in own:
            row = _combination(seen, unknown, own[state], (first, second, np.ones(len(seen), bool)))
            if row is None:
                what = f"the governor predicts with {state}, which no combination of sensors gives"
                problems.append(Problem("governor", what, "add a torque flange or a speed sensor beside it"))
                continue
            table[index, : len(names)] = row[: len(names)]
            table[index, len(names) :] = -row @ fed
        elif machine in decoupling.machines and state.endswith(" before"):
            table[index, len(names) + decoupling.machines.index(machine)] = 1.0
        else:
            of_controller.append((index, state))
    if problems:
        raise ControlError(problems)
    wide = np.hstack([table, np.zeros((len(states), len(of_controller)))])
    for column, (index, _) in enumerate(of_controller):
        wide[index, len(signals) + column] = 1.0
    signals += [state for _, state in of_controller]
    kinds += ["state"] * len(of_controller)
    all_units = ["rad/s" if "_speed" in name else "N m" for name in signals[: len(signals) - len(of_controller)]]
    all_units += [units[index] for index, _ in of_controller]
    used = [k for k in range(len(signals)) if np.any(wide[:, k] != 0)]
    return StateEstimate(
        wide[:, used],
        tuple(signals[k] for k in used),
        tuple(kinds[k] for k in used),
        tuple(all_units[k] for k in used),
    )


def _combination(seen: Array, unknown: Array, state: int, ways: Sequence[NDArray[np.bool_]]) -> Array | None:
    """Return ``row`` with ``row seen = e_state``, if possible with ``row unknown = 0``; None if there is none."""
    for hidden in (unknown, unknown[:, :0]):
        for way in ways:
            equations = np.hstack([seen, hidden])[way].T
            wanted = np.zeros(len(equations))
            wanted[state] = 1.0
            # Scaled: stiffnesses and speeds differ by many powers of ten.
            of_rows = np.abs(equations).max(axis=1, initial=0.0)
            equations, wanted = equations[of_rows > 0], wanted[of_rows > 0]
            if not np.any(wanted):
                continue
            scale = 1 / of_rows[of_rows > 0]
            columns = np.abs(equations * scale[:, None]).max(axis=0)
            columns[columns == 0] = 1.0
            matrix = equations * scale[:, None] / columns
            right = wanted * scale / np.max(wanted * scale)
            solution, *_ = np.linalg.lstsq(matrix, right, rcond=1e-12)
            if np.abs(matrix @ solution - right).max() < _RESIDUAL:
                row = np.zeros(len(seen))
                row[way] = solution / columns * np.max(wanted * scale)
                size = np.abs(row * np.abs(seen).max(axis=1, initial=0.0))
                row[size < 1e-12 * size.max()] = 0.0
                return row
    return None

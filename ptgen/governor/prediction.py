r"""The nominal closed loop that a reference governor predicts with (7.16)-(7.29).

Plant: the reduced model with the inertias that the law takes for its own, torques held over a step, so that sampling is
exact. Controller: the exact derivative of the emitted block in its linear range. Together

.. math:: x_{k+1} = A x_k + B \tilde r, \qquad u_k = C x_k + D \tilde r + W T

with the torque commands u before any limit. The law cancels what friction torques T do to the controlled quantities,
(7.20), so they are left out of the states; and all that the sensors show beyond the states, W T among it, stays as it
is over the horizon.

With the states in rest for a constant reference, :math:`x = X \tilde r` and :math:`X = (I - A)^{-1} B`,

.. math:: u_k - u_0 = C (A^k - I) (x_0 - X \tilde r)

so what is still to come depends on the distance from rest only. :math:`u_0` itself needs no prediction: it is what the
controller is about to ask for, measured torques included, (7.42).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.analysis.linear import Linearisation, StateSpace
from ptgen.control.decoupling import Decoupling
from ptgen.control.design import ControlDesign
from ptgen.errors import ControlError, Problem
from ptgen.governor.state_estimate import StateEstimate, state_estimate
from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.layout import signal_name
from ptgen.testbed.testbed import Testbed

__all__ = ["NamedMatrix", "Prediction", "predict_loop"]

Array = NDArray[np.float64]

_MARGIN = 1e-9
"""How far inside the unit circle an eigenvalue must be."""


@dataclass(frozen=True)
class NamedMatrix:
    """A matrix with the names and units of its rows and columns, and what it is.

    Attributes
    ----------
    values : ndarray (len(rows), len(columns))
    rows, columns, row_units, column_units : tuple of str
    text : str
    """

    values: Array
    rows: tuple[str, ...]
    columns: tuple[str, ...]
    row_units: tuple[str, ...]
    column_units: tuple[str, ...]
    text: str


@dataclass(frozen=True)
class Prediction:
    """The nominal closed loop; see the module.

    Attributes
    ----------
    A : ndarray (n, n)
    B : ndarray (n, m)
    C : ndarray (m, n)
    D : ndarray (m, m)
        How much each torque command changes at once with each reference.
    W : ndarray (m, n_f)
        What friction torques add to the commands.
    states, state_units : tuple of str (n)
        Velocities and twists of the reduced plant, states of the controller, and torques of the step before if sensors
        read them.
    references, reference_units : tuple of str (m)
        Of each machine, in the order of `machines`, as signals of the controller.
    machines, disturbances : tuple of str
    V : ndarray (m, n)
        The speed of each machine (rad/s) from the states.
    estimate : StateEstimate
        The states from signals of the controller.
    sample_time : float
        Step (s).
    """

    A: Array
    B: Array
    C: Array
    D: Array
    W: Array
    V: Array
    states: tuple[str, ...]
    state_units: tuple[str, ...]
    references: tuple[str, ...]
    reference_units: tuple[str, ...]
    machines: tuple[str, ...]
    disturbances: tuple[str, ...]
    estimate: StateEstimate
    sample_time: float

    @cached_property
    def steady(self) -> Array:
        """States at rest per reference, ``X = (I - A)^-1 B`` (n, m)."""
        return np.asarray(np.linalg.solve(np.eye(len(self.A)) - self.A, self.B), dtype=np.float64)

    @cached_property
    def stationary(self) -> Array:
        """Torque commands at rest per reference, ``C X + D`` (m, m), (7.34)."""
        values = self.C @ self.steady + self.D
        size = np.abs(self.C) @ np.abs(self.steady) + np.abs(self.D)
        return np.asarray(np.where(np.abs(values) > 1e-9 * size, values, 0.0), dtype=np.float64)

    @cached_property
    def speeds_at_rest(self) -> Array:
        """Speeds of the machines at rest per reference (m, m), for the limits (7.19)."""
        values = self.V @ self.steady
        size = np.abs(self.V) @ np.abs(self.steady)
        return np.asarray(np.where(np.abs(values) > 1e-6 * size, values, 0.0), dtype=np.float64)

    @cached_property
    def torque_references(self) -> tuple[bool, ...]:
        """Whether each reference is a torque."""
        return tuple(unit == "N m" for unit in self.reference_units)

    def matrices(self) -> dict[str, NamedMatrix]:
        """Return all matrices by their symbols, with names and units."""
        x, r = (self.states, self.state_units), (self.references, self.reference_units)
        u = (tuple(f"{name}_torque_ref" for name in self.machines), ("N m",) * len(self.machines))
        T = (self.disturbances, ("N m",) * len(self.disturbances))
        q = (self.estimate.signals, self.estimate.units)
        table = {
            "A": (self.A, x, x, "states after a step from states (7.27)"),
            "B": (self.B, x, r, "states after a step from references (7.27)"),
            "C": (self.C, u, x, "torque commands from states (7.28), (7.29)"),
            "D": (self.D, u, r, "torque commands from references (7.28), (7.29)"),
            "W": (self.W, u, T, "torque commands from friction torques (7.29)"),
            "V": (
                self.V,
                (tuple(f"{name}_speed" for name in self.machines), ("rad/s",) * len(self.machines)),
                x,
                "speeds of the machines from states (7.19)",
            ),
            "X": (self.steady, x, r, "states at rest from constant references"),
            "Y": (self.stationary, u, r, "torque commands at rest from constant references (7.34)"),
            "E": (self.estimate.values, x, q, "states from signals of the controller"),
        }
        return {
            symbol: NamedMatrix(values, rows[0], columns[0], rows[1], columns[1], text)
            for symbol, (values, rows, columns, text) in table.items()
        }


def predict_loop(design: ControlDesign, testbed: Testbed) -> Prediction:
    """Return the nominal closed loop of a design.

    Parameters
    ----------
    design : ControlDesign
    testbed : Testbed
        The bed that it was made for.

    Raises
    ------
    ControlError
        If that loop is unstable, or if no combination of sensors gives one of its states.

    References
    ----------
    Source (7.16)-(7.29).
    """
    decoupling, block = design.decoupling, design.controller.block
    values = {**decoupling.values, **design.tuned_inertia}

    def numbers(matrix: sp.Matrix) -> Array:
        return np.asarray(evaluate_matrix(matrix, values), dtype=np.float64)

    system = decoupling.system
    A, B = numbers(system.A), numbers(system.B)
    C_y, D_y, F_y = _sensors(decoupling, values)
    # What sensors miss of the inertias that the reduced model leaves out is no part of the reduced loop.
    nothing_missed = {signal.name: 0.0 for signal in block.parameters if "_sensor_inertia_" in signal.name}
    controller = Linearisation(block).at(nothing_missed)
    names, units, to_block = _references(design, testbed.tuning.speed_pairs)
    loop = _closed(A, B, C_y, D_y, controller, decoupling, _columns(design, to_block, controller), testbed.sample_time)
    known = {signal.name: signal.unit for signal in block.states}
    model = decoupling.model
    own = dict.fromkeys(model.coordinates, "rad/s") | {f"twist {name}": "rad" for name in model.twists}
    own |= {_before(name): "N m" for name in decoupling.machines}
    state_units = tuple(own[name] if name in own else known[name] for name in loop.states)
    _check_stability(loop, state_units)
    frictions = tuple(friction.name for friction in model.frictions) + tuple(spring.name for spring in model.contacts)
    return Prediction(
        A=loop.A,
        B=loop.B,
        C=loop.C,
        D=loop.D,
        W=_from_sensors(controller, decoupling)[1] @ F_y,
        V=_speeds(decoupling, values, loop.states),
        states=loop.states,
        state_units=state_units,
        references=names,
        reference_units=units,
        machines=decoupling.machines,
        disturbances=frictions,
        estimate=state_estimate(decoupling, values, (C_y, D_y, F_y), loop.states, state_units),
        sample_time=testbed.sample_time,
    )


def _sensors(decoupling: Decoupling, values: Mapping[sp.Symbol, float]) -> tuple[Array, Array, Array]:
    """Return the sensors as ``y = C x + D u + F T``."""
    model = decoupling.model
    forms = [model.without_acceleration(model.signals[name]) for name in decoupling.sensors]
    C = np.vstack([np.hstack([evaluate_matrix(form.z, values), evaluate_matrix(form.e, values)]) for form in forms])
    D = np.vstack([evaluate_matrix(form.u, values) for form in forms])
    F = np.vstack([evaluate_matrix(form.f, values) for form in forms])
    return C, D, F


def _speeds(decoupling: Decoupling, values: Mapping[sp.Symbol, float], states: tuple[str, ...]) -> Array:
    """Return the speed of each machine from the states of the loop."""
    model = decoupling.model
    rows = [model.velocity_rows[next(iter(torque.row))] for torque in model.inputs]
    from_velocities = np.vstack([evaluate_matrix(row, values) for row in rows])
    result = np.zeros((len(rows), len(states)))
    for k, name in enumerate(model.coordinates):
        if name in states:
            result[:, states.index(name)] = from_velocities[:, k]
    return result


def _references(
    design: ControlDesign, pairs: Mapping[str, tuple[str, ...]]
) -> tuple[tuple[str, ...], tuple[str, ...], dict[str, dict[int, float]]]:
    """Return name and unit of each machine's reference, and the inputs of the block as combinations of them."""
    decoupling = design.decoupling
    names, units = [""] * len(decoupling.machines), [""] * len(decoupling.machines)
    to_block: dict[str, dict[int, float]] = {}
    for position, machine in enumerate(decoupling.actuators):
        name = decoupling.machines[machine]
        is_torque = position < decoupling.torque_count
        names[machine] = signal_name(decoupling.outputs[position]) + "_ref" if is_torque else f"{name}_speed_ref"
        units[machine] = "N m" if is_torque else "rad/s"
    for key, signal in design.controller.references.items():
        if signal in names:
            to_block[signal] = {names.index(signal): 1.0}
            continue
        first, second = (decoupling.machines.index(name) for name in pairs[key.split(".")[1]])
        of_mean = key.startswith("speed_mean.")
        to_block[signal] = {first: 0.5, second: 0.5} if of_mean else {first: 1.0, second: -1.0}
    return tuple(names), tuple(units), to_block


def _columns(design: ControlDesign, to_block: Mapping[str, Mapping[int, float]], controller: StateSpace) -> Array:
    """Return the inputs of the controller's block (n_u, m) per reference of a machine."""
    result = np.zeros((len(controller.inputs), len(design.decoupling.machines)))
    for signal, shares in to_block.items():
        for machine, share in shares.items():
            result[controller.inputs.index(signal), machine] = share
    return result


def _from_sensors(controller: StateSpace, decoupling: Decoupling) -> tuple[Array, Array]:
    """Return what the sensors do to states and commands of the controller, (n_c, n_s) and (m, n_s)."""
    B, D = (
        np.zeros((len(controller.A), len(decoupling.sensors))),
        np.zeros((len(controller.C), len(decoupling.sensors))),
    )
    for k, name in enumerate(decoupling.sensors):
        if name in controller.inputs:  # sensors that the controller does not need are no inputs of it
            B[:, k] = controller.B[:, controller.inputs.index(name)]
            D[:, k] = controller.D[:, controller.inputs.index(name)]
    return B, D


def _before(machine: str) -> str:
    """Return the name of the state that is a torque of the step before."""
    return f"{machine}_torque before"


def _closed(
    A: Array,
    B: Array,
    C_y: Array,
    D_y: Array,
    controller: StateSpace,
    decoupling: Decoupling,
    columns: Array,
    h: float,
) -> StateSpace:
    """Return the closed loop from references to commands, without the states that no command depends on."""
    n, n_c, m = len(A), len(controller.A), len(decoupling.machines)
    held = scipy.linalg.expm(np.block([[A, B], [np.zeros((m, n + m))]]) * h)
    B_s, D_s = _from_sensors(controller, decoupling)
    # x = (plant, controller, torques of the step before): sensors are read before new torques act
    C = np.hstack([D_s @ C_y, controller.C, D_s @ D_y])
    D = controller.D @ columns
    whole = np.zeros((n + n_c + m, n + n_c + m))
    whole[:n] = held[:n, n:] @ C
    whole[:n, :n] += held[:n, :n]
    whole[n : n + n_c] = np.hstack([B_s @ C_y, controller.A, B_s @ D_y])
    whole[n + n_c :] = C
    inputs = np.vstack([held[:n, n:] @ D, controller.B @ columns, D])
    names = (*decoupling.model.states, *controller.states, *(_before(name) for name in decoupling.machines))
    keep = (C != 0).any(axis=0)
    while True:
        more = keep | (whole[keep] != 0).any(axis=0)
        if (more == keep).all():
            break
        keep = more
    states = tuple(name for name, kept in zip(names, keep, strict=True) if kept)
    return StateSpace(whole[np.ix_(keep, keep)], inputs[keep], C[:, keep], D, states, (), decoupling.machines)


def _check_stability(loop: StateSpace, units: tuple[str, ...]) -> None:
    """Refuse a loop that does not settle."""
    values, vectors = np.linalg.eig(loop.A)
    worst = int(np.argmax(abs(values)))
    if abs(values[worst]) < 1 - _MARGIN:
        return
    left = np.linalg.inv(vectors)[worst]
    shares = abs(left * vectors[:, worst])
    most = [loop.states[k] for k in np.argsort(-shares)[:3] if shares[k] > 0.1 * shares.max()]
    what = (
        f"the closed loop does not settle: what lives in {', '.join(most)} changes by {abs(values[worst]):.6g} per step"
    )
    remedy = (
        "a reference governor needs a stable loop: see ptgen analyse for the margins, or let ptgen tune choose gains"
    )
    raise ControlError(Problem("control", what, remedy))

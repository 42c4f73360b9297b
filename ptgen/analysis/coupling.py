"""How much the controlled quantities disturb each other, and what is to blame: rounding, sampling, dead time, parts.

One reference moves, all others are zero, and so should be the quantities that they stand for. Torque references
step, speed references rise with a constant acceleration.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import scipy.linalg
from numpy.typing import NDArray

from ptgen.analysis.linear import Linearisation
from ptgen.control.decoupling import Decoupling
from ptgen.mechanism.model import evaluate_matrix

__all__ = ["Coupling", "ReferencedLoop", "continuous_coupling", "referenced_loop", "sampled_coupling"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Coupling:
    """Errors that one reference causes in what it should leave alone.

    Attributes
    ----------
    references : tuple of str (m)
        As a scenario names them: ``torque.M1``, ``speed.M2``, ``speed_mean.rear``.
    rms : ndarray (m, m)
        Root mean square over the horizon of the quantity of the row while the reference of the column moves: per
        N m of a step of a torque, per rad/s^2 of a speed's acceleration. The diagonal is not a number.
    horizon : float
        Time (s) from the start of the motion.
    """

    references: tuple[str, ...]
    rms: Array
    horizon: float

    def worst(self, disturbed: str, moved: str) -> tuple[float, str, str] | None:
        """Return the largest error of a kind, with the references of row and column; None if there is none.

        Parameters
        ----------
        disturbed, moved : {"torque", "speed"}
        """
        pairs = [
            (float(self.rms[i, j]), of, by)
            for i, of in enumerate(self.references)
            for j, by in enumerate(self.references)
            if i != j and of.startswith(disturbed) and by.startswith(moved)
        ]
        return max(pairs, default=None)


@dataclass(frozen=True)
class ReferencedLoop:
    """Controller and plant in closed loop, from references to the quantities that should follow them.

    Attributes
    ----------
    A, B, C : ndarray
    references : tuple of str (m)
        As a scenario names them.
    sample_time : float
        Step (s).
    """

    A: Array
    B: Array
    C: Array
    references: tuple[str, ...]
    sample_time: float

    def steps(self, horizon: float, rows: int = 600) -> tuple[Array, Array]:
        """Return times (n,) and responses (n, m, m): of the quantity of a row to a unit step of a column's reference.

        Parameters
        ----------
        horizon : float
            Duration (s).
        rows : int
            Points in time to return, about.
        """
        count = max(2, round(horizon / self.sample_time))
        every = max(1, count // rows)
        x = np.zeros((len(self.A), len(self.references)))
        found = []
        for k in range(count):
            if k % every == 0:
                found.append(self.C @ x)
            x = self.A @ x + self.B
        return np.arange(len(found), dtype=np.float64) * every * self.sample_time, np.array(found)


def referenced_loop(
    controller: Linearisation,
    plant: Linearisation,
    references: Mapping[str, tuple[str, Mapping[str, float]]],
    parameters: Mapping[str, float],
) -> ReferencedLoop:
    """Close the loop of controller and plant.

    Parameters
    ----------
    controller, plant : Linearisation
    references : mapping of str to (str, mapping)
        Reference of a scenario -> the controller's input, and the shares of the plant's outputs in what should follow.
    parameters : mapping
        Parameters that differ from the defaults.
    """
    K, G = controller.at(parameters), plant.at(parameters)
    n_c = len(K.A)
    B_y, D_y = np.zeros((n_c, len(G.outputs))), np.zeros((len(K.outputs), len(G.outputs)))
    for k, name in enumerate(K.inputs):
        if name in G.outputs:
            j = G.outputs.index(name)
            B_y[:, j], D_y[:, j] = K.B[:, k], K.D[:, k]
    drive = G.B[:, [G.inputs.index(name) for name in K.outputs]]
    A = np.block([[G.A + drive @ D_y @ G.C, drive @ K.C], [B_y @ G.C, K.A]])
    asked = [K.inputs.index(given) for given, _ in references.values()]
    B = np.vstack([drive @ K.D[:, asked], K.B[:, asked]])
    follows = np.array([[shares.get(name, 0.0) for name in G.outputs] for _, shares in references.values()])
    C = np.hstack([follows @ G.C, np.zeros((len(references), n_c))])
    h = next(signal.value for signal in plant.block.parameters if signal.name == "sample_time")
    return ReferencedLoop(A, B, C, tuple(references), h)


def sampled_coupling(loop: ReferencedLoop, horizon: float) -> Coupling:
    """Return the couplings of a sampled loop within `horizon` (s)."""
    return _run(loop.references, loop.A, loop.B, loop.C, loop.sample_time, horizon)


def continuous_coupling(decoupling: Decoupling, parameters: Mapping[str, float], horizon: float) -> Coupling:
    """Return the couplings that the law leaves on the reduced model without sampling: no more than rounding.

    Parameters
    ----------
    decoupling : Decoupling
    parameters : mapping
        Parameters of the controller by name.
    horizon : float
        Time (s).
    """
    values = dict(decoupling.values)
    values |= {symbol: parameters.get(symbol.name, 0.0) for symbol in decoupling.damping}
    A, B = evaluate_matrix(decoupling.system.A, values), evaluate_matrix(decoupling.system.B, values)
    U_v, U_x = (evaluate_matrix(part, values) for part in (decoupling.state_law.v, decoupling.state_law.x))
    C = np.vstack([evaluate_matrix(chain.rows[0], values) for chain in decoupling.chains])
    n, m = A.shape[0], B.shape[1]
    names, scales = [], np.ones(m)
    for position, machine in enumerate(decoupling.actuators):
        name = decoupling.machines[machine]
        is_torque = position < decoupling.torque_count
        names.append(f"{'torque' if is_torque else 'speed'}.{name}")
        if not is_torque:  # the virtual input is the torque that accelerates the rotor
            rotor = decoupling.model.body_inertias[next(iter(decoupling.model.inputs[machine].row))]
            scales[position] = values[rotor]
    h = horizon / 1000
    exponent = np.zeros((n + m, n + m))
    exponent[:n, :n], exponent[:n, n:] = (A + B @ U_x) * h, (B @ U_v * scales) * h
    step = scipy.linalg.expm(exponent)[:n]
    return _run(tuple(names), step[:, :n], step[:, n:], C, h, horizon, held=True)


def _run(
    references: tuple[str, ...], A: Array, B: Array, C: Array, h: float, horizon: float, held: bool = False
) -> Coupling:
    """Let every reference move on its own; `held` if speeds are given by a constant acceleration already."""
    m, steps = len(references), max(1, round(horizon / h))
    ramped = np.array([name.startswith("speed") and not held for name in references])
    x, total = np.zeros((len(A), m)), np.zeros((m, m))
    for k in range(steps):
        x = A @ x + B * np.where(ramped, k * h, 1.0)
        total += (C @ x) ** 2
    rms = np.sqrt(total / steps)
    np.fill_diagonal(rms, np.nan)
    return Coupling(references, rms, horizon)

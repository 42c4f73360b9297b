"""Modes of a bed: frequencies, damping ratios and shapes, with friction elements locked or free."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.errors import ModelError, Problem, nearest
from ptgen.mechanism.model import Model, evaluate_matrix

__all__ = ["Mode", "modes"]

_NO_DAMPING = 1e-12


@dataclass(frozen=True)
class Mode:
    """One mode.

    Attributes
    ----------
    frequency_hz : float
        Natural frequency of the undamped bed (Hz); exactly 0 for rigid-body modes.
    damping_ratio : float
        Damping ratio of the pole pair that belongs to it; 0 for rigid-body modes.
    vector : ndarray (n_z,)
        Amplitudes of the coordinates, scaled to unit kinetic energy, ``vector' M vector = 1``.
    shape : mapping of str to float
        Amplitude of every velocity that carries inertia, the largest is 1 in size.
    """

    frequency_hz: float
    damping_ratio: float
    vector: NDArray[np.float64]
    shape: Mapping[str, float]


def modes(
    model: Model,
    locked: Collection[str] = (),
    values: Mapping[sp.Symbol, float] | None = None,
    held: Collection[str] = (),
) -> tuple[Mode, ...]:
    """Return the modes, rigid-body modes first, then by frequency.

    Parameters
    ----------
    model : Model
    locked : collection of str
        Friction elements that stick, such as ``diff.limited_slip``; all others are free and without friction.
    values : mapping, optional
        Parameters that override those of the bed.
    held : collection of str
        Velocities that are zero, such as ``M2.shaft``: of machines whose controllers let nothing move them.

    Raises
    ------
    ModelError
        If a name is no friction element of the bed.

    References
    ----------
    Section 3.12 and Figures 3.29, 3.30 of the source.
    """
    names = [friction.name for friction in model.frictions]
    unknown = [name for name in locked if name not in names]
    if unknown:
        raise ModelError(
            [
                Problem(
                    name,
                    "is no friction element of this bed",
                    nearest(name, names) if names else "it has none",
                )
                for name in unknown
            ]
        )
    matrices = model.numeric(values)
    table = {**model.values, **(values or {})}
    rows = matrices.friction_rows[[names.index(name) for name in locked], :]
    rows = np.vstack([rows, *(evaluate_matrix(model.velocity_rows[name], table) for name in held)])
    N = scipy.linalg.null_space(rows) if len(rows) else np.eye(len(model.coordinates))
    if N.shape[1] == 0:
        return ()
    E = matrices.twist_rows @ N
    M = N.T @ matrices.mass @ N
    K = E.T @ matrices.stiffness @ E
    D = E.T @ matrices.damping @ E
    rigid = M.shape[0] - int(np.linalg.matrix_rank(E)) if E.size else M.shape[0]
    squared, shapes = scipy.linalg.eigh(K, M)
    poles = _poles(M, D, K)
    bodies = {name: evaluate_matrix(row, table)[0] @ N for name, row in model.shape_rows().items()}
    result = []
    shapes[:, :rigid] = _rigid_basis(shapes[:, :rigid], M)
    for index, vector in enumerate(shapes.T):
        omega = 0.0 if index < rigid else float(np.sqrt(max(squared[index], 0.0)))
        damping = 0.0 if index < rigid else _damping_ratio(omega, vector @ D @ vector, poles)
        amplitudes = {name: float(row @ vector) for name, row in bodies.items()}
        largest = max(amplitudes.values(), key=abs)
        shape = {name: value / largest + 0.0 for name, value in amplitudes.items()}
        result.append(Mode(omega / (2 * np.pi), damping, N @ vector, shape))
    return tuple(result)


def _rigid_basis(vectors: NDArray[np.float64], M: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a basis of the rigid-body motions that does not depend on how the eigenvalues were found.

    The motions are reduced to echelon form from the last coordinate up, then made orthogonal in the kinetic energy.
    """
    basis = vectors.T[:, ::-1].copy()
    row = 0
    for column in range(basis.shape[1]):
        if row == len(basis):
            break
        pivot = row + int(np.argmax(np.abs(basis[row:, column])))
        if abs(basis[pivot, column]) < 1e-9 * np.abs(basis).max():
            continue
        basis[[row, pivot]] = basis[[pivot, row]]
        basis[row] /= basis[row, column]
        for other in range(len(basis)):
            if other != row:
                basis[other] -= basis[other, column] * basis[row]
        row += 1
    echelon = basis[:, ::-1].T
    factor = np.linalg.cholesky(echelon.T @ M @ echelon) if echelon.size else np.zeros((0, 0))
    return np.asarray(np.linalg.solve(factor, echelon.T).T, dtype=np.float64)


def _poles(M: NDArray[np.float64], D: NDArray[np.float64], K: NDArray[np.float64]) -> NDArray[np.complex128]:
    size = M.shape[0]
    A = np.block([[np.zeros((size, size)), np.eye(size)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    poles = np.linalg.eigvals(A)
    return np.asarray(poles[poles.imag > 0], dtype=np.complex128)


def _damping_ratio(omega: float, modal_damping: float, poles: NDArray[np.complex128]) -> float:
    """Return the damping ratio of the nearest pole pair; that of the modal damping if it is overdamped."""
    proportional = float(modal_damping / (2 * omega))
    if not len(poles):
        return proportional
    expected = omega * complex(-proportional, np.sqrt(max(0.0, 1 - proportional**2)))
    pole = poles[np.argmin(abs(poles - expected))]
    ratio = float(-pole.real / abs(pole)) if proportional < 1 else proportional
    return ratio if abs(ratio) > _NO_DAMPING else 0.0

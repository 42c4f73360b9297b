"""Lie derivatives, relative degrees and decoupling matrix of a reduced model (source (5.23)-(5.36)).

The reduced model is linear in its states, ``dx/dt = A x + B u + F T``, so Lie derivatives are products with ``A``;
its parameters may change with time, which adds their partial derivatives, as in (5.46).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ptgen.mechanism import exact
from ptgen.mechanism.model import LinearForm, Model

__all__ = ["AffineSystem", "OutputChain", "affine_system", "derivatives"]


@dataclass(frozen=True)
class AffineSystem:
    """``dx/dt = A x + B u + F T`` with x = (velocities, twists); A (n, n), B (n, m), F (n, n_f)."""

    A: sp.Matrix
    B: sp.Matrix
    F: sp.Matrix

    @property
    def order(self) -> int:
        """Number of states."""
        return int(self.A.shape[0])


@dataclass(frozen=True)
class OutputChain:
    """An output and its derivatives up to the one in which an input appears.

    Attributes
    ----------
    name : str
    rows : tuple of Matrix (1, n)
        ``L_a^k c`` for k = 0 .. delta; the last one belongs to the delta-th derivative.
    input_row : Matrix (1, m)
        ``L_b L_a^(delta - 1) c``, the row of the decoupling matrix (5.29).
    disturbance_row : Matrix (1, n_f)
        How the friction torques enter the delta-th derivative.
    relative_degree : int or None
        ``delta`` of (5.24); None if no input ever appears.
    """

    name: str
    rows: tuple[sp.Matrix, ...]
    input_row: sp.Matrix
    disturbance_row: sp.Matrix
    relative_degree: int | None


def affine_system(model: Model) -> AffineSystem:
    """Return the state equations of a model by exact elimination."""
    rates = model.accelerations()
    n_e = len(model.twists)
    A = sp.Matrix.vstack(sp.Matrix.hstack(rates.z, rates.e), sp.Matrix.hstack(model.twist_rows, sp.zeros(n_e, n_e)))
    B = sp.Matrix.vstack(rates.u, sp.zeros(n_e, rates.u.shape[1]))
    F = sp.Matrix.vstack(rates.f, sp.zeros(n_e, rates.f.shape[1]))
    return AffineSystem(A, B, F)


def derivatives(
    system: AffineSystem, name: str, form: LinearForm, rates: Mapping[sp.Symbol, sp.Expr] | None = None
) -> OutputChain:
    """Differentiate an output until an input appears.

    Parameters
    ----------
    system : AffineSystem
    name : str
        Name of the output.
    form : LinearForm
        The output without accelerations.
    rates : mapping of Symbol to Expr, optional
        Time derivatives of parameters that change, such as a ratio during a gear shift (5.46).
    """
    row = sp.Matrix.hstack(form.z, form.e)
    rows = [row]
    if any(entry != 0 for entry in form.u):
        return OutputChain(name, (row,), form.u, form.f, 0)
    for degree in range(1, system.order + 1):
        input_row, before = _times(row, system.B), row
        drift = sum((row.diff(symbol) * rate for symbol, rate in (rates or {}).items()), sp.zeros(1, system.order))
        row = _times(row, system.A) if drift.is_zero_matrix else exact.canonical(row * system.A + drift)
        rows.append(row)
        if any(entry != 0 for entry in input_row):
            return OutputChain(name, tuple(rows), input_row, _times(before, system.F), degree)
    return OutputChain(name, tuple(rows), sp.zeros(1, system.B.shape[1]), sp.zeros(1, system.F.shape[1]), None)


def _times(row: sp.Matrix, matrix: sp.Matrix) -> sp.Matrix:
    """Return ``row matrix`` in canonical form; a unit row picks what is canonical already."""
    found = [k for k, entry in enumerate(row) if entry != 0]
    if len(found) == 1 and row[found[0]] == 1:
        return matrix[found[0], :]
    return exact.canonical(row * matrix)

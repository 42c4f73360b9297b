"""Byrnes-Isidori normal form of a bed: outputs, their derivatives, and what stays behind (source (5.37)-(5.41))."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ptgen.control.lie import AffineSystem, OutputChain
from ptgen.mechanism import exact

__all__ = ["NormalForm", "normal_form"]


@dataclass(frozen=True)
class NormalForm:
    """The transformation ``z = (xi, eta) = T x`` (5.37) and the closed loop in it (5.40).

    Attributes
    ----------
    names : tuple of str (n)
        Outputs and their derivatives, such as ``"flange1"`` and ``"d/dt flange1"``; then the states behind them.
    transform : Matrix (n, n)
        ``T``, regular.
    external_order : int
        The length of xi, the total relative degree (5.36).
    closed : Matrix (n, n)
        ``dz/dt = closed z + ...`` with the law (5.34) and all virtual inputs zero.
    """

    names: tuple[str, ...]
    transform: sp.Matrix
    external_order: int
    closed: sp.Matrix

    @property
    def internal_names(self) -> tuple[str, ...]:
        """What is behind the outputs, eta."""
        return self.names[self.external_order :]

    @property
    def internal(self) -> sp.Matrix:
        """The internal dynamics (5.41): ``d eta/dt = internal eta`` while all outputs and virtual inputs are zero."""
        return self.closed[self.external_order :, self.external_order :]

    @property
    def internal_polynomial(self) -> sp.Poly | None:
        """Characteristic polynomial of the internal dynamics in s; None if there are none."""
        return self.internal.charpoly(sp.Symbol("s")) if self.internal_names else None


def normal_form(
    system: AffineSystem, chains: Sequence[OutputChain], of_x: sp.Matrix, states: Sequence[str]
) -> NormalForm:
    """Return the normal form of a bed under its law.

    The states behind the outputs are taken as combinations that no air-gap torque acts on, twists first, as far as
    there are any; otherwise as states of the model.

    Parameters
    ----------
    system : AffineSystem
        ``dx/dt = A x + B u + ...``.
    chains : sequence of OutputChain
        The outputs with their derivatives; the decoupling matrix is regular.
    of_x : Matrix (m, n)
        The law over the states, ``u = of_x x + ...``.
    states : sequence of str (n)
        Names of the states.
    """
    n = system.order
    rows, names = [], []
    for chain in chains:
        for order, row in enumerate(chain.rows[: chain.relative_degree or 0]):
            rows.append(row)
            names.append({0: "", 1: "d/dt "}.get(order, f"d^{order}/dt^{order} ") + chain.name)
    external = len(rows)
    units = [sp.eye(n)[k, :] for k in reversed(range(n))]
    free = [(row, states[n - 1 - k]) for k, row in enumerate(units) if all(entry == 0 for entry in row * system.B)]
    if external + len(free) < n:
        kernel = exact.left_null_space(system.B)
        free += [(kernel[k, :], _written(kernel[k, :], states)) for k in range(kernel.shape[0])]
    candidates = free + [(row, states[n - 1 - k]) for k, row in enumerate(units)]
    chosen = exact.independent_rows(exact.stack([*rows, *(row for row, _ in candidates)], n))
    for index in chosen[external:]:
        row, name = candidates[index - external]
        rows.append(row)
        names.append(name)
    T = exact.stack(rows, n)
    moved = T * (system.A + system.B * of_x)
    closed = exact.canonical(exact.solve(T.T, moved.T).T)
    return NormalForm(tuple(names), T, external, closed)


def _written(row: sp.Matrix, states: Sequence[str]) -> str:
    return " + ".join(
        name if entry == 1 else f"({sp.sstr(entry)}) {name}"
        for entry, name in zip(row, states, strict=True)
        if entry != 0
    )

"""The control law over states and disturbances, before sensors take their place (source (5.31), (5.34))."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from ptgen.control.lie import AffineSystem, OutputChain
from ptgen.mechanism import exact

__all__ = ["LawPart", "StateLaw", "Wishes", "decoupling_state_law"]


@dataclass(frozen=True)
class LawPart:
    """A part of a law over the states, x (m, n), and the friction torques, T (m, n_f)."""

    x: sp.Matrix
    T: sp.Matrix


@dataclass(frozen=True)
class StateLaw:
    """``u = v V + x X + T F`` with virtual inputs V, states X and friction torques F.

    Attributes
    ----------
    v : Matrix (m, m)
    x : Matrix (m, n)
    T : Matrix (m, n_f)
    ratio_rates : mapping of str to LawPart
        What the rate of each ratio that changes at run time adds, per unit of that rate.
    """

    v: sp.Matrix
    x: sp.Matrix
    T: sp.Matrix
    ratio_rates: Mapping[str, LawPart] = field(default_factory=dict)


@dataclass(frozen=True)
class Wishes:
    """The dynamics that the controlled quantities shall have.

    Attributes
    ----------
    torque_count : int
        The first outputs are torques, the others speeds.
    actuators : tuple of int (m)
        The machine of each output.
    rotors : tuple of Expr (m)
        Inertia of each rotor (kg m^2); a speed becomes ``1 / (I_m s)``.
    estimates : tuple of Expr (n_t)
        Inertia that each torque-controlled machine swings with (kg m^2).
    damping : tuple of Expr (n_t)
        Damping that each torque gets (N m s/rad).
    stiffness : tuple of Expr (n_t)
        Natural stiffness that it keeps (N m/rad); a torque becomes ``c / (I s^2 + d s + c)``.
    feedthrough : tuple of Matrix (1, n_f)
        Friction torques that are part of each controlled torque.
    """

    torque_count: int
    actuators: tuple[int, ...]
    rotors: tuple[sp.Expr, ...]
    estimates: tuple[sp.Expr, ...]
    damping: tuple[sp.Expr, ...]
    stiffness: tuple[sp.Expr, ...]
    feedthrough: tuple[sp.Matrix, ...]


def decoupling_state_law(
    system: AffineSystem,
    chains: Sequence[OutputChain],
    matrix: sp.Matrix,
    wishes: Wishes,
    rates: Mapping[sp.Symbol, sp.Symbol] | None = None,
) -> StateLaw:
    """Solve ``D u = w - L_a^delta c`` (5.31), (5.34).

    Parameters
    ----------
    system : AffineSystem
    chains : sequence of OutputChain
        The controlled quantities with their derivatives.
    matrix : Matrix (m, m)
        The decoupling matrix (5.29), regular.
    wishes : Wishes
    rates : mapping of Symbol to Symbol, optional
        The rate of each ratio that changes at run time; terms of higher order in them are left out.
    """
    m, n, n_f = len(chains), system.order, system.F.shape[1]
    want_v, want_x, want_T = sp.zeros(m, m), sp.zeros(m, n), sp.zeros(m, n_f)
    for index, chain in enumerate(chains):
        if index < wishes.torque_count:
            a0 = wishes.stiffness[index] / wishes.estimates[index]
            a1 = wishes.damping[index] / wishes.estimates[index]
            want_v[index, index] = a0
            want_x[index, :] = -a0 * chain.rows[0] - a1 * chain.rows[1]
            want_T[index, :] = -a0 * wishes.feedthrough[index]
        else:
            want_v[index, index] = 1 / wishes.rotors[wishes.actuators[index]]
    drift = exact.stack([chain.rows[-1] for chain in chains], n)
    disturbance = exact.stack([chain.disturbance_row for chain in chains], n_f)
    at_rest = dict.fromkeys((rates or {}).values(), sp.Integer(0))

    def solved(right: sp.Matrix) -> sp.Matrix:
        return exact.solve(matrix, right)

    full_x, full_T = want_x - drift, want_T - disturbance
    constant = solved(sp.Matrix.hstack(want_v, full_x.subs(at_rest), full_T.subs(at_rest)))
    parts = {}
    for ratio, rate in (rates or {}).items():
        slope = solved(sp.Matrix.hstack(full_x.diff(rate).subs(at_rest), full_T.diff(rate).subs(at_rest)))
        parts[ratio.name] = LawPart(slope[:, :n], slope[:, n:])
    return StateLaw(constant[:, :m], constant[:, m : m + n], constant[:, m + n :], parts)

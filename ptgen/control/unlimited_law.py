r"""The commands of the emitted control law without their limits, as functions of the references: (7.42) for any bed.

The statements of the control law are substituted into each other with the clamps of the envelope taken away, so what
comes out holds everything that they do: gains, switches, observers, torque models, losses, whatever the bed. It is
affine in the references,

.. math:: u(\tilde r) = u(r_0) + D\,(\tilde r - r_0),

over signals that are known before the law runs. Measured torques are among these, and with them the measured
disturbance.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ptgen.block.block import Assign, Statement
from ptgen.control.envelope import Envelope
from ptgen.control.writer import signal_symbol

__all__ = ["UnlimitedLaw", "unlimited_law"]


@dataclass(frozen=True)
class UnlimitedLaw:
    """Commands over references, signals that are known before the control law runs, and commands that come earlier.

    Attributes
    ----------
    references : tuple of Symbol (m)
    symbols : tuple of Symbol (m)
        The commands.
    order : tuple of int (m)
        In which they are computed: a command may hold those before it.
    commands : tuple of Expr (m)
        What each command is (N m).
    within : tuple of tuple (m)
        For each machine pairs of a share of its envelope and an expression over the same symbols: the law limits the
        expression to that share before it adds the rest to the command.
    estimates : mapping of str to Expr
        The testing torques as the law estimates them, over the same symbols.
    reads : frozenset of str
        Everything that commands and memory of the law depend on.
    """

    references: tuple[sp.Symbol, ...]
    symbols: tuple[sp.Symbol, ...]
    order: tuple[int, ...]
    commands: tuple[sp.Expr, ...]
    within: tuple[tuple[tuple[sp.Expr, sp.Expr], ...], ...]
    estimates: Mapping[str, sp.Expr]
    reads: frozenset[str]

    @property
    def gain(self) -> sp.Matrix:
        r"""What a change of each reference does to each command in the same step, D of (7.29), (m, m).

        Raises
        ------
        ValueError
            If a command is not affine in the references.
        """
        gain = sp.zeros(len(self.commands), len(self.references))
        for machine in self.order:
            gain[machine, :] = self._slope(self.commands[machine], gain)
        if gain.free_symbols & {*self.references, *self.symbols}:
            raise ValueError("the control law is not affine in its references")
        return gain

    def _slope(self, expression: sp.Expr, gain: sp.Matrix) -> sp.Matrix:
        """Return the derivative of an expression if the commands that it holds have that gain."""
        slope = sp.Matrix([[expression.diff(reference) for reference in self.references]])
        for k, symbol in enumerate(self.symbols):
            slope += expression.diff(symbol) * gain[k, :]
        return slope


def unlimited_law(
    statements: Sequence[Statement],
    envelopes: Sequence[Envelope],
    references: Sequence[sp.Symbol],
    commands: Sequence[sp.Symbol],
    estimates: Sequence[str] = (),
) -> UnlimitedLaw:
    """Substitute the statements of a control law into each other, without limits.

    Parameters
    ----------
    statements : sequence of Statement
        From the references to the commands; those with a condition are passed over: they start the block anew.
    envelopes : sequence of Envelope (m)
    references, commands : sequence of Symbol (m)
    estimates : sequence of str
        Assigned in the statements too.

    Raises
    ------
    ValueError
        If a command depends on a kernel, or on the references other than by an affine function.
    """
    table: dict[sp.Symbol, sp.Expr] = {}
    found: dict[sp.Symbol, sp.Expr] = {}
    within: dict[int, list[tuple[sp.Expr, sp.Expr]]] = {k: [] for k in range(len(envelopes))}
    for statement in _needed(statements, {*estimates, *(symbol.name for symbol in commands)}):
        target, expression = signal_symbol(statement.target), statement.expression
        for machine, envelope in enumerate(envelopes):
            expression, clamped = envelope.opened(expression)
            if target not in commands:
                within[machine] += [(share, torque.xreplace(table)) for share, torque in clamped]
        expression = expression.xreplace(table)
        if target in commands:
            found[target] = expression
            table.pop(target, None)
        else:
            table[target] = expression
    return UnlimitedLaw(
        tuple(references),
        tuple(commands),
        tuple(commands.index(symbol) for symbol in found),
        tuple(found[symbol] for symbol in commands),
        tuple(tuple(within[machine]) for machine in range(len(envelopes))),
        {name: table[signal_symbol(name)] for name in estimates},
        frozenset(symbol.name for s in statements if isinstance(s, Assign) for symbol in s.free_symbols),
    )


def _needed(statements: Sequence[Statement], wanted: set[str]) -> list[Assign]:
    """Return the assignments that lead to the wanted targets, in their order."""
    wanted, kept = set(wanted), []
    for statement in reversed(statements):
        if not isinstance(statement, Assign):
            if wanted & set(statement.outputs):
                raise ValueError(f"the kernel {statement.kernel} stands between references and commands")
            continue
        if statement.condition is not None or statement.target not in wanted:
            continue
        wanted.discard(statement.target)
        wanted |= {symbol.name for symbol in statement.free_symbols}
        kept.append(statement)
    return kept[::-1]

"""The equations of motion of a model, one per coordinate, in the form that people know them in.

Shafts stand in them as torques ``T(shaft)``, with an equation of their own, so that each balance of torques fits
one line. Without a one-to-one relation of shafts and twists the torques belong to the twists.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import sympy as sp

from ptgen.elements import Friction
from ptgen.mechanism.model import Model
from ptgen.report.formulas import Equation, Kind, Term, terms_of

__all__ = ["Motion", "Slip", "motion"]

_LONGEST = 9
"""Operations in a coefficient from which on it gets a name of its own."""


@dataclass(frozen=True)
class Slip:
    """A friction element: its relative velocity, and its torque while it slips.

    Attributes
    ----------
    friction : Friction
    velocity : tuple of Term
        The relative velocity ``w``.
    """

    friction: Friction
    velocity: tuple[Term, ...]


@dataclass(frozen=True)
class Motion:
    """Equations of motion.

    Attributes
    ----------
    balances : tuple of Equation
        Torque balance of every coordinate.
    shafts : tuple of Equation
        Torque of every shaft, or twist.
    twists : tuple of Equation
        Rate of every twist.
    slips : tuple of Slip
        The friction elements.
    abbreviations : dict of Symbol to Expr
        Long coefficients, which the equations name ``k_1``, ``k_2``, ...
    """

    balances: tuple[Equation, ...]
    shafts: tuple[Equation, ...]
    twists: tuple[Equation, ...]
    slips: tuple[Slip, ...]
    abbreviations: dict[sp.Symbol, sp.Expr]


def motion(model: Model, orientation: Mapping[str, int] | None = None) -> Motion:
    """Write the equations of motion of a model.

    Parameters
    ----------
    model : Model
    orientation : mapping of str to int, optional
        Component to the sign that makes the torque of its shaft positive when it drives the right-hand neighbour,
        as the sensors have it.
    """
    by_spring = len(model.spring_rows) == len(model.twists)
    names = tuple(model.spring_rows) if by_spring else model.twists
    signs = [(orientation or {}).get(name.partition(".")[0], 1) if by_spring else 1 for name in names]
    springs = [model.spring_rows[name] for name in names] if by_spring else []
    twist_rows = sp.Matrix.vstack(*springs) if springs else sp.eye(len(model.twists))
    twist_rows = sp.diag(*signs) * twist_rows if signs else twist_rows
    rates = twist_rows * model.twist_rows
    frictions = [friction.name for friction in model.frictions]
    machines = [torque.name for torque in model.inputs]
    short = _Abbreviations()
    balances = []
    for index in range(len(model.coordinates)):
        right = (
            *terms_of(model.input_rows[:, index], Kind.AIR_GAP, machines),
            *terms_of(rates[:, index], Kind.SHAFT, names, -1),
            *terms_of(model.friction_rows[:, index], Kind.FRICTION, frictions, -1),
        )
        left = terms_of(model.mass[index, :], Kind.ACCELERATION, model.coordinates)
        balances.append(Equation(short.terms(left), short.terms(right)))
    shafts = []
    for index, name in enumerate(names):
        if by_spring:
            stiffness = model.spring_stiffness[name] * twist_rows[index, :]
            damping = model.spring_damping[name] * twist_rows[index, :]
        else:
            stiffness, damping = model.stiffness[index, :], model.damping[index, :]
        right = (
            *terms_of(stiffness, Kind.TWIST, model.twists),
            *terms_of(damping, Kind.RATE, model.twists),
        )
        shafts.append(Equation((Term(sp.Integer(1), Kind.SHAFT, name),), short.terms(right)))
    twists = tuple(
        Equation(
            (Term(sp.Integer(1), Kind.RATE, name),),
            short.terms(terms_of(model.twist_rows[index, :], Kind.VELOCITY, model.coordinates)),
        )
        for index, name in enumerate(model.twists)
    )
    slips = tuple(
        Slip(friction, short.terms(terms_of(model.friction_rows[index, :], Kind.VELOCITY, model.coordinates)))
        for index, friction in enumerate(model.frictions)
    )
    return Motion(tuple(balances), tuple(shafts), twists, slips, short.definitions)


class _Abbreviations:
    """Names for long coefficients; the same coefficient gets the same name, whatever its sign."""

    def __init__(self) -> None:
        self._names: dict[sp.Expr, sp.Symbol] = {}

    @property
    def definitions(self) -> dict[sp.Symbol, sp.Expr]:
        return {symbol: expression for expression, symbol in self._names.items()}

    def terms(self, terms: Iterable[Term]) -> tuple[Term, ...]:
        return tuple(Term(self._short(term.coefficient), term.kind, term.name, term.note) for term in terms)

    def _short(self, coefficient: sp.Expr) -> sp.Expr:
        if sp.count_ops(coefficient) <= _LONGEST:
            return coefficient
        for known, symbol in self._names.items():
            if sp.cancel(known - coefficient) == 0:
                return symbol
            if sp.cancel(known + coefficient) == 0:
                return -symbol
        symbol = sp.Symbol(f"k_{len(self._names) + 1}", real=True)
        self._names[coefficient] = symbol
        return symbol

"""Evaluation of scalar expressions over any arithmetic that has the usual operators."""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import And, Not, Or

__all__ = ["Arithmetic", "evaluate"]


@dataclass(frozen=True)
class Arithmetic:
    """The functions that operators alone do not give.

    `select(condition, a, b)` is a where the condition holds, else b; the others are as in NumPy.
    """

    absolute: Callable[[Any], Any]
    minimum: Callable[[Any, Any], Any]
    maximum: Callable[[Any, Any], Any]
    select: Callable[[Any, Any, Any], Any]
    exponential: Callable[[Any], Any]
    sine: Callable[[Any], Any]
    floor: Callable[[Any], Any]
    sign: Callable[[Any], Any]
    root: Callable[[Any], Any]
    both: Callable[[Any, Any], Any]
    either: Callable[[Any, Any], Any]
    negate: Callable[[Any], Any]


_RELATIONS = {
    ">": operator.gt,
    ">=": operator.ge,
    "<": operator.lt,
    "<=": operator.le,
    "==": operator.eq,
    "!=": operator.ne,
}


def evaluate(expression: Any, table: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
    """Evaluate `expression`; `table` gives the value of each symbol by name.

    Raises
    ------
    TypeError
        If the expression contains a function that blocks do not have.
    """

    def visit(node: Any) -> Any:
        if node.is_Symbol:
            return table[node.name]
        if node.is_Number:
            return float(node)
        arguments = node.args
        if node.is_Add:
            return functools.reduce(operator.add, map(visit, arguments))
        if node.is_Mul:
            numerator, denominator = sp.fraction(node, exact=True)
            if denominator != 1:
                return visit(numerator) / visit(denominator)
            return functools.reduce(operator.mul, map(visit, arguments))
        if node.is_Pow:
            base, exponent = visit(arguments[0]), arguments[1]
            if exponent.is_Integer:
                power = functools.reduce(operator.mul, [base] * abs(int(exponent)))
                return power if exponent > 0 else 1.0 / power
            if exponent == sp.Rational(1, 2):
                return arithmetic.root(base)
            return base ** float(exponent)
        if isinstance(node, sp.Piecewise):
            value = visit(arguments[-1][0])
            for branch, condition in reversed(arguments[:-1]):
                value = arithmetic.select(visit(condition), visit(branch), value)
            return value
        if isinstance(node, Relational):
            return _RELATIONS[node.rel_op](visit(node.lhs), visit(node.rhs))
        folded = {
            sp.Min: arithmetic.minimum,
            sp.Max: arithmetic.maximum,
            And: arithmetic.both,
            Or: arithmetic.either,
        }
        if type(node) in folded:
            return functools.reduce(folded[type(node)], map(visit, arguments))
        single = {
            sp.Abs: arithmetic.absolute,
            sp.exp: arithmetic.exponential,
            sp.sin: arithmetic.sine,
            sp.floor: arithmetic.floor,
            sp.sign: arithmetic.sign,
            Not: arithmetic.negate,
        }
        if type(node) in single:
            return single[type(node)](visit(arguments[0]))
        raise TypeError(f"blocks have no function {type(node).__name__}")

    return visit(sp.sympify(expression))

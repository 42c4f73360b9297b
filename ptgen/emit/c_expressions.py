"""Scalar expressions as C."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import precedence

__all__ = ["CExpressions", "Precision", "literal"]

Precision = Literal["double", "float"]


def literal(value: float, precision: Precision) -> str:
    """Return a constant that reads back as the same number.

    Examples
    --------
    >>> literal(0.1, "double"), literal(2, "float")
    ('0.1', '2.0f')
    """
    text = repr(float(value))
    return text + "f" if precision == "float" else text


class CExpressions(C99CodePrinter):  # type: ignore[misc]
    """Prints expressions; the place of each symbol is looked up.

    Parameters
    ----------
    prefix : str
        Prefix of the support functions.
    precision : {"double", "float"}
    place : callable
        Gives the C expression of a symbol's name.
    """

    def __init__(self, prefix: str, precision: Precision, place: Callable[[str], str]) -> None:
        super().__init__()
        self._prefix_name = prefix
        self._precision: Precision = precision
        self._place = place

    def _print_Symbol(self, expr: Any) -> str:
        return self._place(expr.name)

    def _print_Integer(self, expr: Any) -> str:
        return literal(float(expr), self._precision)

    def _print_Float(self, expr: Any) -> str:
        return literal(float(expr), self._precision)

    def _print_Rational(self, expr: Any) -> str:
        return literal(float(expr), self._precision)

    def _print_Zero(self, expr: Any) -> str:
        return literal(0.0, self._precision)

    def _print_One(self, expr: Any) -> str:
        return literal(1.0, self._precision)

    def _print_Half(self, expr: Any) -> str:
        return literal(0.5, self._precision)

    def _print_NegativeOne(self, expr: Any) -> str:
        return literal(-1.0, self._precision)

    def _print_Pow(self, expr: Any) -> str:
        base, exponent = expr.args
        if exponent.is_Integer:
            factor = self.parenthesize(base, precedence(sp.Symbol("a") * sp.Symbol("b")) + 1)
            product = "*".join([factor] * abs(int(exponent)))
            if exponent > 0:
                return f"({product})" if abs(int(exponent)) > 1 else product
            return (
                f"{literal(1.0, self._precision)}/({product})"
                if exponent < -1
                else f"{literal(1.0, self._precision)}/{factor}"
            )
        if exponent == sp.Rational(1, 2):
            return f"{self._prefix_name}_sqrt({self._print(base)})"
        return f"{self._prefix_name}_pow({self._print(base)}, {self._print(exponent)})"

    def _fold(self, function: str, arguments: Any) -> str:
        texts = [self._print(argument) for argument in arguments]
        while len(texts) > 1:  # in pairs: a chain would wait for each of its links
            pairs = [
                f"{self._prefix_name}_{function}({', '.join(texts[k : k + 2])})" for k in range(0, len(texts) - 1, 2)
            ]
            texts = pairs + texts[2 * len(pairs) :]
        result: str = texts[0]
        return result

    def _print_Min(self, expr: Any) -> str:
        return self._fold("min", expr.args)

    def _print_Max(self, expr: Any) -> str:
        return self._fold("max", expr.args)

    def _print_Abs(self, expr: Any) -> str:
        return f"{self._prefix_name}_abs({self._print(expr.args[0])})"

    def _print_exp(self, expr: Any) -> str:
        return f"{self._prefix_name}_exp({self._print(expr.args[0])})"

    def _print_sin(self, expr: Any) -> str:
        return f"{self._prefix_name}_sin({self._print(expr.args[0])})"

    def _print_floor(self, expr: Any) -> str:
        return f"{self._prefix_name}_floor({self._print(expr.args[0])})"

    def _print_sign(self, expr: Any) -> str:
        return f"{self._prefix_name}_sign({self._print(expr.args[0])})"

    def _print_Piecewise(self, expr: Any) -> str:
        text: str = self._print(expr.args[-1][0])
        for branch, condition in reversed(expr.args[:-1]):
            text = f"{self._prefix_name}_select({self._print(condition)}, {self._print(branch)}, {text})"
        return text

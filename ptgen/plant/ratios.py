"""Gear ratios that change at run time: where they stand in the plant, and what all of their range must allow."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from ptgen.block.block import Assign, Statement
from ptgen.mechanism.model import Model

__all__ = ["NOW", "corners", "with_ratios_of_now"]

NOW = "_now"
"""What is appended to the name of a ratio: the state that holds what the plant was prepared for last."""


def corners(model: Model) -> list[Model]:
    """Return the model with its ratios as they are at the start, and in each corner of their ranges."""
    spans = [parameter.span for parameter in model.changing if parameter.span is not None]
    if not spans:
        return [model]
    names = [parameter.symbol for parameter in model.changing]
    result = [model]
    for values in itertools.product(*spans):
        at = dict(zip(names, values, strict=True))
        parameters = tuple(replace(p, value=at.get(p.symbol, p.value)) for p in model.parameters)
        result.append(replace(model, parameters=parameters))
    return result


def with_ratios_of_now(model: Model, statements: Sequence[Statement]) -> tuple[Statement, ...]:
    """Return the statements with the states that hold the ratios in place of the ratios."""
    now = {p.symbol: sp.Symbol(f"{p.symbol.name}{NOW}", real=True) for p in model.changing}
    if not now:
        return tuple(statements)
    return tuple(
        replace(statement, expression=sp.sympify(statement.expression).xreplace(now))
        if isinstance(statement, Assign)
        else statement
        for statement in statements
    )

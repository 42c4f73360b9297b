"""Gear ratios that change at run time: where they stand in the plant, and what all of their range must allow."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from ptgen.block.block import Assign, Statement
from ptgen.mechanism.model import Model

__all__ = ["NOW", "corners", "quick_ratios", "with_ratios_of_now"]

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


def quick_ratios(model: Model) -> set[sp.Symbol]:
    """Return the ratios that change at run time and stand in the rows of friction elements only.

    The solution of the linear part over a step does not depend on them: they only say how the torques of these elements
    act, and what their velocities are. What is measured through a low pass is a part of the linear system, so it must
    not depend on these torques directly either.
    """
    changing = {parameter.symbol for parameter in model.changing}
    slow: set[sp.Basic] = set()
    matrices = [model.mass, model.twist_rows, model.stiffness, model.damping, model.input_rows, model.contact_rows]
    matrices += [model.fluid_rows, model.contact_twists, *model.velocity_rows.values(), *model.spring_rows.values()]
    rows = [model.friction_rows[i, :] for i in range(len(model.frictions))]
    matrices += [row for row, friction in zip(rows, model.frictions, strict=True) if friction.linear_viscous != 0]
    matrices += [form.a for form in model.signals.values()]
    filtered = [model.signals[sensor.name] for sensor in model.sensors if sensor.time_constant is not None]
    for form in filtered:
        matrices += [form.z, form.e, form.u, form.f]
        matrices += [row for i, row in enumerate(rows) if form.f[i] != 0 or form.needs_acceleration]
    for matrix in matrices:
        slow |= matrix.free_symbols
    return changing - slow


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

r"""A component in one of its gears: what sticks is rigid, and so are its shafts.

With the rows :math:`A` of constraints, shafts and sticking elements the velocities are :math:`v = N z`,
:math:`A N = 0`. If that ties input and output together, there is a ratio between them; the inertia seen at the input
is twice the least kinetic energy with :math:`\omega_{input} = 1`, so what the gear leaves free stands still.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np
import scipy.linalg
import sympy as sp

from ptgen.components.component import Component
from ptgen.elements import Row

__all__ = ["Engaged", "engaged"]

_ZERO = 1e-9


@dataclass(frozen=True)
class Engaged:
    """A component in a gear.

    Attributes
    ----------
    ratio : float or None
        Input speed over output speed; None if the two are not tied together, or one of them is held.
    inertia : float
        Seen at the input (kg m^2); of all that turns with it.
    """

    ratio: float | None
    inertia: float


def engaged(component: Component, elements: Collection[str], ratio: float | None = None) -> Engaged:
    """Return ratio and inertia of a component while friction elements of it stick.

    Parameters
    ----------
    component : Component
        With flanges ``input`` and ``output``.
    elements : collection of str
        Friction elements, without the component's name and its dot.
    ratio : float, optional
        What ratios that change at run time are now; without elements it ties input and output together by itself.
    """
    name = "gear"
    parts, parameters = component.elements(name), component.parameters(name)
    given = {p.symbol: p.value if p.span is None or ratio is None else ratio for p in parameters}
    values = {symbol: sp.Float(value, 17) for symbol, value in given.items()}
    one = sp.Integer(1)
    rows: list[Row] = [*(item.row for item in parts.constraints), *(item.row for item in parts.springs)]
    rows += [friction.row for friction in parts.frictions if friction.name[len(name) + 1 :] in elements]
    rows += [{left: one, right: -one} for left, right in getattr(parts, "connections", ())]
    flanges = [f"{name}.input", f"{name}.output"]
    if ratio is not None and not elements:
        rows.append({flanges[0]: one, flanges[1]: -sp.Float(ratio)})
    inner = {velocity for row in rows for velocity in row} | {body.velocity for body in parts.bodies}
    names = list(dict.fromkeys([*flanges, *sorted(inner)]))
    matrix = np.array([[_value(row.get(velocity, sp.Integer(0)), values) for velocity in names] for row in rows])
    N = scipy.linalg.null_space(matrix, rcond=_ZERO) if len(rows) else np.eye(len(names))
    _, size, directions = np.linalg.svd(N[:2])
    if (size > _ZERO).sum() != 1 or min(abs(N[:2] @ directions[0])) < _ZERO:
        return Engaged(None, 0.0)
    input_, output = N[:2] @ directions[0]
    inertia = np.zeros(len(names))
    for body in parts.bodies:
        inertia[names.index(body.velocity)] += _value(body.inertia, values)
    weighted = np.sqrt(inertia)[:, None] * N
    start, free = directions[0] / input_, directions[1:].T
    rest, *_ = np.linalg.lstsq(weighted @ free, -weighted @ start, rcond=None)
    motion = weighted @ (start + free @ rest)
    return Engaged(float(input_ / output), float(motion @ motion))


def _value(expression: sp.Expr, values: Mapping[sp.Symbol, sp.Float]) -> float:
    return float(sp.sympify(expression).xreplace(values))

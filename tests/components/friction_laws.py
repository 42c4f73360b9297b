"""Friction laws in numbers, written down from Sections 3.5, 3.6.3 and 3.8 of the source."""

from __future__ import annotations

import math
from collections.abc import Mapping

import sympy as sp

from ptgen.elements import Friction

__all__ = ["limit_of", "torque_of"]


def torque_of(
    friction: Friction, values: Mapping[sp.Symbol, float], w: float, angle: float, load: float, actuation: float
) -> float:
    """Return the torque of an element that slips with w: (3.12), (3.34), (3.35), swelling and saturation."""
    mu = actuation if friction.actuated else 1.0
    level = values[friction.coulomb] + _load(friction, values, load)
    if friction.stribeck_speed is not None:
        peak = values[friction.static] - values[friction.coulomb]
        level += peak * math.exp(-abs(w) / values[friction.stribeck_speed])
    level *= _swell(friction, values, angle)
    if friction.saturated is not None:
        level += values[friction.saturated.slope] * min(abs(w), values[friction.saturated.speed])
    viscous = float(sp.sympify(friction.viscous).subs(values))
    return mu * (math.copysign(level, w) + viscous * w)


def limit_of(
    friction: Friction, values: Mapping[sp.Symbol, float], angle: float, load: float, actuation: float
) -> float:
    """Return the largest torque that an element holds at rest: (4.2) with the actuation."""
    mu = actuation if friction.actuated else 1.0
    static = values[friction.coulomb] if friction.static is None else values[friction.static]
    return mu * _swell(friction, values, angle) * (static + _load(friction, values, load))


def _load(friction: Friction, values: Mapping[sp.Symbol, float], load: float) -> float:
    return 0.0 if friction.load is None else values[friction.load.coefficient] * abs(load)


def _swell(friction: Friction, values: Mapping[sp.Symbol, float], angle: float) -> float:
    if friction.ripple is None:
        return 1.0
    return 1.0 + values[friction.ripple.amplitude] * math.sin(
        friction.ripple.order * angle + values[friction.ripple.phase]
    )

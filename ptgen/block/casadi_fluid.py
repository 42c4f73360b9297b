"""Torques of a fluid for the CasADi evaluator: `ptgen.friction.fluid` without branches."""

from __future__ import annotations

from typing import Any

import casadi as ca

from ptgen.friction.fluid import FASTER, ROWS

__all__ = ["fluid_torques"]

_LARGEST = 1e300


def fluid_torques(pump: Any, turbine: Any, knots: Any, curves: Any) -> tuple[Any, Any]:
    """Return the torque that a fluid takes from the pump, and the one that it exerts on the turbine."""
    n = knots.shape[0]
    by_turbine = ca.fabs(turbine) > ca.fabs(pump)
    leading, other = ca.if_else(by_turbine, turbine, pump), ca.if_else(by_turbine, pump, turbine)
    square = leading * leading
    turning = ca.logic_and(square > 0, square + other < _LARGEST)
    share = other / ca.if_else(turning, leading, 1.0)
    sector = by_turbine + 2 * ca.logic_and(turning, leading < 0)
    c, beyond = curves[:, 0], share - knots[0, 0]
    for s in range(4):
        for k in range(n):
            inside = share >= knots[k, s] if k else sector == s
            inside = ca.logic_and(sector == s, inside)
            c = ca.if_else(inside, curves[:, s * n + k], c)
            beyond = ca.if_else(inside, share - knots[k, s], beyond)
    faster, slower = _polynomial(c[:FASTER], beyond), _polynomial(c[FASTER:ROWS], beyond)
    scale = ca.if_else(turning, square, 0.0)
    return scale * ca.if_else(by_turbine, slower, faster), scale * ca.if_else(by_turbine, faster, slower)


def _polynomial(coefficients: Any, x: Any) -> Any:
    result = coefficients[-1]
    for k in range(coefficients.shape[0] - 2, -1, -1):
        result = result * x + coefficients[k]
    return result

"""The proof of stability as plain data: what the command line prints as JSON."""

from __future__ import annotations

import math
from typing import Any

import sympy as sp

from ptgen.analysis.characteristic import Factor
from ptgen.analysis.continuous_proof import AdmissibleGain, ContinuousProof, ProvenFactor, Setting

__all__ = ["stability_json"]


def stability_json(proof: ContinuousProof) -> dict[str, Any]:
    """Return a proof; formulas are texts that sympy reads, numbers are in SI units, no bound is null."""
    return {
        "states": list(proof.loop.states),
        "matrix": [[sp.sstr(entry) for entry in proof.loop.A[row, :]] for row in range(proof.loop.A.rows)],
        "speed_control": {loop.machine: loop.kind.value for loop in proof.loop.loops if loop.kind.value != "torque"},
        "polynomial": [_factor(factor) for factor in proof.switched],
        "settings": {setting.name: _setting(setting) for setting in proof.settings},
    }


def _setting(setting: Setting) -> dict[str, Any]:
    return {
        "fixed": {symbol.name: value for symbol, value in setting.fixed.items()},
        "verdict": setting.verdict.name.lower(),
        "factors": [_proven(proven, setting) for proven in setting.factors],
    }


def _factor(factor: Factor) -> dict[str, Any]:
    return {
        "loops": list(factor.loops),
        "degree": factor.degree,
        "coefficients": [sp.sstr(value) for value in factor.coefficients],
    }


def _proven(proven: ProvenFactor, setting: Setting) -> dict[str, Any]:
    values = {symbol: setting.values[symbol] for symbol in _symbols(proven.factor)}
    numbers = proven.factor.numbers(values)
    at = {symbol: numbers[proven.factor.degree - int(symbol.name[2:])] for symbol in proven.abbreviations}
    conditions = None
    if proven.conditions is not None:
        conditions = [
            {
                "expression": sp.sstr(condition.expression),
                "origin": condition.origin,
                "value": float(condition.expression.subs(at or values)),
            }
            for condition in proven.conditions
        ]
    return _factor(proven.factor) | {
        "values": [float(value) for value in numbers],
        "conditions": conditions,
        "gains": [_gain(gain) for gain in proven.gains],
        "poles": [{"re": float(pole.real), "im": float(pole.imag)} for pole in proven.poles],
        "verdict": proven.verdict.name.lower(),
    }


def _symbols(factor: Factor) -> set[sp.Symbol]:
    return set().union(*(sp.sympify(value).free_symbols for value in factor.coefficients))


def _gain(gain: AdmissibleGain) -> dict[str, Any]:
    lower = gain.closed_form.lower if gain.closed_form is not None else None
    upper = gain.closed_form.upper if gain.closed_form is not None else None
    return {
        "gain": gain.gain.name,
        "value": gain.value,
        "admissible": gain.is_admissible,
        "lower": None if lower is None else sp.sstr(lower),
        "upper": None if upper is None else sp.sstr(upper),
        "real_poles_up_to": None if gain.real_poles is None else sp.sstr(gain.real_poles),
        "intervals": [[None if math.isinf(value) else value for value in pair] for pair in gain.intervals],
    }

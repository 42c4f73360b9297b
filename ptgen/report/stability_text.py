"""The proof of stability as text for the terminal: factors, conditions, admissible gains, verdicts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
import sympy as sp
from numpy.typing import NDArray
from rich.console import RenderableType
from rich.text import Text

from ptgen.analysis.characteristic import Factor
from ptgen.analysis.continuous_proof import AdmissibleGain, ContinuousProof, ProvenFactor, Setting, Verdict
from ptgen.analysis.stability_conditions import GainRange
from ptgen.report.formulas import text_expression

__all__ = ["stability_text"]

_LONGEST = 200
"""Letters of a coefficient that is still shown; what is longer stands in the JSON form."""


_ROUNDING = 1e-6
"""Parts of a pole that are smaller, relative to the largest pole, come from rounding: double poles split up."""


def stability_text(proof: ContinuousProof) -> Iterator[RenderableType]:
    """Yield the proof, setting by setting; formulas must not be wrapped."""
    yield Text(
        "Reduced model with ideal drives and sensors, without sampling. The characteristic polynomial of the closed\n"
        "loop is the product of these factors; where the loops are decoupled, each has a factor of its own."
    )
    shown: dict[tuple[Factor, ...], str] = {}
    for setting in proof.settings:
        yield Text(f"{setting.name} ({_switches(setting)}): {setting.verdict.value}", style="bold")
        factors = tuple(proven.factor for proven in setting.factors)
        if factors in shown:
            yield Text(f"  factors as for {shown[factors]}")
            continue
        shown[factors] = setting.name
        for proven in setting.factors:
            yield from _factor(proven)


def _switches(setting: Setting) -> str:
    return ", ".join(f"{symbol.name} = {value:g}" for symbol, value in setting.fixed.items())


def _factor(proven: ProvenFactor) -> Iterator[Text]:
    factor = proven.factor
    style = {Verdict.STABLE: "", Verdict.NEUTRAL: "yellow", Verdict.UNSTABLE: "bold red"}[proven.verdict]
    yield Text(f"  {factor.name}: {proven.verdict.value}, poles at {_poles(proven.poles)} 1/s", style=style)
    if proven.abbreviations or proven.conditions is None:
        yield from _abbreviated(proven)
    else:
        yield Text(f"      {_polynomial(factor)}")
    bounded = {gain.gain for gain in proven.gains if gain.closed_form is not None}
    for condition in proven.conditions or ():
        if condition.expression in proven.abbreviations or condition.expression.free_symbols & bounded:
            continue
        if condition.expression.is_number:
            yield Text(f"      the {condition.origin} is {text_expression(condition.expression)}: no gain changes that")
            continue
        written = text_expression(condition.expression)
        yield Text(f"      {written if len(written) <= _LONGEST else condition.origin} > 0")
    yield from _gains(proven.gains)


def _abbreviated(proven: ProvenFactor) -> Iterator[Text]:
    """Show a long polynomial by its coefficients, as far as these are short."""
    degree = proven.factor.degree
    yield Text(f"      s{_power(degree)} + " + " + ".join(_term(k) for k in range(degree - 1, -1, -1)))
    for symbol, coefficient in proven.abbreviations.items():
        written = text_expression(coefficient)
        if len(written) <= _LONGEST:
            yield Text(f"      {symbol.name} = {written}")
    if proven.abbreviations:
        yield Text(f"      {', '.join(symbol.name for symbol in proven.abbreviations)} > 0")


def _power(exponent: int) -> str:
    return {1: "", 2: "²", 3: "³"}.get(exponent, f"^{exponent}")


def _term(exponent: int) -> str:
    return f"a_{exponent}" + (f"·s{_power(exponent)}" if exponent else "")


def _polynomial(factor: Factor) -> str:
    """Write a polynomial with descending powers."""
    parts = []
    for k, coefficient in enumerate(factor.coefficients):
        exponent = factor.degree - k
        power = f"s{_power(exponent)}" if exponent else ""
        if coefficient == 0:
            continue
        if coefficient == 1 and power:
            parts.append(power)
            continue
        written = text_expression(coefficient)
        if isinstance(coefficient, sp.Add) and power:
            written = f"({written})"
        parts.append(f"{written}·{power}" if power else written)
    return " + ".join(parts)


def _gains(gains: Sequence[AdmissibleGain]) -> Iterator[Text]:
    written = [_range(gain.closed_form) if gain.closed_form is not None else gain.gain.name for gain in gains]
    width = max((len(text) for text in written), default=0)
    for gain, text in zip(gains, written, strict=True):
        inside = " or ".join(_interval(*pair) for pair in gain.intervals) or "nowhere"
        yield Text(f"      {text:<{width}}   is {gain.value:.5g}, stable {inside}", style="dim")
        if gain.real_poles is not None:
            yield Text(f"        real poles up to {text_expression(gain.real_poles)}", style="dim")


def _range(bounds: GainRange) -> str:
    name = bounds.gain.name
    if bounds.lower is None:
        return f"{name} < {text_expression(bounds.upper)}"
    if bounds.upper is None:
        return f"{name} > {text_expression(bounds.lower)}"
    return f"{text_expression(bounds.lower)} < {name} < {text_expression(bounds.upper)}"


def _interval(low: float, high: float) -> str:
    if math.isinf(low) and math.isinf(high):
        return "everywhere"
    if math.isinf(high):
        return f"above {low:.5g}"
    if math.isinf(low):
        return f"below {high:.5g}"
    return f"from {low:.5g} to {high:.5g}"


def _poles(poles: NDArray[np.complex128]) -> str:
    """Write poles once per conjugate pair, the slowest first."""
    size = float(np.max(np.abs(poles), initial=0.0))
    upper = [pole for pole in poles if pole.imag >= -_ROUNDING * size]
    written = []
    for pole in sorted(upper, key=lambda pole: (abs(pole), pole.real)):
        real = f"{_small(pole.real, size):.4g}"
        written.append(real if abs(pole.imag) <= _ROUNDING * size else f"{real} ± {pole.imag:.4g}j")
    return ", ".join(written)


def _small(value: float, size: float) -> float:
    return 0.0 if abs(value) <= _ROUNDING * size else float(value)

r"""Ratios that change while the bed runs: inputs, limited in range and rate, and what their rate adds to the law.

The law holds at every moment with the ratio of that moment; a ratio that changes adds :math:`\dot i` times a
combination of speeds (5.46), (5.62). The rate is that of the limited ratio, ``(i - i_before) / h``, so it is what the
limiter lets through and never more than ``<ratio>_rate``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ptgen.control.decoupling import Decoupling
from ptgen.control.ratio_estimate import ratio_source
from ptgen.control.references import limited
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of

__all__ = ["SHIFT_TIME", "changing_ratios", "ratio_bounds", "ratio_inputs"]

SHIFT_TIME = 0.5
"""Time (s) in which a ratio passes through its whole range, unless the parameter says otherwise."""

_PLAUSIBLE = 1.5


def ratio_inputs(design: Decoupling) -> list[str]:
    """Return the inputs for ratios that change and that the law needs."""
    return [parameter.symbol.name for parameter in design.model.changing if _is_used(design, parameter.symbol)]


def ratio_bounds(design: Decoupling) -> dict[str, float]:
    """Return the largest plausible value of each of them; within it they are limited to their range."""
    spans = {parameter.symbol.name: parameter.span for parameter in design.model.changing}
    return {name: _PLAUSIBLE * max(map(abs, spans[name] or (1.0,))) for name in ratio_inputs(design)}


def changing_ratios(
    w: ControllerWriter, measured: Mapping[str, sp.Symbol], gears: Mapping[str, Sequence[float]]
) -> tuple[dict[str, sp.Expr], sp.Expr]:
    """Write the limits of all changing ratios, let the law use what they leave, and return their rates (1/s).

    Returned too is a factor from 0 to 1 for all dampings: how sure the ratios are, see `RatioSource`.

    Parameters
    ----------
    w : ControllerWriter
    measured : mapping of str to Symbol
    gears : mapping of str to sequence of float
        Ratios of the gears of a component, by its name; with them its ratio can be estimated.
    """
    rates: dict[str, sp.Expr] = {}
    sure: sp.Expr = sp.Integer(1)
    names = ratio_inputs(w.design)
    for parameter in w.design.model.changing:
        name, span = parameter.symbol.name, parameter.span
        if name not in names or span is None:
            continue
        least = w.parameter(f"{name}_least", "", f"least {name}", span[0], None, allowed=False)
        most = w.parameter(f"{name}_most", "", f"largest {name}", span[1], None, allowed=False)
        inside = w.assign(
            f"{name}_inside", greatest_of(least, smallest_of(most, measured[name])), "range and rate of the ratio"
        )
        source = None
        if (ratios := gears.get(name.removesuffix("_ratio"))) is not None:
            source = ratio_source(w, parameter.symbol, inside, ratios, measured)
        chosen = inside if source is None else source.ratio
        now = limited(w, name, "", chosen, chosen, float(f"{(span[1] - span[0]) / SHIFT_TIME:.6g}"), here=True)
        if any(entry != 0 for entry in w.design.law.ratio_rates.get(name, ())):
            per_step = w.derive("steps_per_second", "1/s", "one over the step", 1 / signal_symbol("sample_time"))
            change = (now - signal_symbol(f"{name}_before")) * per_step
            rates[name] = w.assign(f"{name}_change", change if source is None else source.known * change)
        w.run_time[name] = now
        sure = sure if source is None else sure * source.sure
    return rates, sure


def _is_used(design: Decoupling, symbol: sp.Symbol) -> bool:
    law = design.law
    parts = [law.P, law.R, law.R_losses, law.estimate_sensors, law.estimate_virtual, law.estimate_losses]
    parts += [loss.speed for loss in law.known_losses]
    return symbol.name in law.ratio_rates or any(part.has(symbol) for part in parts)

r"""The ratio of a transmission that shifts by itself, estimated from the speeds of the machines (source Section 5.4.1).

Without twist :math:`\omega_1 = i\,\omega_2`. The twist whose row holds the ratio is solved for it, over the measured
speeds of all machines, so gears between machine and transmission, and several machines behind it, are taken in:

.. math:: \hat i = \omega_1 / \omega_2 \quad\text{while } |\omega_2| \ge \omega_{least}, \text{ else as it was}

within the range of the gears, behind a low pass of ``<ratio>_estimate_time``. Once it has stayed within
``<ratio>_tolerance`` of the ratio of a gear for ``<ratio>_settle_time``, it is that ratio exactly, until it is half as
far again from it: in a gear neither noise nor torsional vibrations come through the ratio.

``<ratio>_source`` chooses: 0 the input, 1 the estimate; in between, on the way, their mean. The torque for the rate of
the ratio is that of the input alone: an estimated rate is M1's own acceleration, fed back with a factor of one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import sympy as sp

from ptgen.control.switches import follow
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of
from ptgen.mechanism.model import evaluate_matrix

__all__ = ["RatioSource", "ratio_source"]

ESTIMATE_TIME = 0.02
"""Time constant (s) of the low pass."""

SETTLE_TIME = 0.05
"""Time (s) that the estimate stays at a gear before it is taken for that gear."""

LEAST_SPEED = 0.01
"""Share of the largest speed behind the ratio below which a speed says nothing about it."""

TOLERANCE = 0.02
"""Largest distance from the ratio of a gear, as a share of it; less where gears are close."""


@dataclass(frozen=True)
class RatioSource:
    """A ratio from the input or from the speeds.

    Attributes
    ----------
    ratio : Expr
        What the law shall use, before its rate is limited.
    known : Expr
        The share of the input in it.
    sure : Expr
        From 0 to 1, less than 1 only while it is estimated and the speeds are too small to tell it: then no damping may
        rely on it, which would brake the bed at a ratio that is wrong, and keep it where the ratio cannot be told.
    """

    ratio: sp.Expr
    known: sp.Expr
    sure: sp.Expr


def ratio_source(
    w: ControllerWriter, ratio: sp.Symbol, inside: sp.Symbol, gears: Sequence[float], measured: Mapping[str, sp.Symbol]
) -> RatioSource | None:
    """Write the estimate of a ratio and the choice between it and the input.

    Parameters
    ----------
    w : ControllerWriter
        With the parameters ``<ratio>_least``, ``<ratio>_most`` and ``sample_time``.
    ratio : Symbol
        In the model.
    inside : Symbol
        The input, within its range.
    gears : sequence of float
        The ratios of the gears.
    measured : mapping of str to Symbol

    Returns
    -------
    RatioSource or None
        None if the measured speeds do not tell the ratio.
    """
    speeds = _speeds(w, ratio, measured)
    if speeds is None:
        return None
    name = ratio.name
    text = "switch: 0 the ratio is the input, 1 it is estimated from the speeds"
    w.parameter(f"{name}_source", "", text, 0.0, most=1.0)
    share = follow(w, f"{name}_source").now
    estimate, telling = _estimate(w, name, speeds, inside)
    snapped = _snapped(w, name, estimate, sorted(set(gears)))
    now = w.assign(f"{name}_chosen", (1 - share) * inside + share * snapped, "ratio known or estimated (5.4.1)")
    sure = w.assign(f"{name}_sure", 1 - share * (1 - telling), "near standstill the speeds do not tell the ratio")
    return RatioSource(now, 1 - share, sure)


@dataclass(frozen=True)
class _Speeds:
    """The ratio is `before` over `behind` (rad/s); `largest` is what `behind` can be."""

    before: sp.Expr
    behind: sp.Expr
    largest: float


def _speeds(w: ControllerWriter, ratio: sp.Symbol, measured: Mapping[str, sp.Symbol]) -> _Speeds | None:
    model = w.design.model
    rows = [row for row in model.twist_rows.tolist() if any(ratio in entry.free_symbols for entry in row)]
    rotors = [next(iter(torque.row)) for torque in model.inputs]
    if len(rows) != 1:
        return None
    (row,) = rows
    symbols = {velocity: sp.Dummy(velocity) for velocity in model.coordinates}
    twisting = sp.fraction(sp.together(sum(e * symbols[v] for e, v in zip(row, model.coordinates, strict=True))))[0]
    terms = sp.Poly(twisting, ratio)
    used = [velocity for velocity, symbol in symbols.items() if symbol in twisting.free_symbols]
    sensors = {v: w.speed_sensor(rotors.index(v)) for v in used if v in rotors}
    if terms.degree() != 1 or len(sensors) < len(used) or not set(sensors.values()) <= measured.keys():
        return None
    slope, rest = terms.all_coeffs()
    before, behind, largest = sp.Integer(0), sp.Integer(0), 0.0
    for velocity, sensor in sensors.items():
        weight, other = -sp.diff(slope, symbols[velocity]), sp.diff(rest, symbols[velocity])
        before += w.of_bed(other) * measured[sensor]
        behind += w.of_bed(weight) * measured[sensor]
        most = w.full.values[w.full.inputs[rotors.index(velocity)].drive.speed_max]
        largest += abs(float(evaluate_matrix(sp.Matrix([[weight]]), w.design.values)[0, 0])) * most
    return _Speeds(before, behind, largest)


def _estimate(w: ControllerWriter, name: str, speeds: _Speeds, inside: sp.Symbol) -> tuple[sp.Symbol, sp.Expr]:
    """Return the ratio of the speeds behind its low pass, near standstill as it was; and how far they tell it."""
    text = "ratio from the speeds"
    least = w.parameter(
        f"{name}_least_speed",
        "rad/s",
        f"speed behind the ratio below which {name} is not estimated",
        float(f"{LEAST_SPEED * speeds.largest:.3g}"),
        allowed=False,
    )
    time = w.parameter(f"{name}_estimate_time", "s", f"time constant of the estimate of {name}", ESTIMATE_TIME)
    h = signal_symbol("sample_time")
    share = w.derive(f"{name}_estimate_share", "", f"share of a new value in the estimate of {name}", h / (h + time))
    behind = w.assign(f"{name}_behind", speeds.behind, text)
    turning = sp.Abs(behind) >= least
    divisor = w.assign(f"{name}_divisor", sp.Piecewise((behind, turning), (sp.Integer(1), True)), text)
    limited = greatest_of(
        signal_symbol(f"{name}_least"), smallest_of(signal_symbol(f"{name}_most"), speeds.before / divisor)
    )
    quotient = w.assign(f"{name}_quotient", limited, text)
    estimate = w.state(f"{name}_estimate", "", f"{name} from the speeds, low-passed")
    start = sp.Piecewise((quotient, turning), (inside, True))
    before = w.assign(f"{name}_estimate_before", w.previous(estimate, start, here=True), text)
    change = sp.Piecewise((share * (quotient - before), turning), (sp.Integer(0), True))
    # Full only at twice the least speed, so that the estimate has had the time to follow.
    telling = greatest_of(sp.Integer(0), smallest_of(sp.Integer(1), sp.Abs(behind) / least - 1))
    return w.assign(estimate.name, before + change, text), telling


def _snapped(w: ControllerWriter, name: str, estimate: sp.Symbol, gears: Sequence[float]) -> sp.Symbol:
    """Return the ratio of a gear, once the estimate has settled there, else the estimate."""
    text = "a settled estimate is the ratio of a gear"
    closest = min((b - a) / (2 * max(abs(a), abs(b))) for a, b in pairwise(gears))
    tolerance = w.parameter(
        f"{name}_tolerance",
        "",
        f"distance from the ratio of a gear, as a share of it, within which {name} is taken for that gear",
        float(f"{min(TOLERANCE, 0.4 * closest):.3g}"),
        allowed=False,
        most=float(f"{closest:.6g}"),
    )
    settle = w.parameter(f"{name}_settle_time", "s", f"time that {name} stays there before", SETTLE_TIME)
    h = signal_symbol("sample_time")
    ratios = [sp.Float(gear, 17) for gear in gears]
    middles = [sp.Float(0.5 * (a + b), 17) for a, b in pairwise(gears)]
    cases = [(ratio, estimate <= middle) for ratio, middle in zip(ratios[:-1], middles, strict=True)]
    nearest = w.assign(f"{name}_nearest", sp.Piecewise(*cases, (ratios[-1], True)), text)
    time = w.state(f"{name}_near_time", "s", f"for how long {name} has been near a gear")
    gear = w.state(f"{name}_gear", "", f"ratio of the gear that the estimate of {name} is taken for, 0 for none")
    near = sp.Abs(estimate - nearest) <= tolerance * sp.Abs(nearest)
    before = w.previous(time, sp.Integer(0))
    # Counting ends where it has told everything, so that it never runs out of digits.
    w.assign(time.name, sp.Piecewise((smallest_of(before + h, settle + h), near), (sp.Integer(0), True)), text)
    last = w.assign(f"{name}_gear_before", w.previous(gear, sp.Integer(0)), text)
    far = sp.Abs(estimate - last) > sp.Rational(3, 2) * tolerance * sp.Abs(last)
    w.assign(gear.name, sp.Piecewise((nearest, time > settle), (sp.Integer(0), far), (last, True)), text)
    return w.assign(f"{name}_snapped", sp.Piecewise((gear, sp.Abs(gear) > 0), (estimate, True)), text)

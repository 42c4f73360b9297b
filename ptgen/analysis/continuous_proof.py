"""The proof that a design is stable in continuous time: factors, conditions, admissible gains, verdicts.

What it takes for granted, as Section 5.7 of the source does: the reduced model, drives and sensors without delay, no
limits, no friction; sampling and dead time are left to `ptgen.analysis.closed_loop`. The reference model of the torque
control and its feedforward act on references only, and have no part in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from functools import cache, cached_property

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.analysis.characteristic import Factor, characteristic_factors
from ptgen.analysis.stability_conditions import (
    Condition,
    GainRange,
    closed_form_ranges,
    is_hurwitz,
    real_pole_condition,
    stability_conditions,
    stable_intervals,
)
from ptgen.analysis.symbolic_loop import (
    ACCELERATION_TORQUE,
    LOAD_COMPENSATION,
    LoopKind,
    SymbolicLoop,
    symbolic_loop,
)
from ptgen.control.design import ControlDesign
from ptgen.control.tuning import Gains
from ptgen.mechanism.reduction import ReducedModel

__all__ = [
    "AdmissibleGain",
    "ContinuousProof",
    "ProvenFactor",
    "Setting",
    "Verdict",
    "continuous_proof",
    "equivalent_observer",
    "gain_values",
    "prove",
]

_LARGEST_SIZE = 14
"""Terms of all coefficients together, up to which conditions are written in gains; above, in coefficients."""

_LARGEST_DEGREE = 8
"""Degree up to which they are written in coefficients; above, the determinants alone would fill pages."""


class Verdict(Enum):
    """What becomes of a motion; the better ones first."""

    STABLE = "asymptotically stable"
    NEUTRAL = "not asymptotically stable, poles on the imaginary axis"
    UNSTABLE = "unstable"


@dataclass(frozen=True)
class AdmissibleGain:
    """What a gain may be.

    Attributes
    ----------
    gain : Symbol
    value : float
        Of the bed's controller.
    closed_form : GainRange or None
        For which values the loop is asymptotically stable, given the gains chosen before; None where that is not
        linear in every gain of the factor, or not computed in symbols.
    real_poles : Expr or None
        Largest value for which the poles are real (5.110).
    intervals : tuple of (float, float)
        In numbers, all other gains at the values of the bed.
    """

    gain: sp.Symbol
    value: float
    closed_form: GainRange | None
    real_poles: sp.Expr | None
    intervals: tuple[tuple[float, float], ...]

    @property
    def is_admissible(self) -> bool:
        """Whether the value of the bed lies within."""
        return any(low < self.value < high for low, high in self.intervals)


@dataclass(frozen=True)
class ProvenFactor:
    """A factor with its conditions and what they say for the bed.

    Attributes
    ----------
    factor : Factor
    conditions : tuple of Condition or None
        Necessary and sufficient together (Lienard and Chipart); empty if the factor is stable for all gains, None if
        they would be too long to be of use.
    abbreviations : mapping of Symbol to Expr
        ``a_k``, the coefficient of ``s^k``, where the conditions are written in these.
    gains : tuple of AdmissibleGain
    poles : ndarray (degree,)
        Zeros with the values of the bed (1/s).
    verdict : Verdict
    """

    factor: Factor
    conditions: tuple[Condition, ...] | None
    abbreviations: Mapping[sp.Symbol, sp.Expr]
    gains: tuple[AdmissibleGain, ...]
    poles: NDArray[np.complex128]
    verdict: Verdict


@dataclass(frozen=True)
class Setting:
    """The closed loop with its switches in one position.

    Attributes
    ----------
    name : str
        "decoupling", or "individual" where machines have feedback without cross terms; "conventional", and what else
        the switches allow.
    fixed : mapping of Symbol to float
        Switches, and gains that are zero in this setting.
    values : mapping of Symbol to float
        Every parameter, gain and switch.
    factors : tuple of ProvenFactor
    """

    name: str
    fixed: Mapping[sp.Symbol, float]
    values: Mapping[sp.Symbol, float]
    factors: tuple[ProvenFactor, ...]

    @property
    def verdict(self) -> Verdict:
        """The worst verdict of all factors."""
        return max((proven.verdict for proven in self.factors), key=list(Verdict).index)


@dataclass(frozen=True)
class ContinuousProof:
    """The proof for a bed.

    Attributes
    ----------
    loop : SymbolicLoop
        The closed loop with symbolic switches and gains.
    settings : tuple of Setting
        All measures switched on first; positions of the switches that make no difference are left out.
    """

    loop: SymbolicLoop
    settings: tuple[Setting, ...]

    @cached_property
    def switched(self) -> tuple[Factor, ...]:
        """Factors of the characteristic polynomial for any position of the switches; one of full order, in general."""
        return characteristic_factors(self.loop)

    def setting(self, name: str) -> Setting:
        """Return a setting by its name."""
        return next(setting for setting in self.settings if setting.name == name)


def continuous_proof(
    design: ControlDesign, reduced: ReducedModel, speed_control: LoopKind | None = None
) -> ContinuousProof:
    """Prove, or refute, that the continuous closed loop of a bed is asymptotically stable.

    The inertia of each torque-controlled machine is taken to be what the law takes it for; what a difference does is
    the business of the sampled analysis of the full bed.

    Parameters
    ----------
    design : ControlDesign
    reduced : ReducedModel
        Its shaft damping counts in the internal dynamics.
    speed_control : LoopKind, optional
        Instead of what the controller of the bed has, such as ``SPEED_OBSERVER`` for (5.85)-(5.93).

    References
    ----------
    Source Section 5.7.
    """
    known = {signal.name: float(signal.value) for signal in design.controller.block.parameters}
    kinds = {name: speed_control or _kind(name, known) for name in design.decoupling.machines}
    loop = symbolic_loop(design.decoupling, reduced.equivalent_damping, kinds)
    values = {**gain_values(design.gains, loop, known), **design.tuned_inertia}
    conventional = {**values, **_by_name(loop, design.controller.conventional)}
    damping = dict.fromkeys(design.decoupling.damping, 0.0)
    positions = {
        str(design.decoupling.structure): ((1, 1), {}, values),
        "conventional": ((0, 0), damping, conventional),
        "damping alone": ((0, 0), {}, values),
        "load compensation and damping": ((1, 0), {}, values),
        "acceleration torque and damping": ((0, 1), {}, values),
    }
    settings: list[Setting] = []
    seen: list[sp.Matrix] = []
    for name, (switches, zero, numbers) in positions.items():
        fixed = {LOAD_COMPENSATION: float(switches[0]), ACCELERATION_TORQUE: float(switches[1]), **zero}
        matrix = loop.at(fixed).A
        if matrix not in seen:
            seen.append(matrix)
            settings.append(prove(loop, name, fixed, numbers))
    return ContinuousProof(loop, tuple(settings))


def prove(
    loop: SymbolicLoop, name: str, fixed: Mapping[sp.Symbol, float], values: Mapping[sp.Symbol, float]
) -> Setting:
    """Judge the closed loop in one position of its switches.

    Parameters
    ----------
    loop : SymbolicLoop
    name : str
        Of the setting.
    fixed : mapping of Symbol to float
        Both switches, and gains that are zero.
    values : mapping of Symbol to float
        All gains; parameters of the bed that differ from the file.
    """
    table = {**loop.values, **values, **fixed}
    free = [gain for gain in loop.gains if gain not in fixed]
    factors = tuple(_proven(factor, free, table) for factor in characteristic_factors(loop.at(fixed)))
    return Setting(name, dict(fixed), table, factors)


def equivalent_observer(gain: float, integral_gain: float, inertia: float) -> tuple[float, float]:
    r"""Return gain and rate of the P controller with observer that rejects disturbances exactly as a PI controller.

    With :math:`k_p' = k_p + \hat b I` and :math:`k_i' = \hat b k_p` both have the same polynomial and the same response
    to the disturbance (source Figure 5.16); they differ in the response to the reference, which with the observer has
    no zero and therefore does not overshoot, but stays behind a ramp (Figure 5.17). It exists if and only if the poles
    of the PI control are real (5.110); of the two poles the faster one becomes that of the observer.

    Parameters
    ----------
    gain : float
        ``k_p'`` (N m s/rad).
    integral_gain : float
        ``k_i'`` (N m/rad).
    inertia : float
        Of the rotor (kg m^2).

    Returns
    -------
    tuple of float
        ``k_p`` (N m s/rad) and ``b_hat`` (1/s).

    Raises
    ------
    ValueError
        If the poles are not real and negative.

    Examples
    --------
    >>> equivalent_observer(150.0, 1000.0, 5.0)
    (50.0, 20.0)
    """
    discriminant = gain**2 - 4 * inertia * integral_gain
    if discriminant < 0 or gain <= 0 or integral_gain <= 0:
        raise ValueError("no observer has complex or unstable poles; choose 0 < k_i <= k_p^2 / (4 I)")
    rate = float((gain + np.sqrt(discriminant)) / (2 * inertia))
    return gain - rate * inertia, rate


def _kind(machine: str, parameters: Mapping[str, float]) -> LoopKind:
    """Return the kind of a machine's speed control, as the parameters of the controller tell it."""
    if f"{machine}_twisting_gain" in parameters:
        return LoopKind.SPEED_TWISTING
    return LoopKind.SPEED_OBSERVER if f"{machine}_observer_bandwidth" in parameters else LoopKind.SPEED_PI


def gain_values(gains: Gains, loop: SymbolicLoop, parameters: Mapping[str, float]) -> dict[sp.Symbol, float]:
    """Return the gains of the controller of a bed, and of a speed control that it could have instead.

    Parameters
    ----------
    gains : Gains
    loop : SymbolicLoop
        Its gains are returned.
    parameters : mapping
        Of the controller, by name; they precede `gains`.
    """
    possible = {f"{name}_observer_bandwidth": value for name, value in gains.observer_bandwidth.items()}
    possible |= {f"{name}_speed_integral_gain": value for name, value in gains.speed_integral.items()}
    for name, twisting in gains.super_twisting.items():
        k1 = parameters.get(f"{name}_twisting_gain", twisting.k1)
        k2 = parameters.get(f"{name}_twisting_rate", twisting.k2)
        layer = parameters.get(f"{name}_twisting_layer", twisting.layer)
        possible |= {f"{name}_small_error_gain": k1 / layer**0.5, f"{name}_small_error_integral_gain": k2 / layer}
    return _by_name(loop, possible | dict(parameters))


def _by_name(loop: SymbolicLoop, numbers: Mapping[str, float]) -> dict[sp.Symbol, float]:
    return {gain: float(numbers[gain.name]) for gain in loop.gains if gain.name in numbers}


def _proven(factor: Factor, free: Sequence[sp.Symbol], table: Mapping[sp.Symbol, float]) -> ProvenFactor:
    gains = [gain for gain in free if any(sp.sympify(value).has(gain) for value in factor.coefficients)]
    conditions, abbreviations = _conditions(factor, gains)
    ranges: dict[sp.Symbol, GainRange] = {}
    bounds: dict[sp.Symbol, sp.Expr | None] = {}
    if conditions is not None and not abbreviations:
        found = closed_form_ranges(conditions, gains)
        if len(found) == len(gains):  # one that is missing would narrow those before it
            ranges = {item.gain: item for item in found}
        real = real_pole_condition(factor.coefficients, gains)
        if real is not None:
            bounds = {item.gain: item.upper for item in closed_form_ranges((real,), gains, conditions)}
    numbers = {symbol: float(table[symbol]) for symbol in _symbols(factor)}
    bed = {symbol: sp.Rational(repr(value)) for symbol, value in numbers.items() if symbol not in gains}
    inserted = [sp.expand(sp.sympify(value).xreplace(bed)) for value in factor.coefficients]
    admissible = tuple(
        AdmissibleGain(
            gain,
            numbers[gain],
            ranges.get(gain),
            bounds.get(gain),
            stable_intervals(inserted, gain, numbers),
        )
        for gain in gains
    )
    poles = factor.poles(table)
    return ProvenFactor(factor, conditions, abbreviations, admissible, poles, _verdict(inserted, numbers, poles))


def _conditions(
    factor: Factor, gains: Sequence[sp.Symbol]
) -> tuple[tuple[Condition, ...] | None, dict[sp.Symbol, sp.Expr]]:
    """Return the conditions in gains where they are short, else in the coefficients."""
    terms = sum(len(sp.Add.make_args(sp.expand(sp.fraction(sp.together(v))[0]))) for v in factor.coefficients)
    if terms <= _LARGEST_SIZE:
        return stability_conditions(factor.coefficients, gains), {}
    if factor.degree > _LARGEST_DEGREE:
        return None, {}
    symbols = _coefficient_symbols(factor.degree)
    return _general_conditions(factor.degree), dict(zip(symbols, factor.coefficients[1:], strict=True))


def _coefficient_symbols(degree: int) -> list[sp.Symbol]:
    return [sp.Symbol(f"a_{degree - k}", real=True) for k in range(1, degree + 1)]


@cache
def _general_conditions(degree: int) -> tuple[Condition, ...]:
    """Return the conditions for a polynomial with free coefficients, the first one 1."""
    symbols = _coefficient_symbols(degree)
    return stability_conditions((sp.Integer(1), *symbols), symbols)


def _symbols(factor: Factor) -> set[sp.Symbol]:
    return set().union(*(sp.sympify(value).free_symbols for value in factor.coefficients))


def _verdict(
    coefficients: Sequence[sp.Expr], numbers: Mapping[sp.Symbol, float], poles: NDArray[np.complex128]
) -> Verdict:
    table = {symbol: sp.Rational(repr(value)) for symbol, value in numbers.items()}
    inserted = [sp.Rational(value.xreplace(table)) for value in coefficients]
    if is_hurwitz([Fraction(int(value.p), int(value.q)) for value in inserted]):
        return Verdict.STABLE
    size = float(np.max(np.abs(poles), initial=0.0))
    return Verdict.UNSTABLE if np.any(poles.real > 1e-9 * size) else Verdict.NEUTRAL

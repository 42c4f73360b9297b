r"""When a polynomial with symbolic coefficients has all its zeros in the left half plane, and what that asks of gains.

For ``a_n s^n + ... + a_1 s + a_0`` with ``a_n > 0`` this is so if and only if all coefficients are positive and, of the
Hurwitz determinants, :math:`\Delta_{n-1}, \Delta_{n-3}, \ldots` are (Lienard and Chipart). Parameters of a bed have
signs that are known, so most of these conditions shrink to a few words, and many vanish.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

__all__ = [
    "Condition",
    "GainRange",
    "closed_form_ranges",
    "hurwitz_determinant",
    "is_hurwitz",
    "real_pole_condition",
    "stability_conditions",
    "stable_intervals",
]


@dataclass(frozen=True)
class Condition:
    """``expression > 0``, or ``expression >= 0``; factors that are positive anyway are left out.

    Attributes
    ----------
    expression : Expr
    origin : str
        "coefficient of s^k", "Hurwitz determinant k" or "discriminant".
    strict : bool
    """

    expression: sp.Expr
    origin: str
    strict: bool = True


@dataclass(frozen=True)
class GainRange:
    """Admissible values of a gain, given the gains that were chosen before it.

    Attributes
    ----------
    gain : Symbol
    lower, upper : Expr or None
        Open bounds; None if there is none.
    """

    gain: sp.Symbol
    lower: sp.Expr | None
    upper: sp.Expr | None


def hurwitz_determinant(coefficients: Sequence[sp.Expr], order: int) -> sp.Expr:
    """Return a leading minor of the Hurwitz matrix.

    Parameters
    ----------
    coefficients : sequence of Expr (n + 1)
        The highest power first.
    order : int
        Number of rows, 1 to n.

    Examples
    --------
    >>> a3, a2, a1, a0 = sp.symbols("a3 a2 a1 a0")
    >>> hurwitz_determinant((a3, a2, a1, a0), 2)
    -a0*a3 + a1*a2
    """
    degree = len(coefficients) - 1

    def entry(row: int, column: int) -> sp.Expr:
        index = 2 * (column + 1) - (row + 1)
        return sp.sympify(coefficients[index]) if 0 <= index <= degree else sp.Integer(0)

    matrix = DomainMatrix.from_Matrix(sp.Matrix(order, order, entry))
    return sp.sympify(matrix.domain.to_sympy(matrix.charpoly()[-1]) * (-1) ** order)


def stability_conditions(coefficients: Sequence[sp.Expr], gains: Collection[sp.Symbol]) -> tuple[Condition, ...]:
    """Return conditions that hold if and only if all zeros have negative real parts.

    Parameters
    ----------
    coefficients : sequence of Expr (n + 1)
        The highest power first, and its coefficient positive.
    gains : collection of Symbol
        What may have any sign. All other symbols are parameters of the bed: different from zero, and positive if
        they are declared so.

    Returns
    -------
    tuple of Condition
        Without those that always hold, and without those that follow from the others. One whose expression is a
        number that is not positive can never be met.

    Examples
    --------
    >>> d, k, i, I = sp.symbols("d k i I", positive=True)
    >>> k, i = sp.symbols("k i", real=True)
    >>> for condition in stability_conditions((I, d, 1 + k, i), (k, i)):
    ...     print(condition.expression, ">", 0)
    k + 1 > 0
    i > 0
    -I*i + d*k + d > 0

    References
    ----------
    F. R. Gantmacher, *The Theory of Matrices*, vol. 2, chapter XV, section 13. Source after (5.105), (5.115).
    """
    degree = len(coefficients) - 1
    found = [
        Condition(_without_positive_factors(sp.sympify(value), gains), f"coefficient of s^{degree - index}")
        for index, value in enumerate(coefficients)
        if index > 0
    ]
    for order in range(degree - 1, 1, -2):
        determinant = hurwitz_determinant(coefficients, order)
        found.append(Condition(_without_positive_factors(determinant, gains), f"Hurwitz determinant {order}"))
    return tuple(_without_implied(found, gains))


def real_pole_condition(coefficients: Sequence[sp.Expr], gains: Collection[sp.Symbol]) -> Condition | None:
    """Return when a polynomial of degree two has real zeros, (5.110); None for other degrees."""
    if len(coefficients) != 3:
        return None
    first, middle, last = coefficients
    expression = _without_positive_factors(sp.sympify(middle**2 - 4 * first * last), gains)
    return Condition(expression, "discriminant", strict=False)


def closed_form_ranges(
    conditions: Sequence[Condition], gains: Sequence[sp.Symbol], known: Sequence[Condition] = ()
) -> tuple[GainRange, ...]:
    """Solve conditions for gains, each condition for the last gain in it: (5.110), (5.115).

    Parameters
    ----------
    conditions : sequence of Condition
    gains : sequence of Symbol
        In the order in which they are chosen.
    known : sequence of Condition
        Further conditions that hold too; they decide signs.

    Returns
    -------
    tuple of GainRange
        One for each gain that is bounded, if all conditions that bound it are linear in it.
    """
    signs = _signs([*conditions, *known], gains)
    bounds: dict[sp.Symbol, tuple[list[sp.Expr], list[sp.Expr]]] = {gain: ([], []) for gain in gains}
    for condition in conditions:
        inside = [gain for gain in gains if condition.expression.has(gain)]
        if not inside or inside[-1] not in bounds:
            continue
        gain = inside[-1]
        slope = sp.diff(condition.expression, gain)
        if slope.has(gain):
            del bounds[gain]
            continue
        bound = sp.factor(-(condition.expression - slope * gain).expand() / slope)
        lower, upper = bounds[gain]
        if _is_positive(slope.subs(signs), gains):
            lower.append(bound)
        elif _is_positive(-slope.subs(signs), gains):
            upper.append(bound)
        else:
            del bounds[gain]
    return tuple(
        GainRange(gain, sp.Max(*lower) if lower else None, sp.Min(*upper) if upper else None)
        for gain, (lower, upper) in bounds.items()
        if lower or upper
    )


def is_hurwitz(coefficients: Sequence[Fraction | int]) -> bool:
    """Tell, without rounding, whether all zeros of a polynomial have negative real parts.

    Parameters
    ----------
    coefficients : sequence of Fraction or int (n + 1)
        The highest power first.

    Examples
    --------
    >>> is_hurwitz((1, 2, 1)), is_hurwitz((1, 0, 1)), is_hurwitz((1, 1, 1, 2))
    (True, False, False)
    """
    rows = [Fraction(value) * (1 if coefficients[0] > 0 else -1) for value in coefficients]
    upper, lower = rows[0::2], rows[1::2]
    while upper and lower:
        if upper[0] <= 0 or lower[0] <= 0:
            return False
        factor = upper[0] / lower[0]
        padded = [*lower, *[Fraction(0)] * (len(upper) - len(lower))]
        upper, lower = lower, [u - factor * p for u, p in zip(upper[1:], padded[1:], strict=True)]
    return all(value > 0 for value in upper)


def stable_intervals(
    coefficients: Sequence[sp.Expr], gain: sp.Symbol, values: Mapping[sp.Symbol, float]
) -> tuple[tuple[float, float], ...]:
    """Return the open intervals of a gain in which all zeros have negative real parts, all else in numbers.

    Zeros cross the imaginary axis where the last coefficient or the last but one Hurwitz determinant vanishes
    (Orlando); in each interval in between one point decides.

    Parameters
    ----------
    coefficients : sequence of Expr (n + 1)
        The highest power first; polynomials in `gain`.
    gain : Symbol
    values : mapping of Symbol to float
        All other symbols.
    """
    table = {symbol: _rational(value) for symbol, value in values.items() if symbol != gain}
    inserted = [sp.Poly(sp.sympify(value).xreplace(table), gain, domain="QQ") for value in coefficients]
    degree = len(inserted) - 1
    critical = [inserted[0], inserted[-1]]
    if degree > 1:
        determinant = hurwitz_determinant([polynomial.as_expr() for polynomial in inserted], degree - 1)
        critical.append(sp.Poly(determinant, gain, domain="QQ"))
    borders = sorted({float(root) for polynomial in critical for root in _real_roots(polynomial)})
    points = _points_between(borders)
    ends = [-np.inf, *borders, np.inf]
    intervals: list[tuple[float, float]] = []
    for k, point in enumerate(points):
        at = [polynomial.eval(_rational(point)) for polynomial in inserted]
        if at[0] == 0 or not is_hurwitz([Fraction(int(value.p), int(value.q)) for value in at]):
            continue
        if intervals and intervals[-1][1] == ends[k] and _touches(inserted, ends[k]):
            intervals[-1] = (intervals[-1][0], ends[k + 1])
        else:
            intervals.append((ends[k], ends[k + 1]))
    return tuple((float(low), float(high)) for low, high in intervals)


def _touches(inserted: Sequence[sp.Poly], border: float) -> bool:
    """Tell whether the polynomial is stable at a border too, where a determinant has a double zero."""
    at = [polynomial.eval(_rational(border)) for polynomial in inserted]
    return at[0] != 0 and is_hurwitz([Fraction(int(value.p), int(value.q)) for value in at])


def _rational(value: float) -> sp.Rational:
    return sp.Rational(repr(float(value)))


def _real_roots(polynomial: sp.Poly) -> list[sp.Expr]:
    if polynomial.degree() < 1:
        return []
    return [(low + high) / 2 for (low, high), _ in polynomial.intervals(eps=sp.Rational(1, 10**14))]


def _points_between(borders: Sequence[float]) -> list[float]:
    if not borders:
        return [0.0]
    inner = [(low + high) / 2 for low, high in itertools.pairwise(borders)]
    return [borders[0] - 1 - abs(borders[0]), *inner, borders[-1] + 1 + abs(borders[-1])]


def _without_positive_factors(expression: sp.Expr, gains: Collection[sp.Symbol]) -> sp.Expr:
    """Return an expression of the same sign, as a polynomial without factors that are known to be positive."""
    numerator, denominator = sp.fraction(sp.together(expression))
    if numerator.is_number and denominator.is_number:
        return sp.sympify(numerator / denominator)
    result = sp.Integer(1)
    for part in (numerator, denominator):
        constant, factors = sp.factor_list(part)
        result *= sp.sign(constant)
        for factor, power in factors:
            plain = factor.as_expr() if isinstance(factor, sp.Poly) else factor
            if _is_positive(plain, gains):
                continue
            if _is_positive(-plain, gains):
                result *= (-1) ** power
            elif power % 2 or not plain.is_Symbol or plain in gains:
                result *= plain if power % 2 else plain**2
    return sp.sympify(result)


def _is_positive(expression: sp.Expr, gains: Collection[sp.Symbol]) -> bool:
    """Tell whether a polynomial is positive because each of its terms is, or at least is not negative."""
    expression = sp.sympify(expression)
    if expression.is_number:
        return bool(expression > 0)
    symbols = sorted(expression.free_symbols, key=lambda symbol: symbol.name)
    try:
        terms = sp.Poly(sp.expand(expression), *symbols).terms()
    except sp.PolynomialError:
        return False
    strict = False
    for powers, coefficient in terms:
        if not coefficient.is_number or coefficient < 0:
            return False
        positive = True
        for symbol, power in zip(symbols, powers, strict=True):
            if power == 0 or symbol.is_positive:
                continue
            if symbol in gains or power % 2:
                positive = False
            if power % 2 and not symbol.is_nonnegative:
                return False
        strict = strict or positive
    return strict


def _signs(conditions: Sequence[Condition], gains: Collection[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """Return, for gains that one condition bounds from below by a number, the gain over a positive symbol."""
    signs: dict[sp.Symbol, sp.Expr] = {}
    for condition in conditions:
        free = condition.expression.free_symbols
        if len(free) != 1 or not free <= set(gains) or not condition.strict:
            continue
        (gain,) = free
        if sp.Poly(condition.expression, gain).degree() != 1:
            continue
        slope = sp.diff(condition.expression, gain)
        if slope > 0:
            bound = -(condition.expression - slope * gain).expand() / slope
            signs[gain] = bound + sp.Symbol(f"{gain.name}_above", positive=True)
    return signs


def _without_implied(conditions: Sequence[Condition], gains: Collection[sp.Symbol]) -> list[Condition]:
    """Leave out conditions that always hold, that stand there already, or that follow from those on single gains."""
    signs = _signs(conditions, gains)
    kept: list[Condition] = []
    for condition in conditions:
        free = condition.expression.free_symbols
        single = len(free) == 1 and free <= set(signs)
        if single and sp.Poly(condition.expression, *free).degree() == 1:
            implied = False
        elif condition.expression.is_number:
            implied = bool(condition.expression > 0)
        else:
            implied = _is_positive(condition.expression.subs(signs), gains)
        if not implied and condition.expression not in [other.expression for other in kept]:
            kept.append(condition)
    return kept

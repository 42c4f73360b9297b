"""Conditions in closed form hold exactly when the zeros lie in the left half plane."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from ptgen.analysis.stability_conditions import (
    closed_form_ranges,
    hurwitz_determinant,
    is_hurwitz,
    real_pole_condition,
    stability_conditions,
    stable_intervals,
)

_GENERAL = {
    degree: tuple(sp.Symbol(f"a_{degree - k}", real=True) for k in range(1, degree + 1)) for degree in range(1, 8)
}
_CONDITIONS = {degree: stability_conditions((sp.Integer(1), *symbols), symbols) for degree, symbols in _GENERAL.items()}


@st.composite
def polynomials(draw: st.DrawFn) -> tuple[np.ndarray, bool]:
    """A real polynomial by its zeros, none of them near the imaginary axis, and whether it is stable."""
    degree = draw(st.integers(1, 7))
    away = st.floats(0.05, 2.0).flatmap(lambda size: st.sampled_from([-size, -size, -size, size]))
    zeros: list[complex] = []
    while len(zeros) < degree:
        real = draw(away)
        if degree - len(zeros) >= 2 and draw(st.booleans()):
            imaginary = draw(st.floats(0.1, 3.0))
            zeros += [complex(real, imaginary), complex(real, -imaginary)]
        else:
            zeros.append(real)
    return np.real(np.poly(zeros)), max(np.real(zeros)) < 0


@given(polynomials())
def test_conditions_hold_if_and_only_if_all_zeros_are_on_the_left(drawn: tuple[np.ndarray, bool]) -> None:
    coefficients, stable = drawn
    degree = len(coefficients) - 1
    at = dict(zip(_GENERAL[degree], [Fraction(float(value)) for value in coefficients[1:]], strict=True))
    table = {symbol: sp.Rational(value.numerator, value.denominator) for symbol, value in at.items()}
    assert all(condition.expression.subs(table) > 0 for condition in _CONDITIONS[degree]) == stable
    assert is_hurwitz([Fraction(1), *at.values()]) == stable
    assert is_hurwitz([Fraction(-1), *(-value for value in at.values())]) == stable


@pytest.mark.parametrize("degree", [2, 3, 4, 5])
def test_determinants_are_minors_of_the_hurwitz_matrix(degree: int) -> None:
    coefficients = sp.symbols(f"b0:{degree + 1}")
    matrix = sp.Matrix(
        degree, degree, lambda i, j: 0 if not 0 <= 2 * j - i + 1 <= degree else coefficients[2 * j - i + 1]
    )
    for order in range(1, degree + 1):
        assert sp.expand(hurwitz_determinant(coefficients, order) - matrix[:order, :order].det()) == 0


def test_zero_on_the_axis_is_not_stable() -> None:
    assert not is_hurwitz((1, 0))
    assert not is_hurwitz((1, 1, 4, 4))
    assert not is_hurwitz((1, 0, 5, 0, 4))


def test_what_always_holds_is_left_out_and_what_never_holds_is_shown() -> None:
    mass, d = sp.symbols("mass d", positive=True)
    k = sp.Symbol("k", real=True)
    assert stability_conditions((mass, d, 3), ()) == ()
    assert [c.expression for c in stability_conditions((mass, -d * k, 3), (k,))] == [-k]
    assert stability_conditions((mass, 0, k), (k,))[0].expression == 0
    assert stability_conditions((mass, -d, k), (k,))[0].expression == -1


def test_factors_that_may_vanish_are_kept() -> None:
    a, b, k = sp.symbols("a b k", real=True)
    (condition,) = stability_conditions((1, (a - b) ** 2), ())
    assert sp.expand(condition.expression - (a - b) ** 2) == 0
    assert stability_conditions((1, a**2), ()) == ()
    (condition,) = stability_conditions((1, k**2), (k,))
    assert condition.expression == k**2


@given(st.floats(0.1, 50), st.floats(-0.9, 20), st.floats(0.1, 30), st.floats(1, 1e4))
def test_intervals_of_the_cubic_are_those_of_its_closed_form(d: float, k: float, inertia: float, c: float) -> None:
    integral = sp.Symbol("i", real=True)
    symbols = sp.symbols("d k I c", real=True)
    values = dict(zip(symbols, (d, k, inertia, c), strict=True))
    damping, gain, mass, stiffness = symbols
    coefficients = (1, damping / mass, stiffness * (1 + gain) / mass, stiffness * integral / mass)
    ((low, high),) = stable_intervals(coefficients, integral, values)
    assert low == pytest.approx(0, abs=1e-8)
    assert high == pytest.approx(d * (1 + k) / inertia, rel=1e-7)


def test_interval_goes_on_through_a_point_where_the_zeros_do_not_cross() -> None:
    k = sp.Symbol("k", real=True)
    assert stable_intervals((1, 1, 1 + k**2), k, {}) == ((-np.inf, np.inf),)
    assert stable_intervals((1, 1, k**2), k, {}) == ((-np.inf, 0.0), (0.0, np.inf))
    assert stable_intervals((1, 1, (k - 1) * (k - 2)), k, {}) == ((-np.inf, 1.0), (2.0, np.inf))
    assert stable_intervals((1, -1, k), k, {}) == ()


def test_gain_with_a_bound_that_is_not_linear_has_no_closed_form() -> None:
    k = sp.Symbol("k", real=True)
    conditions = stability_conditions((1, 1, k**2 - 3), (k,))
    assert closed_form_ranges(conditions, (k,)) == ()


@given(st.floats(0.1, 10), st.floats(0.1, 10), st.floats(0.1, 10))
def test_real_poles(inertia: float, gain: float, integral: float) -> None:
    k, i = sp.symbols("k i", real=True)
    mass = sp.Symbol("mass", positive=True)
    condition = real_pole_condition((1, k / mass, i / mass), (k, i))
    assert condition is not None and not condition.strict
    discriminant = gain**2 - 4 * inertia * integral
    assume(abs(discriminant) > 1e-6)
    zeros = np.roots([1, gain / inertia, integral / inertia])
    assert (float(condition.expression.subs({k: gain, i: integral, mass: inertia})) > 0) == bool(np.isreal(zeros).all())
    assert real_pole_condition((1, k, i, 1), (k, i)) is None

"""Exact comparison of printed formulas with derived ones, for the notebooks of this directory.

``check`` and ``erratum`` take the number of an equation of the source, the formula as it is
printed and the formula as the notebook derives it. Both comparisons are exact: the difference of
two rational expressions is brought over one denominator and expanded, nothing is evaluated in
floating point. Formulas with roots or transcendental functions fall back on ``sympy.simplify``.
"""

from collections.abc import Iterable

import sympy as sp

CHECKED: list[str] = []
"""Numbers whose printed form equals the derived one, in the order of the checks."""

ERRATA: list[tuple[str, str]] = []
"""Numbers whose printed form differs from the derived one, each with a note."""


class CheckError(Exception):
    """A printed formula does not compare with the derived one as stated."""


def _entries(value) -> list[sp.Expr]:
    """List the scalar entries of an expression, an equation, a matrix or a nested sequence."""
    if isinstance(value, sp.MatrixBase):
        return list(value)
    if isinstance(value, sp.Equality):
        return [value.lhs - value.rhs]
    if isinstance(value, sp.Poly):
        return [value.as_expr()]
    if isinstance(value, Iterable):
        return [entry for item in value for entry in _entries(item)]
    return [sp.sympify(value)]


def is_zero(expression) -> bool:
    """Tell whether an expression is identically zero."""
    expression = sp.sympify(expression)
    if expression.is_zero:
        return True
    if sp.expand(sp.fraction(sp.together(expression))[0]) == 0:
        return True
    if expression.is_rational_function(*expression.free_symbols):
        return False
    return sp.simplify(expression) == 0


def differences(printed, derived) -> list[sp.Expr]:
    """Subtract entry by entry."""
    left, right = _entries(printed), _entries(derived)
    if len(left) != len(right):
        raise CheckError(f"{len(left)} printed entries against {len(right)} derived ones")
    return [a - b for a, b in zip(left, right, strict=True)]


def check(number: str, printed, derived) -> None:
    """Require that the printed formula equals the derived one exactly, and record its number."""
    wrong = [d for d in differences(printed, derived) if not is_zero(d)]
    if wrong:
        raise CheckError(f"({number}): printed - derived = {[sp.factor(d) for d in wrong]}")
    CHECKED.append(number)
    print(f"({number}) printed = derived")


def erratum(number: str, printed, derived, note: str) -> None:
    """Require that the printed formula differs from the derived one, and record why."""
    if all(is_zero(d) for d in differences(printed, derived)):
        raise CheckError(f"({number}): printed equals derived, so this is no erratum: {note}")
    ERRATA.append((number, note))
    print(f"({number}) ERRATUM: {note}")


def summary() -> None:
    """Print what this notebook has shown."""
    numbers = list(dict.fromkeys(CHECKED))
    print(f"{len(CHECKED)} comparisons, {len(numbers)} numbers equal, {len(ERRATA)} errata")


def show(figure) -> None:
    """Show a figure in a notebook; close it when the file runs as a script."""
    import matplotlib.pyplot as plt

    try:
        interactive = get_ipython() is not None  # type: ignore[name-defined]
    except NameError:
        interactive = False
    if interactive:
        plt.show()
    plt.close(figure)

"""Formulas as people read them: sums of coefficient times quantity, as text and as LaTeX."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import Enum

import sympy as sp

__all__ = ["Equation", "Kind", "Term", "latex_expression", "latex_name", "terms_of", "text_expression"]


class Kind(Enum):
    """What a variable of a formula is; text and LaTeX form."""

    VELOCITY = ("ω({})", r"\omega_{{{}}}")
    ACCELERATION = ("dω({})/dt", r"\dot\omega_{{{}}}")
    TWIST = ("φ({})", r"\Delta\varphi_{{{}}}")
    RATE = ("dφ({})/dt", r"\Delta\dot\varphi_{{{}}}")
    AIR_GAP = ("T_ag({})", r"T_{{\mathrm{{ag}},{}}}")
    SHAFT = ("T({})", r"T_{{{}}}")
    FRICTION = ("T_fr({})", r"T_{{\mathrm{{fr}},{}}}")
    SIGNAL = ("{}", "{}")


@dataclass(frozen=True)
class Term:
    """A coefficient times a variable; `note` says what the term is there for."""

    coefficient: sp.Expr
    kind: Kind
    name: str
    note: str = ""

    def text(self) -> str:
        """Return the variable as text."""
        return str(self.kind.value[0]).format(_plain(self.name))

    def latex(self) -> str:
        """Return the variable as LaTeX."""
        if self.kind is Kind.SIGNAL:
            return latex_name(self.name)
        return str(self.kind.value[1]).format(_roman(_plain(self.name)))


@dataclass(frozen=True)
class Equation:
    """``left = right``, both sums of terms."""

    left: tuple[Term, ...]
    right: tuple[Term, ...]

    def text(self) -> str:
        """Return the equation as one line of text."""
        return " = ".join(_sum(side, _text_product, "−") for side in (self.left, self.right))

    def latex(self) -> str:
        """Return the equation as a line of an ``align`` environment."""
        return " &= ".join(_sum(side, _latex_product, "-") for side in (self.left, self.right))

    def at(self, values: dict[sp.Symbol, float]) -> Equation:
        """Return the equation with numbers in place of the parameters; terms that vanish are left out."""
        sides = []
        for side in (self.left, self.right):
            numbers = ((term, float(term.coefficient.subs(values))) for term in side)
            sides.append(tuple(Term(sp.Float(number), term.kind, term.name) for term, number in numbers if number))
        return Equation(*sides)


def terms_of(row: Iterable[sp.Expr], kind: Kind, names: Sequence[str], sign: int = 1) -> tuple[Term, ...]:
    """Return the terms of a row of coefficients, without those that are zero."""
    return tuple(
        Term(sp.factor(sign * entry), kind, name) for entry, name in zip(row, names, strict=True) if entry != 0
    )


def text_expression(expression: sp.Expr) -> str:
    """Return an expression of parameters as text.

    Examples
    --------
    >>> i, c = sp.symbols("diff_ratio cardan2_stiffness")
    >>> text_expression(c / i**2)
    'cardan2_stiffness/diff_ratio²'
    """
    text = sp.sstr(_rounded(expression), full_prec=False)
    text = re.sub(r"\*\*([23])(?!\d)", lambda match: "²³"[int(match[1]) - 2], text)
    return text.replace("**", "^").replace("*", "·")


def latex_expression(expression: sp.Expr) -> str:
    """Return an expression of parameters as LaTeX."""
    names = {symbol: latex_name(symbol.name) for symbol in expression.free_symbols}
    return str(sp.latex(_rounded(expression), symbol_names=names))


# What a parameter or signal is called in the file or in the emitted code -> the symbol of the literature.
_SYMBOLS = (
    ("inertia_estimate", r"\hat I"),
    ("speed_integral_gain", r"k_{\mathrm{i}}"),
    ("torque_integral_gain", r"k_{\mathrm{i}}"),
    ("small_error_integral_gain", r"k_{\mathrm{i}}"),
    ("speed_gain", r"k_{\mathrm{p}}"),
    ("torque_gain", r"k_{\mathrm{p}}"),
    ("small_error_gain", r"k_{\mathrm{p}}"),
    ("observer_bandwidth", r"\hat b"),
    ("shaft_damping", "d"),
    ("pinion_ratio", r"\rho"),
    ("inertia", "I"),
    ("stiffness", "c"),
    ("damping", "d"),
    ("ratio", "i"),
    ("viscous", r"k_\omega"),
    ("coulomb", "T_0"),
    ("capacity", r"T_{\mathrm{c}}"),
    ("static", r"T_{\mathrm{s}}"),
    ("drag", "T_0"),
    ("stribeck_speed", r"\omega_{\mathrm{s}}"),
    ("load", "k_T"),
    ("slope", "k"),
    ("amplitude", "a"),
    ("phase", r"\varphi_0"),
    ("backlash", r"\theta"),
    ("play", r"\theta"),
    ("torque", "T"),
    ("speed", r"\omega"),
)


def latex_name(name: str) -> str:
    r"""Return a parameter, signal or virtual input as LaTeX.

    Examples
    --------
    >>> latex_name("M1_speed")
    '\\omega_{\\mathrm{M1}}'
    >>> latex_name("diff_limited_slip_viscous")
    '{k_\\omega}_{\\mathrm{diff\\_limited\\_slip}}'
    """
    if name.startswith("v_"):
        return f"v_{{{_roman(name[2:])}}}"
    if abbreviation := re.fullmatch(r"k_(\d+)", name):
        return f"k_{{{abbreviation[1]}}}"
    for word, symbol in _SYMBOLS:
        before, found, after = f"{name}_".partition(f"_{word}_")
        if found:
            base = f"{{{symbol}}}" if "_" in symbol else symbol
            index = f"{before},{after.removesuffix('_')}" if after else before
            return f"{base}_{{{_roman(index)}}}"
    return _roman(name)


def _roman(name: str) -> str:
    escaped = name.replace("_", r"\_")
    return rf"\mathrm{{{escaped}}}"


def _plain(name: str) -> str:
    """Leave out the flange of a machine; it has one only."""
    return name.removesuffix(".shaft")


def _rounded(expression: sp.Expr) -> sp.Expr:
    """Return `expression` with numbers of five digits, whole ones without a point."""
    return expression.xreplace({number: _short(float(number)) for number in expression.atoms(sp.Float)})


def _short(value: float) -> sp.Expr:
    rounded = float(f"{value:.5g}")
    return sp.Integer(int(rounded)) if rounded.is_integer() else sp.Float(f"{rounded:.5g}")


def _sum(terms: tuple[Term, ...], product: Callable[[sp.Expr, Term], str], minus: str) -> str:
    """Return a sum of terms as `product` writes them, a positive sign left out at the start."""
    parts: list[str] = []
    for term in terms:
        coefficient = _rounded(term.coefficient)
        negative = coefficient.could_extract_minus_sign()
        written = product(-coefficient if negative else coefficient, term)
        sign = minus if negative else "+"
        parts.append(f" {sign} {written}" if parts else f"{minus if negative else ''}{written}")
    return "".join(parts) or "0"


def _text_product(coefficient: sp.Expr, term: Term) -> str:
    if coefficient.is_number:
        return term.text() if coefficient == 1 else f"{text_expression(coefficient)}·{term.text()}"
    if term.kind in (Kind.RATE, Kind.ACCELERATION):  # these end in a quotient themselves
        factor = _bracketed(coefficient, sp.Add)
        return term.text() if coefficient == 1 else f"{factor}·{term.text()}"
    above, below = coefficient.as_numer_denom()
    factor = "" if above == 1 else f"{_bracketed(above, sp.Add)}·"
    return factor + term.text() + ("" if below == 1 else f"/{_bracketed(below, (sp.Add, sp.Mul))}")


def _bracketed(expression: sp.Expr, kinds: type | tuple[type, ...]) -> str:
    text = text_expression(expression)
    return f"({text})" if isinstance(expression, kinds) else text


def _latex_product(coefficient: sp.Expr, term: Term) -> str:
    if coefficient == 1:
        return term.latex()
    factor = latex_expression(coefficient)
    if isinstance(coefficient, sp.Add):
        factor = rf"\left({factor}\right)"
    return rf"{factor}\,{term.latex()}"

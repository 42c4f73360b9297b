"""A derivation as a fragment of a LaTeX document: sections, ``align*`` environments and tables.

It needs the packages ``amsmath`` and ``longtable``, and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from ptgen.mechanism.modes import Mode
from ptgen.report.derivation import Derivation
from ptgen.report.formulas import Equation, latex_expression, latex_name
from ptgen.report.friction_law import LATEX, friction_law
from ptgen.report.motion import Motion
from ptgen.report.quantities import percent

__all__ = ["derivation_latex", "escape"]

_ESCAPES = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "_": r"\_",
    "%": r"\%",
    "&": r"\&",
    "#": r"\#",
    "$": r"\$",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
}


def escape(text: str) -> str:
    r"""Return plain text as LaTeX.

    Examples
    --------
    >>> escape("3 % of kg m^2")
    '3 \\% of kg m\\textasciicircum{}2'
    """
    return "".join(_ESCAPES.get(letter, letter) for letter in text)


def derivation_latex(found: Derivation) -> str:
    """Return a derivation as LaTeX."""
    return "\n".join(_lines(found)) + "\n"


def _lines(found: Derivation) -> Iterator[str]:
    yield "% Needs \\usepackage{amsmath,longtable}."
    yield rf"\section*{{{escape(found.title)}}}"
    sections: tuple[tuple[str, Iterable[str]], ...] = (
        ("States", _states(found)),
        ("Equations of motion", (*_motion(found.motion), *_gaps(found))),
        ("Reduction", _reduction(found)),
        ("Reduced model", _reduced(found)),
        ("Relative degrees", _degrees(found)),
        ("Decoupling matrix", _matrix(found)),
        ("Law", _align(found.law.values())),
        ("Testing torque from sensors", _align(found.estimates)),
        ("Gains", _gains(found)),
        ("Stability in continuous time", _stability(found)),
    )
    for heading, lines in sections:
        yield ""
        yield rf"\subsection*{{{heading}}}"
        yield from lines


def _states(found: Derivation) -> Iterator[str]:
    for title, model in (("Full model", found.model), ("Reduced model", found.reduced)):
        velocities, twists = (escape(", ".join(names) or "none") for names in (model.coordinates, model.twists))
        yield rf"{title}, order {model.order}: velocities {velocities}; twists {twists}."
        yield ""


def _motion(equations: Motion) -> Iterator[str]:
    yield from _align((*equations.balances, *equations.shafts, *equations.twists))
    if equations.slips:
        yield "Friction elements that slip with the velocity $w$, and their limit at rest where it is another one:"
        rows = []
        for slip in equations.slips:
            name, law = escape(slip.friction.name), friction_law(slip.friction, LATEX)
            rows.append(rf"{LATEX.torque.format(name=name)} &= {law.slipping}")
            if not law.same:
                rows.append(law.at_rest)
            velocity = Equation((), slip.velocity).latex().removeprefix("0 ")
            rows.append(rf"{LATEX.velocity.format(name=name)} {velocity}")
        yield from _rows(rows)
    yield from _abbreviations(equations)


def _gaps(found: Derivation) -> Iterator[str]:
    if found.gaps:
        yield "Shafts carry no torque inside their gaps, which are closed in the equations above:"
        rows = []
        for spring in found.gaps:
            name = rf"\mathrm{{{escape(spring.name)}}}"
            half = latex_expression(sp.sympify(spring.backlash) / 2)
            rows.append(rf"T_{{{name}}} &= 0, \quad \left|\Delta\varphi_{{{name}}}\right| < {half}")
        yield from _rows(rows)


def _abbreviations(equations: Motion) -> Iterator[str]:
    if equations.abbreviations:
        yield "with"
        yield from _definitions(equations.abbreviations)


def _definitions(table: dict[sp.Symbol, sp.Expr]) -> Iterator[str]:
    yield from _rows([f"{latex_name(symbol.name)} &= {latex_expression(made)}" for symbol, made in table.items()])


def _align(equations: Iterable[Equation]) -> Iterator[str]:
    yield from _rows([equation.latex() for equation in equations])


def _rows(rows: Sequence[str]) -> Iterator[str]:
    if not rows:
        return
    yield r"\begin{align*}"
    yield from (rf"  {row} \\" for row in rows[:-1])
    yield f"  {rows[-1]}"
    yield r"\end{align*}"


def _table(columns: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield rf"\begin{{longtable}}{{{columns}}}"
    yield " & ".join(head) + r" \\ \hline"
    yield from (" & ".join(escape(cell) for cell in row) + r" \\" for row in rows)
    yield r"\end{longtable}"


def _reduction(found: Derivation) -> Iterator[str]:
    rows = [(rule.rule, rule.element, rule.why) for rule in found.rules]
    yield from _table(r"lp{0.25\linewidth}p{0.5\linewidth}", ("rule", "element", "why"), rows)
    count = max(len(found.modes_before), len(found.modes_after))
    modes = [(_mode(found.modes_before, k), _mode(found.modes_after, k)) for k in range(count)]
    yield from _table("rr", ("mode before", "after"), modes)


def _mode(modes: Sequence[Mode], number: int) -> str:
    if number >= len(modes):
        return "left out"
    mode = modes[number]
    rigid = mode.frequency_hz == 0
    return "rigid body" if rigid else f"{mode.frequency_hz:.4g} Hz, {percent(mode.damping_ratio)}"


def _reduced(found: Derivation) -> Iterator[str]:
    equations = found.reduced_motion
    yield from _align((*equations.balances, *equations.shafts, *equations.twists))
    yield from _abbreviations(equations)
    if found.used_definitions:
        yield "Equivalent shafts:"
        yield from _definitions(found.used_definitions)
    yield from _table(
        "lr",
        ("parameter (SI)", "value"),
        [(name, f"{value:.6g}") for name, value in found.reduced_parameters.items()],
    )


def _degrees(found: Derivation) -> Iterator[str]:
    decoupling = found.decoupling
    pairs = zip(decoupling.outputs, decoupling.relative_degrees, strict=True)
    yield from _table("lr", ("output", "relative degree"), [(name, str(degree)) for name, degree in pairs])
    total = sum(decoupling.relative_degrees)
    yield rf"Total {total} of order {decoupling.system.order}: internal dynamics of order {decoupling.internal_order}."


def _matrix(found: Derivation) -> Iterator[str]:
    matrix = found.decoupling.matrix
    rows = [
        " & ".join(latex_expression(sp.factor(matrix[row, column])) for column in range(matrix.cols))
        for row in range(matrix.rows)
    ]
    yield r"\begin{align*}"
    yield r"  \begin{bmatrix}"
    yield from (rf"    {row} \\[1ex]" for row in rows[:-1])
    yield f"    {rows[-1]}"
    yield r"  \end{bmatrix}"
    yield r"\end{align*}"


def _gains(found: Derivation) -> Iterator[str]:
    rows = [(gain.machine, gain.description, f"{gain.value:.5g}", gain.unit) for gain in found.gains]
    yield from _table("llrl", ("machine", "gain", "value", "unit"), rows)


def _stability(found: Derivation) -> Iterator[str]:
    """Write factors and admissible gains of the decoupled loop."""
    setting = found.stability.settings[0]
    rows, bounds = [], []
    for proven in setting.factors:
        factor = proven.factor
        terms = []
        for k, value in enumerate(factor.coefficients):
            exponent = factor.degree - k
            power = ("s" if exponent == 1 else f"s^{{{exponent}}}") if exponent else ""
            written = "" if value == 1 and power else latex_expression(value)
            if isinstance(value, sp.Add) and power:
                written = rf"\left({written}\right)"
            if value != 0:
                terms.append(rf"{written}\,{power}" if written and power else written + power)
        rows.append(rf"\Delta_{{\text{{{escape(factor.name)}}}}}(s) &= {' + '.join(terms)}".replace("+ -", "- "))
        for gain in proven.gains:
            if gain.closed_form is not None:
                lower, upper = gain.closed_form.lower, gain.closed_form.upper
                left = "" if lower is None else f"{latex_expression(lower)} < "
                right = "" if upper is None else f" < {latex_expression(upper)}"
                bounds.append(f"{left}{latex_name(gain.gain.name)}{right}")
    yield "The characteristic polynomial of the decoupled loop, without sampling, is the product of"
    yield from _rows(rows)
    yield f"With the gains above it is {escape(setting.verdict.value)}."
    if bounds:
        yield "Admissible gains:"
        yield from _rows([f"& {row}" for row in bounds])

"""Derivations: the equations that people read are the ones that the code is made from."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp

from ptgen.report.derivation import derivation
from ptgen.report.derivation_latex import derivation_latex, escape
from ptgen.report.formulas import Equation, Kind, Term, latex_name, text_expression
from ptgen.report.motion import motion


@pytest.fixture(scope="module")
def found(project):
    return derivation(project)


@pytest.mark.parametrize("stage", ["full", "reduced"])
def test_equations_of_motion_are_those_of_the_model(project, stage):
    model = project.model if stage == "full" else project.reduced.model
    orientation = project.mechanism.orientation if stage == "full" else None
    equations = motion(model, orientation)
    values = dict(model.values)
    for symbol, expression in equations.abbreviations.items():
        values[symbol] = float(expression.subs(values))
    random = np.random.default_rng(1)
    z, e = random.normal(size=len(model.coordinates)), random.normal(size=len(model.twists))
    u, f = random.normal(size=len(model.inputs)), random.normal(size=len(model.frictions))
    numeric = model.numeric()
    rates = numeric.twist_rows @ z

    known = dict(zip([(Kind.VELOCITY, name) for name in model.coordinates], z, strict=True))
    known |= dict(zip([(Kind.TWIST, name) for name in model.twists], e, strict=True))
    known |= dict(zip([(Kind.AIR_GAP, torque.name) for torque in model.inputs], u, strict=True))

    def evaluate(terms):
        return sum(float(term.coefficient.subs(values)) * known[term.kind, term.name] for term in terms)

    for equation, rate in zip(equations.twists, rates, strict=True):
        known[Kind.RATE, equation.left[0].name] = evaluate(equation.right)
        assert known[Kind.RATE, equation.left[0].name] == pytest.approx(rate)
    for equation in equations.shafts:
        known[Kind.SHAFT, equation.left[0].name] = evaluate(equation.right)
    for slip, torque in zip(equations.slips, f, strict=True):
        viscous = float(sp.sympify(slip.friction.linear_viscous).subs(values))
        known[Kind.FRICTION, slip.friction.name] = torque + viscous * evaluate(slip.velocity)

    E, G, B = numeric.twist_rows, numeric.friction_rows, numeric.input_rows
    wanted = B.T @ u - E.T @ (numeric.stiffness @ e + numeric.damping @ rates)
    wanted = wanted - G.T @ (f + numeric.viscous @ G @ z)
    np.testing.assert_allclose([evaluate(b.right) for b in equations.balances], wanted, rtol=1e-9, atol=1e-9)
    for row, equation in zip(numeric.mass, equations.balances, strict=True):
        masses = dict.fromkeys(model.coordinates, 0.0)
        masses |= {term.name: float(term.coefficient.subs(values)) for term in equation.left}
        np.testing.assert_allclose(list(masses.values()), row)


def test_law_terms_add_up_to_the_law(found):
    for name, expression in found.decoupling.law_expressions().items():
        terms = found.law[name].right
        total = sum(term.coefficient * sp.Symbol(term.name) for term in terms)
        assert sp.simplify(total - expression) == 0
        assert all(term.note for term in terms)
        assert terms[0].name == f"v_{name}"


def test_latex_is_balanced(found):
    text = derivation_latex(found)
    plain = re.sub(r"\\[{}]", "", text)
    depth = 0
    for letter in plain:
        depth += (letter == "{") - (letter == "}")
        assert depth >= 0
    assert depth == 0
    open_environments = []
    for kind, name in re.findall(r"\\(begin|end)\{([a-z*]+)\}", text):
        if kind == "begin":
            open_environments.append(name)
        else:
            assert open_environments.pop() == name
    assert not open_environments
    assert text.count(r"\left(") == text.count(r"\right)")


def test_latex_escapes_what_is_no_formula(found):
    text = derivation_latex(found)
    outside = re.sub(r"\\begin\{align\*\}.*?\\end\{align\*\}", "", text, flags=re.DOTALL)
    outside = "\n".join(line for line in outside.splitlines() if not line.startswith("%"))
    assert not re.search(r"(?<!\\)[_#^]", outside.replace("$w$", ""))
    assert not re.search(r"(?<!\\)%", outside)
    roman = re.findall(r"\\mathrm\{([^{}]*)\}", text)
    assert roman and not any(re.search(r"(?<!\\)_", name) for name in roman)


def test_latex_formulas_can_be_typeset(found):
    from matplotlib.mathtext import MathTextParser

    parser = MathTextParser("path")
    blocks = re.findall(r"\\begin\{align\*\}(.*?)\\end\{align\*\}", derivation_latex(found), flags=re.DOTALL)
    rows = [row.strip() for block in blocks if "bmatrix" not in block for row in block.split(r"\\")]
    assert len(rows) > 10
    for row in rows:
        parser.parse(f"${row.replace('&', '')}$")


def test_text_and_latex_of_an_equation():
    damping, ratio = sp.symbols("M1_damping diff_ratio", positive=True)
    equation = Equation(
        (Term(sp.Integer(1), Kind.AIR_GAP, "M1"),),
        (
            Term(-damping * ratio / 2, Kind.SIGNAL, "M2_speed"),
            Term(damping + 1, Kind.ACCELERATION, "M1.shaft"),
            Term(1 / ratio, Kind.RATE, "flange_1"),
        ),
    )
    assert equation.text() == (
        "T_ag(M1) = −M1_damping·diff_ratio·M2_speed/2 + (M1_damping + 1)·dω(M1)/dt + 1/diff_ratio·dφ(flange_1)/dt"
    )
    assert equation.latex() == (
        r"T_{\mathrm{ag},\mathrm{M1}} &= -\frac{d_{\mathrm{M1}} i_{\mathrm{diff}}}{2}\,\omega_{\mathrm{M2}}"
        r" + \left(d_{\mathrm{M1}} + 1\right)\,\dot\omega_{\mathrm{M1}}"
        r" + \frac{1}{i_{\mathrm{diff}}}\,\Delta\dot\varphi_{\mathrm{flange\_1}}"
    )
    assert Equation((), ()).text() == "0 = 0"


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("v_M1", r"v_{\mathrm{M1}}"),
        ("flange1_torque", r"T_{\mathrm{flange1}}"),
        ("M1_inertia_estimate", r"\hat I_{\mathrm{M1}}"),
        ("diff_inertia_pinion", r"I_{\mathrm{diff,pinion}}"),
        ("k_12", "k_{12}"),
        ("x_y", r"\mathrm{x\_y}"),
    ],
)
def test_symbols_of_the_literature(name, wanted):
    assert latex_name(name) == wanted


def test_numbers_are_short():
    x = sp.Symbol("x")
    assert text_expression(sp.Float(10.3) * x + sp.Float(2.0)) == "10.3·x + 2"


def test_escape_leaves_no_special_letters():
    assert escape(r"a_b%c\d{e}") == r"a\_b\%c\textbackslash{}d\{e\}"

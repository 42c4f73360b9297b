"""Friction laws as text, LaTeX and formulas for programs: complete, and those of the source."""

from __future__ import annotations

import math
import re

import pytest
import sympy as sp
from components.friction_laws import limit_of, torque_of
from components.loose_component import CASES, case
from matplotlib.mathtext import MathTextParser

from ptgen.elements import Friction
from ptgen.report.formulas import latex_expression
from ptgen.report.friction_law import LATEX, PLAIN, TEXT, friction_law

ELEMENTS = [
    pytest.param(name, index, id=f"{name}, {friction.name}")
    for name in CASES
    for index, friction in enumerate(case(name).elements("x").frictions)
]


def element(name: str, index: int) -> tuple[Friction, dict[sp.Symbol, float]]:
    component = case(name)
    values = {parameter.symbol: parameter.value for parameter in component.parameters("x")}
    return component.elements("x").frictions[index], values


@pytest.mark.parametrize(("name", "index"), ELEMENTS)
def test_formula_for_programs_is_the_law(name: str, index: int) -> None:
    friction, values = element(name, index)
    law = friction_law(friction, PLAIN)
    table = {symbol.name: value for symbol, value in values.items()}
    for w, angle, load, mu in ((-0.3, 1.0, 40.0, 0.7), (25.0, -2.0, -7.0, 1.0), (-80.0, 0.1, 0.0, 0.2)):
        w = -abs(w) if friction.one_way else w
        mu = mu if friction.actuated else 1.0
        known = {**table, "w": w, "angle": angle, "T_place": load, "mu": mu}
        slipping, at_rest = (float(sp.sympify(text).subs(known)) for text in (law.slipping, law.at_rest))
        assert slipping == pytest.approx(torque_of(friction, values, w, angle, load, mu))
        sign = -1 if friction.one_way else 1
        assert sign * at_rest == pytest.approx(limit_of(friction, values, angle, load, mu))


@pytest.mark.parametrize(("name", "index"), ELEMENTS)
def test_every_parameter_stands_in_text_and_latex(name: str, index: int) -> None:
    friction, _ = element(name, index)
    parts = [friction.coulomb, friction.viscous, friction.stribeck_speed]
    if friction.saturated is not None:
        parts += [friction.saturated.slope, friction.saturated.speed]
    if friction.ripple is not None:
        parts += [friction.ripple.amplitude, friction.ripple.phase]
    if friction.load is not None:
        parts.append(friction.load.coefficient)
    if friction.stribeck_speed is None:  # then the static torque counts at rest only
        assert friction.static is None or friction.static.name in friction_law(friction, TEXT).at_rest
    else:
        parts.append(friction.static)
    text, latex = friction_law(friction, TEXT), friction_law(friction, LATEX)
    for part in parts:
        if part:  # a component may have no viscous friction at all
            assert part.name in text.slipping
            assert latex_expression(part) in latex.slipping
    assert ("μ(" in text.slipping) == (r"\mu" in latex.slipping) == friction.actuated
    assert text.same == (friction.static is None and not friction.one_way)


@pytest.mark.parametrize(("name", "index"), ELEMENTS)
def test_latex_can_be_typeset(name: str, index: int) -> None:
    friction, _ = element(name, index)
    law = friction_law(friction, LATEX)
    parser = MathTextParser("path")
    for formula in (law.slipping, law.at_rest):
        assert not re.search(r"(?<!\\)_\w*_", formula.replace("_{", ""))
        assert formula.count(r"\left") == formula.count(r"\right")
        parser.parse(f"${formula.replace('&', '')}$")


def test_laws_read_like_the_source() -> None:
    (dry,) = case("dry clutch").elements("c1").frictions
    law = friction_law(dry, TEXT)
    assert law.slipping == "μ(c1)·(c1_capacity·sign(w) + c1_viscous·w)"
    assert law.at_rest == "|T_fr(c1)| ≤ μ(c1)·c1_capacity"
    (bearing,) = case("bearing").elements("b1").frictions
    assert friction_law(bearing, TEXT).slipping == (
        "((1 + b1_ripple_amplitude·sin(2·∫w dt + b1_ripple_phase))"
        "·(b1_coulomb + (b1_static − b1_coulomb)·exp(−|w|/b1_stribeck_speed))"
        " + b1_saturation_slope·min(|w|, b1_saturation_speed))·sign(w) + b1_viscous·w"
    )
    (wheel,) = case("freewheel").elements("f1").frictions
    law = friction_law(wheel, TEXT)
    assert (law.slipping, law.at_rest) == ("−f1_drag + f1_viscous·w", "T_fr(f1) ≥ −f1_drag")


def test_small_slips_of_a_clutch_begin_at_its_limit() -> None:
    """(3.12) at zero velocity is (4.2): text and model agree on where sticking ends."""
    friction, values = element("clutch", 0)
    law = friction_law(friction, PLAIN)
    known = {**{s.name: v for s, v in values.items()}, "w": 1e-12, "angle": 0.3, "mu": 0.5}
    beginning, limit = (float(sp.sympify(text).subs(known)) for text in (law.slipping, law.at_rest))
    assert math.isclose(beginning, limit, rel_tol=1e-9)

"""The law of a friction element as people read it: its torque while it slips, and what it holds at rest."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from ptgen.elements import Friction
from ptgen.report.formulas import latex_expression, text_expression

__all__ = ["LATEX", "PLAIN", "TEXT", "FrictionLaw", "Style", "friction_law"]


@dataclass(frozen=True)
class Style:
    """How the parts of a law are written; the fields in braces are filled in.

    Attributes
    ----------
    expression, named : callable
        Write an expression of parameters, and the name of an element or a place.
    velocity, torque, actuation : str
        The element's velocity and torque and its actuation, of the element's `name`.
    place : str
        The size of the torque at a `name`.
    product, minus, bracket, sign, decay, least, swell : str
        A product of two, and the functions of the velocity.
    at_most, at_least : str
        What the torque is at rest.
    """

    expression: Callable[[sp.Expr], str]
    named: Callable[[str], str]
    velocity: str
    torque: str
    actuation: str
    place: str
    product: str
    minus: str
    bracket: str
    sign: str
    decay: str
    least: str
    swell: str
    at_most: str
    at_least: str


TEXT = Style(
    expression=text_expression,
    named=str,
    velocity="w",
    torque="T_fr({name})",
    actuation="μ({name})",
    place="|T({name})|",
    product="{}·{}",
    minus="−",
    bracket="({})",
    sign="sign({w})",
    decay="exp(−|{w}|/{speed})",
    least="min(|{w}|, {speed})",
    swell="(1 + {amplitude}·sin({order}·∫{w} dt + {phase}))",
    at_most="|{torque}| ≤ {limit}",
    at_least="{torque} ≥ {limit}",
)
"""For the terminal."""

LATEX = Style(
    expression=latex_expression,
    named=lambda name: name.replace("_", r"\_"),
    velocity=r"w_{{\mathrm{{{name}}}}}",
    torque=r"T_{{\mathrm{{fr}},\mathrm{{{name}}}}}",
    actuation=r"\mu_{{\mathrm{{{name}}}}}",
    place=r"\left|T_{{\mathrm{{{name}}}}}\right|",
    product=r"{}\,{}",
    minus="-",
    bracket=r"\left({}\right)",
    sign=r"\operatorname{{sgn}} {w}",
    decay=r"e^{{-\left|{w}\right|/{speed}}}",
    least=r"\min\left(\left|{w}\right|, {speed}\right)",
    swell=r"\left(1 + {amplitude}\,\sin\left({order} \int {w}\,dt + {phase}\right)\right)",
    at_most=r"\left|{torque}\right| &\leq {limit}",
    at_least=r"{torque} &\geq {limit}",
)
"""For documents."""

PLAIN = Style(
    expression=sp.sstr,
    named=str,
    velocity="w",
    torque="T",
    actuation="mu",
    place="Abs(T_place)",
    product="{}*{}",
    minus="-",
    bracket="({})",
    sign="sign({w})",
    decay="exp(-Abs({w})/{speed})",
    least="Min(Abs({w}), {speed})",
    swell="(1 + {amplitude}*sin({order}*angle + {phase}))",
    at_most="{limit}",
    at_least="{limit}",
)
"""For programs: sympy reads it, with w, angle, mu and T_place as symbols."""


@dataclass(frozen=True)
class FrictionLaw:
    """A law in words of one style.

    Attributes
    ----------
    slipping : str
        The torque while it slips.
    at_rest : str
        The limit of the torque at rest.
    same : bool
        Whether the limit at rest is that of slipping, so that nobody needs to be told.
    """

    slipping: str
    at_rest: str
    same: bool


def friction_law(friction: Friction, style: Style) -> FrictionLaw:
    """Write the law of a friction element.

    Parameters
    ----------
    friction : Friction
    style : Style

    Examples
    --------
    >>> from ptgen.elements import FrictionRole
    >>> T_c, T_s, k = sp.symbols("T_c T_s k")
    >>> law = friction_law(Friction("c", {}, T_c, k, FrictionRole.COUPLING, static=T_s, actuated=True), TEXT)
    >>> law.slipping, law.at_rest
    ('μ(c)·(T_c·sign(w) + k·w)', '|T_fr(c)| ≤ μ(c)·T_s')
    """
    write, name = style.expression, style.named(friction.name)
    w = style.velocity.format(name=name)
    levels = [write(friction.coulomb)]
    limits = [write(friction.at_rest)]
    if friction.load is not None and friction.load.coefficient != 0:
        place = style.place.format(
            name=friction.load.place.replace("_", r"\_") if style is LATEX else friction.load.place
        )
        term = style.product.format(write(friction.load.coefficient), place)
        levels.append(term)
        limits.append(term)
    if friction.static is not None and friction.stribeck_speed is not None:
        above = style.bracket.format(f"{write(friction.static)} {style.minus} {write(friction.coulomb)}")
        decay = style.decay.format(w=w, speed=write(friction.stribeck_speed))
        levels.append(style.product.format(above, decay))
    level, limit = _Sum(levels, style), _Sum(limits, style)
    if friction.ripple is not None:
        swell = style.swell.format(
            amplitude=write(friction.ripple.amplitude),
            order=friction.ripple.order,
            w=w,
            phase=write(friction.ripple.phase),
        )
        level, limit = (_Sum([style.product.format(swell, part.factor)], style) for part in (level, limit))
    if friction.saturated is not None:
        least = style.least.format(w=w, speed=write(friction.saturated.speed))
        level = _Sum([*level.terms, style.product.format(write(friction.saturated.slope), least)], style)
    viscous = [style.product.format(write(friction.viscous), w)] if friction.viscous != 0 else []
    torque = style.torque.format(name=name)
    if friction.one_way:  # it slips backwards only
        slipping = _Sum([f"{style.minus}{level.factor}", *viscous], style)
        at_rest = style.at_least.format(torque=torque, limit=f"{style.minus}{limit.factor}")
        return FrictionLaw(slipping.text, at_rest, same=False)
    slipping = _Sum([style.product.format(level.factor, style.sign.format(w=w)), *viscous], style)
    if friction.actuated:
        actuation = style.actuation.format(name=name)
        slipping, limit = (_Sum([style.product.format(actuation, part.factor)], style) for part in (slipping, limit))
    at_rest = style.at_most.format(torque=torque, limit=limit.text)
    return FrictionLaw(slipping.text, at_rest, same=friction.static is None)


@dataclass(frozen=True)
class _Sum:
    """A sum of written terms; as a factor it gets brackets unless it is one term only."""

    terms: list[str]
    style: Style

    @property
    def text(self) -> str:
        return " + ".join(self.terms)

    @property
    def factor(self) -> str:
        return self.text if len(self.terms) == 1 else self.style.bracket.format(self.text)

"""One gear: which elements hold it, its ratio, and all that follows from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from ptgen.gears.layout import Layout
from ptgen.gears.speeds import Speed, formula_speeds, number_speeds, slips
from ptgen.gears.statics import Balance, balance

__all__ = ["Gear", "gear_of"]


@dataclass(frozen=True)
class Gear:
    """A combination of engaged elements in which the output turns with the input.

    Attributes
    ----------
    name : str
        As in the shift table; otherwise counted.
    named : bool
        Whether the shift table names it.
    engaged : tuple of str
        The elements that are engaged, idle ones included.
    needed : tuple of str
        The least elements that make the gear.
    alternatives : tuple of tuple of str
        All combinations that make the same gear, as `needed` and idle elements do.
    degrees_of_freedom : int
        Independent velocities; more than one if branches turn idle.
    ratio : Fraction
        Velocity of the input over that of the output.
    formula : sympy.Expr or None
        The ratio in g1, i1 and so on; None if it holds for the values of the ratios only.
    speeds : mapping of str to Speed
        Of every member.
    slips : mapping of str to Speed
        Relative velocity of every open element.
    ideal : Balance
        Torques without losses.
    drive, coast : Balance or None
        Torques with losses, the input driving the output and the reverse; None if the gear locks itself, or if
        freewheels overrun.
    overruns : tuple of str
        Freewheels that hold in drive and release in coast.
    """

    name: str
    named: bool
    engaged: tuple[str, ...]
    needed: tuple[str, ...]
    alternatives: tuple[tuple[str, ...], ...]
    degrees_of_freedom: int
    ratio: Fraction
    formula: sp.Expr | None
    speeds: Mapping[str, Speed]
    slips: Mapping[str, Speed]
    ideal: Balance
    drive: Balance | None
    coast: Balance | None
    overruns: tuple[str, ...] = ()

    @property
    def idle(self) -> tuple[str, ...]:
        """Engaged elements that the gear does not need."""
        return tuple(name for name in self.engaged if name not in self.needed)


def gear_of(
    layout: Layout,
    name: str,
    engaged: Sequence[str],
    needed: Sequence[str],
    *,
    named: bool,
    alternatives: Sequence[tuple[str, ...]],
    degrees_of_freedom: int,
) -> Gear:
    """Return the gear that a combination of elements makes."""
    numbers = number_speeds(layout, engaged)
    formulas = formula_speeds(layout, engaged)
    confirmed = {
        member: formula
        for member, formula in formulas.items()
        if numbers[member] is not None and _value(layout, formula) == numbers[member]
    }
    speeds = {member: Speed(value, confirmed.get(member)) for member, value in numbers.items()}
    out = speeds[layout.output]
    floats = {member: None if value is None else float(value) for member, value in numbers.items()}
    ideal = balance(layout, engaged, floats, losses=False)
    if out.value is None or ideal is None:
        raise ValueError(f"{', '.join(engaged)} make no gear")
    one_way = [element.name for element in layout.elements if element.one_way]
    overruns = tuple(name for name in one_way if ideal.elements.get(name, 0.0) != 0.0)
    return Gear(
        name=name,
        named=named,
        engaged=tuple(engaged),
        needed=tuple(needed),
        alternatives=tuple(alternatives),
        degrees_of_freedom=degrees_of_freedom,
        ratio=1 / out.value,
        formula=None if out.formula is None else sp.factor(1 / out.formula),
        speeds=speeds,
        slips=slips(layout, engaged, speeds),
        ideal=ideal,
        drive=balance(layout, engaged, floats, losses=True),
        coast=None if overruns else balance(layout, engaged, floats, losses=True, coast=True),
        overruns=overruns,
    )


def _value(layout: Layout, formula: sp.Expr) -> Fraction:
    values = {symbol: sp.Rational(v.numerator, v.denominator) for symbol, v in layout.values.items()}
    number = sp.Rational(formula.subs(values))
    return Fraction(int(number.p), int(number.q))

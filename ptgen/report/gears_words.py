"""Gears in words: formulas of ratios, combinations, changes, and what there is to know about a gear set."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import sympy as sp
from sympy.printing.str import StrPrinter

from ptgen.gears.analysis import GearAnalysis
from ptgen.gears.changes import Change, Exchange
from ptgen.gears.combinations import Combination, State
from ptgen.gears.gear import Gear
from ptgen.gears.layout import Train, TrainKind

__all__ = [
    "change_text",
    "combination_text",
    "findings",
    "number_text",
    "plural",
    "ratio_text",
    "summary",
    "train_text",
    "way_text",
]


class _RatioPrinter(StrPrinter):  # type: ignore[misc]
    """Writes sums as gear makers do: the constant first, unless it is subtracted."""

    def _as_ordered_terms(self, expr: sp.Add, order: str | None = None) -> list[sp.Expr]:
        return sorted(
            expr.args,
            key=lambda term: (
                term.could_extract_minus_sign(),
                len(term.free_symbols),
                sorted(symbol.name for symbol in term.free_symbols),
                str(term),
            ),
        )


def ratio_text(formula: sp.Expr | None) -> str:
    """Return a formula of ratios as text; nothing if there is none.

    Examples
    --------
    >>> g1, g2 = sp.symbols("g1 g2", positive=True)
    >>> ratio_text(g1 * (g2 + 1) / (g1 * g2 - 1))
    'g1·(1 + g2)/(g1·g2 - 1)'
    """
    if formula is None:
        return ""
    text = str(_RatioPrinter().doprint(formula))
    return text.replace("**2", "²").replace("**3", "³").replace("**", "^").replace("*", "·")


def number_text(value: Fraction | float | None, digits: int = 3) -> str:
    """Return a number with fixed digits; what a gear leaves free is free.

    Examples
    --------
    >>> number_text(Fraction(10, 3)), number_text(None), number_text(-1e-12)
    ('3.333', 'free', '0.000')
    """
    if value is None:
        return "free"
    text = f"{float(value):.{digits}f}"
    return text.removeprefix("-") if float(text) == 0 else text


def train_text(train: Train) -> str:
    """Return what the symbol of a train stands for."""
    ratio = train.ratio
    quotient = f"{ratio.numerator}/{ratio.denominator}"
    short = quotient if ratio.denominator > 1 and len(quotient) <= 9 else ""
    value = " = ".join(part for part in (short, f"{float(ratio):.5g}") if part)
    pinions = ", double pinions" if _is_double(train) else ""
    loss = f", loses {100 * train.loss.coefficient:.3g} %" if train.loss is not None else ""
    return f"{train.symbol} = {value}: {train.kind.value} {train.name}{pinions}{loss}"


def _is_double(train: Train) -> bool:
    return train.kind is TrainKind.PLANETARY_SET and train.numbers["ring"] < 0


def combination_text(found: Combination, gear: Gear | None) -> str:
    """Return what a combination of elements does."""
    if found.state is State.NEUTRAL:
        return "neutral"
    if found.state is State.TIE_UP:
        return f"tie-up: {' and '.join(found.blocked)} cannot turn"
    if gear is None:
        return "gear"
    idle = [name for name in found.engaged if name not in gear.needed]
    with_idle = f", {', '.join(idle)} idle" if idle else ""
    return f"gear {gear.name}{with_idle}"


def change_text(change: Change) -> str:
    """Return a change as a table shows it: released > applied; a star where idle elements prepare it.

    Examples
    --------
    >>> change_text(Change("1", "2", ("B",), ("D",)))
    'B>D'
    >>> change_text(Change("1", "2", ("K1",), ("K2",), Exchange((), ("S2",)), Exchange(("S1",), ())))
    'K1>K2*'
    >>> change_text(Change("1", "9", ("C", "E"), ("A", "F")))
    '·'
    """
    if not change.is_single:
        return "·"
    star = "*" if change.before or change.after else ""
    return f"{''.join(change.release)}>{''.join(change.apply)}{star}"


def summary(found: GearAnalysis) -> str:
    """Return the counts of combinations."""
    counts = {state: sum(one.state is state for one in found.combinations) for state in State}
    free = plural(found.combinations[0].degrees_of_freedom, "degree") + " of freedom"
    gears = plural(len(found.gears), "gear")
    return (
        f"{len(found.layout.elements)} shift elements, {free} with all open; "
        f"{len(found.combinations)} combinations: {counts[State.GEAR]} make {gears}, "
        f"{counts[State.NEUTRAL]} are neutral, {counts[State.TIE_UP]} tie up"
    )


def plural(count: int, word: str) -> str:
    """Return a count with its word.

    Examples
    --------
    >>> plural(1, "gear"), plural(0, "gear")
    ('1 gear', '0 gears')
    """
    return f"{count} {word}{'' if count == 1 else 's'}"


def findings(found: GearAnalysis) -> Iterator[str]:
    """Yield what is worth knowing about the gears and is no problem of the file."""
    named = any(gear.named for gear in found.gears)
    for gear in found.gears:
        if named and not gear.named:
            yield f"{gear.name} gives {float(gear.ratio):.4g}, a gear that the shift table does not name"
    for gear in found.listed:
        if gear.idle:
            verb = "make" if len(gear.needed) > 1 else "makes"
            yield f"{gear.name}: {_listed(gear.idle)} idle; {_listed(gear.needed)} {verb} the gear"
        if gear.overruns:
            many = len(gear.overruns) > 1
            verbs = ("hold", "overrun") if many else ("holds", "overruns")
            yield f"{gear.name}: {_listed(gear.overruns)} {verbs[0]} in drive and {verbs[1]} in coast"
        if gear.formula is None:
            yield f"{gear.name}: a gear at these ratios only; for others there would be no formula"
        if gear.ideal.undetermined:
            torques = "torques of least norm are given"
            yield f"{gear.name}: {_listed(gear.ideal.undetermined)} hold the same motion; {torques}"
        for side, one in (("drive", gear.drive), ("coast", gear.coast)):
            if one is None and not (side == "coast" and gear.overruns):
                yield f"{gear.name}: locks itself in {side}: the losses eat all power"
            elif one is not None and one.consistent > 1:
                yield f"{gear.name}: {one.consistent} patterns of power flow are consistent in {side}"


def way_text(change: Change) -> str:
    """Return a change in words.

    Examples
    --------
    >>> way_text(Change("1", "2", ("K1",), ("K2",), Exchange((), ("S2",)), Exchange(("S1",), ())))
    'to 2: close S2, then release K1 and apply K2, then open S1'
    """
    load = [f"{word} {_listed(n)}" for word, n in (("release", change.release), ("apply", change.apply)) if n]
    parts = [_idle(change.before), " and ".join(load), _idle(change.after)]
    return f"to {change.end}: {', then '.join(part for part in parts if part)}"


def _idle(exchange: Exchange) -> str:
    moves = [f"{word} {_listed(n)}" for word, n in (("open", exchange.release), ("close", exchange.apply)) if n]
    return " and ".join(moves)


def _listed(names: Sequence[str]) -> str:
    return " and ".join(part for part in (", ".join(names[:-1]), names[-1]) if part)

"""The shift table of a part compared with what its layout can do."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ptgen.errors import Problem, nearest
from ptgen.gears.combinations import Combination, State, combinations, free_motions
from ptgen.gears.freewheels import with_freewheels
from ptgen.gears.layout import Layout, TrainKind
from ptgen.gears.vectors import combined

__all__ = ["NEUTRAL", "gear_ratios", "listed", "needed_of", "shift_table_problems"]

NEUTRAL = "N"
"""The one name in a shift table whose elements may leave the output free."""


def gear_ratios(layout: Layout, table: Mapping[str, Sequence[str]]) -> dict[str, float]:
    """Return the ratio of input to output speed of every gear of a shift table, the neutral left out.

    Parameters
    ----------
    layout : Layout
    table : mapping of str to sequence of str
        Gear -> engaged elements.
    """
    every = combinations(layout)
    named = ((gear, with_freewheels(layout, every, engaged)) for gear, engaged in table.items())
    return {gear: float(found.ratio) for gear, found in named if found is not None and found.ratio is not None}


def shift_table_problems(layout: Layout, table: Mapping[str, Sequence[str]], where: str = "gears") -> list[Problem]:
    """Return what is wrong with a gear set and its shift table.

    Gears that do not exist or tie up, that leave the output free, or that name unknown elements; the same gear twice;
    elements that no gear of the layout needs; sets with two flanges on one member; an input or an output that cannot
    turn at all.

    Parameters
    ----------
    layout : Layout
    table : mapping of str to sequence of str
        Gear -> engaged elements.
    where : str
        Where the table stands in the file.

    Returns
    -------
    list of Problem
        Empty if all is well.
    """
    every = combinations(layout)
    return [*_layout_problems(layout), *_element_problems(layout, every), *_gear_problems(layout, table, every, where)]


def needed_of(every: Sequence[Combination], engaged: Sequence[str]) -> tuple[str, ...]:
    """Return the fewest of the engaged elements that make a gear."""
    names = set(engaged)
    return next((found.engaged for found in every if found.state is State.GEAR and names.issuperset(found.engaged)), ())


def _gear_problems(
    layout: Layout, table: Mapping[str, Sequence[str]], every: Sequence[Combination], where: str
) -> list[Problem]:
    problems = []
    first: dict[tuple[str, ...], str] = {}
    for gear, engaged in table.items():
        place = f"{where}.{gear}"
        unknown = [name for name in dict.fromkeys(engaged) if name not in layout.element_names]
        problems += [
            Problem(place, f'"{name}" is no shift element', nearest(name, layout.element_names)) for name in unknown
        ]
        found = None if unknown else with_freewheels(layout, every, engaged)
        if found is None:
            continue
        if found.state is State.GEAR:
            needed = needed_of(every, found.engaged)
            other = first.setdefault(needed, gear)
            if other != gear:
                what = f"is the same gear as {other}: {listed(needed)} make both"
                problems.append(Problem(place, what, "remove one of them, or engage other elements"))
        elif gear != NEUTRAL or found.state is State.TIE_UP:
            problems.append(Problem(place, _what_is_wrong(found), _remedy(found, gear, table, every)))
    return problems


def _what_is_wrong(found: Combination) -> str:
    if found.state is State.NEUTRAL:
        return (
            f"is no gear: with {listed(found.engaged)} engaged the output turns independently of the input "
            f"({found.degrees_of_freedom} degrees of freedom)"
        )
    ends = " and ".join(found.blocked)
    return f"ties up: with {listed(found.engaged)} engaged the {ends} cannot turn"


def _remedy(found: Combination, gear: str, table: Mapping[str, Sequence[str]], every: Sequence[Combination]) -> str:
    """Say which gears that no name was given to lie next to the combination."""
    taken = {needed_of(every, engaged) for engaged in table.values()}
    free = [c for c in every if c.state is State.GEAR and needed_of(every, c.engaged) == c.engaged]
    free = [c for c in free if c.engaged not in taken]
    size = len(found.engaged)
    near = sorted(free, key=lambda c: (len(set(c.engaged) ^ set(found.engaged)), abs(len(c.engaged) - size)))[:3]
    shown = "; ".join(f"{listed(c.engaged)} give {float(c.ratio or 0):.4g}" for c in near)
    if shown:
        return f"engage other elements, e.g. {shown}"
    ask = "see `ptgen gears FILE --all` for what each combination does"
    if found.state is State.NEUTRAL:
        return f"call it {NEUTRAL}, or engage more elements; {ask}"
    return f"engage other elements, or remove the gear; {ask}"


def _element_problems(layout: Layout, every: Sequence[Combination]) -> list[Problem]:
    needed: set[str] = set()
    gears = [found for found in every if found.state is State.GEAR]
    for found in gears:
        if not any(other is not found and set(other.engaged) < set(found.engaged) for other in gears):
            needed.update(found.engaged)
    problems = []
    part = f" of {layout.title}" if layout.title else ""
    for element in layout.elements:
        if element.name in needed:
            continue
        where = f"components.{element.name}"
        if not element.row:
            what = f"can never matter: both flanges of {element.name} are on one member{part}"
            remedy = "join one of its flanges elsewhere, or remove it"
        else:
            ends = " and ".join(f'"{member}"' for member in element.row)
            what = f"can never matter: no gear{part} needs {element.name}, whatever else is engaged (it acts on {ends})"
            remedy = "correct the members that it joins, or remove it"
        problems.append(Problem(where, what, remedy))
    return problems


def _layout_problems(layout: Layout) -> list[Problem]:
    problems = []
    for train in layout.trains:
        for a, b in _pairs(tuple(train.members)):
            member = train.members[a]
            if member != train.members[b]:
                continue
            effect = "turns as one block" if train.kind is TrainKind.PLANETARY_SET else "cannot turn"
            kind = train.kind.value
            what = f'{a} and {b} of {train.name} are both on the member "{member}", so that the {kind} {effect}'
            remedy = "join one of them to another member; to block it on request put a clutch between the two"
            problems.append(Problem(f"components.{train.name}", what, remedy))
    basis = free_motions(layout)
    for name, member in (("input", layout.input), ("output", layout.output)):
        if not any(combined(layout.unit_vector(member), basis)):
            what = f'the {name} (member "{member}") cannot turn, even with all elements open'
            problems.append(Problem("members", what, "check what its flanges are joined to"))
    return problems


def _pairs(names: tuple[str, ...]) -> list[tuple[str, str]]:
    return [(a, b) for k, a in enumerate(names) for b in names[k + 1 :]]


def listed(names: Sequence[str]) -> str:
    """Return names as people list them.

    Examples
    --------
    >>> listed(["A", "B", "C"])
    'A, B and C'
    """
    if not names:
        return "no elements"
    return " and ".join(part for part in (", ".join(names[:-1]), names[-1]) if part)

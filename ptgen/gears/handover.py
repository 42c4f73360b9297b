"""How a gear set comes from one gear to another: what hands over the load, and what changes without load around it.

Most changes take one element off and put one on, and the load goes from one to the other. Elements that are idle in the
gear that is left, such as the synchronisers of a branch whose clutch is open, close before; those that are idle in the
gear that follows open afterwards. Where several elements have to change on a side, any mixture of both gears may come
about on the way, and if one of them is a tie-up the shift must not overlap. An element that holds far more than it
transmits while it slips, as dogs do, neither takes nor leaves a load: if it has to, an element that both gears share
opens meanwhile.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from dataclasses import dataclass

from ptgen.gears.analysis import GearAnalysis
from ptgen.gears.changes import Change, Exchange
from ptgen.gears.combinations import State
from ptgen.gears.gear import Gear
from ptgen.gears.layout import ShiftElement
from ptgen.gears.shift_table import NEUTRAL, listed

__all__ = ["Handover", "handover", "way_round"]

_NOTHING = Exchange()

_POSITIVE = 2.0
"""An element that holds this multiple of what it transmits while it slips locks positively."""


@dataclass(frozen=True)
class Handover:
    """The elements that change from one gear to another, in the order in which they do.

    Attributes
    ----------
    release, apply : tuple of str
        Those that leave and take over the load. One that is in both opens and closes again.
    before, after : Exchange
        Idle ones that change before the load is handed over, and afterwards. What opens does so first.
    between : Exchange
        Those that change while nothing is transmitted: after `release`, before `apply`.
    obstacle : str
        Why `apply` cannot begin before `release` has ended; empty if it can.
    """

    release: tuple[str, ...] = ()
    apply: tuple[str, ...] = ()
    before: Exchange = _NOTHING
    between: Exchange = _NOTHING
    after: Exchange = _NOTHING
    obstacle: str = ""


def handover(found: GearAnalysis, start: str, end: str) -> Handover | None:
    """Return how to come from one gear of the shift table to another, or from or to neutral.

    Freewheels are left out: nobody engages them.

    Parameters
    ----------
    found : GearAnalysis
    start, end : str
        Names in the shift table; ``"N"`` is neutral, all elements open unless the table says otherwise.

    Returns
    -------
    Handover or None
        None if one of them is no gear.
    """
    first, second = found.gear(start), found.gear(end)
    if start == NEUTRAL and second is not None:
        return _from_neutral(found, second)
    if end == NEUTRAL and first is not None:
        back = _from_neutral(found, first)
        return Handover(release=back.apply, after=Exchange(back.before.apply, back.before.release))
    change = found.change(start, end)
    if first is None or second is None or change is None:
        return None
    return _between_gears(found, change, first, second)


def way_round(found: GearAnalysis, start: str, end: str) -> str | None:
    """Return the gear through which a shift can go by two that overlap: one between both if possible, else None."""
    ends = found.gear(start), found.gear(end)
    if ends[0] is None or ends[1] is None:
        return None
    low, high = sorted(1 / float(gear.ratio) for gear in ends if gear is not None)

    def far(gear: Gear) -> tuple[bool, float]:
        speed = 1 / float(gear.ratio)
        return not low < speed < high, abs(speed - 0.5 * (low + high))

    def is_free(one: str, other: str) -> bool:
        way = handover(found, one, other)
        return way is not None and not way.obstacle

    free = [gear for gear in found.listed if is_free(start, gear.name) and is_free(gear.name, end)]
    return min(free, key=far).name if free else None


def _from_neutral(found: GearAnalysis, gear: Gear) -> Handover:
    """Return how a gear is engaged: the strongest of the elements that it needs takes the load; others hold before."""
    neutral = frozenset(found.neutral or ())
    wanted = _engageable(found, gear.engaged)
    closing = [name for name in wanted if name not in neutral]
    opening = tuple(name for name in found.layout.element_names if name in neutral and name not in wanted)
    elements = _elements(found)
    candidates = [elements[name] for name in closing if name in gear.needed] or [elements[name] for name in closing]
    if not candidates:
        return Handover(before=Exchange(opening))
    last = max(candidates, key=lambda element: (not _is_positive(element), element.capacity)).name
    return Handover(apply=(last,), before=Exchange(opening, tuple(name for name in closing if name != last)))


def _between_gears(found: GearAnalysis, change: Change, first: Gear, second: Gear) -> Handover:
    elements = _elements(found)
    release, apply = _engageable(found, change.release), _engageable(found, change.apply)
    before, after = (
        Exchange(_engageable(found, side.release), _engageable(found, side.apply))
        for side in (change.before, change.after)
    )
    positive = [name for name in (*release, *apply) if _is_positive(elements[name])]
    if positive:
        hold = "hold" if len(positive) > 1 else "holds"
        obstacle = f"{listed(positive)} {hold} far more than while slipping, so no load can be handed over there"
        between = Exchange(
            tuple(name for name in release if name in positive), tuple(name for name in apply if name in positive)
        )
        opened = _relief(found, frozenset(first.engaged) & frozenset(second.engaged), between)
        if opened:
            leaving, coming = (tuple(name for name in side if name not in positive) for side in (release, apply))
            return Handover((opened, *leaving), (opened, *coming), before, between, after, obstacle)
        return Handover(release, apply, before, _NOTHING, after, obstacle)
    obstacle = "" if change.is_single else _tie_up(found, change, first)
    return Handover(release, apply, before, _NOTHING, after, obstacle)


def _relief(found: GearAnalysis, shared: frozenset[str], exchange: Exchange) -> str | None:
    """Return the strongest shared element without which the elements to exchange carry nothing, if there is one."""
    states = {frozenset(one.engaged): one.state for one in found.combinations}
    relieving = [
        element
        for element in found.layout.elements
        if element.name in shared
        and not (element.one_way or _is_positive(element))
        and all(
            states[(shared - {element.name}) | set(side)] is State.NEUTRAL
            for side in (exchange.release, exchange.apply)
        )
    ]
    return max(relieving, key=lambda element: element.capacity).name if relieving else None


def _tie_up(found: GearAnalysis, change: Change, first: Gear) -> str:
    """Say which mixture of the elements of both gears, as many as make a gear, ties up; empty if none does."""
    states = {frozenset(one.engaged): one.state for one in found.combinations}
    shared = frozenset(first.engaged) - set(change.release)
    most = max(len(change.release), len(change.apply))
    for kept in range(1, len(change.release)):
        for old, new in itertools.product(
            itertools.combinations(change.release, kept), itertools.combinations(change.apply, most - kept)
        ):
            mixed = shared.union(old, new)
            if states[mixed] is State.TIE_UP:
                names = [name for name in found.layout.element_names if name in mixed]
                return f"{listed(names)} could come to hold together on the way, which ties up"
    return ""


def _is_positive(element: ShiftElement) -> bool:
    return element.static is not None and element.static >= _POSITIVE * element.capacity


def _elements(found: GearAnalysis) -> dict[str, ShiftElement]:
    return {element.name: element for element in found.layout.elements}


def _engageable(found: GearAnalysis, names: Iterable[str]) -> tuple[str, ...]:
    elements = _elements(found)
    return tuple(name for name in names if not elements[name].one_way)

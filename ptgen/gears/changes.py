"""Which elements a shift from one gear to another releases and applies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

from ptgen.gears.combinations import Combination, State
from ptgen.gears.gear import Gear
from ptgen.gears.layout import Layout

__all__ = ["Change", "Exchange", "changes"]


@dataclass(frozen=True)
class Exchange:
    """Elements that open, and elements that close."""

    release: tuple[str, ...] = ()
    apply: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.release or self.apply)


@dataclass(frozen=True)
class Change:
    """The way from one gear to another.

    Attributes
    ----------
    start, end : str
        Names of the gears.
    release, apply : tuple of str
        Elements that open and that close while the load is handed over.
    before, after : Exchange
        Idle elements that open and close before and afterwards, without load: preselected synchronisers.
    """

    start: str
    end: str
    release: tuple[str, ...]
    apply: tuple[str, ...]
    before: Exchange = Exchange()
    after: Exchange = Exchange()

    @property
    def is_single(self) -> bool:
        """Whether one element at most is released and one at most applied, so that it can be a powershift."""
        return len(self.release) <= 1 and len(self.apply) <= 1


def changes(layout: Layout, gears: Sequence[Gear], combinations: Sequence[Combination]) -> tuple[Change, ...]:
    """Return the change between every two gears: a single one wherever the layout has one.

    Idle elements may open and close before the change and after it, where no combination on the way is a tie-up;
    that is how a transmission with two clutches prepares the next gear. Of several such ways the one with the
    fewest idle elements is taken, and of those the one in which the elements with the largest capacities hand over the
    load: clutches rather than synchronisers.
    """
    sound = {frozenset(c.engaged) for c in combinations if c.state is State.GEAR and not c.redundant}
    ways = {gear.name: [way for way in map(frozenset, gear.alternatives) if way in sound] for gear in gears}
    order = layout.element_names
    capacity = {element.name: element.capacity for element in layout.elements}

    def listed(names: frozenset[str]) -> tuple[str, ...]:
        return tuple(name for name in order if name in names)

    def change(start: Gear, end: Gear) -> Change:
        a, b = frozenset(start.engaged), frozenset(end.engaged)
        best = Change(start.name, end.name, listed(a - b), listed(b - a))
        if best.is_single:
            return best
        rank: tuple[float, float] | None = None
        for first, second in product(ways[start.name], ways[end.name]):
            if len(first - second) > 1 or len(second - first) > 1:
                continue
            own = float(len(first ^ a) + len(second ^ b)), -min(capacity[name] for name in first ^ second)
            if rank is None or own < rank:
                rank = own
                best = Change(
                    start.name,
                    end.name,
                    listed(first - second),
                    listed(second - first),
                    Exchange(listed(a - first), listed(first - a)),
                    Exchange(listed(second - b), listed(b - second)),
                )
        return best

    return tuple(change(start, end) for start in gears for end in gears if start is not end)

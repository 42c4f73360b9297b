"""From gears and shifts to courses: of the elements that are pressed, and of the ratios that go with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from ptgen.components.component import Component, Engagement
from ptgen.gears import GearAnalysis, Handover, handover, way_round
from ptgen.gears.changes import Exchange
from ptgen.testbed.profile import Profile

__all__ = ["NEUTRAL", "Shift", "ShiftCourse", "ShiftKind", "ShiftWish"]

NEUTRAL = "N"
"""The gear in which all elements are open."""

ShiftKind = Literal["overlapping", "non-overlapping"]
"""Whether the next elements are pressed while the last ones open, or after a pause in which nothing is transmitted."""

_SAME = 1e-9
"""Times (s) that differ by less are the same."""

Points = list[tuple[float, float]]


@dataclass(frozen=True)
class Shift:
    """A shift of a scenario.

    Attributes
    ----------
    component : str
    before, to : str
        Gears; ``"N"`` is neutral.
    start, end : float
        When its first element begins to move, and when the last one has arrived (s).
    kind : {"overlapping", "non-overlapping"}
    """

    component: str
    before: str
    to: str
    start: float
    end: float
    kind: ShiftKind


@dataclass(frozen=True)
class ShiftWish:
    """A shift as it is asked for.

    Attributes
    ----------
    to : str
    start : float
        (s)
    kind : {"overlapping", "non-overlapping"} or None
        None for an overlapping shift wherever that is possible.
    release, apply, pause : float
        Durations: elements open, elements close, and what is in between in a shift that does not overlap (s).
    overlap : float or None
        How long both ramps last at the same time (s); None for as long as possible.
    hold : float
        Share of the capacity to which engaged elements are pressed.
    ratio_time : tuple of two floats, or None
        Between which times from the start the ratio for control moves (s); None if that follows from the rest.
    profiles : mapping of str to Profile
        Elements with a course of their own, over the time from the start.
    preselect : float
        Time in which idle elements change, before the load is handed over and once more afterwards (s).
    """

    to: str
    start: float
    kind: ShiftKind | None = None
    release: float = 0.3
    apply: float = 0.3
    pause: float = 0.2
    overlap: float | None = None
    hold: float = 1.0
    ratio_time: tuple[float, float] | None = None
    profiles: Mapping[str, Profile] | None = None
    preselect: float = 0.2


class ShiftCourse:
    """The courses of one component over its shifts.

    Parameters
    ----------
    name : str
    component : Component
        One that has gears.
    gear : str
        At the start.
    ratios : mapping of str to float
        Ratio of each gear, for control; empty if no ratio for control is wanted.
    analysis : GearAnalysis, optional
        Of the component, if its gears follow from its layout; without it all elements hand over the load.
    """

    def __init__(
        self,
        name: str,
        component: Component,
        gear: str,
        ratios: Mapping[str, float],
        analysis: GearAnalysis | None = None,
    ) -> None:
        self.name = name
        self._analysis = analysis
        self.gears: dict[str, tuple[Engagement, ...]] = {NEUTRAL: (Engagement(()),), **component.engagements()}
        self.gear = gear
        self.end = 0.0
        self._known = ratios
        ways = self.gears[gear]
        starts = {
            key: float(getattr(component, key)) for gears in self.gears.values() for w in gears for key in w.ratios
        }
        suits = (way for way in ways if all(starts[key] == value for key, value in way.ratios.items()))
        self._way = next(suits, ways[0])
        self._elements: dict[str, Points] = {}
        for element in self._way.elements:
            self._elements[element] = [(0.0, 1.0)]
        self._ratios: dict[str, Points] = {
            key: [(0.0, self._way.ratios.get(key, value))] for key, value in starts.items()
        }
        self._set = dict.fromkeys(self._way.ratios)
        self._steps = {key for gears in self.gears.values() for w in gears if w.preselected for key in w.ratios}
        self._control: Points = [(0.0, ratios[gear])] if gear in ratios else []

    @property
    def engaged(self) -> Engagement:
        """How the gear is engaged that it is in now."""
        return self._way

    def level(self, element: str) -> float:
        """Return how far an element is pressed after the shifts so far, 0 to 1."""
        return self._elements[element][-1][1] if element in self._elements else 0.0

    def way(self, to: str) -> Engagement:
        """Return how a gear would be engaged: with elements that are free, where there are such."""
        ways = self.gears[to]
        return next((way for way in ways if not set(way.elements) & set(self._way.elements)), ways[0])

    def obstacle(self, to: str) -> str:
        """Return why a gear cannot be engaged while the last one still is; empty if it can."""
        return self._handover(to).obstacle

    def way_round(self, to: str) -> str | None:
        """Return a gear through which two overlapping shifts lead to another gear, if there is one."""
        return None if self._analysis is None else way_round(self._analysis, self.gear, to)

    def _changes(self, way: Engagement) -> dict[str, float]:
        return {key: value for key, value in way.ratios.items() if self._ratios[key][-1][1] != value}

    def _handover(self, to: str) -> Handover:
        """Return the elements that change on the way to a gear, in their order."""
        found = None if self._analysis is None else handover(self._analysis, self.gear, to)
        if found is not None:
            return found
        now, way = self._way, self.way(to)
        changes = self._changes(way)
        again = set(now.elements) & set(way.elements) if changes else set()
        release = tuple(e for e in now.elements if e not in way.elements or e in again)
        apply = tuple(e for e in way.elements if e not in now.elements or e in again)
        may_overlap = not changes or (way.preselected and not again)
        return Handover(release, apply, obstacle="" if may_overlap else "its clutch has to open in between")

    def shift(self, wish: ShiftWish) -> Shift:
        """Carry out a shift that begins when the last one has ended; return it.

        The shift must be possible: the gear exists and is another one, it may overlap if it is to, and the profiles
        begin where their elements are.
        """
        way, before, order = self.way(wish.to), self.gear, self._handover(wish.to)
        changes = self._changes(way)
        kind: ShiftKind = wish.kind or ("non-overlapping" if order.obstacle else "overlapping")
        own = wish.profiles or {}
        start = wish.start + (wish.preselect if order.before else 0.0)  # of the handover
        release = wish.release if order.release else 0.0
        if kind == "overlapping":
            overlap = min(wish.release, wish.apply) if wish.overlap is None else wish.overlap
            pressed = release - overlap if order.release else 0.0
        else:
            pressed = release + (wish.pause if order.release or changes or order.between else 0.0)
        end = start + max(release, pressed + wish.apply if order.apply else 0.0)
        for element in (*order.release, *order.apply):
            if element in own:
                end = max(end, wish.start + own[element].time[-1])
        self._exchange(order.before, wish.start, start, wish)
        self._ramps(order.release, start, start + release, 0.0, wish)
        self._exchange(order.between, start + release, start + pressed, wish)
        self._ramps(order.apply, start + pressed, start + pressed + wish.apply, wish.hold, wish)
        handed_over = end
        if order.after:
            end += wish.preselect
            self._exchange(order.after, handed_over, end, wish)
        end = max([end, *(wish.start + profile.time[-1] for profile in own.values())])
        moved = {*order.apply, *order.before.apply, *order.between.apply, *order.after.apply, *own}
        for element in way.elements:
            if element not in moved and self.level(element) != wish.hold:
                self._ramps((element,), wish.start, end, wish.hold, wish)
        for element, profile in own.items():
            own_points = zip(profile.time, profile.value, strict=True)
            self._go(element, [(wish.start + time, value) for time, value in own_points])
        self._set |= dict.fromkeys(way.ratios)
        again = set(order.release) & set(order.apply)
        for key, value in changes.items():
            if key not in self._steps:
                points = [(start + release, self._ratios[key][-1][1]), (start + pressed, value)]
            else:
                points = [(start + (0.5 * (release + pressed) if again else 0.0), value)]
            _extend(self._ratios[key], points)
        paused = bool(order.release or changes) and kind == "non-overlapping"
        self._move_control(wish, start - wish.start, release, pressed, paused)
        self._way, self.gear, self.end = way, wish.to, end
        return Shift(self.name, before, wish.to, wish.start, end, kind)

    def _exchange(self, idle: Exchange, start: float, end: float, wish: ShiftWish) -> None:
        """Let idle elements open, and then others close."""
        middle = 0.5 * (start + end)
        self._ramps(idle.release, start, middle if idle.apply else end, 0.0, wish)
        self._ramps(idle.apply, middle if idle.release else start, end, wish.hold, wish)

    def _ramps(self, elements: Sequence[str], start: float, end: float, level: float, wish: ShiftWish) -> None:
        """Let elements go to a level, those that have no course of their own."""
        for element in elements:
            if element not in (wish.profiles or {}):
                self._go(element, [(start, self.level(element)), (end, level)])

    def _move_control(self, wish: ShiftWish, lead: float, release: float, pressed: float, paused: bool) -> None:
        """Move the ratio for control: while nothing is transmitted, or else while the next elements are pressed."""
        if wish.to not in self._known:
            return
        window = wish.ratio_time or (
            (lead + release, lead + pressed) if paused else (lead + pressed, lead + pressed + wish.apply)
        )
        value = self._known[wish.to]
        if not self._control:
            self._control = [(0.0, self._known.get(self.gear, value))]
        points = [(wish.start + window[0], self._control[-1][1]), (wish.start + window[1], value)]
        _extend(self._control, points)

    def _go(self, element: str, points: Points) -> None:
        _extend(self._elements.setdefault(element, [(0.0, 0.0)]), points)

    def actuations(self) -> dict[str, Profile]:
        """Return the courses of the elements that gears and shifts press or open, by their names in the bed."""
        return {f"{self.name}.{element}": _profile(points, "lines") for element, points in self._elements.items()}

    def ratios(self) -> dict[str, Profile]:
        """Return the courses of the ratios of the plant that are set, with the keys of ``Testbed.ratios``."""
        return {
            self.name if key == "ratio" else f"{self.name}.{key}": _profile(
                self._ratios[key], "steps" if key in self._steps else "lines"
            )
            for key in self._set
        }

    def control(self) -> Profile | None:
        """Return the course of the ratio for control; None if it is nothing that shifts move."""
        return _profile(self._control, "lines") if self._control else None


def _extend(points: Points, more: Sequence[tuple[float, float]]) -> None:
    """Append points; one at the time of the last point replaces its value."""
    for time, value in more:
        if time > points[-1][0] + _SAME:
            points.append((time, value))
        elif value != points[-1][1]:
            points[-1] = (points[-1][0], value)


def _profile(points: Points, shape: Literal["lines", "steps"]) -> Profile:
    kept = [
        point
        for index, point in enumerate(points)
        if index in (0, len(points) - 1) or not points[index - 1][1] == point[1] == points[index + 1][1]
    ]
    if len(kept) == 2 and kept[0][1] == kept[1][1]:
        kept = kept[:1]
    return Profile(tuple(time for time, _ in kept), tuple(value for _, value in kept), shape)

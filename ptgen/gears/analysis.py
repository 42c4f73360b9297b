"""The whole analysis of a gear set: its gears in order, steps, spread, and the changes between them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from ptgen.gears.changes import Change, changes
from ptgen.gears.combinations import Combination, State, combinations
from ptgen.gears.freewheels import with_freewheels
from ptgen.gears.gear import Gear, gear_of
from ptgen.gears.layout import Layout
from ptgen.gears.shift_table import NEUTRAL, needed_of

__all__ = ["GearAnalysis", "analyse_gears"]


@dataclass(frozen=True)
class GearAnalysis:
    """What a gear set can do.

    Attributes
    ----------
    layout : Layout
    combinations : tuple of Combination
        Every combination of shift elements.
    gears : tuple of Gear
        In order: reverse first, then from the largest ratio to the smallest; those that the shift table names, and
        those that it does not.
    neutral : tuple of str or None
        The elements that the shift table engages in neutral.
    changes : tuple of Change
        Between every two gears that the shift table names; between all if it names none.
    """

    layout: Layout
    combinations: tuple[Combination, ...]
    gears: tuple[Gear, ...]
    neutral: tuple[str, ...] | None
    changes: tuple[Change, ...]

    @property
    def listed(self) -> tuple[Gear, ...]:
        """The gears that the shift table names, or all if it names none."""
        return tuple(gear for gear in self.gears if gear.named) or self.gears

    @property
    def forward(self) -> tuple[Gear, ...]:
        """Those of the listed gears in which output and input turn the same way."""
        return tuple(gear for gear in self.listed if (gear.ratio > 0) is self._forward_is_positive)

    @property
    def _forward_is_positive(self) -> bool:
        """Whether most gears keep the sense; a transmission with one gear pair on the way turns it over."""
        positive = sum(gear.ratio > 0 for gear in self.listed)
        return 2 * positive >= len(self.listed)

    @property
    def steps(self) -> Mapping[str, float]:
        """Gear -> its ratio over that of the next higher gear, for all forward gears but the highest."""
        forward = self.forward
        return {gear.name: float(gear.ratio / following.ratio) for gear, following in pairwise(forward)}

    @property
    def spread(self) -> float | None:
        """Ratio of the lowest over that of the highest forward gear; None with less than two."""
        forward = self.forward
        return float(forward[0].ratio / forward[-1].ratio) if len(forward) > 1 else None

    @property
    def has_losses(self) -> bool:
        """Whether any train loses power."""
        return any(train.loss is not None for train in self.layout.trains)

    def gear(self, name: str) -> Gear | None:
        """Return the gear with a name; None if there is none."""
        return next((gear for gear in self.gears if gear.name == name), None)

    def change(self, start: str, end: str) -> Change | None:
        """Return the change between two gears, if both are listed."""
        return next((change for change in self.changes if (change.start, change.end) == (start, end)), None)


def analyse_gears(layout: Layout, table: Mapping[str, Sequence[str]] | None = None) -> GearAnalysis:
    """Return everything that a gear set can do.

    Parameters
    ----------
    layout : Layout
    table : mapping of str to sequence of str, optional
        Shift table: gear -> engaged elements. Entries that are no gears are left out; see `shift_table_problems`.

    Raises
    ------
    ModelError
        If there are too many shift elements to look at all combinations.
    """
    every = combinations(layout)
    made = [found for found in every if found.state is State.GEAR]
    needs = {found.engaged: needed_of(made, found.engaged) for found in made}
    alternatives: dict[tuple[str, ...], list[tuple[str, ...]]] = {}
    for engaged, needed in needs.items():
        alternatives.setdefault(needed, []).append(engaged)
    named: dict[tuple[str, ...], tuple[str, Combination]] = {}
    for name, elements in (table or {}).items():
        found = with_freewheels(layout, every, elements)
        if found is not None and found.state is State.GEAR:
            named.setdefault(needs[found.engaged], (name, found))
    gears = []
    for needed, ways in alternatives.items():
        found = next(one for one in made if one.engaged == needed)
        name, chosen = named.get(needed, ("", found))
        gears.append(
            gear_of(
                layout,
                name,
                chosen.engaged,
                needed,
                named=needed in named,
                alternatives=ways,
                degrees_of_freedom=chosen.degrees_of_freedom,
            )
        )
    ordered = _counted(_ordered(gears))
    listed = [gear for gear in ordered if gear.named] or ordered
    neutral = (table or {}).get(NEUTRAL)
    return GearAnalysis(
        layout, every, tuple(ordered), None if neutral is None else tuple(neutral), changes(layout, listed, every)
    )


def _ordered(gears: Sequence[Gear]) -> list[Gear]:
    """Return gears with the rarer sense of rotation first, and each sense from the largest ratio to the smallest."""
    positive = 2 * sum(gear.ratio > 0 for gear in gears) >= len(gears)
    return sorted(gears, key=lambda gear: ((gear.ratio > 0) is positive, -abs(gear.ratio), gear.engaged))


def _counted(gears: Sequence[Gear]) -> list[Gear]:
    """Return gears with names: forward ones counted from 1, reverse ones R, R2; beside a shift table, in brackets."""
    bracketed = any(gear.named for gear in gears)
    positive = 2 * sum(gear.ratio > 0 for gear in gears) >= len(gears)
    forward = reverse = 0
    result = []
    for gear in gears:
        if gear.named:
            result.append(gear)
            continue
        if bracketed:
            name = f"({'+'.join(gear.engaged)})"
        elif (gear.ratio > 0) is positive:
            forward += 1
            name = str(forward)
        else:
            reverse += 1
            name = "R" if reverse == 1 else f"R{reverse}"
        result.append(replace(gear, name=name))
    return result

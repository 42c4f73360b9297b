"""The shifts of a run in words."""

from __future__ import annotations

from collections.abc import Sequence

from ptgen.testbed.shift_plan import Shift

__all__ = ["shift_lines"]


def shift_lines(shifts: Sequence[Shift]) -> list[str]:
    """Return a line for each shift.

    Examples
    --------
    >>> shift_lines([Shift("gears", "1", "2", 14.0, 14.5, "overlapping")])
    ['gears: 1 to 2 from 14 s to 14.5 s, overlapping']
    """
    return [f"{s.component}: {s.before} to {s.to} from {s.start:g} s to {s.end:g} s, {s.kind}" for s in shifts]

"""Freewheels among the shift elements: nobody engages them, they lock when the torque drives them."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from ptgen.gears.combinations import Combination, State
from ptgen.gears.layout import Layout
from ptgen.gears.speeds import Speed, number_speeds, slips
from ptgen.gears.statics import balance

__all__ = ["with_freewheels"]


def with_freewheels(layout: Layout, every: Sequence[Combination], engaged: Sequence[str]) -> Combination | None:
    """Return what a combination becomes while the input drives: freewheels lock that hold torque, the others overrun.

    Parameters
    ----------
    layout : Layout
    every : sequence of Combination
        All combinations of the layout, freewheels taken for elements that can be engaged.
    engaged : sequence of str
        The elements that are engaged.

    Returns
    -------
    Combination or None
        The combination itself if no freewheel makes it a gear; None if it names an unknown element.
    """
    found = {frozenset(one.engaged): one for one in every}
    own = found.get(frozenset(engaged))
    loose = [element.name for element in layout.elements if element.one_way and element.name not in engaged]
    if own is None or not loose:
        return own
    for count in range(len(loose) + 1):
        for locked in itertools.combinations(loose, count):
            tried = found[frozenset((*engaged, *locked))]
            if tried.state is State.GEAR and _holds(layout, tried, locked):
                return tried
    return own


def _holds(layout: Layout, tried: Combination, locked: Sequence[str]) -> bool:
    """Tell whether the locked freewheels carry torque in their sense, and all others turn in theirs."""
    numbers = number_speeds(layout, tried.engaged)
    relative = slips(layout, tried.engaged, {member: Speed(value, None) for member, value in numbers.items()})
    one_way = [element.name for element in layout.elements if element.one_way]
    if any((relative[name].value or 0) > 0 for name in one_way if name in relative):
        return False
    floats = {member: None if value is None else float(value) for member, value in numbers.items()}
    torques = balance(layout, tried.engaged, floats, losses=False)
    return torques is not None and all(torques.elements[name] > 0 for name in locked)

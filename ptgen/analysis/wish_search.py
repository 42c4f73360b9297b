r"""The largest shares of several wishes at which demands hold.

A share of 1 is the wish as it is. The search knows nothing of loops: it asks whether given shares hold. That need not
be monotone, a loop may need some gain to be stable, so no answer is inferred from another one:

1. From 1 downwards to a hundredth, shares are tried in steps of a fifth or less; where one holds, the border to the
   last one that did not is found by bisection, to one percent. What is found counts only if shares that are 5 and
   10 % smaller hold too; if not, the way goes on downwards.
2. So each wish is reduced alone, then several by a common factor. The set of wishes with the largest factor is reduced
   together; of sets that are equally good, the smallest.
3. Wishes of that set that could be larger, the others as they are now, rise together until none can rise any more, so
   that none takes what another one could have too. Then each gets back what it can alone.
4. At the end all reduced wishes together must hold 5 and 10 % below.

If no common factor of any set holds, as where two wishes have to keep a ratio, a coarse grid over all of them is
searched for the point that takes least away, and step 3 goes on from there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations, product

import numpy as np

__all__ = ["LEAST", "RESOLUTION", "FoundShares", "find_shares"]

LEAST = 0.01
"""Smallest share that is tried."""

RESOLUTION = 1.01
"""Factor between a share that holds and one that does not, at which bisection ends."""

_GRID = np.geomspace(1.0, LEAST, 25)
_COARSE = 5
_BELOW = (0.95, 0.9)
_ABOVE = 1.05
_TRIED = 1.02

Shares = tuple[float, ...]
Holds = Callable[[Shares], bool]


@dataclass(frozen=True)
class FoundShares:
    """What the search found.

    Attributes
    ----------
    alone : tuple of float or None
        Largest share of each wish, all others as wished; None if none holds.
    shares : tuple of float or None
        Shares that hold together; None if none were found.
    common : float or None
        The common factor from which they rose; None if none held.
    is_robust : bool
        Whether all reduced wishes may be 5 and 10 % smaller.
    """

    alone: tuple[float | None, ...]
    shares: Shares | None
    common: float | None
    is_robust: bool


def find_shares(holds: Holds, count: int, progress: Callable[[float], None] = lambda share: None) -> FoundShares:
    """Return the largest shares of `count` wishes that hold.

    Parameters
    ----------
    holds : callable
        Tells whether shares hold; it is asked for the same ones more than once.
    count : int
    progress : callable, optional
        Takes the share of the work that is done.

    Examples
    --------
    >>> found = find_shares(lambda shares: shares[0] * shares[1] <= 0.25, 3)
    >>> [share and round(share, 2) for share in found.alone], [round(share, 2) for share in found.shares]
    ([0.25, 0.25, None], [0.5, 0.5, 1.0])
    """
    whole = (1.0,) * count
    if holds(whole):
        return FoundShares((1.0,) * count, whole, 1.0, True)
    sets = [chosen for size in range(1, count + 1) for chosen in combinations(range(count), size)]
    coarse: dict[tuple[int, ...], int | None] = {}
    for position, chosen in enumerate(sets):
        coarse[chosen] = _first(_along(holds, whole, chosen), 0)
        progress(0.4 * (position + 1) / len(sets))
    alone = tuple(_refined(_along(holds, whole, (k,)), coarse[k,]) for k in range(count))
    progress(0.5)
    places = [place for place in coarse.values() if place is not None]
    if not places:
        start = _coarse_grid(holds, count)
        if start is None:
            return FoundShares(alone, None, None, False)
        return _robust(holds, alone, _given_more(holds, start, range(count), progress), None)
    best: tuple[float, tuple[int, ...]] = (0.0, ())
    for chosen, place in coarse.items():
        factor = _refined(_along(holds, whole, chosen), place) if place == min(places) else None
        if factor is not None and factor > RESOLUTION**2 * best[0]:
            best = (factor, chosen)
    common, chosen = best
    shares = _scaled(whole, chosen, common)
    return _robust(holds, alone, _given_more(holds, shares, chosen, progress), common)


def _coarse_grid(holds: Holds, count: int) -> Shares | None:
    """Return the point of a coarse grid that holds and has the largest product of shares."""
    points = sorted(product(np.geomspace(1.0, LEAST, _COARSE), repeat=count), key=lambda point: -np.prod(point))
    return next((tuple(float(x) for x in point) for point in points if holds(tuple(float(x) for x in point))), None)


def _given_more(holds: Holds, shares: Shares, chosen: Sequence[int], progress: Callable[[float], None]) -> Shares:
    """Return the shares after the chosen ones have risen together, then each alone."""
    progress(0.6)
    shares = _risen(holds, shares, chosen)
    progress(0.8)
    for k in chosen:
        shares = _given_back(holds, shares, k)
    progress(0.9)
    return shares


def _along(holds: Holds, shares: Shares, chosen: Sequence[int]) -> Callable[[float], bool]:
    """Return `holds` as a function of a factor on the chosen shares."""
    return lambda factor: holds(_scaled(shares, chosen, factor))


def _scaled(shares: Shares, chosen: Sequence[int], factor: float) -> Shares:
    return tuple(factor * share if k in chosen else share for k, share in enumerate(shares))


def _holds_below(holds: Callable[[float], bool], share: float) -> bool:
    return holds(share) and (share == 1.0 or all(holds(factor * share) for factor in _BELOW))


def _first(holds: Callable[[float], bool], start: int) -> int | None:
    """Return the place of the first share of the grid that holds with those below it."""
    return next((place for place in range(start, len(_GRID)) if _holds_below(holds, float(_GRID[place]))), None)


def _refined(holds: Callable[[float], bool], place: int | None) -> float | None:
    """Return the border above a place of the grid, by bisection."""
    if place is None:
        return None
    low = float(_GRID[place])
    if place == 0:
        return low
    high = float(_GRID[place - 1])
    while high / low > RESOLUTION:
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if _holds_below(holds, middle) else (low, middle)
    return low


def _risen(holds: Holds, shares: Shares, chosen: Sequence[int]) -> Shares:
    """Return the shares after those that can grow have grown together, until none can."""
    for _ in chosen:
        growing = [k for k in chosen if shares[k] < 1.0 and _along(holds, shares, (k,))(min(_TRIED, 1 / shares[k]))]
        if not growing:
            break
        before = {k: shares[k] for k in growing}
        low, high = 0.0, 1.0  # how far on the way back to what is wanted

        def at(way: float, before: dict[int, float] = before, shares: Shares = shares) -> Shares:
            return tuple(before[k] ** (1 - way) if k in before else share for k, share in enumerate(shares))

        if holds(at(1.0)):
            shares = at(1.0)
            continue
        longest = -np.log(min(before.values()))
        while (high - low) * longest > np.log(RESOLUTION):
            middle = (low + high) / 2
            low, high = (middle, high) if holds(at(middle)) else (low, middle)
        shares = at(low)
    return shares


def _given_back(holds: Holds, shares: Shares, k: int) -> Shares:
    """Return the shares with the largest share of one wish, all others as they are."""

    def at(share: float) -> bool:
        return holds((*shares[:k], share, *shares[k + 1 :]))

    found = _refined(at, _first(at, 0)) or 0.0
    found = max(found, shares[k])
    while found < 1.0 and at(min(1.0, _ABOVE * found)):  # an island that the grid missed
        found = min(1.0, _ABOVE * found)
    return (*shares[:k], found, *shares[k + 1 :])


def _robust(holds: Holds, alone: tuple[float | None, ...], shares: Shares, common: float | None) -> FoundShares:
    """Return shares of which all reduced ones may be smaller, each alone and all together."""
    reduced = [k for k, share in enumerate(shares) if share < 1.0]
    at = _along(holds, shares, reduced)
    place = next(
        (place for place in range(len(_GRID)) if all(at(f * float(_GRID[place])) for f in (1.0, *_BELOW))), None
    )
    if place is None:
        return FoundShares(alone, shares, common, False)
    low = high = float(_GRID[place])
    if place > 0:
        high = float(_GRID[place - 1])
    while high / low > RESOLUTION:
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if all(at(f * middle) for f in (1.0, *_BELOW)) else (low, middle)
    return FoundShares(alone, _scaled(shares, reduced, low), common, True)

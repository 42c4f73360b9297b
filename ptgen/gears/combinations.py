"""Every combination of engaged shift elements: what it leaves free, and whether it is a gear.

The members' velocities that all trains allow are ``v = N z``. A combination of engaged elements spans a space of rows
on ``z``; what is left of the rows of input and output outside that space tells all: both left and parallel is a gear,
both left and not parallel a neutral, one of them gone means that it cannot turn.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

from ptgen.errors import ModelError, Problem
from ptgen.gears.layout import Layout
from ptgen.gears.vectors import Span, Vector, combined, null_space, parallel

__all__ = ["MOST_ELEMENTS", "Combination", "State", "combinations", "free_motions"]

MOST_ELEMENTS = 14
"""Gear sets with more shift elements have too many combinations to look at each."""


class State(Enum):
    """What a combination of engaged elements makes of a gear set."""

    GEAR = "gear"
    NEUTRAL = "neutral"
    TIE_UP = "tie-up"


@dataclass(frozen=True)
class Combination:
    """A combination of engaged shift elements.

    Attributes
    ----------
    engaged : tuple of str
    degrees_of_freedom : int
        Independent velocities that remain.
    state : State
    ratio : Fraction or None
        Velocity of the input over that of the output, in a gear.
    blocked : tuple of str
        Which of ``input`` and ``output`` cannot turn, in a tie-up.
    redundant : tuple of str
        Elements whose velocity is zero even without them, because of those before them: their torque is not determined.
    """

    engaged: tuple[str, ...]
    degrees_of_freedom: int
    state: State
    ratio: Fraction | None = None
    blocked: tuple[str, ...] = ()
    redundant: tuple[str, ...] = ()


def free_motions(layout: Layout) -> list[Vector]:
    """Return a basis of the members' velocities that all trains allow."""
    return null_space((layout.train_vector(train) for train in layout.trains), len(layout.members))


def combinations(layout: Layout) -> tuple[Combination, ...]:
    """Return every combination of shift elements, those with few elements first.

    Raises
    ------
    ModelError
        If there are more than `MOST_ELEMENTS`.
    """
    if len(layout.elements) > MOST_ELEMENTS:
        what = f"has {len(layout.elements)} shift elements, 2^{len(layout.elements)} combinations"
        remedy = f"split the part; at most {MOST_ELEMENTS} elements can be looked at in all combinations"
        raise ModelError(Problem("components", what, remedy), layout.title)
    basis = free_motions(layout)
    rows = [(element.name, combined(layout.element_vector(element), basis)) for element in layout.elements]
    input_ = combined(layout.unit_vector(layout.input), basis)
    output = combined(layout.unit_vector(layout.output), basis)
    start = _Node((), (), Span(), input_, output)
    found = [node.combination(len(basis)) for node in _below(start, rows)]
    order = {name: k for k, (name, _) in enumerate(rows)}
    return tuple(sorted(found, key=lambda c: (len(c.engaged), [order[name] for name in c.engaged])))


@dataclass(frozen=True)
class _Node:
    """A combination on the way through all of them, with what is left of the rows of input and output."""

    engaged: tuple[str, ...]
    redundant: tuple[str, ...]
    span: Span
    input: Vector
    output: Vector

    def with_element(self, name: str, row: Vector) -> _Node:
        span = self.span.with_vector(row)
        if span is None:
            return _Node((*self.engaged, name), (*self.redundant, name), self.span, self.input, self.output)
        last = Span(span.vectors[-1:], span.pivots[-1:])
        return _Node((*self.engaged, name), self.redundant, span, last.rest(self.input), last.rest(self.output))

    def combination(self, motions: int) -> Combination:
        freedom = motions - self.span.rank
        blocked = tuple(name for name, row in (("input", self.input), ("output", self.output)) if not any(row))
        if blocked:
            return Combination(self.engaged, freedom, State.TIE_UP, blocked=blocked, redundant=self.redundant)
        ratio = parallel(self.input, self.output)
        state = State.NEUTRAL if ratio is None else State.GEAR
        return Combination(self.engaged, freedom, state, ratio, redundant=self.redundant)


def _below(node: _Node, rows: list[tuple[str, Vector]]) -> Iterator[_Node]:
    """Yield a combination and all that have it and some of `rows` engaged."""
    yield node
    for k, (name, row) in enumerate(rows):
        yield from _below(node.with_element(name, row), rows[k + 1 :])

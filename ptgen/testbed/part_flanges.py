"""Flanges inside a part: each is used once, and no component is connected to itself."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from ptgen.components.component import Component
from ptgen.components.part import Member
from ptgen.errors import Problem
from ptgen.testbed.problems import dotted

__all__ = ["flange_problems"]


def flange_problems(
    types: Mapping[str, type[Component]],
    members: Mapping[str, Member],
    connections: list[tuple[str, str]],
    exposed: Mapping[str, str],
) -> list[Problem]:
    """Return the problems of flanges inside a part: used twice or not at all, or on a component that drives itself.

    Parameters
    ----------
    types : mapping of str to type of Component
        The components of the part.
    members : mapping of str to Member
        With the flanges that they join in full.
    connections : list of (str, str)
        What the chains connect.
    exposed : mapping of str to str
        Flange of the part -> the member or the flange of a component that it is.
    """
    problems: list[Problem] = []
    uses: dict[str, tuple[str, str]] = {}

    def use(flange: str, where: str, what: str) -> None:
        first = uses.setdefault(flange, (where, what))
        if first != (where, what):
            text = f'"{flange}" is connected twice, {first[1]} ({first[0]}) and {what}'
            remedy = "remove one, or join everything that turns together in one member"
            problems.append(Problem(where, text, remedy))

    for member, record in members.items():
        where = dotted("members", member, "joins")
        for a, b in pairwise(sorted(record.joins)):
            if a == b:
                problems.append(Problem(where, f'"{a}" stands there twice', "remove one of them"))
            elif a.partition(".")[0] == b.partition(".")[0]:
                what = f'connects "{a.partition(".")[0]}" to itself ("{a}" and "{b}" on the member "{member}")'
                remedy = "join one of them elsewhere; to block a set on request put a clutch between its flanges"
                problems.append(Problem(where, what, remedy))
        for flange in dict.fromkeys(record.joins):
            use(flange, where, f"on the member {member}")
    for left, right in connections:
        if left.partition(".")[0] == right.partition(".")[0]:
            what = f'connects "{left.partition(".")[0]}" to itself ("{left}" to "{right}")'
            problems.append(Problem("part.connections", what, "put a component between the flanges"))
        use(left, "part.connections", f'to "{right}"')
        use(right, "part.connections", f'to "{left}"')
    for name, inside in exposed.items():
        if inside not in members:
            use(inside, dotted("part", "flanges", name), "as a flange of the part")
    for name, kind in types.items():
        for own in kind.flanges:
            if not own.may_stay_open and f"{name}.{own.name}" not in uses:
                what = f'flange "{name}.{own.name}" is not connected'
                remedy = "join it in a member; what is not joined to anything else may be a member of its own"
                problems.append(Problem(dotted("components", name), what, remedy))
        if all(own.may_stay_open and f"{name}.{own.name}" not in uses for own in kind.flanges):
            remedy = "join it in a member, or remove the component"
            problems.append(Problem(dotted("components", name), "is never connected", remedy))
    return problems

"""Chains: from texts such as ``"M1 - flange1 - diff.input"`` to connections of flanges."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import networkx as nx

from ptgen.components.component import Component
from ptgen.errors import Problem, nearest
from ptgen.testbed.problems import dotted, shown
from ptgen.testbed.testbed import Connection

__all__ = ["Chains", "Link", "Stop", "follow", "split"]

_SEPARATOR = re.compile(r"\s+-\s+")


@dataclass(frozen=True)
class Stop:
    """A component where it is mentioned in a chain.

    Attributes
    ----------
    component : str
        Its name.
    flange : str or None
        The flange, if the chain names it.
    chain : int
        Index of the chain.
    entered, left : bool
        Whether something stands to the left of it, and to the right.
    """

    component: str
    flange: str | None
    chain: int
    entered: bool
    left: bool


@dataclass(frozen=True)
class Link:
    """A connection and the index of the chain that it stands in."""

    connection: Connection
    chain: int


@dataclass(frozen=True)
class Chains:
    """What the chains say.

    Attributes
    ----------
    links : tuple of Link
        The connections, in order.
    orientation : mapping of str to int
        See `Testbed`.
    opposed : tuple of str
        Two-flange components that are entered, or left, at both flanges.
    """

    links: tuple[Link, ...]
    orientation: Mapping[str, int]
    opposed: tuple[str, ...]


def split(
    texts: Sequence[str],
    types: Mapping[str, type[Component]],
    unreadable: frozenset[str] = frozenset(),
    path: tuple[str, ...] = ("testbed", "connections"),
) -> tuple[list[list[Stop]], list[Problem]]:
    """Split the chains into stops and check that every stop exists.

    Parameters
    ----------
    texts : sequence of str
        The chains.
    types : mapping of str to type of Component
        The components whose type is known.
    unreadable : frozenset of str
        Components that exist, but whose type has a problem of its own.
    path : tuple of str
        Where the chains stand in the file.

    Returns
    -------
    chains : list of list of Stop
        Only the chains without a problem.
    problems : list of Problem
        Unknown components and flanges, and chains that are none.
    """
    chains: list[list[Stop]] = []
    problems: list[Problem] = []
    for index, text in enumerate(texts):
        where = dotted(*path, index)
        words = _SEPARATOR.split(text.strip())
        if len(words) < 2:
            what = f"must name at least two components, got {shown(text)}"
            problems.append(Problem(where, what, 'separate them by " - ", as in "M1 - shaft1 - M2"'))
            continue
        stops: list[Stop] = []
        for position, word in enumerate(words):
            name, dot, flange = word.partition(".")
            stop = Stop(name, flange if dot else None, index, position > 0, position < len(words) - 1)
            if name in unreadable:  # its own problem is reported where it is described
                continue
            found = _unknown(stop, word, where, types, unreadable) or _misplaced(stop, where, types)
            if found is None:
                stops.append(stop)
            else:
                problems.append(found)
        if len(stops) == len(words):
            chains.append(stops)
    return chains, problems


def _unknown(
    stop: Stop, word: str, where: str, types: Mapping[str, type[Component]], unreadable: frozenset[str]
) -> Problem | None:
    if stop.component not in types:
        hint = 'separate components by " - " with spaces'
        remedy = hint if not re.fullmatch(r"\w+", stop.component) else nearest(stop.component, {*types, *unreadable})
        return Problem(where, f"{shown(word)} names no component of the bed", remedy)
    known = types[stop.component].flange_names()
    if stop.flange is not None and stop.flange not in known:
        what = f'{shown(word)} names no flange: "{stop.component}" is a {types[stop.component].type_name}'
        return Problem(where, what, nearest(stop.flange, known))
    return None


def _misplaced(stop: Stop, where: str, types: Mapping[str, type[Component]]) -> Problem | None:
    name, flanges = stop.component, types[stop.component].flange_names()
    if len(flanges) == 2:
        return None
    if stop.entered and stop.left:
        remedy = f'end the chain at "{name}" and begin another one there'
        return Problem(where, f'"{name}" stands in the middle of a chain, but has {_count(flanges)}', remedy)
    if len(flanges) > 2 and stop.flange is None:
        options = " or ".join(f'"{name}.{flange}"' for flange in flanges)
        return Problem(where, f'"{name}" has {_count(flanges)}, and none is named', f"write {options}")
    return None


def _count(flanges: Sequence[str]) -> str:
    return "one flange" if len(flanges) == 1 else f"{len(flanges)} flanges"


def follow(chains: Sequence[Sequence[Stop]], types: Mapping[str, type[Component]]) -> Chains:
    """Resolve every stop to the flanges where the chain enters and leaves the component."""
    first = _first_entered(chains, types)
    links: list[Link] = []
    entered: dict[str, set[str]] = {name: set() for name in types}
    left: dict[str, set[str]] = {name: set() for name in types}
    for chain in chains:
        for before, after in pairwise(chain):
            exit_flange = _flange(before, types[before.component], first, at_exit=True)
            entry_flange = _flange(after, types[after.component], first, at_exit=False)
            left[before.component].add(exit_flange)
            entered[after.component].add(entry_flange)
            connection = Connection(f"{before.component}.{exit_flange}", f"{after.component}.{entry_flange}")
            links.append(Link(connection, before.chain))
    orientation = dict.fromkeys(types, 1)
    opposed: list[str] = []
    for name, kind in types.items():
        flanges = kind.flange_names()
        if len(flanges) != 2:
            continue
        forward = flanges[0] in entered[name] or flanges[1] in left[name]
        backward = flanges[1] in entered[name] or flanges[0] in left[name]
        if forward and backward:
            opposed.append(name)
        elif backward:
            orientation[name] = -1
    return Chains(tuple(links), orientation, tuple(opposed))


def _flange(stop: Stop, kind: type[Component], first: Mapping[str, str], *, at_exit: bool) -> str:
    """Return the flange at which a chain enters, or leaves, a component."""
    flanges = kind.flange_names()
    if len(flanges) != 2:
        return stop.flange or flanges[0]
    other = {flanges[0]: flanges[1], flanges[1]: flanges[0]}
    if stop.flange is None:
        entry = first.get(stop.component, flanges[0])
        return other[entry] if at_exit else entry
    passed = stop.entered and stop.left
    return other[stop.flange] if at_exit and passed else stop.flange


def _first_entered(chains: Sequence[Sequence[Stop]], types: Mapping[str, type[Component]]) -> dict[str, str]:
    """Return the flange at which chains enter each component that turns its first flange to a machine."""
    graph = nx.Graph()
    graph.add_nodes_from(types)
    stops = [stop for chain in chains for stop in chain]
    for chain in chains:
        graph.add_edges_from((a.component, b.component) for a, b in pairwise(chain))
    entries: dict[str, str] = {}
    for name, kind in types.items():
        if not kind.faces_machine or len(kind.flanges) != 2:
            continue
        machine_side, other_side = kind.flange_names()
        named = [stop for stop in stops if stop.component == name and stop.flange is not None]
        if named:
            mentioned = str(named[0].flange)
            entries[name] = mentioned if named[0].entered else _opposite(kind, mentioned)
            continue
        sides: tuple[set[str], set[str]] = (set(), set())
        for chain in chains:
            for a, b in pairwise(chain):
                if b.component == name:
                    sides[0].add(a.component)
                if a.component == name:
                    sides[1].add(b.component)
        without = graph.subgraph(set(types) - {name})
        to_left, to_right = (_distance(without, side - {name}, types) for side in sides)
        entries[name] = machine_side if to_left <= to_right else other_side
    return entries


def _opposite(kind: type[Component], flange: str) -> str:
    first, second = kind.flange_names()
    return second if flange == first else first


def _distance(graph: nx.Graph, start: set[str], types: Mapping[str, type[Component]]) -> float:
    """Return the number of components from `start` to the nearest machine; infinite if there is none."""
    if not start:
        return float("inf")
    lengths = nx.multi_source_dijkstra_path_length(graph, start)
    return min((length for name, length in lengths.items() if types[name].is_machine), default=float("inf"))

"""What hangs together: flanges used twice or left open, loose parts, components connected to themselves."""

from __future__ import annotations

from collections.abc import Mapping

import networkx as nx

from ptgen.components.component import Component
from ptgen.errors import Problem
from ptgen.testbed.chains import Chains
from ptgen.testbed.problems import dotted

__all__ = ["check"]


def check(chains: Chains, types: Mapping[str, type[Component]]) -> list[Problem]:
    """Return the problems of the connections.

    Parameters
    ----------
    chains : Chains
        All connections of the bed.
    types : mapping of str to type of Component
        All components of the bed.
    """
    return [*_repeated(chains), *_open(chains, types), *_loose(chains, types)]


def _repeated(chains: Chains) -> list[Problem]:
    """Flanges with more than one neighbour, and components that are their own neighbour."""
    problems: list[Problem] = []
    neighbours: dict[str, str] = {}
    for link in chains.links:
        where = dotted("testbed", "connections", link.chain)
        left, right = link.connection.left, link.connection.right
        component = left.partition(".")[0]
        if component == right.partition(".")[0]:
            what = f'connects "{component}" to itself ("{left}" to "{right}")'
            problems.append(Problem(where, what, "put a component between the flanges, or name the right one"))
        for flange, other in ((left, right), (right, left)):
            if flange in neighbours:
                what = (
                    f'"{flange}" is connected twice, to "{neighbours[flange]}" and to "{other}"; '
                    "a flange has one neighbour"
                )
                remedy = "remove one connection, or name the flanges that are meant"
                problems.append(Problem(where, what.replace("; ", ": "), remedy))
            else:
                neighbours[flange] = other
    return problems


def _open(chains: Chains, types: Mapping[str, type[Component]]) -> list[Problem]:
    """Flanges without a neighbour that need one."""
    used = {flange for link in chains.links for flange in (link.connection.left, link.connection.right)}
    problems: list[Problem] = []
    for name, kind in types.items():
        if not any(f"{name}.{flange}" in used for flange in kind.flange_names()):
            what = "is never connected"
            remedy = f'add "{name}" to a chain in testbed.connections, or remove the component'
            problems.append(Problem(dotted("components", name), what, remedy))
            continue
        for flange in kind.flanges:
            if not flange.may_stay_open and f"{name}.{flange.name}" not in used:
                what = f'flange "{name}.{flange.name}" is not connected'
                remedy = "connect it in testbed.connections; an inertia may end a shaft that drives nothing"
                problems.append(Problem(dotted("components", name), what, remedy))
    return problems


def _loose(chains: Chains, types: Mapping[str, type[Component]]) -> list[Problem]:
    """Parts of the bed that are not connected to each other."""
    graph = nx.Graph()
    for link in chains.links:
        graph.add_edge(link.connection.left.partition(".")[0], link.connection.right.partition(".")[0])
    order = {name: index for index, name in enumerate(types)}
    parts = sorted((sorted(part, key=order.__getitem__) for part in nx.connected_components(graph)), key=str)
    if len(parts) < 2:
        return []
    listed = " and ".join(f"({', '.join(part)})" for part in parts)
    what = f"the bed falls into {len(parts)} parts that are not connected: {listed}"
    return [Problem("testbed.connections", what, "connect them, or describe each part as a bed of its own")]

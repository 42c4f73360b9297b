"""Where the components of a bed stand in its drawing: columns along the power flow, rows beside each other.

The layered drawing of Sugiyama and others in its plainest form: a component's column is the longest way to it;
connections over several columns get a place in each of them, so that nothing is drawn on top of anything; rows are
ordered by the mean of the neighbours, and then moved towards it as far as the distances allow.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import networkx as nx

from ptgen.testbed.testbed import Connection, Testbed

__all__ = ["Layout", "Wire", "layout"]

_SWEEPS = 80


@dataclass(frozen=True)
class Wire:
    """A connection: its flanges, and the places that it passes on its way from left to right."""

    left: str
    right: str
    passes: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Layout:
    """Places in units of the grid; columns grow to the right, rows grow upwards.

    Attributes
    ----------
    places : mapping of str to (float, float)
        Column and row of each component.
    wires : tuple of Wire
    """

    places: Mapping[str, tuple[float, float]]
    wires: tuple[Wire, ...]

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Least and greatest column, least and greatest row of components and wires."""
        points = [*self.places.values(), *(point for wire in self.wires for point in wire.passes)]
        columns, rows = zip(*points, strict=True)
        return min(columns), max(columns), min(rows), max(rows)


@dataclass(frozen=True)
class _Edge:
    connection: Connection
    nodes: tuple[str, ...]
    """The components at its ends, and the places in between."""


def layout(bed: Testbed) -> Layout:
    """Lay out the components of a bed."""
    columns = _columns(bed)
    edges = [_edge(connection, index, columns) for index, connection in enumerate(bed.connections)]
    ranks: dict[int, list[str]] = defaultdict(list)
    for name, column in columns.items():
        ranks[column].append(name)
    neighbours: dict[str, list[tuple[str, float]]] = defaultdict(list)
    for edge in edges:
        for a, b in pairwise(edge.nodes):
            offset = _flange_offset(bed, edge.connection.left) - _flange_offset(bed, edge.connection.right)
            neighbours[a].append((b, -offset))
            neighbours[b].append((a, offset))
    order = [ranks[column] for column in sorted(ranks)]
    rows = _rows(order, neighbours)
    wires = tuple(
        Wire(
            edge.connection.left,
            edge.connection.right,
            tuple((float(columns[node]), rows[node]) for node in edge.nodes[1:-1]),
        )
        for edge in edges
    )
    return Layout({name: (float(columns[name]), rows[name]) for name in bed.components}, wires)


def _component(flange: str) -> str:
    return flange.partition(".")[0]


def _columns(bed: Testbed) -> dict[str, int]:
    """Return the column of each component: the longest way from a beginning; loops are cut open."""
    graph = nx.DiGraph()
    graph.add_nodes_from(bed.components)
    for connection in bed.connections:
        a, b = _component(connection.left), _component(connection.right)
        if a in graph and not nx.has_path(graph, b, a):
            graph.add_edge(a, b)
    columns: dict[str, int] = {}
    for name in nx.topological_sort(graph):
        columns[name] = max((columns[before] + 1 for before in graph.predecessors(name)), default=0)
    # What begins a chain stands next to what it drives.
    for name in reversed(list(nx.topological_sort(graph))):
        after = [columns[other] for other in graph.successors(name)]
        if after and not list(graph.predecessors(name)):
            columns[name] = min(after) - 1
    least = min(columns.values())
    return {name: column - least for name, column in columns.items()}


def _edge(connection: Connection, index: int, columns: dict[str, int]) -> _Edge:
    """Return a connection with a place in each column that it passes; the places are added to `columns`."""
    a, b = _component(connection.left), _component(connection.right)
    step = 1 if columns[b] > columns[a] else -1
    between = []
    for column in range(columns[a] + step, columns[b], step):
        name = f"{index}:{column}"
        columns[name] = column
        between.append(name)
    return _Edge(connection, (a, *between, b))


def _flange_offset(bed: Testbed, flange: str) -> float:
    """Return how far above the middle of its component a flange lies, so that outputs keep their order."""
    name, _, port = flange.partition(".")
    flanges = bed.components[name].flange_names()
    if len(flanges) < 3:
        return 0.0
    others = flanges[1:]
    return 0.0 if port == flanges[0] else 0.2 * (len(others) - 1) - 0.4 * others.index(port)


def _rows(order: Sequence[list[str]], neighbours: Mapping[str, Sequence[tuple[str, float]]]) -> dict[str, float]:
    """Return the row of each node; nodes of one column are at least one row apart."""
    rows = {name: -float(index) for rank in order for index, name in enumerate(rank)}
    for sweep in range(_SWEEPS):
        ranks, sorting = order if sweep % 2 == 0 else order[::-1], sweep < _SWEEPS // 2
        for rank in ranks:
            wanted = {}
            for name in rank:
                seen = [rows[other] + (offset if sorting else 0.0) for other, offset in neighbours[name]]
                wanted[name] = sum(seen) / len(seen) if seen else rows[name]
            if sorting:
                rank.sort(key=lambda name: (-wanted[name], name))
            for name, row in zip(rank, _spaced([wanted[name] for name in rank]), strict=True):
                rows[name] = row
    # Half rows make chains straight; rounding keeps nodes that are one row apart one row apart.
    return {name: math.floor(2 * row + 0.5) / 2 for name, row in rows.items()}


def _spaced(wanted: Sequence[float]) -> list[float]:
    """Return the descending rows nearest to `wanted` that are one apart, by pooling adjacent violators.

    Examples
    --------
    >>> _spaced([0.0, 0.0])
    [0.5, -0.5]
    """
    pools: list[tuple[float, int]] = []
    for index, row in enumerate(wanted):
        mean, count = row + index, 1
        while pools and pools[-1][0] < mean:
            before, size = pools.pop()
            mean, count = (before * size + mean * count) / (size + count), size + count
        pools.append((mean, count))
    flat = [mean for mean, count in pools for _ in range(count)]
    return [mean - index for index, mean in enumerate(flat)]

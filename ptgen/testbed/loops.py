"""Rigid loops: gear ratios that contradict each other, so that nothing could turn."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import networkx as nx
import sympy as sp
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from ptgen.components.component import Component
from ptgen.errors import Problem
from ptgen.testbed.testbed import Connection

__all__ = ["check"]


@dataclass(frozen=True)
class _Relation:
    """A relation between velocities, and whose it is; connections have no owner."""

    owner: str
    row: Mapping[str, sp.Rational]


def check(components: Mapping[str, Component], connections: Sequence[Connection]) -> list[Problem]:
    """Return a problem if the rigid relations force a velocity to be zero that is not held by intention.

    The rigid relations are linear in the velocities. They are compatible if no velocity vanishes in all of
    their solutions, which is decided exactly, in rational numbers: the ratios count as they are written.
    """
    relations = _relations(components, connections)
    held = _held(relations)
    stuck = _stuck(relations) - held
    if not stuck:
        return []
    needed = relations
    for relation in relations:
        fewer = [other for other in needed if other is not relation]
        if _stuck(fewer) - held:
            needed = fewer
    owners = {relation.owner for relation in needed if relation.owner}
    owners |= {flange.partition(".")[0] for relation in needed if not relation.owner for flange in relation.row}
    names = ", ".join(name for name in components if name in owners)
    velocities = ", ".join(f'"{velocity}"' for velocity in sorted(_stuck(needed) - held) if velocity in stuck)
    what = f"the rigid loop through {names} has gear ratios that contradict each other, so it cannot turn"
    remedy = "correct a ratio (all decimals count), or put a shaft into the loop"
    return [Problem("testbed.connections", f"{what} (at rest: {velocities})", remedy)]


def _relations(components: Mapping[str, Component], connections: Sequence[Connection]) -> list[_Relation]:
    relations = [
        _Relation("", {connection.left: sp.Integer(1), connection.right: sp.Integer(-1)}) for connection in connections
    ]
    for name, component in components.items():
        values = {parameter.symbol: sp.Rational(str(parameter.value)) for parameter in component.parameters(name)}
        for constraint in component.elements(name).constraints:
            row = {velocity: sp.sympify(factor).subs(values) for velocity, factor in constraint.row.items()}
            relations.append(_Relation(name, row))
        relations += [
            _Relation(name, {left: sp.Integer(1), right: sp.Integer(-1)})
            for left, right in component.elements(name).connections
        ]
    return relations


def _stuck(relations: Sequence[_Relation]) -> set[str]:
    """Return the velocities that are zero in every solution."""
    velocities = sorted({velocity for relation in relations for velocity in relation.row})
    if not velocities:
        return set()
    entries = [[QQ.from_sympy(relation.row.get(v, sp.Integer(0))) for v in velocities] for relation in relations]
    matrix = DomainMatrix(entries, (len(relations), len(velocities)), QQ)
    basis = matrix.nullspace().to_list()
    return {v for column, v in enumerate(velocities) if not any(row[column] for row in basis)}


def _held(relations: Sequence[_Relation]) -> set[str]:
    """Return the velocities that a component holds at rest, and those that are connected to them rigidly."""
    graph = nx.Graph()
    for relation in relations:
        graph.add_nodes_from(relation.row)
        if sorted(relation.row.values()) == [-1, 1]:
            graph.add_edge(*relation.row)
    anchors = [velocity for relation in relations if len(relation.row) == 1 for velocity in relation.row]
    return set().union(*(nx.node_connected_component(graph, anchor) for anchor in anchors))

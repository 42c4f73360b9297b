"""The torque across a rigid connection, by d'Alembert's principle.

Cutting the connection frees one relative motion. Any velocity field ``q`` of the freed mechanism with unit slip
at the cut gives the torque by virtual power: ``T = q' (torques - M dv/dt)``. The field with the fewest bodies is
taken; between equals the one on the machine's side, so that a rigidised torque flange reads (5.13) of the source.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import networkx as nx
import sympy as sp

from ptgen.errors import ModelError, Problem
from ptgen.mechanism import exact
from ptgen.mechanism.mechanism import Mechanism

__all__ = ["Reaction", "reaction"]


@dataclass(frozen=True)
class Reaction:
    """A velocity field of the mechanism that is cut open, ``{velocity: coefficient}``, with unit slip."""

    field: dict[str, sp.Expr]
    bodies: int
    has_machine: bool


def reaction(mechanism: Mechanism, owner: str) -> Reaction:
    """Return the velocity field that gives the torque across the constraint `owner`.

    The torque is positive when it drives the velocity with the coefficient -1 in the constraint's row.

    Raises
    ------
    ModelError
        If the torque is not determined because other rigid parts hold the same motion.
    """
    cut = next(constraint for constraint in mechanism.constraints if constraint.owner == owner)
    left = next(name for name, value in cut.row.items() if value == 1)
    right = next(name for name, value in cut.row.items() if value == -1)
    rest = [constraint for constraint in mechanism.constraints if constraint is not cut]
    graph = nx.Graph()
    graph.add_nodes_from(mechanism.velocities)
    for constraint in rest:
        names = list(constraint.row)
        graph.add_edges_from(itertools.pairwise(names))
    found = []
    for start, sign in ((left, 1), (right, -1)):
        side = nx.node_connected_component(graph, start)
        names = [name for name in mechanism.velocities if name in side]
        slip = (
            {left: sp.Integer(1), right: sp.Integer(-1)}
            if len(side & {left, right}) == 2
            else {start: sp.Integer(sign)}
        )
        rows = [exact.row_vector(c.row, names) for c in rest if set(c.row) <= side]
        bodies = [body.velocity for body in mechanism.bodies if body.velocity in side]
        candidates = [slip, *({name: sp.Integer(1)} for name in bodies + names)]
        stacked = exact.stack(rows + [exact.row_vector(row, names) for row in candidates], len(names))
        independent = exact.independent_rows(stacked)
        if len(rows) not in independent:
            continue
        basis = exact.stack([stacked[index, :] for index in independent], len(names))
        unit = sp.Matrix([[sp.Integer(int(index == len(rows)))] for index in independent])
        q = exact.solve(basis, unit)
        field = {name: q[index] for index, name in enumerate(names) if q[index] != 0}
        machines = set(mechanism.machine_velocities)
        found.append(Reaction(field, sum(name in field for name in bodies), bool(machines & set(field))))
    if not found:
        raise ModelError(
            Problem(
                owner,
                "the torque is not determined, because other rigid parts hold the same motion",
                "give one of the parallel paths a shaft with a stiffness",
            )
        )
    return min(found, key=lambda item: (item.bodies, not item.has_machine, len(item.field)))

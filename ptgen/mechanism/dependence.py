"""Friction elements that hold the same motion, so that their torques are not unique while they stick."""

from __future__ import annotations

import networkx as nx
import sympy as sp

from ptgen.mechanism import exact
from ptgen.mechanism.model import Model

__all__ = ["dependent_sets", "is_dependent"]


def dependent_sets(model: Model) -> tuple[tuple[str, ...], ...]:
    """Return the sets of friction elements whose velocities depend on each other at the parameters of the bed.

    Each set is as small as possible, and none shares an element with another one unless one combination ties them.
    """
    rows = _rows(model)
    names = [friction.name for friction in model.frictions]
    graph = nx.Graph()
    for combination in rows.T.nullspace():
        members = [name for name, factor in zip(names, combination, strict=True) if factor != 0]
        nx.add_path(graph, members)
        graph.add_nodes_from(members)
    sets = [tuple(name for name in names if name in part) for part in nx.connected_components(graph)]
    return tuple(sorted(sets, key=lambda members: names.index(members[0])))


def is_dependent(model: Model) -> bool:
    """Tell whether some friction elements of the model hold the same motion."""
    return exact.rank(_rows(model)) < len(model.frictions)


def _rows(model: Model) -> sp.Matrix:
    """Return the friction rows with the parameters at their values, as exact numbers."""
    rows = model.friction_rows
    values = {symbol: sp.Rational(str(model.values[symbol])) for symbol in rows.free_symbols}
    return rows.subs(values) if values else rows

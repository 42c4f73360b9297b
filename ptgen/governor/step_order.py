"""The order in which a sequential governor takes the references: what the zeros of a matrix allow."""

from __future__ import annotations

import networkx as nx
import numpy as np
from numpy.typing import NDArray

__all__ = ["step_order"]


def step_order(pattern: NDArray[np.bool_]) -> tuple[int, ...]:
    """Return the machines so that each command depends on references that come before it, as far as possible.

    The matrix is brought to block-triangular form: references that act on each other's commands stand together, in
    the order of the machines. Among those that may come first the machine with the lower number does.

    Parameters
    ----------
    pattern : ndarray (m, m)
        Whether command i depends on reference j; every machine's own reference counts as if it did.

    Examples
    --------
    The differential (7.39): the command of the first machine depends on all references, the others on their own.

    >>> step_order(np.array([[1, 1, 1], [0, 1, 0], [0, 0, 1]], dtype=bool))
    (1, 2, 0)
    """
    graph = nx.DiGraph()
    graph.add_nodes_from(range(len(pattern)))
    graph.add_edges_from((int(j), int(i)) for i, j in np.argwhere(pattern) if i != j)
    groups = nx.condensation(graph)
    members = {group: sorted(groups.nodes[group]["members"]) for group in groups}
    order = nx.lexicographical_topological_sort(groups, key=lambda group: members[group][0])
    return tuple(machine for group in order for machine in members[group])

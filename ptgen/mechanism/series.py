"""Shafts in series, joined one by one into equivalent shafts with a parameter of their own.

This is the condensation rule for a velocity without inertia between two shafts, applied locally: with the twist
shared so that both carry the same torque, stiffness and damping become (3.6), (3.7) of the source. Giving each
equivalent shaft its own symbol keeps the formulas of the reduced model as short as people write them.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import networkx as nx
import sympy as sp

from ptgen.elements import Constraint, Parameter, Row, Spring
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import evaluate_matrix

__all__ = ["SeriesShafts", "equivalent_shaft", "join_series"]


@dataclass(frozen=True)
class SeriesShafts:
    """A mechanism whose shafts in series were joined.

    Attributes
    ----------
    mechanism : Mechanism
    definitions : mapping of Symbol to Expr
        Stiffness and damping of each equivalent shaft in terms of its members'.
    members : mapping of str to tuple of str
        The original springs of each equivalent shaft.
    """

    mechanism: Mechanism
    definitions: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    members: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def equivalent_shaft(c1: sp.Expr, d1: sp.Expr, c2: sp.Expr, d2: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return stiffness and damping of two shafts in series.

    ``Psi`` distributes the twist so that the joint is in static balance; then ``Psi' K Psi`` and ``Psi' D Psi``.

    Examples
    --------
    >>> c1, c2, d1, d2 = sp.symbols("c1 c2 d1 d2")
    >>> equivalent_shaft(c1, d1, c2, d2)[0]
    c1*c2/(c1 + c2)
    """
    Psi = sp.Matrix([c2, c1]) / (c1 + c2)  # twists of both shafts per unit of the whole twist
    stiffness = (Psi.T * sp.diag(c1, c2) * Psi)[0, 0]
    damping = (Psi.T * sp.diag(d1, d2) * Psi)[0, 0]
    return sp.factor(stiffness), sp.factor(damping)


def join_series(mechanism: Mechanism, keep: frozenset[str] = frozenset()) -> SeriesShafts:
    """Join all shafts that meet at a joint which has no inertia and no other element.

    Parameters
    ----------
    mechanism : Mechanism
    keep : frozenset of str
        Springs that must not be joined.
    """
    result = SeriesShafts(mechanism)
    while True:
        joint = _find_joint(result.mechanism, keep)
        if joint is None:
            return result
        result = _join(result, *joint)


def _find_joint(mechanism: Mechanism, keep: frozenset[str]) -> tuple[frozenset[str], Spring, Spring] | None:
    graph = nx.Graph()
    graph.add_nodes_from(mechanism.velocities)
    for constraint in mechanism.constraints:
        names = list(constraint.row)
        graph.add_edges_from(itertools.pairwise(names))
    loaded = {body.velocity for body in mechanism.bodies}
    for row in [e.row for e in mechanism.frictions] + [e.row for e in mechanism.torques]:
        loaded |= set(row)
    for group in nx.connected_components(graph):
        if group & loaded:
            continue
        springs = [spring for spring in mechanism.springs if set(spring.row) & group]
        inside = [constraint for constraint in mechanism.constraints if set(constraint.row) <= group]
        plain = all(sorted(map(str, constraint.row.values())) == ["-1", "1"] for constraint in inside)
        if (
            len(springs) == 2
            and plain
            and len(inside) == len(group) - 1
            and all(len(set(spring.row) & group) == 1 and spring.name not in keep for spring in springs)
            and all(abs(value) == 1 for spring in springs for value in spring.row.values())
        ):
            return frozenset(group), springs[0], springs[1]
    return None


def _end(spring: Spring, group: frozenset[str]) -> tuple[str, sp.Expr]:
    """Return the end of `spring` outside the joint, and the coefficient of the end at the joint."""
    outside = next(name for name in spring.row if name not in group)
    at_joint = next(value for name, value in spring.row.items() if name in group)
    return outside, at_joint


def _join(shafts: SeriesShafts, group: frozenset[str], first: Spring, second: Spring) -> SeriesShafts:
    mechanism = shafts.mechanism
    members = (
        *shafts.members.get(first.name, (first.name,)),
        *shafts.members.get(second.name, (second.name,)),
    )
    if mechanism.springs.index(first) > mechanism.springs.index(second):
        first, second = second, first
    name = "_".join(members)
    stiffness = sp.Symbol(f"{name}_stiffness", positive=True)
    damping = sp.Symbol(f"{name}_damping", nonnegative=True)
    c, d = equivalent_shaft(first.stiffness, first.damping, second.stiffness, second.damping)
    (outside1, coefficient1), (outside2, coefficient2) = _end(first, group), _end(second, group)
    # The joint cancels from the sum of the rows once both are taken with opposite signs at the joint.
    sign2 = -1 if coefficient1 == coefficient2 else 1
    row: Row = {outside1: first.row[outside1], outside2: sign2 * second.row[outside2]}
    table = mechanism.values
    new_parameters = tuple(
        Parameter(symbol, float(evaluate_matrix(sp.Matrix([[expression]]), table)[0, 0]), unit, text, positive=positive)
        for symbol, expression, unit, text, positive in (
            (stiffness, c, "N m/rad", f"stiffness of {', '.join(members)} in series", True),
            (damping, d, "N m s/rad", f"damping of {', '.join(members)} in series", False),
        )
    )
    inside = {constraint.owner for constraint in mechanism.constraints if set(constraint.row) <= group}
    carried = {flange: owner for flange, (owner, _) in mechanism.connections.items() if owner in inside}
    signs = {first.name: 1, second.name: sign2}
    carriers = {
        key: (name, sign * signs[spring]) if spring in signs else (spring, sign)
        for key, (spring, sign) in mechanism.carriers.items()
    }
    carriers |= {spring: (name, sign) for spring, sign in signs.items()}
    # Across a connection inside the joint the torque drives the right-hand velocity.
    for flange in carried:
        left = next(n for n, v in _constraint(mechanism, carried[flange]).row.items() if v == 1)
        towards_first = _reaches(mechanism, group, carried[flange], left, first)
        at_first = coefficient1 if towards_first else -coefficient1
        # A spring drives its joint with minus its coefficient there; the joint passes it on to the right.
        carriers[flange] = (name, -int(at_first))
    joined = Spring(name, row, stiffness, damping)
    springs = tuple(joined if spring is first else spring for spring in mechanism.springs if spring is not second)
    new = replace(
        mechanism,
        velocities=tuple(v for v in mechanism.velocities if v not in group),
        constraints=tuple(c for c in mechanism.constraints if c.owner not in inside),
        springs=springs,
        parameters=mechanism.parameters + new_parameters,
        connections={flange: at for flange, at in mechanism.connections.items() if at[0] not in inside},
        carriers=carriers,
    )
    kept_members = {key: value for key, value in shafts.members.items() if key not in (first.name, second.name)}
    return SeriesShafts(new, {**shafts.definitions, stiffness: c, damping: d}, {**kept_members, name: members})


def _constraint(mechanism: Mechanism, owner: str) -> Constraint:
    return next(constraint for constraint in mechanism.constraints if constraint.owner == owner)


def _reaches(mechanism: Mechanism, group: frozenset[str], owner: str, start: str, spring: Spring) -> bool:
    """Return whether `start` is on the side of `spring` when the connection `owner` is cut."""
    graph = nx.Graph()
    graph.add_nodes_from(group)
    for constraint in mechanism.constraints:
        if set(constraint.row) <= group and constraint.owner != owner:
            names = list(constraint.row)
            graph.add_edges_from(itertools.pairwise(names))
    end = next(name for name in spring.row if name in group)
    return end in nx.node_connected_component(graph, start)

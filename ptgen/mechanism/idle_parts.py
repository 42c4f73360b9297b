"""Parts of a bed that no machine acts on while its clutches slip, such as the shaft between two of them.

Rigid connections, gears and shafts tie velocities together; friction does not. A part without a machine moves as
friction drives it, whatever the machines do, so no controller can do anything about it: its friction elements are
disturbances of their other sides.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection
from dataclasses import dataclass, replace

import networkx as nx

from ptgen.mechanism.mechanism import Mechanism

__all__ = ["IdlePart", "component_of", "idle_parts", "without_parts"]


@dataclass(frozen=True)
class IdlePart:
    """A part without a machine.

    Attributes
    ----------
    velocities : frozenset of str
    names : tuple of str
        What it consists of, in the order of the bed: components, or flanges of a component that has others elsewhere.
    frictions : tuple of str
        The friction elements that act on it.
    """

    velocities: frozenset[str]
    names: tuple[str, ...]
    frictions: tuple[str, ...]


def idle_parts(mechanism: Mechanism, keep: Collection[str] = ()) -> tuple[IdlePart, ...]:
    """Return the parts without a machine, in the order of the bed.

    Parameters
    ----------
    mechanism : Mechanism
    keep : collection of str
        Components whose parts are not wanted.
    """
    graph = nx.Graph()
    graph.add_nodes_from(mechanism.velocities)
    for row in (element.row for elements in (mechanism.constraints, mechanism.springs) for element in elements):
        graph.add_edges_from(itertools.pairwise(row))
    driven = {name for torque in mechanism.torques for name in torque.row}
    found = []
    for group in nx.connected_components(graph):
        components = {component_of(velocity) for velocity in group}
        if group & driven or components & set(keep):
            continue
        elsewhere = {component_of(velocity) for velocity in mechanism.velocities if velocity not in group}
        inside = [velocity for velocity in mechanism.velocities if velocity in group]
        names = dict.fromkeys(v if component_of(v) in elsewhere else component_of(v) for v in inside)
        frictions = tuple(friction.name for friction in mechanism.frictions if set(friction.row) & group)
        found.append(IdlePart(frozenset(group), tuple(names), frictions))
    return tuple(found)


def component_of(velocity: str) -> str:
    """Return the component that a velocity belongs to."""
    return velocity.split(".", 1)[0]


def without_parts(mechanism: Mechanism, parts: Collection[IdlePart]) -> Mechanism:
    """Return the mechanism without `parts`; friction elements at their border act on the other side alone."""
    gone = {velocity for part in parts for velocity in part.velocities}
    if not gone:
        return mechanism
    springs = {spring.name for spring in mechanism.springs if set(spring.row) & gone}
    frictions = tuple(
        replace(friction, row={name: value for name, value in friction.row.items() if name not in gone})
        for friction in mechanism.frictions
        if set(friction.row) - gone
    )
    places = tuple(place for place in mechanism.places if not set(place.flanges) & gone)
    lost = gone | springs | {place.name for place in mechanism.places if place not in places}
    return replace(
        mechanism,
        velocities=tuple(name for name in mechanism.velocities if name not in gone),
        bodies=tuple(body for body in mechanism.bodies if body.velocity not in gone),
        constraints=tuple(constraint for constraint in mechanism.constraints if not set(constraint.row) & gone),
        springs=tuple(spring for spring in mechanism.springs if spring.name not in springs),
        frictions=frictions,
        sensors=tuple(sensor for sensor in mechanism.sensors if sensor.of not in lost),
        places=places,
        connections={flange: at for flange, at in mechanism.connections.items() if flange not in gone},
        observed=tuple(place for place in mechanism.observed if place not in lost),
        fluids=tuple(fluid for fluid in mechanism.fluids if not {fluid.pump, fluid.turbine} & gone),
    )

"""What the sensors of a bed say about its states, and which of them a law asks first."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet

import networkx as nx
import sympy as sp

from ptgen.control.state_law import StateLaw
from ptgen.elements import SensorKind
from ptgen.mechanism import exact
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import LinearForm, Model

__all__ = ["SensorRows"]


class SensorRows:
    """The sensors as ``y = C x + D u + F T``, and combinations of them.

    Parameters
    ----------
    mechanism : Mechanism
        The bed before reduction: how far a sensor is from a machine.
    model : Model
        The reduced model.
    torque_machines : set of int
        Machines that control a torque. A sensor that reads the air-gap torque of one of them comes last: it would
        let this torque depend on itself.
    losses : sequence of str
        Friction elements whose torques are known, so that no sensor has to give them.

    Attributes
    ----------
    model : Model
    torque_machines : frozenset of int
    sensors : tuple of str (n_s)
    C, D, F : Matrix (n_s, n), (n_s, m), (n_s, n_f)
    known, unknown : list of int
        Columns of the friction torques that are known, and of the others.
    """

    def __init__(
        self, mechanism: Mechanism, model: Model, torque_machines: set[int] | frozenset[int], losses: Sequence[str]
    ) -> None:
        forms = [model.without_acceleration(model.signals[sensor.name]) for sensor in model.sensors]
        self.model = model
        self.torque_machines = frozenset(torque_machines)
        self.sensors = tuple(sensor.name for sensor in model.sensors)
        self.C = exact.stack([sp.Matrix.hstack(form.z, form.e) for form in forms], model.order)
        self.D = exact.stack([form.u for form in forms], len(model.inputs))
        width = len(model.frictions) + len(model.contacts)
        self.F = exact.stack([form.f for form in forms], width)
        self.known = [k for k, friction in enumerate(model.frictions) if friction.name in losses]
        self.unknown = [k for k in range(width) if k not in self.known]
        self._fed_back = [any(form.u[machine] != 0 for machine in torque_machines) for form in forms]
        self._speeds = [sensor.kind is SensorKind.SPEED for sensor in model.sensors]
        self._mechanism = mechanism
        self._distances = _distances(mechanism)

    def alone(self) -> sp.Matrix:
        """Return the sensors over (x, friction torques) without air-gap torques."""
        return sp.Matrix.hstack(self.C, self.F)

    def under(self, law: StateLaw) -> sp.Matrix:
        """Return the sensors over (x, unknown friction torques) in closed loop, virtual inputs zero."""
        return self.unknown_part(self.C + self.D * law.x, self.F + self.D * law.T)

    def unknown_part(self, of_x: sp.Matrix, of_T: sp.Matrix) -> sp.Matrix:
        """Return both side by side, without the columns of known torques."""
        return sp.Matrix.hstack(of_x, of_T[:, self.unknown])

    def combination(self, seen: sp.Matrix, wanted: sp.Matrix, order: Sequence[int]) -> sp.Matrix | None:
        """Return ``row`` (1, n_s) with ``row seen = wanted``, earlier sensors in `order` preferred; None if none is."""
        solution = exact.preferred_solution(seen[list(order), :].T, wanted.T)
        if solution is None:
            return None
        row = sp.zeros(1, len(self.sensors))
        for position, sensor in enumerate(order):
            row[sensor] = solution[position]
        return row

    def order(self, velocity: str, speeds_first: bool = False, preferred: AbstractSet[int] = frozenset()) -> list[int]:
        """Return the sensors from the nearest to a velocity to the farthest, after speeds the preferred ones."""
        return self._sorted(self._distances[velocity], speeds_first, preferred)

    def reading(self, outputs: Iterable[LinearForm]) -> frozenset[int]:
        """Return the sensors that read one of these quantities themselves, up to a factor."""
        rows = [sp.Matrix.hstack(form.z, form.e, form.f) for form in outputs]
        mine = sp.Matrix.hstack(self.C, self.F)
        return frozenset(
            k
            for k in range(len(self.sensors))
            if not self._speeds[k] and any(exact.rank(mine[k, :].col_join(row)) < 2 for row in rows)
        )

    def order_at(self, place: str) -> list[int]:
        """Return the sensors from the nearest to a place, or to any flange of a sum, to the farthest."""
        return self._sorted(self._nearest(place), False, frozenset())

    def _sorted(self, near: Mapping[str, int], speeds_first: bool, preferred: AbstractSet[int]) -> list[int]:
        return sorted(
            range(len(self.sensors)),
            key=lambda k: (
                self._fed_back[k],
                speeds_first and not self._speeds[k],
                k not in preferred,
                near.get(self.model.sensors[k].of, 1e9),
            ),
        )

    def _nearest(self, place: str) -> dict[str, int]:
        """Return the distance of every sensor from a place; for a sum of flanges, from the nearest of them."""
        flanges = [place]
        for item in self._mechanism.places:
            if item.name == place:
                flanges = list(item.flanges)
        sources: list[str] = []
        for flange in flanges:
            owner = self._mechanism.connections.get(flange)
            sources.append(owner[0] if owner is not None and owner[0] in self._distances else flange)
        result: dict[str, int] = {}
        for source in sources:
            for node, length in self._distances.get(source, {}).items():
                result[node] = min(length, result.get(node, length))
        return result


def _graph(mechanism: Mechanism) -> nx.Graph:
    """Return the graph of velocities, with every spring and torque sensor as a node of its own."""
    graph = nx.Graph()
    for constraint in mechanism.constraints:
        graph.add_edges_from((constraint.owner, name) for name in constraint.row)
    for spring in mechanism.springs:
        graph.add_edges_from((spring.name, name) for name in spring.row)
    return graph


def _distances(mechanism: Mechanism) -> dict[str, dict[str, int]]:
    return {source: dict(lengths) for source, lengths in nx.all_pairs_shortest_path_length(_graph(mechanism))}

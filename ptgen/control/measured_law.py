"""A law from measured signals only: states and disturbances replaced by sensors, the machine's own ones first."""

from __future__ import annotations

from dataclasses import dataclass

import networkx as nx
import sympy as sp

from ptgen.control import findings
from ptgen.control.lie import OutputChain
from ptgen.elements import SensorKind
from ptgen.mechanism import exact
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import LinearForm, Model

__all__ = ["Law", "measured_law"]


@dataclass(frozen=True)
class Law:
    """``u = P v + R y`` with virtual inputs v and sensors y, and the estimate of the controlled torques.

    Attributes
    ----------
    P : Matrix (m, m)
        Share of each virtual input, in the order of the outputs.
    R : Matrix (m, n_s)
        Share of each sensor.
    estimate_sensors : Matrix (n_t, n_s)
        Controlled torques from sensors, (5.95).
    estimate_virtual : Matrix (n_t, m)
        Correction of these by virtual inputs: torques that accelerate gearboxes, (5.98).
    """

    P: sp.Matrix
    R: sp.Matrix
    estimate_sensors: sp.Matrix
    estimate_virtual: sp.Matrix


def measured_law(
    mechanism: Mechanism,
    model: Model,
    chains: tuple[OutputChain, ...],
    state_law: tuple[sp.Matrix, sp.Matrix, sp.Matrix],
    outputs: dict[str, LinearForm],
    actuators: tuple[int, ...],
    torque_count: int,
    machines: tuple[str, ...],
    swinging: tuple[str, ...],
) -> Law:
    """Replace states and disturbances by sensors.

    With ``y = C x + D_s u + F_s T`` and ``u = U_v v + U_x x + U_T T`` the combination ``R`` has to satisfy
    ``R (C + D_s U_x) = U_x`` and ``R (F_s + D_s U_T) = U_T``; then ``P = U_v - R D_s U_v``.
    """
    U_v, U_x, U_T = state_law
    forms = [model.without_acceleration(model.signals[sensor.name]) for sensor in model.sensors]
    D_s = exact.stack([form.u for form in forms], len(machines))
    of_x = exact.stack([sp.Matrix.hstack(form.z, form.e) for form in forms], U_x.shape[1]) + D_s * U_x
    of_T = exact.stack([form.f for form in forms], U_T.shape[1]) + D_s * U_T
    seen = sp.Matrix.hstack(of_x, of_T)
    count = len(forms)
    distances = _distances(mechanism)

    def combination(wanted: sp.Matrix, order: list[int], what: str) -> sp.Matrix:
        solution = exact.preferred_solution(seen[order, :].T, wanted.T)
        if solution is None:
            raise findings.unmeasured(what, model, swinging)
        row = sp.zeros(1, count)
        for position, sensor in enumerate(order):
            row[sensor] = solution[position]
        return row

    torque_machines = actuators[:torque_count]
    # A sensor that reads the torque of a torque-controlled machine would let this torque depend on itself.
    fed_back = [any(form.u[machine] != 0 for machine in torque_machines) for form in forms]
    speeds = [sensor.kind is SensorKind.SPEED for sensor in model.sensors]
    R = sp.zeros(len(machines), count)
    for machine, name in enumerate(machines):
        near = distances[f"{name}.shaft"]
        order = sorted(
            range(count),
            key=lambda k: (
                fed_back[k],
                machine in torque_machines and not speeds[k],
                near.get(model.sensors[k].of, 1e9),
            ),
        )
        R[machine, :] = combination(sp.Matrix.hstack(U_x[machine, :], U_T[machine, :]), order, f"the law of {name}")
    P = exact.canonical(U_v - R * D_s * U_v)

    estimate = sp.zeros(torque_count, count)
    for index in range(torque_count):
        place = list(outputs)[index]
        form = outputs[place]
        near = _nearest_distance(mechanism, place, distances)
        order = sorted(
            range(count),
            key=lambda k: (fed_back[k], near.get(model.sensors[k].of, 1e9)),
        )
        wanted = sp.Matrix.hstack(form.z, form.e, form.f)
        estimate[index, :] = combination(wanted, order, f"the torque at {place}")
    return Law(P, exact.canonical(R), estimate, exact.canonical(-estimate * D_s * U_v))


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


def _nearest_distance(mechanism: Mechanism, place: str, distances: dict[str, dict[str, int]]) -> dict[str, int]:
    """Return the distance of every sensor from a place; for a sum of flanges, from the nearest of them."""
    flanges = [place]
    for item in mechanism.places:
        if item.name == place:
            flanges = list(item.flanges)
    sources: list[str] = []
    for flange in flanges:
        owner = mechanism.connections.get(flange)
        sources.append(owner[0] if owner is not None and owner[0] in distances else flange)
    result: dict[str, int] = {}
    for source in sources:
        for node, length in distances.get(source, {}).items():
            result[node] = min(length, result.get(node, length))
    return result

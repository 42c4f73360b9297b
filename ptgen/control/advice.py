"""What to do when a bed has no control law: other roles, sensors, locked elements, individual feedback; all tried."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from ptgen.elements import FrictionRole, Sensor, SensorKind
from ptgen.errors import ControlError, ModelError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.reduction import ReducedModel
from ptgen.testbed.testbed import Roles, Structure

__all__ = ["Works", "with_advice"]

Works = Callable[[ReducedModel, Roles, Structure], bool]
"""Tells whether there is a law for a reduced bed, roles and a structure."""

_SHOWN = 3
_TRIED = 24


def with_advice(
    error: ControlError, reduced: ReducedModel, roles: Roles, structure: Structure, works: Works
) -> ControlError:
    """Return the error with a remedy that names what would work.

    Parameters
    ----------
    error : ControlError
    reduced : ReducedModel
    roles : Roles
        The roles that do not work.
    structure : {"decoupling", "individual"}
    works : callable
        Tells whether a changed bed, roles and structure give a law; everything that is advised was tried with it.
    """
    if any(
        problem.where.startswith("control.torque") and "has no torque at" in problem.what for problem in error.problems
    ):
        return error  # a misspelt place
    remedies = []
    machines = [torque.name for torque in reduced.model.inputs]
    tried = itertools.islice(_other_roles(machines, roles), _TRIED)
    found = list(itertools.islice((text for other, text in tried if works(reduced, other, structure)), _SHOWN))
    if any(problem.where == "components" for problem in error.problems):
        remedies += _sensors(reduced, roles, structure, works)
    if found:
        remedies.append("roles that would work: " + "; ".join(found))
    remedies += _locked(reduced, roles, structure, works)
    if structure == "decoupling" and works(reduced, roles, "individual"):
        remedies.append(
            "individual feedback with active damping works with these roles, without decoupling: "
            'structure = "individual" in [control]'
        )
    if not remedies:
        return error
    return ControlError([replace(problem, remedy="; or ".join(remedies)) for problem in error.problems])


def _other_roles(machines: Sequence[str], roles: Roles) -> Iterator[tuple[Roles, str]]:
    """Yield the other assignments of the same places, then those with fewer torques."""
    places = list(roles.torque.values())
    for count in range(len(places), 0, -1):
        for chosen in itertools.combinations(places, count):
            for torque_machines in itertools.permutations(machines, count):
                torque = dict(zip(torque_machines, chosen, strict=True))
                speed = tuple(name for name in machines if name not in torque)
                candidate = replace(roles, torque=torque, speed=speed)
                if candidate != roles:
                    text = ", ".join(f'{machine} = "{place}"' for machine, place in torque.items())
                    yield candidate, f"torque {{ {text} }} with speed [{', '.join(speed)}]"


def _locked(reduced: ReducedModel, roles: Roles, structure: Structure, works: Works) -> list[str]:
    """Return the advice to design for locked elements, for those with which it works."""
    names = []
    for friction in reduced.model.frictions:
        if friction.role is FrictionRole.LOSS:
            continue
        try:
            other = _reassembled(reduced, reduced.mechanism.with_locked_frictions({friction.name}))
        except ModelError:
            continue
        if works(other, roles, structure):
            names.append(friction.name)
    if not names:
        return []
    quoted = " or ".join(f'["{name}"]' for name in names)
    return [f"if it is locked during the test, design for that: [reduction] locked = {quoted}"]


def _sensors(reduced: ReducedModel, roles: Roles, structure: Structure, works: Works) -> list[str]:
    """Return the advice to add torque flanges, the fewest beside machines with which it works."""
    measured = {sensor.of for sensor in reduced.model.sensors if sensor.kind is SensorKind.TORQUE}
    shafts = {torque.name: next(iter(torque.row)) for torque in reduced.model.inputs}
    without = [name for name, shaft in shafts.items() if not _beside(reduced, shaft) & measured]
    for count in range(1, len(without) + 1):
        found = []
        for names in itertools.combinations(without, count):
            sensors = tuple(Sensor(f"{name}_flange_torque", SensorKind.TORQUE, shafts[name]) for name in names)
            mechanism = replace(reduced.mechanism, sensors=reduced.mechanism.sensors + sensors)
            original = replace(reduced.original, sensors=reduced.original.sensors + sensors)
            if works(replace(_reassembled(reduced, mechanism), original=original), roles, structure):
                found.append(f"a torque flange next to {' and '.join(names)}")
        if found:
            return ["add " + ", or ".join(found[:_SHOWN])]
    return []


def _beside(reduced: ReducedModel, shaft: str) -> set[str]:
    """Return the components that are connected to a machine's shaft."""
    owner = reduced.original.connections.get(shaft)
    if owner is None:
        return set()
    return {flange.split(".", 1)[0] for flange in owner[0].split(" - ")}


def _reassembled(reduced: ReducedModel, mechanism: Mechanism) -> ReducedModel:
    model = assemble(mechanism, first="machines")
    damping = reduced.equivalent_damping
    if len(model.twists) != len(damping):
        damping = np.zeros((len(model.twists),) * 2)
    return replace(reduced, mechanism=mechanism, model=model, equivalent_damping=damping)

"""Roles: which machine controls what, and where a torque is defined."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ptgen.components.component import Component
from ptgen.errors import Problem, nearest
from ptgen.testbed.chains import Link
from ptgen.testbed.problems import dotted, shown

__all__ = ["Bed", "check", "torque_places"]


@dataclass(frozen=True)
class Bed:
    """What the roles are checked against.

    Attributes
    ----------
    types : mapping of str to type of Component
        The components whose type is known.
    components : mapping of str to Component
        Those of them that have no problem.
    links : tuple of Link
        The connections; None if they have problems, so that any flange counts as connected.
    unreadable : frozenset of str
        Components whose type has a problem of its own.
    """

    types: Mapping[str, type[Component]]
    components: Mapping[str, Component]
    links: tuple[Link, ...] | None
    unreadable: frozenset[str]


def torque_places(bed: Bed) -> list[str]:
    """Return the places where a torque reference may hold.

    They are the connected flanges of all components that are no machines, the sums that a component offers,
    and the two-flange components with a compliance, such as a torque flange.
    """
    places: list[str] = []
    for name, kind in bed.types.items():
        if kind.is_machine:
            continue
        flanges = kind.flange_names()
        component = bed.components.get(name)
        if len(flanges) == 2 and (component is None or _gives_way(name, component)):
            places.append(name)
        places += [f"{name}.{place}" for place in kind.place_names()]
        places += [f"{name}.{flange}" for flange in flanges if _connected(f"{name}.{flange}", bed)]
    return places


def _gives_way(name: str, component: Component) -> bool:
    """Tell whether the component as a whole is a compliance, whose torque is that of the component."""
    return any(spring.name == name for spring in component.elements(name).springs)


def _connected(flange: str, bed: Bed) -> bool:
    if bed.links is None:
        return True
    return any(flange in (link.connection.left, link.connection.right) for link in bed.links)


def check(torque: Mapping[str, str], speed: Sequence[str], bed: Bed) -> list[Problem]:
    """Return the problems of the roles.

    Parameters
    ----------
    torque : mapping of str to str
        Machine -> place, as in ``control.torque``.
    speed : sequence of str
        Machines, as in ``control.speed``.
    bed : Bed
        The bed.
    """
    machines = [name for name, kind in bed.types.items() if kind.is_machine]
    problems: list[Problem] = []
    for name in torque:
        problems += _no_machine(name, machines, bed, "control", "torque", name)
    for index, name in enumerate(speed):
        where = ("control", "speed", index)
        problems += _no_machine(name, machines, bed, *where)
        if name in torque:
            what = f'"{name}" has two roles, torque and speed: a machine controls one quantity'
            problems.append(Problem(dotted(*where), what, f'remove "{name}" from control.speed or control.torque'))
        if name in speed[:index]:
            problems.append(Problem(dotted(*where), f'"{name}" is listed twice', "remove one of them"))
    problems += _places(torque, bed)
    if not bed.unreadable:
        problems += _complete(machines, torque, speed)
    return problems


def _no_machine(name: str, machines: Sequence[str], bed: Bed, *where: object) -> list[Problem]:
    if name in machines or name in bed.unreadable:
        return []
    kind = bed.types.get(name)
    what = f"{shown(name)} is no machine of the bed"
    if kind is not None:
        what = f'"{name}" is a {kind.type_name}, and only a machine can have a role'
    remedy = nearest(name, machines) if machines else 'add a component with type = "machine"'
    return [Problem(dotted(*where), what, remedy)]


def _places(torque: Mapping[str, str], bed: Bed) -> list[Problem]:
    problems: list[Problem] = []
    allowed = torque_places(bed)
    users: dict[str, str] = {}
    for machine, place in torque.items():
        where = dotted("control", "torque", machine)
        name, _, flange = place.partition(".")
        if name in bed.unreadable:
            continue
        if place not in allowed:
            problems.append(Problem(where, *_no_place(place, name, flange, bed, allowed)))
        elif users.setdefault(place, machine) != machine:
            what = f'"{place}" is controlled twice, by "{users[place]}" and by "{machine}"'
            problems.append(Problem(where, what, "give one of them another place, or a speed"))
    return problems


def _no_place(place: str, name: str, flange: str, bed: Bed, allowed: Sequence[str]) -> tuple[str, str]:
    """Return what is wrong with a place, and what to do."""
    remedy = nearest(place, allowed)
    kind = bed.types.get(name)
    if kind is None:
        return f"{shown(place)} names no component of the bed", remedy
    if kind.is_machine:
        neighbours = [
            other
            for link in bed.links or ()
            for ours, other in (
                (link.connection.left, link.connection.right),
                (link.connection.right, link.connection.left),
            )
            if ours.startswith(f"{name}.") and other in allowed
        ]
        what = f"{shown(place)} is a machine, where no torque reference can hold"
        return what, f'write the flange that it drives, "{neighbours[0]}"' if neighbours else remedy
    own = [other for other in allowed if other.partition(".")[0] == name]
    if flange in kind.flange_names():
        return (
            f"{shown(place)} is not connected, so it carries no torque",
            "choose a flange that is connected",
        )
    what = f"no torque is defined at {shown(place)}"
    return what, nearest(place, own) if own else remedy


def _complete(machines: Sequence[str], torque: Mapping[str, str], speed: Sequence[str]) -> list[Problem]:
    """Check that every machine has a role, and that there are as many roles as machines."""
    count = len(torque) + len(speed)
    if not machines:
        what = "the bed has no machine"
        return [Problem("components", what, 'add a component with type = "machine"')]
    if count == 0:
        remedy = 'write e.g. torque = { M1 = "flange1" } and speed = ["M2"]'
        return [Problem("control", f"no machine has a role; there are {len(machines)}".replace("; ", ": "), remedy)]
    missing = [name for name in machines if name not in torque and name not in speed]
    balance = f"{len(machines)} machines, {count} controlled quantities"
    problems: list[Problem] = []
    if missing:
        plural = len(missing) > 1
        what = f"{', '.join(missing)} {'have' if plural else 'has'} no role ({balance})"
        remedy = f"add {'them' if plural else 'it'} to control.speed or control.torque"
        problems.append(Problem("control", what, remedy))
    if count > len(machines):
        what = f"more controlled quantities than machines ({balance})"
        problems.append(Problem("control", what, "give every machine one role"))
    return problems

"""Names: they become C identifiers, so they must be some, and must stay different when parts are appended."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from ptgen.components.component import Component
from ptgen.errors import Problem
from ptgen.testbed.problems import dotted, shown

__all__ = ["PATTERN", "check_component_names", "check_mangled", "check_name"]

PATTERN = "^[A-Za-z][A-Za-z0-9_]{0,39}$"

_KEYWORDS = frozenset(
    """
    auto break case char const continue default do double else enum extern float for goto if inline int long
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile
    while asm bool true false main
    """.split()  # noqa: SIM905  forty words in quotation marks are harder to read
)


def check_name(name: str, *path: object) -> list[Problem]:
    """Return the problem of a name that is no C identifier.

    Examples
    --------
    >>> check_name("left wheel", "testbed", "name")[0].remedy
    'write e.g. left_wheel'
    """
    where = dotted(*path)
    if not re.fullmatch(PATTERN.strip("^$"), name):
        rule = "a name is a letter and then at most 39 letters, digits and underscores"
        plain = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_")[:40] or "M1"
        plain = plain if plain[0].isalpha() else f"c{plain}"[:40]
        return [Problem(where, f"{shown(name)} is no name: {rule}", f"write e.g. {plain}")]
    if name in _KEYWORDS:
        return [Problem(where, f'"{name}" is a word of the language C', f"write e.g. {name}1")]
    return []


def check_component_names(names: Mapping[str, object], *path: object) -> list[Problem]:
    """Return the problems of names at `path`: no C identifiers, or alike but for upper and lower case."""
    problems: list[Problem] = []
    seen: dict[str, str] = {}
    for name in names:
        where = (*path, name)
        problems += check_name(name, *where)
        first = seen.setdefault(name.lower(), name)
        if first != name:
            what = f'differs from "{first}" only in upper and lower case'
            problems.append(Problem(dotted(*where), what, "rename one of them"))
    return problems


def check_mangled(components: Mapping[str, Component]) -> list[Problem]:
    """Return the problems of components whose signals or parameters would have the same name in C."""
    problems: list[Problem] = []
    owners: dict[str, str] = {}
    clashes: set[tuple[str, str]] = set()
    for name, component in components.items():
        for identifier in _identifiers(name, component):
            owner = owners.setdefault(identifier, name)
            if owner != name and (owner, name) not in clashes:
                clashes.add((owner, name))
                what = f'"{name}" and "{owner}" would both have a "{identifier}" in C'
                problems.append(Problem(dotted("components", name), what, "rename one of them"))
    return problems


def _identifiers(name: str, component: Component) -> Iterator[str]:
    elements = component.elements(name)
    yield name
    yield from (f"{name}_{flange}" for flange in component.flange_names())
    yield from (f"{name}_{flange}_torque_ref" for flange in component.flange_names())
    yield from (f"{name}_{place}_torque_ref" for place in component.place_names())
    yield from (f"{name}_{place}" for place in component.place_names())
    for parameter in component.parameters(name):
        yield parameter.symbol.name
        if parameter.span is not None:
            yield f"{parameter.symbol.name}_now"
    yield from (sensor.name for sensor in elements.sensors)
    yield from (f"{sensor.name}_true" for sensor in elements.sensors if sensor.time_constant is not None)
    for friction in elements.frictions:
        plain = friction.name.replace(".", "_")
        yield plain
        yield f"{plain}_torque"
        yield f"{plain}_speed"
        if friction.actuated:
            yield f"{plain}_actuation"
    for fluid in elements.fluids:
        plain = fluid.name.replace(".", "_")
        yield from (f"{plain}_{part}" for part in ("pump_torque", "turbine_torque", "knots", "curves"))
    yield from (velocity.replace(".", "_") for velocity in elements.internal)
    if any(spring.name == name for spring in elements.springs):
        yield f"{name}_torque_ref"
    if component.is_machine:
        yield f"{name}_torque"
        yield f"{name}_torque_ref"
        yield f"{name}_speed_ref"

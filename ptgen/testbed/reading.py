"""From a test bed file to a checked `Testbed`; all problems of the file are reported at once."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from typing import Any

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.errors import Problem, TestbedError, nearest
from ptgen.testbed import loops, roles, topology
from ptgen.testbed.chains import Chains, follow, split
from ptgen.testbed.names import check_component_names, check_mangled, check_name
from ptgen.testbed.problems import dotted, shown, validated
from ptgen.testbed.schema import BedSection, ControlSection
from ptgen.testbed.testbed import ReductionSettings, Roles, Testbed, Tuning
from ptgen.testbed.text import read_toml

__all__ = ["load"]

_SECTIONS = {
    "testbed": 'add [testbed] with name = "bed", sample_time = "100 us" and connections = [ ... ]',
    "components": 'add a table such as [components.M1] with type = "machine"',
    "control": 'add [control] with torque = { M1 = "flange1" } and speed = ["M2"]',
}
_OPTIONAL = ("reduction",)


def load(path: str | PathLike[str]) -> Testbed:
    """Read and check a test bed file.

    Parameters
    ----------
    path : path-like
        A TOML file.

    Returns
    -------
    Testbed
        The bed, in SI units.

    Raises
    ------
    TestbedError
        With every problem of the file.
    """
    document = read_toml(path, "test bed file")
    tables = document.tables
    problems = _sections(tables)
    bed, found = validated(BedSection, tables["testbed"], "testbed") if "testbed" in tables else (None, [])
    problems += found
    control, found = (
        validated(ControlSection, tables["control"], "control") if "control" in tables else (None, [])
    )
    problems += found
    reduction, found = validated(ReductionSettings, tables.get("reduction", {}), "reduction")
    problems += found
    described = tables.get("components", {})
    types, components, found = _components(described)
    problems += found
    unreadable = frozenset(described) - frozenset(types) if isinstance(described, dict) else frozenset()

    chains: Chains | None = None
    if bed is not None:
        problems += check_name(bed.name, "testbed", "name")
        problems += _assumed(bed.assumed, tables)
        if isinstance(described, dict):
            chains, found = _connected(bed.connections, types, components, unreadable)
            problems += found
    if isinstance(described, dict):
        links = chains.links if chains else None
        known = roles.Bed(types, components, links, unreadable)
        if control is not None:
            problems += roles.check(control.torque, control.speed, known)
            problems += _estimates(control.inertia_estimate, known)
        elif described and not unreadable and not any(kind.is_machine for kind in types.values()):
            problems += roles.check({}, (), known)
        if reduction is not None:
            problems += _reduced(reduction, described)
    if problems or bed is None or control is None or reduction is None or chains is None:
        raise TestbedError(problems, document.file)
    return Testbed(
        name=bed.name,
        title=bed.title or bed.name,
        file=document.file,
        digest=document.digest,
        sample_time=bed.sample_time,
        components=components,
        connections=tuple(link.connection for link in chains.links),
        orientation=chains.orientation,
        roles=Roles(control.torque, control.speed),
        tuning=Tuning.model_construct(**{key: getattr(control, key) for key in Tuning.model_fields}),
        reduction=reduction,
        assumed=bed.assumed,
    )


def _sections(tables: Mapping[str, Any]) -> list[Problem]:
    """Check that the file has the sections that it needs, and no others."""
    known = (*_SECTIONS, *_OPTIONAL)
    problems = [
        Problem(dotted(key), "is an unknown section", nearest(key, known))
        for key in tables
        if key not in known
    ]
    return problems + [
        Problem(key, "is missing", text) for key, text in _SECTIONS.items() if key not in tables
    ]


def _components(
    described: object,
) -> tuple[dict[str, type[Component]], dict[str, Component], list[Problem]]:
    """Read ``[components]``: the type of each component if that is known, and the record if it has no problem."""
    types: dict[str, type[Component]] = {}
    components: dict[str, Component] = {}
    if not isinstance(described, dict):
        what = f"must hold tables, got {shown(described)}"
        return types, components, [Problem("components", what, _SECTIONS["components"])]
    problems = check_component_names(described)
    for name, table in described.items():
        where = dotted("components", name)
        if not isinstance(table, dict):
            remedy = f'write [{where}] with type = "machine" (or another type) and its values'
            problems.append(Problem(where, f"must be a table, got {shown(table)}", remedy))
            continue
        if "type" not in table:
            what = "is missing: what the component is"
            problems.append(Problem(f"{where}.type", what, f"add type = ...; {nearest('', CATALOGUE)}"))
            continue
        kind = CATALOGUE.get(table["type"]) if isinstance(table["type"], str) else None
        if kind is None:
            word = table["type"] if isinstance(table["type"], str) else ""
            what = f"is no type of component: {shown(table['type'])}"
            problems.append(Problem(f"{where}.type", what, nearest(word, CATALOGUE)))
            continue
        types[name] = kind
        component, found = validated(kind, table, "components", name)
        problems += found
        if component is not None:
            components[name] = component
    problems += check_mangled(components)
    return types, components, problems


def _connected(
    texts: tuple[str, ...],
    types: Mapping[str, type[Component]],
    components: Mapping[str, Component],
    unreadable: frozenset[str],
) -> tuple[Chains | None, list[Problem]]:
    """Read the chains; what can only be judged on the whole bed is judged if all of it is readable."""
    if not texts:
        remedy = 'write a chain such as "M1 - flange1 - M2"'
        return None, [Problem("testbed.connections", "is empty", remedy)]
    stops, problems = split(texts, types, unreadable)
    if problems or unreadable:
        return None, problems
    chains = follow(stops, types)
    problems = topology.check(chains, types)
    for name in chains.opposed:
        component = components.get(name)
        if component is not None and component.elements(name).springs:
            what = "the chains pass it in opposite directions, so the sign of its torque is undefined"
            remedy = "turn one of the chains around, or name other flanges"
            problems.append(Problem(dotted("components", name), what, remedy))
    if not problems and len(components) == len(types):
        problems = loops.check(components, [link.connection for link in chains.links])
    return chains, problems


def _assumed(keys: tuple[str, ...], tables: Mapping[str, Any]) -> list[Problem]:
    """Check that the values which are marked as assumed exist."""
    known = set(_paths(tables, ""))
    return [
        Problem(
            dotted("testbed", "assumed", index), f"{shown(key)} is no key of this file", nearest(key, known)
        )
        for index, key in enumerate(keys)
        if key not in known
    ]


def _paths(table: Mapping[str, Any], prefix: str) -> list[str]:
    found: list[str] = []
    for key, value in table.items():
        path = f"{prefix}.{key}" if prefix else key
        found.append(path)
        if isinstance(value, dict):
            found += _paths(value, path)
    return found


def _estimates(estimates: Mapping[str, float], bed: roles.Bed) -> list[Problem]:
    machines = [name for name, kind in bed.types.items() if kind.is_machine]
    return [
        Problem(
            dotted("control", "inertia_estimate", name), "is no machine of the bed", nearest(name, machines)
        )
        for name in estimates
        if name not in machines and name not in bed.unreadable
    ]


def _reduced(settings: ReductionSettings, described: Mapping[str, object]) -> list[Problem]:
    """Check that the components which the reduction names exist and are named for one thing only."""
    problems: list[Problem] = []
    for key in ("rigid", "keep", "drop"):
        for index, name in enumerate(getattr(settings, key)):
            where = dotted("reduction", key, index)
            if name not in described:
                problems.append(Problem(where, f"{shown(name)} is no component", nearest(name, described)))
            elif key != "keep" and name in settings.keep:
                what = f'"{name}" stands in reduction.keep too'
                problems.append(Problem(where, what, "remove it from one of the two lists"))
    return problems

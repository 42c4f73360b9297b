"""From a test bed file to a checked `Testbed`; all problems of the file are reported at once."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from ptgen.components.component import Component
from ptgen.errors import Problem, TestbedError, nearest
from ptgen.testbed import feedback, loops, roles, topology
from ptgen.testbed.chains import Chains, follow, split
from ptgen.testbed.component_tables import read_components
from ptgen.testbed.gear_tables import check_as_ratio
from ptgen.testbed.governor_settings import GovernorSettings, check_governor
from ptgen.testbed.names import check_name
from ptgen.testbed.parts import combined, part_kinds
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
_OPTIONAL = ("reduction", "governor")


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
    if "part" in tables and "testbed" not in tables:
        remedy = 'name it in a bed, with type = "part" and file = "..."; `ptgen gears` shows what it does'
        raise TestbedError(Problem("", "is a part file, not a test bed", remedy), document.file)
    problems = _sections(tables)
    bed, found = validated(BedSection, tables["testbed"], "testbed") if "testbed" in tables else (None, [])
    problems += found
    control, found = validated(ControlSection, tables["control"], "control") if "control" in tables else (None, [])
    problems += found
    reduction, found = validated(ReductionSettings, tables.get("reduction", {}), "reduction")
    problems += found
    governor, found = validated(GovernorSettings, tables.get("governor", {}), "governor")
    problems += found
    described = tables.get("components", {})
    digests = [document.digest]
    folder = Path(document.file).parent
    tabled = read_components(described, part_kinds(folder, digests), folder)
    types, components = tabled.types, tabled.components
    problems += tabled.problems
    problems += check_governor(
        _entry(tables, "governor", "kind"), _entry(tables, "control", "speed_control"), components
    )
    unreadable = frozenset(described) - frozenset(types) if isinstance(described, dict) else frozenset()

    # What follows is judged on the file itself, so that a wrong bandwidth does not hide a wrong connection.
    name = _entry(tables, "testbed", "name")
    if isinstance(name, str):
        problems += check_name(name, "testbed", "name")
    problems += _assumed(_texts(tables, "testbed", "assumed") or (), tables)
    chains: Chains | None = None
    if "components" in tables and isinstance(described, dict):
        texts = _texts(tables, "testbed", "connections")
        if texts is not None:
            chains, found = _connected(texts, types, components, unreadable)
            problems += found
        known = roles.Bed(types, components, chains.links if chains else None, unreadable)
        problems += _roles(tables, known)
        problems += _reduced(tables, described)
        if isinstance(section := tables.get("reduction", {}), dict):
            problems += check_as_ratio(section, _entry(tables, "control", "torque"), types, components, unreadable)
    if problems or not (bed and control and reduction and governor and chains):
        raise TestbedError(problems, document.file)
    return Testbed(
        name=bed.name,
        title=bed.title or bed.name,
        file=document.file,
        digest=combined(digests),
        sample_time=bed.sample_time,
        components=components,
        connections=tuple(link.connection for link in chains.links),
        orientation=chains.orientation,
        roles=Roles(control.torque, control.speed),
        tuning=Tuning.model_construct(**{key: getattr(control, key) for key in Tuning.model_fields}),
        reduction=reduction,
        assumed=bed.assumed,
        computation_delay=bed.computation_delay,
        governor=governor,
    )


def _entry(tables: Mapping[str, Any], section: str, key: str) -> object:
    """Return a value of the file, None if it is not there."""
    table = tables.get(section)
    return table.get(key) if isinstance(table, dict) else None


def _texts(tables: Mapping[str, Any], section: str, key: str) -> tuple[str, ...] | None:
    """Return a list of texts of the file, None if it is none."""
    entries = _entry(tables, section, key)
    if isinstance(entries, list) and all(isinstance(entry, str) for entry in entries):
        return tuple(entries)
    return None


def _sections(tables: Mapping[str, Any]) -> list[Problem]:
    """Check that the file has the sections that it needs, and no others."""
    known = (*_SECTIONS, *_OPTIONAL)
    problems = [
        Problem(dotted(key), "is an unknown section", nearest(key, known)) for key in tables if key not in known
    ]
    return problems + [Problem(key, "is missing", text) for key, text in _SECTIONS.items() if key not in tables]


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
        Problem(dotted("testbed", "assumed", index), f"{shown(key)} is no key of this file", nearest(key, known))
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


def _roles(tables: Mapping[str, Any], bed: roles.Bed) -> list[Problem]:
    """Check the roles, and the tables whose keys are machines or components."""
    problems: list[Problem] = []
    if not isinstance(tables.get("control"), dict):  # reported already, but a bed without machines is not
        no_machine = not bed.unreadable and not any(kind.is_machine for kind in bed.types.values())
        return roles.check({}, (), bed) if no_machine else []
    torque = _entry(tables, "control", "torque") or {}
    speed = _texts(tables, "control", "speed")
    if speed is None and _entry(tables, "control", "speed") is None:
        speed = ()
    if isinstance(torque, dict) and all(isinstance(place, str) for place in torque.values()) and speed is not None:
        problems += roles.check(torque, speed, bed)
    machines = [name for name, kind in bed.types.items() if kind.is_machine]
    for key, wanted, what in (
        ("inertia_estimate", machines, "machine of the bed"),
        ("speed_control", list(speed or ()), "machine that controls its speed"),
        ("losses", [name for name in bed.types if name not in machines], "component that has losses"),
    ):
        problems += feedback.check_machines(key, _entry(tables, "control", key), wanted, what, bed.unreadable)
    problems += feedback.check_pairs(_entry(tables, "control", "speed_pairs"), speed or (), list(bed.types))
    return problems


def _reduced(tables: Mapping[str, Any], described: Mapping[str, object]) -> list[Problem]:
    """Check that the components which the reduction names exist and are named for one thing only."""
    problems: list[Problem] = []
    kept = _texts(tables, "reduction", "keep") or ()
    for key in ("rigid", "keep", "drop"):
        for index, name in enumerate(_texts(tables, "reduction", key) or ()):
            where = dotted("reduction", key, index)
            if name not in described:
                problems.append(Problem(where, f"{shown(name)} is no component", nearest(name, described)))
            elif key != "keep" and name in kept:
                what = f'"{name}" stands in reduction.keep too'
                problems.append(Problem(where, what, "remove it from one of the two lists"))
    return problems

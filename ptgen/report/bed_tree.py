"""A bed as a tree of its chains and components, and as plain data."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from rich.text import Text
from rich.tree import Tree

from ptgen.components.component import Component, Quantity, Record
from ptgen.components.part import Part, PartDescription
from ptgen.report.quantities import readable
from ptgen.testbed.testbed import Testbed

__all__ = ["bed_tree", "bed_values", "chains", "component_lines"]


def chains(bed: Testbed) -> tuple[tuple[str, ...], ...]:
    """Return the chains of a bed: the flanges that each of them passes, in order.

    A chain goes on through components with two flanges, and ends at all others.

    Examples
    --------
    >>> from ptgen.testbed import load
    >>> chains(load("testbeds/back-to-back.toml"))[0][:3]
    ('M1.shaft', 'flange1.machine', 'flange1.uut')
    """
    result: list[list[str]] = []
    for connection in bed.connections:
        left = connection.left.partition(".")[0]
        previous = result[-1][-1].partition(".")[0] if result else ""
        if previous == left and len(bed.components[left].flange_names()) == 2 and result[-1][-1] != connection.left:
            result[-1] += [connection.left, connection.right]
        else:
            result.append([connection.left, connection.right])
    return tuple(tuple(chain) for chain in result)


def bed_tree(bed: Testbed) -> Tree:
    """Return a bed as a tree; ``*`` marks values that are assumed."""
    tree = Tree(Text.assemble((bed.title, "bold"), f"  ({bed.name}, {bed.file})"))
    tree.add(Text(f"controller samples every {readable(bed.sample_time, 's')}"))
    branch = tree.add(Text("chains", style="bold cyan"))
    for chain in chains(bed):
        branch.add(Text(" - ".join(_stops(bed, chain))))
    branch = tree.add(Text("components", style="bold cyan"))
    for name, component in bed.components.items():
        assumed = " *" if f"components.{name}" in bed.assumed else ""
        leaf = branch.add(Text.assemble((name, "bold"), f"{assumed}  {component.summary}"))
        for line in component_lines(bed, name):
            leaf.add(Text(line))
        if isinstance(component, Part):
            _add_part(leaf, component.description)
    branch = tree.add(Text("control", style="bold cyan"))
    for machine, place in bed.roles.torque.items():
        branch.add(Text(f"{machine} controls the torque at {place}"))
    for machine in bed.roles.speed:
        branch.add(Text(f"{machine} controls its own speed"))
    tuning = branch.add(Text("tuning"))
    for line in _values(bed.assumed, bed.tuning, "control"):
        tuning.add(Text(line))
    reduction = branch.add(Text("reduction"))
    for line in _values(bed.assumed, bed.reduction, "reduction"):
        reduction.add(Text(line))
    if bed.assumed:
        branch = tree.add(Text("assumed rather than measured (*)", style="bold cyan"))
        for key in bed.assumed:
            branch.add(Text(key.removeprefix("components.")))
    return tree


def _add_part(leaf: Tree, part: PartDescription) -> None:
    """Add what a part consists of."""
    leaf.label = Text.assemble(leaf.label if isinstance(leaf.label, Text) else str(leaf.label), f": {part.title}")
    for member, record in part.members.items():
        assumed = " *" if f"members.{member}" in part.assumed else ""
        twig = leaf.add(Text.assemble((member, "bold"), f"{assumed}  member"))
        for line in _values(part.assumed, record, f"members.{member}"):
            twig.add(Text(line))
    for name, component in part.components.items():
        assumed = " *" if f"components.{name}" in part.assumed else ""
        twig = leaf.add(Text.assemble((name, "bold"), f"{assumed}  {component.summary}"))
        for line in _values(part.assumed, component, f"components.{name}"):
            twig.add(Text(line))
        if isinstance(component, Part):
            _add_part(twig, component.description)
    if part.gears:
        twig = leaf.add(Text("gears and the elements that are engaged"))
        for gear, elements in part.gears.items():
            twig.add(Text(f"{gear}: {' '.join(elements)}"))


def _part_values(part: PartDescription) -> dict[str, Any]:
    """Return what a part consists of as plain data, in SI units."""
    return {
        "title": part.title,
        "file": part.file,
        "flanges": dict(part.exposed),
        "members": {name: member.model_dump(mode="json") for name, member in part.members.items()},
        "components": {name: _component_values(component) for name, component in part.components.items()},
        "connections": [list(pair) for pair in part.connections],
        "gears": {gear: list(elements) for gear, elements in part.gears.items()},
        "assumed": list(part.assumed),
    }


def _component_values(component: Component) -> dict[str, Any]:
    values = component.model_dump(mode="json")
    return values | {"part": _part_values(component.description)} if isinstance(component, Part) else values


def component_lines(bed: Testbed, name: str) -> list[str]:
    """Return the values of a component, one line each, in the units that people read."""
    return _values(bed.assumed, bed.components[name], f"components.{name}")


def bed_values(bed: Testbed) -> dict[str, Any]:
    """Return a bed as plain data, in SI units."""
    return {
        "name": bed.name,
        "title": bed.title,
        "file": bed.file,
        "sample_time": bed.sample_time,
        "chains": [list(chain) for chain in chains(bed)],
        "components": {name: _component_values(component) for name, component in bed.components.items()},
        "torque": dict(bed.roles.torque),
        "speed": list(bed.roles.speed),
        "tuning": bed.tuning.model_dump(mode="json"),
        "reduction": bed.reduction.model_dump(mode="json"),
        "assumed": list(bed.assumed),
    }


def _stops(bed: Testbed, chain: tuple[str, ...]) -> list[str]:
    """Return a chain as the file has it: flanges named only where a component has more than two."""
    stops: list[str] = []
    for flange in chain:
        name = flange.partition(".")[0]
        stop = flange if len(bed.components[name].flange_names()) > 2 else name
        if not stops or stops[-1] != stop:
            stops.append(stop)
    return stops


def _values(assumed: Collection[str], record: Record, path: str) -> list[str]:
    units = _units(record)
    lines = []
    for field in type(record).model_fields:
        value = getattr(record, field)
        if field == "type" or value is None or value == () or value == {}:
            continue
        mark = " *" if f"{path}.{field}" in assumed else ""
        if isinstance(value, Record):
            lines.append(f"{field}:{mark} {', '.join(_values(assumed, value, f'{path}.{field}'))}")
        elif isinstance(value, float):
            # A bandwidth is held as a rate, but nobody thinks of it as a speed.
            shown = f"{value:.5g} rad/s" if "bandwidth" in field else readable(value, units.get(field, ""))
            lines.append(f"{field} {shown}{mark}")
        elif isinstance(value, dict):
            lines.append(f"{field} {_entries(value, units.get(field, ''))}{mark}")
        elif isinstance(value, tuple) and all(isinstance(entry, float) for entry in value):
            lines.append(f"{field} {', '.join(readable(entry, units.get(field, '')) for entry in value)}{mark}")
        else:
            words = value if isinstance(value, tuple) else (value,)
            shown = ", ".join("yes" if word is True else "no" if word is False else str(word) for word in words)
            lines.append(f"{field} {shown}{mark}")
    return lines


def _entries(table: Mapping[str, object], unit: str) -> str:
    """Return the entries of a table in a line, tables in it as ``key: entries``."""
    parts = []
    for key, entry in table.items():
        if isinstance(entry, Mapping):
            parts.append(f"{key}: {_entries(entry, unit)}")
        elif isinstance(entry, float):
            parts.append(f"{key} {readable(entry, unit)}")
        else:
            words = entry if isinstance(entry, list | tuple) else (entry,)
            parts.append(f"{key} {' '.join(map(str, words))}")
    return ", ".join(parts)


def _units(record: Record) -> dict[str, str]:
    """Return the SI unit of each field that holds a quantity."""
    units: dict[str, str] = {}
    for name, info in type(record).model_fields.items():
        choices = getattr(info.annotation, "__args__", ())
        metadata = [*info.metadata, *(meta for choice in choices for meta in getattr(choice, "__metadata__", ()))]
        for meta in metadata:
            if isinstance(meta, Quantity):
                units[name] = meta.unit
    return units

"""The tables ``[components.NAME]`` of a bed or a part file, from what is written to checked components."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.components.part import Part
from ptgen.errors import Problem, nearest
from ptgen.testbed.map_files import read_component
from ptgen.testbed.names import check_component_names, check_mangled
from ptgen.testbed.problems import dotted, shown, validated

__all__ = ["ComponentTables", "PartKind", "read_components"]

_TYPES: dict[str, type[Component]] = {**CATALOGUE, Part.type_name: Part}

_EXAMPLE = 'add a table such as [components.M1] with type = "machine"'

PartKind = Callable[[Mapping[str, Any], tuple[object, ...]], tuple[type[Part] | None, list[Problem]]]
"""What a table of a part and its path in the file become: the type of the part, None if there are problems."""


@dataclass(frozen=True)
class ComponentTables:
    """What the tables say.

    Attributes
    ----------
    types : dict of str to type of Component
        The type of each component that has a known one.
    components : dict of str to Component
        Those of them that have no problem.
    problems : list of Problem
        All problems of the tables.
    """

    types: dict[str, type[Component]] = field(default_factory=dict)
    components: dict[str, Component] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)


def read_components(described: object, part_kind: PartKind, folder: Path) -> ComponentTables:
    """Read the tables of all components.

    Parameters
    ----------
    described : object
        What stands under ``components``.
    part_kind : callable
        Reads the file of a part.
    folder : Path
        Where files with the columns of a table are looked for.
    """
    if not isinstance(described, dict):
        return ComponentTables(problems=[Problem("components", f"must hold tables, got {shown(described)}", _EXAMPLE)])
    result = ComponentTables(problems=check_component_names(described, "components"))
    for name, table in described.items():
        _read(result, name, table, part_kind, folder)
    result.problems.extend(check_mangled(result.components))
    return result


def _read(result: ComponentTables, name: str, table: object, part_kind: PartKind, folder: Path) -> None:
    where = dotted("components", name)
    if not isinstance(table, dict):
        remedy = f'write [{where}] with type = "machine" (or another type) and its values'
        result.problems.append(Problem(where, f"must be a table, got {shown(table)}", remedy))
        return
    if "type" not in table:
        what = "is missing: what the component is"
        result.problems.append(Problem(f"{where}.type", what, f"add type = ...; {nearest('', _TYPES)}"))
        return
    kind = _TYPES.get(table["type"]) if isinstance(table["type"], str) else None
    if kind is None:
        word = table["type"] if isinstance(table["type"], str) else ""
        what = f"is no type of component: {shown(table['type'])}"
        result.problems.append(Problem(f"{where}.type", what, nearest(word, _TYPES)))
        meant = difflib.get_close_matches(word, _TYPES, n=1)
        if not meant:
            return
        kind = _TYPES[meant[0]]  # so that the slip does not hide what else is wrong
        table = {**table, "type": meant[0]}
    if kind is Part:
        plain, problems = validated(Part, table, "components", name)
        kind = None
        if plain is not None:
            kind, problems = part_kind(table, ("components", name))
        if kind is None:
            result.problems.extend(problems)
            return
    result.types[name] = kind
    component, problems = read_component(kind, table, folder, "components", name)
    result.problems.extend(problems)
    if component is not None:
        result.components[name] = component

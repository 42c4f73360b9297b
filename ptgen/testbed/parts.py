"""From a part file to the type of the parts that it describes; all problems of the file are reported at once."""

from __future__ import annotations

import copy
import hashlib
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import ptgen
from ptgen.components.component import Component, Record, Text
from ptgen.components.part import Member, Part, PartDescription
from ptgen.errors import Problem, TestbedError, nearest
from ptgen.testbed.chains import follow, split
from ptgen.testbed.component_tables import PartKind, read_components
from ptgen.testbed.gear_problems import gear_problems
from ptgen.testbed.names import check_component_names
from ptgen.testbed.part_flanges import flange_problems
from ptgen.testbed.problems import dotted, shown, validated
from ptgen.testbed.text import read_toml

__all__ = ["PartSection", "combined", "find_part", "is_part", "part_kinds", "read_part", "shipped_parts"]

_SECTIONS = {
    "part": 'add [part] with title = "Gear set" and flanges = { input = "input", output = "output" }',
    "components": 'add a table such as [components.P1] with type = "planetary_set"',
}
_OPTIONAL = ("members", "gears")
_OUTSIDE = ("machine", "torque_flange")
"""Types that a bed has itself: what drives it, and what its controller measures."""


class PartSection(Record):
    """Section ``[part]``."""

    title: Text = ""
    """What the part is called in reports; by default the name of the file."""
    flanges: dict[str, str]
    """The flanges that a bed sees, and the member or the flange of a component that each one is."""
    connections: tuple[str, ...] = ()
    """Chains such as "shaft1 - pair1.input"; positive power flows left to right."""
    assumed: tuple[str, ...] = ()
    """Keys of this file whose values are assumed rather than measured, such as "components.P1"."""


def combined(digests: Sequence[str]) -> str:
    """Return the digest of a file and of those that it names; that of the file alone if it names none."""
    return hashlib.sha256("".join(digests).encode()).hexdigest() if digests[1:] else digests[0]


def shipped_parts() -> dict[str, Path]:
    """Return the part files that come with ptgen, by their names."""
    package = Path(ptgen.__file__).parent
    folders = (package / "_parts", package.parent / "parts")
    return {path.name: path for folder in folders if folder.is_dir() for path in sorted(folder.glob("*.toml"))}


def is_part(path: str | PathLike[str]) -> bool:
    """Tell whether a TOML file describes a part rather than a bed.

    Raises
    ------
    TestbedError
        If it cannot be read, or is no TOML.
    """
    tables = read_toml(path, "test bed file").tables
    return "part" in tables and "testbed" not in tables


def find_part(file: str, folder: Path) -> Path | None:
    """Return the part file that is called `file` in a file of `folder`; None if there is none."""
    path = folder / file
    return path if path.is_file() else shipped_parts().get(file)


def read_part(
    path: str | PathLike[str],
    values: Mapping[str, object] | None = None,
    trail: tuple[Path, ...] = (),
    *,
    shift_table: bool = True,
) -> type[Part]:
    """Read and check a part file.

    Parameters
    ----------
    path : path-like
        A TOML file.
    values : mapping, optional
        Values that replace those of the file, by their keys without ``components.`` and ``members.``.
    trail : tuple of Path
        The part files that this one is read for, to find one that contains itself.
    shift_table : bool
        Whether to check that the gears of the shift table exist, and that each shift element is needed for one.

    Raises
    ------
    TestbedError
        With every problem of the file.
    """
    reading = _Reading(path, values or {}, trail)
    part = reading.part()
    problems = gear_problems(part) if shift_table else []
    if problems:
        raise TestbedError(problems, reading.file)
    return part


class _Reading:
    def __init__(self, path: str | PathLike[str], values: Mapping[str, object], trail: tuple[Path, ...]) -> None:
        self.path = Path(path)
        self.trail = (*trail, self.path.resolve())
        document = read_toml(path, "part file")
        self.file = document.file
        self.digests = [document.digest]
        self.problems: list[Problem] = []
        self.tables = self._with_values(document.tables, values)

    def part(self) -> type[Part]:
        tables = self.tables
        known = (*_SECTIONS, *_OPTIONAL)
        self.problems += [
            Problem(dotted(key), "is an unknown section", nearest(key, known)) for key in tables if key not in known
        ]
        self.problems += [Problem(key, "is missing", text) for key, text in _SECTIONS.items() if key not in tables]
        section = self._validated(PartSection, tables.get("part", {}), "part") if "part" in tables else None
        types, components = self._components(tables.get("components", {}))
        members = self._members(tables.get("members", {}), types)
        gears = self._gears(tables.get("gears", {}), components)
        if section is None or self.problems:
            raise TestbedError(self.problems, self.file)
        self.problems += [
            Problem(dotted("part", "assumed", index), f"{shown(key)} is no key of this file", "correct the key")
            for index, key in enumerate(section.assumed)
            if not _has(tables, key)
        ]
        connections = self._connections(section, types)
        exposed = self._exposed(section, types, members)
        if self.problems:
            raise TestbedError(self.problems, self.file)
        self.problems += flange_problems(types, members, connections, exposed)
        if self.problems:
            raise TestbedError(self.problems, self.file)
        return Part.of(
            PartDescription(
                title=section.title or self.path.stem,
                file=self.file,
                digest=combined(self.digests),
                components=components,
                members=members,
                connections=tuple(connections),
                exposed=exposed,
                gears=gears,
                assumed=section.assumed,
            )
        )

    def _validated(self, model: type[Any], table: object, *where: object) -> Any:
        record, problems = validated(model, table, *where)
        self.problems += problems
        return record

    def _with_values(self, tables: dict[str, Any], values: Mapping[str, object]) -> dict[str, Any]:
        """Return the tables with other values; each key must exist or be one that its component knows."""
        if not values:
            return tables
        tables = copy.deepcopy(tables)
        for key, value in values.items():
            owner, *path = key.split(".")
            section = next((s for s in ("components", "members") if owner in tables.get(s, {})), None)
            if section is not None and not path:
                what = f"{shown(key)} is a table of the part {self.file}"
                keys = [inner for inner in tables[section][owner] if inner != "type"]
                example = f'"{owner}.{keys[-1]}"' if keys else f'"{owner}.inertia"'
                raise TestbedError(Problem(dotted("values", key), what, f"write a key of it, such as {example}"))
            if section is None:
                names = [*tables.get("components", {}), *tables.get("members", {})]
                what = f"{shown(key)} names nothing of the part {self.file}"
                raise TestbedError(Problem(dotted("values", key), what, nearest(owner, names)))
            table = tables[section][owner]
            for step in path[:-1]:
                table = table.setdefault(step, {})
            table[path[-1]] = value
        return tables

    def _components(self, described: object) -> tuple[dict[str, type[Component]], dict[str, Component]]:
        folder = self.path.parent
        tables = read_components(described, part_kinds(folder, self.digests, self.trail), folder)
        types, components = tables.types, tables.components
        self.problems += tables.problems
        for name, kind in types.items():
            if kind.type_name in _OUTSIDE:
                what = f"a {kind.type_name} cannot stand inside a part"
                self.problems.append(Problem(dotted("components", name), what, "put it into the bed, beside the part"))
        return types, components

    def _members(self, described: object, types: Mapping[str, type[Component]]) -> dict[str, Member]:
        if not isinstance(described, dict):
            remedy = 'write [members.input] with joins = ["P1.sun", "clutch1.input"]'
            self.problems.append(Problem("members", f"must hold tables, got {shown(described)}", remedy))
            return {}
        self.problems += [
            Problem(dotted("members", name), f'"{name}" is a component too', "rename one of them")
            for name in described
            if name in types
        ]
        self.problems += check_component_names(described, "members")
        members: dict[str, Member] = {}
        for name, table in described.items():
            member = self._validated(Member, table, "members", name)
            if member is None:
                continue
            joins = [self._flange(text, types, "members", name, "joins", i) for i, text in enumerate(member.joins)]
            if all(joined is not None for joined in joins):
                members[name] = member.model_copy(update={"joins": tuple(joins)})
        return members

    def _flange(self, text: str, types: Mapping[str, type[Component]], *where: object) -> str | None:
        """Return the flange that a text names in full; None, and a problem, if it names none."""
        name, dot, flange = text.partition(".")
        kind = types.get(name)
        if kind is None:
            if not isinstance(self.tables["components"].get(name), dict):
                what = f"{shown(text)} names no component of the part"
                self.problems.append(Problem(dotted(*where), what, nearest(name, types)))
            return None
        names = kind.flange_names()
        if dot and flange in names:
            return text
        if not dot and (len(names) == 1 or all(own.may_stay_open for own in kind.flanges)):
            return f"{name}.{names[0]}"
        options = " or ".join(f'"{name}.{own}"' for own in names)
        what = f"{shown(text)} names no flange: {name} is a {kind.type_name}"
        self.problems.append(Problem(dotted(*where), what, f"write {options}"))
        return None

    def _connections(self, section: PartSection, types: Mapping[str, type[Component]]) -> list[tuple[str, str]]:
        stops, problems = split(section.connections, types, path=("part", "connections"))
        self.problems += problems
        links = follow(stops, types).links if not problems else ()
        return [(link.connection.left, link.connection.right) for link in links]

    def _exposed(
        self, section: PartSection, types: Mapping[str, type[Component]], members: Mapping[str, Member]
    ) -> dict[str, str]:
        exposed: dict[str, str] = {}
        self.problems += check_component_names(section.flanges, "part", "flanges")
        if not section.flanges:
            self.problems.append(Problem("part.flanges", "is empty", 'expose a member, such as input = "input"'))
        for name, inside in section.flanges.items():
            if inside in members:
                exposed[name] = inside
            elif "." in inside or inside in types:
                found = self._flange(inside, types, "part", "flanges", name)
                if found is not None:
                    exposed[name] = found
            else:
                what = f"{shown(inside)} is no member and no flange of the part"
                self.problems.append(Problem(dotted("part", "flanges", name), what, nearest(inside, members)))
            if name != inside and (name in types or name in members):
                what = f'"{name}" is the name of a {"member" if name in members else "component"} too'
                self.problems.append(Problem(dotted("part", "flanges", name), what, "rename one of them"))
        return exposed

    def _gears(self, described: object, components: Mapping[str, Component]) -> dict[str, tuple[str, ...]]:
        if not isinstance(described, dict):
            remedy = 'write [gears] with lines such as 1 = ["B", "C", "E"]'
            self.problems.append(Problem("gears", f"must be a table, got {shown(described)}", remedy))
            return {}
        elements = [f.name for name, component in components.items() for f in component.elements(name).frictions]
        actuated = [
            f.name for name, component in components.items() for f in component.elements(name).frictions if f.actuated
        ]
        gears: dict[str, tuple[str, ...]] = {}
        for gear, engaged in described.items():
            where = dotted("gears", gear)
            if not isinstance(engaged, list) or not all(isinstance(name, str) for name in engaged):
                what = f"must be a list of shift elements, got {shown(engaged)}"
                self.problems.append(Problem(where, what, 'write e.g. ["B", "C", "E"]'))
                continue
            for index, name in enumerate(engaged):
                if name not in actuated and not self.problems:
                    kind = "is not actuated" if name in elements else "is no shift element of the part"
                    what = f"{shown(name)} {kind}"
                    self.problems.append(Problem(dotted("gears", gear, index), what, nearest(name, actuated)))
                if name in engaged[:index]:
                    self.problems.append(Problem(dotted("gears", gear, index), f'"{name}" twice', "remove one of them"))
            gears[gear] = tuple(engaged)
        return gears


def part_kinds(folder: Path, digests: list[str], trail: tuple[Path, ...] = ()) -> PartKind:
    """Return how tables of parts become their types; the digests of the files that are read are appended.

    Parameters
    ----------
    folder : Path
        Where the files of parts are looked for first.
    digests : list of str
        Gets the digest of each file.
    trail : tuple of Path
        The part files that are being read.
    """

    def kind(table: Mapping[str, Any], where: tuple[object, ...]) -> tuple[type[Part] | None, list[Problem]]:
        file = table["file"]
        path = find_part(file, folder)
        if path is None:
            what = f"there is no part file {shown(file)} in {folder} and none of that name comes with ptgen"
            return None, [Problem(dotted(*where, "file"), what, nearest(Path(file).name, shipped_parts()))]
        if path.resolve() in trail:
            what = f"the part {path} would contain itself"
            return None, [Problem(dotted(*where, "file"), what, "name another file")]
        try:
            part = read_part(path, table.get("values"), trail)
        except TestbedError as error:
            given = table.get("values") or {}
            own = {f"{section}.{key}": key for key in given for section in ("components", "members")}
            inside = []
            for problem in error.problems:
                if problem.where in own:
                    place = dotted(*where, "values", own[problem.where])
                    inside.append(Problem(place, problem.what, problem.remedy))
                elif problem.where.startswith("values."):
                    inside.append(Problem(f"{dotted(*where)}.{problem.where}", problem.what, problem.remedy))
                else:
                    what = f"{error.file}: {problem.where}: {problem.what}"
                    inside.append(Problem(dotted(*where), what, problem.remedy))
            return None, inside
        digests.append(part.description.digest)
        return part, []

    return kind


def _has(tables: Mapping[str, Any], key: str) -> bool:
    table: Any = tables
    for step in key.split("."):
        if not isinstance(table, dict) or step not in table:
            return False
        table = table[step]
    return True

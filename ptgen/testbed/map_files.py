"""Components whose tables of points stand in the columns of a file beside the bed file."""

from __future__ import annotations

import typing
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ptgen.components.component import Component, Record
from ptgen.components.map_table import MapTable
from ptgen.errors import Problem, nearest
from ptgen.testbed.problems import dotted, quantity_field, shown, validated
from ptgen.testbed.recording import RecordingError, read_columns

__all__ = ["read_component"]


def read_component(
    kind: type[Component], table: Mapping[str, Any], folder: Path, *where: object
) -> tuple[Component | None, list[Problem]]:
    """Read the table of a component.

    Parameters
    ----------
    kind : type of Component
    table : mapping
        What stands in the file.
    folder : Path
        Where the files that it names are looked for.
    *where : object
        Where it stands.

    Returns
    -------
    component : Component or None
        None if there are problems.
    problems : list of Problem
        All problems of the table and of the files that it names.
    """
    problems: list[Problem] = []
    inline, broken = dict(table), []
    for field, record in _map_tables(kind):
        entry = table.get(field)
        if isinstance(entry, dict) and "file" in entry:
            inline[field], found = _with_columns(record, entry, folder, (*where, field))
            problems += found
            if found:
                broken.append(dotted(*where, field))
    component, found = validated(kind, inline, *where)
    # What cannot be read is not judged: its values are missing, but not because nobody wrote them down.
    rest = [problem for problem in found if not any(problem.where.startswith(place) for place in broken)]
    return (None if problems else component), problems + rest


def _map_tables(kind: type[Record]) -> list[tuple[str, type[MapTable]]]:
    """Return the fields of a component that hold a table of points, and the types of these."""
    return [
        (field, part)
        for field, info in kind.model_fields.items()
        for part in (info.annotation, *typing.get_args(info.annotation))
        if isinstance(part, type) and issubclass(part, MapTable)
    ]


def _with_columns(
    record: type[MapTable], entry: Mapping[str, Any], folder: Path, where: tuple[object, ...]
) -> tuple[dict[str, Any], list[Problem]]:
    """Return the table with the lists that stand in the columns of its file."""
    inline: dict[str, Any] = {}
    known = ("file", "unit", *record.model_fields)
    columns = {key: entry[key] for key in record.model_fields if key in entry}
    file, unit = entry["file"], entry.get("unit")
    problems = [
        Problem(dotted(*where, key), "is an unknown key", nearest(key, known)) for key in entry if key not in known
    ]
    if not isinstance(file, str) or not file.strip():
        problems.append(Problem(dotted(*where, "file"), f"must name a file, got {shown(file)}", 'write "map.csv"'))
    for key, column in columns.items():
        if not isinstance(column, str):
            what = f"must be the name of a column, got {shown(column)}"
            problems.append(Problem(dotted(*where, key), what, "put it into quotation marks"))
        elif isinstance(file, str) and file.strip():
            values, found = _column(folder / file, column, where, key)
            problems += [problem for problem in found if problem not in problems]
            si = _unit(record, key)
            inline[key] = [f"{value!r} {unit}" for value in values] if si else values
    if unit is None and any(_unit(record, key) for key in columns):
        what = "is missing: the unit of the torques in the file"
        problems.append(Problem(dotted(*where, "unit"), what, 'add unit = "N m"'))
    return inline, problems


def _column(path: Path, column: str, where: tuple[object, ...], key: str) -> tuple[list[float], list[Problem]]:
    try:
        return read_columns(path, column, column, beside="the bed or part file").value, []
    except RecordingError as error:
        place = "file" if error.key == "file" else key
        return [], [Problem(dotted(*where, place), error.what, error.remedy)]


def _unit(record: type[MapTable], key: str) -> str:
    """Return the SI unit of the entries of a list; empty for plain numbers."""
    quantity = quantity_field(record, (key, 0))
    return quantity.unit if quantity is not None else ""

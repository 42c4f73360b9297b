"""Profiles: the course of a reference or an actuation, from points in the scenario or from a measurement file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from pydantic import field_validator

from ptgen import units
from ptgen.components.component import Record
from ptgen.errors import Problem
from ptgen.testbed.problems import dotted, example, shown, validated
from ptgen.testbed.recording import RecordingError, read_columns

__all__ = ["Bounds", "Points", "Profile", "Recording", "read_profile"]


@dataclass(frozen=True)
class Profile:
    """The course of a reference or an actuation; before the first point and after the last it is constant.

    Attributes
    ----------
    time : tuple of float
        Strictly increasing, from 0 or later (s).
    value : tuple of float
        As many (N m, rad/s, or a share).
    shape : {"lines", "steps"}
        Straight lines between the points, or each value holds until the next time.
    """

    time: tuple[float, ...]
    value: tuple[float, ...]
    shape: Literal["lines", "steps"]


@dataclass(frozen=True)
class Bounds:
    """The least and the largest value that a profile may have, and what to do about others."""

    least: float
    most: float
    remedy: str


class Points(Record):
    """A profile that stands in the scenario file."""

    time: list[object]
    value: list[object]
    shape: Literal["lines", "steps"] = "lines"


class Recording(Record):
    """A profile that stands in a measurement file."""

    file: str
    time: str | None = None
    column: str
    unit: str | None = None
    time_unit: str = "s"
    shape: Literal["lines", "steps"] = "lines"

    @field_validator("file")
    @classmethod
    def _named(cls, value: str) -> str:
        if not value.strip():
            raise ValueError("must not be empty; name a .csv, .parquet or .mf4 file")
        return value


def read_profile(
    entry: object, unit: str, folder: Path, *where: object, bounds: Bounds | None = None
) -> tuple[Profile | None, list[Problem]]:
    """Read one profile.

    Parameters
    ----------
    entry : object
        What stands in the scenario: a table with ``time`` and ``value``, or with ``file``.
    unit : str
        SI unit of the values; empty for plain numbers.
    folder : Path
        Where measurement files are looked for.
    *where : object
        Where the entry stands.
    bounds : Bounds, optional
        What the values are held against.

    Returns
    -------
    profile : Profile or None
        None if there are problems.
    problems : list of Problem
        All problems of the entry.
    """
    if isinstance(entry, dict) and "file" in entry:
        recording, problems = validated(Recording, entry, *where)
        return _recorded(recording, unit, folder, where, bounds) if recording else (None, problems)
    points, problems = validated(Points, entry, *where)
    if points is None:
        return None, problems
    time, problems = _quantities(points.time, "s", (*where, "time"))
    value, found = _quantities(points.value, unit, (*where, "value"))
    problems += found
    if not found:
        problems += [Problem(dotted(*where, "value", index), *problem) for index, problem in _beyond(value, bounds)]
    if not points.time:
        problems.append(Problem(dotted(*where, "time"), "is empty", 'write e.g. time = ["0 s"]'))
    if len(points.time) != len(points.value):
        what = f"must have as many entries as time ({len(points.time)}), got {len(points.value)}"
        problems.append(Problem(dotted(*where, "value"), what, "give one value for each time"))
    if problems:
        return None, problems
    for index, problem in _disorder(time):
        problems.append(Problem(dotted(*where, "time", index), *problem))
    return (None if problems else Profile(tuple(time), tuple(value), points.shape)), problems


def _quantities(entries: list[object], unit: str, where: tuple[object, ...]) -> tuple[list[float], list[Problem]]:
    values: list[float] = []
    problems: list[Problem] = []
    for index, entry in enumerate(entries):
        try:
            values.append(units.parse(entry, unit))
        except units.QuantityError as error:
            remedy = f"write {'it with its unit' if unit else 'a plain number'}, e.g. {example(unit)}"
            problems.append(Problem(dotted(*where, index), str(error), remedy))
    return values, problems


def _disorder(time: list[float]) -> list[tuple[int, tuple[str, str]]]:
    """Return the first place where the times do not begin at 0 or later, or do not increase."""
    if time and time[0] < 0:
        return [(0, (f"must not be before 0 s, got {time[0]:g} s", "shift the times"))]
    for index in range(1, len(time)):
        if time[index] <= time[index - 1]:
            what = f"must be after {time[index - 1]:g} s, got {time[index]:g} s"
            remedy = 'put the times in order; for a jump use shape = "steps", or times 1 ms apart'
            return [(index, (what, remedy))]
    return []


def _beyond(values: Sequence[float], bounds: Bounds | None) -> list[tuple[int, tuple[str, str]]]:
    """Return the values that lie outside of the bounds."""
    if bounds is None:
        return []
    wanted = f"must be from {bounds.least:g} to {bounds.most:g}"
    return [
        (index, (f"{wanted}, got {value:.12g}", bounds.remedy))
        for index, value in enumerate(values)
        if not bounds.least <= value <= bounds.most
    ]


def _recorded(
    recording: Recording, unit: str, folder: Path, where: tuple[object, ...], bounds: Bounds | None
) -> tuple[Profile | None, list[Problem]]:
    problems: list[Problem] = []
    scales: dict[str, float] = {}
    if recording.unit is None and unit:
        what = f"is missing: the unit of the values, such as {units.wanted_units(unit)}"
        problems.append(Problem(dotted(*where, "unit"), what, f'add unit = "{unit}"'))
    for key, text, wanted in (("unit", recording.unit or "", unit), ("time_unit", recording.time_unit, "s")):
        if key == "unit" and recording.unit is None:
            scales[key] = 1.0
            continue
        try:
            scales[key] = units.parse(f"1 {text}", wanted)
        except units.QuantityError:
            wish = f"a unit such as {units.wanted_units(wanted)}" if wanted else '"%", or absent for plain numbers'
            remedy = f'write e.g. {key} = "{wanted}"' if wanted else f"leave {key} out"
            problems.append(Problem(dotted(*where, key), f"must be {wish}, got {shown(text)}", remedy))
    if problems:
        return None, problems
    try:
        columns = read_columns(folder / recording.file, recording.time, recording.column)
    except RecordingError as error:
        return None, [Problem(dotted(*where, error.key), error.what, error.remedy)]
    time = [scales["time_unit"] * instant for instant in columns.time]
    for index, (what, remedy) in _disorder(time):
        place = f"{recording.file}, line {columns.lines[index]}"
        return None, [Problem(dotted(*where, "file"), f"{place}: time {what}", remedy)]
    values = [scales["unit"] * value for value in columns.value]
    for index, (what, remedy) in _beyond(values, bounds):
        place = f"{recording.file}, line {columns.lines[index]}, column {shown(recording.column)}"
        return None, [Problem(dotted(*where, "file"), f"{place}: {what}", remedy)]
    return Profile(tuple(time), tuple(values), recording.shape), []

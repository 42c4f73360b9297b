"""The sections of bed and part files, and the JSON Schemas that editors check them with."""

from __future__ import annotations

import functools
import operator
from typing import Annotated, Any, Literal

from pydantic import Field

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Quantity, Record, Text
from ptgen.components.part import Member, Part
from ptgen.testbed.governor_settings import GovernorSettings
from ptgen.testbed.names import PATTERN
from ptgen.testbed.parts import PartSection
from ptgen.testbed.problems import quantity_field
from ptgen.testbed.profile import Points, Recording
from ptgen.testbed.scenario import ScenarioSection
from ptgen.testbed.shifts import ShiftSection
from ptgen.testbed.testbed import ReductionSettings, Tuning

__all__ = ["BedFile", "BedSection", "ControlSection", "PartFile", "ScenarioFile", "json_schema"]


class BedSection(Record):
    """What the bed is called and how it is connected."""

    name: Annotated[str, Field(json_schema_extra={"pattern": PATTERN})]
    """A C identifier; the prefix of all emitted code."""
    title: Text = ""
    """What the bed is called in reports; by default its name."""
    sample_time: Annotated[float, Quantity("s", "sampling time of the controller")]
    computation_delay: Annotated[
        float,
        Quantity(
            "s", "time from sampling until the command that follows from it reaches the inverters", positive=False
        ),
    ] = 0.0
    connections: tuple[str, ...]
    """Chains such as "M1 - flange1 - diff.input"; positive power flows left to right."""
    assumed: tuple[str, ...] = ()
    """Keys of this file whose values are assumed rather than measured, such as "components.shaft1"."""


class ControlSection(Tuning):
    """Which machine controls what, and how well."""

    torque: dict[str, str] = Field(default_factory=dict)
    """Machine = the place of its torque: a flange, "diff.outputs" (their sum), or a torque flange."""
    speed: tuple[str, ...] = ()
    """Machines that control their own speed."""


_AnyComponent: Any = functools.reduce(operator.or_, (*CATALOGUE.values(), Part))


class BedFile(Record):
    """A power train test bed: its components, their connections and what the machines control."""

    testbed: BedSection
    components: dict[str, Annotated[_AnyComponent, Field(discriminator="type")]]
    """A table for each component, such as [components.M1]; the name is a C identifier."""
    control: ControlSection
    reduction: ReductionSettings = ReductionSettings()
    governor: GovernorSettings = GovernorSettings()


class PartFile(Record):
    """A part: a gear set or another assembly of components, for use in test beds."""

    part: PartSection
    members: dict[str, Member] = Field(default_factory=dict)
    """A table for each rigid shaft inside the part, such as [members.input]."""
    components: dict[str, Annotated[_AnyComponent, Field(discriminator="type")]]
    """A table for each component, such as [components.P1]; the name is a C identifier."""
    gears: dict[str, tuple[str, ...]] = Field(default_factory=dict)
    """The shift table: the elements that are engaged in each gear."""


_Course = Points | Recording


class ScenarioFile(Record):
    """A scenario: what references, clutches, brakes and gears of a bed do over time."""

    scenario: ScenarioSection
    references: dict[str, dict[str, _Course]] = Field(default_factory=dict)
    """Kind of reference, such as torque or speed, and machine = its course."""
    actuations: dict[str, _Course | dict[str, _Course]] = Field(default_factory=dict)
    """Friction element = how far it is pressed, 0 to 1."""
    ratios: dict[str, _Course | dict[str, _Course]] = Field(default_factory=dict)
    """Gearbox = its ratio."""
    gears: dict[str, str] = Field(default_factory=dict)
    """Component = its gear at the start."""
    shifts: tuple[ShiftSection, ...] = ()
    """Shifts, each a table [[shifts]]."""


_FILES: dict[str, type[Record]] = {"bed": BedFile, "part": PartFile, "scenario": ScenarioFile}


def json_schema(kind: Literal["bed", "part", "scenario"] = "bed") -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of test bed files, of part files, or of scenario files.

    Examples
    --------
    >>> sorted(json_schema()["properties"])
    ['components', 'control', 'governor', 'reduction', 'testbed']
    >>> sorted(json_schema("part")["properties"])
    ['components', 'gears', 'members', 'part']
    >>> sorted(json_schema("scenario")["properties"])
    ['actuations', 'gears', 'ratios', 'references', 'scenario', 'shifts']
    """
    schema: dict[str, Any] = _FILES[kind].model_json_schema()
    for section in ("components", "members"):
        if section in schema["properties"]:
            tables = schema["properties"][section]
            tables["patternProperties"] = {PATTERN: tables.pop("additionalProperties")}
            tables["additionalProperties"] = False
    if "components" in schema["properties"]:
        schema["properties"]["components"]["minProperties"] = 1
    for section in ("reduction", "governor"):
        schema["properties"].get(section, {}).pop("default", None)
    _simplify(schema)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _simplify(schema: dict[str, Any]) -> None:
    """Write defaults of quantities with their unit, and leave out what a TOML file cannot hold."""
    pending: list[type[Record]] = [*CATALOGUE.values(), Part, BedSection, ControlSection, ReductionSettings]
    pending += [GovernorSettings, PartSection, Member, ScenarioSection, ShiftSection, Points, Recording]
    seen: set[type[Record]] = set()
    while pending:
        record = pending.pop()
        if record in seen:
            continue
        seen.add(record)
        pending += _subrecords(record)
        if record.__name__ not in schema["$defs"]:
            continue
        for name, entry in schema["$defs"][record.__name__]["properties"].items():
            entry.pop("title", None)
            for option in entry.pop("anyOf", ()):  # a value or null, which TOML does not know
                if option != {"type": "null"}:
                    entry.update(option)
            field = quantity_field(record, (name,))
            default = entry.get("default")
            if default is None:
                entry.pop("default", None)
            elif field is not None and field.unit:
                entry["default"] = f"{default:g} {field.unit}"


def _subrecords(record: type[Record]) -> list[type[Record]]:
    found: list[type[Record]] = []
    for info in record.model_fields.values():
        for part in (info.annotation, *getattr(info.annotation, "__args__", ())):
            if isinstance(part, type) and issubclass(part, Record):
                found.append(part)
    return found

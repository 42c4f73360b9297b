"""The JSON Schema accepts what `load` accepts, and describes every component."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from small_bed import BED

from ptgen import units
from ptgen.components.catalogue import CATALOGUE
from ptgen.testbed import json_schema

BEDS = sorted((Path(__file__).parents[2] / "testbeds").glob("*.toml"))
SCHEMA = json_schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def test_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["$schema"].endswith("2020-12/schema")


@pytest.mark.parametrize("path", BEDS, ids=lambda path: path.stem)
def test_shipped_beds_are_valid(path: Path) -> None:
    VALIDATOR.validate(tomllib.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"50 kN m/rad"', "50"),
        ('"50 kN m/rad"', '"50"'),
        ("stiffness", "stifness"),
        ('"shaft"', '"shft"'),
        ('type = "shaft"\n', ""),
        ("[control]", "[contrl]"),
        ("[control]", "[control]\nspeed_bandwith = 3"),
        ('name = "small"', 'name = "a bed"'),
        ("components.shaft1", 'components."a shaft"'),
        ('speed = ["M2"]', 'speed = "M2"'),
    ],
)
def test_mistakes_are_invalid(old: str, new: str) -> None:
    table = tomllib.loads(BED.replace(old, new))
    assert not VALIDATOR.is_valid(table)


def test_every_component_is_described() -> None:
    (entry,) = SCHEMA["properties"]["components"]["patternProperties"].values()
    references = {option["$ref"].rpartition("/")[2] for option in entry["oneOf"]}
    assert references == {*(kind.__name__ for kind in CATALOGUE.values()), "Part"}


def tables(schema: Any) -> list[dict[str, Any]]:
    found = [schema] if isinstance(schema, dict) else []
    for value in schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ():
        found += tables(value)
    return found


def test_no_unknown_keys_anywhere() -> None:
    assert all(table.get("additionalProperties") is not None for table in tables(SCHEMA) if "properties" in table)


def test_defaults_are_written_as_in_a_file() -> None:
    control = SCHEMA["$defs"]["ControlSection"]["properties"]
    assert control["speed_bandwidth"]["default"] == "30 rad/s"
    assert control["damping_ratio"]["default"] == 1.0
    assert control["conventional_torque_bandwidth"]["type"] == "string"
    for table in tables(SCHEMA):
        if "default" in table and "type" in table:
            jsonschema.validate(table["default"], table)
    assert units.parse(control["fault_ramp"]["default"], "s") == 0.05

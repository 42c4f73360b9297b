"""The reference of the file format names every type and every key, and its examples are read."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Record
from ptgen.components.converter_maps import CoastMap, DriveMap, ReverseMap
from ptgen.components.friction import FrictionRipple, FrictionSaturation, LoadDependentFriction
from ptgen.components.friction_partial import DiskLaw
from ptgen.components.part import Member, Part
from ptgen.testbed.feedback import LossMap
from ptgen.testbed.parts import PartSection
from ptgen.testbed.problems import validated
from ptgen.testbed.schema import ControlSection
from ptgen.testbed.testbed import ReductionSettings

TEXT = (Path(__file__).resolve().parents[2] / "docs" / "testbed-file.md").read_text(encoding="utf-8")
EXAMPLES = [
    "\n".join(line[4:] for line in block.splitlines())
    for block in re.findall(r"(?:^    .*\n|^\n)+", TEXT, flags=re.MULTILINE)
    if "[components." in block
]


def section(heading: str) -> str:
    return re.split(r"^#+ ", TEXT.split(f"{heading}\n", 1)[1], maxsplit=1, flags=re.MULTILINE)[0]


@pytest.mark.parametrize("name", [*CATALOGUE, "part"])
def test_every_key_of_every_type_is_explained(name: str) -> None:
    text = section(f'### type = "{name}"')
    kind = {**CATALOGUE, "part": Part}[name]
    assert not [key for key in kind.model_fields if key != "type" and f"`{key}`" not in text]
    assert f'type = "{name}"' in text, "and there is an example"


@pytest.mark.parametrize(
    ("heading", "record"),
    [
        ("### loss, limited_slip", LoadDependentFriction),
        ('### type = "torque_converter"', DriveMap),
        ('### type = "torque_converter"', ReverseMap),
        ('### type = "torque_converter"', CoastMap),
        ('### type = "torque_converter"', DiskLaw),
        ("### saturation, ripple", FrictionSaturation),
        ("### saturation, ripple", FrictionRipple),
        ("## [reduction]", ReductionSettings),
        ("## Part files", PartSection),
        ("## Part files", Member),
        ("## [control]", ControlSection),
        ("### [control.losses]", LossMap),
    ],
)
def test_every_key_of_the_tables_in_between_is_explained(heading: str, record: type[Record]) -> None:
    text = section(heading)
    assert not [key for key in record.model_fields if f"`{key}`" not in text]


def test_examples_are_read() -> None:
    read = set()
    for text in EXAMPLES:
        for name, table in tomllib.loads(text)["components"].items():
            if "type" in table:
                kind = {**CATALOGUE, "part": Part}[table["type"]]
                component, problems = validated(kind, table, "components", name)
                assert component is not None, problems
                read.add(table["type"])
    assert read == {*CATALOGUE, "part"}

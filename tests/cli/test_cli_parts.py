"""Commands on part files, and on beds that hold a part."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from testbed.part_rig import BED

PART = "parts/nine-speed.toml"

RIG = BED.replace("one.toml", "nine-speed.toml")


@pytest.fixture
def rig(tmp_path: Path) -> Path:
    path = tmp_path / "rig.toml"
    path.write_text(RIG)
    return path


def test_check_knows_part_files(cli):
    assert "a part of 10 components and 8 members" in cli("check", PART).stdout
    assert cli.json("check", PART)["flanges"] == ["input", "output"]


@pytest.mark.parametrize("command", ["show", "derive", "modal", "analyse"])
def test_commands_for_beds_say_what_a_part_is(cli, command):
    result = cli(command, PART, code=2)
    assert "is a part file, not a test bed" in result.stderr


def test_show_lists_what_a_part_consists_of(cli, rig):
    text = cli("show", rig).stdout
    for words in ("Nine-speed automatic transmission", "joins P1.sun, D.input, F.input", "teeth: sun 46, ring 98"):
        assert words in text
    part = cli.json("show", rig)["components"]["gears"]["part"]
    assert part["gears"]["1"] == ["B", "C", "E"]
    assert part["components"]["P1"]["teeth"] == {"sun": 46, "ring": 98}


def test_schema_of_part_files(cli):
    schema = json.loads(cli("schema", "--part").stdout)
    assert set(schema["properties"]) == {"part", "members", "components", "gears"}

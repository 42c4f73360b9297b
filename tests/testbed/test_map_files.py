"""Maps of a component in the columns of a file beside the bed file."""

from __future__ import annotations

import tomllib
from pathlib import Path

import jsonschema
import pytest

from ptgen.errors import TestbedError
from ptgen.testbed import json_schema, load

BED = """
[testbed]
name = "bed"
sample_time = "100 us"
connections = ["M1 - tc - M2"]

[components.M1]
type = "machine"
inertia = "1 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"

[components.M2]
type = "machine"
inertia = "1 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"

[components.tc]
type = "torque_converter"
inertia_pump = "0.1 kg m^2"
inertia_turbine = "0.05 kg m^2"
reference_speed = "2000 rpm"
drive = DRIVE

[control]
torque = { M1 = "tc.pump" }
speed = ["M2"]
"""

INLINE = '{ speed_ratio = [0, 0.5, 1], torque_ratio = [2, 1.5, 1], pump_torque = ["180 N m", "0.1501 kN m", "0 N m"] }'
FILE = '{ file = "maps/tc.csv", speed_ratio = "nu", torque_ratio = "mu", pump_torque = "Tpc", unit = "N m" }'
CSV = "nu;mu;Tpc;remark\n0;2;180;1\n0.5;1.5;150.1;2\n1;1;0;3\n"


def written(folder: Path, drive: str, csv: str | None = CSV) -> Path:
    path = folder / "bed.toml"
    path.write_text(BED.replace("DRIVE", drive), encoding="utf-8")
    if csv is not None:
        (folder / "maps").mkdir()
        (folder / "maps" / "tc.csv").write_text(csv, encoding="utf-8")
    return path


def problems(path: Path) -> dict[str, str]:
    with pytest.raises(TestbedError) as caught:
        load(path)
    return {problem.where.removeprefix("components.tc."): problem.what for problem in caught.value.problems}


@pytest.mark.parametrize("separator", [";", ",", "\t"])
def test_columns_of_a_file_are_the_lists(separator: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    inline = load(written(tmp_path / "a", INLINE))
    file = written(tmp_path / "b", FILE, CSV.replace(";", separator))
    monkeypatch.chdir(tmp_path)
    assert load(file).components == inline.components
    assert load("b/bed.toml").components == inline.components


def test_the_unit_of_the_torques_is_that_of_the_file(tmp_path: Path) -> None:
    path = written(tmp_path, FILE.replace('"N m"', '"kN m"'), CSV.replace("180", "0.18").replace("150.1", "0.15"))
    assert load(path).components["tc"].drive.pump_torque == pytest.approx((180, 150, 0))


@pytest.mark.parametrize("drive", [INLINE, FILE])
def test_schema_takes_both(drive: str) -> None:
    jsonschema.validate(tomllib.loads(BED.replace("DRIVE", drive)), json_schema())


@pytest.mark.parametrize(
    ("old", "new", "where", "words"),
    [
        ("maps/tc.csv", "nix.csv", "drive.file", "nix.csv does not exist"),
        ("maps/tc.csv", "", "drive.file", "must name a file"),
        ("maps/tc.csv", "tc.txt", "drive.file", "must be a .csv, .parquet or .mf4 file"),
        ('"mu"', '"my"', "drive.torque_ratio", 'has no column "my"'),
        ('"mu"', "[2, 1]", "drive.torque_ratio", "must be the name of a column"),
        (', unit = "N m"', "", "drive.unit", "is missing"),
        ('"N m"', '"rpm"', "drive.pump_torque[0]", "must be in N m"),
        ('torque_ratio = "mu", ', "", "drive.torque_ratio", "is missing"),
        ("file =", "fle =", "drive.fle", "is an unknown key"),
        ("unit =", "units =", "drive.units", "is an unknown key"),
    ],
)
def test_what_is_wrong_is_told_by_its_key(old: str, new: str, where: str, words: str, tmp_path: Path) -> None:
    found = problems(written(tmp_path, FILE.replace(old, new)))
    assert words in found.get(where, ""), found


def test_columns_are_judged_like_lists(tmp_path: Path) -> None:
    found = problems(written(tmp_path, FILE, CSV.replace("0.5;1.5", "0.5;2.5")))
    assert "drive.torque_ratio[1]" in found
    broken = problems(written_again(tmp_path, CSV.replace("150.1", "abc")))
    assert "line 3" in broken["drive.file"] and "Tpc" in broken["drive.file"]


def written_again(folder: Path, csv: str) -> Path:
    (folder / "maps" / "tc.csv").write_text(csv, encoding="utf-8")
    return folder / "bed.toml"


def test_all_problems_of_file_and_table_at_once(tmp_path: Path) -> None:
    text = FILE.replace('"mu"', '"my"').replace('"nu"', '"ny"')
    path = written(tmp_path, text)
    path.write_text(path.read_text().replace('"0.1 kg m^2"', '"-1 kg m^2"'))
    assert set(problems(path)) == {"inertia_pump", "drive.torque_ratio", "drive.speed_ratio"}

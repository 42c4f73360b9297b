"""gears on part files and beds: tables, one gear, all combinations, JSON, figures, and what users get wrong."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

NINE = "parts/nine-speed.toml"

BED = """
[testbed]
name = "rig"
sample_time = "100 us"
connections = ["M1 - shaft1 - first.input", "first.output - shaft2 - second.input", "second.output - shaft3 - M2"]
[components.first]
type = "part"
file = "nine-speed.toml"
[components.second]
type = "part"
file = "nine-speed.toml"
values = { "P3.teeth" = { sun = 40, ring = 80 } }
[components.shaft1]
type = "shaft"
stiffness = "20 kN m/rad"
[components.shaft2]
type = "shaft"
stiffness = "20 kN m/rad"
[components.shaft3]
type = "shaft"
stiffness = "20 kN m/rad"
[components.M1]
type = "machine"
inertia = "0.4 kg m^2"
torque_max = "900 N m"
speed_rated = "3200 rpm"
speed_max = "8000 rpm"
[components.M2]
type = "machine"
inertia = "0.4 kg m^2"
torque_max = "900 N m"
speed_rated = "3200 rpm"
speed_max = "8000 rpm"
[control]
speed = ["M1", "M2"]
"""


def test_table_of_the_nine_speed_set(cli):
    text = cli("gears", NINE).stdout
    rows = {line.split()[0]: line for line in text.splitlines() if re.match(r"\s+(R|N|\d)\s", line) and "X" in line}
    assert "-g1·g2·(1 + g3)/(1 + g2)" in text and "(1 + g3)·(1 + g1 + g2)/(1 + g2)" in text
    first = next(line for line in text.splitlines() if "5.503" in line and "1.651" in line)
    assert first.split()[:4] == ["1", "X", "X", "X"]
    assert {"R", *"123456789"} <= set(rows)
    assert "spread 9.150" in text
    assert "4: B idle; C and F make the gear" in text
    assert "B>D" in text


def test_one_gear(cli):
    text = cli("gears", NINE, "--gear", "5").stdout
    assert "ratio = g2·g4/(g2·g4 - 1) = 1.21059" in text
    assert "circulates through P1, P2, P4" in text
    assert "to 6: release B and apply E" in text


def test_every_combination(cli):
    text = cli("gears", NINE, "--all").stdout
    assert text.count("tie-up") >= 30 and "input and output cannot turn" in text
    assert "gear 4, D idle" in text


def test_json_has_everything(cli):
    found = cli.json("gears", NINE)
    assert len(found["combinations"]) == 64
    assert [gear["name"] for gear in found["gears"]] == ["R", *"123456789"]
    assert found["gears"][1]["formula"] == "(g3 + 1)*(g1 + g2 + 1)/(g2 + 1)"
    assert found["gears"][1]["ratio"] == pytest.approx(5.5032, abs=1e-4)
    assert found["gears"][1]["ideal"]["elements"].keys() == {"B", "C", "E"}
    assert found["gears"][1]["slips"].keys() == {"A", "D", "F"}
    assert found["spread"] == pytest.approx(9.15, abs=1e-3)
    single = next(change for change in found["changes"] if (change["from"], change["to"]) == ("1", "2"))
    assert single["single"] and (single["release"], single["apply"]) == (["B"], ["D"])
    assert cli.json("gears", NINE, "--gear", "R")["ratio"] == pytest.approx(-4.9316, abs=1e-4)


@pytest.mark.parametrize("arguments", [(), ("--gear", "7")])
def test_lever_diagram_is_the_same_file_every_time(cli, tmp_path: Path, arguments):
    first, second = tmp_path / "one.svg", tmp_path / "two.svg"
    for path in (first, second):
        cli("gears", NINE, *arguments, "--plot", path)
    assert first.read_bytes() == second.read_bytes() and len(first.read_bytes()) > 10_000


def test_part_of_a_bed_with_its_own_values(cli, tmp_path: Path):
    bed = tmp_path / "rig.toml"
    bed.write_text(BED)
    refused = cli("gears", bed, code=2).stderr
    assert "--component: the bed has several parts: first, second" in refused
    found = cli.json("gears", bed, "--component", "second")
    assert next(gear for gear in found["gears"] if gear["name"] == "2")["ratio"] == 3.0
    assert "did you mean" in cli("gears", bed, "--component", "secnd", code=2).stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((NINE, "--gear", "12"), "is no gear of Nine-speed"),
        ((NINE, "--component", "gears"), "this is a part file"),
        (("testbeds/differential.toml",), "neither describes a part nor has one"),
        (("parts/none.toml",), "does not exist"),
        ((NINE, "--plot", "levers.doc"), ".svg"),
    ],
)
def test_what_users_get_wrong(cli, arguments, words):
    assert words in cli("gears", *arguments, code=2).stderr


def test_wrong_shift_table_is_told_and_all_combinations_can_still_be_seen(cli, root: Path, tmp_path: Path):
    part = tmp_path / "wrong.toml"
    part.write_text((root / NINE).read_text().replace('2 = ["C", "D", "E"]', '2 = ["A", "D", "E"]'))
    text = cli("gears", part, code=2).stderr
    assert "gears.2: ties up: with A, D and E engaged the input cannot turn" in text
    assert "C, D and E give 3.333" in text
    assert "(C+D+E)" in cli("gears", part, "--all").stdout


def test_element_that_can_never_matter_is_a_problem_of_the_file(cli, root: Path, tmp_path: Path):
    part = tmp_path / "more.toml"
    text = (root / NINE).read_text()
    text = text.replace('"P4.carrier", "F.output"]', '"P4.carrier", "F.output", "X.input"]')
    text += '\n[members.loose]\njoins = ["X.output"]\ninertia = "0.001 kg m^2"\n'
    text += '[components.X]\ntype = "clutch"\ncapacity = "100 N m"\n'
    part.write_text(text)
    told = cli("gears", part, code=2).stderr
    assert "components.X: can never matter: no gear of Nine-speed automatic transmission needs X" in told
    assert "remove it" in told


PASTED = """
[testbed]
name = "rig"
sample_time = "100 us"
connections = ["M1 - gears - shaft - M2"]
[components.shaft]
type = "shaft"
stiffness = "20 kN m/rad"
{machines}
[control]
speed = ["M1", "M2"]
"""


def test_tables_of_simplified_gearboxes_can_be_pasted(cli, tmp_path):
    machines = "[components.M1]" + BED.split("[components.M1]")[1].split("[control]")[0]
    text = cli("gears", NINE, "--simplify", "1,2").stdout
    assert "1: B slips with -1.53618 (w_in - 5.50322 w_out)" in text
    assert "left out: the coupling" in text
    first, *tables = text.split("[components.gears]")
    for table in tables:
        bed = tmp_path / "bed.toml"
        bed.write_text(f"{PASTED.format(machines=machines)}[components.gears]{table}")
        cli("show", str(bed))
    box = cli.json("gears", NINE, "--simplify", "1,2")
    assert box["components"]["double_clutch_gearbox"]["ratio1"] == pytest.approx(5.503, abs=5e-4)
    assert box["exact"] is True
    assert first.startswith("# Nine-speed")


def test_pairs_without_two_positive_inertias_and_wrong_pairs_are_said(cli):
    text = cli("gears", NINE, "--simplify", "7,6").stdout
    assert "cannot be exact in both gears" in text
    assert "of the models +11 %" in text
    assert "R, 2, 3, 4, 7" in cli("gears", NINE, "--simplify", "1,6", code=2).stderr
    assert "--gear and --simplify" in cli("gears", NINE, "--simplify", "1,2", "--gear", "1", code=2).stderr

"""Keys and values of a test bed file: each mistake is found, placed, and answered with a way out."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from small_bed import BED, Bench

Change = Callable[..., str]


def test_small_bed(bench: Bench) -> None:
    bed = bench.load(BED)
    assert bed.title == "small" and bed.machines == ("M1", "M2")
    assert bed.tuning.damping_reserve == 0.1 and bed.tuning.conventional_torque_bandwidth is None
    assert bed.reduction.stiffness_share == 0.02


@pytest.mark.parametrize(
    ("old", "new", "where", "what", "remedy"),
    [
        # unknown keys and sections
        ("[control]", "[contrl]\n[control]", "contrl", "unknown section", 'did you mean "control"?'),
        ("title", "titel", "testbed.titel", "unknown key", 'did you mean "title"?'),
        ("stiffness", "stifness", "components.flange1.stifness", "unknown key", '"stiffness"'),
        ("[control]", "[control]\nspeed_bandwith = 1", "control.speed_bandwith", "unknown", '"speed_bandwidth"'),
        ("[control]", "[reduction]\nrigd = []\n[control]", "reduction.rigd", "unknown key", '"rigid"'),
        (
            'speed_max = "6000 rpm"',
            'speed_max = "6000 rpm"\ninverter = { model = "ideal", deadtime = "1 s" }',
            "components.M1.inverter.deadtime",
            "unknown key",
            'did you mean "dead_time"?',
        ),
        # types
        ('"torque_flange"', '"torque_flang"', "components.flange1.type", "no type", '"torque_flange"'),
        ('type = "shaft"\n', "", "components.shaft1.type", "is missing", "add type = ...; known are: b"),
        ('type = "shaft"', "type = 3", "components.shaft1.type", "no type of component: 3", "known are: "),
        (
            'speed_max = "6000 rpm"',
            'speed_max = "6000 rpm"\ninverter = { model = "idael" }',
            "components.M1.inverter.model",
            'must be "ideal" or "lag", got "idael"',
            'did you mean "ideal"?',
        ),
        # quantities
        ('"50 kN m/rad"', '"380 N m"', "components.shaft1.stiffness", "has another dimension", '"380 kN m/rad"'),
        ('"50 kN m/rad"', "380", "components.shaft1.stiffness", "must be a string with its unit", '"380 kN m/rad"'),
        ('"50 kN m/rad"', '"50"', "components.shaft1.stiffness", "another dimension", '"380 kN m/rad"'),
        ('"50 kN m/rad"', '"-3 kN m/rad"', "components.shaft1.stiffness", "must be > 0 N m/rad, got -3000", "rigid"),
        ('"50 kN m/rad"', '"0 kN m/rad"', "components.shaft1.stiffness", "must be > 0", "check the sign"),
        ('"50 kN m/rad"', "[1]", "components.shaft1.stiffness", "must be a quantity", "write it with its unit"),
        ('"50 kN m/rad"', '"nan kN m/rad"', "components.shaft1.stiffness", "finite", "a float can hold"),
        ('"50 kN m/rad"', '"1e999 N m/rad"', "components.shaft1.stiffness", "finite", "a float can hold"),
        ('"50 kN m/rad"', '"9 m**9**9**9**9"', "components.shaft1.stiffness", "not understood", "its unit"),
        ('"1 kg m^2"', '"0 kg m^2"', "components.M1.inertia", "must be > 0 kg m^2, got 0", "check the sign"),
        ('"1 kg m^2"', "inf", "components.M1.inertia", "must be a string with its unit", '"1.2 kg m^2"'),
        ('"1 kg m^2"', "true", "components.M1.inertia", "must be a quantity", '"1.2 kg m^2"'),
        ('speed_max = "6000 rpm"', 'speed_max = "600 rpm"', "components.M1", "must not be below", "exchange them"),
        # the section [testbed]
        ('"100 us"', '"0 s"', "testbed.sample_time", "must be > 0 s", "check the sign and the unit"),
        ('"100 us"', '"-1 ms"', "testbed.sample_time", "must be > 0 s", "check the sign and the unit"),
        ('"100 us"', '"10 kHz"', "testbed.sample_time", "another dimension", '"100 us"'),
        ('sample_time = "100 us"\n', "", "testbed.sample_time", "is missing", 'add sample_time = "100 us"'),
        ('name = "small"', 'name = "my bed"', "testbed.name", "is no name", "write e.g. my_bed"),
        ('name = "small"', 'name = "double"', "testbed.name", "word of the language C", "double1"),
        ('name = "small"', 'name = ""', "testbed.name", "is no name", "write e.g. M1"),
        ('name = "small"', "name = 3", "testbed.name", "must be a text, got 3", "quotation marks"),
        ('["M1 - flange1 - shaft1 - M2"]', '"M1 - M2"', "testbed.connections", "must be a list", "brackets"),
        ('["M1 - flange1 - shaft1 - M2"]', "[]", "testbed.connections", "is empty", '"M1 - flange1 - M2"'),
        ('["M1 - flange1 - shaft1 - M2"]', "[3]", "testbed.connections[0]", "must be a text", "quotation"),
        (
            '"100 us"',
            '"100 us"\nassumed = ["components.flange2"]',
            "testbed.assumed[0]",
            '"components.flange2" is no key',
            'did you mean "components.flange1"?',
        ),
        # [control] and [reduction]
        ("[control]", "[control]\ndamping_reserve = 1", "control.damping_reserve", "must be below 1", "share"),
        ("[control]", "[control]\ndamping_ratio = -1", "control.damping_ratio", "must be > 0, got -1", "sign"),
        ("[control]", '[control]\ndamping_ratio = "x"', "control.damping_ratio", "a plain number", "0.5"),
        (
            "[control]",
            '[control]\ninertia_estimate = { M9 = "1 kg m^2" }',
            "control.inertia_estimate.M9",
            "no machine",
            "known are: M1, M2",
        ),
        (
            "[control]",
            '[control]\ninertia_estimate = { M1 = "1 kg" }',
            "control.inertia_estimate.M1",
            "another dimension",
            '"1.2 kg m^2"',
        ),
        ("[control]", '[reduction]\nrigid = ["shft1"]\n[control]', "reduction.rigid[0]", "no component", '"shaft1"'),
        (
            "[control]",
            '[reduction]\nkeep = ["shaft1"]\nrigid = ["shaft1"]\n[control]',
            "reduction.rigid[0]",
            "stands in reduction.keep too",
            "remove it",
        ),
    ],
)
def test_one_mistake(bench: Bench, change: Change, old: str, new: str, where: str, what: str, remedy: str) -> None:
    text = change(old, new) if old != "title" else change('name = "small"', 'name = "small"\ntitel = "x"')
    if where.endswith(".stifness"):
        found = bench.problems(text)
        assert set(found) == {where, "components.flange1.stiffness"}
        assert found["components.flange1.stiffness"].what.startswith("is missing")
        problem = found[where]
    else:
        problem = bench.problem(text, where)
    assert what in problem.what
    assert remedy in problem.remedy


def test_missing_value_says_what_it_is(bench: Bench, change: Change) -> None:
    problem = bench.problem(change('stiffness = "50 kN m/rad"\n', ""), "components.shaft1.stiffness")
    assert problem.what == "is missing: torsional stiffness c_s"
    assert problem.remedy == 'add stiffness = "380 kN m/rad"'


def test_incomplete_inverter(bench: Bench, change: Change) -> None:
    line = 'speed_max = "6000 rpm"'
    problem = bench.problem(change(line, line + '\ninverter = { model = "lag" }'), "components.M1.inverter")
    assert 'needs a time_constant such as "250 us"' in problem.what and problem.remedy == "add it"


def test_component_that_is_no_table(bench: Bench, change: Change) -> None:
    problem = bench.problem(change("[components.M1]", "[components]\nx = 3\n[components.M1]"), "components.x")
    assert problem.what == "must be a table, got 3" and "[components.x]" in problem.remedy


@pytest.mark.parametrize("section", ["testbed", "components", "control", "reduction"])
def test_section_that_is_no_table(bench: Bench, section: str) -> None:
    found = bench.problems(f"{section} = 3\n")
    assert "got 3" in found[section].what and "[" in found[section].remedy


def test_all_problems_at_once(bench: Bench, change: Change) -> None:
    text = change('"100 us"', '"100 N"').replace('"50 kN m/rad"', '"50"').replace('"2 kg m^2"', '"-2 kg m^2"')
    text = text.replace('speed = ["M2"]', 'speed = ["M3"]').replace("flange1 - shaft1", "flange2 - shaft1")
    assert set(bench.problems(text)) == {
        "testbed.sample_time",
        "components.shaft1.stiffness",
        "components.M2.inertia",
        "testbed.connections[0]",
        "control.speed[0]",
        "control",
    }


@pytest.mark.parametrize(
    ("name", "what", "remedy"),
    [
        ('"left shaft"', "is no name", "write e.g. left_shaft"),
        ('"1st"', "is no name", "write e.g. c1st"),
        ('"é"', "is no name", "write e.g. M1"),
        ("s" * 41, "at most 39 letters", "write e.g. " + "s" * 40),
        ("int", "word of the language C", "write e.g. int1"),
    ],
)
def test_component_names(bench: Bench, change: Change, name: str, what: str, remedy: str) -> None:
    found = bench.problems(change("[components.shaft1]", f"[components.{name}]"))
    problem = next(problem for where, problem in found.items() if where.startswith("components."))
    assert what in problem.what and problem.remedy == remedy


def test_names_that_differ_by_case(bench: Bench) -> None:
    problem = bench.problem(BED.replace("M2", "m1"), "components.m1")
    assert problem.what == 'differs from "M1" only in upper and lower case'
    assert problem.remedy == "rename one of them"


@pytest.mark.parametrize("name", ["M1_speed", "M1_inertia", "M1_torque_ref", "M1_shaft"])
def test_names_that_collide_in_c(bench: Bench, name: str) -> None:
    problem = bench.problem(BED.replace("shaft1", name), f"components.{name}")
    assert problem.what == f'"{name}" and "M1" would both have a "{name}" in C'
    assert problem.remedy == "rename one of them"

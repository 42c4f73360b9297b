"""Part files: what is read, what its elements are called, and what is refused with which words."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from testbed.part_rig import BED

from ptgen.errors import TestbedError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.testbed import load, load_scenario
from ptgen.testbed.parts import read_part, shipped_parts

ROOT = Path(__file__).resolve().parents[2]

ONE_SET = """
[part]
title = "One set"
flanges = { input = "input", output = "output" }

[members.input]
joins = ["P1.sun", "K.input"]
inertia = "0.01 kg m^2"
stiffness = "500 kN m/rad"

[members.ring]
joins = ["P1.ring", "B"]
inertia = "0.01 kg m^2"

[members.output]
joins = ["P1.carrier", "K.output"]
inertia = "0.02 kg m^2"

[components.P1]
type = "planetary_set"
teeth = { sun = 40, ring = 100 }
inertia_sun = "0.001 kg m^2"

[components.B]
type = "brake"
capacity = "500 N m"

[components.K]
type = "clutch"
capacity = "400 N m"

[gears]
1 = ["B"]
2 = ["K"]
"""


def bed(folder: Path, part: str = ONE_SET, text: str = BED) -> Path:
    (folder / "one.toml").write_text(part)
    (folder / "rig.toml").write_text(text)
    return folder / "rig.toml"


def problems(path: Path) -> str:
    with pytest.raises(TestbedError) as caught:
        load(path)
    return "\n".join(f"{p.where}: {p.what}; {p.remedy}" for p in caught.value.problems)


def test_names_are_prefixed(tmp_path: Path) -> None:
    testbed = load(bed(tmp_path))
    assert [friction.name for friction in testbed.frictions] == ["gears.B", "gears.K"]
    assert testbed.actuated == ("gears.B", "gears.K")
    mechanism = Mechanism.of(testbed)
    assert {"gears.input", "gears.output", "gears.ring", "gears.P1.sun", "gears.K.output"} <= set(mechanism.velocities)
    names = {parameter.symbol.name for parameter in mechanism.parameters}
    assert {"gears_P1_ratio", "gears_P1_inertia_sun", "gears_input_inertia", "gears_B_capacity"} <= names
    assert not any("stiffness" in name for name in names if name.startswith("gears")), "those of the flexible model"


def test_rigid_part_has_the_degrees_of_freedom_of_its_layout(tmp_path: Path) -> None:
    model = assemble(Mechanism.of(load(bed(tmp_path))))
    assert model.coordinates == ("gears.B.left", "gears.K", "M1.shaft", "M2.shaft")
    assert model.twists == ("shaft1", "shaft2")


def test_flexible_part_has_a_shaft_at_each_joint_with_an_inertia(tmp_path: Path) -> None:
    text = BED.replace('file = "one.toml"', 'file = "one.toml"\nmodel = "flexible"')
    mechanism = Mechanism.of(load(bed(tmp_path, text=text)))
    assert [spring.name for spring in mechanism.springs if spring.name.startswith("gears")] == ["gears.input.P1.sun"]
    assert len(assemble(mechanism).coordinates) == 5


def test_losses_of_a_flexible_part_go_by_the_torque_in_the_joint(tmp_path: Path) -> None:
    text = BED.replace('file = "one.toml"', 'file = "one.toml"\nmodel = "flexible"')
    lossy = ONE_SET.replace('inertia_sun = "0.001 kg m^2"', 'inertia_sun = "0.001 kg m^2"\nloss = { load = 0.02 }')
    model = assemble(Mechanism.of(load(bed(tmp_path, lossy, text))))
    form, joint = model.signals["gears.P1.sun"], model.twists.index("gears.input.P1.sun")
    stiffness = next(symbol for symbol in model.values if symbol.name == "gears_input_stiffness")
    assert form.e[joint] == stiffness


def test_values_of_the_bed_replace_those_of_the_part(tmp_path: Path) -> None:
    text = BED.replace(
        'file = "one.toml"', 'file = "one.toml"\nvalues = { "P1.teeth.ring" = 80, "ring.inertia" = "0.5 kg m^2" }'
    )
    values = {symbol.name: value for symbol, value in Mechanism.of(load(bed(tmp_path, text=text))).values.items()}
    assert values["gears_P1_ratio"] == 2.0
    assert values["gears_ring_inertia"] == 0.5
    assert values["gears_input_inertia"] == 0.01


def test_digest_of_the_bed_covers_its_parts(tmp_path: Path) -> None:
    before = load(bed(tmp_path)).digest
    assert load(bed(tmp_path, ONE_SET.replace("0.02", "0.03"))).digest != before


def test_parts_may_hold_parts(tmp_path: Path) -> None:
    outer = """
[part]
flanges = { input = "front.input", output = "rear.output" }
connections = ["front.output - rear.input"]
[components.front]
type = "part"
file = "one.toml"
[components.rear]
type = "part"
file = "one.toml"
values = { "P1.teeth.ring" = 90 }
[gears]
1 = ["front.B", "rear.B"]
"""
    (tmp_path / "outer.toml").write_text(outer)
    path = bed(tmp_path, text=BED.replace("one.toml", "outer.toml"))
    testbed = load(path)
    assert testbed.actuated == ("gears.front.B", "gears.front.K", "gears.rear.B", "gears.rear.K")
    names = {parameter.symbol.name for parameter in Mechanism.of(testbed).parameters}
    assert {"gears_front_P1_ratio", "gears_rear_P1_ratio"} <= names
    model = assemble(Mechanism.of(testbed))
    assert len(model.coordinates) == 5, "two for each set, less the connection, and two machines"
    course = '{ time = ["0 s"], value = [1] }'
    scenario = tmp_path / "run.toml"
    scenario.write_text(
        '[scenario]\nduration = "1 s"\nrecord_every = "1 ms"\n'
        f"[actuations]\ngears.front.B = {course}\n[actuations.gears.rear]\nK = {course}\n"
    )
    actuations = load_scenario(scenario, testbed).actuations
    assert [name for name, profile in actuations.items() if profile.value == (1.0,)] == [
        "gears.front.B",
        "gears.rear.K",
    ]


def test_a_part_that_contains_itself_is_refused(tmp_path: Path) -> None:
    text = ONE_SET + '\n[components.again]\ntype = "part"\nfile = "one.toml"\n'
    assert "would contain itself" in problems(bed(tmp_path, text))


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"P1.ring", "B"', '"P1.ring", "P1.carrier", "B"', 'connects "P1" to itself'),
        ('"P1.ring", "B"', '"P1.ring", "B", "K.input"', '"K.input" is connected twice'),
        ('"P1.ring", "B"', '"B"', 'flange "P1.ring" is not connected'),
        ('"P1.ring", "B"', '"P1.ring"', "is never connected"),
        ('"P1.ring", "B"', '"P1.rng", "B"', "names no flange: P1 is a planetary_set"),
        ('"P1.ring", "B"', '"P2.ring", "B"', '"P2.ring" names no component of the part'),
        ('"P1.ring", "B"', '"P1.ring", "K"', 'write "K.input" or "K.output"'),
        ('output = "output" }', 'output = "outpt" }', "is no member and no flange of the part"),
        ('1 = ["B"]', '1 = ["C"]', '"C" is no shift element of the part'),
        ('1 = ["B"]', '1 = "B"', "must be a list of shift elements"),
        ("[members.ring]", "[members.B]", '"B" is a component too'),
        ("[gears]", "[gear]", "is an unknown section"),
        ('inertia = "0.01 kg m^2"\nstiffness', 'inertia = "0.01 kg"\nstiffness', "members.input.inertia"),
        ('type = "brake"', 'type = "brke"', "is no type of component"),
        ('type = "brake"\ncapacity', 'type = "machine"\ncapacity', "cannot stand inside a part"),
    ],
)
def test_what_is_wrong_with_a_part_is_said(tmp_path: Path, old: str, new: str, words: str) -> None:
    assert old in ONE_SET
    found = problems(bed(tmp_path, ONE_SET.replace(old, new, 1)))
    assert words in found
    assert "one.toml" in found


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ('file = "two.toml"', 'there is no part file "two.toml"'),
        ('file = "one.toml"\nmodel = "stiff"', 'must be "rigid" or "flexible"'),
        (
            'file = "one.toml"\nvalues = { "P9.ratio" = 2 }',
            'components.gears.values."P9.ratio": "P9.ratio" names nothing',
        ),
        ('file = "one.toml"\nvalues = { "P1" = 2 }', 'write a key of it, such as "P1.inertia_sun"'),
        ('file = "one.toml"\nvalues = { "P1.inertia_sun" = "2 N m" }', 'components.gears.values."P1.inertia_sun": '),
        ("", "components.gears.file: is missing"),
    ],
)
def test_what_is_wrong_with_its_use_is_said(tmp_path: Path, entry: str, words: str) -> None:
    assert words in problems(bed(tmp_path, text=BED.replace('file = "one.toml"', entry)))


def test_a_part_that_cannot_be_read_has_no_other_problems(tmp_path: Path) -> None:
    text = BED.replace("one.toml", "two.toml").replace(
        'speed = ["M1", "M2"]', 'torque = { M1 = "gears.input" }\nspeed = ["M2"]'
    )
    found = problems(bed(tmp_path, text=text + '[reduction]\nas_ratio = ["gears"]\n'))
    assert len(found.splitlines()) == 1
    assert "components.gears.file" in found


def test_nine_speed_part_is_the_published_layout() -> None:
    """Teeth and table of the shipped file; that the ratios follow is shown by the gears themselves."""
    tables = tomllib.loads((ROOT / "parts" / "nine-speed.toml").read_text(encoding="utf-8"))
    assert [table["teeth"] for name, table in tables["components"].items() if name.startswith("P")] == [
        {"sun": 46, "ring": 98},
        {"sun": 44, "ring": 100},
        {"sun": 36, "ring": 84},
        {"sun": 34, "ring": 86},
    ]
    assert len(tables["gears"]) == 10


@pytest.mark.parametrize("name", sorted(shipped_parts()))
def test_every_shipped_part_is_read_in_both_models(name: str) -> None:
    part = read_part(shipped_parts()[name])
    for model in ("rigid", "flexible"):
        component = part.model_validate({"type": "part", "file": name, "model": model})
        elements = component.elements("gears")
        assert elements.frictions
        assert bool(elements.springs) == (model == "flexible")

"""Components that are ratios for control: what a bed file may say of them."""

from __future__ import annotations

import pytest
from small_bed import BED, Bench

from ptgen.errors import TestbedError
from ptgen.testbed import load_scenario

CLUTCHED = BED.replace("flange1 - shaft1 - M2", "flange1 - shaft1 - k1 - shaft2 - M2")
CLUTCHED += """
[components.k1]
type = "clutch"
capacity = "900 N m"
actuated = true
inertia_input = "0.02 kg m^2"
inertia_output = "0.09 kg m^2"

[components.shaft2]
type = "shaft"
stiffness = "60 kN m/rad"
"""
GEARS = '[reduction]\nas_ratio = ["k1"]\ngear_ratios = { k1 = { R = -3.0, 1 = 4.7, 2 = 3.1 } }\n'


def test_ratio_is_an_input_with_the_range_of_the_gears(bench: Bench) -> None:
    bed = bench.load(CLUTCHED + GEARS)
    table, ratio = bed.gear_tables["k1"], bed.ratios["k1"]
    assert (table.design, table.ratio, table.span) == ("1", 4.7, (-3.0, 4.7))
    assert (ratio.symbol.name, ratio.value, ratio.span) == ("k1_ratio", 4.7, (-3.0, 4.7))


def test_gear_of_the_design_is_by_choice(bench: Bench) -> None:
    bed = bench.load(CLUTCHED + GEARS + 'design_gear = { k1 = "R" }\n')
    assert bed.ratios["k1"].value == -3.0


def test_single_gear_is_a_constant_ratio(bench: Bench) -> None:
    bed = bench.load(CLUTCHED + '[reduction]\nas_ratio = ["k1"]\ngear_ratios = { k1 = { direct = 1.0 } }\n')
    assert bed.ratios == {} and bed.gear_tables["k1"].span is None


@pytest.mark.parametrize(
    ("text", "where", "what", "remedy"),
    [
        ('as_ratio = ["kk"]', "reduction.as_ratio[0]", "no component", "k1"),
        ('as_ratio = ["M1"]', "reduction.as_ratio[0]", "no flanges input and output", "k1"),
        ('as_ratio = ["shaft1"]', "reduction.as_ratio[0]", "no flanges input and output", "k1"),
        ('as_ratio = ["k1"]', "reduction.as_ratio[0]", "no ratio", "gear_ratios"),
        ('gear_ratios = { k1 = { 1 = 2.0 } }', "reduction.gear_ratios.k1", "not listed", 'as_ratio = ["k1"]'),
        ('as_ratio = ["k1"]\ngear_ratios = { k1 = {} }', "reduction.gear_ratios.k1", "no gears", "1 = 4.7"),
        (
            'as_ratio = ["k1"]\ngear_ratios = { k1 = { 1 = 0.0 } }',
            "reduction.gear_ratios.k1.1",
            "must not be 0",
            "",
        ),
        (
            'as_ratio = ["k1"]\ngear_ratios = { k1 = { 1 = 2.0 } }\ndesign_gear = { k1 = "7" }',
            "reduction.design_gear.k1",
            "no gear",
            "1",
        ),
        (
            'as_ratio = ["k1"]\ngear_ratios = { k1 = { 1 = 2.0 } }\nlocked = ["k1"]',
            "reduction.locked[0]",
            "is a ratio for control",
            "one of the two",
        ),
        (
            'as_ratio = ["k1", "k1"]\ngear_ratios = { k1 = { 1 = 2.0 } }',
            "reduction.as_ratio[1]",
            "twice",
            "remove",
        ),
    ],
)  # fmt: skip
def test_problems_name_the_place_and_the_remedy(text: str, where: str, what: str, remedy: str, bench: Bench) -> None:
    found = bench.problem(CLUTCHED + "[reduction]\n" + text + "\n", where)
    assert what in found.what
    assert remedy in found.remedy


def test_gearbox_is_a_ratio_already(bench: Bench) -> None:
    text = BED.replace("shaft1 - M2", "shaft1 - g - M2") + '[components.g]\ntype = "gearbox"\nratio = 2.0\n'
    text += 'inertia = "0.1 kg m^2"\n[reduction]\nas_ratio = ["g"]\n'
    assert "ratio already" in bench.problem(text, "reduction.as_ratio[0]").what


def test_scenarios_give_the_ratio(bench: Bench) -> None:
    bed, file = bench.load(CLUTCHED + GEARS), bench.file.with_name("case.toml")
    head = '[scenario]\nduration = "2 s"\nrecord_every = "1 ms"\n[ratios]\n'
    file.write_text(head, encoding="utf-8")
    assert load_scenario(file, bed).ratios["k1"].value == (4.7,)
    file.write_text(head + 'k1 = { time = ["0 s", "1 s"], value = [3.1, -3.0] }\n', encoding="utf-8")
    assert load_scenario(file, bed).ratios["k1"].value == (3.1, -3.0)
    file.write_text(head + 'k1 = { time = ["0 s"], value = [6] }\n', encoding="utf-8")
    with pytest.raises(TestbedError, match="k1"):
        load_scenario(file, bed)

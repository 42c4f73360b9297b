"""The wishes for the feedback: read, and with an error for every mistake."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest
from small_bed import BED, Bench

from ptgen.errors import TestbedError
from ptgen.testbed import json_schema, load, load_scenario

ROOT = Path(__file__).resolve().parents[2]
THREE = (ROOT / "testbeds" / "differential.toml").read_text(encoding="utf-8")


def with_control(*lines: str, text: str = BED) -> str:
    """Return a bed with more lines in ``[control]``; a sub-table goes to the end."""
    plain = [line for line in lines if not line.startswith("[")]
    tables = [line for line in lines if line.startswith("[")]
    return "\n".join([text.replace("[control]", "\n".join(["[control]", *plain]), 1), *tables]) + "\n"


GOOD = with_control(
    'speed_control = { M2 = "observer" }',
    'observer_bandwidth = "2 Hz"',
    "torque_gain = -0.5",
    'switch_time = "200 ms"',
    'speed_rate = "500 rpm/s"',
    'torque_rate = "20 kN m/s"',
    '[control.losses.shaft1]\nspeed = ["0 rpm", "60 rpm"]\ntorque = ["1 N m", "2 N m"]',
)


def test_everything_is_read_in_si_units(bench: Bench) -> None:
    tuning = bench.load(GOOD).tuning
    assert tuning.speed_control_of("M2") == "observer" and tuning.speed_control_of("M1") == "pi"
    assert tuning.observer_bandwidth == pytest.approx(4 * math.pi)
    assert (tuning.torque_gain, tuning.switch_time, tuning.torque_rate) == (-0.5, 0.2, 20e3)
    assert tuning.speed_rate == pytest.approx(500 * 2 * math.pi / 60)
    losses = tuning.losses["shaft1"]
    assert losses.is_odd and losses.speed == pytest.approx((0.0, 2 * math.pi)) and losses.torque == (1.0, 2.0)


def test_schema_accepts_what_is_read() -> None:
    validator = jsonschema.Draft202012Validator(json_schema())
    validator.validate(tomllib.loads(GOOD))
    validator.validate(tomllib.loads(with_control('speed_control = "super_twisting"')))
    assert not validator.is_valid(tomllib.loads(with_control('speed_control = "pid"')))


@pytest.mark.parametrize(
    ("lines", "where", "what", "remedy"),
    [
        (['speed_control = "observr"'], "speed_control", 'must be "pi" or "observer"', 'did you mean "observer"?'),
        (["speed_control = 3"], "speed_control", "got 3", "quotation marks"),
        (['speed_control = { M2 = "pid" }'], "speed_control", 'got "pid"', 'did you mean "pi"?'),
        (['speed_control = { M1 = "pi" }'], "speed_control.M1", "no machine that controls its speed", "known are: M2"),
        (["torque_gain = -1"], "torque_gain", "must be above -1", "(5.115a)"),
        (["feedforward = 3"], "feedforward", "must be 2 or less", "whole torque reference"),
        (["damping_ratio = 500"], "damping_ratio", "must be 10 or less", "critical damping"),
        (
            ['[control.losses.shaft1]\nspeed = ["60 rpm"]\ntorque = ["-1 N m"]'],
            "losses.shaft1",
            "a loss brakes",
            "the sign of their speed",
        ),
        (['torque_gain = "1 N m"'], "torque_gain", "another dimension", "plain number"),
        (['speed_rate = "500 rpm"'], "speed_rate", "another dimension", '"200 rpm/s"'),
        (['torque_rate = "20 N m"'], "torque_rate", "another dimension", '"2 kN m/s"'),
        (['switch_time = "0 s"'], "switch_time", "must be > 0 s", "check the sign"),
        (['speed_pairs = { rear = ["M2"] }'], "speed_pairs.rear", "two machines, got 1", '["M2", "M3"]'),
        (['[control.losses.shaft]\nspeed = ["1 rpm"]\ntorque = ["1 N m"]'], "losses.shaft", "no component", '"shaft1"'),
        (['[control.losses.M1]\nspeed = ["1 rpm"]\ntorque = ["1 N m"]'], "losses.M1", "no component", "known are"),
        (
            ['[control.losses.shaft1]\nspeed = ["2 rpm", "1 rpm"]\ntorque = ["1 N m", "1 N m"]'],
            "losses.shaft1.speed",
            "must increase strictly",
            "in order",
        ),
        (
            ['[control.losses.shaft1]\nspeed = ["1 rpm", "2 rpm"]\ntorque = ["1 N m"]'],
            "losses.shaft1",
            "as many entries as speed (2), got 1",
            "one for each",
        ),
        (["[control.losses.shaft1]\nspeed = []\ntorque = []"], "losses.shaft1.speed", "at least one speed", "measured"),
        (['[control.losses.shaft1]\nspeed = ["0 rpm"]\ntorque = ["1 N m"]'], "losses.shaft1.speed", "not zero", "add"),
        (
            ['[control.losses.shaft1]\nspeed = ["1 N m"]\ntorque = ["1 N m"]'],
            "losses.shaft1.speed[0]",
            "another dimension",
            "with its unit",
        ),
    ],
)
def test_mistakes(bench: Bench, lines: list[str], where: str, what: str, remedy: str) -> None:
    found = bench.problem(with_control(*lines), f"control.{where}")
    assert what in found.what and remedy in found.remedy, found


def test_mistakes_in_pairs_all_at_once(bench: Bench) -> None:
    pairs = 'rear = ["M2", "M33"], diff = ["M1", "M2"], "a pair" = ["M3", "M3"], more = ["M3", "M2", "M2"]'
    found = bench.problems(with_control(f"speed_pairs = {{ {pairs} }}", text=THREE))
    assert {place.removeprefix("control.speed_pairs."): problem.what for place, problem in found.items()} == {
        "rear[1]": '"M33" is no machine that controls its speed',
        "diff": "is the name of a component too",
        "diff[0]": '"M1" is no machine that controls its speed',
        "diff[1]": '"M2" stands in the pair "rear" already',
        '"a pair"': '"a pair" is no name: a name is a letter and then at most 39 letters, digits and underscores',
        '"a pair"[1]': '"M3" stands in the pair "a pair" already',
        "more": "must name two machines, got 3",
        "more[0]": '"M3" stands in the pair "a pair" already',
        "more[1]": '"M2" stands in the pair "rear" already',
        "more[2]": '"M2" stands in the pair "rear" already',
    }
    assert 'did you mean "M3"?' in found["control.speed_pairs.rear[1]"].remedy


@pytest.fixture
def read(tmp_path: Path) -> Callable[[str], object]:
    bed = tmp_path / "bed.toml"
    bed.write_text(with_control('speed_pairs = { rear = ["M2", "M3"] }', text=THREE), encoding="utf-8")
    testbed = load(bed)

    def reader(references: str) -> object:
        file = tmp_path / "case.toml"
        head = '[scenario]\nduration = "1 s"\nrecord_every = "1 ms"\n[references]\n'
        file.write_text(head + references + "\n", encoding="utf-8")
        return load_scenario(file, testbed)

    return reader


def test_references_of_a_pair(read: Callable[[str], object]) -> None:
    scenario = read('speed_mean.rear = { time = ["0 s"], value = ["60 rpm"] }')
    assert set(scenario.references) == {"torque.M1", "speed_mean.rear", "speed_difference.rear"}
    assert scenario.references["speed_mean.rear"].value[0] == pytest.approx(2 * math.pi)
    assert scenario.references["speed_difference.rear"].value == (0.0,)


@pytest.mark.parametrize(
    ("key", "what", "remedy"),
    [
        ("speed.M2", 'given by the pair "rear"', "speed_mean.rear and speed_difference.rear"),
        ("speed_mean.reer", "no pair of speeds", '"speed_mean.rear"'),
        ("speed_mean.M1", "no pair of speeds", '"speed_mean.rear"'),
        ("speed_men.rear", "unknown kind", '"speed_mean"'),
    ],
)
def test_mistakes_in_references_of_a_pair(read: Callable[[str], object], key: str, what: str, remedy: str) -> None:
    with pytest.raises(TestbedError) as caught:
        read(f'{key} = {{ time = ["0 s"], value = ["60 rpm"] }}')
    (found,) = caught.value.problems
    assert what in found.what and remedy in found.remedy, found

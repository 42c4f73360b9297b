"""The section [governor] of a bed file: defaults, values, and what stands in the way of a governor."""

from __future__ import annotations

import tomllib
from collections.abc import Callable

import jsonschema
import pytest
from small_bed import BED, Bench

from ptgen.testbed import json_schema

Change = Callable[..., str]


def governed(*lines: str) -> str:
    return BED + "\n[governor]\n" + "\n".join(lines) + "\n"


def test_no_section_no_governor(bench: Bench) -> None:
    governor = bench.load(BED).governor
    assert governor.kind == "none" and not governor.is_chosen
    assert governor.horizon is None and governor.iterations == 40


def test_values_in_si_units(bench: Bench) -> None:
    text = governed(
        'kind = "optimal"', 'horizon = "500 ms"', 'tie = "60 rpm"', 'torque_rate_min = "2 kN m/s"', "iterations = 9"
    )
    governor = bench.load(text).governor
    assert governor.is_chosen and governor.horizon == 0.5 and governor.iterations == 9
    assert governor.tie == pytest.approx(6.283185307179586) and governor.torque_rate_min == 2000.0


@pytest.mark.parametrize("kind", ["none", "sequential", "sequential_modified", "optimal"])
def test_schema_knows_every_kind(bench: Bench, kind: str) -> None:
    text = governed(f'kind = "{kind}"', 'tie = "1 rpm"', "reserve = 0.1")
    assert bench.load(text).governor.kind == kind
    jsonschema.Draft202012Validator(json_schema()).validate(tomllib.loads(text))


def test_schema_refuses_what_reading_refuses() -> None:
    validator = jsonschema.Draft202012Validator(json_schema())
    assert not validator.is_valid(tomllib.loads(governed('kind = "best"')))
    assert not validator.is_valid(tomllib.loads(governed("iterations = 0.5")))


@pytest.mark.parametrize(
    ("line", "key", "what", "remedy"),
    [
        ('kind = "optmal"', "kind", 'got "optmal"', 'did you mean "optimal"?'),
        ("reserve = 0.5", "reserve", "must be below 0.5", "stays unused"),
        ("reserve = -0.1", "reserve", "must be >= 0", "sign"),
        ("stationary_reserve = 1", "stationary_reserve", "must be below 0.5", "stays unused"),
        ("removal = 0.7", "removal", "must be below 0.5", "stays unused"),
        ('horizon = "-1 s"', "horizon", "must be >= 0 s", "sign"),
        ('horizon = "3 N m"', "horizon", "another dimension", "100 us"),
        ("torque_weight = 0", "torque_weight", "must be > 0", "sign"),
        ("speed_weight = -1", "speed_weight", "must be > 0", "sign"),
        ('tie = "-1 rpm"', "tie", "must be >= 0", "sign"),
        ('torque_rate_min = "-1 N m/s"', "torque_rate_min", "must be >= 0", "sign"),
        ('torque_reserve = "5 rpm"', "torque_reserve", "another dimension", "400 N m"),
        ("iterations = 0", "iterations", "must be from 1 to 1000, got 0", "takes time"),
        ("iterations = 1.5", "iterations", "must be a whole number, got 1.5", "decimal point"),
        ("iteration = 3", "iteration", "unknown key", '"iterations"'),
    ],
)
def test_mistakes(bench: Bench, line: str, key: str, what: str, remedy: str) -> None:
    problem = bench.problem(governed(line), f"governor.{key}")
    assert what in problem.what
    assert remedy in problem.remedy


def test_section_must_be_a_table(bench: Bench) -> None:
    text = 'governor = "optimal"\n' + BED
    assert "must be a table" in bench.problem(text, "governor").what


@pytest.mark.parametrize("control", ['"super_twisting"', '{ M2 = "super_twisting" }'])
def test_super_twisting_has_no_governor(bench: Bench, control: str) -> None:
    text = governed('kind = "sequential"').replace("[control]", f"[control]\nspeed_control = {control}")
    problem = bench.problem(text, "governor.kind")
    assert "super-twisting" in problem.what and '"observer"' in problem.remedy
    assert not bench.load(text.replace('"sequential"', '"none"')).governor.is_chosen


def test_optimal_governor_needs_constant_ratios(bench: Bench) -> None:
    box = '[components.box]\ntype = "gearbox"\nratio = 1.0\nratio_range = [0.5, 2.0]\ninertia = "0.1 kg m^2"\n\n'
    text = governed('kind = "optimal"').replace("shaft1 - M2", "shaft1 - box - M2")
    text = text.replace("[control]", box + "[control]")
    problem = bench.problem(text, "governor.kind")
    assert "the ratio of box changes" in problem.what and '"sequential_modified"' in problem.remedy
    assert bench.load(text.replace('"optimal"', '"sequential"')).governor.kind == "sequential"

"""The page that sets runs beside the source's figures: every run works, and its numbers are those of the page."""

from __future__ import annotations

import importlib.util
import json
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"
SOURCE = [
    "2.6", "3.17", "3.20", "4.12", "4.13", "4.14", "4.15",
    "5.9", "5.12", "5.13", "5.14", "5.15", "5.16", "5.17", "5.18", "5.20", "5.21",
    "6.2", "6.4", "6.6", "6.7", "6.9",
    "7.5", "7.6", "7.7", "7.11", "7.12", "7.13", "7.14",
]  # fmt: skip


def load() -> ModuleType:
    specification = importlib.util.spec_from_file_location("make_validation", DOCS / "make_validation.py")
    module = importlib.util.module_from_spec(specification)
    sys.modules["make_validation"] = module
    specification.loader.exec_module(module)
    return module


make_validation = load()
NUMBERS = json.loads(make_validation.NUMBERS.read_text(encoding="utf-8"))


def kept(key: str, name: str) -> float:
    (value,) = [float(entry["value"]) for entry in NUMBERS[key] if entry["name"] == name]
    return value


@pytest.mark.compile
@pytest.mark.parametrize("case", make_validation.CASES, ids=lambda case: case.key)
def test_run_gives_the_numbers_of_the_page(case) -> None:
    numbers, figure = case.make()
    found = {case.key: [{"name": n.name, "value": n.value, "unit": n.unit, "source": n.source} for n in numbers]}
    assert make_validation.differences({case.key: NUMBERS[case.key]}, found) == [], "run make validation"
    assert all(axes.lines for axes in figure.axes)


def test_page_is_what_its_numbers_give() -> None:
    assert make_validation.PAGE.read_text(encoding="utf-8") == make_validation.page(NUMBERS), "run make validation"


def test_every_figure_is_there() -> None:
    text = make_validation.PAGE.read_text(encoding="utf-8")
    pictures = set(re.findall(r"\(figures/validation/(figure-[\d-]+\.svg)\)", text))
    assert pictures == {path.name for path in make_validation.FIGURES.glob("*.svg")}
    titles = " ".join(case.title.partition(":")[0] for case in make_validation.CASES)
    assert set(re.findall(r"\d\.\d+", titles)) == set(SOURCE)


def test_differences_are_found() -> None:
    old = {"figure": [{"name": "error", "value": 100.0, "unit": "N m", "source": "-"}]}
    for value, count in ((100.0, 0), (109.0, 0), (112.0, 1)):
        new = {"figure": [{"name": "error", "value": value, "unit": "N m", "source": "-"}]}
        assert len(make_validation.differences(old, new)) == count
    assert make_validation.differences({}, old) == ["figure: error is new"]


def test_claims_of_the_source() -> None:
    """What the source says in words, as inequalities between the numbers of the page."""
    assert 20 * kept("figure-2-6", "rms torque error in the speed ramps, decoupling") < kept(
        "figure-2-6", "rms torque error in the speed ramps, conventional"
    )
    assert abs(kept("figure-5-12", "frequency of the ringing") - 1.3) < 0.1
    assert kept("figure-5-12", "its damping ratio, integrator 1 /s") < 0
    assert kept("figure-5-13", "least damping ratio around the first mode") > 0.7
    for name in ("n1", "n2", "T1", "T2"):
        assert kept("figure-4-12", f"greatest difference of {name}, I to II") < 1e-9
    pause = [kept("figure-4-12", f"acceleration of M1 in the pause, {model}") for model in ("detailed", "II")]
    assert abs(pause[0] / pause[1] - (0.41 + 0.0034) / (0.41 + 0.0285)) < 2e-3  # rotor, flange, gearbox
    for key in ("figure-4-12", "figure-4-14"):
        assert kept(key, "rms difference of n1, detailed to II") < 15
        assert abs(kept(key, "duration of the shift, II") - kept(key, "duration of the shift, detailed")) < 0.02
    inertia = "largest torque error, I1 "
    assert kept("figure-5-14", f"{inertia}= 0") > 3 * kept("figure-5-14", f"{inertia}= rotor of M1")
    assert kept("figure-5-14", f"{inertia}= rotor of M1") > 3 * kept("figure-5-14", f"{inertia}from the full model")
    for kind in ("PI", "observer"):
        with_it, without = (
            kept("figure-5-16", f"largest speed error, {kind}, {name}") for name in ("decoupling", "damping only")
        )
        assert with_it < 0.01 * without
    assert kept("figure-5-17", "overshoot, PI") > 5 > 1 > kept("figure-5-17", "overshoot, observer")
    assert kept("figure-5-17", "error at the end of the ramp, observer") > 5
    times = [kept("figure-5-18", f"time to 90 %, damping ratio {zeta}") for zeta in ("0.2", "0.5", "1", "2")]
    assert times == sorted(times)
    assert (
        kept("figure-5-18", "overshoot, damping ratio 0.2") > 20 > 1 > kept("figure-5-18", "overshoot, damping ratio 1")
    )
    for shift in ("downshift", "upshift"):
        for what in ("largest torque at flange 1", "largest torque at flange 2", "largest speed error of M2"):
            assert 2 * kept("figure-5-20", f"{what}, {shift}, proposed") < kept(
                "figure-5-20", f"{what}, {shift}, conventional"
            )
    assert abs(kept("figure-6-6", "frequency of the ringing") - 17) < 0.5
    assert kept("figure-6-7", "speed error of M2, with compensation") < 1

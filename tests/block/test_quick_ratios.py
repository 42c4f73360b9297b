"""Ratios of clutches: the three evaluators agree, whatever the matrices were prepared for before."""

from __future__ import annotations

from pathlib import Path

import agreement
import pytest

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.project import Project
from ptgen.simulate.build import build

MACHINE = """
[components.{name}]
type = "machine"
inertia = "{inertia} kg m^2"
torque_max = "900 N m"
speed_rated = "3000 rpm"
speed_max = "9000 rpm"
inverter = {{ model = "lag", dead_time = "130 us", time_constant = "250 us" }}
"""
BED = f"""
[testbed]
name = "gears"
sample_time = "100 us"
connections = ["M1 - flange1 - FIRST - gb - shaft2 - M2"]
{MACHINE.format(name="M1", inertia=1.0)}
{MACHINE.format(name="M2", inertia=3.0)}
[components.flange1]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "380 kN m/rad"
sensor = {{ time_constant = "100 us" }}
[components.shaft1]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "3 N m s/rad"
[components.shaft2]
type = "shaft"
stiffness = "60 kN m/rad"
[components.bearing]
type = "bearing"
coulomb = "1 N m"
viscous = "0.1 N m s/rad"
[components.box]
type = "gearbox"
ratio = 1.0
ratio_range = [0.5, 2.0]
inertia = "0.05 kg m^2"
inertia_side = "output"
[components.gb]
type = "double_clutch_gearbox"
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
ratio1 = 5.503
ratio2 = 3.333
gears = {{ 1 = 5.503, 2 = 3.333, R = -3.403 }}
clutch1 = {{ capacity = "300 N m", static = "400 N m", stribeck_speed = "20 rpm" }}
clutch2 = {{ capacity = "500 N m", viscous = "0.1 N m s/rad" }}

[control]
speed = ["M1", "M2"]
structure = "individual"
"""


def project(folder: Path, first: str) -> Project:
    text = BED.replace("FIRST", first)
    if "shaft3" in first:
        text += '[components.shaft3]\ntype = "shaft"\nstiffness = "50 kN m/rad"\n'
    if "bearing" not in first:
        text = text.replace(text[text.index("[components.bearing]") : text.index("[components.box]")], "")
    if "box" not in first:
        text = text.replace(text[text.index("[components.box]") : text.index("[components.gb]")], "")
    (folder / "bed.toml").write_text(text, encoding="utf-8")
    return Project.read(folder / "bed.toml")


@pytest.mark.compile
@pytest.mark.parametrize(
    ("first", "quick"),
    [
        ("shaft1", {"gb_ratio1": True, "gb_ratio2": True}),
        ("bearing - shaft1", {"gb_ratio1": True, "gb_ratio2": True}),
    ],
)
def test_three_evaluators_agree(first: str, quick: dict[str, bool], tmp_path: Path) -> None:
    bed = project(tmp_path, first)
    plant = bed.plant
    assert {item.input: item.quick for item in plant.tracked} == quick
    batch = agreement.random_batch(plant, 300, seed=1)
    parameters = NumpyBlock(plant).defaults()
    reference = agreement.by_numpy(plant, parameters, batch)
    compiled = build(bed).plant
    for other in (agreement.by_casadi(plant, parameters, batch), agreement.by_c(compiled, parameters, batch)):
        difference, where = agreement.largest_difference(plant, reference, other)
        assert difference < 1e-11, where


@pytest.mark.compile
def test_a_slow_ratio_beside_quick_ones(tmp_path: Path) -> None:
    """The ratio of a gearbox between shafts changes the springs; all matrices follow both kinds."""
    bed = project(tmp_path, "shaft1 - box - shaft3")
    plant = bed.plant
    assert {item.input: item.quick for item in plant.tracked} == {
        "box_ratio": False,
        "gb_ratio1": True,
        "gb_ratio2": True,
    }
    batch = agreement.random_batch(plant, 40, seed=2)
    parameters = NumpyBlock(plant).defaults()
    reference = agreement.by_numpy(plant, parameters, batch)
    for other in (
        agreement.by_casadi(plant, parameters, batch),
        agreement.by_c(build(bed).plant, parameters, batch),
    ):
        difference, where = agreement.largest_difference(plant, reference, other)
        assert difference < 1e-9, where

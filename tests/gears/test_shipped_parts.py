"""The gear sets that come with ptgen: their published ratios come out of their layouts, and of their plants."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
import sympy as sp

from ptgen.errors import TestbedError
from ptgen.gears import GearAnalysis, Layout, analyse_gears, gear_ratios, layout_of_part
from ptgen.project import Project
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario
from ptgen.testbed.parts import read_part, shipped_parts

PUBLISHED = {
    "nine-speed.toml": {
        "R": "-4.932",
        "1": "5.503",
        "2": "3.333",
        "3": "2.315",
        "4": "1.661",
        "5": "1.211",
        "6": "1.000",
        "7": "0.865",
        "8": "0.717",
        "9": "0.601",
    },
    "six-speed-lepelletier.toml": {
        "R": "-3.403",
        "1": "4.171",
        "2": "2.340",
        "3": "1.521",
        "4": "1.143",
        "5": "0.867",
        "6": "0.691",
    },
    "seven-speed-dual-clutch.toml": {
        "R": "-17.42",  # 4.170 x 4.176
        "1": "16.71",  # 3.765 x 4.438, and so on
        "2": "10.09",
        "3": "6.79",
        "4": "4.98",
        "5": "3.80",
        "6": "3.07",
        "7": "2.57",
    },
}


def layout(name: str) -> Layout:
    return layout_of_part(read_part(shipped_parts()[name])(type="part", file=name))


@pytest.fixture(scope="module")
def analyses() -> dict[str, GearAnalysis]:
    return {
        name: analyse_gears(layout(name), read_part(path).description.gears) for name, path in shipped_parts().items()
    }


def test_ratios_of_every_shipped_gear_set_are_published() -> None:
    assert set(PUBLISHED) == set(shipped_parts())


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_ratios_come_out(name: str, analyses: dict[str, GearAnalysis]) -> None:
    found = gear_ratios(analyses[name].layout, read_part(shipped_parts()[name]).description.gears)
    digits = {gear: len(text.partition(".")[2]) for gear, text in PUBLISHED[name].items()}
    assert {gear: f"{ratio:.{digits[gear]}f}" for gear, ratio in found.items()} == PUBLISHED[name]


@pytest.mark.parametrize("name", PUBLISHED)
def test_shift_table_names_all_gears_and_neighbours_are_one_change_apart(
    name: str, analyses: dict[str, GearAnalysis]
) -> None:
    found = analyses[name]
    assert all(gear.named for gear in found.gears)
    names = [gear.name for gear in found.forward]
    for low, high in pairwise(names):
        for change in (found.change(low, high), found.change(high, low)):
            assert change is not None and change.is_single


def test_formulas_of_the_lepelletier_set(analyses: dict[str, GearAnalysis]) -> None:
    g1, g2, g3 = sp.symbols("g1:4", positive=True)
    front = (1 + g1) / g1  # of the set in front, whose sun is held
    expected = {
        "R": -front * g2,
        "1": front * g3,
        "2": front * (g2 + g3) / (1 + g2),
        "3": front,
        "4": 1 / (1 - (1 - 1 / front) / g3),
        "5": 1 / (1 + (1 - 1 / front) / g2),
        "6": g2 / (1 + g2),
    }
    found = analyses["six-speed-lepelletier.toml"]
    for name, formula in expected.items():
        gear = found.gear(name)
        assert gear is not None and gear.formula is not None
        assert sp.simplify(gear.formula - formula) == 0, name


def test_held_sun_takes_the_torque_of_the_front_set(analyses: dict[str, GearAnalysis]) -> None:
    first = analyses["six-speed-lepelletier.toml"].gear("1")
    assert first is not None
    assert first.speeds["housing"].value == 0
    assert first.ideal.trains["P1"].torques["sun"] == pytest.approx(37 / 71)


def test_planets_turn_relative_to_their_carrier(analyses: dict[str, GearAnalysis]) -> None:
    """(3.50): r_p = (r_r - r_s) / 2 and omega_p = -(r_s / r_p) (omega_s - omega_c)."""
    found = analyses["nine-speed.toml"]
    for gear in found.gears:
        for train, member in (("P1", "P1.planets"), ("P4", "P4.planets")):
            own = next(one for one in found.layout.trains if one.name == train)
            sun, carrier = (gear.speeds[own.members[flange]].value for flange in ("sun", "carrier"))
            planets = gear.speeds[member].value
            if sun is not None and carrier is not None:
                assert planets == -2 / (own.ratio - 1) * (sun - carrier)
    first = found.gear("1")
    assert first is not None and first.speeds["P1.planets"].formula is not None


BED = """
[testbed]
name = "rig"
sample_time = "100 us"
connections = ["M1 - shaft1 - gears.input", "gears.output - shaft2 - M2"]
[components.gears]
type = "part"
file = "six-speed-lepelletier.toml"
[components.shaft1]
type = "shaft"
stiffness = "20 kN m/rad"
damping = "5 N m s/rad"
[components.shaft2]
type = "shaft"
stiffness = "20 kN m/rad"
damping = "5 N m s/rad"
[components.M1]
type = "machine"
inertia = "0.4 kg m^2"
torque_max = "900 N m"
speed_rated = "3200 rpm"
speed_max = "8000 rpm"
[components.M2]
type = "machine"
inertia = "1.4 kg m^2"
torque_max = "2900 N m"
speed_rated = "3200 rpm"
speed_max = "8000 rpm"
[control]
structure = "individual"
speed = ["M1", "M2"]
"""

# Both machines hold speeds that differ a little from those of second gear, so that the shafts carry torque.
RUN = """
[scenario]
duration = "3 s"
record_every = "10 ms"
[references]
speed.M1 = { time = ["0 s", "0.5 s"], value = ["0 rpm", "600 rpm"] }
speed.M2 = { time = ["0 s", "0.5 s"], value = ["0 rpm", "240 rpm"] }
[actuations]
gears.A = { time = ["0 s"], value = [1] }
gears.C = { time = ["0 s"], value = [1] }
"""


@pytest.mark.compile
def test_plant_has_the_static_torques_of_the_analysis(tmp_path: Path, analyses: dict[str, GearAnalysis]) -> None:
    (tmp_path / "rig.toml").write_text(BED)
    (tmp_path / "run.toml").write_text(RUN)
    project = Project.read(tmp_path / "rig.toml")
    recording = simulate(project, load_scenario(tmp_path / "run.toml", project.testbed))
    final = {name: float(signal[-1]) for name, signal in recording.signals.items()}
    second = analyses["six-speed-lepelletier.toml"].gear("2")
    assert second is not None and second.drive is not None and abs(final["M1_torque"]) > 50
    assert final["M1_torque"] > 0, "the input drives"
    given = final["M1_torque"]
    # The plant's loss is 1 % of the sun's torque in both senses of power, that of the analysis 1 % of the power put in.
    assert final["gears_A_torque"] / given == pytest.approx(second.drive.elements["A"], rel=2e-3)
    assert final["gears_C_torque"] / given == pytest.approx(second.drive.elements["C"], rel=2e-3)
    assert -final["M2_torque"] / given == pytest.approx(second.drive.output_torque, rel=2e-3)


def member(text: str, tmp_path: Path, root: Path) -> str:
    part = (root / "parts" / "six-speed-lepelletier.toml").read_text()
    (tmp_path / "part.toml").write_text(part.replace("held = true", text))
    with pytest.raises(TestbedError) as caught:
        read_part(tmp_path / "part.toml")
    return str(caught.value)


def test_held_member_has_no_inertia(tmp_path: Path, root: Path) -> None:
    assert "members.housing: inertia has no effect on what is held" in member(
        'held = true\ninertia = "1 kg m^2"', tmp_path, root
    )


def test_free_sun_leaves_no_gear_of_the_table(tmp_path: Path, root: Path) -> None:
    text = member('inertia = "0.01 kg m^2"', tmp_path, root)
    assert "gears.1: is no gear: with A and D engaged the output turns independently of the input" in text

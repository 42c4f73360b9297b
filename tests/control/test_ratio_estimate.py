"""The ratio of a transmission that shifts by itself, from the speeds of the machines (source Section 5.4.1)."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from controller_steps import Compiled

from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library

pytestmark = pytest.mark.compile

GEARS = {"R": -3.3, "1": 4.7, "2": 3.13, "3": 2.1, "4": 1.67, "5": 1.28, "6": 1.0, "7": 0.82, "8": 0.65}
TRANSMISSION = f"""
[components.gears]
type = "clutch"
capacity = "1500 N m"
actuated = true
inertia_input = "0.02 kg m^2"
inertia_output = "0.03 kg m^2"

[reduction]
as_ratio = ["gears"]
gear_ratios = {{ gears = {{ {", ".join(f"{gear} = {ratio}" for gear, ratio in GEARS.items())} }} }}
"""
WATCHED = {"gears_ratio_source": 1.0, "M1_overspeed": 1e6, "M2_overspeed": 1e6}


@pytest.fixture(scope="module")
def project(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Project:
    text = (root / "testbeds" / "transmission-fixed-gear.toml").read_text(encoding="utf-8")
    begin, end = text.index("[components.gearbox]"), text.index("[components.shaft2]")
    text = text[:begin] + text[end:] + TRANSMISSION
    text = text.replace('"components.shaft2", "components.gearbox",', '"components.shaft2",')
    text = text.replace("gearbox.", "gears.").replace("transmission_fixed_gear", "estimated_ratio")
    file = tmp_path_factory.mktemp("bed") / "bed.toml"
    file.write_text(text, encoding="utf-8")
    return Project.read(file)


@pytest.fixture(scope="module")
def library(project: Project) -> Library:
    return build(project)


def turn(controller: Compiled, ratio: float, steps: int, speed: float = 60.0, noise: float = 0.0) -> np.ndarray:
    """Do steps with speeds in a ratio; return the ratio that the law has in each of them."""
    rng = np.random.default_rng(1)
    found = np.zeros(steps)
    for k in range(steps):
        first, second = noise * rng.normal(size=2)
        inputs = {"M1_speed": ratio * speed + first, "M2_speed": speed + second, "M2_speed_ref": speed}
        controller.step(gears_ratio=4.7, **inputs)
        found[k] = controller.state("gears_ratio_limited")
    return found


@pytest.mark.parametrize("gear", GEARS)
def test_estimate_settles_at_each_gear_under_noise(gear: str, library: Library) -> None:
    """With noise of 0.5 rad/s on both speeds, about 1 % of the slower one, it is the gear exactly."""
    found = turn(Compiled(library, WATCHED), GEARS[gear], 5000, noise=0.5)
    assert set(found[2000:]) == {GEARS[gear]}


def test_estimate_follows_a_shift_and_settles_again(library: Library) -> None:
    controller = Compiled(library, WATCHED)
    turn(controller, 3.13, 1500)
    path = np.concatenate([turn(controller, ratio, 1) for ratio in np.linspace(3.13, 2.1, 3000)])
    after = turn(controller, 2.1, 2000)
    assert np.abs(np.diff([*path, *after])).max() <= (4.7 + 3.3) / 0.5 * 1e-4 * (1 + 1e-9), "within its rate"
    middle = path[500:2500]
    late = 0.02 * (3.13 - 2.1) / 0.3
    assert np.abs(middle - np.linspace(3.13, 2.1, 3000)[500:2500]).max() < late + 0.02 * 3.13
    assert after[-1] == 2.1


def test_near_standstill_the_last_ratio_is_held(library: Library) -> None:
    controller = Compiled(library, WATCHED)
    assert turn(controller, 1.28, 2000)[-1] == 1.28
    assert set(turn(controller, 3.0, 2000, speed=2.0)) == {1.28}
    assert set(turn(controller, -5.0, 2000, speed=0.0)) == {1.28}


def test_estimate_stays_within_the_gears(library: Library) -> None:
    found = turn(Compiled(library, WATCHED), 9.0, 4000)
    assert found.max() == 4.7


def test_source_changes_without_a_jump(library: Library) -> None:
    """The input is wrong by far: torques move as slowly as the switch, over half a second."""
    controller = Compiled(library, {**WATCHED, "gears_ratio_source": 0.0})
    turning = {"M1_speed": 2.1 * 60.0, "M2_speed": 60.0, "M2_speed_ref": 60.0, "gears_ratio": 3.13}
    torques = []
    for k in range(9000):
        if k == 1500:
            controller.set({"gears_ratio_source": 1.0})
        torques.append(controller.step(**turning)["M1_torque_ref"])
    assert abs(torques[1400]) > 500  # the damping fights the wrong ratio
    assert controller.state("gears_ratio_limited") == 2.1
    assert abs(torques[-1]) < 1e-6 + 0.01 * abs(torques[1400])
    assert np.abs(np.diff(torques[1000:])).max() < 10.0


def test_estimated_rate_accelerates_nothing(library: Library) -> None:
    """It would be M1's own acceleration, fed back: nothing but the input may ask for I_m1 omega_2 di/dt."""
    for source, least, most in ((1.0, 0.0, 1e-6), (0.0, 100.0, 1e4)):
        controller = Compiled(library, {**WATCHED, "M1_damping": 0.0, "gears_ratio_source": source})
        torques = []
        for ratio in np.linspace(3.13, 2.1, 2000):
            inputs = {"M1_speed": ratio * 60.0, "M2_speed": 60.0, "M2_speed_ref": 60.0}
            torques.append(controller.step(gears_ratio=ratio, **inputs)["M1_torque_ref"])
        assert least <= np.abs(torques[10:]).max() <= most


@pytest.mark.parametrize("bad", [math.nan, math.inf, 1e9])
@pytest.mark.parametrize("signal", ["M1_speed", "M2_speed", "gears_ratio"])
def test_what_is_not_finite_never_comes_through(signal: str, bad: float, library: Library) -> None:
    controller = Compiled(library, WATCHED)
    turn(controller, 2.1, 1500)
    turning = {"M1_speed": 126.0, "M2_speed": 60.0, "M2_speed_ref": 60.0, "gears_ratio": 4.7}
    for _ in range(5):  # shorter than what is bridged
        torques = controller.step(**{**turning, signal: bad})
        assert all(map(math.isfinite, torques.values()))
        assert controller.state("gears_ratio_limited") == 2.1
    assert math.isfinite(controller.state("gears_ratio_estimate"))


def test_speeds_behind_gears_are_taken_in(tmp_path: Path, root: Path) -> None:
    """A fixed gearbox beside the transmission is no part of the ratio."""
    text = (root / "testbeds" / "transmission-fixed-gear.toml").read_text(encoding="utf-8")
    begin, end = text.index("[components.gearbox]"), text.index("[components.shaft2]")
    text = text[:begin] + text[end:] + TRANSMISSION
    text += '[components.step]\ntype = "gearbox"\nratio = 1.5\ninertia = "0.01 kg m^2"\n'
    text = text.replace('"components.shaft2", "components.gearbox",', '"components.shaft2",')
    text = text.replace("gearbox.", "gears.").replace("M1 - flange1", "M1 - step - flange1")
    text = text.replace("transmission_fixed_gear", "estimated_behind_gears")
    (tmp_path / "bed.toml").write_text(text, encoding="utf-8")
    controller = Compiled(build(Project.read(tmp_path / "bed.toml")), WATCHED)
    assert turn(controller, 1.5 * 2.1, 2000)[-1] == 2.1

"""Simplified gearboxes in closed loop: courses of their ratios in scenarios, and the event-driven plant beside them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ptgen.errors import ModelError, Problem, TestbedError
from ptgen.project import Project
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario, load, load_scenario

H = 1e-4
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
connections = ["M1 - shaft1 - gb - shaft2 - M2"]
{MACHINE.format(name="M1", inertia=1.0)}
{MACHINE.format(name="M2", inertia=3.0)}
[components.shaft1]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "3 N m s/rad"
[components.shaft2]
type = "shaft"
stiffness = "60 kN m/rad"
damping = "5 N m s/rad"
[components.gb]
type = "double_clutch_gearbox"
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
ratio1 = 5.503
ratio2 = 3.333
gears = {{ 1 = 5.503, 2 = 3.333, R = -3.403 }}
clutch1 = {{ capacity = "300 N m" }}
clutch2 = {{ capacity = "500 N m", static = "600 N m", stribeck_speed = "20 rpm" }}

[control]
speed = ["M1", "M2"]
structure = "individual"
"""
FIVE = '{ time = ["0 s"], value = [5] }'
HEAD = '[scenario]\nduration = "0.2 s"\nrecord_every = "1 ms"\n'


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    file = tmp_path_factory.mktemp("bed") / "bed.toml"
    file.write_text(BED, encoding="utf-8")
    return Project.read(file)


def read(project: Project, folder: Path, text: str) -> Scenario:
    (folder / "case.toml").write_text(HEAD + text, encoding="utf-8")
    return load_scenario(folder / "case.toml", project.testbed)


@pytest.mark.compile
def test_emitted_plant_is_the_event_driven_one(project: Project) -> None:
    """An overlapping shift, with both ratios set before."""
    references = {
        "speed.M1": Profile((0.0, 0.02), (0.0, 30.0), "lines"),
        "speed.M2": Profile((0.0, 0.02), (0.0, 6.0), "lines"),
    }
    actuations = {
        "gb.clutch1": Profile((0.0, 0.01, 0.03, 0.05), (0.0, 1.0, 1.0, 0.0), "lines"),
        "gb.clutch2": Profile((0.03, 0.05), (0.0, 0.7), "lines"),
    }
    scenario = Scenario("case", "", "", 0.06, H, references, actuations)
    emitted, events = simulate(project, scenario), simulate(project, scenario, method="events")
    for name in ("M1_speed", "M2_speed", "gb_clutch1_speed", "gb_clutch2_speed"):
        scale = np.abs(events.signals[name]).max()
        assert np.abs(emitted.signals[name] - events.signals[name]).max() < 2e-3 * scale, name
    for name in ("gb_clutch1_torque", "gb_clutch2_torque"):
        off = np.abs(emitted.signals[name] - events.signals[name])
        assert np.sqrt(np.mean(off**2)) < 2.0, name


def test_ratios_of_one_gearbox_have_courses_of_their_own(project: Project, tmp_path: Path) -> None:
    steps = '{ time = ["0 s", "0.1 s"], value = [3.333, -3.403], shape = "steps" }'
    wanted = {
        "gb.ratio1": Profile((0.0,), (5.503,), "lines"),
        "gb.ratio2": Profile((0.0, 0.1), (3.333, -3.403), "steps"),
    }
    for text in (
        f"[ratios.gb]\nratio2 = {steps}\n",
        f'[ratios]\n"gb.ratio2" = {steps}\n',
        f"[ratios]\ngb.ratio2 = {steps}\n",
    ):
        assert read(project, tmp_path, text).ratios == wanted


@pytest.mark.compile
def test_recording_holds_both_ratios(project: Project, tmp_path: Path) -> None:
    text = '[ratios.gb]\nratio2 = { time = ["0 s", "0.1 s"], value = [3.333, -3.403], shape = "steps" }\n'
    signals = simulate(project, read(project, tmp_path, text)).signals
    assert np.all(signals["gb_ratio1"] == 5.503)
    assert set(signals["gb_ratio2"].tolist()) == {3.333, -3.403}


@pytest.mark.parametrize(
    ("text", "where", "what"),
    [
        ('[ratios]\ngb = { time = ["0 s"], value = [3.3] }', "ratios.gb", "none of the ratios"),
        ('[ratios.gb]\nratio3 = { time = ["0 s"], value = [3.3] }', "ratios.gb.ratio3", "none of the ratios"),
        ('[ratios.gb]\nratio1 = { time = ["0 s"], value = [6] }', "ratios.gb.ratio1.value[0]", "from -3.403 to 5.503"),
        (
            f'[ratios]\n"gb.ratio1" = {FIVE}\n[ratios.gb]\nratio1 = {FIVE}',
            "ratios.gb.ratio1",
            "has an entry already",
        ),
        ('[ratios.gbx]\nratio1 = { time = ["0 s"], value = [5] }', "ratios.gbx.ratio1", "is no gearbox"),
    ],
)
def test_entries_that_cannot_be(project: Project, tmp_path: Path, text: str, where: str, what: str) -> None:
    with pytest.raises(TestbedError) as caught:
        read(project, tmp_path, text + "\n")
    problems: tuple[Problem, ...] = tuple(caught.value.problems)
    assert [problem.where for problem in problems] == [where]
    assert what in problems[0].what and problems[0].remedy


def test_constant_gearboxes_have_no_ratio_to_change(tmp_path: Path) -> None:
    (tmp_path / "bed.toml").write_text(BED.replace("gears = {", "#"), encoding="utf-8")
    testbed = load(tmp_path / "bed.toml")
    assert testbed.ratios == {}
    (tmp_path / "case.toml").write_text(
        HEAD + '[ratios.gb]\nratio1 = { time = ["0 s"], value = [5] }\n', encoding="utf-8"
    )
    with pytest.raises(TestbedError, match="is constant"):
        load_scenario(tmp_path / "case.toml", testbed)


def test_control_with_a_locked_clutch_wants_a_ratio_instead(tmp_path: Path) -> None:
    text = BED + '[reduction]\nlocked = ["gb.clutch1"]\n'
    (tmp_path / "bed.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        _ = Project.read(tmp_path / "bed.toml").reduced
    (problem,) = caught.value.problems
    assert problem.where == "reduction.locked" and 'as_ratio = ["gb"]' in problem.remedy


def test_modes_are_those_of_the_ratios_at_the_start(project: Project, tmp_path: Path) -> None:
    from ptgen.mechanism.modes import modes

    (tmp_path / "bed.toml").write_text(BED.replace("gears = {", "#"), encoding="utf-8")
    constant = Project.read(tmp_path / "bed.toml").model
    for locked in ("gb.clutch1", "gb.clutch2"):
        got, wanted = ([m.frequency_hz for m in modes(model, locked=[locked])] for model in (project.model, constant))
        assert got == pytest.approx(wanted, rel=1e-9, abs=1e-6)

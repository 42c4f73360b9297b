"""Shifts in closed loop: what the gearboxes do, and what a run tells of them."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from ptgen.cli.application import app
from ptgen.project import Project
from ptgen.report.recording_figure import recording_figure
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

pytestmark = pytest.mark.compile

MACHINE = """
[components.{name}]
type = "machine"
inertia = "{inertia} kg m^2"
torque_max = "{torque} N m"
speed_rated = "3000 rpm"
speed_max = "9000 rpm"
inverter = {{ model = "lag", dead_time = "130 us", time_constant = "250 us" }}
"""
BED = f"""
[testbed]
name = "gears"
sample_time = "100 us"
connections = ["M1 - shaft1 - gb - shaft2 - M2"]
{MACHINE.format(name="M1", inertia=0.3, torque=900)}
{MACHINE.format(name="M2", inertia=3.0, torque=4000)}
[components.shaft1]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "20 N m s/rad"
[components.shaft2]
type = "shaft"
stiffness = "60 kN m/rad"
damping = "50 N m s/rad"
[components.gb]
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
gears = {{ 1 = 5.503, 2 = 3.333, 3 = 2.315 }}
"""
SINGLE = 'type = "single_clutch_gearbox"\nratio = 3.333\nclutch = { capacity = "500 N m" }\n'
DOUBLE = """type = "double_clutch_gearbox"
ratio1 = 5.503
ratio2 = 3.333
clutch1 = { capacity = "500 N m" }
clutch2 = { capacity = "500 N m" }
"""
ROLES = '[control]\nspeed = ["M1", "M2"]\nstructure = "individual"\n'
HEAD = """
[scenario]
title = "Shifts"
duration = "3 s"
record_every = "1 ms"
[references]
speed.M2 = { time = ["0 s", "0.5 s"], value = ["0 rpm", "300 rpm"] }
speed.M1 = { time = ["0 s", "0.5 s", "1.3 s", "1.5 s"], value = ["0 rpm", "1000 rpm", "1000 rpm", "1651 rpm"] }
[gears]
gb = "2"
[[shifts]]
component = "gb"
time = "1 s"
to = "1"
kind = "non-overlapping"
pause = "0.4 s"
"""


@cache
def project(gearbox: str, folder: Path) -> Project:
    (folder / f"bed{len(gearbox)}.toml").write_text(BED + gearbox + ROLES, encoding="utf-8")
    return Project.read(folder / f"bed{len(gearbox)}.toml")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("shifts")


def run(gearbox: str, folder: Path, more: str = "") -> Recording:
    (folder / "case.toml").write_text(HEAD + more, encoding="utf-8")
    bed = project(gearbox, folder)
    return simulate(bed, load_scenario(folder / "case.toml", bed.testbed))


def test_both_gearboxes_do_the_same_in_a_shift_that_does_not_overlap(folder: Path) -> None:
    """As the source says of Figures 4.12 and 4.13: with one clutch open, model II is model I."""
    single, double = run(SINGLE, folder), run(DOUBLE, folder)
    for name in ("M1_speed", "M2_speed", "M1_torque", "M2_torque"):
        size = np.abs(single.signals[name]).max()
        assert single.signals[name] == pytest.approx(double.signals[name], abs=1e-6 * size)
    first, second = (double.signals[f"{machine}_speed"] for machine in ("M1", "M2"))
    assert first[900] == pytest.approx(3.333 * second[900], rel=1e-3)
    assert first[-1] == pytest.approx(5.503 * second[-1], rel=1e-3)
    assert double.signals["gb_clutch1_speed"][-1] == 0.0 and single.signals["gb_clutch_speed"][-1] == 0.0


def test_overlapping_shift_transmits_all_the_time(folder: Path) -> None:
    """Both clutches carry torque at once, one more and the other less, and no clutch gives power."""
    load = '[[shifts]]\ncomponent = "gb"\ntime = "2.2 s"\nto = "2"\n'
    signals = run(DOUBLE, folder, load).signals
    during = slice(2210, 2490)
    torques = [np.abs(signals[f"gb_clutch{k}_torque"][during]) for k in (1, 2)]
    assert np.mean((torques[0] > 1.0) & (torques[1] > 1.0)) > 0.5
    shares = signals["gb_clutch1_actuation"][during] + signals["gb_clutch2_actuation"][during]
    assert shares == pytest.approx(1.0)
    for clutch in ("gb_clutch1", "gb_clutch2"):
        assert (signals[f"{clutch}_torque"] * signals[f"{clutch}_speed"]).min() > -1.0
    assert (signals["gb_clutch1_actuation"][-1], signals["gb_clutch2_actuation"][-1]) == (0.0, 1.0)


def test_run_tells_its_shifts(folder: Path) -> None:
    recording = run(SINGLE, folder)
    assert recording.gears == {"gb": "2"}
    assert recording.summary()["shifts"] == [
        {"component": "gb", "before": "2", "to": "1", "start": 1.0, "end": 2.0, "kind": "non-overlapping"}
    ]
    assert not json.dumps(recording.summary()).isspace()
    figure = recording_figure(recording, project(SINGLE, folder))
    assert "2 to 1" in {text.get_text() for axes in figure.axes for text in axes.texts}


NINE = """type = "part"
file = "nine-speed.toml"
"""
GEARS = (*"123456789", "R")
UP = """
[scenario]
duration = "6.5 s"
record_every = "1 ms"
[references]
torque.M1 = { time = ["0.1 s", "0.2 s"], value = ["0 N m", "60 N m"] }
speed.M2 = { time = ["0 s", "0.4 s", "5.2 s", "5.4 s"], value = ["0 rpm", "100 rpm", "100 rpm", "0 rpm"] }
[gears]
gb = "1"
"""


def test_nine_speed_goes_through_all_gears_and_reverse(folder: Path) -> None:
    """Each gear has the ratio of its table at the end, whatever sticks and slips on the way there."""
    own = BED[BED.index("inertia_input") :]
    roles = '[control]\ntorque = { M1 = "gb.input" }\nspeed = ["M2"]\n[reduction]\nas_ratio = ["gb"]\n'
    flanges = "".join(
        f'[components.flange{k}]\ntype = "torque_flange"\ninertia = "0.03 kg m^2"\nstiffness = "380 kN m/rad"\n'
        for k in (1, 2)
    )
    text = BED.replace(own, NINE).replace("M1 - shaft1", "M1 - flange1 - shaft1").replace("- M2", "- flange2 - M2")
    (folder / "nine.toml").write_text(text + flanges + roles, encoding="utf-8")
    bed = Project.read(folder / "nine.toml")
    course = UP + "".join(
        f'[[shifts]]\ncomponent = "gb"\ntime = "{0.6 * k:g} s"\nto = "{gear}"\n'
        for k, gear in enumerate(GEARS[1:], start=1)
    )
    (folder / "up.toml").write_text(course, encoding="utf-8")
    recording = simulate(bed, load_scenario(folder / "up.toml", bed.testbed))
    ratios = bed.testbed.gear_tables["gb"].gears
    assert set(ratios) == set(GEARS)
    assert np.all(recording.signals["fault"] == 0)
    first, second = (recording.signals[f"{machine}_speed"] for machine in ("M1", "M2"))
    for k, gear in enumerate(GEARS[:-1]):
        at = 600 * (k + 1) - 5
        assert first[at] == pytest.approx(ratios[gear] * second[at], rel=0.02), gear
    engaged = bed.testbed.components["gb"].gear_elements()["R"]
    assert all(recording.signals[f"gb_{element}_actuation"][-1] == 1.0 for element in engaged)


def test_command_line_lists_shifts(folder: Path) -> None:
    bed = project(SINGLE, folder).testbed.file
    (folder / "case.toml").write_text(HEAD, encoding="utf-8")
    result = CliRunner().invoke(app, ["simulate", bed, "--scenario", str(folder / "case.toml")])
    assert result.exit_code == 0, result.output
    assert "gb: 2 to 1 from 1 s to 2 s, non-overlapping" in result.output

"""generate, build and simulate."""

from __future__ import annotations

import csv
import signal
import time

import numpy as np
import pytest

BED = "testbeds/back-to-back.toml"
SCENARIO = """\
[scenario]
title = "Short"
duration = "{duration}"
record_every = "{every}"

[references.torque.M1]
time = ["0 s", "0.1 s"]
value = ["0 N m", "200 N m"]

[references.speed.M2]
time = ["0 s"]
value = ["100 rpm"]
"""


@pytest.fixture
def scenario(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(SCENARIO.format(duration="0.3 s", every="1 ms"), encoding="utf-8")
    return path


@pytest.mark.parametrize("precision", ["double", "float"])
def test_generate_writes_the_project(cli, tmp_path, precision):
    folder = tmp_path / "build"
    found = cli.json("generate", BED, "-o", folder, "--precision", precision)
    assert found["precision"] == precision
    written = {str(path) for path in folder.rglob("*") if path.is_file()}
    assert set(found["files"]) == written
    assert str(folder / "back_to_back_controller.c") in written
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert "back_to_back_plant.h" in cli("generate", BED, "-o", folder, "--precision", precision).stdout
    assert before == {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.compile
def test_build_makes_a_library(cli, tmp_path):
    from pathlib import Path

    found = cli.json("build", BED, "-o", tmp_path / "build")
    assert Path(found["library"]).is_file()
    assert Path(found["library"]).parent == tmp_path / "build"
    assert cli("build", BED, "-o", tmp_path / "build").stdout.strip() == found["library"]


@pytest.mark.compile
@pytest.mark.parametrize("controller", ["decoupling", "conventional"])
def test_simulate_records_and_draws(cli, tmp_path, scenario, controller):
    table, figure = tmp_path / "run.csv", tmp_path / "run.svg"
    arguments = ("simulate", BED, "--scenario", scenario, "--controller", controller, "-o", table, "--plot", figure)
    found = cli.json(*arguments)
    assert {"steps", "wall_s", "realtime_factor", "signals"} <= set(found)
    assert found["steps"] == 3000
    assert found["controller"] == controller
    for numbers in found["signals"].values():
        assert set(numbers) == {"min", "max", "rms", "final"}
        assert numbers["min"] <= numbers["final"] <= numbers["max"]
    assert found["signals"]["flange1_torque_ref"]["final"] == pytest.approx(200)
    with table.open(encoding="utf-8") as stream:
        rows = list(csv.reader(stream))
    assert len(rows) == 301
    assert np.isfinite(np.array(rows[1:], dtype=float)).all()
    assert figure.read_bytes().startswith(b"<?xml")
    assert {path.name for path in tmp_path.iterdir()} == {"run.csv", "run.svg", "short.toml"}


@pytest.mark.compile
def test_simulate_as_text_has_readable_units(cli, scenario):
    text = cli("simulate", BED, "-s", scenario).stdout
    assert "times real time" in text and "rpm" in text and "N m" in text


def test_scenario_problems_name_the_scenario(cli, tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text(SCENARIO.format(duration="1 rpm", every="1 ms"), encoding="utf-8")
    problems = cli.json("simulate", BED, "-s", path, code=2)["problems"]
    assert [(problem["file"], problem["where"]) for problem in problems] == [(str(path), "scenario.duration")]


def test_simulate_with_other_parameters(cli, scenario):
    """A change to 200 N m overshoots without damping."""

    def peak(*settings: str) -> float:
        return cli.json("simulate", BED, "-s", scenario, *settings)["signals"]["flange1_torque"]["max"]

    assert peak("--set", "M1_damping=0", "--set", "M1_torque_integral_gain=1") > 210 > 205 > peak()


def test_simulate_names_settings_that_are_none(cli, scenario):
    wrong = ("--set", "M1_damping", "--set", "M1_damping=4 N", "--set", "x=1", "--set", "x=2")
    problems = cli.json("simulate", BED, "-s", scenario, *wrong, code=2)["problems"]
    assert [problem["where"] for problem in problems] == ["--set"] * 3
    (problem,) = cli.json("simulate", BED, "-s", scenario, "--set", "M1_dampin=1", code=2)["problems"]
    assert "M1_damping" in problem["remedy"]


def test_simulate_knows_its_controllers(cli, scenario):
    assert "conventional" in cli("simulate", BED, "-s", scenario, "--controller", "best", code=2).output


@pytest.mark.compile
def test_an_interrupted_run_leaves_nothing(process, tmp_path):
    path = tmp_path / "long.toml"
    path.write_text(SCENARIO.format(duration="100000 s", every="10 s"), encoding="utf-8")
    running = process("simulate", BED, "-s", path, "-o", tmp_path / "run.csv", "--plot", tmp_path / "run.svg")
    time.sleep(4.0)  # by then it imports, compiles or runs; it must end well in each of these
    assert running.poll() is None
    running.send_signal(signal.SIGINT)
    output, errors = running.communicate(timeout=60)
    assert running.returncode == 130
    assert output == b"" and b"Traceback" not in errors
    assert [found.name for found in tmp_path.iterdir()] == ["long.toml"]

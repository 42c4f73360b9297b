"""How commands end: exit codes, messages, pipes."""

from __future__ import annotations

import json

import pytest

from ptgen import __version__
from ptgen.cli.outcome import DEBUG

BED = "testbeds/differential.toml"


def test_version(cli):
    assert cli("--version").stdout.strip() == f"ptgen {__version__}"


@pytest.mark.parametrize("command", ["check", "show", "derive", "modal", "generate", "build", "simulate", "schema"])
def test_every_command_explains_itself(cli, command):
    assert "--help" in cli(command, "--help").stdout


@pytest.mark.parametrize("arguments", [("nonsense",), ("check",), ("check", BED, "--nonsense"), ("simulate", BED)])
def test_wrong_usage_exits_with_two(cli, arguments):
    cli(*arguments, code=2)


@pytest.mark.parametrize(
    "command", [("check",), ("show",), ("derive",), ("modal",), ("generate", "-o", "x"), ("build", "-o", "x")]
)
def test_problems_are_told_on_stderr_and_as_json(cli, tmp_path, command):
    bed = tmp_path / "bed.toml"
    with open(BED, encoding="utf-8") as stream:
        text = stream.read()
    bed.write_text(text.replace('"1.0 kg m^2"', '"-1 kg m^2"').replace('"57 kN m/rad"', '"57 kN"', 1), encoding="utf-8")
    name, *options = command
    plain = cli(name, bed, *options, code=2)
    assert plain.stdout == ""
    lines = plain.stderr.splitlines()
    assert len(lines) == 2
    assert lines[0].startswith(f"{bed}: components.M1.inertia: ") and "; " in lines[0]
    problems = cli.json(name, bed, *options, code=2)["problems"]
    assert [set(problem) for problem in problems] == [{"file", "where", "what", "remedy"}] * 2
    assert [problem["where"] for problem in problems] == ["components.M1.inertia", "components.cardan1.stiffness"]
    assert {problem["file"] for problem in problems} == {str(bed)}


def test_a_missing_file_is_the_users_problem(cli):
    result = cli("check", "testbeds/none.toml", code=2)
    assert result.stderr.startswith("testbeds/none.toml: ")


def test_roles_without_a_controller_are_the_users_problem(cli, tmp_path):
    bed = tmp_path / "bed.toml"
    with open(BED, encoding="utf-8") as stream:
        text = stream.read()
    text = text.replace('torque = { M1 = "diff.input" }', 'torque = { M2 = "diff.output1", M3 = "diff.output2" }')
    bed.write_text(text.replace('speed = ["M2", "M3"]', 'speed = ["M1"]'), encoding="utf-8")
    assert cli("check", bed, code=2).stderr.startswith(f"{bed}: ")


@pytest.mark.parametrize(
    ("arguments", "option"),
    [
        (("show", BED, "-o", "none/bed.svg"), "--output"),
        (("show", BED, "-o", "bed.jpg"), "--output"),
        (("show", BED, "-o", "bed"), "--output"),
        (("modal", BED, "--plot", "none/m.svg"), "--plot"),
        (("modal", BED, "--plot", "m.bmp"), "--plot"),
        (("generate", BED, "-o", BED), "--output"),
        (("simulate", BED, "-s", "scenarios/differential-run.toml", "-o", "none/run.csv"), "--output"),
        (("simulate", BED, "-s", "scenarios/differential-run.toml", "-o", "run.xlsx"), "--output"),
        (("simulate", BED, "-s", "scenarios/differential-run.toml", "--plot", "run.gif"), "--plot"),
    ],
)
def test_destinations_are_checked_before_the_work(cli, monkeypatch, arguments, option):
    from ptgen.project import Project

    monkeypatch.setattr(Project, "read", lambda path: pytest.fail("the work has begun"))
    (problem,) = cli.json(*arguments, code=2)["problems"]
    assert problem["where"] == option


def test_a_defect_is_told_without_traceback(cli, monkeypatch):
    from ptgen.project import Project

    def broken(path):
        raise ZeroDivisionError("nothing to divide by")

    monkeypatch.setattr(Project, "read", broken)
    result = cli("check", BED, code=1)
    assert "ZeroDivisionError: nothing to divide by" in result.stderr and f"{DEBUG}=1" in result.stderr
    assert result.stdout == ""


def test_a_defect_shows_its_traceback_on_request(cli, monkeypatch):
    from typer.testing import CliRunner

    from ptgen.cli import app
    from ptgen.project import Project

    def broken(path):
        raise ZeroDivisionError

    monkeypatch.setattr(Project, "read", broken)
    monkeypatch.setenv(DEBUG, "1")
    assert isinstance(CliRunner().invoke(app, ["check", BED]).exception, ZeroDivisionError)


@pytest.mark.parametrize("arguments", [("derive", BED), ("derive", BED, "--json"), ("show", BED), ("schema",)])
def test_a_closed_pipe_ends_in_silence(process, arguments):
    running = process(*arguments)
    running.stdout.close()
    errors = running.stderr.read()
    running.stderr.close()
    assert running.wait(60) in (0, 141)
    assert errors == b""


def test_the_real_program_prints_pure_json(process):
    with process("modal", BED, "--json") as running:
        output, errors = running.communicate(timeout=60)
    assert running.returncode == 0
    assert errors == b""
    assert json.loads(output)["name"] == "differential"


def test_letters_that_the_terminal_lacks_are_written_in_other_words(process):
    import os

    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    with process("derive", BED, env=environment) as running:
        output, errors = running.communicate(timeout=60)
    assert (running.returncode, errors) == (0, b"")
    assert "domega(M1)/dt" in output.decode("ascii")


def test_help_starts_without_the_mathematics(process):
    import subprocess
    import sys

    code = "import sys, ptgen.cli; sys.exit(any(name in sys.modules for name in ('sympy', 'matplotlib', 'pydantic')))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0

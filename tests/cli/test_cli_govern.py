"""govern: JSON contract, text, figures, and errors that name what is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

BED = "testbeds/differential-governed.toml"
KEYS = {
    "name", "title", "governor", "settings", "sample_time", "limits", "stationary", "order", "set", "check",
    "scenario", "beyond", "runs",
}  # fmt: skip
SET_KEYS = {
    "horizon", "horizon_steps", "automatic", "looked_at_steps", "inequalities", "kept_inequalities", "rows", "removal",
    "loss", "programs", "binding", "shorter",
}  # fmt: skip
RUN_KEYS = {
    "bed", "label", "governor", "horizon", "torque_weight", "speed_weight", "beyond_limit", "beyond_reserve",
    "set_points", "statuses", "mean_iterations", "most_iterations", "slack",
}  # fmt: skip
SCENARIO = """
[scenario]
title = "Short"
duration = "0.2 s"
record_every = "1 ms"
[references]
torque.M1 = { time = ["0 s", "0.05 s"], value = ["0 N m", "TORQUE N m"], shape = "steps" }
speed.M2 = { time = ["0 s", "0.05 s"], value = ["0 rpm", "200 rpm"], shape = "steps" }
speed.M3 = { time = ["0 s", "0.05 s"], value = ["0 rpm", "200 rpm"], shape = "steps" }
"""


@pytest.fixture
def short(tmp_path: Path) -> Path:
    path = tmp_path / "short.toml"
    path.write_text(SCENARIO.replace("TORQUE", "300"), encoding="utf-8")
    return path


@pytest.fixture
def excessive(tmp_path: Path) -> Path:
    path = tmp_path / "excessive.toml"
    path.write_text(SCENARIO.replace("TORQUE", "1000"), encoding="utf-8")
    return path


def test_govern_keeps_its_contract(cli, short) -> None:
    found = cli.json("govern", BED, "--governor", "optimal", "--horizon", "0", "--scenario", short)
    assert set(found) == KEYS and set(found["set"]) == SET_KEYS
    assert (found["governor"], found["scenario"], found["beyond"], found["check"]) == ("optimal", "Short", [], None)
    assert found["set"]["horizon_steps"] == 0 and found["set"]["shorter"] == []
    assert found["set"]["rows"]["M1"] == {"all": 1, "kept": 1, "steps": [0]}
    assert found["stationary"]["largest"] == {
        "diff_input_torque_ref": {"value": pytest.approx(865.83), "machine": "M1"}
    }
    assert [step["machine"] for step in found["order"]] == ["M2", "M3", "M1"]
    assert [run["bed"] for run in found["runs"]] == ["nominal", "plant"]
    for run in found["runs"]:
        assert set(run) == RUN_KEYS
        assert set(run["beyond_limit"][0]) == {"machine", "most", "at", "lasting", "limit"}
        assert len(run["set_points"]) == 3 and sum(run["statuses"].values()) == 2000
        assert run["set_points"][0]["shaped_after"] is not None


def test_without_a_scenario_limits_and_order_are_shown(cli) -> None:
    found = cli.json("govern", BED, "--governor", "sequential_modified")
    assert found["governor"] == "sequential_modified" and found["set"] is None and found["runs"] == []
    text = cli("govern", BED, "--governor", "sequential_modified").stdout
    assert "reference governor sequential modified" in text
    assert "let through up to 865.8 N m, then M1 is at its limit" in text
    assert "they are placed before, and give way" in text


def test_the_governor_of_the_file(cli) -> None:
    found = cli.json("govern", BED)
    assert found["governor"] == "optimal" and found["set"]["automatic"]
    assert found["set"]["kept_inequalities"] < 0.1 * found["set"]["inequalities"]
    text = cli("govern", BED).stdout
    assert "Constraint set of the optimal governor" in text and "(longer ones add nothing)" in text
    assert "With a shorter horizon, rows behind it could still bind" in text


def test_runs_as_text_and_figures(cli, excessive, tmp_path) -> None:
    folder = tmp_path / "figures"
    text = cli("govern", BED, "--governor", "sequential", "--scenario", excessive, "--compare", "--plot", folder).stdout
    assert "Runs on the nominal loop" in text and "Runs on the whole bed, in emitted C: Short" in text
    assert "M1 needs 1000 N m at rest" in text
    for name in ("none", "sequential", "sequential modified"):
        assert name in text
    names = {f"{bed}-{what}.svg" for bed in ("nominal", "plant") for what in ("references", "torques", "controlled")}
    assert {path.name for path in folder.iterdir()} == names
    figure = tmp_path / "all.png"
    cli("govern", BED, "--governor", "sequential", "--scenario", excessive, "--plot", figure)
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_strict_refuses_what_a_machine_does_not_have(cli, excessive) -> None:
    found = cli.json("govern", BED, "--scenario", excessive, "--strict", code=2)
    (problem,) = found["problems"]
    assert problem["file"] == str(excessive) and problem["where"] == "references"
    assert "M1 needs 1000 N m at rest for diff_input_torque_ref = 1000 N m" in problem["what"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--governor", "sequential", "--horizon", "0.5 s"), "is for the optimal governor"),
        (("--horizon", "10 us"), "must be at least one step"),
        (("--horizon", "0.5 m"), "another dimension"),
        (("--horizon", "5 ms"), "too short"),
        (("--horizon", "0", "--solver", "hihgs"), 'did you mean "highs"'),
        (("--governor", "sequential", "--solver", "highs"), "checks the optimal governor"),
        (("--compare",), "needs a scenario"),
        (("--plot", "figures"), "there is no scenario"),
    ],
)
def test_options_that_do_not_fit(cli, options, said) -> None:
    found = cli.json("govern", BED, *options, code=2)
    assert any(said in f"{problem['what']}; {problem['remedy']}" for problem in found["problems"]), found


def test_a_loop_that_does_not_settle(cli, tmp_path) -> None:
    text = Path(BED).read_text(encoding="utf-8")
    bed = tmp_path / "bed.toml"
    bed.write_text(text.replace('torque_bandwidth = "20 rad/s"', 'torque_bandwidth = "2000 rad/s"'), encoding="utf-8")
    assert bed.read_text(encoding="utf-8") != text
    found = cli.json("govern", bed, "--governor", "optimal", code=2)
    assert "the closed loop does not settle" in found["problems"][0]["what"]


def test_a_bed_whose_ratio_changes_gets_the_best_governor_without_prediction(cli):
    text = cli("govern", "testbeds/transmission-fixed-gear.toml").stdout
    assert "Order of the sequential governor" in text
    assert "gears and gears" not in cli("govern", "testbeds/transmission.toml", "--governor", "optimal", code=2).stderr

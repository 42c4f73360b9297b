"""tune: JSON, text, all problems at once, and files that are written as they were."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

KEYS = {
    "name", "title", "locked", "free", "sample_time", "demands", "holds_as_wished", "found", "robust", "common",
    "wishes", "obstacle", "least_obstacle", "wished_checks", "held_checks", "gains", "helps", "notes", "evaluations",
    "changes", "written",
}  # fmt: skip
WISH_KEYS = {
    "key", "wanted", "wanted_text", "held", "held_text", "share", "alone", "reduced", "obstacle",
}  # fmt: skip
OBSTACLE_KEYS = {
    "kind", "machine", "value", "wanted", "frequency_hz", "holds", "controls", "mode", "phase_budget_deg",
}  # fmt: skip
BED = "testbeds/back-to-back.toml"
FAST = ("--damping-ratio", "12", "--delay-margin", "1 ms")


@pytest.fixture
def bed(cli, tmp_path) -> Path:
    """A copy of a bed that may be written to."""
    return Path(shutil.copy(BED, tmp_path / "bed.toml"))


def test_tune_keeps_its_contract(cli):
    found = cli.json("tune", BED, *FAST)
    assert set(found) == KEYS and set(found["wishes"][0]) == WISH_KEYS
    assert found["demands"] == {"delay_margin": 1e-3, "disk_margin": 0.05}
    assert (found["holds_as_wished"], found["found"], found["written"]) == (False, True, False)
    assert set(found["obstacle"]) == OBSTACLE_KEYS and not found["obstacle"]["holds"]
    kinds = ["stability", "proof", "disk", "common_delay", "delay", "delay"]
    assert [check["kind"] for check in found["held_checks"]] == kinds
    assert all(check["holds"] for check in found["held_checks"])
    reduced = {wish["key"]: wish for wish in found["wishes"]}["damping_ratio"]
    assert (
        reduced["reduced"] and 0.1 < reduced["share"] < 1 and reduced["alone"] == pytest.approx(reduced["share"], 0.02)
    )
    assert set(found["changes"]) == {"delay_margin", "damping_ratio"}
    assert set(found["gains"][0]) == {"name", "value", "unit", "intervals"}


def test_nothing_is_written_without_need(cli, bed):
    before = bed.read_bytes()
    text = cli("tune", bed, "--speed-bandwidth", "4 Hz").stdout
    assert "The wishes hold as they are." in text and "--write would write speed_bandwidth = 4 Hz" in text
    assert bed.read_bytes() == before
    assert "nothing to change" in cli("tune", bed, "--write").stdout
    assert bed.read_bytes() == before and len(list(bed.parent.iterdir())) == 1


def test_write_changes_what_has_to_change(cli, bed):
    newline = "\r\n"
    text = bed.read_text(encoding="utf-8")
    text = text.replace('torque_bandwidth = "15 rad/s"', "torque_bandwidth   =  '2.4 Hz'  # as \"before\"")
    bed.write_bytes(text.replace("\n", newline).encode())
    bed.chmod(0o640)
    arguments = ("--torque-bandwidth", "200 rad/s", "--delay-margin", "500 us", "--write")
    found = cli.json("tune", bed, *arguments)
    assert found["written"] is True and set(found["changes"]) == {"torque_bandwidth", "delay_margin"}
    held = {wish["key"]: wish for wish in found["wishes"]}["torque_bandwidth"]
    assert held["held_text"].endswith(" Hz") and held["reduced"]
    expected = text.replace("'2.4 Hz'", f"'{held['held_text']}'")
    ratio = next(line for line in text.splitlines() if line.startswith("damping_ratio"))
    expected = expected.replace(ratio, f'{ratio}\ndelay_margin = "500 us"')
    assert bed.read_bytes().decode() == expected.replace("\n", newline)
    assert bed.stat().st_mode & 0o777 == 0o640 and len(list(bed.parent.iterdir())) == 1
    again = cli.json("tune", bed, "--write")
    assert again["holds_as_wished"] and not again["written"]
    assert again["demands"]["delay_margin"] == 500e-6


def test_a_read_only_file_stays(cli, bed):
    before = bed.read_bytes()
    bed.chmod(0o444)
    (problem,) = cli.json("tune", bed, "--speed-bandwidth", "4 Hz", "--write", code=2)["problems"]
    assert "read-only" in problem["what"] and problem["file"] == str(bed)
    assert bed.read_bytes() == before


def test_a_link_stays_a_link(cli, bed):
    link = bed.with_name("link.toml")
    link.symlink_to(bed)
    cli("tune", link, "--speed-bandwidth", "4 Hz", "--write")
    assert link.is_symlink() and 'speed_bandwidth = "4 Hz"' in bed.read_text(encoding="utf-8")


def test_a_file_that_changed_meanwhile_stays(bed):
    from ptgen.errors import RunError
    from ptgen.loops.loop_tuning import tune, write_wishes
    from ptgen.project import Project

    project = Project.read(bed)
    found = tune(project, {"speed_bandwidth": "4 Hz"})
    bed.write_bytes(bed.read_bytes() + b"\n")
    with pytest.raises(RunError, match="changed since it was read"):
        write_wishes(project, found)
    assert "4 Hz" not in bed.read_text(encoding="utf-8")


def test_what_does_not_hold_once_written_is_not_written(bed):
    from dataclasses import replace

    from ptgen.errors import RunError
    from ptgen.loops.loop_tuning import tune, write_wishes
    from ptgen.project import Project

    project = Project.read(bed)
    before = bed.read_bytes()
    found = replace(tune(project), changes={"torque_bandwidth": "3000 rad/s"})
    with pytest.raises(RunError, match="file was left as it was"):
        write_wishes(project, found)
    assert bed.read_bytes() == before and len(list(bed.parent.iterdir())) == 1


def test_all_problems_of_the_options_are_told_at_once(cli):
    result = cli.json(
        "tune", "testbeds/differential.toml", "--speed-bandwidth", "30", "--torque-bandwidth", "5 Hz",
        "--torque-rise-time", "-3 ms", "--damping-ratio", "much", "--delay-margin", "3 rad", "--disk-margin", "2.5",
        "--lock", "diff.slip", "--free", "clutch", code=2,
    )  # fmt: skip
    places = [problem["where"] for problem in result["problems"]]
    assert sorted(places) == [
        "--damping-ratio", "--delay-margin", "--disk-margin", "--free", "--lock", "--speed-bandwidth",
        "--torque-rise-time", "--torque-rise-time",
    ]  # fmt: skip
    assert any("contradicts --torque-bandwidth" in problem["what"] for problem in result["problems"])
    assert all(problem["remedy"] for problem in result["problems"])


def test_wishes_that_no_machine_can_have_are_problems(cli):
    problems = cli.json("tune", "testbeds/clutch-rig.toml", "--damping-ratio", "1", "--torque-rise-time", "1 s", code=2)
    assert [problem["where"] for problem in problems["problems"]] == ["--torque-rise-time", "--damping-ratio"]


def test_locked_elements_are_taken(cli):
    found = cli.json("tune", "testbeds/clutch-rig.toml", "--lock", "clutch1")
    assert found["locked"] == ["clutch1"] and "clutch2" in found["free"]


def test_bad_demands_in_the_file_are_problems(cli, bed):
    bed.write_text(bed.read_text().replace("damping_ratio = 1.0", 'disk_margin = 2\ndelay_margin = "3 m"'))
    problems = cli.json("tune", bed, code=2)["problems"]
    assert [problem["where"] for problem in problems] == ["control.delay_margin", "control.disk_margin"]

"""analyse: verdict, tables, JSON, figure, and all problems of its options at once."""

from __future__ import annotations

import pytest

KEYS = {
    "name", "title", "controller", "structure", "experimental", "locked", "free", "parameters", "sample_time", "stable",
    "verdict", "continuous", "loops", "margins", "disk_mode", "delay_mode", "poles", "levers", "algebraic_loop",
    "coupling",
}  # fmt: skip


def test_analyse_keeps_its_contract(cli):
    found = cli.json("analyse", "testbeds/back-to-back.toml")
    assert set(found) == KEYS
    assert found["stable"] is True and found["continuous"] == "stable" and found["experimental"] == []
    assert [(loop["machine"], loop["controls"]) for loop in found["loops"]] == [("M1", "torque"), ("M2", "speed")]
    for loop in found["loops"]:
        assert loop["gain_up"] > 1 > loop["gain_down"] >= 0
        assert 0 < loop["phase_deg"] < 180 and loop["delay"]["time"] > 0
        assert set(loop["phase_budget_deg"]) == {"sampling", "dead time", "inverter lag"}
    disk = found["margins"]["disk"]
    assert 0 < disk["alpha"] < 2 and disk["gain_down"] * disk["gain_up"] == pytest.approx(1)
    assert found["margins"]["common_delay"]["time"] < max(loop["delay"]["time"] for loop in found["loops"])
    causes = found["coupling"]["causes"]
    assert [c["cause"] for c in causes] == [
        "rounding", "sampling", "dead_time", "lag", "neglected", "everything", "conventional",
    ]  # fmt: skip
    errors = [c["rms"]["speed.M2"]["torque.M1"] for c in causes]
    assert errors[0] < 1e-9 and errors[-1] > 100 * errors[-2] > 0
    assert not any(pole["unstable"] for pole in found["poles"])


def test_analyse_prints_the_verdict_first(cli):
    text = cli("analyse", "testbeds/back-to-back.toml").stdout
    lines = text.splitlines()
    assert "decoupling controller" in lines[0] and "is stable" in lines[1]
    headings = ("Loops", "All machines at once", "Poles", "Loop through measured torques", "Couplings")
    places = [text.index(f"\n{heading}") for heading in headings]
    assert places == sorted(places)
    assert "speed_bandwidth" in text or "damping_ratio" in text


def test_less_damping_of_the_conventional_controller_is_seen(cli):
    found = cli.json("analyse", "testbeds/back-to-back.toml", "--controller", "conventional")
    assert min(pole["damping_ratio"] for pole in found["poles"] if pole["frequency_hz"] < 30) < 0.1
    assert found["coupling"]["causes"][-1]["cause"] == "conventional"


def test_a_parameter_can_make_the_loop_unstable(cli):
    arguments = ("analyse", "testbeds/back-to-back.toml", "--set", "M1_torque_integral_gain=3000")
    found = cli.json(*arguments)
    assert found["stable"] is False and found["parameters"] == {"M1_torque_integral_gain": 3000}
    assert found["loops"] == [] and found["margins"] is None
    unstable = [pole for pole in found["poles"] if pole["unstable"]]
    assert unstable and unstable[0]["mode"]["strained"]
    assert "UNSTABLE" in cli(*arguments).stdout


def test_a_flange_behind_a_gearbox_reads_back(cli):
    """(5.13): M2 feeds back the share of the gearbox's inertia in what its torque accelerates."""
    found = cli.json("analyse", "testbeds/differential-gearboxes.toml", "--set", "load_compensation=0.5")
    full = found["algebraic_loop"]
    assert full["stable"] is True
    assert full["gains"]["M2"] == pytest.approx(full["spectral_radius"])
    from ptgen.project import Project

    parts = Project.read("testbeds/differential-gearboxes.toml").testbed.components
    gear, rotor = parts["gearbox2"].inertia, parts["M2"].inertia
    expected = {0.5 * gear / (gear + rotor), 0.5 * gear / parts["gearbox2"].ratio ** 2
                / (gear / parts["gearbox2"].ratio ** 2 + rotor)}  # fmt: skip
    assert any(full["gains"]["M2"] == pytest.approx(value, rel=1e-6) for value in expected)


def test_locked_elements_change_the_loop(cli):
    free = cli.json("analyse", "testbeds/differential.toml")
    locked = cli.json("analyse", "testbeds/differential.toml", "--lock", "diff.limited_slip")
    assert (free["locked"], locked["locked"]) == ([], ["diff.limited_slip"])
    assert free["margins"]["disk"]["alpha"] != pytest.approx(locked["margins"]["disk"]["alpha"], rel=1e-3)


def test_file_decides_what_is_locked(cli):
    arguments = ("analyse", "testbeds/centre-differential-locked.toml")
    assert cli.json(*arguments)["locked"] == ["diff.limited_slip"]
    assert cli.json(*arguments, "--free", "diff.limited_slip")["locked"] == []


def test_all_problems_of_the_options_are_told_at_once(cli):
    result = cli.json(
        "analyse", "testbeds/differential.toml", "--lock", "diff.slip", "--free", "clutch", "--set", "M1_dampin=3",
        "--set", "M1_damping", "--set", "M2_speed_gain=-1", code=2,
    )  # fmt: skip
    places = [problem["where"] for problem in result["problems"]]
    assert sorted(places) == ["--free", "--lock", "--set", "M1_dampin", "M2_speed_gain"]
    remedies = " ".join(problem["remedy"] for problem in result["problems"])
    assert "M1_damping" in remedies and "diff.limited_slip" in remedies


def test_a_bad_file_ends_with_code_2(cli, tmp_path):
    bad = tmp_path / "bad.toml"
    bad.write_text("[testbed]\nname = 1\n")
    assert cli.json("analyse", bad, code=2)["problems"]
    assert cli.json("analyse", tmp_path / "none.toml", code=2)["problems"]
    assert cli.json("analyse", "testbeds/back-to-back.toml", "--plot", "x.gif", code=2)["problems"]


@pytest.mark.parametrize("suffix", [".svg", ".png"])
def test_analyse_draws(cli, tmp_path, suffix):
    target = tmp_path / f"loop{suffix}"
    cli("analyse", "testbeds/clutch-rig.toml", "--plot", target)
    assert target.stat().st_size > 20_000

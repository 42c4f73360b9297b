"""check, show, derive, modal and schema on the shipped beds."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp

BEDS = ("back-to-back", "differential", "differential-gearboxes")


@pytest.mark.parametrize("bed", BEDS)
def test_check_tells_that_the_bed_is_sound(cli, bed):
    found = cli.json("check", f"testbeds/{bed}.toml")
    assert found["ok"] is True
    assert found["name"] == bed.replace("-", "_")
    assert found["title"]
    assert found["components"] == len(found["chains"]) if "chains" in found else found["components"] >= 5
    assert "sound" in cli("check", f"testbeds/{bed}.toml").stdout


@pytest.mark.parametrize("bed", BEDS)
def test_derive_keeps_its_contract(cli, bed):
    found = cli.json("derive", f"testbeds/{bed}.toml")
    assert {"states", "order", "inputs", "frictions"} <= set(found["model"])
    assert {"states", "order", "rules", "parameters"} <= set(found["reduced"])
    assert found["model"]["order"] == len(found["model"]["states"])
    assert found["reduced"]["order"] == len(found["reduced"]["states"])
    assert found["total_relative_degree"] == sum(found["relative_degree"])
    assert found["internal_dynamics_order"] == found["reduced"]["order"] - found["total_relative_degree"]
    assert len(found["relative_degree"]) == len(found["outputs"])
    size = len(found["outputs"])
    assert [len(row) for row in found["decoupling_matrix"]] == [size] * size
    for text in [*(entry for row in found["decoupling_matrix"] for entry in row), *found["law"].values()]:
        sp.sympify(text)
    assert list(found["law"]) == found["model"]["inputs"]


def test_derive_gives_the_law_of_the_source(cli):
    found = cli.json("derive", "testbeds/differential.toml")
    names = "M1_damping M1_speed M2_speed M3_speed M1_inertia_estimate diff_ratio v_M1 v_M2 v_M3 M2_inertia M3_inertia"
    d, w1, w2, w3, inertia, i, v1, v2, v3, I2, I3 = sp.symbols(names)
    wanted = v1 + inertia * i / 2 * (v2 / I2 + v3 / I3) - d * (w1 - i / 2 * (w2 + w3))
    assert sp.expand(sp.sympify(found["law"]["M1"]) - wanted) == 0
    assert found["law"]["M2"] in ("v_M2 - flange2_torque", "-flange2_torque + v_M2")


@pytest.mark.parametrize("bed", BEDS)
def test_derive_proves_stability(cli, bed):
    found = cli.json("derive", f"testbeds/{bed}.toml")["stability"]
    decoupling = found["settings"]["decoupling"]
    assert decoupling["verdict"] == "stable"
    assert sum(factor["degree"] for factor in decoupling["factors"]) == len(found["states"]) == len(found["matrix"])
    assert sum(factor["degree"] for factor in found["polynomial"]) == len(found["states"])
    for factor in decoupling["factors"]:
        assert all(condition["value"] > 0 for condition in factor["conditions"])
        assert all(pole["re"] < 0 for pole in factor["poles"])
        assert all(gain["admissible"] for gain in factor["gains"])
        zeros = np.roots(factor["values"])
        poles = [complex(pole["re"], pole["im"]) for pole in factor["poles"]]
        np.testing.assert_allclose(np.poly(poles), np.poly(zeros), rtol=1e-9)
        for text in factor["coefficients"]:
            sp.sympify(text)


def test_derive_gives_the_ranges_of_the_source(cli):
    """(5.115b) of the bed that it is stated for."""
    factors = cli.json("derive", "testbeds/back-to-back.toml")["stability"]["settings"]["decoupling"]["factors"]
    torque = next(factor for factor in factors if factor["loops"] == ["torque loop of M1"])
    ranges = {gain["gain"]: gain for gain in torque["gains"]}
    integral = ranges["M1_torque_integral_gain"]
    d, k, inertia = sp.symbols("M1_damping M1_torque_gain M1_inertia_estimate")
    assert sp.simplify(sp.sympify(integral["upper"]) - d * (1 + k) / inertia) == 0
    assert (integral["lower"], ranges["M1_torque_gain"]["lower"]) == ("0", "-1")
    text = cli("derive", "testbeds/back-to-back.toml").stdout
    assert "0 < M1_torque_integral_gain < M1_damping·(M1_torque_gain + 1)/M1_inertia_estimate" in text
    assert "real poles up to M2_speed_gain²/(4·M2_inertia)" in text


@pytest.mark.parametrize("bed", BEDS)
def test_derive_as_text_has_all_sections(cli, bed):
    text = cli("derive", f"testbeds/{bed}.toml").stdout
    headings = (
        "States",
        "Equations of motion",
        "Reduction",
        "Reduced model",
        "Relative degrees",
        "Decoupling matrix",
        "Law",
        "Testing torque from sensors",
        "Gains",
        "Stability in continuous time",
        "Closed loop",
    )
    places = [text.index(f"\n{heading}\n{'=' * len(heading)}") for heading in headings]
    assert places == sorted(places)
    assert "active damping" in text and "load torque compensation" in text


def test_derive_as_latex_and_json_exclude_each_other(cli):
    assert cli.json("derive", "testbeds/differential.toml", "--latex", code=2)["problems"][0]["where"] == "--latex"
    assert r"\begin{align*}" in cli("derive", "testbeds/differential.toml", "--latex").stdout


def test_modal_locks_elements(cli):
    free = cli.json("modal", "testbeds/differential.toml")
    locked = cli.json("modal", "testbeds/differential.toml", "--lock", "diff.limited_slip", "--free", "diff.loss")
    assert (free["locked"], free["free"]) == ([], ["diff.loss", "diff.limited_slip"])
    assert (locked["locked"], locked["free"]) == (["diff.limited_slip"], ["diff.loss"])
    assert len(locked["modes"]) == len(free["modes"]) - 1
    for document in (free, locked):
        frequencies = [mode["frequency_hz"] for mode in document["modes"]]
        assert frequencies[0] == 0 and frequencies == sorted(frequencies)
        assert all(max(map(abs, mode["shape"].values())) == 1 for mode in document["modes"])
    assert "21.867 Hz" in cli("modal", "testbeds/differential.toml").stdout


def test_modal_names_the_known_elements(cli):
    result = cli.json("modal", "testbeds/differential.toml", "--lock", "diff.slip", "--free", "clutch", code=2)
    assert [problem["where"] for problem in result["problems"]] == ["--lock", "--free"]
    assert all("diff.loss" in problem["remedy"] for problem in result["problems"])
    assert all("diff.limited_slip" in problem["remedy"] for problem in result["problems"])


def test_modal_refuses_to_lock_what_is_free(cli):
    arguments = ("--lock", "diff.loss", "--free", "diff.loss")
    (problem,) = cli.json("modal", "testbeds/differential.toml", *arguments, code=2)["problems"]
    assert "locked and free" in problem["what"]


def test_modal_of_a_bed_without_friction(cli):
    (problem,) = cli.json("modal", "testbeds/back-to-back.toml", "--lock", "x", code=2)["problems"]
    assert "none" in problem["remedy"]


@pytest.mark.parametrize("bed", BEDS)
def test_show_lists_every_component(cli, bed):
    document = cli.json("show", f"testbeds/{bed}.toml")
    text = cli("show", f"testbeds/{bed}.toml").stdout
    for name in document["components"]:
        assert f"── {name} " in text
    assert "rpm" in text and "kN m/rad" in text and "assumed" in text


@pytest.mark.parametrize("suffix", [".svg", ".png", ".pdf"])
def test_show_draws(cli, tmp_path, suffix):
    target = tmp_path / f"bed{suffix}"
    cli("show", "testbeds/differential.toml", "-o", target)
    assert target.stat().st_size > 5000
    assert [path.name for path in tmp_path.iterdir()] == [target.name]


def test_schema_is_the_schema_of_bed_files(cli):
    import json

    schema = json.loads(cli("schema").stdout)
    assert set(schema["properties"]) == {"testbed", "components", "control", "reduction", "governor"}


def test_figures_are_the_same_every_time(cli, tmp_path):
    for name in ("one.svg", "two.svg"):
        cli("modal", "testbeds/differential.toml", "--plot", tmp_path / name)
    first, second = (Path(tmp_path / name).read_bytes() for name in ("one.svg", "two.svg"))
    assert first == second
    assert b"<dc:date>" not in first

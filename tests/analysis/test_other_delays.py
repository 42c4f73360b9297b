"""Filters of sensors, the time of the computation and ideal inverters in the analysis of the loop."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ptgen.analysis.limits import NearModes, energy_shares, phase_budget
from ptgen.analysis.margins import common_delay_margin
from ptgen.loops.loop_analysis import analyse, loop_family
from ptgen.mechanism.modes import modes
from ptgen.project import Project
from ptgen.report.loop_verdict import verdict


@pytest.fixture(scope="module")
def variants(root: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Project]:
    """The bed back-to-back with other drives and sensors."""
    text = (root / "testbeds" / "back-to-back.toml").read_text(encoding="utf-8")
    lag = 'inverter = { model = "lag", dead_time = "100 us", time_constant = "250 us" }'
    assert text.count(lag) == 2
    ideal = text.replace(lag, 'inverter = { model = "ideal" }')
    slow = text.replace('sample_time = "100 us"', 'sample_time = "100 us"\ncomputation_delay = "60 us"')
    filtered = text.replace(lag, lag + '\nsensor = { time_constant = "2 ms" }')
    folder = tmp_path_factory.mktemp("beds")
    found = {}
    for name, content in {"ideal": ideal, "computation": slow, "filters": filtered, "shipped": text}.items():
        path = folder / f"{name}.toml"
        path.write_text(content, encoding="utf-8")
        found[name] = Project.read(path)
    return found


def margin(project: Project) -> float:
    return common_delay_margin(loop_family(project, project.model)).time


def test_time_of_the_computation_is_taken_from_the_delay_margin(variants):
    """A delay is a delay, whoever causes it."""
    assert margin(variants["computation"]) == pytest.approx(margin(variants["shipped"]) - 60e-6, abs=1e-9)


@pytest.mark.parametrize("name", ["ideal", "computation", "filters"])
def test_delay_margin_separates_stable_from_unstable(name, variants):
    project = variants[name]
    family = loop_family(project, project.model)
    time = common_delay_margin(family).time
    for share, stable in ((0.5, True), (0.99, True), (1.01, False)):
        poles = np.linalg.eigvals(family.delayed(None, dict.fromkeys(family.machines, share * time)).closed())
        assert bool(abs(poles).max() < 1) is stable, share


def test_ideal_inverters_leave_the_most_delay(variants):
    """Dead time and lag together are 350 us, as long as the lag is short against the swing."""
    gained = margin(variants["ideal"]) - margin(variants["shipped"])
    assert gained == pytest.approx(350e-6, rel=0.05)


def test_filters_have_their_row_and_their_phase(variants):
    found = analyse(variants["filters"])
    assert [cause.name for cause in found.causes][4] == "sensors"
    torque_loop = found.loops[0]
    expected = np.degrees(np.arctan(2 * np.pi * torque_loop.critical_hz * 2e-3))
    assert torque_loop.budget.degrees["sensor filters"] == pytest.approx(expected)
    assert torque_loop.budget.largest == "sensor filters"
    assert found.margins.delay.time < margin(variants["shipped"])


def test_phase_budget_adds_up():
    budget = phase_budget({"sample_time": 1e-4, "M1_inverter_dead_time": 2e-4}, "M1", 100.0)
    assert budget.degrees == {"sampling": pytest.approx(1.8), "dead time": pytest.approx(7.2)}
    assert budget.total == pytest.approx(9.0) and budget.largest == "dead time"


def test_shares_of_energy_are_those_of_two_masses_on_a_shaft(projects):
    """Flanges of 380 kN m/rad beside a shaft of 33.5 kN m/rad: strain goes with the compliance."""
    project = projects["back_to_back"]
    elastic = [mode for mode in modes(project.model) if mode.frequency_hz > 0]
    strain, kinetic = energy_shares(project.model, elastic[0])
    compliance = {"shaft1": 1 / 33.5, "flange1": 1 / 380, "flange2": 1 / 380}
    for name, value in compliance.items():
        assert strain[name] == pytest.approx(value / sum(compliance.values()), rel=0.02)
    assert kinetic["M1.shaft"] == pytest.approx(0.5, rel=0.02)
    assert sum(strain.values()) == pytest.approx(1) and sum(kinetic.values()) == pytest.approx(1)


def test_a_held_machine_has_the_mode_of_a_clamped_rotor(projects):
    """With M2 held M1 swings alone against the shaft: lower than both together by a factor of sqrt 2."""
    project = projects["back_to_back"]
    found = NearModes(project.model, ("M2",)).near(12.0)
    both = next(mode for mode in modes(project.model) if mode.frequency_hz > 0)
    assert found is not None and found.held == ("M2",) and found.moving == "M1"
    assert found.frequency_hz == pytest.approx(both.frequency_hz / np.sqrt(2), rel=0.01)
    assert NearModes(project.model).near(12.0).held == ()


def test_conventional_controller_is_told_from_decoupling_by_its_coupling(projects):
    found = {name: analyse(projects["differential"], controller=name) for name in ("decoupling", "conventional")}
    by_cause = {cause.name: cause.coupling for cause in found["decoupling"].causes}
    own = found["conventional"].causes[-1].coupling
    np.testing.assert_allclose(by_cause["conventional"].rms, own.rms, rtol=1e-9)
    assert by_cause["rounding"].worst("torque", "speed")[0] < 1e-9
    ratio = by_cause["conventional"].worst("torque", "speed")[0] / by_cause["everything"].worst("torque", "speed")[0]
    assert ratio > 100


def test_pairs_of_speeds_are_moved_and_followed_as_pairs(root, tmp_path):
    """The torque reacts to the mean of both speeds as to both together, and hardly to their difference."""
    text = (root / "testbeds" / "differential.toml").read_text(encoding="utf-8")
    path = tmp_path / "pair.toml"
    path.write_text(text + '\nspeed_pairs = { rear = ["M2", "M3"] }\n', encoding="utf-8")
    coupling = {c.name: c.coupling for c in analyse(Project.read(path), controller="conventional").causes}[
        "conventional"
    ]
    single = (
        analyse(Project.read(root / "testbeds" / "differential.toml"), controller="conventional").causes[-1].coupling
    )
    moved = dict(zip(coupling.references, coupling.rms[coupling.references.index("torque.M1")], strict=True))
    alone = dict(zip(single.references, single.rms[single.references.index("torque.M1")], strict=True))
    assert set(moved) == {"torque.M1", "speed_mean.rear", "speed_difference.rear"}
    assert moved["speed_mean.rear"] == pytest.approx(alone["speed.M2"] + alone["speed.M3"], rel=0.02)
    assert moved["speed_difference.rear"] < 0.02 * moved["speed_mean.rear"]


def test_an_individual_law_and_an_experimental_one_are_called_so(projects, root, tmp_path):
    assert analyse(projects["centre_differential"]).law == "individual"
    text = (root / "testbeds" / "back-to-back.toml").read_text(encoding="utf-8")
    file = tmp_path / "bed.toml"
    file.write_text(text.replace("[control]\n", '[control]\nspeed_control = "super_twisting"\n'), encoding="utf-8")
    found = analyse(Project.read(file))
    assert (found.law, found.experimental) == ("decoupling", ("M2",))
    assert "experimental" in verdict(found)[-1]

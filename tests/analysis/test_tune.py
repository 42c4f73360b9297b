"""Tuning: what holds is left alone, what is too fast comes back held, tight, and true for the emitted code."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from test_delays_of_emitted_code import DelayedBed

import ptgen
from ptgen.analysis.disk_margin import disk_margin
from ptgen.analysis.frequency import FrequencyResponse, frequency_grid
from ptgen.analysis.margins import common_delay_margin, delay_margins, loop_margins
from ptgen.errors import RunError
from ptgen.loops.loop_analysis import loop_family
from ptgen.loops.loop_tuning import LoopTuning, tune, write_wishes
from ptgen.loops.tuning_wishes import OPTIONS, wished
from ptgen.project import Project
from ptgen.report.loop_tuning_text import tuning_text

TOO_FAST = {"speed_bandwidth": "5000 rad/s", "torque_rise_time": "10 ms"}
DELAY, DISK = 300e-6, 0.05  # the defaults: three sample times, 5 %


@pytest.fixture(scope="module")
def reduced(projects: dict[str, Project]) -> LoopTuning:
    """The bed back-to-back with wishes that are far too fast."""
    return tune(projects["back_to_back"], TOO_FAST)


def redesigned(project: Project, wishes: Mapping[str, float]) -> Project:
    """Return the bed with other wishes, designed anew."""
    return Project(replace(project.testbed, tuning=project.testbed.tuning.model_copy(update=dict(wishes))))


def margins(project: Project) -> tuple[float, float] | None:
    """Return smallest delay margin and disk margin of the emitted blocks; None if the loop is unstable."""
    family = loop_family(project, project.model)
    if abs(np.linalg.eigvals(family.delayed().closed())).max() > 1 + 1e-9:
        return None
    loop, steps = family.loop()
    delays = [common_delay_margin(family).time, *(found.delay.time for found in loop_margins(family))]
    return min(delays), disk_margin(FrequencyResponse(loop, steps), frequency_grid(loop)).alpha


@pytest.mark.parametrize("bed", ["back_to_back", "clutch_rig", "transmission_fixed_gear"])
def test_wishes_that_hold_are_left_alone(projects: dict[str, Project], bed: str) -> None:
    project = projects[bed]
    found = tune(project)
    assert found.holds_as_wished and found.is_found and not found.changes
    assert [result.held for result in found.wishes] == [
        getattr(project.testbed.tuning, result.wish.key) for result in found.wishes
    ]
    roles = project.testbed.roles
    keys = (["speed_bandwidth"] if roles.speed else []) + (
        ["torque_bandwidth", "damping_ratio"] if roles.torque else []
    )
    assert [result.wish.key for result in found.wishes] == keys
    assert (found.demands.delay, found.demands.disk) == pytest.approx((DELAY, DISK))
    parameters = {signal.name: signal.value for signal in project.controller.parameters}
    assert {gain.name: gain.value for gain in found.gains} == {gain.name: parameters[gain.name] for gain in found.gains}


def test_too_fast_wishes_come_back_held(projects: dict[str, Project], reduced: LoopTuning) -> None:
    assert not reduced.holds_as_wished and reduced.is_found and reduced.is_robust
    held = {result.wish.key: result.held for result in reduced.wishes}
    assert held["damping_ratio"] == projects["back_to_back"].testbed.tuning.damping_ratio
    assert {result.wish.key for result in reduced.wishes if result.is_reduced} == {
        "speed_bandwidth",
        "torque_bandwidth",
    }
    for less in (1.0, 0.97, 0.9):  # there and below, for a controller that is designed anew
        values = {key: less * value if key != "damping_ratio" else value for key, value in held.items()}
        found = margins(redesigned(projects["back_to_back"], values))
        assert found is not None and found[0] >= DELAY and found[1] >= DISK


def test_more_of_each_reduced_wish_is_not_held(projects: dict[str, Project], reduced: LoopTuning) -> None:
    held = {result.wish.key: result.held for result in reduced.wishes}
    for result in reduced.wishes:
        if not result.is_reduced:
            continue
        project = redesigned(projects["back_to_back"], {**held, result.wish.key: 1.05 * result.held})
        found = margins(project)
        refuted = project.design.gains.torque_integral["M1"] >= project.design.gains.damping["M1"] / 5.0  # (5.115b)
        assert found is None or found[0] < DELAY or found[1] < DISK or refuted
        assert result.obstacle is not None and not result.obstacle.check.holds
        assert result.obstacle.mode is not None and result.obstacle.budget is not None
        assert set(result.obstacle.budget.degrees) == {"sampling", "dead time", "inverter lag"}


def test_text_tells_what_is_in_the_way(reduced: LoopTuning) -> None:
    text = " ".join(str(part) for part in tuning_text(reduced))
    assert "The wishes do not hold" in text and "The best that was found: speed_bandwidth" in text
    assert "More speed_bandwidth is not held" in text and "The drive takes" in text and "of its strain" in text
    assert "--write would write speed_bandwidth = " in text


def test_gains_lie_where_the_proof_allows(reduced: LoopTuning) -> None:
    allowed = [gain for gain in reduced.gains if gain.intervals]
    assert {"M1_damping", "M1_torque_integral_gain", "M2_speed_gain"} <= {gain.name for gain in allowed}
    assert all(any(low < gain.value < high for low, high in gain.intervals) for gain in allowed)


@pytest.mark.compile
def test_emitted_code_takes_the_demanded_delay(
    projects: dict[str, Project], reduced: LoopTuning, monkeypatch: pytest.MonkeyPatch
) -> None:
    held = {result.wish.key: result.held for result in reduced.wishes}
    bed = DelayedBed(redesigned(projects["back_to_back"], held), monkeypatch)
    machines = bed.family.machines
    for delayed in (machines, *((name,) for name in machines)):
        swing = bed.swing(delayed, 0.95 * DELAY, 150_000)
        assert swing[-1] < 0.01 * swing.max(), delayed
    delayed, margin = min(bed.margins, key=lambda item: item[1].time)
    assert DELAY <= margin.time < 1.05 * DELAY
    rate = float(np.log(abs(bed.pole(delayed, 1.05 * margin.time, margin.frequency_hz))))
    swing = bed.swing(delayed, 1.05 * margin.time, int(4 / rate))  # no longer, or the supervision stops it
    assert rate > 0 and swing[-1] / swing[9] == pytest.approx(np.exp(2), rel=0.1)


def test_margins_that_are_large_enough_are_told_on_the_safe_side(projects: dict[str, Project]) -> None:
    family = loop_family(projects["differential"], projects["differential"].model)
    for (names, exact), (same, quick) in zip(delay_margins(family), delay_margins(family, enough=DELAY), strict=True):
        assert names == same
        assert abs(quick.time - exact.time) < family.sample_time
    loop, steps = family.loop()
    response, omega = FrequencyResponse(loop, steps), frequency_grid(loop)
    exact_disk, quick_disk = disk_margin(response, omega), disk_margin(response, omega, enough=DISK)
    assert DISK < quick_disk.alpha <= exact_disk.alpha * 1.001


def test_a_margin_that_no_wish_gives_is_explained(projects: dict[str, Project]) -> None:
    """The free disk between the clutches swings almost undamped once the rotors are held."""
    found = tune(projects["clutch_rig"], {"disk_margin": 0.3})
    assert not found.is_found and not found.changes
    assert found.obstacle is not None and found.obstacle.check.kind == "disk" == found.least.check.kind
    assert [(x.name, x.value) for x in found.helps] == [("load_compensation", 0.0)]
    text = " ".join(str(part) for part in tuning_text(found))
    assert "it is not the bandwidths that limit" in text and "load_compensation of the controller at 0" in text
    with pytest.raises(RunError, match="nothing was written"):
        write_wishes(projects["clutch_rig"], found)


def test_demands_and_wishes_of_the_file(projects: dict[str, Project]) -> None:
    bed = projects["back_to_back"].testbed
    tuning = bed.tuning.model_copy(update={"delay_margin": 2e-3, "disk_margin": 0.2, "damping_ratio": 0.5})
    found = tune(Project(replace(bed, tuning=tuning)))
    assert (found.demands.delay, found.demands.disk) == (2e-3, 0.2)
    assert found.wishes[-1].wish.wanted == 0.5


def test_rise_time_becomes_a_bandwidth(projects: dict[str, Project]) -> None:
    asked, problems = wished(projects["back_to_back"], {"torque_rise_time": "100 ms"})
    assert asked is not None and not problems
    (torque,) = [wish for wish in asked.wishes if wish.key == "torque_bandwidth"]
    lag = np.exp(-torque.wanted * np.array([0.1]))  # a first-order lag goes from 0.9 to 0.1 of what is missing
    assert lag == pytest.approx(1 / 9, rel=0.02)
    assert "rise time of 100 ms" in asked.notes[0]


def test_python_interface(root: Path) -> None:
    bed = ptgen.load(root / "testbeds" / "back-to-back.toml")
    found = ptgen.tune(bed, speed_bandwidth="5 Hz", damping_ratio=0.9)
    assert found.changes == {"speed_bandwidth": "5 Hz", "damping_ratio": 0.9}
    assert set(OPTIONS) >= set(found.changes)

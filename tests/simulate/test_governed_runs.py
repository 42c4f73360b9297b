"""Runs with governors: what they are judged by, the nominal loop, and what scenarios ask for at rest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ptgen.errors import ControlError
from ptgen.governor.shaping import governor_signals
from ptgen.loops.governed_run import Choice, Followed, excess, set_points
from ptgen.loops.governor_check import check_solver
from ptgen.loops.governor_study import choices_of, governed_project, study_governors
from ptgen.loops.nominal_run import nominal_run
from ptgen.loops.stationary_demand import beyond_at_rest, machine_references, stationary_limits
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario
from ptgen.testbed.profile import Profile
from ptgen.testbed.scenario import Scenario
from ptgen.units import from_si

RPM = np.pi / 30


def scenario(duration: float, **references: Profile) -> Scenario:
    named = {key.replace("_", ".", 1): profile for key, profile in references.items()}
    return Scenario("short", "short.toml", "", duration, 1e-3, named, title="Short")


def steps(*points: tuple[float, float]) -> Profile:
    return Profile(tuple(t for t, _ in points), tuple(v for _, v in points), "steps")


@pytest.fixture(scope="module")
def governed(projects) -> Project:
    return projects["differential_governed"]


@pytest.fixture(scope="module")
def event() -> Scenario:
    """The torque rises while the speeds fall and M1 is at its limit: what is still to come is not seen."""
    speeds = steps((0.0, 0.0), (0.05, 400 * RPM), (0.5, 0.0))
    return scenario(0.7, torque_M1=steps((0.0, 0.0), (0.05, -450.0), (0.55, -200.0)), speed_M2=speeds, speed_M3=speeds)


def test_no_excess_has_no_time() -> None:
    found = excess("M1", np.arange(3.0), np.array([1.0, -9.0, 9.0]), np.full(3, 9.0), 1.0)
    assert (found.most, found.at, found.lasting, found.limit) == (0.0, None, 0.0, 9.0)


def test_excess_follows_a_limit_that_varies() -> None:
    found = excess("M1", np.arange(4.0), np.array([5.0, -8.0, 8.0, 8.0]), np.array([9.0, 5.0, 7.0, 9.0]), 0.5)
    assert (found.most, found.at, found.lasting, found.limit) == (3.0, 1.0, 1.0, 5.0)


def test_set_points_of_steps_and_ramps() -> None:
    time = 0.1 * np.arange(100)
    wanted = np.where(time < 1, 0.0, np.where(time < 5, 10.0, np.clip(10 - 10 * (time - 5), 0, 10)))
    followed = Followed("M2", "M2_speed_ref", "rad/s", "M2_speed", wanted)
    shaped = np.where((time > 0.95) & (time < 1.45), 5.0, wanted)
    output = np.where(time < 2, 0.0, wanted)
    up, down = set_points(followed, time, output, shaped)
    assert (up.start, up.target, down.start, down.target) == (0.0, 10.0, 10.0, 0.0)
    assert up.at == pytest.approx(1.0) and up.shaped_after == pytest.approx(0.5)
    assert up.reached_after == pytest.approx(1.0)
    assert down.at == pytest.approx(5.1) and down.reached_after == pytest.approx(0.9)
    (never, _) = set_points(followed, time, np.zeros(100), None)
    assert never.shaped_after is None and never.reached_after is None


def test_set_point_that_is_left_again_is_not_reached() -> None:
    time, wanted = np.arange(6.0), np.array([0.0, 1.0, 1.0, 1.0, 1.0, 1.0])
    followed = Followed("M2", "r", "rad/s", "y", wanted)
    (found,) = set_points(followed, time, np.array([0.0, 1.0, 1.0, 0.5, 1.0, 1.0]), None)
    assert found.reached_after == 3.0


def test_choices(governed) -> None:
    settings = governed.testbed.governor.model_copy(update={"kind": "sequential"})
    optimal = settings.model_copy(update={"kind": "optimal"})
    assert [choice.kind for choice in choices_of(settings, compare=True)] == [
        "none",
        "sequential",
        "sequential_modified",
    ]
    assert len(choices_of(optimal, compare=True)) == 7
    assert len(choices_of(optimal.model_copy(update={"horizon": 0.0}), compare=True)) == 5
    assert choices_of(optimal, compare=False) == (Choice("optimal", None, 1.0, 100.0),)
    assert Choice("optimal", 0.5, 1, 100).label == "optimal, 1 : 100, horizon 0.5 s"


def test_stationary_limits(governed) -> None:
    limits = stationary_limits(governed, governed.prediction, governed.testbed.governor)
    assert limits.largest(0) == (pytest.approx(0.95 * 0.98 * 930.0), "M1")
    np.testing.assert_allclose(limits.torque[:, 0], [1.0, -0.955, -0.955], atol=1e-9)
    np.testing.assert_allclose(limits.speed, [[0, 0.955, 0.955], [0, 1, 0], [0, 0, 1]], atol=1e-9)
    assert limits.envelope(np.array([0.0, 377.0, 0.0]))[1] == pytest.approx(3700 * 188.4956 / 377, rel=1e-5)


def test_what_the_law_keeps_for_damping_is_not_there_at_rest(projects) -> None:
    project = projects["differential"]  # its law keeps a tenth
    limits = stationary_limits(project, project.prediction, project.testbed.governor)
    np.testing.assert_allclose(limits.torque_share, [0.9 * 0.98, 0.95 * 0.98, 0.95 * 0.98])


def test_scenario_beyond_the_torque_of_a_machine(governed, root: Path) -> None:
    course = load_scenario(root / "scenarios" / "differential-governed-field-weakening.toml", governed.testbed)
    limits = stationary_limits(governed, governed.prediction, governed.testbed.governor)
    (found,) = beyond_at_rest(governed, course, limits)
    assert (found.machine, found.quantity, found.at) == ("M1", "torque", 0.1)
    assert found.needed == pytest.approx(1000.0) and found.available == pytest.approx(865.83)
    text = found.problem().what
    assert "M1 needs 1000 N m at rest for diff_input_torque_ref = 1000 N m, 134.2 N m more than the 865.8 N m" in text


def test_two_speeds_within_their_limits_drive_a_third_machine_beyond(governed) -> None:
    both = steps((0.0, 0.0), (0.1, 5500 * RPM))
    course = scenario(1.0, torque_M1=steps((0.0, 0.0)), speed_M2=both, speed_M3=both)
    limits = stationary_limits(governed, governed.prediction, governed.testbed.governor)
    (found,) = beyond_at_rest(governed, course, limits)
    assert (found.machine, found.quantity) == ("M1", "speed")
    assert from_si(found.needed, "rad/s", "rpm") == pytest.approx(1.91 * 5500)
    assert "M1 turns at 10505 rpm" in found.problem().what


def test_less_torque_in_the_range_of_field_weakening(governed) -> None:
    fast = steps((0.0, 0.0), (0.1, 4500 * RPM))
    course = scenario(1.0, torque_M1=steps((0.0, 0.0), (0.1, 850.0)), speed_M2=fast, speed_M3=fast)
    limits = stationary_limits(governed, governed.prediction, governed.testbed.governor)
    found = beyond_at_rest(governed, course, limits)
    assert [(entry.machine, entry.quantity) for entry in found] == [("M1", "torque")]
    assert found[0].limit == pytest.approx(930 * 6684 / (1.91 * 4500), rel=1e-4)


def test_references_of_pairs_are_taken_apart(root: Path, tmp_path: Path) -> None:
    bed = tmp_path / "bed.toml"
    text = (root / "testbeds" / "differential.toml").read_text(encoding="utf-8")
    bed.write_text(text + '\nspeed_pairs = { axle = ["M2", "M3"] }\n', encoding="utf-8")
    named = {"torque.M1": steps((0.0, 50.0)), "speed_mean.axle": steps((0.0, 100.0))}
    named |= {"speed_difference.axle": steps((0.0, 10.0))}
    found = machine_references(Project.read(bed), Scenario("s", "s", "", 1.0, 1e-3, named), np.zeros(1))
    assert found.tolist() == [[50.0, 105.0, 95.0]]


def test_nominal_run_is_the_predicted_loop(governed, event) -> None:
    """On the reduced plant the emitted controller asks for the torques that are predicted for the same references."""
    library, watched = build(governed), {s.name: s.unit for s in governor_signals(governed.controller)}
    parameters = {"governor": 2.0}
    recording = nominal_run(governed, event, library, parameters, watched)
    loop = governed.prediction
    shaped = np.column_stack([recording.signals[f"{name}_shaped"] for name in loop.references])
    commands = np.column_stack([recording.signals[f"{name}_torque_ref"] for name in loop.machines])
    demands = np.column_stack([recording.signals[f"governor_demand_{name}"] for name in loop.machines])
    np.testing.assert_allclose(demands, commands, atol=1e-6)
    x, predicted = np.zeros(len(loop.A)), np.zeros_like(commands)
    for step, reference in enumerate(shaped):
        predicted[step] = loop.C @ x + loop.D @ reference
        x = loop.A @ x + loop.B @ reference
    np.testing.assert_allclose(commands, predicted, atol=1e-4 * np.abs(commands).max())


def test_only_the_modification_and_prediction_keep_the_limit(governed, event) -> None:
    settings = governed.testbed.governor.model_copy(update={"kind": "optimal"})
    choices = [Choice("none"), Choice("sequential"), Choice("sequential_modified"), Choice("optimal")]
    study = study_governors(governed, settings, event, choices)
    beyond = {
        (run.choice.kind, run.bed): {entry.machine: entry.most for entry in run.beyond_limit} for run in study.runs
    }
    assert beyond["none", "nominal"]["M1"] > 300
    assert 20 < beyond["sequential", "nominal"]["M1"] < 100
    for kind in ("sequential_modified", "optimal"):
        assert set(beyond[kind, "nominal"].values()) == {0.0}
    assert beyond["sequential_modified", "plant"] == {"M1": 0.0, "M2": 0.0, "M3": 0.0}
    assert beyond["optimal", "plant"]["M1"] < 0.03 * 930
    predicted = next(run for run in study.runs if run.choice.kind == "optimal" and run.bed == "nominal")
    assert max(predicted.solver.slack.values()) <= 1.1 * settings.removal * 930  # what rows that were left out can cost
    assert [step.machine for step in study.order] == ["M2", "M3", "M1"]
    assert study.order[2].earlier == ("M2_speed_ref", "M3_speed_ref")
    kept = [entry.kept for entry in study.shorter]
    assert kept == sorted(kept) and study.shorter[0].steps == 0
    assert study.shorter[0].binding.max() > 1 > study.shorter[-1].binding.max()
    for run in study.runs:
        for followed in run.followed:
            shaped = run.recording.signals.get(followed.shaped)
            if run.choice.kind in ("sequential", "optimal"):
                low, high = followed.wanted.min(), followed.wanted.max()
                assert shaped is not None and low - 1e-9 <= shaped.min() and shaped.max() <= high + 1e-9


def test_a_torque_step_alone_is_not_held_back(governed) -> None:
    """The damping torque is large while the torque rises; it must not count as if it stayed."""
    still = steps((0.0, 0.0))
    course = scenario(0.2, torque_M1=steps((0.0, 0.0), (0.05, 800.0)), speed_M2=still, speed_M3=still)
    settings = governed.testbed.governor.model_copy(update={"kind": "optimal"})
    study = study_governors(governed, settings, course, [Choice("optimal")])
    for run in study.runs:
        (point,) = (point for point in run.set_points if point.signal == "diff_input_torque_ref")
        assert point.shaped_after is not None and point.shaped_after < 0.003
        assert max(run.solver.slack.values()) == 0.0 and set(run.solver.statuses) <= {0, 1}


def test_rows_that_were_left_out_are_kept(governed) -> None:
    settings = governed.testbed.governor.model_copy(update={"kind": "optimal"})
    study = study_governors(governed, settings)
    assert study.constraints is not None and study.runs == ()
    found = check_solver(study.constraints, settings, "highs", situations=8)
    assert found.situations == 8 and found.unsolved == 0
    assert found.violation <= 1e-9 and found.loss <= 2 * settings.removal
    with pytest.raises(ControlError, match="did you mean"):
        check_solver(study.constraints, settings, "hihgs")


def test_beds_without_a_governor_in_their_file_can_be_governed(projects) -> None:
    project = projects["back_to_back"]
    settings = project.testbed.governor.model_copy(update={"kind": "sequential"})
    course = scenario(0.2, torque_M1=steps((0.0, 0.0)), speed_M2=steps((0.0, 0.0), (0.05, 50.0)))
    key = next(iter(project.design.controller.references))
    assert key in ("torque.M1", "torque.M2")
    names = dict(course.references)
    if key == "torque.M2":
        names = {"torque.M2": names["torque.M1"], "speed.M1": names["speed.M2"]}
    study = study_governors(project, settings, replace(course, references=names), [Choice("sequential")])
    assert len(study.runs) == 2 and study.constraints is None
    assert governed_project(project, project.testbed.governor) is project


def test_a_governor_that_the_bed_does_not_allow(projects) -> None:
    project = projects["transmission_fixed_gear"]
    settings = project.testbed.governor.model_copy(update={"kind": "optimal"})
    with pytest.raises(ControlError, match="changes at run time"):
        governed_project(project, settings)


def test_single_precision_shapes_the_same_references(governed, event) -> None:
    """Rounding moves decisions by a step now and then; limits are kept, references agree on the average."""
    runs = [simulate(governed, event, library=build(governed, precision=p)) for p in ("double", "float")]
    for name in ("M2_speed_ref_shaped", "M3_speed_ref_shaped", "diff_input_torque_ref_shaped"):
        one, other = (run.signals[name] for run in runs)
        assert np.abs(one - other).mean() < 1e-3 * np.abs(one).max()
    assert runs[1].signals["governor_status"].max() <= 2
    assert np.abs(runs[1].signals["governor_demand_M1"]).max() < 930.0


def test_speeds_together_keep_the_machine_that_they_drive(governed) -> None:
    """Each within its own limit, both would drive M1 to 11 900 rpm; it keeps its 9000 rpm (7.19)."""
    both = {"speed_M2": steps((0.0, 0.0), (0.05, 5500 * RPM)), "speed_M3": steps((0.0, 0.0), (0.05, 7000 * RPM))}
    course = scenario(12.0, torque_M1=steps((0.0, 0.0), (0.05, 100.0)), **both)
    run = simulate(governed, course, parameters={"governor": 2.0})
    assert np.abs(run.signals["M1_speed"]).max() < 9000 * RPM
    assert run.signals["diff_input_torque_ref_shaped"][-1] == pytest.approx(100.0)
    ratio = run.signals["M2_speed_ref_shaped"][-1] / run.signals["M3_speed_ref_shaped"][-1]
    assert 0.7 < ratio < 1.0


def test_a_reserve_that_leaves_nothing_is_refused(governed) -> None:
    settings = governed.testbed.governor.model_copy(update={"kind": "sequential", "torque_reserve": 900.0})
    with pytest.raises(ControlError, match=r"torque_reserve: 900 N m .* of M1.*less than 883.5 N m"):
        governed_project(governed, settings).controller  # noqa: B018

"""Closed loops with the event-driven plant: the same drives, profiles and signals as with the emitted one."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from clutched_beds import CLUTCHED
from hypothesis import given
from hypothesis import strategies as st

from ptgen.errors import RunError
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.simulate.drives import Commands, course, kinks, value_at
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario

H = 1e-4


@pytest.fixture(scope="module")
def clutched(tmp_path_factory: pytest.TempPathFactory) -> Project:
    path = tmp_path_factory.mktemp("bed") / "bed.toml"
    path.write_text(CLUTCHED, encoding="utf-8")
    return Project.read(path)


def both(project: Project, scenario: Scenario, **options) -> tuple[Recording, Recording]:
    return simulate(project, scenario, **options), simulate(project, scenario, method="events", **options)


def largest_difference(emitted: Recording, events: Recording, name: str) -> float:
    return float(np.abs(emitted.signals[name] - events.signals[name]).max())


@pytest.mark.compile
@pytest.mark.parametrize("dead_time", [0.0, 1e-4, 1.37e-4, 2.9e-4])
def test_without_friction_both_plants_are_exact(dead_time: float, projects: dict[str, Project]) -> None:
    """So drives, profiles and signals are the same, or the recordings would differ."""
    torque = Profile((0.0, 10 * H, 20 * H), (0.0, 800.0, -300.0), "steps")
    speed = Profile((0.0, 30 * H), (0.0, 20.0), "lines")
    references = {"torque.M1": torque, "speed.M2": speed}
    scenario = Scenario("case", "", "", 60 * H, 3 * H, references)
    parameters = {f"{machine}_inverter_dead_time": dead_time for machine in ("M1", "M2")}
    emitted, events = both(projects["back_to_back"], scenario, parameters=parameters)
    assert list(events.signals) == list(emitted.signals)
    assert np.array_equal(events.time, emitted.time) and (events.steps, events.units) == (60, emitted.units)
    assert np.abs(emitted.signals["M1_torque"]).max() > 50
    for name, values in emitted.signals.items():
        assert largest_difference(emitted, events, name) < 1e-8 * (1 + np.abs(values).max()), name


@pytest.mark.compile
@pytest.mark.parametrize("delay", ["20 us", "137 us"])
def test_low_passes_and_computation_delay_are_those_of_both_plants(delay: str, root: Path, tmp_path: Path) -> None:
    sensor = 'sensor = { time_constant = "150 us" }\n'
    text = (root / "testbeds" / "back-to-back.toml").read_text(encoding="utf-8")
    text = text.replace('type = "machine"\n', f'type = "machine"\n{sensor}')
    text = text.replace('type = "torque_flange"\n', f'type = "torque_flange"\n{sensor}')
    text = text.replace("[testbed]\n", f'[testbed]\ncomputation_delay = "{delay}"\n')
    text = text.replace("[control]\n", '[control]\ntorque_rate = "100 MN m/s"\n')  # the steps stay steps
    file = tmp_path / "bed.toml"
    file.write_text(text, encoding="utf-8")
    torque = Profile((0.0, 10 * H, 20 * H), (0.0, 800.0, -300.0), "steps")
    references = {"torque.M1": torque, "speed.M2": Profile((0.0, 30 * H), (0.0, 20.0), "lines")}
    emitted, events = both(Project.read(file), Scenario("case", "", "", 60 * H, 3 * H, references))
    assert list(events.signals) == list(emitted.signals)
    lag = emitted.signals["flange1_torque_true"] - emitted.signals["flange1_torque"]
    assert np.abs(lag).max() > 1, "the low pass is there"
    for name, values in emitted.signals.items():
        assert largest_difference(emitted, events, name) < 1e-8 * (1 + np.abs(values).max()), name


def test_commands_pass_envelope_and_dead_time(clutched: Project) -> None:
    model = clutched.plant_model
    torque = model.inputs[0]
    values = {**model.values, torque.drive.dead_time: 2.25 * H}
    commands = Commands(torque, model, values, H)
    assert commands.switch == pytest.approx(0.25 * H)
    speed = evaluate_matrix(model.velocity_rows["M1.shaft"], values)[0]
    for factor, reference, limited in ((0.5, 1e6, 500.0), (2.0, -1e6, -250.0), (-4.0, 1e6, 125.0), (-4.0, 7.0, 7.0)):
        velocities = speed * factor * 100 * np.pi / (speed @ speed)
        commands.push(reference, velocities)
        for _ in range(2):
            commands.push(0.0, velocities)
        assert commands.acting(0.3 * H) == pytest.approx(limited)
        commands.push(0.0, velocities)
        assert commands.acting(0.2 * H) == pytest.approx(limited)
        assert commands.acting(0.3 * H) == 0.0


@pytest.mark.compile
def test_a_clutch_that_closes(clutched: Project) -> None:
    """Between both there is what the step does to friction: order two, and one step at the moment of sticking."""
    references = {"speed.M1": Profile((0.0,), (2.0,), "steps"), "speed.M2": Profile((0.0,), (0.0,), "lines")}
    closing = Profile((80.3 * H, 120.7 * H), (0.0, 1.0), "lines")
    scenario = Scenario("case", "", "", 250 * H, H, references, {"clutch1": closing})
    emitted, events = both(clutched, scenario)
    assert emitted.signals["clutch1_speed"].max() > 0.3
    assert emitted.signals["clutch1_speed"][-1] == events.signals["clutch1_speed"][-1] == 0.0
    for name, most in {"M1_speed": 2e-4, "M2_speed": 2e-4, "flange1_torque": 0.5, "clutch1_actuation": 0.0}.items():
        assert largest_difference(emitted, events, name) <= most, name


@pytest.mark.compile
def test_progress_errors_and_interruption(clutched: Project) -> None:
    references = {"speed.M1": Profile((0.0,), (0.0,), "lines"), "speed.M2": Profile((0.0,), (0.0,), "lines")}
    scenario = Scenario("case", "", "", 20 * H, 10 * H, references)
    shares: list[float] = []
    simulate(clutched, scenario, method="events", progress=shares.append)
    assert shares == sorted(shares) and shares[-1] == 1.0
    with pytest.raises(RunError, match='did you mean "clutch1_capacity"'):
        simulate(clutched, scenario, method="events", parameters={"clutch1_capacit": 1.0})
    with pytest.raises(RunError, match="clutch1_static"):
        simulate(clutched, scenario, method="events", parameters={"clutch1_static": -1.0})

    def stop(share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simulate(clutched, scenario, method="events", progress=stop)


# --- profiles over time

TIMES = st.lists(st.integers(0, 1000), min_size=1, max_size=8, unique=True).map(sorted)
POINTS = TIMES.flatmap(
    lambda times: st.tuples(st.just(times), st.lists(st.floats(-5, 5), min_size=len(times), max_size=len(times)))
)


@given(POINTS, st.floats(-1, 1001))
def test_lines_are_those_of_numpy(points: tuple[list[int], list[float]], time: float) -> None:
    times, values = points
    profile = Profile(tuple(map(float, times)), tuple(values), "lines")
    assert value_at(profile, time) == pytest.approx(np.interp(time, times, values), abs=1e-12)


@given(POINTS, st.sampled_from(["lines", "steps"]), st.floats(0, 990), st.floats(0.1, 20), st.floats(0.001, 0.999))
def test_pieces_between_kinks_make_up_the_profile(points, shape, start: float, length: float, share: float) -> None:
    profile = Profile(tuple(map(float, points[0])), tuple(points[1]), shape)
    inside = kinks(profile, start, start + length)
    assert inside == sorted(inside) and all(start < time < start + length for time in inside)
    for begin, end in pairwise([start, *inside, start + length]):
        piece, time = course(profile, begin, end), begin + share * (end - begin)
        got = piece(time) if callable(piece) else piece
        assert got == pytest.approx(value_at(profile, time), abs=1e-6)


def test_a_jump_at_the_edge_of_a_piece_belongs_to_the_next(tmp_path: Path) -> None:
    profile = Profile((0.0, 0.3), (0.0, 1.0), "steps")
    before = 3 * 0.1  # a little more than 0.3
    assert kinks(profile, 0.2, before) == [] and kinks(profile, before, 0.4) == []
    assert course(profile, 0.2, before) == 0.0 and course(profile, before, 0.4) == 1.0
    slightly_early = 0.3 - 1e-16
    assert course(profile, slightly_early, 0.4) == 1.0

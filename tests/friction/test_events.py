"""The event-driven reference against closed forms, energy balances and other methods of integration."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from reference_problems import (
    Bench,
    Problem,
    at_velocities,
    clutch,
    coupled_clutches,
    differential,
    gear_set,
    overrunning,
    rattling,
    scalar,
    two_clutches,
    two_clutches_crossing,
)
from scipy.integrate import quad, solve_ivp

from ptgen.errors import RunError
from ptgen.friction.events import EventDriven, EventState
from ptgen.mechanism.model import Model, evaluate_matrix


def run(problem: Problem, until: float | None = None) -> EventState:
    simulation = EventDriven(problem.model)
    end = problem.duration if until is None else until
    start = simulation.initial(problem.initial)
    return simulation.advance(start, end, problem.torques, problem.actuations, problem.breakpoints)


def changes(state: EventState) -> list[tuple[str, int, int]]:
    return [(t.element, t.before, t.after) for t in state.transitions]


def velocity(model: Model, state: EventState, name: str) -> float:
    return float(evaluate_matrix(model.velocity_rows[name], model.values)[0] @ state.x[: len(model.coordinates)])


@pytest.mark.parametrize("make", [scalar, clutch, two_clutches, two_clutches_crossing])
def test_transitions_in_closed_form(make) -> None:
    problem = make()
    found = run(problem).transitions
    assert [(t.element, t.before, t.after) for t in found] == [known[1:] for known in problem.transitions]
    for transition, known in zip(found, problem.transitions, strict=True):
        assert transition.time == pytest.approx(known[0], abs=1e-12)


def test_scalar_system_follows_its_parabolas() -> None:
    problem = scalar()
    simulation = EventDriven(problem.model)
    state = simulation.initial(problem.initial)
    for time in np.arange(1, 41) / 10:
        state = simulation.advance(state, float(time), problem.torques, breakpoints=problem.breakpoints)
        x = (
            1 + 0.5 * time
            if time <= 0.5
            else 1.25 - 1.5625 * (time - 0.5)
            if time <= 1.3
            else 0.0
            if time <= 2
            else 1.5625 * (time - 2) ** 2
            if time <= 2.5
            else max(0.0, 0.390625 * (3.5 - time))
        )
        assert simulation.friction_velocities(state)[0] == pytest.approx(x, abs=1e-11)
        if 1.3 < time < 2:
            assert simulation.friction_velocities(state)[0] == 0.0
            assert state.friction_torque[0] == pytest.approx(problem.torques(time - 1e-9)[0], abs=1e-7)


def test_two_clutch_chain_follows_its_pieces() -> None:
    problem = two_clutches()
    model, end = problem.model, run(problem)
    # from 0.6 s to 0.75 s all three move with the mean of the momentum, 10 + 2 J2 + J3 over 4 kg m^2
    x1, x2 = 0.5 + 0.35 * 16 / 3, 2.5
    common = (10 + 2 * (10 - x1) + (10 - x1 - x2)) / 4
    at_break = run(problem, 0.75)
    for name in ("J1", "J2", "J3"):
        assert velocity(model, at_break, name) == pytest.approx(common, abs=1e-12)
    # then J1' = T1 - 4; J2 and J3 together 3 a = 4 - T1 until 0.9 s, and 2 J2' = 4 - 8, J3' = 8 - T1 from then on
    drive = lambda t: 20 * (t - 0.65) ** 2  # noqa: E731  integral of T1
    J1 = common + drive(1.0) - drive(0.75) - 4 * 0.25
    both = common + (4 * 0.15 - drive(0.9) + drive(0.75)) / 3
    J2, J3 = both - 2 * 0.1, both + 8 * 0.1 - drive(1.0) + drive(0.9)
    for name, value in {"J1": J1, "J2": J2, "J3": J3}.items():
        assert velocity(model, end, name) == pytest.approx(value, abs=1e-11)


def test_locked_clutch_carries_what_is_left_of_both_torques() -> None:
    """Section 3.5: locked, T_c = (T_ci / I_ci + T_co / I_co) / (1 / I_ci + 1 / I_co)."""
    end = run(clutch())
    assert end.friction_torque[0] == pytest.approx((30 / 0.2 + 20 / 0.5) / (1 / 0.2 + 1 / 0.5), abs=1e-11)


def oscillator(**friction: object) -> Model:
    """Return a body of 0.5 kg m^2 on a shaft of 200 N m/rad to a wall, with a bearing."""
    bench = Bench("oscillator", {"J": 0.5}).machine("J").shaft("shaft", {"J": 1}, stiffness=200.0)
    return bench.friction("bearing", {"J": 1}, **friction).model()  # type: ignore[arg-type]


def test_half_swings_lose_the_same_amplitude() -> None:
    """Dry friction takes 2 T / c from the amplitude of each half swing, and does not change its period."""
    simulation = EventDriven(oscillator(coulomb=2.0))
    start = simulation.initial(twists=[0.105])
    end = simulation.advance(start, 1.0, np.zeros(1))
    half = math.pi / math.sqrt(200.0 / 0.5)
    turns = [t.time for t in end.transitions]
    # amplitudes 105, 85, 65, 45, 25 mrad: 5 mrad is inside the band of 10 mrad where friction holds the shaft
    np.testing.assert_allclose(turns, [0.0, *(half * k for k in range(1, 6))], atol=1e-12)
    assert changes(end)[-1] == ("bearing", -1, 0)
    assert end.x[1] == pytest.approx(-0.005, abs=1e-14) and end.x[0] == 0.0
    for k, time in enumerate(turns[1:5], start=1):
        state = simulation.advance(start, time, np.zeros(1))
        assert abs(state.x[1]) == pytest.approx(0.105 - 0.02 * k, abs=1e-13)


def test_breaks_away_at_rest_limit_and_goes_on_with_kinetic_torque() -> None:
    model = Bench("body", {"J": 2.0}).machine("J").friction("bearing", {"J": 1}, coulomb=3.0, static=5.0).model()
    simulation = EventDriven(model)
    ramp = lambda t: np.array([-10.0 * t])  # noqa: E731
    end = simulation.advance(simulation.initial([0.0]), 0.8, ramp)
    assert changes(end) == [("bearing", 0, -1)]
    assert end.transitions[0].time == pytest.approx(0.5, abs=1e-13)
    assert end.x[0] == pytest.approx(-(5 * (0.8**2 - 0.5**2) - 3 * 0.3) / 2, abs=1e-12)


def test_step_of_torque_breaks_away_at_once() -> None:
    model = Bench("body", {"J": 2.0}).machine("J").friction("bearing", {"J": 1}, coulomb=3.0, static=5.0).model()
    simulation = EventDriven(model)
    end = simulation.advance(
        simulation.initial([0.0]), 1.0, lambda t: np.array([6.0 if t >= 0.25 else 4.9]), breakpoints=(0.25,)
    )
    assert [(t.time, t.after) for t in end.transitions] == [(0.25, 1)]
    assert end.x[0] == pytest.approx(1.5 * 0.75, abs=1e-12)


def test_break_away_can_pull_another_element_along() -> None:
    """The drop from the limit at rest to the kinetic torque of one clutch overloads the next one, at the same time."""
    bench = Bench("row", {"J1": 1.0, "J2": 1.0}).machine("J1").machine("J2")
    bench.friction("brake1", {"J1": 1}, coulomb=1.0, static=10.0)
    bench.friction("clutch", {"J1": 1, "J2": -1}, coulomb=4.0, static=5.0)
    simulation = EventDriven(bench.model())
    # held: brake1 carries T1 + T2. When it drops from 10 to 1 N m, the clutch needs (T1 - 1 - T2) / 2 = 5.5 > 5 N m
    end = simulation.advance(simulation.initial(), 0.3, lambda t: np.array([11.0, -2.0 + 10 * t]))
    assert end.transitions[0].time == end.transitions[1].time == pytest.approx(0.1, abs=1e-13)
    assert changes(end) == [("brake1", 0, 1), ("clutch", 0, 1)]


def test_stribeck_deceleration_to_rest() -> None:
    """Time to rest is the integral of J dw / T(w); the capacity rises towards its value at rest."""
    J, coulomb, static, speed, w0 = 0.3, 2.0, 3.5, 1.7, 20.0
    bench = Bench("body", {"J": J}).machine("J")
    model = bench.friction("bearing", {"J": 1}, coulomb, static=static, stribeck_speed=speed, viscous=0.04).model()
    end = EventDriven(model)
    end_state = end.advance(end.initial([w0]), 3.0, np.zeros(1))
    law = lambda w: coulomb + (static - coulomb) * math.exp(-w / speed) + 0.04 * w  # noqa: E731
    expected = quad(lambda w: J / law(w), 0.0, w0, epsabs=1e-13, epsrel=1e-13)[0]
    assert changes(end_state) == [("bearing", 1, 0)]
    assert end_state.transitions[0].time == pytest.approx(expected, abs=1e-12)


def test_saturated_slope_actuation_and_ripple() -> None:
    """Every factor of the law against an integration by another method, between transitions."""
    bench = Bench("body", {"J": 0.4}).machine("J")
    bench.friction(
        "brake",
        {"J": 1},
        2.0,
        static=2.6,
        stribeck_speed=1.5,
        viscous=0.02,
        saturated=(0.05, 12.0),
        ripple=(0.3, 3, 0.4),
        actuated=True,
    )
    simulation = EventDriven(bench.model())
    mu = lambda t: 0.6 + 0.3 * math.sin(9 * t)  # noqa: E731
    end = simulation.advance(simulation.initial([20.0]), 1.5, np.array([0.3]), {"brake": mu})

    def rate(t: float, y: np.ndarray) -> list[float]:
        w, angle = y
        dry = (1 + 0.3 * math.sin(3 * angle + 0.4)) * (2.0 + 0.6 * math.exp(-w / 1.5))
        return [(0.3 - mu(t) * (dry + 0.05 * min(w, 12.0) + 0.02 * w)) / 0.4, w]

    other = solve_ivp(rate, (0, 1.5), [20.0, 0.0], "LSODA", rtol=1e-12, atol=1e-12)
    assert not end.transitions and other.y[0, -1] > 0.5
    np.testing.assert_allclose([end.x[0], end.angles[0]], other.y[:, -1], atol=1e-8)


def test_falling_actuation_releases_a_clutch() -> None:
    """A clutch that holds 6 of 10 N m lets go when its actuation falls below 0.6."""
    bench = Bench("pair", {"J1": 1.0, "J2": 1.0}).machine("J1").machine("J2")
    model = bench.friction("clutch", {"J1": 1, "J2": -1}, coulomb=10.0, actuated=True).model()
    simulation = EventDriven(model)
    end = simulation.advance(simulation.initial(), 0.9, np.array([6.0, -6.0]), {"clutch": lambda t: 1 - t})
    assert end.transitions[0].time == pytest.approx(0.4, abs=1e-13)
    # w' = 12 - 20 (1 - t)
    assert simulation.friction_velocities(end)[0] == pytest.approx(10 * 0.5**2, abs=1e-11)


def test_freewheel_overruns_and_catches() -> None:
    """It carries any torque in one direction; in the other one it slips with its small drag."""
    bench = Bench("pair", {"J1": 1.0, "J2": 3.0}).machine("J1").machine("J2")
    model = bench.friction("freewheel", {"J1": 1, "J2": -1}, coulomb=0.3, one_way=True).model()
    simulation = EventDriven(model)
    start = simulation.initial(at_velocities(model, {"J1": 0.0, "J2": 0.0}))
    torque = lambda t: np.array([400.0 if t < 0.2 else -20.0 if t < 0.4 else 400.0, 0.0])  # noqa: E731
    driven = simulation.advance(start, 0.1, torque)
    assert driven.mode[0] == 0 and driven.friction_torque[0] == pytest.approx(300.0, abs=1e-10)
    end = simulation.advance(start, 1.0, torque, breakpoints=(0.2, 0.4))
    # overruns from 0.2 s with w' = -20 + 0.3 + 0.1, and from 0.4 s with w' = 400.4: caught after 0.2 * 19.6 / 400.4 s
    assert changes(end) == [("freewheel", 0, -1), ("freewheel", -1, 0)]
    np.testing.assert_allclose([t.time for t in end.transitions], [0.2, 0.4 + 0.2 * 19.6 / 400.4], atol=1e-12)
    with pytest.raises(RunError, match="positive velocity"):
        simulation.initial(at_velocities(model, {"J1": 1.0, "J2": 0.0}))


@pytest.mark.parametrize("gap", [0.01, 0.0])
def test_backlash_keeps_energy(gap: float) -> None:
    """Two bodies that rattle in the gap of an undamped shaft, under no torque, lose neither energy nor momentum."""
    bench = Bench("rattle", {"J1": 0.7, "J2": 1.3}).machine("J1").machine("J2")
    model = bench.shaft("shaft", {"J1": 1, "J2": -1}, stiffness=5000.0, backlash=gap).model()
    simulation = EventDriven(model)
    state = simulation.initial(at_velocities(model, {"J1": 2.0, "J2": -1.0}))
    energy = simulation.energy(state)
    assert energy == pytest.approx(0.5 * (0.7 * 4 + 1.3))
    state = simulation.advance(state, 0.5, np.zeros(2))
    assert simulation.energy(state) == pytest.approx(energy, rel=1e-10)
    assert velocity(model, state, "J1") * 0.7 + velocity(model, state, "J2") * 1.3 == pytest.approx(0.1, abs=1e-12)
    # half a period outside, then through the whole gap with the relative velocity of 3 rad/s
    half = math.pi / math.sqrt(5000.0 * (1 / 0.7 + 1 / 1.3))
    passage = gap / 3
    times = [t.time for t in state.transitions]
    if gap == 0.0:
        assert not times
        return
    ends = itertools.accumulate(itertools.cycle([half, passage]), initial=passage / 2)
    np.testing.assert_allclose(times, list(itertools.islice(ends, len(times))), atol=1e-11)
    assert len(times) > 20


def test_backlash_damping_acts_from_the_end_of_the_gap() -> None:
    """(3.5): the damping torque is there at once when the gap closes."""
    bench = Bench("rattle", {"J1": 1.0, "J2": 1.0}).machine("J1").machine("J2")
    model = bench.shaft("shaft", {"J1": 1, "J2": -1}, stiffness=1000.0, damping=4.0, backlash=0.02).model()
    simulation = EventDriven(model)
    start = simulation.initial(at_velocities(model, {"J1": 1.0, "J2": 0.0}))
    state = simulation.advance(start, 0.01 + 1e-9, np.zeros(2))
    assert [(t.time, t.after) for t in state.transitions] == [(pytest.approx(0.01, abs=1e-13), 1)]
    assert state.contact_torque[0] == pytest.approx(4.0, abs=1e-5)


def loaded_pair(load: float, **more: object) -> Model:
    """Return two bodies, rigidly connected; the bearing of the second is loaded by the torque between them."""
    bench = Bench("pair", {"J1": 0.5, "J2": 1.5}).machine("J1").machine("J2").rigid("coupling", "J1", "J2")
    bench.friction("bearing", {"J2": 1}, coulomb=1.0, load=(load, "coupling.left"), **more)  # type: ignore[arg-type]
    return bench.model()


@pytest.mark.parametrize("load", [0.2, 0.9])
def test_load_that_depends_on_the_friction_that_it_makes(load: float) -> None:
    """J1 a = T1 - L, J2 a = L - T and T = 1 + k |L|: linear for each sign of L."""
    model = loaded_pair(load)
    simulation = EventDriven(model)
    for drive in (40.0, -40.0):
        state = simulation.advance(simulation.initial([100.0]), 1e-3, np.array([drive, 0.0]))
        sign = 1.0 if drive > 0 else -1.0
        equations = np.array([[0.5, 1.0, 0.0], [1.5, -1.0, 1.0], [0.0, -load * sign, 1.0]])
        acceleration, L, T = np.linalg.solve(equations, [drive, 0.0, 1.0])
        assert state.x[0] == pytest.approx(100.0 + 1e-3 * acceleration, abs=1e-11)
        assert state.friction_torque[0] == pytest.approx(T, rel=1e-12)
        assert simulation.signals(state)["coupling.left"] == pytest.approx(L, rel=1e-12)


def test_load_changes_its_sign_while_slipping() -> None:
    """The kink of |L| is found, so that the integration keeps its accuracy across it."""
    model = loaded_pair(0.4)
    simulation = EventDriven(model)
    drive = lambda t: 30.0 * math.cos(7 * t)  # noqa: E731
    state = simulation.advance(simulation.initial([50.0]), 1.0, lambda t: np.array([drive(t), 0.0]))

    def acceleration(t: float, y: np.ndarray) -> list[float]:
        for sign in (1.0, -1.0):
            a, L, _ = np.linalg.solve([[0.5, 1, 0], [1.5, -1, 1], [0, -0.4 * sign, 1]], [drive(t), 0.0, 1.0])
            if L * sign >= 0:
                return [float(a)]
        raise AssertionError("no sign fits")

    other = solve_ivp(acceleration, (0, 1), [50.0], "DOP853", rtol=1e-12, atol=1e-12, max_step=1e-3)
    assert state.x[0] == pytest.approx(other.y[0, -1], abs=1e-8)


def test_limit_at_rest_with_load() -> None:
    """At rest the bearing takes T1, and the coupling carries it: held up to T1 = static + k T1."""
    model = loaded_pair(0.25, static=3.0)
    simulation = EventDriven(model)
    state = simulation.advance(simulation.initial([0.0]), 1.0, lambda t: np.array([8 * t, 0.0]))
    assert state.transitions[0].time == pytest.approx(3.0 / 0.75 / 8, abs=1e-12)


def test_load_without_solution_is_an_error() -> None:
    """A load that makes more friction than it overcomes has no solution; it must not hang."""
    model = loaded_pair(5.0)
    simulation = EventDriven(model)
    with pytest.raises(RunError, match="bearing"):
        simulation.advance(simulation.initial([0.0]), 0.1, np.array([0.0, -8.0]))


def test_limit_at_rest_below_the_kinetic_torque_does_not_hang() -> None:
    """Such a law has no solution where it can be held in motion only at rest; that is said, and not tried for ever."""
    model = Bench("body", {"J": 1.0}).machine("J").friction("bearing", {"J": 1}, coulomb=2.0, static=1.0).model()
    simulation = EventDriven(model)
    with pytest.raises(RunError, match=r"bearing: made \d+ events within 1 ns at t = 0.2 s"):
        simulation.advance(simulation.initial([0.1]), 1.0, np.array([1.5]))


def test_overrun_freewheel_against_smooth_friction() -> None:
    """The freewheel as a stiff one-sided damper, the bearing as a steep ``tanh``."""
    problem = overrunning()
    simulation = EventDriven(problem.model, {"engine_friction_static": 6.0})
    state = simulation.advance(simulation.initial(problem.initial), 1.75, problem.torques)
    starter, engine = (velocity(problem.model, state, name) for name in ("starter", "engine"))

    def rate(t: float, v: np.ndarray) -> list[float]:
        w = v[0] - v[1]
        freewheel = 1e5 * w if w > 0 else 0.4 * math.tanh(1e5 * w)
        bearing = 6.0 * math.tanh(1e4 * v[1]) + 0.02 * v[1]
        T = problem.torques(t)
        return [(T[0] - freewheel) / 0.1, (T[1] + freewheel - bearing) / 0.4]

    smooth = solve_ivp(rate, (0, 1.75), [0.0, 0.0], "Radau", rtol=1e-8, atol=1e-10, max_step=1e-2).y[:, -1]
    assert {-1, 0} == {t.after for t in state.transitions if t.element == "freewheel"}
    np.testing.assert_allclose([starter, engine], smooth, atol=2e-3)


def test_rattling_against_smooth_friction() -> None:
    """Gap ends, reversals and standstill together; the shaft is (3.5) as it stands, the bearing a steep ``tanh``."""
    problem = rattling()
    simulation = EventDriven(problem.model, {"bearing_static": 4.0})
    state = simulation.advance(simulation.initial(problem.initial), 0.6, problem.torques)

    found = np.array([velocity(problem.model, state, name) for name in ("J1", "J2")])

    def smooth(steepness: float) -> np.ndarray:
        def rate(t: float, y: np.ndarray) -> list[float]:
            J1, J2, twist = y
            T = 0.0 if abs(twist) < 0.01 else 8000.0 * (twist - math.copysign(0.01, twist)) + 1.5 * (J1 - J2)
            return [(problem.torques(t)[0] - T) / 0.5, (T - 4.0 * math.tanh(steepness * J2)) / 1.5, J1 - J2]

        return solve_ivp(rate, (0, 0.6), [0.0] * 3, "Radau", rtol=1e-8, atol=1e-10, max_step=2e-4).y[:2, -1]

    assert len(state.transitions) > 15
    errors = [np.abs(smooth(steepness) - found).max() for steepness in (1e4, 1e5)]
    assert errors[1] < 2e-3 and errors[1] < 0.2 * errors[0]


def test_energy_balance_with_friction() -> None:
    """What the machines put in is in the bodies and shafts, or has been turned into heat by friction."""
    bench = Bench("train", {"J1": 0.8, "J2": 0.5, "J3": 2.0}).machine("J1")
    bench.shaft("shaft1", {"J1": 1, "J2": -1}, stiffness=300.0).shaft("shaft2", {"J2": 1, "J3": -1}, stiffness=500.0)
    bench.friction("bearing1", {"J1": 1}, coulomb=3.0).friction("bearing3", {"J3": 1}, coulomb=4.0)
    model = bench.model()
    simulation = EventDriven(model)
    drive = 3.0
    state = simulation.initial(at_velocities(model, {"J1": 6.0, "J2": -4.0, "J3": 1.0}))
    energy, heat, work = simulation.energy(state), 0.0, 0.0
    times = sorted({0.0, 2.0, *(t.time for t in simulation.advance(state, 2.0, np.array([drive])).transitions)})
    for time in times[1:]:  # between transitions each torque is constant, so its work is torque times angle
        before, state = state, simulation.advance(state, time, np.array([drive]))
        heat += float(state.friction_torque @ (state.angles - before.angles))
        work += drive * (state.angles[0] - before.angles[0])
    assert len(times) > 6 and heat > 1.0
    assert simulation.energy(state) - energy == pytest.approx(work - heat, abs=1e-10)


def test_coupled_clutches_of_the_modelica_library() -> None:
    problem = coupled_clutches()
    end = run(problem)
    # public solutions of the example by other tools, to about a millisecond
    seen = [
        (0.7098, "clutch2", 1, 0),
        (0.7911, "clutch1", 1, 0),
        (0.8312, "clutch1", 0, 1),
        (0.9066, "clutch1", 1, 0),
        (1.0003, "clutch1", 0, 1),
        (1.1440, "clutch3", 1, 0),
    ]
    found = [t for t in end.transitions if t.time > 0.4]
    assert [(t.element, t.before, t.after) for t in found] == [each[1:] for each in seen]
    np.testing.assert_allclose([t.time for t in found], [each[0] for each in seen], atol=1e-3)
    momentum = sum(velocity(problem.model, end, f"J{k}") for k in range(1, 5))
    assert momentum == pytest.approx(10 + (1 - math.cos(10 * math.pi * 1.5)) / math.pi, abs=1e-11)
    # clutch 1 slips from 0 to 0.4 s with its kinetic torque 10 cos(2 pi 0.2 t)
    J2 = velocity(problem.model, run(problem, 0.4), "J2")
    assert pytest.approx(10 * math.sin(0.4 * math.pi * 0.4) / (0.4 * math.pi), abs=1e-11) == J2


def regularised(problem: Problem, until: float, steepness: float) -> np.ndarray:
    """Return the velocities if every sign is a steep ``tanh``, by an implicit method."""
    A, B, F = problem.model.numeric().state_matrices()
    G = problem.model.numeric().friction_rows
    capacity = np.array([problem.model.values[f.coulomb] for f in problem.model.frictions])
    mu = [problem.actuations.get(f.name, lambda _: 1.0) for f in problem.model.frictions]

    def rate(t: float, x: np.ndarray) -> np.ndarray:
        return A @ x + B @ problem.torques(t) + F @ (capacity * [m(t) for m in mu] * np.tanh(steepness * (G @ x)))

    def slope(t: float, x: np.ndarray) -> np.ndarray:
        return A + F @ (
            (capacity * [m(t) for m in mu] * steepness * (1 - np.tanh(steepness * (G @ x)) ** 2))[:, None] * G
        )

    return solve_ivp(rate, (0, until), problem.initial, "Radau", jac=slope, rtol=1e-9, atol=1e-9, max_step=5e-3).y[
        :, -1
    ]


def without_higher_limit_at_rest(problem: Problem) -> EventDriven:
    values = {symbol.name: value for symbol, value in problem.model.values.items()}
    coulomb = {name.replace("coulomb", "static"): value for name, value in values.items() if name.endswith("_coulomb")}
    return EventDriven(problem.model, {name: value for name, value in coulomb.items() if name in values})


def test_six_elements_on_four_degrees_of_freedom_are_the_limit_of_smooth_friction() -> None:
    """Dependent rows: locking, break-away of several at once, reversals; against the regularised equations."""
    problem = gear_set()
    simulation = without_higher_limit_at_rest(problem)
    state = simulation.advance(simulation.initial(problem.initial), 1.2, problem.torques)
    errors = [np.abs(regularised(problem, 1.2, steepness) - state.x).max() for steepness in (1e3, 1e4)]
    assert len(state.transitions) > 10
    assert errors[1] < 2e-3 and errors[1] < 0.3 * errors[0]


def test_dependent_elements_carry_the_least_torques_within_their_limits() -> None:
    """Three brakes side by side on one body, of 1, 4 and 9 N m: in equal parts until one is at its limit."""
    bench = Bench("brakes", {"J": 2.0}).machine("J")
    for k, capacity in enumerate((1.0, 4.0, 9.0)):
        bench.friction(f"brake{k}", {"J": 1}, coulomb=capacity)
    simulation = EventDriven(bench.model())
    for drive, parts in ((1.5, (0.5, 0.5, 0.5)), (7.0, (1.0, 3.0, 3.0)), (13.0, (1.0, 4.0, 8.0))):
        state = simulation.advance(simulation.initial(), 0.1, np.array([drive]))
        np.testing.assert_allclose(state.friction_torque, parts, atol=1e-11)
        assert np.all(simulation.friction_velocities(state) == 0) and state.x[0] == 0
    ramp = simulation.advance(simulation.initial(), 1.0, lambda t: np.array([20 * t]))
    assert [t.time for t in ramp.transitions] == pytest.approx([0.7] * 3, abs=1e-13)
    assert ramp.x[0] == pytest.approx((10 * (1 - 0.49) - 14 * 0.3) / 2, abs=1e-11)


def test_velocities_that_stick_do_not_drift() -> None:
    """Locked by two clutches, all bodies of a row have one velocity exactly, however long it takes."""
    bench = Bench("row", {"J1": 0.3, "J2": 0.7, "J3": 1.1}).machine("J1").machine("J3")
    bench.friction("clutch1", {"J1": 1, "J2": -1}, coulomb=50.0).friction("clutch2", {"J2": 1, "J3": -1}, coulomb=50.0)
    simulation = EventDriven(bench.model())
    state = simulation.advance(simulation.initial(), 2.0, lambda t: np.array([20 * math.sin(9 * t), 7.0]))
    assert not state.transitions and np.all(simulation.friction_velocities(state) == 0.0)
    assert state.x[0] == state.x[1] == 0.0


def test_lags_of_the_drives() -> None:
    """With lags, torques are commands: T = command (1 - exp(-t / tau))."""
    bench = Bench("lagged", {"J": 1.5}).machine("J", time_constant=0.02)
    model = bench.friction("bearing", {"J": 1}, coulomb=1.0).model()
    simulation = EventDriven(model, lags=True)
    state = simulation.advance(simulation.initial(), 0.1, np.array([5.0]))
    leave = -0.02 * math.log(1 - 1 / 5)
    assert state.transitions[0].time == pytest.approx(leave, abs=1e-13)
    assert state.air_gap[0] == pytest.approx(5 * (1 - math.exp(-0.1 / 0.02)), abs=1e-11)
    impulse = 4 * (0.1 - leave) + 5 * 0.02 * (math.exp(-0.1 / 0.02) - math.exp(-leave / 0.02))
    assert state.x[0] == pytest.approx(impulse / 1.5, abs=1e-12)


def test_pieces_give_the_same_as_the_whole() -> None:
    """Where a run is cut does not matter, not even at a transition."""
    problem = two_clutches()
    simulation = EventDriven(problem.model)
    whole = run(problem)
    state = simulation.initial(problem.initial)
    for time in (0.1, 0.25, 0.6, 0.65, 0.75, 0.8, 0.9, 1.0):
        state = simulation.advance(state, time, problem.torques, breakpoints=problem.breakpoints)
    np.testing.assert_allclose(state.x, whole.x, atol=1e-11)
    assert [(t.element, t.before, t.after) for t in state.transitions] == changes(whole)
    np.testing.assert_allclose([t.time for t in state.transitions], [t.time for t in whole.transitions], atol=1e-12)


def test_open_clutch_at_rest_follows_without_torque() -> None:
    """Without actuation there is no torque and nothing that could stick, at rest neither."""
    bench = Bench("pair", {"J1": 1.0, "J2": 1.0}).machine("J1")
    model = bench.friction("clutch", {"J1": 1, "J2": -1}, coulomb=10.0, actuated=True).model()
    simulation = EventDriven(model)
    state = simulation.advance(simulation.initial(), 1.0, lambda t: np.array([t * t]), {"clutch": 0.0})
    assert velocity(model, state, "J2") == pytest.approx(0.0, abs=1e-14)
    assert velocity(model, state, "J1") == pytest.approx(1 / 3, abs=1e-11)


def test_touching_zero_within_a_step_is_seen() -> None:
    """A velocity that dips below zero for less than a step sticks there all the same."""
    bench = Bench("body", {"J": 1.0}).machine("J")
    model = bench.friction("bearing", {"J": 1}, coulomb=1.0).model()
    simulation = EventDriven(model)
    # w = 2.5e-7 + (t - 1e-3)^2 - 1e-6 without sticking, which is below zero from 0.134 ms to 1.866 ms
    drive = lambda t: np.array([1.0 + 2 * (t - 1e-3)])  # noqa: E731
    state = simulation.advance(simulation.initial([2.5e-7]), 0.01, drive, longest_step=1e-2)
    assert changes(state) == [("bearing", 1, 0), ("bearing", 0, 1)]
    assert state.transitions[0].time == pytest.approx(1e-3 - math.sqrt(0.75e-6), abs=1e-10)
    assert state.transitions[1].time == pytest.approx(1e-3, abs=1e-10)


@pytest.mark.slow
def test_differential_through_standstill_start_lock_and_release() -> None:
    """A whole bed; where its outputs are locked both half-shafts turn exactly alike."""
    problem = differential()
    simulation = EventDriven(problem.model)
    state = simulation.initial(problem.initial)
    modes = set()
    for time in np.linspace(0.05, problem.duration, 24):
        state = simulation.advance(state, float(time), problem.torques, breakpoints=problem.breakpoints)
        modes.add(tuple(state.mode.tolist()))
        slip = simulation.friction_velocities(state)
        assert np.all((slip == 0) == (state.mode == 0))
        values = simulation.signals(state)
        load = abs(values["diff.input"])
        for i, (capacity, per_load) in enumerate(((2.0, 0.01), (20.0, 0.15))):
            limit = capacity + per_load * load
            if state.mode[i]:
                assert state.friction_torque[i] == pytest.approx(state.mode[i] * limit, rel=1e-12)
            else:
                assert abs(state.friction_torque[i]) <= limit * (1 + 1e-12)
    assert {(0, 0), (1, 0), (1, 1), (1, -1)} <= modes


def test_problems_of_the_user_are_named() -> None:
    problem = clutch()
    with pytest.raises(RunError, match="clutch_coulombs: is no parameter"):
        EventDriven(problem.model, {"clutch_coulombs": 1.0})
    simulation = EventDriven(problem.model)
    with pytest.raises(RunError, match="clutch: has no actuation"):
        simulation.advance(simulation.initial(), 1.0, np.zeros(2))

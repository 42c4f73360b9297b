"""A ratio that changes at run time: the plant against the equations of motion, written by hand and solved by SciPy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from small_beds import Run, two_machines

from ptgen.analysis.closed_loop import closed_loop_poles
from ptgen.errors import ModelError
from ptgen.plant.free import with_free_frictions
from ptgen.plant.plant import plant_block
from ptgen.project import Project

H = 1e-4
GEARBOX = """
[components.gearbox]
type = "gearbox"
ratio = {ratio}
ratio_range = {span}
inertia = "0.05 kg m^2"
[components.shaft2]
type = "shaft"
stiffness = "60 kN m/rad"
damping = "{damping} N m s/rad"
"""
I1, IF, IG, I2 = 1.0, 0.03, 0.05, 2.0
CF, C1, C2 = 380e3, 40e3, 60e3
DF, D1, D2 = 0.5, 3.0, 2.0


def bed(folder: Path, ratio: float = 2.0, span: str = "[0.5, 4.0]", damping: float = D2, **more: str) -> Project:
    components = GEARBOX.format(ratio=ratio, span=span, damping=damping) + more.pop("components", "")
    return two_machines(folder, **{"chain": "flange1 - shaft1 - gearbox - shaft2", "components": components, **more})


def rates(x: np.ndarray, i: float, u1: float, u2: float) -> np.ndarray:
    """Return the right-hand side over rotor, flange, gear and rotor speeds, and three twists."""
    w1, wf, wg, w2, ef, e1, e2 = x
    rate_f, rate_1, rate_2 = w1 - wf, wf - wg, wg / i - w2
    tf, t1, t2 = CF * ef + DF * rate_f, C1 * e1 + D1 * rate_1, C2 * e2 + D2 * rate_2
    return np.array([(u1 - tf) / I1, (tf - t1) / IF, (t1 - t2 / i) / IG, (t2 + u2) / I2, rate_f, rate_1, rate_2])


def start(ratio: float) -> np.ndarray:
    w2 = 40.0
    return np.array([ratio * w2, ratio * w2, ratio * w2, w2, 50 / CF, 50 / C1, 50 * ratio / C2])


def names(project: Project) -> list[int]:
    """Return where the states of `rates` stand in the plant's."""
    model = project.model
    velocities = ["M1.shaft", "flange1.uut", "gearbox.input", "M2.shaft"]
    twists = ["flange1", "shaft1", "shaft2"]
    n_z = len(velocities)
    assert sorted(model.coordinates) == sorted(velocities) and sorted(model.twists) == sorted(twists)
    return [model.coordinates.index(v) for v in velocities] + [n_z + model.twists.index(t) for t in twists]


def started(project: Project, step: float = H, ratio: float = 2.0) -> Run:
    run = Run(plant_block(project.model, step))
    run.states["x"][names(project)] = start(ratio)
    return run


def ramp(time: float) -> float:
    """Return a smooth course of the ratio, from 2 to 3 in 20 ms."""
    share = min(1.0, max(0.0, time / 0.02))
    return 2.0 + share**2 * (3 - 2 * share)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_order_two_against_the_equations_of_motion(sense: float, tmp_path: Path) -> None:
    span, duration = ("[0.5, 4.0]" if sense > 0 else "[-4.0, -0.5]"), 0.03
    project = bed(tmp_path, ratio=2.0 * sense, span=span)
    solution = solve_ivp(
        lambda time, x: rates(x, sense * ramp(time), 120.0, -90.0),
        (0, duration),
        start(2.0 * sense),
        "DOP853",
        rtol=1e-12,
        atol=1e-13,
        max_step=1e-4,
    )
    expected = solution.y[:, -1]
    errors = []
    for divisor in (1, 2, 4):
        run = started(project, H / divisor, 2.0 * sense)
        for k in range(round(duration / H) * divisor):
            ratio = sense * ramp((k + 0.5) * H / divisor)
            run.step(M1_torque_ref=120.0, M2_torque_ref=-90.0, gearbox_ratio=ratio)
        errors.append(np.abs((run.states["x"][names(project)] - expected) / np.abs(expected).max()).max())
    assert errors[0] < 1e-4
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert np.all(orders > 1.9), (errors, orders)


def energy(x: np.ndarray) -> float:
    return float(0.5 * np.array([I1, IF, IG, I2, CF, C1, C2]) @ x**2)


def test_the_ratio_takes_no_work(tmp_path: Path) -> None:
    """Energy changes by what the machines give and the shafts lose, however the ratio changes: the teeth do no work.

    By hand, the power of the teeth is ``T2 wg / i - (T2 / i) wg``. The balance of the plant closes to second order.
    """
    project = bed(tmp_path)

    def power(x: np.ndarray, i: float) -> float:
        w1, wf, wg, w2 = x[:4]
        return 120 * w1 - 90 * w2 - DF * (w1 - wf) ** 2 - D1 * (wf - wg) ** 2 - D2 * (wg / i - w2) ** 2

    def with_work(time: float, x: np.ndarray) -> np.ndarray:
        return np.append(rates(x[:-1], ramp(time), 120.0, -90.0), power(x, ramp(time)))

    x0 = np.append(start(2.0), 0.0)
    end = solve_ivp(with_work, (0, 0.03), x0, "DOP853", rtol=1e-12, atol=1e-13, max_step=1e-4).y[:, -1]
    assert energy(end[:-1]) - energy(x0[:-1]) == pytest.approx(end[-1], rel=1e-8)
    misses = []
    for divisor in (1, 4):
        run, h = started(project, H / divisor), H / divisor
        place, work = names(project), 0.0
        x = run.states["x"][place]
        for k in range(round(0.03 / h)):
            run.step(M1_torque_ref=120.0, M2_torque_ref=-90.0, gearbox_ratio=ramp((k + 0.5) * h))
            new = run.states["x"][place]
            work += h / 2 * (power(x, ramp(k * h)) + power(new, ramp((k + 1) * h)))
            x = new
        misses.append(abs(energy(x) - energy(x0[:-1]) - work))
    assert misses[1] < misses[0] / 10 < 0.1 * abs(work) / 10


def test_a_jump_of_the_ratio_keeps_all_momenta(tmp_path: Path) -> None:
    """Velocities of bodies and twists go on from where they were; the solution of the new ratio is exact."""
    project = bed(tmp_path)
    run = started(project)
    for _ in range(20):
        run.step(M1_torque_ref=0.0, M2_torque_ref=0.0, gearbox_ratio=2.0)
    before = run.states["x"][names(project)]
    run.step(M1_torque_ref=0.0, M2_torque_ref=0.0, gearbox_ratio=3.0)
    flow = solve_ivp(lambda _, x: rates(x, 3.0, 0.0, 0.0), (0, H), before, "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    assert run.states["x"][names(project)] == pytest.approx(flow, rel=1e-9, abs=1e-12)


def test_a_constant_ratio_is_that_of_the_ordinary_plant(tmp_path: Path) -> None:
    changing = started(bed(tmp_path, ratio=2.0), ratio=2.5)
    text = (tmp_path / "bed.toml").read_text(encoding="utf-8")
    text = text.replace("ratio_range = [0.5, 4.0]\n", "").replace("ratio = 2.0", "ratio = 2.5")
    (tmp_path / "plain.toml").write_text(text, encoding="utf-8")
    plain = started(Project.read(tmp_path / "plain.toml"), ratio=2.5)
    for k in range(50):
        torques = {"M1_torque_ref": 100.0 * np.sin(k), "M2_torque_ref": 30.0}
        got, expected = changing.step(**torques, gearbox_ratio=2.5), plain.step(**torques)
        for name, value in expected.items():
            assert got[name] == pytest.approx(value, rel=1e-10, abs=1e-9), name


def test_every_ratio_of_the_range_must_suit_the_step(tmp_path: Path) -> None:
    """At the ratio of the file the friction can be solved, at an end of the range a mode is too fast for it."""
    bearing = '[components.bearing]\ntype = "bearing"\ncoulomb = "1 N m"\n'
    more = {"chain": "flange1 - shaft1 - bearing - gearbox - shaft2", "components": bearing}
    assert bed(tmp_path, ratio=1.0, span="[0.5, 2.0]", damping=0.0, **dict(more)).plant.tracked
    with pytest.raises(ModelError) as caught:
        _ = bed(tmp_path, ratio=1.0, span="[0.03, 2.0]", damping=0.0, **more).plant
    assert caught.value.problems[0].where == "testbed.sample_time"


def test_linear_analysis_holds_the_ratio(tmp_path: Path) -> None:
    plant = bed(tmp_path).plant
    held = with_free_frictions(plant)
    assert [signal.name for signal in plant.inputs if signal not in held.inputs] == ["gearbox_ratio"]
    assert held.declared("gearbox_ratio_now").value == 2.0 and held.tracked == ()
    assert held.declared("gearbox_ratio_now") in held.parameters


def test_signals_and_bounds(tmp_path: Path) -> None:
    project = bed(tmp_path)
    ratio = project.plant.declared("gearbox_ratio")
    assert (ratio.least, ratio.most, ratio.value) == (0.5, 4.0, 2.0)
    assert "gearbox_ratio" not in {signal.name for signal in project.plant.parameters}
    poles = closed_loop_poles(project.controller, project.plant)
    assert poles and not any(pole.is_unstable for pole in poles)

"""Plants with the simplified gearboxes: closed forms, energy, ratios that change while clutches stick or are open."""

from __future__ import annotations

import ctypes
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from small_beds import MACHINE

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.emit.block_files import block_files, common_context
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock

pytestmark = pytest.mark.compile

H = 1e-4
I_IN, I_OUT = 1.0 + 0.13, 2.0 + 0.4
SINGLE = """
[components.gb]
type = "single_clutch_gearbox"
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
ratio = 5.5
{more}
clutch = {{ capacity = "300 N m" }}
"""
DOUBLE = """
[components.gb]
type = "double_clutch_gearbox"
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
ratio1 = 5.5
ratio2 = 3.3
{more}
clutch1 = {{ capacity = "300 N m" }}
clutch2 = {{ capacity = "400 N m" }}
"""
RANGE = "ratio_range = [-4.0, 6.0]"


FLEXIBLE = """
[components.shaft1]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "3 N m s/rad"
[components.bearing]
type = "bearing"
coulomb = "2 N m"
viscous = "0.01 N m s/rad"
"""
BEDS = {
    "single": (SINGLE, RANGE, "gb", ""),
    "constant": (SINGLE, "", "gb", ""),
    "double": (DOUBLE, RANGE, "gb", ""),
    "flexible": (DOUBLE, RANGE, "shaft1 - bearing - gb", FLEXIBLE),
    "flexible constant": (DOUBLE, "", "shaft1 - bearing - gb", FLEXIBLE),
}


@cache
def bed(name: str) -> tuple[Project, CompiledBlock]:
    """Return a bed and its compiled plant."""
    gearbox, more, chain, extra = BEDS[name]
    folder = Path(tempfile.mkdtemp(prefix="ptgen-gearbox-"))
    text = f"""
[testbed]
name = "bed"
sample_time = "100 us"
connections = ["M1 - {chain} - M2"]
{MACHINE.format(name="M1", inertia=1.0, more="")}
{MACHINE.format(name="M2", inertia=2.0, more="")}
{gearbox.format(more=more)}
{extra}
[control]
speed = ["M1", "M2"]
"""
    (folder / "bed.toml").write_text(text, encoding="utf-8")
    project = Project.read(folder / "bed.toml")
    block = project.plant
    for file, content in block_files([block], common_context("bed", "bed", "0" * 16, "double")).items():
        (folder / file).write_text(content)
    compile_library(sorted(folder.glob("*.c")), folder / "libbed.so")
    return project, CompiledBlock(block, "bed", ctypes.CDLL(str(folder / "libbed.so")), "double")


class Course:
    """A compiled plant step by step, from given speeds of the machines on."""

    def __init__(self, name: str, first: float = 0.0, second: float = 0.0, **parameters: float) -> None:
        project, self.plant = bed(name)
        self.params = self.plant.parameters(parameters)
        status, self.state = self.plant.init(self.params)
        assert status == 0, self.plant.status_text(status)
        values = {s: parameters.get(s.name, value) for s, value in project.model.values.items()}
        rows = [evaluate_matrix(project.model.velocity_rows[f"{m}.shaft"], values)[0] for m in ("M1", "M2")]
        x = self.read("x")
        x[: len(rows[0])] = np.linalg.lstsq(np.array(rows), np.array([first, second]), rcond=None)[0]
        self.plant.write(self.state, "x", x)
        self.outputs = self.plant.measure(self.state, self.params)

    def step(self, **inputs: float) -> dict[str, float]:
        status, self.outputs = self.plant.step(self.state, self.params, inputs)
        assert status == 0, self.plant.status_text(status)
        return self.outputs

    def read(self, name: str) -> np.ndarray:
        return self.plant.read(self.state, name)


def torques(first: float, second: float) -> dict[str, float]:
    return {"M1_torque_ref": first, "M2_torque_ref": second}


@pytest.mark.parametrize("ratio", [5.5, 2.0, -3.4])
@pytest.mark.parametrize("name", ["constant", "single"])
def test_engagement_takes_the_time_and_the_heat_of_two_inertias(ratio: float, name: str) -> None:
    """By hand: slip falls at a constant rate, and heat is torque times the area below it."""
    capacity, first, second = 300.0, 40.0, -25.0
    slip = 200.0 - ratio * 3.0
    rate = (first - capacity) / I_IN - ratio * (ratio * capacity + second) / I_OUT
    time, heat = -slip / rate, 0.5 * capacity * slip * (-slip / rate)
    run = Course(name, 200.0, 3.0, **({"gb_ratio": ratio} if name == "constant" else {}))
    shift = {} if name == "constant" else {"gb_ratio": ratio}
    lost, elapsed, last = 0.0, None, slip
    for k in range(round(1.2 * time / H)):
        now = run.step(**torques(first, second), gb_clutch_actuation=1.0, **shift)["gb_clutch_speed"]
        part = 1.0 if now != 0 else last / (-rate * H)
        lost += capacity * 0.5 * (last + now) * H * min(part, 1.0)
        if elapsed is None and now == 0:
            elapsed = (k + part) * H
        last = now
    assert elapsed == pytest.approx(time, rel=1e-8)
    assert lost == pytest.approx(heat, rel=1e-8)
    sticking = (first * I_OUT - ratio * second * I_IN) / (I_OUT + ratio**2 * I_IN)
    assert run.outputs["gb_clutch_torque"] == pytest.approx(sticking, rel=1e-6, abs=1e-9)


def energy(outputs: dict[str, float]) -> float:
    return 0.5 * (I_IN * outputs["M1_speed"] ** 2 + I_OUT * outputs["M2_speed"] ** 2)


def test_power_balance_closes_while_ratios_change() -> None:
    """Work of the machines is kinetic energy and heat of the clutches, also in the steps in which ratios change.

    The torque of each clutch is that at the end of the step; so the balance closes to second order, but for the steps
    in which a clutch begins to stick.
    """
    misses = []
    for step in (1e-4, 1e-5):
        run = Course("double", 110.0, 20.0, sample_time=step)
        start, work, heat, most = energy(run.outputs), 0.0, 0.0, 0.0
        for k in range(round(0.6 / step)):
            time = (k + 0.5) * step
            ratios = [5.5 - 2.0 * min(1.0, max(0.0, (time - 0.1) / 0.2)), -3.0 if time > 0.3 else 3.3]
            mu = {"gb_clutch1_actuation": 0.8, "gb_clutch2_actuation": 0.5 * min(1.0, max(0.0, (time - 0.35) / 0.1))}
            before = run.outputs
            after = run.step(**torques(60.0, -80.0), **mu, gb_ratio1=ratios[0], gb_ratio2=ratios[1])
            omega = [0.5 * (before[f"M{m}_speed"] + after[f"M{m}_speed"]) for m in (1, 2)]
            work += (60.0 * omega[0] - 80.0 * omega[1]) * step
            for number, ratio in enumerate(ratios, start=1):
                power = after[f"gb_clutch{number}_torque"] * (omega[0] - ratio * omega[1])
                heat += power * step
                most = max(most, power)
                assert power > -1e-3 * max(most, 1.0), "a clutch takes power, and gives none"
        misses.append(abs(work - heat - energy(run.outputs) + start) / abs(work))
        assert heat > 1000.0
    assert misses[0] < 1e-4
    assert misses[1] < 1e-5


def test_a_ratio_that_changes_while_the_clutch_sticks_makes_it_slip() -> None:
    """No impulse: velocities go on from where they were, and the clutch pulls with its capacity."""
    run = Course("single", 55.0, 10.0)
    for _ in range(5):
        run.step(**torques(20.0, -30.0), gb_clutch_actuation=1.0, gb_ratio=5.5)
    before = run.outputs
    assert before["gb_clutch_speed"] == 0.0
    after = run.step(**torques(20.0, -30.0), gb_clutch_actuation=1.0, gb_ratio=3.3)
    rate = (20.0 - 300.0) / I_IN
    assert (after["M1_speed"] - before["M1_speed"]) == pytest.approx(rate * H, rel=1e-9)
    assert (after["M2_speed"] - before["M2_speed"]) == pytest.approx((3.3 * 300.0 - 30.0) / I_OUT * H, rel=1e-9)
    assert after["gb_clutch_torque"] == 300.0
    slip = (before["M1_speed"]) - 3.3 * before["M2_speed"]
    assert 0 < after["gb_clutch_speed"] < slip
    for _ in range(4000):
        after = run.step(**torques(20.0, -30.0), gb_clutch_actuation=1.0, gb_ratio=3.3)
    assert after["gb_clutch_speed"] == 0.0
    assert after["M1_speed"] == pytest.approx(3.3 * after["M2_speed"], rel=1e-12)


def test_while_the_clutch_is_open_the_ratio_does_nothing() -> None:
    still, moved = (Course("single", 55.0, 10.0) for _ in range(2))
    for k in range(50):
        one = still.step(**torques(20.0, -30.0), gb_clutch_actuation=0.0, gb_ratio=5.5)
        other = moved.step(**torques(20.0, -30.0), gb_clutch_actuation=0.0, gb_ratio=5.5 - 0.18 * k)
        assert all(one[name] == other[name] for name in one if name != "gb_clutch_speed")
    assert other["gb_clutch_speed"] == pytest.approx(other["M1_speed"] + 3.32 * other["M2_speed"], rel=1e-9)
    for _ in range(20000):
        other = moved.step(**torques(20.0, -30.0), gb_clutch_actuation=1.0, gb_ratio=-3.32)
    assert other["gb_clutch_speed"] == 0.0 and (other["M1_speed"] * other["M2_speed"]) < 0


def test_two_clutches_one_of_them_open_are_one_clutch() -> None:
    single, double = Course("single", 150.0, 10.0), Course("double", 150.0, 10.0)
    for k in range(600):
        mu, ratio = min(1.0, k / 300), 5.5 if k < 400 else 4.0
        one = single.step(**torques(60.0, -40.0), gb_clutch_actuation=mu, gb_ratio=ratio)
        rest = {"gb_clutch2_actuation": 0.0, "gb_ratio2": 3.3 - 0.01 * k}
        other = double.step(**torques(60.0, -40.0), gb_clutch1_actuation=mu, gb_ratio1=ratio, **rest)
        for name in ("M1_speed", "M2_speed"):
            assert other[name] == pytest.approx(one[name], rel=1e-12), k
        assert other["gb_clutch1_torque"] == pytest.approx(one["gb_clutch_torque"], rel=1e-9, abs=1e-9)
        assert other["gb_clutch2_torque"] == 0.0


@pytest.mark.parametrize("ratios", [(5.5, 3.3), (5.5, 5.5), (5.5, -3.4)])
def test_both_clutches_hold_at_standstill(ratios: tuple[float, float]) -> None:
    run = Course("double")
    acting = {"gb_clutch1_actuation": 1.0, "gb_clutch2_actuation": 1.0, "gb_ratio1": ratios[0], "gb_ratio2": ratios[1]}
    same = ratios[0] == ratios[1]
    for _ in range(50):
        outputs = run.step(**torques(40.0, 5.5 * -40.0 if same else -100.0), **acting)
        assert outputs["gb_clutch1_speed"] == outputs["gb_clutch2_speed"] == 0.0
        assert abs(outputs["M1_speed"]) < 1e-12 and abs(outputs["M2_speed"]) < 1e-12
    first, second = (outputs[f"gb_clutch{k}_torque"] for k in (1, 2))
    assert first + second == pytest.approx(40.0)
    if same:
        assert first == pytest.approx(second, rel=1e-9), "shared by equals"
    else:
        assert ratios[0] * first + ratios[1] * second == pytest.approx(100.0)


def test_quick_preparation_is_the_whole_one() -> None:
    """Elements whose rows stay, others whose rows change: after a step all matrices are those of a fresh start."""
    project, _ = bed("flexible")
    plant = project.plant
    assert all(item.quick for item in plant.tracked) and len(plant.tracked) == 2
    assert [f.name for f in project.model.frictions] == ["gb.clutch1", "gb.clutch2", "bearing"]
    evaluator = NumpyBlock(plant)
    changed = {"gb_ratio1_now": np.asarray(-2.5), "gb_ratio2_now": np.asarray(4.4)}
    wanted = evaluator.prepare(evaluator.defaults(), {**evaluator.initial(), **changed})
    run = Course("flexible")
    run.step(**torques(0.0, 0.0), gb_clutch1_actuation=0.0, gb_clutch2_actuation=0.0, gb_ratio1=-2.5, gb_ratio2=4.4)
    for name in ("gamma", "K"):
        assert run.read(name) == pytest.approx(wanted[name], rel=1e-9, abs=1e-18)
    # and those of a plant whose ratios are constant, in its own coordinates
    constant = NumpyBlock(bed("flexible constant")[0].plant)
    given = {**constant.defaults(), "gb_ratio1": np.asarray(-2.5), "gb_ratio2": np.asarray(4.4)}
    assert wanted["K"] == pytest.approx(constant.prepare(given)["K"], rel=1e-9, abs=1e-18)


def test_constant_and_changing_ratios_give_the_same_motion() -> None:
    """Other coordinates, another preparation: slips are states of the one and combinations of states of the other."""
    changing, constant = Course("flexible"), Course("flexible constant")
    for k in range(4000):
        acting = {"gb_clutch1_actuation": min(1.0, k / 1000), "gb_clutch2_actuation": 0.2}
        got = changing.step(**torques(150.0, -20.0), **acting, gb_ratio1=5.5, gb_ratio2=3.3)
        wanted = constant.step(**torques(150.0, -20.0), **acting)
        for name, value in wanted.items():
            assert got[name] == pytest.approx(value, rel=1e-7, abs=1e-7), (k, name)


def test_convergence_over_a_shift() -> None:
    """Capacity ramps of both clutches, the ratio of the open one set before: second order."""

    def end(divisor: int) -> np.ndarray:
        run = Course("flexible", sample_time=H / divisor)
        for k in range(1000 * divisor):
            time = (k + 0.5) * H / divisor
            share = min(1.0, max(0.0, (time - 0.0437) / 0.03))
            acting = {"gb_clutch1_actuation": 1.0 - share, "gb_clutch2_actuation": 0.5 * share}
            run.step(**torques(150.0, -20.0), **acting, gb_ratio1=5.5, gb_ratio2=-1.0 if time < 0.02 else 3.3)
        return np.array([run.outputs["M1_speed"], run.outputs["M2_speed"]])

    reference = end(64)
    errors = [np.abs(end(divisor) - reference).max() for divisor in (1, 8)]
    assert errors[0] < 1e-3
    assert errors[1] < errors[0] / 8**1.5

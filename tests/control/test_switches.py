"""Run-time switches: independent of each other, and without a jump while the bed runs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from controller_steps import Bench, Controller
from hypothesis import given
from hypothesis import strategies as st
from mechanism.bed_text import differential_bed

from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

pytestmark = pytest.mark.compile

SWITCH_TIME, H = 0.2, 1e-4


@pytest.fixture(scope="module", params=["pi", "observer"])
def bench(request: pytest.FixtureRequest) -> tuple[Project, Library]:
    bed = differential_bed()
    bed.control = {"speed_control": request.param}
    project = Project(bed.load())
    return project, build(project)


REFERENCES = {"diff_input_torque_ref": 300.0, "M2_speed_ref": 40.0, "M3_speed_ref": 50.0}
"""Input torque of 300 N m: the outputs carry it with 286 N m each, and the limited slip on top."""


def turned(bench: tuple[Project, Library], **changes: float) -> Bench:
    """Return the bed at a steady state under load."""
    made = Bench(*bench, switch_time=SWITCH_TIME, **changes)
    made.run(30000, **REFERENCES)
    return made


@pytest.mark.parametrize("switch", ["load_compensation", "acceleration_torque", "M1_damping"])
@pytest.mark.parametrize("share", [0.0, 0.4])
def test_switching_under_load_does_not_jump(bench: tuple[Project, Library], switch: str, share: float) -> None:
    made = turned(bench)
    before = {name: float(values[-1]) for name, values in made.run(500, **REFERENCES).items()}
    made.change(**{switch: share * getattr(made.params, switch)})
    during = made.run(round(SWITCH_TIME / H), **REFERENCES)
    loads = (
        {"M1": 0.0, "M2": 300.0, "M3": 350.0}
        if switch == "load_compensation"
        else dict.fromkeys(("M1", "M2", "M3"), 20.0)
    )
    for name, load in loads.items():
        jumps = np.abs(np.diff(during[f"{name}_torque_ref"], prepend=before[f"{name}_torque_ref"]))
        assert jumps.max() <= (1 - share) * load * H / SWITCH_TIME + 0.05, name
    after = made.run(20000, **REFERENCES)
    for name, value in before.items():
        if name.endswith(("_torque_ref", "_speed")) or name.startswith("flange"):
            assert after[name][-1] == pytest.approx(value, rel=1e-3, abs=0.1), name


@given(st.floats(0, 1), st.floats(0, 1), st.floats(-300, 300))
def test_the_integrator_takes_over_what_the_compensation_gives_away(start: float, end: float, load: float) -> None:
    """With the load held, the command does not change at all, in no step of the ramp."""
    controller = Controller(PI.controller, {"load_compensation": start, "switch_time": 1e-3})
    inputs = {"flange2_torque": load, "M2_speed": 30.0, "M2_speed_ref": 30.0}
    first = controller.step(**inputs)["M2_torque_ref"]
    controller.set({"load_compensation": end, "switch_time": 1e-3})
    for _ in range(12):
        assert controller.step(**inputs)["M2_torque_ref"] == pytest.approx(first, abs=1e-9)
    assert controller.state("load_compensation_now") == end
    assert controller.state("M2_speed_integral") == pytest.approx((end - start) * load, abs=1e-9)


@given(st.floats(0, 1), st.floats(0, 1), st.integers(1, 40))
def test_a_switch_lands_exactly_and_in_equal_steps(start: float, end: float, steps: int) -> None:
    controller = Controller(PI.controller, {"acceleration_torque": start, "switch_time": steps * H})
    controller.step()
    assert controller.state("acceleration_torque_now") == start
    controller.set({"acceleration_torque": end, "switch_time": steps * H})
    values = [start]
    for _ in range(steps + 1):
        controller.step()
        values.append(controller.state("acceleration_torque_now"))
    largest = max(abs(end - start) / steps, 1e-6 * (start + end))
    assert np.abs(np.diff(values)).max() <= largest * (1 + 1e-9)
    np.testing.assert_allclose(values[:-1], np.linspace(start, end, steps + 1), atol=1e-4)
    assert values[-1] == end


numbers = st.floats(-200, 200)


@given(st.floats(0, 1), numbers, numbers, numbers, numbers)
def test_acceleration_torque_sees_the_whole_net_torque(
    share: float, wanted: float, f2: float, f3: float, f1: float
) -> None:
    """(5.107) with the derivation's entry of (5.108): command and flange torque, whatever load_compensation is."""
    inputs = {"flange1_torque": f1, "flange2_torque": f2, "flange3_torque": f3, "M2_speed_ref": wanted / 50.0}
    outputs = {}
    for accelerate in (0.0, 1.0):
        changes = {"load_compensation": share, "acceleration_torque": accelerate, "M1_torque_gain": 0.0}
        outputs[accelerate] = Controller(PI.controller, changes).step(**inputs)
    net = {name: outputs[1.0][f"{name}_torque_ref"] + load for name, load in (("M2", f2), ("M3", f3))}
    decoupling = PI.design.decoupling
    inertia = PI.design.gains.inertia_estimate["M1"]
    shares = evaluate_matrix(decoupling.law.P, decoupling.values | {decoupling.inertia_estimate[0]: inertia})[0, 1:]
    expected = sum(share * torque for share, torque in zip(shares, net.values(), strict=True))
    got = outputs[1.0]["M1_torque_ref"] - outputs[0.0]["M1_torque_ref"]
    assert got == pytest.approx(expected, abs=1e-8)


def test_acceleration_torque_works_without_load_compensation(projects: dict[str, Project], root: Path) -> None:
    """During speed ramps it alone makes the error of the testing torque four times smaller, as with compensation."""
    project = projects["differential"]
    library, scenario = (
        build(project),
        load_scenario(root / "scenarios" / "differential-speed-ramps.toml", project.testbed),
    )
    error = {}
    for load in (0.0, 1.0):
        for accelerate in (0.0, 1.0):
            parameters = {"load_compensation": load, "acceleration_torque": accelerate}
            signals = simulate(project, scenario, library=library, parameters=parameters).signals
            difference = signals["diff_input_torque_ref"] - signals["diff_input_torque"]
            error[load, accelerate] = float(np.sqrt(np.mean(difference**2)))
    assert error[0.0, 1.0] < 0.25 * error[0.0, 0.0]
    assert error[0.0, 1.0] == pytest.approx(error[1.0, 1.0], rel=0.02)


PI = Project(differential_bed().load())

"""Computation delay and dead time of the plant, and the room of its delay lines."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import scipy.linalg
from small_beds import Run, two_machines

from ptgen.errors import ModelError
from ptgen.plant.plant import plant_block

H = 1e-4
LAG = 'inverter = {{ model = "lag", dead_time = "{} us", time_constant = "300 us" }}'


@pytest.mark.parametrize("delay", [0.2e-4, 1e-4, 1.37e-4, 14e-4])
def test_a_command_acts_late_also_with_an_ideal_inverter(delay: float, tmp_path: Path) -> None:
    """The solution is that of SciPy's exponential with the jump of the command where it belongs."""
    project = two_machines(tmp_path, testbed=f'computation_delay = "{delay * 1e6} us"')
    A, B, _ = project.model.numeric().state_matrices()

    def flow(x: np.ndarray, u: np.ndarray, time: float) -> np.ndarray:
        joined = np.block([[A, (B @ u)[:, None]], [np.zeros((1, len(A) + 1))]])
        return (scipy.linalg.expm(joined * time) @ np.append(x, 1.0))[:-1]

    run, x, commands = Run(project.plant), np.zeros(len(A)), []
    for k in range(40):
        commands.append(np.array([300.0 * np.sin(0.7 * k + 1), 200.0 * np.cos(k)]))
        run.step(M1_torque_ref=commands[k][0], M2_torque_ref=commands[k][1])
        whole, part = divmod(round(delay * 1e9), round(H * 1e9))
        early, late = (commands[j] if j >= 0 else np.zeros(2) for j in (k - whole - 1, k - whole))
        x = flow(flow(x, early, part * 1e-9), late, H - part * 1e-9)
        assert run.states["x"][: len(x)] == pytest.approx(x, rel=1e-9, abs=1e-11)


def test_computation_and_dead_time_add_up(tmp_path: Path) -> None:
    split = two_machines(tmp_path, testbed='computation_delay = "45 us"', machines=LAG.format(130))
    whole = two_machines(tmp_path, machines=LAG.format(175))
    first, second = Run(split.plant), Run(whole.plant)
    for k in range(50):
        inputs = {"M1_torque_ref": 100.0 * np.sin(k), "M2_torque_ref": 50.0}
        assert first.step(**inputs)["M1_speed"] == pytest.approx(second.step(**inputs)["M1_speed"], rel=1e-12)


def test_without_a_delay_there_is_no_parameter(tmp_path: Path) -> None:
    assert two_machines(tmp_path).plant.signal("computation_delay") is None
    plant = two_machines(tmp_path, testbed='computation_delay = "20 us"').plant
    assert plant.declared("computation_delay").value == pytest.approx(20e-6)


def test_both_limits_together_fit_the_delay_line(tmp_path: Path) -> None:
    plant = two_machines(tmp_path, testbed='computation_delay = "20 us"', machines=LAG.format(100)).plant
    most = [plant.declared(name).most for name in ("computation_delay", "M1_inverter_dead_time")]
    assert sum(most) <= 15 * H * (1 + 1e-12)
    assert all(limit > value for limit, value in zip(most, (20e-6, 100e-6), strict=True))


@pytest.mark.parametrize(
    ("testbed", "machines", "where"),
    [
        ('computation_delay = "1.6 ms"', "", "testbed.computation_delay"),
        ('computation_delay = "1.2 ms"', LAG.format(400), "testbed.computation_delay"),
        ('computation_delay = "0.4 ms"', LAG.format(1200), "components.M1.inverter.dead_time"),
        ("", LAG.format(1600), "components.M1.inverter.dead_time"),
    ],
)
def test_too_much_for_the_delay_line(testbed: str, machines: str, where: str, tmp_path: Path) -> None:
    project = two_machines(tmp_path, testbed=testbed, machines=machines)
    with pytest.raises(ModelError) as caught:
        _ = project.plant
    assert caught.value.problems[0].where == where
    assert "more than 15 steps" in caught.value.problems[0].what
    assert plant_block(project.model, H, delay_capacity=18).declared("M1_delay").shape == (18,)


def test_a_longer_delay_line_changes_no_number(tmp_path: Path) -> None:
    project = two_machines(tmp_path, machines=LAG.format(275))
    runs = [Run(project.plant), Run(plant_block(project.model, H, delay_capacity=64))]
    for k in range(80):
        speeds = [run.step(M1_torque_ref=90.0 * np.sin(k), M2_torque_ref=20.0)["M2_speed"] for run in runs]
        assert speeds[0] == speeds[1]

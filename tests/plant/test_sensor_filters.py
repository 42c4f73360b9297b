"""Low passes of sensors in the plant: exact, and invisible to everything but the measured values."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from small_beds import Run, two_machines

from ptgen.elements import Sensor, SensorKind
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.plant.plant import plant_block

H = 1e-4
SENSOR = 'sensor = { time_constant = "250 us" }'
COMMANDS = [{"M1_torque_ref": 300.0 * np.sin(k), "M2_torque_ref": 200.0 * np.cos(0.3 * k)} for k in range(80)]


def augmented(model: Model, taus: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """Return state and input matrix of a bed with ideal drives and without friction, low passes appended."""
    A, B, _ = model.numeric().state_matrices()
    n_z = len(model.coordinates)
    rows, inputs = [], []
    for name in taus:
        form = model.signals[name]
        z, e, u, a = (evaluate_matrix(part, model.values) for part in (form.z, form.e, form.u, form.a))
        rows.append(np.hstack([z, e])[0] + (a @ A[:n_z])[0])
        inputs.append(u[0] + (a @ B[:n_z])[0])
    lags = np.array(list(taus.values()))
    full = np.block([[A, np.zeros((len(A), len(taus)))], [np.array(rows) / lags[:, None], -np.diag(1 / lags)]])
    return full, np.vstack([B, np.array(inputs) / lags[:, None]])


def exact(model: Model, taus: dict[str, float]) -> np.ndarray:
    """Return the measured values after each step, by the exponential of SciPy."""
    A, B = augmented(model, taus)
    whole = scipy.linalg.expm(np.block([[A, B], [np.zeros((2, A.shape[0] + 2))]]) * H)[: len(A)]
    x, values = np.zeros(len(A)), []
    for command in COMMANDS:
        x = whole @ np.concatenate([x, list(command.values())])
        values.append(x[len(A) - len(taus) :])
    return np.array(values)


def test_measured_values_are_the_exact_solution(tmp_path: Path) -> None:
    project = two_machines(tmp_path, machines=SENSOR, flange=SENSOR)
    names = ["M1_speed", "flange1_torque", "M2_speed"]
    expected = exact(project.model, dict.fromkeys(names, 250e-6))
    run = Run(project.plant)
    got = np.array([[float(outputs[name]) for name in names] for outputs in (run.step(**c) for c in COMMANDS)])
    assert np.abs(got - expected).max(axis=0) == pytest.approx(0.0, abs=1e-11 * np.abs(expected).max())


def test_a_filter_changes_nothing_but_what_is_measured(tmp_path: Path) -> None:
    plain, filtered = two_machines(tmp_path), two_machines(tmp_path, machines=SENSOR, flange=SENSOR)
    ideal, run = Run(plain.plant), Run(filtered.plant)
    for command in COMMANDS:
        expected, got = ideal.step(**command), run.step(**command)
        for name in ("M1_speed", "M2_speed", "flange1_torque"):
            assert got[f"{name}_true"] == pytest.approx(expected[name], rel=1e-11, abs=1e-11)
        assert got["M1_torque"] == expected["M1_torque"]
    assert abs(got["flange1_torque"] - got["flange1_torque_true"]) > 0.1, "the filter lags behind"


def test_a_reading_with_accelerations_and_feedthrough_is_exact_too(tmp_path: Path) -> None:
    """The torque across a rigid connection depends on accelerations, and through these on the held commands."""
    disk = '[components.disk]\ntype = "inertia"\ninertia = "0.2 kg m^2"\n'
    project = two_machines(tmp_path, chain="disk - flange1 - shaft1", components=disk, place="disk.left")
    model, tau = project.model, sp.Symbol("cut_sensor_time_constant", positive=True)
    form = model.signals["disk.left"]
    assert form.needs_acceleration and not form.u.is_zero_matrix
    parameter = replace(model.parameters[0], symbol=tau, value=60e-6)
    model = replace(
        model,
        sensors=(*model.sensors, Sensor("cut_torque", SensorKind.TORQUE, "disk.left", tau)),
        signals={**model.signals, "cut_torque": form},
        parameters=(*model.parameters, parameter),
    )
    expected = exact(model, {"cut_torque": 60e-6})[:, 0]
    run = Run(plant_block(model, H))
    got = np.array([float(run.step(**command)["cut_torque"]) for command in COMMANDS])
    assert np.abs(got - expected).max() < 1e-11 * np.abs(expected).max()


def test_friction_passes_the_filter_as_its_mean_over_the_step(tmp_path: Path) -> None:
    """A clutch that slips exerts a constant torque, which makes the filtered torque the exact solution again."""
    clutch = '[components.clutch]\ntype = "clutch"\ncapacity = "50 N m"\ninertia_input = "0.1 kg m^2"\n'
    project = two_machines(tmp_path, chain="flange1 - shaft1 - clutch", components=clutch, flange=SENSOR)
    run = Run(project.plant)
    model = project.model
    A, B = augmented(model, {"flange1_torque": 250e-6})
    F = np.vstack([model.numeric().state_matrices()[2], np.zeros((1, 1))])
    whole = scipy.linalg.expm(np.block([[A, B, F], [np.zeros((3, len(A) + 3))]]) * H)[: len(A)]
    x = np.zeros(len(A))
    bodies = {"M1.shaft": 100.0, "flange1.uut": 100.0, "clutch.input": 100.0, "M2.shaft": 0.0}
    rows = np.vstack([evaluate_matrix(model.velocity_rows[name], model.values) for name in bodies])
    x[: len(rows)] = np.linalg.solve(rows, list(bodies.values()))
    x[-1] = 0.0
    run.states["x"][: len(x)] = x
    for _ in range(60):
        outputs = run.step(M1_torque_ref=80.0, M2_torque_ref=10.0, clutch_actuation=1.0)
        x = whole @ np.concatenate([x, [80.0, 10.0, 50.0]])
        assert outputs["flange1_torque"] == pytest.approx(x[-1], rel=1e-8, abs=1e-9)
    assert abs(x[-1]) > 5


def test_reduction_tells_what_the_filter_costs(tmp_path: Path) -> None:
    rules = two_machines(tmp_path, machines=SENSOR, flange=SENSOR).reduced.rules
    found = {rule.element: rule for rule in rules if rule.rule == "idealise sensor"}
    assert set(found) == {"M1_speed", "M2_speed", "flange1_torque"}
    (frequency,) = [mode.frequency_hz for mode in two_machines(tmp_path).reduced.modes_before if mode.frequency_hz][:1]
    expected = np.degrees(np.arctan(2 * np.pi * frequency * 250e-6))
    assert found["M1_speed"].numbers == pytest.approx({"lag": 250e-6, "phase_degrees": expected})
    assert not [rule for rule in two_machines(tmp_path).reduced.rules if rule.rule == "idealise sensor"]

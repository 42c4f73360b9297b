"""The nominal closed loop: that of the emitted block with the reduced plant, step by step; the source's formulas."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import scipy.linalg

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.errors import ControlError
from ptgen.governor.prediction import predict_loop
from ptgen.mechanism.model import evaluate_matrix
from ptgen.testbed import load


@pytest.fixture(scope="module")
def prediction(project):
    return predict_loop(project.design, project.testbed)


class NominalBed:
    """The emitted controller in NumPy, and the reduced plant with torques held over a step."""

    def __init__(self, project) -> None:
        design, decoupling = project.design, project.design.decoupling
        values = {**decoupling.values, **design.tuned_inertia}
        system, model = decoupling.system, decoupling.model
        A, B, F = (evaluate_matrix(matrix, values) for matrix in (system.A, system.B, system.F))
        m, n = B.shape[1], len(A)
        wide = np.hstack([A, B, F])
        held = scipy.linalg.expm(
            np.vstack([wide, np.zeros((wide.shape[1] - n, wide.shape[1]))]) * project.testbed.sample_time
        )
        self.A, self.B, self.F = held[:n, :n], held[:n, n : n + m], held[:n, n + m :]
        forms = [model.without_acceleration(model.signals[name]) for name in decoupling.sensors]
        self.C = np.vstack([np.hstack([evaluate_matrix(f.z, values), evaluate_matrix(f.e, values)]) for f in forms])
        self.D, self.T = (np.vstack([evaluate_matrix(getattr(f, k), values) for f in forms]) for k in "uf")
        self.block = NumpyBlock(design.controller.block)
        self.parameters = self.block.defaults()
        wide_open = ("_rate", "_plausible", "_limit", "_overspeed", "frozen_time")
        for name in self.parameters:
            if "_sensor_inertia_" in name:
                self.parameters[name] = np.array(0.0)
            elif name.endswith(wide_open) and not name.endswith("_twisting_rate"):
                self.parameters[name] = np.array(1e12)
        self.derived = self.block.prepare(self.parameters)
        self.states = self.block.initial()
        self.x, self.u = np.zeros(n), np.zeros(m)
        self.sensors = decoupling.sensors
        self.machines = decoupling.machines

    def step(self, references, T):
        y = self.C @ self.x + self.D @ self.u + self.T @ T
        inputs = {signal.name: np.array(signal.value) for signal in self.block.block.inputs}
        known = set(inputs)
        inputs |= {name: np.array(value) for name, value in zip(self.sensors, y, strict=True) if name in known}
        inputs |= {name: np.array(value) for name, value in references.items() if name in known}
        self.states, outputs = self.block.step(self.parameters, self.derived, self.states, inputs)
        u = np.array([float(outputs[f"{name}_torque_ref"]) for name in self.machines])
        self.x, self.u = self.A @ self.x + self.B @ u + self.F @ T, u
        return y, u


def given(prediction, bed, y):
    """Return the signals that the estimate of the states is made of."""
    values = []
    for name, kind in zip(prediction.estimate.signals, prediction.estimate.kinds, strict=True):
        if kind == "state":
            values.append(float(bed.states[name]))
        elif kind == "applied":
            values.append(bed.u[bed.machines.index(name.removesuffix("_torque"))])
        elif kind == "sensor":
            values.append(y[bed.sensors.index(name)])
        else:
            values.append(np.nan)
    return np.array(values)


def test_prediction_is_what_the_emitted_block_does_with_the_reduced_plant(project, prediction):
    """Commands agree from the second step on (the first one starts integrators), small references, no limit reached."""
    bed, rng = NominalBed(project), np.random.default_rng(1)
    torques, T = np.array(prediction.torque_references), np.zeros(len(prediction.disturbances))
    bed.step({}, T)
    x, worst, size = np.zeros(len(prediction.A)), 0.0, 0.0
    for k in range(600):
        if k % 100 == 0:
            r = np.where(torques, 20.0, 0.05) * rng.normal(size=len(torques))
        _, u = bed.step(dict(zip(prediction.references, r, strict=True)), T)
        worst = max(worst, float(abs(u - prediction.C @ x - prediction.D @ r).max()))
        size = max(size, float(abs(u).max()))
        x = prediction.A @ x + prediction.B @ r
    assert size > 1.0
    assert worst < 1e-9 * size


def test_states_follow_from_sensors(project, prediction):
    bed, rng = NominalBed(project), np.random.default_rng(2)
    torques, T = np.array(prediction.torque_references), np.zeros(len(prediction.disturbances))
    bed.step({}, T)
    x = np.zeros(len(prediction.A))
    r = np.where(torques, 20.0, 0.05) * rng.normal(size=len(torques))
    own = {name: k for k, name in enumerate(project.design.decoupling.model.states)}
    for _ in range(300):
        u_before = bed.u
        y = bed.C @ bed.x + bed.D @ bed.u
        q = given(prediction, bed, y)
        # testing torques: what the estimate of the controller gives on the reduced plant
        for k in np.flatnonzero(np.isnan(q)):
            q[k] = torque_at_place(project, prediction.estimate.signals[k], bed, u_before)
        estimated = prediction.estimate.values @ q
        for k, state in enumerate(prediction.states):
            if state in own and "clutch" not in state:
                assert estimated[k] == pytest.approx(bed.x[own[state]], rel=1e-7, abs=1e-9)
            elif state not in own:
                assert estimated[k] == pytest.approx(x[k], rel=1e-7, abs=1e-6)
        bed.step(dict(zip(prediction.references, r, strict=True)), T)
        x = prediction.A @ x + prediction.B @ r


def torque_at_place(project, signal, bed, u):
    decoupling = project.design.decoupling
    values = {**decoupling.values, **project.design.tuned_inertia}
    form = decoupling.model.without_acceleration(decoupling.model.signals[signal.removesuffix("_torque").replace("_", ".", 1)])  # fmt: skip  # noqa: E501
    row = np.hstack([evaluate_matrix(form.z, values), evaluate_matrix(form.e, values)])
    return float(row[0] @ bed.x + evaluate_matrix(form.u, values)[0] @ u)


@pytest.mark.parametrize(
    ("name", "share"), [("differential", 1e-9), ("differential_gearboxes", 0.01), ("all_wheel_drive", 0.03)]
)
def test_friction_shows_in_the_commands_and_moves_no_speed(projects, name, share):
    """A constant slip-limiting torque is W T in the commands (7.29); sensors hardly take it for a twist."""
    project = projects[name]
    prediction = predict_loop(project.design, project.testbed)
    bed, T = NominalBed(project), np.full(len(prediction.disturbances), 10.0)
    bed.step({}, 0 * T)
    for _ in range(2000):
        _, u = bed.step(dict.fromkeys(prediction.references, 0.0), T)
    assert abs(u - prediction.W @ T).max() < share * T.sum()
    assert abs(bed.x).max() < 1e-3


def test_prediction_of_the_differential_is_that_of_the_source(projects):
    """(7.28): gains of the references; (7.34): stationary torques; (7.29): the slip-limiting torque."""
    project = projects["differential"]
    q = predict_loop(project.design, project.testbed)
    gains, i_d, I_m2 = project.design.gains, 1.91, 10.3
    share = project.design.gains.inertia_estimate["M1"] * i_d / 2 / I_m2
    assert q.references == ("diff_input_torque_ref", "M2_speed_ref", "M3_speed_ref")
    expected = [[1, share * gains.speed["M2"], share * gains.speed["M3"]], [0, gains.speed["M2"], 0], [0, 0, gains.speed["M3"]]]  # fmt: skip  # noqa: E501
    assert pytest.approx(np.array(expected, dtype=float), rel=1e-12, abs=1e-12) == q.D
    assert q.stationary == pytest.approx(np.array([[1, 0, 0], [-i_d / 2, 0, 0], [-i_d / 2, 0, 0]]), abs=1e-9)
    assert pytest.approx(np.array([[0.0], [0.5], [-0.5]]), abs=1e-12) == q.W


def test_matrices_have_names_and_units(prediction):
    for symbol, matrix in prediction.matrices().items():
        assert matrix.values.shape == (len(matrix.rows), len(matrix.columns)), symbol
        assert len(matrix.row_units) == len(matrix.rows)
        assert len(matrix.column_units) == len(matrix.columns)
        assert matrix.text


def test_references_of_a_pair_are_those_of_its_machines(root, tmp_path):
    text = (root / "testbeds" / "differential.toml").read_text(encoding="utf-8")
    path = tmp_path / "paired.toml"
    path.write_text(text.replace('speed = ["M2", "M3"]', 'speed = ["M2", "M3"]\nspeed_pairs = { axle = ["M2", "M3"] }'))
    from ptgen.project import Project

    paired, plain = Project.read(path), Project.read(root / "testbeds" / "differential.toml")
    one, other = (predict_loop(p.design, p.testbed) for p in (paired, plain))
    assert one.references == other.references
    assert pytest.approx(other.B, abs=1e-12) == one.B
    assert pytest.approx(other.D, abs=1e-12) == one.D


def test_a_loop_that_does_not_settle_is_refused(root, tmp_path):
    text = (root / "testbeds" / "differential.toml").read_text(encoding="utf-8")
    path = tmp_path / "fast.toml"
    path.write_text(text.replace('speed_bandwidth = "30 rad/s"', 'speed_bandwidth = "50000 rad/s"'))
    from ptgen.project import Project

    project = Project.read(path)
    with pytest.raises(ControlError, match=r"does not settle: .*M[23]"):
        predict_loop(project.design, dataclasses.replace(load(path)))

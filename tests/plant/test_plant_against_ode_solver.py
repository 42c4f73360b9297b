"""The emitted plant against SciPy's DOP853, with the same held inputs, between transitions of friction."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.simulate.build import build

BEDS = ["differential", "differential_gearboxes", "back_to_back"]


class Reference:
    """The equations of motion, integrated by DOP853; friction slips in a given sense."""

    def __init__(self, project: Project, parameters: dict[str, float]) -> None:
        self.model = project.model
        self.values = {
            **self.model.values,
            **{s: parameters[s.name] for s in self.model.values if s.name in parameters},
        }
        self.A, self.B, self.F = self.model.numeric(self.values).state_matrices()
        self.lags = [self.values[t.drive.time_constant] for t in self.model.inputs]
        self.n = self.A.shape[0]

    def capacity(self, x: np.ndarray, air_gap: np.ndarray) -> np.ndarray:
        result = []
        for friction in self.model.frictions:
            form = self.model.signals[friction.load.place]
            row = np.hstack([evaluate_matrix(form.z, self.values)[0], evaluate_matrix(form.e, self.values)[0]])
            coulomb, coefficient = (self.values[s] for s in (friction.coulomb, friction.load.coefficient))
            result.append(coulomb + coefficient * abs(row @ x))
        return np.array(result)

    def derivative(self, state: np.ndarray, command: np.ndarray, sense: np.ndarray) -> np.ndarray:
        x, air_gap = state[: self.n], state[self.n :]
        friction = sense * self.capacity(x, air_gap) if len(sense) else np.zeros(0)
        return np.concatenate([self.A @ x + self.B @ air_gap + self.F @ friction, (command - air_gap) / self.lags])

    def run(self, start: np.ndarray, applied, duration: float, h: float, dead_time: float, sense) -> np.ndarray:
        """Integrate piece by piece, so that no piece has a jump of the command inside."""
        edges = np.arange(0, duration + h / 2, h)
        shifted = edges + dead_time % h
        times = np.unique(np.round(np.concatenate([edges, shifted[shifted < duration]]), 12))
        state = start
        for begin, end in itertools.pairwise(times):
            command = applied((begin + end) / 2 - dead_time)
            state = solve_ivp(
                lambda _, y, u=command: self.derivative(y, u, sense),
                (begin, end),
                state,
                "DOP853",
                rtol=1e-11,
                atol=1e-11,
            ).y[:, -1]
        return state


def run_emitted(project, parameters: dict[str, float], start: np.ndarray, applied, steps: int, h: float) -> np.ndarray:
    plant = build(project).plant
    params = plant.parameters({**parameters, "sample_time": h})
    status, state = plant.init(params)
    assert status == 0, plant.status_text(status)
    x = plant.read(state, "x")
    x[: len(start)] = start
    plant.write(state, "x", x)
    for k in range(steps):
        status, _ = plant.step(
            state, params, dict(zip([s.name for s in plant.block.inputs], applied(k * h + h / 2), strict=True))
        )
        assert status == 0
    return plant.read(state, "x")[: len(start)]


def applied_torques(machines: int, h: float):
    def at(time: float) -> np.ndarray:
        if time < 0:
            return np.zeros(machines)
        k = np.floor(time / h + 1e-9)
        return np.array([200.0 * np.sin(0.7 * k + i) + 100.0 for i in range(machines)])

    return at


def slipping_start(project: Project) -> np.ndarray:
    """Return a state in which every friction element slips fast in the positive sense."""
    model = project.model
    start = np.zeros(model.order + len(model.inputs))
    n_f = len(model.frictions)
    values = np.array([evaluate_matrix(row, model.values)[0] for row in model.velocity_rows.values()])
    assert values.shape[1] == len(model.coordinates)
    # a rigid-body motion with all friction velocities positive strains no shaft
    numeric = model.numeric()
    E = numeric.twist_rows
    _, _, vt = np.linalg.svd(E)
    rigid = vt[np.linalg.matrix_rank(E) :].T
    wanted = np.array([60.0, 25.0][:n_f])
    motion = (
        rigid @ np.linalg.lstsq(rigid[:n_f] if n_f else rigid[:1], wanted if n_f else np.array([60.0]), rcond=None)[0]
    )
    start[: len(motion)] = motion
    return start


@pytest.mark.compile
@pytest.mark.parametrize("dead_time", [1e-4, 1.37e-4])
@pytest.mark.parametrize("name", BEDS)
def test_exact_without_load_dependence(name: str, dead_time: float, projects) -> None:
    project = projects[name]
    h = project.testbed.sample_time
    parameters = {s.name: s.value for s in project.plant.parameters if s.name != "sample_time"}
    parameters |= {key: dead_time for key in parameters if key.endswith("_dead_time")}
    parameters |= {key: 0.0 for key in parameters if key.endswith("_load")}
    reference = Reference(project, parameters)
    start = slipping_start(project)
    applied = applied_torques(len(project.model.inputs), h)
    steps = 100
    expected = reference.run(start, applied, steps * h, h, dead_time, np.ones(len(project.model.frictions)))
    got = run_emitted(project, parameters, start, applied, steps, h)
    n_z, n_e = len(project.model.coordinates), len(project.model.twists)
    for part in (slice(0, n_z), slice(n_z, n_z + n_e), slice(n_z + n_e, None)):
        assert np.abs(got[part] - expected[part]).max() < 1e-9 * np.abs(expected[part]).max()


@pytest.mark.compile
@pytest.mark.parametrize("name", ["differential", "differential_gearboxes"])
def test_order_two_with_load_dependence(name: str, projects) -> None:
    project = projects[name]
    sample_time = project.testbed.sample_time
    parameters = {s.name: s.value for s in project.plant.parameters if s.name != "sample_time"}
    parameters |= {key: 0.05 for key in parameters if key.endswith("_load")}
    reference = Reference(project, parameters)
    start = slipping_start(project)
    machines = len(project.model.inputs)
    applied = lambda time: np.full(machines, 150.0) if time >= 0 else np.zeros(machines)  # noqa: E731
    duration = 100 * sample_time
    expected = reference.run(start, applied, duration, sample_time, 1e-4, np.ones(len(project.model.frictions)))
    n_z = len(project.model.coordinates)
    errors = []
    for divisor in (1, 2, 4):
        h = sample_time / divisor
        got = run_emitted(project, parameters, start, applied, 100 * divisor, h)
        errors.append(np.abs(got[:n_z] - expected[:n_z]).max())
    orders = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert np.all(orders > 1.9), (errors, orders)

"""Sticking is exact: velocity 0.0, torque inside its limit, no chatter; energy is never made."""

from __future__ import annotations

import numpy as np
import pytest

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario


def capacities(project: Project, signals: dict[str, np.ndarray], name: str) -> np.ndarray:
    """Return the capacity of a friction element along a recording, from the load at the same time."""
    friction = next(f for f in project.model.frictions if f.name == name)
    values = project.model.values
    load = signals[friction.load.place.replace(".", "_") + "_torque"]
    return values[friction.coulomb] + values[friction.load.coefficient] * np.abs(load)


@pytest.mark.compile
@pytest.mark.parametrize("controller", ["decoupling", "conventional"])
@pytest.mark.parametrize("name", ["differential-standstill", "differential-differential-speed", "differential-run"])
def test_scenarios_stick_exactly(name: str, controller: str, projects, root) -> None:
    project = projects["differential"]
    scenario = load_scenario(root / "scenarios" / f"{name}.toml", project.testbed)
    recording = simulate(project, scenario, controller=controller)
    stuck_somewhere = False
    for friction in project.model.frictions:
        key = friction.name.replace(".", "_")
        speed, torque = recording.signals[f"{key}_speed"], recording.signals[f"{key}_torque"]
        stuck = speed == 0.0
        stuck_somewhere |= bool(stuck[1:].any())
        # The capacity belongs to the middle of the step, the load is recorded at its ends.
        load = capacities(project, recording.signals, friction.name)
        assert np.all(np.abs(torque[stuck]) <= 1.02 * load[stuck] + 0.5)
        # No chatter: an element that sticks does so for a while.
        assert np.count_nonzero(np.diff(stuck.astype(int))) < 40
    assert stuck_somewhere


@pytest.mark.compile
def test_constant_torque_below_break_away_holds_for_ever(projects) -> None:
    """Torques that the limited slip can hold leave its velocity exactly zero, every step."""
    project = projects["differential"]
    plant = build(project).plant
    params = plant.defaults()
    status, state = plant.init(params)
    assert status == 0
    torques = {"M1_torque_ref": 0.0, "M2_torque_ref": 4.0, "M3_torque_ref": -4.0}
    for _ in range(20_000):
        status, outputs = plant.step(state, params, torques)
        assert status == 0
        assert outputs["diff_limited_slip_speed"] == 0.0
        assert abs(outputs["diff_limited_slip_torque"]) <= params.diff_limited_slip_coulomb + 5.0


@pytest.mark.compile
def test_break_away_starts_slip_and_locks_again(projects) -> None:
    project = projects["differential"]
    plant = build(project).plant
    params = plant.defaults()
    _, state = plant.init(params)
    speeds = []
    for k in range(40_000):
        push = 200.0 if k < 1000 else 0.0
        _, outputs = plant.step(state, params, {"M1_torque_ref": 0.0, "M2_torque_ref": -push, "M3_torque_ref": push})
        speeds.append(outputs["diff_limited_slip_speed"])
    speeds = np.array(speeds)
    assert np.abs(speeds[:1000]).max() > 1.0
    assert np.all(speeds[-1000:] == 0.0)
    changes = np.count_nonzero(np.diff((speeds != 0.0).astype(int)))
    assert changes < 60, "chatter"


def energy(project: Project, x: np.ndarray) -> np.ndarray:
    numeric = project.model.numeric()
    n_z, n_e = len(project.model.coordinates), len(project.model.twists)
    z, e = x[..., :n_z], x[..., n_z : n_z + n_e]
    kinetic = 0.5 * np.einsum("...i,ij,...j->...", z, numeric.mass, z)
    return kinetic + 0.5 * np.einsum("...i,ij,...j->...", e, numeric.stiffness, e)


@pytest.mark.parametrize("seed", range(20))
def test_a_bed_without_drive_only_loses_energy(seed: int, projects) -> None:
    project = projects["differential"]
    plant = NumpyBlock(project.plant)
    parameters = plant.defaults()
    derived = plant.prepare(parameters)
    rng = np.random.default_rng(seed)
    states = plant.initial()
    n_z, n_e = len(project.model.coordinates), len(project.model.twists)
    states["x"][:n_z] = rng.normal(size=n_z) * 10.0
    states["x"][n_z : n_z + n_e] = rng.normal(size=n_e) * 1e-3
    inputs = {signal.name: np.array(0.0) for signal in project.plant.inputs}
    before = float(energy(project, states["x"]))
    for _ in range(300):
        states, _ = plant.step(parameters, derived, states, inputs)
        after = float(energy(project, states["x"]))
        assert after <= before * (1 + 1e-12)
        before = after

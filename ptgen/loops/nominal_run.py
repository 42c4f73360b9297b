r"""Runs on the nominal loop: the emitted controller on the reduced plant, which is what a governor predicts with.

The plant is the reduced model with the inertias that the law takes for its own, sampled exactly, torques held over a
step (7.22). No dead time, no lag, no friction, no losses: what goes wrong here is the governor's.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Mapping

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.errors import Problem, RunError
from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.layout import signal_name
from ptgen.project import Project
from ptgen.simulate.drives import value_at
from ptgen.simulate.library import Library
from ptgen.simulate.recording import Recording
from ptgen.testbed.scenario import Scenario

__all__ = ["nominal_run"]

Array = NDArray[np.float64]


def nominal_run(
    project: Project,
    scenario: Scenario,
    library: Library,
    parameters: Mapping[str, float],
    recorded: Mapping[str, str],
    progress: Callable[[float], None] | None = None,
) -> Recording:
    """Run a scenario with the compiled controller on the reduced plant; every step is recorded.

    Parameters
    ----------
    project : Project
    scenario : Scenario
    library : Library
        Compiled code of the bed.
    parameters : mapping
        Parameters of the controller that differ from their defaults; those of the plant are passed over.
    recorded : mapping of str to str
        States of the controller that are recorded, and their units.
    progress : callable, optional
        Called now and then with the share that is done.

    Raises
    ------
    RunError
        If the controller reports a fault.
    """
    controller, bed = library.controller, _ReducedPlant(project)
    block = controller.block
    # What sensors miss of the inertias that the reduced model leaves out is no part of the reduced plant.
    given = {signal.name: 0.0 for signal in block.parameters if "_sensor_inertia_" in signal.name}
    given |= {name: value for name, value in parameters.items() if block.signal(name) is not None}
    params = controller.parameters(given)
    status, state = controller.init(params)
    _check(status, controller.status_text(status), "initialisation")
    steps = round(scenario.duration / project.testbed.sample_time)
    times = np.arange(steps, dtype=np.float64) * project.testbed.sample_time
    courses = {
        signal: np.array([value_at(scenario.references[key], t) for t in times])
        for key, signal in project.design.controller.references.items()
    }
    inputs, outputs = controller.inputs_type(), controller.outputs_type()
    for signal in block.inputs:
        setattr(inputs, signal.name, signal.value)
    sensors = [(k, name) for k, name in enumerate(bed.sensors) if block.signal(name) is not None]
    commands = [f"{name}_torque_ref" for name in bed.machines]
    rows = np.zeros((steps, len(bed.measured) + len(commands) + len(recorded)))
    report = max(1, steps // 100)
    start = clock.perf_counter()
    for step in range(steps):
        read = bed.read()
        for name, course in courses.items():
            setattr(inputs, name, course[step])
        for k, name in sensors:
            setattr(inputs, name, read[k])
        if status := controller.step_struct(state, params, inputs, outputs):
            _check(status, controller.status_text(status), f"the nominal run at {times[step]:.4g} s")
        torques = [getattr(outputs, name) for name in commands]
        rows[step] = [*bed.see(read), *torques, *(getattr(state, name) for name in recorded)]
        bed.step(torques)
        if progress is not None and step % report == 0:
            progress(step / steps)
    wall = clock.perf_counter() - start
    names = [*bed.measured, *commands, *recorded]
    units = {**bed.units, **dict.fromkeys(commands, "N m"), **recorded}
    signals = {name: rows[:, k] for k, name in enumerate(names)} | courses
    units |= {name: "N m" if name.endswith("torque_ref") else "rad/s" for name in courses}
    return Recording(times, signals, units, steps, wall, project.testbed.sample_time)


class _ReducedPlant:
    """The reduced plant under torques that are held over each step."""

    def __init__(self, project: Project) -> None:
        design = project.design
        decoupling = design.decoupling
        model, values = decoupling.model, {**decoupling.values, **design.tuned_inertia}

        def numbers(matrix: sp.Matrix) -> Array:
            return np.asarray(evaluate_matrix(matrix, values), dtype=np.float64)

        A, B = numbers(decoupling.system.A), numbers(decoupling.system.B)
        n, m = B.shape
        held = scipy.linalg.expm(np.block([[A, B], [np.zeros((m, n + m))]]) * project.testbed.sample_time)
        self._A, self._B = held[:n, :n], held[:n, n:]
        self.machines = decoupling.machines
        places = {signal_name(place): place for place in decoupling.outputs[: decoupling.torque_count]}
        names = {**{name: name for name in decoupling.sensors}, **places}
        forms = [model.without_acceleration(model.signals[place]) for place in names.values()]
        self._C = np.vstack([np.hstack([numbers(form.z), numbers(form.e)]) for form in forms])
        self._D = np.vstack([numbers(form.u) for form in forms])
        self.sensors = tuple(decoupling.sensors)
        self.measured = tuple(names)
        units = {sensor.name: "N m" if sensor.name.endswith("_torque") else "rad/s" for sensor in model.sensors}
        self.units = {name: units.get(name, "N m") for name in self.measured}
        self._x, self._torques = np.zeros(n), np.zeros(m)

    def read(self) -> Array:
        """Return what sensors and places show, before new torques act."""
        return np.asarray(self._C @ self._x + self._D @ self._torques)

    def see(self, read: Array) -> list[float]:
        """Return the values that are recorded."""
        return [float(value) for value in read]

    def step(self, torques: list[float]) -> None:
        """Hold the torques over a step."""
        self._torques = np.asarray(torques)
        self._x = self._A @ self._x + self._B @ self._torques


def _check(status: int, text: str, when: str) -> None:
    """Raise what a status of the controller says."""
    if status:
        remedy = "see ptgen simulate for the same scenario on the whole bed"
        raise RunError(Problem("", f"{when} ended with the status: {text}", remedy))

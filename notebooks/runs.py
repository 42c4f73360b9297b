"""Runs of beds for the notebooks: the emitted C step by step, and the event-driven reference, under the same torques.

Torques and actuations are functions of time. The emitted plant holds them over each step at their value in the middle;
the reference takes them as they are. Both give the same signals at the same times: speeds of machines, and speed and
torque of every friction element, named as the outputs of the emitted plant.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from beds import bed, machine, table

from ptgen.friction.events import EventDriven, Transition
from ptgen.project import Project
from ptgen.simulate.build import build

Torques = Mapping[str, Callable[[float], float]]


@dataclass(frozen=True)
class Run:
    """Signals over time; `transitions` are those that the reference located, none for the emitted plant."""

    time: np.ndarray
    signals: Mapping[str, np.ndarray]
    transitions: tuple[Transition, ...] = ()

    def __getitem__(self, name: str) -> np.ndarray:
        return self.signals[name]


class _Uncontrolled(Project):
    """A bed that is emitted for its plant, with the controller of two machines and a torque flange.

    Plant and controller of a bed are emitted together, and ptgen refuses to design a controller without the torque
    flanges that its law would need.
    """

    def __init__(self, project: Project) -> None:
        super().__init__(project.testbed)
        chain = ["M1 - flange1 - M2"]
        flange = table("flange1", "torque_flange", stiffness="1 kN m/rad", inertia="0.01 kg m^2")
        self._other = bed(chain, machine("M1"), machine("M2"), flange, torque={"M1": "flange1"}, speed=["M2"])

    @cached_property
    def design(self):
        return self._other.design


def run_emitted(
    project: Project,
    velocities: Sequence[float],
    torques: Torques,
    actuations: Torques,
    duration: float,
    step: float = 1e-4,
) -> Run:
    """Run the emitted plant; `velocities` are those of the coordinates at the start (rad/s)."""
    plant = build(_Uncontrolled(project)).plant
    parameters = plant.parameters({"sample_time": step})
    status, state = plant.init(parameters)
    if status:
        raise RuntimeError(plant.status_text(status))
    x = np.zeros(plant.block.declared("x").shape)
    x[: len(velocities)] = velocities
    plant.write(state, "x", x)
    inputs = {f"{name}_torque_ref": value for name, value in torques.items()}
    inputs |= {f"{name}_actuation": value for name, value in actuations.items()}
    rows = [plant.measure(state, parameters)]
    for k in range(round(duration / step)):
        status, outputs = plant.step(state, parameters, {name: f((k + 0.5) * step) for name, f in inputs.items()})
        if status:
            raise RuntimeError(plant.status_text(status))
        rows.append(outputs)
    return Run(step * np.arange(len(rows)), {name: np.array([row[name] for row in rows]) for name in rows[0]})


def run_by_events(
    project: Project,
    velocities: Sequence[float],
    torques: Torques,
    actuations: Torques,
    breakpoints: Sequence[float],
    times: np.ndarray,
) -> Run:
    """Run the event-driven reference from time zero, and read its signals at `times`, which are later."""
    model = project.plant_model
    reference = EventDriven(model)
    given = [torques[torque.name] for torque in model.inputs]
    state = reference.initial(velocities)
    rows = []
    for time in times:
        state = reference.advance(
            state, float(time), lambda t: np.array([f(t) for f in given]), actuations, breakpoints
        )
        rows.append(_named(reference, model, state))
    return Run(times, {name: np.array([row[name] for row in rows]) for name in rows[0]}, state.transitions)


def _named(reference: EventDriven, model, state) -> dict[str, float]:
    signals = reference.signals(state)
    speeds = reference.friction_velocities(state)
    for friction, speed in zip(model.frictions, speeds, strict=True):
        name = friction.name.replace(".", "_")
        signals |= {f"{name}_torque": signals.pop(friction.name), f"{name}_speed": float(speed)}
    return signals

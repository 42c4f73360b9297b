"""A scenario with the emitted controller and the event-driven plant."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ptgen.emit.c_block import BAD_INPUT
from ptgen.emit.project import actuation_names, ratio_names, recorded_signals
from ptgen.errors import Problem, RunError
from ptgen.friction.events import EventDriven, EventState
from ptgen.plant.layout import identifier, signal_name
from ptgen.plant.signals import fluid_signals
from ptgen.project import Project
from ptgen.simulate.closed_loop import REPORTS, ClosedLoop
from ptgen.simulate.drives import Commands, course, kinks, value_at
from ptgen.simulate.library import Library
from ptgen.testbed.profile import Profile

__all__ = ["run_by_events"]


def run_by_events(
    project: Project,
    library: Library,
    loop: ClosedLoop,
    profiles: Mapping[str, Profile],
    steps: int,
    every: int,
    recording: np.ndarray,
    progress: Callable[[float], None] | None = None,
) -> int:
    """Do the steps of a closed loop whose plant is `ptgen.friction.events`; the controller is the compiled one.

    Torque references pass the same envelope, dead time and lag as in the emitted plant; actuations act as the
    continuous functions of time that they are, of which the emitted plant takes the value in the middle of each step.

    Parameters
    ----------
    project : Project
    library : Library
    loop : ClosedLoop
        Holds parameters, the controller's state and all signals; status as after steps in C.
    profiles : mapping of str to Profile
        References and actuations, by the names of their signals.
    steps, every : int
        Steps to do, and steps between two rows of the recording.
    recording : ndarray (rows, signals)
        Filled row by row.
    progress : callable, optional
        Called now and then with the share that is done.

    Returns
    -------
    int
        Steps that were done.

    Raises
    ------
    RunError
        If a ratio changes, or the bed cannot be simulated, see `ptgen.friction.events.EventDriven.advance`.
    """
    struct, plant = loop.struct, _Plant(project, loop, profiles)
    references = [name for name in profiles if name not in plant.actuations]
    taken = {signal.name for signal in library.controller.block.inputs}
    references = [name for name in references if name in taken]
    known = {signal.name for signal in library.plant.block.outputs}
    measured = [signal.name for signal in library.controller.block.inputs if signal.name in known]
    places = [signal.place.removeprefix("run->").split(".") for signal in recorded_signals(project)]
    for step in range(steps):
        time = step * plant.sample_time
        for name in references:
            setattr(struct.inputs, name, value_at(profiles[name], time))
        for name in measured:
            setattr(struct.inputs, name, getattr(struct.measured, name))
        status = library.controller.step_struct(
            struct.controller, struct.controller_params, struct.inputs, struct.commands
        )
        plant.drive(step)
        if step % every == 0 and step // every < len(recording):
            recording[step // every] = [getattr(getattr(struct, part), name) for part, name in places]
        refused = plant.advance(step)
        struct.status = struct.status or status or -refused
        struct.step = step + 1
        if progress is not None and (step + 1) % max(1, steps // REPORTS) == 0:
            progress((step + 1) / steps)
    return steps


class _Plant:
    """The event-driven plant behind its drives; its inputs and outputs are those of the emitted one."""

    def __init__(self, project: Project, loop: ClosedLoop, profiles: Mapping[str, Profile]) -> None:
        model, self._struct = project.plant_model, loop.struct
        self.sample_time = float(loop.struct.plant_params.sample_time)
        symbols = {symbol.name: symbol for symbol in model.values}
        parameters = {
            name: float(getattr(loop.struct.plant_params, name))
            for name, *_ in loop.struct.plant_params._fields_
            if name in symbols
        }
        values = {**model.values, **{symbols[name]: value for name, value in parameters.items()}}
        self.ratios = {signal: _constant(profiles[signal], name) for name, signal in ratio_names(project).items()}
        parameters |= self.ratios
        values |= {symbols[name]: value for name, value in self.ratios.items()}
        self._model = model
        self._bed = EventDriven(model, parameters, lags=True)
        self._state = self._bed.initial()
        self._commands = {t.name: Commands(t, model, values, self.sample_time) for t in model.inputs}
        elements = {signal: name for name, signal in actuation_names(project).items()}
        self.actuations = {name: profile for name, profile in profiles.items() if name in elements}
        self._by_element = {elements[name]: profile for name, profile in self.actuations.items()}
        self._inputs = project.plant.inputs
        self._outputs = [signal.name for signal in project.plant.outputs]

    def drive(self, step: int) -> None:
        """Take commands and actuations over into the inputs of the plant."""
        driven, middle = self._struct.driven, step * self.sample_time + 0.5 * self.sample_time
        for name in self._commands:
            setattr(driven, f"{name}_torque_ref", getattr(self._struct.commands, f"{name}_torque_ref"))
        for name, profile in self.actuations.items():
            setattr(driven, name, value_at(profile, middle))
        for name, value in self.ratios.items():
            setattr(driven, name, value)

    def advance(self, step: int) -> int:
        """Go on by one step and measure; return the status, after which the state has stayed as it was."""
        start, end = step * self.sample_time, (step + 1) * self.sample_time
        if status := self._refused():
            self._state = replace(self._state, time=end)
            return status
        n_z = len(self._model.coordinates)
        inside: set[float] = set()
        for name, commands in self._commands.items():
            commands.push(getattr(self._struct.driven, f"{name}_torque_ref"), self._state.x[:n_z])
            if 1e-6 * self.sample_time < commands.switch < (1 - 1e-6) * self.sample_time:
                inside.add(start + commands.switch)
        for profile in self._by_element.values():
            inside.update(kinks(profile, start, end))
        for begin, until in pairwise([start, *sorted(inside), end]):
            since = 0.5 * (begin + until) - start
            torques = np.array([commands.acting(since) for commands in self._commands.values()])
            actuations = {name: course(profile, begin, until) for name, profile in self._by_element.items()}
            self._state = self._bed.advance(self._state, until, torques, actuations)
        self._state = replace(self._state, transitions=())
        found = self._measured(self._state)
        for name in self._outputs:
            setattr(self._struct.measured, name, found[name])
        return 0

    def _refused(self) -> int:
        """Return the status of the emitted plant for the first input that it would not take."""
        for index, signal in enumerate(self._inputs):
            value = getattr(self._struct.driven, signal.name)
            least = -math.inf if signal.least is None else signal.least
            most = math.inf if signal.most is None else signal.most
            if not (math.isfinite(value) and least <= value <= most):
                return BAD_INPUT + index
        return 0

    def _measured(self, state: EventState) -> dict[str, float]:
        model, signals = self._model, self._bed.signals(state)
        measured = self._bed.measured(state)
        sensors = {sensor.name for sensor in model.sensors}
        found = {name if name in sensors else signal_name(name): signals[name] for name in model.signals}
        found |= {f"{name}_true": signals[name] for name in measured} | measured
        for torque, value in zip(model.inputs, state.air_gap, strict=True):
            found[f"{torque.name}_torque"] = float(value)
        for friction, speed in zip(model.frictions, self._bed.friction_velocities(state), strict=True):
            found[f"{identifier(friction)}_torque"] = signals[friction.name]
            found[f"{identifier(friction)}_speed"] = float(speed)
        fluids = [name for fluid in model.fluids for name in fluid_signals(fluid)]
        found |= dict(zip(fluids, state.contact_torque[len(model.contacts) :].tolist(), strict=True))
        return found


def _constant(profile: Profile, gearbox: str) -> float:
    """Return the value of a ratio that stays the same.

    Raises
    ------
    RunError
        If it does not.
    """
    first = profile.value[0]
    if any(value != first for value in profile.value):
        what = "changes in the scenario, which the event-driven plant does not follow"
        raise RunError(Problem(f"ratios.{gearbox}", what, "leave out --method events, or keep the ratio constant"))
    return first

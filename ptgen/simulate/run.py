"""A scenario in closed loop: in one call inside the emitted C, or with the plant simulated event by event."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from typing import Literal

import numpy as np

from ptgen.emit.project import actuation_names, controller_ratio_names, ratio_names, recorded_signals
from ptgen.errors import Problem, RunError
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.closed_loop import ClosedLoop, ControllerName
from ptgen.simulate.events_run import run_by_events
from ptgen.simulate.library import Library
from ptgen.simulate.recording import Recording
from ptgen.testbed.profile import Profile
from ptgen.testbed.scenario import Scenario

__all__ = ["ControllerName", "MethodName", "simulate"]

MethodName = Literal["emitted", "events"]

_OPEN = Profile((0.0,), (0.0,), "lines")
"""The actuation of an element that the scenario does not name."""

_MOST_NUMBERS = 200_000_000
"""Recorded numbers that a run may keep: 1.6 GB."""


def simulate(
    project: Project,
    scenario: Scenario,
    *,
    controller: ControllerName = "decoupling",
    method: MethodName = "emitted",
    library: Library | None = None,
    progress: Callable[[float], None] | None = None,
    parameters: Mapping[str, float] | None = None,
) -> Recording:
    """Run a scenario.

    Parameters
    ----------
    project : Project
    scenario : Scenario
    controller : {"decoupling", "conventional"}
        Decoupling with active damping, or the baseline of the source's Figure 5.10.
    method : {"emitted", "events"}
        The plant as it is emitted, or simulated from one event of friction to the next with tight tolerances: a
        thousand times slower, and meant to be compared with. The controller is the emitted one in both cases.
    library : Library, optional
        Compiled code of this bed; it is built if it is not given.
    progress : callable, optional
        Called now and then with the share of the run that is done.
    parameters : mapping, optional
        Parameters of plant and controller that differ from their defaults, by name.

    Raises
    ------
    RunError
        If code cannot be built, a parameter is unknown or out of its range, or controller or plant found a fault.
    KeyboardInterrupt
        If the user stops the run.
    """
    library = library or build(project)
    signals = recorded_signals(project)
    sample_time = project.testbed.sample_time
    steps = round(scenario.duration / sample_time)
    every = max(1, round(scenario.record_every / sample_time))
    rows = (steps + every - 1) // every
    if rows * len(signals) > _MOST_NUMBERS:
        what = f"gives {rows} rows of {len(signals)} signals, more than fit into memory"
        least = every * (rows * len(signals) / _MOST_NUMBERS) * sample_time
        raise RunError(Problem("scenario.record_every", what, f"take {least:.2g} s or more, or a shorter duration"))
    named = project.design.controller.references
    references = {signal: scenario.references[key] for key, signal in named.items()}
    actuations = {signal: scenario.actuations.get(name, _OPEN) for name, signal in actuation_names(project).items()}
    ratios = {
        signal: _ratio(project, scenario, name)
        for names in (ratio_names(project), controller_ratio_names(project))
        for name, signal in names.items()
    }
    profiles = {**references, **actuations, **ratios}
    loop = ClosedLoop(library, list(profiles.values()), controller, parameters or {})
    recording = np.zeros((rows, len(signals)))
    start = time.perf_counter()
    if method == "emitted":
        done = loop.steps(steps, every, recording, progress)
    else:
        done = run_by_events(project, library, loop, profiles, steps, every, recording, progress)
    wall = time.perf_counter() - start
    if done < steps:
        raise KeyboardInterrupt
    loop.check("the run")
    return Recording(
        time=np.arange(rows, dtype=np.float64) * (every * sample_time),
        signals={signal.name: recording[:, index] for index, signal in enumerate(signals)},
        units={signal.name: signal.unit for signal in signals},
        steps=done,
        wall_s=wall,
        sample_time=sample_time,
        gears=dict(scenario.gears),
        shifts=scenario.shifts,
    )


def _ratio(project: Project, scenario: Scenario, name: str) -> Profile:
    """Return the course of a ratio; without one in the scenario it stays as the bed file has it."""
    return scenario.ratios.get(name) or Profile((0.0,), (project.testbed.ratios[name].value,), "lines")

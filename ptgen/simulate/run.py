"""A scenario in closed loop, in one call inside the emitted C."""

from __future__ import annotations

import ctypes
import signal
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, Literal

import numpy as np

from ptgen.emit.project import recorded_signals
from ptgen.errors import Problem, RunError, nearest
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import PROFILE_FIELDS, Library
from ptgen.simulate.recording import Recording
from ptgen.testbed.scenario import Scenario

__all__ = ["ControllerName", "simulate"]

ControllerName = Literal["decoupling", "conventional"]

_REPORTS = 200

_MOST_NUMBERS = 200_000_000
"""Recorded numbers that a run may keep: 1.6 GB."""


def simulate(
    project: Project,
    scenario: Scenario,
    *,
    controller: ControllerName = "decoupling",
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
    library : Library, optional
        Compiled code of this bed; it is built if it is not given.
    progress : callable, optional
        Called now and then with the share of the run that is done.
    parameters : mapping, optional
        Parameters of plant and controller that differ from their defaults, by name.

    Raises
    ------
    RunError
        If code cannot be built, a parameter is unknown or out of its range, or the controller found a fault.
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
    run = _Run(library, len(project.design.controller.references))
    run.set_parameters(controller, parameters or {})
    run.check("initialisation")
    profiles, kept = _profiles(project, scenario)
    recording = np.zeros((rows, len(signals)))
    start = time.perf_counter()
    done = run.steps(profiles, steps, every, recording, progress)
    wall = time.perf_counter() - start
    del kept
    if done < steps:
        raise KeyboardInterrupt
    run.check("the run")
    return Recording(
        time=np.arange(rows, dtype=np.float64) * (every * sample_time),
        signals={signal.name: recording[:, index] for index, signal in enumerate(signals)},
        units={signal.name: signal.unit for signal in signals},
        steps=done,
        wall_s=wall,
        sample_time=sample_time,
    )


class _Run:
    """The struct ``<bed>_run`` in memory."""

    def __init__(self, library: Library, references: int) -> None:
        controller, plant = library.controller, library.plant
        fields = [
            ("controller_params", controller.params_type),
            ("plant_params", plant.params_type),
            ("controller", controller.state_type),
            ("plant", plant.state_type),
            ("inputs", controller.inputs_type),
            ("commands", controller.outputs_type),
            ("measured", plant.outputs_type),
            ("cursor", ctypes.c_long * references),
            ("step", ctypes.c_long),
            ("status", ctypes.c_int),
        ]
        kind: Any = type("run", (ctypes.Structure,), {"_fields_": fields})
        self._library = library
        self._struct = kind()
        size = getattr(library.handle, f"{library.prefix}_run_size")
        size.restype = ctypes.c_size_t
        if size() != ctypes.sizeof(kind):
            what = f"{library.path.name} has another layout than this version of ptgen emits"
            raise RunError(Problem("", what, "delete it, it will be built anew"))

    def set_parameters(self, controller: ControllerName, parameters: Mapping[str, float]) -> None:
        library, struct = self._library, self._struct
        variant = "defaults" if controller == "decoupling" else "conventional"
        struct.controller_params = library.controller.defaults(variant)
        struct.plant_params = library.plant.defaults()
        known = {name for part in ("controller_params", "plant_params") for name, *_ in getattr(struct, part)._fields_}
        problems = [
            Problem(name, "is no parameter of this bed", nearest(name, known))
            for name in parameters
            if name not in known
        ]
        if problems:
            raise RunError(problems)
        for name, value in parameters.items():
            for part in (struct.controller_params, struct.plant_params):
                if hasattr(part, name):
                    setattr(part, name, value)
        getattr(library.handle, f"{library.prefix}_run_init")(ctypes.byref(struct))

    def check(self, when: str) -> None:
        """Raise what the status says."""
        status = int(self._struct.status)
        if status == 0:
            return
        block = self._library.controller if status > 0 else self._library.plant
        text = block.status_text(abs(status))
        raise RunError(
            Problem("", f"{when} ended with the status: {text}", "correct the parameter or the reference that it names")
        )

    def steps(
        self,
        profiles: Any,
        steps: int,
        every: int,
        recording: np.ndarray,
        progress: Callable[[float], None] | None,
    ) -> int:
        interrupted: list[BaseException] = []
        with _noted_interrupt() as stopped:

            def report(step: int, user: object) -> int:
                try:
                    if stopped():
                        raise KeyboardInterrupt
                    if progress is not None:
                        progress(step / steps)
                except BaseException as error:  # a callback from C cannot raise; it is raised again below
                    interrupted.append(error)
                    return 1
                return 0

            callback_type = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_long, ctypes.c_void_p)
            function = getattr(self._library.handle, f"{self._library.prefix}_run_steps")
            function.restype = ctypes.c_long
            done = function(
                ctypes.byref(self._struct),
                profiles,
                ctypes.c_long(steps),
                ctypes.c_long(every),
                recording.ctypes.data_as(ctypes.POINTER(ctypes.c_double)),
                ctypes.c_long(len(recording)),
                ctypes.c_long(max(1, steps // _REPORTS)),
                callback_type(report),
                None,
            )
        if stopped() and not interrupted:  # after the last report
            raise KeyboardInterrupt
        if interrupted:
            raise interrupted[0]
        return int(done)


@contextmanager
def _noted_interrupt() -> Iterator[Callable[[], bool]]:
    """Turn Ctrl-C into a note for as long as C code runs.

    Python would raise the interrupt somewhere inside a callback, where C code above it would swallow it.

    Yields
    ------
    stopped : callable
        Tells whether Ctrl-C was pressed.
    """
    noted: list[int] = []
    if threading.current_thread() is not threading.main_thread():  # only there signals can be caught
        yield lambda: False
        return
    before = signal.signal(signal.SIGINT, lambda number, frame: noted.append(number))
    try:
        yield lambda: bool(noted)
    finally:
        signal.signal(signal.SIGINT, before)


class _Profile(ctypes.Structure):
    _fields_ = PROFILE_FIELDS


def _profiles(project: Project, scenario: Scenario) -> tuple[Any, list[np.ndarray]]:
    """Return the references as C profiles, and the arrays that they point to."""
    keys = list(project.design.controller.references)
    profiles = (_Profile * len(keys))()
    kept = []
    pointer = ctypes.POINTER(ctypes.c_double)
    for index, key in enumerate(keys):
        profile = scenario.references[key]
        times, values = np.array(profile.time, dtype=float), np.array(profile.value, dtype=float)
        kept += [times, values]
        profiles[index] = _Profile(
            len(times), int(profile.shape == "steps"), times.ctypes.data_as(pointer), values.ctypes.data_as(pointer)
        )
    return profiles, kept

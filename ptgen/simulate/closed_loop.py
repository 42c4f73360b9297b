"""The emitted closed loop in memory: its parameters, its states, and steps that C does."""

from __future__ import annotations

import ctypes
import signal
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Literal

import numpy as np

from ptgen.errors import Problem, RunError, nearest
from ptgen.simulate.library import PROFILE_FIELDS, Library
from ptgen.testbed.profile import Profile

__all__ = ["REPORTS", "ClosedLoop", "ControllerName"]

ControllerName = Literal["decoupling", "conventional"]

REPORTS = 200
"""How often a run tells its progress."""


class _Profile(ctypes.Structure):
    _fields_ = PROFILE_FIELDS


class ClosedLoop:
    """The struct ``<bed>_run`` in memory, initialised.

    Parameters
    ----------
    library : Library
    profiles : sequence of Profile
        The references and then the actuations, in the order of the emitted names.
    controller : {"decoupling", "conventional"}
    parameters : mapping
        Parameters of plant and controller that differ from their defaults, by name.

    Attributes
    ----------
    struct : ctypes.Structure
        The struct.

    Raises
    ------
    RunError
        If a parameter is unknown or out of its range.
    """

    def __init__(
        self,
        library: Library,
        profiles: Sequence[Profile],
        controller: ControllerName,
        parameters: Mapping[str, float],
    ) -> None:
        fields = [
            ("controller_params", library.controller.params_type),
            ("plant_params", library.plant.params_type),
            ("controller", library.controller.state_type),
            ("plant", library.plant.state_type),
            ("inputs", library.controller.inputs_type),
            ("commands", library.controller.outputs_type),
            ("driven", library.plant.inputs_type),
            ("measured", library.plant.outputs_type),
            ("cursor", ctypes.c_long * len(profiles)),
            ("step", ctypes.c_long),
            ("status", ctypes.c_int),
        ]
        kind: Any = type("run", (ctypes.Structure,), {"_fields_": fields})
        self._library = library
        self._profiles = _CProfiles(profiles)
        self.struct = kind()
        size = getattr(library.handle, f"{library.prefix}_run_size")
        size.restype = ctypes.c_size_t
        if size() != ctypes.sizeof(kind):
            what = f"{library.path.name} has another layout than this version of ptgen emits"
            raise RunError(Problem("", what, "delete it, it will be built anew"))
        self._set_parameters(controller, parameters)
        getattr(library.handle, f"{library.prefix}_run_init")(ctypes.byref(self.struct))
        self.check("initialisation")

    def _set_parameters(self, controller: ControllerName, parameters: Mapping[str, float]) -> None:
        library, struct = self._library, self.struct
        struct.controller_params = library.controller.defaults(
            "defaults" if controller == "decoupling" else "conventional"
        )
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

    def check(self, when: str) -> None:
        """Raise what the status says.

        Raises
        ------
        RunError
            If it is not ok.
        """
        status = int(self.struct.status)
        if status == 0:
            return
        block = self._library.controller if status > 0 else self._library.plant
        text = block.status_text(abs(status))
        remedy = "correct the parameter, reference or actuation that it names"
        raise RunError(Problem("", f"{when} ended with the status: {text}", remedy))

    def steps(
        self, steps: int, every: int, recording: np.ndarray, progress: Callable[[float], None] | None = None
    ) -> int:
        """Do steps in C.

        Parameters
        ----------
        steps : int
        every : int
            Steps between two rows of the recording.
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
        KeyboardInterrupt
            If the user stops the run.
        """
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
                ctypes.byref(self.struct),
                self._profiles.array,
                ctypes.c_long(steps),
                ctypes.c_long(every),
                recording.ctypes.data_as(ctypes.POINTER(ctypes.c_double)),
                ctypes.c_long(len(recording)),
                ctypes.c_long(max(1, steps // REPORTS)),
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


class _CProfiles:
    """Profiles as an array of C structs, together with the numbers that these point to."""

    def __init__(self, profiles: Sequence[Profile]) -> None:
        self.array = (_Profile * len(profiles))()
        self._kept: list[np.ndarray] = []
        pointer = ctypes.POINTER(ctypes.c_double)
        for index, profile in enumerate(profiles):
            times, values = np.array(profile.time, dtype=float), np.array(profile.value, dtype=float)
            self._kept += [times, values]
            self.array[index] = _Profile(
                len(times), int(profile.shape == "steps"), times.ctypes.data_as(pointer), values.ctypes.data_as(pointer)
            )

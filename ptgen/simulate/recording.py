"""What a run leaves: signals over time."""

from __future__ import annotations

import io
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.files import write_file
from ptgen.testbed.shift_plan import Shift

__all__ = ["Recording"]


@dataclass(frozen=True)
class Recording:
    """Signals over time, in SI units.

    Attributes
    ----------
    time : ndarray (n,)
        Time (s).
    signals : mapping of str to ndarray (n,)
    units : mapping of str to str
    steps : int
        Steps that were done.
    wall_s : float
        Time that the steps took (s).
    sample_time : float
        Step (s).
    gears : mapping of str to str
        Component that shifts -> its gear at the start.
    shifts : tuple of Shift
        The gears that were wanted later on, in the order of time.
    """

    time: NDArray[np.float64]
    signals: Mapping[str, NDArray[np.float64]]
    units: Mapping[str, str]
    steps: int
    wall_s: float
    sample_time: float
    gears: Mapping[str, str] = field(default_factory=dict)
    shifts: tuple[Shift, ...] = ()

    @property
    def realtime_factor(self) -> float:
        """How much faster than the bed the run was."""
        return self.steps * self.sample_time / self.wall_s if self.wall_s > 0 else float("inf")

    def write_csv(self, path: Path) -> None:
        """Write all signals to a CSV file; the head line gives names and units.

        Raises
        ------
        PtgenError
            If the file cannot be written.
        """
        head = ["time (s)", *(f"{name} ({self.units[name]})" if self.units[name] else name for name in self.signals)]
        stream = io.StringIO()
        table = np.column_stack([self.time, *self.signals.values()])
        np.savetxt(stream, table, delimiter=",", fmt="%.9g", header=",".join(head), comments="")
        write_file(path, stream.getvalue())

    def summary(self) -> dict[str, Any]:
        """Return the numbers of the run, its shifts, and least, largest, rms and last value of every signal."""
        return {
            "steps": self.steps,
            "wall_s": self.wall_s,
            "realtime_factor": self.realtime_factor,
            "gears": dict(self.gears),
            "shifts": [asdict(shift) for shift in self.shifts],
            "signals": {
                name: {
                    "min": float(values.min()),
                    "max": float(values.max()),
                    "rms": float(np.sqrt(np.mean(values**2))),
                    "final": float(values[-1]),
                }
                for name, values in self.signals.items()
            },
        }

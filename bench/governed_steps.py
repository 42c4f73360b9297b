"""Computed time of every step of a governed controller in closed loop: ``python bench/governed_steps.py [BED]``.

The emitted plant and controller run scenarios; each step of the controller is done again five times from its state, and
the least time counts, as the machine may be shared. Printed for every governor: mean and largest time, iterations, and
the mean of the steps that took a certain number of iterations. The ratio is to the same controller without governor.
"""

from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import numpy as np

from ptgen.emit.project import recorded_signals
from ptgen.governor.shaping import KINDS
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.closed_loop import ClosedLoop
from ptgen.simulate.compiler import compile_library
from ptgen.testbed import load_scenario

ROOT = Path(__file__).resolve().parents[1]
REPEATED = 5


def times_of(project: Project, scenario: Path, kind: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return time (ns), iterations and status of every step."""
    library = build(project)
    folder = Path(mkdtemp(prefix="steps"))
    compile_library([Path(__file__).with_suffix(".c")], folder / "steps.so")
    least_time: Any = ctypes.CDLL(str(folder / "steps.so")).least_time
    least_time.restype = ctypes.c_double
    course = load_scenario(scenario, project.testbed)
    named = project.design.controller.references
    profiles = [course.references[key] for key in named]
    loop = ClosedLoop(library, profiles, "decoupling", {"governor": float(kind)})
    steps = round(course.duration / project.testbed.sample_time)
    run = loop.struct
    step = getattr(library.handle, f"{library.prefix}_controller_step")
    address = ctypes.cast(step, ctypes.c_void_p)
    before, again, outputs = type(run.controller)(), type(run.controller)(), type(run.commands)()
    size = ctypes.c_ulong(ctypes.sizeof(before))
    row = np.zeros((1, len(recorded_signals(project))))
    taken, iterations, status = np.zeros(steps), np.zeros(steps), np.zeros(steps)
    for k in range(steps):
        ctypes.memmove(ctypes.byref(before), ctypes.byref(run.controller), ctypes.sizeof(before))
        loop.steps(1, 1, row)
        taken[k] = least_time(
            address, ctypes.byref(before), ctypes.byref(again), size, ctypes.byref(run.controller_params),
            ctypes.byref(run.inputs), ctypes.byref(outputs), REPEATED,
        )  # fmt: skip
        iterations[k], status[k] = run.controller.governor_iterations, run.controller.governor_status
    loop.check("the run")
    return taken, iterations, status


def main() -> None:
    """Print a table."""
    bed = sys.argv[1] if len(sys.argv) > 1 else "differential-governed"
    project = Project.read(ROOT / "testbeds" / f"{bed}.toml")
    scenarios = sorted((ROOT / "scenarios").glob(f"{bed}-*.toml"))
    print(f"{bed}, load {os.getloadavg()[0]:.2f}; ns per step of the whole controller, least of {REPEATED}")
    for scenario in scenarios:
        reference = 0.0
        for kind in range(round(project.controller.declared("governor").value) + 1):
            taken, iterations, status = times_of(project, scenario, kind)
            reference = reference or float(taken.mean())
            counts = ", ".join(f"{int((status == s).sum())} x {s}" for s in np.unique(status).astype(int))
            print(f"{scenario.stem}, {KINDS[kind]}: mean {taken.mean():.0f} ({taken.mean() / reference:.2f}), "
                  f"largest {taken.max():.0f}, at most {iterations.max():.0f} iterations, {len(taken)} steps, "
                  f"status {counts}")  # fmt: skip
            if kind == 3:
                parts = [(n, taken[iterations == n]) for n in np.unique(iterations)]
                print("  " + ", ".join(f"{n:.0f} iterations {t.mean():.0f} ({len(t)})" for n, t in parts))


if __name__ == "__main__":
    main()

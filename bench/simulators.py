"""The emitted plant, CasADi's CVODES with smoothed friction and SciPy with events, on one rig in one run.

Four inertias in a row with three clutches between them, driven by a sine torque, lock and slip. Friction is smoothed
as ``c tanh(w / eps)`` for CVODES. First the torque is a known function of time, over which CVODES takes long steps, and
errors are against the event-driven reference at 1e-12. Then it is held for 100 us at a time, as a controller does;
there the reference would take minutes, and the emitted C with a sixteenth of the step takes its place.

python bench/simulators.py
"""

from __future__ import annotations

import ctypes
import itertools
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import casadi as ca
import numpy as np
from run import best, describe_machine

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "friction"))

from reference_problems import Bench, at_velocities

from ptgen.emit.block_files import block_files, common_context
from ptgen.friction.events import EventDriven
from ptgen.plant.plant import plant_block
from ptgen.simulate.compiler import FLAGS, find_compiler

DURATION = 2.0
SAMPLE = 1e-4
AMPLITUDE, FREQUENCY = 40.0, 1.7
CAPACITIES = {"clutch1": 6.0, "clutch2": 5.0, "clutch3": 4.0}
SPEEDS = {"J1": 10.0, "J2": 4.0, "J3": 1.0, "J4": 0.0}


def torque(t: float | np.ndarray) -> np.ndarray:
    return AMPLITUDE * np.sin(2 * np.pi * FREQUENCY * t)


def sampled(t: float | np.ndarray) -> np.ndarray:
    """Return the middle of the controller's sample in which `t` lies."""
    return (np.floor(t / SAMPLE + 1e-9) + 0.5) * SAMPLE


def rig():  # type: ignore[no-untyped-def]
    bench = Bench("rig", dict.fromkeys(SPEEDS, 1.0)).machine("J1")
    for (name, capacity), (left, right) in zip(CAPACITIES.items(), itertools.pairwise(SPEEDS), strict=True):
        bench.friction(name, {left: 1, right: -1}, coulomb=capacity)
    return bench.model()


class Emitted:
    """The emitted plant of the rig, in a loop in C."""

    def __init__(self, model, initial: np.ndarray, folder: Path) -> None:  # type: ignore[no-untyped-def]
        self.initial = initial
        for name, text in block_files(
            [plant_block(model, 1e-4)], common_context("rig", "rig", "0" * 16, "double")
        ).items():
            (folder / name).write_text(text)
        loop = Path(__file__).with_name("plant_loop.c")
        library = folder / "librig.so"
        options = ["-DPLANT=rig", "-DPLANT_HEADER=rig_plant.h", f"-I{folder}"]
        sources = [str(loop), *map(str, sorted(folder.glob("*.c")))]
        subprocess.run([*find_compiler(), *FLAGS, *options, "-o", str(library), *sources, "-lm"], check=True)
        self.function = ctypes.CDLL(str(library)).plant_loop
        self.function.restype = ctypes.c_long

    def run(self, h: float, held: bool = False) -> tuple[float, np.ndarray]:
        """Return the time that a run took (s), and the last velocities."""
        steps = round(DURATION / h)
        middles = (np.arange(steps) + 0.5) * h
        inputs = np.ascontiguousarray(torque(sampled(middles) if held else middles))
        end = np.zeros(len(self.initial))
        pointer = ctypes.c_void_p
        start = time.perf_counter()
        status = self.function(
            ctypes.c_double(h),
            pointer(self.initial.ctypes.data),
            ctypes.c_size_t(len(end)),
            pointer(inputs.ctypes.data),
            ctypes.c_long(steps),
            pointer(end.ctypes.data),
        )
        wall = time.perf_counter() - start
        if status != 0:
            raise RuntimeError(f"the plant ended with status {status}")
        return wall, end


def smoothed(model, initial: np.ndarray, eps: float, tolerance: float, held: bool) -> tuple[float, np.ndarray, float]:  # type: ignore[no-untyped-def]
    """Return the time of CVODES (s), the last velocities, and the largest slip while two disks are held (rad/s)."""
    numeric = model.numeric()
    z, t, u = ca.SX.sym("z", len(initial)), ca.SX.sym("t"), ca.SX.sym("u")
    w = ca.DM(numeric.friction_rows) @ z
    friction = ca.DM(list(CAPACITIES.values())) * ca.tanh(w / eps)
    options = {"reltol": tolerance, "abstol": tolerance, "max_num_steps": 10_000_000}
    acting = u if held else AMPLITUDE * ca.sin(2 * ca.pi * FREQUENCY * t)
    forces = ca.DM(numeric.input_rows.T) @ acting - ca.DM(numeric.friction_rows).T @ friction
    rate = ca.solve(ca.DM(numeric.mass), forces)
    if held:
        count = round(DURATION / SAMPLE)
        integrator = ca.integrator("rig", "cvodes", {"x": z, "p": u, "ode": rate}, 0.0, SAMPLE, options)
        course = integrator.mapaccum(count)
        inputs = torque((np.arange(count) + 0.5) * SAMPLE)[None, :]
        start = time.perf_counter()
        result = course(x0=initial, p=inputs)["xf"].full()
    else:
        grid = np.linspace(0.0, DURATION, 201)[1:]
        integrator = ca.integrator("rig", "cvodes", {"x": z, "t": t, "ode": rate}, 0.0, grid, options)
        start = time.perf_counter()
        result = integrator(x0=initial)["xf"].full()
    wall = time.perf_counter() - start
    slip = np.abs(numeric.friction_rows @ result)
    return wall, result[:, -1], float(np.max(np.where(slip < 10 * eps, slip, 0.0)))


def compare(model, initial: np.ndarray, emitted: Emitted, held: bool) -> None:  # type: ignore[no-untyped-def]
    acting = "torque held for 100 us" if held else "smooth torque"
    print(f"\n{acting}, {DURATION:g} s")
    print(f"{'simulator':36} {'time':>11} {'error rad/s':>12} {'slip held':>10}")
    if held:
        wanted = emitted.run(SAMPLE / 16, held)[1]
    else:
        reference = EventDriven(model)
        start = time.perf_counter()
        last = reference.advance(reference.initial(initial), DURATION, lambda t: np.atleast_1d(torque(t)))
        events = time.perf_counter() - start
        wanted = last.x[: len(initial)]
        print(f"{'SciPy DOP853 with events':36} {1e3 * events:8.0f} ms {'reference':>12} {0.0:10.1e}")
    found: list[tuple[float, float]] = []
    for h in (1e-4, 5e-5) if held else (4e-4, 2e-4, 1e-4, 5e-5):
        wall = best(lambda h=h: emitted.run(h, held)[0], 7)  # type: ignore[misc]
        error = float(np.max(np.abs(emitted.run(h, held)[1] - wanted)))
        found.append((wall, error))
        print(f"{f'emitted C, {1e6 * h:g} us':36} {1e3 * wall:8.3f} ms {error:12.1e} {0.0:10.1e}")
    for eps, tolerance in ((1e-2, 1e-6), (1e-3, 1e-7), (1e-4, 1e-8), (1e-5, 1e-9), (1e-6, 1e-10)):
        wall, end, slip = smoothed(model, initial, eps, tolerance, held)
        error = float(np.max(np.abs(end - wanted)))
        as_good = [mine for mine, own in found if own <= error]
        ratio = f", {wall / min(as_good):.0f} times the emitted C that is as good" if as_good else ""
        print(f"{f'CVODES, tanh, eps {eps:g} rad/s':36} {1e3 * wall:8.2f} ms {error:12.1e} {slip:10.1e}{ratio}")


def main() -> None:
    print(describe_machine())
    model = rig()
    initial = at_velocities(model, SPEEDS)
    with tempfile.TemporaryDirectory() as folder:
        emitted = Emitted(model, initial, Path(folder))
        for held in (False, True):
            compare(model, initial, emitted, held)
    print("slip held: velocity between disks that should be locked; smoothed friction creeps")
    print(describe_machine())


if __name__ == "__main__":
    main()

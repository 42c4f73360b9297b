"""Time per solution and step of the emitted friction code, and its size, against the number of elements.

python bench/solver.py
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from run import best, describe_machine

from ptgen.simulate.compiler import FLAGS, compile_library, find_compiler

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "friction"))

from box_problems import write_sources

ROOT = Path(__file__).resolve().parents[1]
ELEMENTS = (1, 2, 3, 4, 6, 8, 12)
COUNT = 4096
CALLS = 100_000


def main() -> None:
    print(describe_machine())
    columns = ("elements", "cold ns", "warm ns", "step ns", "events", "most work", "code bytes")
    print("\n" + " ".join(f"{column:>10}" for column in columns))
    with tempfile.TemporaryDirectory() as name:
        for n in ELEMENTS:
            folder = Path(name) / str(n)
            folder.mkdir()
            print_row(n, folder)
    print("\nevents: share of the steps in which an element begins or ceases to be held; most work: factorisations")
    print(describe_machine())


def print_row(n: int, folder: Path) -> None:
    write_sources(folder, n, contacts=0)
    timing = folder / "solver_timing.c"
    timing.write_text((ROOT / "bench" / "solver_timing.c").read_text())
    compile_library([timing, folder / "box_friction.c", folder / "box_support.c"], folder / "timing.so")
    library = ctypes.CDLL(str(folder / "timing.so"))
    K, w, slow, c = chain(n)
    low = -c

    def per_call(function: str, *arrays: np.ndarray) -> tuple[float, int]:
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in arrays]
        results = []

        def once() -> float:
            start = time.perf_counter()
            results.append(getattr(library, function)(COUNT, CALLS // COUNT, *pointers))
            return time.perf_counter() - start

        return 1e9 * best(once, 15) / (CALLS // COUNT * COUNT), results[-1]

    cold, work = per_call("cold", K, w, low, c)
    warm, more = per_call("warm", K, slow, low, c)
    step, events = per_call("steps", K, slow, c, 1.2 * c)
    share = f"{100 * events / (CALLS // COUNT * COUNT):.1f} %"
    row = (n, f"{cold:.0f}", f"{warm:.0f}", f"{step:.0f}", share, max(work, more), code_size(folder))
    print(" ".join(f"{entry:>10}" for entry in row))


def chain(n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return friction matrix, random velocities, slowly changing ones and capacities of clutches in a row.

    Capacities are of the size of the torques that hold everything, so that about half of the elements slip.
    """
    rng = np.random.default_rng(n)
    G = np.eye(n, n + 1) - np.eye(n, n + 1, 1)
    inertia = 10.0 ** rng.uniform(-1, 1, n + 1)
    matrix = G @ np.diag(1e-4 / inertia) @ G.T
    K = np.zeros((n, (n + 3) // 4 * 4))
    K[:, :n] = matrix
    seconds = 1e-4 * np.arange(COUNT)
    phase, frequency = rng.uniform(0, 2 * np.pi, (n, 3)), rng.uniform(2, 40, (n, 3))
    torques = 200.0 * np.sin(2 * np.pi * np.multiply.outer(seconds, frequency) + phase).sum(axis=2)
    slow = np.ascontiguousarray(torques @ matrix)
    random = np.ascontiguousarray(rng.normal(0.0, 300.0, (COUNT, n)) @ matrix)
    return K, random, slow, rng.uniform(100.0, 300.0, n)


def code_size(folder: Path) -> int:
    """Return the bytes of instructions and constants of the compiled friction code."""
    compiler = find_compiler()
    target = folder / "box_friction.o"
    options = [flag for flag in FLAGS if flag != "-shared"]
    subprocess.run([*compiler, *options, "-c", "-o", str(target), str(folder / "box_friction.c")], check=True)
    printed = subprocess.run(["size", str(target)], check=True, capture_output=True, text=True).stdout
    return int(printed.splitlines()[1].split()[0])


if __name__ == "__main__":
    main()

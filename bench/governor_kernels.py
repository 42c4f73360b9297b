"""Time and instructions of the emitted governors, with 240 rows, 9 states, 3 machines: ``bench/governor_kernels.py``.

For problems in which nothing binds, and for those that take 1, 2, ... iterations, the mean and the largest time of one
solution; and, where valgrind is installed, the instructions of one.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from dataclasses import fields
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "shaping"))

import governor_problems

from ptgen.shaping.optimal import optimal_governor

SIZES = governor_problems.Sizes()


def c_array(name: str, array: np.ndarray, real: str) -> str:
    """Return an array as C, matrices by columns and padded."""
    array = np.asarray(array, dtype=float)
    if array.ndim == 0:
        return f"static const {real} {name} = {float(array)!r};\n"
    padded = -(-array.shape[0] // 4) * 4
    columns = np.atleast_2d(array.T)
    text = ", ".join("{" + ", ".join(map(repr, map(float, column))) + "}" for column in columns)
    if array.ndim == 1:
        return f"static const {real} {name}[{padded}] = {text};\n"
    return f"static const {real} {name}[{array.shape[1]}][{padded}] = {{ {text} }};\n"


def build(folder: Path, precision: str, number: int, compiler: str) -> Path:
    """Return the program that solves problem `number`."""
    sources = governor_problems.write_sources(SIZES, folder, precision)  # type: ignore[arg-type]
    rows_x, rows_r = governor_problems.tables(SIZES)
    arrays = {field.name: getattr(PROBLEMS[number], field.name) for field in fields(PROBLEMS)}
    arrays |= {"rows_x": rows_x, "rows_r": rows_r, "group": np.array(SIZES.group)}
    arrays["free_torque"] = arrays.pop("free")
    (folder / "problem.h").write_text("".join(c_array(name, array, "bed_real") for name, array in arrays.items()))
    program = folder / f"timing{number}"
    timing = Path(__file__).with_name("governor_timing.c")
    used = [source for source in sources if not source.name.endswith("_shaper.c")]
    flags = ["-std=c99", "-O2", "-ffp-contract=off", "-I", folder]
    subprocess.run([compiler, *flags, timing, *used, "-o", program, "-lm"], check=True)
    return program


def instructions(program: Path, kind: str) -> int:
    """Return the instructions of one solution."""
    counted = []
    for count in (10, 110):
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(program), kind, str(count)]
        said = subprocess.run(command, capture_output=True, text=True, check=True).stderr
        counted.append(int(re.search(r"Collected : (\d+)", said).group(1)))  # type: ignore[union-attr]
    return (counted[1] - counted[0]) // 100


PROBLEMS = governor_problems.random_problems(SIZES, 1000, 1)


def solve() -> tuple[np.ndarray, np.ndarray]:
    """Return iterations and status of all problems."""
    P = PROBLEMS
    rows_x, rows_r = governor_problems.tables(SIZES)
    shared = (P.wanted, P.before, P.free, P.gain, P.least, P.most, P.deviation, rows_x, rows_r, P.weight, P.tie)
    group = np.array(SIZES.group)
    return optimal_governor(np.ones(len(P)), *shared, group, P.before, *SIZES.counts, SIZES.iterations)[2:]


def main() -> None:
    """Print the table."""
    iterations, status = solve()
    for compiler in filter(shutil.which, ("gcc", "clang")):
        for precision in ("double", "float"):
            print(f"{compiler}, {precision}")
            for count in range(int(iterations.max()) + 1):
                found = np.flatnonzero(iterations == count)
                if not len(found):
                    continue
                with TemporaryDirectory() as name:
                    program = build(Path(name), precision, int(found[0]), compiler)
                    for kind in ("optimal", "sequential"):
                        said = subprocess.run([program, kind, "200000"], capture_output=True, text=True, check=True)
                        time = float(said.stdout.split()[-1])
                        work = instructions(program, kind) if shutil.which("valgrind") else 0
                        what = f"{count} iterations, status {status[found[0]]:g}"
                        print(f"  {kind:10} {what:24} {time:8.0f} ns {work:8d} instructions")


if __name__ == "__main__":
    main()

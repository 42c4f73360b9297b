"""Cost of the emitted controllers: time per step beside the plant's, and instructions per step over what can come in.

python bench/controller.py
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from run import ROOT, describe_machine

from ptgen.emit.project import project_files
from ptgen.files import write_files
from ptgen.project import Project
from ptgen.simulate.compiler import find_compiler

FLAGS = ("-std=c99", "-O2", "-ffp-contract=off")
CASES = ("normal", "saturated", "bridged", "faulted", "reset")
STEPS = 20_000

EVERYTHING_OF = "differential-gearboxes"
EVERYTHING = """
speed_control = "observer"
torque_gain = 0.5
speed_pairs = { outputs = ["M2", "M3"] }

[control.losses.gearbox1]
speed = ["0 rpm", "1000 rpm", "2000 rpm", "4000 rpm", "6000 rpm"]
torque = ["2 N m", "4 N m", "6 N m", "9 N m", "15 N m"]

[control.losses.gearbox2]
speed = ["0 rpm", "1000 rpm", "2000 rpm", "4000 rpm", "6000 rpm"]
torque = ["3 N m", "5 N m", "8 N m", "12 N m", "19 N m"]

[control.losses.gearbox3]
speed = ["0 rpm", "1000 rpm", "2000 rpm", "4000 rpm", "6000 rpm"]
torque = ["3 N m", "5 N m", "8 N m", "12 N m", "19 N m"]
"""
"""Everything that can be chosen besides, at the end of a bed file; its last section is ``[control]``."""


def beds(folder: Path) -> dict[str, Path]:
    """Return the shipped beds, and one of them with everything on."""
    result = {path.stem: path for path in sorted((ROOT / "testbeds").glob("*.toml"))}
    everything = folder / f"{EVERYTHING_OF}.toml"
    everything.write_text(result[EVERYTHING_OF].read_text() + EVERYTHING)
    return result | {"everything on": everything}


def compiled(project: Project, folder: Path) -> Path:
    """Return the bench program of a bed."""
    prefix = project.testbed.name
    files = project_files(project)
    write_files(folder, files)
    sources = [f"{prefix}_{part}.c" for part in ("controller", "plant", "support")]
    sources += [name for name in (f"{prefix}_friction.c", f"{prefix}_governor.c") if name in files]
    program = folder / "bench"
    subprocess.run(
        [
            *find_compiler(),
            *FLAGS,
            f"-DBED={prefix}",
            f'-DCONTROLLER_HEADER="{prefix}_controller.h"',
            f'-DPLANT_HEADER="{prefix}_plant.h"',
            f"-DAT_REST={_at_rest(project)}",
            f"-I{folder}",
            "-o",
            str(program),
            str(ROOT / "bench" / "controller_timing.c"),
            *(str(folder / name) for name in sources),
            "-lm",
        ],
        check=True,
    )
    return program


def _at_rest(project: Project) -> str:
    """Return the plant's inputs that are not zero at rest, the ratios that can change, as C initialisers."""
    ratios = {name: parameter.value for name, parameter in project.testbed.ratios.items()}
    return ",".join(f".{name}_ratio={value!r}" for name, value in ratios.items()) or "0"


def times(program: Path) -> dict[str, float]:
    """Return the least of several times per step (ns): plant, and controller by case."""
    result: dict[str, float] = {}
    for case in ("plant", *CASES):
        for _ in range(5):
            said = subprocess.run([program, case, "200000"], check=True, capture_output=True, text=True).stdout
            result[case] = min(result.get(case, float("inf")), float(said))
    return result


def instructions(program: Path) -> dict[str, float]:
    """Return instructions per controller step by case."""
    result = {}
    for case in CASES:
        counts = [count(program, case, steps) for steps in (STEPS, 2 * STEPS)]
        result[case] = (counts[1] - counts[0]) / STEPS
    return result


def count(program: Path, case: str, steps: int) -> int:
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", str(program), case, str(steps)]
    said = subprocess.run(command, check=True, capture_output=True, text=True).stderr
    found = re.search(r"Collected : (\d+)", said)
    if found is None:
        raise RuntimeError(f"valgrind said: {said}")
    return int(found.group(1))


def main() -> None:
    print(describe_machine())
    counting = shutil.which("valgrind") is not None
    print(f"\n{'time per step in ns':26}" + "".join(f"{case:>11}" for case in ("plant", *CASES)))
    with tempfile.TemporaryDirectory() as folder:
        programs = {}
        for name, path in beds(Path(folder)).items():
            project = Project.read(path)
            programs[name] = compiled(project, Path(folder) / name)
            row = times(programs[name])
            print(f"{name:26}" + "".join(f"{row[case]:11.0f}" for case in ("plant", *CASES)))
        if not counting:
            print("instructions are not counted: valgrind is not installed")
            return
        print(f"\n{'instructions per step':26}" + "".join(f"{case:>11}" for case in CASES) + f"{'off mean':>11}")
        for name, program in programs.items():
            row = instructions(program)
            mean = sum(row.values()) / len(row)
            worst = max(abs(value / mean - 1) for value in row.values())
            print(f"{name:26}" + "".join(f"{row[case]:11.1f}" for case in CASES) + f"{100 * worst:10.1f}%")
    print(describe_machine())


if __name__ == "__main__":
    main()

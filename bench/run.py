"""Speed of ptgen and of what it emits, as ratios measured side by side in this run, with the machine's load.

python bench/run.py
"""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.compiler import find_compiler
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

ROOT = Path(__file__).resolve().parents[1]

# The source's simulations: compiled Simulink model ("Rapid Accelerator") on one core of a laptop of 2013, with
# variable-step ode45 and models of induction machines and field-oriented control, which ours do not contain.
SOURCE = {"differential": (70.0, 66.0), "differential-gearboxes": (100.0, 92.0), "transmission": (70.0, 10.0)}
RUNS = {
    "differential": "differential-run",
    "differential-gearboxes": "differential-gearboxes-run",
    "back-to-back": "back-to-back-steps",
    "transmission": "transmission-run",
    "transmission-nine-speed": "transmission-run",
    "shift-rig": "shift-rig-upshift",
}


def best(action: Callable[[], float], repetitions: int) -> float:
    """Return the smallest of several measured times."""
    return min(action() for _ in range(repetitions))


def describe_machine() -> str:
    """Return processor, cores and load of the machine."""
    model = platform.processor() or platform.machine()
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        model = next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        pass
    load = ", ".join(f"{value:.2f}" for value in os.getloadavg())
    return f"{model}, {os.cpu_count()} cores, load {load}, compiler {' '.join(find_compiler())}"


def closed_loop() -> None:
    print(f"\n{'closed loop, one scenario, one core':40} {'ns/step':>8} {'real-time factor':>17}   source")
    for bed, scenario_name in RUNS.items():
        project = Project.read(ROOT / "testbeds" / f"{bed}.toml")
        scenario = load_scenario(ROOT / "scenarios" / f"{scenario_name}.toml", project.testbed)
        library = build(project)

        def run(project=project, scenario=scenario, library=library) -> float:  # type: ignore[no-untyped-def]
            return simulate(project, scenario, library=library).wall_s

        wall = best(run, 7)
        factor = scenario.duration / wall
        source = ""
        if bed in SOURCE:
            duration, needed = SOURCE[bed]
            source = f"{duration:.0f} s in {needed:.0f} s, factor {duration / needed:.2f} (other model and machine)"
        steps = round(scenario.duration / project.testbed.sample_time)
        print(f"{bed + ', ' + scenario_name:40} {1e9 * wall / steps:8.0f} {factor:17.0f}   {source}")


def generation() -> None:
    print(f"\n{'cold process':40} {'seconds':>8} {'of bare python':>17}")

    def timed(arguments: list[str]) -> float:
        start = time.perf_counter()
        subprocess.run([sys.executable, *arguments], check=True, capture_output=True)
        return time.perf_counter() - start

    bare = best(lambda: timed(["-c", "import numpy, sympy"]), 3)
    print(f"{'import numpy, sympy':40} {bare:8.2f} {1.0:17.1f}")
    for part in sorted((ROOT / "parts").glob("*.toml")):
        wall = best(lambda part=part: timed(["-m", "ptgen", "gears", str(part)]), 3)  # type: ignore[misc]
        print(f"{'ptgen gears ' + part.stem:40} {wall:8.2f} {wall / bare:17.1f}")
    with tempfile.TemporaryDirectory() as folder:
        for bed in RUNS:
            path = str(ROOT / "testbeds" / f"{bed}.toml")
            for command in (["check", path], ["derive", path, "--json"], ["generate", path, "-o", f"{folder}/{bed}"]):
                wall = best(lambda command=command: timed(["-m", "ptgen", *command]), 3)  # type: ignore[misc]
                print(f"{'ptgen ' + command[0] + ' ' + bed:40} {wall:8.2f} {wall / bare:17.1f}")


if __name__ == "__main__":
    print(describe_machine())
    closed_loop()
    generation()
    print(describe_machine())

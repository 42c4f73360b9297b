"""The optimal governor against all rows of its horizon: ``python bench/governor_sweep.py [STEPS] [STATES]``.

On the nominal loop of ``testbeds/differential.toml``, half a second ahead, 30012 inequalities:

- *loss*: how much of the sum of h is lost because rows were removed and limits tightened, over a run with random steps
  of all references, torque limits that follow the speed, and both solved in every step;
- *feasibility*: states from which the limits can be kept lead to states from which they can be kept;
- *agreement* of the emitted solver with HiGHS, all rows, random states.

Minutes with 100 000 steps and 10 000 states.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "governor"))

from all_rows import EmittedGovernor, NominalLoop, largest_shares, shares, worst_difference

from ptgen.governor.constraint_set import torque_limits
from ptgen.governor.set_cache import cached_constraint_set
from ptgen.project import Project
from ptgen.testbed.governor_settings import GovernorSettings

STATUS = ("free", "limited", "slack", "not solved")


def loss(project: Project, reduced: EmittedGovernor, full: EmittedGovernor, steps: int) -> None:
    """Print what the removal of rows costs: two runs with the same references, and both governors in every state."""
    settings = reduced.constraints
    sums = {}
    for name, governor in (("reduced", reduced), ("all rows", full)):
        loop, counts, iterations = NominalLoop(project, 1), np.zeros(4, dtype=int), 0
        own, other, missed, beyond = 0.0, 0.0, 0.0, -np.inf
        for _ in range(steps):
            problem = loop.problem(settings.reserve, settings.stationary_reserve)
            answer = governor(problem)
            h = shares(problem, answer.shaped)
            if h.min() < 0 or h.max() > 1:
                raise SystemExit(f"h outside [0, 1]: {h}")
            own += h.sum()
            counts[answer.status] += 1
            iterations = max(iterations, answer.iterations)
            if governor is reduced:
                other += shares(problem, full(problem).shaped).sum()
            missed += float(np.abs(problem.wanted - answer.shaped) @ [1, 10, 10])
            u = loop.step(answer.shaped)
            beyond = max(beyond, float((np.abs(u) - problem.limit / (1 - settings.reserve)).max()))
        sums[name] = own, missed
        print(f"{name}: " + ", ".join(f"{count} {text}" for text, count in zip(STATUS, counts, strict=True)))
        print(f"  at most {iterations} iterations; torque commands stay {-beyond:.3g} N m inside the machines' limits")
        if governor is reduced:
            print(f"  in the same states: sum of h {own:.2f} of {other:.2f}, {1 - own / other:.2e} lost")
    (own, missed), (other, best) = sums["reduced"], sums["all rows"]
    print(f"loss of a run of {steps} steps: sum of h {own:.2f} of {other:.2f}, {1 - own / other:.2e} lost;")
    print(f"  distance of references from the wanted ones {missed / max(best, 1e-300) - 1:.2e} larger")


def main() -> None:
    """Run all three."""
    given = [int(float(text)) for text in sys.argv[1:3]]
    steps, states = (*given, *(100_000, 10_000)[len(given) :])
    root = Path(__file__).resolve().parents[1]
    project = Project.read(root / "testbeds" / "differential.toml")
    start = time.perf_counter()
    settings = GovernorSettings(horizon="0.5 s")
    reduced = cached_constraint_set(project.prediction, torque_limits(project.reduced.full), settings)
    print(f"load {os.getloadavg()[0]:.2f}; set of {reduced.kept_rows} of {reduced.all_rows} inequalities, "
          f"{time.perf_counter() - start:.1f} s")  # fmt: skip
    emitted, full = EmittedGovernor(reduced), EmittedGovernor(reduced.full())
    loss(project, emitted, full, steps)
    now, after, kept = largest_shares(reduced, 10 * states)
    print(f"feasibility of {10 * states} states of the reduced set: largest share of a limit, all rows, now {now:.6f},")
    print(f"  in the next step {after:.6f}; of kept rows in the next step {kept:.6f}")
    worst, counts = worst_difference(full, states)
    text = ", ".join(f"{count} {name}" for count, name in zip(counts, STATUS, strict=True))
    print(f"agreement with HiGHS on {states} random states, {2 * (sum(full.constraints.counts) + 3)} inequalities:")
    print(f"  {worst:.2e} ({text})")


if __name__ == "__main__":
    main()

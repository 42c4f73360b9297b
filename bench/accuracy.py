"""Error of the emitted plant against the event-driven reference, for the test problems of friction.

python bench/accuracy.py
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
from run import describe_machine

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from friction.emitted_plant import emitted_run, errors, problem_named, reference_run, steps
from friction.reference_problems import PROBLEMS

DIVISORS = (1, 2, 4, 8)


def main() -> None:
    print(describe_machine())
    print("\nlargest error of any velocity (rad/s), mean order, transitions found and wanted, seconds of the reference")
    print(
        f"{'problem':22}" + "".join(f"{100 / d:>9.4g} us" for d in DIVISORS) + f"{'order':>7}{'found':>7}{'wanted':>7}"
    )
    for make in PROBLEMS:
        name = make.__name__
        start = time.perf_counter()
        wanted = reference_run(name)[1].transitions
        taken = time.perf_counter() - start
        found = errors(name, DIVISORS)
        order = np.log2(found[0] / found[-1]) / 3
        elements = {friction.name for friction in problem_named(name).model.frictions}
        counts = len(emitted_run(name)[1]), sum(item.element in elements for item in wanted)
        shown = f"{order:.2f}" if found[0] > 1e-7 else "exact"
        cells = [*(f"{error:.1e}" for error in found), shown, *map(str, counts), f"{taken:.1f}"]
        print(f"{name:22}" + "".join(f"{cell:>9}" for cell in cells))
    step = problem_named("clutch").duration / steps("clutch")
    print(f"\nsteps are {1e6 * step:.3f} us and the like, so that no event falls on their grid")
    print("exact: the motion between events is polynomial, what is left is rounding")
    print(describe_machine())


if __name__ == "__main__":
    main()

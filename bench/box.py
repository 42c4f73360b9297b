"""Random friction problems against the enumeration of their sectors, as many as there is time for.

python bench/box.py [problems for each number of elements] [elements ...]
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

from run import describe_machine

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "friction"))

from box_problems import CHECKS, KINDS, box_library

DEFAULT_PROBLEMS = 10_000_000
DEFAULT_ELEMENTS = (2, 3, 4, 5, 6)
MOST_ENUMERATED = 6


def main(problems: int, elements: tuple[int, ...]) -> int:
    """Print what was found; return the number of failures."""
    print(describe_machine())
    print(
        f"{'n':>2} {'kind':12} {'problems':>9} {'failures':>8} {'residual':>9} {'velocity':>9} {'torque':>8} "
        f"{'norm':>8} {'work':>5} {'mean':>5} {'fallbacks':>9} {'us each':>8}"
    )
    failures = 0
    for n in elements:
        library = box_library(n)
        for kind in KINDS:
            count = problems // len(KINDS)
            start = time.perf_counter()
            report = library.run(kind, count, enumerated=n <= MOST_ENUMERATED)
            each = 1e6 * (time.perf_counter() - start) / count
            print(
                f"{n:2} {kind:12} {count:9} {report.failures:8} {report.worst_residual:9.1e} "
                f"{report.worst_velocity:9.2f} {report.worst_torque:8.1e} {report.worst_norm:8.1e} "
                f"{report.worst_work:5} {report.work / count:5.2f} {report.fallbacks:9} {each:8.2f}",
                flush=True,
            )
            if report.failures:
                print(f"   first: number {report.first_failure}, not {CHECKS[report.first_check]}")
            failures += report.failures
    print(f"{failures} failures; residuals relative to what they are sums of, velocities to what residuals allow,")
    print("torques relative, norm: share that is too much, work: factorisations, fallbacks: not announced as dependent")
    print(describe_machine())
    return failures


if __name__ == "__main__":
    arguments = [int(float(argument)) for argument in sys.argv[1:]]
    sys.exit(main(arguments[0] if arguments else DEFAULT_PROBLEMS, tuple(arguments[1:]) or DEFAULT_ELEMENTS) > 0)

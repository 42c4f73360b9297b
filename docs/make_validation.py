"""Write docs/validation.md: runs of ptgen beside the source's simulations and measurements.

    python docs/make_validation.py            # run all, write page, figures and numbers
    python docs/make_validation.py --check    # run all, compare the numbers with those of the page, write nothing

The numbers are kept in docs/figures/validation/numbers.json; a page is stale if it is not what these give, or if a
number of a run differs from them by more than a tenth.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS))

from validation import direct, experiments, gearboxes, governors, joints, shifts, transmissions  # noqa: E402
from validation.case import Case, Number  # noqa: E402

from ptgen.report.figures import save_figure  # noqa: E402

__all__ = ["CASES", "differences", "main", "page"]

PAGE = DOCS / "validation.md"
FIGURES = DOCS / "figures" / "validation"
NUMBERS = FIGURES / "numbers.json"
CASES: tuple[Case, ...] = (
    *direct.CASES,
    *joints.CASES,
    *shifts.CASES,
    *gearboxes.CASES,
    *transmissions.CASES,
    *experiments.CASES,
    *governors.CASES,
)

HEAD = """# Validation

Runs of ptgen beside the simulations and measurements of the source. The controllers are the emitted ones, compiled; the
plants are the full ones, with friction, lag and dead time. The source's curves are known from pictures only: what is
compared is what its text says and what its axes and captions give. Its references are drawn anew. Beds and
values that the source does not give are marked in the bed files (`assumed`). The supervision that stops a bed when its
torques swing ([controller.md](controller.md)) is switched off, so that the swings can be seen.

Written by `make validation` from `docs/make_validation.py`; each figure can be run again on its own.
"""

Values = Mapping[str, Sequence[Mapping[str, str | float]]]


def _shown(value: float, unit: str) -> str:
    """Return a number with two or three significant digits."""
    if value == 0 or abs(value) < 5e-4:
        return f"0 {unit}".strip()
    digits = f"{value:.2g}" if abs(value) < 100 else f"{value:.3g}"
    number = float(digits)
    text = f"{number:.0f}" if abs(number) >= 100 else f"{number:g}"
    return f"{text} {unit}".strip()


def page(values: Values) -> str:
    """Return the page for the numbers of all cases."""
    lines = [HEAD, "| figure | quantity | ptgen | the source |", "| --- | --- | --- | --- |"]
    for case in CASES:
        title = f"[{case.title.partition(':')[0]}](#{_anchor(case.title)})"
        for entry in values[case.key]:
            shown = _shown(float(entry["value"]), str(entry["unit"]))
            lines.append(f"| {title} | {entry['name']} | {shown} | {entry['source']} |")
            title = ""
    for case in CASES:
        lines += ["", f"## {case.title}", "", f"*The source.* {case.shows}", "", f"*ptgen.* {case.verdict}", ""]
        lines.append(f"![{case.title}](figures/validation/{case.key}.svg)")
    return "\n".join(lines).replace("|  |", "| |") + "\n"


def _anchor(title: str) -> str:
    kept = "".join(c for c in title.lower() if c.isalnum() or c in " -")
    return kept.replace(" ", "-")


def _entries(numbers: Sequence[Number]) -> list[dict[str, str | float]]:
    return [{"name": n.name, "value": float(f"{n.value:.4g}"), "unit": n.unit, "source": n.source} for n in numbers]


def differences(old: Values, new: Values) -> list[str]:
    """Return the numbers that differ by more than a tenth, or by what is too small to count."""
    found = []
    for key, entries in new.items():
        before = {str(entry["name"]): entry for entry in old.get(key, [])}
        for entry in entries:
            name, value = str(entry["name"]), float(entry["value"])
            if name not in before:
                found.append(f"{key}: {name} is new")
                continue
            kept = float(before[name]["value"])
            least = {"N m": 1.0, "rpm": 0.1, "%": 0.5, "": 0.01}.get(str(entry["unit"]), 0.02)
            if abs(value - kept) > max(0.1 * abs(kept), least):
                found.append(f"{key}: {name} is {value:g}, was {kept:g}")
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the page, or compare it; return the exit code."""
    parser = argparse.ArgumentParser(description="Write docs/validation.md from runs.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if the page is stale")
    parser.add_argument("--only", metavar="KEY", help="make one figure only, such as figure-5-12; page untouched")
    options = parser.parse_args(arguments)
    values = {}
    for case in CASES:
        if options.only in (None, case.key):
            numbers, figure = case.make()
            values[case.key] = _entries(numbers)
            if not options.check:
                FIGURES.mkdir(parents=True, exist_ok=True)
                save_figure(figure, FIGURES / f"{case.key}.svg")
            if options.only:
                print("\n".join(f"{n.name}: {_shown(n.value, n.unit)} ({n.source})" for n in numbers))
    if options.only:
        return 0
    if not options.check:
        NUMBERS.write_text(json.dumps(values, indent=1, ensure_ascii=False) + "\n", encoding="utf-8", newline="\n")
        PAGE.write_text(page(values), encoding="utf-8", newline="\n")
        return 0
    kept = json.loads(NUMBERS.read_text(encoding="utf-8"))
    stale = differences(kept, values)
    if PAGE.read_text(encoding="utf-8") != page(kept):
        stale.append("docs/validation.md is not what its numbers give")
    for line in stale:
        print(line, file=sys.stderr)
    if stale:
        print("docs/validation.md is stale: run make validation", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())

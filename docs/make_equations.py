"""Write docs/equations.md from docs/equations.toml.

python docs/make_equations.py            write the page
python docs/make_equations.py --check    exit with 1 if the page is stale
"""

from __future__ import annotations

import argparse
import sys
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent
LEDGER = HERE / "equations.toml"
PAGE = HERE / "equations.md"

STATUSES = {
    "derived": "a check fails when the formula is wrong; it stands in the notebook named, under that number",
    "implemented": "the product uses it, and it has no derivation of its own; the module is named",
    "definition": "symbols, assumptions, parameters or requirements: nothing to derive",
    "erratum": "the print is wrong; see the page named",
    "open": "neither shown nor used",
}

CHAPTERS = {
    "2": "Test beds",
    "3": "Models of the components",
    "4": "Friction in simulation",
    "5": "Control",
    "6": "Experiments",
    "7": "Reference governor",
    "A": "Induction machine",
    "B": "Equivalent shafts",
    "C": "Assembled bed for differentials",
    "D": "Parameters",
}

HEAD = """\
# Equations

Every numbered equation of the source, and what stands behind it in this project. This page is written by
`docs/make_equations.py` from `docs/equations.toml`; change that file, not this page.
"""


def read_ledger(path: Path = LEDGER) -> list[dict[str, str]]:
    """Return the entries of the ledger in the order of the file."""
    with path.open("rb") as stream:
        return list(tomllib.load(stream)["equation"])


def page(entries: Sequence[Mapping[str, str]]) -> str:
    """Return the text of the page."""
    unknown = sorted({entry["status"] for entry in entries} - STATUSES.keys())
    if unknown:
        raise SystemExit(f"{LEDGER.name}: unknown status {', '.join(unknown)}; known are {', '.join(STATUSES)}")
    chapters: dict[str, list[Mapping[str, str]]] = {}
    for entry in entries:
        chapters.setdefault(entry["number"].partition(".")[0], []).append(entry)
    lines = [HEAD, "| status | meaning | equations |", "| --- | --- | --- |"]
    lines += [f"| {status} | {meaning} | {_count(entries, status)} |" for status, meaning in STATUSES.items()]
    lines += [f"| | all | {len(entries)} |", ""]
    lines += [f"| chapter | {' | '.join(STATUSES)} | all |", f"| --- |{' --- |' * (len(STATUSES) + 1)}"]
    for key, members in chapters.items():
        counts = " | ".join(str(_count(members, status)) for status in STATUSES)
        lines.append(f"| [{_title(key)}](#{_anchor(_title(key))}) | {counts} | {len(members)} |")
    for key, members in chapters.items():
        lines += ["", f"## {_title(key)}", "", "| number | section | equation | status | where |"]
        lines.append("| --- | --- | --- | --- | --- |")
        for entry in members:
            where = f"`{entry['where']}`" if "where" in entry else ""
            note = f"; {entry['note']}" if "note" in entry else ""
            cells = (f"({entry['number']})", entry["section"], entry["states"], entry["status"], where + note)
            lines.append(f"| {' | '.join(cells)} |".replace("|  |", "| |"))
    return "\n".join(lines) + "\n"


def _count(entries: Sequence[Mapping[str, str]], status: str) -> int:
    return sum(entry["status"] == status for entry in entries)


def _title(key: str) -> str:
    kind = "Chapter" if key.isdigit() else "Appendix"
    return f"{kind} {key}: {CHAPTERS[key]}"


def _anchor(title: str) -> str:
    return title.lower().replace(":", "").replace(" ", "-")


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the page, or compare it; return the exit code."""
    parser = argparse.ArgumentParser(description="Write docs/equations.md from docs/equations.toml.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if the page is stale")
    options = parser.parse_args(arguments)
    text = page(read_ledger())
    if not options.check:
        PAGE.write_text(text, encoding="utf-8", newline="\n")
        return 0
    if PAGE.is_file() and PAGE.read_text(encoding="utf-8") == text:
        return 0
    print("docs/equations.md is stale: run python docs/make_equations.py", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())

"""The ledger of equations is honest, and the notebooks that it points to run."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LEDGER = tomllib.loads((ROOT / "docs" / "equations.toml").read_text(encoding="utf-8"))["equation"]
STATES = {"derived", "implemented", "definition", "erratum", "open"}
NOTEBOOKS = [
    path for path in sorted((ROOT / "notebooks").glob("*.py")) if "jupytext:" in path.read_text(encoding="utf-8")
]
CHAPTERS = ["2", "3", "4", "5", "6", "7", "A", "B", "C", "D"]


def place(number: str) -> tuple[int, int]:
    chapter, _, index = number.partition(".")
    return CHAPTERS.index(chapter), int(index)


def of_state(state: str) -> list[dict[str, str]]:
    return [entry for entry in LEDGER if entry["status"] == state]


def number(entry: dict[str, str]) -> str:
    return entry["number"]


def test_every_equation_once_and_in_order() -> None:
    numbers = [entry["number"] for entry in LEDGER]
    assert len(numbers) == 372
    assert numbers == sorted(set(numbers), key=place)
    chapters = {chapter: [place(n)[1] for n in numbers if n.startswith(f"{chapter}.")] for chapter in CHAPTERS}
    for indices in chapters.values():
        assert indices == list(range(1, len(indices) + 1)), "no number is left out"


def test_entries_are_complete() -> None:
    for entry in LEDGER:
        assert set(entry) <= {"number", "section", "states", "status", "where", "note"}, entry
        assert entry["status"] in STATES, entry
        assert entry["states"].strip() and entry["section"].strip(), entry
        assert ("where" in entry) == (entry["status"] in {"derived", "implemented", "erratum"}), entry


@pytest.mark.parametrize("entry", of_state("derived"), ids=number)
def test_derived_equation_is_checked_where_it_says(entry: dict[str, str]) -> None:
    file, _, key = entry["where"].partition("::")
    assert key.split()[0] == entry["number"], "a check may say more than the number, such as 5.98 without losses"
    text = (ROOT / file).read_text(encoding="utf-8")
    assert re.search(rf'\b(check|erratum)\(\s*"{re.escape(key)}[" ]', text), f"{file} has no check of {key}"


@pytest.mark.parametrize("entry", of_state("implemented"), ids=number)
def test_implemented_equation_is_in_the_product(entry: dict[str, str]) -> None:
    file = ROOT / entry["where"]
    assert file.is_file() and file.is_relative_to(ROOT / "ptgen")


@pytest.mark.parametrize("entry", of_state("erratum"), ids=number)
def test_erratum_is_on_the_page(entry: dict[str, str]) -> None:
    assert entry["where"] == "docs/errata.md"
    assert f"({entry['number']}" in (ROOT / entry["where"]).read_text(encoding="utf-8")


def test_errata_page_names_files_that_exist() -> None:
    text = (ROOT / "docs" / "errata.md").read_text(encoding="utf-8")
    named = set(re.findall(r"notebooks/\w+\.py", text))
    assert named
    assert all((ROOT / name).is_file() for name in named)


def test_there_are_notebooks() -> None:
    assert {"components", "reduction", "decoupling", "errata", "transmissions"} <= {path.stem for path in NOTEBOOKS}


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs(notebook: Path) -> None:
    """Each check in a notebook raises when the printed and the derived formula do not compare as stated."""
    environment = os.environ | {"MPLBACKEND": "Agg", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, notebook.name],
        cwd=notebook.parent,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    shown = re.search(r"(\d+) comparisons", done.stdout)
    assert shown is not None and int(shown.group(1)) > 0, done.stdout

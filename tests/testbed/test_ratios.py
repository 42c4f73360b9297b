"""The section ``[ratios]`` of scenario files."""

from __future__ import annotations

from pathlib import Path

import pytest
from small_bed import BED

from ptgen.errors import Problem, TestbedError
from ptgen.testbed import Profile, Scenario, load, load_scenario

HEAD = '[scenario]\nduration = "2 s"\nrecord_every = "1 ms"\n'
GEARBOX = """
[components.{name}]
type = "gearbox"
ratio = {ratio}
inertia = "0.05 kg m^2"
{more}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a bed that has a gearbox of each kind."""
    text = BED.replace("flange1 - shaft1 - M2", "flange1 - shaft1 - shifting - shaft2 - fixed - M2")
    text += '[components.shaft2]\ntype = "shaft"\nstiffness = "60 kN m/rad"\n'
    text += GEARBOX.format(name="shifting", ratio=2.0, more="ratio_range = [0.5, 4.0]")
    text += GEARBOX.format(name="fixed", ratio=3.0, more="")
    (tmp_path / "bed.toml").write_text(text, encoding="utf-8")
    return tmp_path


def read(folder: Path, text: str) -> Scenario:
    (folder / "case.toml").write_text(HEAD + text, encoding="utf-8")
    return load_scenario(folder / "case.toml", load(folder / "bed.toml"))


def problem(folder: Path, text: str) -> Problem:
    with pytest.raises(TestbedError) as caught:
        read(folder, text)
    (only,) = caught.value.problems
    return only


def test_bed_names_the_ratios_that_change(folder: Path) -> None:
    ratios = load(folder / "bed.toml").ratios
    assert {name: (p.symbol.name, p.value, p.span) for name, p in ratios.items()} == {
        "shifting": ("shifting_ratio", 2.0, (0.5, 4.0))
    }


def test_courses_are_read_and_the_file_is_the_default(folder: Path) -> None:
    assert read(folder, "").ratios == {"shifting": Profile((0.0,), (2.0,), "lines")}
    text = '[ratios]\nshifting = { time = ["0 s", "1 s"], value = [2, 3.5] }\n'
    assert read(folder, text).ratios == {"shifting": Profile((0.0, 1.0), (2.0, 3.5), "lines")}


@pytest.mark.parametrize("value", [0.4, 4.2, -2.0])
def test_beyond_the_range(value: float, folder: Path) -> None:
    found = problem(folder, f'[ratios]\nshifting = {{ time = ["0 s"], value = [{value}] }}\n')
    assert found.where == "ratios.shifting.value[0]"
    assert "0.5" in found.what and "4" in found.what and "ratio_range" in found.remedy


@pytest.mark.parametrize(
    ("name", "what", "remedy"),
    [
        ("fixed", "is constant", "ratio_range"),
        ("shiftin", "is no gearbox", 'did you mean "shifting"'),
        ("M1", "is no gearbox", "shifting"),
    ],
)
def test_what_has_no_ratio_that_changes(name: str, what: str, remedy: str, folder: Path) -> None:
    found = problem(folder, f'[ratios]\n{name} = {{ time = ["0 s"], value = [2.0] }}\n')
    assert found.where == f"ratios.{name}" and what in found.what and remedy in found.remedy


def test_not_a_table(folder: Path) -> None:
    (folder / "case.toml").write_text("ratios = 3\n" + HEAD, encoding="utf-8")
    with pytest.raises(TestbedError, match="ratios: must be a table"):
        load_scenario(folder / "case.toml", load(folder / "bed.toml"))

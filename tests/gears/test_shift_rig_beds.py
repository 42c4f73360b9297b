"""The rigs with simplified gearboxes hold what is derived from the gear set of the shift rig; the rest is equal."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from ptgen.gears import analyse_gears, layout_of_part, simplified_gearbox
from ptgen.report.gears_simplified import simplified_tables
from ptgen.testbed import load

MODELS = {"shift-rig-one-clutch": "single_clutch_gearbox", "shift-rig-two-clutches": "double_clutch_gearbox"}


@pytest.mark.parametrize("stem", MODELS)
def test_simplified_gearboxes_are_those_of_the_gear_set(root: Path, stem: str) -> None:
    part = load(root / "testbeds" / "shift-rig.toml").components["gears"]
    found = analyse_gears(layout_of_part(part), part.description.gears)
    table = simplified_tables(simplified_gearbox(found, ["1", "2"]))[MODELS[stem]]
    own, whole = (
        tomllib.loads((root / "testbeds" / f"{name}.toml").read_text("utf-8")) for name in (stem, "shift-rig")
    )
    gearbox = own["components"].pop("gears")
    whole["components"].pop("gears")
    assert gearbox.keys() == table.keys()
    for key, value in table.items():
        given, wanted = (_numbers(entry) for entry in (gearbox[key], value))
        assert given == (wanted if isinstance(wanted, str) else pytest.approx(wanted, rel=1e-12)), key
    for bed in (own, whole):
        bed["testbed"].pop("name")
        bed["testbed"].pop("title")
    assert own == whole


def test_the_course_of_model_one_is_scaled_by_its_capacity(root: Path) -> None:
    text = (root / "scenarios" / "shift-rig-one-clutch-downshift.toml").read_text("utf-8")
    bed = load(root / "testbeds" / "shift-rig-two-clutches.toml").components["gears"]
    start = tomllib.loads(text)["actuations"]["gears"]["clutch"]["value"][0]
    assert start == pytest.approx(bed.clutch2.capacity / bed.clutch1.capacity, rel=1e-12)


def _numbers(entry: object) -> object:
    """Return an entry of a bed file with its quantities as numbers."""
    if isinstance(entry, dict):
        return {key: _numbers(value) for key, value in entry.items()}
    if isinstance(entry, str) and entry[0].isdigit():
        return float(entry.partition(" ")[0])
    return entry

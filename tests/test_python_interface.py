"""The stages from Python, as the documentation shows them."""

from __future__ import annotations

from pathlib import Path

import pytest

import ptgen
from ptgen.errors import ControlError, TestbedError


@pytest.mark.compile
def test_from_file_to_recording(root: Path, tmp_path: Path) -> None:
    bed = ptgen.load(root / "testbeds" / "back-to-back.toml")
    model = bed.assemble()
    assert model.modes()[1].frequency_hz == pytest.approx(17.0, abs=0.1)
    design = model.reduce().decouple()
    controller, plant = design.blocks()
    assert {controller.name, plant.name} == {"controller", "plant"}
    assert ptgen.analyse(design).is_stable
    assert tmp_path / "back_to_back_plant.c" in ptgen.emit(design, tmp_path)
    recording = ptgen.simulate(design, root / "scenarios" / "back-to-back-steps.toml")
    assert recording.realtime_factor > 1


def test_settings_and_roles_can_be_tried(root: Path) -> None:
    model = ptgen.load(root / "testbeds" / "differential.toml").assemble()
    reduced = model.reduce(rigid=["flange1", "flange2", "flange3"])
    c, i = 57e3, 1.91
    assert reduced.reduced.parameters["stiffness cardan1"] == pytest.approx(2 * c * c / (i**2 * c + 2 * c))  # (5.2)
    swapped = reduced.decouple(torque={"M2": "diff.output1"}, speed=["M1", "M3"])
    assert swapped.design.decoupling.relative_degrees == (2, 1, 1)
    with pytest.raises(ControlError, match="roles that would work"):
        reduced.decouple(torque={"M2": "diff.output1", "M3": "diff.output2"}, speed=["M1"])


@pytest.mark.compile
def test_governors_from_python(root: Path) -> None:
    bed = ptgen.load(root / "testbeds" / "back-to-back.toml")
    study = ptgen.govern(bed, root / "scenarios" / "back-to-back-steps.toml", kind="sequential", reserve=0.1)
    assert [run.bed for run in study.runs] == ["nominal", "plant"] and study.settings.reserve == 0.1
    with pytest.raises(TestbedError, match="reserve"):
        ptgen.govern(bed, kind="sequential", reserve=0.7)
    with pytest.raises(TestbedError, match="horizn"):
        ptgen.govern(bed, horizn="0.5 s")

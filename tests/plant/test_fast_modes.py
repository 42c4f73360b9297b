"""A bed that is too fast for its step is refused with the mode, the shaft and what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from ptgen.errors import ModelError
from ptgen.project import Project


def test_mode_too_fast_for_the_step_is_named(root: Path, tmp_path: Path) -> None:
    text = (root / "testbeds" / "differential.toml").read_text()
    bed = tmp_path / "fast.toml"
    bed.write_text(text.replace('sample_time = "100 us"', 'sample_time = "3 ms"'))
    project = Project.read(bed)
    with pytest.raises(ModelError) as caught:
        _ = project.plant
    (problem,) = caught.value.problems
    assert problem.where == "testbed.sample_time"
    assert "Hz" in problem.what and "sample_time of" in problem.remedy
    assert str(bed) in str(caught.value)


def test_very_stiff_shafts_are_still_exact_when_friction_is_elsewhere(root: Path, tmp_path: Path) -> None:
    text = (root / "testbeds" / "differential.toml").read_text()
    bed = tmp_path / "stiff.toml"
    bed.write_text(text.replace('"380 kN m/rad"', '"1e7 kN m/rad"'))
    assert Project.read(bed).plant.name == "plant"

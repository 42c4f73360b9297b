"""One reading tells everything: a slip in one place does not hide those in others."""

from __future__ import annotations

from pathlib import Path

import pytest

from ptgen.errors import TestbedError
from ptgen.testbed import load


def test_a_misspelt_type_hides_nothing(root: Path, tmp_path: Path) -> None:
    text = (root / "testbeds" / "back-to-back.toml").read_text()
    for before, after in (
        ('type = "shaft"', 'type = "shfat"'),
        ('stiffness = "33.5 kN m/rad"', 'stifness = "33.5 N m"'),
        ('speed = ["M2"]', 'speed = ["M3"]'),
        ('inertia = "0.032 kg m^2"', 'inertia = "-1 kg m^2"'),
    ):
        assert before in text
        text = text.replace(before, after)
    bed = tmp_path / "bed.toml"
    bed.write_text(text)
    with pytest.raises(TestbedError) as caught:
        load(bed)
    places = {problem.where for problem in caught.value.problems}
    assert places >= {
        "components.shaft1.type",
        "components.shaft1.stifness",
        "components.shaft1.stiffness",
        "components.flange1.inertia",
        "components.flange2.inertia",
        "control.speed[0]",
    }
    assert all(problem.remedy for problem in caught.value.problems)

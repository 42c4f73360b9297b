"""A small test bed, and a bench that reads what is left of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from ptgen.errors import Problem, TestbedError
from ptgen.testbed import Testbed, load

BED = """\
[testbed]
name = "small"
sample_time = "100 us"
connections = ["M1 - flange1 - shaft1 - M2"]

[components.M1]
type = "machine"
inertia = "1 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"

[components.flange1]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "380 kN m/rad"

[components.shaft1]
type = "shaft"
stiffness = "50 kN m/rad"

[components.M2]
type = "machine"
inertia = "2 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"

[control]
torque = { M1 = "flange1" }
speed = ["M2"]
"""


class Bench:
    """Writes test bed files and reads them back."""

    def __init__(self, folder: Path) -> None:
        self.file = folder / "bed.toml"

    def load(self, text: str) -> Testbed:
        self.file.write_text(text, encoding="utf-8")
        return load(self.file)

    def problems(self, text: str) -> dict[str, Problem]:
        """Return the problems of a file by place; each place once."""
        with pytest.raises(TestbedError) as caught:
            self.load(text)
        assert caught.value.file == str(self.file)
        found = {problem.where: problem for problem in caught.value.problems}
        assert len(found) == len(caught.value.problems)
        assert all(problem.what and problem.remedy for problem in found.values())
        return found

    def problem(self, text: str, where: str) -> Problem:
        """Return the only problem of a file, which must be at `where`."""
        found = self.problems(text)
        assert list(found) == [where], found
        return found[where]

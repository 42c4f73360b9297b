"""Small beds whose plants are compared with independent solutions."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from ptgen.block.block import Block
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.project import Project

MACHINE = """
[components.{name}]
type = "machine"
inertia = "{inertia} kg m^2"
torque_max = "1000 N m"
speed_rated = "3000 rpm"
speed_max = "9000 rpm"
{more}
"""


def two_machines(
    folder: Path,
    chain: str = "flange1 - shaft1",
    components: str = "",
    machines: str = "",
    flange: str = "",
    testbed: str = "",
    place: str = "flange1",
) -> Project:
    """Return a bed of two machines with a torque flange, an elastic shaft and more in between."""
    text = f"""
[testbed]
name = "bed"
sample_time = "100 us"
connections = ["M1 - {chain} - M2"]
{testbed}
{MACHINE.format(name="M1", inertia=1.0, more=machines)}
{MACHINE.format(name="M2", inertia=2.0, more=machines)}
[components.flange1]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "380 kN m/rad"
damping = "0.5 N m s/rad"
{flange}
[components.shaft1]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "3 N m s/rad"
{components}
[control]
torque = {{ M1 = "{place}" }}
speed = ["M2"]
"""
    file = folder / "bed.toml"
    file.write_text(text, encoding="utf-8")
    return Project.read(file)


class Run:
    """A plant step by step with NumPy."""

    def __init__(self, plant: Block) -> None:
        self.block = NumpyBlock(plant)
        self.parameters = self.block.defaults()
        self.derived = self.block.prepare(self.parameters)
        self.states = self.block.initial()
        self.outputs = self.block.measure(self.parameters, self.derived, self.states)

    def step(self, **inputs: float) -> dict[str, np.ndarray]:
        given = {name: np.asarray(value, dtype=float) for name, value in inputs.items()}
        self.states, self.outputs = self.block.step(self.parameters, self.derived, self.states, given)
        return self.outputs

"""One controller step after the other, by NumPy or in C, with everything visible."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ptgen.block.block import Block
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.project import Project
from ptgen.simulate.library import Library

FAST = 1e9
"""A rate that limits nothing."""

_UNWATCHED = ("_disagreement_limit", "_frozen_limit", "_oscillation_limit")


def free(block: Block) -> dict[str, float]:
    """Return parameters with which no reference is limited in its rate, and inputs need not belong to a bed."""
    rates = {s.name: FAST for s in block.parameters if s.name.endswith("_ref_rate")}
    return rates | {s.name: 1e30 for s in block.parameters if s.name.endswith(_UNWATCHED)}


@dataclass
class Controller:
    """The block in NumPy with its state."""

    block: Block
    changes: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.evaluator = NumpyBlock(self.block)
        self.states = self.evaluator.initial()
        self.set(self.changes)

    def set(self, changes: Mapping[str, float]) -> None:
        """Take parameters that differ from the defaults."""
        values = {name: np.array(value, dtype=float) for name, value in {**free(self.block), **changes}.items()}
        assert not set(values) - {s.name for s in self.block.parameters}
        self.parameters = {**self.evaluator.defaults(), **values}
        self.derived = self.evaluator.prepare(self.parameters)

    def step(self, **inputs: float) -> dict[str, float]:
        """Do a step; inputs that are not given are zero."""
        given = {s.name: np.array(inputs.get(s.name, 0.0)) for s in self.block.inputs}
        assert not set(inputs) - set(given), set(inputs) - set(given)
        self.states, outputs = self.evaluator.step(self.parameters, self.derived, self.states, given)
        return {name: float(value) for name, value in outputs.items()}

    def state(self, name: str) -> float:
        """Return a state."""
        return float(self.states[name])


class Compiled:
    """The same in C."""

    def __init__(self, library: Library, changes: Mapping[str, float]) -> None:
        self.block = library.controller
        self.parameters = self.block.parameters({**free(self.block.block), **changes})
        status, self.memory = self.block.init(self.parameters)
        assert status == 0, self.block.status_text(status)
        self.inputs, self.outputs = self.block.inputs_type(), self.block.outputs_type()

    def set(self, changes: Mapping[str, float]) -> None:
        """Change parameters."""
        for name, value in changes.items():
            setattr(self.parameters, name, value)
        assert self.block.update(self.memory, self.parameters) == 0

    def step(self, **inputs: float) -> dict[str, float]:
        """Do a step; inputs that are not given stay as they were."""
        for name, value in inputs.items():
            setattr(self.inputs, name, value)
        assert self.block.step_struct(self.memory, self.parameters, self.inputs, self.outputs) == 0
        return {signal.name: getattr(self.outputs, signal.name) for signal in self.block.block.outputs}

    def state(self, name: str) -> float:
        """Return a state."""
        return float(getattr(self.memory, name))


class Bench:
    """Emitted controller and plant in closed loop."""

    def __init__(self, project: Project, library: Library, **changes: float) -> None:
        self.project, self.library = project, library
        controller, plant = library.controller, library.plant
        known = {s.name for s in controller.block.parameters}
        self.params = controller.parameters({k: v for k, v in changes.items() if k in known})
        self.plant_params = plant.parameters({k: v for k, v in changes.items() if k not in known})
        status, self.state = controller.init(self.params)
        assert status == 0, controller.status_text(status)
        status, self.plant_state = plant.init(self.plant_params)
        assert status == 0, plant.status_text(status)
        self.measured = plant.measure(self.plant_state, self.plant_params)

    def change(self, **values: float) -> None:
        """Change parameters of the controller while it runs."""
        for name, value in values.items():
            setattr(self.params, name, value)
        assert self.library.controller.update(self.state, self.params) == 0

    def run(self, steps: int, **references: float) -> dict[str, np.ndarray]:
        """Do steps with constant references; return what was measured and commanded in each of them."""
        rows: list[dict[str, float]] = []
        for _ in range(steps):
            given = {s.name: self.measured.get(s.name, 0.0) for s in self.project.controller.inputs} | references
            status, commands = self.library.controller.step(self.state, self.params, given)
            assert status == 0, self.library.controller.status_text(status)
            rows.append({**self.measured, **commands})
            inputs = {s.name: commands.get(s.name, 0.0) for s in self.project.plant.inputs}
            _, self.measured = self.library.plant.step(self.plant_state, self.plant_params, inputs)
        return {name: np.array([row[name] for row in rows]) for name in rows[0]}

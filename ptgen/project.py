"""All stages of a bed in a row, each computed once and only when it is asked for."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from pathlib import Path

from ptgen.analysis.continuous_proof import ContinuousProof, continuous_proof
from ptgen.block.block import Block
from ptgen.control.design import ControlDesign, design_control
from ptgen.errors import PtgenError
from ptgen.governor.constraint_set import ConstraintSet, torque_limits
from ptgen.governor.governed_controller import governed_controller
from ptgen.governor.prediction import Prediction, predict_loop
from ptgen.governor.set_cache import cached_constraint_set
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.control_bed import as_ratio_rules, control_bed
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism
from ptgen.plant.plant import plant_block
from ptgen.testbed import Testbed, load

__all__ = ["Project"]


class Project:
    """The way from a test bed to its blocks.

    Parameters
    ----------
    testbed : Testbed

    Raises
    ------
    PtgenError
        From each stage; problems then carry the file's name.
    """

    def __init__(self, testbed: Testbed) -> None:
        self.testbed = testbed

    @classmethod
    def read(cls, path: str | Path) -> Project:
        """Read a test bed file."""
        return cls(load(path))

    @cached_property
    def mechanism(self) -> Mechanism:
        """The elements of all components."""
        return Mechanism.of(self.testbed)

    @cached_property
    def model(self) -> Model:
        """The full model, friction velocities first, all gaps closed, without fluids: linear but for friction."""
        with _located(self.testbed.file):
            return assemble(self.mechanism.with_closed_backlash().without_fluids())

    @cached_property
    def plant_model(self) -> Model:
        """The full model with its gaps and fluids."""
        if not self.mechanism.fluids and not any(spring.backlash is not None for spring in self.mechanism.springs):
            return self.model
        with _located(self.testbed.file):
            return assemble(self.mechanism)

    @cached_property
    def control_bed(self) -> Testbed:
        """The bed as control sees it: the bed itself, or with ratios in place of transmissions."""
        return control_bed(self.testbed)

    @cached_property
    def control_mechanism(self) -> Mechanism:
        """The elements of the bed as control sees it."""
        return self.mechanism if self.control_bed is self.testbed else Mechanism.of(self.control_bed)

    @cached_property
    def control_model(self) -> Model:
        """The full model of the bed as control sees it, all gaps closed."""
        if self.control_bed is self.testbed:
            return self.model
        with _located(self.testbed.file):
            return assemble(self.control_mechanism.with_closed_backlash().without_fluids())

    @cached_property
    def reduced(self) -> ReducedModel:
        """The reduced model."""
        with _located(self.testbed.file):
            settings = self.control_bed.reduction
            reduced = reduce_mechanism(self.control_mechanism, settings, self.control_model)
            if self.control_bed is self.testbed:
                return reduced
            rules = as_ratio_rules(self.testbed, self.model, self.control_model, settings.locked)
            return replace(reduced, rules=(*rules, *reduced.rules))

    @cached_property
    def design(self) -> ControlDesign:
        """The control design."""
        with _located(self.testbed.file):
            return design_control(self.control_bed, self.reduced.full, self.reduced)

    @cached_property
    def plant(self) -> Block:
        """The plant's block."""
        with _located(self.testbed.file):
            return plant_block(self.plant_model, self.testbed.sample_time)

    @cached_property
    def proof(self) -> ContinuousProof:
        """The stability of the design in continuous time."""
        return continuous_proof(self.design, self.reduced)

    @cached_property
    def prediction(self) -> Prediction:
        """The nominal closed loop that a reference governor predicts with."""
        with _located(self.testbed.file):
            return predict_loop(self.design, self.control_bed)

    @cached_property
    def constraints(self) -> ConstraintSet:
        """The rows that the optimal governor keeps."""
        with _located(self.testbed.file):
            return cached_constraint_set(self.prediction, torque_limits(self.reduced.full), self.testbed.governor)

    @cached_property
    def controller(self) -> Block:
        """The controller's block: that of the design, behind the reference governor if the file asks for one."""
        governor = self.testbed.governor
        if not governor.is_chosen:
            return self.design.controller.block
        with _located(self.testbed.file):
            constraints = self.constraints if governor.kind == "optimal" else None
            full = self.reduced.full
            return governed_controller(self.design, self.control_bed, full, self.prediction, constraints).block

    def blocks(self) -> tuple[Block, Block]:
        """Return controller and plant."""
        plant = self.plant  # what it cannot solve is found sooner than a law
        return self.controller, plant


class _located:  # noqa: N801  reads as a phrase: with _located(file)
    """Gives errors of later stages the file that they come from."""

    def __init__(self, file: str) -> None:
        self._file = file

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, PtgenError) and not error.file:
            raise type(error)(error.problems, self._file) from None

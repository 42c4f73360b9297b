"""The control design of a bed: law, gains and the emitted block."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ptgen.control.controller import ControllerBlock, controller_block
from ptgen.control.decoupling import Decoupling, decouple
from ptgen.control.tuning import Gains, gains
from ptgen.mechanism.model import Model
from ptgen.mechanism.reduction import ReducedModel
from ptgen.testbed.testbed import Testbed

__all__ = ["ControlDesign", "design_control", "gear_values"]


@dataclass(frozen=True)
class ControlDesign:
    """Everything that the control of a bed consists of."""

    decoupling: Decoupling
    gains: Gains
    controller: ControllerBlock

    @property
    def tuned_inertia(self) -> dict[sp.Symbol, float]:
        """The inertia (kg m^2) that the law of each torque-controlled machine takes for its own."""
        design, found = self.decoupling, self.gains.inertia_estimate
        names = [design.machines[k] for k in design.actuators[: design.torque_count]]
        return {symbol: found[name] for symbol, name in zip(design.inertia_estimate, names, strict=True)}


def design_control(testbed: Testbed, full: Model, reduced: ReducedModel) -> ControlDesign:
    """Design the controller for the roles and the wishes in the test bed file.

    Raises
    ------
    ControlError
        See `decouple`.
    """
    flanges = [f"{name}.{testbed.components[name].flange_names()[0]}" for name in testbed.tuning.losses]
    decoupling = decouple(reduced, testbed.roles, testbed.tuning.structure, flanges)
    tuned = gains(decoupling, full, testbed.tuning, reduced.modes_before)
    gears = gear_values(testbed)
    block = controller_block(decoupling, tuned, testbed.tuning, full, testbed.sample_time, gears=gears)
    return ControlDesign(decoupling, tuned, block)


def gear_values(testbed: Testbed) -> dict[str, tuple[float, ...]]:
    """Return the ratios of the gears of each component that is a ratio for control, by its name."""
    return {name: tuple(gears.values()) for name, gears in testbed.reduction.gear_ratios.items()}

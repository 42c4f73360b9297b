"""The controller of a bed with the reference governor that its file asks for."""

from __future__ import annotations

from ptgen.control.controller import ControllerBlock, controller_block
from ptgen.control.design import ControlDesign, gear_values
from ptgen.errors import ControlError, Problem
from ptgen.governor.constraint_set import ConstraintSet, torque_limits
from ptgen.governor.prediction import Prediction
from ptgen.governor.shaping import ReferenceGovernor
from ptgen.mechanism.model import Model
from ptgen.testbed.testbed import Testbed

__all__ = ["governed_controller"]


def governed_controller(
    design: ControlDesign,
    testbed: Testbed,
    full: Model,
    prediction: Prediction,
    constraints: ConstraintSet | None = None,
) -> ControllerBlock:
    """Return the controller with its governor.

    Parameters
    ----------
    design : ControlDesign
    testbed : Testbed
        The bed that it was made for.
    full : Model
        Its full model.
    prediction : Prediction
    constraints : ConstraintSet, optional
        Needed for the optimal governor.

    Raises
    ------
    ControlError
        If the speed control of a machine has no governor, if more torque is to be kept free than there is, or if the
        optimal one needs what the controller does not know.
    """
    tuning = testbed.tuning
    names = [design.decoupling.machines[k] for k in design.decoupling.actuators[design.decoupling.torque_count :]]
    if twisting := [name for name in names if tuning.speed_control_of(name) == "super_twisting"]:
        what = (
            f"needs speed control that is linear in its reference; that of {' and '.join(twisting)} is super-twisting"
        )
        raise ControlError(Problem("governor.kind", what, 'choose "pi" or "observer" as control.speed_control'))
    changing = [parameter.symbol.name for parameter in design.decoupling.model.changing]
    if testbed.governor.kind == "optimal" and changing:
        what = f"looks ahead with one model of the bed, but {' and '.join(changing)} changes at run time"
        raise ControlError(Problem("governor.kind", what, 'choose "sequential_modified", which needs no model'))
    _check_reserve(design, testbed, full)
    governor = ReferenceGovernor(testbed.governor, prediction, constraints)
    return controller_block(
        design.decoupling, design.gains, tuning, full, testbed.sample_time, governor, gear_values(testbed)
    )


def _check_reserve(design: ControlDesign, testbed: Testbed, full: Model) -> None:
    """Refuse a reserve of torque that leaves a torque-controlled machine nothing."""
    settings, decoupling, problems = testbed.governor, design.decoupling, []
    limits = dict(zip(decoupling.machines, torque_limits(full), strict=True))
    for machine in decoupling.actuators[: decoupling.torque_count]:
        name = decoupling.machines[machine]
        available = (1 - settings.reserve) * limits[name].largest
        if settings.torque_reserve >= available:
            what = f"{settings.torque_reserve:g} N m is as much as all that the governor may use of {name}, or more"
            problems.append(Problem("governor.torque_reserve", what, f"take less than {available:g} N m"))
    if problems:
        raise ControlError(problems)

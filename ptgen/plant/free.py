"""The plant with all friction elements free and all ratios held, for linear analysis."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ptgen.block.block import Assign, Block, Call, Statement, element

__all__ = ["with_free_frictions", "with_held_ratios"]


def with_free_frictions(plant: Block) -> Block:
    """Return the plant in which friction elements exert their linear viscous torques only, and none ever sticks.

    Ratios that change at run time are held, see `with_held_ratios`. What is left of a plant without backlash is linear
    in its states.
    """
    plant = with_held_ratios(plant)
    return replace(plant, step=tuple(part for statement in plant.step for part in _freed(statement, plant)))


def with_held_ratios(plant: Block) -> Block:
    """Return the plant whose ratios are parameters, ``<gearbox>_ratio_now``, instead of inputs and states."""
    states = {item.state for item in plant.tracked}
    inputs = {item.input: item.state for item in plant.tracked}
    held = tuple(replace(signal, name=inputs[signal.name]) for signal in plant.inputs if signal.name in inputs)
    return replace(
        plant,
        parameters=(*plant.parameters, *held),
        inputs=tuple(signal for signal in plant.inputs if signal.name not in inputs),
        states=tuple(signal for signal in plant.states if signal.name not in states),
        tracked=(),
    )


def _freed(statement: Statement, plant: Block) -> list[Statement]:
    if not isinstance(statement, Call) or statement.kernel != "friction_step":
        return [statement]
    mean, end, _, velocities, status = statement.outputs
    free = statement.inputs[2]
    count = range(plant.declared(free).shape[0])
    zero = [Assign(str(element(name, i)), sp.Integer(0)) for name in (mean, end) for i in count]
    moving = [Assign(str(element(velocities, i)), element(free, i)) for i in count]
    return [*zero, *moving, Assign(status, sp.Integer(0))]

"""The plant with all friction elements free, for linear analysis."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ptgen.block.block import Assign, Block, Call, Statement, element

__all__ = ["with_free_frictions"]


def with_free_frictions(plant: Block) -> Block:
    """Return the plant in which friction elements exert their linear viscous torques only, and none ever sticks.

    What is left of a plant without backlash is linear in its states.
    """
    return replace(plant, step=tuple(part for statement in plant.step for part in _freed(statement, plant)))


def _freed(statement: Statement, plant: Block) -> list[Statement]:
    if not isinstance(statement, Call) or statement.kernel != "friction_step":
        return [statement]
    mean, end, _, velocities, status = statement.outputs
    free = statement.inputs[2]
    count = range(plant.declared(free).shape[0])
    zero = [Assign(str(element(name, i)), sp.Integer(0)) for name in (mean, end) for i in count]
    moving = [Assign(str(element(velocities, i)), element(free, i)) for i in count]
    return [*zero, *moving, Assign(status, sp.Integer(0))]

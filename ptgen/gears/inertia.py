r"""Kinetic energy of a gear set in one of its motions, and the inertia that its input feels.

In a gear all velocities that follow from the input's are known. What the gear leaves free, such as a branch whose
clutch is open, takes part with the motion in which no torque acts on it. That is the one of least kinetic energy, so
the inertia at the input is twice the least energy with :math:`\omega_{in} = 1`.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from ptgen.gears.combinations import State, combinations
from ptgen.gears.freewheels import with_freewheels
from ptgen.gears.layout import Layout
from ptgen.gears.vectors import Vector, null_space

__all__ = ["energy", "input_inertia", "torque_free"]


def energy(layout: Layout, first: Vector, second: Vector) -> Fraction:
    """Return ``first' M second`` of two motions, velocities of all members; of a motion twice its kinetic energy."""
    members = layout.members
    terms = ((inertia, members.index(member)) for member, inertia in layout.inertias.items())
    return sum((inertia * first[k] * second[k] for inertia, k in terms), Fraction(0))


def torque_free(layout: Layout, motions: Sequence[Vector], free: Sequence[Vector]) -> list[Vector]:
    """Return motions with what is free in them at the least kinetic energy.

    Parameters
    ----------
    layout : Layout
    motions : sequence of Vector
        Velocities of all members.
    free : sequence of Vector
        Motions that may be added to them.
    """
    own: list[Vector] = []  # with kinetic energy, orthogonal to each other
    for motion in free:
        rest = _without(layout, motion, own)
        if energy(layout, rest, rest):
            own.append(rest)
    return [_without(layout, motion, own) for motion in motions]


def input_inertia(layout: Layout, engaged: Sequence[str], ratio: float | None = None) -> float:
    """Return the inertia of all that turns with the input (kg m^2); 0 if nothing ties the output to it.

    Parameters
    ----------
    layout : Layout
    engaged : sequence of str
        The engaged elements; freewheels lock besides if the gear needs them.
    ratio : float, optional
        Ties input and output together if nothing is engaged: input speed over output speed.
    """
    rows = [layout.train_vector(train) for train in layout.trains]
    found = with_freewheels(layout, combinations(layout), engaged)
    if found is not None and found.state is State.GEAR:
        rows += [layout.element_vector(element) for element in layout.elements if element.name in found.engaged]
    elif ratio is not None and not engaged:
        ends = layout.unit_vector(layout.input), layout.unit_vector(layout.output)
        rows.append([a - Fraction(ratio) * b for a, b in zip(*ends, strict=True)])
    else:
        return 0.0
    place = layout.members.index(layout.input)
    basis = null_space(rows, len(layout.members))
    turning = next((motion for motion in basis if motion[place]), None)
    if turning is None:
        return 0.0
    unit = [speed / turning[place] for speed in turning]
    free = [_less(motion, motion[place], unit) for motion in basis if motion is not turning]
    (motion,) = torque_free(layout, [unit], free)
    return float(energy(layout, motion, motion))


def _without(layout: Layout, motion: Vector, others: Sequence[Vector]) -> Vector:
    """Return a motion without its shares of others, which are orthogonal to each other."""
    for other in others:
        motion = _less(motion, energy(layout, motion, other) / energy(layout, other, other), other)
    return motion


def _less(vector: Vector, factor: Fraction, other: Vector) -> Vector:
    return [a - factor * b for a, b in zip(vector, other, strict=True)]

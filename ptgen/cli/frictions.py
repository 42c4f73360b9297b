"""Friction elements in words: what kind they are, and which of them hold the same motion."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ptgen.elements import Friction
    from ptgen.mechanism.model import Model

__all__ = ["dependence_text", "dependent_among", "kinds"]


def kinds(friction: Friction) -> list[str]:
    """Return what a friction element is there for and what its torque depends on, in words.

    Examples
    --------
    >>> import sympy as sp
    >>> from ptgen.elements import Friction, FrictionRole
    >>> kinds(Friction("f", {}, sp.Integer(0), sp.Integer(0), FrictionRole.COUPLING, one_way=True))
    ['coupling', 'one-way']
    """
    found = {
        "actuated": friction.actuated,
        "one-way": friction.one_way,
        "load-dependent": friction.load is not None,
        "stronger at rest": friction.static is not None,
        "saturated": friction.saturated is not None,
        "angle-dependent": friction.ripple is not None,
    }
    return [friction.role.value, *(word for word, applies in found.items() if applies)]


def dependent_among(model: Model, names: Collection[str]) -> tuple[tuple[str, ...], ...]:
    """Return the sets of the named friction elements that hold the same motion while all of them stick."""
    from ptgen.mechanism.dependence import dependent_sets

    chosen = [index for index, friction in enumerate(model.frictions) if friction.name in names]
    part = replace(
        model,
        frictions=tuple(model.frictions[index] for index in chosen),
        friction_rows=model.friction_rows[chosen, :],
    )
    return dependent_sets(part)


def dependence_text(names: Sequence[str]) -> str:
    """Return what follows for elements that hold the same motion.

    Examples
    --------
    >>> dependence_text(["brakeA", "brakeB"])
    '"brakeA" and "brakeB" hold the same motion: their torques are not unique, those of least norm are reported'
    """
    quoted = [f'"{name}"' for name in names]
    listed = f"{', '.join(quoted[:-1])} and {quoted[-1]}"
    motion = "motion" if len(names) == 2 else "motions"
    return f"{listed} hold the same {motion}: their torques are not unique, those of least norm are reported"

"""What the templates of the friction code need to know of a plant."""

from __future__ import annotations

from ptgen.block.block import Block, Call
from ptgen.friction.backlash import SWEEPS
from ptgen.friction.box import LEAST_SHIFT, NO_PIVOT, PATIENCE
from ptgen.friction.step import UNSOLVED

__all__ = ["friction_context", "uses_friction"]


def friction_context(elements: int, contacts: int) -> dict[str, object]:
    """Return the context of ``friction.{h,c}.jinja``.

    Parameters
    ----------
    elements, contacts : int
        Number of friction elements and of shafts with backlash.
    """
    return {
        "elements": elements,
        "contacts": contacts,
        "no_pivot": NO_PIVOT,
        "least_shift": LEAST_SHIFT,
        "patience": PATIENCE,
        "unsolved": int(UNSOLVED),
        "sweeps": SWEEPS,
    }


def uses_friction(plant: Block) -> dict[str, object] | None:
    """Return the context for a plant, or None if it has neither friction nor backlash."""
    calls = {statement.kernel: statement for statement in plant.step if isinstance(statement, Call)}
    friction, backlash = calls.get("friction_step"), calls.get("backlash_step")
    if friction is None and backlash is None:
        return None
    return friction_context(
        elements=plant.declared("K").shape[0] if friction else 0,
        contacts=plant.declared("kappa").shape[0] if backlash else 0,
    )

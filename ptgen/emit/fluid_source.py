"""What the template of the code for fluids needs to know of a plant."""

from __future__ import annotations

from ptgen.block.block import Block, Call
from ptgen.friction.fluid import FASTER, ROWS, SLOWER

__all__ = ["fluid_context", "uses_fluid"]


def fluid_context() -> dict[str, object]:
    """Return the context of ``fluid.h.jinja``."""
    return {"faster": FASTER, "slower": SLOWER, "stride": (ROWS + 3) // 4 * 4}


def uses_fluid(block: Block) -> dict[str, object] | None:
    """Return the context for a block, or None if it has no fluid."""
    calls = (statement for statement in block.step if isinstance(statement, Call))
    return fluid_context() if any(call.kernel == "fluid_torques" for call in calls) else None

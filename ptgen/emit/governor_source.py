"""What the templates of the governors need to know of a controller."""

from __future__ import annotations

from ptgen.block.block import Block, Call
from ptgen.emit.c_expressions import Precision, literal
from ptgen.shaping.dual_simplex import FEASIBLE, LEAST_PIVOT
from ptgen.shaping.optimal import LARGEST, LIMITED, MARGIN, NOT_SOLVED, NOTHING_BINDS, SLACK
from ptgen.shaping.sequential import TOLERANCE, UNLIMITED

__all__ = ["GOVERNORS", "governor_context", "uses_governor"]

GOVERNORS = ("sequential_governor", "optimal_governor")
"""Kernels whose C is made for the sizes and numbers of their call."""

_SINGLE = 1e-5
"""What stands for smaller tolerances in single precision."""


def governor_context(
    machines: int,
    precision: Precision,
    order: tuple[int, ...] = (),
    states: int = 0,
    table_rows: int = 0,
    numbers: tuple[int, ...] = (),
) -> dict[str, object]:
    """Return the context of ``governor.{h,c}.jinja``.

    Parameters
    ----------
    machines : int
        Number of machines, and of references.
    precision : {"double", "float"}
    order : tuple of int
        Row and reference of each step of the sequential governor; empty if it is not used.
    states, table_rows : int
        Columns and rows of the table of the optimal governor.
    numbers : tuple of int
        Rows of each machine, and the bound of iterations; empty if the optimal governor is not used.
    """
    least = _SINGLE if precision == "float" else 0.0
    firsts = [sum(numbers[:i]) for i in range(machines + 1)] if numbers else []
    return {
        "machines": machines,
        "steps": list(zip(order[::2], order[1::2], strict=True)),
        "states": states,
        "table_rows": table_rows,
        "first_rows": firsts,
        "iterations": numbers[machines] if numbers else 0,
        "feasible": literal(max(FEASIBLE, least), precision),
        "least_pivot": literal(max(LEAST_PIVOT, least), precision),
        "margin": literal(max(MARGIN, least), precision),
        "largest": literal(LARGEST, precision),
        "worse": literal(max(TOLERANCE, least), precision),
        "unlimited": literal(UNLIMITED, precision),
        "statuses": [literal(status, precision) for status in (NOTHING_BINDS, LIMITED, SLACK, NOT_SOLVED)],
    }


def uses_governor(block: Block, precision: Precision) -> dict[str, object] | None:
    """Return the context for a block, or None if it has no governor.

    Raises
    ------
    ValueError
        If calls of a governor differ in size or order: the code is made for one of each. Or if one puts its results
        where its inputs are: it reads them to the end.
    """
    statements = [*block.prepare, *block.refresh, *block.step, *block.measure]
    calls = [statement for statement in statements if isinstance(statement, Call)]
    for call in calls:
        if call.kernel in GOVERNORS and (shared := {*call.outputs} & {*call.inputs}):
            raise ValueError(f"block {block.name}: {sorted(shared)} cannot be both input and output of a governor")
    sequential = {call.numbers for call in calls if call.kernel == "sequential_governor"}
    optimal = {(call.numbers, block.shape(call.inputs[8])) for call in calls if call.kernel == "optimal_governor"}
    sizes = {block.shape(call.outputs[0])[0] for call in calls if call.kernel in GOVERNORS}
    if not sizes:
        return None
    if len(sequential) > 1 or len(optimal) > 1 or len(sizes) > 1:
        raise ValueError(f"block {block.name}: its governors differ in size or order")
    order = next(iter(sequential), ())
    numbers, (table_rows, states) = next(iter(optimal), ((), (0, 0)))
    return governor_context(sizes.pop(), precision, order, states, table_rows, numbers)

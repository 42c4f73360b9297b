"""CasADi functions of a block as files."""

from __future__ import annotations

from ptgen.block.block import Block
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.block.function_files import function_files

__all__ = ["casadi_files"]


def casadi_files(block: Block, prefix: str) -> dict[str, bytes]:
    """Return the functions of a block as ``.casadi`` files and as C, by file name.

    Load them with ``casadi.Function.load``; arguments are described in `ptgen.block.casadi_evaluator`.
    """
    functions = CasadiBlock(block)
    chosen = [functions.step]
    if block.prepare:
        chosen.insert(0, functions.prepare)
    if block.measure:
        chosen.append(functions.measure)
    return function_files(chosen, prefix, block.name)

"""CasADi functions of a block as files."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

import casadi as ca

from ptgen.block.block import Block
from ptgen.block.casadi_evaluator import CasadiBlock

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
    result = {}
    with tempfile.TemporaryDirectory() as folder:
        for function in chosen:
            path = Path(folder) / f"{prefix}_{function.name()}.casadi"
            function.save(str(path))
            result[path.name] = path.read_bytes()
        generator = ca.CodeGenerator(f"{prefix}_{block.name}_casadi.c")
        for function in chosen:
            generator.add(function)
        text = generator.dump()
        # The version of CasADi would change the file without changing the code.
        result[f"{prefix}_{block.name}_casadi.c"] = re.sub(r"CasADi \d[\w.+-]*", "CasADi", text).encode("utf-8")
    return result

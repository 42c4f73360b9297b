"""CasADi functions as files that other programs load or compile."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Sequence
from pathlib import Path

import casadi as ca

__all__ = ["function_files"]


def function_files(functions: Sequence[ca.Function], prefix: str, name: str) -> dict[str, bytes]:
    """Return each function as ``<prefix>_<function>.casadi``, and all of them as C in ``<prefix>_<name>_casadi.c``.

    Load the former with ``casadi.Function.load``; the latter needs no library but that of C.
    """
    result = {}
    with tempfile.TemporaryDirectory() as folder:
        for function in functions:
            path = Path(folder) / f"{prefix}_{function.name()}.casadi"
            function.save(str(path))
            result[path.name] = path.read_bytes()
    generator = ca.CodeGenerator(f"{prefix}_{name}_casadi.c")
    for function in functions:
        generator.add(function)
    # The version of CasADi would change the file without changing the code.
    text = re.sub(r"CasADi \d[\w.+-]*", "CasADi", generator.dump())
    result[f"{prefix}_{name}_casadi.c"] = text.encode("utf-8")
    return result

"""ptgen: from one file that describes a power train test bed to model, controller and C code."""

from __future__ import annotations

import importlib
from typing import Any

__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    # The stages take a second to import, which `ptgen --version` should not have to wait for.
    if name in {"analyse", "govern", "load", "tune"}:
        return getattr(importlib.import_module("ptgen.api"), name)
    if name in {"emit", "simulate"}:  # packages that can be called, see there
        return importlib.import_module(f"ptgen.{name}")
    raise AttributeError(f"module 'ptgen' has no attribute {name!r}")

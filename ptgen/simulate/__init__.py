"""Simulation: build the emitted code, run scenarios in it.

The package can be called like the function of the same name in `ptgen.api`: ``ptgen.simulate(...)``.
"""

from __future__ import annotations

import importlib
import sys
import types
from typing import Any


class _CallablePackage(types.ModuleType):
    """A package that is also the function that people look for under its name."""

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return importlib.import_module("ptgen.api").simulate(*arguments, **options)


sys.modules[__name__].__class__ = _CallablePackage

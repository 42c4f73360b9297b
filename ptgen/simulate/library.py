"""The emitted code of a bed, compiled and loaded."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.block.block import Block, Signal
from ptgen.emit.c_block import padded
from ptgen.emit.c_expressions import Precision

__all__ = ["PROFILE_FIELDS", "CompiledBlock", "Library"]

PROFILE_FIELDS: list[tuple[str, Any]] = [
    ("count", ctypes.c_long),
    ("steps", ctypes.c_int),
    ("time", ctypes.POINTER(ctypes.c_double)),
    ("value", ctypes.POINTER(ctypes.c_double)),
]


def _structure(name: str, signals: tuple[Signal, ...], real: Any) -> type[ctypes.Structure]:
    fields: list[tuple[str, Any]] = []
    for signal in signals:
        kind = real
        if signal.shape:
            kind = kind * padded(signal.shape[0])
            if len(signal.shape) == 2:
                kind = kind * signal.shape[1]
        fields.append((signal.name, kind))
    return type(name, (ctypes.Structure,), {"_fields_": fields or [("unused", real)]})


class CompiledBlock:
    """The C evaluator of a block: the same calls as `ptgen.block.numpy_evaluator.NumpyBlock`, without batches.

    Parameters
    ----------
    block : Block
    prefix : str
    library : ctypes.CDLL
    precision : {"double", "float"}
    """

    def __init__(self, block: Block, prefix: str, library: ctypes.CDLL, precision: Precision) -> None:
        real = ctypes.c_float if precision == "float" else ctypes.c_double
        self.block = block
        name = f"{prefix}_{block.name}"
        self.params_type = _structure("params", block.parameters, real)
        self.inputs_type = _structure("inputs", block.inputs, real)
        self.outputs_type = _structure("outputs", block.outputs, real)
        self.state_type = _structure("state", block.states + block.derived, real)
        self._init = getattr(library, f"{name}_init")
        self._update = getattr(library, f"{name}_update")
        self._step = getattr(library, f"{name}_step")
        self._measure = getattr(library, f"{name}_measure") if block.measure else None
        self._text = getattr(library, f"{name}_status_text")
        self._text.restype = ctypes.c_char_p
        self._library, self._name = library, name

    def defaults(self, variant: str = "defaults") -> Any:
        """Return a copy of the default parameters as a struct."""
        original = self.params_type.in_dll(self._library, f"{self._name}_{variant}")
        copy = self.params_type()
        ctypes.memmove(ctypes.byref(copy), ctypes.byref(original), ctypes.sizeof(copy))
        return copy

    def parameters(self, values: Mapping[str, Any]) -> Any:
        """Return a parameter struct with `values` in place of the defaults."""
        struct = self.defaults()
        for name, value in values.items():
            setattr(struct, name, float(value))
        return struct

    def init(self, params: Any) -> tuple[int, Any]:
        """Return status and state."""
        state = self.state_type()
        return int(self._init(ctypes.byref(state), ctypes.byref(params))), state

    def update(self, state: Any, params: Any) -> int:
        """Prepare `state` for changed parameters; return the status."""
        return int(self._update(ctypes.byref(state), ctypes.byref(params)))

    def step(self, state: Any, params: Any, inputs: Mapping[str, Any]) -> tuple[int, dict[str, float]]:
        """Do one step in place; return status and outputs."""
        given = self.inputs_type(**{signal.name: float(inputs[signal.name]) for signal in self.block.inputs})
        outputs = self.outputs_type()
        status = self.step_struct(state, params, given, outputs)
        return status, {signal.name: float(getattr(outputs, signal.name)) for signal in self.block.outputs}

    def step_struct(self, state: Any, params: Any, inputs: Any, outputs: Any) -> int:
        """Do one step with inputs and outputs in structs; return the status."""
        return int(self._step(*map(ctypes.byref, (state, params, inputs, outputs))))

    def measure(self, state: Any, params: Any) -> dict[str, float]:
        """Return the outputs of a state."""
        outputs = self.outputs_type()
        if self._measure is not None:
            self._measure(*map(ctypes.byref, (state, params, outputs)))
        return {signal.name: float(getattr(outputs, signal.name)) for signal in self.block.outputs}

    def status_text(self, status: int) -> str:
        """Return a status in words."""
        return str(self._text(status).decode("ascii"))

    def read(self, state: Any, name: str) -> NDArray[np.float64]:
        """Return a state or derived quantity as an array of its shape."""
        signal = self.block.declared(name)
        value = np.array(getattr(state, name), dtype=np.float64)
        if len(signal.shape) == 2:
            return value.T[: signal.shape[0]].copy()
        return value[: signal.shape[0]].copy() if signal.shape else value

    def write(self, state: Any, name: str, value: Any) -> None:
        """Set a state."""
        signal = self.block.declared(name)
        if not signal.shape:
            setattr(state, name, float(value))
            return
        target = getattr(state, name)
        for index, entry in enumerate(np.asarray(value, dtype=float)):
            target[index] = float(entry)


class Library:
    """A compiled bed.

    Attributes
    ----------
    path : Path
        The shared library.
    controller, plant : CompiledBlock
    """

    def __init__(self, path: Path, prefix: str, blocks: tuple[Block, Block], precision: Precision) -> None:
        self.path = path
        self.prefix = prefix
        self.precision: Precision = precision
        self.handle = ctypes.CDLL(str(path))
        self.controller = CompiledBlock(blocks[0], prefix, self.handle, precision)
        self.plant = CompiledBlock(blocks[1], prefix, self.handle, precision)

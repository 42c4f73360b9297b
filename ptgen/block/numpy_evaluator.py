"""The NumPy evaluator of blocks; works on batches."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.block.block import Assign, Block, Call, parse_element
from ptgen.block.expressions import Arithmetic, evaluate
from ptgen.block.kernels import KERNELS

__all__ = ["NumpyBlock", "Values"]

Array = NDArray[np.float64]
Values = dict[str, Array]

_ARITHMETIC = Arithmetic(
    absolute=np.abs,
    minimum=np.minimum,
    maximum=np.maximum,
    select=np.where,
    exponential=np.exp,
    sine=np.sin,
    floor=np.floor,
    sign=np.sign,
    root=np.sqrt,
    both=np.logical_and,
    either=np.logical_or,
    negate=np.logical_not,
)


class NumpyBlock:
    """Evaluates a block with NumPy.

    Signals are arrays ``(..., *shape)`` with any leading batch axes, the same for all of them.

    Parameters
    ----------
    block : Block
    """

    def __init__(self, block: Block) -> None:
        self.block = block
        self._tables = {table.name: table.array() for table in block.tables}

    def defaults(self) -> Values:
        """Return the default parameters."""
        return {signal.name: np.full(signal.shape, signal.value) for signal in self.block.parameters}

    def prepare(self, parameters: Mapping[str, Array], states: Mapping[str, Array] | None = None) -> Values:
        """Return what follows from the parameters, and from tracked quantities; these are initial without `states`."""
        table = {**self._tables, **parameters}
        given = self.initial() if states is None else states
        tracked = {item.state: given[item.state] for item in self.block.tracked}
        batch = np.broadcast_shapes(self._batch(parameters), self._batch(tracked))
        table |= tracked
        table |= {signal.name: np.zeros(batch + signal.shape) for signal in self.block.derived + self.block.arrays}
        self._run("prepare", table)
        self._run("refresh", table)
        return {signal.name: table[signal.name] for signal in self.block.derived}

    def initial(self) -> Values:
        """Return the initial states."""
        return {signal.name: np.full(signal.shape, signal.value) for signal in self.block.states}

    def step(
        self, parameters: Mapping[str, Array], derived: Mapping[str, Array], states: Values, inputs: Mapping[str, Array]
    ) -> tuple[Values, Values]:
        """Return the states and outputs after one step; the arguments are not changed."""
        batch = self._batch(inputs) or self._batch(states)
        table: Values = {**self._tables, **parameters, **derived, **inputs}
        table |= {name: np.broadcast_to(value, batch + self._shape(name)).copy() for name, value in states.items()}
        table |= {item.state: np.asarray(inputs[item.input], dtype=float) for item in self.block.tracked}
        self._follow(parameters, table)
        table |= {signal.name: np.zeros(batch + signal.shape) for signal in self.block.arrays + self.block.outputs}
        self._run("step", table)
        self._run("measure", table)
        for signal in self.block.states + self.block.outputs:  # what follows from parameters alone has no batch yet
            table[signal.name] = np.broadcast_to(table[signal.name], batch + signal.shape)
        return self._pick(table)

    def measure(self, parameters: Mapping[str, Array], derived: Mapping[str, Array], states: Values) -> Values:
        """Return the outputs that follow from the states."""
        batch = self._batch(states)
        table: Values = {**self._tables, **parameters, **derived, **states}
        self._follow(parameters, table)
        table |= {signal.name: np.zeros(batch + signal.shape) for signal in self.block.arrays + self.block.outputs}
        self._run("measure", table)
        return self._pick(table)[1]

    def _follow(self, parameters: Mapping[str, Array], table: Values) -> None:
        """Compute in a table what depends on the tracked quantities in it."""
        tracked = self.block.tracked
        if any(not item.quick for item in tracked):
            table |= self.prepare(parameters, table)
        elif tracked:
            batch = np.broadcast_shapes(*(np.shape(table[item.state]) for item in tracked))
            for signal in self.block.derived:  # of the caller, and perhaps with fewer batch axes
                held = table[signal.name]
                shape = np.broadcast_shapes(batch + (1,) * len(signal.shape), held.shape)
                table[signal.name] = np.broadcast_to(held, shape).copy()
            self._run("refresh", table)

    def _pick(self, table: Values) -> tuple[Values, Values]:
        states = {signal.name: table[signal.name] for signal in self.block.states}
        return states, {signal.name: table[signal.name] for signal in self.block.outputs}

    def _shape(self, name: str) -> tuple[int, ...]:
        signal = self.block.signal(name)
        return signal.shape if signal is not None else ()

    def _batch(self, values: Mapping[str, Array]) -> tuple[int, ...]:
        for name, value in values.items():
            array = np.asarray(value)
            return array.shape[: array.ndim - len(self._shape(name))]
        return ()

    def _run(self, section: str, table: Values) -> None:
        for statement in self.block.statements(section):
            if isinstance(statement, Assign):
                lookup = _Elements(table)
                value = evaluate(statement.expression, lookup, _ARITHMETIC)
                if statement.condition is not None:
                    holds = evaluate(statement.condition, lookup, _ARITHMETIC)
                    value = np.where(holds, value, lookup[statement.target])
                _store(table, statement.target, value)
            else:
                self._call(statement, table)

    def _call(self, call: Call, table: Values) -> None:
        lookup = _Elements(table)
        arguments = [lookup[name] for name in call.inputs]
        results = KERNELS[call.kernel](*arguments, *call.numbers)
        if len(call.outputs) == 1:
            results = (results,)
        for name, result in zip(call.outputs, results, strict=True):
            _store(table, name, result)


class _Elements(Mapping[str, Array]):
    """Looks up ``name`` and ``name[i,j]`` in a table of arrays with batch axes."""

    def __init__(self, table: Values) -> None:
        self._table = table

    def __getitem__(self, key: str) -> Array:
        name, indices = parse_element(key)
        return np.asarray(self._table[name][_index(indices)] if indices else self._table[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)


def _index(indices: tuple[int, ...]) -> Any:
    return (..., *indices)


def _store(table: Values, target: str, value: Array) -> None:
    name, indices = parse_element(target)
    if indices:
        table[name][_index(indices)] = value
    else:
        table[name] = np.asarray(value, dtype=float)

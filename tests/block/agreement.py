"""Random states and inputs of a block, and the block's result from each of the three evaluators."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from ptgen.block.block import Block, Signal
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.simulate.library import CompiledBlock

Values = dict[str, np.ndarray]


@dataclass(frozen=True)
class Batch:
    """States and inputs, each with the batch as first axis."""

    states: Values
    inputs: Values

    @property
    def size(self) -> int:
        return len(next(iter(self.states.values())))


def _magnitude(signal: Signal, name: str) -> float:
    """Return the size of a signal in operation, from its unit."""
    entry = name or signal.description
    if "rad/s" in signal.unit or "(rad/s)" in entry:
        return 100.0
    if signal.unit == "rad" or "(rad)" in entry:
        return 0.02
    return 800.0


def random_batch(block: Block, size: int, seed: int) -> Batch:
    rng = np.random.default_rng(seed)
    states: Values = {}
    for signal in block.states:
        entries = signal.entries or ("",) * signal.size
        scale = np.array([_magnitude(signal, entry) for entry in entries])
        value = rng.normal(size=(size, signal.size)) * scale
        states[signal.name] = value.reshape((size, *signal.shape))
    if "fault" in states:
        states |= _supervision(block, size, rng)
        states |= {s.name: rng.uniform(0, 1, size) for s in block.states if s.name.endswith("_source_now")}
    inputs = {s.name: rng.normal(size=size) * _magnitude(s, "") for s in block.inputs}
    inputs |= {s.name: rng.uniform(s.least, s.most, size) for s in block.inputs if s.most is not None}
    if "fault" in states:  # some inputs are implausible
        for signal in block.inputs:
            inputs[signal.name] = np.where(rng.random(size) < 0.01, 1e7, inputs[signal.name])
    # velocities near standstill, so that friction elements stick in part of the cases
    if "x" in states:
        states["x"][: size // 2] *= 10.0 ** rng.uniform(-6, 0, size=(size // 2, 1))
    return Batch(states, inputs)


def _supervision(block: Block, size: int, rng: np.random.Generator) -> Values:
    """Return states of supervision: mostly sound, sometimes latched, some about to be."""
    latched = rng.random(size) < 0.3
    statuses = np.array([fault.status for fault in block.faults], dtype=float)
    values = {
        "fault": np.where(latched, rng.choice(statuses, size), 0.0),
        "authority": np.where(rng.random(size) < 0.5, rng.integers(0, 2, size), rng.random(size)),
    }
    for signal in block.states:
        if not signal.monitor or signal.name in values:
            continue
        if signal.unit == "s":
            values[signal.name] = np.where(rng.random(size) < 0.7, 0.0, rng.uniform(0.0, 0.02, size))
        elif signal.name.endswith("_side"):
            values[signal.name] = rng.integers(-1, 2, size).astype(float)
        elif signal.name.endswith("_swings"):
            values[signal.name] = np.where(rng.random(size) < 0.8, 0.0, rng.uniform(0.0, 7.0, size))
        elif signal.name.endswith("_integrated"):
            values[signal.name] = rng.normal(size=size) * 100.0
        elif not signal.unit:  # flags
            values[signal.name] = rng.integers(0, 2, size).astype(float)
    return values


def random_parameters(block: Block, seed: int) -> Values:
    rng = np.random.default_rng(seed)
    values = {}
    for signal in block.parameters:
        factor = 1.0 if signal.name == "sample_time" else rng.uniform(0.9, 1.1)
        value = signal.value * factor
        values[signal.name] = np.array(value if signal.most is None else min(value, signal.most))
    return values


def by_numpy(block: Block, parameters: Values, batch: Batch) -> Values:
    evaluator = NumpyBlock(block)
    derived = evaluator.prepare(parameters)
    states, outputs = evaluator.step(parameters, derived, batch.states, batch.inputs)
    return {**states, **outputs}


def stack(signals: tuple[Signal, ...], values: Mapping[str, np.ndarray], size: int) -> np.ndarray:
    """Stack signals as columns of a matrix (entries, batch)."""
    parts = [np.broadcast_to(values[s.name], (size, *s.shape)).reshape(size, s.size) for s in signals]
    return np.hstack(parts).T if parts else np.zeros((0, size))


def by_casadi(block: Block, parameters: Values, batch: Batch) -> Values:
    functions = CasadiBlock(block)
    size = batch.size
    given = np.concatenate([np.ravel(parameters[s.name]) for s in block.parameters])
    derived = functions.prepare(given)
    states, outputs = functions.step(
        ca.repmat(ca.DM(given), 1, size),
        ca.repmat(derived, 1, size),
        stack(block.states, batch.states, size),
        stack(block.inputs, batch.inputs, size),
    )
    return {**_unstack(block.states, states), **_unstack(block.outputs, outputs)}


def _unstack(signals: tuple[Signal, ...], table: ca.DM) -> Values:
    full, result, start = np.array(table.full()), {}, 0
    for signal in signals:
        result[signal.name] = full[start : start + signal.size].T.reshape((-1, *signal.shape))
        start += signal.size
    return result


def by_c(compiled: CompiledBlock, parameters: Values, batch: Batch) -> Values:
    params = compiled.parameters({name: float(value) for name, value in parameters.items()})
    status, state = compiled.init(params)
    assert status == 0, compiled.status_text(status)
    block = compiled.block
    rows: dict[str, list[np.ndarray]] = {s.name: [] for s in (*block.states, *block.outputs)}
    for k in range(batch.size):
        for signal in block.states:
            compiled.write(state, signal.name, batch.states[signal.name][k])
        _, outputs = compiled.step(state, params, {name: value[k] for name, value in batch.inputs.items()})
        for signal in block.states:
            rows[signal.name].append(compiled.read(state, signal.name))
        for name, value in outputs.items():
            rows[name].append(np.array(value))
    return {name: np.array(values) for name, values in rows.items()}


def largest_difference(block: Block, first: Values, second: Values) -> tuple[float, str]:
    """Return the largest difference relative to the size of its signal in the batch, and the signal.

    Torques count as 10 N m at least: one that balances to zero is the rounding of much larger ones.
    """
    worst, where = 0.0, ""
    for name, value in first.items():
        signal = block.signal(name)
        least = 10.0 if signal is not None and signal.unit == "N m" else 1e-300
        size = max(float(np.abs(value).max()), least)
        difference = float(np.abs(value - second[name].reshape(value.shape)).max()) / size
        if difference > worst:
            worst, where = difference, name
    return worst, where

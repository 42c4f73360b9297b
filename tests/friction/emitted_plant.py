"""The emitted plant of a model alone, compiled, run through a friction problem beside the event-driven reference."""

from __future__ import annotations

import ctypes
import functools
import itertools
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import sympy as sp
from friction.reference_problems import PROBLEMS, Problem

from ptgen.emit.block_files import block_files, common_context
from ptgen.friction.events import EventDriven, EventState
from ptgen.mechanism.model import Model
from ptgen.plant.plant import plant_block
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock

__all__ = ["STEP", "compiled_plant", "emitted_run", "errors", "problem_named", "reference_run", "steps"]

STEP = 1e-4

INSTANTS = 40
"""Instants at which two runs are compared."""


_MADE = {make.__name__: make for make in PROBLEMS}


@functools.cache
def problem_named(name: str) -> Problem:
    """Return a problem of `PROBLEMS` by the name of its function."""
    return _MADE[name]()


def ideal(model: Model) -> Model:
    """Return the model with ideal drives: what is commanded is the air-gap torque."""
    inputs = tuple(
        replace(torque, drive=replace(torque.drive, time_constant=None, dead_time=None)) for torque in model.inputs
    )
    return replace(model, inputs=inputs)


@functools.cache
def compiled_plant(name: str) -> CompiledBlock:
    """Return the compiled plant of a problem."""
    block = plant_block(ideal(problem_named(name).model), STEP)
    folder = Path(tempfile.mkdtemp(prefix="ptgen-plant-"))
    for file, text in block_files([block], common_context(name, "problem", "0" * 16, "double")).items():
        (folder / file).write_text(text)
    library = folder / f"lib{name}.so"
    compile_library(sorted(folder.glob("*.c")), library)
    return CompiledBlock(block, name, ctypes.CDLL(str(library)), "double")


def steps(name: str) -> int:
    """Return into how many steps of about `STEP` a run is divided: a prime, so that no event falls on their grid."""
    count = round(problem_named(name).duration / STEP)
    return int(sp.nextprime(count))


def instants(name: str) -> np.ndarray:
    """Return the numbers of the steps after which runs are compared."""
    return np.unique(np.round(np.linspace(0, steps(name), INSTANTS + 1)[1:]).astype(int))


def mean(
    function: Callable[[float], np.ndarray | float], begin: float, end: float, kinks: Sequence[float]
) -> np.ndarray:
    """Return what a step sees of an input: its value in the middle, or the mean if it has a kink or jump inside."""
    inside = [time for time in kinks if begin < time < end]
    edges = [begin, *inside, end]
    parts = [
        (right - left) * np.asarray(function((left + right) / 2), dtype=float)
        for left, right in itertools.pairwise(edges)
    ]
    return np.asarray(sum(parts) / (end - begin))


def emitted_run(name: str, divisor: int = 1) -> tuple[np.ndarray, list[tuple[float, str, int, int]]]:
    """Run the compiled plant with steps of `STEP` / `divisor`, nearly.

    Returns
    -------
    velocities : ndarray (instants, n_z)
    transitions : list of (time at the end of the step, element, mode before, mode after)
    """
    problem, plant = problem_named(name), compiled_plant(name)
    count = steps(name) * divisor
    h = problem.duration / count
    params = plant.parameters({"sample_time": h})
    status, state = plant.init(params)
    assert status == 0, plant.status_text(status)
    x = plant.read(state, "x")
    x[: len(problem.initial)] = problem.initial
    plant.write(state, "x", x)
    frictions = problem.model.frictions
    speeds = [f"{friction.name.replace('.', '_')}_speed" for friction in frictions]
    outputs = plant.measure(state, params)
    mode = [int(np.sign(outputs[key])) for key in speeds]
    transitions, recorded = [], []
    wanted = set((instants(name) * divisor).tolist())
    names = [signal.name for signal in plant.block.inputs]
    acting = [problem.actuations[f.name] for f in frictions if f.actuated]
    for k in range(count):
        span = (k * h, (k + 1) * h, problem.breakpoints)
        values = [*mean(problem.torques, *span), *(mean(mu, *span) for mu in acting)]
        status, outputs = plant.step(state, params, dict(zip(names, values, strict=True)))
        assert status == 0, plant.status_text(status)
        for i, key in enumerate(speeds):
            now = int(np.sign(outputs[key]))
            if now != mode[i]:
                transitions.append(((k + 1) * h, frictions[i].name, mode[i], now))
                mode[i] = now
        if k + 1 in wanted:
            recorded.append(plant.read(state, "x")[: len(problem.initial)])
    return np.array(recorded), transitions


@functools.cache
def reference_run(name: str) -> tuple[np.ndarray, EventState]:
    """Return velocities at the same instants by the event-driven reference, and its last state."""
    problem = problem_named(name)
    reference = EventDriven(problem.model)
    state = reference.initial(problem.initial)
    recorded = []
    for time in instants(name) * problem.duration / steps(name):
        state = reference.advance(state, float(time), problem.torques, problem.actuations, problem.breakpoints)
        recorded.append(state.x[: len(problem.initial)])
    return np.array(recorded), state


def errors(name: str, divisors: Sequence[int] = (1, 2, 4, 8)) -> np.ndarray:
    """Return the largest errors of the velocities (rad/s) with steps of `STEP` / divisor."""
    wanted = reference_run(name)[0]
    return np.array([np.abs(emitted_run(name, divisor)[0] - wanted).max() for divisor in divisors])

"""Random problems of both governors, as arrays and as a block that solves one per step."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
import sympy as sp

from ptgen.block.block import Assign, Block, Call, Signal, Table, element
from ptgen.emit.block_files import block_files, common_context
from ptgen.emit.c_expressions import Precision
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock

Array = np.ndarray

__all__ = ["Problems", "Sizes", "compiled", "governed_block", "random_problems", "tables", "write_sources"]


@dataclass(frozen=True)
class Sizes:
    """Machines, states of the prediction, rows of each machine, groups, order of the sequential governor."""

    m: int = 3
    n: int = 9
    counts: tuple[int, ...] = (80, 80, 80)
    group: tuple[float, ...] = (0.0, 1.0, 1.0)
    order: tuple[int, ...] = (1, 1, 2, 2, 0, 0)
    iterations: int = 40
    seed: int = 0

    @property
    def rows(self) -> int:
        return max(sum(self.counts), 1)


@dataclass(frozen=True)
class Problems:
    """Arrays with the batch as first axis, named as the arguments of the governors."""

    wanted: Array
    before: Array
    free: Array
    gain: Array
    least: Array
    most: Array
    reserve: Array
    rate_step: Array
    tie: Array
    modified: Array
    deviation: Array
    weight: Array

    def __len__(self) -> int:
        return len(self.wanted)

    def __getitem__(self, index: object) -> Problems:
        return Problems(**{f.name: getattr(self, f.name)[index] for f in fields(self)})


@cache
def tables(sizes: Sizes) -> tuple[Array, Array]:
    """Return rows_x and rows_r: decaying sums of modes, so that neighbouring rows are nearly parallel as in a bed."""
    rng = np.random.default_rng(sizes.seed + 1000)
    m, n = sizes.m, sizes.n
    rows_x, rows_r = np.zeros((sizes.rows, n)), np.zeros((sizes.rows, m))
    start = 0
    for machine, count in enumerate(sizes.counts):
        mix, steady = rng.normal(size=n) * 3.0, rng.normal(size=(n, m)) * 0.5
        damping, speed, phase = rng.uniform(1, 6, n), rng.uniform(0, 25, n), rng.uniform(0, 6, n)
        for k in range(count):
            time = (k + 1) / max(count, 1)
            decay = mix * (np.exp(-damping * time) * np.cos(speed * time + phase) - np.cos(phase))
            rows_x[start + k] = decay
            rows_r[start + k] = -decay @ steady * (1.0 + 0.5 * machine)
        start += count
    return rows_x, rows_r


def random_problems(sizes: Sizes, size: int, seed: int) -> Problems:
    """Return problems of operation in torque (N m) and speed (rad/s): some free, some limited, some infeasible."""
    rng = np.random.default_rng(seed)
    m = sizes.m
    gain = np.zeros((size, m, m))
    gain[:, range(m), range(m)] = rng.uniform(5.0, 60.0, (size, m)) * np.where(rng.random((size, m)) < 0.9, 1, -1)
    gain[:, 0, 1:] = rng.normal(size=(size, m - 1)) * 20.0
    gain[:, 0, 0] = rng.uniform(0.5, 2.0, size)
    before, change = (
        rng.normal(size=(size, m)) * 50.0,
        rng.normal(size=(size, m)) * 10.0 ** rng.uniform(0, 2.3, (size, 1)),
    )
    change[rng.random((size, m)) < 0.05] = 0.0
    together = rng.random(size) < 0.2  # tied speeds, with equal or opposite differences below the tie
    if m > 2:
        before[together, 2] = before[together, 1] + rng.normal(size=together.sum()) * 0.03
        change[together, 2] = change[together, 1] + rng.normal(size=together.sum()) * 0.03
    before[:, 0] *= 5.0
    change[:, 0] *= 20.0
    most = rng.uniform(300.0, 1500.0, (size, m))
    least = -most * rng.choice([1.0, 1.0, 0.3], (size, m))
    free = rng.normal(size=(size, m)) * 200.0 * rng.choice([0.2, 0.6, 1.5], (size, 1))
    return Problems(
        wanted=before + change,
        before=before,
        free=free,
        gain=gain,
        least=least,
        most=most,
        reserve=rng.choice([0.0, 20.0, 300.0], (size, m)),
        rate_step=rng.choice([0.0, 5.0], (size, m)),
        tie=np.full(size, 0.1),
        modified=(rng.random(size) < 0.5).astype(float),
        deviation=rng.normal(size=(size, sizes.n)) * 10.0 ** rng.uniform(-1, 1.3, (size, 1)),
        weight=rng.uniform(0.5, 100.0, (size, m)),
    )


def governed_block(sizes: Sizes) -> Block:
    """Return a block that takes a problem from its states and puts both solutions into further states."""
    m, n = sizes.m, sizes.n
    rows_x, rows_r = tables(sizes)
    vectors = dict.fromkeys(("wanted", "before", "free", "least", "most", "reserve", "rate_step", "weight"), m)
    vectors |= {"deviation": n, "gains": m * m, "sequential": m, "shaped": m, "slack": m}
    scalars = ("tie", "modified", "chosen", "iterations", "status")
    states = [Signal(name, "", name, (length,)) for name, length in vectors.items()]
    states += [Signal(name, "", name) for name in scalars]
    rows = range(m)
    step = [Assign(f"gain[{i},{j}]", element("gains", i * m + j)) for i in rows for j in rows]
    shared = ("wanted", "before", "free", "gain", "least", "most")
    sequential = ("reserve", "rate_step", "tie", "modified", "group")
    optimal = ("deviation", "rows_x", "rows_r", "weight", "tie", "group", "sequential")
    return Block(
        name="shaper",
        description="both governors",
        parameters=(Signal("scale", "", "not used", value=1.0),),
        inputs=(Signal("time", "s", "not used"),),
        outputs=(Signal("first", "", "a shaped reference"),),
        states=tuple(states),
        arrays=(Signal("gain", "", "gain", (m, m)),),
        step=(
            *step,
            Call("sequential_governor", ("sequential",), (*shared, *sequential), numbers=sizes.order),
            Call(
                "optimal_governor",
                ("shaped", "slack", "iterations", "status"),
                ("chosen", *shared, *optimal),
                numbers=(*sizes.counts, sizes.iterations),
            ),
            Assign("first", element("shaped", 0) * sp.Symbol("scale", real=True) + element("group", 0)),
        ),
        tables=(
            Table("rows_x", "", "rows of the state", rows_x),
            Table("rows_r", "", "rows of the references", rows_r),
            Table("group", "", "which references may be tied", sizes.group),
        ),
    )


def write_sources(sizes: Sizes, folder: Path, precision: Precision = "double") -> list[Path]:
    """Write the C of the block into `folder`; return its sources."""
    context = common_context("bed", "", "", precision)
    paths = []
    for name, text in block_files([governed_block(sizes)], context).items():
        (folder / name).write_text(text)
        paths.append(folder / name)
    return [path for path in paths if path.suffix == ".c"]


@cache
def compiled(sizes: Sizes, precision: Precision = "double") -> CompiledBlock:
    """Return the compiled block; made once."""
    folder = Path(mkdtemp(prefix="governor"))
    compile_library(write_sources(sizes, folder, precision), folder / "bed.so")
    return CompiledBlock(governed_block(sizes), "bed", ctypes.CDLL(str(folder / "bed.so")), precision)

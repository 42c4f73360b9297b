"""Constant arrays of a block: what is refused, and that all evaluators read the same numbers."""

from __future__ import annotations

import ctypes
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from ptgen.block.block import Assign, Block, Call, Signal, Table, element
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.emit.block_files import block_files, common_context
from ptgen.emit.c_expressions import Precision
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock

RNG = np.random.default_rng(4)
MATRIX = RNG.normal(size=(7, 3)) * 10.0 ** RNG.uniform(-30, 30, (7, 3))
VECTOR = np.array([0.1, -1e-300, 3.0])


def reading_block(tables: tuple[Table, ...] | None = None) -> Block:
    """Return a block with a product and elements of tables in each section."""
    return Block(
        name="reader",
        description="reads tables",
        parameters=(Signal("one", "", "a number", value=1.0),),
        inputs=(Signal("x", "", "a number"),),
        outputs=(Signal("sum", "", "sum"), Signal("shown", "", "shown")),
        states=(Signal("product", "", "product", (7,)),),
        derived=(Signal("prepared", "", "prepared", (7,)), Signal("entry", "", "entry")),
        prepare=(Call("multiply", ("prepared",), ("matrix", "vector")), Assign("entry", element("matrix", 6, 2))),
        step=(
            Call("multiply", ("product",), ("matrix", "vector")),
            Assign("sum", element("matrix", 4, 1) * element("vector", 0) + element("prepared", 3) + element("x") * 0),
        )
        if tables is None
        else (),
        measure=(Assign("shown", element("matrix", 0, 0) + element("one") * element("entry") * 0),),
        tables=tables or (Table("matrix", "N m", "a matrix", MATRIX), Table("vector", "", "a vector", VECTOR)),
    )


def compiled(folder: Path, precision: Precision) -> CompiledBlock:
    for name, text in block_files([reading_block()], common_context("bed", "", "", precision)).items():
        (folder / name).write_text(text)
    compile_library(sorted(folder.glob("*.c")), folder / "bed.so")
    return CompiledBlock(reading_block(), "bed", ctypes.CDLL(str(folder / "bed.so")), precision)


@pytest.mark.compile
def test_evaluators_read_the_same_numbers(tmp_path: Path) -> None:
    block = reading_block()
    evaluator, c = NumpyBlock(block), compiled(tmp_path, "double")
    derived = evaluator.prepare(evaluator.defaults())
    states, outputs = evaluator.step(evaluator.defaults(), derived, evaluator.initial(), {"x": np.zeros(())})
    assert outputs["sum"] == MATRIX[4, 1] * VECTOR[0] + derived["prepared"][3]
    params = c.defaults()
    status, state = c.init(params)
    assert status == 0
    _, got = c.step(state, params, {"x": 0.0})
    assert got["shown"] == outputs["shown"] == MATRIX[0, 0]
    assert c.read(state, "entry") == derived["entry"] == MATRIX[6, 2]
    for name, expected in (("product", states["product"]), ("prepared", derived["prepared"])):
        assert c.read(state, name) == pytest.approx(expected, rel=1e-12)
    functions = CasadiBlock(block)
    given = functions.prepare([1.0])
    after, shown = functions.step([1.0], given, ca.DM.zeros(7), [0.0])
    assert np.array(after).ravel() == pytest.approx(states["product"], rel=1e-12)
    assert float(shown[0]) == pytest.approx(float(outputs["sum"]), rel=1e-12)
    assert float(functions.measure([1.0], given, ca.DM.zeros(7))[1]) == MATRIX[0, 0]


@pytest.mark.compile
def test_single_precision_is_the_nearest(tmp_path: Path) -> None:
    c = compiled(tmp_path, "float")
    status, state = c.init(c.defaults())
    assert status == 0
    assert c.read(state, "entry") == np.float32(MATRIX[6, 2])


@pytest.mark.parametrize("values", [[], [[]], [np.inf], [np.nan, 1.0], 3.0, [[[1.0]]]])
def test_tables_are_finite_vectors_or_matrices(values: object) -> None:
    with pytest.raises(ValueError, match="table t"):
        Table("t", "", "a table", values)  # type: ignore[arg-type]


def test_a_table_is_hashable_and_equal_by_content() -> None:
    first, second = (Table("t", "", "a table", values) for values in (np.eye(2), ((1, 0), (0, 1))))
    assert first == second and hash(first) == hash(second)
    assert first.shape == (2, 2)


@pytest.mark.parametrize("name", ["x", "vector"])
def test_names_are_unique(name: str) -> None:
    tables = (Table("matrix", "", "", MATRIX), Table("vector", "", "", VECTOR), Table(name, "", "", VECTOR))
    with pytest.raises(ValueError, match="declared twice"):
        reading_block(tables)


def test_idle_tables_are_refused() -> None:
    tables = (Table("matrix", "", "", MATRIX), Table("vector", "", "", VECTOR), Table("idle", "", "", VECTOR))
    with pytest.raises(ValueError, match=r"\['idle'\] are not used"):
        reading_block(tables)


def test_tables_are_constant() -> None:
    with pytest.raises(ValueError, match="constant"):
        Block("b", "", (), (), (), (), step=(Assign("t[0]", element("t", 1)),), tables=(Table("t", "", "", VECTOR),))

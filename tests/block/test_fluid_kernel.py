"""Torques of a fluid: the three evaluators agree, and what is not finite gives no torque."""

from __future__ import annotations

import ctypes
from pathlib import Path

import agreement
import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from plant.converter_bed import converter, converter_bed

from ptgen.block.block import Block, Call, Signal
from ptgen.block.casadi_evaluator import CASADI_KERNELS
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.components.catalogue import CATALOGUE
from ptgen.emit.block_files import block_files, common_context
from ptgen.friction.event_fluid import EventFluid
from ptgen.friction.fluid import fluid_torques
from ptgen.plant.fluids import fluid_tables
from ptgen.simulate.build import build
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock

(FLUID,) = converter().elements("tc").fluids
KNOTS, CURVES = fluid_tables(FLUID)
SPEEDS = st.floats(-3, 3) | st.sampled_from([0.0, 1.0, -1.0, 5e-324, 1e-160, 1e150])


@given(SPEEDS, SPEEDS)
def test_numpy_and_casadi_agree_with_the_reference(pump: float, turbine: float) -> None:
    expected = EventFluid(FLUID, 1.0).torques(pump, turbine)
    size = 1e-12 * max(abs(pump), abs(turbine)) ** 2 * 400
    tables = KNOTS.array(), CURVES.array()
    assert np.array(fluid_torques(np.array(pump), np.array(turbine), *tables)) == pytest.approx(expected, abs=size)
    found = CASADI_KERNELS["fluid_torques"](ca.DM(pump), ca.DM(turbine), *map(ca.DM, tables))
    assert [float(torque) for torque in found] == pytest.approx(expected, abs=size)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e200])
@pytest.mark.parametrize("other", [0.0, 1.0, np.nan])
def test_what_is_not_finite_gives_no_torque(bad: float, other: float) -> None:
    for pair in ((bad, other), (other, bad)):
        assert [float(t) for t in fluid_torques(*map(np.array, pair), KNOTS.array(), CURVES.array())] == [0.0, 0.0]


def kernel_block() -> Block:
    return Block(
        name="coupling",
        description="torques of a fluid",
        parameters=(Signal("one", "", "a number", value=1.0),),
        inputs=(),
        outputs=(),
        states=(
            Signal("pump", "", "speed"),
            Signal("turbine", "", "speed"),
            Signal("torque", "N m", "torques", (2,)),
        ),
        step=(Call("fluid_torques", ("torque[0]", "torque[1]"), ("pump", "turbine", KNOTS.name, CURVES.name)),),
        tables=(KNOTS, CURVES),
    )


@pytest.mark.compile
def test_c_agrees_everywhere_and_is_zero_for_what_is_not_finite(tmp_path: Path) -> None:
    block = kernel_block()
    for name, text in block_files([block], common_context("bed", "", "", "double")).items():
        (tmp_path / name).write_text(text)
    compile_library(sorted(tmp_path.glob("*.c")), tmp_path / "bed.so")
    compiled = CompiledBlock(block, "bed", ctypes.CDLL(str(tmp_path / "bed.so")), "double")
    params = compiled.parameters({"one": 1.0})
    _, state = compiled.init(params)
    grid = [0.0, -0.0, 5e-324, 1e-170, 0.3, -0.7, 1.0, -1.0, 2.4, 1e150, 1e200, np.inf, -np.inf, np.nan]
    for pump in grid:
        for turbine in grid:
            compiled.write(state, "pump", pump)
            compiled.write(state, "turbine", turbine)
            compiled.step(state, params, {})
            expected = fluid_torques(np.array(pump), np.array(turbine), KNOTS.array(), CURVES.array())
            assert compiled.read(state, "torque")[:2].tolist() == pytest.approx([float(t) for t in expected], rel=1e-12)


@pytest.mark.compile
@pytest.mark.parametrize("seed", [None, 4])
def test_all_evaluators_agree_on_a_plant_with_a_converter(seed: int | None, tmp_path: Path) -> None:
    project = converter_bed(tmp_path)
    block = project.plant
    batch = agreement.random_batch(block, 2000, seed or 1)
    parameters = NumpyBlock(block).defaults() if seed is None else agreement.random_parameters(block, seed)
    expected = agreement.by_numpy(block, parameters, batch)
    compiled = build(project).plant
    for other in (agreement.by_casadi(block, parameters, batch), agreement.by_c(compiled, parameters, batch)):
        difference, where = agreement.largest_difference(block, expected, other)
        assert difference < 1e-12, where


def test_a_map_with_two_points_has_tables_too() -> None:
    maps = {"speed_ratio": [0, 1], "torque_ratio": [1, 1], "pump_torque": ["90 N m", "0 N m"]}
    plain = {"inertia_pump": "1 kg m^2", "inertia_turbine": "1 kg m^2", "reference_speed": "100 rad/s", "drive": maps}
    component = CATALOGUE["torque_converter"].model_validate({"type": "torque_converter", **plain})
    knots, curves = fluid_tables(component.elements("c").fluids[0])
    assert knots.shape == (2, 4) and curves.shape == (11, 8)

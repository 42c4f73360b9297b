"""Bad signals never reach a torque output."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import CompiledBlock

pytestmark = pytest.mark.compile


@pytest.fixture(scope="module")
def controller(projects: dict[str, Project]) -> CompiledBlock:
    return build(projects["differential"]).controller


def sound_inputs(controller: CompiledBlock) -> dict[str, float]:
    return {s.name: 20.0 if "speed" in s.name else 100.0 for s in controller.block.inputs}


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, 1e12])
def test_fault_is_latched_named_and_ramped_to_zero(bad: float, controller: CompiledBlock) -> None:
    params = controller.defaults()
    for number, signal in enumerate(controller.block.inputs, start=1):
        status, state = controller.init(params)
        assert status == 0
        for _ in range(10):
            status, healthy = controller.step(state, params, sound_inputs(controller))
            assert status == 0
        status, outputs = controller.step(state, params, {**sound_inputs(controller), signal.name: bad})
        assert status == number
        assert signal.name in controller.status_text(status)
        previous = healthy
        steps = round(params.fault_ramp / params.sample_time)
        for _ in range(steps + 2):
            for name, value in outputs.items():
                assert math.isfinite(value)
                assert abs(value) <= abs(previous[name]) + 1e-12
            previous = outputs
            # sound again: the fault stays until the controller is initialised
            status, outputs = controller.step(state, params, sound_inputs(controller))
            assert status == number
        assert all(value == 0.0 for value in outputs.values())


@given(st.data())
def test_outputs_are_finite_and_within_the_envelope_whatever_comes_in(controller: CompiledBlock, data) -> None:
    params = controller.defaults()
    _, state = controller.init(params)
    limits = {f"{m}_torque_ref": getattr(params, f"{m}_torque_max") for m in ("M1", "M2", "M3")}
    for _ in range(5):
        inputs = {s.name: data.draw(st.floats(allow_nan=True, allow_infinity=True)) for s in controller.block.inputs}
        _, outputs = controller.step(state, params, inputs)
        for name, value in outputs.items():
            assert math.isfinite(value) and abs(value) <= limits[name]


@given(st.data())
def test_parameters_out_of_range_are_refused_by_name(controller: CompiledBlock, data) -> None:
    signal = data.draw(st.sampled_from(controller.block.parameters))
    bad = data.draw(st.sampled_from([math.nan, math.inf, -math.inf]))
    params = controller.parameters({signal.name: bad})
    status, _ = controller.init(params)
    assert status != 0
    assert signal.name in controller.status_text(status)


def test_overflowing_or_unchecked_parameters_never_reach_a_machine(controller: CompiledBlock) -> None:
    inputs = {s.name: 400.0 if s.name.endswith("speed_ref") else 20.0 for s in controller.block.inputs}
    for name, value in {"M2_speed_gain": 1e308, "M1_damping": 1e308, "M1_model_stiffness": 1e308}.items():
        params = controller.parameters({name: value})
        status, state = controller.init(params)
        assert status == 0
        for _ in range(50):
            status, outputs = controller.step(state, params, inputs)
            assert all(math.isfinite(value) for value in outputs.values()), name
    for signal in controller.block.parameters:
        params = controller.defaults()
        _, state = controller.init(params)
        setattr(params, signal.name, math.nan)  # changed without an update
        for _ in range(3):
            _, outputs = controller.step(state, params, inputs)
            assert all(math.isfinite(value) for value in outputs.values()), signal.name


def test_after_a_refused_start_there_is_no_torque(controller: CompiledBlock) -> None:
    params = controller.parameters({"M1_inertia_estimate": math.nan})
    refused, state = controller.init(params)
    assert refused != 0
    status, outputs = controller.step(state, controller.defaults(), sound_inputs(controller))
    assert status == refused
    assert all(value == 0.0 for value in outputs.values())


def test_negative_inertia_and_zero_ratio_are_refused(projects: dict[str, Project]) -> None:
    plant = build(projects["differential"]).plant
    for name, value in {
        "M1_inertia": -1.0,
        "diff_ratio": 0.0,
        "cardan1_stiffness": 0.0,
        "M1_inverter_dead_time": 1.0,
    }.items():
        status, _ = plant.init(plant.parameters({name: value}))
        assert name in plant.status_text(status)


def test_plant_refuses_what_is_not_finite_and_keeps_its_state(projects: dict[str, Project]) -> None:
    plant = build(projects["differential"]).plant
    params = plant.defaults()
    _, state = plant.init(params)
    plant.step(state, params, {s.name: 50.0 for s in plant.block.inputs})
    before = plant.read(state, "x")
    outputs = plant.measure(state, params)
    for index, signal in enumerate(plant.block.inputs):
        for bad in (math.nan, math.inf, -math.inf):
            status, held = plant.step(state, params, {s.name: bad if s == signal else 1.0 for s in plant.block.inputs})
            assert status == 1100 + index
            assert plant.status_text(status) == f"the input {signal.name} is not finite"
            assert np.array_equal(plant.read(state, "x"), before)
            assert held == outputs and all(math.isfinite(value) for value in held.values())


def test_parameters_far_from_the_emitted_ones_are_refused(projects: dict[str, Project]) -> None:
    plant = build(projects["differential"]).plant
    status, _ = plant.init(plant.parameters({"flange1_stiffness": 380e9}))
    assert "emit it again" in plant.status_text(status) or "too fast for the step" in plant.status_text(status)

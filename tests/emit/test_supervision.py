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
    """Return inputs of a bed that stands still and in which nothing happens."""
    return {s.name: 0.0 for s in controller.block.inputs} | {"M2_speed_ref": 0.5, "diff_input_torque_ref": 50.0}


def supervised(controller: CompiledBlock) -> list[tuple[int, str]]:
    return [(k, s.name) for k, s in enumerate(controller.block.inputs, start=1) if s.name != "reset"]


def run(controller: CompiledBlock, state, params, inputs: dict[str, float], steps: int):
    """Do steps with the same inputs; return the last status, and the outputs of all."""
    results = [controller.step(state, params, inputs) for _ in range(steps)]
    return results[-1][0], [outputs for _, outputs in results]


def started(controller: CompiledBlock, params):
    status, state = controller.init(params)
    assert status == 0
    status, outputs = run(controller, state, params, sound_inputs(controller), 10)
    assert status == 0
    assert any(value != 0.0 for value in outputs[-1].values())
    return state, outputs[-1]


BAD = (math.nan, math.inf, -math.inf, 1e12)


@pytest.mark.parametrize("bad", BAD)
def test_fault_is_latched_named_and_ramped_to_zero(bad: float, controller: CompiledBlock) -> None:
    params = controller.parameters({"hold_time": 0.0})
    for number, name in supervised(controller):
        state, healthy = started(controller, params)
        status, outputs = controller.step(state, params, {**sound_inputs(controller), name: bad})
        assert status == number
        assert controller.status_text(status) == f"{name}: not finite or not plausible"
        previous = healthy
        steps = round(params.fault_ramp / params.sample_time)
        for _ in range(steps + 2):
            for output, value in outputs.items():
                assert math.isfinite(value)
                assert abs(value) <= abs(previous[output]) + 1e-12
            previous = outputs
            # sound again: the fault stays until it is reset
            status, outputs = controller.step(state, params, sound_inputs(controller))
            assert status == number
        assert all(value == 0.0 for value in outputs.values())


def test_short_dropouts_are_bridged_with_the_last_sound_value(controller: CompiledBlock) -> None:
    params = controller.defaults()
    held = round(params.hold_time / params.sample_time)
    assert held == 10
    for number, name in supervised(controller):
        dropped = {**sound_inputs(controller), name: math.nan}
        with_gap, undisturbed = (started(controller, params)[0] for _ in range(2))
        status, bridged = run(controller, with_gap, params, dropped, held)
        assert status == 0
        assert bridged == run(controller, undisturbed, params, sound_inputs(controller), held)[1]
        assert controller.step(with_gap, params, dropped)[0] == number


def test_dropouts_half_of_the_time_are_a_fault_in_the_end(controller: CompiledBlock) -> None:
    params = controller.defaults()
    sound, dropped = sound_inputs(controller), {**sound_inputs(controller), "M2_speed": math.nan}
    for pattern, caught in (([dropped] * 4 + [sound] * 5, False), ([dropped] * 5 + [sound] * 4, True)):
        state, _ = started(controller, params)
        statuses = [controller.step(state, params, inputs)[0] for _ in range(50) for inputs in pattern]
        assert (statuses[-1] != 0) == caught


def test_a_signal_that_was_never_sound_is_not_bridged(controller: CompiledBlock) -> None:
    params = controller.defaults()
    _, state = controller.init(params)
    status, outputs = controller.step(state, params, {**sound_inputs(controller), "M2_speed": math.nan})
    assert "M2_speed" in controller.status_text(status)
    assert all(value == 0.0 for value in outputs.values())


def faulted(controller: CompiledBlock, params):
    """Return a state with a latched fault and no torque left."""
    state, _ = started(controller, params)
    bad = {**sound_inputs(controller), "M2_speed": math.nan}
    status, outputs = run(controller, state, params, bad, round((params.hold_time + params.fault_ramp) / 1e-4) + 5)
    assert status != 0 and all(value == 0.0 for value in outputs[-1].values())
    return state, status


def test_reset_starts_anew_and_the_torques_return_along_the_ramp(controller: CompiledBlock) -> None:
    params = controller.parameters({"M2_speed_integral_gain": 0.0, "M1_torque_integral_gain": 0.0})
    state, _ = faulted(controller, params)
    sound = sound_inputs(controller)
    controller.step(state, params, sound)
    status, outputs = controller.step(state, params, {**sound, "reset": 1.0})
    assert status == 0
    _, fresh = controller.init(params)
    steps = round(params.fault_ramp / params.sample_time)
    for k in range(1, steps + 20):
        wanted = controller.step(fresh, params, sound)[1]
        for name, value in outputs.items():
            assert value == pytest.approx(min(1.0, k / steps) * wanted[name], abs=1e-9)
        status, outputs = controller.step(state, params, {**sound, "reset": 1.0})
        assert status == 0


def test_a_reset_acts_on_its_edge_only(controller: CompiledBlock) -> None:
    params = controller.defaults()
    sound = sound_inputs(controller)
    held_down = {**sound, "reset": 1.0}
    state, status = faulted(controller, params)
    assert controller.step(state, params, sound)[0] == status
    assert controller.step(state, params, held_down)[0] == 0
    # still held down when the next fault comes: nothing happens until it is released and pressed again
    run(controller, state, params, {**held_down, "M2_speed": math.nan}, 1000)
    assert run(controller, state, params, held_down, 1000)[0] == status
    assert controller.step(state, params, sound)[0] == status
    assert controller.step(state, params, held_down)[0] == 0


@pytest.mark.parametrize("reset", [math.nan, math.inf, -math.inf, -1.0, 0.4, 1e300])
def test_what_is_no_reset_counts_as_none(reset: float, controller: CompiledBlock) -> None:
    params = controller.defaults()
    state, status = faulted(controller, params)
    for value in (0.0, reset, 0.0, reset):
        assert controller.step(state, params, {**sound_inputs(controller), "reset": value})[0] == status


def test_no_reset_while_an_input_is_bad(controller: CompiledBlock) -> None:
    params = controller.defaults()
    for _, name in supervised(controller):
        state, status = faulted(controller, params)
        for value in (0.0, 1.0, 0.0, 1.0):
            bad = {**sound_inputs(controller), name: math.nan, "reset": value}
            assert controller.step(state, params, bad)[0] == status
        # the request is not kept until the signal returns
        assert run(controller, state, params, {**sound_inputs(controller), "reset": 1.0}, 10)[0] == status


def test_a_reset_on_the_way_down_waits_for_zero_torque(controller: CompiledBlock) -> None:
    params = controller.defaults()
    state, _ = started(controller, params)
    sound = sound_inputs(controller)
    run(controller, state, params, {**sound, "M2_speed": math.nan}, 20)
    sequence = [controller.step(state, params, {**sound, "reset": 1.0}) for _ in range(1000)]
    sizes = [abs(outputs["M2_torque_ref"]) for _, outputs in sequence]
    back = next(k for k, (status, _) in enumerate(sequence) if status == 0)
    assert 480 < back < 500
    assert np.all(np.diff(sizes[:back]) <= 0) and sizes[back - 1] == 0.0
    assert sizes[back + 1] > 0.0


def test_integrators_are_empty_after_a_reset(controller: CompiledBlock) -> None:
    params = controller.defaults()
    state, _ = started(controller, params)
    charging = {**sound_inputs(controller), "M2_speed_ref": 5.0, "M3_speed_ref": -5.0}
    run(controller, state, params, charging, 300)
    assert abs(float(controller.read(state, "M2_speed_integral"))) > 10.0
    run(controller, state, params, {**charging, "flange1_torque": math.inf}, 1000)
    calm = {s.name: 0.0 for s in controller.block.inputs}
    run(controller, state, params, calm, 2)
    status, outputs = run(controller, state, params, {**calm, "reset": 1.0}, 600)
    assert status == 0
    assert all(value == 0.0 for step in outputs for value in step.values())


def test_overspeed_is_named(controller: CompiledBlock) -> None:
    params = controller.defaults()
    for machine in ("M1", "M2", "M3"):
        limit = getattr(params, f"{machine}_overspeed")
        assert limit < getattr(params, f"{machine}_speed_plausible")
        for sign in (1.0, -1.0):
            for factor, text in ((0.999, "ok"), (1.001, f"{machine}_speed: overspeed")):
                _, state = controller.init(params)
                inputs = {**sound_inputs(controller), f"{machine}_speed": sign * factor * limit}
                statuses = [controller.step(state, params, inputs)[0] for _ in range(11)]
                assert controller.status_text(statuses[-1]) == text
                assert statuses[:10] == [0] * 10


def test_every_fault_has_its_number_and_its_text(project: Project) -> None:
    block, compiled = project.controller, build(project).controller
    numbers = [fault.status for fault in block.faults]
    assert len(set(numbers)) == len(numbers) and all(1 <= number < 9000 for number in numbers)
    for fault in block.faults:
        assert compiled.status_text(fault.status) == fault.text
    names = {s.name for s in (*block.inputs, *block.outputs)} - {"reset"}
    assert {fault.text.split(":")[0] for fault in block.faults} == names


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


def test_refused_parameters_cannot_be_reset_away(controller: CompiledBlock) -> None:
    params, bad = controller.defaults(), controller.parameters({"M1_damping": math.nan})
    sound = sound_inputs(controller)
    for start in (params, bad):
        status, state = controller.init(start)
        if status == 0:
            run(controller, state, params, sound, 10)
        refused = controller.update(state, bad)
        assert "M1_damping" in controller.status_text(refused)
        run(controller, state, params, sound, 1000)
        for value in (0.0, 1.0, 0.0):
            assert controller.step(state, params, {**sound, "reset": value})[0] == refused
        assert controller.update(state, params) == 0
        assert controller.step(state, params, sound)[0] == refused
        assert controller.step(state, params, {**sound, "reset": 1.0})[0] == 0


def test_torque_beyond_the_machine_in_the_file_is_refused_and_never_leaves(controller: CompiledBlock) -> None:
    rating = controller.defaults().M2_torque_max
    params = controller.parameters({"M2_torque_max": 2.0 * rating})
    assert "M2_torque_max" in controller.status_text(controller.init(params)[0])
    _, state = controller.init(controller.defaults())
    inputs = {**sound_inputs(controller), "M2_speed_ref": 100.0}
    for _ in range(100):  # not checked by an update
        _, outputs = controller.step(state, params, inputs)
        assert abs(outputs["M2_torque_ref"]) <= rating


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

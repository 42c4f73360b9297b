"""Shifts of a scenario with idle elements that change before and after, in the compiled plant."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from gear_set_rig import Rig, rig

from ptgen.gears import analyse_gears, layout_of_part
from ptgen.testbed import Shift, load_scenario

pytestmark = pytest.mark.compile

DUAL_CLUTCH, NINE_SPEED = "seven-speed-dual-clutch.toml", "nine-speed.toml"

STEP, DWELL = 2e-4, 0.9


@dataclass
class Run:
    """A run with a shift every `DWELL`, values at every step."""

    shifts: tuple[Shift, ...]
    time: np.ndarray
    input_speed: np.ndarray
    output_torque: np.ndarray
    slip: dict[str, np.ndarray]
    unsolved: int

    def during(self, shift: Shift, before: float = 0.0, after: float = 0.0) -> slice:
        begin, end = np.searchsorted(self.time, [shift.start - before, shift.end + after])
        return slice(int(begin), int(end))


def run(built: Rig, folder: Path, gears: list[str], torques: list[float], speed: list[float]) -> Run:
    """Shift through gears; each has a torque at the input (N m) and a speed of the output (rad/s)."""
    begin = [0.6 + DWELL * k for k in range(len(gears))]
    text = f'[scenario]\nduration = "60 s"\nrecord_every = "1 ms"\n[gears]\ngears = "{gears[0]}"\n'
    for time, gear in zip(begin, gears[1:], strict=False):
        text += f'[[shifts]]\ncomponent = "gears"\ntime = "{time} s"\nto = "{gear}"\n'
    (folder / "case.toml").write_text(text, encoding="utf-8")
    scenario = load_scenario(folder / "case.toml", built.testbed)
    time = (np.arange(round((begin[-1] + 0.4) / STEP)) + 0.5) * STEP
    corners = [0.0, 0.1, *(t for shift in begin[:-1] for t in (shift - 0.2, shift - 0.1))]
    course = {
        f"{name.replace('.', '_')}_actuation": np.interp(time, profile.time, profile.value)
        for name, profile in scenario.actuations.items()
    }
    input_torque = np.interp(time, corners, np.repeat([0.0, *torques], 2)[1:-1])
    output_speed = np.interp(time, corners, np.repeat([speed[0], *speed], 2)[1:-1])
    plant, model = built.plant, built.model
    params = plant.parameters({"sample_time": STEP})
    status, state = plant.init(params)
    assert status == 0, plant.status_text(status)
    stiffness = built.numeric.stiffness[1, 1]
    names = [friction.name.partition(".")[2] for friction in model.frictions]
    outputs, rows, unsolved = plant.measure(state, params), [], 0
    for k in range(len(time)):
        inputs = {name: values[k] for name, values in course.items()}
        inputs["M1_torque_ref"] = input_torque[k] - 0.02 * outputs["M1_speed"]
        inputs["M2_torque_ref"] = 800.0 * (output_speed[k] - outputs["M2_speed"])
        status, outputs = plant.step(state, params, inputs)
        unsolved += status != 0
        twist = plant.read(state, "x")[len(model.coordinates) + 1]
        rows.append([outputs["M1_speed"], stiffness * twist, *(outputs[f"gears_{name}_speed"] for name in names)])
    values = np.array(rows).T
    slip = dict(zip(names, values[2:], strict=True))
    return Run(scenario.shifts, time, values[0], values[1], slip, unsolved)


def check_engaged(done: Run, table: dict[str, tuple[str, ...]]) -> None:
    """The elements of each gear, and no others, are at rest between the shifts."""
    for shift in done.shifts:
        k = done.during(shift, after=0.1).stop
        held = {name for name, slip in done.slip.items() if slip[k] == 0.0}
        assert held == set(table[shift.to]), shift


def test_dual_clutch_shifts_up_in_drive_and_down_in_coast_without_interruption(tmp_path: Path) -> None:
    """The output torque keeps its sign over every shift, and neither end of the transmission is ever held."""
    built = rig("200 us", part=DUAL_CLUTCH)
    gears = [*"1234567", *"654321"]
    torques = [150.0] * 7 + [-150.0] * 6
    done = run(built, tmp_path, gears, torques, [20.0] * len(gears))
    assert done.unsolved == 0
    assert all(shift.kind == "overlapping" for shift in done.shifts)
    check_engaged(done, built.testbed.components["gears"].gear_elements())
    for shift, torque in zip(done.shifts, torques[1:], strict=True):
        during = done.during(shift)
        sense = np.sign(done.output_torque[during] * torque) * np.sign(done.output_torque[during.start] * torque)
        assert np.all(sense > 0), shift
        assert np.all(done.input_speed[during] > 30.0), shift


def test_dual_clutch_shifts_into_reverse_and_back_and_inside_a_branch(tmp_path: Path) -> None:
    built = rig("200 us", part=DUAL_CLUTCH)
    gears = ["1", "N", "R", "N", "1", "3", "7", "1"]
    torques = [100.0, 0.0, 50.0, 0.0, 50.0, 50.0, 50.0, -50.0]
    done = run(built, tmp_path, gears, torques, [10.0, 0.0, -5.0, 0.0, 10.0, 10.0, 10.0, 10.0])
    assert done.unsolved == 0
    assert [shift.kind for shift in done.shifts[4:]] == ["non-overlapping"] * 3
    check_engaged(done, built.testbed.components["gears"].gear_elements())
    for shift in done.shifts[4:]:  # with a torque that comes and goes: while the clutch is open there is none
        assert np.abs(done.output_torque[done.during(shift)]).min() < 5.0


@pytest.mark.parametrize("gears", [["4", "2", "4", "6", "4", "8", "4"], ["1", "6", "2", "7"]])
def test_nine_speed_skips_gears(gears: list[str], tmp_path: Path) -> None:
    """With idle elements where there are, otherwise with all elements that differ, without a tie-up."""
    built = rig("200 us", part=NINE_SPEED)
    part = built.testbed.components["gears"]
    found = analyse_gears(layout_of_part(part), part.gear_elements())
    done = run(built, tmp_path, gears, [100.0] * len(gears), [30.0] * len(gears))
    assert done.unsolved == 0
    check_engaged(done, part.gear_elements())
    for shift in done.shifts:
        change = found.change(shift.before, shift.to)
        assert shift.kind == ("overlapping" if change.is_single else "non-overlapping")
        assert np.all(done.input_speed[done.during(shift)] > 10.0), shift

"""The nine-speed gear set between two machines, its emitted plant compiled, and shifts with a balance of its energy."""

from __future__ import annotations

import ctypes
import functools
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ptgen.emit.block_files import block_files, common_context
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model, NumericModel
from ptgen.plant.plant import plant_block
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock
from ptgen.testbed import Testbed, load

__all__ = ["ELEMENTS", "GEARS", "ORDER", "Balance", "Rig", "rig", "shift_course", "shifted", "turn"]

ELEMENTS = "ABCDEF"

GEARS = {"R": "ABC", "1": "BCE", "2": "CDE", "3": "BCD", "4": "BCF", "5": "BDF", "6": "DEF", "7": "BEF", "8": "AEF"}
GEARS["9"] = "ABF"

ORDER = ["1", "2", "3", "4", "5", "6", "7", "8", "9", "8", "7", "6", "5", "4", "3", "2", "1", "R", "1"]

_BED = """
[testbed]
name = "rig"
sample_time = "{step}"
connections = ["M1 - shaft1 - gears.input", "gears.output - shaft2 - M2"]

[components.M1]
type = "machine"
inertia = "0.4 kg m^2"
torque_max = "9000 N m"
speed_rated = "8000 rpm"
speed_max = "8000 rpm"

[components.shaft1]
type = "shaft"
stiffness = "25 kN m/rad"
damping = "2 N m s/rad"

[components.gears]
type = "part"
file = "{part}"
{more}

[components.shaft2]
type = "shaft"
stiffness = "40 kN m/rad"
damping = "3 N m s/rad"

[components.M2]
type = "machine"
inertia = "4.5 kg m^2"
torque_max = "33000 N m"
speed_rated = "4500 rpm"
speed_max = "4500 rpm"

[control]
speed = ["M1", "M2"]
speed_bandwidth = "25 rad/s"
"""


@dataclass(frozen=True)
class Rig:
    """Model and compiled plant of the rig."""

    testbed: Testbed
    model: Model
    numeric: NumericModel
    plant: CompiledBlock


@functools.cache
def rig(step: str = "100 us", more: str = "", part: str = "nine-speed.toml") -> Rig:
    """Return the rig with a step, and with more keys of the part."""
    folder = Path(tempfile.mkdtemp(prefix="ptgen-gears-"))
    (folder / "rig.toml").write_text(_BED.format(step=step, more=more, part=part))
    testbed = load(folder / "rig.toml")
    model = assemble(Mechanism.of(testbed))
    block = plant_block(model, testbed.sample_time)
    for file, text in block_files([block], common_context("rig", "rig", "0" * 16, "double")).items():
        (folder / file).write_text(text)
    compile_library(sorted(folder.glob("*.c")), folder / "librig.so")
    plant = CompiledBlock(block, "rig", ctypes.CDLL(str(folder / "librig.so")), "double")
    return Rig(testbed, model, model.numeric(), plant)


def shift_course(gears: Sequence[str], dwell: float, ramp: float, times: np.ndarray) -> np.ndarray:
    """Return the actuations (times, 6) when the gears follow each other every `dwell`, with ramps that overlap.

    Half a `dwell` after a gear has begun its elements give way to those of the next one within `ramp` (all in s).
    """
    engaged = np.array([[float(name in GEARS[gear]) for name in ELEMENTS] for gear in gears])
    begin = (np.arange(1, len(gears)) - 0.5) * dwell
    corners = np.column_stack([begin, begin + ramp]).ravel()
    levels = np.repeat(engaged, 2, axis=0)[1:-1]
    return np.column_stack([np.interp(times, corners, level) for level in levels.T])


@dataclass
class Balance:
    """Work and heat since the start (J), each the integral of a power by the trapezoidal rule."""

    input: float = 0.0
    output: float = 0.0
    friction: float = 0.0
    damping: float = 0.0
    stored: float = 0.0
    turnover: float = 0.0

    @property
    def error(self) -> float:
        """What is missing, relative to all the work that was done."""
        return abs(self.input + self.output - self.friction - self.damping - self.stored) / self.turnover


def shifted(
    built: Rig,
    gears: Sequence[str],
    *,
    step: float,
    dwell: float,
    ramp: float,
    torque: float,
    speed: float,
    turning: bool = True,
) -> tuple[list[Balance], list[Mapping[str, float]], int]:
    """Shift through `gears` with a torque at the input (N m) while the other machine holds the output speed (rad/s).

    Returns
    -------
    balances : list of Balance
        One from just before each shift to just before the next one, shift and recovery included.
    ends : list of mapping
        What the plant puts out just before each shift, and once more after the last one.
    unsolved : int
        Steps whose status was not zero.
    """
    plant, numeric, model = built.plant, built.numeric, built.model
    params = plant.parameters({"sample_time": step})
    status, state = plant.init(params)
    assert status == 0, plant.status_text(status)
    n_z, n_e = len(model.coordinates), len(model.twists)
    if turning:
        turn(built, state, gears[0], speed)
    names = [friction.name.replace(".", "_") for friction in model.frictions]
    outputs = plant.measure(state, params)

    def picture(reading: Mapping[str, float]) -> tuple[np.ndarray, float, float]:
        x = plant.read(state, "x")
        z, e = x[:n_z], x[n_z : n_z + n_e]
        rates = numeric.twist_rows @ z
        energy = 0.5 * z @ numeric.mass @ z + 0.5 * e @ numeric.stiffness @ e
        speeds = np.array([reading[f"{name}_speed"] for name in ("M1", "M2", *names)])
        return speeds, float(rates @ numeric.damping @ rates), float(energy)

    balance, balances, ends, unsolved = Balance(), [], [], 0
    speeds, losses, start = picture(outputs)
    count, gear = round(len(gears) * dwell / step), 0
    course = shift_course(gears, dwell, ramp, (np.arange(count) + 0.5) * step)
    for k in range(count):
        load = 400.0 * (speed - outputs["M2_speed"])
        inputs = {"M1_torque_ref": torque, "M2_torque_ref": load}
        inputs |= {f"gears_{name}_actuation": level for name, level in zip(ELEMENTS, course[k], strict=True)}
        status, outputs = plant.step(state, params, inputs)
        unsolved += status != 0
        now, lost, energy = picture(outputs)
        mean = (speeds + now) / 2
        held = np.array([torque, load, *(outputs[f"{name}_torque"] for name in names)])  # over the step
        balance.input += step * torque * mean[0]
        balance.output += step * load * mean[1]
        balance.friction += step * float(held[2:] @ mean[2:])
        balance.damping += step * (losses + lost) / 2
        balance.turnover += step * float(abs(held[:2] * mean[:2]).sum())
        speeds, losses = now, lost
        if k + 1 >= (gear + 0.48) * dwell / step:  # just before the next shift
            ends.append(dict(outputs))
            balance.stored = energy - start
            balances.append(balance)
            balance, start, gear = Balance(), energy, gear + 1
    return balances, ends, unsolved


def turn(built: Rig, state: object, gear: str, speed: float) -> None:
    """Let everything turn without strain in a gear, with an output speed (rad/s)."""
    model, numeric, plant = built.model, built.numeric, built.plant
    held = [i for i, friction in enumerate(model.frictions) if friction.name[-1] in GEARS[gear]]
    rows = np.vstack([numeric.friction_rows[held], numeric.twist_rows])
    _, sizes, directions = np.linalg.svd(rows)
    (motion,) = directions[np.sum(sizes > 1e-9 * sizes[0]) :]
    z = motion * speed / motion[model.coordinates.index("M2.shaft")]
    x = plant.read(state, "x")
    x[: len(z)] = z
    for i in range(np.linalg.matrix_rank(numeric.friction_rows)):
        if i in held:
            x[i] = 0.0
    plant.write(state, "x", x)

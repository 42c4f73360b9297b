"""Gear shifts of the nine-speed gear set and of both simplified gearboxes: Figures 4.12 to 4.15."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ptgen.simulate.recording import Recording
from ptgen.testbed import load_scenario
from validation.case import ROOT, RPM, Array, Case, Number, Panel, bed, draw, rms, run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["AIR_GAP", "CASES", "MODELS", "shift"]

AIR_GAP = {"load_compensation": 0.0, "acceleration_torque": 0.0, "M1_damping": 0.0, "M1_torque_integral_gain": 0.0}
"""Parameters with which M1 gives its air-gap torque without feedback."""
MODELS = {"detailed": "shift-rig", "I": "shift-rig-one-clutch", "II": "shift-rig-two-clutches"}
START, END = 3.0, 4.0
PAUSE = (3.11, 3.29)
SIGNALS = (
    ("n1", "M1_speed", RPM, "rpm"),
    ("n2", "M2_speed", RPM, "rpm"),
    ("T1", "flange1_torque", 1.0, "N m"),
    ("T2", "flange2_torque", 1.0, "N m"),
)


def shift(model: str, course: str) -> Recording:
    """Return the run of a model, with the air-gap torque of M1 as it is given."""
    stem = MODELS[model]
    project = bed(stem)
    scenario = load_scenario(ROOT / "scenarios" / f"{stem}-{course}.toml", project.testbed)
    return run(project, scenario, AIR_GAP)


def _differences(one: Recording, other: Recording) -> dict[str, tuple[float, float]]:
    """Return the greatest and the rms difference of each signal while the gear changes."""
    inside = (one.time >= START) & (one.time <= END)
    found = {}
    for name, signal, unit, _ in SIGNALS:
        error = (one.signals[signal] - other.signals[signal])[inside] / unit
        found[name] = (float(np.abs(error).max()), rms(error))
    return found


def _numbers(runs: dict[str, Recording], elements: dict[str, str], said: str) -> list[Number]:
    numbers = []
    for name, (greatest, mean) in _differences(runs["detailed"], runs["II"]).items():
        unit = next(unit for own, _, _, unit in SIGNALS if own == name)
        numbers.append(Number(f"greatest difference of {name}, detailed to II", greatest, unit, said))
        numbers.append(Number(f"rms difference of {name}, detailed to II", mean, unit, said))
    for model in ("detailed", "II"):
        recording = runs[model]
        slips = recording.time[np.abs(recording.signals[elements[model]]) > 1e-6]
        numbers.append(Number(f"duration of the shift, {model}", float(slips[slips < END].max()) - START, "s", "-"))
    for model in ("detailed", "II"):
        inside = (runs[model].time >= START) & (runs[model].time <= END)
        for name, signal, _, unit in SIGNALS[2:]:
            peak = float(np.abs(runs[model].signals[signal][inside]).max())
            numbers.append(Number(f"largest {name}, {model}", peak, unit, "-"))
    return numbers


def _drawn(runs: dict[str, Recording]) -> Figure:
    panels = []
    for name, signal, unit, shown in SIGNALS:
        curves = []
        for model, recording in runs.items():
            inside = (recording.time >= START - 0.2) & (recording.time <= END + 0.2)
            label = "ref: I" if model == "I" else model  # dashed, over that of model II, which it is equal to
            curves.append((label, recording.time[inside], recording.signals[signal][inside] / unit))
        panels.append(Panel(f"{name} ({shown})", curves))
    return draw(panels)


def _in_pause(recording: Recording) -> tuple[float, float]:
    """Return the acceleration of M1 (rad/s^2) and the frequency (Hz) of T2 while nothing is transmitted."""
    inside = (recording.time >= PAUSE[0]) & (recording.time <= PAUSE[1])
    t = recording.time[inside]
    acceleration = float(np.polyfit(t, recording.signals["M1_speed"][inside], 1)[0])
    torque: Array = recording.signals["flange2_torque"][inside]
    torque = torque - torque.mean()
    rising = np.flatnonzero((torque[:-1] < 0) & (torque[1:] >= 0))
    crossings = t[rising] - torque[rising] * (t[1] - t[0]) / (torque[rising + 1] - torque[rising])
    return acceleration, float(1.0 / np.diff(crossings).mean())


def _figure_4_12() -> tuple[list[Number], Figure]:
    runs = {model: shift(model, "downshift") for model in MODELS}
    numbers = _numbers(runs, {"detailed": "gears_B_speed", "II": "gears_clutch1_speed"}, '"minor deviations"')
    for name, (greatest, _) in _differences(runs["I"], runs["II"]).items():
        unit = next(unit for own, _, _, unit in SIGNALS if own == name)
        numbers.append(Number(f"greatest difference of {name}, I to II", greatest, unit, '"identical results"'))
    for model in ("detailed", "II"):
        acceleration, frequency = _in_pause(runs[model])
        numbers.append(Number(f"acceleration of M1 in the pause, {model}", acceleration, "rad/s^2", "-"))
        numbers.append(Number(f"frequency of T2 in the pause, {model}", frequency, "Hz", "-"))
    return numbers, _drawn(runs)


def _figure_4_14() -> tuple[list[Number], Figure]:
    runs = {model: shift(model, "upshift") for model in ("detailed", "II")}
    numbers = _numbers(runs, {"detailed": "gears_D_speed", "II": "gears_clutch2_speed"}, '"slightly differ"')
    return numbers, _drawn(runs)


CASES = (
    Case(
        "figure-4-12",
        "Figures 4.12 and 4.13: shift from second to first gear, not overlapping",
        "While nothing is transmitted the input is accelerated by the torque of its machine. Both simplified models "
        "capture the essential dynamics; deviations are visible mainly while the clutches are open. Models I and II "
        "give identical results. The torques show only minor deviations.",
        "Agrees. Models I and II are derived from the gear set (`ptgen gears parts/nine-speed.toml --simplify 1,2`): "
        "its inertia is exact in both gears, so that all curves are one before the shift and after it. What differs is "
        "the inertia that couples input and output while both elements are open, m12 = -0.11 kg m^2: at the input the "
        "gear set then has 0.029 kg m^2 and the models 0.0034, so M1 speeds up by 1 - (0.41 + 0.0034) / (0.41 + 0.029) "
        "= 6 % less, and at the output 1.18 and 0.72 kg m^2, so T2 rings more slowly; the ringing reaches T1 through "
        "the coupling, which the models do not have. From then on the phase of the ringing differs, which makes the "
        "greatest difference of T2 as large as its amplitude. Models I and II are equal to rounding.",
        _figure_4_12,
    ),
    Case(
        "figure-4-14",
        "Figures 4.14 and 4.15: overlapping shift from first to second gear",
        "The two elements are actuated in parallel, and the speed of the input falls although its torque is positive. "
        "Model II describes the gear set sufficiently; the torques slightly differ.",
        "Agrees. While both elements slip the gear set has the coupling inertia and the model has not, as in Figures "
        "4.12 and 4.13: T2 rings more slowly, T1 has some of it, and D sticks some 10 ms later. Most "
        "of the greatest differences come from that delay.",
        _figure_4_14,
    ),
)

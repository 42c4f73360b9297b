"""Conventional control of the bed in direct drive: Figure 2.6."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from validation.case import RPM, Case, Number, Panel, bed, course, draw, ramps, rms, run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["CASES"]


def _figure_2_6() -> tuple[list[Number], Figure]:
    project = bed("differential")
    speed = ramps((1.5, 0), (2.5, 500 * RPM), (5.5, 500 * RPM), (6.5, 1000 * RPM), (8, 1000 * RPM), (8.5, 750 * RPM))
    torque = ramps((0.3, 0), (0.8, 300), (4.0, 300), (4.02, 600))
    scenario = course(10.0, 5e-3, {"torque.M1": torque, "speed.M2": speed, "speed.M3": speed})
    fine = course(10.0, 1e-3, scenario.references)
    results = {}
    for name, conventional in (("conventional", True), ("decoupling", False)):
        results[name] = run(project, fine, conventional=conventional)
    numbers, curves, speeds = [], [], []
    for name, recording in results.items():
        t, signals = recording.time, recording.signals
        error = signals["diff_input_torque"] - signals["diff_input_torque_ref"]
        ramp = (t > 1.5) & (t < 3.5) | (t > 5.5) & (t < 7.5)
        slip = (signals["M2_speed"] - signals["M2_speed_ref"]) / RPM
        after = (t > 4.0) & (t < 5.0)
        said = "not kept at its reference while the speed changes" if name == "conventional" else "-"
        minor = "only some minor speed tracking error" if name == "conventional" else "-"
        numbers.append(
            Number(f"largest torque error in the speed ramps, {name}", np.abs(error[ramp]).max(), "N m", said)
        )
        numbers.append(Number(f"rms torque error in the speed ramps, {name}", rms(error[ramp]), "N m", "-"))
        numbers.append(Number(f"speed error after the torque step, {name}", np.abs(slip[after]).max(), "rpm", minor))
        curves.append((name, t[::4], signals["diff_input_torque"][::4]))
        speeds.append((name, t[::4], signals["M2_speed"][::4] / RPM))
    conventional = results["conventional"]
    t, torque_now = conventional.time, conventional.signals["diff_input_torque"]
    ringing = torque_now[(t >= 4.05) & (t < 5.05)]
    spectrum = np.abs(np.fft.rfft((ringing - ringing.mean()) * np.hanning(len(ringing))))
    numbers.append(
        Number("frequency of the ringing, conventional", 3 + float(spectrum[3:].argmax()), "Hz", "vibrations")
    )
    reference = ("reference", t[::4], conventional.signals["diff_input_torque_ref"][::4])
    speed_reference = ("reference", t[::4], conventional.signals["M2_speed_ref"][::4] / RPM)
    panels = [
        Panel("torque at the\ninput (N m)", [*curves, reference]),
        Panel("speed of M2\n(rpm)", [*speeds, speed_reference]),
    ]
    return numbers, draw(panels)


CASES = (
    Case(
        "figure-2-6",
        "Figure 2.6: conventional control, direct drive",
        "With independent PI controllers the speeds are controlled rather well; a fast change of the testing torque "
        "at 4 s moves them little. The testing torque is not kept at its reference while the speeds change, and it "
        "rings whenever it varies.",
        "Agrees in all three points, on the bed of Table C.1. The references are drawn anew, since the source gives "
        "only a picture. With its conservative integrator ptgen's conventional controller needs seconds to remove an "
        "error of the torque; the source's parameters came from a test bed and are not printed.",
        _figure_2_6,
    ),
)

"""Truck differentials behind adapter gearboxes: Figures 5.9 and 5.12 to 5.18, 6.2 and 6.4."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ptgen.analysis.closed_loop import closed_loop_poles
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.simulate.recording import Recording
from ptgen.testbed import load_scenario
from validation.case import ROOT, RPM, Array, Case, Number, Panel, bed, course, draw, ramps, rms, run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["CASES"]

NAME = "differential-gearboxes"
DAMPING_ONLY = {"load_compensation": 0.0, "acceleration_torque": 0.0}
STIFF = {
    f"{machine}_speed_{gain}": value
    for machine in ("M2", "M3")
    for gain, value in (("gain", 10.3 * 60.0), ("integral_gain", 10.3 * 60.0**2 / 4))
}
"""Speed controllers of 60 rad/s, as one would tune them alone."""
LOSSES = (
    ("gearbox2.output - shaft2", "gearbox2.output - bearing2 - shaft2"),
    ("gearbox3.output - shaft3", "gearbox3.output - bearing3 - shaft3"),
    (
        "[control]\n",
        """[components.bearing2]
type = "bearing"
coulomb = "8 N m"
viscous = "0.06 N m s/rad"
[components.bearing3]
type = "bearing"
coulomb = "8 N m"
viscous = "0.06 N m s/rad"
[control]
""",
    ),
)
MAPS = (
    "damping_ratio = 1.0                  # critical damping (5.81), the thesis's compromise (Figure 5.18)\n",
    """[control.losses.gearbox2]
speed = ["0 rpm", "1 rpm", "3000 rpm"]
torque = ["0 N m", "8 N m", "26.8 N m"]
[control.losses.gearbox3]
speed = ["0 rpm", "1 rpm", "3000 rpm"]
torque = ["0 N m", "8 N m", "26.8 N m"]
""",
)


def _of_mode(project: Project, parameters: dict[str, float]) -> tuple[float, float]:
    """Return frequency (Hz) and damping ratio of the least damped pole around the first mode."""
    poles = closed_loop_poles(project.controller, project.plant, parameters)
    near = [pole for pole in poles if 0.3 < pole.frequency_hz < 4.0]
    worst = min(near, key=lambda pole: pole.damping_ratio)
    return worst.frequency_hz, worst.damping_ratio


def _total(recording: Recording) -> Array:
    return recording.signals["diff_outputs_torque"] / 1e3


def _error(recording: Recording) -> Array:
    return recording.signals["diff_outputs_torque"] - recording.signals["diff_outputs_torque_ref"]


def _figure_5_9() -> tuple[list[Number], Figure]:
    """Poles of the torque transfer function over the damping: (5.79), and those of the whole sampled loop."""
    project = bed(NAME)
    gains = project.design.gains
    c, inertia, critical = gains.stiffness["M1"], gains.inertia_estimate["M1"], gains.damping["M1"]
    share = np.linspace(0.0, 1.5, 61)
    d = share * critical
    ideal = -d / (2 * inertia) + np.emath.sqrt((d / (2 * inertia)) ** 2 - c / inertia)
    sampled = []
    for value in share:
        own = {"M1_damping": value * critical, "M1_torque_integral_gain": 0.0}
        poles = [pole.s for pole in closed_loop_poles(project.controller, project.plant, own)]
        wanted = -d[len(sampled)] / (2 * inertia) + np.emath.sqrt((d[len(sampled)] / (2 * inertia)) ** 2 - c / inertia)
        sampled.append(min(poles, key=lambda s: abs(complex(s) - complex(wanted))))
    sampled = np.array(sampled)
    zeta = -ideal.real / np.abs(ideal)
    mine = -sampled.real / np.abs(sampled)
    half = int(np.argmin(np.abs(share - 0.5)))
    numbers = [
        Number("damping for critical damping, (5.81)", critical, "N m s/rad", "2 sqrt(c I1)"),
        Number("damping ratio with half of it, (5.81)", float(zeta[half]), "", "0.5 by (5.81)"),
        Number("the same, sampled loop with the full plant", float(mine[half]), "", "-"),
        Number("damping ratio without active damping, full plant", float(mine[0]), "", "0 by (5.79)"),
    ]
    panels = [
        Panel("damping ratio", [("full plant, sampled", share, mine), ("ref: (5.81)", share, np.minimum(share, 1.0))]),
        Panel(
            "imaginary part\n(rad/s)",
            [("full plant, sampled", share, np.abs(sampled.imag)), ("ref: (5.79)", share, np.abs(ideal.imag))],
        ),
        Panel("real part\n(rad/s)", [("full plant, sampled", share, sampled.real), ("ref: (5.79)", share, ideal.real)]),
    ]
    return numbers, draw(panels, "damping / damping for critical damping", height=1.5)


def _test_run(project: Project, **options: object) -> Recording:
    scenario = load_scenario(ROOT / "scenarios" / "differential-gearboxes-run.toml", project.testbed)
    return run(project, course(100.0, 0.05, scenario.references), **options)


def _figure_5_12() -> tuple[list[Number], Figure]:
    project = bed(NAME)
    slow = project.design.controller.conventional | STIFF
    fast = slow | {"M1_torque_integral_gain": 1.0}
    runs = {name: _test_run(project, conventional=True, parameters=p) for name, p in (("slow", slow), ("fast", fast))}
    frequency, damping = _of_mode(project, slow)
    _, unstable = _of_mode(project, fast)
    _, shipped = _of_mode(project, project.design.controller.conventional)
    error = _error(runs["slow"])
    numbers = [
        Number("frequency of the ringing", frequency, "Hz", "approximately 1.3 Hz"),
        Number("its damping ratio, integrator 0.32 /s", damping, "", '"weakly damped"'),
        Number("its damping ratio, integrator 1 /s", unstable, "", "unstable, because of the integrator"),
        Number("its damping ratio, as shipped: speed control 6 rad/s", shipped, "", "-"),
        Number("largest torque error, integrator 0.32 /s", np.abs(error).max(), "N m", '"unacceptable"'),
    ]
    t = runs["slow"].time
    panels = [
        Panel(
            "sum of output\ntorques (kN m)",
            [
                ("integrator 1 /s", t, np.clip(_total(runs["fast"]), -100, 100)),
                ("integrator 0.32 /s", t, _total(runs["slow"])),
                ("reference", t, runs["slow"].signals["diff_outputs_torque_ref"] / 1e3),
            ],
            (-30, 50),
        ),
        Panel("error, integrator\n0.32 /s (kN m)", [("torque error", t, error / 1e3)]),
        Panel(
            "speeds (rpm),\nintegrator 0.32 /s",
            [(name, t, runs["slow"].signals[f"{name}_speed"] / RPM) for name in ("M2", "M3")],
        ),
    ]
    return numbers, draw(panels)


def _figure_5_13() -> tuple[list[Number], Figure]:
    project = bed(NAME)
    slow = project.design.controller.conventional | STIFF
    recordings = {
        "decoupling and damping": _test_run(project),
        "damping only": _test_run(project, parameters=DAMPING_ONLY),
        "conventional": _test_run(project, conventional=True, parameters=slow),
    }
    _, damping = _of_mode(project, {})
    said = {"decoupling and damping": '"hardly affected" by the speeds', "damping only": "affected by the speeds"}
    t = recordings["damping only"].time
    reference = recordings["damping only"].signals["diff_outputs_torque_ref"]
    moving = np.convolve(np.abs(np.gradient(reference)) > 0, np.ones(60))[: len(t)] > 0  # ramps, and 3 s after them
    numbers = [
        Number(
            f"rms torque error while the reference rests, {name}", rms(_error(r)[~moving]), "N m", said.get(name, "-")
        )
        for name, r in recordings.items()
    ]
    numbers.append(Number("least damping ratio around the first mode", damping, "", '"sufficiently damped"'))
    numbers.append(Number("torque control", project.design.gains.torque_integral["M1"], "rad/s", '"much faster"'))
    whole, damped = recordings["decoupling and damping"], recordings["damping only"]
    panels = [
        Panel(
            "sum of output\ntorques (kN m)",
            [
                ("damping only", t, _total(damped)),
                ("decoupling", t, _total(whole)),
                ("reference", t, reference / 1e3),
            ],
        ),
        Panel(
            "torque error\n(kN m)", [("damping only", t, _error(damped) / 1e3), ("decoupling", t, _error(whole) / 1e3)]
        ),
    ]
    return numbers, draw(panels)


def _speed_ramp() -> dict[str, object]:
    speed = ramps((1, 0), (4, 600 * RPM), (9, 600 * RPM), (11, 1000 * RPM), (15, 1000 * RPM), (17, 600 * RPM))
    return {"torque.M1": ramps((0.5, 0), (2.0, 10e3)), "speed.M2": speed, "speed.M3": speed}


def _estimate(project: Project, recording: Recording, inertias: bool, maps: bool) -> Array:
    """Return the testing torque from flange torques (5.96), and from accelerations too (5.98)."""
    design = project.design.decoupling
    values = {name: recording.signals[name] for name in design.sensors}
    row = evaluate_matrix(design.law.estimate_sensors, design.values)[0]
    torque = sum(weight * values[name] for weight, name in zip(row, design.sensors, strict=True) if weight)
    ratio, step = 10.4, recording.time[1] - recording.time[0]
    for machine in ("M2", "M3"):
        speed = recording.signals[f"{machine}_speed"]
        if maps:
            torque = torque + ratio * (8.0 + 0.06 * np.abs(speed)) * np.clip(speed / (1 * RPM), -1, 1)
        if inertias:
            torque = torque + ratio * (1.65 + 0.03) * np.gradient(speed, step)
    return np.asarray(torque)


def _variations() -> dict[str, tuple[Project, dict[str, float]]]:
    own = bed(NAME, *LOSSES, MAPS)
    return {
        "I1 = 0": (own, {"acceleration_torque": 0.0}),
        "I1 = rotor of M1": (own, {"M1_inertia_estimate": 3.25}),
        "I1 from the full model": (own, {}),
    }


def _figure_5_14() -> tuple[list[Number], Figure]:
    numbers, curves = [], []
    scenario = course(20.0, 0.01, _speed_ramp())
    for name, (project, parameters) in _variations().items():
        recording = run(project, scenario, parameters)
        t = recording.time
        after = t > 8.5
        said = {
            "I1 = 0": "significant torque variations",
            "I1 = rotor of M1": "remaining variations might be unsatisfactory",
        }.get(name, "improved; perfect decoupling cannot be achieved")
        error = _error(recording)[after]
        numbers.append(Number(f"largest torque error, {name}", np.abs(error).max(), "N m", said))
        curves.append((f"{name}, real", t[after], _total(recording)[after]))
        if name == "I1 from the full model":
            estimate = _estimate(project, recording, inertias=False, maps=True)
            off = estimate[after] - recording.signals["diff_outputs_torque"][after]
            said = "significant difference during acceleration"
            numbers.append(Number("estimate without accelerations less real torque", np.abs(off).max(), "N m", said))
            curves.append((f"{name}, est.", t[after], estimate[after] / 1e3))
    curves.append(("reference", t[after], recording.signals["diff_outputs_torque_ref"][after] / 1e3))
    return numbers, draw([Panel("sum of output\ntorques (kN m)", curves)], height=2.6)


def _figure_5_15() -> tuple[list[Number], Figure]:
    project, parameters = _variations()["I1 from the full model"]
    recording = run(project, course(20.0, 0.01, _speed_ramp()), parameters)
    t, real = recording.time, recording.signals["diff_outputs_torque"]
    after = t > 8.5
    estimates = {
        "flanges only": _estimate(project, recording, inertias=False, maps=False),
        "with losses, (5.96)": _estimate(project, recording, inertias=False, maps=True),
        "with losses and inertias, (5.98)": _estimate(project, recording, inertias=True, maps=True),
    }
    said = {"with losses, (5.96)": "as in Figure 5.14", "with losses and inertias, (5.98)": '"significantly reduced"'}
    numbers = [
        Number(f"rms difference to the real torque, {name}", rms((values - real)[after]), "N m", said.get(name, "-"))
        for name, values in estimates.items()
    ]
    curves = [(name, t[after], (values - real)[after]) for name, values in estimates.items()]
    return numbers, draw([Panel("estimate less\nreal torque (N m)", curves)], height=2.6)


def _figure_5_16() -> tuple[list[Number], Figure]:
    speed = ramps((0.5, 0), (6, 1000 * RPM))
    torque = ramps((1, 0), (3, 8e3), (14, 8e3), (14.5, 16e3))
    scenario = course(22.0, 0.01, {"torque.M1": torque, "speed.M2": speed, "speed.M3": speed})
    observer = bed(NAME, ('speed_bandwidth = "6 rad/s"', 'speed_control = "observer"\nspeed_bandwidth = "6 rad/s"'))
    numbers, curves = [], []
    for kind, project in (("PI", bed(NAME)), ("observer", observer)):
        for name, parameters in (("damping only", DAMPING_ONLY), ("decoupling", {})):
            recording = run(project, scenario, parameters)
            t = recording.time
            after = t > 13.0
            error = (recording.signals["M2_speed"] - recording.signals["M2_speed_ref"])[after] / RPM
            said = "directly affected" if name == "damping only" else '"almost entirely eliminated"'
            numbers.append(Number(f"largest speed error, {kind}, {name}", np.abs(error).max(), "rpm", said))
            curves.append((f"{kind}, {name}", t[after], error))
    return numbers, draw([Panel("speed error of\nM2 (rpm)", curves)], height=2.6)


def _figure_5_17() -> tuple[list[Number], Figure]:
    speed = ramps((0.5, 0), (6, 800 * RPM), (14, 800 * RPM), (17, 1100 * RPM))
    torque = ramps((1, 0), (3, 8e3))
    scenario = course(24.0, 0.01, {"torque.M1": torque, "speed.M2": speed, "speed.M3": speed})
    observer = bed(NAME, ('speed_bandwidth = "6 rad/s"', 'speed_control = "observer"\nspeed_bandwidth = "6 rad/s"'))
    numbers, curves = [], []
    for kind, project in (("PI", bed(NAME)), ("observer", observer)):
        for name, parameters in (("damping only", DAMPING_ONLY), ("decoupling", {})):
            recording = run(project, scenario, parameters)
            t = recording.time
            after = t > 13.0
            now = recording.signals["M2_speed"] / RPM
            curves.append((f"{kind}, {name}", t[after], now[after]))
            if name == "decoupling":
                behind = float(np.interp(16.9, t, recording.signals["M2_speed_ref"] / RPM - now))
                over = '"shows an overshoot"' if kind == "PI" else '"can be avoided"'
                lag = "-" if kind == "PI" else '"a remaining tracking error"'
                numbers.append(Number(f"overshoot, {kind}", now[after].max() - 1100, "rpm", over))
                numbers.append(Number(f"error at the end of the ramp, {kind}", behind, "rpm", lag))
    curves.append(("reference", t[after], recording.signals["M2_speed_ref"][after] / RPM))
    return numbers, draw([Panel("speed of M2\n(rpm)", curves)], height=2.6)


def _figure_5_18() -> tuple[list[Number], Figure]:
    project = bed(NAME)
    critical = project.design.gains.damping["M1"]
    speed = ramps((0.5, 0), (6, 800 * RPM))
    torque = ramps((1, 0), (3, 8e3), (12, 8e3), (12.3, 16e3))
    scenario = course(18.0, 0.01, {"torque.M1": torque, "speed.M2": speed, "speed.M3": speed})
    numbers, curves = [], []
    for zeta, said in ((0.2, "fast, but torsional vibrations"), (0.5, "-"), (1.0, "good compromise"), (2.0, "slower")):
        damping = {"M1_damping": zeta * critical, "M1_model_damping": zeta * critical}
        recording = run(project, scenario, damping)
        t = recording.time
        after = t > 11.5
        torque_now = _total(recording)
        reached = t[(t > 12) & (torque_now > 8 + 0.9 * 8)][0] - 12.0
        numbers.append(
            Number(f"overshoot, damping ratio {zeta:g}", (torque_now[after].max() / 16 - 1) * 200, "%", said)
        )
        numbers.append(Number(f"time to 90 %, damping ratio {zeta:g}", reached, "s", "-"))
        curves.append((f"damping ratio {zeta:g}", t[after], torque_now[after]))
    curves.append(("reference", t[after], recording.signals["diff_outputs_torque_ref"][after] / 1e3))
    return numbers, draw([Panel("sum of output\ntorques (kN m)", curves)], height=2.8)


def _figure_6_2() -> tuple[list[Number], Figure]:
    """A change of the torque's sign through play, conventional and with decoupling and damping."""
    line = 'damping = "150 N m s/rad"            #'
    loose = bed(NAME, (line, f'backlash = "3 deg"\n{line}'))
    speed = ramps((1, 0), (8, 600 * RPM))
    torque = ramps((9, 0), (13, 8e3), (35, 8e3), (41, -8e3))
    scenario = course(55.0, 0.02, {"torque.M1": torque, "speed.M2": speed, "speed.M3": speed})
    stiff = bed(NAME).design.controller.conventional | STIFF
    runs = {
        "conventional, no play": run(bed(NAME), scenario, stiff, conventional=True),
        "conventional": run(loose, scenario, stiff, conventional=True),
        "decoupling": run(loose, scenario),
    }
    said = {"conventional": "strong excitation, emergency shut-down", "decoupling": '"no longer critical"'}
    numbers, curves = [], []
    for name, recording in runs.items():
        t = recording.time
        for when, begin in (("during the change of sign", 38.0), ("4 s after it", 45.0)):
            size = np.ptp(_error(recording)[(t > begin) & (t < begin + 2.0)])
            numbers.append(Number(f"torque error {when}, peak to peak, {name}", size, "N m", said.get(name, "-")))
        shown = t > 30.0
        if name in said:
            curves.append((name, t[shown], _total(recording)[shown]))
    curves.append(("reference", t[shown], recording.signals["diff_outputs_torque_ref"][shown] / 1e3))
    return numbers, draw([Panel("sum of output\ntorques (kN m)", curves)], height=2.8)


CASES = (
    Case(
        "figure-5-9",
        "Figure 5.9: poles over the active damping",
        "Without damping the poles of the torque are imaginary; with 2 sqrt(c I1) they meet on the real axis, the "
        "damping ratio being proportional up to there (5.79), (5.81); beyond, they part.",
        "Agrees. The curve of the full plant is that of the emitted code around the unreduced bed, with sampling, "
        "dead time and lag: it starts at the damping of the shafts, and the poles meet at slightly less damping than "
        "for (5.79). Integrator off, as in the formula.",
        _figure_5_9,
    ),
    Case(
        "figure-5-12",
        "Figure 5.12: conventional control with adapter gearboxes",
        "Unacceptable vibrations at approximately 1.3 Hz, started by each change of the speed of M1 and of the "
        "torque; unstable because of the integrator of the torque controller, though the torque is changed slowly.",
        "Agrees in frequency, cause and course. The source does not print its gains. The speed controllers are those "
        "of 60 rad/s that one would tune alone; then the load machines hold their speeds, and the mode has the 1.3 "
        "Hz of the source. With an integrator of 1 /s it grows, as in the source; ptgen's conventional controller "
        "takes half of what would do so. The slow speed control of 6 rad/s of the shipped bed damps the mode a "
        "little. The references are drawn anew.",
        _figure_5_12,
    ),
    Case(
        "figure-5-13",
        "Figure 5.13: decoupling and damping, damping only",
        "With active damping resonance is no longer critical, whether decoupled or not; this allows a much faster "
        "torque controller. With decoupling the total output torque is hardly affected by the speeds.",
        "Agrees. With decoupling what is left of the error is the lag behind ramps of the torque; the numbers count "
        "only the time while its reference rests. The speed references are the same for all, while the source gave "
        "the conventional controller gentler ones.",
        _figure_5_13,
    ),
    Case(
        "figure-5-14",
        "Figure 5.14: inertia in the acceleration torque",
        "Without acceleration torque a change of the speed leads to significant variations of the torque; with the "
        "rotor's inertia alone what remains might be unsatisfactory; a manually increased value improves it. The "
        "estimate, without the inertia of the gearboxes, differs from the real torque during the acceleration.",
        "Agrees. ptgen finds the inertia from the full model, where the source tunes by hand. Losses of 8 N m and 0.06 "
        "N m s/rad are added behind each output gearbox and given to the controller as maps; the source has such maps "
        "and does not print them. Inertia and maps are those of the simulated bed, so next to no error is left; on a "
        "real bed it is what these numbers are wrong by, and the source's plant has more in it than "
        "its controller knows.",
        _figure_5_14,
    ),
    Case(
        "figure-5-15",
        "Figure 5.15: testing torque from sensors",
        "With the acceleration torques of the gearboxes the difference between the real torque and its estimate is "
        "significantly reduced.",
        "Agrees. The emitted controller uses (5.98) with the net torque of the rotors instead of a derivative; here "
        "the estimates are computed from the recording.",
        _figure_5_15,
    ),
    Case(
        "figure-5-16",
        "Figure 5.16: a change of the load torque moves the speed",
        "Without decoupling a change of load torque directly affects n2; with load torque compensation this is almost "
        "entirely eliminated. PI and P with disturbance observer, tuned alike, are nearly identical.",
        "Agrees, for the observer's default bandwidth, which gives it the same area of error as the PI controller.",
        _figure_5_16,
    ),
    Case(
        "figure-5-17",
        "Figure 5.17: ramp response of the speed",
        "PI overshoots at the end of a ramp; P with disturbance observer does not, but stays behind during the ramp. "
        "Both are hardly affected by the decoupling measures.",
        "Agrees.",
        _figure_5_17,
    ),
    Case(
        "figure-5-18",
        "Figure 5.18: ramp response of the torque for several dampings",
        "With little damping fast, but with vibrations; with more they vanish and the torque becomes slower; critical "
        "damping is a good compromise.",
        "Agrees. Overshoot is counted in percent of the change. The torque model follows the damping; with a damping "
        "ratio of 0.1 the integrator of 2 rad/s alone would make the mode grow.",
        _figure_5_18,
    ),
    Case(
        "figure-6-2",
        "Figures 6.2 and 6.4: change of the torque's sign through play (measured)",
        "At t = 90 s the testing torque changes its sign: gear play excites large oscillations, and the bed is shut "
        "down in an emergency. With decoupling and damping resonance is no longer critical, even if the excitation is "
        "strong.",
        "Agrees in kind: the play multiplies the oscillation that the change of sign excites, and with damping it is "
        "gone as soon as the gap has closed. The play of the measured bed is not printed; 3 degrees at the input "
        "cardan shaft stand for all of it. The run is shortened, the conventional controller is that of Figure 5.12 "
        "with 0.32 /s, and its supervision is off.",
        _figure_6_2,
    ),
)

r"""References: their names, speeds as mean and difference, and limits of their rates.

A reference that jumps asks for more than the bed can do, and what is left over has to be kept from winding up. So each
one passes a rate limiter first. By default it is as fast as can be followed at all: a speed changes with
``torque_max / I_m``, a torque with its largest static value times the natural frequency of its loop (5.79).
In the first step a limited reference starts where the bed is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ptgen.control.decoupling import Decoupling
from ptgen.control.plausibility import plausible_speed
from ptgen.control.tuning import Gains
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of
from ptgen.plant.layout import signal_name
from ptgen.testbed.testbed import Tuning

__all__ = ["Reference", "limited", "pair_bounds", "pair_rates", "reference_inputs", "speed_references"]


@dataclass(frozen=True)
class Reference:
    """What a machine shall do, behind the limits of the rates.

    Attributes
    ----------
    signal : str
        Its name, such as ``diff_input_torque_ref`` or ``M2_speed_ref``.
    unit : str
        N m or rad/s.
    limited : Expr
        Its value in this step.
    step : Expr
        By how much that may change in a step.
    present : Expr
        What the bed does now.
    """

    signal: str
    unit: str
    limited: sp.Expr
    step: sp.Expr
    present: sp.Expr


def reference_inputs(design: Decoupling, tuning: Tuning) -> dict[str, str]:
    """Return the input of each reference of a scenario, ``torque.M1`` -> ``flange1_torque_ref``."""
    result = {}
    paired = {machine for members in tuning.speed_pairs.values() for machine in members}
    for position, machine in enumerate(design.actuators):
        name = design.machines[machine]
        if position < design.torque_count:
            result[f"torque.{name}"] = signal_name(design.outputs[position]) + "_ref"
        elif name not in paired:
            result[f"speed.{name}"] = f"{name}_speed_ref"
    for pair in tuning.speed_pairs:
        result[f"speed_mean.{pair}"] = f"{pair}_speed_mean_ref"
        result[f"speed_difference.{pair}"] = f"{pair}_speed_difference_ref"
    return result


def pair_rates(gains: Gains, members: tuple[str, ...]) -> tuple[float, float]:
    """Return the rates (rad/s^2) of mean and difference of a pair: each alone moves the slower machine at its own."""
    slower = min(gains.speed_rate[machine] for machine in members)
    return slower, 2 * slower


def pair_bounds(w: ControllerWriter) -> dict[str, float]:
    """Return the largest plausible value (rad/s) of each reference of a pair."""
    bounds = {}
    for pair, members in w.tuning.speed_pairs.items():
        least = min(plausible_speed(w.full, machine) for machine in members)
        bounds[f"{pair}_speed_mean_ref"] = least
        bounds[f"{pair}_speed_difference_ref"] = 2 * least
    return bounds


def limited(
    w: ControllerWriter, name: str, unit: str, target: sp.Expr, start: sp.Expr, rate: float, *, here: bool = False
) -> sp.Symbol:
    """Return a signal behind a rate limiter.

    Parameters
    ----------
    w : ControllerWriter
    name : str
        Of the signal.
    unit : str
    target : Expr
        What it shall be.
    start : Expr
        What it is in the first step.
    rate : float
        Default of its largest rate (unit/s).
    here : bool
        Whether `start` is not known before, see `ControllerWriter.previous`.
    """
    most = w.parameter(
        f"{name}_rate", f"{unit}/s".replace("rad/s/s", "rad/s^2"), f"largest rate of {name}", rate, allowed=False
    )
    step = w.derive(f"{name}_step", unit, f"largest change of {name} in a step", signal_symbol("sample_time") * most)
    state = w.state(f"{name}_limited", unit, f"{name} behind its rate limiter")
    before = w.assign(f"{name}_before", w.previous(state, start, here=here), "limit of the rate")
    return w.assign(state.name, before + greatest_of(-step, smallest_of(step, target - before)))


def speed_references(w: ControllerWriter, measured: Mapping[str, sp.Symbol]) -> dict[str, Reference]:
    """Return the limited speed reference of each speed-controlled machine."""
    result: dict[str, Reference] = {}
    machines = {w.design.machines[k]: k for k in w.design.actuators[w.design.torque_count :]}
    speeds = {name: measured[w.speed_sensor(k)] for name, k in machines.items()}
    half = sp.Rational(1, 2)
    for pair, (first, second) in w.tuning.speed_pairs.items():
        rates = pair_rates(w.gains, (first, second))
        starts = (half * (speeds[first] + speeds[second]), speeds[first] - speeds[second])
        names = (f"{pair}_speed_mean_ref", f"{pair}_speed_difference_ref")
        mean, difference = (
            limited(w, name, "rad/s", measured[name], start, rate)
            for name, start, rate in zip(names, starts, rates, strict=True)
        )
        step = signal_symbol(f"{names[0]}_step") + half * signal_symbol(f"{names[1]}_step")
        for name, sign in ((first, 1), (second, -1)):
            result[name] = Reference(f"{name}_speed_ref", "rad/s", mean + sign * half * difference, step, speeds[name])
    for name, speed in speeds.items():
        if name not in result:
            signal = f"{name}_speed_ref"
            now = limited(w, signal, "rad/s", measured[signal], speed, w.gains.speed_rate[name])
            result[name] = Reference(signal, "rad/s", now, signal_symbol(f"{signal}_step"), speed)
    return result

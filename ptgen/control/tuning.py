"""Gains from quantities that an engineer knows: bandwidths, damping ratio, inertia that must be accelerated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.control.decoupling import Decoupling
from ptgen.control.plausibility import largest_torque
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.mechanism.modes import Mode
from ptgen.testbed.testbed import Tuning

__all__ = ["Gains", "TwistingGains", "gains"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TwistingGains:
    """Gains of the super-twisting speed control, experimental.

    Attributes
    ----------
    k1 : float
        (N m (s/rad)^0.5)
    k2 : float
        (N m/s)
    layer : float
        Error (rad/s) below which it is linear.
    """

    k1: float
    k2: float
    layer: float


@dataclass(frozen=True)
class Gains:
    """Gains of the controller.

    Attributes
    ----------
    speed, speed_integral : mapping of str to float
        Proportional (N m s/rad) and integral (N m/rad) gain of each speed-controlled machine (5.84).
    torque_integral, conventional_integral : mapping of str to float
        Integral gain (1/s) of each torque-controlled machine (5.99), with and without active damping.
    damping : mapping of str to float
        Damping (N m s/rad) of each torque-controlled machine (5.81).
    inertia_estimate : mapping of str to float
        Inertia (kg m^2) that the acceleration torque of each torque-controlled machine accounts for (5.78).
    sensor_inertia : mapping of str to mapping of str to float
        Inertia (kg m^2) between sensors and testing torque: for each torque-controlled machine, what has to be added
        to the torque read per acceleration of each speed-controlled machine; (5.97) for all parts of the bed.
    sensor_ratio : mapping of str to mapping of str to str
        The changing ratio times which that holds, where the parts between lie on one side of it: their acceleration is
        the derivative of ratio times speed. Empty where there is none.
    stiffness, natural_frequency : mapping of str to float
        What each torque-controlled machine swings against (N m/rad), and how fast (rad/s) (5.79).
    observer_bandwidth : mapping of str to float
        Bandwidth (rad/s) of the disturbance observer of each speed-controlled machine (5.88).
    super_twisting : mapping of str to TwistingGains
        Experimental; of each speed-controlled machine.
    speed_rate : mapping of str to float
        Largest rate (rad/s^2) of the speed reference of each speed-controlled machine.
    torque_rate : mapping of str to float
        Largest rate (N m/s) of the torque reference of each torque-controlled machine.
    """

    speed: Mapping[str, float]
    speed_integral: Mapping[str, float]
    torque_integral: Mapping[str, float]
    conventional_integral: Mapping[str, float]
    damping: Mapping[str, float]
    inertia_estimate: Mapping[str, float]
    sensor_inertia: Mapping[str, Mapping[str, float]]
    sensor_ratio: Mapping[str, Mapping[str, str]]
    stiffness: Mapping[str, float]
    natural_frequency: Mapping[str, float]
    observer_bandwidth: Mapping[str, float]
    super_twisting: Mapping[str, TwistingGains]
    speed_rate: Mapping[str, float]
    torque_rate: Mapping[str, float]

    def parameters(self) -> dict[str, float]:
        """Return the gains of all feedback by the names of the controller's parameters, any kind of speed control."""
        named = {
            "speed_gain": self.speed,
            "speed_integral_gain": self.speed_integral,
            "observer_bandwidth": self.observer_bandwidth,
            "twisting_gain": {name: twisting.k1 for name, twisting in self.super_twisting.items()},
            "twisting_rate": {name: twisting.k2 for name, twisting in self.super_twisting.items()},
            "twisting_layer": {name: twisting.layer for name, twisting in self.super_twisting.items()},
            "torque_integral_gain": self.torque_integral,
            "damping": self.damping,
            "model_damping": self.damping,
        }
        return {f"{name}_{key}": value for key, values in named.items() for name, value in values.items()}


def gains(decoupling: Decoupling, full: Model, tuning: Tuning, modes: tuple[Mode, ...]) -> Gains:
    r"""Return gains for the bandwidths and the damping ratio in `tuning`.

    Speed: the plant ``1 / (I_m s)`` with :math:`k_p = I_m \omega_b` and :math:`k_i = k_p \omega_b / 4` has a double
    pole at :math:`-\omega_b / 2`. Torque: the plant has gain one, so the integral gain is the bandwidth; without
    active damping it may not exceed :math:`\zeta \omega` of the mode, half of what makes the loop unstable.
    Damping: :math:`d = 2 \zeta \sqrt{c I}` (5.81).

    Observer: a disturbance d moves the speed by :math:`-s d / (I_m s^2 + k_p s + k_i)` with the PI controller and by
    :math:`-s d / ((s + \hat b)(I_m s + k_p))` with the P controller and its observer. Both are equal at low and at
    high frequencies, and a step of d leaves the same area of error :math:`d / k_i`, if :math:`\hat b = k_i / k_p`;
    with the gains above that is a quarter of the bandwidth.

    Rates: a speed reference changes by ``torque_max / I_m`` at most, a torque reference by the largest static torque
    at its place times the natural frequency (5.79); nothing that is faster could be followed.

    Parameters
    ----------
    decoupling : Decoupling
    full : Model
        The full model; the inertia between machine and testing torque comes from it.
    tuning : Tuning
    modes : tuple of Mode
        Modes of the full model.
    """
    rotors = {
        torque.name: decoupling.values[decoupling.model.body_inertias[next(iter(torque.row))]]
        for torque in decoupling.model.inputs
    }
    torque_machines = [decoupling.machines[i] for i in decoupling.actuators[: decoupling.torque_count]]
    speed_machines = [decoupling.machines[i] for i in decoupling.actuators[decoupling.torque_count :]]
    steady = _steady_acceleration(decoupling, full)
    inertia = {**_accelerated_inertia(decoupling, steady), **tuning.inertia_estimate}
    stiffness = {
        name: float(evaluate_matrix(sp.Matrix([[expression]]), decoupling.values)[0, 0])
        for name, expression in zip(torque_machines, decoupling.stiffness, strict=True)
    }
    elastic = [mode for mode in modes if mode.frequency_hz > 0]
    weak = min((2 * np.pi * mode.frequency_hz * mode.damping_ratio for mode in elastic), default=np.inf)
    conventional = tuning.conventional_torque_bandwidth or min(float(weak), tuning.torque_bandwidth)
    wanted = tuning.speed_bandwidth
    inertia = {name: _rounded(inertia[name]) for name in torque_machines}
    frequency = {name: float(np.sqrt(stiffness[name] / inertia[name])) for name in torque_machines}
    drives = {torque.name: torque.drive for torque in full.inputs}
    missing, ratios = _with_ratios(_sensor_inertia(decoupling, full, steady, rotors), decoupling, full, rotors)
    return Gains(
        speed={name: _rounded(rotors[name] * wanted) for name in speed_machines},
        speed_integral={name: _rounded(rotors[name] * wanted**2 / 4) for name in speed_machines},
        torque_integral=dict.fromkeys(torque_machines, tuning.torque_bandwidth),
        conventional_integral=dict.fromkeys(torque_machines, _rounded(conventional)),
        damping={
            name: _rounded(2 * tuning.damping_ratio * float(np.sqrt(stiffness[name] * inertia[name])))
            for name in torque_machines
        },
        inertia_estimate=inertia,
        sensor_inertia=missing,
        sensor_ratio=ratios,
        stiffness=stiffness,
        natural_frequency=frequency,
        observer_bandwidth=dict.fromkeys(speed_machines, tuning.observer_bandwidth or _rounded(wanted / 4)),
        super_twisting={
            name: _twisting(rotors[name], wanted, full.values[drives[name].speed_rated]) for name in speed_machines
        },
        speed_rate={
            name: tuning.speed_rate or _rounded(full.values[drives[name].torque_max] / rotors[name])
            for name in speed_machines
        },
        torque_rate={
            name: tuning.torque_rate or _rounded(largest_torque(full, full.signals[place]) * frequency[name])
            for name, place in zip(torque_machines, decoupling.outputs, strict=False)
        },
    )


def _twisting(rotor: float, bandwidth: float, speed_rated: float) -> TwistingGains:
    r"""Return gains of the super-twisting control with the torque of the PI controller at 1 % of the rated speed.

    With :math:`e_0` that error: :math:`k_1 = k_p \sqrt{e_0}`, and :math:`k_1 = 1.5 \sqrt L`, :math:`k_2 = 1.1 L` per
    inertia, the usual choice for disturbances that change by less than L. The layer of :math:`e_0 / 16` makes it a PI
    controller of four times the bandwidth for small errors.
    """
    size = 0.01 * speed_rated
    bound = (bandwidth / 1.5) ** 2 * size
    return TwistingGains(
        k1=_rounded(rotor * bandwidth * float(np.sqrt(size))),
        k2=_rounded(1.1 * rotor * bound),
        layer=_rounded(size / 16),
    )


def _rounded(value: float) -> float:
    """Round to six digits: more would emit the rounding errors of the linear algebra at hand."""
    return float(f"{value:.6g}")


def _accelerated_inertia(decoupling: Decoupling, steady: Array) -> dict[str, float]:
    """Return the inertia for which the acceleration torque leaves the testing torque alone.

    In steady acceleration of the whole bed, all twists constant and every controlled torque zero, the torque that
    a torque-controlled machine needs is found from the full model; the law gives that torque per unit of
    inertia. The thesis finds this value by hand (source, Section 5.8.1).
    """
    per_inertia = _law_torques(decoupling)
    result = {}
    for index, (machine, symbol) in enumerate(_estimates(decoupling)):
        weights = per_inertia[index]
        needed = steady[len(steady) - len(decoupling.machines) + machine]
        squared = float(weights @ weights)
        result[decoupling.machines[machine]] = (
            float(weights @ needed / squared) if squared > 0 else decoupling.values[symbol]
        )
    return result


def _sensor_inertia(
    decoupling: Decoupling, full: Model, steady: Array, rotors: Mapping[str, float]
) -> dict[str, dict[str, float]]:
    """Return what the estimate of each controlled torque misses in steady acceleration, where that torque is zero."""
    speed_machines = decoupling.actuators[decoupling.torque_count :]
    sensors = np.vstack([_row(full.signals[name], full) @ steady for name in decoupling.sensors])
    read = evaluate_matrix(decoupling.law.estimate_sensors, decoupling.values) @ sensors
    of_virtual = evaluate_matrix(decoupling.law.estimate_virtual, decoupling.values)
    result: dict[str, dict[str, float]] = {}
    for index, machine in enumerate(decoupling.actuators[: decoupling.torque_count]):
        missing = {}
        for column, other in enumerate(speed_machines):
            name = decoupling.machines[other]
            known = of_virtual[index, decoupling.torque_count + column] * rotors[name]
            inertia = -float(read[index, column] + known)
            missing[name] = _rounded(inertia) if abs(inertia) > 1e-7 * rotors[name] else 0.0
        result[decoupling.machines[machine]] = missing
    return result


def _with_ratios(
    missing: dict[str, dict[str, float]], decoupling: Decoupling, full: Model, rotors: Mapping[str, float]
) -> tuple[dict[str, dict[str, float]], dict[str, dict[str, str]]]:
    """Divide what is missing by the changing ratio that it grows with; return it, and the names of these ratios."""
    found = {name: dict(inertias) for name, inertias in missing.items()}
    names: dict[str, dict[str, str]] = {name: {} for name in missing}
    for changing in full.changing:
        ratio, other = changing.value, 2.0 * changing.value
        parameters = tuple(replace(p, value=other) if p.symbol == changing.symbol else p for p in full.parameters)
        changed = replace(full, parameters=parameters)
        design = replace(decoupling, values={**decoupling.values, changing.symbol: other})
        twice = _sensor_inertia(design, changed, _steady_acceleration(design, changed), rotors)
        for name, inertias in missing.items():
            for machine, inertia in inertias.items():
                if inertia and abs(twice[name][machine] - 2.0 * inertia) <= 1e-4 * abs(inertia):
                    found[name][machine] = _rounded(inertia / ratio)
                    names[name][machine] = changing.symbol.name
    return found, names


def _estimates(decoupling: Decoupling) -> list[tuple[int, sp.Symbol]]:
    return list(zip(decoupling.actuators[: decoupling.torque_count], decoupling.inertia_estimate, strict=True))


def _law_torques(decoupling: Decoupling) -> list[Array]:
    """Return each torque machine's acceleration torque per inertia and per acceleration of each speed machine."""
    speed_machines = decoupling.actuators[decoupling.torque_count :]
    rows = []
    for machine, symbol in _estimates(decoupling):
        row = []
        for position, other in enumerate(speed_machines, start=decoupling.torque_count):
            rotor = decoupling.model.body_inertias[next(iter(decoupling.model.inputs[other].row))]
            share = sp.diff(decoupling.law.P[machine, position], symbol) * rotor
            row.append(float(evaluate_matrix(sp.Matrix([[share]]), decoupling.values)[0, 0]))
        rows.append(np.array(row))
    return rows


def _steady_acceleration(decoupling: Decoupling, full: Model) -> Array:
    """Return accelerations, twists and air-gap torques (n_z + n_e + n_u) per acceleration of each speed machine.

    All twists are constant and all controlled torques are zero.
    """
    numeric = full.numeric()
    n_e, n_u = len(full.twists), len(full.inputs)
    E = numeric.twist_rows
    speed_machines = decoupling.actuators[decoupling.torque_count :]
    equations = [np.hstack([numeric.mass, E.T @ numeric.stiffness, -numeric.input_rows.T])]
    equations.append(np.hstack([E, np.zeros((n_e, n_e + n_u))]))
    equations += [_row(full.signals[place], full) for place in decoupling.outputs[: decoupling.torque_count]]
    right = [np.zeros((sum(len(block) for block in equations), len(speed_machines)))]
    for machine in speed_machines:
        row = evaluate_matrix(full.velocity_rows[next(iter(full.inputs[machine].row))], full.values)
        equations.append(np.hstack([row, np.zeros((1, n_e + n_u))]))
    right.append(np.eye(len(speed_machines)))
    # Scaled rows: inertias and stiffnesses differ by many powers of ten.
    matrix, wanted = np.vstack(equations), np.vstack(right)
    size = np.linalg.norm(matrix, axis=1, keepdims=True)
    solution, *_ = np.linalg.lstsq(matrix / size, wanted / size, rcond=None)
    return np.asarray(solution, dtype=np.float64)


def _row(form: LinearForm, full: Model) -> Array:
    """Return a signal over accelerations, twists and air-gap torques."""
    return np.hstack([evaluate_matrix(part, full.values) for part in (form.a, form.e, form.u)])

"""What references need at rest: torques (7.34) and speeds of all machines, and where a scenario asks for too much."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import Problem
from ptgen.governor.prediction import Prediction
from ptgen.loops.listing import listed
from ptgen.project import Project
from ptgen.simulate.drives import value_at
from ptgen.testbed.governor_settings import GovernorSettings
from ptgen.testbed.scenario import Scenario
from ptgen.units import from_si

__all__ = ["Beyond", "StationaryLimits", "beyond_at_rest", "machine_references", "stationary_limits"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class StationaryLimits:
    """What machines give at rest per reference, and what they have.

    Attributes
    ----------
    machines, references, units : tuple of str (m)
    torque : ndarray (m, m)
        Torque of each machine per reference, without friction (7.34).
    speed : ndarray (m, m)
        Speed of each machine per reference.
    torque_max, speed_rated, speed_max : ndarray (m,)
        Torque up to the rated speed (N m), rated and largest speed (rad/s).
    torque_share : ndarray (m,)
        What the governor uses of the torque at rest; the law itself keeps a share for the damping.
    speed_share : float
        What it uses of the speeds.
    """

    machines: tuple[str, ...]
    references: tuple[str, ...]
    units: tuple[str, ...]
    torque: Array
    speed: Array
    torque_max: Array
    speed_rated: Array
    speed_max: Array
    torque_share: Array
    speed_share: float

    def envelope(self, speeds: Array) -> Array:
        """Return the largest torque (..., m) at given speeds (..., m)."""
        return np.asarray(self.torque_max * self.speed_rated / np.maximum(self.speed_rated, np.abs(speeds)))

    def largest(self, reference: int) -> tuple[float, str]:
        """Return up to where a torque reference alone is let through at low speed, and the machine that limits it."""
        factors = np.abs(self.torque[:, reference])
        with np.errstate(divide="ignore"):
            allowed = np.where(factors > 0, self.torque_share * self.torque_max / factors, np.inf)
        limiting = int(np.argmin(allowed))
        return float(allowed[limiting]), self.machines[limiting]


@dataclass(frozen=True)
class Beyond:
    """A time at which a scenario asks a machine for more than it has at rest.

    Attributes
    ----------
    machine : str
    quantity : {"torque", "speed"}
    at : float
        When the excess is largest (s).
    needed, available : float
        N m or rad/s; what is available is what the governor may use.
    limit : float
        What the machine has without any reserve.
    references : mapping of str to float
        Those that matter, and their values.
    """

    machine: str
    quantity: str
    at: float
    needed: float
    available: float
    limit: float
    references: Mapping[str, float]

    def problem(self) -> Problem:
        """Return what is asked for in words, and what could be done."""
        unit = "N m" if self.quantity == "torque" else "rad/s"
        given = listed(
            [
                f"{name} = {_shown(value, 'N m' if name.endswith('torque_ref') else 'rad/s')}"
                for name, value in self.references.items()
            ]
        )
        needed = _shown(self.needed, unit)
        does = f"needs {needed} at rest" if self.quantity == "torque" else f"turns at {needed}"
        what = (
            f"at {self.at:.4g} s {self.machine} {does} for {given}, "
            f"{_shown(abs(self.needed) - self.available, unit)} more than the {_shown(self.available, unit)} that a "
            f"governor may use of its {_shown(self.limit, unit)}"
        )
        remedy = f"ask for less, or let the governor hold the references back to what {self.machine} has"
        return Problem("references", what, remedy)


def _shown(value: float, unit: str) -> str:
    return f"{from_si(value, 'rad/s', 'rpm'):.5g} rpm" if unit == "rad/s" else f"{value:.4g} {unit}"


def stationary_limits(project: Project, prediction: Prediction, settings: GovernorSettings) -> StationaryLimits:
    """Return the stationary limits of a bed.

    Parameters
    ----------
    project : Project
    prediction : Prediction
    settings : GovernorSettings
    """
    speed = prediction.speeds_at_rest
    drives = [torque.drive for torque in project.model.inputs]
    known = project.model.values

    def of_drives(name: str) -> Array:
        return np.array([float(known[getattr(drive, name)]) for drive in drives])

    kept = {s.name: s.value for s in project.design.controller.block.parameters if s.name.endswith("_damping_reserve")}
    inside = [1 - max(settings.reserve, kept.get(f"{name}_damping_reserve", 0.0)) for name in prediction.machines]
    return StationaryLimits(
        machines=prediction.machines,
        references=prediction.references,
        units=prediction.reference_units,
        torque=prediction.stationary,
        speed=speed,
        torque_max=of_drives("torque_max"),
        speed_rated=of_drives("speed_rated"),
        speed_max=of_drives("speed_max"),
        torque_share=np.array(inside) * (1 - settings.stationary_reserve),
        speed_share=1 - settings.stationary_reserve,
    )


def machine_references(project: Project, scenario: Scenario, times: Array) -> Array:
    """Return the reference of every machine over time (n, m); pairs of speeds are taken apart.

    Parameters
    ----------
    project : Project
    scenario : Scenario
    times : ndarray (n,)
        (s)
    """
    machines = project.design.decoupling.machines
    found = np.zeros((len(times), len(machines)))
    for key, profile in scenario.references.items():
        kind, _, name = key.partition(".")
        values = np.array([value_at(profile, time) for time in times])
        if kind in ("torque", "speed"):
            found[:, machines.index(name)] += values
            continue
        first, second = project.testbed.tuning.speed_pairs[name]
        factor = 1.0 if kind == "speed_mean" else 0.5
        found[:, machines.index(first)] += factor * values
        found[:, machines.index(second)] += values if kind == "speed_mean" else -0.5 * values
    return found


def beyond_at_rest(project: Project, scenario: Scenario, limits: StationaryLimits) -> tuple[Beyond, ...]:
    """Return what a scenario asks for that a machine does not have, the worst time of each machine and quantity.

    Only the points of the profiles are looked at: between them, torques and speeds are between those there, while the
    torque that is available in the range of field weakening bends the other way.
    """
    times = np.array(sorted({t for p in scenario.references.values() for t in p.time if t <= scenario.duration}))
    wanted = machine_references(project, scenario, times)
    speeds, torques = wanted @ limits.speed.T, wanted @ limits.torque.T
    envelope = limits.envelope(speeds)
    found: list[Beyond] = []
    for i, machine in enumerate(limits.machines):
        cases: Sequence[tuple[str, Array, Array, float, Array]] = (
            ("torque", torques[:, i], envelope[:, i], float(limits.torque_share[i]), limits.torque[i]),
            ("speed", speeds[:, i], np.full(len(times), limits.speed_max[i]), limits.speed_share, limits.speed[i]),
        )
        for quantity, needed, limit, share, row in cases:
            over = np.abs(needed) - share * limit
            worst = int(np.argmax(over))
            if over[worst] <= 1e-9 * limit[worst]:
                continue
            given = {limits.references[k]: float(wanted[worst, k]) for k in np.flatnonzero(np.abs(row) > 1e-9)}
            found.append(
                Beyond(
                    machine,
                    quantity,
                    float(times[worst]),
                    float(needed[worst]),
                    float(share * limit[worst]),
                    float(limit[worst]),
                    given,
                )
            )
    return tuple(found)

r"""The differential equation of a bed in one mode, and what ends the mode.

With the elements that stick, :math:`s`, and those that slip, :math:`p`, all torques but friction :math:`F`, and a
basis :math:`N` of the null space of :math:`G_s`,

.. math::
    z = N y, \qquad N'MN\,\dot y = N'(F - G_p' T_p), \qquad G_s' T_s = F - G_p' T_p - M \dot z .

A load is linear in all of these, so that for a given sign of it :math:`T_p` follows from a linear system.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ptgen.errors import Problem, RunError
from ptgen.friction.event_bed import Array, EventBed
from ptgen.friction.holding import ROUNDING, HeldElements

__all__ = ["Actuations", "Inputs", "Mode", "Phase", "Point", "Torques"]

Torques = Callable[[float], Array] | Array
Actuations = Callable[[float], Array] | Mapping[str, Callable[[float], float] | float]

_ABSOLUTE = (1e-13, 1e-16, 1e-13, 1e-12, 1e-12)
"""Absolute tolerances of velocities (rad/s), twists (rad), angles (rad), air-gap torques (N m), measured values."""


@dataclass(frozen=True)
class Inputs:
    """Torques (n_u,) and actuations (n_f,) over time between two breakpoints, asked only in between."""

    torques: Callable[[float], Array]
    actuations: Callable[[float], Array]
    begin: float
    end: float

    @classmethod
    def of(cls, bed: EventBed, torques: Torques, actuations: Actuations | None, begin: float, end: float) -> Inputs:
        """Return the inputs of the time from `begin` to `end`; see `EventDriven.advance`.

        Raises
        ------
        RunError
            If an actuated element has no actuation.
        """
        first, last = float(np.nextafter(begin, np.inf)), float(np.nextafter(end, -np.inf))
        actuated = list(bed.actuated)
        given = actuations if callable(actuations) else _by_name(bed, actuations or {})

        def all_torques(time: float) -> Array:
            at = torques(min(max(time, first), last)) if callable(torques) else torques
            return np.asarray(at, dtype=float)

        def all_actuations(time: float) -> Array:
            mu = np.ones(bed.n_f)
            if actuated:
                mu[actuated] = given(min(max(time, first), last))
            return mu

        return cls(all_torques, all_actuations, begin, end)


def _by_name(bed: EventBed, actuations: Mapping[str, Callable[[float], float] | float]) -> Callable[[float], Array]:
    names = [bed.frictions[i] for i in bed.actuated]
    missing = [name for name in names if name not in actuations]
    if missing:
        remedy = "give it, a number or a function of time"
        raise RunError([Problem(name, "has no actuation", remedy) for name in missing])
    given = [actuations[name] for name in names]
    return lambda time: np.array([value(time) if callable(value) else value for value in given])


@dataclass(frozen=True)
class Mode:
    """What is the same between two events.

    Attributes
    ----------
    slip : tuple of int (n_f,)
        Sense of each friction element, 0 if it sticks.
    load : tuple of int (n_l,)
        Sign of each load.
    beyond : tuple of bool (n_f,)
        Whether the velocity of an element is beyond the knee of its saturated slope.
    region : tuple of int (n_c,)
        Side of its gap on which a contact is, 0 inside.
    """

    slip: tuple[int, ...]
    load: tuple[int, ...]
    beyond: tuple[bool, ...]
    region: tuple[int, ...]


@dataclass(frozen=True)
class Point:
    """Everything at one time.

    Attributes
    ----------
    time : float
    z, e, angles, u, y : ndarray
        Velocities, twists, angles of the friction elements, air-gap torques, measured values behind a low pass.
    w : ndarray (n_f,)
        Friction velocities.
    z_dot : ndarray (n_z,)
        Accelerations.
    torques, contact, loads : ndarray
        Torques of friction elements and contacts, loads.
    lo, hi : ndarray (n_f,)
        Limits of the friction torques at rest.
    """

    time: float
    z: Array
    e: Array
    angles: Array
    u: Array
    y: Array
    w: Array
    z_dot: Array
    torques: Array
    contact: Array
    loads: Array
    lo: Array
    hi: Array


class Phase:
    """The differential equation of one mode, over the state ``(y, e, angles, lagging air-gap torques, low passes)``.

    Parameters
    ----------
    bed : EventBed
    inputs : Inputs
    mode : Mode
    held : HeldElements
        What follows from the elements that stick in `mode`.
    """

    def __init__(self, bed: EventBed, inputs: Inputs, mode: Mode, held: HeldElements) -> None:
        self.bed, self.inputs, self.held = bed, inputs, held
        self.slip = np.array(mode.slip, dtype=np.int64)
        self.signs = np.array(mode.load, dtype=np.int64)
        self.beyond = np.array(mode.beyond, dtype=bool)
        self.region = np.array(mode.region, dtype=np.int64)
        self.sliding, self.stuck = np.flatnonzero(self.slip), np.flatnonzero(self.slip == 0)
        self._ends = np.cumsum([len(held.free), bed.n_e, bed.n_f, len(bed.lagging), len(bed.filtered)])
        self._sense = self.slip[self.sliding].astype(float)
        self._rows = bed.G[self.sliding]
        self._knees = np.flatnonzero(np.isfinite(bed.laws.knee))
        loads = bed.loads
        self._loads_per_torque = loads.a @ held.accelerate + loads.f[:, self.stuck] @ held.react
        self._loads_per_slip = loads.f[:, self.sliding] - self._loads_per_torque @ self._rows.T
        self._loads_per_contact = loads.f[:, bed.n_f :]
        self._in_loop = self._sense * bed.laws.load[self.sliding]
        self._loop_closed = bool(np.any(self._in_loop))

    @property
    def tolerances(self) -> Array:
        """Absolute tolerances of the state."""
        return np.repeat(_ABSOLUTE, np.diff(self._ends, prepend=0))

    def pack(self, z: Array, e: Array, angles: Array, u: Array, y: Array) -> Array:
        """Return the state."""
        return np.concatenate([z[self.held.free], e, angles, u[self.bed.lagging], y])

    def at(self, time: float, state: Array) -> Point:
        """Return everything at a time."""
        bed, laws, held = self.bed, self.bed.laws, self.held
        a, b, c, d, _ = self._ends
        z, e, angles = held.N @ state[:a], state[a:b], state[b:c]
        u = self.inputs.torques(time)
        if len(bed.lagging):
            u = u.copy()
            u[bed.lagging] = state[c:d]
        w = bed.G @ z
        w[self.stuck] = 0.0
        mu, ripple = self.inputs.actuations(time), laws.ripple(angles)
        contact = bed.contact_torques(z, e, self.region)
        applied = bed.applied(z, e, u, contact)
        sliding = self._sense * laws.kinetic(w, mu, ripple, self.beyond)[self.sliding]
        loads = self._loads_at_rest(z, e, u, contact) + self._loads_per_torque @ applied
        if self._loop_closed:
            sliding = self._solve_loop(sliding, (mu * ripple)[self.sliding], loads)
        loads = loads + self._loads_per_slip @ sliding
        driving = applied - sliding @ self._rows
        torques = np.zeros(bed.n_f)
        torques[self.sliding] = sliding
        torques[self.stuck] = held.react @ driving
        lo, hi = laws.limits(mu, ripple, loads)
        z_dot = held.accelerate @ driving
        return Point(time, z, e, angles, u, state[d:], w, z_dot, torques, contact, loads, lo, hi)

    def _loads_at_rest(self, z: Array, e: Array, u: Array, contact: Array) -> Array:
        """Return the loads without friction torques and accelerations."""
        if not len(self.signs):
            return np.zeros(0)
        form = self.bed.loads
        return np.asarray(form.z @ z + form.e @ e + form.u @ u + self._loads_per_contact @ contact, dtype=np.float64)

    def _solve_loop(self, without: Array, scale: Array, loads: Array) -> Array:
        """Return the torques of the slipping elements, which depend on loads that depend on them."""
        of = self.bed.laws.load_of[self.sliding]
        gain = self._in_loop * scale * self.signs[of]
        loop = np.eye(len(without)) - gain[:, None] * self._loads_per_slip[of]
        return np.asarray(np.linalg.solve(loop, without + gain * loads[of]), dtype=np.float64)

    def rates(self, time: float, state: Array) -> Array:
        """Return the right-hand side."""
        bed, point = self.bed, self.at(time, state)
        parts = [point.z_dot[self.held.free], bed.E @ point.z, point.w]
        if len(bed.lagging):
            commands = self.inputs.torques(time)[bed.lagging]
            parts.append(bed.lag_rates[bed.lagging] * (commands - point.u[bed.lagging]))
        if bed.filtered:
            true = bed.filter_forms.values(point.z, point.e, point.u, point.torques, point.contact, point.z_dot)
            parts.append(bed.filter_rates * (true - point.y))
        return np.concatenate(parts)

    def margins(self, point: Point) -> Array:
        """Return what is positive as long as the mode lasts, in the order of `events`."""
        bed, stuck, region = self.bed, self.stuck, self.region
        twist, half = bed.contact_twists @ point.e, bed.gap / 2
        past = np.where(self.beyond[self._knees], 1.0, -1.0)
        upper = np.where(region == 0, half - twist, region * twist - half)
        lower = np.where(region == 0, twist + half, np.inf)
        return np.concatenate(
            [
                self._sense * point.w[self.sliding],
                self.held.margins(point.torques[stuck], point.lo[stuck], point.hi[stuck]),
                self.signs * point.loads,
                past * (np.abs(point.w[self._knees]) - bed.laws.knee[self._knees]),
                np.where(bed.gap > 0, upper, np.inf),
                np.where(bed.gap > 0, lower, np.inf),
            ]
        )

    @cached_property
    def events(self) -> list[tuple[str, int]]:
        """What the margins are about, and the index of the element, the motion, the load or the contact."""
        return [
            *(("velocity", int(i)) for i in self.sliding),
            *(("limit", k) for k in range(len(self.held.cocircuits))),
            *(("load", k) for k in range(len(self.signs))),
            *(("knee", int(i)) for i in self._knees),
            *(("upper gap end", k) for k in range(self.bed.n_c)),
            *(("lower gap end", k) for k in range(self.bed.n_c)),
        ]

    def roundings(self, point: Point) -> Array:
        """Return by how much each margin may be negative."""
        speed = max(1.0, float(np.abs(point.z).max(initial=0.0)))
        parts = (point.torques, point.u, point.contact, point.loads, point.hi[np.isfinite(point.hi)])
        torque = max(1.0, *(float(np.abs(part).max(initial=0.0)) for part in parts))
        sizes = {"velocity": speed, "limit": torque, "load": torque, "knee": speed}
        return ROUNDING * np.array([sizes[kind] if kind in sizes else self._gap(k) for kind, k in self.events])

    def _gap(self, contact: int) -> float:
        return max(float(self.bed.gap[contact]), 1e-3)

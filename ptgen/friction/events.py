r"""Event-driven simulation of a bed: every transition located, nothing smoothed. The reference for all else.

Between events the bed is an ordinary differential equation. Its *mode* says which friction elements stick and in
which sense the others slip, on which side of its gap each shaft with backlash is, which sign each load has, and which
velocities are beyond the knee of a saturated slope. With the rows :math:`G_s` of the elements that stick, the others'
kinetic torques :math:`T_p` and :math:`N` a basis of the null space of :math:`G_s`,

.. math::
    z = N y, \qquad N'MN\,\dot y = N'(F - G_p' T_p), \qquad G_s' T_s = F - G_p' T_p - M \dot z,

:math:`F` being all other torques on the coordinates. So a velocity that sticks is zero exactly and cannot drift. If
rows of :math:`G_s` depend on each other, :math:`T_s` is not unique, and the one with the least :math:`\sum K_{ii}
T_i^2` is taken, :math:`K = G M^{-1} G'`. A load is a linear function of the state, the accelerations and the friction
torques; for a given sign its part in the capacities is linear too, so the algebraic loop between loads and slip
torques is one linear system.

What ends a mode:

* the velocity of a slipping element reaches zero;
* the elements that stick can no longer be held. With independent rows that is a torque at its limit. In general, by
  the principle of virtual power, they can be held if for every virtual motion :math:`d` the power of the torques does
  not exceed what friction can take, :math:`c' T \le \sum_i \max(l_i c_i, h_i c_i)` with :math:`c = G_s d`. It suffices
  to ask the motions in which as many elements as possible stay at rest, the *cocircuits* of the rows: they are the
  normals of the facets of the set of torques that can be held;
* a twist reaches an end of its gap, a load is zero, a velocity passes a knee: there the right-hand side has a kink.

At an event, elements of zero velocity are decided upon at acceleration level. All at rest have their limits at rest;
those whose acceleration is then not zero break away, in that direction, and from then on exert their kinetic torque;
with these fixed the rest is solved again, until no more breaks away. So an element that reaches zero velocity sticks
if the limit at rest can hold it, and otherwise goes on through zero. Should one that broke away turn back under the
kinetic torques of the others, it is held up to its kinetic torque. The box problems are solved by enumeration of their
sectors (`ptgen.friction.sectors`).

The equation is integrated by the Runge-Kutta method of order 8 of Dormand and Prince. Each step is searched for sign
changes on its dense output; the time of an event is the root over the end of one step from the start of that step, so
that its accuracy is that of the integration.

References
----------
Source (3.5), (3.12), (3.34), (3.35), Sections 4.1 and 4.2.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy.integrate
import scipy.optimize

from ptgen.errors import Problem, RunError
from ptgen.friction.event_bed import Array, Booleans, EventBed, Integers
from ptgen.friction.event_phase import Actuations, Inputs, Mode, Phase, Point, Torques
from ptgen.friction.holding import ROUNDING, Contest, HeldElements, at_rest, closed
from ptgen.friction.sectors import enumerate_sectors
from ptgen.mechanism.model import Model

__all__ = ["EventDriven", "EventState", "Transition"]

_RELATIVE = 1e-12
"""Relative tolerance of the integration."""

_SAME_INSTANT = 1e-12
"""Events that are no further apart (s) are one event."""

_CROWD = (1e-9, 60)
"""A span of time (s), and the number of events per element in it that are taken as going on for ever."""

_SAMPLES = np.array([0.25, 0.5, 0.75, 1.0])
"""Where a step is searched for sign changes."""


@dataclass(frozen=True)
class Transition:
    """A change of a friction element between -1, 0 (stuck) and +1, or of a shaft between the sides of its gap."""

    time: float
    element: str
    before: int
    after: int


@dataclass(frozen=True)
class EventState:
    """State of a bed at a time, with all torques just before it.

    Attributes
    ----------
    time : float
        (s)
    x : ndarray (n_z + n_e,)
        Velocities z (rad/s) and twists e (rad). The velocity of an element that sticks is zero.
    angles : ndarray (n_f,)
        Angle by which each friction element has turned (rad).
    mode : ndarray of int (n_f,)
        -1 or +1 for an element that slips, 0 for one that sticks.
    friction_torque : ndarray (n_f,)
        Friction torques (N m), without the viscous part that belongs to the linear part of the bed.
    region : ndarray of int (n_c,)
        0 for a shaft inside its gap, -1 or +1 for one that is beyond it.
    contact_torque : ndarray (n_c + n_w,)
        Torques of the shafts with backlash, then of pump and turbine of each fluid (N m).
    air_gap : ndarray (n_u,)
        Air-gap torques (N m).
    accelerations : ndarray (n_z,)
        dz/dt (rad/s^2).
    transitions : tuple of Transition
        All transitions since the initial state.
    measured : ndarray (n_y,)
        Measured values of the sensors with a low pass, in the order of the model; with lags only.
    """

    time: float
    x: Array
    angles: Array
    mode: Integers
    friction_torque: Array
    region: Integers
    contact_torque: Array
    air_gap: Array
    accelerations: Array
    transitions: tuple[Transition, ...] = ()
    measured: Array = field(default_factory=lambda: np.zeros(0))


class EventDriven:
    """Event-driven simulation of a model.

    Parameters
    ----------
    model : Model
        The full model of a bed.
    parameters : mapping of str to float, optional
        Parameters that override those of the bed, by their names such as ``diff_loss_coulomb``.
    lags : bool
        Whether torques given to `advance` are commands, which the first-order lags of the drives make air-gap torques,
        and sensors have their low passes; otherwise they are the air-gap torques, and sensors are ideal. Delays are
        left to the caller either way.

    Raises
    ------
    RunError
        If a parameter is none of the bed.

    Examples
    --------
    A body of 1 kg m^2 that starts with 1 rad/s on a bearing with 0.5 N m of dry friction::

        simulation = EventDriven(model)
        end = simulation.advance(simulation.initial([1.0]), 3.0, torques=np.zeros(1))
        end.transitions  # (Transition(time=2.0, element='bearing', before=1, after=0),)
    """

    def __init__(self, model: Model, parameters: Mapping[str, float] | None = None, lags: bool = False) -> None:
        self.model = model
        self._bed = EventBed.of(model, parameters or {}, lags)
        self._held: dict[tuple[int, ...], HeldElements] = {}

    def initial(
        self,
        velocities: Sequence[float] | Array | None = None,
        twists: Sequence[float] | Array | None = None,
        angles: Sequence[float] | Array | None = None,
        air_gap: Sequence[float] | Array | None = None,
        time: float = 0.0,
    ) -> EventState:
        """Return a state to start from; what is not given is zero.

        Parameters
        ----------
        velocities : array_like (n_z,)
            z (rad/s). Friction elements whose velocities are zero, to rounding, are at rest.
        twists : array_like (n_e,)
            e (rad).
        angles : array_like (n_f,)
            Angles of the friction elements (rad).
        air_gap : array_like (n_u,)
            Air-gap torques (N m), of use with lags only.
        time : float
            (s)

        Raises
        ------
        RunError
            If a one-way element has a positive velocity.
        """
        bed = self._bed
        z, e = _filled(velocities, bed.n_z), _filled(twists, bed.n_e)
        w = bed.G @ z
        mode = np.where(np.abs(w) <= 1e-14 * (np.abs(bed.G) @ np.abs(z)), 0, np.sign(w)).astype(np.int64)
        wrong = [bed.frictions[i] for i in np.flatnonzero(bed.laws.one_way & (mode > 0))]
        if wrong:
            what = "has a positive velocity at the start, which an element that holds in that direction cannot have"
            raise RunError([Problem(name, what, "start with a velocity that is zero or negative") for name in wrong])
        return EventState(
            time=time,
            x=np.concatenate([z, e]),
            angles=_filled(angles, bed.n_f),
            mode=mode,
            friction_torque=np.zeros(bed.n_f),
            region=bed.regions(z, e),
            contact_torque=np.zeros(len(bed.H)),
            air_gap=_filled(air_gap, bed.n_u),
            accelerations=np.zeros(bed.n_z),
            measured=np.zeros(len(bed.filtered)),
        )

    def advance(
        self,
        state: EventState,
        until: float,
        torques: Torques,
        actuations: Actuations | None = None,
        breakpoints: Sequence[float] = (),
        longest_step: float = 2e-3,
    ) -> EventState:
        """Return the state at a later time.

        Parameters
        ----------
        state : EventState
        until : float
            (s)
        torques : callable or ndarray (n_u,)
            Air-gap torques over time, or commands if the drives lag (N m); an array is held.
        actuations : callable or mapping
            Actuations of the actuated elements over time, as an array in their order, or each by its name.
        breakpoints : sequence of float
            Times at which torques or actuations jump or have a kink (s). A function that jumps may have either value at
            the breakpoint; it is never asked there.
        longest_step : float
            Longest step of the integration (s), of which every quarter is looked at: nothing that makes an event should
            come and go within one.

        Raises
        ------
        RunError
            If events go on for ever within one instant, if loads and friction torques have no common solution, or if
            an actuated element has no actuation.
        """
        inside = sorted({point for point in breakpoints if state.time < point < until})
        for begin, end in itertools.pairwise([state.time, *inside, until]):
            if end > begin:
                inputs = Inputs.of(self._bed, torques, actuations, begin, end)
                state = _Piece(self._bed, self._held, inputs, longest_step).run(state)
        return state

    def friction_velocities(self, state: EventState) -> Array:
        """Return the velocities of the friction elements (n_f,), exactly zero for those that stick (rad/s)."""
        return np.where(state.mode == 0, 0.0, self._bed.G @ state.x[: self._bed.n_z]) + 0.0

    def signals(self, state: EventState) -> dict[str, float]:
        """Return every signal of the model, and the whole torque of every friction element under its name.

        The whole torque includes the viscous part that belongs to the linear part of the bed.
        """
        bed = self._bed
        z, e = state.x[: bed.n_z], state.x[bed.n_z :]
        values = bed.signals.values(
            z, e, state.air_gap, state.friction_torque, state.contact_torque, state.accelerations
        )
        named = dict(zip(self.model.signals, values.tolist(), strict=True))
        whole = state.friction_torque + bed.viscous * self.friction_velocities(state)
        return named | dict(zip(bed.frictions, whole.tolist(), strict=True))

    def measured(self, state: EventState) -> dict[str, float]:
        """Return the measured values of the sensors with a low pass, by name; none without lags."""
        return dict(zip(self._bed.filtered, state.measured.tolist(), strict=True))

    def energy(self, state: EventState) -> float:
        """Return kinetic energy and energy of all shafts (J)."""
        bed = self._bed
        z, e = state.x[: bed.n_z], state.x[bed.n_z :]
        beyond = np.where(state.region == 0, 0.0, bed.contact_twists @ e - 0.5 * state.region * bed.gap)
        return 0.5 * float(z @ bed.M @ z + e @ bed.C @ e + beyond @ (bed.contact_stiffness * beyond))


def _filled(values: Sequence[float] | Array | None, size: int) -> Array:
    array = np.zeros(size) if values is None else np.array(values, dtype=float)
    if array.shape != (size,):
        raise ValueError(f"{size} values are wanted, got an array of shape {array.shape}")
    return array


@dataclass(frozen=True)
class _Event:
    """An event in a step: the margin that ends the mode, and a bracket of the time."""

    margin: int
    before: float
    after: float


@dataclass(frozen=True)
class _Decision:
    """What is known after an event.

    `slip` is 0 for elements of zero velocity, `forced` are those among them that break away because of the event.
    """

    slip: Integers
    forced: dict[int, int]
    load: Integers
    beyond: Booleans
    region: Integers


class _Piece:
    """The motion between two breakpoints."""

    def __init__(
        self, bed: EventBed, held: dict[tuple[int, ...], HeldElements], inputs: Inputs, longest_step: float
    ) -> None:
        self.bed, self.held, self.inputs, self.longest_step = bed, held, inputs, longest_step
        self.crowd: list[float] = []

    def run(self, state: EventState) -> EventState:
        """Return the state at the end of the piece."""
        bed, time, angles = self.bed, state.time, state.angles
        z, e = state.x[: bed.n_z], state.x[bed.n_z :]
        u = self.inputs.torques(time).copy()
        u[bed.lagging] = state.air_gap[bed.lagging]
        y, w = state.measured, bed.G @ z
        rest = (state.mode == 0) | (w == 0)
        load = np.ones(len(bed.loads.z), dtype=np.int64)
        start = _Decision(np.where(rest, 0, state.mode), {}, load, np.abs(w) > bed.laws.knee, state.region)
        mode, z = self._decide(time, z, e, angles, u, start)
        transitions = [*state.transitions, *self._changes(time, state.mode, state.region, mode)]
        while True:
            phase = self._phase(mode)
            time, packed, events = self._integrate(phase, time, phase.pack(z, e, angles, u, y))
            point = phase.at(time, packed)
            if not events:
                break
            z, e, angles, u, y = point.z, point.e, point.angles, point.u, point.y
            self._count(time, phase, events)
            mode, z = self._decide(time, z, e, angles, u, self._decision(phase, events))
            transitions += self._changes(time, phase.slip, phase.region, mode)
        return EventState(
            time=self.inputs.end,
            x=np.concatenate([point.z, point.e]),
            angles=point.angles,
            mode=phase.slip,
            friction_torque=self._reported(phase, point),
            region=phase.region,
            contact_torque=point.contact,
            air_gap=point.u,
            accelerations=point.z_dot,
            transitions=tuple(transitions),
            measured=point.y,
        )

    def _phase(self, mode: Mode) -> Phase:
        stuck = tuple(i for i, sense in enumerate(mode.slip) if sense == 0)
        if stuck not in self.held:
            self.held[stuck] = HeldElements.of(self.bed, stuck)
        return Phase(self.bed, self.inputs, mode, self.held[stuck])

    def _reported(self, phase: Phase, point: Point) -> Array:
        """Return the friction torques; where they are not unique, the least ones within their limits."""
        torques, stuck = point.torques.copy(), phase.stuck
        if phase.held.dependent:
            K = self.bed.K[np.ix_(stuck, stuck)]
            torques[stuck] = enumerate_sectors(K, K @ torques[stuck], point.lo[stuck], point.hi[stuck]).torques
        return torques

    def _changes(self, time: float, slip: Integers, region: Integers, after: Mode) -> list[Transition]:
        names = (*self.bed.frictions, *self.bed.contacts)
        pairs = zip(names, (*slip.tolist(), *region.tolist()), (*after.slip, *after.region), strict=True)
        return [Transition(time, name, old, new) for name, old, new in pairs if old != new]

    def _count(self, time: float, phase: Phase, events: list[int]) -> None:
        """Raise if events go on for ever."""
        span, each = _CROWD
        self.crowd = [earlier for earlier in self.crowd if earlier > time - span] + [time]
        if len(self.crowd) > each * (self.bed.n_f + self.bed.n_c + 1):
            last = ", ".join(f"{kind} of no. {k}" for kind, k in (phase.events[event] for event in events))
            names = ", ".join((*self.bed.frictions, *self.bed.contacts))
            what = (
                f"made {len(self.crowd)} events within {1e9 * span:.0f} ns at t = {time:.12g} s, the last was: {last}"
            )
            raise RunError(Problem(names, what, "look for limits that fall as soon as they are needed"))

    def _solver(self, phase: Phase, time: float, state: Array, until: float, whole: bool) -> Any:
        """Return the integrator; `whole` makes it try the time until then in one step."""
        first = until - time if whole else None
        longest = np.inf if whole else self.longest_step
        tolerances: Any = phase.tolerances
        rates: Any = phase.rates
        return scipy.integrate.DOP853(
            rates, time, state, until, rtol=_RELATIVE, atol=tolerances, first_step=first, max_step=longest
        )

    def _integrate(self, phase: Phase, time: float, state: Array) -> tuple[float, Array, list[int]]:
        """Return time and state at the next event or at the end of the piece, and the margins that became zero."""
        end = self.inputs.end
        if time >= end:
            return end, state, []
        solver = self._solver(phase, time, state, end, whole=False)
        margins = [phase.margins(phase.at(time, state))]
        while solver.status == "running":
            begin, begin_state = float(solver.t), solver.y.copy()
            message = solver.step()
            if solver.status == "failed":
                what = f"could not be integrated beyond t = {begin:.12g} s: {message}"
                raise RunError(Problem("plant", what, "look for a time constant that is out of all proportion"))
            dense = solver.dense_output()
            times = [begin, *(begin + _SAMPLES * (solver.t - begin)).tolist()]
            points = [phase.at(t, dense(t)) for t in times[1:-1]] + [phase.at(solver.t, solver.y)]
            margins = [margins[-1], *(phase.margins(point) for point in points)]
            found = self._search(phase, times, np.vstack(margins), phase.roundings(points[-1]), dense)
            if found:
                return self._locate(phase, begin, begin_state, found)
        return end, solver.y, []

    def _search(
        self, phase: Phase, times: list[float], margins: Array, rounding: Array, dense: Callable[[float], Array]
    ) -> list[_Event]:
        """Return the events of a step, each with a bracket in time.

        A margin that is negative from the start of a mode on, without having been positive, ends the mode where it
        began: what was decided there was undecided to rounding.
        """
        found = []
        for k in np.flatnonzero((margins < -rounding).any(axis=0)).tolist():
            values = margins[:, k]
            after = int(np.argmax(values < -rounding[k]))
            positive = np.flatnonzero(values[:after] > 0)
            before = int(positive[-1]) if len(positive) else 0
            found.append(_Event(k, times[before], times[after if len(positive) else 0]))
        for k, mid in self._dips(margins):

            def margin(time: float, k: int = k) -> float:
                return float(phase.margins(phase.at(time, dense(time)))[k])

            around = (times[mid - 1], times[mid + 1])
            result = scipy.optimize.minimize_scalar(margin, bounds=around, method="bounded")
            if result.fun < -rounding[k]:
                found.append(_Event(k, times[mid - 1], float(result.x)))
        return found

    @staticmethod
    def _dips(margins: Array) -> list[tuple[int, int]]:
        """Return the positive margins whose parabola through three samples becomes negative between them."""
        left, middle, right = margins[:-2], margins[1:-1], margins[2:]
        candidates = (middle > 0) & (middle < left) & (middle <= right) & np.isfinite(left) & np.isfinite(right)
        with np.errstate(invalid="ignore", divide="ignore"):
            lowest = middle - (right - left) ** 2 / (8 * (left - 2 * middle + right))
        rows, columns = np.nonzero(candidates & (lowest < 0))
        return [(int(k), int(row) + 1) for row, k in zip(rows, columns, strict=True) if margins[:, k].min() > 0]

    def _locate(self, phase: Phase, begin: float, state: Array, events: list[_Event]) -> tuple[float, Array, list[int]]:
        """Return time and state of the first event of a step, and all margins that became zero there."""
        reached: dict[float, Array] = {begin: state}

        def flow(time: float) -> Array:
            if time not in reached:
                solver = self._solver(phase, begin, state, time, whole=True)
                while solver.status == "running":
                    solver.step()
                reached[time] = solver.y
            return reached[time]

        roots: dict[int, float] = {}
        for event in sorted(events, key=lambda event: event.before):
            if not roots or event.before <= min(roots.values()) + _SAME_INSTANT:

                def margin(time: float, k: int = event.margin) -> float:
                    return float(phase.margins(phase.at(time, flow(time)))[k])

                roots[event.margin] = _root(margin, event.before, event.after)
        first = min(roots.values())
        return first, flow(first), [k for k, time in roots.items() if time <= first + _SAME_INSTANT]

    def _decision(self, phase: Phase, events: list[int]) -> _Decision:
        """Return what is to be decided after the margins `events` became zero."""
        slip, region, load, beyond = phase.slip.copy(), phase.region.copy(), phase.signs.copy(), phase.beyond.copy()
        forced: dict[int, int] = {}
        for event in events:
            kind, k = phase.events[event]
            if kind == "velocity":
                slip[k] = 0
            elif kind == "limit":
                motion = np.sign(phase.held.cocircuits[k]).astype(int)
                forced |= {i: sense for i, sense in zip(phase.stuck.tolist(), motion.tolist(), strict=True) if sense}
            elif kind == "load":
                load[k] = -load[k]
            elif kind == "knee":
                beyond[k] = not beyond[k]
            elif region[k]:
                region[k] = 0
            else:
                region[k] = 1 if kind == "upper gap end" else -1
        return _Decision(slip, forced, load, beyond, region)

    def _decide(
        self, time: float, z: Array, e: Array, angles: Array, u: Array, decision: _Decision
    ) -> tuple[Mode, Array]:
        """Return the mode after an event, and the velocities with those at rest exactly zero."""
        bed = self.bed
        rest = closed(bed.G, decision.slip == 0)
        z = at_rest(bed, z, rest)
        mu, ripple = self.inputs.actuations(time), bed.laws.ripple(angles)
        contact = bed.contact_torques(z, e, decision.region)
        w = np.where(rest, 0.0, bed.G @ z)
        contest = Contest(
            bed=bed,
            time=time,
            applied=bed.applied(z, e, u, contact),
            loads=bed.loads.z @ z + bed.loads.e @ e + bed.loads.u @ u + bed.loads.f[:, bed.n_f :] @ contact,
            kinetic=bed.laws.kinetic(w, mu, ripple, decision.beyond),
            mu=mu,
            ripple=ripple,
            slip=np.where(rest, 0, decision.slip),
        )
        slip, loads, scale = contest.settle(decision.forced)
        load = np.where(np.abs(loads) > ROUNDING * scale, np.sign(loads), decision.load).astype(int)
        beyond = decision.beyond.tolist()
        return Mode(tuple(slip.tolist()), tuple(load.tolist()), tuple(beyond), tuple(decision.region.tolist())), z


def _root(margin: Callable[[float], float], before: float, after: float) -> float:
    """Return where a margin becomes zero; an end of the bracket, if rounding has moved it outside."""
    if after <= before or margin(before) <= 0:
        return before
    if margin(after) >= 0:
        return after
    return float(scipy.optimize.brentq(margin, before, after, xtol=1e-16, rtol=1e-15))

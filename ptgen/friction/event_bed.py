"""The numbers of a bed and its laws of friction, for the event-driven reference.

The laws are those of `ptgen.elements.Friction`. They are written down here once more, element by element as arrays,
and not shared with the plant, so that the reference does not repeat its mistakes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.elements import Friction
from ptgen.errors import Problem, RunError, nearest
from ptgen.friction.event_fluid import EventFluid
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix

__all__ = ["Array", "Booleans", "EventBed", "Forms", "FrictionLaws", "Integers"]

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]


@dataclass(frozen=True)
class Forms:
    """Linear forms as the rows of matrices."""

    z: Array
    e: Array
    u: Array
    f: Array
    a: Array

    @classmethod
    def of(cls, model: Model, forms: Sequence[LinearForm], table: Mapping[sp.Symbol, float]) -> Forms:
        """Return the numbers of forms of a model at values of its parameters."""
        n_f = len(model.frictions) + len(model.contacts) + 2 * len(model.fluids)
        widths = (len(model.coordinates), len(model.twists), len(model.inputs), n_f, len(model.coordinates))
        parts = []
        for name, width in zip(("z", "e", "u", "f", "a"), widths, strict=True):
            rows = [evaluate_matrix(getattr(form, name), table) for form in forms]
            parts.append(np.vstack(rows) if rows else np.zeros((0, width)))
        return cls(*parts)

    def values(self, z: Array, e: Array, u: Array, friction: Array, contact: Array, z_dot: Array) -> Array:
        """Return the values of the forms."""
        torques = np.concatenate([friction, contact])
        total = self.z @ z + self.e @ e + self.u @ u + self.f @ torques + self.a @ z_dot
        return np.asarray(total, dtype=np.float64)


class _Numbers:
    """Evaluates expressions of parameters."""

    def __init__(self, table: Mapping[sp.Symbol, float]) -> None:
        self._table = table

    def one(self, expression: sp.Expr | None, missing: float = 0.0) -> float:
        if expression is None:
            return missing
        return float(evaluate_matrix(sp.Matrix([[expression]]), self._table)[0, 0])

    def all(self, expressions: Iterable[sp.Expr | None], missing: float = 0.0) -> Array:
        return np.array([self.one(expression, missing) for expression in expressions])


@dataclass(frozen=True)
class FrictionLaws:
    """The laws of all friction elements, each number as an array over the elements (n_f,).

    Attributes
    ----------
    coulomb, static, viscous : ndarray
        Kinetic capacity, capacity at rest (N m), and the viscous friction of actuated elements (N m s/rad).
    stribeck_speed : ndarray
        (rad/s), infinite if the capacity falls from `static` to `coulomb` at once.
    falling : ndarray
        The part of the capacity that falls with the speed over `stribeck_speed` (N m).
    slope, knee : ndarray
        Saturated slope (N m s/rad) and the speed where it ends (rad/s), infinite if there is none.
    amplitude, order, phase : ndarray
        Ripple.
    load : ndarray
        Capacity per load.
    load_of : ndarray of int
        Which load; that of an element without any does not matter, because its `load` is zero.
    one_way : ndarray of bool
    """

    coulomb: Array
    static: Array
    viscous: Array
    stribeck_speed: Array
    falling: Array
    slope: Array
    knee: Array
    amplitude: Array
    order: Array
    phase: Array
    load: Array
    load_of: Integers
    one_way: Booleans

    @classmethod
    def of(cls, frictions: Sequence[Friction], places: Sequence[str], numbers: _Numbers) -> FrictionLaws:
        """Return the laws; `places` are the names of the loads."""
        coulomb, static = numbers.all(f.coulomb for f in frictions), numbers.all(f.at_rest for f in frictions)
        stribeck_speed = numbers.all((f.stribeck_speed for f in frictions), np.inf)
        ripples = [f.ripple for f in frictions]
        return cls(
            coulomb=coulomb,
            static=static,
            viscous=numbers.all(f.viscous if f.actuated else None for f in frictions),
            stribeck_speed=stribeck_speed,
            falling=np.where(np.isfinite(stribeck_speed), static - coulomb, 0.0),
            slope=numbers.all(None if f.saturated is None else f.saturated.slope for f in frictions),
            knee=numbers.all((None if f.saturated is None else f.saturated.speed for f in frictions), np.inf),
            amplitude=numbers.all(None if ripple is None else ripple.amplitude for ripple in ripples),
            order=np.array([0.0 if ripple is None else float(ripple.order) for ripple in ripples]),
            phase=numbers.all(None if ripple is None else ripple.phase for ripple in ripples),
            load=numbers.all(None if f.load is None else f.load.coefficient for f in frictions),
            load_of=np.array([0 if f.load is None else places.index(f.load.place) for f in frictions], dtype=np.int64),
            one_way=np.array([f.one_way for f in frictions], dtype=bool),
        )

    @cached_property
    def _ripples(self) -> bool:
        return bool(np.any(self.amplitude))

    @cached_property
    def _falls(self) -> bool:
        return bool(np.any(self.falling))

    @cached_property
    def _grows(self) -> bool:
        return bool(np.any(self.slope) or np.any(self.viscous))

    def ripple(self, angles: Array) -> Array:
        """Return the factors that depend on the angles of the elements."""
        if not self._ripples:
            return np.ones(len(angles))
        return 1.0 + self.amplitude * np.sin(self.order * angles + self.phase)

    def kinetic(self, w: Array, mu: Array, ripple: Array, beyond: Booleans) -> Array:
        """Return the kinetic capacities without load; `beyond` tells whose velocity is beyond the knee."""
        speed = np.abs(w)
        dry = self.coulomb + self.falling * np.exp(-speed / self.stribeck_speed) if self._falls else self.coulomb
        if not self._grows:
            return mu * ripple * dry
        knee = np.where(beyond, self.knee, 0.0)
        return mu * (ripple * dry + self.slope * np.where(beyond, knee, speed) + self.viscous * speed)

    def by_load(self, mu: Array, ripple: Array, loads: Array) -> Array:
        """Return what the loads add to the capacities, kinetic and at rest."""
        return mu * ripple * self.load * np.abs(loads)[self.load_of] if len(loads) else np.zeros(len(self.load))

    def limits(self, mu: Array, ripple: Array, loads: Array) -> tuple[Array, Array]:
        """Return the limits at rest."""
        limit = mu * ripple * self.static + self.by_load(mu, ripple, loads)
        return -limit, np.where(self.one_way, np.inf, limit)


@dataclass(frozen=True)
class EventBed:
    """All numbers of a bed, with the names of `ptgen.mechanism.model`.

    Attributes
    ----------
    frictions, contacts : tuple of str
        Their names.
    actuated : tuple of int
        The elements with an actuation.
    M, C, E, G, H, B : ndarray
        Inertia, stiffness, rows of twists, friction, contacts and inputs. The rows ``H`` of contacts are followed by
        those of fluids, whose torques stand behind theirs everywhere.
    Fz, Fe : ndarray (n_z, n_z), (n_z, n_e)
        Torques on the coordinates per velocity and per twist.
    K : ndarray (n_f, n_f)
        ``G M^-1 G'``.
    viscous : ndarray (n_f,)
        Viscous friction that is part of `Fz` (N m s/rad).
    contact_twists : ndarray (n_c, n_e)
    gap, contact_stiffness, contact_damping : ndarray (n_c,)
    fluids : tuple of EventFluid
    signals, loads : Forms
        All signals of the model, and those that capacities depend on.
    laws : FrictionLaws
    lag_rates : ndarray (n_u,)
        Inverse time constants of the air-gap torques that are states (1/s), zero for those that are given.
    filtered : tuple of str (n_y,)
        Sensors with a low pass, whose measured values are states.
    filter_forms : Forms
        What they measure.
    filter_rates : ndarray (n_y,)
        Inverse time constants of the low passes (1/s).
    """

    frictions: tuple[str, ...]
    contacts: tuple[str, ...]
    actuated: tuple[int, ...]
    M: Array
    C: Array
    E: Array
    G: Array
    H: Array
    B: Array
    Fz: Array
    Fe: Array
    K: Array
    viscous: Array
    contact_twists: Array
    gap: Array
    contact_stiffness: Array
    contact_damping: Array
    signals: Forms
    loads: Forms
    laws: FrictionLaws
    lag_rates: Array
    filtered: tuple[str, ...]
    filter_forms: Forms
    filter_rates: Array
    fluids: tuple[EventFluid, ...] = ()

    @classmethod
    def of(cls, model: Model, parameters: Mapping[str, float], lags: bool) -> EventBed:
        """Return the numbers of a model.

        Parameters
        ----------
        model : Model
        parameters : mapping of str to float
            Parameters that override those of the bed.
        lags : bool
            Whether the air-gap torques of drives with a lag, and the measured values of sensors with a low pass, are
            states.

        Raises
        ------
        RunError
            If a parameter is none of the bed.
        """
        table = _values(model, parameters)
        numbers = _Numbers(table)
        frictions, contacts = model.frictions, model.contacts
        numeric = model.numeric(table)
        M, E, G = numeric.mass, numeric.twist_rows, numeric.friction_rows
        places = list(dict.fromkeys(f.load.place for f in frictions if f.load is not None))
        sensors = [sensor for sensor in model.sensors if lags and sensor.time_constant is not None]
        time_constants = numbers.all((torque.drive.time_constant for torque in model.inputs), np.inf)
        return cls(
            frictions=tuple(friction.name for friction in frictions),
            contacts=tuple(contact.name for contact in contacts),
            actuated=tuple(i for i, f in enumerate(frictions) if f.actuated),
            M=M,
            C=numeric.stiffness,
            E=E,
            G=G,
            H=np.vstack([numeric.contact_rows, numeric.fluid_rows]),
            B=numeric.input_rows,
            Fz=-E.T @ numeric.damping @ E - G.T @ numeric.viscous @ G,
            Fe=-E.T @ numeric.stiffness,
            K=G @ np.linalg.solve(M, G.T),
            viscous=numbers.all(f.linear_viscous for f in frictions),
            contact_twists=evaluate_matrix(model.contact_twists, table) if contacts else np.zeros((0, len(E))),
            gap=numbers.all(contact.backlash for contact in contacts),
            contact_stiffness=numbers.all(contact.stiffness for contact in contacts),
            contact_damping=numbers.all(contact.damping for contact in contacts),
            signals=Forms.of(model, list(model.signals.values()), table),
            loads=Forms.of(model, [model.signals[place] for place in places], table),
            laws=FrictionLaws.of(frictions, places, numbers),
            lag_rates=1 / time_constants if lags else np.zeros(len(time_constants)),
            filtered=tuple(sensor.name for sensor in sensors),
            filter_forms=Forms.of(model, [model.signals[sensor.name] for sensor in sensors], table),
            filter_rates=1 / numbers.all(sensor.time_constant for sensor in sensors),
            fluids=tuple(EventFluid(fluid, numbers.one(fluid.reference_speed)) for fluid in model.fluids),
        )

    @property
    def n_z(self) -> int:
        """Number of velocities."""
        return len(self.M)

    @property
    def n_e(self) -> int:
        """Number of twists."""
        return len(self.E)

    @property
    def n_u(self) -> int:
        """Number of air-gap torques."""
        return len(self.B)

    @property
    def n_f(self) -> int:
        """Number of friction elements."""
        return len(self.G)

    @property
    def n_c(self) -> int:
        """Number of shafts with backlash."""
        return len(self.gap)

    @cached_property
    def lagging(self) -> Integers:
        """Machines whose air-gap torque is a state."""
        return np.flatnonzero(self.lag_rates)

    def regions(self, z: Array, e: Array) -> Integers:
        """Return on which side of its gap each contact is; at an end of the gap its motion decides."""
        twist, rate, half = self.contact_twists @ e, self.H[: self.n_c] @ z, self.gap / 2
        above = (twist > half) | ((twist == half) & (rate > 0)) | (self.gap == 0)
        below = (twist < -half) | ((twist == -half) & (rate < 0))
        return np.where(above, 1, np.where(below, -1, 0)).astype(np.int64)

    def contact_torques(self, z: Array, e: Array, region: Integers) -> Array:
        """Return the torques of the contacts, (3.5), and those of the fluids behind them."""
        fluids = np.zeros(0)
        if self.fluids:
            speeds = (self.H[self.n_c :] @ z).reshape(-1, 2)
            fluids = np.concatenate([fluid.torques(a, -b) for fluid, (a, b) in zip(self.fluids, speeds, strict=True)])
        if not len(region):
            return fluids
        beyond = self.contact_twists @ e - 0.5 * region * self.gap
        rate = self.H[: self.n_c] @ z
        contacts = np.where(region == 0, 0.0, self.contact_stiffness * beyond + self.contact_damping * rate)
        return np.concatenate([contacts, fluids])

    def applied(self, z: Array, e: Array, u: Array, contact: Array) -> Array:
        """Return all torques on the coordinates but those of friction."""
        total = self.Fz @ z + self.Fe @ e + self.B.T @ u
        return total - self.H.T @ contact if len(contact) else total


def _values(model: Model, parameters: Mapping[str, float]) -> dict[sp.Symbol, float]:
    symbols = {symbol.name: symbol for symbol in model.values}
    unknown = [name for name in parameters if name not in symbols]
    if unknown:
        raise RunError([Problem(name, "is no parameter of this bed", nearest(name, symbols)) for name in unknown])
    return {**model.values, **{symbols[name]: value for name, value in parameters.items()}}

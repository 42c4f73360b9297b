"""Friction problems with known transitions, as models: for the event-driven reference and all that is compared with it.

Each problem is small enough to be followed by hand, and named after what makes it hard. The models are built from
elements directly: bodies on velocities of their own names, friction elements, shafts and air-gap torques on rows of
these. Inertias and capacities are parameters, named as in a test bed file, ``<component>_<field>``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np
import sympy as sp

from ptgen.elements import (
    Body,
    Constraint,
    Drive,
    Friction,
    FrictionRole,
    Load,
    Parameter,
    Ripple,
    Row,
    Saturation,
    Spring,
    Torque,
)
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model
from ptgen.project import Project

__all__ = ["PROBLEMS", "Bench", "Problem", "at_velocities"]

Drives = Callable[[float], np.ndarray]
Actuations = Mapping[str, Callable[[float], float]]


@dataclass(frozen=True)
class Problem:
    """A model, where it starts and what acts on it.

    Attributes
    ----------
    name : str
    model : Model
    initial : ndarray (n_z,)
        Velocities at the start (rad/s); twists are zero.
    torques : callable
        Air-gap torques over time (N m), in the order of ``model.inputs``.
    actuations : mapping of str to callable
        Actuation over time of each actuated friction element.
    breakpoints : tuple of float
        Times at which a torque or an actuation jumps or has a kink (s).
    duration : float
        (s)
    transitions : tuple of (float, str, int, int)
        Those known in closed form: time, element, mode before and after, in order of time.
    """

    name: str
    model: Model
    initial: np.ndarray
    torques: Drives
    actuations: Actuations = field(default_factory=dict)
    breakpoints: tuple[float, ...] = ()
    duration: float = 1.0
    transitions: tuple[tuple[float, str, int, int], ...] = ()


class Bench:
    """Collects elements and makes a model of them.

    Parameters
    ----------
    name : str
    inertias : mapping of str to float
        Velocities that carry an inertia (kg m^2).
    """

    def __init__(self, name: str, inertias: Mapping[str, float]) -> None:
        self.name = name
        self._parameters: list[Parameter] = []
        self._velocities = list(inertias)
        self._bodies = [
            Body(body, self.parameter(f"{body}_inertia", "kg m^2", value)) for body, value in inertias.items()
        ]
        self._frictions: list[Friction] = []
        self._springs: list[Spring] = []
        self._torques: list[Torque] = []
        self._constraints: list[Constraint] = []
        self._connections: dict[str, tuple[str, int]] = {}

    def parameter(self, name: str, unit: str, value: float) -> sp.Symbol:
        symbol = sp.Symbol(name, real=True)
        self._parameters.append(Parameter(symbol, value, unit, name.replace("_", " "), signed=True))
        return symbol

    def machine(self, velocity: str, time_constant: float | None = None) -> Bench:
        """Add an air-gap torque on a velocity; its envelope is wider than any problem asks."""
        wide = sp.Integer(10) ** 6
        lag = None
        if time_constant is not None:
            lag = self.parameter(f"{velocity}_inverter_time_constant", "s", time_constant)
        self._torques.append(Torque(velocity, {velocity: sp.Integer(1)}, Drive(wide, wide, wide, lag)))
        return self

    def friction(
        self,
        name: str,
        row: Mapping[str, float],
        coulomb: float,
        static: float | None = None,
        viscous: float = 0.0,
        stribeck_speed: float | None = None,
        load: tuple[float, str] | None = None,
        saturated: tuple[float, float] | None = None,
        ripple: tuple[float, int, float] | None = None,
        actuated: bool = False,
        one_way: bool = False,
    ) -> Bench:
        """Add a friction element on ``row . velocities``."""

        def number(part: str, unit: str, value: float) -> sp.Symbol:
            return self.parameter(f"{name}_{part}", unit, value)

        self._frictions.append(
            Friction(
                name=name,
                row=_row(row),
                coulomb=number("coulomb", "N m", coulomb),
                viscous=number("viscous", "N m s/rad", viscous),
                role=FrictionRole.COUPLING,
                load=None if load is None else Load(number("load", "", load[0]), load[1]),
                static=None if static is None else number("static", "N m", static),
                stribeck_speed=None if stribeck_speed is None else number("stribeck_speed", "rad/s", stribeck_speed),
                saturated=None
                if saturated is None
                else Saturation(number("slope", "N m s/rad", saturated[0]), number("knee", "rad/s", saturated[1])),
                ripple=None
                if ripple is None
                else Ripple(number("ripple", "", ripple[0]), ripple[1], number("phase", "rad", ripple[2])),
                actuated=actuated,
                one_way=one_way,
            )
        )
        return self

    def shaft(
        self, name: str, row: Mapping[str, float], stiffness: float, damping: float = 0.0, backlash: float | None = None
    ) -> Bench:
        """Add a shaft whose twist rate is ``row . velocities``; its torque can be a load."""
        gap = None if backlash is None else self.parameter(f"{name}_backlash", "rad", backlash)
        self._springs.append(
            Spring(
                name,
                _row(row),
                self.parameter(f"{name}_stiffness", "N m/rad", stiffness),
                self.parameter(f"{name}_damping", "N m s/rad", damping),
                gap,
            )
        )
        return self

    def rigid(self, name: str, left: str, right: str) -> Bench:
        """Connect two velocities rigidly; the torque across the connection can be a load, named ``name.left``."""
        self._velocities += [f"{name}.left", f"{name}.right"]
        for owner, a, b in ((f"{name} a", left, f"{name}.left"), (f"{name} b", f"{name}.right", right)):
            self._constraints.append(Constraint(owner, _row({a: 1, b: -1})))
        owner = f"{name}.left - {name}.right"
        self._constraints.append(Constraint(owner, _row({f"{name}.left": 1, f"{name}.right": -1})))
        self._connections |= {f"{name}.left": (owner, +1), f"{name}.right": (owner, -1)}
        return self

    def model(self) -> Model:
        """Return the model, friction velocities first."""
        loads = [friction.load.place for friction in self._frictions if friction.load is not None]
        return assemble(
            Mechanism(
                name=self.name,
                velocities=tuple(self._velocities),
                bodies=tuple(self._bodies),
                constraints=tuple(self._constraints),
                springs=tuple(self._springs),
                frictions=tuple(self._frictions),
                torques=tuple(self._torques),
                sensors=(),
                places=(),
                parameters=tuple(self._parameters),
                connections=self._connections,
                orientation={spring.name: 1 for spring in self._springs},
                observed=tuple(dict.fromkeys(loads)),
            )
        )


def _row(row: Mapping[str, float]) -> Row:
    return {velocity: sp.Rational(str(value)) for velocity, value in row.items()}


def at_velocities(model: Model, velocities: Mapping[str, float]) -> np.ndarray:
    """Return the coordinates z at which velocities of the bed have the given values (rad/s)."""
    rows = sp.Matrix.vstack(*[model.velocity_rows[name] for name in velocities]).subs(model.values)
    matrix = np.array(rows.evalf(), dtype=float)
    wanted = np.array(list(velocities.values()))
    z = np.linalg.lstsq(matrix, wanted, rcond=None)[0]
    assert np.linalg.matrix_rank(matrix) == len(z) and np.allclose(matrix @ z, wanted)
    return np.where(np.abs(z) < 1e-12, 0.0, z)


def _ramps(times: Sequence[float], *values: Sequence[float]) -> Drives:
    return lambda t: np.array([np.interp(t, times, each) for each in values])


def scalar() -> Problem:
    """Return (4.14), ``dx/dt = u - T(x)`` with 1 N m of friction.

    As in Figure 4.3 it sticks at 1.3 s and at 3.5 s, and breaks away at 2 s: x is 1.25 at 0.5 s and falls with 1.5625;
    u is 1 at 2 s, so that x = 1.5625 (t - 2)^2 until 2.5 s, and then falls with 0.390625 from 0.390625.
    """

    def u(t: float) -> np.ndarray:
        if t < 0.5:
            return np.array([1.5])
        if t < 1.5:
            return np.array([-0.5625])
        return np.array([-0.5625 + 3.125 * (t - 1.5) if t < 2.5 else 0.609375])

    model = Bench("scalar", {"J": 1.0}).machine("J").friction("bearing", {"J": 1}, coulomb=1.0).model()
    known = ((1.3, "bearing", 1, 0), (2.0, "bearing", 0, 1), (3.5, "bearing", 1, 0))
    return Problem("scalar", model, np.array([1.0]), u, {}, (0.5, 1.5, 2.5), 4.0, known)


def clutch() -> Problem:
    """Return the clutch of Section 3.5, engaged by its actuation and then locked under constant torques."""
    model = (
        Bench("clutch", {"input": 0.2, "output": 0.5})
        .machine("input")
        .machine("output")
        .friction("clutch", {"input": 1, "output": -1}, coulomb=60.0, static=66.0, actuated=True)
        .model()
    )
    # mu = t / 0.1 s up to 1; (4.16b): dw/dt = 30/0.2 + 20/0.5 - 7 * 60 mu = 190 - 420 mu, w(0) = 40 rad/s:
    # w(0.1) = 40 + 19 - 21 = 38, then dw/dt = -230; locks at 0.1 + 38/230 and needs T = 190/7 < 66
    lock = 0.1 + 38 / 230
    return Problem(
        "clutch",
        model,
        at_velocities(model, {"input": 40.0, "output": 0.0}),
        lambda _: np.array([30.0, -20.0]),
        {"clutch": lambda t: min(1.0, t / 0.1)},
        (0.1,),
        0.5,
        ((lock, "clutch", 1, 0),),
    )


def _chain(capacity1: float, capacity2: float) -> Model:
    return (
        Bench("two_clutches", {"J1": 1.0, "J2": 2.0, "J3": 1.0})
        .machine("J1")
        .machine("J3")
        .friction("clutch1", {"J1": 1, "J2": -1}, coulomb=capacity1)
        .friction("clutch2", {"J2": 1, "J3": -1}, coulomb=capacity2)
        .model()
    )


def two_clutches() -> Problem:
    """Return the chain (4.69), in which both clutches lock and break away as in Figure 4.11.

    Without torques until 0.65 s, clutches of 4 N m and 8 N m: x1' = -6 + 4 = -2 and x2' = 2 - 12 = -10, so clutch 2
    locks at 0.25 s with x2(0) = 2.5; then x1' = -4 - 4/3, and clutch 1 locks at 0.6 s with x1(0) = 0.5 + 0.35 * 16/3.
    From 0.65 s T1 = -T2 = 40 (t - 0.65): Tc1 = Tc2 = T1 reaches 4 N m at 0.75 s; then Tc2 = 4/3 + 2/3 T1 reaches 8 N m
    at T1 = 10 N m, t = 0.9 s.
    """
    model = _chain(4.0, 8.0)
    x1, x2 = 0.5 + 0.35 * 16 / 3, 2.5
    known = (
        (0.25, "clutch2", 1, 0),
        (0.6, "clutch1", 1, 0),
        (0.75, "clutch1", 0, 1),
        (0.9, "clutch2", 0, 1),
    )
    initial = at_velocities(model, {"J1": 10.0, "J2": 10.0 - x1, "J3": 10.0 - x1 - x2})
    torques = _ramps((0.0, 0.65, 1.65), (0.0, 0.0, 40.0), (0.0, 0.0, -40.0))
    return Problem("two_clutches", model, initial, torques, {}, (0.65,), 1.0, known)


def two_clutches_crossing() -> Problem:
    """Return the chain (4.69) with a clutch that reverses without sticking.

    Both clutches have 4 N m, T2 = 10 N m: x2' = 2 - 10 - 6 = -14 takes x2 = 3.5 rad/s to zero at 0.25 s. To hold it
    would take (2 - 10) / 1.5 = -16/3 N m, so it goes on with x2' = -2; x1' = -4 before, -8 then. So x1 = 4 rad/s
    reaches zero at 0.25 + 3/8 s. With clutch 2 slipping it takes 4/3 N m to hold clutch 1 there, and it locks.
    """
    model = _chain(4.0, 4.0)
    known = ((0.25, "clutch2", 1, -1), (0.625, "clutch1", 1, 0))
    initial = at_velocities(model, {"J1": 5.0, "J2": 1.0, "J3": -2.5})
    return Problem("two_clutches_crossing", model, initial, lambda _: np.array([0.0, 10.0]), {}, (), 1.0, known)


def coupled_clutches() -> Problem:
    """Return the example CoupledClutches of the Modelica Standard Library.

    Four inertias of 1 kg m^2 in a row, the first starts with 10 rad/s and is driven by 10 N m at 5 Hz. The clutches
    have ``cgeo * mue_pos * fn_max = 0.5 * 20 N`` = 10 N m and ``peak`` 1.1, actuated by cos(2 pi 0.2 Hz t), and by
    steps at 0.4 s and 0.9 s.
    """
    bench = Bench("coupled_clutches", {f"J{k}": 1.0 for k in range(1, 5)}).machine("J1")
    for k in range(1, 4):
        row = {f"J{k}": 1, f"J{k + 1}": -1}
        bench.friction(f"clutch{k}", row, coulomb=10.0, static=11.0, actuated=True)
    model = bench.model()
    return Problem(
        "coupled_clutches",
        model,
        at_velocities(model, {"J1": 10.0, "J2": 0.0, "J3": 0.0, "J4": 0.0}),
        lambda t: np.array([10.0 * np.sin(2 * np.pi * 5 * t)]),
        {
            "clutch1": lambda t: max(0.0, float(np.cos(2 * np.pi * 0.2 * t))),
            "clutch2": lambda t: 1.0 if t >= 0.4 else 0.0,
            "clutch3": lambda t: 1.0 if t >= 0.9 else 0.0,
        },
        (0.4, 0.9, 1.25),
        1.5,
    )


@cache
def _differential() -> Model:
    return Project.read(Path(__file__).resolve().parents[2] / "testbeds" / "differential.toml").model


def differential() -> Problem:
    """Return the bed of axle differentials: standstill, start-up with locked outputs, release, lock, standstill.

    The outputs move together while the difference of their torques stays below the slip-limiting torque (3.35), which
    grows with the input torque. All torques change along half-waves, so that the shafts hardly ring.
    """
    model = _differential()

    def bump(t: float, begin: float, end: float) -> float:
        return float(np.sin(np.pi * (t - begin) / (end - begin)) ** 2) if begin < t < end else 0.0

    def torques(t: float) -> np.ndarray:
        drive = 120.0 * bump(t, 0.05, 0.45) - 120.0 * bump(t, 0.65, 1.05)
        split = 160.0 * bump(t, 0.2, 0.4) - 160.0 * bump(t, 0.4, 0.6)
        return np.array([drive, split, -split])

    points = (0.05, 0.2, 0.4, 0.45, 0.6, 0.65, 1.05)
    return Problem("differential", model, np.zeros(len(model.coordinates)), torques, {}, points, 1.2)


def gear_set() -> Problem:
    """Return six friction elements on four degrees of freedom, as brakes and clutches around a planetary gear set."""
    bench = Bench("gear_set", {"sun": 0.6, "carrier": 1.4, "ring": 0.9, "output": 2.0}).machine("sun").machine("output")
    rows: dict[str, tuple[dict[str, float], float, float]] = {
        "brake_sun": ({"sun": 1}, 6.0, 7.0),
        "brake_ring": ({"ring": 1}, 8.0, 8.0),
        "clutch_sun": ({"sun": 1, "carrier": -1}, 5.0, 6.0),
        "clutch_output": ({"carrier": 1, "output": -1}, 9.0, 10.0),
        "planet": ({"sun": 1, "ring": 2.5, "carrier": -3.5}, 2.0, 2.2),
        "clutch_ring": ({"ring": 1, "output": -1}, 4.0, 4.0),
    }
    for name, (row, coulomb, static) in rows.items():
        bench.friction(name, row, coulomb=coulomb, static=static)
    model = bench.model()
    return Problem(
        "gear_set",
        model,
        at_velocities(model, {"sun": 6.0, "carrier": 2.0, "ring": -1.0, "output": 3.0}),
        lambda t: np.array([30.0 * np.sin(2 * np.pi * 0.7 * t), -25.0 * np.sin(2 * np.pi * 1.1 * t)]),
        duration=2.0,
    )


def rattling() -> Problem:
    """Return two bodies with a gap of 20 mrad in the shaft between them, under a torque that reverses."""
    model = (
        Bench("rattling", {"J1": 0.5, "J2": 1.5})
        .machine("J1")
        .friction("bearing", {"J2": 1}, coulomb=4.0, static=5.0)
        .shaft("shaft", {"J1": 1, "J2": -1}, stiffness=8000.0, damping=1.5, backlash=0.02)
        .model()
    )
    return Problem("rattling", model, np.zeros(2), lambda t: np.array([25.0 * np.sin(2 * np.pi * 2 * t)]))


def overrunning() -> Problem:
    """Return a starter behind a freewheel: it drives, is overrun, and drives again."""
    model = (
        Bench("overrunning", {"starter": 0.1, "engine": 0.4})
        .machine("starter")
        .machine("engine")
        .friction("freewheel", {"starter": 1, "engine": -1}, coulomb=0.4, one_way=True)
        .friction("engine_friction", {"engine": 1}, coulomb=6.0, static=9.0, stribeck_speed=4.0, viscous=0.02)
        .model()
    )

    def torques(t: float) -> np.ndarray:
        return np.array([30.0 * np.sin(2 * np.pi * 0.8 * t), 25.0 * np.sin(2 * np.pi * 0.5 * t) ** 3])

    return Problem("overrunning", model, np.zeros(2), torques, duration=2.0)


PROBLEMS: tuple[Callable[[], Problem], ...] = (
    scalar,
    clutch,
    two_clutches,
    two_clutches_crossing,
    coupled_clutches,
    differential,
    gear_set,
    rattling,
    overrunning,
)

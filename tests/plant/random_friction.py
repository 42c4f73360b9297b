"""Random mechanisms with friction of every kind, as models: bodies, shafts, gaps, clutches, brakes, gears."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import sympy as sp

from ptgen.elements import Body, Drive, Friction, FrictionRole, Parameter, Spring, Torque
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model

STEP = 1e-4


@dataclass(frozen=True)
class Kind:
    """What a random mechanism may contain."""

    frictions: int = 3
    static: bool = True
    one_way: bool = True
    backlash: bool = True
    actuated: bool = True


def random_model(seed: int, kind: Kind = Kind()) -> Model:
    """Return a mechanism of two to five bodies; its modes are slow enough for `STEP`."""
    rng = np.random.default_rng(seed)
    parameters: list[Parameter] = []

    def symbol(name: str, value: float, unit: str = "", positive: bool = False) -> sp.Symbol:
        made = sp.Symbol(name, positive=True) if positive else sp.Symbol(name, nonnegative=True)
        parameters.append(Parameter(made, float(f"{value:.6g}"), unit, name, positive))
        return made

    count = int(rng.integers(2, 6))
    bodies = [f"b{i}" for i in range(count)]
    inertias = 10 ** rng.uniform(-2, 1, count)
    one = sp.Integer(1)
    springs = []
    for i in range(count - 1):
        if rng.random() < 0.6:
            lighter = min(inertias[i], inertias[i + 1])
            stiffness = symbol(f"c{i}", lighter * (2 * np.pi * 10 ** rng.uniform(1, 2.5)) ** 2, "N m/rad", True)
            gap = (
                symbol(f"g{i}", 10 ** rng.uniform(-4, -2), "rad", True) if rng.random() < 0.4 * kind.backlash else None
            )
            springs.append(Spring(f"s{i}", {bodies[i]: one, bodies[i + 1]: -one}, stiffness, sp.Integer(0), gap))
    frictions = []
    for i in range(int(rng.integers(1, kind.frictions + 1))):
        a, b = rng.choice(count, 2, replace=False)
        ratio = sp.Rational(str(rng.choice([1, 1, 1, 2, -1.5])))
        row = {bodies[a]: one} if rng.random() < 0.25 else {bodies[a]: one, bodies[b]: -ratio}
        capacity = 10 ** rng.uniform(0, 2) * (rng.random() < 0.95)
        coulomb = symbol(f"m{i}", capacity, "N m")
        more = kind.static and rng.random() < 0.4
        static = symbol(f"r{i}", capacity * rng.uniform(1, 1.5), "N m") if more else None
        fading = more and rng.random() < 0.5
        frictions.append(
            Friction(
                f"f{i}",
                row,
                coulomb,
                sp.Integer(0),
                FrictionRole.COUPLING,
                static=static,
                stribeck_speed=symbol(f"w{i}", rng.uniform(0.5, 5), "rad/s", True) if fading else None,
                actuated=bool(kind.actuated and rng.random() < 0.5),
                one_way=bool(kind.one_way and rng.random() < 0.15),
            )
        )
    unlimited = sp.Integer(10**9)
    drive = Drive(unlimited, unlimited, unlimited)
    return assemble(
        Mechanism(
            name="random",
            velocities=tuple(bodies),
            bodies=tuple(Body(v, symbol(f"I{i}", inertias[i], "kg m^2", True)) for i, v in enumerate(bodies)),
            constraints=(),
            springs=tuple(springs),
            frictions=tuple(frictions),
            torques=tuple(Torque(f"T{i}", {v: one}, drive) for i, v in enumerate(bodies)),
            sensors=(),
            places=(),
            parameters=tuple(parameters),
            connections={},
            orientation={},
            observed=(),
        )
    )

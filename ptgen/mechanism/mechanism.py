"""A mechanism: the elements of all components of a bed, with their connections.

Velocities are not merged: a rigid connection is a constraint like any other, ``v_left - v_right = 0``. So the
torque across any connection is the multiplier of one constraint, and nothing needs a special case.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import sympy as sp

from ptgen.elements import (
    Body,
    Constraint,
    Elements,
    FluidCoupling,
    Friction,
    Parameter,
    Place,
    Row,
    Sensor,
    Spring,
    Torque,
)
from ptgen.testbed.testbed import Testbed

__all__ = ["Mechanism"]

_COMPUTATION_DELAY = sp.Symbol("computation_delay", nonnegative=True)


@dataclass(frozen=True)
class Mechanism:
    """All elements of a bed over one set of velocities.

    Attributes
    ----------
    name : str
        Name of the bed.
    velocities : tuple of str
        Names ``<component>.<flange>`` of all velocities, internal ones included.
    bodies, constraints, springs, frictions, torques, sensors, places, fluids
        The elements, see `ptgen.elements`.
    parameters : tuple of Parameter
        Every parameter with its value.
    connections : mapping
        Flange name to the name of the constraint that connects it, and the side (+1 left, -1 right) on which
        it stands.
    orientation : mapping
        Component to +1 or -1; the sign that makes a torque positive when it drives the right-hand neighbour.
    observed : tuple of str
        The places whose torque is of interest: those of torque references, and those that friction depends on.
    carriers : mapping
        Springs and flanges that were joined into an equivalent shaft: its name, and the sign of their torque.
    """

    name: str
    velocities: tuple[str, ...]
    bodies: tuple[Body, ...]
    constraints: tuple[Constraint, ...]
    springs: tuple[Spring, ...]
    frictions: tuple[Friction, ...]
    torques: tuple[Torque, ...]
    sensors: tuple[Sensor, ...]
    places: tuple[Place, ...]
    parameters: tuple[Parameter, ...]
    connections: Mapping[str, tuple[str, int]]
    orientation: Mapping[str, int]
    observed: tuple[str, ...]
    carriers: Mapping[str, tuple[str, int]] = field(default_factory=dict)
    fluids: tuple[FluidCoupling, ...] = ()

    @classmethod
    def of(cls, testbed: Testbed) -> Mechanism:
        """Collect the elements of all components of `testbed` and connect them."""
        parts: list[Elements] = []
        velocities: list[str] = []
        parameters: list[Parameter] = []
        for name, component in testbed.components.items():
            elements = component.elements(name)
            parts.append(elements)
            velocities += [f"{name}.{flange}" for flange in component.flange_names()]
            velocities += elements.internal
            parameters += component.parameters(name)
        if testbed.computation_delay > 0:
            text = "time from sampling until the command that follows from it reaches the inverters"
            parameters.append(Parameter(_COMPUTATION_DELAY, testbed.computation_delay, "s", text))
            parts = [_delayed(part) for part in parts]
        constraints = [constraint for part in parts for constraint in part.constraints]
        connections: dict[str, tuple[str, int]] = {}
        joined = [(connection.left, connection.right) for connection in testbed.connections]
        for left, right in (*(pair for part in parts for pair in part.connections), *joined):
            owner = f"{left} - {right}"
            constraints.append(Constraint(owner, {left: sp.Integer(1), right: sp.Integer(-1)}))
            connections[left] = (owner, +1)
            connections[right] = (owner, -1)
        return cls(
            name=testbed.name,
            velocities=tuple(velocities),
            bodies=tuple(body for part in parts for body in part.bodies),
            constraints=tuple(constraints),
            springs=tuple(spring for part in parts for spring in part.springs),
            frictions=tuple(friction for part in parts for friction in part.frictions),
            torques=tuple(torque for part in parts for torque in part.torques),
            sensors=tuple(sensor for part in parts for sensor in part.sensors),
            places=tuple(place for part in parts for place in part.places),
            parameters=tuple(parameters),
            connections=connections,
            orientation=testbed.orientation,
            observed=tuple(dict.fromkeys(_observed(testbed, parts))),
            fluids=tuple(fluid for part in parts for fluid in part.fluids),
        )

    @property
    def values(self) -> dict[sp.Symbol, float]:
        """Value of every parameter, by symbol."""
        return {parameter.symbol: parameter.value for parameter in self.parameters}

    @property
    def changing(self) -> tuple[Parameter, ...]:
        """The parameters that change while the bed runs: ratios that are inputs of plant and controller."""
        return tuple(parameter for parameter in self.parameters if parameter.span is not None)

    @property
    def machine_velocities(self) -> tuple[str, ...]:
        """Velocities of the rotors, in the order of the machines."""
        return tuple(next(iter(torque.row)) for torque in self.torques)

    def without_bodies(self, velocities: set[str]) -> Mechanism:
        """Return the mechanism without the bodies on `velocities`."""
        return replace(self, bodies=tuple(body for body in self.bodies if body.velocity not in velocities))

    def with_rigid_springs(self, names: set[str]) -> Mechanism:
        """Return the mechanism in which the named springs are rigid; their torque becomes a reaction."""
        rigid = [spring for spring in self.springs if spring.name in names]
        return replace(
            self,
            springs=tuple(spring for spring in self.springs if spring.name not in names),
            constraints=self.constraints + tuple(Constraint(spring.name, spring.row) for spring in rigid),
        )

    def with_locked_frictions(self, names: set[str], *, holding_ratios: bool = False) -> Mechanism:
        """Return the mechanism in which the named friction elements are locked for good.

        With `holding_ratios` the ratios in their rows stay what they are now: locked as it is, and not while it shifts.
        """
        locked = [friction for friction in self.frictions if friction.name in names]
        held: set[sp.Basic] = set()
        if holding_ratios:
            entries = [sp.sympify(entry) for friction in locked for entry in friction.row.values()]
            held = held.union(*(entry.free_symbols for entry in entries))
        return replace(
            self,
            parameters=tuple(replace(p, span=None) if p.symbol in held else p for p in self.parameters),
            frictions=tuple(friction for friction in self.frictions if friction.name not in names),
            constraints=self.constraints + tuple(Constraint(friction.name, friction.row) for friction in locked),
        )

    def with_numbers(self) -> Mechanism:
        """Return the mechanism with rational numbers in place of the parameters of its mechanics, for quick algebra."""
        table = {symbol: sp.Rational(f"{value:.12g}") for symbol, value in self.values.items()}

        def number(expression: sp.Expr) -> sp.Expr:
            return sp.sympify(expression).xreplace(table)

        def row(coefficients: Row) -> Row:
            return {name: number(value) for name, value in coefficients.items()}

        return replace(
            self,
            bodies=tuple(replace(body, inertia=number(body.inertia)) for body in self.bodies),
            constraints=tuple(replace(constraint, row=row(constraint.row)) for constraint in self.constraints),
            springs=tuple(
                replace(s, row=row(s.row), stiffness=number(s.stiffness), damping=number(s.damping))
                for s in self.springs
            ),
            frictions=tuple(replace(f, row=row(f.row), viscous=number(f.viscous)) for f in self.frictions),
            torques=tuple(replace(torque, row=row(torque.row)) for torque in self.torques),
            places=tuple(replace(place, flanges=row(place.flanges)) for place in self.places),
        )

    def with_closed_backlash(self) -> Mechanism:
        """Return the mechanism in which all gaps are closed, so that every shaft is linear."""
        return replace(self, springs=tuple(replace(spring, backlash=None) for spring in self.springs))

    def without_fluids(self) -> Mechanism:
        """Return the mechanism without the torques of fluids, which are no linear functions."""
        return replace(self, fluids=())

    def without_frictions(self, names: set[str]) -> Mechanism:
        """Return the mechanism without the named friction elements."""
        return replace(self, frictions=tuple(f for f in self.frictions if f.name not in names))


def _delayed(part: Elements) -> Elements:
    """Return the elements whose drives get their commands late."""
    torques = tuple(
        replace(torque, drive=replace(torque.drive, computation_delay=_COMPUTATION_DELAY)) for torque in part.torques
    )
    return replace(part, torques=torques)


def _observed(testbed: Testbed, parts: list[Elements]) -> list[str]:
    loads = [friction.load.place for part in parts for friction in part.frictions if friction.load is not None]
    return [*testbed.roles.torque.values(), *loads]

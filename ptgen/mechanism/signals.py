"""Sensors and places of a model as linear forms of its variables."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ptgen.elements import Row, SensorKind
from ptgen.mechanism import exact
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import LinearForm
from ptgen.mechanism.reaction import reaction

__all__ = ["SignalForms"]


class SignalForms:
    """Builds linear forms from the velocities and the spring torques of a model.

    Parameters
    ----------
    mechanism : Mechanism
        The elements.
    velocity_rows : mapping of str to Matrix (1, n_z)
        Every velocity in the coordinates.
    spring_torques : mapping of str to LinearForm
        Every compliant spring's torque.
    """

    def __init__(
        self,
        mechanism: Mechanism,
        velocity_rows: Mapping[str, sp.Matrix],
        spring_torques: Mapping[str, LinearForm],
        n_e: int,
    ) -> None:
        self._mechanism = mechanism
        self._velocity_rows = velocity_rows
        self._spring_torques = spring_torques
        self._n_z = next(iter(velocity_rows.values())).shape[1]
        self._n_e = n_e

    def all(self) -> dict[str, LinearForm]:
        """Return every sensor, and every place that the bed observes."""
        signals: dict[str, LinearForm] = {}
        for sensor in self._mechanism.sensors:
            if sensor.kind is SensorKind.SPEED:
                signals[sensor.name] = self._zero(z=self._velocity_rows[sensor.of])
            else:
                signals[sensor.name] = self.place(sensor.of)
        for place in self._mechanism.observed:
            signals[place] = self.place(place)
        return signals

    def place(self, name: str) -> LinearForm:
        """Return the torque at a flange, a spring, or a sum of flanges; positive to the right."""
        for place in self._mechanism.places:
            if place.name == name:
                form = self._zero()
                for flange, factor in place.flanges.items():
                    form = form + self.place(flange).scaled(factor)
                return form
        if name in self._mechanism.carriers and name not in self._mechanism.orientation:
            spring, sign = self._mechanism.carriers[name]
            return self._spring_torques[spring].scaled(sign)
        if name in self._mechanism.connections:
            return self._across(self._mechanism.connections[name][0])
        sign = self._mechanism.orientation[name]
        if name in self._mechanism.carriers:
            spring, same = self._mechanism.carriers[name]
            return self._spring_torques[spring].scaled(sign * same)
        if name in self._spring_torques:
            return self._spring_torques[name].scaled(sign)
        return self._across(name).scaled(sign)

    @property
    def _first_fluid(self) -> int:
        """Where the torques of fluids stand among those of friction and contacts."""
        contacts = sum(spring.backlash is not None for spring in self._mechanism.springs)
        return len(self._mechanism.frictions) + contacts

    def _zero(self, z: sp.Matrix | None = None) -> LinearForm:
        n_u = len(self._mechanism.torques)
        n_f = self._first_fluid + 2 * len(self._mechanism.fluids)
        return LinearForm(
            z=sp.zeros(1, self._n_z) if z is None else z,
            e=sp.zeros(1, self._n_e),
            u=sp.zeros(1, n_u),
            f=sp.zeros(1, n_f),
            a=sp.zeros(1, self._n_z),
        )

    def _across(self, owner: str) -> LinearForm:
        """Return the torque across a rigid connection: ``q' (torques - M dv/dt)``."""
        q = reaction(self._mechanism, owner).field

        def along(row: Row) -> sp.Expr:
            return sum((value * q[name] for name, value in row.items() if name in q), sp.Integer(0))

        form = self._zero()
        for index, torque in enumerate(self._mechanism.torques):
            form.u[0, index] += along(torque.row)
        for index, friction in enumerate(self._mechanism.frictions):
            share = along(friction.row)
            form.f[0, index] -= share
            for name, value in friction.row.items():
                form = form + self._zero(z=self._velocity_rows[name] * (-share * friction.linear_viscous * value))
        for index, row in enumerate(row for fluid in self._mechanism.fluids for row in fluid.rows):
            form.f[0, self._first_fluid + index] -= along(row)
        for spring in self._mechanism.springs:
            share = along(spring.row)
            if share != 0:
                form = form + self._spring_torques[spring.name].scaled(-share)
        for body in self._mechanism.bodies:
            if body.velocity in q:
                row = self._velocity_rows[body.velocity] * (-q[body.velocity] * body.inertia)
                form = form + LinearForm(z=sp.zeros(1, self._n_z), e=form.e * 0, u=form.u * 0, f=form.f * 0, a=row)
        return LinearForm(*(exact.canonical(part) for part in (form.z, form.e, form.u, form.f, form.a)))

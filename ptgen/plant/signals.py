"""What the plant puts out, as expressions of its state array."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import sympy as sp

from ptgen.block.block import Assign, Signal, Statement, element
from ptgen.elements import FluidCoupling
from ptgen.mechanism.model import LinearForm, Model
from ptgen.plant.layout import Layout, identifier, signal_name

__all__ = ["PlantSignals", "fluid_signals"]


class PlantSignals:
    """Sensors, observed torques and friction elements of a plant.

    Parameters
    ----------
    model : Model
    layout : Layout
    """

    def __init__(self, model: Model, layout: Layout) -> None:
        self.model = model
        self.layout = layout

    def accelerated(self) -> dict[str, LinearForm]:
        """Return the signals that depend on accelerations."""
        return {name: form for name, form in self.torques().items() if form.needs_acceleration}

    def torques(self) -> dict[str, LinearForm]:
        """Return every measured and observed signal, by its name in the emitted code."""
        signals = self.model.signals
        sensors = {sensor.name: signals[sensor.name] for sensor in self.model.sensors}
        places = {signal_name(name): form for name, form in signals.items() if name not in sensors}
        return {**sensors, **{name: form for name, form in places.items() if name not in sensors}}

    @cached_property
    def friction_rows(self) -> sp.Matrix:
        """The rows of the friction velocities for use in every step, see `prepared_rows`."""
        return self._with_prepared("G", self.model.friction_rows)

    @cached_property
    def contact_twists(self) -> sp.Matrix:
        """The rows of the twists of shafts with backlash for use in every step, see `prepared_rows`."""
        return self._with_prepared("L", self.model.contact_twists)

    def prepared_rows(self) -> dict[str, tuple[str, sp.Matrix]]:
        """Return the matrices of rows, and what they are, some of whose coefficients are formulas of parameters.

        These are computed once, `preparation`, and stand as elements of the matrix in the rows for every step.
        """
        kinds = {
            "G": ("friction velocities per velocity", self.model.friction_rows, self.friction_rows),
            "L": ("twists of shafts with backlash per twist", self.model.contact_twists, self.contact_twists),
        }
        return {name: (text, rows) for name, (text, rows, used) in kinds.items() if used != rows}

    def preparation(self) -> list[Assign]:
        """Return the statements that compute the coefficients of `prepared_rows`."""
        return [
            Assign(str(element(name, i, k)), rows[i, k], text)
            for name, (text, rows) in self.prepared_rows().items()
            for i in range(rows.shape[0])
            for k in range(rows.shape[1])
            if self._is_formula(rows[i, k])
        ]

    def _with_prepared(self, name: str, rows: sp.Matrix) -> sp.Matrix:
        return sp.Matrix(*rows.shape, lambda i, k: element(name, i, k) if self._is_formula(rows[i, k]) else rows[i, k])

    def _is_formula(self, coefficient: sp.Expr) -> bool:
        """Tell whether a coefficient is more than a number or a parameter, and constant while the bed runs."""
        changing = {parameter.symbol for parameter in self.model.changing}
        symbols = coefficient.free_symbols
        return bool(symbols) and not symbols & changing and not (coefficient.is_Symbol or (-coefficient).is_Symbol)

    def over_coordinates(self, row: sp.Matrix) -> sp.Expr:
        """Return a row over the coordinates as an expression of the state array."""
        return sum((row[k] * element("x", k) for k in range(self.layout.n_z) if row[k] != 0), sp.Integer(0))

    def is_state(self, i: int) -> bool:
        """Tell whether the velocity of a friction element is a state, not a combination of states."""
        return bool(self.over_coordinates(self.model.friction_rows[i, :]).is_Symbol)

    def friction_speed(self, i: int) -> sp.Expr:
        """Return the velocity of a friction element as an expression of the state array.

        Those that are states are exactly zero at rest; one that is a combination of states may be off by rounding.
        """
        speed = self.over_coordinates(self.friction_rows[i, :])
        if speed.is_Symbol:
            return speed
        terms = sp.Add.make_args(speed)
        rounding = sp.Symbol("velocity_rounding", real=True) * sum((sp.Abs(term) for term in terms), sp.Integer(0))
        stands = sp.Abs(speed) < sp.Symbol("standstill_speed", real=True) + rounding
        return sp.Piecewise((sp.Integer(0), stands), (speed, True))

    def over(self, name: str, form: LinearForm, x: Callable[[int], sp.Expr]) -> sp.Expr:
        """Return a linear form as an expression; `x` gives the entries of the state array."""
        layout = self.layout
        variables: list[sp.Expr] = [
            *(x(k) for k in range(layout.n_z + layout.n_e)),
            *(x(layout.air_gap(i)) for i in range(layout.n_u)),
            *(element("friction_torque", j) for j in range(layout.n_f)),
            *(element("contact_torque", j) for j in range(layout.n_c)),
            *(element("fluid_torque", j) for j in range(layout.n_w)),
        ]
        coefficients = [*form.z, *form.e, *form.u, *form.f]
        reaction = [
            element(f"{name}_reaction", j) if form.needs_acceleration else sp.Integer(0) for j in range(len(variables))
        ]
        return sum(
            ((c + r) * v for c, r, v in zip(coefficients, reaction, variables, strict=True) if c != 0 or r != 0),
            sp.Integer(0),
        )

    def measure(self) -> tuple[Statement, ...]:
        """Return the statements of the section ``measure``."""
        layout, model = self.layout, self.model

        def x(k: int) -> sp.Expr:
            return element("x", k)

        statements: list[Statement] = []
        for name, form in self.torques().items():
            if name in layout.filtered:
                statements.append(Assign(name, element("x", layout.measured(name)), "low pass of the sensor"))
                statements.append(Assign(f"{name}_true", self.over(name, form, x)))
            else:
                statements.append(Assign(name, self.over(name, form, x)))
        for i, torque in enumerate(model.inputs):
            statements.append(Assign(f"{torque.name}_torque", element("x", layout.air_gap(i))))
        for i, friction in enumerate(model.frictions):
            name = identifier(friction)
            speed = sp.Symbol(f"{name}_speed", real=True)
            torque_now = element("friction_torque", i) + friction.linear_viscous * speed
            statements += [Assign(speed.name, self.friction_speed(i)), Assign(f"{name}_torque", torque_now)]
        for i, fluid in enumerate(model.fluids):
            names = fluid_signals(fluid)
            statements += [Assign(name, element("fluid_torque", 2 * i + j)) for j, name in enumerate(names)]
        return tuple(statements)

    def outputs(self) -> tuple[Signal, ...]:
        """Return the outputs of the block."""
        outputs = []
        for name in self.torques():
            unit = "rad/s" if name.endswith("_speed") else "N m"
            outputs.append(Signal(name, unit, "measured or observed, positive to the right"))
            if name in self.layout.filtered:
                outputs.append(Signal(f"{name}_true", unit, "the same before the low pass of its sensor"))
        for torque in self.model.inputs:
            outputs.append(Signal(f"{torque.name}_torque", "N m", f"air-gap torque of {torque.name}"))
        for friction in self.model.frictions:
            name = identifier(friction)
            outputs.append(Signal(f"{name}_torque", "N m", f"torque of the friction element {friction.name}"))
            outputs.append(Signal(f"{name}_speed", "rad/s", f"velocity of the friction element {friction.name}"))
        for fluid in self.model.fluids:
            texts = (f"torque that {fluid.name} takes from the pump", f"torque that {fluid.name} exerts on the turbine")
            outputs += [Signal(name, "N m", text) for name, text in zip(fluid_signals(fluid), texts, strict=True)]
        return tuple(outputs)


def fluid_signals(fluid: FluidCoupling) -> tuple[str, str]:
    """Return the names of the torques of pump and turbine."""
    return f"{identifier(fluid)}_pump_torque", f"{identifier(fluid)}_turbine_torque"

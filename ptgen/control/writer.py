"""What the parts of the controller write into: parameters, states, inputs and statements of one block."""

from __future__ import annotations

import sympy as sp

from ptgen.block.block import Assign, Signal, Statement
from ptgen.control.decoupling import Decoupling
from ptgen.control.tuning import Gains
from ptgen.elements import SensorKind
from ptgen.mechanism.model import Model
from ptgen.testbed.testbed import Tuning

__all__ = ["ControllerWriter", "signal_symbol"]


def signal_symbol(name: str) -> sp.Symbol:
    """Return the symbol of a signal of the block."""
    return sp.Symbol(name, real=True)


class ControllerWriter:
    """The block in the making, and the design that it is made from.

    Parameters
    ----------
    design : Decoupling
    gains : Gains
    tuning : Tuning
    full : Model
        The full model; it tells what is plausible.
    """

    def __init__(self, design: Decoupling, gains: Gains, tuning: Tuning, full: Model) -> None:
        self.design = design
        self.gains = gains
        self.tuning = tuning
        self.full = full
        self.parameters: dict[str, Signal] = {}
        self.states: dict[str, Signal] = {}
        self.inputs: dict[str, Signal] = {}
        self.statements: list[Statement] = []

    def speed_sensor(self, machine: int) -> str:
        """Return the name of the sensor that measures the speed of a machine."""
        velocity = next(iter(self.design.model.inputs[machine].row))
        return next(s.name for s in self.design.model.sensors if s.kind is SensorKind.SPEED and s.of == velocity)

    def parameter(
        self,
        name: str,
        unit: str,
        text: str,
        value: float,
        least: float | None = 0.0,
        allowed: bool = True,
        most: float | None = None,
    ) -> sp.Symbol:
        """Declare a parameter and return its symbol; `allowed` tells whether it may equal `least`."""
        signal = Signal(name, unit, text, value=value, least=least, least_allowed=allowed, most=most)
        self.parameters.setdefault(name, signal)
        return signal_symbol(name)

    def of_bed(self, expression: sp.Expr) -> sp.Expr:
        """Declare the bed's parameters that occur in an expression, and return it over plain symbols."""
        known = {parameter.symbol: parameter for parameter in self.design.model.parameters}
        table = {}
        for symbol in sorted(expression.free_symbols, key=lambda s: s.name):
            if symbol in known:
                p = known[symbol]
                least = None if p.signed else 0.0
                table[symbol] = self.parameter(symbol.name, p.unit, p.description, p.value, least, not p.positive)
            else:
                table[symbol] = signal_symbol(symbol.name)
        return expression.subs(table)

    def state(self, name: str, unit: str, text: str, value: float = 0.0) -> sp.Symbol:
        """Declare a state and return its symbol."""
        self.states[name] = Signal(name, unit, text, value=value)
        return signal_symbol(name)

    def assign(self, target: str, expression: sp.Expr, source: str = "") -> sp.Symbol:
        """Add an assignment and return its target."""
        self.statements.append(Assign(target, expression, source))
        return signal_symbol(target)

    def sensor_sum(self, row: sp.Matrix, measured: dict[str, sp.Symbol]) -> sp.Expr:
        """Return a row over the sensors as an expression."""
        terms = [
            self.of_bed(sp.factor(row[k])) * measured[name] for k, name in enumerate(self.design.sensors) if row[k] != 0
        ]
        return sp.Add(*terms)

    def virtual_sum(self, row: sp.Matrix, virtual: dict[int, sp.Expr]) -> sp.Expr:
        """Return a row over the virtual inputs as an expression."""
        terms = [
            self.of_bed(sp.factor(row[position])) * value for position, value in virtual.items() if row[position] != 0
        ]
        return sp.Add(*terms)

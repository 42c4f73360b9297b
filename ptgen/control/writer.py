"""What the parts of the controller write into: parameters, states, inputs and statements of one block."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp
from sympy.logic.boolalg import Boolean

from ptgen.block.block import Assign, Call, Fault, Signal, Statement, Table
from ptgen.control.decoupling import Decoupling
from ptgen.control.tuning import Gains
from ptgen.elements import SensorKind
from ptgen.mechanism.model import Model
from ptgen.testbed.testbed import Tuning

__all__ = ["ControllerWriter", "greatest_of", "signal_symbol", "smallest_of"]


def greatest_of(*values: sp.Expr | float) -> sp.Expr:
    """Return ``max``, as it stands: looking for arguments that never win takes sympy a second per controller."""
    return sp.Max(*values, evaluate=False)


def smallest_of(*values: sp.Expr | float) -> sp.Expr:
    """Return ``min``, as it stands."""
    return sp.Min(*values, evaluate=False)


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

    Attributes
    ----------
    running : Symbol
        1 if the last step ended without a latched fault, else 0: in the first step, and while a fault is latched, up
        to and including the step in which it is reset. See `previous`.
    faults : list of Fault
        Every cause for which the block stops.
    """

    running = signal_symbol("running")

    def __init__(self, design: Decoupling, gains: Gains, tuning: Tuning, full: Model) -> None:
        self.design = design
        self.gains = gains
        self.tuning = tuning
        self.full = full
        self.parameters: dict[str, Signal] = {}
        self.states: dict[str, Signal] = {}
        self.inputs: dict[str, Signal] = {}
        self.statements: list[Statement] = []
        self.restart: list[Statement] = []
        """Where every state starts; stands behind the supervision of the inputs."""
        self.faults: list[Fault] = []
        self.derived: dict[str, Signal] = {}
        self.arrays: dict[str, Signal] = {}
        """Local arrays, which kernels read and write."""
        self.preparation: list[Statement] = []
        self.tables: dict[str, Table] = {}
        self.plausible: dict[str, float] = {}
        """Largest plausible value of inputs that are no signals of the bed."""
        self.run_time: dict[str, sp.Symbol] = {}
        """What stands for symbols of the law that change while the controller runs: dampings and ratios."""

    def speed_sensor(self, machine: int) -> str:
        """Return the name of the sensor that measures the speed of a machine."""
        velocity = next(iter(self.design.model.inputs[machine].row))
        return next(s.name for s in self.design.model.sensors if s.kind is SensorKind.SPEED and s.of == velocity)

    def rotor(self, name: str) -> sp.Expr:
        """Return the inertia of a machine's rotor alone, over symbols of the block."""
        torque = self.design.model.inputs[self.design.machines.index(name)]
        return self.of_bed(self.design.model.body_inertias[next(iter(torque.row))])

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
            if symbol.name in self.run_time:
                table[symbol] = self.run_time[symbol.name]
            elif symbol in known:
                p = known[symbol]
                least = None if p.signed else 0.0
                table[symbol] = self.parameter(symbol.name, p.unit, p.description, p.value, least, not p.positive)
            else:
                table[symbol] = signal_symbol(symbol.name)
        return expression.subs(table)

    def state(self, name: str, unit: str, text: str, value: float = 0.0, *, monitor: bool = False) -> sp.Symbol:
        """Declare a state and return its symbol; `monitor` as in `ptgen.block.block.Signal`."""
        self.states[name] = Signal(name, unit, text, value=value, monitor=monitor)
        return signal_symbol(name)

    def array(self, name: str, text: str, *shape: int) -> str:
        """Declare a local array and return its name."""
        self.arrays[name] = Signal(name, "", text, shape)
        return name

    def latch(self, causes: Sequence[tuple[Fault, Boolean]], name: str, source: str) -> None:
        """Declare faults, each with the condition under which all is well, and latch the one with the lowest status.

        All conditions are looked at in every step, so that it takes the same time whatever comes in. One that compares
        with a number that is not finite does not hold.
        """
        self.faults += [fault for fault, _ in causes]
        if not causes:
            return
        first: sp.Expr = sp.Integer(0)
        for fault, well in sorted(causes, key=lambda cause: -cause[0].status):
            first = sp.Piecewise((first, well), (sp.Integer(fault.status), True), evaluate=False)
        latched = signal_symbol("fault")
        self.assign(name, first, source)
        self.assign("fault", sp.Piecewise((latched, latched > sp.Rational(1, 2)), (signal_symbol(name), True)))

    def call(
        self,
        kernel: str,
        outputs: tuple[str, ...],
        inputs: tuple[str | sp.Symbol, ...],
        source: str = "",
        numbers: tuple[int, ...] = (),
    ) -> None:
        """Add the call of a kernel; its inputs are signals, `numbers` as in `ptgen.block.block.Call`."""
        names = tuple(item if isinstance(item, str) else item.name for item in inputs)
        self.statements.append(Call(kernel, outputs, names, source, numbers))

    def assign(
        self, target: str, expression: sp.Expr, source: str = "", *, condition: Boolean | None = None
    ) -> sp.Symbol:
        """Add an assignment and return its target; see `Assign` for the condition."""
        self.statements.append(Assign(target, expression, source, condition))
        return signal_symbol(target)

    def derive(self, name: str, unit: str, text: str, expression: sp.Expr) -> sp.Symbol:
        """Declare a quantity that follows from the parameters alone, computed when they change, not in every step.

        Raises
        ------
        ValueError
            If another quantity has that name.
        """
        statement = Assign(name, expression)
        if name not in self.derived:
            self.derived[name] = Signal(name, unit, text)
            self.preparation.append(statement)
        elif statement not in self.preparation:
            raise ValueError(f"the derived quantity {name} is declared twice")
        return signal_symbol(name)

    def coefficient(self, name: str, text: str, expression: sp.Expr) -> sp.Expr:
        """Return an expression of the law over symbols of the block, prepared under `name` as far as it is constant."""
        plain = self.of_bed(sp.factor(expression))
        changing = set(self.run_time.values())
        if plain.is_Atom or plain.free_symbols & changing:
            return plain
        if (-plain).is_Atom:
            return plain
        return self.derive(name, "", text, plain)

    def sensor_sum(self, name: str, row: sp.Matrix, measured: Mapping[str, sp.Symbol]) -> sp.Expr:
        """Return a row over the sensors as an expression; `name` begins the names of what is prepared."""
        terms = [
            self.coefficient(f"{name}_{sensor}", f"coefficient of {sensor}", row[k]) * measured[sensor]
            for k, sensor in enumerate(self.design.sensors)
            if row[k] != 0
        ]
        return sp.Add(*terms)

    def virtual_sum(self, name: str, row: sp.Matrix, virtual: Mapping[int, sp.Expr]) -> sp.Expr:
        """Return a row over the virtual inputs as an expression."""
        machines = [self.design.machines[machine] for machine in self.design.actuators]
        terms = [
            self.coefficient(f"{name}_{machines[k]}", f"coefficient of the virtual input of {machines[k]}", row[k]) * v
            for k, v in virtual.items()
            if row[k] != 0
        ]
        return sp.Add(*terms)

    def loss_sum(self, name: str, row: sp.Matrix, losses: Sequence[sp.Symbol]) -> sp.Expr:
        """Return a row over the known loss torques as an expression."""
        terms = [
            self.coefficient(f"{name}_{loss.name}", f"coefficient of {loss.name}", row[k]) * loss
            for k, loss in enumerate(losses)
            if row[k] != 0
        ]
        return sp.Add(*terms)

    def rate_sum(
        self, name: str, machine: int, rates: Mapping[str, sp.Expr], measured: Mapping[str, sp.Symbol]
    ) -> sp.Expr:
        """Return what the rates of changing ratios add to the torque of a machine (5.46), (5.62)."""
        terms = [
            rate * self.sensor_sum(f"{name}_per_{ratio}", self.design.law.ratio_rates[ratio][machine, :], measured)
            for ratio, rate in rates.items()
            if ratio in self.design.law.ratio_rates
        ]
        return sp.Add(*terms)

    # -- the first step, and the first one after a fault

    def previous(self, state: sp.Symbol, start: sp.Expr, *, here: bool = False) -> sp.Symbol:
        """Return a state as the last step left it, or `start` if that step did not run, see `running`.

        All states get their `start` at one place, behind the supervision of the inputs; with `here` at the present
        one, if `start` is only known now.
        """
        anew = Assign(state.name, start, "the first step, and the first one after a fault, starts anew", self._stopped)
        (self.statements if here else self.restart).append(anew)
        return state

    @property
    def _stopped(self) -> Boolean:
        return self.running <= sp.Rational(1, 2)

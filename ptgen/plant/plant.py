r"""The plant as a block: exact discretisation of the linear part, exact friction, dead time.

For held inputs and friction torques the linear part is discretised exactly,
:math:`x^+ = \Phi x + \Gamma_u u + \Gamma_f T`, once, by one matrix exponential; the low passes of sensors are part of
it. Computation and dead time of :math:`(d + f) h` let the command of :math:`d + 1` steps ago act for the first
:math:`f h` of a step, and that of :math:`d` steps ago for the rest; this too is exact. The friction torques of a step
follow from :math:`K = -G\,\Gamma_f` by `ptgen.friction.step`, those of shafts with backlash by
`ptgen.friction.backlash`; capacities are those of `ptgen.plant.capacities` and torques of fluids those of
`ptgen.plant.fluids`, at mid-step, which keeps order 2.

A gear ratio that changes at run time is an input, taken over the whole step, best the value at its middle, which keeps
order 2. With the ratio the shafts' rows :math:`E(i)` change, and all matrices are computed anew, in the steps in which
it does change; where it stands in rows of friction elements only, the linear part stays, and a few products do. Bodies'
rows do not depend on such a ratio, so the momenta :math:`M z` stay what they are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import sympy as sp

from ptgen.block.block import Alarm, Assign, Block, Call, Signal, Statement, Tracked, element, parse_element
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.elements import Parameter
from ptgen.friction.step import UNSOLVED
from ptgen.mechanism.dependence import is_dependent
from ptgen.mechanism.model import Model
from ptgen.plant.capacities import Capacities
from ptgen.plant.fluids import Fluids
from ptgen.plant.layout import Layout, identifier
from ptgen.plant.limits import DELAY_CAPACITY, check_delays, too_fast
from ptgen.plant.preparation import Preparation
from ptgen.plant.ratios import NOW, corners, quick_ratios, with_ratios_of_now
from ptgen.plant.signals import PlantSignals

__all__ = ["STANDSTILL", "plant_block"]

STANDSTILL = 1e-9
"""Friction velocity (rad/s) below which an element counts as standing; one revolution in two hundred years."""


def plant_block(model: Model, sample_time: float, delay_capacity: int = DELAY_CAPACITY) -> Block:
    """Return the plant of a bed as a block.

    Parameters
    ----------
    model : Model
        The full model, with the friction velocities as first coordinates.
    sample_time : float
        Step of the emitted code (s).
    delay_capacity : int
        Steps for which every delay line has room, one more than computation and dead time may take: an analysis may
        ask for more than the emitted plant has.

    Raises
    ------
    ModelError
        If the bed has a delay or a mode that the step cannot represent.
    """
    check_delays(model, sample_time, delay_capacity)
    block = _Plant(model, sample_time, delay_capacity).block()
    evaluator = NumpyBlock(block)
    for corner in corners(model):
        values = {f"{parameter.symbol.name}{NOW}": np.asarray(parameter.value) for parameter in corner.changing}
        try:
            evaluator.prepare(evaluator.defaults(), {**evaluator.initial(), **values})
        except ValueError:
            raise too_fast(corner, sample_time) from None
    return block


class _Plant:
    def __init__(self, model: Model, sample_time: float, delay_capacity: int) -> None:
        self.model = model
        self.sample_time = sample_time
        self.delay_capacity = delay_capacity
        self.layout = Layout.of(model)
        self.signals = PlantSignals(model, self.layout)
        self.capacities = Capacities(model, self.layout, self.signals)
        self.fluids = Fluids(model, self.layout)

    def block(self) -> Block:
        layout = self.layout
        n, n_u, n_t, width = layout.n, layout.n_u, layout.n_t, layout.n + 2 * layout.n_u
        preparation = Preparation(self.model, self.layout, self.signals, self.sample_time)
        prepare, refresh, step, measure = (
            with_ratios_of_now(self.model, statements)
            for statements in (
                preparation.statements(),
                preparation.refresh(),
                self._step(),
                self.signals.measure(),
            )
        )
        quick = quick_ratios(self.model)
        used = {symbol.name for statement in (*prepare, *refresh, *step, *measure) for symbol in _symbols(statement)}
        parameters = [
            _parameter_signal(parameter) for parameter in self.model.parameters if parameter.symbol.name in used
        ]
        parameters = [self._bounded(signal) for signal in parameters]
        if layout.n_f:
            text = "friction velocities below this are none"
            parameters.append(Signal("standstill_speed", "rad/s", text, value=STANDSTILL, least=0.0))
        sample = Signal("sample_time", "s", "step of the plant", value=self.sample_time, least=0.0, least_allowed=False)
        force_columns = layout.n_z + layout.n_e + n_u + layout.n_s
        columns = n + n_u + layout.n_s
        derived = [
            Signal("transition", "", "x at the end of the step without friction torques", (n, width)),
            *(Signal(f"{m}_dead_steps", "", "whole steps of dead time") for m in self._names()),
        ]
        derived += [Signal(name, "", text, rows.shape) for name, (text, rows) in self.signals.prepared_rows().items()]
        kinds = "velocity, twist, input, friction and contact" + (", fluid" if layout.n_w else "")
        arrays = [
            Signal("mass", "kg m^2", "inertia matrix of the coordinates", (layout.n_z, layout.n_z)),
            Signal("forces", "", f"torques on the coordinates per {kinds}", (layout.n_z, force_columns)),
            Signal("A", "", "state matrix, input columns, friction and contact columns", (n, columns)),
            Signal("scale", "", "balance of the exponential", (columns,)),
            Signal("whole", "", "solution over the whole step", (n, columns)),
            Signal("late", "", "solution over the late part of the step", (n, columns)),
            Signal("early", "", "difference of both", (n, columns)),
            Signal("rates", "", f"accelerations per {kinds}", (layout.n_z, force_columns)),
            Signal("x_free", "", "states at the end of the step without friction torques", (n,)),
        ]
        for name in self.signals.accelerated():
            per_variable = (layout.n_z + layout.n_e + n_u + n_t,)
            derived.append(Signal(f"{name}_reaction", "", f"{name} per {kinds}", per_variable))
            if layout.turning:
                text = f"{name} per friction torque on a coordinate"
                derived.append(Signal(f"{name}_pressed", "", text, (len(layout.pressed),)))
        measured = ", measured values" if layout.filtered else ""
        states = [
            Signal(
                "x",
                "",
                f"velocities, twists, air-gap torques{measured}; then the commands that act late and early",
                (width,),
                entries=self._entries(),
            ),
            *(
                Signal(f"{m}_delay", "N m", f"commands to {m} of past steps", (self.delay_capacity,))
                for m in self._names()
            ),
            *self.capacities.states(),
            *self.fluids.states(),
            *(
                Signal(f"{p.symbol.name}{NOW}", p.unit, f"{p.description}, in the last step", value=p.value)
                for p in self.model.changing
            ),
        ]
        if n_t:
            solved = "friction, contact and fluid" if layout.n_w else "friction and contact"
            derived.append(Signal("gamma", "", f"x at the end of the step per {solved} torque", (n, n_t)))
            arrays.append(Signal("mean_torque", "N m", f"mean {solved} torques of the step", (n_t,)))
        if layout.n_f:
            self._declare_frictions(states, derived, arrays)
        if layout.n_c:
            self._declare_contacts(states, derived, arrays)
        torques = (Signal(f"{m}_torque_ref", "N m", f"air-gap torque reference of {m}") for m in self._names())
        return Block(
            name="plant",
            description=f"plant of the bed {self.model.name}",
            parameters=(*parameters, sample),
            inputs=(*torques, *self.capacities.inputs(), *(_ratio_input(p) for p in self.model.changing)),
            outputs=self.signals.outputs(),
            states=tuple(states),
            derived=tuple(derived),
            arrays=tuple(arrays),
            prepare=prepare,
            refresh=refresh,
            step=step,
            measure=measure,
            alarms=self._alarms(),
            tables=self.fluids.tables(),
            tracked=tuple(
                Tracked(f"{p.symbol.name}{NOW}", p.symbol.name, quick=p.symbol in quick) for p in self.model.changing
            ),
        )

    def _declare_frictions(self, states: list[Signal], derived: list[Signal], arrays: list[Signal]) -> None:
        n_f = (self.layout.n_f,)
        names = tuple(f.name for f in self.model.frictions)
        states.append(Signal("friction_torque", "N m", "friction torques at the end of the step", n_f, entries=names))
        states.append(Signal("friction_rest", "N m", "capacities at rest in the last step", n_f, entries=names))
        states.append(Signal("friction_status", "", "0, or what was wrong with the friction of the last step"))
        if any(not self.signals.is_state(i) for i in range(self.layout.n_f)):
            derived.append(Signal("velocity_rounding", "", "share of a sum of velocities that is rounding"))
        derived.append(Signal("K", "rad/(N m s)", "friction velocities lost per mean friction torque", n_f * 2))
        if self.layout.turning:
            text = "x at the end of the step per friction torque on a coordinate"
            derived.append(Signal("gamma_pressed", "", text, (self.layout.n, len(self.layout.pressed))))
            base = self.layout.n_f - len(self.layout.turning) + len(self.layout.pressed)
            text = "the same for the elements that others are put together from"
            derived.append(Signal("K_base", "rad/(N m s)", text, (base, base)))
        arrays += [
            Signal("w_start", "rad/s", "friction velocities at the start of the step", n_f),
            Signal("w_free", "rad/s", "friction velocities at the end of the step without friction torques", n_f),
            Signal("w_plus", "rad/s", "friction velocities at the end of the step", n_f),
            Signal("slide", "N m", "capacities in motion", n_f),
            Signal("rest", "N m", "capacities at rest", n_f),
            Signal("friction_mean", "N m", "mean friction torques of the step", n_f),
        ]

    def _declare_contacts(self, states: list[Signal], derived: list[Signal], arrays: list[Signal]) -> None:
        n_c = (self.layout.n_c,)
        names = tuple(contact.name for contact in self.model.contacts)
        text = "torques of shafts with backlash at the end of the step"
        states.append(Signal("contact_torque", "N m", text, n_c, entries=names))
        derived += [
            Signal("kappa", "rad/(N m)", "twist lost over the step per torque", n_c * 2),
            Signal("half_gap", "rad", "half of the gaps", n_c),
            Signal("contact_stiffness", "N m/rad", "stiffness beyond the gaps", n_c),
            Signal("contact_damping", "N m/rad", "damping over the step", n_c),
        ]
        arrays += [
            Signal("twist_start", "rad", "twists of shafts with backlash at the start of the step", n_c),
            Signal("twist_free", "rad", "the same at its end, without their torques", n_c),
            Signal("contact_mean", "N m", "their mean torques", n_c),
        ]

    def _alarms(self) -> tuple[Alarm, ...]:
        if not self.layout.n_f:
            return ()
        unsolved = Alarm("friction_status", int(UNSOLVED), "friction_unsolved", "the friction torques are not exact")
        return (
            unsolved,
            *(
                Alarm(
                    "friction_status",
                    i + 1,
                    f"bad_capacity_{identifier(friction)}",
                    f"the capacity of {friction.name} is no number from 0 up; it was taken as 0",
                )
                for i, friction in enumerate(self.model.frictions)
            ),
        )

    def _names(self) -> list[str]:
        return [torque.name for torque in self.model.inputs]

    def _bounded(self, signal: Signal) -> Signal:
        """Return a parameter with its upper bound: computation and dead time together must fit the delay lines."""
        drives = [torque.drive for torque in self.model.inputs]
        values = self.model.values
        computation = max((values[d.computation_delay] for d in drives if d.computation_delay is not None), default=0.0)
        dead_time = max((values[d.dead_time] for d in drives if d.dead_time is not None), default=0.0)
        longest = (self.delay_capacity - 1) * self.sample_time
        spare = (longest - computation - dead_time) / 2
        if any(d.dead_time is not None and d.dead_time.name == signal.name for d in drives):
            return replace(signal, most=dead_time + spare if computation else longest)
        if any(d.computation_delay is not None and d.computation_delay.name == signal.name for d in drives):
            return replace(signal, most=computation + spare)
        return signal

    def _entries(self) -> tuple[str, ...]:
        names = self._names()
        return (
            *(f"velocity of {name} (rad/s)" for name in self.model.coordinates),
            *(f"twist of {name} (rad)" for name in self.model.twists),
            *(f"air-gap torque of {names[i]} (N m)" for i in self.layout.lagging),
            *(f"measured {name} ({'rad/s' if name.endswith('_speed') else 'N m'})" for name in self.layout.filtered),
            *(f"late command to {name} (N m)" for name in names),
            *(f"early command to {name} (N m)" for name in names),
        )

    def _step(self) -> tuple[Statement, ...]:
        layout, model = self.layout, self.model
        statements: list[Statement] = []
        for i, torque in enumerate(model.inputs):
            name, drive = torque.name, torque.drive
            speed = self.signals.over_coordinates(model.velocity_rows[next(iter(torque.row))])
            available = drive.torque_max * drive.speed_rated / sp.Max(drive.speed_rated, sp.Abs(speed))
            reference = sp.Symbol(f"{name}_torque_ref", real=True)
            limited = sp.Symbol(f"{name}_available", real=True)
            statements += [
                Assign(limited.name, available, "torque-speed envelope, Figure 7.1"),
                Assign(f"{name}_limited", sp.Max(-limited, sp.Min(limited, reference))),
                Call(
                    "delay",
                    (f"{name}_delay", str(element("x", layout.late(i))), str(element("x", layout.early(i)))),
                    (f"{name}_delay", f"{name}_limited", f"{name}_dead_steps"),
                    "dead time of the torque loop" if drive.computation_delay is None else "computation and dead time",
                ),
            ]
        statements += self.capacities.at_start()
        statements.append(Call("multiply", ("x_free",), ("transition", "x"), "x+ = Phi x + Gamma_u u"))
        if layout.n_t == 0:
            return (*statements, *(Assign(str(element("x", k)), element("x_free", k)) for k in range(layout.n)))
        statements += self.fluids.at_mid_step(self._with_last_torques)
        statements += self._contact_torques()
        statements += self._friction_torques()
        statements.append(
            Call("add_product", ("x",), ("x", "x_free", "gamma", "mean_torque"), "x+ = x_free + Gamma_f T")
        )
        statements += [statement for i in range(layout.n_f) for statement in self._settled(i)]
        statements += self.capacities.turned()
        statements += self._contacts_at_end()
        statements += self.fluids.at_end()
        return tuple(statements)

    def _friction_torques(self) -> list[Statement]:
        layout, model = self.layout, self.model
        if not layout.n_f:
            return []
        statements: list[Statement] = []
        for i in range(layout.n_f):
            statements.append(Assign(str(element("w_start", i)), self.signals.friction_speed(i), "w = G z"))
        statements += self.capacities.at_mid_step(self._predicted)
        for i in range(layout.n_f):
            free = self._over(self.signals.friction_rows[i, :], 0, self._with_contacts)
            statements.append(Assign(str(element("w_free", i)), free, "w_free = G z_free"))
        inputs = ("K", "w_start", "w_free", "slide", "rest", "friction_torque", "friction_rest")
        outputs = ("friction_mean", "friction_torque", "friction_rest", "w_plus", "friction_status")
        one_way = sum(1 << i for i, friction in enumerate(model.frictions) if friction.one_way)
        numbers = (int(is_dependent(model)), one_way)
        statements.append(Call("friction_step", outputs, inputs, "what sticks, slips and passes zero", numbers))
        statements += [Assign(str(element("mean_torque", i)), element("friction_mean", i)) for i in range(layout.n_f)]
        return statements

    def _contact_torques(self) -> list[Statement]:
        """Return the torques of shafts with backlash, with the friction torques of the last step."""
        layout = self.layout
        if not layout.n_c:
            return []
        statements: list[Statement] = []
        for i in range(layout.n_c):
            row = self.signals.contact_twists[i, :]
            start = self._over(row, layout.n_z, lambda k: element("x", k))
            statements.append(Assign(str(element("twist_start", i)), start, "e = L x_e"))
            statements.append(Assign(str(element("twist_free", i)), self._over(row, layout.n_z, self._with_frictions)))
        inputs = ("kappa", "twist_start", "twist_free", "half_gap", "contact_stiffness", "contact_damping")
        statements.append(Call("backlash_step", ("contact_mean",), inputs, "(3.5) as a mean over the step"))
        for i in range(layout.n_c):
            statements.append(Assign(str(element("mean_torque", layout.n_f + i)), element("contact_mean", i)))
        return statements

    def _contacts_at_end(self) -> list[Statement]:
        layout, model = self.layout, self.model
        statements: list[Statement] = []
        for i, contact in enumerate(model.contacts):
            name = f"{contact.name.replace('.', '_')}_twist"
            twist, b = sp.Symbol(name, real=True), element("half_gap", i)
            rate = self._over(model.contact_rows[i, :], 0, lambda k: element("x", k))
            beyond = twist - sp.Max(-b, sp.Min(b, twist))
            damping = sp.Piecewise((contact.damping * rate, sp.Abs(twist) > b), (sp.Integer(0), True))
            statements.append(
                Assign(name, self._over(self.signals.contact_twists[i, :], layout.n_z, lambda k: element("x", k)))
            )
            statements.append(Assign(str(element("contact_torque", i)), contact.stiffness * beyond + damping, "(3.5)"))
        return statements

    def _over(self, row: sp.Matrix, first: int, x: Callable[[int], sp.Expr]) -> sp.Expr:
        """Return a row over the states from `first` on; `x` gives them."""
        return sum((row[k] * x(first + k) for k in range(row.shape[1]) if row[k] != 0), sp.Integer(0))

    def _state_of(self, i: int) -> int | None:
        """Return the state that a friction velocity is, or None if it is a combination of states."""
        speed = self.signals.friction_speed(i)
        return parse_element(speed.name)[1][0] if speed.is_Symbol else None

    def _settled(self, i: int) -> list[Statement]:
        """Return the statement that takes over a friction velocity, if it is a state.

        A velocity that dies away while its torque is at the limit would end in the rounding of zero and go back and
        forth between sticking and slipping for ever.
        """
        state = self._state_of(i)
        if state is None:
            return []
        velocity = element("w_plus", i)
        stands = sp.Abs(velocity) < sp.Symbol("standstill_speed", real=True)
        value = sp.Piecewise((sp.Integer(0), stands), (velocity, True))
        return [Assign(str(element("x", state)), value, "exactly zero while it sticks")]

    def _with_last_torques(self, k: int) -> sp.Expr:
        """Return a state at the end of the step with all torques as they were at the end of the last one."""
        layout = self.layout
        return element("x_free", k) + sum(
            (
                self._share(k, first, name, count)
                for name, first, count in (
                    ("friction_torque", 0, layout.n_f),
                    ("contact_torque", layout.n_f, layout.n_c),
                    ("fluid_torque", layout.n_f + layout.n_c, layout.n_w),
                )
            ),
            sp.Integer(0),
        )

    def _with_frictions(self, k: int) -> sp.Expr:
        """Return a state at the end of the step with the last friction torques, but without contact torques."""
        return element("x_free", k) + self._share(k, 0, "friction_torque", self.layout.n_f) + self._of_fluids(k)

    def _with_contacts(self, k: int) -> sp.Expr:
        """Return a state at the end of the step with contact torques, but without friction torques."""
        n_f, n_c = self.layout.n_f, self.layout.n_c
        return element("x_free", k) + self._share(k, n_f, "contact_mean", n_c) + self._of_fluids(k)

    def _predicted(self, k: int) -> sp.Expr:
        """Return a state at the end of the step with the last friction torques and with contact torques."""
        if k >= self.layout.n:
            return element("x", k)
        return self._with_contacts(k) + self._share(k, 0, "friction_torque", self.layout.n_f)

    def _of_fluids(self, k: int) -> sp.Expr:
        """Return what the torques of fluids, which are known first, add to a state."""
        first = self.layout.n_f + self.layout.n_c
        shares = (element("gamma", k, j) * element("mean_torque", j) for j in range(first, self.layout.n_t))
        return sum(shares, sp.Integer(0))

    def _share(self, k: int, first: int, name: str, count: int) -> sp.Expr:
        """Return what the torques `name`, which stand from column `first` on, add to a state."""
        shares = (element("gamma", k, first + j) * element(name, j) for j in range(count))
        return sum(shares, sp.Integer(0))


def _symbols(statement: Statement) -> Sequence[sp.Symbol]:
    return tuple(statement.expression.free_symbols) if isinstance(statement, Assign) else ()


def _ratio_input(parameter: Parameter) -> Signal:
    least, most = parameter.span if parameter.span is not None else (None, None)
    name, unit = parameter.symbol.name, parameter.unit
    return Signal(name, unit, parameter.description, value=parameter.value, least=least, most=most)


def _parameter_signal(parameter: Parameter) -> Signal:
    return Signal(
        parameter.symbol.name,
        parameter.unit,
        parameter.description,
        value=parameter.value,
        least=None if parameter.signed else 0.0,
        least_allowed=not parameter.positive,
    )

r"""The plant as a block: exact discretisation of the linear part, exact friction, dead time.

For held inputs and friction torques the linear part is discretised exactly,
:math:`x^+ = \Phi x + \Gamma_u u + \Gamma_f T`, once, by one matrix exponential. A dead time of
:math:`(d + f) h` lets the command of :math:`d + 1` steps ago act for the first :math:`f h` of a step, and that of
:math:`d` steps ago for the rest; this too is exact. The friction torques solve the problem of
`ptgen.friction.box` with :math:`K = -G\,\Gamma_f`. Capacities that depend on a load are evaluated at mid-step,
with the mean of the load at the start and the one predicted for the end with the last friction torques; that
keeps order 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import sympy as sp

from ptgen.block.block import Assign, Block, Call, Signal, Statement, element
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.elements import Parameter
from ptgen.errors import ModelError, Problem
from ptgen.friction.box import MAX_ELEMENTS
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.mechanism.modes import Mode, modes
from ptgen.plant.layout import Layout, signal_name
from ptgen.plant.preparation import Preparation
from ptgen.plant.signals import PlantSignals

__all__ = ["DELAY_CAPACITY", "STANDSTILL", "plant_block"]

DELAY_CAPACITY = 16
"""Steps of dead time for which every delay line has room, one more than can be asked for."""

STANDSTILL = 1e-9
"""Friction velocity (rad/s) below which an element counts as standing; one revolution in two hundred years."""


def plant_block(model: Model, sample_time: float) -> Block:
    """Return the plant of a bed as a block.

    Parameters
    ----------
    model : Model
        The full model, with the friction velocities as first coordinates.
    sample_time : float
        Step of the emitted code (s).

    Raises
    ------
    ModelError
        If the bed has more friction elements than there are closed forms, or elements that hold one motion, or a
        mode that is too fast for the step.
    """
    _check_dead_times(model, sample_time)
    block = _Plant(model, sample_time).block()
    evaluator = NumpyBlock(block)
    try:
        evaluator.prepare(evaluator.defaults())
    except ValueError:
        raise _too_fast(model, sample_time) from None
    return block


def _check_dead_times(model: Model, sample_time: float) -> None:
    longest = (DELAY_CAPACITY - 1) * sample_time
    problems = []
    for torque in model.inputs:
        dead_time = torque.drive.dead_time
        if dead_time is not None and model.values[dead_time] > longest:
            what = f"is {1e6 * model.values[dead_time]:.6g} us, more than {DELAY_CAPACITY - 1} steps of the controller"
            remedy = f"check the unit, or take a longer sample_time: {1e6 * longest:.6g} us are possible now"
            problems.append(Problem(f"components.{torque.name}.inverter.dead_time", what, remedy))
    if problems:
        raise ModelError(problems)


def _too_fast(model: Model, sample_time: float) -> ModelError:
    """Return the error for a mode that is too fast for the step, with the shaft that makes it so."""
    numeric = model.numeric()

    def taken(mode: Mode) -> float:
        """Return what friction torques take from a mode over a step; negative if the mode is too fast."""
        omega = 2 * np.pi * mode.frequency_hz
        size = float(np.sum((numeric.friction_rows @ mode.vector) ** 2))
        return size * (float(np.sin(omega * sample_time)) / omega if omega > 0 else sample_time)

    fastest = min(modes(model), key=taken)
    strain = {
        name: float((evaluate_matrix(row, model.values)[0] @ numeric.twist_rows @ fastest.vector) ** 2)
        * float(evaluate_matrix(sp.Matrix([[model.spring_stiffness[name]]]), model.values)[0, 0])
        for name, row in model.spring_rows.items()
    }
    shaft = max(strain, key=lambda name: strain[name])
    what = (
        f"is too long for the mode at {fastest.frequency_hz:.4g} Hz, whose friction could not be solved any more "
        f"(half the sampling rate is {0.5 / sample_time:.4g} Hz)"
    )
    remedy = (
        f"connect the flanges of {shaft}, which is the stiff part of that mode, directly instead; or raise the "
        f"inertias beside it; or take a sample_time of {1e6 / (4 * fastest.frequency_hz):.0f} us or less"
    )
    return ModelError(Problem("testbed.sample_time", what, remedy))


class _Plant:
    def __init__(self, model: Model, sample_time: float) -> None:
        self.model = model
        self.sample_time = sample_time
        self.layout = Layout.of(model)
        self.signals = PlantSignals(model, self.layout)
        self._check_frictions()

    def _check_frictions(self) -> None:
        names = [friction.name for friction in self.model.frictions]
        if len(names) > MAX_ELEMENTS:
            listed = ", ".join(names)
            what = f"has {len(names)} friction elements ({listed}), more than the {MAX_ELEMENTS} that can be solved"
            raise ModelError(Problem("components", what, "leave some of them out"))
        rows = self.model.friction_rows
        for i, name in enumerate(names):
            unit = [sp.Integer(int(i == j)) for j in range(self.layout.n_z)]
            if list(rows[i, :]) != unit:
                what = f'the friction element "{name}" holds the same motion as another one'
                raise ModelError(Problem(name, what, "leave one of them out, or give the part between them an inertia"))

    def block(self) -> Block:
        layout = self.layout
        n, n_u, n_f, width = layout.n, layout.n_u, layout.n_f, layout.n + 2 * layout.n_u
        prepare, step, measure = (
            Preparation(self.model, self.layout, self.signals, self.sample_time).statements(),
            self._step(),
            self.signals.measure(),
        )
        used = {symbol.name for statement in (*prepare, *step, *measure) for symbol in _symbols(statement)}
        parameters = [
            _parameter_signal(parameter) for parameter in self.model.parameters if parameter.symbol.name in used
        ]
        parameters = [self._bounded(signal) for signal in parameters]
        sample = Signal("sample_time", "s", "step of the plant", value=self.sample_time, least=0.0, least_allowed=False)
        friction_parameters = (
            (
                Signal(
                    "standstill_speed", "rad/s", "friction velocities below this are none", value=STANDSTILL, least=0.0
                ),
            )
            if n_f
            else ()
        )
        force_columns = layout.n_z + layout.n_e + n_u + n_f
        derived = [
            Signal("transition", "", "x at the end of the step without friction torques", (n, width)),
            *(Signal(f"{m}_dead_steps", "", "whole steps of dead time") for m in self._names()),
        ]
        arrays = [
            Signal("mass", "kg m^2", "inertia matrix of the coordinates", (layout.n_z, layout.n_z)),
            Signal(
                "forces",
                "",
                "torques on the coordinates per velocity, twist, input, friction",
                (layout.n_z, force_columns),
            ),
            Signal("A", "", "state matrix, input columns, friction columns", (n, n + n_u + n_f)),
            Signal("scale", "", "balance of the exponential", (n + n_u + n_f,)),
            Signal("whole", "", "solution over the whole step", (n, n + n_u + n_f)),
            Signal("late", "", "solution over the late part of the step", (n, n + n_u + n_f)),
            Signal("early", "", "difference of both", (n, n + n_u + n_f)),
            Signal("rates", "", "accelerations per velocity, twist, input, friction", (layout.n_z, force_columns)),
            Signal("x_free", "", "states at the end of the step without friction torques", (n,)),
        ]
        derived += [
            Signal(f"{name}_reaction", "", f"{name} per velocity, twist, input, friction", (force_columns,))
            for name in self.signals.accelerated()
        ]
        states = [
            Signal(
                "x",
                "",
                "velocities, twists, air-gap torques; then the commands that act late and early",
                (width,),
                entries=self._entries(),
            ),
            *(Signal(f"{m}_delay", "N m", f"commands to {m} of past steps", (DELAY_CAPACITY,)) for m in self._names()),
        ]
        if n_f:
            derived += [
                Signal("gamma_f", "", "x at the end of the step per friction torque", (n, n_f)),
                Signal("K", "rad/(N m s)", "friction velocities lost per friction torque", (n_f, n_f)),
            ]
            arrays += [
                Signal(
                    "w_free", "rad/s", "friction velocities at the end of the step without friction torques", (n_f,)
                ),
                Signal("w_plus", "rad/s", "friction velocities at the end of the step", (n_f,)),
                Signal("capacity", "N m", "friction capacities at mid-step", (n_f,)),
            ]
            names = tuple(f.name for f in self.model.frictions)
            states.append(Signal("friction_torque", "N m", "friction torques of the last step", (n_f,), entries=names))
        return Block(
            name="plant",
            description=f"plant of the bed {self.model.name}",
            parameters=(*parameters, *friction_parameters, sample),
            inputs=tuple(Signal(f"{m}_torque_ref", "N m", f"air-gap torque reference of {m}") for m in self._names()),
            outputs=self.signals.outputs(),
            states=tuple(states),
            derived=tuple(derived),
            arrays=tuple(arrays),
            prepare=prepare,
            step=step,
            measure=measure,
        )

    def _names(self) -> list[str]:
        return [torque.name for torque in self.model.inputs]

    def _bounded(self, signal: Signal) -> Signal:
        if signal.name.endswith("_dead_time"):
            return replace(signal, most=(DELAY_CAPACITY - 1) * self.sample_time)
        return signal

    def _entries(self) -> tuple[str, ...]:
        names = self._names()
        return (
            *(f"velocity of {name} (rad/s)" for name in self.model.coordinates),
            *(f"twist of {name} (rad)" for name in self.model.twists),
            *(f"air-gap torque of {names[i]} (N m)" for i in self.layout.lagging),
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
                    "dead time of the torque loop",
                ),
            ]
        loads = self._loads()
        for name, form in loads.items():
            statements.append(Assign(f"{name}_start", self.signals.over(name, form, lambda k: element("x", k))))
        statements.append(Call("multiply", ("x_free",), ("transition", "x"), "x+ = Phi x + Gamma_u u"))
        if layout.n_f == 0:
            return (*statements, *(Assign(str(element("x", k)), element("x_free", k)) for k in range(layout.n)))
        for name, form in loads.items():
            statements.append(Assign(f"{name}_end", self.signals.over(name, form, self._predicted), "predicted"))
        for i, friction in enumerate(model.frictions):
            capacity = friction.coulomb
            if friction.load is not None:
                load = signal_name(friction.load.place)
                mean = (sp.Symbol(f"{load}_start", real=True) + sp.Symbol(f"{load}_end", real=True)) / 2
                capacity = capacity + friction.load.coefficient * sp.Abs(mean)
            statements.append(Assign(str(element("capacity", i)), capacity, "(3.34), (3.35) at mid-step"))
            statements.append(Assign(str(element("w_free", i)), element("x_free", i)))
        statements += [
            Call("solve_box", ("friction_torque", "w_plus"), ("K", "w_free", "capacity"), "|T| <= m, w+ = w - K T"),
            Call("add_product", ("x",), ("x", "x_free", "gamma_f", "friction_torque"), "x+ = x_free + Gamma_f T"),
            *(self._settled(i) for i in range(layout.n_f)),
        ]
        return tuple(statements)

    def _settled(self, i: int) -> Assign:
        """Return the statement that takes over a friction velocity.

        A velocity that dies away while its torque is at the limit would end in the rounding of zero and go back and
        forth between sticking and slipping for ever.
        """
        velocity = element("w_plus", i)
        stands = sp.Abs(velocity) < sp.Symbol("standstill_speed", real=True)
        source = "exactly zero while it sticks"
        return Assign(str(element("x", i)), sp.Piecewise((sp.Integer(0), stands), (velocity, True)), source)

    def _predicted(self, k: int) -> sp.Expr:
        if k >= self.layout.n:
            return element("x", k)
        change = sum(element("gamma_f", k, j) * element("friction_torque", j) for j in range(self.layout.n_f))
        return element("x_free", k) + change

    def _loads(self) -> dict[str, LinearForm]:
        places = dict.fromkeys(f.load.place for f in self.model.frictions if f.load is not None)
        return {signal_name(place): self.model.signals[place] for place in places}


def _symbols(statement: Statement) -> Sequence[sp.Symbol]:
    return tuple(statement.expression.free_symbols) if isinstance(statement, Assign) else ()


def _parameter_signal(parameter: Parameter) -> Signal:
    return Signal(
        parameter.symbol.name,
        parameter.unit,
        parameter.description,
        value=parameter.value,
        least=None if parameter.signed else 0.0,
        least_allowed=not parameter.positive,
    )

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

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from ptgen.block.block import Assign, Block, Call, Signal, Statement, element
from ptgen.elements import Parameter
from ptgen.errors import ModelError, Problem
from ptgen.friction.box import MAX_ELEMENTS
from ptgen.mechanism.model import LinearForm, Model

__all__ = ["DELAY_CAPACITY", "plant_block", "signal_name"]

DELAY_CAPACITY = 16
"""Steps of dead time for which every delay line has room, one more than can be asked for."""

STANDSTILL = 1e-9
"""Friction velocity (rad/s) below which an element counts as standing; one revolution in two hundred years."""

_MARGIN = 8.0
"""Factor by which tuned parameters may raise the norm of the exponential's argument."""


def signal_name(place: str) -> str:
    """Return the name of the torque signal of a place: ``diff.input`` gives ``diff_input_torque``."""
    return place.replace(".", "_") + "_torque"


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
        If the bed has more friction elements than there are closed forms, or elements that hold one motion.
    """
    return _Plant(model, sample_time).block()


@dataclass(frozen=True)
class _Layout:
    """Where things stand in the state array ``x`` and in the columns of its matrices."""

    n_z: int
    n_e: int
    lagging: tuple[int, ...]
    n_u: int
    n_f: int

    @property
    def n(self) -> int:
        """Number of true states."""
        return self.n_z + self.n_e + len(self.lagging)

    def air_gap(self, machine: int) -> int:
        """Return where the air-gap torque of a machine stands in ``x``."""
        return self.n_z + self.n_e + self.lagging.index(machine) if machine in self.lagging else self.n + machine

    def late(self, machine: int) -> int:
        """Return where the command that acts at the end of the step stands."""
        return self.n + machine

    def early(self, machine: int) -> int:
        """Return where the command that acts at the start of the step stands."""
        return self.n + self.n_u + machine


class _Plant:
    def __init__(self, model: Model, sample_time: float) -> None:
        self.model = model
        self.sample_time = sample_time
        self.layout = _Layout(
            n_z=len(model.coordinates),
            n_e=len(model.twists),
            lagging=tuple(i for i, torque in enumerate(model.inputs) if torque.drive.time_constant is not None),
            n_u=len(model.inputs),
            n_f=len(model.frictions),
        )
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
        prepare, step, measure = self._prepare(), self._step(), self._measure()
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
            for name in self._accelerated()
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
            outputs=self._outputs(),
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

    # -- prepare

    def _prepare(self) -> tuple[Statement, ...]:
        layout, model = self.layout, self.model
        n, n_z, n_e, n_u, n_f = layout.n, layout.n_z, layout.n_e, layout.n_u, layout.n_f
        h = sp.Symbol("sample_time", positive=True)
        statements: list[Statement] = list(_assign_matrix("mass", model.mass, "M = S' I S"))
        forces = model.forces()
        joined = sp.Matrix.hstack(forces.z, forces.e, forces.u, forces.f)
        statements += _assign_matrix("forces", joined, "M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z)")
        statements.append(Call("cholesky_solve", ("rates",), ("mass", "forces")))
        statements.append(Call("insert", ("A",), ("A", "rates"), numbers=(0, 0, 0, n_z + n_e)))
        statements += _assign_matrix("A", model.twist_rows, "de/dt = E z", row=n_z)
        for i, torque in enumerate(model.inputs):
            column = layout.air_gap(i)
            statements.append(Call("insert", ("A",), ("A", "rates"), numbers=(0, column, n_z + n_e + i, 1)))
            if torque.drive.time_constant is not None:
                rate = 1 / torque.drive.time_constant
                statements.append(Assign(str(element("A", column, column)), -rate, "lag of the torque loop"))
                statements.append(Assign(str(element("A", column, n + i)), rate))
        if n_f:
            numbers = (0, n + n_u, n_z + n_e + n_u, n_f)
            statements.append(Call("insert", ("A",), ("A", "rates"), numbers=numbers))
        for i in range(n + n_u + n_f):
            is_twist = n_z <= i < n_z + n_e
            statements.append(Assign(str(element("scale", i)), h if is_twist else sp.Integer(1)))
        squarings = self._squarings()
        statements.append(
            Call("discretise", ("whole",), ("A", "scale", "sample_time"), "exact discretisation", (squarings,))
        )
        statements.append(Call("insert", ("transition",), ("transition", "whole"), numbers=(0, 0, 0, n)))
        for i, torque in enumerate(model.inputs):
            statements += self._input_columns(i, torque.name, torque.drive.dead_time, h, squarings)
        if n_f:
            statements.append(Call("insert", ("gamma_f",), ("gamma_f", "whole"), numbers=(0, 0, n + n_u, n_f)))
            statements += [
                Assign(str(element("K", i, j)), -element("whole", i, n + n_u + j), "K = -G Gamma_f")
                for i in range(n_f)
                for j in range(n_f)
            ]
            statements.append(Call("require_definite", (), ("K",), "friction torques are unique"))
        for name, form in self._accelerated().items():
            for j in range(n_z + n_e + n_u + n_f):
                total = sum((form.a[k] * element("rates", k, j) for k in range(n_z) if form.a[k] != 0), sp.Integer(0))
                statements.append(Assign(str(element(f"{name}_reaction", j)), total, "d'Alembert"))
        return tuple(statements)

    def _input_columns(
        self, i: int, name: str, dead_time: sp.Expr | None, h: sp.Symbol, squarings: int
    ) -> list[Statement]:
        layout = self.layout
        column = layout.n + i
        steps = sp.Symbol(f"{name}_dead_steps", real=True)
        if dead_time is None:
            return [
                Assign(steps.name, sp.Integer(0)),
                Call("insert", ("transition",), ("transition", "whole"), numbers=(0, layout.late(i), column, 1)),
            ]
        part = f"{name}_late_time"
        return [
            Assign(steps.name, sp.floor(dead_time / h + sp.Float(1e-6)), "dead time = (d + f) h"),
            Assign(part, h - sp.Max(0, dead_time - steps * h), "the late command acts for (1 - f) h"),
            Call("discretise", ("late",), ("A", "scale", part), numbers=(squarings,)),
            Call("difference", ("early",), ("whole", "late")),
            Call("insert", ("transition",), ("transition", "late"), numbers=(0, layout.late(i), column, 1)),
            Call("insert", ("transition",), ("transition", "early"), numbers=(0, layout.early(i), column, 1)),
        ]

    def _squarings(self) -> int:
        """Return how often the exponential is squared: enough for the nominal parameters, with a margin."""
        A, B, F = self.model.numeric().state_matrices()
        n_z = self.layout.n_z
        scale = np.ones(A.shape[0])
        scale[n_z:] = self.sample_time
        joined = np.hstack([A * scale[None, :], B, F]) / scale[:, None] * self.sample_time
        values = self.model.values
        lags = [self.sample_time / values[t.drive.time_constant] for t in self.model.inputs if t.drive.time_constant]
        norm = max(float(np.abs(joined).sum(axis=0).max()), 2 * max(lags, default=0.0))
        return max(0, math.ceil(math.log2(_MARGIN * norm)))

    # -- step

    def _step(self) -> tuple[Statement, ...]:
        layout, model = self.layout, self.model
        statements: list[Statement] = []
        for i, torque in enumerate(model.inputs):
            name, drive = torque.name, torque.drive
            speed = self._over_x(model.velocity_rows[next(iter(torque.row))])
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
            statements.append(Assign(f"{name}_start", self._over(name, form, lambda k: element("x", k))))
        statements.append(Call("multiply", ("x_free",), ("transition", "x"), "x+ = Phi x + Gamma_u u"))
        if layout.n_f == 0:
            return (*statements, *(Assign(str(element("x", k)), element("x_free", k)) for k in range(layout.n)))
        for name, form in loads.items():
            statements.append(Assign(f"{name}_end", self._over(name, form, self._predicted), "predicted"))
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

    # -- signals

    def _accelerated(self) -> dict[str, LinearForm]:
        """Return the signals that depend on accelerations."""
        return {name: form for name, form in self._torques().items() if form.needs_acceleration}

    def _torques(self) -> dict[str, LinearForm]:
        signals = self.model.signals
        sensors = {sensor.name: signals[sensor.name] for sensor in self.model.sensors}
        places = {signal_name(name): form for name, form in signals.items() if name not in sensors}
        return {**sensors, **{name: form for name, form in places.items() if name not in sensors}}

    def _over_x(self, row: sp.Matrix) -> sp.Expr:
        return sum((row[k] * element("x", k) for k in range(self.layout.n_z) if row[k] != 0), sp.Integer(0))

    def _over(self, name: str, form: LinearForm, x: Callable[[int], sp.Expr]) -> sp.Expr:
        """Return a linear form as an expression; `x` gives the entries of the state array."""
        layout = self.layout
        variables: list[sp.Expr] = [
            *(x(k) for k in range(layout.n_z + layout.n_e)),
            *(x(layout.air_gap(i)) for i in range(layout.n_u)),
            *(element("friction_torque", j) for j in range(layout.n_f)),
        ]
        coefficients = [*form.z, *form.e, *form.u, *form.f]
        reaction = [
            element(f"{name}_reaction", j) if form.needs_acceleration else sp.Integer(0) for j in range(len(variables))
        ]
        return sum(
            ((c + r) * v for c, r, v in zip(coefficients, reaction, variables, strict=True) if c != 0 or r != 0),
            sp.Integer(0),
        )

    def _measure(self) -> tuple[Statement, ...]:
        layout, model = self.layout, self.model

        def x(k: int) -> sp.Expr:
            return element("x", k)

        statements: list[Statement] = [
            Assign(name, self._over(name, form, x)) for name, form in self._torques().items()
        ]
        for i, torque in enumerate(model.inputs):
            statements.append(Assign(f"{torque.name}_torque", element("x", layout.air_gap(i))))
        for i, friction in enumerate(model.frictions):
            name = friction.name.replace(".", "_")
            torque_now = element("friction_torque", i) + friction.viscous * element("x", i)
            statements += [Assign(f"{name}_torque", torque_now), Assign(f"{name}_speed", element("x", i))]
        return tuple(statements)

    def _outputs(self) -> tuple[Signal, ...]:
        outputs = []
        for name in self._torques():
            unit = "rad/s" if name.endswith("_speed") else "N m"
            outputs.append(Signal(name, unit, "measured or observed, positive to the right"))
        for torque in self.model.inputs:
            outputs.append(Signal(f"{torque.name}_torque", "N m", f"air-gap torque of {torque.name}"))
        for friction in self.model.frictions:
            name = friction.name.replace(".", "_")
            outputs.append(Signal(f"{name}_torque", "N m", f"torque of the friction element {friction.name}"))
            outputs.append(Signal(f"{name}_speed", "rad/s", f"velocity of the friction element {friction.name}"))
        return tuple(outputs)


def _assign_matrix(name: str, matrix: sp.Matrix, source: str, row: int = 0) -> list[Assign]:
    return [
        Assign(str(element(name, row + i, j)), matrix[i, j], source)
        for i in range(matrix.shape[0])
        for j in range(matrix.shape[1])
        if matrix[i, j] != 0
    ]


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

"""What the plant computes once from its parameters: the exact solution of its linear part over a step."""

from __future__ import annotations

import math

import numpy as np
import sympy as sp

from ptgen.block.block import Assign, Call, Statement, element
from ptgen.elements import Sensor
from ptgen.mechanism.dependence import is_dependent
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.plant.layout import Layout
from ptgen.plant.ratios import corners
from ptgen.plant.signals import PlantSignals

__all__ = ["Preparation"]

_MARGIN = 8.0
"""Factor by which tuned parameters may raise the norm of the exponential's argument."""


class Preparation:
    """The statements of the section ``prepare``.

    Parameters
    ----------
    model : Model
    layout : Layout
    signals : PlantSignals
    sample_time : float
        Nominal step (s); decides how often the exponential is squared.
    """

    def __init__(self, model: Model, layout: Layout, signals: PlantSignals, sample_time: float) -> None:
        self.model = model
        self.layout = layout
        self.signals = signals
        self.sample_time = sample_time

    def statements(self) -> tuple[Statement, ...]:
        """Return the statements in order."""
        layout, model = self.layout, self.model
        n, n_z, n_e, n_u, n_t = layout.n, layout.n_z, layout.n_e, layout.n_u, layout.n_t
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
        if n_t:
            numbers = (0, n + n_u, n_z + n_e + n_u, n_t)
            statements.append(Call("insert", ("A",), ("A", "rates"), numbers=numbers))
        statements += self._filters()
        balance = self._filter_scales()
        for i in range(n + n_u + n_t):
            is_twist = n_z <= i < n_z + n_e
            statements.append(Assign(str(element("scale", i)), h if is_twist else balance.get(i, sp.Integer(1))))
        squarings = self._squarings()
        statements.append(
            Call("discretise", ("whole",), ("A", "scale", "sample_time"), "exact discretisation", (squarings,))
        )
        statements.append(Call("insert", ("transition",), ("transition", "whole"), numbers=(0, 0, 0, n)))
        for i, torque in enumerate(model.inputs):
            statements += self._input_columns(i, torque.name, torque.drive.delay, h, squarings)
        if n_t:
            statements.append(Call("insert", ("gamma",), ("gamma", "whole"), numbers=(0, 0, n + n_u, n_t)))
        if layout.n_f:
            statements += self._lost("K", model.friction_rows, 0, n + n_u, "K = -G Gamma_f")
            if not all(self.signals.is_state(i) for i in range(layout.n_f)):
                statements.append(Call("rounding_unit", ("velocity_rounding",), (), "of a sum of velocities"))
            statements.append(
                Call("require_definite", (), ("K",), "friction can be solved", (int(is_dependent(model)),))
            )
        if layout.n_c:
            first = n + n_u + layout.n_f
            statements += self._lost("kappa", model.contact_twists, n_z, first, "twist lost per torque of a contact")
            for i, contact in enumerate(model.contacts):
                statements += [
                    Assign(str(element("half_gap", i)), sp.sympify(contact.backlash) / 2, "(3.5)"),
                    Assign(str(element("contact_stiffness", i)), contact.stiffness),
                    Assign(str(element("contact_damping", i)), contact.damping / h),
                ]
        for name, form in self.signals.accelerated().items():
            for j in range(n_z + n_e + n_u + n_t):
                total = sum((form.a[k] * element("rates", k, j) for k in range(n_z) if form.a[k] != 0), sp.Integer(0))
                statements.append(Assign(str(element(f"{name}_reaction", j)), total, "d'Alembert"))
        return tuple(statements)

    def _filters(self) -> list[Assign]:
        """Return the rows of the sensors' low passes: ``dy/dt = (y_true - y) / tau``.

        What is measured is linear in velocities, twists, torques and accelerations, and these are linear in the same
        without them: so a filter is part of the linear system, and a reading with feed-through is nothing special.
        """
        layout = self.layout
        statements = []
        for sensor, time_constant in self._filtered():
            form, row = self.model.signals[sensor.name], layout.measured(sensor.name)
            for j, (coefficient, column) in enumerate(self._columns(form)):
                terms = [form.a[k] * element("rates", k, j) for k in range(layout.n_z) if form.a[k] != 0]
                total = sum(terms, sp.sympify(coefficient))
                if total != 0:
                    target = str(element("A", row, column))
                    statements.append(Assign(target, total / time_constant, f"low pass of {sensor.name}"))
            statements.append(Assign(str(element("A", row, row)), -1 / time_constant))
        return statements

    def _filtered(self) -> list[tuple[Sensor, sp.Expr]]:
        """Return the sensors with a low pass, and its time constant."""
        return [(s, s.time_constant) for s in self.model.sensors if s.time_constant is not None]

    def _columns(self, form: LinearForm) -> list[tuple[sp.Expr, int]]:
        """Return the coefficients of a form over (z, e, u, friction and contacts) with the columns where they stand."""
        layout = self.layout
        columns = [
            *range(layout.n_z + layout.n_e),
            *(layout.air_gap(i) for i in range(layout.n_u)),
            *(layout.n + layout.n_u + j for j in range(layout.n_t)),
        ]
        return list(zip([*form.z, *form.e, *form.u, *form.f], columns, strict=True))

    def _filter_scales(self) -> dict[int, sp.Expr]:
        """Return powers of two that make the rows of the filters about as large as the others."""
        scales = {}
        for sensor, _ in self._filtered():
            form = self.model.signals[sensor.name]
            z, e = (evaluate_matrix(part, self.model.values) for part in (form.z, form.e))
            size = float(np.abs(z).sum() + self.sample_time * np.abs(e).sum())
            scales[self.layout.measured(sensor.name)] = sp.Integer(2) ** max(0, math.ceil(math.log2(max(1.0, size))))
        return scales

    def _lost(self, name: str, rows: sp.Matrix, first_row: int, first: int, source: str) -> list[Assign]:
        """Return the matrix of what `rows` over the states from `first_row` on lose per torque; it is symmetric."""

        def entry(i: int, j: int) -> sp.Expr:
            terms = [-rows[i, k] * element("whole", first_row + k, first + j) for k in range(rows.shape[1])]
            return sum((term for term in terms if term != 0), sp.Integer(0))

        size = range(rows.shape[0])
        return [Assign(str(element(name, i, j)), entry(i, j), source) for i in size for j in size]

    def _input_columns(self, i: int, name: str, delay: sp.Expr | None, h: sp.Symbol, squarings: int) -> list[Statement]:
        layout = self.layout
        column = layout.n + i
        steps = sp.Symbol(f"{name}_dead_steps", real=True)
        if delay is None:
            return [
                Assign(steps.name, sp.Integer(0)),
                Call("insert", ("transition",), ("transition", "whole"), numbers=(0, layout.late(i), column, 1)),
            ]
        part = f"{name}_late_time"
        what = "dead time" if self.model.inputs[i].drive.computation_delay is None else "computation and dead time"
        return [
            Assign(steps.name, sp.floor(delay / h + sp.Float(1e-6)), f"{what} = (d + f) h"),
            Assign(part, h - sp.Max(0, delay - steps * h), "the late command acts for (1 - f) h"),
            Call("discretise", ("late",), ("A", "scale", part), numbers=(squarings,)),
            Call("difference", ("early",), ("whole", "late")),
            Call("insert", ("transition",), ("transition", "late"), numbers=(0, layout.late(i), column, 1)),
            Call("insert", ("transition",), ("transition", "early"), numbers=(0, layout.early(i), column, 1)),
        ]

    def _squarings(self) -> int:
        """Return how often the exponential is squared: enough for the nominal parameters, with a margin."""
        norm = max(self._norm(model) for model in corners(self.model))
        return max(0, math.ceil(math.log2(_MARGIN * norm)))

    def _norm(self, model: Model) -> float:
        """Return the size of the exponential's argument, balanced."""
        A, B, F = model.numeric().state_matrices()
        n_z = self.layout.n_z
        scale = np.ones(A.shape[0])
        scale[n_z:] = self.sample_time
        joined = np.hstack([A * scale[None, :], B, F]) / scale[:, None] * self.sample_time
        values = model.values
        lags = [self.sample_time / values[t.drive.time_constant] for t in model.inputs if t.drive.time_constant]
        norm = max(float(np.abs(joined).sum(axis=0).max()), 2 * max(lags, default=0.0))
        return norm + sum(self.sample_time / values[time_constant] for _, time_constant in self._filtered())


def _assign_matrix(name: str, matrix: sp.Matrix, source: str, row: int = 0) -> list[Assign]:
    return [
        Assign(str(element(name, row + i, j)), matrix[i, j], source)
        for i in range(matrix.shape[0])
        for j in range(matrix.shape[1])
        if matrix[i, j] != 0
    ]

"""What the plant computes once from its parameters: the exact solution of its linear part over a step."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import sympy as sp

from ptgen.block.block import Assign, Call, Statement, element
from ptgen.elements import Sensor
from ptgen.mechanism.dependence import is_dependent, rank_deficient
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.plant.layout import Layout
from ptgen.plant.ratios import corners
from ptgen.plant.signals import PlantSignals

__all__ = ["Preparation"]

_MARGIN = 8.0
"""Factor by which tuned parameters may raise the norm of the exponential's argument."""


class Preparation:
    """The statements of the sections ``prepare`` and ``refresh``.

    A ratio that stands in the rows of friction elements only, a *quick* one, is no matter of the linear part: that is
    solved for torques on the coordinates on which these elements act, and each torque is put together from them anew
    when the ratio has changed, with its row G(i)::

        Gamma_T = Gamma_z G',    K = G K_z G'

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
        n, n_z, n_e, n_u, n_s = layout.n, layout.n_z, layout.n_e, layout.n_u, layout.n_s
        h = sp.Symbol("sample_time", positive=True)
        statements: list[Statement] = [*self.signals.preparation(), *_assign_matrix("mass", model.mass, "M = S' I S")]
        forces = model.forces()
        joined = sp.Matrix.hstack(forces.z, forces.e, forces.u, self._torque_columns(forces.f))
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
        if n_s:
            numbers = (0, n + n_u, n_z + n_e + n_u, n_s)
            statements.append(Call("insert", ("A",), ("A", "rates"), numbers=numbers))
        statements += self._filters()
        balance = self._filter_scales()
        for i in range(n + n_u + n_s):
            is_twist = n_z <= i < n_z + n_e
            statements.append(Assign(str(element("scale", i)), h if is_twist else balance.get(i, sp.Integer(1))))
        squarings = self._squarings()
        statements.append(
            Call("discretise", ("whole",), ("A", "scale", "sample_time"), "exact discretisation", (squarings,))
        )
        statements.append(Call("insert", ("transition",), ("transition", "whole"), numbers=(0, 0, 0, n)))
        for i, torque in enumerate(model.inputs):
            statements += self._input_columns(i, torque.name, torque.drive.delay, h, squarings)
        statements += self._torque_solutions()
        if layout.n_f:
            statements += self._friction_matrix()
        if layout.n_c:
            first = n + n_u + layout.n_f - len(layout.turning)
            statements += self._lost("kappa", model.contact_twists, n_z, first, "twist lost per torque of a contact")
            for i, contact in enumerate(model.contacts):
                statements += [
                    Assign(str(element("half_gap", i)), sp.sympify(contact.backlash) / 2, "(3.5)"),
                    Assign(str(element("contact_stiffness", i)), contact.stiffness),
                    Assign(str(element("contact_damping", i)), contact.damping / h),
                ]
        for name, form in self.signals.accelerated().items():
            for j, place in enumerate(self._solved_columns()):
                if place is not None:
                    target = element(f"{name}_reaction", j)
                    statements.append(Assign(str(target), self._reaction(form, place), "d'Alembert"))
            for s in range(len(layout.pressed)):
                target = element(f"{name}_pressed", s)
                statements.append(Assign(str(target), self._reaction(form, n_z + n_e + n_u + len(layout.solved) + s)))
        return tuple(statements)

    def refresh(self) -> tuple[Statement, ...]:
        """Return what follows from quick ratios."""
        layout, G = self.layout, self.model.friction_rows
        statements: list[Statement] = []

        def together(row: sp.Matrix, of: str, *before: int) -> sp.Expr:
            terms = (row[k] * element(of, *before, s) for s, k in enumerate(layout.pressed) if row[k] != 0)
            return sum(terms, sp.Integer(0))

        for j in layout.turning:
            for i in range(layout.n):
                total = together(G[j, :], "gamma_pressed", i)
                statements.append(Assign(str(element("gamma", i, j)), total, "Gamma_T = Gamma_z G'"))
        base = self._base_rows()
        for i in range(layout.n_f):
            for j in range(layout.n_f):
                if i in layout.turning or j in layout.turning:
                    total = sum(
                        (p * q * element("K_base", a, b) for a, p in base[i] for b, q in base[j]), sp.Integer(0)
                    )
                    statements.append(Assign(str(element("K", i, j)), total, "K = G K_z G'"))
        for name in self.signals.accelerated():
            for j in layout.turning:
                target = element(f"{name}_reaction", layout.n_z + layout.n_e + layout.n_u + j)
                statements.append(Assign(str(target), together(G[j, :], f"{name}_pressed"), "d'Alembert"))
        return tuple(statements)

    def _torque_columns(self, columns: sp.Matrix) -> sp.Matrix:
        """Return the columns of torques: those that are solved, then friction torques on the coordinates `pressed`."""
        layout = self.layout
        if not layout.turning:
            return columns
        units = sp.zeros(layout.n_z, len(layout.pressed))
        for s, k in enumerate(layout.pressed):
            units[k, s] = sp.Integer(-1)
        return sp.Matrix.hstack(columns[:, list(layout.solved)], units)

    def _solved_columns(self) -> list[int | None]:
        """Return where the columns of (z, e, u, friction and contacts) stand among those that were solved."""
        layout = self.layout
        first = layout.n_z + layout.n_e + layout.n_u
        places = {j: first + at for at, j in enumerate(layout.solved)}
        return [*range(first), *(places.get(j) for j in range(layout.n_t))]

    def _reaction(self, form: LinearForm, column: int) -> sp.Expr:
        terms = (form.a[k] * element("rates", k, column) for k in range(self.layout.n_z) if form.a[k] != 0)
        return sum(terms, sp.Integer(0))

    def _torque_solutions(self) -> list[Statement]:
        """Return the statements that take torque columns over from the solution."""
        layout = self.layout
        first = layout.n + layout.n_u
        if not layout.turning:
            numbers = (0, 0, first, layout.n_t)
            return [Call("insert", ("gamma",), ("gamma", "whole"), numbers=numbers)] if layout.n_t else []
        statements: list[Statement] = [
            Call("insert", ("gamma",), ("gamma", "whole"), numbers=(0, j, first + at, 1))
            for at, j in enumerate(layout.solved)
        ]
        numbers = (0, 0, first + len(layout.solved), len(layout.pressed))
        return [*statements, Call("insert", ("gamma_pressed",), ("gamma_pressed", "whole"), numbers=numbers)]

    def _friction_matrix(self) -> list[Statement]:
        layout, model = self.layout, self.model
        G, first = model.friction_rows, layout.n + layout.n_u
        statements: list[Statement] = []
        name, dependent = "K", is_dependent(model)
        if not layout.turning:
            statements += self._lost(name, G, 0, first, "K = -G Gamma_f")
        else:
            name = "K_base"
            steady = [j for j in layout.solved if j < layout.n_f]
            units = [sp.Matrix([[int(k == at) for k in range(layout.n_z)]]) for at in layout.pressed]
            rows = sp.Matrix.vstack(*(G[j, :] for j in steady), *units)
            columns = [*range(len(steady)), *(len(layout.solved) + s for s in range(len(units)))]
            dependent = rank_deficient(model, rows)
            statements += self._lost(name, rows, 0, first, "K = -G Gamma_f, also on pressed coordinates", columns)
            statements += [
                Assign(str(element("K", i, j)), element(name, a, b))
                for a, i in enumerate(steady)
                for b, j in enumerate(steady)
            ]
        if not all(self.signals.is_state(i) for i in range(layout.n_f)):
            statements.append(Call("rounding_unit", ("velocity_rounding",), (), "of a sum of velocities"))
        statements.append(Call("require_definite", (), (name,), "friction can be solved", (int(dependent),)))
        return statements

    def _base_rows(self) -> list[list[tuple[int, sp.Expr]]]:
        """Return each friction element as a combination of those that ``K_base`` is for: places and factors."""
        layout, G = self.layout, self.model.friction_rows
        steady = [j for j in range(layout.n_f) if j not in layout.turning]
        return [
            [(steady.index(j), sp.Integer(1))]
            if j not in layout.turning
            else [(len(steady) + s, G[j, k]) for s, k in enumerate(layout.pressed) if G[j, k] != 0]
            for j in range(layout.n_f)
        ]

    def _filters(self) -> list[Assign]:
        """Return the rows of the sensors' low passes: ``dy/dt = (y_true - y) / tau``.

        What is measured is linear in velocities, twists, torques and accelerations, and these are linear in the same
        without them: so a filter is part of the linear system, and a reading with feed-through is nothing special.
        """
        layout = self.layout
        statements = []
        for sensor, time_constant in self._filtered():
            form, row = self.model.signals[sensor.name], layout.measured(sensor.name)
            solved = self._solved_columns()
            columns = [(c, column, j) for (c, column), j in zip(self._columns(form), solved, strict=True)]
            for coefficient, column, j in columns:
                if j is None:
                    continue  # of an element whose row changes: `quick_ratios` has seen to it that nothing is there
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
            *(layout.n + layout.n_u + (layout.solved.index(j) if j in layout.solved else 0) for j in range(layout.n_t)),
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

    def _lost(
        self,
        name: str,
        rows: sp.Matrix,
        first_row: int,
        first: int,
        source: str,
        columns: Sequence[int] | None = None,
    ) -> list[Assign]:
        """Return the matrix of what `rows` over the states from `first_row` on lose per torque; it is symmetric.

        The torques stand in the solution from the column `first` on, one after the other or in `columns`.
        """
        at = range(rows.shape[0]) if columns is None else columns

        def entry(i: int, j: int) -> sp.Expr:
            terms = [-rows[i, k] * element("whole", first_row + k, first + at[j]) for k in range(rows.shape[1])]
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

r"""Minimal equations of motion of a bed.

.. math::
    M \dot z = B' u - E'(C e + D E z) - G'(T + \mathrm{diag}(k_v) G z) - H' T_c - W' T_w, \qquad \dot e = E z

with velocities ``z``, twists ``e``, air-gap torques ``u``, friction torques ``T``, the torques ``T_c`` of shafts
with backlash, the *contacts*, and the torques ``T_w`` of fluids, functions of the velocities. ``M``, ``C`` and ``D``
are symmetric; friction acts through the transpose of the rows that give its velocities, so it is dissipative by
construction (source (4.22)-(4.25)).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.elements import FluidCoupling, Friction, Parameter, Sensor, Spring, Torque
from ptgen.mechanism import exact

__all__ = ["LinearForm", "Model", "NumericModel", "evaluate_matrix"]


@dataclass(frozen=True)
class LinearForm:
    """A signal as a linear function of the model's variables.

    ``z . velocities + e . twists + u . inputs + f . friction torques + a . accelerations``; each part is a row. The
    columns of ``f`` are the friction elements, then the contacts, then pump and turbine of each fluid.
    """

    z: sp.Matrix
    e: sp.Matrix
    u: sp.Matrix
    f: sp.Matrix
    a: sp.Matrix

    def __add__(self, other: LinearForm) -> LinearForm:
        return LinearForm(self.z + other.z, self.e + other.e, self.u + other.u, self.f + other.f, self.a + other.a)

    def mapped(self, function: Callable[[sp.Matrix], sp.Matrix]) -> LinearForm:
        """Return the form with `function` applied to each part."""
        return LinearForm(*(function(part) for part in (self.z, self.e, self.u, self.f, self.a)))

    def scaled(self, factor: sp.Expr | int) -> LinearForm:
        """Return the form times `factor`."""
        return LinearForm(*(part * factor for part in (self.z, self.e, self.u, self.f, self.a)))

    @property
    def needs_acceleration(self) -> bool:
        """Whether the signal depends on accelerations."""
        return any(entry != 0 for entry in self.a)


@dataclass(frozen=True)
class Model:
    """Symbolic equations of motion; see the module for the equation.

    Attributes
    ----------
    name : str
        Name of the bed.
    coordinates : tuple of str (n_z)
        Names of the independent velocities.
    velocity_rows : mapping of str to Matrix (1, n_z)
        Every velocity of the bed in the independent ones.
    mass : Matrix (n_z, n_z)
    twists : tuple of str (n_e)
    twist_rows : Matrix (n_e, n_z)
        ``E``.
    stiffness, damping : Matrix (n_e, n_e)
        ``C`` (N m/rad) and ``D`` (N m s/rad).
    inputs : tuple of Torque (n_u)
    input_rows : Matrix (n_u, n_z)
        ``B``.
    frictions : tuple of Friction (n_f)
    friction_rows : Matrix (n_f, n_z)
        ``G``.
    sensors : tuple of Sensor
    signals : mapping of str to LinearForm
        Every sensor and every place where a torque is defined.
    parameters : tuple of Parameter
    body_rows : mapping of str to Matrix (1, n_z)
        Rows of the velocities that carry inertia.
    body_inertias : mapping of str to Expr
        Inertia on these velocities (kg m^2).
    spring_rows : mapping of str to Matrix (1, n_e)
        Each spring's twist in the twist states.
    spring_stiffness, spring_damping : mapping of str to Expr
        Each spring's own parameters.
    fixed : tuple of Symbol
        Parameters that the model holds at their values: the ratios of rigid loops, which must agree exactly.
    contacts : tuple of Spring (n_c)
        Shafts with backlash; their torques are variables like those of friction, and not part of ``C`` and ``D``.
    contact_rows : Matrix (n_c, n_z)
        ``H``, their twist rates.
    contact_twists : Matrix (n_c, n_e)
        Their twists in the twist states.
    fluids : tuple of FluidCoupling (n_w / 2)
        Fluids between a pump and a turbine; the linear analyses have none.
    fluid_rows : Matrix (n_w, n_z)
        ``W``, the rows of pump and turbine of each, see `ptgen.elements.FluidCoupling.rows`.
    """

    name: str
    coordinates: tuple[str, ...]
    velocity_rows: Mapping[str, sp.Matrix]
    mass: sp.Matrix
    twists: tuple[str, ...]
    twist_rows: sp.Matrix
    stiffness: sp.Matrix
    damping: sp.Matrix
    inputs: tuple[Torque, ...]
    input_rows: sp.Matrix
    frictions: tuple[Friction, ...]
    friction_rows: sp.Matrix
    sensors: tuple[Sensor, ...]
    signals: Mapping[str, LinearForm]
    parameters: tuple[Parameter, ...]
    body_rows: Mapping[str, sp.Matrix]
    body_inertias: Mapping[str, sp.Expr]
    spring_rows: Mapping[str, sp.Matrix]
    spring_stiffness: Mapping[str, sp.Expr]
    spring_damping: Mapping[str, sp.Expr]
    fixed: tuple[sp.Symbol, ...] = ()
    contacts: tuple[Spring, ...] = ()
    contact_rows: sp.Matrix = field(default_factory=lambda: sp.zeros(0, 0))
    contact_twists: sp.Matrix = field(default_factory=lambda: sp.zeros(0, 0))
    fluids: tuple[FluidCoupling, ...] = ()
    fluid_rows: sp.Matrix = field(default_factory=lambda: sp.zeros(0, 0))

    @property
    def order(self) -> int:
        """Number of states: velocities and twists."""
        return len(self.coordinates) + len(self.twists)

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the states, velocities first."""
        return self.coordinates + tuple(f"twist {name}" for name in self.twists)

    @property
    def values(self) -> dict[sp.Symbol, float]:
        """Value of every parameter, by symbol."""
        return {parameter.symbol: parameter.value for parameter in self.parameters}

    @property
    def changing(self) -> tuple[Parameter, ...]:
        """The parameters that change while the bed runs: ratios that are inputs of plant and controller.

        The matrices of the model hold at every moment. No row of a body depends on them, so ``S' M dS/dt z`` vanishes,
        and `mass` is constant; ``E`` and ``G`` may depend on them.
        """
        return tuple(parameter for parameter in self.parameters if parameter.span is not None)

    @property
    def viscous(self) -> sp.Matrix:
        """Viscous friction coefficients as a diagonal matrix (n_f, n_f)."""
        return sp.diag(*[friction.linear_viscous for friction in self.frictions]) if self.frictions else sp.zeros(0, 0)

    def shape_rows(self) -> dict[str, sp.Matrix]:
        """Return the rows of the velocities that show a mode's shape: rotors, all that carry inertia, then the rest.

        A connected flange has the velocity of its neighbour; each velocity is listed once, under the first name.
        """
        rotors = [next(iter(torque.row)) for torque in self.inputs]
        rows: dict[str, sp.Matrix] = {name: self.velocity_rows[name] for name in rotors}
        for name, row in (*self.body_rows.items(), *self.velocity_rows.items()):
            if row not in rows.values() and any(entry != 0 for entry in row):
                rows[name] = row
        return rows

    def forces(self) -> LinearForm:
        """Return the generalised torques on the coordinates, ``M dz/dt``; its rows are (n_z, .) matrices."""
        E, G, B = self.twist_rows, self.friction_rows, self.input_rows
        pairs = ((self.contacts, self.contact_rows), (self.fluids, self.fluid_rows))
        return LinearForm(
            z=-E.T * self.damping * E - G.T * self.viscous * G,
            e=-E.T * self.stiffness,
            u=B.T,
            f=sp.Matrix.hstack(-G.T, *(-rows.T for elements, rows in pairs if elements)),
            a=sp.zeros(len(self.coordinates), len(self.coordinates)),
        )

    def accelerations(self) -> LinearForm:
        """Return ``dz/dt`` as matrices over (z, e, u, f), by exact elimination; meant for small models."""
        forces = self.forces()
        widths = [part.shape[1] for part in (forces.z, forces.e, forces.u, forces.f)]
        joined = sp.Matrix.hstack(forces.z, forces.e, forces.u, forces.f)
        solved = exact.solve(self.mass, joined)
        ends = np.cumsum([0, *widths])
        parts = [solved[:, int(start) : int(end)] for start, end in itertools.pairwise(ends)]
        z, e, u, f = parts
        return LinearForm(z, e, u, f, sp.zeros(*self.mass.shape))

    def without_acceleration(self, form: LinearForm) -> LinearForm:
        """Return `form` with the accelerations replaced by the equations of motion."""
        if not form.needs_acceleration:
            return form
        rates = self.accelerations()
        parts = [
            exact.canonical(mine + form.a * rate)
            for mine, rate in (
                (form.z, rates.z),
                (form.e, rates.e),
                (form.u, rates.u),
                (form.f, rates.f),
            )
        ]
        z, e, u, f = parts
        return LinearForm(z, e, u, f, sp.zeros(1, len(self.coordinates)))

    def with_numbers(self) -> Model:
        """Return the model with all parameters as rational numbers, right to twelve digits, for quick exact algebra."""
        table = {symbol: Fraction(f"{value:.12g}") for symbol, value in self.values.items()}

        def numbers(matrix: sp.Matrix) -> sp.Matrix:
            return exact.valued(matrix, table)

        return replace(
            self,
            velocity_rows={name: numbers(row) for name, row in self.velocity_rows.items()},
            mass=numbers(self.mass),
            twist_rows=numbers(self.twist_rows),
            stiffness=numbers(self.stiffness),
            damping=numbers(self.damping),
            input_rows=numbers(self.input_rows),
            frictions=tuple(
                replace(friction, viscous=numbers(sp.Matrix([[friction.viscous]]))[0]) for friction in self.frictions
            ),
            friction_rows=numbers(self.friction_rows),
            signals={name: form.mapped(numbers) for name, form in self.signals.items()},
            contact_rows=numbers(self.contact_rows),
            contact_twists=numbers(self.contact_twists),
            fluid_rows=numbers(self.fluid_rows),
        )

    def numeric(self, values: Mapping[sp.Symbol, float] | None = None) -> NumericModel:
        """Evaluate all matrices; `values` override the parameters of the bed."""
        table = {**self.values, **(values or {})}

        def evaluate(matrix: sp.Matrix) -> NDArray[np.float64]:
            return evaluate_matrix(matrix, table)

        return NumericModel(
            mass=evaluate(self.mass),
            stiffness=evaluate(self.stiffness),
            damping=evaluate(self.damping),
            twist_rows=evaluate(self.twist_rows),
            friction_rows=evaluate(self.friction_rows),
            input_rows=evaluate(self.input_rows),
            viscous=evaluate(self.viscous),
            contact_rows=evaluate(self.contact_rows) if self.contacts else np.zeros((0, len(self.coordinates))),
            fluid_rows=evaluate(self.fluid_rows) if self.fluids else np.zeros((0, len(self.coordinates))),
        )


@dataclass(frozen=True)
class NumericModel:
    """The matrices of a `Model` as arrays, same names and shapes."""

    mass: NDArray[np.float64]
    stiffness: NDArray[np.float64]
    damping: NDArray[np.float64]
    twist_rows: NDArray[np.float64]
    friction_rows: NDArray[np.float64]
    input_rows: NDArray[np.float64]
    viscous: NDArray[np.float64]
    contact_rows: NDArray[np.float64]
    fluid_rows: NDArray[np.float64]

    def state_matrices(self) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Return ``A (n, n)``, ``B (n, n_u)``, ``F (n, n_f + n_c + n_w)``: ``dx/dt = A x + B u + F T``, x = (z, e)."""
        E, G = self.twist_rows, self.friction_rows
        n_z, n_e = self.mass.shape[0], E.shape[0]
        joined = np.hstack([-E.T @ self.damping @ E - G.T @ self.viscous @ G, -E.T @ self.stiffness])
        A = np.zeros((n_z + n_e, n_z + n_e))
        A[:n_z] = np.linalg.solve(self.mass, joined)
        A[n_z:, :n_z] = E
        B = np.zeros((n_z + n_e, self.input_rows.shape[0]))
        B[:n_z] = np.linalg.solve(self.mass, self.input_rows.T)
        rows = np.vstack([G, self.contact_rows, self.fluid_rows])
        F = np.zeros((n_z + n_e, rows.shape[0]))
        F[:n_z] = np.linalg.solve(self.mass, -rows.T)
        return A, B, F


def evaluate_matrix(matrix: sp.Matrix, values: Mapping[sp.Symbol, float]) -> NDArray[np.float64]:
    """Evaluate a matrix of rational expressions at `values`."""
    result = np.zeros(matrix.shape)
    for (row, column), entry in sp.SparseMatrix(matrix).todok().items():
        result[row, column] = _value(entry, values)
    return result


def _value(expression: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """Evaluate a rational expression; much faster than making a function of each entry."""
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Number:
        return float(expression)
    if expression.is_Add:
        return sum(_value(argument, values) for argument in expression.args)
    if expression.is_Mul:
        return math.prod(_value(argument, values) for argument in expression.args)
    if expression.is_Pow:
        return float(_value(expression.base, values) ** _value(expression.exp, values))
    raise TypeError(f"{expression} is no rational expression")

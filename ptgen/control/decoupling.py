"""Input-output decoupling with active damping, from measured signals only (source Section 5.4).

Desired dynamics: a controlled speed becomes ``1 / (I_m s)`` (5.49), (5.70); a controlled torque keeps the natural
stiffness that its machine sees and gets the damping that is asked for (5.57), (5.76), so that the twist drops out
of the law. Then all that is left of states and disturbances is written as a combination of sensors, the machine's
own ones first; the unknown friction torque of the unit under test drops out with it (5.74).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.control import findings
from ptgen.control.lie import AffineSystem, OutputChain, affine_system, derivatives
from ptgen.control.measured_law import Law, measured_law
from ptgen.elements import SensorKind
from ptgen.errors import ControlError
from ptgen.mechanism import exact
from ptgen.mechanism.abbreviation import abbreviate
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.mechanism.reduction import ReducedModel
from ptgen.testbed.testbed import Roles

__all__ = ["Decoupling", "decouple"]


@dataclass(frozen=True)
class Decoupling:
    """The result of the general procedure.

    Attributes
    ----------
    machines : tuple of str (m)
        Machines in the order of the inputs.
    outputs : tuple of str (m)
        Controlled quantities, torques first.
    actuators : tuple of int (m)
        Which machine is responsible for each output.
    torque_count : int
        How many of the outputs are torques.
    sensors : tuple of str (n_s)
    model : Model
        The reduced model with the tunable inertias in place.
    system : AffineSystem
    chains : tuple of OutputChain (m)
    matrix : Matrix (m, m)
        The decoupling matrix (5.29).
    internal_eigenvalues : ndarray
        Eigenvalues of the internal dynamics (5.41); empty for maximum relative degree.
    law : Law
    damping, inertia_estimate : tuple of Symbol
        Tunable damping (N m s/rad) and inertia (kg m^2) of each torque-controlled machine.
    stiffness : tuple of Expr
        Natural stiffness that each torque-controlled machine sees (N m/rad).
    values : mapping of Symbol to float
    definitions : mapping of Symbol to Expr
        What the stiffnesses of equivalent shafts stand for.
    """

    machines: tuple[str, ...]
    outputs: tuple[str, ...]
    actuators: tuple[int, ...]
    torque_count: int
    sensors: tuple[str, ...]
    model: Model
    system: AffineSystem
    chains: tuple[OutputChain, ...]
    matrix: sp.Matrix
    internal_eigenvalues: NDArray[np.complex128]
    law: Law
    state_law: tuple[sp.Matrix, sp.Matrix, sp.Matrix]
    damping: tuple[sp.Symbol, ...]
    inertia_estimate: tuple[sp.Symbol, ...]
    stiffness: tuple[sp.Expr, ...]
    values: dict[sp.Symbol, float]
    definitions: Mapping[sp.Symbol, sp.Expr]

    @property
    def relative_degrees(self) -> tuple[int, ...]:
        """Relative degree of each output (5.35)."""
        return tuple(chain.relative_degree or 0 for chain in self.chains)

    @property
    def internal_order(self) -> int:
        """Order of the internal dynamics, N minus the total relative degree (5.36)."""
        return self.system.order - sum(self.relative_degrees)

    def law_expressions(self) -> dict[str, sp.Expr]:
        """Return the law of each machine over ``v_<machine>`` and the sensors, like (5.74) and (5.78)."""
        virtual = sp.Matrix([sp.Symbol(f"v_{self.machines[machine]}") for machine in self.actuators])
        measured = sp.Matrix([sp.Symbol(sensor) for sensor in self.sensors])
        rows = self.law.P * virtual + self.law.R * measured
        return {name: _by_terms(rows[index]) for index, name in enumerate(self.machines)}


def decouple(reduced: ReducedModel, roles: Roles) -> Decoupling:
    """Design the decoupling law for the roles of the machines.

    Raises
    ------
    ControlError
        If the decoupling matrix is singular, if internal dynamics are not asymptotically stable, or if no
        combination of sensors gives a state that the law needs. The error names the cause, and other roles
        that would work.

    References
    ----------
    Source (5.23)-(5.41), (5.52), (5.62), (5.74), (5.75), (5.78).
    """
    machines = tuple(torque.name for torque in reduced.model.inputs)
    try:
        return _decouple(reduced, roles, machines)
    except ControlError as error:

        def works(other: Roles) -> bool:
            try:
                _decouple(reduced, other, machines)
            except ControlError:
                return False
            return True

        raise findings.with_advice(error, machines, roles, works) from None


def _decouple(reduced: ReducedModel, roles: Roles, machines: tuple[str, ...]) -> Decoupling:
    actuators = tuple(machines.index(name) for name in (*roles.torque, *roles.speed))
    torque_count = len(roles.torque)
    short = abbreviate(reduced.model)
    estimates, model, values = _with_inertia_estimates(short.model, machines, actuators[:torque_count])
    forms = _output_forms(model, roles)
    system = affine_system(model)
    chains = tuple(derivatives(system, name, form) for name, form in forms.items())
    matrix = exact.stack([chain.input_row for chain in chains], len(machines))
    findings.check_degrees(chains, roles)
    findings.check_regular(matrix, values, model, torque_count)
    damping = tuple(sp.Symbol(f"{name}_damping", nonnegative=True) for name in roles.torque)
    stiffness = _natural_stiffness(system, chains, actuators, torque_count, estimates)
    state_law = _state_law(
        system,
        chains,
        matrix,
        actuators,
        torque_count,
        damping,
        estimates,
        stiffness,
        _rotors(model),
        tuple(form.f for form in forms.values()),
    )
    table = {**values, **dict.fromkeys(damping, 1.0)}
    eigenvalues = _internal_eigenvalues(system, model, chains, state_law, table, reduced.equivalent_damping)
    findings.check_internal(eigenvalues, _swinging(reduced), model, torque_count)
    sensors = tuple(sensor.name for sensor in model.sensors)
    law = measured_law(
        reduced.original, model, chains, state_law, forms, actuators, torque_count, machines, _swinging(reduced)
    )
    return Decoupling(
        machines=machines,
        outputs=tuple(forms),
        actuators=actuators,
        torque_count=torque_count,
        sensors=sensors,
        model=model,
        system=system,
        chains=chains,
        matrix=matrix,
        internal_eigenvalues=eigenvalues,
        law=law,
        state_law=state_law,
        damping=damping,
        inertia_estimate=estimates,
        stiffness=stiffness,
        values=values,
        definitions={**reduced.definitions, **short.definitions},
    )


def _with_inertia_estimates(
    model: Model, machines: tuple[str, ...], torque_machines: tuple[int, ...]
) -> tuple[tuple[sp.Symbol, ...], Model, dict[sp.Symbol, float]]:
    """Put a tunable symbol in place of the whole inertia on each torque-controlled machine, I1_hat of (5.78)."""
    values = dict(model.values)
    mass = model.mass.copy()
    estimates = []
    for machine in torque_machines:
        symbol = sp.Symbol(f"{machines[machine]}_inertia_estimate", positive=True)
        values[symbol] = float(evaluate_matrix(mass[machine : machine + 1, machine : machine + 1], values)[0, 0])
        mass[machine, machine] = symbol
        estimates.append(symbol)
    return tuple(estimates), replace(model, mass=mass), values


def _output_forms(model: Model, roles: Roles) -> dict[str, LinearForm]:
    findings.check_places(roles, model)
    forms = {place: model.without_acceleration(model.signals[place]) for place in roles.torque.values()}
    sensors = {sensor.of: sensor.name for sensor in model.sensors if sensor.kind is SensorKind.SPEED}
    for name in roles.speed:
        forms[sensors[f"{name}.shaft"]] = model.signals[sensors[f"{name}.shaft"]]
    return forms


def _rotors(model: Model) -> tuple[sp.Expr, ...]:
    """Return the inertia of each rotor alone."""
    return tuple(model.body_inertias[next(iter(torque.row))] for torque in model.inputs)


def _natural_stiffness(
    system: AffineSystem,
    chains: tuple[OutputChain, ...],
    actuators: tuple[int, ...],
    torque_count: int,
    estimates: tuple[sp.Symbol, ...],
) -> tuple[sp.Expr, ...]:
    """Return the stiffness that each torque-controlled machine sees while the other machines stand.

    With only its own machine moving, the second derivative of the torque is ``-(c / I) y``.
    """
    result = []
    for index in range(torque_count):
        chain, machine = chains[index], actuators[index]
        own = system.A.copy()
        for other in range(len(actuators)):
            if other != machine:
                own[other, :] = sp.zeros(1, system.order)
        row = chain.rows[0]
        second = row * own * own
        pivot = next(k for k, entry in enumerate(row) if entry != 0)
        result.append(sp.cancel(-second[pivot] / row[pivot] * estimates[index]))
    return tuple(result)


def _state_law(
    system: AffineSystem,
    chains: tuple[OutputChain, ...],
    matrix: sp.Matrix,
    actuators: tuple[int, ...],
    torque_count: int,
    damping: tuple[sp.Symbol, ...],
    estimates: tuple[sp.Symbol, ...],
    stiffness: tuple[sp.Expr, ...],
    rotors: tuple[sp.Expr, ...],
    feedthrough: tuple[sp.Matrix, ...],
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix]:
    """Solve ``D u = w - L_a^delta c`` (5.31), (5.34) for ``u = U_v v + U_x x + U_T T``."""
    m, n, n_f = len(chains), system.order, system.F.shape[1]
    want_v, want_x, want_T = sp.zeros(m, m), sp.zeros(m, n), sp.zeros(m, n_f)
    for index, chain in enumerate(chains):
        if index < torque_count:
            a0 = stiffness[index] / estimates[index]
            a1 = damping[index] / estimates[index]
            want_v[index, index] = a0
            want_x[index, :] = -a0 * chain.rows[0] - a1 * chain.rows[1]
            want_T[index, :] = -a0 * feedthrough[index]
        else:
            want_v[index, index] = 1 / rotors[actuators[index]]
    drift = exact.stack([chain.rows[-1] for chain in chains], n)
    disturbance = exact.stack([chain.disturbance_row for chain in chains], n_f)
    solved = exact.solve(matrix, sp.Matrix.hstack(want_v, want_x - drift, want_T - disturbance))
    return solved[:, :m], solved[:, m : m + n], solved[:, m + n :]


def _internal_eigenvalues(
    system: AffineSystem,
    model: Model,
    chains: tuple[OutputChain, ...],
    state_law: tuple[sp.Matrix, sp.Matrix, sp.Matrix],
    table: dict[sp.Symbol, float],
    damping: NDArray[np.float64],
) -> NDArray[np.complex128]:
    """Return the eigenvalues of the motion that leaves all outputs at zero.

    The law is designed without the damping of the shafts, but whether that motion dies away is decided by it.
    """
    observed = [row for chain in chains for row in chain.rows[: chain.relative_degree or 0]]
    xi = evaluate_matrix(exact.stack(observed, system.order), table)
    hidden = scipy.linalg.null_space(xi / np.linalg.norm(xi, axis=1, keepdims=True))
    if hidden.shape[1] == 0:
        return np.zeros(0, dtype=np.complex128)
    closed = evaluate_matrix(system.A, table) + evaluate_matrix(system.B, table) @ evaluate_matrix(state_law[1], table)
    E, mass = evaluate_matrix(model.twist_rows, table), evaluate_matrix(model.mass, table)
    n_z = len(model.coordinates)
    closed[:n_z, :n_z] -= np.linalg.solve(mass, E.T @ damping @ E)
    return np.asarray(np.linalg.eigvals(hidden.T @ closed @ hidden), dtype=np.complex128)


def _swinging(reduced: ReducedModel) -> tuple[str, ...]:
    """Return the components whose inertia was kept although it belongs to no machine."""
    rotors = set(reduced.mechanism.machine_velocities)
    names = [body.velocity.split(".", 1)[0] for body in reduced.mechanism.bodies if body.velocity not in rotors]
    return tuple(dict.fromkeys(names))


def _by_terms(expression: sp.Expr) -> sp.Expr:
    """Write a law as a sum over virtual inputs and sensors, each with a factored coefficient."""
    variables = [s for s in expression.free_symbols if not s.is_nonnegative and s.is_real is None]
    collected = sp.collect(sp.expand(expression), variables, evaluate=False)
    return sp.Add(*[sp.factor(coefficient) * variable for variable, coefficient in collected.items()])

"""Control laws from measured signals only: input-output decoupling, or individual feedback (source Section 5.4, 6.3).

Desired dynamics: a controlled speed becomes ``1 / (I_m s)`` (5.49), (5.70); a controlled torque keeps the natural
stiffness that its machine sees and gets the damping that is asked for (5.57), (5.76), so that for a single torque the
twist drops out of the law. Then all that is left of states and disturbances is written as a combination of sensors,
the machine's own ones first; the unknown friction torque of the unit under test drops out with it (5.74).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
import sympy as sp
from numpy.typing import NDArray

from ptgen.control import advice, findings
from ptgen.control.individual_law import individual_law
from ptgen.control.known_losses import loss_element, with_known_losses
from ptgen.control.lie import AffineSystem, OutputChain, affine_system, derivatives
from ptgen.control.measured_law import Law, complete_law, decoupling_rows, rotor_balances
from ptgen.control.normal_form import NormalForm, normal_form
from ptgen.control.sensor_rows import SensorRows
from ptgen.control.state_law import StateLaw, Wishes, decoupling_state_law
from ptgen.elements import SensorKind
from ptgen.errors import ControlError
from ptgen.mechanism import exact
from ptgen.mechanism.abbreviation import abbreviate
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix
from ptgen.mechanism.reduction import ReducedModel
from ptgen.mechanism.twist_basis import twists_of
from ptgen.testbed.testbed import Roles, Structure

__all__ = ["Decoupling", "check_structure", "decouple"]


@dataclass(frozen=True)
class Decoupling:
    """The result of the general procedure.

    Attributes
    ----------
    structure : {"decoupling", "individual"}
        Whether the machines work together, or each one for its own quantity.
    findings : tuple of str
        What stands in the way of decoupling, if the structure is individual.
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
    normal_form : NormalForm or None
        Byrnes-Isidori form (5.37)-(5.41); None for individual feedback.
    internal_eigenvalues : ndarray
        Eigenvalues of the internal dynamics (5.41); empty for maximum relative degree.
    law : Law
    state_law : StateLaw
    damping, inertia_estimate : tuple of Symbol
        Tunable damping (N m s/rad) and inertia (kg m^2) of each torque-controlled machine.
    stiffness : tuple of Expr
        Natural stiffness that each torque-controlled machine sees (N m/rad).
    values : mapping of Symbol to float
    definitions : mapping of Symbol to Expr
        What the stiffnesses of equivalent shafts stand for.
    """

    structure: Structure
    findings: tuple[str, ...]
    machines: tuple[str, ...]
    outputs: tuple[str, ...]
    actuators: tuple[int, ...]
    torque_count: int
    sensors: tuple[str, ...]
    model: Model
    system: AffineSystem
    chains: tuple[OutputChain, ...]
    matrix: sp.Matrix
    normal_form: NormalForm | None
    internal_eigenvalues: NDArray[np.complex128]
    law: Law
    state_law: StateLaw
    damping: tuple[sp.Symbol, ...]
    inertia_estimate: tuple[sp.Symbol, ...]
    stiffness: tuple[sp.Expr, ...]
    values: dict[sp.Symbol, float]
    definitions: Mapping[sp.Symbol, sp.Expr]

    @property
    def relative_degrees(self) -> tuple[int, ...]:
        """Relative degree of each output (5.24); together the vector relative degree (5.35) if `matrix` is regular."""
        return tuple(chain.relative_degree or 0 for chain in self.chains)

    @property
    def internal_order(self) -> int:
        """Order of the internal dynamics, N minus the total relative degree (5.36); 0 if there is no such degree."""
        return self.system.order - sum(self.relative_degrees) if self.structure == "decoupling" else 0

    def law_expressions(self) -> dict[str, sp.Expr]:
        """Return the law of each machine over ``v_<machine>`` and the sensors, like (5.74) and (5.78).

        The rate of a ratio that changes is ``<ratio>_rate``, a known loss torque ``<component>_loss``.
        """
        virtual = sp.Matrix([sp.Symbol(f"v_{self.machines[machine]}") for machine in self.actuators])
        measured = sp.Matrix([sp.Symbol(sensor) for sensor in self.sensors])
        losses = sp.Matrix([sp.Symbol(f"{loss.component}_loss") for loss in self.law.known_losses])
        rows = self.law.P * virtual + self.law.R * measured
        if losses:
            rows += self.law.R_losses * losses
        for ratio, share in self.law.ratio_rates.items():
            rows += share * measured * sp.Symbol(f"{ratio}_rate")
        return {name: _by_terms(rows[index]) for index, name in enumerate(self.machines)}


def decouple(
    reduced: ReducedModel,
    roles: Roles,
    structure: Structure = "decoupling",
    losses: Sequence[str] = (),
) -> Decoupling:
    """Design the control law for the roles of the machines.

    Parameters
    ----------
    reduced : ReducedModel
    roles : Roles
    structure : {"decoupling", "individual"}
    losses : sequence of str
        Flanges on which a loss torque acts that is known as a function of the speed, such as ``"gearbox2.input"``.


    Raises
    ------
    ControlError
        If the decoupling matrix is singular, if internal dynamics are not asymptotically stable, or if no
        combination of sensors gives a state that the law needs. The error names the cause, and roles, locked
        friction elements or sensors that would work.

    References
    ----------
    Source (5.23)-(5.41), (5.52), (5.62), (5.74), (5.75), (5.78); Section 6.3.
    """
    try:
        return _decouple(reduced, roles, structure, losses)
    except ControlError as error:

        def works(other: ReducedModel, chosen: Roles, how: Structure) -> bool:
            try:
                if how == "decoupling":
                    check_structure(other, chosen)
                _decouple(other, chosen, how, losses)
            except ControlError:
                return False
            return True

        raise advice.with_advice(error, reduced, roles, structure, works) from None


def check_structure(reduced: ReducedModel, roles: Roles) -> None:
    """Raise if there is no decoupling for the bed's numbers, whatever is measured; far quicker than `decouple`.

    Raises
    ------
    ControlError
        If the decoupling matrix is singular, or internal dynamics are not asymptotically stable.
    """
    model = reduced.model.with_numbers()
    machines = tuple(torque.name for torque in model.inputs)
    actuators = tuple(machines.index(name) for name in (*roles.torque, *roles.speed))
    torque_count = len(roles.torque)
    forms, system, chains, matrix, singular = _differentiated(model, roles, {}, {})
    if singular is not None:
        raise singular
    wishes = Wishes(
        torque_count=torque_count,
        actuators=actuators,
        rotors=(sp.Integer(1),) * len(machines),
        estimates=(sp.Integer(1),) * torque_count,
        damping=(sp.Integer(1),) * torque_count,
        stiffness=(sp.Integer(1),) * torque_count,
        feedthrough=tuple(form.f for form in forms.values()),
    )
    state_law = decoupling_state_law(system, chains, matrix, wishes)
    eigenvalues = _internal_eigenvalues(system, model, chains, state_law, {}, reduced.equivalent_damping)
    findings.check_internal(eigenvalues, _swinging(reduced), model, torque_count)


def _decouple(reduced: ReducedModel, roles: Roles, structure: Structure, losses: Sequence[str]) -> Decoupling:
    machines = tuple(torque.name for torque in reduced.model.inputs)
    known = tuple(loss_element(flange) for flange in losses)
    model = assemble(with_known_losses(reduced.mechanism, losses), first="machines") if losses else reduced.model
    actuators = tuple(machines.index(name) for name in (*roles.torque, *roles.speed))
    torque_count = len(roles.torque)
    basis = twists_of(model, actuators[:torque_count])
    short = abbreviate(basis.model)
    estimates, model, values = _with_inertia_estimates(short.model, machines, actuators[:torque_count])
    rates = {parameter.symbol: sp.Symbol(f"{parameter.symbol.name}_rate") for parameter in model.changing}
    forms, system, chains, matrix, singular = _differentiated(model, roles, values, rates)
    wishes = Wishes(
        torque_count=torque_count,
        actuators=actuators,
        rotors=tuple(model.body_inertias[next(iter(torque.row))] for torque in model.inputs),
        estimates=estimates,
        damping=tuple(sp.Symbol(f"{name}_damping", nonnegative=True) for name in roles.torque),
        stiffness=tuple(_natural_stiffness(model, machine) for machine in actuators[:torque_count]),
        feedthrough=tuple(form.f for form in forms.values()),
    )
    # Internal dynamics are those in a gear: ratios rest.
    table = {**values, **dict.fromkeys(wishes.damping, 1.0), **dict.fromkeys(rates.values(), 0.0)}
    torque_machines = set(actuators[:torque_count])
    rows = SensorRows(reduced.original, model, torque_machines, known)
    balances = rotor_balances(SensorRows(reduced.original, short.model, set(), known))
    former = evaluate_matrix(basis.former, values)
    equivalent_damping = former.T @ reduced.equivalent_damping @ former
    eigenvalues = np.zeros(0, dtype=np.complex128)
    form = None
    if structure == "decoupling":
        if singular is not None:
            raise singular
        state_law = decoupling_state_law(system, chains, matrix, wishes, rates)
        eigenvalues = _internal_eigenvalues(system, model, chains, state_law, table, equivalent_damping)
        findings.check_internal(eigenvalues, _swinging(reduced), model, torque_count)
        form = normal_form(system, chains, state_law.x, model.states)
        R = decoupling_rows(rows, state_law, tuple(forms.values())[:torque_count], _swinging(reduced))
    else:
        findings.check_speed_held(roles)
        findings.check_uncontrolled_twists(model, torque_count)
        state_law, R = individual_law(rows, balances, system, forms, wishes, _swinging(reduced))
    law = complete_law(rows, state_law, R, forms, balances, _swinging(reduced))
    findings.check_speed_rows(law.P, actuators, torque_count, machines)
    return Decoupling(
        structure=structure,
        findings=_findings(singular, model, actuators[torque_count:]),
        machines=machines,
        outputs=tuple(forms),
        actuators=actuators,
        torque_count=torque_count,
        sensors=rows.sensors,
        model=model,
        system=system,
        chains=chains,
        matrix=matrix,
        normal_form=form,
        internal_eigenvalues=eigenvalues,
        law=law,
        state_law=state_law,
        damping=wishes.damping,
        inertia_estimate=estimates,
        stiffness=wishes.stiffness,
        values=values,
        definitions={**reduced.definitions, **short.definitions},
    )


def _differentiated(
    model: Model, roles: Roles, values: Mapping[sp.Symbol, float], rates: Mapping[sp.Symbol, sp.Expr]
) -> tuple[dict[str, LinearForm], AffineSystem, tuple[OutputChain, ...], sp.Matrix, ControlError | None]:
    """Return outputs, state equations, derivatives, decoupling matrix (5.29), and the error if that is singular."""
    forms = _output_forms(model, roles)
    system = affine_system(model)
    chains = tuple(derivatives(system, name, form, rates) for name, form in forms.items())
    findings.check_degrees(chains, roles)
    matrix = exact.stack([chain.input_row for chain in chains], len(model.inputs))
    singular = findings.singular_matrix(matrix, values, model, tuple(forms)[: len(roles.torque)])
    return forms, system, chains, matrix, singular


def _findings(singular: ControlError | None, model: Model, speed_machines: tuple[int, ...]) -> tuple[str, ...]:
    found = [] if singular is None else [problem.what for problem in singular.problems]
    free = findings.unheld_motions(model, speed_machines)
    if free and singular is not None:
        ways = "one motion" if free == 1 else f"{free} motions"
        found.append(
            f"{ways} of the bed without any twist, such as the difference of the speeds behind an open differential, "
            "is controlled by nobody: only friction holds it, so the torque references must not ask for more than that"
        )
    return tuple(found)


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


def _natural_stiffness(model: Model, machine: int) -> sp.Expr:
    """Return the stiffness that a machine sees while the other machines stand (N m/rad), as in (5.57) and (5.76)."""
    row = model.twist_rows[:, machine]
    return sp.factor(exact.canonical(row.T * model.stiffness * row)[0])


def _internal_eigenvalues(
    system: AffineSystem,
    model: Model,
    chains: tuple[OutputChain, ...],
    state_law: StateLaw,
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
    closed = evaluate_matrix(system.A, table) + evaluate_matrix(system.B, table) @ evaluate_matrix(state_law.x, table)
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
    # Rates of ratios stand in products with speeds: collected first, they are terms of their own, in any session.
    variables.sort(key=lambda s: (not s.name.endswith("_rate"), s.name))
    collected = sp.collect(sp.expand(expression), variables, evaluate=False)
    return sp.Add(*[sp.factor(coefficient) * variable for variable, coefficient in collected.items()])

"""A law from measured signals only: states and disturbances replaced by sensors, the machine's own ones first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ptgen.control import findings
from ptgen.control.known_losses import component_of_loss
from ptgen.control.sensor_rows import SensorRows
from ptgen.control.state_law import StateLaw
from ptgen.elements import Friction
from ptgen.mechanism import exact
from ptgen.mechanism.model import LinearForm

__all__ = ["Balance", "KnownLoss", "Law", "complete_law", "decoupling_rows", "rotor_balances"]


@dataclass(frozen=True)
class Balance:
    """The torque balance of a rotor from measured signals: ``I_m d(omega)/dt = share u + sensors . y``.

    Attributes
    ----------
    share : Expr
        What the rotor gets of its machine's air-gap torque; 1 with a torque flange beside the machine.
    sensors : Matrix (1, n_s)
        What the rest of the bed does to it; minus the own flange torque with a torque flange beside the machine.
    """

    share: sp.Expr
    sensors: sp.Matrix


@dataclass(frozen=True)
class KnownLoss:
    """A loss torque that is known as a function of the speed (5.96).

    Attributes
    ----------
    component : str
        Where it acts: on the first flange, such as the input of a gearbox, positive when it brakes.
    speed : Matrix (1, n_s)
        The speed there from the sensors.
    """

    component: str
    speed: sp.Matrix


@dataclass(frozen=True)
class Law:
    """``u = P v + R y + R_losses T_l`` with virtual inputs v, sensors y, known losses; and the controlled torques.

    Attributes
    ----------
    P : Matrix (m, m)
        Share of each virtual input, in the order of the outputs.
    R : Matrix (m, n_s)
        Share of each sensor.
    R_losses : Matrix (m, n_k)
        Share of each known loss torque.
    ratio_rates : mapping of str to Matrix (m, n_s)
        For each ratio that changes at run time, what its rate times each sensor adds to u (5.46), (5.62).
    estimate_sensors : Matrix (n_t, n_s)
        Controlled torques from sensors, (5.95).
    estimate_virtual : Matrix (n_t, m)
        Correction of these by virtual inputs: torques that accelerate gearboxes, (5.98).
    estimate_losses : Matrix (n_t, n_k)
        Correction of these by known loss torques, (5.96).
    known_losses : tuple of KnownLoss (n_k)
    balance : tuple of Balance or None (m)
        Of each machine; None if no combination of sensors gives it.
    """

    P: sp.Matrix
    R: sp.Matrix
    R_losses: sp.Matrix
    ratio_rates: Mapping[str, sp.Matrix]
    estimate_sensors: sp.Matrix
    estimate_virtual: sp.Matrix
    estimate_losses: sp.Matrix
    known_losses: tuple[KnownLoss, ...]
    balance: tuple[Balance | None, ...]


def decoupling_rows(
    rows: SensorRows, state_law: StateLaw, torques: Sequence[LinearForm], swinging: Sequence[str]
) -> sp.Matrix:
    """Replace states and disturbances of a law by sensors; return ``R`` (m, n_s).

    With ``y = C x + D u + F T`` and ``u = U_v v + U_x x + U_T T`` the combination has to satisfy
    ``R (C + D U_x) = U_x`` and ``R (F + D U_T) = U_T`` for every friction torque that is not known.

    Parameters
    ----------
    rows : SensorRows
    state_law : StateLaw
    torques : sequence of LinearForm
        The controlled torques; sensors that read these go before others in the laws of their machines, so that what
        losses do to the rest of the bed stays out of them.
    swinging : sequence of str
        Components whose inertia stands between the machines; named if a state cannot be measured.

    Raises
    ------
    ControlError
        If no combination of sensors gives a state or a disturbance that the law needs.
    """
    machines = [torque.name for torque in rows.model.inputs]
    seen = rows.under(state_law)
    found, reading = [], rows.reading(torques)
    for machine, name in enumerate(machines):
        controls_torque = machine in rows.torque_machines
        order = rows.order(f"{name}.shaft", controls_torque, reading if controls_torque else frozenset())
        wanted = rows.unknown_part(state_law.x[machine, :], state_law.T[machine, :])
        found.append(_combined(rows, seen, wanted, order, f"the law of {name}", swinging))
    return exact.canonical(exact.stack(found, len(rows.sensors)))


def complete_law(
    rows: SensorRows,
    state_law: StateLaw,
    R: sp.Matrix,
    outputs: Mapping[str, LinearForm],
    balances: Sequence[Balance | None],
    swinging: Sequence[str],
) -> Law:
    """Return the law over virtual inputs and sensors with the estimates of the controlled torques.

    Parameters
    ----------
    rows : SensorRows
    state_law : StateLaw
    R : Matrix (m, n_s)
        The law's rows over the sensors.
    outputs : mapping of str to LinearForm
        The controlled quantities, torques first.
    balances : sequence of Balance or None (m)
        Of the rotors.
    swinging : sequence of str

    Raises
    ------
    ControlError
        If no combination of sensors gives a controlled torque, or what a changing ratio or a known loss needs.
    """
    model = rows.model
    seen = rows.under(state_law)
    machines = [torque.name for torque in model.inputs]
    ratio_rates = {}
    for ratio, part in state_law.ratio_rates.items():
        left_x, left_T = part.x - R * rows.D * part.x, part.T - R * rows.D * part.T
        shares = []
        for machine, name in enumerate(machines):
            wanted = rows.unknown_part(left_x[machine, :], left_T[machine, :])
            order = rows.order(f"{name}.shaft", speeds_first=True)
            shares.append(_combined(rows, seen, wanted, order, f"the law of {name} while {ratio} changes", swinging))
        ratio_rates[ratio] = exact.canonical(exact.stack(shares, len(rows.sensors)))
    estimates, known = [], []
    disturbed = rows.F + rows.D * state_law.T
    for place in list(outputs)[: len(rows.torque_machines)]:
        form = outputs[place]
        wanted = rows.unknown_part(sp.Matrix.hstack(form.z, form.e), form.f)
        estimates.append(_combined(rows, seen, wanted, rows.order_at(place), f"the torque at {place}", swinging))
        known.append((form.f - estimates[-1] * disturbed)[:, rows.known])
    estimate = exact.stack(estimates, len(rows.sensors))
    return Law(
        P=exact.canonical(state_law.v - R * rows.D * state_law.v),
        R=R,
        R_losses=exact.canonical((state_law.T - R * disturbed)[:, rows.known]),
        ratio_rates=ratio_rates,
        estimate_sensors=estimate,
        estimate_virtual=exact.canonical(-estimate * rows.D * state_law.v),
        estimate_losses=exact.canonical(exact.stack(known, len(rows.known))),
        known_losses=tuple(_known_loss(model.frictions[k], k, rows, swinging) for k in rows.known),
        balance=tuple(balances),
    )


def _combined(
    rows: SensorRows, seen: sp.Matrix, wanted: sp.Matrix, order: Sequence[int], what: str, swinging: Sequence[str]
) -> sp.Matrix:
    found = rows.combination(seen, wanted, order)
    if found is None:
        raise findings.unmeasured(what, rows.model, swinging)
    return found


def rotor_balances(rows: SensorRows) -> tuple[Balance | None, ...]:
    """Return the balance of each rotor, or None where the sensors do not give it.

    Parameters
    ----------
    rows : SensorRows
        Of the reduced model with its own inertias; tuned ones have no place here.
    """
    return tuple(_balance(machine, rows) for machine in range(len(rows.model.inputs)))


def _balance(machine: int, rows: SensorRows) -> Balance | None:
    """Return the balance of a rotor if the sensors give it without the torques of other machines."""
    model = rows.model
    velocity = next(iter(model.inputs[machine].row))
    rotor = model.body_inertias[velocity]
    rates = model.accelerations()
    of_x = rotor * sp.Matrix.hstack(rates.z, rates.e)[machine, :]
    found = rows.combination(rows.alone(), sp.Matrix.hstack(of_x, rotor * rates.f[machine, :]), rows.order(velocity))
    if found is None:
        return None
    share = exact.canonical(rotor * rates.u[machine, :] - found * rows.D)
    if any(entry != 0 for column, entry in enumerate(share) if column != machine):
        return None
    return Balance(share[machine], exact.canonical(found))


def _known_loss(friction: Friction, index: int, rows: SensorRows, swinging: Sequence[str]) -> KnownLoss:
    model, component = rows.model, component_of_loss(friction.name)
    wanted = sp.Matrix.hstack(model.friction_rows[index, :], sp.zeros(1, len(model.twists) + rows.F.shape[1]))
    order = rows.order(next(iter(friction.row)), speeds_first=True)
    what = f"the loss torque of {component}, a function of its speed,"
    return KnownLoss(component, exact.canonical(_combined(rows, rows.alone(), wanted, order, what, swinging)))

"""What can stand in the way of a control law, explained."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.control.lie import OutputChain
from ptgen.elements import FrictionRole
from ptgen.errors import ControlError, Problem, nearest
from ptgen.mechanism import exact
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.testbed.testbed import Roles

__all__ = [
    "check_degrees",
    "check_internal",
    "check_places",
    "check_speed_held",
    "check_speed_rows",
    "check_uncontrolled_twists",
    "singular_matrix",
    "unheld_motions",
    "unmeasured",
]

_SINGULAR = 1e-9


def check_places(roles: Roles, model: Model) -> None:
    """Raise if a torque is asked for where the model has no signal."""
    problems = [
        Problem(f"control.torque.{machine}", f'the model has no torque at "{place}"', nearest(place, model.signals))
        for machine, place in roles.torque.items()
        if place not in model.signals
    ]
    if problems:
        raise ControlError(problems)


def check_degrees(chains: Sequence[OutputChain], roles: Roles) -> None:
    """Raise if an output cannot be controlled by any machine, or contains an air-gap torque itself."""
    problems = []
    for machine, chain in zip((*roles.torque, *roles.speed), chains, strict=True):
        where = f"control.torque.{machine}" if machine in roles.torque else "control.speed"
        if chain.relative_degree is None:
            what = f"no machine acts on {chain.name}"
            problems.append(Problem(where, what, "choose another place for the torque reference"))
        elif chain.relative_degree == 0:
            what = (
                f"the torque at {chain.name} contains an air-gap torque directly, "
                "because only rigid parts lie between the place and a machine"
            )
            problems.append(
                Problem(where, what, "choose a place behind the next shaft, such as a flange of the unit under test")
            )
        elif machine in roles.torque and chain.relative_degree != 2:
            what = f"the torque at {chain.name} has relative degree {chain.relative_degree} instead of 2"
            problems.append(Problem(where, what, "drop the inertia between the machine and the place in [reduction]"))
    if problems:
        raise ControlError(problems)


def _other_count(torques: int, model: Model) -> str:
    """Return what to do about torques that cannot all be controlled, or twists that nobody controls."""
    if torques < _machine_twists(model):
        return "let one more machine control a torque: what lies between machines at given speeds winds up"
    couplings = [friction.name for friction in model.frictions if friction.role is FrictionRole.COUPLING]
    if couplings:
        names = ", ".join(f'"{name}"' for name in couplings)
        return f"a torque needs a closed line: design for locked elements with [reduction] locked = [{names}]"
    return "let fewer machines control torques, and more control speeds"


def singular_matrix(
    matrix: sp.Matrix, values: Mapping[sp.Symbol, float], model: Model, places: Sequence[str]
) -> ControlError | None:
    """Return the error for a singular decoupling matrix, None if the matrix is regular.

    Parameters
    ----------
    matrix : Matrix (m, m)
        The decoupling matrix (5.29).
    values : mapping of Symbol to float
    model : Model
    places : sequence of str
        Where torques are controlled.
    """
    torques, twists = len(places), len(model.twists)
    if _is_regular(evaluate_matrix(matrix, values)):
        return None
    if torques > twists:
        hang = f"the torques at {_listed(places)} hang" if torques > 1 else f"the torque at {places[0]} hangs"
        cause = (
            f"{torques} machines control torques, but {hang} on {twists} twist{'s' if twists != 1 else ''} of the "
            "reduced bed"
        )
        if any(friction.role is FrictionRole.LIMITED_SLIP for friction in model.frictions):
            cause += "; behind an open or slipping differential both outputs carry the same torque up to friction"
    else:
        cause = "the machines that control torques cannot change these torques independently of the speeds"
    what = f"the decoupling matrix is singular: {cause}"
    return ControlError(Problem("control", what, _other_count(torques, model)))


def check_uncontrolled_twists(model: Model, torques: int) -> None:
    """Raise if fewer torques are controlled than the machines can twist the bed: the other twists would wind up.

    The machines are the first coordinates of `model`.
    """
    twists = _machine_twists(model)
    if torques >= twists:
        return
    what = (
        f"{torques} torque{'s are' if torques != 1 else ' is'} controlled, but the machines of the reduced bed twist "
        f"it in {twists} independent way{'s' if twists != 1 else ''}; what nobody controls winds up "
        "when the speed references do not agree exactly"
    )
    raise ControlError(Problem("control", what, _other_count(torques, model)))


def check_speed_held(roles: Roles) -> None:
    """Raise if no machine controls a speed: the bed would run away under the smallest sum of torques."""
    if not roles.speed:
        what = "no machine controls a speed, so nothing holds the speed of the bed"
        raise ControlError(Problem("control.speed", what, "let one machine control its speed"))


def unheld_motions(model: Model, speed_machines: Sequence[int]) -> int:
    """Return in how many ways the bed can turn without a twist while every controlled speed is held."""
    held = exact.stack(
        [model.velocity_rows[next(iter(model.inputs[k].row))] for k in speed_machines], model.mass.shape[0]
    )
    return int(model.mass.shape[0]) - exact.rank(model.twist_rows.col_join(held))


def _machine_twists(model: Model) -> int:
    """Return in how many ways the machines, the first coordinates, can twist the bed for good."""
    return exact.rank(model.twist_rows) - exact.rank(model.twist_rows[:, len(model.inputs) :])


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:-1]) + (" and " if len(names) > 1 else "") + names[-1]


def check_internal(eigenvalues: NDArray[np.complex128], swinging: Sequence[str], model: Model, torques: int) -> None:
    """Raise if the internal dynamics are not asymptotically stable.

    `swinging` are the components whose inertia the reduced model keeps besides the machines.
    """
    if len(eigenvalues) == 0:
        return
    size = max(1.0, float(np.abs(eigenvalues).max()))
    unstable = [value for value in eigenvalues if value.real > -1e-9 * size]
    if not unstable:
        return
    shown = ", ".join(_complex(value, size) for value in unstable)
    twists = f" ({_listed(model.twists)})" if len(model.twists) > torques else ""
    what = (
        f"{_counted(len(eigenvalues))} behind the controlled quantities (internal dynamics), not asymptotically "
        f"stable: {'eigenvalue' if len(unstable) == 1 else 'eigenvalues'} {shown} 1/s; it would wind up or oscillate "
        "unseen: "
        f"{torques} torque{'s' if torques != 1 else ''} for {len(model.twists)} twists{twists}"
    )
    remedy = _other_count(torques, model)
    if any(abs(value.imag) > 0 for value in unstable) and swinging:
        names = ", ".join(f'"{name}"' for name in swinging)
        remedy = f"give the shafts their damping, or leave the inertia out of the design: [reduction] drop = [{names}]"
    raise ControlError(Problem("control", what, remedy))


def check_speed_rows(P: sp.Matrix, actuators: Sequence[int], torques: int, machines: Sequence[str]) -> None:
    """Raise if the law of a speed-controlled machine needs what another controller asks for."""
    problems = []
    for position, machine in enumerate(actuators):
        others = [machines[actuators[k]] for k, entry in enumerate(P[machine, :]) if k != position and entry != 0]
        if position >= torques and others:
            name = machines[machine]
            what = f"an inertia moves rigidly with {name} and with {_listed(others)}, so their speeds hang together"
            remedy = f"put a torque flange next to {name}, or leave the inertia out with [reduction] drop"
            problems.append(Problem("control.speed", what, remedy))
    if problems:
        raise ControlError(problems)


def _counted(states: int) -> str:
    return "1 state stays" if states == 1 else f"{states} states stay"


def _complex(value: complex, size: float) -> str:
    """Write an eigenvalue; what is rounding beside `size` is zero."""
    real, imaginary = (part if abs(part) > 1e-9 * size else 0.0 for part in (value.real, value.imag))
    return f"{real:.3g}{imaginary:+.3g}j" if imaginary else f"{real:.3g}"


def unmeasured(what: str, model: Model, swinging: Sequence[str]) -> ControlError:
    """Return the error for a law that needs a state which no sensor gives."""
    remedy = "add a torque flange next to each machine that controls a speed and has none"
    if swinging:
        names = ", ".join(f'"{name}"' for name in swinging)
        remedy = f"leave the inertia between the machines out of the design: [reduction] drop = [{names}]"
    sensors = ", ".join(sensor.name for sensor in model.sensors)
    return ControlError(
        Problem(
            "components",
            f"{what} needs a state or a disturbance that no combination of the sensors gives ({sensors})",
            remedy,
        )
    )


def _is_regular(matrix: NDArray[np.float64]) -> bool:
    norms = np.linalg.norm(matrix, axis=1)
    if not np.all(norms > 0):
        return False
    return bool(np.linalg.svd(matrix / norms[:, None], compute_uv=False)[-1] > _SINGULAR)

r"""The continuous closed loop of the reduced model in symbols: plant, decoupling law, speed and torque control.

With the plant ``dx/dt = A x + B u``, the controlled quantities ``y = C x`` and the law ``u = P v + R y_s`` over the
sensors ``y_s``, every controlled quantity has a controller with one integrator :math:`\lambda`,

.. math::
    v = a r - b y + \lambda, \qquad \dot\lambda = c (r - y)

- PI speed control (5.84), (5.102): ``a = b = k_p``, ``c = k_i``.
- P speed control with disturbance observer (5.85)-(5.93): the auxiliary variable of (5.90) is :math:`\lambda`, its
  estimate :math:`\lambda - \hat b I \omega`, and ``a = k_p``, ``b = k_p + b_hat I``, ``c = b_hat k_p``.
- Super-twisting speed control, for errors that are small against its layer: a PI controller.
- PI torque control with feedforward (5.99), (5.111): ``a = k_ff + k_p``, ``b = k_p``, ``c = k_i``.

Two switches take the law apart as in (5.102), (5.107): ``load_compensation`` (gamma_omega) multiplies what a
speed-controlled machine takes from sensors, ``acceleration_torque`` (gamma_T) what a torque-controlled machine takes
from the speed-controlled ones. The latter is the inertia times the *acceleration*, from the whole net torque on the
rotor, as in (5.62) and in the matrix (5.108). So each switch decouples alone; with ``v / I_m`` in place of the
acceleration, as (5.107) is printed, ``acceleration_torque`` alone would not.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.control.decoupling import Decoupling
from ptgen.mechanism import exact
from ptgen.mechanism.model import evaluate_matrix

__all__ = [
    "ACCELERATION_TORQUE",
    "LOAD_COMPENSATION",
    "Loop",
    "LoopKind",
    "SymbolicLoop",
    "numeric_matrix",
    "symbolic_loop",
]

LOAD_COMPENSATION = sp.Symbol("load_compensation", real=True)
"""gamma_omega of the source, 0 to 1."""

ACCELERATION_TORQUE = sp.Symbol("acceleration_torque", real=True)
"""gamma_T of the source, 0 to 1."""


class LoopKind(Enum):
    """What a loop controls, and how."""

    TORQUE = "torque"
    SPEED_PI = "pi"
    SPEED_OBSERVER = "observer"
    SPEED_TWISTING = "super_twisting"


@dataclass(frozen=True)
class Loop:
    """One controlled quantity with its controller ``v = a r - b y + lambda``, ``d lambda/dt = c (r - y)``.

    Attributes
    ----------
    name : str
        Such as "speed loop of M2".
    machine, output : str
    kind : LoopKind
    gains : tuple of Symbol
        Gains of the controller in the order in which they are chosen; active damping first, integral gain last.
        They have the names of the controller's parameters.
    on_reference, on_output, integral : Expr
        ``a``, ``b``, ``c``.
    """

    name: str
    machine: str
    output: str
    kind: LoopKind
    gains: tuple[sp.Symbol, ...]
    on_reference: sp.Expr
    on_output: sp.Expr
    integral: sp.Expr


@dataclass(frozen=True)
class SymbolicLoop:
    """``dx/dt = A x + B r`` of the closed loop.

    Attributes
    ----------
    states : tuple of str (n)
        Velocities, twists, then integrators: those of the speed control first, as in (5.112).
    references : tuple of str (m)
        References, torques first; of a torque loop that is left open, its virtual input.
    A : Matrix (n, n)
    B : Matrix (n, m)
    loops : tuple of Loop
        In the order of the controlled quantities.
    coordinates : Matrix (n, n)
        ``z = T x``: controlled quantities and their derivatives (5.37), internal states, integrators.
    owners : tuple of str (n)
        The loop that each coordinate belongs to; "internal dynamics" if none.
    internal_damping : Matrix (n, n)
        Damping of the shafts in the internal dynamics, in the coordinates z. The law is designed without it, as in the
        source, but what the law does not reach is damped by nothing else.
    values : mapping of Symbol to float
        Value of every parameter of the bed and of this damping.
    """

    states: tuple[str, ...]
    references: tuple[str, ...]
    A: sp.Matrix
    B: sp.Matrix
    loops: tuple[Loop, ...]
    coordinates: sp.Matrix
    owners: tuple[str, ...]
    internal_damping: sp.Matrix
    values: Mapping[sp.Symbol, float]

    @property
    def gains(self) -> tuple[sp.Symbol, ...]:
        """All gains, loop by loop."""
        return tuple(gain for loop in self.loops for gain in loop.gains)

    def at(self, settings: Mapping[sp.Symbol, sp.Expr | float]) -> SymbolicLoop:
        """Return the loop with switches or gains set to numbers."""
        table = {symbol: sp.nsimplify(value) for symbol, value in settings.items()}
        return replace(self, A=exact.canonical(self.A.subs(table)), B=exact.canonical(self.B.subs(table)))

    def normal_form(self) -> sp.Matrix:
        """Return the state matrix in the coordinates z, shaft damping of the internal dynamics included."""
        inverse = exact.solve(self.coordinates, sp.eye(len(self.states)))
        return exact.canonical(self.coordinates * self.A * inverse + self.internal_damping)


def symbolic_loop(
    decoupling: Decoupling,
    shaft_damping: NDArray[np.float64] | None = None,
    speed_control: LoopKind | Mapping[str, LoopKind] = LoopKind.SPEED_PI,
    torque_loops: bool = True,
) -> SymbolicLoop:
    """Return the closed loop of a design, all gains and switches symbolic.

    Parameters
    ----------
    decoupling : Decoupling
        The reduced model and the law. Plant and law have the same inertia of each torque-controlled machine.
    shaft_damping : ndarray (n_e, n_e), optional
        Damping of the twists (N m s/rad), for the internal dynamics; none if left out.
    speed_control : LoopKind or mapping of str to LoopKind
        Of all speed-controlled machines, or of each.
    torque_loops : bool
        False leaves the torque control open, as in (5.104), (5.108).

    References
    ----------
    Source (5.100)-(5.115).
    """
    m, n_t = len(decoupling.outputs), decoupling.torque_count
    kinds = speed_control if isinstance(speed_control, Mapping) else dict.fromkeys(decoupling.machines, speed_control)
    loops = tuple(_loop(decoupling, index, kinds) for index in range(m))
    closed = [*range(n_t, m), *(range(n_t) if torque_loops else ())]
    on_reference, on_output = sp.eye(m), sp.zeros(m, m)
    share, integral = sp.zeros(m, len(closed)), sp.zeros(len(closed), m)
    for position, index in enumerate(closed):
        loop = loops[index]
        on_reference[index, index], on_output[index, index] = loop.on_reference, loop.on_output
        share[index, position] = 1
        integral[position, index] = loop.integral
    A, B = _closed(decoupling, on_reference, on_output, share, integral)
    T, owners = _coordinates(decoupling, loops)
    damping, damping_values = _internal_damping(decoupling, T, owners, shaft_damping, len(closed))
    return SymbolicLoop(
        states=decoupling.model.states + tuple(f"integrator of the {loops[index].name}" for index in closed),
        references=tuple(f"v_{loop.machine}" if i not in closed else loop.output for i, loop in enumerate(loops)),
        A=A,
        B=B,
        loops=loops,
        coordinates=sp.diag(T, sp.eye(len(closed))),
        owners=(*owners, *(loops[index].name for index in closed)),
        internal_damping=damping,
        values={**decoupling.values, **damping_values},
    )


def _loop(decoupling: Decoupling, index: int, kinds: Mapping[str, LoopKind]) -> Loop:
    machine, output = decoupling.machines[decoupling.actuators[index]], decoupling.outputs[index]

    def gain(suffix: str) -> sp.Symbol:
        return sp.Symbol(f"{machine}_{suffix}", real=True)

    if index < decoupling.torque_count:
        proportional, integral = gain("torque_gain"), gain("torque_integral_gain")
        forward, name = gain("feedforward") + proportional, f"torque loop of {machine}"
        gains: tuple[sp.Symbol, ...] = (decoupling.damping[index], proportional, integral)
        return Loop(name, machine, output, LoopKind.TORQUE, gains, forward, proportional, integral)
    name, kind = f"speed loop of {machine}", kinds[machine]
    if kind is LoopKind.SPEED_OBSERVER:
        proportional, rate = gain("speed_gain"), gain("observer_bandwidth")
        on_output = proportional + rate * _rotor(decoupling, index)
        return Loop(name, machine, output, kind, (proportional, rate), proportional, on_output, rate * proportional)
    prefix = "small_error" if kind is LoopKind.SPEED_TWISTING else "speed"
    proportional, integral = gain(f"{prefix}_gain"), gain(f"{prefix}_integral_gain")
    return Loop(name, machine, output, kind, (proportional, integral), proportional, proportional, integral)


def _rotor(decoupling: Decoupling, index: int) -> sp.Expr:
    """Return the inertia of the rotor of an output's machine alone."""
    torque = decoupling.model.inputs[decoupling.actuators[index]]
    return sp.sympify(decoupling.model.body_inertias[next(iter(torque.row))])


def _closed(
    decoupling: Decoupling, on_reference: sp.Matrix, on_output: sp.Matrix, share: sp.Matrix, integral: sp.Matrix
) -> tuple[sp.Matrix, sp.Matrix]:
    """Return state and input matrix; the algebraic loop through sensors and accelerations is solved.

    It is put together as the controller does it: law, net torque on each rotor, torques estimated from sensors.
    """
    system, law, model = decoupling.system, decoupling.law, decoupling.model
    n, m, n_t = system.order, len(decoupling.machines), decoupling.torque_count
    forms = [model.without_acceleration(model.signals[sensor]) for sensor in decoupling.sensors]
    sensors = sp.Matrix.hstack(
        exact.stack([sp.Matrix.hstack(form.z, form.e) for form in forms], n), exact.stack([form.u for form in forms], m)
    )  # over (x, u)
    of_u = sp.Matrix.hstack(sp.zeros(m, n), sp.eye(m))
    P, law_rows, net = sp.zeros(m, m), sp.zeros(m, n + m), sp.zeros(m - n_t, n + m)
    for position, machine in enumerate(decoupling.actuators[n_t:]):
        from_sensors = law.R[machine, :] * sensors
        P[machine, n_t + position] = law.P[machine, n_t + position]
        net[position, :] = (of_u[machine, :] - from_sensors) / law.P[machine, n_t + position]
        law_rows[machine, :] = LOAD_COMPENSATION * from_sensors
    for machine in decoupling.actuators[:n_t]:
        P[machine, :n_t] = law.P[machine, :n_t]
        law_rows[machine, :] = law.R[machine, :] * sensors + ACCELERATION_TORQUE * law.P[machine, n_t:] * net
    speeds = exact.stack([chain.rows[0] for chain in decoupling.chains[n_t:]], n)
    measured = sp.Matrix.vstack(
        law.estimate_sensors * sensors + law.estimate_virtual[:, n_t:] * net,
        sp.Matrix.hstack(speeds, sp.zeros(m - n_t, m)),
    )
    measured = exact.canonical(measured)
    y_x, y_u = measured[:, :n], measured[:, n:]
    # u = law_rows (x, u) + P v with v = on_reference r - on_output (y_x x + y_u u) + share lambda
    left = sp.eye(m) - law_rows[:, n:] + P * on_output * y_u
    right = sp.Matrix.hstack(law_rows[:, :n] - P * on_output * y_x, P * share, P * on_reference)
    u = exact.solve(left, right)
    wide = sp.Matrix.hstack(y_x, sp.zeros(m, u.cols - n)) + y_u * u
    driven, integrated = system.B * u, -integral * wide
    driven[:, :n] += system.A
    k = n + share.cols
    integrated[:, k:] += integral
    return (
        exact.canonical(sp.Matrix.vstack(driven[:, :k], integrated[:, :k])),
        exact.canonical(sp.Matrix.vstack(driven[:, k:], integrated[:, k:])),
    )


def _coordinates(decoupling: Decoupling, loops: tuple[Loop, ...]) -> tuple[sp.Matrix, tuple[str, ...]]:
    """Return the transformation (5.37) as far as the rows are independent, completed by states no input drives."""
    system = decoupling.system
    rows: list[tuple[sp.Matrix, str]] = []
    for chain, loop in zip(decoupling.chains, loops, strict=True):
        rows += [(row, loop.name) for row in chain.rows[: max(1, chain.relative_degree or 1)]]
    single = [sp.eye(system.order)[k, :] for k in range(system.order)]
    single.sort(key=lambda row: any(entry != 0 for entry in row * system.B))
    rows += [(row, "internal dynamics") for row in single]
    kept = exact.independent_rows(exact.stack([row for row, _ in rows], system.order))
    return exact.stack([rows[k][0] for k in kept], system.order), tuple(rows[k][1] for k in kept)


def _internal_damping(
    decoupling: Decoupling,
    T: sp.Matrix,
    owners: tuple[str, ...],
    shaft_damping: NDArray[np.float64] | None,
    integrators: int,
) -> tuple[sp.Matrix, dict[sp.Symbol, float]]:
    """Return what the damping of the shafts adds to the internal dynamics, in the coordinates ``T x``."""
    model, n = decoupling.model, decoupling.system.order
    internal = [k for k, owner in enumerate(owners) if owner == "internal dynamics"]
    result = sp.zeros(n + integrators, n + integrators)
    if not internal or shaft_damping is None or not np.any(shaft_damping):
        return result, {}
    values: dict[sp.Symbol, float] = {}
    D = sp.zeros(*shaft_damping.shape)
    for i, first in enumerate(model.twists):
        for j, second in enumerate(model.twists):
            if shaft_damping[i, j] != 0:
                names = sorted({first.removeprefix("twist "), second.removeprefix("twist ")})
                own = {"positive": True} if i == j else {"real": True}
                symbol = sp.Symbol(f"{'_'.join(names)}_shaft_damping", **own)
                values[symbol] = float(shaft_damping[i, j])
                D[i, j] = symbol
    torque = exact.solve(model.mass, -model.twist_rows.T * D * model.twist_rows)
    inverse = exact.solve(T, sp.eye(n))
    n_z = len(model.coordinates)
    added = exact.canonical(T[:, :n_z] * torque * inverse[:n_z, :])
    for i in internal:
        for j in internal:
            result[i, j] = added[i, j]
    return result, values


def numeric_matrix(loop: SymbolicLoop, values: Mapping[sp.Symbol, float]) -> NDArray[np.float64]:
    """Return ``A`` in numbers; `values` has the gains and switches, and may override parameters of the bed."""
    return evaluate_matrix(loop.A, {**loop.values, **values})

"""Closed loops in numbers, formed from the reduced model and from the law over sensors as it is emitted."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp
from mechanism.bed_text import Bed
from numpy.typing import NDArray

from ptgen.control.decoupling import Decoupling, decouple
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import LinearForm, evaluate_matrix
from ptgen.mechanism.reduction import reduce_mechanism

Array = NDArray[np.float64]


def design(bed: Bed) -> Decoupling:
    """Return the decoupling of a bed with the roles in its file."""
    testbed = bed.load()
    return decouple(reduce_mechanism(Mechanism.of(testbed), testbed.reduction), testbed.roles)


def is_zero(value: sp.Expr | sp.Matrix) -> bool:
    entries = list(value) if isinstance(value, sp.MatrixBase) else [value]
    return all(sp.cancel(sp.together(entry)) == 0 for entry in entries)


def symbols(decoupling: Decoupling) -> dict[str, sp.Symbol]:
    """Return all parameters of a design by name, the tunable ones included."""
    found = {symbol.name: symbol for symbol in decoupling.values}
    return found | {symbol.name: symbol for symbol in decoupling.damping}


def expanded(decoupling: Decoupling, expression: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
    """Insert what the short names of a design stand for; later ones are made of earlier ones."""
    for symbol, definition in reversed(decoupling.definitions.items()):
        expression = expression.subs(symbol, definition)
    return expression


class ClosedLoop:
    """Plant and sensors of the reduced bed in numbers, with ``u = P v + R y`` around them.

    A signal is a row over (velocities, twists, inputs, frictions); a torque sensor may contain air-gap torques, so
    the loop through the sensors is algebraic and is solved first.
    """

    def __init__(
        self, decoupling: Decoupling, damping: Mapping[str, float], values: Mapping[sp.Symbol, float] | None = None
    ) -> None:
        model = decoupling.model
        tuned = {symbol: damping[symbol.name] for symbol in decoupling.damping}
        self.values = decoupling.values | tuned | dict(values or {})
        numeric = model.numeric(self.values)
        self.A, self.B, self.F = numeric.state_matrices()
        self._rates = (self.A, self.B, self.F)
        C, D, H = self._stack([model.signals[sensor.name] for sensor in model.sensors], decoupling)
        P, R = (evaluate_matrix(matrix, self.values) for matrix in (decoupling.law.P, decoupling.law.R))
        solved = np.linalg.inv(np.eye(len(P)) - R @ D)
        self.of_v, self.of_x, self.of_T = solved @ P, solved @ R @ C, solved @ R @ H
        self.outputs = self._stack([model.signals[name] for name in decoupling.outputs], decoupling)

    def _stack(self, forms: list[LinearForm], decoupling: Decoupling) -> tuple[Array, Array, Array]:
        """Return the signals over states, inputs and frictions, accelerations replaced in numbers."""
        n_z = len(decoupling.model.coordinates)
        A, B, F = self._rates
        rows = []
        for form in forms:
            z, e, u, f, a = (evaluate_matrix(part, self.values) for part in (form.z, form.e, form.u, form.f, form.a))
            rows.append((np.hstack([z, e]) + a @ A[:n_z], u + a @ B[:n_z], f + a @ F[:n_z]))
        return tuple(np.vstack([row[k] for row in rows]) for k in range(3))

    def transfer(self, s: complex) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Return the responses of the outputs to the virtual inputs and to the friction torques at `s`."""
        C, D, H = self.outputs
        resolvent = np.linalg.inv(s * np.eye(len(self.A)) - self.A - self.B @ self.of_x)
        by_state = (C + D @ self.of_x) @ resolvent
        to_v = by_state @ self.B @ self.of_v + D @ self.of_v
        to_T = by_state @ (self.F + self.B @ self.of_T) + D @ self.of_T + H
        return to_v, to_T


def wanted(
    decoupling: Decoupling, damping: Mapping[str, float], s: complex, values: Mapping[sp.Symbol, float] | None = None
) -> NDArray[np.complex128]:
    """Return the diagonal that (5.49), (5.58), (5.70), (5.76) ask for at `s`."""
    result = np.zeros((len(decoupling.outputs),) * 2, dtype=complex)
    values = values or decoupling.values
    for index, machine in enumerate(decoupling.actuators):
        if index < decoupling.torque_count:
            c = float(evaluate_matrix(sp.Matrix([[decoupling.stiffness[index]]]), values)[0, 0])
            inertia, d = values[decoupling.inertia_estimate[index]], damping[decoupling.damping[index].name]
            result[index, index] = c / (inertia * s**2 + d * s + c)
        else:
            rotor = decoupling.model.body_inertias[f"{decoupling.machines[machine]}.shaft"]
            result[index, index] = 1 / (values[rotor] * s)
    return result


def assert_decoupled(decoupling: Decoupling, seed: int = 0) -> None:
    """Check the whole closed loop at random complex frequencies: diagonal, as wanted, no slip torque in it."""
    random = np.random.default_rng(seed)
    damping = {symbol.name: float(random.uniform(1, 500)) for symbol in decoupling.damping}
    loop = ClosedLoop(decoupling, damping)
    for s in random.uniform(1, 200, 5) + 1j * random.uniform(1, 300, 5):
        to_v, to_T = loop.transfer(s)
        expected = wanted(decoupling, damping, s)
        size = abs(np.diag(expected))[:, None]  # all virtual inputs are torques, so a row has one unit
        assert np.max(abs(to_v - expected) / size) < 1e-7, (to_v, expected)
        # A friction torque that is part of the controlled torque itself is seen until the loop has settled.
        seen = loop.outputs[2] * (1 - np.diag(expected))[:, None]
        seen[decoupling.torque_count :] = 0
        np.testing.assert_allclose(to_T, seen, atol=1e-7)

"""The mechanics of a bed written a second time, in numbers and with nothing of ptgen but the checked file.

Bodies, springs and constraints stand over all velocities; constraints are met with an orthonormal basis of their
null space (SVD), inertia-free motions by a Schur complement, constraint torques as multipliers of the KKT system.
"""

from __future__ import annotations

import numpy as np
import scipy.linalg
from numpy.typing import NDArray

from ptgen.testbed import Testbed

Array = NDArray[np.float64]


class Reference:
    """Matrices of a bed over all velocities; rows of springs ``E``, frictions ``G``, constraints ``J``."""

    def __init__(self, testbed: Testbed) -> None:
        self.names: list[str] = []
        self.inertia: dict[str, float] = {}
        self._rows: list[tuple[str, dict[str, float], tuple[float, float]]] = []
        self._constraints: list[tuple[str, dict[str, float]]] = []
        self._frictions: list[tuple[str, dict[str, float], float]] = []
        for name, part in testbed.components.items():
            self.names += [f"{name}.{flange}" for flange in part.flange_names()]
            getattr(self, f"_{part.type_name}")(name, part)
        for link in testbed.connections:
            self._constraints.append((link.left, {link.left: 1.0, link.right: -1.0}))
        self.machines = list(testbed.machines)
        self.M = np.diag([self.inertia.get(name, 0.0) for name in self.names])
        self.springs = [name for name, _, _ in self._rows]
        self.E = self._stack([row for _, row, _ in self._rows])
        self.c = np.array([values[0] for _, _, values in self._rows])
        self.d = np.array([values[1] for _, _, values in self._rows])
        self.J = self._stack([row for _, row in self._constraints])
        self.connections = [owner for owner, _ in self._constraints]
        self.frictions = [name for name, _, _ in self._frictions]
        self.G = self._stack([row for _, row, _ in self._frictions])
        self.viscous = np.array([value for _, _, value in self._frictions])
        self.B = self._stack([{f"{name}.shaft": 1.0} for name in self.machines])
        self.N = scipy.linalg.null_space(self.J / np.linalg.norm(self.J, axis=1, keepdims=True), rcond=1e-11)

    def _stack(self, rows: list[dict[str, float]]) -> Array:
        matrix = np.zeros((len(rows), len(self.names)))
        for index, row in enumerate(rows):
            for name, value in row.items():
                matrix[index, self.names.index(name)] = value
        return matrix

    def _body(self, velocity: str, inertia: float) -> None:
        if velocity not in self.names:
            self.names.append(velocity)
        self.inertia[velocity] = self.inertia.get(velocity, 0.0) + inertia

    def _machine(self, name: str, part: object) -> None:
        self._body(f"{name}.shaft", part.inertia)

    def _inertia(self, name: str, part: object) -> None:
        self._body(f"{name}.left", part.inertia)
        self._constraints.append((name, {f"{name}.left": 1.0, f"{name}.right": -1.0}))

    def _shaft(self, name: str, part: object) -> None:
        self._rows.append((name, {f"{name}.left": 1.0, f"{name}.right": -1.0}, (part.stiffness, part.damping)))

    def _torque_flange(self, name: str, part: object) -> None:
        self._body(f"{name}.uut", part.inertia)
        self._body(f"{name}.machine", part.inertia_machine or 0.0)
        self._rows.append((name, {f"{name}.machine": 1.0, f"{name}.uut": -1.0}, (part.stiffness, part.damping)))

    def _gearbox(self, name: str, part: object) -> None:
        self._body(f"{name}.{part.inertia_side}", part.inertia)
        self._constraints.append((name, {f"{name}.input": 1.0, f"{name}.output": -part.ratio}))

    def _split(self, name: str, part: object, ratio: float, share1: float, share2: float, pinion: float) -> None:
        """``output = input/ratio +- share * third``; `pinion` is the inertia on the third velocity."""
        third = f"{name}.third"
        self._body(third, pinion)
        for output, share in (("output1", share1), ("output2", -share2)):
            self._constraints.append(
                (name, {f"{name}.{output}": 1.0, f"{name}.input": -1 / ratio, third: -share}),
            )
        for kind, velocity in (("loss", f"{name}.input"), ("limited_slip", third)):
            if getattr(part, kind) is not None:
                self._frictions.append((f"{name}.{kind}", {velocity: 1.0}, getattr(part, kind).viscous))

    def _differential(self, name: str, part: object) -> None:
        rho = part.pinion_ratio
        self._body(f"{name}.input", part.inertia)
        self._split(name, part, part.ratio, rho, rho, rho * part.inertia_pinion)  # (C.14) times rho

    def _bevel_differential(self, name: str, part: object) -> None:
        self._body(f"{name}.input", part.inertia_drive + part.inertia_cage / part.ratio**2)
        self._body(f"{name}.output1", part.inertia_output1)
        self._body(f"{name}.output2", part.inertia_output2)
        share1, share2 = (part.radius_pinion / radius for radius in (part.radius_output1, part.radius_output2))
        self._split(name, part, part.ratio, share1, share2, part.inertia_pinion)

    def _epicyclic_differential(self, name: str, part: object) -> None:
        self._body(f"{name}.input", part.inertia_carrier)
        self._body(f"{name}.output1", part.inertia_ring)
        self._body(f"{name}.output2", part.inertia_sun)
        planet = (part.radius_ring - part.radius_sun) / 2
        share1, share2 = planet / part.radius_ring, planet / part.radius_sun
        self._split(name, part, 1.0, share1, share2, part.planets * part.inertia_planet)

    # -- results

    def squared_frequencies(self, locked: tuple[str, ...] = ()) -> Array:
        """Return the squares of all natural frequencies (1/s^2), rigid-body motions included, in order."""
        rows = [self.frictions.index(name) for name in locked]
        N = self.N @ scipy.linalg.null_space(self.G[rows] @ self.N) if rows else self.N
        M, K = N.T @ self.M @ N, N.T @ self.E.T @ np.diag(self.c) @ self.E @ N
        sizes, axes = np.linalg.eigh(M)
        loaded = sizes > 1e-12 * sizes.max()
        kept, free = axes[:, loaded], axes[:, ~loaded]
        K_kk, K_kf, K_ff = kept.T @ K @ kept, kept.T @ K @ free, free.T @ K @ free
        condensed = K_kk - K_kf @ np.linalg.solve(K_ff, K_kf.T) if free.shape[1] else K_kk
        return scipy.linalg.eigh(condensed, kept.T @ M @ kept, eigvals_only=True)

    def applied(self, v: Array, twists: Array, u: Array, T: Array) -> Array:
        """Return all applied torques on the velocities."""
        torques = self.c * twists + self.d * (self.E @ v)
        return self.B.T @ u - self.E.T @ torques - self.G.T @ (T + self.viscous * (self.G @ v))

    def constrained(self, force: Array) -> tuple[Array, Array]:
        """Return accelerations and the multipliers of the constraints; positive drives the right-hand side."""
        n, m = len(self.names), len(self.J)
        kkt = np.block([[self.M, self.J.T], [self.J, np.zeros((m, m))]])
        solution, *_ = np.linalg.lstsq(kkt, np.concatenate([force, np.zeros(m)]), rcond=1e-14)
        return solution[:n], solution[n:]

    def machine_stiffness(self) -> Array:
        """Return the stiffness between the machines when nothing else has inertia, (n_m, n_m)."""
        K = self.N.T @ self.E.T @ np.diag(self.c) @ self.E @ self.N
        rotors = self.B @ self.N
        free = scipy.linalg.null_space(rotors)
        held = np.linalg.pinv(rotors)
        K_ff = free.T @ K @ free
        relaxed = held - free @ np.linalg.lstsq(K_ff, free.T @ K @ held, rcond=1e-12)[0]
        return relaxed.T @ K @ relaxed

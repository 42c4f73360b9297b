"""Loops for tests: continuous systems behind a dead time, closed by a sampled controller, as matrices."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import scipy.linalg

from ptgen.analysis.linear import SampledLoop


class MatrixFamily:
    """The same calls as `ptgen.analysis.linear.LoopFamily`, for given matrices.

    ``dx/dt = A x + B u`` with held, delayed ``u``; ``y = C x``; controller ``w+ = F w + G y``, ``u = H w + K y``.
    """

    def __init__(self, plant, controller, sample_time, dead_time=0.0):
        self.A, self.B, self.C = (np.atleast_2d(np.asarray(m, dtype=float)) for m in plant)
        self.F, self.G, self.H, self.K = (np.asarray(m, dtype=float) for m in controller)
        self.sample_time = sample_time
        self.machines = tuple(f"M{k + 1}" for k in range(self.B.shape[1]))
        self._dead_time = dead_time

    def delay(self, machine: str, parameters: Mapping[str, float] | None = None) -> float:
        return self._dead_time

    def loop(self, parameters=None, delays=None):
        h, n, m, n_w = self.sample_time, len(self.A), len(self.machines), len(self.F)
        whole, split = [], []
        for machine in self.machines:
            total = self._dead_time + (delays or {}).get(machine, 0.0)
            steps = int(np.floor(total / h + 1e-6))
            whole.append(steps)
            split.append(max(0.0, total / h - steps))
        Phi, _ = self._held(h)
        late = np.column_stack([self._held((1 - f) * h)[1][:, k] for k, f in enumerate(split)])
        early = self._held(h)[1] - late
        A = np.zeros((n + m + n_w, n + m + n_w))  # states, last commands, controller
        A[:n, :n], A[:n, n : n + m] = Phi, early
        A[n + m :, :n], A[n + m :, n + m :] = self.G @ self.C, self.F
        B = np.vstack([late, np.eye(m), np.zeros((n_w, m))])
        C = np.hstack([self.K @ self.C, np.zeros((m, m)), self.H])
        states = tuple(f"x{k}" for k in range(len(A)))
        return SampledLoop(A, B, C, self.machines, states, h), tuple(whole)

    def delayed(self, parameters=None, delays=None) -> SampledLoop:
        loop, steps = self.loop(parameters, delays)
        return loop.delayed(steps)

    def _held(self, time):
        n, m = self.B.shape
        joined = np.zeros((n + m, n + m))
        joined[:n, :n], joined[:n, n:] = self.A, self.B
        whole = scipy.linalg.expm(joined * time)
        return whole[:n, :n], whole[:n, n:]


def static(K):
    """Return a controller without states."""
    K = np.atleast_2d(np.asarray(K, dtype=float))
    return np.zeros((0, 0)), np.zeros((0, K.shape[1])), np.zeros((K.shape[0], 0)), K


def radius(matrix) -> float:
    """Return the size of the largest pole."""
    return float(abs(np.linalg.eigvals(matrix)).max())

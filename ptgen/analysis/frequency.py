"""The loop transfer matrix over frequency, and where its curves cross."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import scipy.linalg
import scipy.optimize
from numpy.typing import NDArray

from ptgen.analysis.linear import SampledLoop

__all__ = ["NEUTRAL", "FrequencyResponse", "crossings", "frequency_grid", "others_closed"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

NEUTRAL = 1e-9
"""Poles of z that are no further from the unit circle are neutral: what open clutches leave to coast."""

_POINTS = 1200
_AROUND = np.array([0.0, 0.03, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.5, 5.0, 10.0])


class FrequencyResponse:
    """``L(exp(j omega h))`` of a loop whose commands may be delayed by whole steps.

    Parameters
    ----------
    loop : SampledLoop
    steps : sequence of int, optional
        Whole steps by which the commands to each machine are delayed besides.
    """

    def __init__(self, loop: SampledLoop, steps: Sequence[int] | None = None) -> None:
        self.loop = loop
        self.steps = np.zeros(len(loop.machines)) if steps is None else np.asarray(steps, dtype=np.float64)
        T, Q = scipy.linalg.schur(loop.A, output="complex")
        self._T, self._B, self._C = T, Q.conj().T @ loop.B, loop.C @ Q

    def __call__(self, omega: float | Array) -> Complex:
        """Return the matrices (..., m, m) at angular frequencies ``omega`` (rad/s)."""
        if np.ndim(omega) == 0:
            z = np.exp(1j * float(omega) * self.loop.sample_time)
            x = np.zeros_like(self._B)
            for i in range(len(x) - 1, -1, -1):
                x[i] = (self._B[i] + self._T[i, i + 1 :] @ x[i + 1 :]) / (z - self._T[i, i])
            return np.asarray(self._C @ x * z**-self.steps)
        points = np.asarray(omega, dtype=np.float64)
        z = np.exp(1j * points * self.loop.sample_time)
        n, m = self._B.shape
        X = np.zeros((len(points), n, m), dtype=np.complex128)
        for i in range(n - 1, -1, -1):
            coupled = np.einsum("j,kjm->km", self._T[i, i + 1 :], X[:, i + 1 :]) if i + 1 < n else 0.0
            X[:, i] = (self._B[i] + coupled) / (z - self._T[i, i])[:, None]
        result = np.einsum("in,knm->kim", self._C, X) * z[:, None, None] ** -self.steps
        return np.asarray(result)


def frequency_grid(loop: SampledLoop) -> Array:
    """Return angular frequencies (rad/s) up to half the sampling rate, dense where a resonance could hide."""
    h = loop.sample_time
    systems = [loop.A, loop.closed(), *(loop.opened(k).A for k in range(len(loop.machines)))]
    z = np.concatenate([np.linalg.eigvals(A) for A in systems]).astype(np.complex128)
    s = np.log(z[(abs(z) > 1e-6) & (abs(z - 1) > NEUTRAL)]) / h
    highest = np.pi / h
    slowest = max(1e-3 * float(abs(s).min(initial=highest)), 1e-8 / h)
    points = [np.geomspace(slowest, highest, _POINTS)]
    for pole in s[s.imag > 0]:
        width = max(abs(pole.real), 1e-6 * abs(pole))
        points += [pole.imag + width * _AROUND, pole.imag - width * _AROUND]
    joined = np.unique(np.concatenate(points))
    return np.asarray(joined[(joined >= slowest) & (joined <= highest)], dtype=np.float64)


def others_closed(L: Complex, machine: int) -> Complex:
    """Return the loop transfer function (...) of one machine with the loops of all others closed."""
    m = L.shape[-1]
    others = [k for k in range(m) if k != machine]
    if not others:
        return np.asarray(L[..., machine, machine])
    inner = np.eye(m - 1) - L[..., others, :][..., others]
    column = L[..., others, machine][..., None]
    back = np.linalg.solve(inner, column)
    row = L[..., machine, :][..., others][..., None, :]
    return np.asarray(L[..., machine, machine] + (row @ back)[..., 0, 0])


def crossings(omega: Array, values: Array, function: Callable[[float], float]) -> list[float]:
    """Return where a real function of frequency passes zero.

    Parameters
    ----------
    omega, values : ndarray (n,)
        Samples of it.
    function : callable
        The function itself.
    """
    found = [float(w) for w, value in zip(omega, values, strict=True) if value == 0]
    for k in np.nonzero(values[:-1] * values[1:] < 0)[0]:
        if function(omega[k]) * function(omega[k + 1]) >= 0:
            continue  # no more than rounding, where the function is all but zero
        root, result = scipy.optimize.brentq(
            function, omega[k], omega[k + 1], xtol=1e-12 * omega[k + 1], rtol=1e-14, full_output=True, disp=False
        )
        if result.converged:
            found.append(float(root))
    return sorted(found)

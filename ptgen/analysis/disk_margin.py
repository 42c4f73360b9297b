r"""Disk margin: how much gain and phase all machines may lose at once, each in its own way.

Every torque command gets a factor :math:`f_i = (1 + \delta_i / 2) / (1 - \delta_i / 2)` with complex
:math:`|\delta_i| < \alpha`, the balanced (skew 0) family. With the sensitivity :math:`S = (I - L)^{-1}` the loop stays
stable for all of them up to

.. math:: \alpha = 1 / \max_\omega \mu(S - I / 2)

where :math:`\mu` is the structured singular value for diagonal :math:`\delta`. It is bounded from above by scaling,
:math:`\mu(M) \le \min_D \bar\sigma(D M D^{-1})` with positive diagonal ``D``, which is exact for up to three machines
and keeps the margin on the safe side for more.

References
----------
P. Seiler, A. Packard, P. Gahinet: An Introduction to Disk Margins, IEEE Control Systems Magazine 40 (5), 2020.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.optimize
from numpy.typing import NDArray

from ptgen.analysis.frequency import FrequencyResponse

__all__ = ["DiskMargin", "disk_margin", "structured_singular_value"]

_BALANCING = 6
"""Rounds of balancing that give the scaling to start from."""

_REFINED = 3
"""Peaks that are refined."""


@dataclass(frozen=True)
class DiskMargin:
    """The disk margin at the torque commands.

    Attributes
    ----------
    alpha : float
        Size of the disk, up to 2.
    frequency_hz : float
        Where it is reached (Hz).
    """

    alpha: float
    frequency_hz: float

    @property
    def gain_up(self) -> float:
        """Factor up to which the gains of all machines may rise, each on its own."""
        return (2 + self.alpha) / (2 - self.alpha) if self.alpha < 2 else float("inf")

    @property
    def gain_down(self) -> float:
        """Factor down to which they may fall."""
        return max(0.0, (2 - self.alpha) / (2 + self.alpha))

    @property
    def phase_deg(self) -> float:
        """Phase (deg) that they may lose or gain."""
        return float(2 * np.degrees(np.arctan(self.alpha / 2)))


def disk_margin(response: FrequencyResponse, omega: NDArray[np.float64], enough: float | None = None) -> DiskMargin:
    """Return the disk margin of a stable loop.

    Parameters
    ----------
    response : FrequencyResponse
    omega : ndarray (n,)
        Angular frequencies to search first (rad/s); see `ptgen.analysis.frequency.frequency_grid`.
    enough : float, optional
        If the margin is larger than that by a twentieth, a bound from below is returned, which takes less time.
    """
    identity = np.eye(len(response.loop.machines))

    def matrices(L: NDArray[np.complex128]) -> NDArray[np.complex128]:
        return np.asarray(np.linalg.inv(identity - L) - identity / 2)

    M = matrices(response(omega))
    scales = _balanced(M)
    bound = np.linalg.norm(_scaled(M, scales), ord=2, axis=(-2, -1))
    worst = int(np.argmax(bound))
    if enough is not None and 1 / bound[worst] > 1.05 * enough:
        return DiskMargin(float(1 / bound[worst]), float(omega[worst] / (2 * np.pi)))
    peaks = [k for k in range(len(bound)) if bound[k] == bound[max(0, k - 1) : k + 2].max()]
    best = (0.0, float(omega[0]))
    for k in sorted(peaks, key=lambda k: -bound[k])[:_REFINED]:
        low, high = np.log(omega[max(0, k - 1)]), np.log(omega[min(len(omega) - 1, k + 1)])

        def size(logarithm: float) -> float:
            return structured_singular_value(matrices(response(float(np.exp(logarithm)))))

        found = scipy.optimize.minimize_scalar(
            lambda w: -size(w), bounds=(low, high), method="bounded", options={"xatol": 1e-5}
        )
        best = max(best, (-float(found.fun), float(np.exp(found.x))), (size(np.log(omega[k])), float(omega[k])))
    return DiskMargin(1 / best[0], best[1] / (2 * np.pi))


def structured_singular_value(M: NDArray[np.complex128]) -> float:
    """Return the least ``sigma(D M D^-1)`` over positive diagonal ``D``, an upper bound of mu.

    Parameters
    ----------
    M : ndarray (m, m)

    Examples
    --------
    >>> round(structured_singular_value(np.array([[0, 100.0], [0.01, 0]], dtype=complex)), 6)
    1.0
    """
    if len(M) == 1:
        return float(abs(M[0, 0]))
    start = np.log(_balanced(M[None])[0])

    def largest(logarithms: NDArray[np.float64]) -> float:
        return float(np.linalg.norm(_scaled(M, np.exp(np.append(logarithms, 0.0))), ord=2))

    first = start[:-1] - start[-1]
    # The bound is convex in the logarithms, with edges where two singular values meet.
    found = scipy.optimize.minimize(largest, first, method="Nelder-Mead", options={"xatol": 1e-5, "fatol": 1e-8})
    return float(min(found.fun, largest(first)))


def _scaled(M: NDArray[np.complex128], scales: NDArray[np.float64]) -> NDArray[np.complex128]:
    return np.asarray(M * scales[..., :, None] / scales[..., None, :])


def _balanced(M: NDArray[np.complex128]) -> NDArray[np.float64]:
    """Return scales (..., m) that make rows and columns of equal size (Osborne)."""
    m = M.shape[-1]
    scales = np.ones(M.shape[:-1])
    if m == 1:
        return scales
    squared = np.abs(M) ** 2
    for _ in range(_BALANCING):
        for i in range(m):
            now = squared * (scales[..., :, None] / scales[..., None, :]) ** 2
            row = now[..., i, :].sum(-1) - now[..., i, i]
            column = now[..., :, i].sum(-1) - now[..., i, i]
            tiny = 1e-24 * (now.sum((-2, -1)) + 1e-300)
            scales[..., i] *= ((column + tiny) / (row + tiny)) ** 0.25
    return scales

r"""The loop through torque flanges that read the air-gap torque of the very machine that they correct.

Where the parts between a machine and its flange are as good as rigid, the flange reads a share of the air-gap torque
at once: ``y = ... + D_s u``. The law turns the reading into torque again, ``u = ... + R y``. Without sampling that is
an algebraic loop with the matrix :math:`R D_s`; sampled it is a recursion from one step to the next, which dies away if
the spectral radius is below 1. For load torque compensation of a machine with the inertia :math:`I_m` behind which a
gearbox has the inertia :math:`I_g` the share is :math:`\gamma I_g / (I_m + I_g)`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.control.decoupling import Decoupling
from ptgen.mechanism import exact
from ptgen.mechanism.model import evaluate_matrix

__all__ = ["AlgebraicLoop", "algebraic_loop"]


@dataclass(frozen=True)
class AlgebraicLoop:
    """The loop through measured torques.

    Attributes
    ----------
    machines : tuple of str (m)
    matrix : ndarray (m, m)
        ``R D_s``.
    radius : float
        Its spectral radius.
    """

    machines: tuple[str, ...]
    matrix: NDArray[np.float64]
    radius: float

    @property
    def gains(self) -> dict[str, float]:
        """What every machine feeds back to itself."""
        return {name: float(self.matrix[k, k]) for k, name in enumerate(self.machines)}

    @property
    def is_stable(self) -> bool:
        """Whether the recursion dies away."""
        return self.radius < 1

    @property
    def settling_steps(self) -> float:
        """Steps until 1 % is left; infinite if it does not die away."""
        if self.radius == 0:
            return 0.0
        return float(np.log(0.01) / np.log(self.radius)) if self.radius < 1 else float("inf")


def algebraic_loop(decoupling: Decoupling, parameters: Mapping[str, float]) -> AlgebraicLoop:
    """Return the loop through measured torques.

    Parameters
    ----------
    decoupling : Decoupling
    parameters : mapping
        Parameters of the controller by name: damping, inertias, ``load_compensation``.
    """
    model, law = decoupling.model, decoupling.law
    m = len(decoupling.machines)
    through = exact.stack([model.without_acceleration(model.signals[name]).u for name in decoupling.sensors], m)
    symbols = law.R.free_symbols | through.free_symbols
    values = {**decoupling.values, **dict.fromkeys(decoupling.damping, 0.0)}
    values |= {symbol: parameters[symbol.name] for symbol in symbols if symbol.name in parameters}
    R = evaluate_matrix(law.R, values)
    for machine in decoupling.actuators[decoupling.torque_count :]:
        R[machine] *= parameters.get("load_compensation", 1.0)
    matrix = R @ evaluate_matrix(through, values)
    return AlgebraicLoop(decoupling.machines, matrix, float(abs(np.linalg.eigvals(matrix)).max(initial=0.0)))

"""How much an element takes part in the motions that a reduced model must keep."""

from __future__ import annotations

import numpy as np
import sympy as sp

from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.modes import Mode

__all__ = ["Participation"]


class Participation:
    """Shares of elements in the motions that the reduced model must keep."""

    def __init__(self, full: Model, before: tuple[Mode, ...], twists: int) -> None:
        self._values = full.values
        self._full = full
        rigid = [mode.vector for mode in before if mode.frequency_hz == 0]
        elastic = [mode for mode in before if mode.frequency_hz > 0][:twists]
        self.kept = tuple(mode.frequency_hz for mode in elastic)
        # The vectors have unit kinetic energy and are orthogonal in it, so shares are sums of squares.
        self._all = np.array(rigid + [mode.vector for mode in elastic])
        self._elastic = np.array([mode.vector / (2 * np.pi * mode.frequency_hz) for mode in elastic])

    def kinetic(self, velocity: str) -> float:
        """Return the largest share of a body in the kinetic energy of any kept motion."""
        row = evaluate_matrix(self._full.body_rows[velocity], self._values)[0]
        inertia = evaluate_matrix(sp.Matrix([[self._full.body_inertias[velocity]]]), self._values)[0, 0]
        return float(inertia * np.sum((self._all @ row) ** 2))

    def strain(self, spring: str) -> float:
        """Return the largest share of a spring in the strain energy of any kept elastic motion."""
        if not len(self._elastic):
            return 1.0  # nothing tells how little it matters
        row = self._full.spring_rows[spring] * self._full.twist_rows
        stiffness = evaluate_matrix(sp.Matrix([[self._full.spring_stiffness[spring]]]), self._values)[0, 0]
        return float(stiffness * np.sum((self._elastic @ evaluate_matrix(row, self._values)[0]) ** 2))

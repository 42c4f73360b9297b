"""The closed loop of the bed for differentials in direct drive, (7.20)-(7.29), with numbers of Tables C.1 and 7.1."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from ptgen.governor.limit_rows import LimitRows, Situation

Array = NDArray[np.float64]

STEP = 1e-4
INERTIA = np.array([1.0, 10.3, 10.3])
MOST = np.array([930.0, 3700.0, 3700.0])
RATIO = 1.91
# Shafts and flanges in series, the outputs referred to the input.
_SERIES = [1 / (1 / 380e3 + 1 / 57e3), 1 / (1 / 220e3 + 1 / 57e3), 1 / (1 / 220e3 + 1 / 57e3)]
STIFFNESS = 1 / (1 / _SERIES[0] + RATIO**2 / (_SERIES[1] + _SERIES[2]))
DAMPING = 2 * np.sqrt(STIFFNESS / (1 / INERTIA[0] + RATIO**2 / (4 * INERTIA[1]) + RATIO**2 / (4 * INERTIA[2])))
SPEED_GAIN = 30.0 * INERTIA[1]
SPEED_INTEGRAL = 30.0**2 / 8 * INERTIA[1]
TORQUE_INTEGRAL = 20.0


class Bed:
    """``x+ = A x + B r``, ``u = C x + D r + W T_dsl`` (7.27), (7.29), and its steady state ``X r``."""

    def __init__(self) -> None:
        i1, i2, i3 = INERTIA
        c, d, i = STIFFNESS, DAMPING, RATIO
        half = i / 2
        Ac = np.zeros((4, 4))  # omega1, omega2, omega3, twist (7.20)
        Ac[0] = [-d / i1, d * half / i1, d * half / i1, -c / i1]
        Ac[3] = [1, -half, -half, 0]
        Bc = np.array([[1 / i1, half / i2, half / i3], [0, 1 / i2, 0], [0, 0, 1 / i3], [0, 0, 0]])
        whole = expm(STEP * np.block([[Ac, Bc], [np.zeros((3, 7))]]))
        Ap, Bp = whole[:4, :4], whole[:4, 4:]  # (7.22)
        # Virtual controls v = V x + R r (7.23)-(7.25), integrators x+ = x + E x + F r.
        V, R = np.zeros((3, 7)), np.diag([1.0, SPEED_GAIN, SPEED_GAIN])
        V[0, 4] = V[1, 5] = V[2, 6] = 1.0
        V[1, 1] = V[2, 2] = -SPEED_GAIN
        F = STEP * np.diag([TORQUE_INTEGRAL, SPEED_INTEGRAL, SPEED_INTEGRAL])
        E = np.zeros((3, 7))
        E[0, 3] = -STEP * TORQUE_INTEGRAL * c
        E[1, 1] = E[2, 2] = -STEP * SPEED_INTEGRAL
        self.A = np.vstack([np.hstack([Ap, np.zeros((4, 3))]) + Bp @ V, np.hstack([np.zeros((3, 4)), np.eye(3)]) + E])
        self.B = np.vstack([Bp @ R, F])
        mix = np.array([[1, i1 * half / i2, i1 * half / i3], [0, 1, 0], [0, 0, 1]])
        own = np.zeros((3, 7))
        own[0, :3] = [-d, d * half, d * half]
        own[1, 3] = own[2, 3] = -half * c
        self.C, self.D = mix @ V + own, mix @ R  # (7.28)
        self.W = np.array([0.0, 0.5, -0.5])
        self.X = np.linalg.solve(np.eye(7) - self.A, self.B)

    def rows(self, steps: tuple[Array, ...]) -> tuple[Array, Array]:
        """Return the coefficients of the rows of some steps of each machine."""
        last = max(int(kept.max(initial=0)) for kept in steps)
        powers, wanted = np.eye(7), [np.zeros((len(kept), 7)) for kept in steps]
        for k in range(1, last + 1):
            powers = powers @ self.A
            for machine, kept in enumerate(steps):
                wanted[machine][kept == k] = self.C[machine] @ (powers - np.eye(7))
        x = np.vstack(wanted)
        return x, -x @ self.X


class Limits:
    """A constraint set with every so many steps of a horizon."""

    def __init__(self, bed: Bed, horizon: int, every: int) -> None:
        kept = np.arange(every, horizon + 1, every)
        self.steps = (kept, kept, kept)
        self._rows = bed.rows(self.steps)

    def rows_x(self) -> Array:
        return self._rows[0]

    def rows_r(self) -> Array:
        return self._rows[1]


BED = Bed()


def limit_rows(horizon: int = 5000, every: int = 63) -> LimitRows:
    return LimitRows.predicted(Limits(BED, horizon, every)) if horizon else LimitRows.present(3, 7)


def situation(x: Array, before: Array, wanted: Array, slip: float = 0.0, share: float = 0.95) -> Situation:
    """Return what the governor knows in the state `x`."""
    free = BED.C @ x + BED.D @ before + BED.W * slip
    most = share * MOST
    return Situation(wanted, before, free, BED.D, -most, most, x - BED.X @ wanted)


def random_situation(rng: np.random.Generator, way: float = 1.0) -> Situation:
    """Return a state near the steady state of some references, and other references that are wanted."""
    before = rng.uniform(-1, 1, 3) * [800.0, 150.0, 150.0]
    wanted = before + way * rng.uniform(-1, 1, 3) * [100.0, 20.0, 20.0] * rng.choice([0.03, 0.3, 1.0], 3)
    near = before + way * rng.uniform(-1, 1, 3) * [40.0, 4.0, 4.0]
    return situation(BED.X @ near, before, wanted, slip=float(rng.uniform(-200, 200)))

"""The kernels: what blocks call besides scalar expressions. This is the one list of them.

Each kernel is implemented here for arrays with leading batch axes, in `ptgen.block.casadi_evaluator` for
CasADi, and in ``templates/`` for C. The tests compare the three.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ptgen.friction.backlash import backlash_step
from ptgen.friction.box import ROUNDING, is_deficient
from ptgen.friction.fluid import fluid_torques
from ptgen.friction.step import friction_step
from ptgen.shaping.optimal import optimal_governor
from ptgen.shaping.sequential import sequential_governor

__all__ = [
    "KERNELS",
    "TAYLOR_DEGREE",
    "add_product",
    "cholesky_solve",
    "delay",
    "difference",
    "discretise",
    "guard",
    "insert",
    "lasting",
    "lookup",
    "multiply",
    "require_definite",
    "rounding_unit",
    "share",
    "still",
    "swings",
]

Array = NDArray[np.float64]

TAYLOR_DEGREE = 18
"""Degree of the exponential series; with arguments of norm 1 at most, the rest is below 1e-17."""


def cholesky_solve(M: Array, right: Array) -> Array:
    """Solve ``M X = right`` for symmetric positive definite M (n, n), right (n, m)."""
    return np.asarray(np.linalg.solve(M, right), dtype=np.float64)


def require_definite(K: Array, *numbers: int) -> tuple[()]:
    """Check that K (n, n) is positive definite; only semidefinite if the number is 1.

    Raises
    ------
    ValueError
        If it is not: a mode of the bed is too fast for the step, or elements hold the same motion.
    """
    (semidefinite,) = numbers
    for index in np.ndindex(*K.shape[:-2]):
        if is_deficient(K[index]) and not semidefinite:
            raise ValueError("friction matrix is not positive definite: elements hold the same motion")
    return ()


def insert(target: Array, source: Array, *numbers: int) -> Array:
    """Copy columns of `source` into `target`.

    `numbers` are the row and column in `target`, the first column in `source`, and how many columns.
    """
    row, column, first, count = numbers
    result = target.copy()
    result[..., row : row + source.shape[-2], column : column + count] = source[..., first : first + count]
    return result


def discretise(A: Array, scale: Array, duration: Array, *numbers: int) -> Array:
    r"""Return the first n rows of :math:`\exp(\tilde A\,t)` with :math:`\tilde A` = A over zero rows.

    A is (n, n + m): state matrix and input columns. ``scale`` (n + m,) balances the exponential: it is
    taken of ``diag(scale)^-1 A~ diag(scale)``. `numbers` is the number of squarings. Taylor series with
    scaling and squaring, source of the idea: design by exact discretisation (Van Loan).
    """
    (squarings,) = numbers
    n, total = A.shape[-2], A.shape[-1]
    batch = A.shape[:-2]
    X = np.zeros((*batch, total, total))
    X[..., :n, :] = A * scale[..., None, :] / scale[..., :n, None]
    X = X * (np.asarray(duration)[..., None, None] / 2.0**squarings)
    identity = np.broadcast_to(np.eye(total), X.shape)
    E = identity + X / TAYLOR_DEGREE
    for k in range(TAYLOR_DEGREE - 1, 0, -1):
        E = identity + X @ E / k
    for _ in range(squarings):
        E = E @ E
    return np.asarray(E[..., :n, :] * scale[..., :n, None] / scale[..., None, :], dtype=np.float64)


def multiply(A: Array, x: Array) -> Array:
    """Return ``A x``; x may be longer than A has columns, the rest is not used."""
    return np.asarray(np.einsum("...ij,...j->...i", A, x[..., : A.shape[-1]]), dtype=np.float64)


def add_product(y: Array, x: Array, A: Array, T: Array) -> Array:
    """Return y with its leading part replaced by ``x + A T``; x (n,), A (n, m), T (m,)."""
    result = y.copy()
    result[..., : x.shape[-1]] = x + np.einsum("...ij,...j->...i", A, T)
    return result


def delay(buffer: Array, value: Array, steps: Array) -> tuple[Array, Array, Array]:
    """Push `value` into a delay line.

    ``buffer[k]`` is the value of k + 1 steps ago. Returns the new buffer, the value of `steps` steps ago and
    the one of a step before.
    """
    value = np.asarray(value, dtype=float)
    history = np.concatenate([value[..., None], buffer], axis=-1)
    index = np.asarray(steps).astype(int)
    late = np.take_along_axis(history, np.broadcast_to(index, value.shape)[..., None], -1)[..., 0]
    early = np.take_along_axis(history, np.broadcast_to(index + 1, value.shape)[..., None], -1)[..., 0]
    return history[..., :-1], late, early


def guard(value: Array, bound: Array, held: Array) -> tuple[Array, Array]:
    """Return `value` if it is finite and at most `bound` in size, else `held`; and 1 or 0 for which."""
    with np.errstate(invalid="ignore"):
        sound = np.abs(value) <= bound  # false for NaN
    return np.where(sound, value, held), np.where(sound, 1.0, 0.0)


def lookup(value: Array, grid: Array, slope: Array, level: Array) -> Array:
    """Return a function that is linear between the points of `grid` (n,), increasing, and constant beyond them.

    From ``grid[k]`` on it is ``level[k] + slope[k] * (value - grid[k])``; the last slope must be zero. A value that is
    not a number counts as one below the first point.
    """
    value = np.asarray(value, dtype=float)
    with np.errstate(invalid="ignore"):
        k = (value[..., None] >= grid[..., 1:]).sum(axis=-1)

    def entry(table: Array) -> Array:
        table = np.broadcast_to(table, (*k.shape, table.shape[-1]))
        return np.asarray(np.take_along_axis(table, k[..., None], -1)[..., 0])

    beyond = value - entry(grid)
    return np.asarray(entry(level) + entry(slope) * np.where(beyond > 0.0, beyond, 0.0), dtype=np.float64)


def lasting(sound: Array, time: Array, step: Array, allowed: Array) -> Array:
    """Return for how long a signal was not sound, counted up to a step more than `allowed`.

    A sound step takes back one that was not, so that a signal that is bad half of the time does not pass. Half a step
    of tolerance keeps rounding out of the comparison with `allowed`.
    """
    counted = np.where(np.asarray(time) < allowed, time, allowed)
    left = np.where(counted > step, counted, step) - step
    return np.where(np.asarray(sound) > 0.5, left, counted + step)


def still(value: Array, before: Array, time: Array, step: Array) -> Array:
    """Return for how long `value` has been the same to the last bit."""
    return np.where(np.asarray(value) == before, time + step, 0.0)


def swings(value: Array, limit: Array, side: Array, count: Array, decay: Array) -> tuple[Array, Array]:
    """Return the side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`."""
    value = np.asarray(value)
    after = np.where(value > limit, 1.0, np.where(value < -np.asarray(limit), -1.0, side))
    left = np.asarray(count - decay)
    return after, np.where(left > 0.0, left, 0.0) + np.where(after == side, 0.0, 1.0)


def share(value: Array) -> Array:
    """Return `value` limited to 0 to 1; 0 for NaN."""
    value = np.asarray(value)
    return np.where(value > 0.0, np.where(value < 1.0, value, 1.0), 0.0)


def rounding_unit() -> Array:
    """Return the share of a sum of a few numbers that may be rounding: 64 units of the precision."""
    return np.array(ROUNDING * np.finfo(np.float64).eps)


def difference(A: Array, B: Array) -> Array:
    """Return ``A - B``."""
    return A - B


KERNELS: dict[str, Callable[..., Any]] = {
    "difference": difference,
    "rounding_unit": rounding_unit,
    "insert": insert,
    "cholesky_solve": cholesky_solve,
    "discretise": discretise,
    "require_definite": require_definite,
    "multiply": multiply,
    "add_product": add_product,
    "delay": delay,
    "guard": guard,
    "lasting": lasting,
    "share": share,
    "still": still,
    "swings": swings,
    "lookup": lookup,
    "friction_step": friction_step,
    "backlash_step": backlash_step,
    "fluid_torques": fluid_torques,
    "sequential_governor": sequential_governor,
    "optimal_governor": optimal_governor,
}

r"""The rows of the governor's programs: the torque of a machine, some steps ahead, as it depends on the references.

Row ``j`` stands for machine ``i`` and step ``k``. With the shaped references ``r~``, the wanted ones ``r``, the state
``x`` of the closed loop and its steady state ``X r``, the predicted torque is (7.6), (7.28)

    v_j = u_i(r~) + row_x[j] (x - X r) + row_r[j] (r~ - r),   row_x[j] = C_i (A^k - I),   row_r[j] = -row_x[j] X

where ``u(r~) = free + gain (r~ - before)`` are the torques of this step. The rows with ``k = 0`` are those of this step
alone, (7.37): ``row_x = row_r = 0``, and nothing about them is predicted. Both signs of a limit share a row.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ptgen.errors import ControlError, Problem
from ptgen.governor.constraint_set import ConstraintSet

__all__ = ["LimitRows", "Situation"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Situation:
    """What the governor knows in one step.

    The limits are those that hold as they stand: envelope at the present speed, narrowed by the torque reserve (7.30)
    and, where rows were removed, by what their removal can cost.

    Attributes
    ----------
    wanted : ndarray (m,)
        References of the machines (N m for torques, rad/s for speeds), rate limited and within stationary limits.
    before : ndarray (m,)
        Shaped references of the last step, in the same units.
    free : ndarray (m,)
        Torques (N m) that the machines would be asked for with the references of the last step.
    gain : ndarray (m, m)
        What they change by with the references of this step, ``D`` of (7.29).
    least, most : ndarray (m,)
        Limits of the torques (N m).
    deviation : ndarray (n,)
        State of the closed loop less its steady state at the wanted references; empty without prediction.
    """

    wanted: Array
    before: Array
    free: Array
    gain: Array
    least: Array
    most: Array
    deviation: Array


@dataclass(frozen=True)
class LimitRows:
    """The rows of a program, those of this step first, one for each machine.

    Attributes
    ----------
    machine : ndarray of int (N,)
        The machine that each row limits.
    step : ndarray of int (N,)
        How many steps ahead; 0 is this step.
    x : ndarray (N, n)
        Coefficients of the deviation (N m per unit of the state).
    r : ndarray (N, m)
        Coefficients of ``r~ - r`` besides the gain (N m per unit of the reference).
    """

    machine: NDArray[np.int64]
    step: NDArray[np.int64]
    x: Array
    r: Array

    def __post_init__(self) -> None:
        count, m = len(self.machine), self.machines
        wrong = [
            Problem(name, f"has the shape {got}, wanted is {wanted}", "give one line for each row")
            for name, got, wanted in (
                ("step", self.step.shape, (count,)),
                ("x", self.x.shape, (count, self.x.shape[-1])),
                ("r", self.r.shape, (count, m)),
            )
            if got != wanted
        ]
        if not wrong and not (np.array_equal(self.machine[:m], np.arange(m)) and not self.step[:m].any()):
            wrong.append(Problem("machine", "the first rows are not those of this step", "put step 0 of each first"))
        if wrong:
            raise ControlError(wrong)

    @property
    def machines(self) -> int:
        """How many machines there are."""
        return int(self.r.shape[-1])

    @classmethod
    def predicted(cls, constraints: ConstraintSet) -> LimitRows:
        """Return the rows of a constraint set together with those of this step."""
        steps, x, r = constraints.steps, constraints.rows_x(), constraints.rows_r()
        m = len(steps)
        machine = np.repeat(np.arange(m), [len(kept) for kept in steps])
        return cls(
            machine=np.concatenate([np.arange(m), machine]),
            step=np.concatenate([np.zeros(m, dtype=np.int64), *(np.asarray(kept, dtype=np.int64) for kept in steps)]),
            x=np.vstack([np.zeros((m, x.shape[1])), x]),
            r=np.vstack([np.zeros((m, m)), r]),
        )

    @classmethod
    def present(cls, machines: int, states: int = 0) -> LimitRows:
        """Return the rows of this step alone, the horizon ``k* = 0`` of (7.37).

        Examples
        --------
        >>> LimitRows.present(3).step
        array([0, 0, 0])
        """
        index = np.arange(machines)
        return cls(index, np.zeros_like(index), np.zeros((machines, states)), np.zeros((machines, machines)))

    def at_before(self, now: Situation) -> tuple[Array, Array]:
        """Return the torques with the references of the last step (N,), and what they change by with them (N, m)."""
        slope = now.gain[self.machine] + self.r
        moved = self.r @ (now.wanted - now.before)
        return now.free[self.machine] + self.x @ now.deviation - moved, slope

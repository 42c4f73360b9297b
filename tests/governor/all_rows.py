"""The optimal governor against all rows of its horizon: emitted solver, nominal loop, HiGHS.

Few states and steps in tests, many in the bench, of a bed with three machines, the first of which controls a torque.
"""

from __future__ import annotations

import ctypes
import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
import scipy.optimize

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "shaping"))

import governor_problems

from ptgen.governor.constraint_set import ConstraintSet
from ptgen.project import Project
from ptgen.shaping.optimal import MARGIN
from ptgen.simulate.compiler import compile_library

__all__ = [
    "WEIGHT",
    "Answer",
    "EmittedGovernor",
    "NominalLoop",
    "Problem",
    "largest_shares",
    "shares",
    "worst_difference",
]

WEIGHT = np.array([1.0, 100.0, 100.0])
ITERATIONS = 40
POINTER = ctypes.POINTER(ctypes.c_double)


@dataclass(frozen=True)
class Problem:
    """What a governor is given in one step."""

    wanted: np.ndarray
    before: np.ndarray
    free: np.ndarray
    limit: np.ndarray
    deviation: np.ndarray


@dataclass(frozen=True)
class Answer:
    """What it answers."""

    shaped: np.ndarray
    slack: np.ndarray
    iterations: int
    status: int


class EmittedGovernor:
    """The emitted C of the optimal governor for one constraint set."""

    def __init__(self, constraints: ConstraintSet) -> None:
        self.constraints = constraints
        p = constraints.prediction
        m, n = p.C.shape
        sizes = governor_problems.Sizes(m=m, n=n, counts=constraints.counts, iterations=ITERATIONS)
        folder = Path(mkdtemp(prefix="sweep"))
        sources = [path for path in governor_problems.write_sources(sizes, folder) if "_shaper" not in path.name]
        compile_library(sources, folder / "bed.so")
        self._function = ctypes.CDLL(str(folder / "bed.so")).bed_optimal_governor
        self._function.restype = None
        self.rows_x, self.rows_r = constraints.rows_x(), constraints.rows_r()
        self._tables = [_columns(self.rows_x), _columns(self.rows_r), _columns(p.D)]
        self._group = np.array(sizes.group)

    def __call__(self, problem: Problem) -> Answer:
        m = len(problem.wanted)
        shaped, slack = np.zeros(m + 3), np.zeros(m + 3)
        iterations, status = ctypes.c_double(), ctypes.c_double()
        limit = problem.limit / (1 + self.constraints.removal)
        rows_x, rows_r, gain = self._tables
        vectors = (problem.wanted, problem.before, problem.free, gain, -limit, limit, problem.deviation)
        one, none = ctypes.c_double(1.0), ctypes.c_double(0.0)
        given = [*map(_pointer, (*vectors, rows_x, rows_r, WEIGHT)), none, _pointer(self._group)]
        results = [*map(_pointer, (problem.before, shaped, slack)), ctypes.byref(iterations), ctypes.byref(status)]
        self._function(one, *given, *results)
        return Answer(shaped[:m], slack[:m], int(iterations.value), int(status.value))


def _columns(matrix: np.ndarray) -> np.ndarray:
    """Return a matrix by columns, padded to four rows, as C has it."""
    rows = -(-matrix.shape[0] // 4) * 4
    padded = np.zeros((matrix.shape[1], rows))
    padded[:, : matrix.shape[0]] = matrix.T
    return np.ascontiguousarray(padded)


def _pointer(array: np.ndarray) -> ctypes._Pointer:
    return np.ascontiguousarray(array).ctypes.data_as(POINTER)


def shares(problem: Problem, shaped: np.ndarray) -> np.ndarray:
    """Return h of every reference; 1 if there was nothing to change."""
    change = problem.wanted - problem.before
    moving = np.abs(change) > 0
    return np.where(moving, (shaped - problem.before) / np.where(moving, change, 1.0), 1.0)


class NominalLoop:
    """The loop of the prediction under random steps of the references, with torque limits that follow the speed."""

    def __init__(self, project: Project, seed: int) -> None:
        self.p = project.prediction
        self.rng = np.random.default_rng(seed)
        values, inputs = project.model.values, project.model.inputs
        self.rated, self.most, self.largest = (
            np.array([values[getattr(t.drive, key)] for t in inputs])
            for key in ("speed_rated", "speed_max", "torque_max")
        )
        self.speeds = [self.p.states.index(f"{name}.shaft") for name in self.p.machines]
        self.x = np.zeros(len(self.p.A))
        self.shaped = np.zeros(len(self.p.machines))
        self.wanted = np.zeros(len(self.p.machines))
        self.slip = 0.0

    def problem(self, reserve: float, stationary_reserve: float) -> Problem:
        """Return what the governor sees now; now and then a reference or the slip-limiting torque has changed."""
        if self.rng.random() < 3e-4:
            self.wanted[0] = self.rng.uniform(-1000, 1000)
        if self.rng.random() < 3e-4:
            both = self.rng.random() < 0.4
            target = self.rng.uniform(-300, 300, 2)
            self.wanted[1:] = target[0] if both else target
        if self.rng.random() < 1e-4:
            self.slip = self.rng.uniform(-150, 150)
        limit = (1 - reserve) * self.largest * np.minimum(1.0, self.rated / np.maximum(abs(self.x[self.speeds]), 1e-9))
        beside = self.p.W[:, 0] * self.slip
        room = (1 - stationary_reserve) * limit
        Y = self.p.stationary[:, 0]
        wanted = self.wanted.copy()
        for machine, share in enumerate(Y):
            ends = sorted(((-room[machine] - beside[machine]) / share, (room[machine] - beside[machine]) / share))
            wanted[0] = min(max(wanted[0], ends[0]), ends[1])
        free = self.p.C @ self.x + self.p.D @ self.shaped + beside
        return Problem(wanted, self.shaped.copy(), free, limit, self.x - self.p.steady @ wanted)

    def step(self, shaped: np.ndarray) -> np.ndarray:
        """Go on with shaped references; return the torque commands of this step."""
        u = self.p.C @ self.x + self.p.D @ shaped + self.p.W[:, 0] * self.slip
        self.x = self.p.A @ self.x + self.p.B @ shaped
        self.shaped = shaped.copy()
        return u


def largest_shares(constraints: ConstraintSet, states: int) -> tuple[float, float, float]:
    """Return the largest share of a limit in states of the reduced set.

    Of all rows now, and of all and of the kept ones a step later.
    """
    p, rng = constraints.prediction, np.random.default_rng(2)
    full, tight = constraints.full(), 1 / (1 + constraints.removal)
    kept_x, all_x = constraints.rows_x(), full.rows_x()
    of_kept = np.repeat(np.arange(3), constraints.counts)
    of_all = np.repeat(np.arange(3), full.counts)
    largest = np.array([limit.largest for limit in constraints.limits])
    least = np.array([limit.least for limit in constraints.limits])
    now, after, behind, inside, block = 0.0, 0.0, 0.0, 0, 500
    scale = 2 * largest.max() / np.abs(p.C[of_all] + all_x).max(axis=0)
    while inside < states:
        limit = rng.uniform(least, largest, (block, 3)) * (1 - constraints.reserve)
        xi = rng.uniform(-1, 1, (block, len(p.A))) * scale * rng.uniform(0, 1, (block, 1))
        rest = rng.uniform(-1, 1, (block, 3)) * limit * (1 - constraints.stationary_reserve)
        # u_0 = rest + C xi; drawn back to the border of the reduced set, or less far
        values = np.concatenate([rest + xi @ p.C.T, (rest + xi @ p.C.T)[:, of_kept] + xi @ kept_x.T], axis=1)
        bounds = np.concatenate([limit, limit[:, of_kept]], axis=1) * tight
        factor = np.minimum(1.0, (bounds / np.abs(values)).min(axis=1)) * rng.choice([1.0, 0.7], block)
        xi, rest = xi * factor[:, None], rest * factor[:, None]
        following = xi @ p.A.T
        for state, kind in ((xi, "now"), (following, "after")):
            u = rest + state @ p.C.T
            share = (np.abs(u[:, of_all] + state @ all_x.T) / limit[:, of_all]).max()
            share = max(share, (np.abs(u) / limit).max())
            now, after = (max(now, share), after) if kind == "now" else (now, max(after, share))
        u = rest + following @ p.C.T
        kept = (np.abs(u[:, of_kept] + following @ kept_x.T) / limit[:, of_kept]).max()
        behind = max(behind, kept, (np.abs(u) / limit).max())
        inside += block
    return now, after, behind


def worst_difference(full: EmittedGovernor, states: int) -> tuple[float, np.ndarray]:
    """Return how far the emitted solver and HiGHS are apart on random states, all rows, and how many of each status.

    The difference is that of the objective, as a share of the weights, or by how much a limit is missed, as a share.
    """
    p, rng = full.constraints.prediction, np.random.default_rng(3)
    machine = np.repeat(np.arange(3), full.constraints.counts)
    largest = np.array([limit.largest for limit in full.constraints.limits]) * 0.95
    scale = largest.max() / np.abs(p.C[machine] + full.rows_x).max(axis=0)
    worst, counts = 0.0, np.zeros(4, dtype=int)
    for _ in range(states):
        before = rng.uniform(-1, 1, 3) * [800, 200, 200]
        wanted = before + rng.normal(size=3) * [300, 30, 30] * 10 ** rng.uniform(-2, 0.5)
        x = p.steady @ before + rng.normal(size=len(p.A)) * scale * 10 ** rng.uniform(-3, -0.5)
        limit = largest * rng.uniform(0.3, 1.0, 3)
        free = p.C @ x + p.D @ before + rng.normal(size=3) * [0, 50, 50]
        problem = Problem(wanted, before, free, limit, x - p.steady @ wanted)
        answer = full(problem)
        counts[answer.status] += 1
        if answer.status == 3:
            continue
        change = wanted - before
        v = free + p.D @ change
        values = np.concatenate([v, v[machine] + full.rows_x @ problem.deviation])
        A = np.concatenate([p.D * change, (p.D[machine] + full.rows_r) * change])
        at_rest = values - A.sum(axis=1)
        bound = np.concatenate([limit, limit[machine]])
        if answer.status == 2:
            wider = limit + answer.slack
            bound = np.concatenate([wider, wider[machine]]) * (1 + MARGIN)
        best = _highs(A, at_rest, bound)
        h = shares(problem, answer.shaped)
        if h.min() < 0 or h.max() > 1:
            raise ValueError(f"h outside [0, 1]: {h}")
        # in shares of the weights; the answer must keep the rows as well as HiGHS does
        gap = abs(WEIGHT @ h - WEIGHT @ best) / WEIGHT.sum()
        lacking = max(0.0, float((np.abs(at_rest + A @ h) - bound).max())) / largest.max()
        worst = max(worst, gap, lacking)
    return worst, counts


def _highs(A: np.ndarray, at_rest: np.ndarray, bound: np.ndarray) -> np.ndarray:
    """Return the h that HiGHS finds; rows that it violates are given to it until there are none."""
    h, rows = np.ones(A.shape[1]), np.zeros(0, dtype=int)
    while True:
        beyond = np.abs(at_rest + A @ h) - bound
        worst = np.argsort(-beyond)[:10]
        new = np.setdiff1d(worst[beyond[worst] > 1e-11 * bound[worst]], rows)
        if not len(new):
            return h
        rows = np.append(rows, new)
        size = np.abs(A[rows]).max(axis=1, keepdims=True)
        upper, lower = ((bound - at_rest)[rows] / size[:, 0], (bound + at_rest)[rows] / size[:, 0])
        found = scipy.optimize.linprog(
            -WEIGHT, A_ub=np.vstack([A[rows] / size, -A[rows] / size]), b_ub=np.concatenate([upper, lower]),
            bounds=(0, 1), method="highs",
            options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10, "presolve": False},
        )  # fmt: skip
        if found.status != 0:
            raise ValueError(f"HiGHS: {found.message}")
        h = found.x

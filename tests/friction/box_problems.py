"""The friction solver of the emitted C with ``box_problems.c``: compiled, and as functions of Python."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from ptgen.emit.block_files import common_context
from ptgen.emit.c_expressions import Precision
from ptgen.emit.friction_source import friction_context
from ptgen.emit.templates import render
from ptgen.simulate.compiler import compile_library

__all__ = ["CHECKS", "KINDS", "BoxLibrary", "BoxProblem", "Report", "box_library", "write_sources"]

KINDS = ("regular", "conditioned", "lopsided", "near", "gears", "degenerate", "unflagged", "flagged")
"""Kinds of problems, in the order of ``enum kind``."""

CHECKS = ("passed", "solved", "in bounds", "balanced", "exact", "velocities", "torques", "least norm")
"""What a solution may fail, in the order of ``enum check``."""

_MAX_ORDER = 32


class Report(ctypes.Structure):
    """Worst of many solutions, see ``report`` in the C."""

    _fields_ = (
        *((name, ctypes.c_int64) for name in ("problems", "failures", "first_failure", "first_check", "fallbacks")),
        ("worst_work", ctypes.c_int64),
        *((f"{name}", ctypes.c_double) for name in ("work", "worst_residual", "worst_velocity")),
        *((f"{name}", ctypes.c_double) for name in ("worst_torque", "worst_norm")),
    )


@dataclass(frozen=True)
class BoxProblem:
    """One random problem."""

    K: np.ndarray
    w: np.ndarray
    lo: np.ndarray
    hi: np.ndarray
    guess: np.ndarray
    deficient: bool


def write_sources(folder: Path, n: int, contacts: int = 1, precision: Precision = "double") -> None:
    """Write support and friction code for `n` elements into `folder`, with the prefix ``box``."""
    context = {
        **common_context("box", "", "", precision),
        "max_order": _MAX_ORDER,
        **friction_context(elements=n, contacts=contacts),
    }
    for part in ("support", "friction"):
        for end in ("h", "c"):
            text = render(f"{part}.{end}.jinja", **context)
            (folder / f"box_{part}.{end}").write_text(text)


@cache
def box_library(n: int, contacts: int = 1) -> BoxLibrary:
    """Return the compiled library for `n` elements and for `contacts` shafts with backlash; made once."""
    return BoxLibrary(n, contacts)


class BoxLibrary:
    """The emitted solver for `n` elements."""

    def __init__(self, n: int, contacts: int) -> None:
        self.n, self.stride, self.contacts = n, (n + 3) // 4 * 4, contacts
        self.general = n > 2
        folder = Path(mkdtemp(prefix="box"))
        write_sources(folder, n, contacts)
        harness = folder / "box_problems.c"
        text = Path(__file__).with_suffix(".c").read_text()
        harness.write_text(f"#define BOX_GENERAL {int(self.general)}\n{text}")
        compile_library([harness, folder / "box_support.c"], folder / "box.so")
        self._c = ctypes.CDLL(str(folder / "box.so"))
        numbers = [("K", n * self.stride), *((name, n) for name in ("w", "lo", "hi", "guess")), ("null", n * n)]
        fields = [(name, ctypes.c_double * size) for name, size in numbers]
        fields += [(name, ctypes.c_int32) for name in ("nullity", "deficient", "dependent")]
        self._problem = type("problem", (ctypes.Structure,), {"_fields_": fields})

    def run(self, kind: str, count: int, first: int = 0, enumerated: bool = True) -> Report:
        """Solve `count` problems of a kind and check the solutions."""
        report = Report()
        long = ctypes.c_int64
        self._c.run(KINDS.index(kind), long(first), long(count), int(enumerated), ctypes.byref(report))
        return report

    def make(self, kind: str, number: int) -> BoxProblem:
        """Return a problem that `run` solves."""
        made = self._problem()
        self._c.make(KINDS.index(kind), ctypes.c_int64(number), ctypes.byref(made))
        K = np.array(made.K).reshape(self.n, self.stride)[:, : self.n].T
        rows = (np.array(getattr(made, name)) for name in ("w", "lo", "hi", "guess"))
        return BoxProblem(K, *rows, deficient=bool(made.deficient))

    def solve(self, problem: BoxProblem) -> tuple[np.ndarray, np.ndarray, int]:
        """Return torques, velocities and status."""
        T, w_plus = problem.guess.copy(), np.zeros(self.n)
        arrays = [self._padded(problem.K), problem.w, problem.lo, problem.hi, T, w_plus]
        status = self._c.box_solve_box(int(problem.deficient), *map(_pointer, arrays))
        return T, w_plus, status

    def friction_step(
        self,
        K: np.ndarray,
        w: np.ndarray,
        w_free: np.ndarray,
        slide: np.ndarray,
        rest: np.ndarray,
        guess: np.ndarray,
        deficient: bool,
        bits: int,
        rest_before: np.ndarray | None = None,
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, float]:
        """Return mean torques, torques and velocities at the end, and status of one step."""
        torque, mean, w_plus, status = guess.copy(), np.zeros(self.n), np.zeros(self.n), np.zeros(1)
        before = np.zeros(self.n) if rest_before is None else rest_before.copy()
        arrays = [self._padded(K), w, w_free, slide, rest, torque, before, mean, w_plus, status]
        self._c.box_friction_step(int(deficient), bits, *map(_pointer, arrays))
        assert np.array_equal(before, rest, equal_nan=True)
        return mean, torque, w_plus, float(status[0])

    def backlash_step(self, kappa: np.ndarray, *rows: np.ndarray) -> np.ndarray:
        """Return the torques of shafts with backlash over one step."""
        T = np.zeros(self.contacts)
        self._c.box_backlash_step(*map(_pointer, [self._padded(kappa), *rows, T]))
        return T

    def _padded(self, M: np.ndarray) -> np.ndarray:
        """Return the matrix as it is stored in C."""
        n = len(M)
        stored = np.zeros((n, (n + 3) // 4 * 4))
        stored[:, :n] = M.T
        return stored


def _pointer(array: np.ndarray) -> ctypes.c_void_p:
    assert array.dtype == np.float64 and array.flags.c_contiguous
    return ctypes.c_void_p(array.ctypes.data)

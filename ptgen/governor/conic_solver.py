r"""Solvers by name, through CasADi: a conic program of fixed size that is solved many times with changing numbers.

Nothing that a solver says about its own answer is relied upon; see `ptgen.governor.checks`.
"""

from __future__ import annotations

import contextlib
import io
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from ptgen.errors import ControlError, Problem, nearest
from ptgen.governor.checks import Convex

__all__ = ["QUIET", "ConicSolver", "present_solvers", "require_solver"]

Array = NDArray[np.float64]

QUIET: Mapping[str, Mapping[str, Any]] = {
    "highs": {
        "highs": {
            "output_flag": False,
            "presolve": "off",  # a third of the time, and these programs are small
            "primal_feasibility_tolerance": 1e-10,
            "dual_feasibility_tolerance": 1e-10,
            "qp_regularization_value": 0.0,
            "qp_iteration_limit": 1000,  # it can cycle
            "time_limit": 10.0,
        }
    },
    "qrqp": {"print_iter": False, "print_header": False, "print_info": False},
    "ipqp": {"print_iter": False, "print_header": False, "print_info": False},
    "osqp": {"osqp": {"verbose": False, "eps_abs": 1e-9, "eps_rel": 1e-9, "max_iter": 20000, "polish": True}},
    "proxqp": {"proxqp": {"eps_abs": 1e-11}},
    "qpoases": {"printLevel": "none"},
    "cbc": {"cbc": {"loglevel": 0}},
}
"""Options with which known solvers are silent and exact; others run as they come."""


@cache
def present_solvers() -> tuple[str, ...]:
    """Return the names of all conic solvers that this CasADi can load."""
    listed = (entry.partition("::") for entry in ca.CasadiMeta.plugins().split(";"))
    with contextlib.redirect_stderr(io.StringIO()):  # it warns about commercial ones that are not installed
        return tuple(sorted(name for kind, _, name in listed if kind == "Conic" and ca.has_conic(name)))


@cache
def _missing(name: str) -> bool:
    with contextlib.redirect_stderr(io.StringIO()):
        return not ca.has_conic(name)


def _rival() -> str:
    """Return the library of HiGHS that highspy has brought into this process, if it has one of its own.

    It has the name of CasADi's, and would be taken for it; with another version that is a crash.
    """
    module = sys.modules.get("highspy")
    file = getattr(module, "__file__", None)
    found = sorted(Path(file).parent.glob("*libhighs*")) if file else []
    return str(found[0]) if found else ""


def require_solver(name: str) -> None:
    """Raise an error that lists those present unless the solver `name` is, and can be loaded.

    Raises
    ------
    ControlError
    """
    if name == "highs" and (rival := _rival()):
        raise ControlError(
            Problem(
                "solver",
                f'"highs" of CasADi cannot be loaded beside another HiGHS, {rival}',
                "use highspy in a process of its own, or take another solver",
            )
        )
    if _missing(name):
        known = ", ".join(present_solvers())
        raise ControlError(
            Problem(
                "solver",
                f'CasADi has no conic solver "{name}"; present are {known}',
                f'{nearest(name, present_solvers())}; without a wish take "highs"',
            )
        )


class ConicSolver:
    """A convex program of fixed size, built once; numbers are passed without copies of CasADi's own.

    Parameters
    ----------
    name : str
        A solver, see `present_solvers`.
    variables, rows : int
    quadratic : bool
        Whether the cost has a quadratic part; not every solver can.
    options : mapping, optional
        Options of CasADi's interface of that solver, in place of those of `QUIET`.

    Raises
    ------
    ControlError
        If the solver is missing, refuses such programs or these options.
    """

    def __init__(
        self, name: str, variables: int, rows: int, quadratic: bool, options: Mapping[str, Any] | None = None
    ) -> None:
        require_solver(name)
        n, self.rows, self.quadratic = variables, rows, quadratic
        shape = ca.Sparsity.dense(n, n) if quadratic else ca.Sparsity(n, n)
        chosen = {"error_on_fail": False, **(QUIET.get(name, {}) if options is None else options)}
        try:
            self._function = ca.conic("governor", name, {"h": shape, "a": ca.Sparsity.dense(rows, n)}, chosen)
        except RuntimeError as error:
            reason = str(error).strip().splitlines()[-1]
            kind = "quadratic" if quadratic else "linear"
            raise ControlError(
                Problem(
                    "solver",
                    f'"{name}" refuses a {kind} program: {reason}',
                    'take another one, such as "highs", or other options',
                )
            ) from error
        self._P, self._A = np.zeros((n, n), order="F"), np.zeros((rows, n), order="F")
        self._given = {
            "g": np.zeros(n),
            "a": self._A.ravel(order="K"),
            "lba": np.zeros(rows),
            "uba": np.zeros(rows),
            "lbx": np.zeros(n),
            "ubx": np.zeros(n),
            "x0": np.zeros(n),
            "lam_x0": np.zeros(n),
            "lam_a0": np.zeros(rows),
        }
        if quadratic:
            self._given["h"] = self._P.ravel(order="K")
        self._found = {"x": np.zeros(n), "lam_a": np.zeros(rows)}
        self._buffer: Any
        self._buffer, self._solve = self._function.buffer()
        for key, value in self._given.items():
            self._buffer.set_arg(self._function.index_in(key), value.data)
        for key, value in self._found.items():
            self._buffer.set_res(self._function.index_out(key), value.data)

    def solve(self, program: Convex) -> tuple[Array, Array]:
        """Return variables and multipliers of the rows, as the solver gives them; not a number if it gives none.

        A program with fewer rows is filled up with rows that bind nothing.
        """
        count = len(program.A)
        self._A[:count], self._A[count:] = program.A, 0.0
        given = self._given
        if self.quadratic:
            self._P[:] = program.P
        given["g"][:], given["lbx"][:], given["ubx"][:] = program.q, program.lo, program.hi
        given["lba"][:count], given["lba"][count:] = program.lower, -1.0
        given["uba"][:count], given["uba"][count:] = program.upper, 1.0
        for result in self._found.values():
            result.fill(np.nan)
        try:
            self._solve()
        except RuntimeError:
            return np.full(len(program.q), np.nan), np.zeros(count)
        return self._found["x"].copy(), self._found["lam_a"][:count].copy()

    def last_words(self) -> str:
        """Return what the solver itself says about the numbers it was given last."""
        arguments = {key: ca.DM(self._function.sparsity_in(key), value.copy()) for key, value in self._given.items()}
        try:
            self._function(**arguments)
            said = self._function.stats()
        except RuntimeError as error:
            return str(error).strip().splitlines()[-1]
        return f"{said.get('return_status', 'no status')}, success {said.get('success', 'not told')}"

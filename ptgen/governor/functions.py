r"""Prediction, rows and linear program of the governor as CasADi functions, to take elsewhere.

`predict`
    One step of the closed loop (7.27), (7.29): ``state``, ``references``, ``offset`` (N m, what sensors show beyond the
    states) to ``state_next`` and ``torques``.
`residual`
    The rows (7.33) for any shaped references: ``torques`` predicted, and ``residual``, by how much each is outside its
    limits (N m); it is negative inside.
`program`
    The data of (7.36): minimise ``cost' h`` with ``lower <= A h <= upper`` and ``0 <= h <= 1``. The rows of ties stand
    last: ``h_i - h_j`` is zero when references i and j are tied, and anything otherwise.

Matrices are rounded, see `ptgen.governor.digits`. Arguments are those of `ptgen.governor.limit_rows.Situation`; names
and units of states and references are those of `ptgen.governor.prediction.Prediction`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import casadi as ca

from ptgen.block.function_files import function_files
from ptgen.governor.digits import rounded, significant
from ptgen.governor.limit_rows import LimitRows
from ptgen.governor.prediction import Prediction

__all__ = ["governor_files", "predict_function", "program_function", "residual_function"]

_KNOWN = ("wanted", "before", "free", "gain", "least", "most", "deviation")


def predict_function(prediction: Prediction) -> ca.Function:
    """Return one step of the closed loop; see the module."""
    n, m = prediction.B.shape
    x, r, d = ca.MX.sym("state", n), ca.MX.sym("references", m), ca.MX.sym("offset", m)
    given = (prediction.A, prediction.B, prediction.C, prediction.D)
    A, B, C, D = (ca.DM(significant(matrix, 10)) for matrix in given)
    return ca.Function(
        "governor_predict",
        [x, r, d],
        [A @ x + B @ r, C @ x + D @ r + d],
        ["state", "references", "offset"],
        ["state_next", "torques"],
    )


def residual_function(rows: LimitRows) -> ca.Function:
    """Return the rows for any shaped references; see the module."""
    known, at_before, slope = _rows(rows)
    shaped = ca.MX.sym("shaped", rows.machines)
    torques = at_before + slope @ (shaped - known["before"])
    machine = rows.machine.tolist()
    residual = ca.fmax(torques - known["most"][machine], known["least"][machine] - torques)
    return ca.Function(
        "governor_residual",
        [*known.values(), shaped],
        [torques, residual],
        [*known, "shaped"],
        ["torques", "residual"],
    )


def program_function(rows: LimitRows, group: Sequence[int] | None = None) -> ca.Function:
    """Return the data of the linear program; see the module.

    Parameters
    ----------
    rows : LimitRows
    group : sequence of int (m,), optional
        References with the same positive number may be tied; none by default.
    """
    m = rows.machines
    known, at_before, slope = _rows(rows)
    weight, tie = ca.MX.sym("weight", m), ca.MX.sym("tie")
    machine = rows.machine.tolist()
    move = (known["wanted"] - known["before"]).T
    A = [slope * ca.repmat(move, len(machine), 1)]
    lower, upper = [known["least"][machine] - at_before], [known["most"][machine] - at_before]
    for i, j in combinations(range(m), 2):
        if group is None or not group[i] == group[j] > 0:
            continue
        row = ca.DM(1, m)
        row[0, i], row[0, j] = 1, -1
        near = [ca.fabs(known[name][i] - known[name][j]) < tie for name in ("wanted", "before")]
        room = 1 - near[0] * near[1]
        A.append(ca.MX(ca.densify(row)))
        lower.append(-room)
        upper.append(room)
    return ca.Function(
        "governor_program",
        [*known.values(), weight, tie],
        [ca.vertcat(*A), ca.vertcat(*lower), ca.vertcat(*upper), -weight],
        [*known, "weight", "tie"],
        ["A", "lower", "upper", "cost"],
    )


def governor_files(
    prediction: Prediction, rows: LimitRows, prefix: str, group: Sequence[int] | None = None
) -> dict[str, bytes]:
    """Return the functions as ``.casadi`` files and as C, by file name: ``<prefix>_governor_*``.

    `ptgen.files` writes them.
    """
    functions = [predict_function(prediction), residual_function(rows), program_function(rows, group)]
    return function_files(functions, prefix, "governor")


def _rows(rows: LimitRows) -> tuple[dict[str, ca.MX], ca.MX, ca.MX]:
    """Return the arguments, the torques with the references of the last step, and how they change with them."""
    m, n = rows.machines, rows.x.shape[1]
    sizes = {"gain": (m, m), "deviation": (n, 1)}
    known = {name: ca.MX.sym(name, *sizes.get(name, (m, 1))) for name in _KNOWN}
    machine = rows.machine.tolist()
    rows_x, rows_r = ca.DM(rounded(rows.x)), ca.DM(rounded(rows.r))
    moved = rows_r @ (known["wanted"] - known["before"])
    slope = known["gain"][machine, :] + rows_r
    return known, known["free"][machine] + rows_x @ known["deviation"] - moved, slope

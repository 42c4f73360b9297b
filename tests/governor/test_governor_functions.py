"""The saved functions are the governor's prediction, rows and program; so is the C that CasADi makes of them."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest
from decoupled_bed import limit_rows, random_situation
from scipy.optimize import linprog

from ptgen.files import write_files
from ptgen.governor.digits import rounded
from ptgen.governor.functions import governor_files, predict_function, program_function, residual_function
from ptgen.governor.limit_rows import LimitRows
from ptgen.governor.prediction import predict_loop
from ptgen.governor.programs import Status, VectorGovernor
from ptgen.simulate.compiler import compile_library

KNOWN = ("wanted", "before", "free", "gain", "least", "most", "deviation")
WEIGHT = np.array([1.0, 100.0, 100.0])


@pytest.fixture(scope="module")
def prediction(projects):
    project = projects["differential"]
    return predict_loop(project.design, project.testbed)


def rows_of(prediction, steps=(1, 5, 25, 125)) -> LimitRows:
    n, m = prediction.B.shape
    x = np.vstack(
        [prediction.C[i] @ (np.linalg.matrix_power(prediction.A, k) - np.eye(n)) for i in range(m) for k in steps]
    )
    machine, step = np.repeat(np.arange(m), len(steps)), np.tile(steps, m)
    return LimitRows(
        np.concatenate([np.arange(m), machine]),
        np.concatenate([np.zeros(m, dtype=int), step]),
        np.vstack([np.zeros((m, n)), x]),
        np.vstack([np.zeros((m, m)), -x @ prediction.steady]),
    )


def arguments(now) -> dict[str, np.ndarray]:
    return {name: getattr(now, name) for name in KNOWN}


def numbers(result) -> dict[str, np.ndarray]:
    return {name: np.array(value).squeeze() for name, value in result.items()}


def test_names(prediction):
    rows = limit_rows(every=500)
    predict, residual, program = predict_function(prediction), residual_function(rows), program_function(rows)
    assert (predict.name_in(), predict.name_out()) == (["state", "references", "offset"], ["state_next", "torques"])
    assert (residual.name_in(), residual.name_out()) == ([*KNOWN, "shaped"], ["torques", "residual"])
    assert (program.name_in(), program.name_out()) == ([*KNOWN, "weight", "tie"], ["A", "lower", "upper", "cost"])


def as_saved(rows: LimitRows) -> LimitRows:
    """Return rows with the digits that saved functions have."""
    return replace(rows, x=rounded(rows.x), r=rounded(rows.r))


def test_rows_are_what_the_prediction_gives(prediction):
    """Step by step with held references, as (7.6) says without."""
    rows, predict = rows_of(prediction), predict_function(prediction)
    residual = residual_function(rows)
    rng = np.random.default_rng(2)
    n, m = prediction.B.shape
    before, wanted, shaped = (rng.normal(size=m) * 10 for _ in range(3))
    x, offset = prediction.steady @ before + rng.normal(size=n) * 0.01, rng.normal(size=m) * 5
    now = replace(
        random_situation(rng),
        wanted=wanted,
        before=before,
        free=prediction.C @ x + prediction.D @ before + offset,
        gain=prediction.D,
        deviation=x - prediction.steady @ wanted,
    )
    found = numbers(residual(**arguments(now), shaped=shaped))
    at_before, slope = rows.at_before(now)
    whole = at_before + slope @ (shaped - before)
    at_before, slope = as_saved(rows).at_before(now)
    assert found["torques"] == pytest.approx(at_before + slope @ (shaped - before), rel=1e-10, abs=1e-9)
    for k in range(126):
        following, torques = (np.array(value).ravel() for value in predict(x, shaped, offset))
        at = rows.step == k
        scale = np.abs(torques).max() + 1.0
        assert whole[at] == pytest.approx(torques[rows.machine[at]], rel=1e-8, abs=1e-8 * scale)
        x = following
    outside = np.maximum(found["torques"] - now.most[rows.machine], now.least[rows.machine] - found["torques"])
    assert found["residual"] == pytest.approx(outside)


def test_program_is_the_one_that_is_solved():
    rows, group = limit_rows(), (0, 1, 1)
    program = program_function(rows, group)
    asked = VectorGovernor(as_saved(rows), weight=WEIGHT, group=group, tie=0.1)
    rng = np.random.default_rng(5)
    compared = tied = 0
    while compared < 12:
        now = random_situation(rng)
        if compared % 2:
            now.wanted[2] = now.wanted[1] + 0.01
            now.before[2] = now.before[1]
        answer = asked.solve(now)
        if answer.status is not Status.LIMITED:
            continue
        data = numbers(program(**arguments(now), weight=WEIGHT, tie=0.1))
        found = linprog(
            data["cost"],
            np.vstack([data["A"], -data["A"]]),
            np.concatenate([data["upper"], -data["lower"]]),
            bounds=[(0, 1)] * 3,
        )
        assert found.x == pytest.approx(answer.h, abs=1e-7)
        compared += 1
        tied += answer.h[1] == answer.h[2]
    assert tied >= 6


@pytest.mark.compile
def test_files_load_and_compile(prediction, tmp_path):
    rows = rows_of(prediction)
    files = governor_files(prediction, rows, "bed", group=(0, 1, 1))
    assert set(files) == {
        "bed_governor_casadi.c",
        *(f"bed_governor_{name}.casadi" for name in ("predict", "residual", "program")),
    }
    assert governor_files(prediction, rows, "bed", group=(0, 1, 1)) == files  # byte by byte
    write_files(tmp_path / "casadi", files)
    library = tmp_path / "governor.so"
    compile_library([tmp_path / "casadi" / "bed_governor_casadi.c"], library)
    rng = np.random.default_rng(3)
    for original in (predict_function(prediction), residual_function(rows), program_function(rows, (0, 1, 1))):
        loaded = ca.Function.load(str(tmp_path / "casadi" / f"bed_{original.name()}.casadi"))
        compiled = ca.external(original.name(), str(library))
        assert original.name_in() == loaded.name_in() == compiled.name_in()
        assert original.name_out() == loaded.name_out() == compiled.name_out()
        for _ in range(20):
            given = [rng.normal(size=original.size_in(k)) for k in range(original.n_in())]
            for a, b, c in zip(*(f.call(given) for f in (original, loaded, compiled)), strict=True):
                assert np.array_equal(np.array(a), np.array(b))
                assert np.array(c) == pytest.approx(np.array(a), rel=1e-12, abs=1e-12)

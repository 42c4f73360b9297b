"""Solvers by name: those that can agree, those that cannot are refused, and what they say is not believed."""

from __future__ import annotations

import sys
from types import ModuleType

import numpy as np
import pytest
from decoupled_bed import limit_rows, random_situation

from ptgen.errors import ControlError
from ptgen.governor.conic_solver import ConicSolver, present_solvers
from ptgen.governor.limit_rows import LimitRows
from ptgen.governor.programs import CommandGovernor, QuadraticGovernor, ScalarGovernor, Status, VectorGovernor

TRIED = ("clp", "daqp", "ipqp", "osqp", "proxqp", "qrqp")
COST = np.diag([1.0, 600.0, 600.0])
MAY_BE_REFUSED = {(True, "clp"), (False, "daqp"), (False, "proxqp"), (False, "qrqp")}


def build(kind, solver, **more):
    return kind(limit_rows(every=250), weight=(1.0, 100.0, 100.0), cost=COST, solver=solver, **more)


def build_or_none(kind, solver):
    try:
        return build(kind, solver)
    except ControlError:
        return None


def situations(count=120):
    rng = np.random.default_rng(21)
    return [random_situation(rng) for _ in range(count)]


def test_highs_is_there():
    assert "highs" in present_solvers()


def test_a_missing_solver_is_named_with_those_present():
    with pytest.raises(ControlError) as caught:
        VectorGovernor(LimitRows.present(2), solver="higs")
    text = str(caught.value)
    assert '"higs"' in text and 'did you mean "highs"?' in text
    assert all(name in text for name in present_solvers())


@pytest.mark.parametrize("solver", [name for name in TRIED if name in present_solvers()])
@pytest.mark.parametrize("kind", [ScalarGovernor, VectorGovernor, QuadraticGovernor, CommandGovernor])
def test_solvers_agree_where_they_can(kind, solver, capfd):
    """A solver is refused, or its proven answers are as good as those of HiGHS, to the tolerance."""
    asked = build_or_none(kind, solver)
    if asked is None:
        assert (kind.quadratic, solver) in MAY_BE_REFUSED
        return
    other = build(kind, "highs")
    proven = shaped = 0
    for now in situations():
        a, b = asked.solve(now), other.solve(now).accepted()
        shaped += b.status is not Status.FREE
        if a.status is Status.UNSOLVED:
            assert a.message
            assert np.array_equal(a.references, now.before)
            continue
        assert a.status == b.status
        proven += a.status is not Status.FREE
        if kind.quadratic:
            costs = [(now.wanted - r) @ COST @ (now.wanted - r) for r in (a.references, b.references)]
            scale = (now.wanted - now.before) @ COST @ (now.wanted - now.before) + costs[1]
        else:
            weight = np.array([1.0, 100.0, 100.0]) if kind is VectorGovernor else np.ones(3)
            costs, scale = [-weight @ h for h in (a.h, b.h)], weight.sum()
        assert abs(costs[0] - costs[1]) <= 5e-6 * scale
    capfd.readouterr()
    assert shaped > 20
    assert proven >= 0.5 * shaped


def test_linear_programs_of_a_quadratic_solver():
    """daqp fails on them; with a regularisation, which is asked for, it does not."""
    if "daqp" not in present_solvers():
        pytest.skip("daqp is not there")
    with pytest.raises(ControlError, match=r'"daqp" fails on a linear program .*; take highs, or a regularisation'):
        build(VectorGovernor, "daqp")
    asked, other = build(VectorGovernor, "daqp", regularisation=1e-6), build(VectorGovernor, "highs")
    for now in situations(60):
        a, b = asked.solve(now).accepted(), other.solve(now)
        assert a.h == pytest.approx(b.h, abs=1e-5)


@pytest.mark.parametrize(("kind", "solver"), [(QuadraticGovernor, "clp"), (VectorGovernor, "daqp")])
def test_the_wrong_kind_of_program_is_refused(kind, solver):
    if solver not in present_solvers():
        pytest.skip(f"{solver} is not there")
    with pytest.raises(ControlError, match=f'"{solver}" (fails on|refuses) a'):
        build(kind, solver)


def test_options_are_passed_on():
    with pytest.raises(ControlError, match='"highs" refuses'):
        build(VectorGovernor, "highs", options={"no_such_option": 1})


def test_another_highs_in_the_process_is_an_error_and_no_crash(tmp_path, monkeypatch):
    """Libraries of the same name: the first one would serve both."""
    (tmp_path / "libhighs.so.1").write_bytes(b"")
    rival = ModuleType("highspy")
    rival.__file__ = str(tmp_path / "__init__.py")
    monkeypatch.setitem(sys.modules, "highspy", rival)
    with pytest.raises(ControlError, match="beside another HiGHS"):
        ConicSolver("highs", 2, 2, quadratic=False)


class Fake:
    """Returns wrong answers and swears that they are right."""

    def __init__(self, wrong):
        self.wrong, self.asked = wrong, 0

    def __call__(self, solver, program):
        self.asked += 1
        return self.wrong(program)

    @staticmethod
    def last_words(solver):
        return "Optimal, success True"


WRONG = {
    "beyond a limit": lambda p: (p.hi.copy(), np.zeros(len(p.A))),
    "beyond a bound": lambda p: (p.hi + 1.0, np.zeros(len(p.A))),
    "not the best": lambda p: (p.lo.copy(), np.zeros(len(p.A))),
    "not the best, false multipliers": lambda p: (p.lo.copy(), np.full(len(p.A), 3.0)),
    "not a number": lambda p: (np.full(len(p.q), np.nan), np.zeros(len(p.A))),
    "infinite": lambda p: (np.full(len(p.q), np.inf), np.zeros(len(p.A))),
}


@pytest.mark.parametrize("wrong", WRONG.values(), ids=WRONG)
@pytest.mark.parametrize("kind", [ScalarGovernor, VectorGovernor, QuadraticGovernor])
def test_wrong_answers_are_seen(kind, wrong, monkeypatch):
    asked, honest = build(kind, "highs"), build(kind, "highs")
    cases = [now for now in situations() if honest.solve(now).status is Status.LIMITED]
    # Some situations allow no progress, and then the lower bound is right.
    cases = [now for now in cases if honest.solve(now).h.max() > 0.01 and np.linalg.norm(now.wanted - now.before) > 1]
    assert len(cases) > 5
    fake = Fake(wrong)
    monkeypatch.setattr(ConicSolver, "solve", lambda self, program: fake(self, program))
    monkeypatch.setattr(ConicSolver, "last_words", Fake.last_words)
    for now in cases:
        answer = asked.solve(now)
        assert answer.status is Status.UNSOLVED
        assert np.array_equal(answer.references, now.before)
        assert answer.message
        with pytest.raises(ControlError, match="no answer could be proven"):
            answer.accepted()
    assert fake.asked >= len(cases)


def test_a_right_answer_without_multipliers_is_proven(monkeypatch):
    solve = ConicSolver.solve

    def silent(self, program):
        y, multipliers = solve(self, program)
        return y, np.full_like(multipliers, np.nan)

    monkeypatch.setattr(ConicSolver, "solve", silent)
    for kind in (VectorGovernor, QuadraticGovernor, CommandGovernor):
        asked = build(kind, "highs")
        answers = [asked.solve(now) for now in situations(60)]
        assert {Status.LIMITED} <= {answer.status for answer in answers}
        assert all(answer.accepted() is answer for answer in answers)

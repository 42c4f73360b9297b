"""The programs of the governors: closed forms, what they promise, and the emitted governor's dual simplex."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from decoupled_bed import BED, limit_rows, random_situation, situation

from ptgen.errors import ControlError
from ptgen.governor.limit_rows import LimitRows, Situation
from ptgen.governor.programs import (
    CommandGovernor,
    Governor,
    QuadraticGovernor,
    ScalarGovernor,
    Status,
    VectorGovernor,
    tied,
)
from ptgen.shaping.optimal import MARGIN, optimal_governor

GOVERNORS = [ScalarGovernor, VectorGovernor, QuadraticGovernor, CommandGovernor]
COST = np.diag([1.0, 600.0, 600.0])


def plain(wanted, free, gain, most=10.0) -> Situation:
    """A situation that starts at zero, with symmetric limits and no prediction."""
    wanted, free = np.atleast_1d(wanted).astype(float), np.atleast_1d(free).astype(float)
    m = len(wanted)
    limit = np.broadcast_to(np.asarray(most, dtype=float), m).copy()
    return Situation(wanted, np.zeros(m), free, np.asarray(gain, float).reshape(m, m), -limit, limit, np.zeros(0))


def torques(rows: LimitRows, now: Situation, references) -> np.ndarray:
    """The rows, written out once more from their definition."""
    present = now.free + now.gain @ (references - now.before)
    return present[rows.machine] + rows.x @ now.deviation + rows.r @ (references - now.wanted)


def excess(rows: LimitRows, now: Situation, references, slack=0.0) -> float:
    values, give = torques(rows, now, references), np.broadcast_to(slack, rows.machines)[rows.machine]
    return float(np.maximum(values - now.most[rows.machine] - give, now.least[rows.machine] - give - values).max())


@pytest.mark.parametrize("kind", GOVERNORS)
class TestOneMachine:
    """One machine: 4 N m and 2 N m per unit of the reference, limit 10 N m, so the reference may go to 3."""

    def test_limited(self, kind):
        answer = kind(LimitRows.present(1)).solve(plain(5.0, 4.0, 2.0))
        assert answer.status is Status.LIMITED
        assert answer.references == pytest.approx([3.0], abs=1e-9)
        assert answer.h == pytest.approx([0.6], abs=1e-9)
        assert answer.binding == ((0, 0),)
        assert answer.slack.tolist() == [0.0]
        assert answer.solver == "highs"

    def test_free(self, kind):
        answer = kind(LimitRows.present(1)).solve(plain(3.0, 4.0, 2.0))
        assert answer.status is Status.FREE
        assert answer.references.tolist() == [3.0]  # exactly
        assert answer.h.tolist() == [1.0]
        assert (answer.solver, answer.binding, answer.gap) == ("", (), 0.0)

    def test_other_side(self, kind):
        answer = kind(LimitRows.present(1)).solve(plain(5.0, -4.0, -2.0))
        assert answer.references == pytest.approx([3.0], abs=1e-9)

    def test_towards_a_kept_limit_although_it_is_violated_now(self, kind):
        answer = kind(LimitRows.present(1)).solve(plain(-9.0, 12.0, 2.0))
        assert answer.status is Status.FREE

    def test_nothing_keeps_the_limit(self, kind):
        """12 N m of at most 10 at standstill, and the wanted reference makes it worse."""
        answer = kind(LimitRows.present(1)).solve(plain(5.0, 12.0, 2.0))
        if kind is CommandGovernor:  # it goes back
            assert answer.status is Status.LIMITED
            assert answer.references == pytest.approx([-1.0], abs=1e-9)
            return
        assert answer.status is Status.SLACK
        assert answer.references == pytest.approx([0.0], abs=1e-9)
        assert answer.slack == pytest.approx([2.0])

    def test_nothing_keeps_the_limit_and_slack_has_a_price(self, kind):
        answer = kind(LimitRows.present(1), slack="penalised").solve(plain(5.0, 12.0, 2.0))
        if kind is CommandGovernor:
            assert answer.references == pytest.approx([-1.0], abs=1e-9)
            return
        assert answer.status is Status.SLACK
        assert answer.references == pytest.approx([0.0], abs=1e-9)
        assert answer.slack == pytest.approx([2.0], abs=1e-8)

    def test_a_limit_that_references_do_not_change(self, kind):
        answer = kind(LimitRows.present(1)).solve(plain(5.0, 12.0, 0.0))
        assert answer.status is Status.SLACK
        assert answer.references.tolist() == [5.0]
        assert answer.slack == pytest.approx([2.0])

    def test_nothing_finite_comes_of_what_is_not(self, kind):
        answer = kind(LimitRows.present(1)).solve(plain(5.0, np.nan, 2.0))
        assert answer.status is Status.UNSOLVED
        assert answer.references.tolist() == [0.0]
        with pytest.raises(ControlError, match="not finite"):
            answer.accepted()


class TestPriorities:
    """Two references share a limit: 2 r1 + 1 r2 within 10, both wanted at 10."""

    now = plain([10.0, 10.0], [0.0, 0.0], [[2.0, 1.0], [0.0, 0.1]])
    rows = LimitRows.present(2)

    @pytest.mark.parametrize(("weight", "references"), [((1.0, 100.0), (0.0, 10.0)), ((100.0, 1.0), (5.0, 0.0))])
    def test_weights_decide_who_goes_first(self, weight, references):
        assert VectorGovernor(self.rows, weight=weight).solve(self.now).references == pytest.approx(references)

    def test_scalar_shares_one_way(self):
        answer = ScalarGovernor(self.rows, weight=(1.0, 100.0)).solve(self.now)
        assert answer.h == pytest.approx([1 / 3, 1 / 3])

    @pytest.mark.parametrize("kind", [QuadraticGovernor, CommandGovernor])
    def test_quadratic_is_the_projection(self, kind):
        """min (10-a)^2 + (10-b)^2 with 2a + b = 10: (10, 10) - 20/5 (2, 1) = (2, 6)."""
        assert kind(self.rows).solve(self.now).references == pytest.approx([2.0, 6.0], abs=1e-8)

    def test_cost_matrix_decides(self):
        """min (10-a)^2 + 4 (10-b)^2 with 2a + b = 10: a = 10 - 2 s, b = 10 - s/4, 4.25 s = 20."""
        s = 20 / 4.25
        answer = QuadraticGovernor(self.rows, cost=np.diag([1.0, 4.0])).solve(self.now)
        assert answer.references == pytest.approx([10 - 2 * s, 10 - s / 4], abs=1e-8)

    def test_command_governor_leaves_the_box(self):
        """More of the one makes room for the other: r2 - r1 within 10 with 30 wanted of r2."""
        now = plain([0.0, 30.0], [0.0, 0.0], [[-1.0, 1.0], [0.0, 0.1]])
        assert CommandGovernor(self.rows).solve(now).references == pytest.approx([10.0, 20.0], abs=1e-8)
        assert QuadraticGovernor(self.rows).solve(now).references == pytest.approx([0.0, 10.0], abs=1e-8)


class TestTies:
    """References 2 and 3 act on machines of their own, of which only one has little room left."""

    now = plain([0.0, 10.0, 10.0], [0.0, 6.0, 0.0], np.diag([1.0, 1.0, 1.0]), most=[10.0, 10.0, 100.0])
    rows = LimitRows.present(3)

    def test_untied(self):
        assert VectorGovernor(self.rows).solve(self.now).references == pytest.approx([0.0, 4.0, 10.0])

    @pytest.mark.parametrize("kind", [VectorGovernor, QuadraticGovernor])
    def test_tied_share_their_way(self, kind):
        answer = kind(self.rows, group=(0, 1, 1), tie=0.1).solve(self.now)
        assert answer.h == pytest.approx([1.0, 0.4, 0.4], abs=1e-9)
        assert answer.h[1] == answer.h[2]

    def test_command_keeps_the_difference(self):
        answer = CommandGovernor(self.rows, group=(0, 1, 1), tie=0.1).solve(self.now)
        assert answer.references == pytest.approx([0.0, 4.0, 4.0], abs=1e-8)

    def test_who_is_tied(self):
        apart = replace(self.now, wanted=np.array([0.0, 10.0, 10.2]))
        assert tied(self.now, (0, 1, 1), 0.1) == [[1, 2]]
        assert tied(self.now, (0, 1, 2), 0.1) == tied(self.now, (0, 0, 0), 0.1) == tied(apart, (0, 1, 1), 0.1) == []
        assert tied(replace(self.now, before=np.array([0.0, 0.0, 0.2])), (0, 1, 1), 0.1) == []


@pytest.fixture(scope="module")
def situations() -> list[Situation]:
    rng = np.random.default_rng(7)
    return [random_situation(rng) for _ in range(150)]


def governor(kind: type[Governor], rows: LimitRows, **more) -> Governor:
    return kind(rows, **{"weight": (1.0, 100.0, 100.0), "cost": COST, "group": (0, 1, 1), "tie": 0.1, **more})


@pytest.mark.parametrize("slack", ["widened", "penalised"])
@pytest.mark.parametrize("kind", GOVERNORS)
def test_answers_keep_what_they_promise(kind, slack, situations):
    rows = limit_rows()
    asked = governor(kind, rows, slack=slack)
    answers = [asked.solve(now) for now in situations]
    assert {answer.status for answer in answers} >= {Status.FREE, Status.LIMITED}
    for now, answer in zip(situations, answers, strict=True):
        assert answer.accepted() is answer
        assert excess(rows, now, answer.references, answer.slack) <= 1e-6 * now.most.max()
        assert abs(answer.gap) <= 1e-6
        if kind is not CommandGovernor:
            assert (answer.h >= 0).all() and (answer.h <= 1).all()
            low, high = np.minimum(now.before, now.wanted), np.maximum(now.before, now.wanted)
            assert (answer.references >= low - 1e-9).all() and (answer.references <= high + 1e-9).all()
        if answer.status is Status.FREE:
            assert excess(rows, now, now.wanted) <= 1e-9
        elif answer.status is Status.LIMITED:
            assert not answer.slack.any() and answer.binding
        else:
            assert answer.slack.max() > 0


def test_less_freedom_is_never_better(situations):
    """Scalar within vector within command governor, by the quadratic cost."""
    rows = limit_rows()
    kinds = [governor(kind, rows, group=None) for kind in (CommandGovernor, QuadraticGovernor, ScalarGovernor)]
    compared = 0
    for now in situations:
        answers = [kind.solve(now) for kind in kinds]
        if any(answer.status is Status.SLACK for answer in answers):
            continue
        costs = [(now.wanted - a.references) @ COST @ (now.wanted - a.references) for a in answers]
        assert costs[0] <= costs[1] * (1 + 1e-6) + 1e-9 and costs[1] <= costs[2] * (1 + 1e-6) + 1e-9
        compared += costs[2] > 0
    assert compared > 20


@pytest.mark.parametrize("kind", GOVERNORS)
def test_all_rows_at_once_is_the_same(kind, situations):
    rows = limit_rows(every=500)
    one, other = governor(kind, rows), governor(kind, rows, all_rows=True)
    for now in situations[:60]:
        a, b = one.solve(now), other.solve(now)
        assert a.status == b.status
        assert a.references == pytest.approx(b.references, rel=1e-5, abs=1e-4)


def test_fifteen_thousand_rows():
    """The whole horizon of half a second."""
    rows = limit_rows(every=1)
    assert len(rows.machine) == 15003
    rng = np.random.default_rng(3)
    selected, whole = governor(VectorGovernor, rows), governor(VectorGovernor, rows, all_rows=True)
    seen = 0
    while seen < 3:
        now = random_situation(rng)
        a = selected.solve(now)
        if a.status is Status.LIMITED:
            assert a.h == pytest.approx(whole.solve(now).h, abs=1e-9)
            seen += 1


def test_emitted_governor_agrees(situations):
    """The dual simplex that is emitted, on the same rows; ties, slack and all."""
    rows = limit_rows()
    asked = governor(VectorGovernor, rows)
    counts = np.bincount(rows.machine) - 1
    slack = limited = 0
    rng = np.random.default_rng(11)
    for now in [*situations, *(random_situation(rng, way=2.0) for _ in range(450))]:
        answer = asked.solve(now).accepted()
        shaped, give, _, status = optimal_governor(
            *map(np.asarray, (1.0, now.wanted, now.before, now.free, now.gain, now.least, now.most, now.deviation)),
            rows.x[3:],
            rows.r[3:],
            asked.weight,
            np.asarray(asked.tie),
            np.asarray(asked.group, dtype=float),
            now.before,
            *(int(count) for count in counts),
            40,
        )
        assert int(status) == answer.status
        assert give == pytest.approx(answer.slack, abs=1e-9)
        if answer.status is Status.SLACK:  # which it widens by a trace more
            more = answer.slack + MARGIN * (now.most + answer.slack)
            answer = asked.solve(replace(now, least=now.least - more, most=now.most + more)).accepted()
            slack += 1
        move = np.abs(now.wanted - now.before)
        assert (np.abs(shaped - answer.references) <= 1e-9 * np.maximum(move, 1.0)).all()
        limited += answer.status is Status.LIMITED
    assert slack > 5 and limited > 100


def test_feasible_now_is_feasible_next():
    """On the nominal loop, standing still stays admissible: references are shaped and never get stuck in slack."""
    rows = limit_rows(horizon=2000, every=20)
    asked = governor(VectorGovernor, rows, group=None)
    before = np.zeros(3)
    x = BED.X @ before
    wanted = np.array([300.0, 60.0, -40.0])
    statuses = []
    for _ in range(400):
        now = situation(x, before, wanted)
        answer = asked.solve(now).accepted()
        statuses.append(answer.status)
        # Rows in between those that were kept may be missed by little.
        assert (np.abs(BED.C @ x + BED.D @ answer.references) <= now.most * 1.001).all()
        x, before = BED.A @ x + BED.B @ answer.references, answer.references
    assert Status.LIMITED in statuses
    assert Status.SLACK not in statuses


def test_price_of_slack():
    """A low price lets a limit go that could be kept."""
    now = plain(5.0, 4.0, 2.0)
    kept = VectorGovernor(LimitRows.present(1), slack="penalised").solve(now)
    assert kept.references == pytest.approx([3.0], abs=1e-8) and kept.status is Status.LIMITED
    sold = VectorGovernor(LimitRows.present(1), slack="penalised", penalty=0.1).solve(now)
    assert sold.references == pytest.approx([5.0], abs=1e-8) and sold.status is Status.SLACK
    assert sold.slack == pytest.approx([4.0], abs=1e-8)


def test_all_wrong_values_are_reported_at_once():
    with pytest.raises(ControlError) as caught:
        VectorGovernor(
            LimitRows.present(2), weight=(1.0, 0.0), cost=-np.eye(2), group=(1,), tie=-1.0, penalty=0.0, tolerance=0.0
        )
    assert {problem.where for problem in caught.value.problems} == {
        "weight",
        "cost",
        "group",
        "tie",
        "penalty",
        "tolerance",
    }
    with pytest.raises(ControlError, match='"soft" is unknown'):
        VectorGovernor(LimitRows.present(2), slack="soft")


def test_rows_of_the_wrong_shape_are_refused():
    index = np.arange(2)
    with pytest.raises(ControlError, match="first rows"):
        LimitRows(index, index, np.zeros((2, 1)), np.zeros((2, 2)))
    with pytest.raises(ControlError, match="step"):
        LimitRows(index, np.zeros(3, dtype=int), np.zeros((2, 1)), np.zeros((2, 2)))

"""The optimal governor with removed rows and the emitted solver, against all rows of half a second."""

from __future__ import annotations

import numpy as np
import pytest
from all_rows import EmittedGovernor, NominalLoop, largest_shares, shares, worst_difference

from ptgen.governor.constraint_set import torque_limits
from ptgen.governor.set_cache import cached_constraint_set
from ptgen.testbed.governor_settings import GovernorSettings


@pytest.fixture(scope="module")
def reduced(projects):
    project = projects["differential"]
    settings = GovernorSettings(horizon="0.5 s")
    return cached_constraint_set(project.prediction, torque_limits(project.reduced.full), settings)


@pytest.fixture(scope="module")
def emitted(reduced):
    return EmittedGovernor(reduced), EmittedGovernor(reduced.full())


def test_emitted_solver_agrees_with_highs_on_all_rows(emitted):
    worst, counts = worst_difference(emitted[1], 150)
    assert worst < 1e-9
    assert counts[:3].min() > 10
    assert counts[3] == 0


def test_limits_that_can_be_kept_can_be_kept_in_the_next_step(reduced):
    """States on the border of the reduced set keep all 30012 inequalities, now and one step later."""
    now, after, kept = largest_shares(reduced, 4000)
    assert 0.99 < now <= 1.0
    assert after <= 1.0
    assert kept <= 1.0


def test_runs_at_the_limits_keep_them_and_lose_little(projects, emitted):
    """References stay between the last and the wanted ones; removal costs less than 0.2 % of sum h if steps bind."""
    project, (reduced, full) = projects["differential"], emitted
    settings = reduced.constraints
    loop = NominalLoop(project, 4)
    loop.wanted[:] = [400.0, 250.0, 150.0]
    own = other = 0.0
    limited = 0
    for _ in range(3000):
        problem = loop.problem(settings.reserve, settings.stationary_reserve)
        answers = [governor(problem) for governor in (reduced, full)]
        h = np.array([shares(problem, answer.shaped) for answer in answers])
        low, high = np.minimum(problem.before, problem.wanted), np.maximum(problem.before, problem.wanted)
        assert (low <= answers[0].shaped).all()
        assert (answers[0].shaped <= high).all()
        assert h.min() >= 0
        assert h.max() <= 1
        assert answers[0].iterations <= 40
        own, other = own + h[0].sum(), other + h[1].sum()
        limited += answers[0].status == 1
        u = loop.step(answers[0].shaped)
        assert (abs(u) <= problem.limit / (1 - settings.reserve)).all()
    assert limited > 1000
    assert own > 0.998 * other

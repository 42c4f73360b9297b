"""The emitted plant against the event-driven reference: error, order, number and times of transitions."""

from __future__ import annotations

import numpy as np
import pytest
from friction.emitted_plant import STEP, emitted_run, errors, problem_named, reference_run, steps

# Largest error of any velocity at 100 us (rad/s), and least mean order from there to 12.5 us. Where the motion is
# polynomial between events, as in the chain of two clutches, the straight lines inside a step are exact.
BOUNDS = {
    "scalar": (1e-8, None),
    "clutch": (1e-10, None),
    "two_clutches": (1e-7, None),
    "two_clutches_crossing": (1e-10, None),
    "coupled_clutches": (5e-6, 1.9),
    "differential": (2e-3, 1.9),
    "gear_set": (1e-6, 1.9),
    "overrunning": (5e-6, 1.9),
    "rattling": (2e-2, 1.2),
}

pytestmark = pytest.mark.compile


@pytest.mark.parametrize("name", BOUNDS)
def test_error_and_order(name: str) -> None:
    bound, order = BOUNDS[name]
    found = errors(name, (1, 8) if order else (1,))
    assert found[0] < bound
    if order is not None:
        assert np.log2(found[0] / found[1]) / 3 > order


@pytest.mark.parametrize("name", BOUNDS)
def test_transitions_are_those_of_the_reference_to_one_step(name: str) -> None:
    problem = problem_named(name)
    elements = {friction.name for friction in problem.model.frictions}
    h = problem.duration / steps(name)
    found = emitted_run(name)[1]
    wanted = [item for item in reference_run(name)[1].transitions if item.element in elements]
    assert len(found) == len(wanted)
    for element in elements:
        mine = [item for item in found if item[1] == element]
        theirs = [item for item in wanted if item.element == element]
        assert [item[2:] for item in mine] == [(item.before, item.after) for item in theirs]
        for (time, *_), item in zip(mine, theirs, strict=True):
            # In the step that ends at `time`, or one step beside it; a shaft that rings at 360 Hz asks for more.
            beside = 1.6 if name == "differential" else 1.0
            assert time - (1 + beside) * h < item.time < time + beside * h


def test_the_chain_of_two_clutches_is_far_better_than_what_holding_at_zero_gives() -> None:
    """A scheme that holds what passes zero until the end of a step leaves 9e-4 rad/s, and first order."""
    assert errors("two_clutches", (1,))[0] < 5e-4 / 1000
    assert problem_named("two_clutches").duration / steps("two_clutches") == pytest.approx(STEP, rel=1e-2)

"""Parameters for other wishes are those of a controller that is designed for them."""

from __future__ import annotations

import pytest

from ptgen.analysis.wishes import WISHES, WishedParameters
from ptgen.control.controller import controller_block
from ptgen.project import Project


@pytest.mark.parametrize("conventional", [False, True])
@pytest.mark.parametrize("kind", ["pi", "observer", "super_twisting"])
@pytest.mark.parametrize("bed", ["back_to_back", "differential", "centre_differential", "clutch_rig"])
def test_parameters_are_those_of_a_new_design(
    projects: dict[str, Project], bed: str, kind: str, conventional: bool
) -> None:
    project = projects[bed]
    design, full = project.design.decoupling, project.reduced.full
    tuning = project.testbed.tuning.model_copy(update={"speed_control": kind})
    h = project.testbed.sample_time
    wishes = WishedParameters(design, full, project.reduced.modes_before, tuning, h, conventional)
    asked = {wish: factor * getattr(tuning, wish) for wish, factor in zip(WISHES, (0.3, 1.7, 0.45), strict=True)}
    made = controller_block(design, wishes.gains(**asked), tuning.model_copy(update=asked), full, h)
    expected = {signal.name: signal.value for signal in made.block.parameters}
    expected |= made.conventional if conventional else {}
    assert wishes.at(**asked) == expected
    assert wishes.at() != expected

"""What becomes of the roles in the other state of a friction element (Section 6.3)."""

from __future__ import annotations

from ptgen.control.friction_states import FrictionState, other_friction_states
from ptgen.project import Project
from ptgen.testbed.testbed import ReductionSettings


def states(project: Project, settings: ReductionSettings | None = None) -> dict[str, FrictionState]:
    testbed = project.testbed
    found = other_friction_states(
        project.mechanism,
        settings or testbed.reduction,
        testbed.roles,
        testbed.tuning.structure,
        len(project.reduced.model.twists),
    )
    return {state.element: state for state in found}


def test_slipping_centre_differential_cannot_be_decoupled(projects: dict[str, Project]) -> None:
    state = states(projects["centre_differential_locked"])["diff.limited_slip"]
    assert (state.sticks, state.decouples) == (False, False)
    assert "the torques at flange2 and flange3 hang on 1 twist" in state.text


def test_sticking_axle_leaves_an_integrator(projects: dict[str, Project]) -> None:
    state = states(projects["differential"])["diff.limited_slip"]
    assert (state.sticks, state.decouples) == (True, False)
    assert "wind up" in state.text and "1 torque for 2 twists" in state.text
    assert "eigenvalue 0 1/s" in state.text


def test_every_differential_of_a_larger_bed_is_examined(projects: dict[str, Project]) -> None:
    found = states(projects["all_wheel_drive"])
    assert set(found) == {"centre.limited_slip", "front.limited_slip", "rear.limited_slip"}
    assert not any(state.decouples for state in found.values())


def test_losses_have_no_other_state(projects: dict[str, Project]) -> None:
    assert not [name for project in projects.values() for name in states(project) if name.endswith(".loss")]


def test_closed_clutches_are_another_bed(projects: dict[str, Project]) -> None:
    assert all(state.decouples and state.sticks for state in states(projects["clutch_rig"]).values())


def test_individual_law_for_a_slipping_element_does_not_damp_the_sticking_one(projects: dict[str, Project]) -> None:
    project = projects["centre_differential"]
    testbed = project.testbed
    free = testbed.reduction.model_copy(update={"locked": ()})
    (state,) = other_friction_states(project.mechanism, free, testbed.roles, "individual", 1)
    assert state.sticks and state.decouples
    assert "1 twist more" in state.text and 'locked = ["diff.limited_slip"]' in state.text

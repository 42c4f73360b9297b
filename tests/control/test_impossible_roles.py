"""Roles for which no controller exists are explained, with roles that would work."""

from __future__ import annotations

from dataclasses import replace

import pytest
from control_laws import design
from mechanism.bed_text import Bed, differential_bed, two_machines

from ptgen.control.decoupling import decouple
from ptgen.errors import ControlError
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism
from ptgen.project import Project
from ptgen.testbed import Roles


def light(bed: Bed) -> Bed:
    names = [name for name in bed.components if name.startswith(("flange", "diff"))]
    bed.reduction = {"drop": names}
    return bed


def problem_of(bed: Bed) -> tuple[str, str, str]:
    with pytest.raises(ControlError) as caught:
        design(bed)
    (problem,) = caught.value.problems
    return problem.where, problem.what, problem.remedy


def test_two_torques_on_an_open_differential_get_advice() -> None:
    bed = light(differential_bed())
    bed.torque, bed.speed = {"M1": "diff.input", "M2": "flange2"}, ["M3"]
    where, what, remedy = problem_of(bed)
    assert where == "control"
    assert "decoupling matrix is singular" in what
    assert "2 machines control torques, but the torques at diff.input and flange2 hang on 1 twist" in what
    assert remedy.startswith("roles that would work: torque {")
    roles, *_ = remedy.split("; or ")
    advised = roles.removeprefix("roles that would work: ").split("; ")
    assert 1 <= len(advised) <= 3
    for text in advised:  # they do work
        torques, _, speeds = text.removeprefix("torque { ").partition(" } with speed [")
        pairs = [pair.split(" = ") for pair in torques.split(", ")]
        bed.torque = {machine: place.strip('"') for machine, place in pairs}
        bed.speed = speeds.removesuffix("]").split(", ")
        assert design(bed).relative_degrees == (2, 1, 1)


def locked(bed: Bed) -> tuple[ReducedModel, Roles]:
    testbed = bed.load()
    mechanism = Mechanism.of(testbed).with_locked_frictions({"diff.limited_slip"})
    return reduce_mechanism(mechanism, testbed.reduction), testbed.roles


def test_locked_differential_leaves_an_integrator_between_two_speeds() -> None:
    reduced, roles = locked(light(differential_bed()))
    assert len(reduced.model.twists) == 2
    with pytest.raises(ControlError, match="not asymptotically stable") as caught:
        decouple(reduced, roles)
    (problem,) = caught.value.problems
    assert "1 state stays behind the controlled quantities" in problem.what
    assert "wind up" in problem.what


def test_locked_differential_with_two_torques_works() -> None:
    bed = light(differential_bed())
    bed.torque, bed.speed = {"M1": "diff.input", "M2": "flange2"}, ["M3"]
    decoupling = decouple(*locked(bed))
    assert decoupling.relative_degrees == (2, 2, 1)
    assert decoupling.internal_order == 0


def test_missing_torque_flanges_are_named() -> None:
    bed = light(differential_bed(flanges=("flange1",)))
    with pytest.raises(ControlError, match="no combination of the sensors") as caught:
        design(bed)
    (problem,) = caught.value.problems
    for sensor in ("M1_speed", "M2_speed", "M3_speed", "flange1_torque"):
        assert sensor in problem.what
    assert "torque flange" in problem.remedy or problem.remedy.startswith("roles that would work")


def test_one_missing_flange_is_replaced_by_the_others() -> None:
    """Both output torques follow from the input torque and one of them: nothing is missing."""
    decoupling = design(light(differential_bed(flanges=("flange1", "flange3"))))
    assert decoupling.relative_degrees == (2, 1, 1)


def test_place_with_the_air_gap_torque_in_it() -> None:
    bed = Bed()
    bed.add("gear", "gearbox", ratio=3.0, inertia=0.5)
    bed.add("shaft1", "shaft", stiffness=5e4)
    bed.add("flange2", "torque_flange", inertia=0.01, stiffness=4e5)
    bed = two_machines(["gear", "shaft1", "flange2"], bed, place="gear.input")
    bed.reduction = {"keep": ["gear"]}
    where, what, _ = problem_of(bed)
    assert where == "control.torque.M1"
    assert "contains an air-gap torque directly" in what


def test_place_that_the_bed_does_not_observe_is_an_error(projects: dict[str, Project]) -> None:
    """Places are those of the file; other ones have no signal in the reduced model."""
    reduced = projects["differential"].reduced
    with pytest.raises(ControlError, match=r"diff\.inptu") as caught:
        decouple(reduced, Roles(torque={"M1": "diff.inptu"}, speed=("M2", "M3")))
    assert "diff.input" in caught.value.problems[0].remedy


def test_roles_of_the_same_places_in_another_order_are_the_same_design() -> None:
    bed = light(differential_bed())
    testbed = bed.load()
    reduced = reduce_mechanism(Mechanism.of(testbed), testbed.reduction)
    first = decouple(reduced, testbed.roles)
    second = decouple(reduced, replace(testbed.roles, speed=("M3", "M2")))
    assert first.law_expressions() == second.law_expressions()

"""Beds with clutches, brakes, bearings, freewheels and gaps: their modes, and what the reduction makes of them."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from mechanism.bed_text import Bed, differential_bed

from ptgen.control.design import design_control
from ptgen.errors import ModelError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.modes import Mode, modes
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism

CLUTCH = {"inertia_input": 0.02, "inertia_output": 0.03}


def bed(middle: Mapping[str, tuple[str, Mapping[str, object]]], **reduction: object) -> Bed:
    """Return M1 - flange1 - cardan1 - (the middle) - cardan2 - flange2 - M2."""
    made = Bed()
    made.machine("M1")
    made.add("flange1", "torque_flange", inertia=0.03, stiffness=380e3, damping=0.5)
    made.add("cardan1", "shaft", stiffness=57e3, damping=2.0)
    for name, (kind, fields) in middle.items():
        made.add(name, kind, **fields)
    made.add("cardan2", "shaft", stiffness=45e3, damping=1.0)
    made.add("flange2", "torque_flange", inertia=0.04, stiffness=220e3, damping=0.5)
    made.machine("M2", 5.0)
    made.chains = [" - ".join(["M1", "flange1", "cardan1", *middle, "cardan2", "flange2", "M2"])]
    made.torque, made.speed = {"M1": "cardan1"}, ["M2"]
    made.reduction = reduction
    return made


def clutched(**reduction: object) -> Bed:
    return bed({"clutch1": ("clutch", {"capacity": "300 N m", "static": "360 N m", **CLUTCH})}, **reduction)


def reduced(made: Bed) -> ReducedModel:
    testbed = made.load()
    return reduce_mechanism(Mechanism.of(testbed), testbed.reduction)


def frequencies(found: tuple[Mode, ...]) -> list[float]:
    return [mode.frequency_hz for mode in found]


def rules(result: ReducedModel) -> dict[tuple[str, str], str]:
    return {(rule.rule, rule.element): rule.why for rule in result.rules}


def test_free_clutch_parts_the_bed_and_locked_clutch_is_an_inertia() -> None:
    full = assemble(Mechanism.of(clutched().load()))
    assert frequencies(modes(full)).count(0.0) == 2, "both sides turn freely"
    whole = bed({"disk": ("inertia", {"inertia": 0.05})})
    wanted = frequencies(modes(assemble(Mechanism.of(whole.load()))))
    assert frequencies(modes(full, ["clutch1"])) == pytest.approx(wanted, rel=1e-9)


def test_locked_clutch_reduces_like_an_inertia() -> None:
    result = reduced(clutched(locked=["clutch1"]))
    wanted = reduced(bed({"disk": ("inertia", {"inertia": 0.05})}))
    assert frequencies(result.modes_before) == pytest.approx(frequencies(wanted.modes_before), rel=1e-9)
    assert frequencies(result.modes_after) == pytest.approx(frequencies(wanted.modes_after), rel=1e-9)
    assert result.model.coordinates == wanted.model.coordinates
    assert result.parameters == pytest.approx(wanted.parameters, rel=1e-9)
    why = rules(result)["lock", "clutch1"]
    assert why == "asked for in the file; it sticks up to 360 N m, fully actuated"
    assert not result.model.frictions


def test_modes_before_are_those_of_the_full_model_with_the_element_locked() -> None:
    made = clutched(locked=["clutch1"])
    full = assemble(Mechanism.of(made.load()))
    found, wanted = reduced(made).modes_before, modes(full, ["clutch1"])
    assert frequencies(found) == pytest.approx(frequencies(wanted), rel=1e-9)
    assert [m.damping_ratio for m in found] == pytest.approx([m.damping_ratio for m in wanted], rel=1e-6)


def test_the_full_model_that_was_assembled_already_is_not_taken_for_the_locked_one() -> None:
    made = clutched(locked=["clutch1"]).load()
    mechanism = Mechanism.of(made)
    result = reduce_mechanism(mechanism, made.reduction, assemble(mechanism))
    assert not result.full.frictions
    assert frequencies(result.modes_before).count(0.0) == 1


def test_free_clutch_is_a_disturbance() -> None:
    result = reduced(clutched())
    (friction,) = result.model.frictions
    assert friction.name == "clutch1"
    assert not result.model.viscous[0, 0]
    assert not any(rule.rule == "lock" for rule in result.rules)


def test_locked_limited_slip_ties_the_outputs() -> None:
    made = differential_bed()
    made.reduction = {"locked": ["diff.limited_slip"]}
    result = reduced(made)
    full = assemble(Mechanism.of(made.load()))
    assert frequencies(result.modes_before) == pytest.approx(
        frequencies(modes(full, ["diff.limited_slip"])), rel=1e-7, abs=1e-9
    )
    why = rules(result)["lock", "diff.limited_slip"]
    assert why == "asked for in the file; it sticks up to 20 N m and 15 % of the torque at diff.input"


def test_swelling_element_holds_what_it_holds_at_its_weakest_angle() -> None:
    middle = {"clutch1": ("clutch", {"capacity": "300 N m", **CLUTCH, "ripple": {"amplitude": 0.25, "order": 1}})}
    result = reduced(bed(middle, locked=["clutch1"]))
    assert "up to 225 N m" in rules(result)["lock", "clutch1"]


def test_freewheel_is_locked_in_one_direction() -> None:
    middle = {"wheel": ("freewheel", {**CLUTCH, "drag": "0.5 N m"})}
    result = reduced(bed(middle, locked=["wheel"]))
    assert "while its torque is above -0.5 N m" in rules(result)["lock", "wheel"]
    wanted = reduced(bed({"disk": ("inertia", {"inertia": 0.05})}))
    assert frequencies(result.modes_after) == pytest.approx(frequencies(wanted.modes_after), rel=1e-9)


def test_bearing_and_brake_are_left_to_the_integrators() -> None:
    middle = {
        "bearing1": ("bearing", {"coulomb": 1.5, "viscous": 0.01}),
        "brake1": ("brake", {"inertia": 0.05, "capacity": "200 N m"}),
    }
    result = reduced(bed(middle))
    assert result.model.frictions == ()
    assert rules(result)["drop losses", "brake1"] == "the torque controller's integrator covers 200 N m"
    assert rules(result)["drop losses", "bearing1"] == "the torque controller's integrator covers 1.5 N m"


def test_locked_brake_holds_the_bed() -> None:
    middle = {"brake1": ("brake", {"inertia": 0.05, "capacity": "200 N m"})}
    full = assemble(Mechanism.of(bed(middle).load()))
    assert 0.0 not in frequencies(modes(full, ["brake1"]))
    result = reduced(bed(middle, locked=["brake1"]))
    assert frequencies(result.modes_before) == pytest.approx(frequencies(modes(full, ["brake1"])), rel=1e-9)
    before, after = frequencies(result.modes_before), frequencies(result.modes_after)
    assert after == pytest.approx(before[: len(after)], rel=0.05)


def test_brake_that_holds_a_machine_cannot_be_locked() -> None:
    made = bed({})
    made.add("brake1", "brake", capacity="200 N m")
    made.chains = ["M1 - flange1 - cardan1 - cardan2 - flange2 - brake1 - M2"]
    assert ("drop losses", "brake1") in rules(reduced(made)), "free it is left to the integrator"
    made.reduction = {"locked": ["brake1"]}
    with pytest.raises(ModelError, match="M2 cannot turn with brake1 locked") as caught:
        reduced(made)
    assert caught.value.problems[0].where == "reduction.locked"


def test_closed_gap_reduces_like_a_shaft_without_one() -> None:
    disk = {"disk": ("inertia", {"inertia": 0.05})}
    made = bed(disk)
    made.components["cardan2"]["backlash"] = "0.5 deg"
    result, wanted = reduced(made), reduced(bed(disk))
    assert result.parameters == pytest.approx(wanted.parameters)
    assert frequencies(result.modes_before) == pytest.approx(frequencies(wanted.modes_before))
    assert not result.model.contacts
    (rule,) = [rule for rule in result.rules if rule.rule == "close backlash"]
    assert rule.element == "cardan2"
    assert rule.numbers["gap_degrees"] == pytest.approx(0.5)
    assert rule.numbers["torque"] == pytest.approx(45e3 * np.deg2rad(0.5))


def test_gap_without_inertia_at_its_end_is_an_error_that_names_it() -> None:
    made = bed({})
    made.components["cardan2"]["backlash"] = "0.5 deg"
    with pytest.raises(ModelError, match=r"cardan2: has backlash and an end without inertia"):
        assemble(Mechanism.of(made.load()))


def test_play_of_a_gearbox_is_closed_and_its_teeth_are_a_shaft_behind_the_ratio() -> None:
    gears = {"ratio": 2.0, "inertia": 0.03, "inertia_other": 0.05, "mesh_stiffness": "500 kN m/rad"}
    result = reduced(bed({"box": ("gearbox", {**gears, "play": "0.1 deg"})}, drop=["box"]))
    stiffness = [1 / (1 / 380e3 + 1 / 57e3), 500e3 / 4, 1 / (4 / 45e3 + 4 / 220e3)]
    (twist,) = result.model.twists
    assert result.parameters[f"stiffness {twist}"] == pytest.approx(1 / sum(1 / c for c in stiffness), rel=1e-9)
    assert rules(result)["close backlash", "box"].startswith("as long as its torque keeps its sign")


@pytest.mark.parametrize(("name", "hint"), [("clutch2", '"clutch1"'), ("cardan1", "clutch1")])
def test_only_friction_elements_can_be_locked(name: str, hint: str) -> None:
    with pytest.raises(ModelError) as caught:
        reduced(clutched(locked=[name]))
    (problem,) = caught.value.problems
    assert problem.where == "reduction.locked"
    assert name in problem.what and "friction element" in problem.what
    assert hint.strip('"') in problem.remedy


def test_bed_without_friction_has_nothing_to_lock() -> None:
    with pytest.raises(ModelError, match="the bed has none"):
        reduced(bed({"disk": ("inertia", {"inertia": 0.05})}, locked=["disk"]))


def test_clutch_without_any_inertia_is_an_error_that_names_it() -> None:
    with pytest.raises(ModelError, match="clutch1: is a friction element on a velocity without inertia"):
        assemble(Mechanism.of(bed({"clutch1": ("clutch", {"capacity": "300 N m"})}).load()))


def test_controller_for_the_locked_clutch_is_that_for_an_inertia() -> None:
    made = []
    for candidate in (clutched(locked=["clutch1"]), bed({"disk": ("inertia", {"inertia": 0.05})})):
        testbed = candidate.load()
        result = reduce_mechanism(Mechanism.of(testbed), testbed.reduction)
        made.append(design_control(testbed, result.full, result).gains)
    locked, wanted = made
    for name in ("damping", "inertia_estimate", "stiffness", "speed"):
        assert getattr(locked, name) == pytest.approx(getattr(wanted, name), rel=1e-5), name

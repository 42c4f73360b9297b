"""Parts that no machine acts on while clutches slip: left out of the controller's model, not of the plant's."""

from __future__ import annotations

import pytest
from mechanism.bed_text import Bed

from ptgen.control.design import design_control
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.idle_parts import idle_parts, without_parts
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism


def rig(middle: str = "shaft2 - wheel", **reduction: object) -> Bed:
    """Return M1 - flange1 - clutch1 - (the middle) - clutch2 - flange2 - M2, speeds controlled at both ends."""
    bed = Bed()
    bed.machine("M1")
    bed.machine("M2", 2.0)
    for k in (1, 2):
        bed.add(f"flange{k}", "torque_flange", inertia=0.03, stiffness=380e3, damping=0.5)
        bed.add(f"clutch{k}", "clutch", capacity="300 N m", inertia_input=0.02, inertia_output=0.02)
    bed.add("shaft2", "shaft", stiffness=20e3, damping=1.0)
    bed.add("wheel", "inertia", inertia=0.4)
    bed.chains = [f"M1 - flange1 - clutch1 - {middle} - clutch2 - flange2 - M2"]
    bed.speed = ["M1", "M2"]
    bed.reduction = reduction
    return bed


def reduced(bed: Bed) -> ReducedModel:
    testbed = bed.load()
    return reduce_mechanism(Mechanism.of(testbed), testbed.reduction)


def test_middle_of_two_clutches_is_left_out() -> None:
    result = reduced(rig())
    (rule,) = [rule for rule in result.rules if rule.rule == "leave out"]
    assert rule.element == "clutch1.output, clutch2.input, shaft2, wheel"
    assert rule.why == "no machine acts on these 0.44 kg m^2 while clutch1, clutch2 slip"
    assert rule.numbers["inertia"] == pytest.approx(0.44)
    assert set(result.model.coordinates) == {"M1.shaft", "M2.shaft"}
    assert {friction.name for friction in result.model.frictions} == {"clutch1", "clutch2"}


def test_clutches_disturb_what_is_left() -> None:
    """Each with its torque on its own machine, the input's against it, the output's with it."""
    result = reduced(rig())
    rows = dict(zip((f.name for f in result.model.frictions), result.model.friction_rows.tolist(), strict=True))
    assert result.model.coordinates == ("M1.shaft", "M2.shaft")
    assert rows == {"clutch1": [1, 0], "clutch2": [0, -1]}


def test_a_law_is_found_and_the_plant_has_everything() -> None:
    testbed = rig().load()
    mechanism = Mechanism.of(testbed)
    full = assemble(mechanism)
    result = reduce_mechanism(mechanism, testbed.reduction, full)
    assert result.full is full
    assert {"wheel.left", "clutch1.output"} <= set(full.body_rows)
    assert set(design_control(testbed, result.full, result).gains.speed) == {"M1", "M2"}


def test_locked_clutch_makes_the_middle_belong_to_a_machine() -> None:
    result = reduced(rig(locked=["clutch1"]))
    assert not [rule for rule in result.rules if rule.rule == "leave out"]
    assert "wheel.left" in result.full.body_rows


def test_what_is_to_be_kept_is_kept() -> None:
    result = reduced(rig(keep=["wheel"]))
    assert not [rule for rule in result.rules if rule.rule == "leave out"]
    assert "wheel.left" in {body.velocity for body in result.mechanism.bodies}


def test_wishes_for_what_is_left_out_do_no_harm() -> None:
    result = reduced(rig(rigid=["shaft2"], drop=["wheel", "clutch1", "clutch2"]))
    assert not [rule for rule in result.rules if rule.element == "shaft2"]
    assert not result.model.twists or "shaft2" not in result.model.twists


def test_every_bed_in_one_piece_has_no_idle_part(projects) -> None:
    for name in ("differential", "differential_gearboxes", "back_to_back"):
        mechanism = projects[name].mechanism
        assert idle_parts(mechanism) == ()
        assert without_parts(mechanism, ()) is mechanism


def test_sensors_and_places_go_with_their_part() -> None:
    bed = rig("shaft2 - flange3 - diff.input")
    bed.add("flange3", "torque_flange", inertia=0.03, stiffness=380e3)
    friction = {"coulomb": 2.0, "load": 0.1}
    bed.add("diff", "differential", ratio=2.0, inertia=0.02, inertia_pinion=0.04, loss=friction)
    bed.chains = [
        "M1 - flange1 - clutch1 - shaft2 - flange3 - diff.input",
        "diff.output1 - clutch2 - flange2 - M2",
        "diff.output2 - wheel",
    ]
    result = reduced(bed)
    assert {sensor.name for sensor in result.model.sensors} == {
        "M1_speed",
        "M2_speed",
        "flange1_torque",
        "flange2_torque",
    }
    assert "diff.input" in result.full.signals and "diff.input" not in result.model.signals
    assert {friction.name for friction in result.model.frictions} == {"clutch1", "clutch2"}

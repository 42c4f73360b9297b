"""Models of beds with a gearbox whose ratio changes at run time."""

from __future__ import annotations

import pytest
import sympy as sp
from bed_text import Bed, two_machines
from test_special_mechanisms import LOCKS, loop

from ptgen.errors import ModelError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.reduction import reduce_mechanism

RATIO = sp.Symbol("gearbox_ratio", real=True)


def bed(*middle: str, **gearbox: object) -> Bed:
    """Return two machines with a gearbox between elastic shafts, and more components where they are named."""
    bed = Bed()
    bed.add("flange1", "torque_flange", inertia=0.03, stiffness=380e3, damping=0.5)
    bed.add("gearbox", "gearbox", **{"ratio": 2.0, "ratio_range": [0.5, 4.0], "inertia": 0.02, **gearbox})
    for name in ("shaft1", "shaft2"):
        bed.add(name, "shaft", stiffness=30e3, damping=2.0)
    bed.add("clutch", "clutch", capacity="100 N m", inertia_output=0.1)
    bed.add("bearing", "bearing", coulomb=1.0)
    middle = middle or ("flange1", "shaft1", "gearbox", "shaft2")
    for name in [name for name in bed.components if name not in middle]:
        bed.components.pop(name)
    return two_machines(middle, bed)


def free_of_ratio(matrix: sp.Matrix) -> bool:
    return RATIO not in matrix.free_symbols


@pytest.mark.parametrize("side", ["input", "output"])
def test_model_lists_the_ratio_and_no_body_depends_on_it(side: str) -> None:
    mechanism = Mechanism.of(bed(inertia_side=side).load())
    full = assemble(mechanism)
    assert [parameter.symbol for parameter in full.changing] == [RATIO]
    assert free_of_ratio(full.mass) and not free_of_ratio(full.twist_rows)
    reduced = reduce_mechanism(mechanism, bed().load().reduction, full).model
    assert [parameter.symbol for parameter in reduced.changing] == [RATIO]
    assert reduced.twist_rows == sp.Matrix([[1, -RATIO]])


def test_constant_ratio_is_no_changing_one() -> None:
    assert assemble(Mechanism.of(bed(ratio_range=[1.0, 3.0]).load())).changing
    text = bed()
    text.components["gearbox"].pop("ratio_range")
    assert not assemble(Mechanism.of(text.load())).changing


def test_friction_behind_the_ratio_leaves_the_bodies_alone() -> None:
    """The bearing sits at the output, the inertia at the input: the friction's row changes, not the body's."""
    model = assemble(Mechanism.of(bed("flange1", "shaft1", "gearbox", "bearing", "shaft2").load()))
    assert free_of_ratio(model.mass) and all(map(free_of_ratio, model.body_rows.values()))
    assert not free_of_ratio(model.friction_rows)


def test_twists_are_not_scaled_by_what_changes() -> None:
    """Scaled by the ratio the twist would not be the integral of its row."""
    turned = bed()
    turned.chains = ["M2 - shaft2 - gearbox.output", "gearbox.input - shaft1 - flange1 - M1"]
    for text in (turned, bed(inertia_side="output")):
        model = assemble(Mechanism.of(text.load()))
        assert all(any(abs(entry) == 1 for entry in model.twist_rows[k, :]) for k in range(len(model.twists)))
        assert all(map(free_of_ratio, model.spring_rows.values()))


def test_inertias_on_both_sides_are_refused() -> None:
    with pytest.raises(ModelError) as caught:
        assemble(Mechanism.of(bed("flange1", "shaft1", "gearbox").load()))
    (problem,) = caught.value.problems
    assert problem.where == "components.gearbox.ratio_range"
    assert "gearbox.input" in problem.what and "M2.shaft" in problem.what
    assert "shaft" in problem.remedy


def test_rigid_loops_refuse_a_changing_ratio() -> None:
    """3 = 2 * 1.5 turns with both differentials locked, any other ratio does not."""
    text = loop()
    text.components["one"]["ratio_range"] = [2.0, 4.0]
    mechanism = Mechanism.of(text.load())
    with pytest.raises(ModelError) as caught:
        assemble(mechanism.with_locked_frictions(LOCKS))
    assert caught.value.problems[0].where == "components.one.ratio_range"
    assert "rigid loop" in caught.value.problems[0].what

"""Individual feedback with active damping, where no decoupling exists (Section 6.3)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from control_laws import ClosedLoop, is_zero, symbols
from mechanism.bed_text import Bed, differential_bed

from ptgen.control.decoupling import Decoupling, decouple
from ptgen.errors import ControlError
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import evaluate_matrix
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism
from ptgen.testbed import Roles

v1, v2, v3 = sp.symbols("v_M1 v_M2 v_M3")
w1, w2, w3 = sp.symbols("M1_speed M2_speed M3_speed")


def open_bed(flanges: tuple[str, ...] = ("flange1", "flange2", "flange3")) -> Bed:
    """Return an open differential, M1 on speed, M2 and M3 on torque."""
    bed = differential_bed("differential", flanges=flanges)
    places = {"M2": "diff.output1", "M3": "diff.output2"}
    bed.torque, bed.speed = places, ["M1"]
    bed.reduction = {"drop": ["diff", *flanges]}
    return bed


def reduced_of(bed: Bed) -> tuple[ReducedModel, Roles]:
    testbed = bed.load()
    return reduce_mechanism(Mechanism.of(testbed), testbed.reduction), testbed.roles


@pytest.fixture(scope="module")
def individual() -> Decoupling:
    return decouple(*reduced_of(open_bed()), structure="individual")


def test_law_has_no_cross_terms_and_damps_with_the_twist_rate(individual: Decoupling) -> None:
    p, law = symbols(individual), individual.law_expressions()
    i = p["diff_ratio"]
    rate = w2 + w3 - 2 * w1 / i
    assert is_zero(law["M2"] - (-v2 - p["M2_damping"] * rate))
    assert is_zero(law["M3"] - (-v3 - p["M3_damping"] * rate))
    assert is_zero(law["M1"] - (v1 + sp.Symbol("flange1_torque")))


def test_why_there_is_no_decoupling_is_kept(individual: Decoupling) -> None:
    finding, unheld = individual.findings
    assert "one motion of the bed without any twist" in unheld
    assert "the torques at diff.output1 and diff.output2 hang on 1 twist" in finding
    assert individual.normal_form is None
    assert individual.internal_order == 0


def test_damping_is_that_of_a_damper_beside_the_shafts(individual: Decoupling) -> None:
    """Power taken out: the damping torques of M2 and M3 work against the twist rate, for every motion."""
    values = {**individual.values, **dict.fromkeys(individual.damping, 7.0)}
    speeds = [individual.sensors.index(f"M{k}_speed") for k in (1, 2, 3)]
    R = evaluate_matrix(individual.law.R, values)[:, speeds]
    E = individual.model.numeric(individual.values).twist_rows
    for omega in np.random.default_rng(0).normal(size=(20, 3)):
        torque = R @ omega
        assert torque[1] * E[0, 1] * (E @ omega)[0] <= 0
        assert torque[2] * E[0, 2] * (E @ omega)[0] <= 0


def test_feedback_alone_is_stable_with_speed_held(individual: Decoupling) -> None:
    """With v_1 a stiff speed control the twist is damped; what is left is the free difference of the outputs."""
    loop = ClosedLoop(individual, dict.fromkeys((s.name for s in individual.damping), 60.0))
    gain = np.zeros_like(loop.of_x)
    gain += loop.of_x + loop.of_v[:, [2]] @ np.array([[-100.0, 0, 0, 0]])  # outputs: two torques, then M1's speed
    poles = np.linalg.eigvals(loop.A + loop.B @ gain)
    free = [pole for pole in poles if abs(pole) < 1e-6]
    assert len(free) == 1
    assert all(pole.real < -1 for pole in poles if abs(pole) >= 1e-6)


def test_same_roles_get_advice_without_the_structure() -> None:
    reduced, roles = reduced_of(open_bed())
    with pytest.raises(ControlError, match="decoupling matrix is singular") as caught:
        decouple(reduced, roles)
    remedy = caught.value.problems[0].remedy
    assert 'locked = ["diff.limited_slip"]' in remedy
    assert 'structure = "individual"' in remedy
    bed = open_bed()
    bed.reduction["locked"] = ["diff.limited_slip"]
    assert decouple(*reduced_of(bed)).relative_degrees == (2, 2, 1)  # the advice works


def test_machine_without_a_flange_gets_no_compensation() -> None:
    """Plain speed control is better than none; the torques come from the other flanges."""
    individual = decouple(*reduced_of(open_bed(("flange2", "flange3"))), structure="individual")
    assert is_zero(individual.law_expressions()["M1"] - v1) or individual.law.balance[0] is not None


def test_speeds_only_across_a_locked_line_are_refused() -> None:
    bed = open_bed()
    bed.torque, bed.speed = {}, ["M1", "M2", "M3"]
    bed.reduction["locked"] = ["diff.limited_slip"]
    with pytest.raises(ControlError, match="winds up"):
        decouple(*reduced_of(bed), structure="individual")


def test_sensors_that_would_work_are_found() -> None:
    """Without any torque flange the law needs a state; one beside each speed machine is found by trying."""
    bed = differential_bed("differential", flanges=())
    bed.reduction = {"drop": ["diff"]}
    reduced, roles = reduced_of(bed)
    with pytest.raises(ControlError, match="no combination of the sensors") as caught:
        decouple(reduced, roles)
    remedy = caught.value.problems[0].remedy
    assert remedy.startswith("add a torque flange next to ")
    first = remedy.removeprefix("add a torque flange next to ").split("; or ")[0].split(", or ")[0]
    with_flanges = differential_bed("differential", flanges=tuple(f"flange{name[1]}" for name in first.split(" and ")))
    with_flanges.reduction = {"drop": [n for n in with_flanges.components if n.startswith(("diff", "flange"))]}
    assert decouple(*reduced_of(with_flanges)).relative_degrees == (2, 1, 1)


def test_roles_given_in_another_order_are_the_same(individual: Decoupling) -> None:
    reduced, roles = reduced_of(open_bed())
    other = replace(roles, torque=dict(reversed(list(roles.torque.items()))))
    assert decouple(reduced, other, structure="individual").law_expressions() == individual.law_expressions()


def test_torques_only_are_refused_and_never_advised() -> None:
    """Nothing would hold the speed: under 1000 against 900 N m the bed would run away."""
    bed = open_bed()
    bed.torque, bed.speed = {"M1": "diff.input", "M2": "flange2", "M3": "flange3"}, []
    with pytest.raises(ControlError, match="no machine controls a speed"):
        decouple(*reduced_of(bed), structure="individual")
    with pytest.raises(ControlError) as caught:
        decouple(*reduced_of(bed))
    assert "individual" not in caught.value.problems[0].remedy

"""Reduction of general beds: against direct condensation, the full model, and the wishes of the file."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mechanism.bed_text import DIFFERENTIALS, Bed, differential_bed
from mechanism.random_beds import trees
from mechanism.reference_mechanics import Array, Reference

from ptgen.errors import PtgenError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism
from ptgen.project import Project


def reduced(bed: Bed) -> ReducedModel:
    testbed = bed.load()
    return reduce_mechanism(Mechanism.of(testbed), testbed.reduction)


def without_inertia(bed: Bed) -> Bed:
    """Ask for the inertia of everything but the machines to be dropped."""
    names = [name for name, fields in bed.components.items() if any(key.startswith("inertia") for key in fields)]
    bed.reduction = {"drop": [name for name in names if bed.components[name]["type"] != "machine"]}
    return bed


def machine_stiffness(result: ReducedModel, count: int) -> Array:
    model = result.model
    assert len(model.coordinates) == count
    numeric = model.numeric()
    E = numeric.twist_rows
    return E.T @ numeric.stiffness @ E


@pytest.mark.parametrize("kind", list(DIFFERENTIALS))
@pytest.mark.parametrize("shafts", [(57e3, 45e3, 70e3), (1e4, 9e5, 3e4)])
def test_stiffness_between_machines_is_the_direct_condensation(kind: str, shafts: tuple[float, ...]) -> None:
    """Unequal shafts and an asymmetric torque split: the Schur complement of the full stiffness matrix."""
    bed = without_inertia(differential_bed(kind, shafts))
    expected = Reference(bed.load()).machine_stiffness()
    found = machine_stiffness(reduced(bed), 3)
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * abs(expected).max())


@settings(max_examples=5)
@given(trees())
def test_random_trees_condense_directly(bed: Bed) -> None:
    without_inertia(bed)
    expected = Reference(bed.load()).machine_stiffness()
    result = reduced(bed)
    found = machine_stiffness(result, 3)
    np.testing.assert_allclose(found, expected, rtol=1e-7, atol=1e-7 * abs(expected).max())
    assert not np.any(result.model.numeric().damping), "undamped"
    assert np.linalg.eigvalsh(result.equivalent_damping).min() >= -1e-9, "but the damping is known"


def balanced(model: Model, T: Array, seed: int) -> Array:
    """Return random air-gap torques that, with the friction torques, leave the bed at rest."""
    numeric = model.numeric()
    E = numeric.twist_rows
    R = scipy.linalg.null_space(E / np.linalg.norm(E, axis=1, keepdims=True))
    load, needed = R.T @ numeric.input_rows.T, R.T @ numeric.friction_rows.T @ T
    u = np.linalg.lstsq(load, needed, rcond=None)[0]
    assume(np.allclose(load @ u, needed, atol=1e-6 * (1 + abs(needed).max())))
    return u + scipy.linalg.null_space(load) @ np.random.default_rng(seed).uniform(-300, 300, len(u) - len(R.T))


def static_signals(model: Model, u: Array, T: Array) -> dict[str, float]:
    """Return all torques at rest: the twists follow from the balance, velocities and accelerations are zero."""
    numeric = model.numeric()
    E = numeric.twist_rows
    force = numeric.input_rows.T @ u - numeric.friction_rows.T @ T
    e = np.linalg.lstsq(E.T @ numeric.stiffness, force, rcond=None)[0]
    np.testing.assert_allclose(E.T @ numeric.stiffness @ e, force, atol=1e-6 * (1 + abs(force).max()))
    values = model.values
    return {
        name: float(sum(evaluate_matrix(part, values)[0] @ x for part, x in ((f.e, e), (f.u, u), (f.f, T))))
        for name, f in model.signals.items()
    }


@settings(max_examples=5)
@given(trees(), st.integers(0, 2**32 - 1), st.booleans())
def test_static_torques_are_those_of_the_full_model(bed: Bed, seed: int, drop: bool) -> None:
    """Whatever was dropped or made rigid, a sensor of a bed at rest still reads the same."""
    bed.components["diff"].pop("loss", None)
    testbed = (without_inertia(bed) if drop else bed).load()
    full = assemble(Mechanism.of(testbed))
    result = reduce_mechanism(Mechanism.of(testbed), testbed.reduction, full)
    T = np.array([np.random.default_rng(seed).uniform(-50, 50)])
    u = balanced(result.model, T, seed)
    expected, found = static_signals(full, u, T), static_signals(result.model, u, T)
    scale = 1 + max(map(abs, expected.values()))
    assert set(found) == set(expected)
    for name, value in expected.items():
        assert abs(found[name] - value) < 1e-6 * scale, name


def test_kept_modes_stay_within_five_percent(project: Project) -> None:
    before = [mode.frequency_hz for mode in project.reduced.modes_before]
    after = [mode.frequency_hz for mode in project.reduced.modes_after]
    assert len(after) == len(project.reduced.model.coordinates)
    asked = [rule for rule in project.reduced.rules if rule.rule == "drop inertia" and "asked for" in rule.why]
    far = any(rule.numbers["kinetic_share"] > rule.numbers["threshold"] for rule in asked)
    for mine, full in zip(after, before, strict=False):
        assert mine == pytest.approx(full, rel=0.08 if far else 0.05, abs=1e-12)
    assert max(after) > 0, "the mode that control acts on is kept"


def test_every_rule_gives_its_numbers(project: Project) -> None:
    rules = project.reduced.rules
    kinds = {"drop losses", "drop damping", "idealise drive", "drop inertia", "rigidise", "condense", "refer"}
    kinds |= {"leave out", "lock", "close backlash", "as ratio"}
    assert {rule.rule for rule in rules} <= kinds
    for rule in rules:
        assert rule.numbers and all(np.isfinite(value) for value in rule.numbers.values())
        assert any(character.isdigit() for character in rule.why)
        for key in ("kinetic_share", "strain_share"):
            if key in rule.numbers and "asked for" not in rule.why:
                assert rule.numbers[key] <= rule.numbers["threshold"]


def test_everything_that_went_is_listed(project: Project) -> None:
    result = project.reduced
    gone = {body.velocity for body in result.original.bodies} - {body.velocity for body in result.mechanism.bodies}
    idle = {r.element for r in result.rules if r.rule == "leave out" and not r.element.endswith(".fluid")}
    dropped = {rule.element for rule in result.rules if rule.rule == "drop inertia"}
    assert gone == dropped | {velocity for velocity in gone if any(velocity.split(".")[0] in item for item in idle)}
    assert bool(gone - dropped) == bool(idle)
    losses = {f.name for f in result.original.frictions} - {f.name for f in result.mechanism.frictions}
    assert losses == {rule.element for rule in result.rules if rule.rule == "drop losses"}
    rigid = {rule.element for rule in result.rules if rule.rule == "rigidise"}
    assert rigid == {c.owner for c in result.mechanism.constraints} & {s.name for s in result.original.springs}


def test_kinetic_and_strain_shares_of_a_mode_sum_to_one(project: Project) -> None:
    """The shares that decide are shares of unit energy: check the scale of the vectors behind them."""
    numeric = project.reduced.full.numeric()
    if any(rule.rule == "leave out" for rule in project.reduced.rules):
        pytest.skip("the modes before are those of a part of the model")
    for mode in project.reduced.modes_before:
        assert mode.vector @ numeric.mass @ mode.vector == pytest.approx(1.0)
        twist = numeric.twist_rows @ mode.vector
        omega = 2 * np.pi * mode.frequency_hz
        assert twist @ numeric.stiffness @ twist == pytest.approx(omega**2, rel=1e-6, abs=1e-3)


def test_keep_keeps(projects: dict[str, Project]) -> None:
    bed = differential_bed()
    bed.reduction = {"keep": ["diff", "flange1", "cardan1"]}
    result = reduced(bed)
    left = {body.velocity for body in result.mechanism.bodies}
    assert {"diff.input", "diff.pinion", "flange1.uut"} <= left
    assert not {"flange2.uut", "flange3.uut"} & left
    assert {"flange1", "cardan1"} <= {spring.name for spring in result.mechanism.springs}


def test_rigid_and_drop_are_obeyed_and_say_so() -> None:
    bed = differential_bed()
    bed.reduction = {"rigid": ["cardan1"], "drop": ["diff"], "keep": ["flange2"]}
    result = reduced(bed)
    reasons = {(rule.rule, rule.element): rule.why for rule in result.rules}
    assert reasons["rigidise", "cardan1"].startswith("asked for in the file")
    assert reasons["drop inertia", "diff.input"].startswith("asked for in the file")
    assert "cardan1" not in {spring.name for spring in result.mechanism.springs}
    assert "flange2.uut" in {body.velocity for body in result.mechanism.bodies}


def test_thresholds_are_obeyed() -> None:
    bed = differential_bed()
    bed.reduction = {"inertia_share": 0}
    assert len(reduced(bed).mechanism.bodies) == len(Mechanism.of(bed.load()).bodies)


@pytest.mark.parametrize(("key", "name"), [("rigid", "M1"), ("drop", "M1"), ("keep", "nothing"), ("drop", "cardan1")])
def test_impossible_wish_is_an_error(key: str, name: str) -> None:
    bed = differential_bed()
    bed.reduction = {key: [name]}
    with pytest.raises(PtgenError, match=name) as caught:
        reduced(bed)
    assert all(problem.remedy for problem in caught.value.problems)

"""Closed rigid loops, places where nothing is determined, and locked friction."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from mechanism.bed_text import Bed, differential_bed, two_machines
from mechanism.reference_mechanics import Reference

from ptgen.errors import ModelError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.modes import modes

LOCKS = {"split.limited_slip", "join.limited_slip"}


def loop() -> Bed:
    """Two gearboxes in series beside a third one of the same ratio, between two differentials."""
    bed = Bed()
    for name, inertia in (("M1", 1.0), ("M2", 2.0)):
        bed.machine(name, inertia)
    for name in ("split", "join"):
        bed.add(name, "differential", ratio=1.0, inertia=0.1, inertia_pinion=0.2, limited_slip={"coulomb": 1.0})
    bed.add("s1", "shaft", stiffness=1e4)
    bed.add("s2", "shaft", stiffness=2e4)
    for name, ratio in (("one", 3.0), ("two", 2.0), ("three", 1.5)):
        bed.add(name, "gearbox", ratio=ratio, inertia=0.05)
    bed.chains = [
        "M1 - s1 - split.input",
        "split.output1 - one - join.output1",
        "split.output2 - two - three - join.output2",
        "join.input - s2 - M2",
    ]
    bed.torque, bed.speed = {"M1": "s1"}, ["M2"]
    return bed


def squared_frequencies(mechanism: Mechanism) -> list[float]:
    return [(2 * np.pi * mode.frequency_hz) ** 2 for mode in modes(assemble(mechanism))]


def test_loop_through_differentials_is_that_of_the_reference() -> None:
    testbed = loop().load()
    expected = Reference(testbed).squared_frequencies()
    squared = squared_frequencies(Mechanism.of(testbed))
    np.testing.assert_allclose(squared, expected, rtol=1e-9, atol=1e-9 * expected.max())


def test_rigid_loop_turns_because_its_ratios_agree_as_numbers() -> None:
    """With both differentials locked, three independent ratios would leave no motion: 3 = 2 * 1.5 does."""
    testbed = loop().load()
    locked = Mechanism.of(testbed).with_locked_frictions(LOCKS)
    model = assemble(locked)
    assert {symbol.name for symbol in model.fixed} >= {"one_ratio", "two_ratio", "three_ratio"}
    assert not model.mass.free_symbols & set(model.fixed), "fixed ratios stand as numbers"
    expected = Reference(testbed).squared_frequencies(tuple(sorted(LOCKS)))
    squared = squared_frequencies(locked)
    np.testing.assert_allclose(squared, expected, rtol=1e-9, atol=1e-9 * expected.max())
    assert len(squared) == 3
    speed = model.velocity_rows
    assert speed["split.output1"] == 3 * speed["join.output1"]
    assert speed["split.pinion"] == sp.zeros(1, 3)


def test_torque_inside_a_rigid_loop_is_not_determined() -> None:
    bed = loop()
    bed.torque = {"M1": "one.input"}
    mechanism = Mechanism.of(bed.load())
    assert "one.input" in assemble(mechanism).signals
    with pytest.raises(ModelError, match="the torque is not determined"):
        assemble(mechanism.with_locked_frictions(LOCKS))


def test_no_fixed_parameters_without_a_loop(project: object) -> None:
    assert project.model.fixed == ()


@pytest.mark.parametrize("parts", [("gearbox1",), ("s1", "gearbox1", "s2")])
def test_parameters_stay_symbolic(parts: tuple[str, ...]) -> None:
    bed = Bed()
    bed.add("gearbox1", "gearbox", ratio=2.0, inertia=0.1)
    for name in set(parts) - {"gearbox1"}:
        bed.add(name, "shaft", stiffness=1e4)
    model = assemble(Mechanism.of(two_machines(parts, bed, place="gearbox1.output").load()))
    symbols = model.mass.free_symbols | model.twist_rows.free_symbols
    assert {"gearbox1_ratio", "gearbox1_inertia"} <= {symbol.name for symbol in symbols}


def test_motion_without_inertia_and_without_stiffness_is_an_error() -> None:
    """An epicyclic set without bodies on two of its shafts leaves a motion that nothing holds."""
    mechanism = Mechanism.of(differential_bed("epicyclic_differential").load())
    loose = mechanism.without_bodies({body.velocity for body in mechanism.bodies} - {"M1.shaft"})
    rigid = loose.with_rigid_springs({"cardan1", "flange1"}).without_frictions({"diff.limited_slip"})
    held = replace(rigid, springs=tuple(s for s in rigid.springs if s.name == "cardan2"))
    with pytest.raises(ModelError, match="neither inertia nor a shaft that holds it") as caught:
        assemble(held)
    assert all(problem.remedy for problem in caught.value.problems)


def test_friction_on_a_velocity_without_inertia_is_an_error() -> None:
    """A differential whose pinion and outputs have no inertia has a friction on nothing but shafts."""
    mechanism = Mechanism.of(differential_bed().load())
    with pytest.raises(ModelError, match=re.escape("diff.limited_slip")) as caught:
        assemble(mechanism.without_bodies({"diff.pinion"}))
    (problem,) = caught.value.problems
    assert "without inertia" in problem.what
    assemble(mechanism.without_bodies({"diff.pinion"}), first="machines")  # as a disturbance it may act there


def test_locking_all_frictions_leaves_none() -> None:
    mechanism = Mechanism.of(differential_bed().load())
    model = assemble(mechanism.with_locked_frictions({"diff.limited_slip"}))
    assert model.frictions == ()
    z = sp.Matrix(model.velocity_rows["diff.pinion"])
    assert z == sp.zeros(1, len(model.coordinates))

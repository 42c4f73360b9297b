"""Modes: closed forms, the published frequencies, and consistency of vectors and shapes."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanism.bed_text import Bed, two_machines

from ptgen.errors import ModelError
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.modes import modes
from ptgen.project import Project


def elastic(found: tuple[object, ...]) -> list[float]:
    return [mode.frequency_hz for mode in found if mode.frequency_hz > 0]


def test_table_c1_open(projects: dict[str, Project]) -> None:
    found = modes(projects["differential"].model)
    assert elastic(found) == pytest.approx([21.87, 230.39, 283.95, 483.64, 507.66, 604.83], abs=0.006)
    assert [mode.frequency_hz for mode in found[:2]] == [0.0, 0.0]


def test_table_c1_locked(projects: dict[str, Project]) -> None:
    """The source gives 21.9 Hz for M1 against M2 and M3."""
    found = modes(projects["differential"].model, ["diff.limited_slip"])
    assert elastic(found) == pytest.approx([10.54, 21.87, 283.94, 473.18, 498.51, 604.83], abs=0.006)
    published = found[2]
    assert published.frequency_hz == pytest.approx(21.867, abs=5e-4)
    assert round(published.frequency_hz, 1) == 21.9
    assert published.shape["M1.shaft"] == 1.0
    assert published.shape["M2.shaft"] == pytest.approx(published.shape["M3.shaft"], rel=1e-3)
    assert published.shape["M2.shaft"] < 0


def test_locking_both_frictions_stops_the_input(projects: dict[str, Project]) -> None:
    found = modes(projects["differential"].model, ["diff.limited_slip", "diff.loss"])
    assert len(found) == len(projects["differential"].model.coordinates) - 2
    assert all(mode.frequency_hz > 0 for mode in found), "nothing turns freely any more"


@settings(max_examples=40)
@given(
    I1=st.floats(0.01, 100),
    I2=st.floats(0.01, 100),
    c=st.floats(10, 1e6),
    zeta=st.floats(0, 0.99),
)
def test_two_masses_on_a_shaft(I1: float, I2: float, c: float, zeta: float) -> None:
    reduced = I1 * I2 / (I1 + I2)
    omega = np.sqrt(c / reduced)
    d = float(2 * zeta * omega * reduced)
    bed = Bed()
    bed.add("shaft1", "shaft", stiffness=c, damping=d)
    bed = two_machines(["shaft1"], bed, place="shaft1")
    bed.machine("M1", I1)
    bed.machine("M2", I2)
    rigid, mode = modes(assemble(Mechanism.of(bed.load())))
    assert (rigid.frequency_hz, rigid.damping_ratio) == (0.0, 0.0)
    assert mode.frequency_hz == pytest.approx(omega / (2 * np.pi), rel=1e-9)
    assert mode.damping_ratio == pytest.approx(zeta, rel=1e-6, abs=1e-9)
    ratio = mode.shape["M1.shaft"] / mode.shape["M2.shaft"]
    assert ratio == pytest.approx(-I2 / I1, rel=1e-6)


def test_modes_without_a_spring_are_rigid() -> None:
    bed = Bed()
    bed.add("gearbox1", "gearbox", ratio=2.0, inertia=0.1)
    (mode,) = modes(assemble(Mechanism.of(two_machines(["gearbox1"], bed, place="gearbox1.output").load())))
    assert (mode.frequency_hz, mode.damping_ratio) == (0.0, 0.0)
    assert mode.shape["M2.shaft"] == pytest.approx(0.5 * mode.shape["M1.shaft"])


def test_vectors_have_unit_kinetic_energy_and_are_orthogonal(project: Project) -> None:
    mass = project.model.numeric().mass
    V = np.array([mode.vector for mode in modes(project.model)])
    np.testing.assert_allclose(V @ mass @ V.T, np.eye(len(V)), atol=1e-8)


def test_shapes_are_scaled_and_sorted(project: Project) -> None:
    found = modes(project.model)
    frequencies = [mode.frequency_hz for mode in found]
    assert frequencies == sorted(frequencies)
    for mode in found:
        assert max(abs(value) for value in mode.shape.values()) == 1.0
        assert set(mode.shape) >= set(project.mechanism.machine_velocities)


def test_parameters_can_be_overridden(projects: dict[str, Project]) -> None:
    model = projects["back_to_back"].model
    heavy = {p.symbol: 4 * p.value for p in model.parameters if p.unit == "kg m^2"}
    before, after = elastic(modes(model)), elastic(modes(model, values=heavy))
    np.testing.assert_allclose(after, np.array(before) / 2, rtol=1e-9)


def test_unknown_lock_names_the_nearest(projects: dict[str, Project]) -> None:
    with pytest.raises(ModelError, match="no friction element") as caught:
        modes(projects["differential"].model, ["diff.limited_slp", "diff.loss"])
    (problem,) = caught.value.problems
    assert problem.where == "diff.limited_slp"
    assert "diff.limited_slip" in problem.remedy


def test_unknown_lock_without_any_friction(projects: dict[str, Project]) -> None:
    with pytest.raises(ModelError, match="it has none"):
        modes(projects["back_to_back"].model, ["clutch"])

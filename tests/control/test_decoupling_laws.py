"""The printed laws come out of the general procedure, and every closed loop is diagonal."""

from __future__ import annotations

import pytest
import sympy as sp
from control_laws import assert_decoupled, design, expanded, is_zero, symbols
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanism.bed_text import DIFFERENTIALS, Bed, differential_bed, two_machines

from ptgen.control.decoupling import Decoupling
from ptgen.project import Project

v1, v2, v3 = sp.symbols("v_M1 v_M2 v_M3")
w1, w2, w3 = sp.symbols("M1_speed M2_speed M3_speed")
Tf1, Tf2, Tf3 = sp.symbols("flange1_torque flange2_torque flange3_torque")


def transmission(ratio: float = 3.5, shafts: tuple[float, float] = (5e4, 8e4), inertia: float = 2.0) -> Bed:
    bed = Bed()
    bed.add("flange1", "torque_flange", inertia=0.01, stiffness=4e5)
    bed.add("shaft1", "shaft", stiffness=shafts[0])
    bed.add("gear", "gearbox", ratio=ratio, inertia=0.02)
    bed.add("shaft2", "shaft", stiffness=shafts[1])
    bed.add("flange2", "torque_flange", inertia=0.01, stiffness=4e5)
    result = two_machines(["flange1", "shaft1", "gear", "shaft2", "flange2"], bed)
    result.components["M2"]["inertia"] = inertia
    result.reduction = {"drop": ["gear", "flange1", "flange2"]}
    return result


def same_sides(p: dict[str, sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """Both output shafts alike, as the source assumes."""
    pairs = [("cardan3_stiffness", "cardan2_stiffness"), ("gearbox3_ratio", "gearbox2_ratio")]
    return {p[old]: p[new] for old, new in pairs if old in p and new in p}


def test_two_machines_get_5_52_and_5_62() -> None:
    decoupling = design(transmission())
    p, law = symbols(decoupling), decoupling.law_expressions()
    i, I1, I2, d = p["gear_ratio"], p["M1_inertia_estimate"], p["M2_inertia"], p["M1_damping"]
    assert is_zero(law["M2"] - (v2 - Tf2))
    assert is_zero(law["M1"] - (v1 + I1 * i * v2 / I2 - d * (w1 - i * w2)))


def test_two_machines_on_one_shaft_are_the_special_case(projects: dict[str, Project]) -> None:
    decoupling = projects["back_to_back"].design.decoupling
    p, law = symbols(decoupling), decoupling.law_expressions()
    assert is_zero(law["M2"] - (v2 - Tf2))
    I1, I2, d = p["M1_inertia_estimate"], p["M2_inertia"], p["M1_damping"]
    assert is_zero(law["M1"] - (v1 + I1 / I2 * v2 - d * (w1 - w2)))


def test_three_machines_get_5_74_5_75_and_5_78(projects: dict[str, Project]) -> None:
    decoupling = projects["differential_gearboxes"].design.decoupling
    p, law = symbols(decoupling), decoupling.law_expressions()
    i = p["diff_ratio"] * p["gearbox1_ratio"] / p["gearbox2_ratio"]
    I1, I2, I3, d = p["M1_inertia_estimate"], p["M2_inertia"], p["M3_inertia"], p["M1_damping"]
    printed = v1 / (p["gearbox2_ratio"] * i) - d * (w1 - i * (w2 + w3) / 2) + I1 * i / 2 * (v2 / I2 + v3 / I3)
    assert is_zero((law["M1"] - printed).subs(same_sides(p)))
    assert is_zero(law["M2"] - (v2 - Tf2))
    assert is_zero(law["M3"] - (v3 - Tf3))


def test_direct_drive_has_the_same_structure(projects: dict[str, Project]) -> None:
    decoupling = projects["differential"].design.decoupling
    p, law = symbols(decoupling), decoupling.law_expressions()
    i, I1, d = p["diff_ratio"], p["M1_inertia_estimate"], p["M1_damping"]
    printed = v1 - d * (w1 - i * (w2 + w3) / 2) + I1 * i / 2 * (v2 / p["M2_inertia"] + v3 / p["M3_inertia"])
    assert is_zero(law["M1"] - printed)
    assert is_zero(law["M2"] - (v2 - Tf2))
    assert is_zero(law["M3"] - (v3 - Tf3))


def test_estimate_is_5_95_with_the_correction_5_98(projects: dict[str, Project]) -> None:
    decoupling = projects["differential_gearboxes"].design.decoupling
    p, law = symbols(decoupling), decoupling.law
    measured = sp.Matrix([sp.Symbol(name) for name in decoupling.sensors])
    found = (law.estimate_sensors * measured + law.estimate_virtual * sp.Matrix([v1, v2, v3]))[0]
    i2, gears = p["gearbox2_ratio"], [p["gearbox2_inertia"], p["gearbox3_inertia"]]
    printed = i2 * (Tf2 + gears[0] / p["M2_inertia"] * v2 + Tf3 + gears[1] / p["M3_inertia"] * v3)
    assert is_zero((found - printed).subs(same_sides(p)))
    assert is_zero(law.estimate_sensors.subs(same_sides(p)) * measured - sp.Matrix([i2 * (Tf2 + Tf3)]))  # (5.95)


def test_laws_are_blind_to_the_twist(projects: dict[str, Project]) -> None:
    """(5.57), (5.76): with the natural stiffness the torque machine's law needs no twist and no friction."""
    for name in ("back_to_back", "differential", "differential_gearboxes"):
        decoupling = projects[name].design.decoupling
        of_x, of_T = decoupling.state_law.x, decoupling.state_law.T
        n_z = len(decoupling.model.coordinates)
        own = decoupling.actuators[0]
        assert is_zero(of_x[own, n_z:])
        assert is_zero(of_T[own, :])


def test_natural_stiffness_is_5_10(projects: dict[str, Project]) -> None:
    decoupling = projects["differential_gearboxes"].design.decoupling
    p = symbols(decoupling)
    i = p["diff_ratio"] * p["gearbox1_ratio"] / p["gearbox2_ratio"]
    c1, c2 = p["cardan1_stiffness"] / p["gearbox1_ratio"] ** 2, p["cardan2_stiffness"] / p["gearbox2_ratio"] ** 2
    printed = 2 * c1 * c2 / (i**2 * c1 + 2 * c2)
    assert is_zero((expanded(decoupling, decoupling.stiffness[0]) - printed).subs(same_sides(p)))


def test_short_names_have_the_value_of_what_they_stand_for(project: Project) -> None:
    decoupling = project.design.decoupling
    for symbol, definition in decoupling.definitions.items():
        assert decoupling.values[symbol] == pytest.approx(float(definition.subs(decoupling.values)), rel=1e-12)


def test_closed_loop_is_diagonal_symbolically(projects: dict[str, Project]) -> None:
    """(5.58), (5.49) from the law over states, for every value of every parameter."""
    decoupling = projects["differential"].design.decoupling
    of_v, of_x, of_T = decoupling.state_law.v, decoupling.state_law.x, decoupling.state_law.T
    system, p = decoupling.system, symbols(decoupling)
    s = sp.Symbol("s")
    A = (system.A + system.B * of_x).applyfunc(sp.cancel)
    B = (system.B * of_v).applyfunc(sp.cancel)
    rows = sp.Matrix.vstack(*[chain.rows[0] for chain in decoupling.chains])
    x = (s * sp.eye(system.order) - A).LUsolve(B).applyfunc(sp.cancel)
    G = (rows * x).applyfunc(sp.cancel)
    c = decoupling.stiffness[0]
    torque = c / (p["M1_inertia_estimate"] * s**2 + p["M1_damping"] * s + c)
    printed = sp.diag(torque, 1 / (p["M2_inertia"] * s), 1 / (p["M3_inertia"] * s))
    assert is_zero(G - printed)
    closed_F = (system.F + system.B * of_T).applyfunc(sp.cancel)
    # Unequal output shafts put a share of the slip torque into the input torque; the loop settles against it.
    direct = decoupling.model.signals["diff.input"].f[0]
    disturbed = rows * (s * sp.eye(system.order) - A).LUsolve(closed_F)
    assert is_zero(expanded(decoupling, disturbed + sp.Matrix([direct * torque, 0, 0])))
    equal = {p["cardan3_stiffness"]: p["cardan2_stiffness"], p["flange3_stiffness"]: p["flange2_stiffness"]}
    assert is_zero(expanded(decoupling, sp.Matrix([direct])).subs(equal))


def test_shipped_beds_are_decoupled(project: Project) -> None:
    if project.testbed.tuning.structure == "individual":
        pytest.skip("each machine has a controller of its own")
    assert_decoupled(project.design.decoupling)


@settings(max_examples=2)
@given(
    kind=st.sampled_from(list(DIFFERENTIALS)),
    shafts=st.tuples(*[st.floats(1e3, 1e6)] * 3),
    place=st.sampled_from(["diff.input", "diff.outputs", "flange1"]),
    seed=st.integers(0, 2**32 - 1),
)
def test_unequal_shafts_and_asymmetric_differentials_are_decoupled(
    kind: str, shafts: tuple[float, ...], place: str, seed: int
) -> None:
    bed = differential_bed(kind, shafts, place=place)
    bed.reduction = {"drop": ["diff", "flange1", "flange2", "flange3"]}
    assert_decoupled(design(bed), seed)


@settings(max_examples=8)
@given(
    ratio=st.floats(0.1, 12),
    shafts=st.tuples(st.floats(1e3, 1e6), st.floats(1e3, 1e6)),
    inertia=st.floats(0.1, 50),
    seed=st.integers(0, 2**32 - 1),
)
def test_two_machines_with_any_ratio_are_decoupled(
    ratio: float, shafts: tuple[float, float], inertia: float, seed: int
) -> None:
    assert_decoupled(design(transmission(ratio, shafts, inertia)), seed)


SWAPPED = {
    "M2 controls its torque": ("differential", {"M2": "flange2"}, ["M1", "M3"]),
    "M3 controls the input torque": ("differential", {"M3": "diff.input"}, ["M1", "M2"]),
    "M2 controls the sum": ("bevel_differential", {"M2": "diff.outputs"}, ["M3", "M1"]),
}


@pytest.mark.parametrize(("kind", "torque", "speed"), SWAPPED.values(), ids=SWAPPED.keys())
def test_swapped_roles_are_decoupled(kind: str, torque: dict[str, str], speed: list[str]) -> None:
    bed = differential_bed(kind)
    bed.torque, bed.speed = torque, speed
    bed.reduction = {"drop": ["diff", "flange1", "flange2", "flange3"]}
    decoupling = design(bed)
    assert decoupling.machines[decoupling.actuators[0]] == next(iter(torque))
    assert decoupling.relative_degrees == (2, 1, 1)
    assert_decoupled(decoupling)


def law_sensors(decoupling: Decoupling, machine: str) -> set[str]:
    row = decoupling.law.R[decoupling.machines.index(machine), :]
    return {name for name, share in zip(decoupling.sensors, row, strict=True) if share != 0}


def test_machine_uses_its_own_flange(project: Project) -> None:
    """The rule is the same for every bed: speed machines their flange, torque machines the speeds.

    With several torques their cross terms are cancelled from measured torques.
    """
    decoupling = project.design.decoupling
    for machine in project.testbed.roles.speed:
        assert law_sensors(decoupling, machine) == {f"flange{machine[1:]}_torque"}
    for machine in project.testbed.roles.torque if len(project.testbed.roles.torque) == 1 else ():
        assert all(name.endswith("_speed") for name in law_sensors(decoupling, machine))

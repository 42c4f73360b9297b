"""The printed reduced models come out of the general rules: (3.6), (3.7), (5.2)-(5.13), (B.25), (B.27)."""

from __future__ import annotations

import pytest
import sympy as sp
from mechanism.bed_text import Bed, differential_bed, two_machines

from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.reduction import ReducedModel, reduce_mechanism
from ptgen.project import Project
from ptgen.testbed import load

T_dsl, dphi, Tag1, Tag2, Tag3 = sp.symbols("T_dsl Delta_phi Tag1 Tag2 Tag3")


def is_zero(value: sp.Expr | sp.Matrix) -> bool:
    entries = list(value) if isinstance(value, sp.MatrixBase) else [value]
    return all(sp.cancel(sp.together(entry)) == 0 for entry in entries)


def reduced(bed: Bed) -> ReducedModel:
    testbed = bed.load()
    return reduce_mechanism(Mechanism.of(testbed), testbed.reduction)


def expanded(expression: sp.Expr | sp.Matrix, result: ReducedModel) -> sp.Expr | sp.Matrix:
    """Insert the definitions of equivalent shafts until only parameters of the bed are left."""
    for symbol, definition in reversed(result.definitions.items()):
        expression = expression.subs(symbol, definition)
    return expression


def symbols(result: ReducedModel) -> dict[str, sp.Symbol]:
    return {parameter.symbol.name: parameter.symbol for parameter in result.model.parameters}


def in_series(count: int) -> tuple[ReducedModel, list[sp.Symbol], list[sp.Symbol]]:
    bed = Bed()
    names = [bed.add(f"s{k}", "shaft", stiffness=1e4 * k, damping=1.0 * k) for k in range(1, count + 1)]
    result = reduced(two_machines(names, bed, place="s1"))
    p = symbols(result)
    return result, [p[f"{name}_stiffness"] for name in names], [p[f"{name}_damping"] for name in names]


@pytest.mark.parametrize("count", [2, 3, 4, 5])
def test_stiffness_of_shafts_in_series_is_3_6(count: int) -> None:
    result, c, _ = in_series(count)
    stiffness = expanded(result.model.stiffness[0, 0], result)
    assert is_zero(1 / stiffness - sum(1 / value for value in c))
    assert result.model.twist_rows == sp.Matrix([[1, -1]])


@pytest.mark.parametrize("count", [2, 3, 4, 5])
def test_damping_of_shafts_in_series_is_3_7(count: int) -> None:
    """Each shaft takes the share c_eq/c_k of the twist: d = c_eq^2 sum(d_k / c_k^2)."""
    result, c, d = in_series(count)
    damping = next(symbol for symbol in reversed(result.definitions) if symbol.name.endswith("_damping"))
    c_eq = 1 / sum(1 / value for value in c)
    printed = c_eq**2 * sum(dk / ck**2 for ck, dk in zip(c, d, strict=True))
    assert is_zero(expanded(damping, result) - printed)
    assert result.equivalent_damping[0, 0] == pytest.approx(float(printed.subs(result.model.values)))


def test_two_shafts_are_b25_and_b27() -> None:
    result, (c1, c2), (d1, d2) = in_series(2)
    assert is_zero(expanded(result.model.stiffness[0, 0], result) - c1 * c2 / (c1 + c2))
    damping = list(result.definitions)[-1]
    assert is_zero(result.definitions[damping] - (c1**2 * d2 + c2**2 * d1) / (c1 + c2) ** 2)


@pytest.fixture(scope="module")
def direct_drive() -> ReducedModel:
    """The bed of Figure 5.3: flanges rigid and without inertia, the differential kinematic."""
    bed = differential_bed(shafts=(57e3, 57e3, 57e3))
    bed.reduction = {
        "rigid": ["flange1", "flange2", "flange3"],
        "drop": ["flange1", "flange2", "flange3", "diff"],
    }
    return reduced(bed)


def test_equivalent_stiffness_is_5_2(direct_drive: ReducedModel) -> None:
    p = symbols(direct_drive)
    c1, c2, i = p["cardan1_stiffness"], p["cardan2_stiffness"], p["diff_ratio"]
    printed = 2 * c1 * c2 / (i**2 * c1 + 2 * c2)
    assert is_zero((direct_drive.model.stiffness[0, 0] - printed).subs(p["cardan3_stiffness"], c2))


def test_twist_is_5_5(direct_drive: ReducedModel) -> None:
    i = symbols(direct_drive)["diff_ratio"]
    assert direct_drive.model.coordinates == ("M1.shaft", "M2.shaft", "M3.shaft")
    assert is_zero(direct_drive.model.twist_rows - sp.Matrix([[1, -i / 2, -i / 2]]))


def test_state_equations_are_5_6(direct_drive: ReducedModel) -> None:
    """T_dsl of (5.6) is r1/r3 times the friction torque at the pinion, see the errata."""
    p, model = symbols(direct_drive), direct_drive.model
    i, c = p["diff_ratio"], model.stiffness[0, 0]
    friction = T_dsl * p["diff_pinion_ratio"]
    rates = model.accelerations()
    derived = rates.e * dphi + rates.u * sp.Matrix([Tag1, Tag2, Tag3]) + rates.f * friction
    printed = sp.Matrix(
        [
            (-c * dphi + Tag1) / p["M1_inertia"],
            (i * c * dphi / 2 - T_dsl / 2 + Tag2) / p["M2_inertia"],
            (i * c * dphi / 2 + T_dsl / 2 + Tag3) / p["M3_inertia"],
        ]
    )
    symmetric = {p["cardan3_stiffness"]: p["cardan2_stiffness"]}
    assert is_zero((derived - printed).subs(symmetric))
    assert rates.z == sp.zeros(3, 3)


def test_measured_torques_are_5_7(direct_drive: ReducedModel) -> None:
    p, model = symbols(direct_drive), direct_drive.model
    i, c = p["diff_ratio"], model.stiffness[0, 0]
    friction = T_dsl * p["diff_pinion_ratio"]
    printed = {
        "flange1_torque": c * dphi,
        "flange2_torque": i / 2 * c * dphi - T_dsl / 2,
        "flange3_torque": i / 2 * c * dphi + T_dsl / 2,
    }
    symmetric = {p["cardan3_stiffness"]: p["cardan2_stiffness"]}
    for sensor, expected in printed.items():
        form = model.without_acceleration(model.signals[sensor])
        derived = (form.e * dphi + form.u * sp.Matrix([Tag1, Tag2, Tag3]) + form.f * friction)[0]
        assert is_zero((derived - expected).subs(symmetric)), sensor


@pytest.fixture(scope="module")
def geared(root: object) -> ReducedModel:
    """The bed with adapter gearboxes as shipped; flanges are rigid by the automatic rule."""
    return Project(load(root / "testbeds" / "differential-gearboxes.toml")).reduced


def symmetry(p: dict[str, sp.Symbol]) -> dict[sp.Symbol, sp.Symbol]:
    return {
        p["cardan3_stiffness"]: p["cardan2_stiffness"],
        p["gearbox3_ratio"]: p["gearbox2_ratio"],
        p["diff_pinion_ratio"]: sp.Integer(1),
    }


def scaled(p: dict[str, sp.Symbol]) -> tuple[sp.Expr, sp.Expr]:
    """Return i_d' of (5.9) and the equivalent stiffness (5.10) of the shafts (5.8)."""
    c1, c2 = p["cardan1_stiffness"] / p["gearbox1_ratio"] ** 2, p["cardan2_stiffness"] / p["gearbox2_ratio"] ** 2
    i = p["diff_ratio"] * p["gearbox1_ratio"] / p["gearbox2_ratio"]
    return i, 2 * c1 * c2 / (i**2 * c1 + 2 * c2)


def test_geared_bed_is_5_10_to_5_12(geared: ReducedModel) -> None:
    p, model = symbols(geared), geared.model
    i, c = scaled(p)
    same = symmetry(p)
    assert is_zero((model.stiffness[0, 0] - c).subs(same))
    assert is_zero((model.twist_rows - sp.Matrix([[1, -i / 2, -i / 2]])).subs(same))
    inertias = [p[f"M{k}_inertia"] + p[f"gearbox{k}_inertia"] for k in (1, 2, 3)]
    T = T_dsl / p["gearbox2_ratio"]
    rates = model.accelerations()
    derived = rates.e * dphi + rates.u * sp.Matrix([Tag1, Tag2, Tag3]) + rates.f * T_dsl
    printed = [-c * dphi + Tag1, i * c * dphi / 2 - T / 2 + Tag2, i * c * dphi / 2 + T / 2 + Tag3]
    for row, (torque, inertia) in enumerate(zip(printed, inertias, strict=True)):
        assert is_zero((derived[row] - torque / inertia).subs(same)), row


@pytest.mark.parametrize("index", [1, 2, 3])
def test_rigid_flange_reads_5_13(geared: ReducedModel, index: int) -> None:
    """Inertia share and feed-through of the air-gap torque included."""
    p, model = symbols(geared), geared.model
    i, c = scaled(p)
    rotor, gears = p[f"M{index}_inertia"], p[f"gearbox{index}_inertia"]
    total, T = rotor + gears, T_dsl / p["gearbox2_ratio"]
    printed = {
        1: rotor / total * c * dphi + gears / total * Tag1,
        2: rotor / total * (i / 2 * c * dphi - T / 2) - gears / total * Tag2,
        3: rotor / total * (i / 2 * c * dphi + T / 2) - gears / total * Tag3,
    }
    form = model.without_acceleration(model.signals[f"flange{index}_torque"])
    derived = (form.e * dphi + form.u * sp.Matrix([Tag1, Tag2, Tag3]) + form.f * T_dsl)[0]
    assert is_zero((derived - printed[index]).subs(symmetry(p)))


def test_bed_for_a_transmission_is_5_15_to_5_18() -> None:
    bed = Bed()
    bed.add("shaft1", "shaft", stiffness=5e4)
    bed.add("gear", "gearbox", ratio=3.5, inertia=0.02)
    bed.add("shaft2", "shaft", stiffness=8e4)
    two = two_machines(["shaft1", "gear", "shaft2"], bed, place="shaft1")
    two.reduction = {"drop": ["gear"]}
    result = reduced(two)
    p = symbols(result)
    c1, c2, i = p["shaft1_stiffness"], p["shaft2_stiffness"], p["gear_ratio"]
    c = c1 * c2 / (i**2 * c1 + c2)
    assert is_zero(result.model.stiffness[0, 0] - c)  # (5.15)
    assert is_zero(result.model.twist_rows - sp.Matrix([[1, -i]]))  # (5.17)
    assert is_zero(result.model.signals["shaft1"].e[0] - c)  # (5.18)

"""The simplified gearboxes against (3.51)-(3.54) and (4.74)-(4.76); their ratios, and what they refuse."""

from __future__ import annotations

import pytest
import sympy as sp
from loose_component import EXAMPLES, case, example, is_zero, loose_model, symbols_of

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.single_clutch_gearbox import SingleClutchGearbox
from ptgen.testbed.problems import validated

T_i, T_o, T_c1, T_c2, w_i, w_o = sp.symbols("T_gbi T_gbo T_c1 T_c2 omega_gbi omega_gbo", real=True)
TYPES = ("single_clutch_gearbox", "double_clutch_gearbox")
CHANGING = {"gears": {"1": 5.503, "2": 3.333}}


def accelerations(type_name: str, **changes: object) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Return the accelerations of input and output, and the slips, in the velocities of both sides."""
    model = loose_model(example(type_name, **changes))
    torques = sp.Matrix([T_c1, T_c2][: len(model.frictions)])
    rates = model.accelerations()
    found = rates.u * sp.Matrix([T_i, -T_o]) + rates.f * torques
    sides = sp.Matrix.vstack(*(model.velocity_rows[f"x.{side}"] for side in ("input", "output")))
    slips = model.friction_rows * sides.inv() * sp.Matrix([w_i, w_o])
    return [*(sides * found)], [*slips]


@pytest.mark.parametrize("changes", [{}, CHANGING], ids=["constant", "changing"])
def test_single_clutch_gearbox_follows_3_51(changes: dict[str, object]) -> None:
    p = symbols_of(example("single_clutch_gearbox"))
    (of_input, of_output), (slip,) = accelerations("single_clutch_gearbox", **changes)
    assert is_zero(p["inertia_input"] * of_input - (T_i - T_c1))
    assert is_zero(p["inertia_output"] * of_output - (p["ratio"] * T_c1 - T_o))
    assert is_zero(slip - (w_i - p["ratio"] * w_o))


@pytest.mark.parametrize("changes", [{}, CHANGING], ids=["constant", "changing"])
def test_double_clutch_gearbox_follows_3_53(changes: dict[str, object]) -> None:
    p = symbols_of(example("double_clutch_gearbox"))
    (of_input, of_output), slips = accelerations("double_clutch_gearbox", **changes)
    assert is_zero(p["inertia_input"] * of_input - (T_i - T_c1 - T_c2))
    assert is_zero(p["inertia_output"] * of_output - (p["ratio1"] * T_c1 + p["ratio2"] * T_c2 - T_o))
    assert is_zero(sp.Matrix(slips) - sp.Matrix([w_i - p["ratio1"] * w_o, w_i - p["ratio2"] * w_o]))


def test_constant_ratios_give_the_states_of_4_74_and_the_equations_4_75() -> None:
    p = symbols_of(example("double_clutch_gearbox"))
    model = loose_model(example("double_clutch_gearbox"))
    assert model.coordinates == ("x.clutch1", "x.clutch2")
    rates = model.accelerations()
    found = rates.u * sp.Matrix([T_i, -T_o]) + rates.f * sp.Matrix([T_c1, T_c2])
    I_i, I_o = p["inertia_input"], p["inertia_output"]
    for row, i in enumerate((p["ratio1"], p["ratio2"])):
        wanted = T_i / I_i + i * T_o / I_o
        wanted -= T_c1 * (1 / I_i + i * p["ratio1"] / I_o) + T_c2 * (1 / I_i + i * p["ratio2"] / I_o)
        assert is_zero(found[row] - wanted)


@pytest.mark.parametrize("type_name", TYPES)
def test_changing_ratios_are_in_no_coordinate(type_name: str) -> None:
    component = example(type_name, **CHANGING)
    model = loose_model(component)
    assert model.coordinates == ("x.input", "x.output")
    assert {p.key: p.span for p in model.changing} == dict.fromkeys(component.ratios, (3.333, 5.503))
    assert {p.owner for p in model.changing} == {"x"}
    changing = {p.symbol for p in model.changing}
    assert not changing & model.mass.free_symbols and changing <= model.friction_rows.free_symbols


@pytest.mark.parametrize(
    ("changes", "span"),
    [
        ({}, None),
        ({"gears": {"2": 3.333}}, None),
        ({"gears": {"2": 3.333, "R": -3.403}}, (-3.403, 3.333)),
        ({"ratio_range": [-4, 6]}, (-4.0, 6.0)),
        ({"ratio_range": [0, 6], "gears": {"2": 3.333}}, (0.0, 6.0)),
    ],
)
def test_the_range_is_that_of_the_gears_unless_it_is_given(changes: dict[str, object], span: object) -> None:
    component = example("single_clutch_gearbox", **changes)
    assert isinstance(component, SingleClutchGearbox)
    assert component.spans().get("ratio") == span
    assert [p.span for p in component.parameters("x") if p.key == "ratio"] == [span]


@pytest.mark.parametrize(
    ("type_name", "changes", "text"),
    [
        ("single_clutch_gearbox", {"ratio": 0}, "must not be 0"),
        ("single_clutch_gearbox", {"ratio_range": [4, 2]}, "must rise"),
        ("single_clutch_gearbox", {"ratio_range": [4, 5]}, "lie in ratio_range, from 4 to 5, got ratio = 3.333"),
        (
            "single_clutch_gearbox",
            {"gears": {"1": 5.503, "3": 2.3}, "ratio": 6},
            "range of the gears, from 2.3 to 5.503, got ratio = 6",
        ),
        ("single_clutch_gearbox", {"gears": {"1": 5.503}, "ratio_range": [3, 5]}, "got gears.1 = 5.503"),
        ("single_clutch_gearbox", {"gears": {}}, "must hold gears"),
        ("single_clutch_gearbox", {"gears": {"N": 1.0}}, "N is neutral"),
        ("single_clutch_gearbox", {"gears": {"1": 0}}, "must not be 0"),
        ("single_clutch_gearbox", {"clutch": None}, "is missing"),
        ("single_clutch_gearbox", {"clutch": {"capacity": "10 N m", "static": "5 N m"}}, "must not be below capacity"),
        ("double_clutch_gearbox", {"ratio2": 7, "gears": {"1": 5.5, "2": 3.3}}, "got ratio1 = 5.503, ratio2 = 7"),
        ("double_clutch_gearbox", {"clutch2": {"capacity": "0 N m"}}, "must be > 0"),
    ],
)
def test_what_cannot_be_is_refused(type_name: str, changes: dict[str, object], text: str) -> None:
    fields = {"type": type_name, **EXAMPLES[type_name], **changes}
    given = {key: value for key, value in fields.items() if value is not None}
    component, problems = validated(CATALOGUE[type_name], given, "components", "gb")
    assert component is None
    assert any(text in f"{problem.what}; {problem.remedy}" for problem in problems), problems
    assert all(problem.where.startswith("components.gb") for problem in problems)


def test_clutches_have_names_of_their_own() -> None:
    assert [f.name for f in case("single_clutch_gearbox").elements("gb").frictions] == ["gb.clutch"]
    two = case("double_clutch_gearbox").elements("gb").frictions
    assert [f.name for f in two] == ["gb.clutch1", "gb.clutch2"]
    assert all(f.actuated for f in two) and two[0].static is not None and two[1].static is None

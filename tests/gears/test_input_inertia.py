"""The inertia at the input: least kinetic energy of all that a gear leaves free."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg
from test_freewheels import TABLE, two_speed

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.gears import Layout, gear_ratios, input_inertia, layout_of_part
from ptgen.gears.combinations import combinations
from ptgen.gears.freewheels import with_freewheels
from ptgen.testbed.parts import read_part, shipped_parts


def clutch(**more: object) -> Component:
    values = {"capacity": "1 N m", "inertia_input": "2 kg m^2", "inertia_output": "3 kg m^2", **more}
    return CATALOGUE["clutch"].model_validate({"type": "clutch", **values})


def in_floats(layout: Layout, engaged: tuple[str, ...]) -> float:
    """Return the inertia by least squares over the null space of all rows."""
    rows = [layout.train_vector(train) for train in layout.trains]
    rows += [layout.element_vector(element) for element in layout.elements if element.name in engaged]
    N = scipy.linalg.null_space(np.array(rows, float), rcond=1e-9)
    root = np.sqrt([float(layout.inertias.get(member, 0)) for member in layout.members])
    row = N[layout.members.index(layout.input)]
    start, free = row / (row @ row), scipy.linalg.null_space(row[None])
    weighted = root[:, None] * N
    rest = np.linalg.lstsq(weighted @ free, -weighted @ start, rcond=None)[0] if free.size else np.zeros(0)
    return float(np.sum((weighted @ (start + free @ rest)) ** 2))


@pytest.mark.parametrize("part", sorted(shipped_parts()))
def test_same_as_in_floats(part: str) -> None:
    component = read_part(shipped_parts()[part]).model_validate({"type": "part", "file": part})
    layout = layout_of_part(component)
    table = component.gear_elements()
    for gear in gear_ratios(layout, table):
        found = with_freewheels(layout, combinations(layout), table[gear])
        assert found is not None
        assert input_inertia(layout, table[gear]) == pytest.approx(in_floats(layout, found.engaged), rel=1e-12)
    assert input_inertia(layout, []) == 0.0, "nothing ties the output to the input"


def test_engaged_clutch_is_one_shaft() -> None:
    layout = layout_of_part(clutch())
    assert layout.element_names == ("part",)
    assert input_inertia(layout, ["part"]) == 5.0
    assert input_inertia(layout, []) == 0.0


def test_inertia_behind_a_ratio_is_referred_to_the_input() -> None:
    layout = layout_of_part(clutch())
    assert input_inertia(layout, [], 2.0) == 2.0 + 3.0 / 2.0**2
    assert input_inertia(layout, ["part"], 2.0) == 5.0, "what is engaged goes before"


def test_ratio_that_changes_is_what_it_is_now() -> None:
    table = {"1": 5.5, "R": -3.4}
    gearbox = CATALOGUE["double_clutch_gearbox"].model_validate(
        {
            "type": "double_clutch_gearbox",
            "inertia_input": "0.13 kg m^2",
            "inertia_output": "0.4 kg m^2",
            "ratio1": 5.5,
            "ratio2": 3.3,
            "gears": table,
            "clutch1": {"capacity": "600 N m"},
            "clutch2": {"capacity": "600 N m"},
        }
    )
    for gear, elements in gearbox.gear_elements().items():
        layout = layout_of_part(gearbox, ratio=table[gear])
        assert gear_ratios(layout, {gear: elements}) == {gear: pytest.approx(table[gear], rel=1e-15)}
        assert input_inertia(layout, elements) == pytest.approx(0.13 + 0.4 / table[gear] ** 2, rel=1e-15)


def test_freewheels_lock_what_turns_with_the_input() -> None:
    layout = two_speed()
    layout = Layout(**{**vars(layout), "inertias": {"output": 9, "sun": 2}})
    assert input_inertia(layout, TABLE["1"]) == 2.0 + 9.0 / 3.0**2
    assert input_inertia(layout, TABLE["2"]) == 2.0 + 9.0

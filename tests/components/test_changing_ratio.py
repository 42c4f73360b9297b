"""A gearbox whose ratio changes at run time: what it says of itself."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from ptgen.components.gearbox import Gearbox


def gearbox(**fields: object) -> Gearbox:
    return Gearbox.model_validate({"type": "gearbox", "ratio": 2.0, "inertia": "0.02 kg m^2", **fields})


@pytest.mark.parametrize("span", [(0.5, 4.0), (2.0, 4.0), (1, 2)])
def test_its_ratio_is_marked_as_changing(span: tuple[float, float]) -> None:
    parameters = {parameter.symbol.name: parameter for parameter in gearbox(ratio_range=span).parameters("box")}
    assert parameters["box_ratio"].span == tuple(map(float, span))
    assert parameters["box_ratio"].value == 2.0
    assert parameters["box_inertia"].span is None


def test_without_a_range_nothing_changes() -> None:
    assert all(parameter.span is None for parameter in gearbox().parameters("box"))


@pytest.mark.parametrize(
    ("fields", "text"),
    [
        ({"ratio_range": [4.0, 0.5]}, "must rise"),
        ({"ratio_range": [2.0, 2.0]}, "must rise"),
        ({"ratio_range": [-1.0, 3.0]}, "must not hold 0"),
        ({"ratio_range": [0.0, 3.0]}, "must not"),
        ({"ratio_range": [3.0, 4.0]}, "must lie in ratio_range"),
        ({"ratio_range": [-4.0, -1.0]}, "must lie in ratio_range"),
        ({"ratio_range": [1.0, 4.0], "inertia_other": "0.1 kg m^2"}, "mesh_stiffness"),
    ],
)
def test_a_range_that_cannot_be(fields: dict[str, object], text: str) -> None:
    with pytest.raises(ValidationError, match=text):
        gearbox(**fields)


def test_negative_ratios_stay_negative() -> None:
    assert gearbox(ratio=-2.0, ratio_range=[-3.0, -1.0]).ratio_range == (-3.0, -1.0)


def test_elastic_teeth_allow_an_inertia_on_either_side() -> None:
    fields = {"ratio_range": [1.0, 4.0], "inertia_other": "0.1 kg m^2", "mesh_stiffness": "800 kN m/rad"}
    assert gearbox(**fields).inertia_other == 0.1

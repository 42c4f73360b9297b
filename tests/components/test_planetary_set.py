"""The planetary set against the printed equations of motion (3.47)-(3.49), and double pinions against two meshes."""

from __future__ import annotations

import pytest
import sympy as sp
from loose_component import example, loose_model
from pydantic import ValidationError


def test_accelerations_are_those_of_3_47() -> None:
    """Lagrange's equations in carrier and planet, with I_c, I_r, I_s, I_p as the source has them."""
    model = loose_model(example("planetary_set", loss=None))
    values = {symbol.name: value for symbol, value in model.values.items()}
    g = values["x_ratio"]
    inertias = [values[f"x_inertia_{part}"] for part in ("carrier", "ring", "sun", "planets")]
    rp_rr, rp_rs = (1 - 1 / g) / 2, (g - 1) / 2
    # omega_r = omega_c + r_p/r_r omega_p, omega_s = omega_c - r_p/r_s omega_p (3.50); the planets turn with omega_p.
    follow = sp.Matrix([[1, 0], [1, rp_rr], [1, -rp_rs], [0, 1]])
    mass = follow.T * sp.diag(*inertias) * follow
    names = ("x.carrier", "x.ring", "x.sun", "x.planets")
    numeric = sp.Matrix.vstack(*(model.velocity_rows[name] for name in names)).subs(model.values)
    change = (follow.T * follow).inv() * follow.T * numeric
    assert (follow * change - numeric).norm() < 1e-12, "both move alike"
    assert (change.T * mass * change - model.mass.subs(model.values)).norm() < 1e-12


@pytest.mark.parametrize("pinions", ["single", "double"])
def test_standing_flanges_give_the_three_basic_ratios(pinions: str) -> None:
    component = example("planetary_set", pinions=pinions, inertia_planets=None, loss=None, ratio=2.5)
    (constraint,) = component.elements("x").constraints
    values = {p.symbol: p.value for p in component.parameters("x")}
    sun, ring, carrier = (
        float(sp.sympify(constraint.row[f"x.{part}"]).subs(values)) for part in ("sun", "ring", "carrier")
    )
    sense = -1 if pinions == "single" else 1
    assert -ring / sun == pytest.approx(sense * 2.5), "sun over ring, carrier standing"
    assert -carrier / sun == pytest.approx(3.5 if pinions == "single" else -1.5), "sun over carrier, ring standing"
    assert sun + ring + carrier == pytest.approx(0), "it can turn as one block"


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"ratio": None}, "needs its ratio"),
        ({"teeth": {"sun": 40, "ring": 90}}, "teeth and ratio, which differ"),
        ({"ratio": None, "teeth": {"sun": 90, "ring": 40}}, "ring must be larger"),
        ({"loss": {"load": 1.0}}, "load must be below 1"),
        ({"pinions": "double"}, "inertia_planets is for single pinions"),
        ({"ratio": None, "teeth": {"sun": 40.5, "ring": 90}}, "integer"),
        ({"teeth": {"sun": 40, "ring": 90, "planet": 25}}, "extra|Extra"),
    ],
)
def test_contradictions_are_refused(changes: dict[str, object], text: str) -> None:
    with pytest.raises(ValidationError, match=text):
        example("planetary_set", **changes)


def test_dogs_must_hold_more_than_the_cone() -> None:
    with pytest.raises(ValidationError, match="dog must not be below cone"):
        example("synchroniser", dog="20 N m")

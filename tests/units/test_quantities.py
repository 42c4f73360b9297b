"""Quantities at the border: conversions, dimensions, and texts that are none."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ptgen.units import QuantityError, from_si, parse, wanted_units


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("380 kN m/rad", "N m/rad", 380e3),
        ("6000 rpm", "rad/s", 200 * math.pi),
        ("5 Hz", "rad/s", 10 * math.pi),
        ("30 rad/s", "rad/s", 30.0),
        ("100 us", "s", 1e-4),
        ("100 µs", "s", 1e-4),
        ("5ms", "s", 5e-3),
        ("1 kg m^2", "kg m^2", 1.0),
        ("1 kg·m²", "kg m^2", 1.0),
        ("1 kg m**2", "kg m^2", 1.0),
        ("90 deg", "rad", math.pi / 2),
        ("1 N m/deg", "N m/rad", 180 / math.pi),
        ("1_000 N m", "N m", 1000.0),
        ("-3 kN m", "N m", -3000.0),
        ("50 %", "", 0.5),
        ("0.5", "", 0.5),
        (3, "", 3.0),
        ("1 ft lbf", "N m", 0.3048 * 4.4482216152605),
        ("2 kW", "W", 2000.0),
    ],
)
def test_conversion(text: object, unit: str, value: float) -> None:
    assert parse(text, unit) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("3 N m", "N m/rad"),  # a torque is no stiffness: the angle counts
        ("3 N m/rad", "N m"),
        ("3 s", "rad/s"),
        ("3 kg", "kg m^2"),
        ("3", "s"),
        (3, "s"),
        (True, ""),
        (None, "s"),
        ([1], "s"),
        ("nan s", "s"),
        ("inf s", "s"),
        ("1e999 s", "s"),
        (math.inf, ""),
        (10**400, ""),
        ("fast", "s"),
        ("", "s"),
        ("3 furlong", "m"),
        ("3 m**9**9**9", "m"),
        ("3 __import__('os')", "m"),
    ],
)
def test_refusal_says_what_is_wanted(text: object, unit: str) -> None:
    with pytest.raises(QuantityError) as caught:
        parse(text, unit)
    assert wanted_units(unit) in str(caught.value) or "finite" in str(caught.value)


@given(
    value=st.floats(-1e12, 1e12),
    pair=st.sampled_from([("rad/s", "rpm"), ("N m", "kN m"), ("s", "ms"), ("rad", "deg"), ("N m/rad", "kN m/rad")]),
)
def test_there_and_back(value: float, pair: tuple[str, str]) -> None:
    unit, shown = pair
    assert parse(f"{from_si(value, unit, shown)!r} {shown}", unit) == pytest.approx(value, rel=1e-13, abs=1e-300)


@given(st.text(max_size=30))
def test_any_text_is_read_or_refused(text: str) -> None:
    """Nothing but `QuantityError` ever comes out, and what is read is finite."""
    try:
        value = parse(text, "N m")
    except QuantityError:
        return
    assert math.isfinite(value)

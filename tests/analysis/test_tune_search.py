"""The search for the largest shares that hold: closed forms, holes, and what it promises of any answer."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ptgen.analysis.wish_search import LEAST, RESOLUTION, find_shares

limits = st.floats(1.2 * LEAST, 3.0)


@given(st.lists(limits, min_size=1, max_size=3))
def test_independent_limits_are_found(limit: list[float]) -> None:
    found = find_shares(lambda shares: all(s <= m for s, m in zip(shares, limit, strict=True)), len(limit))
    assert found.shares is not None and found.is_robust
    for share, most in zip(found.shares, limit, strict=True):
        assert share == 1.0 if most >= 1 else most / RESOLUTION**2 < share <= most
    above = [k for k, most in enumerate(limit) if most < 1]
    if len(above) == 1:
        assert found.alone[above[0]] == pytest.approx(limit[above[0]], rel=0.02)
    elif above:
        assert found.alone == (None,) * len(limit)  # none of them alone is enough


@given(st.floats(0.05, 0.9))
def test_wishes_share_what_they_both_need(most: float) -> None:
    found = find_shares(lambda shares: shares[0] * shares[1] <= most, 3)
    assert found.shares is not None
    assert found.shares[2] == 1.0
    np.testing.assert_allclose(found.shares[:2], np.sqrt(most), rtol=0.02)
    assert found.alone[:2] == pytest.approx((most, most), rel=0.02) and found.alone[2] is None


@given(st.lists(st.tuples(st.floats(LEAST, 1.0), st.floats(0.0, 0.9)), max_size=4), st.floats(LEAST, 1.0))
def test_answers_hold_whatever_holes_there_are(holes: list[tuple[float, float]], most: float) -> None:
    """Loops may need some gain: the shares that hold are no interval from zero on."""
    asked = []

    def holds(shares: tuple[float, ...]) -> bool:
        asked.append(shares)
        return shares[0] <= most and not any(low * top < shares[0] < top for top, low in holes)

    found = find_shares(holds, 1)
    assert all(0 < share[0] <= 1.0 for share in asked)
    if found.shares is not None:
        assert holds(found.shares)
        if found.is_robust and found.shares[0] < 1.0:
            assert holds((0.95 * found.shares[0],)) and holds((0.9 * found.shares[0],))


def test_too_little_may_be_as_bad_as_too_much() -> None:
    found = find_shares(lambda shares: 0.1 <= shares[0] <= 0.4, 2)
    assert found.shares is not None and found.shares[1] == 1.0
    assert found.shares[0] == pytest.approx(0.4, rel=0.02)


def test_a_ratio_that_must_be_kept_needs_the_grid() -> None:
    def holds(shares: tuple[float, ...]) -> bool:
        return shares[0] < 0.5 and shares[1] < 0.04 * shares[0]

    found = find_shares(holds, 2)
    assert found.common is None and found.shares is not None
    assert found.shares[0] == pytest.approx(0.5, rel=0.03) and found.shares[1] == pytest.approx(0.02, rel=0.03)


def test_nothing_is_found_where_nothing_holds() -> None:
    found = find_shares(lambda shares: False, 2)
    assert found.shares is None and found.alone == (None, None) and not found.is_robust


def test_progress_goes_on() -> None:
    seen: list[float] = []
    find_shares(lambda shares: shares[0] < 0.3 and shares[1] < 0.5, 3, seen.append)
    assert seen == sorted(seen) and seen[0] > 0 and seen[-1] <= 1

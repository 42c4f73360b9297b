"""What the tests of test bed files share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from small_bed import BED, Bench


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path)


@pytest.fixture
def change() -> Callable[..., str]:
    """Return the small bed with one text replaced by another."""

    def changed(old: str, new: str) -> str:
        assert BED.count(old) >= 1, old
        return BED.replace(old, new, 1)

    return changed

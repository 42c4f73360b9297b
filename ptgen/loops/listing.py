"""Names as a sentence has them."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["listed"]


def listed(names: Sequence[str]) -> str:
    """Return names with commas, and "and" before the last one.

    Examples
    --------
    >>> listed(["M1", "M2", "M3"])
    'M1, M2 and M3'
    """
    return " and ".join([*filter(None, [", ".join(names[:-1])]), *names[-1:]])

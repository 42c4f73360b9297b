"""Quantities in the units that people read: rpm, kN m/rad, ms."""

from __future__ import annotations

from ptgen.units import from_si

__all__ = ["percent", "readable", "shown_unit"]

# SI unit -> (least size for it, unit shown), the largest first.
_SCALES: dict[str, tuple[tuple[float, str], ...]] = {
    "rad/s": ((0.0, "rpm"),),
    "N m": ((10e3, "kN m"), (0.0, "N m")),
    "N m/rad": ((1e3, "kN m/rad"), (0.0, "N m/rad")),
    "rad": ((0.0, "deg"),),
    "s": ((1.0, "s"), (1e-3, "ms"), (0.0, "us")),
}


def shown_unit(size: float, unit: str) -> str:
    """Return the unit in which quantities up to `size`, given in the SI unit `unit`, are shown.

    Examples
    --------
    >>> shown_unit(38e4, "N m/rad")
    'kN m/rad'
    """
    return next((shown for least, shown in _SCALES.get(unit, ()) if abs(size) >= least), unit)


def readable(value: float, unit: str, digits: int = 5) -> str:
    """Return a quantity as people write it.

    Parameters
    ----------
    value : float
        The value in SI units.
    unit : str
        The SI unit; empty for plain numbers.
    digits : int
        Significant digits.

    Examples
    --------
    >>> readable(699.946843, "rad/s")
    '6684 rpm'
    >>> readable(380e3, "N m/rad"), readable(1e-4, "s"), readable(0.0, "s")
    ('380 kN m/rad', '100 us', '0 s')
    """
    shown = shown_unit(value, unit) if value else {"rad/s": "rpm", "rad": "deg"}.get(unit, unit)
    number = value if shown == unit else from_si(value, unit, shown)
    return f"{number:.{digits}g} {shown}".strip()


def percent(share: float) -> str:
    """Return a share in percent; what is too small to matter is zero.

    Examples
    --------
    >>> percent(0.0173645), percent(1.267), percent(-1e-16)
    ('1.74 %', '127 %', '0 %')
    """
    return f"{100 * share if abs(share) > 1e-7 else 0:.3g} %"

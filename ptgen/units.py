"""Units at the border: the only module that knows any.

Inside ptgen every number is in SI units and radians. The registry treats the angle as a dimension of its
own, so that a stiffness (N m/rad) and a torque (N m) cannot be mistaken for each other.
"""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import Any

import pint

__all__ = ["QuantityError", "from_si", "parse", "rounded_down", "unit_of", "wanted_units"]

_DEFINITIONS = """
tera- = 1e12 = T-
giga- = 1e9 = G-
mega- = 1e6 = M-
kilo- = 1e3 = k-
centi- = 1e-2 = c-
milli- = 1e-3 = m-
micro- = 1e-6 = µ- = μ- = u-
nano- = 1e-9 = n-
meter = [length] = m = metre
second = [time] = s = sec
gram = [mass] = g
radian = [angle] = rad
kelvin = [temperature] = K
minute = 60 * second = min
hour = 60 * minute = h = hr
degree = 3.141592653589793 / 180 * radian = deg = °
revolution = 2 * 3.141592653589793 * radian = rev = turn
rpm = revolution / minute
hertz = 1 / second = Hz
newton = kilogram * meter / second ** 2 = N
joule = newton * meter = J
watt = joule / second = W
pound = 0.45359237 * kilogram = lb
inch = 0.0254 * meter = in
foot = 12 * inch = ft
pound_force = 4.4482216152605 * newton = lbf
percent = 0.01 = %
"""

# The SI unit in which a quantity is held -> the units that people write for it.
_EXAMPLES = {
    "": "a plain number",
    "kg m^2": "kg m^2",
    "N m/rad": "N m/rad or kN m/rad",
    "N m s/rad": "N m s/rad",
    "N m": "N m or kN m",
    "rad/s": "rpm or rad/s",
    "rad/s^2": "rad/s^2 or rpm/s",
    "N m/s": "N m/s or kN m/s",
    "s": "s, ms or us",
    "rad": "rad or deg",
    "m": "m or mm",
    "W": "W or kW",
    "1/s": "1/s",
}


class QuantityError(ValueError):
    """A text is no quantity of the wanted dimension; the message says what is wanted."""


@lru_cache(maxsize=1)
def _registry() -> Any:
    registry: Any = pint.UnitRegistry(None, cache_folder=None)
    registry.load_definitions(_DEFINITIONS.strip().splitlines())
    return registry


# Superscripts become "^2". What pint would compute for ever, such as "9**9**9**9", is no unit of a test bed.
_SUPERSCRIPTS = str.maketrans({"⁻": "^-", "¹": "1", "²": "^2", "³": "^3", "·": "*"})
_UNIT_TEXT = re.compile(r"[A-Za-z0-9_°%µμ\s*/^.()+-]{0,60}", re.ASCII)
_TOWER = re.compile(r"(\*\*|\^)\s*[-+]?\s*(\d\s*(\*\*|\^|\d)|[^-+\s\d])|\)\s*(\*\*|\^)")


@lru_cache(maxsize=512)
def _unit(text: str) -> Any:
    text = text.translate(_SUPERSCRIPTS).replace("^-^", "^-")
    if not _UNIT_TEXT.fullmatch(text) or _TOWER.search(text):
        raise ValueError(text)
    return _registry().parse_units(text)


def wanted_units(unit: str) -> str:
    """Return in words how a quantity held in `unit` is written."""
    return _EXAMPLES.get(unit, unit)


def parse(text: object, unit: str) -> float:
    """Convert a quantity such as ``"380 kN m/rad"`` to a number in `unit`.

    Parameters
    ----------
    text : object
        What stands in the file: a string with number and unit, or a number if `unit` is empty.
    unit : str
        The SI unit wanted, e.g. ``"N m/rad"``.

    Raises
    ------
    QuantityError
        If the text is no number with a unit of that dimension, or is not finite.

    Examples
    --------
    >>> parse("380 kN m/rad", "N m/rad")
    380000.0
    >>> round(parse("6684 rpm", "rad/s"), 3)
    699.947
    """
    wanted = wanted_units(unit)
    if isinstance(text, bool) or not isinstance(text, (str, int, float)):
        raise QuantityError(f"must be a quantity in {wanted}, got {text!r}")
    if isinstance(text, (int, float)):
        if unit:
            raise QuantityError(f'must be a string with its unit ({wanted}), such as "{text} {unit}", got {text}')
        try:
            return _finite(float(text), text)
        except OverflowError:  # a whole number of more than 308 digits
            raise QuantityError(f"must be a finite number in {wanted}") from None
    words = text.strip().split(maxsplit=1)
    try:
        magnitude = float(words[0].replace("_", ""))
        rest = words[1] if len(words) == 2 else ""
    except (ValueError, IndexError):
        number, rest = _split_glued(text)
        if number is None:
            raise QuantityError(f"must be a number with its unit ({wanted}), got {text!r}") from None
        magnitude = number
    _finite(magnitude, text)
    try:
        got = _unit(rest)
        target = _unit(unit)
        if unit == "rad/s" and got.dimensionality == _unit("1/s").dimensionality and "Hz" in rest:
            return _finite(float(_registry().Quantity(magnitude, got).to("1/s").magnitude) * 2 * math.pi, text)
        if got.dimensionality != target.dimensionality:
            raise QuantityError(f"must be in {wanted}, got {text!r}, which has another dimension")
        converted = float(_registry().Quantity(magnitude, got).to(target).magnitude)
        return _finite(float(f"{converted:.15g}"), text)  # so that "100 us" is 1e-4 and not its neighbour
    except QuantityError:
        raise
    except Exception as error:
        raise QuantityError(f"must be in {wanted}, got {text!r}, whose unit is not understood") from error


def from_si(value: float, unit: str, shown: str) -> float:
    """Convert `value` from the SI unit `unit` to the unit `shown`.

    Examples
    --------
    >>> round(from_si(104.7198, "rad/s", "rpm"))
    1000
    """
    return float(_registry().Quantity(value, _unit(unit)).to(_unit(shown)).magnitude)


def unit_of(text: str) -> str:
    """Return the unit of a quantity as it is written there.

    Examples
    --------
    >>> unit_of("5 Hz"), unit_of("300us"), unit_of("0.5")
    ('Hz', 'us', '')
    """
    return _split_glued(text.replace("_", ""))[1].strip()


def rounded_down(value: float, unit: str, shown: str, digits: int = 3) -> str:
    """Return a positive quantity in the unit `shown`, rounded down, as `parse` reads it.

    Parameters
    ----------
    value : float
        In the SI unit `unit`.
    unit, shown : str
    digits : int
        Significant digits.

    Examples
    --------
    >>> rounded_down(31.4155, "rad/s", "Hz"), rounded_down(0.0299999, "s", "ms"), rounded_down(0.7, "", "%")
    ('4.99 Hz', '29.9 ms', '70 %')
    """
    number = value / parse(f"1 {shown}" if shown else 1, unit)
    places = digits - 1 - math.floor(math.log10(number) + 1e-12)
    scaled = math.floor(number * 10.0**places * (1 + 1e-12))
    text = str(scaled * 10**-places) if places <= 0 else f"{scaled / 10.0**places:.{places}f}".rstrip("0").rstrip(".")
    return f"{text} {shown}".strip()


def _finite(value: float, text: object) -> float:
    if not math.isfinite(value):
        raise QuantityError(f"must be a finite number, got {text!r}")
    return value


def _split_glued(text: str) -> tuple[float | None, str]:
    """Split a number that is glued to its unit, as in ``"5ms"``."""
    text = text.strip()
    for length in range(len(text), 0, -1):
        try:
            return float(text[:length]), text[length:]
        except ValueError:
            continue
    return None, text

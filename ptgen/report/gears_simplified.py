"""Simplified gearboxes of a gear set: tables of a bed file to paste, and as plain data."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import asdict
from typing import Any

from ptgen.gears.simplified import SimplifiedClutch, SimplifiedGearbox

__all__ = ["simplified_json", "simplified_tables", "simplified_text"]


def simplified_tables(box: SimplifiedGearbox) -> dict[str, dict[str, Any]]:
    """Return the component of model I and, for two gears, that of model II, as tables of a bed file.

    Parameters
    ----------
    box : SimplifiedGearbox

    Returns
    -------
    dict of str to dict
        Type of the component -> its table.
    """
    own: dict[str, Any] = {
        "inertia_input": f"{box.inertia_input!r} kg m^2",
        "inertia_output": f"{box.inertia_output!r} kg m^2",
    }
    gears = {clutch.gear: clutch.ratio for clutch in box.clutches}
    if all(name.isalnum() for name in gears):
        own["gears"] = gears
    ratio = {"ratio": box.clutches[0].ratio}
    tables = {"single_clutch_gearbox": {**ratio, **own, "clutch": _law(box.strongest)}}
    if len(box.clutches) > 1:
        ratios = {f"ratio{number}": clutch.ratio for number, clutch in enumerate(box.clutches, 1)}
        laws = {f"clutch{number}": _law(clutch) for number, clutch in enumerate(box.clutches, 1)}
        tables["double_clutch_gearbox"] = {**ratios, **own, **laws}
    return {name: {"type": name, **table} for name, table in tables.items()}


def simplified_text(box: SimplifiedGearbox, name: str) -> Iterator[str]:
    """Yield the tables of both models as TOML, with what they stand for and leave out as comments.

    Parameters
    ----------
    box : SimplifiedGearbox
    name : str
        What the component is to be called.
    """
    gears = " and ".join(clutch.gear for clutch in box.clutches)
    yield f"# {box.title}: gear{'s' if len(box.clutches) > 1 else ''} {gears} as simplified gearbox, (3.51)-(3.54)"
    m11, m12, m22 = box.masses
    engaged = ", ".join(box.locked) or "nothing"
    yield f"# with {engaged} engaged: m11 = {m11:.6g}, m12 = {m12:.6g}, m22 = {m22:.6g} kg m^2"
    for clutch in box.clutches:
        error = "" if abs(clutch.inertia_error) < 1e-12 else f", of the models {100 * clutch.inertia_error:+.2g} %"
        yield (
            f"# gear {clutch.gear}: {clutch.element} slips with {clutch.factor:.6g} (w_in - {clutch.ratio:.6g} w_out); "
            f"inertia at the output {clutch.inertia:.6g} kg m^2{error}"
        )
    for sentence in _left_out(box):
        yield f"# {sentence}"
    for model, (_, table) in zip(("I", "II"), simplified_tables(box).items(), strict=False):
        yield ""
        yield f"[components.{name}]{' ' * max(1, 33 - 13 - len(name))}# model {model}"
        yield from (f"{key} = {_toml(value)}" for key, value in table.items())


def simplified_json(box: SimplifiedGearbox) -> dict[str, Any]:
    """Return everything about the simplified gearboxes, with the tables of both under ``components``."""
    return {
        "title": box.title,
        "locked": list(box.locked),
        "masses": dict(zip(("m11", "m12", "m22"), box.masses, strict=True)),
        "inertia_input": box.inertia_input,
        "inertia_output": box.inertia_output,
        "exact": box.is_exact,
        "own_motions": box.own_motions,
        "clutches": [asdict(clutch) for clutch in box.clutches],
        "left_out": list(_left_out(box)),
        "components": simplified_tables(box),
    }


def _left_out(box: SimplifiedGearbox) -> Iterator[str]:
    m11, m12, _ = box.masses
    slipping = "both clutches slip" if len(box.clutches) > 1 else "the clutch slips"
    if m12:
        yield (
            f"left out: the coupling of input and output while {slipping}; the inertia at the input with the output "
            f"at rest is {m11:.4g} kg m^2 then, that of the models {box.inertia_input:.4g}"
        )
    if not box.is_exact:
        yield "two positive inertias cannot be exact in both gears; the relative errors have least squares"
    if box.own_motions:
        what = "1 motion" if box.own_motions == 1 else f"{box.own_motions} motions"
        yield f"left out: {what} of members that neither input nor output holds; they follow without torque"
    if box.losses:
        yield f"left out: the losses {', '.join(box.losses)}"
    if box.locked:
        yield f"left out: that {', '.join(box.locked)} can slip"
    if len(box.clutches) > 1:
        strong = box.strongest
        (weak,) = (clutch for clutch in box.clutches if clutch is not strong)
        share = weak.capacity / strong.capacity
        yield f"model I has the clutch of gear {strong.gear}; in gear {weak.gear} it is actuated by {share:.6g}"


def _law(clutch: SimplifiedClutch) -> dict[str, str]:
    law = {"capacity": f"{clutch.capacity!r} N m"}
    if clutch.static is not None:
        law["static"] = f"{clutch.static!r} N m"
    if clutch.stribeck_speed is not None:
        law["stribeck_speed"] = f"{clutch.stribeck_speed!r} rad/s"
    if clutch.viscous:
        law["viscous"] = f"{clutch.viscous!r} N m s/rad"
    return law


def _toml(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_toml(entry)}" for key, entry in value.items()) + " }"
    return f'"{value}"' if isinstance(value, str) else repr(value)

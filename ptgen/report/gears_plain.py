"""The analysis of a gear set as plain data: what the command line prints as JSON."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from ptgen.gears.analysis import GearAnalysis
from ptgen.gears.changes import Change
from ptgen.gears.gear import Gear
from ptgen.gears.layout import Layout
from ptgen.gears.speeds import Speed
from ptgen.gears.statics import Balance
from ptgen.report.gears_words import findings

__all__ = ["gear_json", "gears_json"]


def gears_json(found: GearAnalysis) -> dict[str, Any]:
    """Return everything about a gear set; speeds, torques and powers are per unit of those of the input."""
    makes = {engaged: gear.name for gear in found.gears for engaged in gear.alternatives}
    return {
        "title": found.layout.title,
        **_layout(found.layout),
        "combinations": [
            {
                "engaged": list(one.engaged),
                "degrees_of_freedom": one.degrees_of_freedom,
                "state": one.state.value,
                "gear": makes.get(one.engaged),
                "ratio": None if one.ratio is None else float(one.ratio),
                "blocked": list(one.blocked),
                "redundant": list(one.redundant),
            }
            for one in found.combinations
        ],
        "neutral": None if found.neutral is None else list(found.neutral),
        "gears": [gear_json(gear) for gear in found.gears],
        "forward": [gear.name for gear in found.forward],
        "steps": dict(found.steps),
        "spread": found.spread,
        "changes": [_change(change) for change in found.changes],
        "findings": list(findings(found)),
    }


def gear_json(gear: Gear) -> dict[str, Any]:
    """Return everything about one gear."""
    return {
        "name": gear.name,
        "named": gear.named,
        "engaged": list(gear.engaged),
        "needed": list(gear.needed),
        "idle": list(gear.idle),
        "alternatives": [list(way) for way in gear.alternatives],
        "degrees_of_freedom": gear.degrees_of_freedom,
        "ratio": float(gear.ratio),
        "ratio_exact": str(gear.ratio),
        "formula": _text(gear.formula),
        "speeds": _speeds(gear.speeds),
        "slips": _speeds(gear.slips),
        "ideal": _balance(gear.ideal),
        "drive": _balance(gear.drive),
        "coast": _balance(gear.coast),
        "overruns": list(gear.overruns),
    }


def _layout(layout: Layout) -> dict[str, Any]:
    return {
        "input": layout.input,
        "output": layout.output,
        "members": {member: list(flanges) for member, flanges in layout.flanges.items()},
        "trains": [
            {
                "name": train.name,
                "kind": train.kind.value,
                "members": dict(train.members),
                "coefficients": {flange: _text(entry) for flange, entry in train.coefficients.items()},
                "symbol": None if train.symbol is None else train.symbol.name,
                "ratio": float(train.ratio),
                "ratio_exact": str(train.ratio),
                "loss": None if train.loss is None else train.loss.coefficient,
            }
            for train in layout.trains
        ],
        "elements": {
            element.name: {member: float(factor) for member, factor in element.row.items()}
            for element in layout.elements
        },
    }


def _text(expression: sp.Expr | None) -> str | None:
    return None if expression is None else str(sp.sstr(expression))


def _speeds(speeds: Mapping[str, Speed]) -> dict[str, Any]:
    return {
        name: {"value": None if speed.value is None else float(speed.value), "formula": _text(speed.formula)}
        for name, speed in speeds.items()
    }


def _balance(one: Balance | None) -> dict[str, Any] | None:
    if one is None:
        return None
    return {
        "input_torque": one.input_torque,
        "output_torque": one.output_torque,
        "elements": dict(one.elements),
        "trains": {
            name: {
                "torques": dict(load.torques),
                "powers": dict(load.powers),
                "rolling_power": load.rolling_power,
            }
            for name, load in one.trains.items()
        },
        "efficiency": one.efficiency,
        "consistent_patterns": one.consistent,
        "undetermined": list(one.undetermined),
        "recirculating": one.recirculating,
        "circle": list(one.circle),
    }


def _change(change: Change) -> dict[str, Any]:
    return {
        "from": change.start,
        "to": change.end,
        "single": change.is_single,
        "release": list(change.release),
        "apply": list(change.apply),
        "before": {"release": list(change.before.release), "apply": list(change.before.apply)},
        "after": {"release": list(change.after.release), "apply": list(change.after.apply)},
    }

r"""The bed as control sees it: each component of ``reduction.as_ratio`` is a ratio that changes at run time.

It takes the place of a transmission (5.14): the same name and the same flanges, no friction elements,

.. math:: \omega_{gbi} = i_{gb}\,\omega_{gbo}, \qquad T_{gbo} = i_{gb}\,T_{gbi} \qquad (5.14)

with the ratio as an input ``<name>_ratio`` of the controller. What turns with the input in the gear that control is
designed in stays as an inertia there, so that the reduction, which drops it, can tell how much that matters.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Any

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.component import Component
from ptgen.errors import ModelError, Problem
from ptgen.gears import input_inertia, layout_of_part
from ptgen.mechanism.applied_rules import AppliedRule
from ptgen.mechanism.model import Model
from ptgen.mechanism.modes import modes
from ptgen.testbed.gear_tables import GearTable
from ptgen.testbed.testbed import Testbed

__all__ = ["as_ratio_rules", "control_bed"]


def control_bed(testbed: Testbed) -> Testbed:
    """Return the bed with the components of ``reduction.as_ratio`` replaced; the bed itself if there are none.

    Raises
    ------
    ModelError
        If a component has no inertia that turns with its input.
    """
    tables = testbed.gear_tables
    if not tables:
        return testbed
    problems = []
    components = dict(testbed.components)
    for name, table in tables.items():
        inertia = _inertia(testbed.components[name], table)
        if inertia > 0:
            components[name] = _gearbox(table, inertia)
            continue
        what = f'"{name}" has no inertia that turns with its input in gear {table.design}'
        problems.append(Problem(f"components.{name}", what, "give it one, however small"))
    if problems:
        raise ModelError(problems, testbed.file)
    kept = testbed.reduction.keep
    drop = dict.fromkeys([*testbed.reduction.drop, *(name for name in tables if name not in kept)])
    reduction = testbed.reduction.model_copy(
        update={
            "drop": tuple(drop),
            "as_ratio": (),
            "gear_ratios": {name: dict(table.gears) for name, table in tables.items()},
            "design_gear": {},
        }
    )
    return replace(testbed, components=components, reduction=reduction)


def _inertia(component: Component, table: GearTable) -> float:
    elements = component.gear_elements().get(table.design, ())
    inertia = input_inertia(layout_of_part(component, ratio=table.ratio), elements, table.ratio)
    return float(f"{inertia:.6g}")


def _gearbox(table: GearTable, inertia: float) -> Component:
    """Return a gearbox with that ratio; its range may span zero, which no gearbox that transmits could pass."""
    values: dict[str, Any] = {
        "type": "gearbox",
        "inertia_side": "input",
        "ratio": table.ratio,
        "ratio_range": table.span,
        "inertia": inertia,
    }
    return CATALOGUE["gearbox"].model_construct(**values)


def as_ratio_rules(testbed: Testbed, plant: Model, control: Model, locked: Collection[str]) -> tuple[AppliedRule, ...]:
    """Return the rules that take components as ratios, each with the numbers that justify it.

    Parameters
    ----------
    testbed : Testbed
        As the file has it.
    plant, control : Model
        The full models of the bed and of the bed for control, gaps closed.
    locked : collection of str
        Friction elements that are taken for locked besides those of the gears.
    """
    return tuple(_rule(testbed, table, plant, control, locked) for table in testbed.gear_tables.values())


def _rule(testbed: Testbed, table: GearTable, plant: Model, control: Model, locked: Collection[str]) -> AppliedRule:
    name, component = table.component, testbed.components[table.component]
    sticking = tuple(f"{name}.{element}" for element in component.gear_elements().get(table.design, ()))
    inertia = _inertia(component, table)
    numbers = {"ratio": table.ratio, "inertia": inertia}
    text = f"the ratio {table.ratio:.4g} of its gear {table.design}"
    if table.span is not None:
        numbers |= {"least_ratio": table.span[0], "largest_ratio": table.span[1]}
        text = f"a ratio from {table.span[0]:.4g} to {table.span[1]:.4g} at run time, {text[4:]}"
    text = f"for control it is {text}, without the {inertia:.3g} kg m^2 that turn with its input then"
    others = [element for element in locked if element in {friction.name for friction in plant.frictions}]
    known = {friction.name for friction in plant.frictions}
    if sticking and set(sticking) <= known:
        elsewhere = {f.name for f in plant.frictions if f.name.partition(".")[0] == name} - set(sticking)
        ratios = {p.symbol: table.ratio for p in component.parameters(name) if p.span is not None}
        before = [mode.frequency_hz for mode in modes(plant, [*sticking, *others], ratios) if mode.frequency_hz > 0]
        after = [
            mode.frequency_hz
            for mode in modes(control, [f for f in others if f in {x.name for x in control.frictions}])
            if mode.frequency_hz > 0
        ]
        text += f"; {', '.join(sticking)} {'stick' if len(sticking) > 1 else 'sticks'}"
        text += f", {', '.join(sorted(elsewhere))} slip" if elsewhere else ""
        if before and after:
            numbers |= {"first_mode_hz": before[0], "first_mode_as_ratio_hz": after[0]}
            text += f"; the first mode is at {before[0]:.4g} Hz, here at {after[0]:.4g} Hz"
    return AppliedRule("as ratio", name, text, numbers)

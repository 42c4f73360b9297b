"""Components that are ratios for control: their gears, and the input that tells the controller the ratio."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ptgen.components.component import Component
from ptgen.elements import Parameter
from ptgen.errors import Problem, nearest
from ptgen.gears import gear_ratios, layout_of_part
from ptgen.testbed.problems import dotted, shown

__all__ = ["GearTable", "check_as_ratio", "gear_tables", "known_ratios", "ratio_parameter"]

_FLANGES = ("input", "output")
"""What a component must have between which there is a ratio."""


@dataclass(frozen=True)
class GearTable:
    """The gears of a component that is a ratio for control.

    Attributes
    ----------
    component : str
    gears : mapping of str to float
        Ratio of input speed to output speed in each gear; negative when the sense reverses.
    design : str
        The gear that control is designed in, and whose ratio holds at the start.
    """

    component: str
    gears: Mapping[str, float]
    design: str

    @property
    def ratio(self) -> float:
        """The ratio that control is designed with."""
        return self.gears[self.design]

    @property
    def span(self) -> tuple[float, float] | None:
        """Least and largest ratio; None if there is one ratio only."""
        least, most = min(self.gears.values()), max(self.gears.values())
        return (least, most) if least < most else None


def ratio_parameter(table: GearTable) -> Parameter | None:
    """Return the ratio as an input of the controller, ``<component>_ratio``; None if it is constant.

    Examples
    --------
    >>> ratio_parameter(GearTable("gears", {"1": 5.5, "2": 3.3}, "2")).span
    (3.3, 5.5)
    """
    if table.span is None:
        return None
    symbol = sp.Symbol(f"{table.component}_ratio", real=True)
    text = "ratio of input speed to output speed"
    return Parameter(symbol, table.ratio, "", text, positive=True, signed=True, span=table.span, owner=table.component)


def known_ratios(component: Component) -> dict[str, float]:
    """Return the ratio of each gear: as the component has it, or as its shift table gives it; empty if neither does."""
    if found := component.gear_ratios():
        return dict(found)
    elements = component.gear_elements()
    return gear_ratios(layout_of_part(component), elements) if elements else {}


def gear_tables(
    components: Mapping[str, Component],
    names: Sequence[str],
    given: Mapping[str, Mapping[str, float]],
    design: Mapping[str, str],
) -> dict[str, GearTable]:
    """Return the gears of each component that is a ratio for control.

    Parameters
    ----------
    components : mapping of str to Component
    names : sequence of str
        The components, as in ``reduction.as_ratio``.
    given : mapping
        Gears that the bed file gives, as in ``reduction.gear_ratios``; they go before those of the component.
    design : mapping of str to str
        Gears that control is designed in, as in ``reduction.design_gear``; by default the first one that does not
        reverse the sense.
    """
    tables = {}
    for name in names:
        gears = {gear: float(ratio) for gear, ratio in (given.get(name) or known_ratios(components[name])).items()}
        first = next((gear for gear, ratio in gears.items() if ratio > 0), next(iter(gears)))
        tables[name] = GearTable(name, gears, design.get(name, first))
    return tables


def check_as_ratio(
    section: Mapping[str, Any],
    torque: object,
    types: Mapping[str, type[Component]],
    components: Mapping[str, Component],
    unreadable: frozenset[str] = frozenset(),
) -> list[Problem]:
    """Return what is wrong with ``as_ratio``, ``gear_ratios`` and ``design_gear`` of section ``[reduction]``.

    Parameters
    ----------
    section : mapping
        As it stands in the file.
    torque : object
        ``control.torque`` of the file.
    types : mapping of str to type of Component
    components : mapping of str to Component
        Those of them that have no problem.
    unreadable : frozenset of str
        Components that exist, but whose type has a problem of its own.
    """
    listed = section.get("as_ratio", ())
    names = [name for name in listed if isinstance(name, str)] if isinstance(listed, list | tuple) else []
    problems: list[Problem] = []
    possible = [name for name, kind in types.items() if _can_be_ratio(kind, components.get(name))]
    for index, name in enumerate(names):
        where = dotted("reduction", "as_ratio", index)
        kind = types.get(name)
        if name in unreadable:  # its own problem is reported where it is described
            continue
        if kind is None:
            problems.append(Problem(where, f"{shown(name)} is no component", nearest(name, types)))
        elif kind.type_name == "gearbox":
            what = f'"{name}" is a gearbox, which is a ratio already'
            problems.append(Problem(where, what, f"remove it; ratio_range in [{dotted('components', name)}] varies it"))
        elif not _can_be_ratio(kind, components.get(name)):
            what = f'"{name}" is a {kind.type_name} and has no flanges input and output with a ratio between them'
            remedy = nearest(name, possible) if possible else "remove it: no component of the bed has them"
            problems.append(Problem(where, what, remedy))
        elif name in names[:index]:
            problems.append(Problem(where, f'"{name}" is listed twice', "remove one of them"))
        else:
            problems += _check_gears(name, where, section, components)
        problems += _check_uses(name, where, section, torque)
    for key in ("gear_ratios", "design_gear"):
        table = section.get(key, {})
        for name in table if isinstance(table, dict) else ():
            if name not in names:
                what = f"{shown(name)} is not listed in reduction.as_ratio"
                remedy = f"write as_ratio = [{', '.join(map(_quoted, [*names, name]))}], or remove it"
                problems.append(Problem(dotted("reduction", key, name), what, remedy))
    return problems


def _quoted(name: str) -> str:
    return f'"{name}"'


def _can_be_ratio(kind: type[Component], component: Component | None) -> bool:
    flanges = kind.flange_names() if component is None else component.flange_names()
    return kind.type_name != "gearbox" and set(_FLANGES) <= set(flanges or _FLANGES)


def _check_gears(
    name: str, where: str, section: Mapping[str, Any], components: Mapping[str, Component]
) -> list[Problem]:
    """Check that the gears are known, and that the one that control is designed in is one of them."""
    given, design = section.get("gear_ratios", {}), section.get("design_gear", {})
    gears: object = given.get(name) if isinstance(given, dict) else None
    if gears is None and name in components:
        gears = known_ratios(components[name])
        if not gears:
            what = f'no ratio of "{name}" is known: it has no gears'
            remedy = f"write [reduction.gear_ratios] with {name} = {{ 1 = 4.7, 2 = 3.1 }}, or give it gears"
            return [Problem(where, what, remedy)]
    if not isinstance(gears, Mapping):
        return []
    if not gears:
        what = f'"{name}" has no gears here'
        return [Problem(dotted("reduction", "gear_ratios", name), what, "write { 1 = 4.7, 2 = 3.1 }, or remove it")]
    wanted = design.get(name) if isinstance(design, dict) else None
    if isinstance(wanted, str) and wanted not in gears:
        what = f'{shown(wanted)} is no gear of "{name}"'
        return [Problem(dotted("reduction", "design_gear", name), what, nearest(wanted, list(gears)))]
    return []


def _check_uses(name: str, where: str, section: Mapping[str, Any], torque: object) -> list[Problem]:
    """Check that nothing else in the file wants parts of the component that are gone for control."""
    problems = []
    locked = section.get("locked", ())
    for index, element in enumerate(locked if isinstance(locked, list | tuple) else ()):
        if isinstance(element, str) and element.partition(".")[0] == name:
            what = f'"{element}" is part of "{name}", which is a ratio for control ({where})'
            problems.append(Problem(dotted("reduction", "locked", index), what, "remove it from one of the two lists"))
    rigid = section.get("rigid", ())
    for index, component in enumerate(rigid if isinstance(rigid, list | tuple) else ()):
        if component == name:
            what = f'"{name}" is a ratio for control ({where}), where nothing is left that could be rigid'
            problems.append(Problem(dotted("reduction", "rigid", index), what, "remove it from one of the two lists"))
    for machine, place in torque.items() if isinstance(torque, dict) else ():
        if place == name:
            what = f'"{name}" is a ratio for control ({where}), so its torque is defined at its flanges only'
            problems.append(Problem(dotted("control", "torque", machine), what, f'write "{name}.input"'))
    return problems

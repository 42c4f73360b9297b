"""From the elements of a gear set's components to its layout."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

import networkx as nx
import sympy as sp

from ptgen.elements import Constraint, Elements, Friction, FrictionRole, Row
from ptgen.gears.layout import Layout, Loss, ShiftElement, Train, TrainKind, fraction

__all__ = ["exact", "layout_of"]

_DENOMINATOR = 10_000
"""Quotients of numbers of teeth have smaller denominators."""


_LETTERS = {TrainKind.PLANETARY_SET: "g", TrainKind.GEAR_PAIR: "i"}
"""Symbol of the ratio of a train of each kind that has one."""


def exact(value: float) -> Fraction:
    """Return a number of a file as the quotient of whole numbers, such as numbers of teeth, that it was made of.

    Examples
    --------
    >>> exact(98 / 46)
    Fraction(49, 23)
    >>> exact(2.13)
    Fraction(213, 100)
    """
    near = Fraction(value).limit_denominator(_DENOMINATOR)
    return near if float(near) == float(value) else Fraction(repr(float(value)))


def layout_of(
    elements: Elements,
    input_flange: str,
    output_flange: str,
    values: Mapping[sp.Symbol, float],
    *,
    title: str = "",
    prefix: str = "",
    connections: Iterable[tuple[str, str]] = (),
    members: Iterable[str] = (),
) -> Layout:
    """Return the layout of a gear set from its elements.

    Parameters
    ----------
    elements : Elements
        Constraints, springs (taken as rigid) and friction elements of all components of the gear set. Friction elements
        of the role COUPLING are shift elements if they are actuated or one-way; otherwise they are always engaged.
    input_flange, output_flange : str
        The velocities that the gears connect.
    values : mapping of sympy.Symbol to float
        The parameters that the rows contain.
    title : str
        What the gear set is called.
    prefix : str
        What all names begin with, such as ``"gears."``; it is left out of the names of the layout.
    connections : iterable of (str, str)
        Velocities that are connected rigidly.
    members : iterable of str
        Velocities whose names the members bear that they belong to.
    """
    return _Builder(elements, values, prefix, connections).layout(title, (input_flange, output_flange), tuple(members))


class _Builder:
    def __init__(
        self,
        elements: Elements,
        values: Mapping[sp.Symbol, float],
        prefix: str,
        connections: Iterable[tuple[str, str]],
    ) -> None:
        self.prefix = prefix
        self.values = {symbol: exact(value) for symbol, value in values.items()}
        self.frictions = elements.frictions
        pressed = [f for f in elements.frictions if f.role is FrictionRole.COUPLING and not (f.actuated or f.one_way)]
        rows = [
            *elements.constraints,
            *(Constraint(spring.name, spring.row) for spring in elements.springs),
            *(Constraint(friction.name, friction.row) for friction in pressed),
            *(Constraint("", {left: sp.Integer(1), right: sp.Integer(-1)}) for left, right in connections),
        ]
        self.joints = [row for row in rows if _is_joint(row.row)]
        self.rows = [row for row in rows if not _is_joint(row.row)]

    def layout(self, title: str, ends: tuple[str, str], preferred: tuple[str, ...]) -> Layout:
        graph = nx.Graph()
        graph.add_nodes_from(ends)
        couplings = (friction.row for friction in self.frictions if friction.role is FrictionRole.COUPLING)
        for row in (*(own.row for own in (*self.rows, *self.joints)), *couplings):
            graph.add_nodes_from(row)
        graph.add_nodes_from(preferred)
        for joint in self.joints:
            graph.add_edge(*joint.row)
        geared = [velocity for row in self.rows for velocity in row.row]
        names: dict[str, str] = {}
        flanges: dict[str, tuple[str, ...]] = {}
        for part in nx.connected_components(graph):
            velocities = [velocity for velocity in graph if velocity in part]
            chosen = next(
                velocity for group in (preferred, ends, geared, velocities) for velocity in group if velocity in part
            )
            name = self._short(chosen)
            names.update(dict.fromkeys(velocities, name))
            flanges[name] = tuple(self._short(velocity) for velocity in velocities if velocity != chosen)
        trains = self._trains(names)
        shift = [
            self._element(friction, names)
            for friction in self.frictions
            if friction.role is FrictionRole.COUPLING and (friction.actuated or friction.one_way)
        ]
        return Layout(title, tuple(flanges), flanges, names[ends[0]], names[ends[1]], trains, tuple(shift))

    def _short(self, name: str) -> str:
        return name.removeprefix(self.prefix)

    def _number(self, expression: sp.Expr) -> Fraction:
        expression = sp.sympify(expression)
        table = {s: sp.Rational(v.numerator, v.denominator) for s, v in self.values.items()}
        return fraction(expression.subs(table))

    def _element(self, friction: Friction, names: Mapping[str, str]) -> ShiftElement:
        row: dict[str, Fraction] = {}
        for velocity, coefficient in friction.row.items():
            member = names[velocity]
            row[member] = row.get(member, Fraction(0)) + self._number(coefficient)
        kept = {member: number for member, number in row.items() if number}
        return ShiftElement(self._short(friction.name), kept, float(self._number(friction.coulomb)), friction.one_way)

    def _trains(self, names: Mapping[str, str]) -> tuple[Train, ...]:
        found = []
        for row in self.rows:
            numbers = {velocity: self._number(c) for velocity, c in row.row.items()}
            labels = {velocity: velocity.rpartition(".")[2] for velocity in row.row}
            found.append((row.owner, *_sorted_row(numbers, labels)))
        symbols: dict[TrainKind, dict[str, sp.Symbol]] = {
            kind: _symbols(letter, [owner for owner, own, _ in found if own is kind])
            for kind, letter in _LETTERS.items()
        }
        trains = []
        for owner, kind, numbers in found:
            labels = {velocity: velocity.rpartition(".")[2] for velocity in numbers}
            if len(set(labels.values())) < len(labels):
                labels = {velocity: self._short(velocity) for velocity in numbers}
            members = {labels[velocity]: names[velocity] for velocity in numbers}
            symbol = symbols.get(kind, {}).get(owner)
            ratio, coefficients = _in_symbol(kind, list(numbers.values()), symbol)
            trains.append(
                Train(
                    self._short(owner),
                    kind,
                    members,
                    dict(zip(members, coefficients, strict=True)),
                    symbol,
                    ratio,
                    self._loss(owner, labels),
                )
            )
        return tuple(trains)

    def _loss(self, owner: str, labels: Mapping[str, str]) -> Loss | None:
        for friction in self.frictions:
            if friction.role is not FrictionRole.LOSS or friction.name.rpartition(".")[0] != owner:
                continue
            if friction.load is None or friction.load.place not in labels or not set(friction.row) <= set(labels):
                continue
            rolling = {labels[velocity]: self._number(c) for velocity, c in friction.row.items()}
            coefficient = float(self._number(friction.load.coefficient))
            if rolling.get(labels[friction.load.place]) and coefficient > 0:
                return Loss(coefficient, labels[friction.load.place], rolling)
        return None


def _is_joint(row: Row) -> bool:
    """Tell whether a row makes two velocities one."""
    return len(row) == 2 and set(row.values()) == {sp.Integer(1), sp.Integer(-1)}


def _sorted_row(numbers: Mapping[str, Fraction], labels: Mapping[str, str]) -> tuple[TrainKind, dict[str, Fraction]]:
    """Return what a row stands for, and the row in the order of its kind with the leading coefficient 1."""
    by_label = {labels[velocity]: velocity for velocity in numbers}
    if set(by_label) == {"sun", "ring", "carrier"} and not sum(numbers.values()):
        order = [by_label[label] for label in ("sun", "ring", "carrier")]
        kind = TrainKind.PLANETARY_SET
    elif len(numbers) == 2 and all(numbers.values()):
        named = set(by_label) == {"input", "output"}
        order = [by_label["input"], by_label["output"]] if named else list(numbers)
        kind = TrainKind.GEAR_PAIR
    else:
        return TrainKind.OTHER, dict(numbers)
    return kind, {velocity: numbers[velocity] / numbers[order[0]] for velocity in order}


def _in_symbol(
    kind: TrainKind, numbers: Sequence[Fraction], symbol: sp.Symbol | None
) -> tuple[Fraction, list[sp.Expr]]:
    """Return the ratio of a train, and its coefficients written with the symbol of the ratio."""
    one = sp.Integer(1)
    if symbol is None:
        return Fraction(1), [sp.Rational(number.numerator, number.denominator) for number in numbers]
    signed = symbol if numbers[1] > 0 else -symbol
    if kind is TrainKind.PLANETARY_SET:
        return abs(numbers[1]), [one, signed, -one - signed]
    return abs(numbers[1]), [one, signed]


def _symbols(letter: str, owners: Sequence[str]) -> dict[str, sp.Symbol]:
    """Return a symbol for each owner: with the number that its name ends in, if all have one; counted otherwise.

    Examples
    --------
    >>> _symbols("g", ["P2", "P1"])
    {'P2': g2, 'P1': g1}
    >>> _symbols("g", ["front", "rear"])
    {'front': g1, 'rear': g2}
    """
    unique = list(dict.fromkeys(owners))
    found = [re.search(r"(\d+)$", owner) for owner in unique]
    numbers = [match[1].lstrip("0") if match else "" for match in found]
    if not all(numbers) or len(set(numbers)) < len(numbers):
        numbers = [str(k) for k in range(1, len(unique) + 1)]
    return {owner: sp.Symbol(f"{letter}{n}", positive=True) for owner, n in zip(unique, numbers, strict=True)}

"""From the elements of a gear set's components to its layout."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import networkx as nx
import sympy as sp

from ptgen.components.component import Component
from ptgen.components.part import Part
from ptgen.elements import Constraint, Elements, Friction, FrictionRole, Row
from ptgen.errors import ModelError, Problem
from ptgen.gears.layout import Layout, Loss, ShiftElement, Train, TrainKind, fraction

__all__ = ["exact", "layout_of", "layout_of_part"]

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
    members: Iterable[str] = (),
) -> Layout:
    """Return the layout of a gear set from its elements.

    Parameters
    ----------
    elements : Elements
        Constraints, connections, springs (taken as rigid) and friction elements of all components of the gear set.
        Friction elements of the role COUPLING are shift elements if they are actuated or one-way; otherwise they are
        always engaged.
    input_flange, output_flange : str
        The velocities that the gears connect.
    values : mapping of sympy.Symbol to float
        The parameters that the rows contain.
    title : str
        What the gear set is called.
    prefix : str
        What all names begin with, such as ``"gears."``; it is left out of the names of the layout.
    members : iterable of str
        Velocities whose names the members bear that they belong to.
    """
    return _Builder(elements, values, prefix).layout(title, (input_flange, output_flange), tuple(members))


def layout_of_part(part: Component, name: str = "part", ratio: float | None = None) -> Layout:
    """Return the layout of a part that exposes ``input`` and ``output``, or two flanges of any names.

    Parameters
    ----------
    part : Component
        A part, or another component with such flanges.
    name : str
        What the part is called; it stands in no name of the layout.
    ratio : float, optional
        What ratios that change at run time are now.

    Raises
    ------
    ModelError
        If it is not clear which of its flanges the gears connect.
    """
    flanges = part.flange_names()
    ends = ("input", "output") if {"input", "output"} <= set(flanges) else flanges
    title, file = "", ""
    members: tuple[str, ...] = ()
    if isinstance(part, Part):
        title, file, members = part.description.title, part.description.file, tuple(part.description.members)
    if len(ends) != 2:
        listed = ", ".join(flanges) or "none"
        what = f"gears lead from an input to an output, and the flanges are {listed}"
        raise ModelError(Problem("part.flanges", what, "call two of them input and output"), file)
    parameters = part.parameters(name)
    values = {p.symbol: p.value if p.span is None or ratio is None else ratio for p in parameters}
    return layout_of(
        part.elements(name),
        f"{name}.{ends[0]}",
        f"{name}.{ends[1]}",
        values,
        title=title,
        prefix=f"{name}.",
        members=[f"{name}.{member}" for member in members],
    )


class _Builder:
    def __init__(self, elements: Elements, values: Mapping[sp.Symbol, float], prefix: str) -> None:
        self.prefix = prefix
        self.values = {symbol: exact(value) for symbol, value in values.items()}
        self.frictions = elements.frictions
        self.bodies = elements.bodies
        pressed = [f for f in elements.frictions if f.role is FrictionRole.COUPLING and not (f.actuated or f.one_way)]
        rows = [
            *elements.constraints,
            *(Constraint(spring.name, spring.row) for spring in elements.springs),
            *(Constraint(friction.name, friction.row) for friction in pressed),
            *(Constraint("", {left: sp.Integer(1), right: sp.Integer(-1)}) for left, right in elements.connections),
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
        return Layout(
            title,
            tuple(flanges),
            flanges,
            names[ends[0]],
            names[ends[1]],
            trains,
            tuple(shift),
            self._inertias(names),
            tuple(self._short(f.name) for f in self.frictions if f.role is not FrictionRole.COUPLING),
        )

    def _inertias(self, names: Mapping[str, str]) -> dict[str, Fraction]:
        sums: dict[str, Fraction] = {}
        for body in self.bodies:
            if body.velocity in names:  # a body that hangs on a friction element alone is on no member
                member = names[body.velocity]
                sums[member] = sums.get(member, Fraction(0)) + self._number(body.inertia)
        return {member: inertia for member, inertia in sums.items() if inertia}

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
        static, speed = friction.static, friction.stribeck_speed
        return ShiftElement(
            self._short(friction.name),
            {member: number for member, number in row.items() if number},
            float(self._number(friction.coulomb)),
            friction.one_way,
            None if static is None else float(self._number(static)),
            None if speed is None else float(self._number(speed)),
            float(self._number(friction.viscous)),
        )

    def _trains(self, names: Mapping[str, str]) -> tuple[Train, ...]:
        found = [_read_row(row, {velocity: self._number(c) for velocity, c in row.row.items()}) for row in self.rows]
        symbols: dict[TrainKind, dict[str, sp.Symbol]] = {
            kind: _symbols(letter, [row.owner for row in found if row.kind is kind])
            for kind, letter in _LETTERS.items()
        }
        meant = {row.parameter: symbols[row.kind][row.owner] for row in found if row.parameter and row.kind in symbols}
        trains: list[Train] = []
        for row in found:
            labels = {velocity: velocity.rpartition(".")[2] for velocity in row.numbers}
            if len(set(labels.values())) < len(labels):
                labels = {velocity: self._short(velocity) for velocity in row.numbers}
            symbol = symbols.get(row.kind, {}).get(row.owner)
            coefficients = row.in_symbol(symbol) if symbol is not None else self._in_symbols(row, meant)
            name = self._short(row.owner)
            if any(train.name == name for train in trains):
                name = f"{name}.{list(labels.values())[-1]}"
            trains.append(
                Train(
                    name,
                    row.kind,
                    {labels[velocity]: names[velocity] for velocity in row.numbers},
                    {labels[velocity]: coefficient for velocity, coefficient in coefficients.items()},
                    {labels[velocity]: number for velocity, number in row.numbers.items()},
                    symbol,
                    row.ratio,
                    self._loss(row.owner, labels),
                )
            )
        return tuple(trains)

    def _in_symbols(self, row: _Row, meant: Mapping[sp.Symbol, sp.Symbol]) -> dict[str, sp.Expr]:
        """Return the coefficients of a constraint with the ratios of trains as symbols, and numbers for the rest."""
        rest = {s: sp.Rational(v.numerator, v.denominator) for s, v in self.values.items() if s not in meant}
        return {v: sp.sympify(row.original[v]).subs(rest).subs(meant) for v in row.numbers}

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


@dataclass(frozen=True)
class _Row:
    """A constraint with what it stands for.

    `numbers` are its coefficients in the order of its kind, and `original` the same as expressions, not in order.
    """

    owner: str
    kind: TrainKind
    numbers: Mapping[str, Fraction]
    original: Mapping[str, sp.Expr]

    @property
    def parameter(self) -> sp.Symbol | None:
        """The parameter that the ratio of a train is, if it is one."""
        if self.kind is TrainKind.OTHER:
            return None
        velocities = list(self.numbers)
        quotient = sp.sympify(self.original[velocities[1]]) / sp.sympify(self.original[velocities[0]])
        return next((own for own in (quotient, -quotient) if own.is_Symbol), None)

    @property
    def ratio(self) -> Fraction:
        """The value of the ratio; 1 for a constraint of another kind."""
        return Fraction(1) if self.kind is TrainKind.OTHER else abs(list(self.numbers.values())[1])

    def in_symbol(self, symbol: sp.Symbol) -> dict[str, sp.Expr]:
        """Return the coefficients written with the symbol of the ratio."""
        velocities = list(self.numbers)
        one, signed = sp.Integer(1), symbol if self.numbers[velocities[1]] > 0 else -symbol
        return dict(zip(velocities, (one, signed, -one - signed), strict=False))


def _read_row(row: Constraint, numbers: Mapping[str, Fraction]) -> _Row:
    """Return what a constraint stands for, with its coefficients in the order of its kind, the first one 1."""
    by_label = {velocity.rpartition(".")[2]: velocity for velocity in numbers}
    if set(by_label) == {"sun", "ring", "carrier"} and not sum(numbers.values()):
        order = [by_label[label] for label in ("sun", "ring", "carrier")]
        kind = TrainKind.PLANETARY_SET
    elif len(numbers) == 2 and all(numbers.values()):
        order = [by_label["input"], by_label["output"]] if set(by_label) == {"input", "output"} else list(numbers)
        kind = TrainKind.GEAR_PAIR
    else:
        return _Row(row.owner, TrainKind.OTHER, dict(numbers), row.row)
    return _Row(row.owner, kind, {v: numbers[v] / numbers[order[0]] for v in order}, row.row)


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

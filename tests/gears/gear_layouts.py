"""Layouts of gear sets for the tests, made from elements by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ptgen.elements import Constraint, Elements, Friction, FrictionRole, Load
from ptgen.gears import Layout, layout_of

ONE = sp.Integer(1)


class Gearing:
    """Collects sets, pairs, elements and members, and makes the layout of them."""

    def __init__(self) -> None:
        self.constraints: list[Constraint] = []
        self.frictions: list[Friction] = []
        self.connections: list[tuple[str, str]] = []
        self.values: dict[sp.Symbol, float] = {}
        self.members: list[str] = []

    def set(self, name: str, sun: int, ring: int, *, double: bool = False, loss: float = 0.0) -> None:
        g = sp.Symbol(f"{name}_ratio", positive=True)
        self.values[g] = ring / sun
        signed = -g if double else g
        row = {f"{name}.sun": ONE, f"{name}.ring": signed, f"{name}.carrier": -ONE - signed}
        self.constraints.append(Constraint(name, row))
        if loss:
            self._loss(name, {f"{name}.sun": ONE, f"{name}.carrier": -ONE}, f"{name}.sun", loss)

    def pair(self, name: str, input_: int, output: int, *, reversing: bool = True, loss: float = 0.0) -> None:
        i = sp.Symbol(f"{name}_ratio", positive=True)
        self.values[i] = output / input_
        self.constraints.append(Constraint(name, {f"{name}.input": ONE, f"{name}.output": i if reversing else -i}))
        if loss:
            self._loss(name, {f"{name}.input": ONE}, f"{name}.input", loss)

    def _loss(self, name: str, row: Mapping[str, sp.Expr], place: str, loss: float) -> None:
        load = sp.Symbol(f"{name}_loss_load", positive=True)
        self.values[load] = loss
        zero = sp.Integer(0)
        self.frictions.append(Friction(f"{name}.loss", row, zero, zero, FrictionRole.LOSS, load=Load(load, place)))

    def clutch(self, *names: str) -> None:
        for name in names:
            self._shift(name, {f"{name}.input": ONE, f"{name}.output": -ONE})

    def brake(self, *names: str) -> None:
        for name in names:
            self._shift(name, {f"{name}.left": ONE})

    def freewheel(self, name: str) -> None:
        """A freewheel that holds its flange ``input`` against positive rotation relative to ``output``."""
        row = {f"{name}.input": ONE, f"{name}.output": -ONE}
        zero = sp.Integer(0)
        self.frictions.append(Friction(name, row, zero, zero, FrictionRole.COUPLING, one_way=True))

    def _shift(self, name: str, row: Mapping[str, sp.Expr]) -> None:
        capacity = sp.Integer(20 if name.startswith("S") else 300)
        self.frictions.append(Friction(name, row, capacity, sp.Integer(0), FrictionRole.COUPLING, actuated=True))

    def member(self, name: str, *flanges: str) -> None:
        self.members.append(name)
        self.connections += [(name, flange) for flange in flanges]

    def layout(self, title: str = "") -> Layout:
        elements = Elements(
            constraints=tuple(self.constraints),
            frictions=tuple(self.frictions),
            connections=tuple(self.connections),
        )
        return layout_of(
            elements,
            "input",
            "output",
            self.values,
            title=title,
            members=self.members,
        )


NINE_SPEED_TEETH = {"P1": (46, 98), "P2": (44, 100), "P3": (36, 84), "P4": (34, 86)}

NINE_SPEED_GEARS: dict[str, Sequence[str]] = {
    "R": ["A", "B", "C"],
    "N": ["B", "C"],
    "1": ["B", "C", "E"],
    "2": ["C", "D", "E"],
    "3": ["B", "C", "D"],
    "4": ["B", "C", "F"],
    "5": ["B", "D", "F"],
    "6": ["D", "E", "F"],
    "7": ["B", "E", "F"],
    "8": ["A", "E", "F"],
    "9": ["A", "B", "F"],
}


def nine_speed(loss: float = 0.0, teeth: Mapping[str, tuple[int, int]] = NINE_SPEED_TEETH) -> Layout:
    """Return the gear set of Figure 3.16."""
    gearing = Gearing()
    for name, (sun, ring) in teeth.items():
        gearing.set(name, sun, ring, loss=loss)
    gearing.brake("A", "B", "C")
    gearing.clutch("D", "E", "F")
    gearing.member("input", "P1.sun", "D.input", "F.input")
    gearing.member("a", "P1.ring", "P2.carrier")
    gearing.member("b", "P2.ring", "P3.sun", "P4.sun", "E.input")
    gearing.member("output", "P3.carrier", "P4.ring")
    gearing.member("c", "P1.carrier", "A.left", "D.output", "E.output")
    gearing.member("s2", "P2.sun", "B.left")
    gearing.member("r3", "P3.ring", "C.left")
    gearing.member("c4", "P4.carrier", "F.output")
    return gearing.layout("nine-speed")


def dual_clutch() -> Layout:
    """Return a layshaft transmission with two clutches, four gears and a reverse gear by an idler."""
    gearing = Gearing()
    teeth = {"G1": (13, 47), "G2": (20, 43), "G3": (29, 42), "G4": (35, 36)}
    for name, (first, second) in teeth.items():
        gearing.pair(name, first, second)
    gearing.pair("GR", 12, 40, reversing=False)
    gearing.clutch("K1", "K2", "S1", "S2", "S3", "S4", "SR")
    gearing.member("input", "K1.input", "K2.input")
    gearing.member("inner", "K1.output", "G1.input", "G3.input", "GR.input")
    gearing.member("outer", "K2.output", "G2.input", "G4.input")
    for number in "1234R":
        gearing.member(f"wheel{number}", f"G{number}.output", f"S{number}.input")
    gearing.member("output", *(f"S{number}.output" for number in "1234R"))
    return gearing.layout("dual clutch")


DUAL_CLUTCH_GEARS = {"R": ["K1", "SR"], "1": ["K1", "S1"], "2": ["K2", "S2"], "3": ["K1", "S3"], "4": ["K2", "S4"]}

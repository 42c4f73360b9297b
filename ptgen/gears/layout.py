r"""The layout of a gear set: members that turn as one, trains of gears between them, and elements that couple them.

A *member* is everything that is connected rigidly, springs included, since in stationary motion they do not twist. A
*train* is a row of coefficients on the members' velocities that is zero whatever is engaged: a planetary set

.. math:: \omega_s + g\,\omega_r = (1 + g)\,\omega_c \qquad (3.47), \qquad
          \omega_s - g\,\omega_r = (1 - g)\,\omega_c \quad\text{with double pinions},

or a pair of gears, :math:`\omega_{in} = i\,\omega_{out}`. A *shift element* is a row that is zero while the element is
engaged. Ratios are symbols :math:`g_1, g_2, \ldots` and :math:`i_1, i_2, \ldots` with exact values.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from fractions import Fraction

import sympy as sp

from ptgen.gears.vectors import Vector

__all__ = ["Layout", "Loss", "ShiftElement", "Train", "TrainKind", "fraction"]


class TrainKind(Enum):
    """What a row on velocities stands for."""

    PLANETARY_SET = "planetary set"
    GEAR_PAIR = "gear pair"
    OTHER = "constraint"


@dataclass(frozen=True)
class Loss:
    """Friction of teeth, proportional to the torque at one flange and acting on the velocity with which they roll.

    Attributes
    ----------
    coefficient : float
        1 less the efficiency while the carrier stands.
    flange : str
        The flange of the train, such as ``sun``, whose torque it is proportional to.
    rolling : mapping of str to Fraction
        Flange of the train -> coefficient of the rolling velocity.
    """

    coefficient: float
    flange: str
    rolling: Mapping[str, Fraction]


@dataclass(frozen=True)
class Train:
    """Gears that always mesh: ``sum of coefficient * velocity = 0`` over its flanges.

    Attributes
    ----------
    name : str
    kind : TrainKind
    members : mapping of str to str
        Flange, such as ``sun``, -> member, in the order of a picture: sun, carrier or ring, or input, output.
    coefficients : mapping of str to sympy.Expr
        Flange -> coefficient, in ratio symbols.
    numbers : mapping of str to Fraction
        The same at the values of the ratios.
    symbol : sympy.Symbol or None
        The ratio; None for a constraint of another kind.
    ratio : Fraction
        Value of `symbol`; 1 if there is none.
    loss : Loss or None
    """

    name: str
    kind: TrainKind
    members: Mapping[str, str]
    coefficients: Mapping[str, sp.Expr]
    numbers: Mapping[str, Fraction]
    symbol: sp.Symbol | None
    ratio: Fraction
    loss: Loss | None = None


@dataclass(frozen=True)
class ShiftElement:
    """A clutch, brake or synchroniser; engaged, ``sum of coefficient * velocity = 0`` over members.

    A torque of the element is positive when it brakes the members with positive coefficients: a clutch's when the
    input drives the output, a brake's when it holds against positive rotation.

    Attributes
    ----------
    name : str
    row : mapping of str to Fraction
        Member -> coefficient; without members that it holds to themselves.
    capacity : float
        Torque that it transmits while it slips, fully actuated (N m).
    one_way : bool
        Whether it is a freewheel, which holds one sense of torque only.
    static : float or None
        Torque that it holds while it sticks, fully actuated (N m); None if it is the capacity.
    stribeck_speed : float or None
        Velocity over which the torque falls from `static` to the capacity (rad/s); None if it falls at once.
    viscous : float
        Viscous friction, fully actuated (N m s/rad).
    """

    name: str
    row: Mapping[str, Fraction]
    capacity: float
    one_way: bool = False
    static: float | None = None
    stribeck_speed: float | None = None
    viscous: float = 0.0

    @property
    def is_brake(self) -> bool:
        """Whether it holds a single member against the housing."""
        return len(self.row) == 1


@dataclass(frozen=True)
class Layout:
    """A gear set as the analysis sees it.

    Attributes
    ----------
    title : str
    members : tuple of str
        Names of what turns as one.
    flanges : mapping of str to tuple of str
        Member -> the flanges of components on it.
    input, output : str
        The members that the gears connect.
    trains : tuple of Train
    elements : tuple of ShiftElement
    inertias : mapping of str to Fraction
        Member -> moment of inertia of all bodies on it (kg m^2); without those that have none.
    losses : tuple of str
        Friction elements that are no shift elements.
    """

    title: str
    members: tuple[str, ...]
    flanges: Mapping[str, tuple[str, ...]]
    input: str
    output: str
    trains: tuple[Train, ...]
    elements: tuple[ShiftElement, ...]
    inertias: Mapping[str, Fraction] = field(default_factory=dict)
    losses: tuple[str, ...] = ()

    @property
    def values(self) -> dict[sp.Symbol, Fraction]:
        """The ratio symbols with their values."""
        return {train.symbol: train.ratio for train in self.trains if train.symbol is not None}

    @property
    def element_names(self) -> tuple[str, ...]:
        """The names of the shift elements, in order."""
        return tuple(element.name for element in self.elements)

    def train_vector(self, train: Train) -> Vector:
        """Return the row of a train over the members."""
        vector = [Fraction(0)] * len(self.members)
        for flange, number in train.numbers.items():
            vector[self.members.index(train.members[flange])] += number
        return vector

    def element_vector(self, element: ShiftElement) -> Vector:
        """Return the row of a shift element over the members."""
        return [element.row.get(member, Fraction(0)) for member in self.members]

    def unit_vector(self, member: str) -> Vector:
        """Return the row that is the velocity of a member."""
        return [Fraction(int(own == member)) for own in self.members]


def fraction(number: sp.Expr) -> Fraction:
    """Return a rational number of sympy as a fraction."""
    rational = sp.Rational(number) if number.is_Rational else sp.nsimplify(number, rational=True)
    return Fraction(int(rational.p), int(rational.q))

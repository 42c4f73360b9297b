r"""Torques and power in a gear, without losses and with those of the teeth.

In stationary motion no inertia counts, and by virtual power the torques balance on every member:

.. math:: e_{in} T_{in} - e_{out} T_{out} = \sum_j r_j \lambda_j + \sum_k g_k \tau_k

with the rows :math:`r_j` of the trains and :math:`g_k` of the engaged elements. A mesh that loses the share
:math:`1 - \eta_0` of the power with which it rolls adds to the row of its train. With the torque :math:`T_p` at the
flange that the loss is proportional to, and the power :math:`P = T_p \omega_{roll}` that rolls from there,

.. math:: r_j \to r_j + \kappa\,w_j, \qquad
          \kappa = \begin{cases} 1 / \eta_0 - 1 & P > 0 \\ \eta_0 - 1 & P < 0 \end{cases}

for the row :math:`w_j` of the rolling velocity, so that for a planetary set :math:`T_r = g\,T_s\,\eta_0^{\pm 1}`. Which
sign holds is found by trial: the pattern of signs is the one that its own solution confirms.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import networkx as nx
import numpy as np
from numpy.typing import NDArray

from ptgen.gears.layout import Layout, Train

__all__ = ["Balance", "TrainLoad", "balance"]

_SMALL = 1e-10
"""Torques and powers below this share of the largest one are zero."""
_MOST_PATTERNS = 12
"""Trains with losses of which all sign patterns are tried."""

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TrainLoad:
    """What a train of gears transmits, per unit of the input's torque, speed and power.

    Attributes
    ----------
    torques : mapping of str to float
        Flange -> torque that its member exerts on the train.
    powers : mapping of str to float or None
        Flange -> power that its member gives to the train; None if its velocity is free.
    rolling_power : float
        Power at the sun, or at the input, of the motion relative to the carrier; positive into the train.
    """

    torques: Mapping[str, float]
    powers: Mapping[str, float | None]
    rolling_power: float


@dataclass(frozen=True)
class Balance:
    """Torques in a gear per unit of the input's torque, and what becomes of the power.

    Attributes
    ----------
    output_torque : float
        Torque that the output exerts on what it drives.
    elements : mapping of str to float
        Engaged element -> its torque.
    trains : mapping of str to TrainLoad
    efficiency : float
        Power that comes out over power that goes in.
    consistent : int
        Number of patterns of the signs of rolling power that are consistent; 1 unless the gear locks itself.
    undetermined : tuple of str
        Engaged elements whose torque is not determined, because others hold the same motion; theirs is of least norm.
    recirculating : float
        Power that flows in a circle, per unit of the input's power.
    circle : tuple of str
        Trains through which it flows.
    """

    output_torque: float
    elements: Mapping[str, float]
    trains: Mapping[str, TrainLoad]
    efficiency: float
    consistent: int = 1
    undetermined: tuple[str, ...] = ()
    recirculating: float = 0.0
    circle: tuple[str, ...] = ()
    input_torque: float = field(default=1.0)


def balance(
    layout: Layout, engaged: Sequence[str], speeds: Mapping[str, float | None], *, losses: bool, coast: bool = False
) -> Balance | None:
    """Return the torques in a gear.

    Parameters
    ----------
    layout : Layout
    engaged : sequence of str
        Shift elements that are engaged.
    speeds : mapping of str to float or None
        Velocity of every member per unit of the input's; None if it is free.
    losses : bool
        Whether the teeth lose power.
    coast : bool
        Whether the output drives the input.

    Returns
    -------
    Balance or None
        None if no pattern of signs is consistent: the gear locks itself under load from this side.
    """
    return _Statics(layout, engaged, speeds, -1.0 if coast else 1.0).solve(losses)


class _Statics:
    def __init__(
        self, layout: Layout, engaged: Sequence[str], speeds: Mapping[str, float | None], input_torque: float
    ) -> None:
        self.layout = layout
        self.speeds = speeds
        self.input_torque = input_torque
        self.engaged = [element for element in layout.elements if element.name in engaged]
        self.rows = [np.array([float(x) for x in layout.train_vector(train)]) for train in layout.trains]
        self.rolls = [self._rolling(train) for train in layout.trains]
        self.element_rows = [np.array([float(x) for x in layout.element_vector(e)]) for e in self.engaged]
        self.left = input_torque * np.array([float(x) for x in layout.unit_vector(layout.input)])
        self.out = np.array([float(x) for x in layout.unit_vector(layout.output)])

    def _rolling(self, train: Train) -> tuple[Array, float | None]:
        """Return the row of the rolling velocity, scaled like the train's row, and its value."""
        row = np.zeros(len(self.layout.members))
        numbers = train.numbers
        if train.loss is not None:
            rolling = {flange: float(number) for flange, number in train.loss.rolling.items()}
            scale = float(numbers[train.loss.flange]) / rolling[train.loss.flange]
        elif set(numbers) == {"sun", "ring", "carrier"}:
            rolling, scale = {"sun": 1.0, "carrier": -1.0}, float(numbers["sun"])
        else:
            first = next(iter(numbers))
            rolling, scale = {first: 1.0}, float(numbers[first])
        speed: float | None = 0.0
        for flange, number in rolling.items():
            member = train.members[flange]
            row[self.layout.members.index(member)] += scale * number
            own = self.speeds[member]
            speed = None if speed is None or own is None else speed + scale * number * own
        return row, speed

    def solve(self, losses: bool) -> Balance | None:
        solution = self._solution([0.0] * len(self.rows))
        if not losses:
            return self._balance(solution, [0.0] * len(self.rows), 1)
        rolling = [self._rolling_power(solution, index) for index in range(len(self.rows))]
        lossy = [
            index
            for index, train in enumerate(self.layout.trains)
            if train.loss is not None and abs(rolling[index]) > _SMALL
        ]
        found = []
        for signs in self._patterns(lossy, rolling):
            factors = [0.0] * len(self.rows)
            for index, sign in zip(lossy, signs, strict=True):
                loss = self.layout.trains[index].loss
                share = 0.0 if loss is None else loss.coefficient
                factors[index] = share / (1.0 - share) if sign > 0 else -share
            tried = self._solution(factors)
            if all(
                np.sign(self._rolling_power(tried, index)) == sign for index, sign in zip(lossy, signs, strict=True)
            ):
                found.append(self._balance(tried, factors, 1))
        sound = [one for one in found if 0.0 < one.efficiency <= 1.0 + 1e-9]
        if not sound:
            return None
        first = sound[0]
        return Balance(**{**vars(first), "consistent": len(sound)})

    @staticmethod
    def _patterns(lossy: Sequence[int], rolling: Sequence[float]) -> list[tuple[float, ...]]:
        likely = tuple(float(np.sign(rolling[index])) for index in lossy)
        if len(lossy) > _MOST_PATTERNS:
            return [likely]
        rest = (p for p in itertools.product((1.0, -1.0), repeat=len(lossy)) if p != likely)
        return [likely, *rest]

    def _columns(self, factors: Sequence[float]) -> Array:
        trains = [row + factor * roll for row, factor, (roll, _) in zip(self.rows, factors, self.rolls, strict=True)]
        return np.column_stack([self.out, *trains, *self.element_rows])

    def _solution(self, factors: Sequence[float]) -> Array:
        """Return output torque, multipliers of the trains and torques of the elements, the latter of least norm."""
        columns = self._columns(factors)
        solution = np.linalg.lstsq(columns, self.left, rcond=1e-12)[0]
        free = self._free(columns)
        if free.shape[1] and self.engaged:
            own = free[-len(self.engaged) :]
            solution = solution - free @ np.linalg.lstsq(own, solution[-len(self.engaged) :], rcond=1e-12)[0]
        kept: Array = np.where(np.abs(solution) < _SMALL * np.abs(solution).max(), np.zeros(()), solution)
        return kept

    @staticmethod
    def _free(columns: Array) -> Array:
        """Return a basis of the torques that balance among themselves, one per column."""
        _, values, right = np.linalg.svd(columns)
        rank = int(np.sum(values > 1e-11 * values[0]))
        basis: Array = right[rank:].T
        return basis

    def _rolling_power(self, solution: Array, index: int) -> float:
        speed = self.rolls[index][1]
        return 0.0 if speed is None else float(solution[1 + index] * speed)

    def _balance(self, solution: Array, factors: Sequence[float], consistent: int) -> Balance:
        layout = self.layout
        trains = {}
        for index, train in enumerate(layout.trains):
            numbers = {flange: float(number) for flange, number in train.numbers.items()}
            torques = {flange: float(solution[1 + index]) * number for flange, number in numbers.items()}
            if train.loss is not None and factors[index]:
                loss = train.loss
                scale = numbers[loss.flange] / float(loss.rolling[loss.flange])
                for flange, number in loss.rolling.items():
                    torques[flange] += factors[index] * float(solution[1 + index]) * scale * float(number)
            powers = {
                flange: _product(torque, self.speeds[train.members[flange]]) for flange, torque in torques.items()
            }
            trains[train.name] = TrainLoad(
                torques, powers, self._rolling_power(solution, index) * (1.0 + factors[index])
            )
        count = len(layout.trains)
        elements = {e.name: float(solution[1 + count + k]) + 0.0 for k, e in enumerate(self.engaged)}
        free = self._free(self._columns(factors))[1 + count :]
        undetermined = tuple(element.name for k, element in enumerate(self.engaged) if np.any(np.abs(free[k]) > 1e-9))
        out = float(solution[0])
        given, taken = self.input_torque, out * float(self.speeds[layout.output] or 0.0)
        efficiency = taken / given if given > 0 else given / taken if taken else 0.0
        power, circle = _recirculation(layout, trains, elements, self.speeds, given)
        return Balance(out, elements, trains, efficiency, consistent, undetermined, power, circle, given)


def _product(torque: float, speed: float | None) -> float | None:
    if torque == 0.0:
        return 0.0
    return None if speed is None else torque * speed


def _recirculation(
    layout: Layout,
    trains: Mapping[str, TrainLoad],
    elements: Mapping[str, float],
    speeds: Mapping[str, float | None],
    given: float,
) -> tuple[float, tuple[str, ...]]:
    """Return the power that flows in circles, and the trains that it flows through."""
    flow = nx.DiGraph()

    def add(source: tuple[str, str], target: tuple[str, str], power: float) -> None:
        if abs(power) > 1e-9:
            ends = (source, target) if power > 0 else (target, source)
            flow.add_edge(*ends, power=abs(power) + flow.get_edge_data(*ends, {"power": 0.0})["power"])

    for train in layout.trains:
        for flange, power in trains[train.name].powers.items():
            add(("member", train.members[flange]), ("train", train.name), (power or 0.0) / abs(given))
    for element in layout.elements:
        for member, factor in element.row.items():
            power = elements.get(element.name, 0.0) * float(factor) * (speeds[member] or 0.0)
            add(("member", member), ("element", element.name), power / abs(given))
    total, through = 0.0, []
    while True:
        try:
            edges = nx.find_cycle(flow)
        except nx.NetworkXNoCycle:
            return total, tuple(train.name for train in layout.trains if train.name in through)
        least = min(flow.edges[edge]["power"] for edge in edges)
        total += least
        through += [name for (kind, name), _ in edges if kind == "train"]
        for edge in edges:
            flow.edges[edge]["power"] -= least
            if flow.edges[edge]["power"] <= 1e-12:
                flow.remove_edge(*edge)

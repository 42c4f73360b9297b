"""Wishes for the feedback controllers: kind of the speed control, pairs of speeds, maps of known loss torques."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Annotated, Any, Literal, get_args

from pydantic import BeforeValidator, WithJsonSchema, field_validator, model_validator

from ptgen.components.component import Quantity, Record
from ptgen.errors import Problem, nearest
from ptgen.testbed.names import check_name
from ptgen.testbed.problems import dotted, shown

__all__ = ["LossMap", "SpeedControl", "SpeedControlName", "check_machines", "check_pairs"]

SpeedControlName = Literal["pi", "observer", "super_twisting"]

_KINDS: tuple[str, ...] = get_args(SpeedControlName)


def _speed_control(value: object) -> object:
    """Check the kind of the speed control, one for all machines or a table of machines."""
    entries = value.values() if isinstance(value, dict) else [value]
    for entry in entries:
        if not isinstance(entry, str) or entry not in _KINDS:
            names = " or ".join(f'"{kind}"' for kind in _KINDS)
            remedy = nearest(entry, _KINDS) if isinstance(entry, str) else "write one of them in quotation marks"
            raise ValueError(f"must be {names}, or a table of machines with these, got {shown(entry)}; {remedy}")
    return value


_KIND_SCHEMA: dict[str, Any] = {"type": "string", "enum": list(_KINDS)}

SpeedControl = Annotated[
    SpeedControlName | dict[str, SpeedControlName],
    BeforeValidator(_speed_control),
    WithJsonSchema({"oneOf": [_KIND_SCHEMA, {"type": "object", "additionalProperties": _KIND_SCHEMA}]}),
]
"""One kind for all machines, or a table machine = kind; machines that are not named have a PI controller."""


class LossMap(Record):
    """Loss torque of a component as a function of the speed of its first flange (source (5.96)).

    Between the points the torque is linear, beyond them constant. Without negative speeds the map is odd: the same
    torque brakes in both directions.
    """

    speed: tuple[Annotated[float, Quantity("rad/s", "speed of the first flange", positive=False, signed=True)], ...]
    """Speeds of the first flange, strictly increasing."""
    torque: tuple[Annotated[float, Quantity("N m", "loss torque there", positive=False, signed=True)], ...]
    """Loss torque at each of them; at positive speeds it is positive where it brakes."""

    @field_validator("speed")
    @classmethod
    def _increasing(cls, speed: tuple[float, ...]) -> tuple[float, ...]:
        for before, after in pairwise(speed):
            if after <= before:
                raise ValueError(f"must increase strictly, got {after:g} rad/s after {before:g} rad/s; put it in order")
        if not speed or (speed[0] >= 0 and speed[-1] == 0):
            raise ValueError("needs at least one speed that is not zero; add the speeds at which it was measured")
        return speed

    @model_validator(mode="after")
    def _as_many(self) -> LossMap:
        if len(self.speed) != len(self.torque):
            count, got = len(self.speed), len(self.torque)
            raise ValueError(f"torque needs as many entries as speed ({count}), got {got}; give one for each speed")
        for speed, torque in zip(self.speed, self.torque, strict=True):
            if speed * torque < 0:
                what = f"a loss brakes, but {torque:g} N m at {speed:g} rad/s drives"
                raise ValueError(f"{what}; give torques the sign of their speed")
        return self

    @property
    def is_odd(self) -> bool:
        """Whether the map is continued to negative speeds with the opposite sign."""
        return self.speed[0] >= 0


def check_machines(
    key: str, table: object, wanted: Sequence[str], what: str, unreadable: frozenset[str]
) -> list[Problem]:
    """Return the problems of a table of ``[control]`` whose keys must be among `wanted`; `what` tells what they are."""
    return [
        Problem(dotted("control", key, name), f"is no {what}", nearest(name, wanted))
        for name in (table if isinstance(table, dict) else ())
        if name not in wanted and name not in unreadable
    ]


def check_pairs(pairs: object, speed: Sequence[str], names: Sequence[str]) -> list[Problem]:
    """Return the problems of ``control.speed_pairs``.

    Parameters
    ----------
    pairs : object
        What stands in the file.
    speed : sequence of str
        Machines that control their speed.
    names : sequence of str
        Components; a pair may not be called like one of them.
    """
    if not isinstance(pairs, Mapping):
        return []
    problems: list[Problem] = []
    users: dict[str, str] = {}
    for name, members in pairs.items():
        where = ("control", "speed_pairs", name)
        problems += check_name(name, *where)
        if any(name.lower() == other.lower() for other in names):
            problems.append(Problem(dotted(*where), "is the name of a component too", "choose another name"))
        if not isinstance(members, list) or not all(isinstance(machine, str) for machine in members):
            continue  # reported where the types are checked
        if len(members) != 2:
            what = f"must name two machines, got {len(members)}"
            problems.append(Problem(dotted(*where), what, 'write e.g. ["M2", "M3"]'))
        for index, machine in enumerate(members):
            place = dotted(*where, index)
            if machine not in speed:
                what = f"{shown(machine)} is no machine that controls its speed"
                problems.append(Problem(place, what, nearest(machine, speed)))
            elif machine in users:
                what = f'"{machine}" stands in the pair "{users[machine]}" already'
                problems.append(Problem(place, what, "a machine can be in one pair only"))
            else:
                users[machine] = name
    return problems

"""What every component is: a frozen record of checked SI values that yields elements."""

from __future__ import annotations

import types
import typing
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, ClassVar

import sympy as sp
from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
)
from pydantic.fields import FieldInfo
from pydantic_core import core_schema

from ptgen import units
from ptgen.elements import Body, Elements, Parameter

__all__ = ["Component", "Engagement", "Flange", "Quantity", "Record", "Switch", "Text", "parameters_of"]


_LEAST, _MOST = 1e-12, 1e15
"""SI values beyond these are slips of the pen, and numbers with which no linear algebra could deal."""


@dataclass(frozen=True)
class Quantity:
    """What is wanted of a field that holds a quantity; used as ``Annotated[float, Quantity(...)]``.

    Attributes
    ----------
    unit : str
        SI unit in which the value is held; empty for a plain number.
    description : str
        What it is, one line.
    positive : bool
        Whether the value must be greater than zero (default) or may be zero too.
    signed : bool
        Whether negative values are allowed; zero still is not if `positive`.
    """

    unit: str
    description: str
    positive: bool = True
    signed: bool = False

    def __get_pydantic_core_schema__(self, source: object, handler: GetCoreSchemaHandler) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self._read)

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        described: dict[str, Any] = {"description": f"{self.description} ({units.wanted_units(self.unit)})"}
        if not self.unit:
            return described | {"type": ["number", "string"]}
        pattern = r"^\s*[-+]?[0-9._]+([eE][-+]?[0-9]+)?(\s*[A-Za-z°%µμ(]|\s+1/).*$"
        return described | {"type": "string", "pattern": pattern}

    def _read(self, text: object) -> float:
        value = units.parse(text, self.unit)
        shown = f"{value:g} {self.unit}".strip()
        if self.signed:
            if self.positive and value == 0:
                raise ValueError(f"must not be 0, got {shown}")
        elif value < 0 or (self.positive and value == 0):
            bound = f"{'>' if self.positive else '>='} 0 {self.unit}".strip()
            raise ValueError(f"must be {bound}, got {shown}")
        if abs(value) > _MOST or (self.positive and abs(value) < _LEAST):
            raise ValueError(f"must be a physical quantity, got {shown}; check the number and its unit")
        return value


class Record(BaseModel):
    """A frozen part of a test bed file; unknown keys are problems."""

    model_config = ConfigDict(frozen=True, extra="forbid", use_attribute_docstrings=True)


def _printable(text: str) -> str:
    if any(not character.isprintable() for character in text):
        raise ValueError("must be one line of printable text; remove line breaks and control characters")
    return text


Text = Annotated[str, AfterValidator(_printable)]
"""A line of text that people read."""


def _true_or_false(value: object) -> object:
    if not isinstance(value, bool):
        raise ValueError(f"must be true or false, got {value!r}; write the word without quotation marks")
    return value


Switch = Annotated[bool, BeforeValidator(_true_or_false)]
"""True or false, and nothing that merely looks like it."""


def _quantity_of(info: FieldInfo) -> Quantity | None:
    for meta in info.metadata:
        if isinstance(meta, Quantity):
            return meta
    if typing.get_origin(info.annotation) not in (typing.Union, types.UnionType):
        return None  # the entries of a list are no parameters
    for argument in typing.get_args(info.annotation):
        for meta in getattr(argument, "__metadata__", ()):
            if isinstance(meta, Quantity):
                return meta
    return None


@dataclass(frozen=True)
class Flange:
    """A connection point of a component.

    `may_stay_open` tells whether a bed may leave it unconnected.
    """

    name: str
    may_stay_open: bool = False


@dataclass(frozen=True)
class Engagement:
    """A way in which a component can be in a gear.

    Attributes
    ----------
    elements : tuple of str
        The friction elements that are closed, without the component's name.
    ratios : mapping of str to float
        The keys of ratios that these elements act through, and their values in the gear.
    preselected : bool
        Whether these ratios are set as soon as a shift begins, while the elements still are open; otherwise they
        change while nothing is transmitted.
    """

    elements: tuple[str, ...]
    ratios: Mapping[str, float] = field(default_factory=dict)
    preselected: bool = False


class Component(Record, ABC):
    """A part of a test bed.

    A component knows nothing of other components: it has flanges, parameters and equations. Positive power
    flows from its first flange to the others; a torque at a flange is positive when it drives the neighbour
    on the right of the connection.
    """

    type_name: ClassVar[str]
    summary: ClassVar[str]
    flanges: ClassVar[tuple[Flange, ...]]
    is_machine: ClassVar[bool] = False
    faces_machine: ClassVar[bool] = False
    """Whether the first flange is the one that faces the nearest machine, whatever the order of the chain."""

    @classmethod
    def flange_names(cls) -> tuple[str, ...]:
        """Return the names of the flanges, in order."""
        return tuple(flange.name for flange in cls.flanges)

    @classmethod
    def place_names(cls) -> tuple[str, ...]:
        """Return the names of the sums of flange torques that the component offers, such as ``outputs``."""
        return ()

    def gear_ratios(self) -> Mapping[str, float]:
        """Return the ratio of input speed to output speed in each gear; empty if the component has no gears."""
        return {}

    def gear_elements(self) -> Mapping[str, tuple[str, ...]]:
        """Return the shift elements that stick in each gear, without the component's name; empty if there are none."""
        return {}

    def engagements(self) -> Mapping[str, tuple[Engagement, ...]]:
        """Return the ways in which each gear can be engaged, best first; empty if a scenario cannot shift it."""
        return {gear: (Engagement(elements),) for gear, elements in self.gear_elements().items()}

    def spans(self) -> Mapping[str, tuple[float, float]]:
        """Return the least and the largest value of the keys that change while the bed runs, such as ``ratio``."""
        return {}

    def parameters(self, name: str) -> tuple[Parameter, ...]:
        """Return the parameters of the component called `name`, sub-tables included."""
        spans = {f"{name}_{key}": span for key, span in self.spans().items()}
        return tuple(
            replace(parameter, span=spans.get(parameter.symbol.name), owner=name)
            for parameter in parameters_of(self, name)
        )

    def symbol(self, name: str, *path: str) -> sp.Symbol:
        """Return the symbol of the parameter at `path` of the component called `name`."""
        wanted = "_".join((name, *path))
        for parameter in parameters_of(self, name):
            if parameter.symbol.name == wanted:
                return parameter.symbol
        raise KeyError(wanted)

    def disk_bodies(self, name: str) -> tuple[Body, ...]:
        """Return the bodies of the flanges that have a key for an inertia of their own, where it is given."""
        given = [flange for flange in self.flange_names() if getattr(self, f"inertia_{flange}", None) is not None]
        return tuple(Body(f"{name}.{flange}", self.symbol(name, f"inertia_{flange}")) for flange in given)

    @abstractmethod
    def elements(self, name: str) -> Elements:
        """Return the elements of the component called `name`."""


def parameters_of(record: Record, prefix: str) -> Iterator[Parameter]:
    """Yield the parameters of a record, sub-tables included; their symbols begin with `prefix`."""
    for field_name, info in type(record).model_fields.items():
        value = getattr(record, field_name)
        if isinstance(value, Record):
            yield from parameters_of(value, f"{prefix}_{field_name}")
        meta = _quantity_of(info)
        if meta is not None and value is not None:
            assumptions = (
                {"real": True} if meta.signed else {"positive": True} if meta.positive else {"nonnegative": True}
            )
            symbol = sp.Symbol(f"{prefix}_{field_name}", **assumptions)
            yield Parameter(symbol, float(value), meta.unit, meta.description, meta.positive, meta.signed)

"""Problems in the words of the person who wrote the file."""

from __future__ import annotations

import json
import re
import types
import typing
from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, ValidationError

from ptgen.components.component import Quantity, Record
from ptgen.errors import Problem, nearest

__all__ = ["dotted", "example", "quantity_field", "shown", "validated"]

_EXAMPLES = {
    "": "0.5",
    "N m/rad": "380 kN m/rad",
    "kg m^2": "1.2 kg m^2",
    "N m s/rad": "2 N m s/rad",
    "N m": "400 N m",
    "rad/s": "1500 rpm",
    "rad/s^2": "200 rpm/s",
    "N m/s": "2 kN m/s",
    "s": "100 us",
    "rad": "2 deg",
    "m": "35 mm",
    "W": "700 kW",
    "1/s": "20 1/s",
}

_SIGN = {
    "N m/rad": "check the sign, or connect the flanges directly for a rigid shaft",
    "kg m^2": "check the sign; give the true inertia however small, ptgen drops it where it may",
}

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")

_R = TypeVar("_R", bound=Record)


def dotted(*path: object) -> str:
    """Return a path into a file as it is written there.

    Examples
    --------
    >>> dotted("testbed", "connections", 1)
    'testbed.connections[1]'
    >>> dotted("components", "left wheel", "inertia")
    'components."left wheel".inertia'
    """
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part}]"
            continue
        key = str(part)
        key = key if _BARE_KEY.fullmatch(key) else json.dumps(key, ensure_ascii=False)
        text += f".{key}" if text else key
    return text


def shown(value: object) -> str:
    """Return a value of the file in a few words."""
    try:
        text = json.dumps(value, ensure_ascii=False, default=str)
    except RecursionError:  # dotted keys nest tables as deep as their writer likes
        text = "a table of tables"
    return text if len(text) <= 80 else text[:77] + "..."


def example(unit: str) -> str:
    """Return an example of a quantity that is held in `unit`, as it is written in the file.

    Examples
    --------
    >>> print(example("N m/rad"))
    "380 kN m/rad"
    """
    return f'"{_EXAMPLES.get(unit, f"1 {unit}")}"' if unit else _EXAMPLES[""]


def validated(model: type[_R], table: object, *path: object) -> tuple[_R | None, list[Problem]]:
    """Read a table of the file into a record.

    Parameters
    ----------
    model : type of Record
        The record.
    table : object
        What stands in the file.
    *path : object
        Where it stands.

    Returns
    -------
    record : Record or None
        None if there are problems.
    problems : list of Problem
        All problems of the table.
    """
    if not isinstance(table, dict):
        where = dotted(*path)
        return None, [Problem(where, f"must be a table, got {shown(table)}", f"write it as a table, [{where}]")]
    try:
        return model.model_validate(table), []
    except ValidationError as error:
        details = error.errors(include_url=False)
        return None, [_problem(model, detail, path) for detail in details]


def quantity_field(model: type[BaseModel], location: Iterable[object]) -> Quantity | None:
    """Return what is known of the quantity at `location` in `model`; None if no quantity is there."""
    for annotation in _walk(model, tuple(location)):
        for part in _variants(annotation):
            if typing.get_origin(part) is Annotated:
                for meta in part.__metadata__:
                    if isinstance(meta, Quantity):
                        return meta
    return None


def _variants(annotation: Any) -> Iterator[Any]:
    """Yield the members of a union, or the annotation itself."""
    if typing.get_origin(annotation) in (typing.Union, types.UnionType):
        for part in typing.get_args(annotation):
            yield from _variants(part)
    else:
        yield annotation


def _walk(model: type[BaseModel], location: tuple[object, ...]) -> Iterator[Any]:
    """Yield the annotations that a location may lead to."""
    annotations: list[Any] = [model]
    for step in location:
        below: list[Any] = []
        for annotation in annotations:
            for part in _variants(annotation):
                if isinstance(part, type) and issubclass(part, BaseModel):
                    info = part.model_fields.get(str(step))
                    if info is not None:
                        below.append(Annotated[(info.annotation, *info.metadata)] if info.metadata else info.annotation)
                elif typing.get_origin(part) is dict:
                    below.append(typing.get_args(part)[1])
                elif typing.get_origin(part) is tuple:
                    below.append(typing.get_args(part)[0])
        annotations = below
    yield from annotations


def _record_at(model: type[BaseModel], location: tuple[object, ...]) -> type[BaseModel] | None:
    for annotation in _walk(model, location):
        for part in _variants(annotation):
            if isinstance(part, type) and issubclass(part, BaseModel):
                return part
    return None


def _problem(model: type[Record], detail: Mapping[str, Any], path: tuple[object, ...]) -> Problem:
    location = tuple(detail["loc"])
    where = dotted(*path, *location)
    value = detail["input"]
    field = quantity_field(model, location)
    match detail["type"]:
        case "missing":
            key = location[-1]
            what = f"is missing: {field.description}" if field else "is missing"
            return Problem(where, what, f"add {key} = {example(field.unit) if field else '...'}")
        case "extra_forbidden":
            parent = _record_at(model, location[:-1])
            known = parent.model_fields if parent else ()
            return Problem(where, "is an unknown key", nearest(str(location[-1]), known))
        case "literal_error":
            wanted = detail["ctx"]["expected"].replace("'", '"')
            names = re.findall(r'"([^"]*)"', wanted)
            remedy = nearest(value, names) if isinstance(value, str) else "write one of them"
            return Problem(where, f"must be {wanted}, got {shown(value)}", remedy)
        case "value_error":
            return _of_value(where, str(detail["ctx"]["error"]), field)
        case "model_type" | "dict_type" | "model_attributes_type":
            return Problem(where, f"must be a table, got {shown(value)}", "write it as a table, { key = value }")
        case "string_type":
            return Problem(where, f"must be a text, got {shown(value)}", "put it into quotation marks")
        case "int_type":
            return Problem(where, f"must be a whole number, got {shown(value)}", "write it without a decimal point")
        case "tuple_type" | "list_type":
            return Problem(where, f"must be a list, got {shown(value)}", "put it into brackets, [ ... ]")
    return Problem(where, f"is not understood, {detail['msg']}", "compare it with `ptgen schema`")


def _of_value(where: str, message: str, field: Quantity | None) -> Problem:
    if "; " in message:
        return Problem(where, *message.split("; ", 1))
    if field is None:
        return Problem(where, message, "add it" if " needs a " in message else "change one of the two")
    if re.match(r"must be >=? ", message) or message.startswith("must not be 0"):
        return Problem(where, message, _SIGN.get(field.unit, "check the sign and the unit"))
    if not field.unit:
        return Problem(where, message, f"write a plain number, e.g. {example('')}")
    if message.startswith("must be a finite number"):
        return Problem(where, message, f"write a number that a float can hold, e.g. {example(field.unit)}")
    return Problem(where, message, f"write it with its unit, e.g. {example(field.unit)}")

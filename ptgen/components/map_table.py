"""Tables of points, in the file itself or in the columns of a file beside it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from pydantic import GetJsonSchemaHandler, ValidationError
from pydantic_core import InitErrorDetails, core_schema

from ptgen.components.component import Record

__all__ = ["Finding", "MapTable", "disorder", "refuse"]

Finding = tuple[tuple[str | int, ...], str]
"""Where in a table something is wrong, and the message: what; what to do."""


class MapTable(Record):
    """A table whose keys hold one list each, all of the same length.

    In a file a table may name a file with the lists instead: ``{ file = "map.csv", speed = "n", torque = "T", unit =
    "N m" }``, with the name of a column for each key; the reading of the file puts the lists in their place.
    """

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        described = handler.resolve_ref_schema(handler(schema))
        properties = described["properties"]
        for key, entry in properties.items():
            options = [option for option in entry.pop("anyOf", ()) if option != {"type": "null"}]
            inline = options[0] if options else {name: entry.pop(name) for name in ("type", "items") if name in entry}
            column = {"type": "string", "description": "column of the file"}
            properties[key] = {"description": entry.get("description", key), "oneOf": [inline, column]}
        properties["file"] = {"type": "string", "description": "file with the columns, beside this file"}
        properties["unit"] = {"type": "string", "description": "unit of the torques in the file"}
        return described


def disorder(values: Iterable[float], key: str, least: float = 1e-6) -> list[Finding]:
    """Return the places where a list does not rise, by `least` at least: closer points would be steps of a curve."""
    entries = list(values)
    found: list[Finding] = []
    for k in range(1, len(entries)):
        before, here = entries[k - 1], entries[k]
        if here <= before:
            found.append(((key, k), f"must rise strictly, got {here:g} after {before:g}; put the points in order"))
        elif here - before < least:
            what = f"is only {here - before:.3g} above the point before it"
            found.append(((key, k), f"{what}; points must be {least:g} apart, remove one of the two"))
    return found


def refuse(title: str, findings: Iterable[Finding]) -> None:
    """Raise if anything was found, with all of it.

    Raises
    ------
    ValidationError
        With one error for each finding.
    """
    details = [
        InitErrorDetails(type="value_error", loc=where, input=None, ctx={"error": ValueError(text)})
        for where, text in findings
    ]
    if details:
        raise ValidationError.from_exception_data(title, details)

"""New values for keys of a bed file; everything else stays as it was written, to the byte."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

import tomlkit
from tomlkit.items import InlineTable, Item, String, Table

from ptgen.errors import Problem, TestbedError
from ptgen.testbed.problems import dotted

__all__ = ["with_control"]

_MARK = "\ufeff"


def with_control(content: bytes, changes: Mapping[str, str | float], file: str = "") -> bytes:
    r"""Return the content of a bed file with other values in section ``[control]``.

    A key that is there keeps its place, its spacing and its comment; one that is missing follows the last one.

    Parameters
    ----------
    content : bytes
        Of a file that can be read.
    changes : mapping of str to str or float
        Value of each key: a quantity with its unit, or a plain number.
    file : str
        For messages.

    Raises
    ------
    TestbedError
        If the section is written in a way that cannot be changed without touching anything else.

    Examples
    --------
    >>> with_control(b'[control]\nspeed = ["M1"]  # one\n\n[reduction]\n', {"damping_ratio": 0.7})
    b'[control]\nspeed = ["M1"]  # one\ndamping_ratio = 0.7\n\n[reduction]\n'
    """
    text = content.decode("utf-8")
    mark = _MARK if text.startswith(_MARK) else ""
    text = text.removeprefix(_MARK)
    newline = "\r\n" if "\r\n" in text else "\n"
    wanted = tomllib.loads(text.replace("\r\n", "\n"))
    document = tomlkit.parse(text)
    if tomlkit.dumps(document) == text:
        missing = {}
        for key, value in changes.items():
            table = _holding(document, key)
            if table is None:
                missing[key] = value
            else:
                _replace(table, key, value)
        if missing:
            _append(document, missing, newline)
        for key, value in changes.items():
            wanted["control"][key] = value
        written = tomlkit.dumps(document)
        if tomllib.loads(written.replace("\r\n", "\n")) == wanted:
            return (mark + written).encode("utf-8")
    lines = ", ".join(f"{key} = {_shown(value)}" for key, value in changes.items())
    what = "is written in a way that cannot be changed without touching anything else"
    raise TestbedError(Problem(dotted("control"), what, f"write it yourself: {lines}"), file)


def _tables(document: tomlkit.TOMLDocument) -> list[Table | InlineTable]:
    """Return every piece of the section, one for each heading."""
    return [
        item
        for key, item in document.body
        if key is not None and key.key == "control" and isinstance(item, (Table, InlineTable))
    ]


def _holding(document: tomlkit.TOMLDocument, key: str) -> Table | InlineTable | None:
    return next((table for table in _tables(document) if key in table), None)


def _replace(table: Table | InlineTable, key: str, value: str | float) -> None:
    old: Any = table[key]
    if isinstance(value, str) and isinstance(old, String):
        literal = old.as_string().startswith("'") and "'" not in value
        table[key] = tomlkit.string(value, literal=literal)
    else:
        table[key] = value


def _append(document: tomlkit.TOMLDocument, missing: Mapping[str, str | float], newline: str) -> None:
    """Add keys behind the last one that is written as a line of its own below the section's heading."""
    tables = _tables(document)
    for table in tables:
        last = _last_line(table)
        if last is None:
            continue
        trivia = last.trivia
        lines = [f"{trivia.indent}{key} = {_shown(value)}" for key, value in missing.items()]
        if trivia.trail.endswith("\n"):
            trivia.trail += "".join(line + newline for line in lines)
        else:  # the file ends without a line break
            trivia.trail += newline + newline.join(lines)
        return
    for key, value in missing.items():
        tables[0].add(key, value)


def _last_line(table: Table | InlineTable) -> Item | None:
    """Return the last value of a table that has a line of its own; None if none has."""
    if isinstance(table, InlineTable) or table.is_super_table():
        return None
    found = None
    for key, item in table.value.body:
        if key is None or (isinstance(item, Table) and not key.is_dotted()):
            continue
        if isinstance(item, Table):
            return None  # dotted keys hold lines inside of each other
        found = item
    return found


def _shown(value: str | float) -> str:
    return tomlkit.item(value).as_string()

"""The text of a TOML file: what can go wrong before a single key is read."""

from __future__ import annotations

import hashlib
import re
import tomllib
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from ptgen.errors import Problem, TestbedError

__all__ = ["Document", "read_toml"]

_PLACE = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")

# What tomllib says -> what it means and what to do; {} is the place that it names.
_MEANINGS = (
    (
        r"Cannot declare \((.*)\) twice",
        "the table [{}] stands twice in the file",
        "merge the two, or rename one",
    ),
    (r"Cannot overwrite a value", "the key stands twice in its table", "remove one, or rename it"),
    (r"Cannot mutate immutable namespace (.*)", "{} is already complete", "write all its keys in one place"),
    (r"Expected '=' after a key.*", "a key without a value", 'write key = "value"'),
    (r"Invalid value", "not a value", "put texts and quantities into quotation marks"),
    (r"Unterminated string|Illegal character.*", "a text that does not end", "close the quotation marks"),
    (r"Unclosed array", "a list that does not end", "close the bracket ]"),
    (r"Unclosed inline table", "a table that does not end", "close the brace }}"),
)


@dataclass(frozen=True)
class Document:
    """A TOML file: its path as given, the SHA-256 of its bytes, and its tables."""

    file: str
    digest: str
    tables: dict[str, Any]


def read_toml(path: str | PathLike[str], kind: str) -> Document:
    """Read a TOML file.

    Parameters
    ----------
    path : path-like
        The file.
    kind : str
        What it is, for messages: ``"test bed file"``.

    Raises
    ------
    TestbedError
        If it cannot be read, is not UTF-8 or no TOML.
    """
    file = fspath(path)
    content = _content(file, kind)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        what = f"is not UTF-8 (byte 0x{content[error.start]:02x} in line {line})"
        raise TestbedError(Problem("", what, "save it in the encoding UTF-8"), file) from None
    try:
        tables = tomllib.loads(text.replace("\r\n", "\n"))
    except tomllib.TOMLDecodeError as error:
        raise TestbedError(_syntax(str(error), text), file) from None
    except RecursionError:
        raise TestbedError(Problem("", "is nested too deeply", f"write it as a {kind}"), file) from None
    except ValueError as error:  # a whole number of thousands of digits
        raise TestbedError(Problem("", f"holds an impossible number: {error}", "shorten it"), file) from None
    return Document(file, hashlib.sha256(content).hexdigest(), tables)


def _content(file: str, kind: str) -> bytes:
    try:
        return Path(file).read_bytes()
    except FileNotFoundError:
        raise TestbedError(Problem("", "does not exist", f"check the path of the {kind}"), file) from None
    except IsADirectoryError:
        raise TestbedError(Problem("", "is a directory", f"name the {kind} inside it"), file) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise TestbedError(Problem("", f"cannot be read ({reason})", "check path and permissions"), file) from None


def _syntax(message: str, text: str) -> Problem:
    place = _PLACE.search(message)
    if place is None or place[1] is None:
        line, column = text.count("\n") + 1, len(text) - text.rfind("\n")
    else:
        line, column = int(place[1]), int(place[2])
    message = _PLACE.sub("", message)
    where = f"line {line}, column {column}"
    for pattern, meaning, remedy in _MEANINGS:
        found = re.fullmatch(pattern, message)
        if found:
            named = ".".join(re.findall(r"'([^']*)'", found[1])) if found.groups() else ""
            return Problem(where, f"{meaning.format(named)} (TOML: {message})", remedy.format())
    return Problem(where, f"is no TOML ({message})", "correct this line")

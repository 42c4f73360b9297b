"""The two streams of the command line: results on stdout, messages and progress on stderr."""

from __future__ import annotations

import codecs
import json
import math
import sys
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from rich.console import Console, RenderableType
from rich.text import Text

__all__ = ["messages", "prepare_streams", "print_json", "print_parts", "progress"]

_PLAIN_WIDTH = 120
"""Width of tables when stdout is no terminal."""

_ASCII = {"ω": "omega", "φ": "phi", "Δ": "D", "·": "*", "−": "-", "²": "^2", "³": "^3", "→": "->", "…": "..."}


class _Console(Console):
    """A console that leaves a closed pipe to the caller."""

    def on_broken_pipe(self) -> None:
        raise BrokenPipeError


def messages() -> Console:
    """Return the console for messages and progress, on stderr."""
    return _Console(stderr=True, highlight=False, markup=False)


def print_parts(parts: Iterable[RenderableType]) -> None:
    """Print texts, tables and trees on stdout; lines of text are never wrapped."""
    console = _Console(highlight=False, markup=False)
    if not console.is_terminal:
        console.width = _PLAIN_WIDTH
    for part in parts:
        console.print(part, soft_wrap=isinstance(part, (str, Text)))


def print_json(document: Mapping[str, Any]) -> None:
    """Print a JSON document on stdout, and nothing else; numbers that are not finite become null."""
    sys.stdout.write(json.dumps(_finite(document), indent=2, ensure_ascii=True, allow_nan=False) + "\n")


@contextmanager
def progress(title: str) -> Iterator[tuple[Callable[[str], None], Callable[[float], None]]]:
    """Show a progress bar on stderr, if that is a terminal.

    Yields
    ------
    show : callable
        Names the work that is going on.
    advance : callable
        Takes the share that is done, 0 to 1.
    """
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    console = messages()
    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task(title, total=1.0)

        def show(work: str) -> None:
            bar.update(task, description=f"{title}: {work}")

        def advance(share: float) -> None:
            bar.update(task, completed=share)

        yield show, advance


def prepare_streams() -> None:
    """Let streams of narrow encodings write letters that they lack in other words."""
    codecs.register_error("ptgen.transliterate", _transliterate)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="ptgen.transliterate")


def _transliterate(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    text = error.object[error.start : error.end]
    plain = "".join(
        _ASCII.get(letter) or unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode() or "?"
        for letter in text
    )
    return plain, error.end


def _finite(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(key): _finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(entry) for entry in value]
    if hasattr(value, "item"):  # a number of NumPy
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value

"""Modes as text for the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from ptgen.mechanism.modes import Mode
from ptgen.report.quantities import percent

__all__ = ["modes_text"]

_SHOWN = 4
"""Velocities listed for each mode."""


def modes_text(modes: Sequence[Mode], locked: Sequence[str], free: Sequence[str]) -> Iterator[RenderableType]:
    """Yield a table of the modes and which friction elements stick."""
    table = Table("mode", "frequency", "damping", "moves most (amplitude, largest is 1)", box=box.SIMPLE_HEAD)
    for column in table.columns[:3]:
        column.justify = "right"
    for number, mode in enumerate(modes, start=1):
        rigid = mode.frequency_hz == 0
        frequency = "rigid body" if rigid else f"{mode.frequency_hz:.5g} Hz"
        damping = "" if rigid else percent(mode.damping_ratio)
        largest = sorted(mode.shape.items(), key=lambda item: -abs(item[1]))[:_SHOWN]
        moves = ", ".join(f"{name} {amplitude:+.2f}" for name, amplitude in largest if abs(amplitude) >= 0.05)
        table.add_row(str(number), frequency, damping, Text(moves))
    yield table
    for title, names in (("locked", locked), ("free", free)):
        if names:
            yield Text(f"{title}: {', '.join(names)}")

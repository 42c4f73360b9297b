"""What all figures share: colours, type, and how they are written so that equal figures are equal files."""

from __future__ import annotations

import io
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ptgen.files import write_file
from ptgen.report.destinations import check_destination

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = [
    "BLUE",
    "GREEN",
    "GREY",
    "INK",
    "LIGHT",
    "ORANGE",
    "PALETTE",
    "REFERENCE",
    "check_figure",
    "new_figure",
    "save_figure",
    "set_headline",
]

FORMATS = (".svg", ".png", ".pdf")

# Okabe and Ito's palette: told apart with every common colour blindness; its yellow is too light for lines.
BLUE, ORANGE, GREEN = "#0072B2", "#D55E00", "#009E73"
PALETTE = (BLUE, ORANGE, GREEN, "#CC79A7", "#56B4E9", "#E69F00", "#8C510A")
REFERENCE = "#000000"
INK, GREY, LIGHT = "#222222", "#777777", "#D5D5D5"

_HEADLINE_SIZE = 12
_HEADLINE_CHARACTER = 0.12
"""Width of a character of a headline (inches), the spaces at both sides included."""

_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None, "Creator": "ptgen"},
    ".pdf": {"CreationDate": None, "Creator": "ptgen"},
    ".png": {"Software": "ptgen"},
}
_STYLE = {
    "svg.hashsalt": "ptgen",
    "svg.fonttype": "path",
    "font.family": ["DejaVu Sans"],
    "axes.unicode_minus": True,
}


def check_figure(path: Path, option: str) -> None:
    """Check that a figure can be written to `path`; `option` is what named it."""
    check_destination(path, FORMATS, option)


def new_figure(width: float, height: float, arranged: bool = True) -> Figure:
    """Return an empty figure of `width` times `height` inches; `arranged` lets matplotlib place its axes."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained" if arranged else None, facecolor="white")


def set_headline(figure: Figure, text: str) -> None:
    """Set the title above all axes of a figure, in as many lines as its width asks for."""
    width = int(figure.get_figwidth() / _HEADLINE_CHARACTER)
    figure.suptitle("\n".join(textwrap.wrap(text, width)), fontsize=_HEADLINE_SIZE, fontweight="bold")


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure in the format that the suffix of `path` names; equal figures give equal files."""
    import matplotlib as mpl

    suffix = path.suffix.lower()
    buffer = io.BytesIO()
    with mpl.rc_context(_STYLE):
        figure.savefig(buffer, format=suffix[1:], dpi=150, metadata=_METADATA[suffix])
    write_file(path, buffer.getvalue())

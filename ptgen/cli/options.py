"""Arguments and options that several commands share."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

__all__ = ["AsJson", "BedFile", "ControllerKind", "Directory", "MethodKind", "Precision", "PrecisionOption"]

BedFile = Annotated[Path, typer.Argument(metavar="FILE", help="The test bed file (.toml).", show_default=False)]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON for programs, and nothing else, on stdout.")]
Directory = Annotated[
    Path, typer.Option("--output", "-o", metavar="DIR", help="The folder to write to.", show_default=False)
]


class Precision(StrEnum):
    """Floating-point type of the emitted code."""

    double = "double"
    float = "float"


PrecisionOption = Annotated[Precision, typer.Option("--precision", help="Floating-point type of the emitted code.")]


class ControllerKind(StrEnum):
    """The controllers that a scenario can be run with."""

    decoupling = "decoupling"
    conventional = "conventional"


class MethodKind(StrEnum):
    """The ways in which the plant of a scenario can be simulated."""

    emitted = "emitted"
    events = "events"

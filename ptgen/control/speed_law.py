"""What every kind of speed control offers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

__all__ = ["SpeedLaw"]


@dataclass(frozen=True)
class SpeedLaw:
    """A speed controller in the making.

    It is written in two parts, before and after the limits. The functions that begin one take the writer, the machine's
    name, the control error and the speed (rad/s), and `taken_over`: torque (N m) that the load torque compensation gave
    away in this step, and that the controller's memory has to take over so that the command does not jump.

    Attributes
    ----------
    asked : Symbol
        Virtual input that it asks for (N m).
    finish : callable
        Writes the rest of the step; its argument is what the limits add to the virtual input (N m): zero inside them,
        so what they left is ``asked`` plus that.
    """

    asked: sp.Symbol
    finish: Callable[[sp.Symbol], None]

"""What may stand between the limited references and the control law: a shaper of the references."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Protocol

import sympy as sp

from ptgen.control.envelope import Envelope
from ptgen.control.references import Reference
from ptgen.control.unlimited_law import UnlimitedLaw
from ptgen.control.writer import ControllerWriter

__all__ = ["Shaper", "shaped_reference"]


class Shaper(Protocol):
    """Writes the statements that decide which references the control law gets."""

    def shape(
        self,
        w: ControllerWriter,
        references: Sequence[Reference],
        law: UnlimitedLaw,
        envelopes: Sequence[Envelope],
        measured: Mapping[str, sp.Symbol],
        losses: Sequence[sp.Symbol],
    ) -> None:
        """Declare and assign the state `shaped_reference` of every machine.

        Parameters
        ----------
        w : ControllerWriter
            It stands where all references have passed their rate limiters, before the control law.
        references : sequence of Reference (m)
            Of the machines in their order.
        law : UnlimitedLaw
            What the control law asks of the machines, as a function of the references that it gets.
        envelopes : sequence of Envelope (m)
        measured : mapping of str to Symbol
            The supervised inputs.
        losses : sequence of Symbol
            The known loss torques.
        """


def shaped_reference(reference: Reference) -> str:
    """Return the name of what the control law gets in the place of a reference."""
    return f"{reference.signal}_shaped"

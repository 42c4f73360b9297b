"""Torques of fluids over a step: held, as they are at its middle."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import sympy as sp

from ptgen.block.block import Assign, Call, Signal, Statement, Table, element
from ptgen.elements import FluidCoupling
from ptgen.friction.fluid import FASTER, ROWS
from ptgen.mechanism.model import Model
from ptgen.plant.layout import Layout, identifier
from ptgen.plant.signals import fluid_signals

__all__ = ["Fluids", "fluid_tables"]


class Fluids:
    """The statements that give the torques of fluids.

    Over a step they are taken at the mean of the velocities at its start and of those that are predicted for its end
    with the last torques of friction, contacts and fluids; at the start of the step it would cost an order of accuracy.
    At its end they are computed once more, for the outputs and for the next prediction.

    Parameters
    ----------
    model : Model
    layout : Layout

    References
    ----------
    Source (3.37)-(3.39).
    """

    def __init__(self, model: Model, layout: Layout) -> None:
        self.model = model
        self.layout = layout

    def tables(self) -> tuple[Table, ...]:
        """Return the curves of all fluids."""
        return tuple(table for fluid in self.model.fluids for table in fluid_tables(fluid))

    def states(self) -> list[Signal]:
        """Return the torques at the end of a step."""
        if not self.model.fluids:
            return []
        entries = tuple(name for fluid in self.model.fluids for name in fluid_signals(fluid))
        text = "torques of fluids at the end of the step"
        return [Signal("fluid_torque", "N m", text, (self.layout.n_w,), entries=entries)]

    def at_mid_step(self, predicted: Callable[[int], sp.Expr]) -> list[Statement]:
        """Return the mean torques; `predicted` gives the entries of the state array at the end of the step."""
        first = self.layout.n_f + self.layout.n_c
        targets = [str(element("mean_torque", first + j)) for j in range(self.layout.n_w)]
        return self._torques("mid", lambda k: (element("x", k) + predicted(k)) / 2, targets)

    def at_end(self) -> list[Statement]:
        """Return the torques at the end of the step."""
        targets = [str(element("fluid_torque", j)) for j in range(self.layout.n_w)]
        return self._torques("end", lambda k: element("x", k), targets)

    def _torques(self, when: str, x: Callable[[int], sp.Expr], targets: list[str]) -> list[Statement]:
        statements: list[Statement] = []
        for i, fluid in enumerate(self.model.fluids):
            name = identifier(fluid)
            speeds = (f"{name}_pump_{when}", f"{name}_turbine_{when}")
            for j, (speed, sense) in enumerate(zip(speeds, (1, -1), strict=True)):
                row = sense * self.model.fluid_rows[2 * i + j, :]
                terms = [row[k] * x(k) for k in range(self.layout.n_z) if row[k] != 0]
                value = sum(terms, sp.Integer(0)) / fluid.reference_speed
                statements.append(Assign(speed, value, "speeds by the reference speed"))
            inputs = (*speeds, f"{name}_knots", f"{name}_curves")
            outputs = (targets[2 * i], targets[2 * i + 1])
            statements.append(Call("fluid_torques", outputs, inputs, "(3.37)-(3.39), all quadrants"))
        return statements


def fluid_tables(fluid: FluidCoupling) -> tuple[Table, Table]:
    """Return where the polynomials of the four sectors begin, one column each, and their coefficients."""
    count = max(len(sector.faster) for sector in fluid.sectors)
    knots, curves = np.full((count, 4), 2.0), np.zeros((ROWS, 4 * count))
    for column, sector in enumerate(fluid.sectors):
        knots[: len(sector.faster), column] = sector.share[:-1]
        for k, (faster, slower) in enumerate(zip(sector.faster, sector.slower, strict=True), start=column * count):
            curves[: len(faster), k] = faster
            curves[FASTER : FASTER + len(slower), k] = slower
    name = identifier(fluid)
    begin = "shares of the slower wheel from which each polynomial holds"
    sectors = ("pump faster, forward", "turbine faster, forward", "pump faster, backward", "turbine faster, backward")
    text = f"torques at the reference speed: {FASTER} coefficients of the faster wheel's, the rest of the slower one's"
    return Table(f"{name}_knots", "", begin, knots, sectors), Table(f"{name}_curves", "N m", text, curves)

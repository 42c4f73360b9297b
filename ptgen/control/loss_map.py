r"""Known loss torques as functions of the speed, (5.96).

A map is linear between its points and constant beyond them. A map that is given for one direction is odd; a torque at
0 rpm, whose direction would be unknown there, is reached within a hundredth of the next speed.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ptgen.block.block import Assign, Call, Signal
from ptgen.control.writer import ControllerWriter, signal_symbol
from ptgen.testbed.feedback import LossMap

__all__ = ["BAND", "loss_torques", "points"]

BAND = 0.01
"""Share of the next speed within which a torque at 0 rpm is reached."""


def points(losses: LossMap, torques: list[sp.Expr]) -> list[tuple[float, sp.Expr]]:
    """Return speed (rad/s) and torque of every point of the whole map, negative speeds included.

    Parameters
    ----------
    losses : LossMap
    torques : list of Expr
        Torque at each of its speeds: numbers, or parameters of a controller.

    Examples
    --------
    >>> points(LossMap.model_validate({"speed": ["10 rad/s"], "torque": ["3 N m"]}), [sp.Integer(3)])
    [(-10.0, -3), (10.0, 3)]
    """
    given = list(zip(losses.speed, torques, strict=True))
    if not losses.is_odd:
        return given
    if given[0][0] == 0:
        first = given.pop(0)[1]
        if losses.torque[0] != 0:
            speed, torque = given[0]
            given.insert(0, (BAND * speed, first + sp.Float(BAND) * (torque - first)))
    return [(-speed, -torque) for speed, torque in reversed(given)] + given


def loss_torques(w: ControllerWriter, measured: Mapping[str, sp.Symbol]) -> list[sp.Symbol]:
    """Write the known loss torques (N m) of the law and return them in its order."""
    return [_loss_torque(w, loss.component, loss.speed, measured) for loss in w.design.law.known_losses]


def _loss_torque(w: ControllerWriter, name: str, row: sp.Matrix, measured: Mapping[str, sp.Symbol]) -> sp.Symbol:
    losses = w.tuning.losses[name]
    torques = [
        w.parameter(f"{name}_loss_torque_{k}", "N m", f"loss torque of {name} at {speed:.6g} rad/s", torque, None)
        for k, (speed, torque) in enumerate(zip(losses.speed, losses.torque, strict=True))
        if not (losses.is_odd and speed == torque == 0)
    ]
    if losses.is_odd and losses.speed[0] == losses.torque[0] == 0:
        torques.insert(0, sp.Integer(0))
    whole = points(losses, torques)
    grid, slope, level = f"{name}_loss_speeds", f"{name}_loss_slopes", f"{name}_loss_levels"
    w.derived[grid] = Signal(grid, "rad/s", f"speeds of the loss torque of {name}", (len(whole),))
    w.derived[slope] = Signal(slope, "N m s/rad", f"slopes of the loss torque of {name}", (len(whole),))
    w.derived[level] = Signal(level, "N m", f"loss torque of {name} at these speeds", (len(whole),))
    for k, (speed, torque) in enumerate(whole):
        w.preparation.append(Assign(f"{grid}[{k}]", sp.Float(speed)))
        w.preparation.append(Assign(f"{level}[{k}]", torque))
        following = whole[min(k + 1, len(whole) - 1)]
        width = following[0] - speed
        w.preparation.append(Assign(f"{slope}[{k}]", (following[1] - torque) / width if width else sp.Integer(0)))
    source = "known loss torque (5.96)"
    w.assign(f"{name}_loss_speed", w.sensor_sum(f"{name}_loss_per", row, measured), source)
    w.statements.append(Call("lookup", (f"{name}_known_loss",), (f"{name}_loss_speed", grid, slope, level), source))
    return signal_symbol(f"{name}_known_loss")

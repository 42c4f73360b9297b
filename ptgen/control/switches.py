r"""Switches and dampings that follow their parameter along a ramp, so that a change while the bed runs does not jump.

A change takes ``switch_time``, however large it is: each step moves by (full change) ``h / switch_time``, though not by
less than a millionth of the value, and the last one lands on the parameter exactly. In the first step a switch has the
value of its parameter.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of

__all__ = ["RESOLUTION", "Switch", "follow"]

RESOLUTION = sp.Float("1e-6")
"""Smallest share of its value by which a switch moves in a step, so that it arrives in single precision too."""


@dataclass(frozen=True)
class Switch:
    """Value of a switch in this step and in the last one."""

    now: sp.Symbol
    before: sp.Symbol


def follow(w: ControllerWriter, name: str, unit: str = "") -> Switch:
    """Return what follows the parameter `name` along a ramp.

    Parameters
    ----------
    w : ControllerWriter
        With the parameters `name` and ``sample_time``.
    name : str
    unit : str
        Of the parameter.
    """
    time = w.parameter(
        "switch_time",
        "s",
        "time in which a switch or a damping follows its parameter",
        w.tuning.switch_time,
        allowed=False,
    )
    share = w.derive("switch_share", "", "share of a change per step", signal_symbol("sample_time") / time)
    value = signal_symbol(name)
    now = w.state(f"{name}_now", unit, f"{name} on its way to the parameter")
    target = w.state(f"{name}_target", unit, f"{name} as the last step found it")
    step = w.state(f"{name}_step", unit, f"how far {name} moves in a step")
    before = w.assign(f"{name}_before", w.previous(now, value), f"{name} follows its parameter along a ramp")
    distance = w.assign(f"{name}_distance", value - before)
    least = RESOLUTION * (sp.Abs(value) + sp.Abs(before))  # less would be lost in rounding, and never arrive
    w.assign(step.name, greatest_of(sp.Abs(distance) * share, least), condition=sp.Ne(value, target))
    # In this order a step that is not a number lands at once, so that none is left after a fault.
    far = sp.Abs(distance) > step
    w.assign(now.name, sp.Piecewise((before + greatest_of(-step, smallest_of(step, distance)), far), (value, True)))
    w.assign(step.name, sp.Piecewise((step, far), (sp.Integer(0), True)))
    w.assign(target.name, value)
    return Switch(now, before)

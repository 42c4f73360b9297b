r"""The torque that a machine may be asked for at its speed, Figure 7.1.

Full torque up to the rated speed, constant power above (field weakening). Above ``speed_max`` no torque is left that
would accelerate the machine further: it is taken back in a straight line and is zero at ``speed_max + speed_taper``.
Torque that brakes stays available, so a machine that is driven beyond its speed can always be slowed down.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ptgen.control.writer import ControllerWriter, greatest_of, smallest_of

__all__ = ["TAPER", "Envelope", "envelope"]

TAPER = 0.05
"""Share of the largest speed over which accelerating torque is taken back."""


@dataclass(frozen=True)
class Envelope:
    """Least and largest torque (N m) of a machine in this step."""

    least: sp.Symbol
    most: sp.Symbol

    def clamp(self, torque: sp.Expr, share: sp.Expr = sp.S.One) -> sp.Expr:
        """Return `torque` within a share of the envelope."""
        return greatest_of(share * self.least, smallest_of(share * self.most, torque))

    def opened(self, expression: sp.Expr) -> tuple[sp.Expr, list[tuple[sp.Expr, sp.Expr]]]:
        """Return an expression without what `clamp` did to it, and each share that it limited a torque to.

        Examples
        --------
        >>> least, most, torque = sp.symbols("least most torque", real=True)
        >>> envelope = Envelope(least, most)
        >>> envelope.opened(1 + envelope.clamp(torque, sp.Rational(1, 2)))
        (torque + 1, [(1/2, torque)])
        """
        found = [part for part in sp.preorder_traversal(expression) if self._is_clamp(part)]
        clamped = []
        for part in found:
            inner = next(argument for argument in part.args if isinstance(argument, sp.Min))
            torque = next(argument for argument in inner.args if self.most not in argument.free_symbols)
            limit = next(argument for argument in inner.args if argument is not torque)
            clamped.append((limit / self.most, torque))
            expression = expression.xreplace({part: torque})
        return expression, clamped

    def _is_clamp(self, part: sp.Basic) -> bool:
        return isinstance(part, sp.Max) and {self.least, self.most} <= part.free_symbols


def envelope(w: ControllerWriter, machine: int, measured: Mapping[str, sp.Symbol]) -> Envelope:
    """Return what is available to a machine at its measured speed."""
    name, drive = w.design.machines[machine], w.design.model.inputs[machine].drive
    rated, largest = w.of_bed(drive.speed_rated), w.of_bed(drive.speed_max)
    width = w.parameter(
        f"{name}_speed_taper",
        "rad/s",
        f"speed above {name}_speed_max over which accelerating torque is taken back",
        float(f"{TAPER * w.design.values[drive.speed_max]:.6g}"),
        allowed=False,
    )
    slope = w.derive(f"{name}_taper_slope", "s/rad", f"share of the torque of {name} per excess of speed", 1 / width)
    end = w.derive(f"{name}_taper_end", "", "share at standstill if it were not limited", 1 + largest / width)
    speed = measured[w.speed_sensor(machine)]
    source = "torque-speed envelope, Figure 7.1"
    power = w.derive(f"{name}_power", "W", f"power of {name} above its rated speed", w.of_bed(drive.torque_max) * rated)
    available = w.assign(f"{name}_available", power / greatest_of(rated, sp.Abs(speed)), source)
    above, below = (greatest_of(0, smallest_of(1, end - sign * slope * speed)) for sign in (1, -1))
    return Envelope(
        least=w.assign(f"{name}_least", -available * below, source),
        most=w.assign(f"{name}_most", available * above, source),
    )

r"""PI speed control (5.84) with Hanus's conditioning.

.. math:: u = k_p e + x, \qquad \dot x = k_i \left(e + \frac{u^r - u}{k_p}\right)

The bracket is the error of the *realisable reference* :math:`w^r = w + (u^r - u) / k_p`: the one for which the
controller itself would have asked for what the limits left, :math:`u^r`. So the integrator runs as if that reference
had been given, and does not wind up.
"""

from __future__ import annotations

import sympy as sp

from ptgen.control.speed_law import SpeedLaw
from ptgen.control.writer import ControllerWriter, signal_symbol

__all__ = ["pi_control"]


def pi_control(w: ControllerWriter, name: str, error: sp.Expr, speed: sp.Expr, taken_over: sp.Expr) -> SpeedLaw:
    """Write the PI controller of the machine `name`; see `ptgen.control.speed_law.SpeedLaw`."""
    gain = signal_symbol(f"{name}_speed_gain")
    integral_gain = w.parameter(
        f"{name}_speed_integral_gain",
        "N m/rad",
        f"integral gain of the speed of {name}",
        w.gains.speed_integral[name],
    )
    h = signal_symbol("sample_time")
    per_error = w.derive(f"{name}_speed_growth", "N m s/rad", "growth of the integrator per error", h * integral_gain)
    per_torque = w.derive(f"{name}_speed_conditioning", "", "growth per torque cut off", h * integral_gain / gain)
    integral = w.state(f"{name}_speed_integral", "N m", f"integrator of the speed control of {name}")
    kept = sp.Piecewise((taken_over, integral_gain > 0), (sp.Integer(0), True))
    before = w.assign(f"{name}_integral_before", w.previous(integral, sp.Integer(0)) + kept, "PI speed control (5.84)")
    asked = w.assign(f"{name}_asked", gain * error + before)

    def finish(cut: sp.Symbol) -> None:
        grown = before + per_error * error + per_torque * cut
        w.assign(integral.name, grown, "conditioning anti-windup (Hanus)")

    return SpeedLaw(asked, finish)

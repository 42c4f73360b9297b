r"""Experimental: super-twisting speed control, after the sliding mode controllers that the source mentions in 5.5.

.. math:: u = k_1 \frac{e}{\sqrt{|e| + \delta}} + x, \qquad \dot x = k_2 \frac{e}{|e| + \delta}

For :math:`\delta = 0` this is the super-twisting algorithm, which reaches the reference in finite time although a
disturbance changes at a bounded rate. The layer :math:`\delta` makes it linear for small errors, so that sampling and
dead time do not make it chatter. The integrator stands while the machine is at its limit and the error would drive it
further. The source found no improvement over (5.84), and neither delay nor higher modes were analysed for it here.
"""

from __future__ import annotations

import sympy as sp

from ptgen.control.speed_law import SpeedLaw
from ptgen.control.writer import ControllerWriter, signal_symbol

__all__ = ["super_twisting"]


def super_twisting(w: ControllerWriter, name: str, error: sp.Expr, speed: sp.Expr, taken_over: sp.Expr) -> SpeedLaw:
    """Write the super-twisting controller of the machine `name`, experimental; see `SpeedLaw`."""
    gains = w.gains.super_twisting[name]
    k1 = w.parameter(f"{name}_twisting_gain", "N m (s/rad)^0.5", f"k1 of {name}, experimental", gains.k1, allowed=False)
    k2 = w.parameter(f"{name}_twisting_rate", "N m/s", f"k2 of {name}, experimental", gains.k2)
    layer = w.parameter(
        f"{name}_twisting_layer",
        "rad/s",
        f"error of {name} below which it is linear, experimental",
        gains.layer,
        allowed=False,
    )
    growth = w.derive(
        f"{name}_twisting_growth", "N m", "growth of the integrator in a step", signal_symbol("sample_time") * k2
    )
    integral = w.state(f"{name}_speed_integral", "N m", f"integrator of the speed control of {name}")
    source = "EXPERIMENTAL: super-twisting speed control"
    kept = sp.Piecewise((taken_over, k2 > 0), (sp.Integer(0), True))
    before = w.assign(f"{name}_integral_before", w.previous(integral, sp.Integer(0)) + kept, source)
    size = w.assign(f"{name}_error_size", sp.Abs(error) + layer, source)
    asked = w.assign(f"{name}_asked", k1 * error / sp.sqrt(size) + before, source)

    def finish(cut: sp.Symbol) -> None:
        grown = before + growth * error / size
        beyond = cut * error < 0
        w.assign(
            integral.name, sp.Piecewise((before, beyond), (grown, True)), "EXPERIMENTAL: integrator of super-twisting"
        )

    return SpeedLaw(asked, finish)

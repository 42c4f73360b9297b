r"""P speed control with disturbance observer (5.85)-(5.93).

The observer (5.88) is discretised so that it is exact for a held torque and a constant disturbance,

.. math:: \hat T_{k+1} = a \hat T_k + (1 - a) \left(v_k - I_m \frac{\omega_{k+1} - \omega_k}{h}\right),
          \qquad a = \frac{1}{1 + h \hat b},

because the bracket *is* the disturbance; so the estimation error decays with :math:`a^k` whatever the controller does,
and is stable for every :math:`\hat b \ge 0` (implicit Euler). With :math:`z_k = \hat T_k + \beta I_m \omega_k`,
:math:`\beta = \hat b / (1 + h \hat b)`, this is the z-form (5.90), (5.91) of the source. What is stored is
:math:`r_k = z_k - \beta I_m \omega_{k-1}` and the last speed: the same numbers without the difference of two large
ones, and the bandwidth may be changed while the machine turns.

`v` is what the limits left, so the observer does not take a limit for a disturbance, and does not wind up.
"""

from __future__ import annotations

import sympy as sp

from ptgen.control.speed_law import SpeedLaw
from ptgen.control.writer import ControllerWriter, signal_symbol

__all__ = ["observer_control"]


def observer_control(w: ControllerWriter, name: str, error: sp.Expr, speed: sp.Expr, taken_over: sp.Expr) -> SpeedLaw:
    """Write the P controller with disturbance observer of the machine `name`; see `SpeedLaw`."""
    gain = signal_symbol(f"{name}_speed_gain")
    bandwidth = w.parameter(
        f"{name}_observer_bandwidth",
        "rad/s",
        f"bandwidth of the disturbance observer of {name}",
        w.gains.observer_bandwidth[name],
    )
    h = signal_symbol("sample_time")
    inertia = w.rotor(name)
    learnt = w.derive(
        f"{name}_observer_share", "", "share that the observer learns in a step", 1 - 1 / (1 + h * bandwidth)
    )
    momentum = w.derive(
        f"{name}_observer_momentum",
        "N m s/rad",
        "torque per change of speed",
        inertia * bandwidth / (1 + h * bandwidth),
    )
    state = w.state(
        f"{name}_observer", "N m", f"disturbance of {name} as of the last speed, z of (5.89) relative to it"
    )
    last = w.state(f"{name}_speed_last", "rad/s", f"speed of {name} in the last step")
    source = "P speed control with disturbance observer (5.91), (5.92)"
    kept = sp.Piecewise((taken_over, bandwidth > 0), (sp.Integer(0), True))
    change = w.assign(f"{name}_speed_change", speed - w.previous(last, speed), source)
    disturbance = w.assign(f"{name}_disturbance", w.previous(state, sp.Integer(0)) + kept - momentum * change, source)
    asked = w.assign(f"{name}_asked", gain * error + disturbance, source)

    def finish(cut: sp.Symbol) -> None:
        learned = disturbance + learnt * (asked + cut - disturbance)
        w.assign(state.name, learned, "disturbance observer (5.90)")
        w.assign(last.name, speed)

    return SpeedLaw(asked, finish)

"""Individual feedback: every machine works for its own quantity, with active damping (source Section 6.3, Figure 5.10).

A torque-controlled machine gets the torque that its own shaft asks for, and a damping torque as if a damper lay
beside the stiffness that it sees; a speed-controlled one its load torque compensation, if the sensors give it.
There are no cross terms, so this works where the decoupling matrix is singular.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ptgen.control import findings
from ptgen.control.lie import AffineSystem
from ptgen.control.measured_law import Balance
from ptgen.control.sensor_rows import SensorRows
from ptgen.control.state_law import StateLaw, Wishes
from ptgen.mechanism import exact
from ptgen.mechanism.model import LinearForm

__all__ = ["individual_law"]


def individual_law(
    rows: SensorRows,
    balances: Sequence[Balance | None],
    system: AffineSystem,
    outputs: Mapping[str, LinearForm],
    wishes: Wishes,
    swinging: Sequence[str],
) -> tuple[StateLaw, sp.Matrix]:
    """Return the law over the states, and its rows over the sensors (m, n_s).

    Parameters
    ----------
    rows : SensorRows
    balances : sequence of Balance or None (m)
        Of the rotors.
    system : AffineSystem
    outputs : mapping of str to LinearForm
        The controlled quantities, torques first.
    wishes : Wishes
    swinging : sequence of str
        Components whose inertia stands between the machines.

    Raises
    ------
    ControlError
        If the speeds that the damping needs are not measured.

    References
    ----------
    Source (5.62) without the acceleration torque, Section 6.3.
    """
    model = rows.model
    m, count = len(wishes.actuators), len(rows.sensors)
    stiffness = exact.canonical(model.twist_rows.T * model.stiffness * model.twist_rows)
    P, R = sp.zeros(m, m), sp.zeros(m, count)
    for index, (form, machine) in enumerate(zip(outputs.values(), wishes.actuators, strict=True)):
        if index >= wishes.torque_count:
            found = balances[machine]
            P[machine, index] = sp.Integer(1) if found is None else 1 / found.share
            if found is not None:
                R[machine, :] = -found.sensors / found.share
            continue
        of_own_twist = (form.e * model.twist_rows[:, machine])[0]
        P[machine, index] = stiffness[machine, machine] / of_own_twist
        twist_rate = stiffness[machine, :] / stiffness[machine, machine]
        wanted = rows.unknown_part(sp.Matrix.hstack(twist_rate, sp.zeros(1, len(model.twists))), rows.F[:1, :] * 0)
        velocity = next(iter(model.inputs[machine].row))
        speeds = rows.combination(rows.unknown_part(rows.C, rows.F), wanted, rows.order(velocity, speeds_first=True))
        if speeds is None:
            raise findings.unmeasured(f"the damping by {model.inputs[machine].name}", model, swinging)
        R[machine, :] = -wishes.damping[index] * speeds
    P, R = exact.canonical(P), exact.canonical(R)
    around = exact.solve(sp.eye(m) - R * rows.D, sp.Matrix.hstack(P, R * rows.C, R * rows.F))
    state_law = StateLaw(around[:, :m], around[:, m : m + system.order], around[:, m + system.order :])
    return state_law, R

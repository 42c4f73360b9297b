r"""Stationary limits of torque references, (7.34), and of speed references: steps 1 to 3 of Figure 7.4.

At rest every machine gives what its torque references ask of it and what friction adds,

.. math:: u_i = \sum_j Y_{ij} \tilde r_j + d_i,

with the torques d that the sensors show now: what acts on the rotor less :math:`Y` times the testing torques, such as
half of the torque of a limited slip. A torque reference is scaled down so far that :math:`u_i` stays within
:math:`(1 - \varepsilon_1)(1 - \varepsilon_\infty)` of the limits: by machines that it alone concerns, then together
with the others by machines that they share. It never changes its sign.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.control.references import Reference
from ptgen.control.writer import ControllerWriter, greatest_of, signal_symbol, smallest_of

__all__ = ["limited_speeds", "limited_torques"]

Array = NDArray[np.float64]

_TINY = sp.Float("1e-30")


def limited_speeds(w: ControllerWriter, references: Sequence[Reference], at_rest: Array) -> dict[int, sp.Expr]:
    """Write steps 2 and 3: every speed reference within what is left of the machines' largest speeds.

    Where several speeds drive a machine that controls a torque, they are scaled down together until it keeps its own
    (7.19); the source looks at each reference by itself.

    Parameters
    ----------
    w : ControllerWriter
    references : sequence of Reference (m)
    at_rest : ndarray (m, m)
        Speed of each machine at rest, per reference.
    """
    source = "largest speeds (7.19), steps 2 and 3 of Figure 7.4"
    speeds = [k for k, reference in enumerate(references) if reference.unit != "N m"]
    values: dict[int, sp.Expr] = {}
    rows: dict[int, dict[int, sp.Symbol]] = {}
    rooms: dict[int, tuple[sp.Symbol, sp.Symbol]] = {}
    for machine, reference in enumerate(references):
        driven = {k: at_rest[machine, k] for k in speeds if at_rest[machine, k] != 0}
        if not driven:
            continue
        name, drive = w.design.machines[machine], w.design.model.inputs[machine].drive
        bound = w.derive(
            f"{name}_governed_speed",
            "rad/s",
            f"largest speed to which the governor lets references drive {name}",
            (1 - signal_symbol("governor_stationary_reserve")) * w.of_bed(drive.speed_max),
        )
        if machine in speeds:
            within = greatest_of(-bound, smallest_of(bound, reference.limited))
            values[machine] = w.assign(f"{reference.signal}_bounded", within, source)
            continue
        rooms[machine] = (bound, bound)
        for k, factor in driven.items():
            text = f"speed of {name} at rest per {references[k].signal}"
            value = float(f"{factor:.9g}")
            row = rows.setdefault(machine, {})
            row[k] = w.parameter(f"{name}_speed_at_rest_{references[k].signal}", "", text, value, None)
    if rows:
        involved = {k for row in rows.values() for k in row}
        values |= _scaled(w, "speed_references", {k: values[k] for k in involved}, rows, rooms, source)
    return {k: w.assign(f"{references[k].signal}_within", value, source) for k, value in values.items()}


def limited_torques(
    w: ControllerWriter,
    references: Sequence[Reference],
    limits: Sequence[tuple[sp.Expr, sp.Expr]],
    stationary: Array,
    measured: Mapping[str, sp.Symbol],
) -> dict[int, sp.Expr]:
    """Write step 1: every torque reference within the stationary limits of all machines.

    Parameters
    ----------
    w : ControllerWriter
    references : sequence of Reference (m)
    limits : sequence of tuple (m)
        Least and largest torque of every machine (N m).
    stationary : ndarray (m, m)
        Y: torque of each machine at rest, per reference.
    measured : mapping of str to Symbol
    """
    torques = [k for k, reference in enumerate(references) if reference.unit == "N m"]
    values: dict[int, sp.Expr] = {k: references[k].limited for k in torques}
    source = "stationary limits (7.34), step 1 of Figure 7.4"
    rows: dict[int, dict[int, sp.Symbol]] = {}
    for machine, name in enumerate(w.design.machines):
        for k in torques:
            if stationary[machine, k] == 0:
                continue
            text = f"torque of {name} at rest per {references[k].signal}"
            value = float(f"{stationary[machine, k]:.9g}")
            rows.setdefault(machine, {})[k] = w.parameter(
                f"{name}_at_rest_{references[k].signal}", "", text, value, None
            )
    rooms: dict[int, tuple[sp.Symbol, sp.Symbol]] = {}
    kept = 1 - signal_symbol("governor_stationary_reserve")
    for machine, row in rows.items():
        name = w.design.machines[machine]
        other = _held_torque(w, machine, measured)
        if other is not None:
            other -= sp.Add(*(factor * references[k].present for k, factor in row.items()))
        beside = w.assign(f"{name}_beside", other if other is not None else sp.Integer(0), source)
        least, most = limits[machine]
        rooms[machine] = (
            w.assign(f"{name}_room_below", beside - kept * least),
            w.assign(f"{name}_room_above", kept * most - beside),
        )
    for k in torques:
        own = [machine for machine, row in rows.items() if set(row) == {k}]
        values[k] = _scaled(w, f"{references[k].signal}", {k: values[k]}, {i: rows[i] for i in own}, rooms, source)[k]
    shared = {machine: row for machine, row in rows.items() if len(row) > 1}
    if shared:
        values = _scaled(w, "torque_references", values, shared, rooms, source)
    return {k: w.assign(f"{references[k].signal}_within", value, source) for k, value in values.items()}


def _scaled(
    w: ControllerWriter,
    name: str,
    values: Mapping[int, sp.Expr],
    rows: Mapping[int, Mapping[int, sp.Symbol]],
    rooms: Mapping[int, tuple[sp.Symbol, sp.Symbol]],
    source: str,
) -> dict[int, sp.Expr]:
    """Return references that are scaled down until the torques of all rows find room."""
    shares: list[sp.Expr] = [sp.Integer(1)]
    for machine, row in rows.items():
        prefix = f"{name}_of_{w.design.machines[machine]}"
        reach = w.assign(f"{prefix}_reach", sp.Add(*(factor * values[k] for k, factor in row.items())), source)
        below, above = rooms[machine]
        room = greatest_of(0, sp.Piecewise((above, reach > 0), (below, True)))
        room = w.assign(f"{prefix}_room", room, source)
        shares.append(room / greatest_of(room, sp.Abs(reach), _TINY))
    if len(shares) == 1:
        return dict(values)
    share = w.assign(f"{name}_share_at_rest", smallest_of(*shares), source)
    return {k: share * value for k, value in values.items()}


def _held_torque(w: ControllerWriter, machine: int, measured: Mapping[str, sp.Symbol]) -> sp.Expr | None:
    """Return the torque that would keep a rotor at its speed, from the sensors; None if they do not give it."""
    balance = w.design.law.balance[machine]
    if balance is None or {n for k, n in enumerate(w.design.sensors) if balance.sensors[k] != 0} - measured.keys():
        return None
    unknown = {p.symbol for p in w.design.model.changing if p.symbol.name not in w.run_time}
    if (set(balance.sensors.free_symbols) | balance.share.free_symbols) & unknown:
        return None
    row = -balance.sensors / balance.share
    return w.sensor_sum(f"{w.design.machines[machine]}_holding", row, measured)

"""Beds for the proof of stability, and their parameters in the symbols of the source."""

from __future__ import annotations

from functools import cache

import sympy as sp
from mechanism.bed_text import Bed, two_machines

from ptgen.analysis.symbolic_loop import ACCELERATION_TORQUE, LOAD_COMPENSATION, SymbolicLoop
from ptgen.control.decoupling import Decoupling
from ptgen.project import Project

s = sp.Symbol("s")
Im1, Im2, c, d_des = sp.symbols("Im1 Im2 c d_des", positive=True)
igb, g_w, g_t, kff, kp1, ki1, kp2, ki2 = sp.symbols("igb gamma_w gamma_T kff kp1 ki1 kp2 ki2", real=True)

_NAMES = {
    "M1_inertia_estimate": Im1,
    "M1_inertia": Im1,
    "M2_inertia": Im2,
    "shaft1_stiffness": c,
    "flange1_shaft1_flange2_stiffness": c,
    "gearbox1_ratio": igb,
    "M1_damping": d_des,
    "M1_feedforward": kff,
    "M1_torque_gain": kp1,
    "M1_torque_integral_gain": ki1,
    "M2_speed_gain": kp2,
    "M2_speed_integral_gain": ki2,
    LOAD_COMPENSATION.name: g_w,
    ACCELERATION_TORQUE.name: g_t,
}


def in_source(value: sp.Matrix | sp.Expr) -> sp.Matrix | sp.Expr:
    """Return an expression in the symbols of Section 5.7 of the source."""
    return value.subs({symbol: _NAMES[symbol.name] for symbol in value.free_symbols if symbol.name in _NAMES})


@cache
def geared() -> Project:
    """Two machines with a transmission between; the shaft is on the side of M1, as (5.44) has it."""
    bed = Bed()
    bed.add("shaft1", "shaft", stiffness=30e3)
    bed.add("gearbox1", "gearbox", ratio=2.0, inertia=0.02)
    bed.add("flange2", "torque_flange", inertia=0.01, stiffness=400e3)
    bed = two_machines(["shaft1", "gearbox1", "flange2"], bed, "shaft1")
    bed.reduction = {"rigid": ["flange2"], "drop": ["gearbox1", "flange2"]}
    return Project(bed.load())


@cache
def five_machines() -> Project:
    """One torque-controlled machine, three differentials, four speed-controlled machines."""
    bed = Bed()
    for k in range(1, 6):
        bed.machine(f"M{k}", 1.0 + k)
        bed.add(f"flange{k}", "torque_flange", inertia=0.03, stiffness=3e5, damping=0.5)
    for k in range(1, 8):
        bed.add(f"cardan{k}", "shaft", stiffness=2e4 * k, damping=2.0)
    for name, ratio in (("diff", 3.0), ("diff2", 2.5), ("diff3", 2.0)):
        bed.add(name, "differential", ratio=ratio, inertia=0.1, inertia_pinion=0.05)
    bed.chains = [
        "M1 - flange1 - cardan1 - diff.input",
        "diff.output1 - cardan2 - diff2.input",
        "diff.output2 - cardan3 - diff3.input",
        "diff2.output1 - cardan4 - flange2 - M2",
        "diff2.output2 - cardan5 - flange3 - M3",
        "diff3.output1 - cardan6 - flange4 - M4",
        "diff3.output2 - cardan7 - flange5 - M5",
    ]
    bed.torque, bed.speed = {"M1": "diff.input"}, ["M2", "M3", "M4", "M5"]
    return Project(bed.load())


def is_zero(value: sp.Expr | sp.Matrix) -> bool:
    """Tell whether an expression, or every entry of a matrix, is identically zero."""
    entries = list(value) if isinstance(value, sp.MatrixBase) else [value]
    return all(sp.cancel(sp.together(entry)) == 0 for entry in entries)


def switched(loop: SymbolicLoop, load: int, acceleration: int) -> SymbolicLoop:
    """Return the loop with both switches in a position."""
    return loop.at({LOAD_COMPENSATION: load, ACCELERATION_TORQUE: acceleration})


def all_symbols(decoupling: Decoupling, loop: SymbolicLoop) -> list[sp.Symbol]:
    """Return parameters of the bed, gains and switches."""
    return [*decoupling.values, *loop.gains, LOAD_COMPENSATION, ACCELERATION_TORQUE]

"""A rigid shaft, and one that is very stiff: Figures 3.17 to 3.20. Equations and modes: notebooks/modular.py."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import numpy as np

from validation.case import ROOT, RPM, Case, Number, Panel, draw, rms

sys.path.insert(0, str(ROOT / "notebooks"))

from beds import bed, machine, table
from runs import Run, run_emitted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["CASES"]

STIFFNESSES = (500e3, 2000e3, 8000e3)
"""That of shaft 1 in Table 3.2 (N m/rad), and stiffer ones."""


def _run(stiffness: float | None) -> Run:
    """Return the run of Figure 3.20 with the parameters of Table 3.2; without a stiffness shaft 1 is rigid."""
    parts = [
        machine("M1", 1.0),
        machine("M2", 2.0),
        table("clutch", "clutch", capacity="200 N m", inertia_input="0.1 kg m^2", inertia_output="0.1 kg m^2"),
        table("shaft2", "shaft", stiffness="5 kN m/rad", damping="3 N m s/rad"),
    ]
    chain = "M1 - clutch - shaft2 - M2"
    if stiffness is not None:
        parts.append(table("shaft1", "shaft", stiffness=f"{stiffness!r} N m/rad", damping="10 N m s/rad"))
        chain = "M1 - shaft1 - clutch - shaft2 - M2"
    project = bed([chain], *parts, torque={}, speed=["M1", "M2"])

    def drive(t: float) -> float:
        return 100.0 if 0.2 <= t < 0.75 else 0.0

    torques, actuations = {"M1": drive, "M2": drive}, {"clutch": lambda t: float(t >= 0.5)}
    return run_emitted(project, np.zeros(len(project.model.coordinates)), torques, actuations, 1.0)


def _figure_3_20() -> tuple[list[Number], Figure]:
    rigid = _run(None)
    modular = {stiffness: _run(stiffness) for stiffness in STIFFNESSES}
    numbers, panels = [], []
    speeds = [(f"n{k}, rigid", rigid.time, rigid[f"M{k}_speed"] / RPM) for k in (1, 2)]
    first = modular[STIFFNESSES[0]]
    panels.append(
        Panel(
            "n1, n2 (rpm)",
            [*speeds, *((f"ref: n{k}, modular", first.time, first[f"M{k}_speed"] / RPM) for k in (1, 2))],
        )
    )
    for k in (1, 2):
        curves = []
        for stiffness, recording in modular.items():
            error = (recording[f"M{k}_speed"] - rigid[f"M{k}_speed"]) / RPM
            said = "similar results, the difference negligible" if stiffness == STIFFNESSES[0] else "-"
            name = f"difference of n{k}, {stiffness / 1e3:.0f} kN m/rad"
            numbers.append(Number(f"greatest {name}", float(np.abs(error).max()), "rpm", said))
            numbers.append(Number(f"rms {name}", rms(error), "rpm", "-"))
            curves.append((f"{stiffness / 1e3:.0f} kN m/rad", recording.time, error))
        panels.append(Panel(f"error of n{k} (rpm)", curves))
    return numbers, draw(panels)


CASES = (
    Case(
        "figure-3-20",
        "Figures 3.17 to 3.20: rigid and modular model of a clutch between two bodies",
        "Shaft 1 is rigid in the original model and a stiff spring in the modular one. With the stiffness big enough "
        "both yield similar results: a second mode in n1, which decays fast, and a slightly different first mode.",
        "Agrees, with the parameters of Table 3.2. The difference is below 1 rpm, and goes to zero as the stiffness of "
        "shaft 1 grows.",
        _figure_3_20,
    ),
)

"""The derivation of a bed with a bearing, a brake and a gap."""

from __future__ import annotations

import json
import re

import pytest
from matplotlib.mathtext import MathTextParser
from mechanism.bed_text import two_machines
from rich.console import Console

from ptgen.project import Project
from ptgen.report.derivation import Derivation, derivation
from ptgen.report.derivation_latex import derivation_latex
from ptgen.report.derivation_text import derivation_text
from ptgen.report.plain import derivation_json


@pytest.fixture(scope="module")
def found() -> Derivation:
    middle = two_machines(["flange1", "cardan1", "bearing1", "box_1", "brake1", "cardan2", "flange2"])
    middle.add("flange1", "torque_flange", inertia=0.03, stiffness=380e3, damping=0.5)
    middle.add("cardan1", "shaft", stiffness=57e3, damping=2.0)
    middle.add("bearing1", "bearing", coulomb=1.0, static="2 N m", stribeck_speed="10 rpm", inertia=0.01)
    middle.add("box_1", "gearbox", ratio=2.0, inertia=0.03, inertia_other=0.05, mesh_stiffness="300 kN m/rad")
    middle.components["box_1"]["play"] = "0.1 deg"
    middle.add("brake1", "brake", capacity="200 N m", inertia=0.05, ripple={"amplitude": 0.1, "order": 3})
    middle.add("cardan2", "shaft", stiffness=45e3, damping=1.0, backlash="0.5 deg")
    middle.add("flange2", "torque_flange", inertia=0.04, stiffness=220e3, damping=0.5)
    return derivation(Project(middle.load()))


def text_of(found: Derivation) -> str:
    console = Console(width=1000)
    with console.capture() as captured:
        for part in derivation_text(found):
            console.print(part, markup=False, highlight=False)
    return captured.get()


def test_text_shows_laws_limits_gaps_and_rules(found: Derivation) -> None:
    text = text_of(found)
    for line in (
        "T_fr(bearing1) = (bearing1_coulomb + (bearing1_static − bearing1_coulomb)·exp(−|w|/bearing1_stribeck_speed))",
        "at rest |T_fr(bearing1)| ≤ bearing1_static",
        "T_fr(brake1) = μ(brake1)·((1 + brake1_ripple_amplitude·sin(3·∫w dt + brake1_ripple_phase))·brake1_capacity",
        "T(box_1) = 0 within box_1_play = 0.1 deg",
        "T(cardan2) = 0 within cardan2_backlash = 0.5 deg",
        "close backlash",
        "friction elements free",
    ):
        assert line in text


def test_latex_can_be_typeset(found: Derivation) -> None:
    text = derivation_latex(found)
    parser = MathTextParser("path")
    blocks = re.findall(r"\\begin\{align\*\}(.*?)\\end\{align\*\}", text, flags=re.DOTALL)
    rows = [row.strip() for block in blocks if "bmatrix" not in block for row in block.split(r"\\")]
    for row in rows:
        parser.parse(f"${row.replace('&', '')}$")
    assert r"\theta_{\mathrm{box\_1}}" in text
    assert text.count(r"\left(") == text.count(r"\right)")


def test_json_has_the_laws(found: Derivation) -> None:
    model = json.loads(json.dumps(derivation_json(found)))["model"]
    assert model["gaps"] == pytest.approx({"box_1": 0.1 * 0.017453292519943295, "cardan2": 0.5 * 0.017453292519943295})
    laws = model["friction_laws"]
    assert list(laws) == model["frictions"]
    assert laws["bearing1"]["role"] == "loss" and laws["brake1"]["role"] == "coupling"
    assert laws["brake1"]["actuated"] and not laws["bearing1"]["actuated"]
    assert laws["brake1"]["velocity"] == {"brake1.left": "1"}


def test_closed_loop_is_that_of_the_closed_gaps(found: Derivation) -> None:
    """A bed that stands inside its gap has no mode at all between the machines."""
    slow = [mode.frequency_hz for mode in found.modes_before if mode.frequency_hz > 0]
    poles = found.closed_loop["conventional"]
    assert min(abs(pole.frequency_hz / slow[0] - 1) for pole in poles) < 0.05
    assert all(pole.damping_ratio > 0 for pole in poles)

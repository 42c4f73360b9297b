"""A transmission is a ratio for control: the law is that of (5.52) and (5.62), the plant keeps what it has."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from control_laws import expanded, is_zero, symbols

from ptgen.loops.loop_analysis import analyse
from ptgen.mechanism.control_bed import control_bed
from ptgen.mechanism.model import evaluate_matrix
from ptgen.project import Project
from ptgen.simulate.run import simulate
from ptgen.testbed import load_scenario

TRANSMISSION = """
[components.gears]
type = "clutch"
capacity = "1500 N m"
actuated = true
inertia_input = "0.02 kg m^2"
inertia_output = "0.03 kg m^2"

[reduction]
as_ratio = ["gears"]
gear_ratios = { gears = { R = -3.3, 1 = 4.7, 2 = 3.13, direct = 1.0 } }
design_gear = { gears = "direct" }
"""


@pytest.fixture(scope="module")
def project(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The shipped bed with a fixed gear, a clutch in place of its gearbox."""
    text = (root / "testbeds" / "transmission-fixed-gear.toml").read_text(encoding="utf-8")
    begin, end = text.index("[components.gearbox]"), text.index("[components.shaft2]")
    text = text[:begin] + text[end:] + TRANSMISSION
    text = text.replace('"components.shaft2", "components.gearbox",', '"components.shaft2",')
    text = text.replace("gearbox.", "gears.").replace("transmission_fixed_gear", "as_ratio")
    file = tmp_path_factory.mktemp("bed") / "bed.toml"
    file.write_text(text, encoding="utf-8")
    return Project.read(file)


def test_law_is_5_52_and_5_62(project: Project) -> None:
    decoupling = project.design.decoupling
    p, law = symbols(decoupling), decoupling.law_expressions()
    i, I1, I2, d = p["gears_ratio"], p["M1_inertia_estimate"], p["M2_inertia"], p["M1_damping"]
    v1, v2, w1, w2, rate = sp.symbols("v_M1 v_M2 M1_speed M2_speed gears_ratio_rate")
    assert is_zero(law["M1"] - (v1 + I1 * (i * v2 / I2 + w2 * rate) - d * (w1 - i * w2)))
    assert is_zero(law["M2"] - (v2 - sp.Symbol("flange2_torque")))


def test_stiffness_is_5_15_for_every_ratio(project: Project) -> None:
    decoupling = project.design.decoupling
    stiffness = expanded(decoupling, decoupling.stiffness[0])
    ratio = symbols(decoupling)["gears_ratio"]
    c1, c2 = 1 / (1 / 380e3 + 1 / 25e3), 1 / (1 / 40e3 + 1 / 220e3)
    for i in (-3.3, -1.0, 0.0, 1.0, 4.7):
        found = evaluate_matrix(sp.Matrix([[stiffness]]), {**decoupling.values, ratio: i})[0, 0]
        assert found == pytest.approx(c1 * c2 / (i**2 * c1 + c2))


def test_plant_keeps_the_component(project: Project) -> None:
    assert "gears_actuation" in {signal.name for signal in project.plant.inputs}
    assert "gears_ratio" not in {signal.name for signal in project.plant.inputs}
    assert "gears_ratio" in {signal.name for signal in project.controller.inputs}
    assert control_bed(project.testbed).components["gears"].type_name == "gearbox"


def test_rule_tells_what_is_neglected(project: Project) -> None:
    rule = project.reduced.rules[0]
    assert (rule.rule, rule.element) == ("as ratio", "gears")
    assert rule.numbers["inertia"] == pytest.approx(0.02 + 0.03)  # in direct drive
    assert (rule.numbers["least_ratio"], rule.numbers["largest_ratio"]) == (-3.3, 4.7)
    dropped = next(r for r in project.reduced.rules if r.element.startswith("gears") and r.rule == "drop inertia")
    assert 0 < dropped.numbers["kinetic_share"] < 0.2


def test_loops_are_those_of_the_bed_for_control(project: Project) -> None:
    found = analyse(project)
    assert found.is_stable and found.free == ()
    assert found.margins is not None and found.margins.delay.time > 5e-4


def test_run_feeds_the_ratio_to_the_controller_alone(project: Project, tmp_path: Path) -> None:
    file = tmp_path / "case.toml"
    file.write_text(
        '[scenario]\nduration = "2 s"\nrecord_every = "1 ms"\n'
        '[references]\ntorque.M1 = { time = ["1 s", "1.2 s"], value = ["0 N m", "300 N m"] }\n'
        'speed.M2 = { time = ["0 s", "1 s"], value = ["0 rpm", "500 rpm"] }\n'
        '[actuations]\ngears = { time = ["0 s"], value = [1] }\n'
        '[ratios]\ngears = { time = ["0.5 s", "1 s"], value = [4.7, 1.0] }\n',
        encoding="utf-8",
    )
    run = simulate(project, load_scenario(file, project.testbed))
    assert run.signals["gears_ratio"][0] == 4.7 and run.signals["gears_ratio_limited"][-1] == 1.0
    assert run.signals["gears_input_torque"][-1] == pytest.approx(300, abs=3)
    assert run.signals["gears_speed"][-1] == 0.0


def test_reverse_gear_turns_the_sense_of_the_law(project: Project) -> None:
    law, p = project.design.decoupling.law, symbols(project.design.decoupling)
    assert is_zero(law.P[0, 1] + law.P[0, 1].subs(p["gears_ratio"], -p["gears_ratio"]))


def with_gear_set(root: Path, folder: Path, part: str, gear: str) -> Project:
    """Return the shipped bed with a fixed gear, a gear set in place of its gearbox, designed for one of its gears."""
    text = (root / "testbeds" / "transmission-fixed-gear.toml").read_text(encoding="utf-8")
    begin, end = text.index("[components.gearbox]"), text.index("[components.shaft2]")
    text = text[:begin] + text[end:]
    for old, new in (('"components.gearbox",', ""), ("gearbox.", "gears."), ("transmission_fixed_gear", "as_ratio")):
        text = text.replace(old, new)
    text += f'[components.gears]\ntype = "part"\nfile = "{part}.toml"\n'
    text += f'[reduction]\nas_ratio = ["gears"]\ndesign_gear = {{ gears = "{gear}" }}\n'
    (folder / "bed.toml").write_text(text, encoding="utf-8")
    return Project.read(folder / "bed.toml")


@pytest.mark.parametrize(
    ("part", "gear", "ratio", "inertia"),
    [
        ("nine-speed", "1", 5.503220611916264, 0.0271878),
        ("nine-speed", "4", 1.6611111111111112, 0.156622),  # with an element that is idle
        ("nine-speed", "6", 1.0, 0.12),
        ("seven-speed-dual-clutch", "2", 10.085227272727273, 0.0286398),  # the other branch turns freely
        ("six-speed-lepelletier", "R", -3.402520385470719, 0.0273696),
    ],
)
def test_numbers_of_the_rule_are_those_of_the_gear_set(
    part: str, gear: str, ratio: float, inertia: float, root: Path, tmp_path: Path
) -> None:
    rule = with_gear_set(root, tmp_path, part, gear).reduced.rules[0]
    assert (rule.rule, rule.element) == ("as ratio", "gears")
    assert rule.numbers["ratio"] == pytest.approx(ratio, rel=1e-14)
    assert rule.numbers["inertia"] == inertia

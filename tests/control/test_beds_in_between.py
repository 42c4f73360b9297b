"""Legal beds that the shipped ones do not cover: an inertia between the machines, more machines, slow torque loops."""

from __future__ import annotations

from pathlib import Path

import pytest

from ptgen.errors import ControlError, ModelError, TestbedError
from ptgen.project import Project


def changed(root: Path, tmp_path: Path, bed: str, *changes: tuple[str, str], more: str = "") -> Path:
    text = (root / "testbeds" / f"{bed}.toml").read_text()
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    path = tmp_path / "bed.toml"
    path.write_text(text + more)
    return path


FLYWHEEL = '\n[components.fly]\ntype = "inertia"\ninertia = "4 kg m^2"\n' + (
    '[components.shaft2]\ntype = "shaft"\nstiffness = "60 kN m/rad"\ndamping = "10 N m s/rad"\n'
)
CHAIN = ("M1 - flange1 - shaft1 - flange2 - M2", "M1 - flange1 - shaft1 - fly - shaft2 - flange2 - M2")


def test_heavy_inertia_between_the_machines_gets_advice_that_works(root: Path, tmp_path: Path) -> None:
    bed = changed(root, tmp_path, "back-to-back", CHAIN, more=FLYWHEEL)
    with pytest.raises(ControlError, match=r'drop = \["fly"\]'):
        _ = Project.read(bed).design
    bed = changed(root, tmp_path, "back-to-back", CHAIN, more=FLYWHEEL + '\n[reduction]\ndrop = ["fly"]\n')
    assert Project.read(bed).design.decoupling.relative_degrees == (2, 1)


def test_dead_time_beyond_the_delay_line_is_named(root: Path, tmp_path: Path) -> None:
    bed = changed(root, tmp_path, "back-to-back", ('dead_time = "100 us"', 'dead_time = "100 ms"'))
    with pytest.raises(ModelError, match=r"components\.M1\.inverter\.dead_time"):
        _ = Project.read(bed).plant


def test_numbers_that_no_machine_has_are_refused(root: Path, tmp_path: Path) -> None:
    bed = changed(root, tmp_path, "back-to-back", ('stiffness = "380 kN m/rad"', 'stiffness = "1e200 kN m/rad"'))
    with pytest.raises(TestbedError, match="physical quantity"):
        Project.read(bed)


def test_four_machines_and_two_differentials_get_their_law(root: Path, tmp_path: Path) -> None:
    more = """
[components.diff2]
type = "differential"
ratio = 3.0
inertia = "0.1 kg m^2"
inertia_pinion = "0.05 kg m^2"
[components.cardan4]
type = "shaft"
stiffness = "70 kN m/rad"
damping = "2 N m s/rad"
[components.cardan5]
type = "shaft"
stiffness = "50 kN m/rad"
damping = "2 N m s/rad"
[components.flange4]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "220 kN m/rad"
[components.M4]
type = "machine"
inertia = "8 kg m^2"
torque_max = "3700 N m"
speed_rated = "1800 rpm"
speed_max = "6000 rpm"
"""
    chains = ", ".join(
        f'"{chain}"'
        for chain in (
            "diff.output1 - cardan5 - diff2.input",
            "diff2.output1 - cardan2 - flange2 - M2",
            "diff2.output2 - cardan4 - flange4 - M4",
        )
    )
    bed = changed(
        root,
        tmp_path,
        "differential",
        ('"diff.output1 - cardan2 - flange2 - M2"', chains),
        ('speed = ["M2", "M3"]', 'speed = ["M2", "M3", "M4"]'),
        more=more,
    )
    law = Project.read(bed).design.decoupling.law_expressions()
    assert str(law["M4"]) == "-flange4_torque + v_M4"
    assert {"v_M2", "v_M3", "v_M4", "M1_inertia_estimate"} <= {symbol.name for symbol in law["M1"].free_symbols}

"""Closed loops with a torque converter: emitted against event-driven plant, in the bed and in a part."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from plant.converter_bed import FILE, converter_bed
from plant.small_beds import two_machines

from ptgen.project import Project
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario

pytestmark = pytest.mark.compile

H = 1e-4

PART = '[part]\nflanges = { input = "tc.pump", output = "tc.turbine" }\n'


def inside_a_part(folder: Path) -> Project:
    (folder / "auto.toml").write_text(PART + FILE, encoding="utf-8")
    reduction = '[reduction]\nlocked = ["gb.tc.lockup"]\ndrop = ["gb"]\n'
    part = '[components.gb]\ntype = "part"\nfile = "auto.toml"\n'
    return two_machines(folder, "flange1 - gb - shaft1", f"{part}\n{reduction}")


def run(project: Project, element: str, method: str) -> Recording:
    references = {
        "torque.M1": Profile((0.0, 0.01), (0.0, 400.0), "lines"),
        "speed.M2": Profile((0.0, 0.04), (0.0, 6.0), "lines"),
    }
    actuations = {element: Profile((0.0, 0.04, 0.05), (0.0, 0.0, 0.3), "lines")}
    scenario = Scenario("case", "", "", 600 * H, 10 * H, references, actuations)
    return simulate(project, scenario, method=method, parameters={"load_compensation": 0.0})


def test_emitted_and_event_driven_runs_agree(tmp_path: Path) -> None:
    project = converter_bed(tmp_path)
    emitted, events = (run(project, "tc.lockup", method) for method in ("emitted", "events"))
    assert list(emitted.signals) == list(events.signals)
    names = ("tc_fluid_pump_torque", "tc_fluid_turbine_torque", "M1_speed", "M2_speed", "flange1_torque")
    for name in names:
        size = np.abs(emitted.signals[name]).max()
        assert size > 0.1
        assert np.abs(emitted.signals[name] - events.signals[name]).max() < 2e-3 * size, name


def test_a_part_with_a_converter_is_the_converter(tmp_path: Path) -> None:
    (tmp_path / "plain").mkdir()
    plain = run(converter_bed(tmp_path / "plain"), "tc.lockup", "emitted")
    part = run(inside_a_part(tmp_path), "gb.tc.lockup", "emitted")
    for name in ("tc_fluid_pump_torque", "tc_fluid_turbine_torque", "tc_lockup_torque", "tc_lockup_speed"):
        expected = plain.signals[name]
        assert part.signals[f"gb_{name}"] == pytest.approx(expected, abs=1e-9 * (1 + np.abs(expected).max()))

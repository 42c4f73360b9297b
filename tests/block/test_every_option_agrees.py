"""A controller with every option of the feedback: the three evaluators agree on it."""

from __future__ import annotations

from pathlib import Path

import agreement
import numpy as np
import pytest

from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.testbed import load

pytestmark = pytest.mark.compile

OPTIONS = """\
speed_control = { M2 = "observer", M3 = "super_twisting" }
speed_pairs = { rear = ["M2", "M3"] }
torque_gain = 0.3

[control.losses.gearbox2]
speed = ["0 rpm", "500 rpm", "1500 rpm"]
torque = ["2 N m", "9 N m", "20 N m"]

[control.losses.gearbox3]
speed = ["-1500 rpm", "-100 rpm", "400 rpm"]
torque = ["-20 N m", "-3 N m", "8 N m"]
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory, root: Path) -> Project:
    text = (root / "testbeds" / "differential-gearboxes.toml").read_text(encoding="utf-8")
    head, tail = text.split("damping_ratio", 1)
    line, _, rest = tail.partition("\n")
    file = tmp_path_factory.mktemp("bed") / "bed.toml"
    file.write_text(f"{head}damping_ratio{line}\n{OPTIONS}{rest}", encoding="utf-8")
    return Project(load(file))


@pytest.mark.parametrize("seed", [None, 4, 5])
def test_all_evaluators_agree(project: Project, seed: int | None) -> None:
    block = project.controller
    compiled = build(project).controller
    batch = agreement.random_batch(block, 4000 if seed is None else 300, seed or 1)
    batch.states["running"] = (np.random.default_rng(0).random(batch.size) < 0.9).astype(float)
    parameters = NumpyBlock(block).defaults() if seed is None else agreement.random_parameters(block, seed)
    reference = agreement.by_numpy(block, parameters, batch)
    for other in (agreement.by_casadi(block, parameters, batch), agreement.by_c(compiled, parameters, batch)):
        difference, where = agreement.largest_difference(block, reference, other)
        assert difference < 1e-12, where

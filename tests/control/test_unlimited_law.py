"""The law that a shaper gets is the emitted one without its limits: values and derivatives, with everything changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from mechanism.bed_text import Bed, differential_bed, two_machines

from ptgen.block.block import Assign, Block, Call
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.control.controller import controller_block
from ptgen.control.envelope import Envelope
from ptgen.control.references import Reference
from ptgen.control.shaper import shaped_reference
from ptgen.control.unlimited_law import UnlimitedLaw, unlimited_law
from ptgen.control.writer import ControllerWriter, signal_symbol
from ptgen.project import Project


class Probe:
    """Gives the law what the states ``given_<k>`` say, and writes down what the law should make of it."""

    def shape(
        self,
        w: ControllerWriter,
        references: Sequence[Reference],
        law: UnlimitedLaw,
        envelopes: Sequence[Envelope],
        measured: Mapping[str, sp.Symbol],
        losses: Sequence[sp.Symbol],
    ) -> None:
        given = [w.state(f"given_{k}", reference.unit, "given") for k, reference in enumerate(references)]
        chain = dict(zip(law.references, given, strict=True))
        for k in law.order:
            value = w.state(f"unlimited_{k}", "N m", "command without limits")
            w.assign(value.name, law.commands[k].xreplace(chain))
            chain[law.symbols[k]] = value
        for name, estimate in law.estimates.items():
            w.assign(w.state(f"{name}_found", "N m", "estimate").name, estimate.xreplace(chain))
        for (i, j), entry in np.ndenumerate(np.array(law.gain)):
            w.assign(w.state(f"gain_{i}_{j}", "", "gain").name, sp.sympify(entry))
        for reference, value in zip(references, given, strict=True):
            w.assign(w.state(shaped_reference(reference), reference.unit, "shaped").name, value)


def probed(project: Project) -> Block:
    design, bed = project.design, project.testbed
    full = project.reduced.full
    return controller_block(design.decoupling, design.gains, bed.tuning, full, bed.sample_time, Probe()).block


def check(project: Project, seed: int) -> None:
    block, rng = probed(project), np.random.default_rng(seed)
    functions = CasadiBlock(block)
    parameters = np.array([s.value for s in block.parameters])
    for k, signal in enumerate(block.parameters):
        if signal.name.endswith(("_gain", "_bandwidth", "_stiffness", "_damping", "_estimate", "_feedforward")):
            parameters[k] *= rng.uniform(0.5, 2.0)
        elif signal.name in ("load_compensation", "acceleration_torque") or signal.name.endswith("_torque_model"):
            parameters[k] = rng.uniform(0.0, 1.0)
        if signal.name.endswith("_torque_gain"):
            parameters[k] = rng.uniform(-0.5, 0.5)
    ratios = {p.symbol.name: p.value for p in project.design.decoupling.model.changing}
    inputs = np.array([ratios.get(s.name, rng.normal() * (1e-3 if "speed" in s.name else 1e-2)) for s in block.inputs])
    inputs[[s.name for s in block.inputs].index("reset")] = 0.0
    derived = functions.prepare(parameters)
    start = np.array([s.value for s in block.states])
    for _ in range(3):
        start = functions.step(parameters, derived, start, inputs)[0].full().ravel()
    names = [s.name for s in block.states]
    for k, name in enumerate(names):
        if name.startswith("given_"):
            start[k] = rng.normal() * 1e-3
        if name.endswith(("_integral", "_observer", "_model_torque")):
            start[k] = rng.normal() * 1e-2
        if name.endswith("_now"):  # on their way
            start[k] *= rng.uniform(0.5, 1.0)
    x = ca.MX.sym("x", len(names))
    after, outputs = functions.step(parameters, derived, x, inputs)
    table = ca.Function("f", [x], [after, outputs, ca.jacobian(outputs, x)])(start)
    states, torques, slopes = (np.array(part.full()) for part in table)
    value = dict(zip(names, states.ravel(), strict=True))
    m = len(block.outputs)
    largest = np.abs(torques).max()
    assert 0 < largest < 10.0, "far from all limits"
    np.testing.assert_allclose([value[f"unlimited_{k}"] for k in range(m)], torques.ravel(), rtol=1e-9, atol=1e-11)
    columns = [names.index(f"given_{k}") for k in range(m)]
    gain = np.array([[value[f"gain_{i}_{j}"] for j in range(m)] for i in range(m)])
    np.testing.assert_allclose(gain, slopes[:, columns], rtol=1e-9, atol=1e-11 * np.abs(gain).max())
    assert np.linalg.matrix_rank(gain / np.abs(gain).max(axis=1, keepdims=True)) == m


@pytest.mark.parametrize("seed", [1, 2])
def test_of_every_bed(project: Project, seed: int) -> None:
    check(project, seed)


def with_losses() -> Bed:
    bed = Bed()
    for name in ("flange1", "flange2"):
        bed.add(name, "torque_flange", inertia=0.03, stiffness=380e3)
    bed.add("shaft1", "shaft", stiffness=20e3)
    bed.add("shaft2", "shaft", stiffness=60e3)
    bed.add("box", "gearbox", ratio=2.0, inertia=0.02, ratio_range=[1.0, 4.0])
    return two_machines(["flange1", "shaft1", "box", "shaft2", "flange2"], bed)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(
    "control",
    [
        {"speed_control": "observer", "torque_gain": "0.3"},
        {"speed_control": {"M2": "observer"}, "speed_pairs": {"rear": ["M2", "M3"]}},
        {"torque_gain": "-0.4", "feedforward": 0.7},
    ],
)
def test_of_options(control: dict[str, object], seed: int) -> None:
    bed = differential_bed()
    bed.control = control
    check(Project(bed.load()), seed)


@pytest.mark.parametrize("seed", [1, 2])
def test_of_a_ratio_that_changes(seed: int) -> None:
    check(Project(with_losses().load()), seed)


def test_of_known_losses(root: Path, tmp_path: Path) -> None:
    text = (root / "testbeds" / "differential-gearboxes.toml").read_text(encoding="utf-8")
    losses = '\n[control.losses.gearbox2]\nspeed = ["0 rpm", "500 rpm"]\ntorque = ["2 N m", "9 N m"]\n'
    head, mark, tail = text.partition("[control]")
    assert mark
    control, bracket, rest = tail.partition("\n[")
    file = tmp_path / "bed.toml"
    file.write_text(f"{head}{mark}{control}{losses}{bracket}{rest}", encoding="utf-8")
    check(Project.read(file), 1)


def test_super_twisting_is_not_affine() -> None:
    bed = differential_bed()
    bed.control = {"speed_control": "super_twisting"}
    with pytest.raises(ValueError, match="not affine"):
        probed(Project(bed.load()))


def test_a_kernel_in_between_is_refused() -> None:
    r, u = signal_symbol("r"), signal_symbol("u")
    statements = [Call("share", ("x",), ("r",)), Assign("u", signal_symbol("x"))]
    with pytest.raises(ValueError, match="share"):
        unlimited_law(statements, [], [r], [u])

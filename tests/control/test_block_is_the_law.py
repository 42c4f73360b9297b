"""The emitted block computes the law of the design: every term of it, for every shipped bed."""

from __future__ import annotations

import numpy as np
import pytest
from controller_steps import Controller
from mechanism.bed_text import Bed, differential_bed

from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.layout import signal_name
from ptgen.project import Project


def opposed() -> Bed:
    """Both outputs of an open differential brake with a torque of their own: individual feedback, Section 6.3."""
    bed = differential_bed()
    bed.torque, bed.speed = {"M2": "diff.output1", "M3": "diff.output2"}, ["M1"]
    bed.control = {"structure": "individual"}
    return bed


def check(project: Project, seed: int) -> None:
    """Compare a step far from all limits with ``u = P v + R y``; v is the net torque of a speed-controlled rotor."""
    design, rng = project.design.decoupling, np.random.default_rng(seed)
    torque_machines = design.actuators[: design.torque_count]
    changes = {f"{design.machines[k]}_torque_model": 0.0 for k in torque_machines}
    controller = Controller(project.controller, changes)
    inputs = {s.name: float(rng.normal() * (1e-3 if "speed" in s.name else 1e-2)) for s in project.controller.inputs}
    inputs |= {parameter.symbol.name: parameter.value for parameter in design.model.changing} | {"reset": 0.0}
    controller.step(**inputs)
    charged = {f"{design.machines[k]}_torque_integral": np.array(rng.normal() * 1e-2) for k in torque_machines}
    controller.states |= charged
    outputs = controller.step(**inputs)
    u = np.array([outputs[f"{name}_torque_ref"] for name in design.machines])

    value = {s.name: s.value for s in project.controller.parameters}
    table = {symbol: value.get(symbol.name, number) for symbol, number in design.values.items()}
    table |= {symbol: value[symbol.name] for symbol in design.damping}
    P, R = evaluate_matrix(design.law.P, table), evaluate_matrix(design.law.R, table)
    y = np.array([inputs.get(sensor, 0.0) for sensor in design.sensors])
    v = np.empty(len(design.machines))
    for position, machine in enumerate(design.actuators):
        name = design.machines[machine]
        if position >= design.torque_count:
            v[position] = (u[machine] - R[machine] @ y) / P[machine, position]
            assert not np.delete(P[machine], position).any(), "a speed needs nothing of other outputs"
        else:
            reference = inputs[signal_name(design.outputs[position]) + "_ref"]
            v[position] = value[f"{name}_feedforward"] * reference + float(charged[f"{name}_torque_integral"])
    np.testing.assert_allclose(u, P @ v + R @ y, rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("seed", range(3))
def test_of_the_shipped_beds(projects: dict[str, Project], seed: int) -> None:
    for project in projects.values():
        check(project, seed)


@pytest.mark.parametrize("seed", range(3))
def test_of_individual_feedback(seed: int) -> None:
    check(Project(opposed().load()), seed)

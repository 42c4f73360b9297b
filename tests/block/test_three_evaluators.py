"""NumPy, CasADi and C give the same numbers for every block of every bed."""

from __future__ import annotations

import agreement
import numpy as np
import pytest

from ptgen.block.block import Block
from ptgen.block.numpy_evaluator import NumpyBlock
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import CompiledBlock, Library

TOLERANCE = 1e-12


@pytest.fixture(scope="module")
def libraries() -> dict[str, Library]:
    return {}


@pytest.fixture
def library(project: Project, libraries: dict[str, Library]) -> Library:
    name = project.testbed.name
    if name not in libraries:
        libraries[name] = build(project)
    return libraries[name]


def parts(project: Project, library: Library, block: str) -> tuple[Block, CompiledBlock]:
    return (project.controller, library.controller) if block == "controller" else (project.plant, library.plant)


@pytest.mark.compile
@pytest.mark.parametrize("block", ["controller", "plant"])
def test_agree_on_random_inputs(block: str, project: Project, library: Library) -> None:
    description, compiled = parts(project, library, block)
    # CasADi works through all sectors of the friction elements; with three or more that takes its time.
    size = 1_000 if len(project.plant_model.frictions) > 2 and block == "plant" else 10_000
    batch = agreement.random_batch(description, size, seed=1)
    parameters = NumpyBlock(description).defaults()
    reference = agreement.by_numpy(description, parameters, batch)
    for other in (agreement.by_casadi(description, parameters, batch), agreement.by_c(compiled, parameters, batch)):
        difference, where = agreement.largest_difference(description, reference, other)
        assert difference < TOLERANCE, where


@pytest.mark.compile
@pytest.mark.parametrize("seed", [2, 3])
@pytest.mark.parametrize("block", ["controller", "plant"])
def test_agree_with_other_parameters(block: str, seed: int, project: Project, library: Library) -> None:
    description, compiled = parts(project, library, block)
    batch = agreement.random_batch(description, 200, seed)
    parameters = agreement.random_parameters(description, seed)
    reference = agreement.by_numpy(description, parameters, batch)
    for other in (agreement.by_casadi(description, parameters, batch), agreement.by_c(compiled, parameters, batch)):
        difference, where = agreement.largest_difference(description, reference, other)
        assert difference < TOLERANCE, where


@pytest.mark.compile
def test_agree_along_a_run(project: Project, library: Library) -> None:
    """Each step of a closed-loop run, started from the state that the compiled code had."""
    trace: dict[str, agreement.Batch] = {}
    results: dict[str, agreement.Values] = {}
    states: dict[str, list] = {"controller": [], "plant": []}
    inputs: dict[str, list] = {"controller": [], "plant": []}
    outcome: dict[str, list] = {"controller": [], "plant": []}
    loop = {}
    for name, compiled in (("controller", library.controller), ("plant", library.plant)):
        params = compiled.defaults()
        status, state = compiled.init(params)
        assert status == 0
        loop[name] = (compiled, params, state)
    measured = library.plant.measure(loop["plant"][2], loop["plant"][1])
    references = project.design.controller.references

    def step(name: str, given: dict[str, float]) -> dict[str, float]:
        compiled, params, state = loop[name]
        states[name].append({s.name: compiled.read(state, s.name) for s in compiled.block.states})
        inputs[name].append(given)
        status, outputs = compiled.step(state, params, given)
        assert status == 0
        outcome[name].append({**{s.name: compiled.read(state, s.name) for s in compiled.block.states}, **outputs})
        return outputs

    changing = [p.symbol.name for p in project.mechanism.changing]
    held = {name: project.plant.declared(name).value for name in changing[1:]}  # two alike would tie their clutches up
    for k in range(1500 if len(project.plant_model.frictions) > 2 else 3000):
        time = k * project.testbed.sample_time
        wanted = {
            signal: (300.0 * np.sin(20 * time) if key.startswith("torque") else 30 * max(0.0, np.sin(15 * time)))
            for key, signal in references.items()
        }
        pressed = {
            s.name: (s.least or 0.0) + (s.most - (s.least or 0.0)) * abs(np.sin(9 * time + i))
            for i, s in enumerate(project.plant.inputs)
            if s.most is not None
        } | held
        known = measured | pressed
        given = {s.name: known.get(s.name, 0.0) for s in project.controller.inputs} | wanted
        commands = step("controller", given)
        measured = step("plant", commands | pressed)
    for name, block in (("controller", project.controller), ("plant", project.plant)):
        trace[name] = agreement.Batch(
            *({key: np.array([row[key] for row in rows]) for key in rows[0]} for rows in (states[name], inputs[name]))
        )
        results[name] = {key: np.array([row[key] for row in outcome[name]]) for key in outcome[name][0]}
        parameters = NumpyBlock(block).defaults()
        for other in (
            agreement.by_numpy(block, parameters, trace[name]),
            agreement.by_casadi(block, parameters, trace[name]),
        ):
            difference, where = agreement.largest_difference(block, results[name], other)
            assert difference < TOLERANCE, where


@pytest.mark.compile
def test_preparation_agrees(project: Project, library: Library) -> None:
    compiled = library.plant
    evaluator = NumpyBlock(project.plant)
    derived = evaluator.prepare(evaluator.defaults())
    status, state = compiled.init(compiled.defaults())
    assert status == 0
    for signal in project.plant.derived:
        expected = derived[signal.name]
        got = compiled.read(state, signal.name)
        assert np.abs(got - expected).max() <= TOLERANCE * max(np.abs(expected).max(), 1e-300), signal.name

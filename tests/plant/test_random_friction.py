"""Friction of random mechanisms: what sticks is at rest, friction only takes power, the energy balance closes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plant.random_friction import STEP, Kind, random_model

from ptgen.block.kernels import KERNELS
from ptgen.block.numpy_evaluator import NumpyBlock, Values
from ptgen.mechanism.model import evaluate_matrix
from ptgen.plant.plant import plant_block

seeds = st.integers(0, 10**6)


@dataclass(frozen=True)
class Step:
    """One step of a run: states before and after, outputs, air-gap torques, mean friction torques."""

    before: Values
    after: Values
    outputs: Values
    torques: np.ndarray
    mean: np.ndarray


class Run:
    """A random mechanism with random torques, from a random motion that one-way elements allow."""

    def __init__(self, seed: int, kind: Kind = Kind(), driven: bool = True) -> None:  # noqa: B008  frozen
        self.model = model = random_model(seed, kind)
        self.plant = NumpyBlock(plant_block(model, STEP))
        self.numeric = model.numeric()
        rng = np.random.default_rng(seed)
        self.start = self._motion(rng)
        self.frequencies = rng.uniform(1, 50, len(model.inputs))
        self.amplitudes = rng.normal(size=len(model.inputs)) * 30 * driven
        self.contacts = [
            (
                evaluate_matrix(model.contact_twists[i, :], model.values)[0],
                model.values[spring.stiffness],
                model.values[spring.backlash] / 2,
            )
            for i, spring in enumerate(model.contacts)
        ]

    def _motion(self, rng: np.random.Generator) -> np.ndarray:
        G = self.numeric.friction_rows
        one_way = np.array([friction.one_way for friction in self.model.frictions])
        z = rng.normal(size=G.shape[1]) * 10
        for _ in range(100):
            wrong = one_way & (G @ z > 0)
            if not wrong.any():
                return z
            row = G[int(np.argmax(wrong))]
            z = z - row * (row @ z + 0.1) / (row @ row)
        return z * 0

    def steps(self, h: float, duration: float) -> Iterator[Step]:
        parameters = {**self.plant.defaults(), "sample_time": np.array(h)}
        derived, states = self.plant.prepare(parameters), self.plant.initial()
        states["x"][: len(self.start)] = self.start
        for k in range(round(duration / h)):
            phase = 2 * np.pi * self.frequencies * (k + 0.5) * h + np.arange(len(self.frequencies))
            torques = self.amplitudes * np.sin(phase)
            inputs = {signal.name: np.array(0.7) for signal in self.plant.block.inputs}
            inputs |= {f"{t.name}_torque_ref": np.array(torques[i]) for i, t in enumerate(self.model.inputs)}
            with pytest.MonkeyPatch.context() as patch:
                means: list[np.ndarray] = []
                step = KERNELS["friction_step"]

                def noted(*arguments, step=step, means=means):
                    results = step(*arguments)
                    means.append(results[0])
                    return results

                patch.setitem(KERNELS, "friction_step", noted)
                after, outputs = self.plant.step(parameters, derived, states, inputs)
            yield Step(states, after, outputs, torques, means[0])
            states = after

    def energy(self, states: Values) -> float:
        n_z, n_e = len(self.model.coordinates), len(self.model.twists)
        z, e = states["x"][:n_z], states["x"][n_z : n_z + n_e]
        beyond = [(L @ e - np.clip(L @ e, -b, b), c) for L, c, b in self.contacts]
        linear = 0.5 * z @ self.numeric.mass @ z + 0.5 * e @ self.numeric.stiffness @ e
        return float(linear + sum(0.5 * c * p**2 for p, c in beyond))

    def imbalance(self, h: float, duration: float) -> float:
        """Return energy that came from nowhere, relative to all that went to and fro."""
        n_z, G, B = len(self.model.coordinates), self.numeric.friction_rows, self.numeric.input_rows
        first = last = None
        supplied = taken = turned_over = 0.0
        for step in self.steps(h, duration):
            first = step.before if first is None else first
            last = step.after
            z = (step.before["x"][:n_z] + last["x"][:n_z]) / 2
            work, loss = h * step.torques @ B @ z, h * step.mean @ G @ z
            supplied, taken = supplied + work, taken + loss
            turned_over += abs(work) + abs(loss)
        assert first is not None and last is not None
        start = self.energy(first)
        return abs(self.energy(last) - start - supplied + taken) / (turned_over + start + 1e-9)


@settings(max_examples=30, deadline=None)
@given(seeds)
def test_what_sticks_is_at_rest_and_friction_takes_power(seed: int) -> None:
    run = Run(seed, Kind(frictions=5))
    numeric, model = run.numeric, run.model
    n_z = len(model.coordinates)
    for step in run.steps(STEP, 0.008):
        assert step.after["friction_status"] == 0
        z = step.after["x"][:n_z]
        for i, friction in enumerate(model.frictions):
            torque = float(step.outputs[f"{friction.name}_torque"])
            speed = float(step.outputs[f"{friction.name}_speed"])
            assert torque * speed >= 0
            mu = 0.7 if friction.actuated else 1.0
            limit = mu * model.values.get(friction.at_rest, 0.0)
            if friction.one_way:
                assert speed <= 0.0
                assert torque >= -limit * (1 + 1e-12)
            else:
                assert abs(torque) <= limit * (1 + 1e-12)
            if abs(torque) < mu * model.values[friction.coulomb] * (1 - 1e-9):
                assert speed == 0.0
            assert abs(speed - numeric.friction_rows[i] @ z) <= 1e-9


@settings(max_examples=15, deadline=None)
@given(seeds)
def test_the_energy_balance_closes_with_the_second_order_of_the_step(seed: int) -> None:
    run = Run(seed)
    coarse, fine = run.imbalance(STEP, 0.01), run.imbalance(STEP / 4, 0.01)
    assert coarse < 5e-3
    assert fine < max(coarse / 8, 1e-9) or fine < 1e-5


@settings(max_examples=15, deadline=None)
@given(seeds)
def test_without_drive_energy_is_only_lost(seed: int) -> None:
    """Up to the curvature of velocities inside a step, whose effect falls with its square."""
    run = Run(seed, driven=False)
    rises = []
    for h in (STEP, STEP / 4):
        energies = [run.energy(step.after) for step in run.steps(h, 0.01)]
        rises.append(max(np.diff(energies).max(), 0.0) / (energies[0] + 1e-9))
    assert rises[0] < 2e-3
    assert rises[1] < max(rises[0] / 4, 1e-5)


def test_parameters_that_spoil_a_capacity_name_the_element(projects) -> None:
    plant = NumpyBlock(projects["differential"].plant)
    parameters = plant.defaults()
    derived = plant.prepare(parameters)
    inputs = {signal.name: np.array(10.0) for signal in plant.block.inputs}
    alarms = {alarm.value: alarm.name for alarm in plant.block.alarms}
    for value in (-1.0, np.nan, np.inf):
        spoilt = {**parameters, "diff_limited_slip_coulomb": np.array(value)}
        states, outputs = plant.step(spoilt, derived, plant.initial(), inputs)
        assert alarms[int(states["friction_status"])] == "bad_capacity_diff_limited_slip"
        assert all(np.isfinite(output) for output in outputs.values())

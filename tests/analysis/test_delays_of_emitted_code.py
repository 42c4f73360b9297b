"""What delay margins mean: 5 % more delay lets the emitted code swing ever more, 5 % less does not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ptgen.analysis.frequency import NEUTRAL
from ptgen.analysis.linear import LoopFamily, with_dead_times
from ptgen.analysis.margins import Delay, common_delay_margin, machine_delay_margin
from ptgen.emit.project import recorded_signals
from ptgen.loops.loop_analysis import chosen_frictions, loop_family
from ptgen.mechanism.assembly import assemble
from ptgen.plant.plant import plant_block
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.closed_loop import ClosedLoop
from ptgen.testbed.profile import Profile

_LONGEST = 0.15
"""Delays (s) above are not simulated: so slow a swing takes minutes of simulated time to tell growth from decay."""

_GROWTH = 4.0
"""Exponent of the growth or decay to wait for."""


class DelayedBed:
    """A bed without friction, with long delay lines, its emitted code compiled."""

    def __init__(self, project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
        held, _ = chosen_frictions(project, (), ())
        mechanism = project.mechanism.with_closed_backlash().with_locked_frictions(set(held))
        full = assemble(mechanism)
        self.family: LoopFamily = loop_family(project, full)
        self.h = project.testbed.sample_time
        poles = np.linalg.eigvals(self.family.delayed().closed())
        worst = complex(poles[np.argmax(abs(poles))])
        self.unstable = worst if abs(worst) > 1 + NEUTRAL else None
        margins: list[tuple[tuple[str, ...], Delay]] = []
        if self.unstable is None:
            margins = [(self.family.machines, common_delay_margin(self.family))]
            margins += [((name,), machine_delay_margin(self.family, name)) for name in self.family.machines]
        self.margins = [item for item in margins if item[1].time < _LONGEST]
        longest = max((delay.time for _, delay in self.margins), default=0.0)
        copy = Project(project.testbed)
        capacity = int(1.1 * longest / self.h) + 32
        copy.__dict__ |= {key: value for key, value in project.__dict__.items() if key != "testbed"}
        copy.__dict__["plant"] = plant_block(with_dead_times(full), self.h, capacity)
        copy.__dict__["plant_model"] = full
        # the functions for CasADi have no part in this, and thousands of delays make them long
        monkeypatch.setattr("ptgen.emit.project.casadi_files", lambda block, prefix: {})
        self.library = build(copy)
        self.recorded = [signal.name for signal in recorded_signals(copy)]
        symbols = {
            symbol.name
            for friction in full.frictions
            if not friction.actuated  # those are open
            for part in (
                friction.coulomb,
                friction.static,
                friction.load.coefficient if friction.load else None,
                friction.saturated.slope if friction.saturated else None,
            )
            if part is not None
            for symbol in part.free_symbols
        }
        self.frictionless = dict.fromkeys(symbols, 1e-12)
        self.references = len(project.design.controller.references)
        self.actuations = sum(f.actuated for f in full.frictions)
        self.ratios = [parameter.value for parameter in project.testbed.ratios.values()]

    def pole(self, machines: tuple[str, ...], delay: float, frequency_hz: float) -> complex:
        """Return the pole that starts at the margin, by Newton's method on ``det(I - L(z)) = 0``."""
        loop, steps = self.family.loop(None, dict.fromkeys(machines, delay))
        A, exponents = loop.A, -np.asarray(steps, dtype=float)

        def missing(z: complex) -> complex:
            L = loop.C @ np.linalg.solve(z * np.eye(len(A)) - A, loop.B) * z**exponents
            values = np.linalg.eigvals(L)
            return complex(np.log(values[np.argmin(abs(values - 1))]))

        z = np.exp(2j * np.pi * frequency_hz * self.h)
        for _ in range(40):
            step = 1e-7 * (1 + 1j)
            slope = (missing(z + step) - missing(z - step)) / (2 * step)
            change = missing(z) / slope
            z -= change
            if abs(change) < 1e-13:
                break
        return complex(z)

    def swing(self, machines: tuple[str, ...], delay: float, steps: int) -> np.ndarray:
        """Return the largest torque command in twenty parts of a run after a short push."""
        pushes = [Profile((0.0, 20 * self.h), (1e-4, 0.0), "steps") for _ in range(self.references)]
        pushes += [Profile((0.0,), (0.0,), "lines") for _ in range(self.actuations)]
        pushes += [Profile((0.0,), (ratio,), "lines") for ratio in self.ratios]
        parameters = dict(self.frictionless)
        for machine in machines:
            parameters[f"{machine}_inverter_dead_time"] = self.family.dead_time(machine) + delay
        loop = ClosedLoop(self.library, pushes, "decoupling", parameters)
        rows = np.zeros((steps, len(self.recorded)))
        loop.steps(steps, 1, rows)
        loop.check("the run")
        commands = rows[:, [k for k, name in enumerate(self.recorded) if name.endswith("_torque_ref")]]
        return np.array([abs(part).max() for part in np.array_split(commands, 20)])


BEDS = sorted(path.stem for path in (Path(__file__).parents[2] / "testbeds").glob("*.toml"))


@pytest.mark.compile
@pytest.mark.parametrize("name", BEDS)
def test_delay_margins_are_true_for_the_emitted_code(name, projects, monkeypatch):
    bed = DelayedBed(projects[name.replace("-", "_")], monkeypatch)
    if bed.unstable is not None:  # then it must swing without any delay
        steps = int(2 * _GROWTH / np.log(abs(bed.unstable)))
        swing = bed.swing(bed.family.machines, 0.0, steps)
        assert swing[-1] / swing[9] == pytest.approx(np.exp(_GROWTH), rel=0.1)
        return
    assert bed.margins
    for machines, margin in bed.margins:
        for share in (0.95, 1.05):
            rate = float(np.log(abs(bed.pole(machines, share * margin.time, margin.frequency_hz))))
            assert np.sign(rate) == np.sign(share - 1)
            swing = bed.swing(machines, share * margin.time, int(2 * _GROWTH / abs(rate)))
            if rate > 0:
                assert swing[-1] / swing[9] == pytest.approx(np.exp(_GROWTH), rel=0.1), (machines, share)
            else:
                assert swing[-1] < 0.01 * swing.max(), (machines, share)

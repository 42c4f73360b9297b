"""ptgen from Python, stage by stage.

>>> import ptgen
>>> bed = ptgen.load("testbeds/differential.toml")          # doctest: +SKIP
>>> model = bed.assemble()                                  # doctest: +SKIP
>>> [mode.frequency_hz for mode in model.modes()]           # doctest: +SKIP
>>> design = model.reduce().decouple()                      # doctest: +SKIP
>>> controller, plant = design.blocks()                     # doctest: +SKIP
>>> ptgen.analyse(design).margins                           # doctest: +SKIP
>>> ptgen.tune(design, speed_bandwidth="8 Hz").changes      # doctest: +SKIP
>>> ptgen.govern(design, "scenarios/differential-run.toml").runs  # doctest: +SKIP
>>> ptgen.emit(design, "build/differential")                # doctest: +SKIP
>>> recording = ptgen.simulate(design, "scenarios/differential-run.toml")  # doctest: +SKIP
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ptgen.block.block import Block
from ptgen.control.design import ControlDesign
from ptgen.emit.c_expressions import Precision
from ptgen.emit.project import generate
from ptgen.errors import TestbedError
from ptgen.loops.governor_study import GovernorStudy, choices_of, study_governors
from ptgen.loops.loop_analysis import LoopAnalysis
from ptgen.loops.loop_analysis import analyse as analyse_loop
from ptgen.loops.loop_tuning import LoopTuning, write_wishes
from ptgen.loops.loop_tuning import tune as tune_loop
from ptgen.mechanism.model import Model
from ptgen.mechanism.modes import Mode, modes
from ptgen.mechanism.reduction import ReducedModel
from ptgen.project import Project
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import ControllerName
from ptgen.simulate.run import simulate as run_scenario
from ptgen.testbed import Roles, Testbed, load_scenario
from ptgen.testbed.governor_settings import GovernorSettings
from ptgen.testbed.problems import validated

__all__ = ["AssembledBed", "Bed", "DesignedBed", "ReducedBed", "analyse", "emit", "govern", "load", "simulate", "tune"]


@dataclass(frozen=True)
class Bed:
    """A test bed that was read; `project` holds its stages."""

    project: Project

    @property
    def testbed(self) -> Testbed:
        """What the file says, in SI units."""
        return self.project.testbed

    def assemble(self) -> AssembledBed:
        """Derive the full model."""
        return AssembledBed(self.project, self.project.model)


@dataclass(frozen=True)
class AssembledBed:
    """A bed with its full `model`."""

    project: Project
    model: Model

    def modes(self, locked: Collection[str] = ()) -> tuple[Mode, ...]:
        """Return the modes with the named friction elements locked, all others free."""
        return modes(self.model, locked)

    def reduce(self, **settings: Any) -> ReducedBed:
        """Reduce the model; `settings` replace those of the file's section ``[reduction]``, such as ``rigid``."""
        project = self.project
        if settings:
            merged = {**project.testbed.reduction.model_dump(), **settings}
            reduction = type(project.testbed.reduction).model_validate(merged)
            project = Project(replace(project.testbed, reduction=reduction))
        return ReducedBed(project, project.reduced)


@dataclass(frozen=True)
class ReducedBed:
    """A bed with its `reduced` model."""

    project: Project
    reduced: ReducedModel

    def decouple(self, torque: Mapping[str, str] | None = None, speed: Sequence[str] | None = None) -> DesignedBed:
        """Design the controller; `torque` and `speed` replace the roles in the file.

        Raises
        ------
        ControlError
            If the roles allow no decoupling; the error names others that do.
        """
        project = self.project
        if torque is not None or speed is not None:
            roles = project.testbed.roles
            roles = Roles(
                torque=dict(torque if torque is not None else roles.torque),
                speed=tuple(speed if speed is not None else roles.speed),
            )
            project = Project(replace(project.testbed, roles=roles))
        return DesignedBed(project, project.design)


@dataclass(frozen=True)
class DesignedBed:
    """A bed with its control `design`."""

    project: Project
    design: ControlDesign

    def blocks(self) -> tuple[Block, Block]:
        """Return the blocks of controller and plant."""
        return self.project.blocks()


def load(path: str | Path) -> Bed:
    """Read a test bed file.

    Raises
    ------
    TestbedError
        With all problems of the file.
    """
    return Bed(Project.read(path))


def analyse(
    bed: Bed | DesignedBed,
    locked: Collection[str] = (),
    controller: ControllerName = "decoupling",
    parameters: Mapping[str, float] | None = None,
) -> LoopAnalysis:
    """Analyse the sampled closed loop of a bed; see `ptgen.loops.loop_analysis.analyse`."""
    return analyse_loop(bed.project, locked=locked, controller=controller, parameters=parameters)


def tune(
    bed: Bed | DesignedBed,
    *,
    locked: Collection[str] = (),
    free: Collection[str] = (),
    write: bool = False,
    **options: str | float | None,
) -> LoopTuning:
    """Find the largest wishes that keep the margins; see `ptgen.loops.loop_tuning.tune`.

    Parameters
    ----------
    bed : Bed or DesignedBed
    locked, free : collection of str
        Friction elements that stick, or slip, other than the file takes them.
    write : bool
        Whether to write the wishes that hold into the bed file.
    **options : str or float
        ``speed_bandwidth``, ``torque_bandwidth`` or ``torque_rise_time``, ``damping_ratio``, ``delay_margin``,
        ``disk_margin``, as the bed file writes them: ``"5 Hz"``, ``0.7``.

    Raises
    ------
    PtgenError
        With all problems of the options, or of writing.
    """
    found = tune_loop(bed.project, options, locked=locked, free=free)
    if write:
        write_wishes(bed.project, found, locked=locked, free=free)
    return found


def govern(
    bed: Bed | DesignedBed, scenario: str | Path | None = None, compare: bool = False, **settings: Any
) -> GovernorStudy:
    """Compute what the reference governors of a bed need, and run them; see `ptgen.loops.governor_study`.

    Parameters
    ----------
    bed : Bed or DesignedBed
    scenario : str or path-like, optional
        A scenario file to run with the governor.
    compare : bool
        Whether to run all governors.
    **settings
        Keys of section ``[governor]`` as the bed file writes them, in the place of those there: ``horizon="0.5 s"``.

    Raises
    ------
    PtgenError
        With all problems of the settings, or from any stage.
    """
    project = bed.project
    given = project.testbed.governor
    read, problems = validated(GovernorSettings, settings, "governor")
    if read is None:
        raise TestbedError(problems)
    changes = {key: getattr(read, key) for key in settings}
    chosen = given.model_copy(update={**({} if given.is_chosen else {"kind": "optimal"}), **changes})
    course = None if scenario is None else load_scenario(scenario, project.testbed)
    return study_governors(project, chosen, course, choices_of(chosen, compare))


def emit(bed: Bed | DesignedBed, directory: str | Path, precision: Precision = "double") -> list[Path]:
    """Write the C project of a bed; see `ptgen.emit.project.generate`."""
    return generate(bed.project, Path(directory), precision)


def simulate(
    bed: Bed | DesignedBed, scenario: str | Path, controller: ControllerName = "decoupling", **options: Any
) -> Recording:
    """Run a scenario file in closed loop; `options` go to `ptgen.simulate.run.simulate`."""
    project = bed.project
    return run_scenario(project, load_scenario(scenario, project.testbed), controller=controller, **options)

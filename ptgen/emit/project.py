"""The C project of a bed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ptgen.emit.block_files import block_files, common_context
from ptgen.emit.c_block import CBlock
from ptgen.emit.c_expressions import Precision, literal
from ptgen.emit.casadi_files import casadi_files
from ptgen.emit.friction_source import uses_friction
from ptgen.emit.governor_source import uses_governor
from ptgen.emit.templates import render
from ptgen.files import write_files
from ptgen.governor.functions import governor_files
from ptgen.governor.limit_rows import LimitRows
from ptgen.governor.shaping import governor_signals
from ptgen.project import Project

__all__ = [
    "RecordedSignal",
    "actuation_names",
    "controller_ratio_names",
    "generate",
    "project_files",
    "ratio_names",
    "recorded_signals",
]


@dataclass(frozen=True)
class RecordedSignal:
    """A signal that the closed loop records: its name, its SI unit, and where it stands in C."""

    name: str
    unit: str
    place: str


def recorded_signals(project: Project) -> tuple[RecordedSignal, ...]:
    """Return the signals of a recording.

    References, actuations, ratios, what the plant puts out, commands, the ratio that the law has for a component that
    is a ratio for control, what a reference governor does, fault.
    """
    controller, plant = project.blocks()
    given = {*actuation_names(project).values(), *ratio_names(project).values()}
    references = set(project.design.controller.references.values())
    signals = [
        RecordedSignal(s.name, s.unit, f"run->inputs.{s.name}") for s in controller.inputs if s.name in references
    ]
    signals += [RecordedSignal(s.name, s.unit, f"run->driven.{s.name}") for s in plant.inputs if s.name in given]
    alone = set(controller_ratio_names(project).values())
    signals += [RecordedSignal(s.name, s.unit, f"run->inputs.{s.name}") for s in controller.inputs if s.name in alone]
    signals += [RecordedSignal(s.name, s.unit, f"run->measured.{s.name}") for s in plant.outputs]
    signals += [RecordedSignal(s.name, s.unit, f"run->commands.{s.name}") for s in controller.outputs]
    used = [f"{name}_ratio_limited" for name in project.testbed.reduction.as_ratio]
    signals += [
        RecordedSignal(s.name, s.unit, f"run->controller.{s.name}") for s in controller.states if s.name in used
    ]
    signals += [RecordedSignal(s.name, s.unit, f"run->controller.{s.name}") for s in governor_signals(controller)]
    signals.append(RecordedSignal("fault", "", "run->controller.fault"))
    return tuple(signals)


def actuation_names(project: Project) -> dict[str, str]:
    """Return the plant's input for each actuated friction element of the bed, in the order of the inputs."""
    wanted = {f"{name.replace('.', '_')}_actuation": name for name in project.testbed.actuated}
    return {wanted[signal.name]: signal.name for signal in project.plant.inputs if signal.name in wanted}


def ratio_names(project: Project) -> dict[str, str]:
    """Return the plant's input for each gearbox whose ratio changes at run time, in the order of the inputs."""
    wanted = {parameter.symbol.name: name for name, parameter in project.testbed.ratios.items()}
    return {wanted[signal.name]: signal.name for signal in project.plant.inputs if signal.name in wanted}


def controller_ratio_names(project: Project) -> dict[str, str]:
    """Return the controller's input for each ratio that the plant does not have: of what is a ratio for control."""
    wanted = {parameter.symbol.name: name for name, parameter in project.testbed.ratios.items()}
    plant = set(ratio_names(project).values())
    return {wanted[s.name]: s.name for s in project.controller.inputs if s.name in wanted and s.name not in plant}


def project_files(project: Project, precision: Precision = "double") -> dict[str, str | bytes]:
    """Return the files of the C project by their path inside it.

    Parameters
    ----------
    project : Project
    precision : {"double", "float"}
        Type of all numbers in the emitted C.

    Raises
    ------
    PtgenError
        From any stage.
    """
    testbed = project.testbed
    prefix = testbed.name
    controller, plant = project.blocks()
    references = project.design.controller.references
    actuations = list(actuation_names(project).values())
    taken = {signal.name for signal in controller.inputs}
    ratios = list(ratio_names(project).values())
    alone = list(controller_ratio_names(project).values())
    profiles = [(name, name in taken, True, plant.declared(name).value) for name in ratios]
    profiles += [(name, True, False, controller.declared(name).value) for name in alone]
    names = {signal.name for signal in plant.outputs}
    common = common_context(prefix, Path(testbed.file).name, testbed.digest, precision)
    context: dict[str, object] = {
        **common,
        "title": testbed.title,
        "sample_time": f"{testbed.sample_time:g}",
        "references": list(references.values()),
        "measured": [signal.name for signal in controller.inputs if signal.name in names],
        "actuations": actuations,
        "ratios": [(name, taken, driven, literal(value, "double")) for name, taken, driven, value in profiles],
        "commands": [signal.name for signal in plant.inputs if signal.name not in (*actuations, *ratios)],
        "signals": recorded_signals(project),
        "friction": uses_friction(plant) is not None,
        "governor": uses_governor(controller, precision) is not None,
        "optimal": testbed.governor.kind == "optimal",
        "controller": CBlock(controller, prefix, precision),
        "law": {name: str(text) for name, text in project.design.decoupling.law_expressions().items()},
    }
    variants = {controller.name: {"conventional": project.design.controller.conventional}}
    files: dict[str, str | bytes] = {
        f"{prefix}_run.h": render("run.h.jinja", **context),
        f"{prefix}_run.c": render("run.c.jinja", **context),
        f"{prefix}_main.c": render("main.c.jinja", **context),
        "CMakeLists.txt": render("CMakeLists.txt.jinja", **context),
        "README.md": render("README.md.jinja", **context),
        **block_files((controller, plant), common, variants),
    }
    for block_ in (controller, plant):
        files |= {f"casadi/{name}": content for name, content in casadi_files(block_, prefix).items()}
    if testbed.governor.kind == "optimal":
        rows = LimitRows.predicted(project.constraints)
        group = [0 if torque else 1 for torque in project.prediction.torque_references]
        functions = governor_files(project.prediction, rows, prefix, group)
        files |= {f"casadi/{name}": content for name, content in functions.items()}
    return dict(sorted(files.items()))


def generate(project: Project, directory: Path, precision: Precision = "double") -> list[Path]:
    """Write the C project of a bed into `directory`; return the paths of its files.

    All stages run before the first file is written; each file is written whole or not at all.

    Raises
    ------
    PtgenError
        From any stage, or if the folder cannot be written.
    """
    return write_files(directory, project_files(project, precision))

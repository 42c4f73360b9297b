"""The C project of a bed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ptgen.block.block import Block
from ptgen.block.kernels import TAYLOR_DEGREE
from ptgen.emit.c_block import CBlock
from ptgen.emit.c_expressions import Precision, literal
from ptgen.emit.casadi_files import casadi_files
from ptgen.emit.templates import render
from ptgen.files import write_files
from ptgen.project import Project

__all__ = ["RecordedSignal", "generate", "project_files", "recorded_signals"]

_FAILURE_TEXTS = {
    "mass_matrix": "the inertia matrix is not positive definite",
    "exponential_range": "the parameters are too far from those that the code was emitted for; emit it again",
    "friction_matrix": "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter",
}


@dataclass(frozen=True)
class RecordedSignal:
    """A signal that the closed loop records: its name, its SI unit, and where it stands in C."""

    name: str
    unit: str
    place: str


def recorded_signals(project: Project) -> tuple[RecordedSignal, ...]:
    """Return the signals of a recording: references, what the plant puts out, commands, fault."""
    controller, plant = project.blocks()
    references = set(project.design.controller.references.values())
    signals = [
        RecordedSignal(s.name, s.unit, f"run->inputs.{s.name}") for s in controller.inputs if s.name in references
    ]
    signals += [RecordedSignal(s.name, s.unit, f"run->measured.{s.name}") for s in plant.outputs]
    signals += [RecordedSignal(s.name, s.unit, f"run->commands.{s.name}") for s in controller.outputs]
    signals.append(RecordedSignal("fault", "", "run->controller.fault"))
    return tuple(signals)


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
    names = {signal.name for signal in plant.outputs}
    blocks = {block.name: CBlock(block, prefix, precision) for block in (controller, plant)}
    conventional = {name: literal(value, precision) for name, value in project.design.controller.conventional.items()}
    context: dict[str, object] = {
        "prefix": prefix,
        "title": testbed.title,
        "bed_file": Path(testbed.file).name,
        "digest": testbed.digest,
        "precision": precision,
        "sample_time": f"{testbed.sample_time:g}",
        "zero": literal(0.0, precision),
        "one": literal(1.0, precision),
        "sqrt": "sqrtf" if precision == "float" else "sqrt",
        "floor": "floorf" if precision == "float" else "floor",
        "taylor_degree": TAYLOR_DEGREE,
        "max_order": _max_order(plant),
        "references": list(references.values()),
        "measured": [signal.name for signal in controller.inputs if signal.name in names],
        "commands": [signal.name for signal in plant.inputs],
        "signals": recorded_signals(project),
        "failure_texts": _FAILURE_TEXTS,
        "controller": blocks["controller"],
        "law": {name: str(text) for name, text in project.design.decoupling.law_expressions().items()},
    }
    files: dict[str, str | bytes] = {
        f"{prefix}_support.h": render("support.h.jinja", **context),
        f"{prefix}_support.c": render("support.c.jinja", **context),
        f"{prefix}_run.h": render("run.h.jinja", **context),
        f"{prefix}_run.c": render("run.c.jinja", **context),
        f"{prefix}_main.c": render("main.c.jinja", **context),
        "CMakeLists.txt": render("CMakeLists.txt.jinja", **context),
        "README.md": render("README.md.jinja", **context),
    }
    for name, block in blocks.items():
        variants = {"conventional": conventional} if name == "controller" else {}
        for suffix in ("h", "c"):
            text = render(f"block.{suffix}.jinja", block=block, variants=variants, **context)
            files[f"{prefix}_{name}.{suffix}"] = text
    for block_ in (controller, plant):
        files |= {f"casadi/{name}": content for name, content in casadi_files(block_, prefix).items()}
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


def _max_order(plant: Block) -> int:
    """Return the order of the exponential: columns of the matrix A of the plant."""
    return plant.declared("A").shape[1]

"""What a comparison with the source consists of: words, a run, a figure, numbers."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ptgen.project import Project
from ptgen.report.figures import LIGHT, PALETTE, REFERENCE, new_figure
from ptgen.simulate.build import build
from ptgen.simulate.library import Library
from ptgen.simulate.recording import Recording
from ptgen.simulate.run import simulate
from ptgen.testbed import Profile, Scenario

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["RPM", "Case", "Number", "Panel", "bed", "course", "draw", "library", "ramps", "rms", "run", "steps"]

ROOT = Path(__file__).resolve().parents[2]
RPM = 2 * np.pi / 60
Array = NDArray[np.float64]


@dataclass(frozen=True)
class Number:
    """A number of the page: what it is, its value, how it is shown, and what the source says of it."""

    name: str
    value: float
    unit: str
    source: str


@dataclass(frozen=True)
class Case:
    """A comparison.

    Attributes
    ----------
    key : str
        Name of its figure.
    title : str
        With the number of the source's figure.
    shows : str
        What the source says or shows.
    verdict : str
        What agrees, what differs, and why.
    make : callable
        Returns the numbers and the figure.
    """

    key: str
    title: str
    shows: str
    verdict: str
    make: Callable[[], tuple[list[Number], Figure]]


@cache
def bed(name: str, *changes: tuple[str, str]) -> Project:
    """Return a shipped bed, with pieces of its file replaced."""
    path = ROOT / "testbeds" / f"{name}.toml"
    if not changes:
        return Project.read(path)
    text = path.read_text(encoding="utf-8")
    for old, new in changes:
        if text.count(old) != 1:
            raise ValueError(f"{name}: {old!r} occurs {text.count(old)} times")
        text = text.replace(old, new)
    with tempfile.TemporaryDirectory() as folder:
        other = Path(folder) / path.name
        other.write_text(text, encoding="utf-8")
        return Project.read(other)


@cache
def library(project: Project) -> Library:
    """Return the compiled code of a bed."""
    return build(project)


def ramps(*points: tuple[float, float]) -> Profile:
    """Return a reference with straight lines between (time (s), value)."""
    return Profile(tuple(float(t) for t, _ in points), tuple(float(v) for _, v in points), "lines")


def steps(*points: tuple[float, float]) -> Profile:
    """Return a reference that holds each value until the next time."""
    return Profile(tuple(float(t) for t, _ in points), tuple(float(v) for _, v in points), "steps")


def course(duration: float, every: float, references: Mapping[str, Profile]) -> Scenario:
    """Return a scenario; times in s."""
    return Scenario(
        name="validation", file="", digest="", duration=duration, record_every=every, references=dict(references)
    )


def run(
    project: Project, scenario: Scenario, parameters: Mapping[str, float] | None = None, conventional: bool = False
) -> Recording:
    """Run a scenario with other parameters, and without the supervision that would stop a bed that swings."""
    controller = "conventional" if conventional else "decoupling"
    limits = [signal.name for signal in project.controller.parameters if signal.name.endswith("_oscillation_limit")]
    given = dict.fromkeys(limits, 1e9) | dict(parameters or {})
    return simulate(project, scenario, controller=controller, parameters=given, library=library(project))


def rms(values: Array) -> float:
    """Return the root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


@dataclass(frozen=True)
class Panel:
    """One of the stacked axes: (name, time, values) per curve; a name that starts with "ref" is drawn as reference."""

    label: str
    curves: Sequence[tuple[str, Array, Array]]
    span: tuple[float, float] | None = None


def draw(panels: Sequence[Panel], xlabel: str = "time (s)", width: float = 7.6, height: float = 1.75) -> Figure:
    """Draw stacked axes over one quantity, with the legends beside them."""
    figure = new_figure(width, height * len(panels) + 0.5)
    grid = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for axes, panel in zip(grid, panels, strict=True):
        colours = iter(PALETTE)
        for name, time, values in panel.curves:
            if name.startswith("ref"):
                axes.plot(
                    time,
                    values,
                    color=REFERENCE,
                    linewidth=0.9,
                    linestyle=(0, (4, 2)),
                    zorder=3,
                    label=name.removeprefix("ref: "),
                )
            else:
                axes.plot(time, values, color=next(colours), linewidth=1.1, label=name)
        axes.set_ylabel(panel.label, fontsize=8)
        axes.tick_params(labelsize=8)
        axes.grid(color=LIGHT, linewidth=0.6)
        axes.spines[["top", "right"]].set_visible(False)
        if panel.span is not None:
            axes.set_ylim(*panel.span)
        axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    grid[-1].set_xlabel(xlabel, fontsize=8)
    return figure

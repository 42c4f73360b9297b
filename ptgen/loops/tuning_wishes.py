"""The wishes and demands of a tuning: those of the bed file, and those that options put in their place."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from pydantic import field_validator

from ptgen.analysis.demands import Demands
from ptgen.analysis.wishes import WISHES
from ptgen.components.component import Quantity, Record
from ptgen.errors import Problem
from ptgen.project import Project
from ptgen.testbed.problems import validated
from ptgen.units import parse, rounded_down, unit_of

__all__ = ["DELAY_STEPS", "OPTIONS", "TuneOptions", "Wish", "Wished", "wished"]

DELAY_STEPS = 3
"""Delay that is demanded where the file names none, in sample times."""

_UNITS = {"speed_bandwidth": "rad/s", "torque_bandwidth": "rad/s", "damping_ratio": "", "delay_margin": "s",
          "disk_margin": ""}  # fmt: skip


class TuneOptions(Record):
    """What can be asked for instead of what the file says; every value as the file writes it."""

    speed_bandwidth: Annotated[float, Quantity("rad/s", "bandwidth of the speed control")] | None = None
    torque_bandwidth: Annotated[float, Quantity("rad/s", "bandwidth of the torque control")] | None = None
    torque_rise_time: Annotated[float, Quantity("s", "rise time of the torque from 10 to 90 %")] | None = None
    damping_ratio: Annotated[float, Quantity("", "damping ratio of the torque poles (5.81)")] | None = None
    delay_margin: Annotated[float, Quantity("s", "additional delay to leave room for", positive=False)] | None = None
    disk_margin: Annotated[float, Quantity("", "disk margin to leave", positive=False)] | None = None

    @field_validator("disk_margin")
    @classmethod
    def _below_two(cls, value: float | None) -> float | None:
        if value is not None and value >= 2:
            raise ValueError(f"must be below 2, got {value:g}; 0.67 is a good margin, 0.33 a fair one")
        return value


OPTIONS = tuple(TuneOptions.model_fields)
"""Names of the options, as Python has them."""


@dataclass(frozen=True)
class Wish:
    """One wish.

    Attributes
    ----------
    key : str
        In section ``[control]``.
    unit : str
        SI unit of `wanted`.
    wanted : float
    text : str
        As it was written.
    shown : str
        Unit that the file has for it, or the option, or the SI unit.
    is_given : bool
        Whether an option asked for it.
    is_number : bool
        Whether the file holds a number rather than a text.
    """

    key: str
    unit: str
    wanted: float
    text: str
    shown: str
    is_given: bool
    is_number: bool

    def written(self, value: float) -> str:
        """Return a value in the wish's unit, rounded down to three digits."""
        return rounded_down(value, self.unit, self.shown)


@dataclass(frozen=True)
class Wished:
    """All wishes and demands.

    Attributes
    ----------
    wishes : tuple of Wish
        Those that the bed has a machine for.
    demands : Demands
    margins : tuple of Wish
        Demands that options asked for.
    notes : tuple of str
        What was converted.
    """

    wishes: tuple[Wish, ...]
    demands: Demands
    margins: tuple[Wish, ...]
    notes: tuple[str, ...]


def wished(project: Project, options: Mapping[str, object]) -> tuple[Wished | None, list[Problem]]:
    """Return the wishes for a bed, and everything that is wrong with the options.

    Parameters
    ----------
    project : Project
    options : mapping
        Keys of `OPTIONS`; None stands for what the file says.
    """
    given = {key: value for key, value in options.items() if value is not None}
    bed = project.testbed
    found, problems = validated(TuneOptions, given)
    problems = [Problem(_option(problem.where), problem.what, problem.remedy) for problem in problems]
    problems += _useless(project, given)
    if "torque_bandwidth" in given and "torque_rise_time" in given:
        what = "contradicts --torque-bandwidth: one follows from the other"
        problems.append(Problem("--torque-rise-time", what, "leave out one of the options"))
    if problems or found is None:
        return None, problems
    notes = []
    texts = {key: str(value).strip() for key, value in given.items()}
    values = {key: value for key, value in found.model_dump().items() if value is not None}
    written = _of_file(project)
    if (rise := values.pop("torque_rise_time", None)) is not None:
        unit = _shown(written.get("torque_bandwidth"), "", "rad/s")
        asked, text = texts["torque_rise_time"], rounded_down(math.log(9) / rise, "rad/s", unit)
        texts["torque_bandwidth"], values["torque_bandwidth"] = text, parse(text, "rad/s")
        notes.append(
            f"A rise time of {asked} from 10 to 90 % is a torque_bandwidth of {text} "
            "(ln 9 / rise time, a first-order lag)."
        )
    defaults = {**bed.tuning.model_dump(), "delay_margin": bed.tuning.delay_margin}
    if defaults["delay_margin"] is None:
        defaults["delay_margin"] = DELAY_STEPS * bed.sample_time

    def wish(key: str) -> Wish:
        in_file, unit = written.get(key), _UNITS[key]
        wanted = float(values.get(key, defaults[key]))
        shown = _shown(in_file, texts.get(key, ""), unit)
        text = texts.get(key) or (str(in_file) if in_file is not None else rounded_down(wanted, unit, shown, 9))
        is_number = not unit and not isinstance(in_file, str) and not shown
        return Wish(key, unit, wanted, text, shown, key in texts, is_number)

    kinds = {
        "speed_bandwidth": bed.roles.speed,
        "torque_bandwidth": bed.roles.torque,
        "damping_ratio": bed.roles.torque,
    }
    demands = Demands(*(float(values.get(key, defaults[key])) for key in ("delay_margin", "disk_margin")))
    margins = tuple(wish(key) for key in ("delay_margin", "disk_margin") if key in values)
    return Wished(tuple(wish(key) for key in WISHES if kinds[key]), demands, margins, tuple(notes)), []


def _useless(project: Project, given: Mapping[str, object]) -> list[Problem]:
    """Return a problem for every option that no machine of the bed has a use for."""
    roles = project.testbed.roles
    problems = []
    for key in given:
        kind = "torque" if key.startswith("torque") or key == "damping_ratio" else "speed"
        if key in ("delay_margin", "disk_margin") or (roles.torque if kind == "torque" else roles.speed):
            continue
        whose = "a torque" if kind == "torque" else "its own speed"
        problems.append(Problem(_option(key), f"no machine of this bed controls {whose}", "leave out the option"))
    return problems


def _option(key: str) -> str:
    return f"--{key.replace('_', '-')}"


def _of_file(project: Project) -> dict[str, Any]:
    """Return section ``[control]`` as the file has it; empty if the bed came from elsewhere."""
    try:
        text = Path(project.testbed.file).read_bytes().decode("utf-8-sig")
        table = tomllib.loads(text.replace("\r\n", "\n")).get("control", {})
    except (OSError, ValueError):
        return {}
    return table if isinstance(table, dict) else {}


def _shown(in_file: object, option: str, unit: str) -> str:
    """Return the unit for a value: that of the file, of the option, or the SI unit."""
    for text in (in_file, option):
        if isinstance(text, str) and text:
            return unit_of(text)
        if text not in (None, ""):
            return ""
    return unit

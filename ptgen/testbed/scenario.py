"""Scenario files: what the references and the actuated friction elements of a bed do over time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Annotated

from ptgen.components.component import Quantity, Record, Text
from ptgen.errors import Problem, TestbedError, nearest
from ptgen.testbed.problems import dotted, shown, validated
from ptgen.testbed.profile import Bounds, Points, Profile, Recording, read_profile
from ptgen.testbed.references import read_references
from ptgen.testbed.shift_plan import Shift
from ptgen.testbed.shifts import read_shifts
from ptgen.testbed.testbed import Testbed
from ptgen.testbed.text import read_toml

__all__ = ["Scenario", "ScenarioSection", "load_scenario"]

_SHARE = Bounds(0.0, 1.0, "write 0 for open, 1 for the full capacity, or a share in between")

_RATIO = '{ time = ["0 s", "1 s"], value = [1.0, 2.0] }'

_PROFILE_KEYS = frozenset({*Points.model_fields, *Recording.model_fields})

_ACTUATION = '{ time = ["0 s", "1 s"], value = [0, 1] }'


@dataclass(frozen=True)
class Scenario:
    """A checked scenario.

    Attributes
    ----------
    name : str
        The file's name without its suffix.
    file : str
        The file that it was read from.
    digest : str
        SHA-256 of the bytes of that file, in hexadecimal; measurement files are not part of it.
    duration : float
        How long it takes (s), a multiple of the sampling time.
    record_every : float
        Interval between two recorded instants (s), a multiple of the sampling time.
    references : mapping of str to Profile
        ``"torque.M1"`` (N m) or ``"speed.M2"`` (rad/s) -> its course; one for each machine of the bed. A pair of
        speeds has ``"speed_mean.<pair>"`` and ``"speed_difference.<pair>"`` instead.
    actuations : mapping of str to Profile
        Name of an actuated friction element -> its actuation, 0 (open) to 1 (full capacity); a scenario that was read
        has one for each of them, and one that is not there stays open.
    ratios : mapping of str to Profile
        Name of a gearbox whose ratio changes at run time -> its ratio, with the key if it has several, such as
        ``"gearbox1.ratio2"``; a scenario that was read has one for each of them, and one that is not there keeps the
        ratio of the bed file.
    title, description : str
        What it shows.
    gears : mapping of str to str
        Component that shifts -> its gear at the start; ``"N"`` is neutral.
    shifts : tuple of Shift
        In the order of time; their courses are part of `actuations` and `ratios`.
    """

    name: str
    file: str
    digest: str
    duration: float
    record_every: float
    references: Mapping[str, Profile]
    actuations: Mapping[str, Profile] = field(default_factory=dict)
    title: str = ""
    description: str = ""
    ratios: Mapping[str, Profile] = field(default_factory=dict)
    gears: Mapping[str, str] = field(default_factory=dict)
    shifts: tuple[Shift, ...] = ()


class ScenarioSection(Record):
    """Section ``[scenario]``."""

    title: Text = ""
    description: Text = ""
    duration: Annotated[float, Quantity("s", "how long the scenario takes")]
    record_every: Annotated[float, Quantity("s", "interval between two recorded instants")]


def load_scenario(path: str | PathLike[str], testbed: Testbed) -> Scenario:
    """Read and check a scenario for a test bed.

    Parameters
    ----------
    path : path-like
        A TOML file; files that it names are looked for beside it.
    testbed : Testbed
        The bed that it is for.

    Raises
    ------
    TestbedError
        With every problem of the file.
    """
    document = read_toml(path, "scenario file")
    tables = document.tables
    known = ("scenario", "references", "actuations", "ratios", "gears", "shifts")
    problems = [
        Problem(dotted(key), "is an unknown section", nearest(key, known)) for key in tables if key not in known
    ]
    if "scenario" not in tables:
        remedy = 'add [scenario] with duration = "10 s" and record_every = "1 ms"'
        problems.append(Problem("scenario", "is missing", remedy))
        section = None
    else:
        section, found = validated(ScenarioSection, tables["scenario"], "scenario")
        problems += found
    if section is not None:
        problems += _grid(section, testbed.sample_time)
    folder = Path(document.file).parent
    references, found = read_references(tables.get("references", {}), testbed, folder)
    problems += found
    actuations, found = _actuations(tables.get("actuations", {}), testbed, folder)
    problems += found
    ratios, found = _ratios(tables.get("ratios", {}), testbed, folder)
    problems += found
    duration = None if section is None else section.duration
    plan, found = read_shifts(tables.get("gears"), tables.get("shifts"), testbed, folder, duration)
    problems += found
    problems += _given_twice(
        "actuations", tables.get("actuations"), {f.name for f in testbed.frictions}, plan.actuations
    )
    problems += _given_twice("ratios", tables.get("ratios"), set(testbed.ratios), plan.ratios)
    given = _given(tables.get("ratios"), set(testbed.ratios))
    control = {name: profile for name, profile in plan.control.items() if name not in given}
    if problems or section is None:
        raise TestbedError(problems, document.file)
    return Scenario(
        name=Path(document.file).stem,
        file=document.file,
        digest=document.digest,
        duration=section.duration,
        record_every=section.record_every,
        references=references,
        actuations={**actuations, **plan.actuations},
        ratios={**ratios, **control, **plan.ratios},
        title=section.title,
        description=section.description,
        gears=plan.gears,
        shifts=plan.shifts,
    )


def _given(table: object, known: set[str]) -> dict[str, str]:
    """Return the entries of a section, by name, with the place where each stands."""
    if not isinstance(table, dict):
        return {}
    section = "actuations"
    return {".".join(path): dotted(section, *path).removeprefix(section) for path, _ in _entries(table, known)}


def _given_twice(section: str, table: object, known: set[str], planned: Mapping[str, Profile]) -> list[Problem]:
    """Return the entries of a section that gears and shifts set as well."""
    return [
        Problem(
            f"{section}{place}",
            f'is set by the gears and shifts of "{name.partition(".")[0]}"',
            "remove it here"
            + (", or give it a course inside a shift, with elements in [[shifts]]" if section == "actuations" else ""),
        )
        for name, place in _given(table, known).items()
        if name in planned
    ]


def _grid(section: ScenarioSection, sample_time: float) -> list[Problem]:
    """Check that the times are multiples of the sampling time."""
    problems: list[Problem] = []
    for key in ("duration", "record_every"):
        value = getattr(section, key)
        steps = value / sample_time
        if steps > 1e15:
            problems.append(Problem(dotted("scenario", key), f"is too long, {value:g} s", "shorten it"))
        elif round(steps) < 1 or abs(steps - round(steps)) > 1e-6 * max(1.0, 1e-6 * steps):
            what = f"must be a multiple of the sampling time, {sample_time:g} s, got {value:g} s"
            near = max(1, round(steps)) * sample_time
            problems.append(Problem(dotted("scenario", key), what, f'write e.g. "{near:.10g} s"'))
    if not problems and section.record_every > section.duration:
        what = f"must not exceed the duration, {section.duration:g} s, got {section.record_every:g} s"
        problems.append(Problem("scenario.record_every", what, "record more often"))
    return problems


def _actuations(table: object, testbed: Testbed, folder: Path) -> tuple[dict[str, Profile], list[Problem]]:
    """Read ``[actuations]``; an element without an entry stays open."""
    actuations = {name: Profile((0.0,), (0.0,), "lines") for name in testbed.actuated}
    elements = {friction.name for friction in testbed.frictions}
    if not isinstance(table, dict):
        remedy = f"write [actuations] with clutch1 = {_ACTUATION}"
        return actuations, [Problem("actuations", f"must be a table, got {shown(table)}", remedy)]
    problems: list[Problem] = []
    seen: dict[str, str] = {}
    for path, entry in _entries(table, elements):
        name, where = ".".join(path), dotted("actuations", *path)
        if name not in actuations:
            problems.append(_no_actuation(name, where, testbed))
            continue
        first = seen.setdefault(name, where)
        if first != where:
            problems.append(Problem(where, f'"{name}" has an entry already, {first}', "remove one of the two"))
            continue
        profile, found = read_profile(entry, "", folder, "actuations", *path, bounds=_SHARE)
        problems += found
        if profile is not None:
            actuations[name] = profile
    return actuations, problems


def _entries(table: Mapping[str, object], elements: set[str]) -> Iterator[tuple[tuple[str, ...], object]]:
    """Yield each entry and its path: a table stands for an element, or holds those of a component or of a part."""
    for key, entry in table.items():
        if key not in elements and isinstance(entry, dict) and _holds_elements(key, entry, elements):
            inside = {name.removeprefix(f"{key}.") for name in elements if name.startswith(f"{key}.")}
            within = _entries(entry, inside) if inside else (((inner,), below) for inner, below in entry.items())
            yield from (((key, *path), below) for path, below in within)
        else:
            yield (key,), entry


def _holds_elements(key: str, entry: Mapping[str, object], elements: set[str]) -> bool:
    if any(name.startswith(f"{key}.") for name in elements):
        return not _PROFILE_KEYS.intersection(entry) or any(f"{key}.{inner}" in elements for inner in entry)
    return bool(entry) and all(isinstance(below, dict) for below in entry.values())  # a misspelt component


def _no_actuation(name: str, where: str, testbed: Testbed) -> Problem:
    actuated = testbed.actuated
    if any(friction.name == name for friction in testbed.frictions):
        component = name.partition(".")[0]
        what = f'the friction element "{name}" of the bed "{testbed.name}" is not actuated'
        remedy = "leave it out: only clutches and brakes are actuated"
        if hasattr(testbed.components.get(component), "actuated"):
            remedy = f"write actuated = true in [{dotted('components', component)}] of the bed, or leave it out"
        return Problem(where, what, remedy)
    what = f'{shown(name)} is no friction element of the bed "{testbed.name}"'
    remedy = nearest(name, actuated) if actuated else "leave it out: no friction element of the bed is actuated"
    return Problem(where, what, remedy)


def _ratios(table: object, testbed: Testbed, folder: Path) -> tuple[dict[str, Profile], list[Problem]]:
    """Read ``[ratios]``; a gearbox without an entry keeps the ratio of the bed file."""
    changing = testbed.ratios
    ratios = {name: Profile((0.0,), (parameter.value,), "lines") for name, parameter in changing.items()}
    if not isinstance(table, dict):
        remedy = f"write [ratios] with gearbox = {_RATIO}"
        return ratios, [Problem("ratios", f"must be a table, got {shown(table)}", remedy)]
    problems: list[Problem] = []
    seen: dict[str, str] = {}
    for path, entry in _entries(table, set(changing)):
        name, where = ".".join(path), dotted("ratios", *path)
        parameter = changing.get(name)
        if parameter is None or parameter.span is None:
            problems.append(_no_ratio(name, where, testbed))
            continue
        first = seen.setdefault(name, where)
        if first != where:
            problems.append(Problem(where, f'"{name}" has an entry already, {first}', "remove one of the two"))
            continue
        least, most = parameter.span
        remedy = "stay within the range of its gears"
        if "ratio_range" in getattr(type(testbed.components.get(parameter.owner)), "model_fields", {}):
            remedy = f"stay within ratio_range of [{dotted('components', parameter.owner)}] in the bed, or widen it"
        profile, found = read_profile(entry, "", folder, "ratios", *path, bounds=Bounds(least, most, remedy))
        problems += found
        if profile is not None:
            ratios[name] = profile
    return ratios, problems


def _no_ratio(name: str, where: str, testbed: Testbed) -> Problem:
    component, changing = name.partition(".")[0], testbed.ratios
    own = [key for key in changing if key.partition(".")[0] == component]
    if not own and "ratio_range" in getattr(type(testbed.components.get(component)), "model_fields", {}):
        what = f'the ratio of "{component}" of the bed "{testbed.name}" is constant'
        remedy = f"write ratio_range in [{dotted('components', component)}] of the bed, or leave it out"
        return Problem(where, what, remedy)
    if own:
        what = f'{shown(name)} is none of the ratios of "{component}"'
        return Problem(where, what, nearest(name, own))
    what = f'{shown(name)} is no gearbox of the bed "{testbed.name}" with a ratio that changes'
    remedy = nearest(name, changing) if changing else "leave it out: no ratio of the bed changes"
    return Problem(where, what, remedy)

"""The sections ``[gears]`` and ``[[shifts]]`` of scenarios: which gears there are at the start, and what follows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field

from ptgen.components.component import Quantity, Record
from ptgen.errors import Problem, nearest
from ptgen.gears import analyse_gears, layout_of_part
from ptgen.testbed.gear_tables import known_ratios
from ptgen.testbed.problems import dotted, shown, validated
from ptgen.testbed.profile import Bounds, Points, Profile, Recording, read_profile
from ptgen.testbed.shift_plan import NEUTRAL, Shift, ShiftCourse, ShiftKind, ShiftWish
from ptgen.testbed.testbed import Testbed

__all__ = ["ShiftPlan", "ShiftSection", "read_shifts"]

_SHARE = Bounds(0.0, 1.0, "write 0 for open, 1 for the full capacity, or a share in between")

_DURATION = "s"


class ShiftSection(Record):
    """An entry of ``[[shifts]]``."""

    component: str
    """The component that shifts."""
    time: Annotated[float, Quantity(_DURATION, "when the shift begins", positive=False)]
    to: str
    """The next gear, as the component calls it; "N" is neutral."""
    kind: ShiftKind | None = None
    """Whether the next elements are pressed while the last ones open; by default wherever that is possible."""
    release: Annotated[float, Quantity(_DURATION, "time in which elements open")] = 0.3
    apply: Annotated[float, Quantity(_DURATION, "time in which elements are pressed")] = 0.3
    overlap: Annotated[float, Quantity(_DURATION, "time for which both last", positive=False)] | None = None
    pause: Annotated[float, Quantity(_DURATION, "time between the two in which nothing is transmitted")] | None = None
    preselect: Annotated[float, Quantity(_DURATION, "time in which idle elements change before, and afterwards")] = 0.2
    hold: Annotated[float, Quantity("", "share of the capacity to which engaged elements are pressed")] = 1.0
    ratio_time: (
        tuple[
            Annotated[float, Quantity(_DURATION, "when the ratio for control begins to move", positive=False)],
            Annotated[float, Quantity(_DURATION, "when it has arrived")],
        ]
        | None
    ) = None
    """Times from the start of the shift."""
    elements: dict[str, Points | Recording] = Field(default_factory=dict)
    """Element = its course over the time from the start of the shift, in place of a ramp."""


@dataclass(frozen=True)
class ShiftPlan:
    """What gears and shifts of a scenario come to.

    Attributes
    ----------
    actuations, ratios : mapping of str to Profile
        With the keys of `ptgen.testbed.scenario.Scenario`.
    control : mapping of str to Profile
        Ratios for control alone, by component; a course in ``[ratios]`` goes before them.
    gears : mapping of str to str
        Component -> gear at the start.
    shifts : tuple of Shift
        In the order of time.
    """

    actuations: Mapping[str, Profile] = field(default_factory=dict)
    ratios: Mapping[str, Profile] = field(default_factory=dict)
    control: Mapping[str, Profile] = field(default_factory=dict)
    gears: Mapping[str, str] = field(default_factory=dict)
    shifts: tuple[Shift, ...] = ()


def read_shifts(
    gears: object, shifts: object, testbed: Testbed, folder: Path, duration: float | None
) -> tuple[ShiftPlan, list[Problem]]:
    """Read and carry out the gears and shifts of a scenario.

    Parameters
    ----------
    gears, shifts : object
        What stands in the sections; None if a section is missing.
    testbed : Testbed
    folder : Path
        Where measurement files are looked for.
    duration : float or None
        How long the scenario takes (s), if that is known.

    Returns
    -------
    plan : ShiftPlan
    problems : list of Problem
        All problems of both sections.
    """
    start, problems = _gears({} if gears is None else gears, testbed)
    entries, found = _sections([] if shifts is None else shifts, testbed, folder)
    problems += found
    names = dict.fromkeys([*start, *(entry.section.component for entry in entries)])
    unclear = _unclear(problems, gears, shifts)
    shifting = {entry.section.component for entry in entries}
    courses = {name: _course(name, start.get(name, NEUTRAL), testbed, name in shifting) for name in names}
    done: list[Shift] = []
    for entry in sorted(entries, key=lambda entry: entry.section.time):
        course = courses[entry.section.component]
        if course.name in unclear:  # what is said of the others would be wrong
            continue
        found = _check(entry, course, duration)
        problems += found
        if found:
            unclear.add(course.name)
        else:
            done.append(course.shift(_wish(entry)))
    actuations = {key: profile for course in courses.values() for key, profile in course.actuations().items()}
    for element in actuations:
        if element not in testbed.actuated:
            what = f'"{element}" stands in the gears, but is not actuated'
            remedy = "write actuated = true where it is described, or take it out of the gears"
            problems.append(Problem("gears" if gears else "shifts", what, remedy))
    control = {name: course.control() for name, course in courses.items() if name in testbed.ratios}
    plan = ShiftPlan(
        actuations=actuations,
        ratios={key: profile for course in courses.values() for key, profile in course.ratios().items()},
        control={name: profile for name, profile in control.items() if profile is not None},
        gears={name: start.get(name, NEUTRAL) for name in names},
        shifts=tuple(sorted(done, key=lambda shift: shift.start)),
    )
    return plan, problems


def _unclear(problems: Sequence[Problem], gears: object, shifts: object) -> set[object]:
    """Return the components of whose gears something is unknown, because an entry has a problem."""
    found: set[object] = set()
    for name in gears if isinstance(gears, dict) else ():
        if any(problem.where == dotted("gears", name) for problem in problems):
            found.add(name)
    for index, entry in enumerate(shifts if isinstance(shifts, list) else ()):
        place = dotted("shifts", index)
        if isinstance(entry, dict) and any(f"{problem.where}.".startswith(f"{place}.") for problem in problems):
            name = entry.get("component")
            found.add(name if isinstance(name, str) else None)
    return found


@dataclass(frozen=True)
class _Entry:
    """An entry of ``[[shifts]]`` that names a gear of a component; `index` is its place in the file."""

    index: int
    section: ShiftSection
    profiles: Mapping[str, Profile]

    def where(self, *path: object) -> str:
        return dotted("shifts", self.index, *path)


def _course(name: str, gear: str, testbed: Testbed, shifts: bool) -> ShiftCourse:
    component, table = testbed.components[name], testbed.gear_tables.get(name)
    has_own = any(key == "ratio" for key in component.spans())
    wanted: Mapping[str, float] = {}
    if name in testbed.ratios and not has_own:
        wanted = table.gears if table is not None else known_ratios(component)
    elements = component.gear_elements()
    fixed = not any(way.ratios for ways in component.engagements().values() for way in ways)
    analysis = analyse_gears(layout_of_part(component, name), elements) if shifts and elements and fixed else None
    return ShiftCourse(name, component, gear, wanted, analysis)


def _shiftable(testbed: Testbed) -> list[str]:
    return [name for name, component in testbed.components.items() if component.engagements()]


def _no_gears(name: object, where: str, testbed: Testbed) -> Problem:
    known = _shiftable(testbed)
    what = f"{shown(name)} is no component of the bed"
    if name in testbed.components:
        what = f'"{name}" has no gears'
    remedy = nearest(str(name), known) if known else "leave it out: no component of the bed has gears"
    return Problem(where, what, remedy)


def _no_gear(name: str, gear: object, where: str, testbed: Testbed) -> Problem | None:
    known = [*testbed.components[name].engagements(), NEUTRAL]
    if gear in known:
        return None
    if not isinstance(gear, str):
        return Problem(where, f"must be a text, got {shown(gear)}", f'put it into quotation marks, e.g. "{known[0]}"')
    return Problem(where, f'{shown(gear)} is no gear of "{name}"', nearest(gear, known))


def _gears(table: object, testbed: Testbed) -> tuple[dict[str, str], list[Problem]]:
    if not isinstance(table, dict):
        remedy = 'write [gears] with gears = "1"'
        return {}, [Problem("gears", f"must be a table, got {shown(table)}", remedy)]
    gears: dict[str, str] = {}
    problems: list[Problem] = []
    for name, gear in table.items():
        where = dotted("gears", name)
        if name not in _shiftable(testbed):
            problems.append(_no_gears(name, where, testbed))
        elif problem := _no_gear(name, gear, where, testbed):
            problems.append(problem)
        else:
            gears[name] = gear
    return gears, problems


def _sections(entries: object, testbed: Testbed, folder: Path) -> tuple[list[_Entry], list[Problem]]:
    if not isinstance(entries, list):
        remedy = 'write [[shifts]], in two brackets, with component = "gears", time = "2 s" and to = "2"'
        return [], [Problem("shifts", f"must be a list of tables, got {shown(entries)}", remedy)]
    found: list[_Entry] = []
    problems: list[Problem] = []
    for index, entry in enumerate(entries):
        own = entry.get("elements") if isinstance(entry, dict) else None
        rest = {key: value for key, value in entry.items() if key != "elements"} if isinstance(entry, dict) else entry
        section, wrong = validated(ShiftSection, rest, "shifts", index)
        profiles: dict[str, Profile] = {}
        if section is not None:
            name, where = section.component, dotted("shifts", index)
            if name not in _shiftable(testbed):
                wrong.append(_no_gears(name, f"{where}.component", testbed))
            else:
                problem = _no_gear(name, section.to, f"{where}.to", testbed)
                wrong += [problem] if problem else []
                profiles, more = _profiles(own, name, index, testbed, folder)
                wrong += more
            wrong += _inconsistent(section, where)
        problems += wrong
        if section is not None and not wrong:
            found.append(_Entry(index, section, profiles))
    return found, problems


def _inconsistent(section: ShiftSection, where: str) -> list[Problem]:
    problems = []
    if section.hold > 1:
        problems.append(Problem(f"{where}.hold", f"must be from 0 to 1, got {section.hold:g}", _SHARE.remedy))
    if section.kind == "overlapping" and section.pause is not None:
        remedy = 'remove it, or write kind = "non-overlapping"'
        problems.append(Problem(f"{where}.pause", "has no place in an overlapping shift", remedy))
    if section.overlap is not None and (section.kind == "non-overlapping" or section.pause is not None):
        remedy = 'remove it, or write kind = "overlapping" without a pause'
        problems.append(Problem(f"{where}.overlap", "has no place in a shift that does not overlap", remedy))
    most = min(section.release, section.apply)
    if section.overlap is not None and section.overlap > most:
        what = f"must not be longer than release and apply, {most:g} s, got {section.overlap:g} s"
        problems.append(Problem(f"{where}.overlap", what, "shorten it, or lengthen them"))
    if section.ratio_time is not None and section.ratio_time[0] >= section.ratio_time[1]:
        what = f"must rise, got {section.ratio_time[0]:g} s and {section.ratio_time[1]:g} s"
        problems.append(Problem(f"{where}.ratio_time", what, "exchange the two"))
    return problems


def _profiles(
    table: Any, name: str, index: int, testbed: Testbed, folder: Path
) -> tuple[dict[str, Profile], list[Problem]]:
    """Read the elements that have a course of their own in a shift."""
    at = ("shifts", index, "elements")
    if table is None:
        return {}, []
    if not isinstance(table, dict):
        remedy = 'write elements.A = { time = ["0 s", "0.4 s"], value = [0, 1] }'
        return {}, [Problem(dotted(*at), f"must be a table of elements, got {shown(table)}", remedy)]
    known = [element.removeprefix(f"{name}.") for element in testbed.actuated if element.startswith(f"{name}.")]
    profiles: dict[str, Profile] = {}
    problems: list[Problem] = []
    for element, entry in table.items():
        where = dotted(*at, element)
        if element not in known:
            problems.append(Problem(where, f'is no actuated element of "{name}"', nearest(element, known)))
            continue
        profile, found = read_profile(entry, "", folder, *at, element, bounds=_SHARE)
        problems += found
        if profile is None:
            continue
        if profile.shape == "steps":
            problems.append(Problem(f"{where}.shape", "must be lines: no element closes in no time", "remove shape"))
        else:
            profiles[element] = profile
    return profiles, problems


def _wish(entry: _Entry) -> ShiftWish:
    section = entry.section
    return ShiftWish(
        to=section.to,
        start=section.time,
        kind=_kind(section),
        release=section.release,
        apply=section.apply,
        pause=0.2 if section.pause is None else section.pause,
        preselect=section.preselect,
        overlap=section.overlap,
        hold=section.hold,
        ratio_time=section.ratio_time,
        profiles=entry.profiles,
    )


def _kind(section: ShiftSection) -> ShiftKind | None:
    """Return the kind of a shift; one that has a pause does not overlap."""
    if section.kind is None and section.pause is not None:
        return "non-overlapping"
    return "overlapping" if section.kind is None and section.overlap is not None else section.kind


def _check(entry: _Entry, course: ShiftCourse, duration: float | None) -> list[Problem]:
    """Return why a shift cannot be carried out after those before it."""
    section, name = entry.section, course.name
    problems: list[Problem] = []
    if duration is not None and section.time >= duration:
        what = f"begins at {section.time:g} s, when the scenario of {duration:g} s has ended"
        problems.append(Problem(entry.where("time"), what, "let it begin earlier, or lengthen the scenario"))
    if section.time < course.end - 1e-9:
        what = f'begins at {section.time:g} s, before the shift of "{name}" to {course.gear} has ended'
        problems.append(Problem(entry.where("time"), what, f"let it begin at {course.end:g} s or later"))
    elif section.to == course.gear:
        what = f'"{name}" is in gear {course.gear} already'
        problems.append(Problem(entry.where("to"), what, "name another gear, or remove the shift"))
    if problems:
        return problems
    obstacle = course.obstacle(section.to)
    if _kind(section) == "overlapping" and obstacle:
        what = f'"{name}" cannot shift from {course.gear} to {section.to} overlapping: {obstacle}'
        through = course.way_round(section.to)
        remedy = 'write kind = "non-overlapping", with a pause'
        remedy += f", or shift to {through} first" if through is not None else ""
        return [Problem(entry.where("kind" if section.kind is not None else "overlap"), what, remedy)]
    if section.ratio_time is not None and course.control() is None and section.to != NEUTRAL:
        what = f'"{name}" has no ratio for control that shifts could move'
        return [Problem(entry.where("ratio_time"), what, "list it in [reduction] as_ratio of the bed, or remove this")]
    engaged = course.way(section.to).elements
    for element, profile in entry.profiles.items():
        where, level = entry.where("elements", element, "value"), course.level(element)
        if profile.value[0] != level:
            what = f"begins at {profile.value[0]:g}, but the element is at {level:g} when the shift begins"
            problems.append(Problem(where, what, f"begin with {level:g}"))
        if element in engaged and profile.value[-1] == 0:
            what = f"ends at 0, but the element is engaged in gear {section.to}"
            problems.append(Problem(where, what, "end with 1, or a share of the capacity"))
        elif element not in engaged and profile.value[-1] != 0:
            what = f"ends at {profile.value[-1]:g}, but the element is open in gear {section.to}"
            problems.append(Problem(where, what, "end with 0"))
    return problems

"""Tuning of a bed: the largest wishes that the sampled loop of the full bed can hold, and what stands in the way."""

from __future__ import annotations

import hashlib
import itertools
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from ptgen.analysis.continuous_proof import Verdict, gain_values, prove
from ptgen.analysis.demands import Check, DemandedLoop, Demands
from ptgen.analysis.limits import NearMode, NearModes, PhaseBudget, phase_budget
from ptgen.analysis.symbolic_loop import ACCELERATION_TORQUE, LOAD_COMPENSATION
from ptgen.analysis.wish_search import LEAST, FoundShares, find_shares
from ptgen.analysis.wishes import WishedParameters
from ptgen.errors import Problem, PtgenError, RunError
from ptgen.files import replace_file
from ptgen.loops.loop_analysis import chosen_frictions, full_model, loop_family, sensor_filters
from ptgen.loops.tuning_wishes import Wish, Wished, wished
from ptgen.mechanism.model import Model
from ptgen.project import Project
from ptgen.testbed.rewriting import with_control
from ptgen.units import parse

__all__ = ["GainResult", "Help", "LoopTuning", "Obstacle", "WishResult", "tune", "write_wishes"]

_MORE = (1.05, 1.1, 1.2, 1.5, 2.0)
"""Factors by which a wish is raised to see what is in its way."""

_SWITCHES = ((LOAD_COMPENSATION, (0.8, 0.5, 0.0)), (ACCELERATION_TORQUE, (0.5, 0.0)))
_RAISED = (1.5, 2.0, 3.0)

_ROUNDINGS = 20
"""Steps of the third digit by which a value may be lowered besides."""


@dataclass(frozen=True)
class Obstacle:
    """The demand that fails, and what is known of it.

    Attributes
    ----------
    check : Check
    controls : str
        ``"torque"`` or ``"speed"``, what the machine controls; empty without a machine.
    mode : NearMode or None
        The mode that is nearest to its frequency.
    budget : PhaseBudget or None
        Phase that the machine's drive takes there.
    """

    check: Check
    controls: str
    mode: NearMode | None
    budget: PhaseBudget | None


@dataclass(frozen=True)
class WishResult:
    """A wish and what can be held of it.

    Attributes
    ----------
    wish : Wish
    held : float or None
        In SI units; None if nothing was found.
    text : str
        What would be written; empty if nothing was found.
    alone : float or None
        Largest share of it with all other wishes as wished; None if no share of it alone is enough.
    obstacle : Obstacle or None
        What fails with some more of it; None if it is held.
    """

    wish: Wish
    held: float | None
    text: str
    alone: float | None
    obstacle: Obstacle | None

    @property
    def share(self) -> float | None:
        """Share of the wish that is held."""
        return None if self.held is None else self.held / self.wish.wanted

    @property
    def is_reduced(self) -> bool:
        """Whether less is held than wished."""
        return self.held is not None and self.held < self.wish.wanted


@dataclass(frozen=True)
class GainResult:
    """A gain of the controller, and the open intervals in which the continuous loop is stable, all else as it is."""

    name: str
    value: float
    unit: str
    intervals: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Help:
    """A change with which all wishes hold: a switch of the controller at a value, or a wish raised by a factor."""

    name: str
    value: float
    is_switch: bool


@dataclass(frozen=True)
class LoopTuning:
    """What a tuning found.

    Attributes
    ----------
    name, title, file : str
    locked, free : tuple of str
        Friction elements that stick, and those that slip without friction.
    sample_time : float
        Step (s).
    demands : Demands
    wishes : tuple of WishResult
    wished_checks : tuple of Check
        Of the wishes as they are.
    held_checks : tuple of Check
        Of what is held; empty if nothing was found.
    gains : tuple of GainResult
        Of what is held.
    common : float or None
        The common factor from which the search went on; 1 if the wishes hold.
    is_robust : bool
        Whether reduced wishes may be 5 and 10 % smaller too.
    obstacle : Obstacle or None
        What fails with the wishes as they are; None if they hold.
    least : Obstacle or None
        If nothing was found: what fails with a hundredth of all wishes.
    helps : tuple of Help
        If nothing was found: what would make the wishes hold.
    notes : tuple of str
        What was converted.
    evaluations : int
        How many wishes were judged.
    changes : mapping of str to str or float
        What `write_wishes` changes in section ``[control]``.
    """

    name: str
    title: str
    file: str
    locked: tuple[str, ...]
    free: tuple[str, ...]
    sample_time: float
    demands: Demands
    wishes: tuple[WishResult, ...]
    wished_checks: tuple[Check, ...]
    held_checks: tuple[Check, ...]
    gains: tuple[GainResult, ...]
    common: float | None
    is_robust: bool
    obstacle: Obstacle | None
    least: Obstacle | None
    helps: tuple[Help, ...]
    notes: tuple[str, ...]
    evaluations: int
    changes: Mapping[str, str | float]

    @property
    def holds_as_wished(self) -> bool:
        """Whether the wishes hold as they are."""
        return self.obstacle is None

    @property
    def is_found(self) -> bool:
        """Whether any wishes were found that hold."""
        return bool(self.held_checks)


def tune(
    project: Project,
    options: Mapping[str, object] | None = None,
    *,
    locked: Collection[str] = (),
    free: Collection[str] = (),
    progress: Callable[[float], None] = lambda share: None,
) -> LoopTuning:
    """Find the largest wishes for which the emitted loop of the full bed holds the demanded margins.

    Parameters
    ----------
    project : Project
    options : mapping, optional
        Wishes and demands that differ from the file's, keys of `ptgen.loops.tuning_wishes.OPTIONS`, written as the
        file writes them, such as ``{"speed_bandwidth": "5 Hz"}``.
    locked, free : collection of str
        Friction elements that stick, or slip, other than the file takes them.
    progress : callable, optional
        Takes the share of the work that is done.

    Raises
    ------
    PtgenError
        With every problem of the options.
    """
    held, problems = chosen_frictions(project, locked, free)
    asked, wrong = wished(project, options or {})
    if problems or wrong or asked is None:
        raise RunError([*problems, *wrong], project.testbed.file)
    full = full_model(project, held)
    loop = _loop(project, full, asked.demands)
    judge = _Judge(project, full, loop)
    wanted = {wish.key: wish.wanted for wish in asked.wishes}
    wished_checks = loop.checks(wanted)
    obstacle = judge.obstacle(wished_checks)
    progress(0.05)
    if obstacle is None:
        found = FoundShares((1.0,) * len(wanted), (1.0,) * len(wanted), 1.0, True)
    else:
        found = find_shares(
            lambda shares: loop.holds(_times(wanted, shares)), len(wanted), lambda share: progress(0.05 + 0.8 * share)
        )
    texts = _texts(asked, found, loop)
    values = {wish.key: _value(wish, texts[wish.key]) for wish in asked.wishes if wish.key in texts}
    held_checks = (wished_checks if values == wanted else loop.checks(values)) if values else ()
    progress(0.9)
    results = tuple(
        WishResult(
            wish,
            values.get(wish.key),
            texts.get(wish.key, ""),
            found.alone[k],
            judge.in_the_way(wish, values, wanted) if values and values[wish.key] < wish.wanted else None,
        )
        for k, wish in enumerate(asked.wishes)
    )
    bed = project.testbed
    least = judge.obstacle(loop.checks(_times(wanted, itertools.repeat(LEAST)))) if not values else None
    return LoopTuning(
        name=bed.name,
        title=bed.title,
        file=bed.file,
        locked=held,
        free=tuple(f.name for f in project.control_model.frictions if f.name not in held),
        sample_time=bed.sample_time,
        demands=asked.demands,
        wishes=results,
        wished_checks=wished_checks,
        held_checks=held_checks,
        gains=_gains(project, loop, values) if values else (),
        common=found.common,
        is_robust=found.is_robust,
        obstacle=obstacle,
        least=least,
        helps=() if values else _helps(project, full, asked.demands, loop, wanted),
        notes=asked.notes,
        evaluations=loop.evaluations,
        changes=_changes(project, asked, results),
    )


def write_wishes(
    project: Project,
    found: LoopTuning,
    *,
    locked: Collection[str] = (),
    free: Collection[str] = (),
) -> bool:
    """Write the wishes that hold into the bed file; tell whether anything changed.

    The new file is read again and has to hold all demands before it takes the place of the old one.

    Parameters
    ----------
    project : Project
    found : LoopTuning
    locked, free : collection of str
        As for `tune`.

    Raises
    ------
    PtgenError
        If nothing was found that holds, or the file cannot be written.
    """
    file = project.testbed.file
    if not found.is_found:
        what = "nothing was written, as no wishes were found that hold the margins"
        raise RunError(Problem("--write", what, "see what stands in the way, without --write"), file)
    if not found.changes:
        return False
    try:
        content = Path(file).read_bytes()
    except OSError as error:
        what = f"cannot be read ({error.strerror or error})"
        raise RunError(Problem("", what, "check path and permissions"), file) from None
    if hashlib.sha256(content).hexdigest() != project.testbed.digest:
        raise RunError(Problem("", "has changed since it was read", "run the command again"), file)
    check = partial(_check_written, file=file, demands=found.demands, locked=locked, free=free)
    replace_file(Path(file), with_control(content, found.changes, file), check)
    return True


def _check_written(path: Path, file: str, demands: Demands, locked: Collection[str], free: Collection[str]) -> None:
    """Check that a file holds the demands with its own wishes."""
    try:
        project = Project.read(path)
        held, _ = chosen_frictions(project, locked, free)
        loop = _loop(project, full_model(project, held), demands)
        failed = [check for check in loop.checks({}) if not check.holds]
    except PtgenError as error:
        raise type(error)(error.problems, file) from None
    if failed:
        what = f"with the wishes as they would be written, {failed[0].kind} is {failed[0].value:.4g}"
        raise RunError(Problem("--write", what, "the file was left as it was; ask for a little less"), file)


def _loop(project: Project, full: Model, demands: Demands) -> DemandedLoop:
    design, bed = project.design, project.testbed
    wishes = WishedParameters(
        design.decoupling, project.reduced.full, project.reduced.modes_before, bed.tuning, bed.sample_time
    )
    proof = project.proof
    return DemandedLoop(loop_family(project, full), wishes, proof.settings[0], proof.loop, demands)


def _times(wishes: Mapping[str, float], shares: Collection[float] | itertools.repeat[float]) -> dict[str, float]:
    return {key: share * value for (key, value), share in zip(wishes.items(), shares, strict=False)}


def _value(wish: Wish, text: str) -> float:
    return wish.wanted if text == wish.text else parse(text, wish.unit)


def _texts(asked: Wished, found: FoundShares, loop: DemandedLoop) -> dict[str, str]:
    """Return what would be written for each wish: reduced ones rounded down, so that they still hold."""
    if found.shares is None:
        return {}
    texts, reduced = {}, []
    for wish, share in zip(asked.wishes, found.shares, strict=True):
        texts[wish.key] = wish.text if share == 1.0 else wish.written(share * wish.wanted)
        reduced += [wish] if share < 1.0 else []
    for _ in range(_ROUNDINGS):
        if not reduced or loop.holds({wish.key: _value(wish, texts[wish.key]) for wish in asked.wishes}):
            return texts
        for wish in reduced:
            texts[wish.key] = wish.written(_value(wish, texts[wish.key]) * (1 - 1e-6))
    return {}


def _changes(project: Project, asked: Wished, results: tuple[WishResult, ...]) -> dict[str, str | float]:
    """Return what differs from the file, by its key."""
    tuning = project.testbed.tuning.model_dump()
    changes: dict[str, str | float] = {}
    for result in results:
        if result.held is not None and result.held != tuning[result.wish.key]:
            changes[result.wish.key] = float(result.text) if result.wish.is_number else result.text
    for margin in asked.margins if all(result.held is not None for result in results) else ():
        if margin.wanted != tuning[margin.key]:
            changes[margin.key] = margin.wanted if margin.is_number else margin.text
    return changes


class _Judge:
    """Finds out what stands in the way."""

    def __init__(self, project: Project, full: Model, loop: DemandedLoop) -> None:
        self._project, self._full, self._loop = project, full, loop
        blocks = (loop.family.plant, project.design.controller.block)
        self._table = {s.name: s.value for block in blocks for s in block.parameters}
        self._modes = NearModes(full, project.testbed.roles.speed)

    def obstacle(self, checks: tuple[Check, ...]) -> Obstacle | None:
        """Return the demand that fails by most; None if all hold."""
        failed = [check for check in checks if not check.holds]
        if not failed:
            return None
        check = min(failed, key=lambda check: check.share)
        controls = budget = None
        if check.machine:
            controls = "torque" if check.machine in self._project.testbed.roles.torque else "speed"
            if check.frequency_hz > 0:
                filters = sensor_filters(self._project, self._full, check.machine)
                budget = phase_budget(self._table, check.machine, check.frequency_hz, filters)
        return Obstacle(check, controls or "", self._modes.near(check.frequency_hz), budget)

    def in_the_way(self, wish: Wish, held: Mapping[str, float], wanted: Mapping[str, float]) -> Obstacle | None:
        """Return what fails with more of one wish, all others as they are held."""
        for more in _MORE:
            value = min(more * held[wish.key], wanted[wish.key])
            found = self.obstacle(self._loop.checks({**held, wish.key: value}))
            if found is not None:
                return found
        return self.obstacle(self._loop.checks({**held, wish.key: wanted[wish.key]}))


def _gains(project: Project, loop: DemandedLoop, wishes: Mapping[str, float]) -> tuple[GainResult, ...]:
    """Return the gains, each with the intervals that the continuous proof allows."""
    gains, parameters = loop.wishes.gains(**wishes), loop.parameters(wishes)
    setting = loop.proof
    values = {**setting.values, **gain_values(gains, loop.symbols, parameters)}
    proven = prove(loop.symbols, setting.name, setting.fixed, values)
    intervals = {g.gain.name: g.intervals for factor in proven.factors for g in factor.gains}
    units = {signal.name: signal.unit for signal in project.design.controller.block.parameters}
    return tuple(
        GainResult(name, parameters[name], units[name], intervals.get(name, ()))
        for name in sorted(gains.parameters())
        if name in parameters
    )


def _helps(
    project: Project, full: Model, demands: Demands, loop: DemandedLoop, wanted: Mapping[str, float]
) -> tuple[Help, ...]:
    """Return single changes with which all wishes hold, which a person has to decide about."""
    helps = []
    for switch, values in _SWITCHES:
        if switch.name not in loop.parameters(wanted):
            continue
        for value in values:
            fixed = {**loop.proof.fixed, switch: value}
            setting = prove(loop.symbols, loop.proof.name, fixed, loop.proof.values)
            other = DemandedLoop(loop.family, loop.wishes, setting, loop.symbols, demands, {switch.name: value})
            if setting.verdict is not Verdict.UNSTABLE and other.holds(wanted):
                helps.append(Help(switch.name, value, True))
                break
    for key in wanted:
        for factor in _RAISED:
            if loop.holds({**wanted, key: factor * wanted[key]}):
                helps.append(Help(key, factor, False))
                break
    return tuple(helps)

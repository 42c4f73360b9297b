"""The analysis of the sampled closed loop of a bed: stability, margins, what limits them, and what couples."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from ptgen.analysis.algebraic_loop import AlgebraicLoop, algebraic_loop
from ptgen.analysis.closed_loop import Pole, poles_of
from ptgen.analysis.continuous_proof import Setting
from ptgen.analysis.coupling import ReferencedLoop, referenced_loop
from ptgen.analysis.disk_margin import DiskMargin, disk_margin
from ptgen.analysis.frequency import FrequencyResponse, frequency_grid, others_closed
from ptgen.analysis.limits import NearMode, NearModes, PhaseBudget, phase_budget
from ptgen.analysis.linear import Linearisation, LoopFamily, with_dead_times
from ptgen.analysis.margins import Delay, LoopMargins, common_delay_margin, loop_margins
from ptgen.analysis.wishes import WISHES, WishedParameters
from ptgen.errors import Problem, RunError, nearest
from ptgen.loops.causes import Cause, couplings_by_cause, followed_outputs
from ptgen.mechanism.assembly import assemble
from ptgen.mechanism.model import Model
from ptgen.plant.plant import plant_block
from ptgen.project import Project
from ptgen.simulate.run import ControllerName
from ptgen.testbed.testbed import Structure

__all__ = [
    "Cause",
    "Lever",
    "LoopAnalysis",
    "LoopResult",
    "Margins",
    "analyse",
    "chosen_frictions",
    "chosen_parameters",
    "full_model",
    "loop_family",
    "sensor_filters",
]


_LESS = 0.8
"""Share of a wish that is tried to see what it does to the margins."""

_MOVED = 1.02
"""Factor in a margin below which a wish does nothing to it."""


@dataclass(frozen=True)
class LoopResult:
    """The loop of one machine and what limits it.

    Attributes
    ----------
    margins : LoopMargins
    controls : str
        ``"torque"`` or ``"speed"``.
    critical_hz : float
        Frequency (Hz) at which the loop comes nearest to instability: its sensitivity is largest there.
    mode : NearMode or None
        The mode that is nearest to that frequency.
    budget : PhaseBudget
        Phase that sampled drives take there.
    """

    margins: LoopMargins
    controls: str
    critical_hz: float
    mode: NearMode | None
    budget: PhaseBudget


@dataclass(frozen=True)
class Margins:
    """Margins with respect to all machines at once.

    Attributes
    ----------
    disk : DiskMargin
        Gain and phase of every machine on its own.
    delay : Delay
        The same additional delay in all machines.
    """

    disk: DiskMargin
    delay: Delay


@dataclass(frozen=True)
class Lever:
    """What a smaller wish does to the margins.

    Attributes
    ----------
    wish : str
        Key in section ``[control]``, or a switch of the controller.
    factor : float
        By which it was changed.
    margins : Margins or None
        With that wish; None if the loop is unstable then.
    """

    wish: str
    factor: float
    margins: Margins | None


@dataclass(frozen=True)
class LoopAnalysis:
    """Everything that was found out about the sampled closed loop.

    Attributes
    ----------
    name, title, file : str
    controller : {"decoupling", "conventional"}
    structure : {"decoupling", "individual"}
        Of the law.
    experimental : tuple of str
        Machines with super-twisting speed control, which is linear only close to zero error.
    locked, free : tuple of str
        Friction elements that stick, and those that slip without friction.
    parameters : mapping
        Parameters that were set by the user.
    sample_time : float
        Step (s).
    poles : tuple of Pole
    loops : tuple of LoopResult
        Empty if the loop is unstable.
    margins : Margins or None
    disk_mode, delay_mode : NearMode or None
        Modes nearest to the frequencies of these margins.
    pole_modes : mapping of int to NearMode
        Modes nearest to unstable and to weakly damped poles, by their place in `poles`.
    levers : tuple of Lever
    algebraic : AlgebraicLoop
    causes : tuple of Cause
    family : LoopFamily
        The loop, for figures.
    referenced : ReferencedLoop
        The loop from references, for figures.
    chosen : mapping
        All parameters that differ from the defaults of the blocks.
    continuous : Setting or None
        The proof for the reduced bed without sampling and delays; None if parameters were set, which it does not know.
    """

    name: str
    title: str
    file: str
    controller: ControllerName
    structure: Structure
    experimental: tuple[str, ...]
    locked: tuple[str, ...]
    free: tuple[str, ...]
    parameters: Mapping[str, float]
    sample_time: float
    poles: tuple[Pole, ...]
    loops: tuple[LoopResult, ...]
    margins: Margins | None
    disk_mode: NearMode | None
    delay_mode: NearMode | None
    pole_modes: Mapping[int, NearMode]
    levers: tuple[Lever, ...]
    algebraic: AlgebraicLoop
    causes: tuple[Cause, ...]
    family: LoopFamily
    referenced: ReferencedLoop
    chosen: Mapping[str, float]
    continuous: Setting | None

    @property
    def law(self) -> str:
        """What the controller is called: individual, if its machines do not work together."""
        return self.structure if self.controller == "decoupling" else self.controller

    @property
    def is_stable(self) -> bool:
        """Whether no pole lies outside the unit circle."""
        return not any(pole.is_unstable for pole in self.poles)

    @property
    def loop_machines(self) -> tuple[str, ...]:
        """The machines, in the order of the loops."""
        return self.family.machines

    @property
    def weakest(self) -> LoopResult | None:
        """The loop with the smallest phase margin."""
        return min(self.loops, key=lambda loop: loop.margins.phase_deg, default=None)

    @property
    def least_damped(self) -> Pole | None:
        """The pole with the smallest damping ratio, parts that coast left out."""
        return min((p for p in self.poles if not p.is_neutral), key=lambda pole: pole.damping_ratio, default=None)

    @property
    def helpful(self) -> tuple[Lever, ...]:
        """The levers that raise the disk margin or the delay margin, the most helpful first."""
        if self.margins is None:
            return tuple(lever for lever in self.levers if lever.margins is not None)
        return tuple(sorted((x for x in self.levers if self._help(x) > _MOVED), key=self._help, reverse=True))

    def _help(self, lever: Lever) -> float:
        if lever.margins is None or self.margins is None:
            return 0.0
        gained = lever.margins.disk.alpha / self.margins.disk.alpha
        if np.isfinite(self.margins.delay.time):
            gained = max(gained, lever.margins.delay.time / self.margins.delay.time)
        return gained


def analyse(
    project: Project,
    *,
    locked: Collection[str] = (),
    free: Collection[str] = (),
    controller: ControllerName = "decoupling",
    parameters: Mapping[str, float] | None = None,
) -> LoopAnalysis:
    """Analyse the sampled closed loop of a bed: the full model with the emitted controller, gaps closed.

    Parameters
    ----------
    project : Project
    locked : collection of str
        Friction elements that stick besides those that the file's section ``[reduction]`` takes for locked.
    free : collection of str
        Friction elements that slip although the file takes them for locked.
    controller : {"decoupling", "conventional"}
    parameters : mapping, optional
        Parameters of controller and plant that differ from the defaults, by name.

    Raises
    ------
    PtgenError
        With every friction element and every parameter that is not known.
    """
    given = dict(parameters or {})
    held, problems = chosen_frictions(project, locked, free)
    full = full_model(project, held)
    family = loop_family(project, full)
    chosen, wrong = chosen_parameters(project, family, controller, given)
    if problems or wrong:
        raise RunError([*problems, *wrong], project.testbed.file)
    table = _table(project, family, chosen)
    compensated = table.get("load_compensation", 0.0) > 0
    modes = NearModes(full, project.testbed.roles.speed if compensated else ())
    loop = family.delayed(chosen)
    poles = poles_of(loop.closed(), loop.sample_time)
    stable = not any(pole.is_unstable for pole in poles)
    margins = _margins(family, chosen) if stable else None
    roles = dict.fromkeys(project.testbed.roles.torque, "torque")
    results = []
    for found, critical in zip(loop_margins(family, chosen), _critical(family, chosen), strict=True) if stable else ():
        results.append(
            LoopResult(
                margins=found,
                controls=roles.get(found.machine, "speed"),
                critical_hz=critical,
                mode=modes.near(critical),
                budget=phase_budget(table, found.machine, critical, sensor_filters(project, full, found.machine)),
            )
        )
    weak = [k for k, pole in enumerate(poles) if pole.is_unstable or (pole.damping_ratio < 0.1 and pole.s.imag > 0)]
    named = {k: modes.near(poles[k].frequency_hz) for k in weak}
    plant = Linearisation(plant_block(with_dead_times(full), project.testbed.sample_time))
    referenced = referenced_loop(
        Linearisation(project.design.controller.block), plant, followed_outputs(project), chosen
    )
    return LoopAnalysis(
        name=project.testbed.name,
        title=project.testbed.title,
        file=project.testbed.file,
        controller=controller,
        structure=project.design.decoupling.structure,
        experimental=tuple(
            name
            for name in project.testbed.roles.speed
            if project.testbed.tuning.speed_control_of(name) == "super_twisting"
        ),
        locked=held,
        free=tuple(f.name for f in project.control_model.frictions if f.name not in held),
        parameters=given,
        sample_time=loop.sample_time,
        poles=poles,
        loops=tuple(results),
        margins=margins,
        disk_mode=modes.near(margins.disk.frequency_hz) if margins else None,
        delay_mode=modes.near(margins.delay.frequency_hz) if margins else None,
        pole_modes={k: mode for k, mode in named.items() if mode is not None},
        levers=_levers(project, family, controller, given, chosen),
        algebraic=algebraic_loop(project.design.decoupling, table),
        causes=couplings_by_cause(project, full, held, chosen, referenced),
        family=family,
        referenced=referenced,
        chosen=chosen,
        continuous=None if given else _continuous(project, controller),
    )


def chosen_frictions(
    project: Project, locked: Collection[str], free: Collection[str]
) -> tuple[tuple[str, ...], list[Problem]]:
    """Return the friction elements that stick: those of the file and of `locked`, but not those of `free`.

    Besides all problems: names that are no friction elements, and elements that are to be locked and free.
    """
    names = [friction.name for friction in project.control_model.frictions]
    hint = f"known are: {', '.join(names)}" if names else "it has none"
    problems = [
        Problem(option, f'"{name}" is no friction element of this bed', hint)
        for option, wanted in (("--lock", locked), ("--free", free))
        for name in wanted
        if name not in names
    ]
    problems += [
        Problem("--lock", f'"{name}" is to be locked and free', "leave out one of the options")
        for name in dict.fromkeys(locked)
        if name in free
    ]
    wanted = {*project.testbed.reduction.locked, *locked} - set(free)
    return tuple(name for name in names if name in wanted), problems


def chosen_parameters(
    project: Project, family: LoopFamily, controller: ControllerName, given: Mapping[str, float]
) -> tuple[dict[str, float], list[Problem]]:
    """Return the parameters that differ from the blocks' defaults, and those that are not known or out of range."""
    signals = {s.name: s for block in (project.design.controller.block, family.plant) for s in block.parameters}
    problems = []
    for name, value in given.items():
        if name not in signals:
            problems.append(Problem(name, "is no parameter of this bed", nearest(name, signals)))
            continue
        least, most = signals[name].least, signals[name].most
        low = least is not None and (value < least or (value == least and not signals[name].least_allowed))
        if not np.isfinite(value) or low or (most is not None and value > most):
            word = "at least" if signals[name].least_allowed else "above"
            wanted = [] if least is None else [f"{word} {least:g}"]
            wanted += [] if most is None else [f"at most {most:g}"]
            what = f"must be {' and '.join(wanted) or 'finite'}, got {value:g}"
            problems.append(Problem(name, what, f"its unit is {signals[name].unit or '1'}"))
    return {**(project.design.controller.conventional if controller == "conventional" else {}), **given}, problems


def loop_family(project: Project, full: Model) -> LoopFamily:
    """Return the loop of a bed whose full model is `full`."""
    return LoopFamily(project.design.controller.block, plant_block(with_dead_times(full), project.testbed.sample_time))


def _continuous(project: Project, controller: ControllerName) -> Setting:
    settings = project.proof.settings
    named = [setting for setting in settings if setting.name == controller]
    return named[0] if named else settings[0]  # positions of the switches that make no difference are left out


def full_model(project: Project, locked: tuple[str, ...]) -> Model:
    """Return the full model of a bed with closed gaps, the named friction elements locked."""
    if not locked:
        return project.control_model
    mechanism = project.control_mechanism.with_closed_backlash().without_fluids()
    mechanism = mechanism.with_locked_frictions(set(locked), holding_ratios=True)
    return assemble(mechanism)


def _table(project: Project, family: LoopFamily, chosen: Mapping[str, float]) -> dict[str, float]:
    blocks = (family.plant, project.design.controller.block)
    return {**{s.name: s.value for block in blocks for s in block.parameters}, **chosen}


def sensor_filters(project: Project, full: Model, machine: str) -> list[str]:
    """Return the time constants of the filters of the sensors that the law of a machine, and its own control, read."""
    decoupling = project.design.decoupling
    row = decoupling.law.R[decoupling.machines.index(machine), :]
    own = next(iter(next(torque.row for torque in full.inputs if torque.name == machine)))
    read = {name for name, share in zip(decoupling.sensors, row, strict=True) if share != 0}
    return [
        symbol.name
        for sensor in full.sensors
        if sensor.time_constant is not None and (sensor.name in read or sensor.of == own)
        for symbol in sensor.time_constant.free_symbols
    ]


def _margins(family: LoopFamily, parameters: Mapping[str, float]) -> Margins:
    loop, steps = family.loop(parameters)
    disk = disk_margin(FrequencyResponse(loop, steps), frequency_grid(loop))
    return Margins(disk, common_delay_margin(family, parameters))


def _critical(family: LoopFamily, parameters: Mapping[str, float]) -> list[float]:
    """Return the frequency (Hz) at which each loop comes nearest to instability, in the sense of its disk margin."""
    loop, steps = family.loop(parameters)
    omega = frequency_grid(loop)
    L = FrequencyResponse(loop, steps)(omega)
    found = []
    for k in range(len(loop.machines)):
        sensitivity = 1 / (1 - others_closed(L, k))
        found.append(float(omega[np.argmax(abs(sensitivity - 0.5))] / (2 * np.pi)))
    return found


def _levers(
    project: Project,
    family: LoopFamily,
    controller: ControllerName,
    given: Mapping[str, float],
    chosen: Mapping[str, float],
) -> tuple[Lever, ...]:
    design, bed = project.design, project.testbed
    wishes = WishedParameters(
        design.decoupling,
        project.reduced.full,
        project.reduced.modes_before,
        bed.tuning,
        bed.sample_time,
        controller == "conventional",
    )
    before = wishes.at()
    levers = []
    tries = {wish: wishes.at(**{wish: _LESS * getattr(bed.tuning, wish)}) for wish in WISHES}
    for switch in ("load_compensation", "acceleration_torque"):
        if before.get(switch):
            tries[switch] = {**before, switch: _LESS * before[switch]}
    for wish, parameters in tries.items():
        changed = {name: new for name, new in parameters.items() if new != before[name] and name not in given}
        if not changed:
            continue
        tried = {**chosen, **changed}
        loop = family.delayed(tried)
        unstable = any(pole.is_unstable for pole in poles_of(loop.closed(), loop.sample_time))
        levers.append(Lever(wish, _LESS, None if unstable else _margins(family, tried)))
    return tuple(levers)

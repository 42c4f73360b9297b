"""The verdict on a closed loop in words: stable or not, how far from it, what limits it, what to do."""

from __future__ import annotations

import numpy as np

from ptgen.analysis.disk_margin import DiskMargin
from ptgen.analysis.limits import NearMode
from ptgen.loops.loop_analysis import Lever, LoopAnalysis, LoopResult
from ptgen.report.quantities import percent, readable

__all__ = [
    "ENOUGH",
    "FEW_STEPS",
    "SMALL",
    "delay_text",
    "gain_text",
    "grade",
    "mode_text",
    "percent_of",
    "shares_text",
    "verdict",
]

ENOUGH, SMALL = 2 / 3, 1 / 3
"""Disk margins: a factor of 2 and 37 deg for every machine at once, the usual demand; a factor of 1.4 and 19 deg."""

FEW_STEPS = 3.0
"""Delay margin in steps below which a small change of the drives makes the loop unstable."""

_NEAR = 1.6
"""Factor between frequencies up to which a mode counts as near."""

_DO = {
    "speed_bandwidth": "a smaller speed_bandwidth",
    "torque_bandwidth": "a smaller torque_bandwidth",
    "damping_ratio": "a smaller damping_ratio",
    "load_compensation": "load_compensation below 1",
    "acceleration_torque": "acceleration_torque below 1",
}


def grade(disk: DiskMargin) -> str:
    """Return a disk margin in one word.

    Examples
    --------
    >>> grade(DiskMargin(1.0, 10.0)), grade(DiskMargin(0.1, 10.0))
    ('good', 'small')
    """
    return "good" if disk.alpha >= ENOUGH else "fair" if disk.alpha >= SMALL else "small"


def gain_text(up: float, down: float) -> str:
    """Return both gain margins.

    Examples
    --------
    >>> gain_text(27.04, 0.0), gain_text(float("inf"), 0.075)
    ('up to x 27', 'down to x 0.075')
    """
    parts = [f"down to x {down:.3g}"] if down > 0 else []
    parts += [f"up to x {up:.3g}"] if np.isfinite(up) else []
    return ", ".join(parts) or "any"


def delay_text(time: float, sample_time: float) -> str:
    """Return a delay and how many steps that is.

    Examples
    --------
    >>> delay_text(0.00481, 1e-4), delay_text(float("inf"), 1e-4)
    ('4.81 ms (48 steps)', 'any')
    """
    if not np.isfinite(time):
        return "any"
    steps = time / sample_time
    return (
        f"{readable(time, 's', 3)} ({steps:.0f} steps)"
        if steps >= 10
        else f"{readable(time, 's', 3)} ({steps:.2g} steps)"
    )


def mode_text(mode: NearMode | None, frequency_hz: float) -> str:
    """Return the mode that a frequency belongs to, or that none is near."""
    if mode is None:
        return "there are no elastic modes"
    named = f"mode {mode.number}"
    if mode.held:
        named = f"the mode of the bed with {', '.join(mode.held)} held, as load compensation holds rotors,"
    told = f"{named} at {mode.frequency_hz:.4g} Hz ({shares_text(mode)})"
    return told if mode.distance(frequency_hz) <= _NEAR else f"no mode is near; the nearest is {told}"


def shares_text(mode: NearMode) -> str:
    """Return the components that take most of a mode's strain and motion."""
    return (
        f"{mode.strained} takes {percent_of(mode.strain_share)} of its strain, {mode.moving} "
        f"{percent_of(mode.kinetic_share)} of its motion"
    )


def percent_of(share: float) -> str:
    """Return a share in whole percent."""
    return f"{100 * share:.0f} %"


def verdict(found: LoopAnalysis) -> tuple[str, ...]:
    """Return the verdict as sentences."""
    if not found.is_stable:
        return (*_unstable(found), *_continuous(found))
    sentences = [_stable(found), *_continuous(found)]
    margins, weakest = found.margins, found.weakest
    if margins is not None:
        disk = margins.disk
        sentences.append(
            f"The margins are {grade(disk)}: all torques may at once be wrong by factors from {disk.gain_down:.3g} to "
            f"{disk.gain_up:.3g}, or by {disk.phase_deg:.3g} deg of phase (disk margin {disk.alpha:.3g} at "
            f"{disk.frequency_hz:.3g} Hz: {mode_text(found.disk_mode, disk.frequency_hz)})."
        )
        delay = margins.delay
        if np.isfinite(delay.time):
            few = ", which is very little" if delay.time < FEW_STEPS * found.sample_time else ""
            sentences.append(
                f"All torques may come {delay_text(delay.time, found.sample_time)} later{few}; then the bed swings at "
                f"{delay.frequency_hz:.3g} Hz: {mode_text(found.delay_mode, delay.frequency_hz)}."
            )
        else:
            sentences.append("No common delay makes it unstable.")
    if weakest is not None and np.isfinite(weakest.margins.phase_deg):
        sentences.append(_weakest(weakest))
    sentences.append(_advice(found))
    if found.experimental:
        names = ", ".join(found.experimental)
        sentences.append(
            f"The super-twisting speed control of {names} is experimental: all of this holds only within its small "
            "layer around zero error, where it is linear."
        )
    return tuple(sentences)


def _continuous(found: LoopAnalysis) -> list[str]:
    if found.continuous is None:
        return []
    verdict = found.continuous.verdict.value
    return [f"Without sampling and delays, on the reduced bed, the design is {verdict} (proof: ptgen derive)."]


def _stable(found: LoopAnalysis) -> str:
    least = found.least_damped
    neutral = sum(pole.is_neutral for pole in found.poles)
    coasts = f" ({neutral} neutral: parts that coast)" if neutral else ""
    if least is None:
        return f"The closed loop is stable{coasts}."
    return (
        f"The closed loop is stable{coasts}; its least damped pole is at {least.frequency_hz:.4g} Hz with a damping "
        f"ratio of {percent(least.damping_ratio)}."
    )


def _unstable(found: LoopAnalysis) -> tuple[str, ...]:
    poles = [(k, pole) for k, pole in enumerate(found.poles) if pole.is_unstable and pole.s.imag >= 0]
    sentences = ["The closed loop is UNSTABLE."]
    for k, pole in poles:
        grows = f"grows by e every {readable(1 / pole.s.real, 's', 3)}"
        if pole.s.imag > 0:
            near = mode_text(found.pole_modes.get(k), pole.frequency_hz)
            sentences.append(f"It swings at {pole.frequency_hz:.4g} Hz and {grows}: {near}.")
        else:
            sentences.append(f"It drifts away and {grows}.")
    helping = [lever for lever in found.levers if lever.margins is not None]
    if helping:
        listed = "; ".join(f"{_DO[lever.wish]} (x {lever.factor:g})" for lever in helping)
        sentences.append(f"What makes it stable: {listed}.")
    else:
        sentences.append(
            "None of the wishes, reduced by a fifth alone, makes it stable: reduce several, or run the conventional "
            "controller to see which part of the law does it (--controller, --set load_compensation=0)."
        )
    return tuple(sentences)


def _weakest(loop: LoopResult) -> str:
    margins, budget = loop.margins, loop.budget
    shares = ", ".join(f"{name} {degrees:.2g}" for name, degrees in budget.degrees.items())
    head = (
        f"Nearest to its limit is the {loop.controls} loop of {margins.machine}: {margins.phase_deg:.3g} deg of phase "
        f"{'lag' if margins.phase_is_lag else 'lead'} at {margins.phase_hz:.3g} Hz, critical at "
        f"{loop.critical_hz:.3g} Hz. "
    )
    if not margins.phase_is_lag:
        return (
            f"{head}The drive's own lag of {budget.total:.2g} deg ({shares}) keeps it away from there, so a faster "
            "drive would not help: gains and mechanics limit it."
        )
    taken = budget.total / (budget.total + margins.phase_deg)
    blame = (
        f"the drive is what limits it, above all its {budget.largest}"
        if taken > 0.5
        else "gains and mechanics limit it, not the drive"
    )
    return f"{head}The drive takes {budget.total:.2g} deg there ({shares}): {blame}."


def _advice(found: LoopAnalysis) -> str:
    margins = found.margins
    if margins is None:
        return ""
    enough = margins.disk.alpha >= ENOUGH and margins.delay.time >= FEW_STEPS * found.sample_time
    start = "Nothing needs to be done; more margin comes from" if enough else "More margin comes from"
    if not found.helpful:
        if enough:
            return "Nothing needs to be done."
        return (
            "No single wish, reduced by a fifth, gives more margin: look at the mechanics and the drives named above."
        )
    return f"{start} {'; or from '.join(_lever(lever, found) for lever in found.helpful[:2])}."


def _lever(lever: Lever, found: LoopAnalysis) -> str:
    before, after = found.margins, lever.margins
    if before is None or after is None:
        return _DO[lever.wish]
    changes = []
    if after.disk.alpha > 1.02 * before.disk.alpha:
        changes.append(f"disk margin {before.disk.alpha:.3g} to {after.disk.alpha:.3g}")
    if after.delay.time > 1.02 * before.delay.time:
        changes.append(f"delay {readable(before.delay.time, 's', 3)} to {readable(after.delay.time, 's', 3)}")
    return f"{_DO[lever.wish]} (x {lever.factor:g}: {', '.join(changes)})"

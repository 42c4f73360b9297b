r"""Margins of a sampled loop: how much gain, phase and delay it can take before it becomes unstable.

A loop is broken at the torque command of one machine, all other loops are closed. With the loop transfer function
:math:`l` (positive feedback) a factor ``k`` in that command makes the loop swing where :math:`k\,l = 1`, and a delay
``tau`` where :math:`l\,e^{-j \omega \tau} = 1`. Delays that are no whole steps change a sampled loop in a slightly
other way; the delay margins are those of the plant's own representation of its dead time, so that the emitted code
becomes unstable at that delay.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
import scipy.optimize
from numpy.typing import NDArray

from ptgen.analysis.frequency import NEUTRAL, FrequencyResponse, crossings, frequency_grid, others_closed
from ptgen.analysis.linear import LoopFamily

__all__ = ["Delay", "LoopMargins", "common_delay_margin", "delay_margins", "loop_margins", "machine_delay_margin"]

_DENSE = 400
"""States up to which all eigenvalues are computed."""

_STEPS_CHECKED = 64
"""Whole steps of delay at which stability is checked by eigenvalues, below a delay margin that was found."""


@dataclass(frozen=True)
class Delay:
    """The delay at which a loop starts to swing.

    Attributes
    ----------
    time : float
        Additional delay (s); infinite if no delay makes the loop unstable.
    frequency_hz : float
        Frequency with which it then swings (Hz); not a number if it never does.
    """

    time: float
    frequency_hz: float


@dataclass(frozen=True)
class LoopMargins:
    """Margins of the loop of one machine, the loops of all others closed.

    Attributes
    ----------
    machine : str
    gain_up, gain_up_hz : float
        Smallest factor above 1 that makes the loop swing, and the frequency (Hz); infinite if none does.
    gain_down, gain_down_hz : float
        Largest factor below 1 that makes it swing; 0 if none does.
    phase_deg, phase_hz : float
        Smallest phase shift, of either sign, that makes it swing (deg); infinite if none does.
    phase_is_lag : bool
        Whether that shift is a lag, as delays make it; if it is a lead, the lags of the drive keep away from it.
    delay : Delay
    crossovers_hz : tuple of float
        Frequencies at which the loop has gain one.
    """

    machine: str
    gain_up: float
    gain_up_hz: float
    gain_down: float
    gain_down_hz: float
    phase_deg: float
    phase_hz: float
    phase_is_lag: bool
    delay: Delay
    crossovers_hz: tuple[float, ...]


def loop_margins(family: LoopFamily, parameters: Mapping[str, float] | None = None) -> tuple[LoopMargins, ...]:
    """Return the margins of the loop of every machine; the closed loop must be stable.

    Parameters
    ----------
    family : LoopFamily
    parameters : mapping, optional
        Parameters of controller and plant that differ from the defaults.
    """
    loop, steps = family.loop(parameters)
    response, omega = FrequencyResponse(loop, steps), frequency_grid(loop)
    L = response(omega)
    return tuple(_of_machine(family, parameters, response, omega, L, k) for k in range(len(loop.machines)))


def common_delay_margin(family: LoopFamily, parameters: Mapping[str, float] | None = None) -> Delay:
    """Return the smallest delay that makes the closed loop swing when the torques of all machines have it."""
    loop, steps = family.loop(parameters)
    response, omega = FrequencyResponse(loop, steps), frequency_grid(loop)
    return _delay_margin(family, parameters, loop.machines, omega, response(omega), response, lambda L: L)


def delay_margins(
    family: LoopFamily, parameters: Mapping[str, float] | None = None, enough: float | None = None
) -> Iterator[tuple[tuple[str, ...], Delay]]:
    """Yield the delay margin of all machines in common, then that of each machine.

    Parameters
    ----------
    family : LoopFamily
    parameters : mapping, optional
        Parameters of controller and plant that differ from the defaults.
    enough : float, optional
        Delay (s); a margin that is longer by two steps or more is told without the last digits, which takes less time.

    Yields
    ------
    machines : tuple of str
        That are delayed.
    margin : Delay
    """
    loop, steps = family.loop(parameters)
    response, omega = FrequencyResponse(loop, steps), frequency_grid(loop)
    L = response(omega)
    yield loop.machines, _delay_margin(family, parameters, loop.machines, omega, L, response, lambda L: L, enough)
    for k, machine in enumerate(loop.machines):
        yield (machine,), _delay_margin(family, parameters, (machine,), omega, L, response, _picker(k), enough)


def machine_delay_margin(family: LoopFamily, machine: str, parameters: Mapping[str, float] | None = None) -> Delay:
    """Return the smallest delay of the torque of one machine that makes the closed loop swing."""
    loop, steps = family.loop(parameters)
    response, omega = FrequencyResponse(loop, steps), frequency_grid(loop)
    pick = _picker(loop.machines.index(machine))
    return _delay_margin(family, parameters, (machine,), omega, response(omega), response, pick)


def _picker(machine: int) -> Callable[[NDArray[np.complex128]], NDArray[np.complex128]]:
    return lambda L: others_closed(L, machine)[..., None, None]


def _of_machine(
    family: LoopFamily,
    parameters: Mapping[str, float] | None,
    response: FrequencyResponse,
    omega: NDArray[np.float64],
    L: NDArray[np.complex128],
    machine: int,
) -> LoopMargins:
    def transfer(w: float) -> complex:
        return complex(others_closed(response(w), machine))

    l = others_closed(L, machine)  # noqa: E741  its name in the formulas
    name = response.loop.machines[machine]
    gains = [(1 / transfer(w).real, w) for w in crossings(omega, l.imag, lambda w: transfer(w).imag)]
    gains.append((1 / l[-1].real, float(omega[-1])))  # at half the sampling rate it is real
    if abs(l[0] - l[1]) < 1e-3 * abs(l[0]):  # and at standstill, without an integrator
        gains.append((1 / l[0].real, 0.0))
    gains = [(k, w) for k, w in gains if k > 0]
    up = min((g for g in gains if g[0] > 1), default=(np.inf, np.nan))
    down = max((g for g in gains if g[0] < 1), default=(0.0, np.nan))
    crossovers = crossings(omega, np.log(abs(l)), lambda w: float(np.log(abs(transfer(w)))))
    phases = [(float(np.degrees(np.angle(transfer(w)))), w) for w in crossovers]  # a lag of that size leads to one
    phase = min(phases, key=lambda phase: abs(phase[0]), default=(np.inf, np.nan))
    delay = _delay_margin(family, parameters, (name,), omega, L, response, _picker(machine))
    return LoopMargins(
        machine=name,
        gain_up=float(up[0]),
        gain_up_hz=up[1] / (2 * np.pi),
        gain_down=float(down[0]),
        gain_down_hz=down[1] / (2 * np.pi),
        phase_deg=abs(phase[0]),
        phase_hz=phase[1] / (2 * np.pi),
        phase_is_lag=phase[0] > 0,
        delay=delay,
        crossovers_hz=tuple(w / (2 * np.pi) for w in crossovers),
    )


def _delay_margin(
    family: LoopFamily,
    parameters: Mapping[str, float] | None,
    machines: tuple[str, ...],
    omega: NDArray[np.float64],
    L: NDArray[np.complex128],
    response: FrequencyResponse,
    pick: Callable[[NDArray[np.complex128]], NDArray[np.complex128]],
    enough: float | None = None,
) -> Delay:
    """Return the smallest delay that all of `machines` can have in common; `pick` gives their loop."""
    size = abs(np.linalg.eigvals(pick(L)))
    size.sort(axis=-1)
    guesses = []
    for k in range(size.shape[-1]):

        def level(w: float, k: int = k) -> float:
            return float(np.log(np.sort(abs(np.linalg.eigvals(pick(response(w)))))[k]))

        for w in crossings(omega, np.log(size[:, k]), level):
            values = np.linalg.eigvals(pick(response(w)))
            value = values[np.argsort(abs(values))[k]]
            turned = float(np.angle(value)) % (2 * np.pi)
            guesses.append((turned / w, w))
    h = response.loop.sample_time
    first = min(guesses, default=(np.inf, np.nan))
    if enough is not None and first[0] > enough + 2 * h and not _jumps(family, parameters, machines):
        return Delay(first[0], first[1] / (2 * np.pi))
    found: list[tuple[float, float]] = []
    for tau, w in sorted(guesses):
        if found and tau > min(found)[0] + 2 * h:
            break
        refined = _refined(family, parameters, machines, pick, tau, w)
        if refined is not None:
            found.append(refined)
    best = min(found, default=(np.inf, np.nan))
    tau, w = _earlier(family, parameters, machines, best)
    return Delay(tau, w / (2 * np.pi))


def _refined(
    family: LoopFamily,
    parameters: Mapping[str, float] | None,
    machines: tuple[str, ...],
    pick: Callable[[NDArray[np.complex128]], NDArray[np.complex128]],
    tau: float,
    w: float,
) -> tuple[float, float] | None:
    """Return delay and angular frequency at which the loop has exactly gain one and no phase, near to a guess."""
    h = family.sample_time

    def missing(point: NDArray[np.float64]) -> list[float]:
        delay, frequency = max(0.0, float(point[0]) * h), float(point[1]) * w
        loop, steps = family.loop(parameters, dict.fromkeys(machines, delay))
        z = np.exp(1j * frequency * h)
        L = loop.C @ np.linalg.solve(z * np.eye(len(loop.A)) - loop.A, loop.B) * z ** -np.asarray(steps, dtype=float)
        values = np.linalg.eigvals(pick(L[None])[0])
        value = values[np.argmin(abs(values - 1))]
        return [float(np.log(abs(value))), float(np.angle(value))]

    result = scipy.optimize.root(missing, [tau / h, 1.0], tol=1e-11)
    if max(abs(v) for v in missing(result.x)) > 1e-7 or result.x[0] < 0:
        return None
    return float(result.x[0]) * h, float(result.x[1]) * w


def _earlier(
    family: LoopFamily,
    parameters: Mapping[str, float] | None,
    machines: tuple[str, ...],
    best: tuple[float, float],
) -> tuple[float, float]:
    """Return the delay margin, or a smaller delay at which the loop is unstable already.

    An inverter without lag passes its command on to the torque flange at once. Such a loop jumps where a delay
    grows beyond whole steps, and may become unstable there without having swung before.
    """
    h = family.sample_time
    base = family.delay(machines[0], parameters)
    if not _jumps(family, parameters, machines):
        return best
    last = min(best[0] / h, _STEPS_CHECKED)
    for step in range(int(last) + 1):
        for shift in (0.0, 1e-3):
            delay = (step + shift) * h - base % h
            if not 0 < delay < best[0] * (1 - 1e-6):
                continue
            A = family.delayed(parameters, dict.fromkeys(machines, delay)).closed()
            z = np.linalg.eigvals(A) if len(A) <= _DENSE else np.zeros(0)
            if (abs(z) > 1 + 10 * NEUTRAL).any():
                worst = z[np.argmax(abs(z))]
                return delay, abs(float(np.angle(worst))) / h
    return best


def _jumps(family: LoopFamily, parameters: Mapping[str, float] | None, machines: tuple[str, ...]) -> bool:
    """Tell whether the loop changes at once where a delay grows beyond whole steps."""
    h = family.sample_time
    whole = h - family.delay(machines[0], parameters) % h
    z = np.exp(1j * np.linspace(0.1, 3.0, 7))
    before, after = (
        [
            loop.C @ np.linalg.solve(value * np.eye(len(loop.A)) - loop.A, loop.B) * value ** -np.asarray(steps, float)
            for value in z
        ]
        for loop, steps in (
            family.loop(parameters, dict.fromkeys(machines, whole + shift * h)) for shift in (-1e-5, 0.0)
        )
    )
    difference = float(np.abs(np.array(after) - np.array(before)).max())
    return difference > 1e-3 * float(np.abs(np.array(after)).max(initial=1e-12))

"""What is demanded of a closed loop, and whether the loop for given wishes holds it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from ptgen.analysis.continuous_proof import Setting, gain_values
from ptgen.analysis.disk_margin import disk_margin
from ptgen.analysis.frequency import NEUTRAL, FrequencyResponse, frequency_grid, others_closed
from ptgen.analysis.linear import LoopFamily
from ptgen.analysis.margins import delay_margins
from ptgen.analysis.symbolic_loop import SymbolicLoop
from ptgen.analysis.wishes import WishedParameters

__all__ = ["Check", "CheckKind", "DemandedLoop", "Demands"]

CheckKind = Literal["stability", "proof", "common_delay", "disk", "delay"]


@dataclass(frozen=True)
class Demands:
    """Margins that a loop has to keep.

    Attributes
    ----------
    delay : float
        Additional delay (s), of each machine alone and of all together.
    disk : float
        Disk margin.
    """

    delay: float
    disk: float


@dataclass(frozen=True)
class Check:
    """One demand, and what the loop makes of it.

    Attributes
    ----------
    kind : {"stability", "proof", "common_delay", "disk", "delay"}
        ``"stability"`` of the sampled loop of the full bed, ``"proof"`` of the continuous loop of the reduced bed.
    machine : str
        The machine whose loop it is, or whose loop is the most sensitive one at that frequency; empty if unknown.
    value : float
        Margin: a delay (s), a disk margin; for stability the slowest decay (1/s), negative where it grows.
    wanted : float
        What it must be at least; zero for stability.
    frequency_hz : float
        Where it is reached; not a number if nowhere.
    """

    kind: CheckKind
    machine: str
    value: float
    wanted: float
    frequency_hz: float

    @property
    def holds(self) -> bool:
        """Whether the demand is met."""
        return self.value >= self.wanted if self.kind != "proof" else self.value > 0

    @property
    def share(self) -> float:
        """Margin by what is wanted of it; below 1 it is too small."""
        if self.kind in ("stability", "proof"):
            return np.inf if self.holds else -np.inf
        return self.value / self.wanted if self.wanted > 0 else np.inf


class DemandedLoop:
    """The loop of a bed as a function of wishes, held against demands; what was computed once is kept.

    Parameters
    ----------
    family : LoopFamily
        Of the full bed, as it is emitted.
    wishes : WishedParameters
    proof : Setting
        The continuous loop whose factors have to be stable.
    symbols : SymbolicLoop
        The loop that `proof` is about.
    demands : Demands
    fixed : mapping, optional
        Parameters that do not follow from the wishes, such as a switch.
    """

    def __init__(
        self,
        family: LoopFamily,
        wishes: WishedParameters,
        proof: Setting,
        symbols: SymbolicLoop,
        demands: Demands,
        fixed: Mapping[str, float] | None = None,
    ) -> None:
        self.family, self.wishes, self.proof, self.demands = family, wishes, proof, demands
        self.symbols, self._fixed = symbols, dict(fixed or {})
        self._known: dict[tuple[tuple[str, float], ...], bool] = {}

    @property
    def evaluations(self) -> int:
        """How many wishes were judged."""
        return len(self._known)

    def parameters(self, wishes: Mapping[str, float]) -> dict[str, float]:
        """Return the parameters of the controller for `wishes`."""
        return {**self.wishes.at(**wishes), **self._fixed}

    def holds(self, wishes: Mapping[str, float]) -> bool:
        """Tell whether all demands are met; cheap ones are looked at first."""
        key = tuple(sorted(wishes.items()))
        if key not in self._known:
            parameters = self.parameters(wishes)
            self._known[key] = not self._is_unstable_with_delay(parameters) and all(
                check.holds for check in self._checks(wishes, parameters, exact=False)
            )
        return self._known[key]

    def checks(self, wishes: Mapping[str, float]) -> tuple[Check, ...]:
        """Return every demand with its value; margins only where the loop is stable."""
        return tuple(self._checks(wishes, self.parameters(wishes)))

    def _is_unstable_with_delay(self, parameters: Mapping[str, float]) -> bool:
        """Tell whether a loop with just the demanded delay is unstable, which no margin can make good."""
        machines = self.family.machines
        for delayed in ((), machines, *((machine,) for machine in machines)):
            loop = self.family.delayed(parameters, dict.fromkeys(delayed, self.demands.delay))
            if abs(np.linalg.eigvals(loop.closed())).max(initial=0.0) > 1 + 10 * NEUTRAL:
                return True
        return False

    def _checks(
        self, wishes: Mapping[str, float], parameters: Mapping[str, float], exact: bool = True
    ) -> Iterator[Check]:
        """Yield every demand; if not `exact`, margins that are large enough anyway without their last digits."""
        stability = self._stability(parameters)
        yield stability
        yield self._proof(wishes, parameters)
        if not stability.holds:
            return
        demands = self.demands
        loop, steps = self.family.loop(parameters)
        response = FrequencyResponse(loop, steps)
        disk = disk_margin(response, frequency_grid(loop), None if exact else demands.disk)
        yield Check("disk", _sensitive(response, disk.frequency_hz), disk.alpha, demands.disk, disk.frequency_hz)
        for machines, delay in delay_margins(self.family, parameters, None if exact else demands.delay):
            alone = machines[0] if len(machines) == 1 else ""
            name = alone or _sensitive(response, delay.frequency_hz)
            yield Check("delay" if alone else "common_delay", name, delay.time, demands.delay, delay.frequency_hz)

    def _stability(self, parameters: Mapping[str, float]) -> Check:
        loop = self.family.delayed(parameters)
        z = np.linalg.eigvals(loop.closed()).astype(np.complex128)
        z = z[(abs(z) > 1e-6) & (abs(z - 1) > NEUTRAL)]
        if not z.size:
            return Check("stability", "", np.inf, 0.0, np.nan)
        s = np.log(z) / loop.sample_time
        worst = s[np.argmax(s.real)]
        neutral = abs(worst.real) * loop.sample_time <= NEUTRAL
        frequency = float(abs(worst.imag) / (2 * np.pi))
        response = FrequencyResponse(*self.family.loop(parameters))
        return Check(
            "stability", _sensitive(response, frequency), 0.0 if neutral else float(-worst.real), 0.0, frequency
        )

    def _proof(self, wishes: Mapping[str, float], parameters: Mapping[str, float]) -> Check:
        """Return the slowest decay of all factors that gains are in; others are those of the bed itself."""
        numbers = gain_values(self.wishes.gains(**wishes), self.symbols, parameters)
        table = {**self.proof.values, **numbers, **self.proof.fixed}
        worst = Check("proof", "", np.inf, 0.0, np.nan)
        for proven in self.proof.factors:
            if not proven.gains:
                continue
            poles = proven.factor.poles(table)
            pole = poles[np.argmax(poles.real)]
            if -pole.real < worst.value:
                name = next((loop.machine for loop in self.symbols.loops if loop.name in proven.factor.loops), "")
                worst = Check("proof", name, float(-pole.real), 0.0, float(abs(pole.imag) / (2 * np.pi)))
        return worst


def _sensitive(response: FrequencyResponse, frequency_hz: float) -> str:
    """Return the machine whose loop is nearest to instability at a frequency."""
    h = response.loop.sample_time
    if not np.isfinite(frequency_hz) or not 0 < frequency_hz <= 0.5 / h:
        return ""
    L = response(2 * np.pi * frequency_hz)
    sizes = [abs(1 / (1 - others_closed(L, k)) - 0.5) for k in range(len(response.loop.machines))]
    return response.loop.machines[int(np.argmax(sizes))]

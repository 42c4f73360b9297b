"""What limits a margin: the mode nearby and the component that swings in it, and who takes the phase."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp

from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.mechanism.modes import Mode, modes

__all__ = ["NearMode", "NearModes", "PhaseBudget", "energy_shares", "phase_budget"]


@dataclass(frozen=True)
class NearMode:
    """The mode whose frequency is nearest: of the bed, or of the bed with the speed-controlled machines held.

    Load torque compensation takes all reaction from a machine's rotor; what is left swings as if it were held.

    Attributes
    ----------
    number : int
        Its number in ``ptgen modal``, from 1; or among the modes with machines held.
    held : tuple of str
        Machines that are held; empty for a mode of the bed itself.
    frequency_hz, damping_ratio : float
    strained, moving : str
        Spring with the largest share in the strain energy, body with the largest in the kinetic energy.
    strain_share, kinetic_share : float
    """

    number: int
    held: tuple[str, ...]
    frequency_hz: float
    damping_ratio: float
    strained: str
    strain_share: float
    moving: str
    kinetic_share: float

    def distance(self, frequency_hz: float) -> float:
        """Return the factor between a frequency and the mode's, at least 1."""
        ratio = frequency_hz / self.frequency_hz
        return max(ratio, 1 / ratio)


@dataclass(frozen=True)
class PhaseBudget:
    """Phase (deg) that each part of a sampled drive takes at a frequency (Hz)."""

    frequency_hz: float
    degrees: Mapping[str, float]

    @property
    def total(self) -> float:
        """All of it (deg)."""
        return sum(self.degrees.values())

    @property
    def largest(self) -> str:
        """The part that takes most."""
        return max(self.degrees, key=lambda name: self.degrees[name])


def energy_shares(model: Model, mode: Mode) -> tuple[dict[str, float], dict[str, float]]:
    """Return the shares of all springs in the strain energy and of all bodies in the kinetic energy of a mode."""
    values = model.values

    def number(expression: sp.Expr) -> float:
        return float(evaluate_matrix(sp.Matrix([[expression]]), values)[0, 0])

    kinetic = {
        name: number(model.body_inertias[name]) * float((evaluate_matrix(row, values)[0] @ mode.vector) ** 2)
        for name, row in model.body_rows.items()
    }
    rates = evaluate_matrix(model.twist_rows, values) @ mode.vector
    strain = {
        name: number(model.spring_stiffness[name]) * float((evaluate_matrix(row, values)[0] @ rates) ** 2)
        for name, row in model.spring_rows.items()
    }
    return _normalised(strain), _normalised(kinetic)


class NearModes:
    """Finds the mode next to a frequency.

    Parameters
    ----------
    model : Model
        The full model.
    held : tuple of str
        Speed-controlled machines, if their load torque is compensated.
    """

    def __init__(self, model: Model, held: tuple[str, ...] = ()) -> None:
        self._model = model
        rotors = [next(iter(torque.row)) for torque in model.inputs if torque.name in held]
        self._modes: list[tuple[int, tuple[str, ...], Mode]] = [
            (number, (), mode) for number, mode in enumerate(modes(model), start=1)
        ]
        if held:
            self._modes += [(number, held, mode) for number, mode in enumerate(modes(model, held=rotors), start=1)]

    def near(self, frequency_hz: float) -> NearMode | None:
        """Return the elastic mode that is nearest on a logarithmic scale; None if there is none."""
        elastic = [item for item in self._modes if item[2].frequency_hz > 0]
        if not elastic or not np.isfinite(frequency_hz) or frequency_hz <= 0:
            return None
        number, held, mode = min(elastic, key=lambda item: abs(np.log(item[2].frequency_hz / frequency_hz)))
        strain, kinetic = energy_shares(self._model, mode)
        strained, moving = max(strain, key=lambda k: strain[k]), max(kinetic, key=lambda k: kinetic[k])
        return NearMode(
            number=number,
            held=held,
            frequency_hz=mode.frequency_hz,
            damping_ratio=mode.damping_ratio,
            strained=strained,
            strain_share=strain[strained],
            moving=moving.removesuffix(".shaft"),
            kinetic_share=kinetic[moving],
        )


def phase_budget(
    parameters: Mapping[str, float], machine: str, frequency_hz: float, filters: Sequence[str] = ()
) -> PhaseBudget:
    """Return the phase that holding a torque over a step, computation, the inverter and sensor filters take.

    Parameters
    ----------
    parameters : mapping
        Parameters of plant and controller, by name.
    machine : str
    frequency_hz : float
    filters : sequence of str
        Parameters that are time constants of the filters of sensors that the machine's law reads; the slowest counts.
    """
    slowest = max((parameters.get(name, 0.0) for name in filters), default=0.0)
    omega = 2 * np.pi * frequency_hz
    degrees = {
        "sampling": np.degrees(omega * parameters["sample_time"] / 2),
        "computation": np.degrees(omega * parameters.get("computation_delay", 0.0)),
        "dead time": np.degrees(omega * parameters.get(f"{machine}_inverter_dead_time", 0.0)),
        "inverter lag": np.degrees(np.arctan(omega * parameters.get(f"{machine}_inverter_time_constant", 0.0))),
    }
    degrees["sensor filters"] = np.degrees(np.arctan(omega * slowest))
    present = {name: float(value) for name, value in degrees.items() if value > 0}
    return PhaseBudget(frequency_hz, present)


def _normalised(shares: Mapping[str, float]) -> dict[str, float]:
    total = sum(shares.values())
    return {name: share / total if total > 0 else 0.0 for name, share in shares.items()}

"""What keeps the references within what the machines can do: section ``[governor]`` of a bed file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Literal

from pydantic import Field, field_validator

from ptgen.components.component import Component, Quantity, Record
from ptgen.errors import Problem

__all__ = ["GovernorKind", "GovernorSettings", "check_governor"]

GovernorKind = Literal["none", "sequential", "sequential_modified", "optimal"]


class GovernorSettings(Record):
    """The reference governor: which one, and how much it leaves free.

    References
    ----------
    Source Chapter 7: limits (7.30)-(7.34), optimal governor (7.36), sequential governor (7.37)-(7.43).
    """

    kind: GovernorKind = "none"
    """None, one machine after the other (7.41), the same and allowed to go back (7.43), or the optimal one (7.36)."""
    horizon: Annotated[float, Quantity("s", "how far the optimal governor looks ahead", positive=False)] | None = None
    """By default as far as longer horizons add nothing."""
    reserve: Annotated[
        float, Quantity("", "share of every machine's torque that is kept free, eps_1 (7.30)", positive=False)
    ] = 0.05
    stationary_reserve: Annotated[
        float,
        Quantity("", "further share kept free of stationary torques, and of speeds, eps_inf (7.32)", positive=False),
    ] = 0.02
    removal: Annotated[
        float, Quantity("", "share of a limit by which a row may bind and yet be left out", positive=False)
    ] = 0.0005
    torque_weight: Annotated[float, Quantity("", "weight of a torque reference, alpha_T (7.36)")] = 1.0
    speed_weight: Annotated[float, Quantity("", "weight of a speed reference, alpha_omega (7.36)")] = 100.0
    tie: Annotated[
        float, Quantity("rad/s", "speed references that differ by less stay together, mu", positive=False)
    ] = 0.10471975511965977
    torque_rate_min: Annotated[
        float, Quantity("N m/s", "rate of a torque reference that speeds leave room for", positive=False)
    ] = 1000.0
    torque_reserve: Annotated[
        float, Quantity("N m", "torque of a torque-controlled machine that speeds leave free", positive=False)
    ] = 0.0
    iterations: Annotated[int, Field(strict=True)] = 40
    """Largest number of steps of the optimal governor's solver."""

    @field_validator("reserve", "stationary_reserve", "removal")
    @classmethod
    def _small_share(cls, value: float) -> float:
        if value >= 0.5:
            raise ValueError(f"must be below 0.5, got {value:g}; it is a share of the torque that stays unused")
        return value

    @field_validator("iterations")
    @classmethod
    def _bounded(cls, value: int) -> int:
        if not 1 <= value <= 1000:
            raise ValueError(f"must be from 1 to 1000, got {value}; each one takes time in every step")
        return value

    @property
    def is_chosen(self) -> bool:
        """Whether there is a governor at all."""
        return self.kind != "none"


def check_governor(kind: object, speed_control: object, components: Mapping[str, Component]) -> list[Problem]:
    """Return what stands in the way of a governor in the rest of a bed file.

    Parameters
    ----------
    kind : object
        What stands in ``governor.kind``.
    speed_control : object
        What stands in ``control.speed_control``.
    components : mapping of str to Component
    """
    problems: list[Problem] = []
    if kind not in ("sequential", "sequential_modified", "optimal"):
        return problems
    named = speed_control.items() if isinstance(speed_control, dict) else [("", speed_control)]
    twisting = [machine for machine, control in named if control == "super_twisting"]
    if twisting:
        whose = f"of {' and '.join(twisting)} " if twisting[0] else ""
        what = f"needs speed control that is linear in its reference; that {whose}is super-twisting"
        problems.append(Problem("governor.kind", what, 'choose "pi" or "observer" as control.speed_control, or "none"'))
    changing = [
        name
        for name, component in components.items()
        if any(parameter.span is not None for parameter in component.parameters(name))
    ]
    if kind == "optimal" and changing:
        what = f"looks ahead with one model of the bed, but the ratio of {' and '.join(changing)} changes at run time"
        problems.append(Problem("governor.kind", what, 'choose "sequential_modified", which needs no model'))
    return problems

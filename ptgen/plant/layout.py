"""Where states, inputs and friction elements stand in the arrays of the plant."""

from __future__ import annotations

from dataclasses import dataclass

from ptgen.elements import Friction
from ptgen.mechanism.model import Model

__all__ = ["Layout", "identifier", "signal_name"]


def identifier(friction: Friction) -> str:
    """Return the name of a friction element as a C identifier."""
    return friction.name.replace(".", "_")


def signal_name(place: str) -> str:
    """Return the name of the torque signal of a place: ``diff.input`` gives ``diff_input_torque``."""
    return place.replace(".", "_") + "_torque"


@dataclass(frozen=True)
class Layout:
    """Where things stand in the state array ``x`` and in the columns of its matrices."""

    n_z: int
    n_e: int
    lagging: tuple[int, ...]
    n_u: int
    n_f: int
    n_c: int
    filtered: tuple[str, ...] = ()

    @classmethod
    def of(cls, model: Model) -> Layout:
        """Return the layout of a model; machines with a lag and sensors with a filter have a state of their own."""
        return cls(
            n_z=len(model.coordinates),
            n_e=len(model.twists),
            lagging=tuple(i for i, torque in enumerate(model.inputs) if torque.drive.time_constant is not None),
            n_u=len(model.inputs),
            n_f=len(model.frictions),
            n_c=len(model.contacts),
            filtered=tuple(sensor.name for sensor in model.sensors if sensor.time_constant is not None),
        )

    @property
    def n(self) -> int:
        """Number of true states."""
        return self.n_z + self.n_e + len(self.lagging) + len(self.filtered)

    @property
    def n_t(self) -> int:
        """Number of torques that a step solves for: those of friction elements, then those of contacts."""
        return self.n_f + self.n_c

    def air_gap(self, machine: int) -> int:
        """Return where the air-gap torque of a machine stands in ``x``."""
        return self.n_z + self.n_e + self.lagging.index(machine) if machine in self.lagging else self.n + machine

    def measured(self, sensor: str) -> int:
        """Return where the measured value of a sensor with a filter stands in ``x``."""
        return self.n_z + self.n_e + len(self.lagging) + self.filtered.index(sensor)

    def late(self, machine: int) -> int:
        """Return where the command that acts at the end of the step stands."""
        return self.n + machine

    def early(self, machine: int) -> int:
        """Return where the command that acts at the start of the step stands."""
        return self.n + self.n_u + machine

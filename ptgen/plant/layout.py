"""Where states, inputs and friction elements stand in the arrays of the plant."""

from __future__ import annotations

from dataclasses import dataclass

from ptgen.elements import FluidCoupling, Friction
from ptgen.mechanism.model import Model
from ptgen.plant.ratios import quick_ratios

__all__ = ["Layout", "identifier", "signal_name"]


def identifier(element: Friction | FluidCoupling) -> str:
    """Return the name of a friction element or a fluid as a C identifier."""
    return element.name.replace(".", "_")


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
    turning: tuple[int, ...] = ()
    """Friction elements whose rows change with quick ratios."""
    pressed: tuple[int, ...] = ()
    """Coordinates on which their torques act."""
    n_w: int = 0
    """Torques of fluids, two of each."""

    @classmethod
    def of(cls, model: Model) -> Layout:
        """Return the layout of a model; machines with a lag and sensors with a filter have a state of their own."""
        quick = quick_ratios(model)
        turning = [i for i in range(len(model.frictions)) if model.friction_rows[i, :].free_symbols & quick]
        return cls(
            n_z=len(model.coordinates),
            n_e=len(model.twists),
            lagging=tuple(i for i, torque in enumerate(model.inputs) if torque.drive.time_constant is not None),
            n_u=len(model.inputs),
            n_f=len(model.frictions),
            n_c=len(model.contacts),
            filtered=tuple(sensor.name for sensor in model.sensors if sensor.time_constant is not None),
            turning=tuple(turning),
            pressed=tuple(
                k for k in range(len(model.coordinates)) if any(model.friction_rows[i, k] != 0 for i in turning)
            ),
            n_w=2 * len(model.fluids),
        )

    @property
    def n(self) -> int:
        """Number of true states."""
        return self.n_z + self.n_e + len(self.lagging) + len(self.filtered)

    @property
    def n_t(self) -> int:
        """Number of torques that a step finds: of friction elements, then contacts, then pump and turbine of fluids."""
        return self.n_f + self.n_c + self.n_w

    @property
    def solved(self) -> tuple[int, ...]:
        """The torques that have a column in the solution of the linear part; the others follow from `pressed`."""
        return tuple(j for j in range(self.n_t) if j not in self.turning)

    @property
    def n_s(self) -> int:
        """Number of torque columns in the solution: those that are solved, then those on the coordinates `pressed`."""
        return len(self.solved) + len(self.pressed)

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

"""Poles of the emitted closed loop: plant and controller as they run, dead time and sampling included."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from ptgen.block.block import Block
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.plant.free import with_free_frictions

__all__ = ["Pole", "closed_loop_matrix", "closed_loop_poles"]


_NEUTRAL = 1e-9
"""Poles of z that are no further from the unit circle are neutral: what open clutches leave to coast."""


@dataclass(frozen=True)
class Pole:
    """A pole of the sampled closed loop.

    Attributes
    ----------
    z : complex
        In the plane of the sampled system.
    s : complex
        ``log(z) / h`` (1/s).
    frequency_hz, damping_ratio : float
        Of the equivalent continuous pole.
    """

    z: complex
    s: complex
    frequency_hz: float
    damping_ratio: float

    @property
    def is_unstable(self) -> bool:
        """Whether the pole lies outside the unit circle by more than rounding; a part that coasts is on it."""
        return abs(self.z) > 1 + _NEUTRAL


def closed_loop_matrix(
    controller: Block, plant: Block, parameters: Mapping[str, float] | None = None
) -> tuple[NDArray[np.float64], list[str]]:
    """Return the state matrix of one step of both blocks in closed loop, linearised at rest, and its states' names.

    The matrix is the exact derivative of the blocks themselves, so it holds what the emitted code does: sampling,
    dead time, computation order. All friction elements are free, see `ptgen.plant.free`.

    Parameters
    ----------
    controller, plant : Block
        The plant with closed gaps; a gap would be open at rest.
    parameters : mapping, optional
        Parameters that differ from the defaults, by name.
    """
    given = dict(parameters or {})
    given["standstill_speed"] = 0.0
    plant = with_free_frictions(plant)
    functions = {block.name: CasadiBlock(block) for block in (controller, plant)}
    fixed = {}
    for block in (controller, plant):
        values = [given.get(signal.name, signal.value) for signal in block.parameters]
        fixed[block.name] = (ca.DM(values), functions[block.name].prepare(ca.DM(values)))
    states = {block.name: ca.SX.sym(block.name, sum(s.size for s in block.states)) for block in (controller, plant)}
    outputs = functions["plant"].measure(*fixed["plant"], states["plant"])
    measured = dict(zip(CasadiBlock.names(plant.outputs), ca.vertsplit(outputs), strict=True))
    inputs = ca.vertcat(*[measured.get(signal.name, ca.SX(0)) for signal in controller.inputs])
    next_controller, commands = functions["controller"].step(*fixed["controller"], states["controller"], inputs)
    torques = ca.vertcat(commands, ca.DM.zeros(sum(s.size for s in plant.inputs) - commands.shape[0]))  # no actuation
    next_plant, _ = functions["plant"].step(*fixed["plant"], states["plant"], torques)
    x = ca.vertcat(states["controller"], states["plant"])
    x_next = ca.vertcat(next_controller, next_plant)
    jacobian = ca.Function("jacobian", [x], [ca.jacobian(x_next, x)])
    follow = ca.Function("follow", [x], [x_next])
    start = [
        value for block in (controller, plant) for signal in block.states for value in [signal.value] * signal.size
    ]
    names = CasadiBlock.names(controller.states) + CasadiBlock.names(plant.states)
    # After a step at rest: the first one starts references, observers and integrators, and is no part of the loop.
    return np.array(jacobian(follow(start)).full(), dtype=np.float64), names


def closed_loop_poles(
    controller: Block, plant: Block, parameters: Mapping[str, float] | None = None
) -> tuple[Pole, ...]:
    """Return the poles of `closed_loop_matrix` that move, by frequency.

    Poles at z = 0 are delays. Latches (fault, ramp) hold themselves by design and are left out.
    """
    matrix, names = closed_loop_matrix(controller, plant, parameters)
    moving = [i for i, name in enumerate(names) if name not in ("fault", "authority") and not name.endswith("_last")]
    sample_time = next(signal.value for signal in plant.parameters if signal.name == "sample_time")
    poles = []
    for z in np.linalg.eigvals(matrix[np.ix_(moving, moving)]):
        if abs(z) < 1e-6:
            continue
        s = complex(np.log(complex(z)) / sample_time)
        size = abs(s)
        poles.append(Pole(complex(z), s, size / (2 * np.pi), float(-s.real / size) if size > 0 else 1.0))
    return tuple(sorted(poles, key=lambda pole: pole.frequency_hz))

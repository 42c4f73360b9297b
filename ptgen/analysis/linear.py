r"""Blocks, linearised as they are emitted, and the sampled loop of controller and plant.

The matrices are the exact derivatives of the blocks' statements, so they hold what the emitted code does: sampling,
dead time, lags, filters, computation order. A plant is linearised with all friction elements free; elements that
stick belong into the model that the plant is made from.

The loop is broken at the torque commands, between controller and inverters: from commands ``u`` that go to the plant
to commands ``u'`` that the controller gives in return, ``u' = L u``. The closed loop is ``u = u'``; with the usual
signs of control engineering the loop transfer matrix is ``-L``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np
import sympy as sp
from numpy.typing import NDArray

from ptgen.block.block import Block
from ptgen.block.casadi_evaluator import CasadiBlock
from ptgen.elements import Parameter
from ptgen.mechanism.model import Model
from ptgen.plant.free import with_free_frictions

__all__ = ["Linearisation", "LoopFamily", "SampledLoop", "StateSpace", "with_dead_times"]

Array = NDArray[np.float64]

_WHOLE = 1e-6
"""Share of a step by which a dead time may miss a whole number of steps; the plant uses the same."""


@dataclass(frozen=True)
class StateSpace:
    """A linear sampled system ``x+ = A x + B u``, ``y = C x + D u`` with names.

    Attributes
    ----------
    A, B, C, D : ndarray
    states, inputs, outputs : tuple of str
    """

    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


class Linearisation:
    """The derivative of a block at rest as a function of its parameters.

    It is that of the second step: the first one starts references, observers and integrators, and is no part of the
    loop.

    Parameters
    ----------
    block : Block
        A plant is linearised without its friction torques, see `ptgen.plant.free`.
    """

    def __init__(self, block: Block) -> None:
        block = with_free_frictions(block)
        functions = CasadiBlock(block)
        self.block = block
        p = ca.MX.sym("p", sum(s.size for s in block.parameters))
        x = ca.MX.sym("x", sum(s.size for s in block.states))
        u = ca.MX.sym("u", sum(s.size for s in block.inputs))
        derived = functions.prepare(p)
        following, outputs = functions.step(p, derived, x, u)
        if block.measure:  # what is measured of the states, before the next step
            outputs = functions.measure(p, derived, x)
        whole = ca.jacobian(ca.vertcat(following, outputs), ca.vertcat(x, u))
        self._derivative = ca.Function("derivative", [p, x, u], [whole])
        self._follow = ca.Function("follow", [p, x, u], [following])
        self._start = np.concatenate([np.full(s.size, s.value) for s in block.states] or [np.zeros(0)])
        self._inputs = np.concatenate([np.full(s.size, s.value) for s in block.inputs] or [np.zeros(0)])
        self._names = [CasadiBlock.names(signals) for signals in (block.states, block.inputs, block.outputs)]
        self._defaults = {signal.name: signal.value for signal in block.parameters}
        self._last: tuple[list[float], StateSpace] | None = None

    def at(self, parameters: Mapping[str, float] | None = None) -> StateSpace:
        """Return the derivative for `parameters` in place of the defaults; those of other blocks are passed over."""
        given = {**self._defaults, "standstill_speed": 0.0}
        given |= {name: value for name, value in (parameters or {}).items() if name in self._defaults}
        values = [given[name] for name in self._defaults]
        if self._last is not None and self._last[0] == values:
            return self._last[1]
        rest = self._follow(values, self._start, self._inputs)
        whole = np.array(self._derivative(values, rest, self._inputs).full(), dtype=np.float64)
        states, inputs, outputs = (tuple(names) for names in self._names)
        n = len(states)
        found = StateSpace(whole[:n, :n], whole[:n, n:], whole[n:, :n], whole[n:, n:], states, inputs, outputs)
        self._last = values, found
        return found


@dataclass(frozen=True)
class SampledLoop:
    """Plant and controller in a row: ``x+ = A x + B u``, ``u' = C x``; it is closed by ``u = u'``.

    Attributes
    ----------
    A : ndarray (n, n)
    B : ndarray (n, m)
    C : ndarray (m, n)
    machines : tuple of str (m)
    states : tuple of str (n)
    sample_time : float
        Step (s).
    """

    A: Array
    B: Array
    C: Array
    machines: tuple[str, ...]
    states: tuple[str, ...]
    sample_time: float

    def closed(self, gains: Sequence[float] | None = None) -> Array:
        """Return the state matrix of the closed loop, with a factor on every torque command if `gains` are given."""
        factors = np.ones(len(self.machines)) if gains is None else np.asarray(gains, dtype=np.float64)
        return self.A + (self.B * factors) @ self.C

    def opened(self, machine: int) -> SampledLoop:
        """Return the loop of one machine, with the loops of all others closed."""
        others = [k for k in range(len(self.machines)) if k != machine]
        A = self.A + self.B[:, others] @ self.C[others]
        one = slice(machine, machine + 1)
        return replace(self, A=A, B=self.B[:, one], C=self.C[one], machines=self.machines[one])

    def delayed(self, steps: Sequence[int]) -> SampledLoop:
        """Return the loop with the commands to each machine delayed by whole steps."""
        n, added = len(self.A), int(sum(steps))
        A = np.zeros((n + added, n + added))
        B, C = np.zeros((n + added, len(self.machines))), np.zeros((len(self.machines), n + added))
        A[:n, :n], C[:, :n] = self.A, self.C
        first, names = n, list(self.states)
        for machine, count in enumerate(steps):
            if count == 0:
                B[:n, machine] = self.B[:, machine]
                continue
            A[:n, first] = self.B[:, machine]
            for k in range(count - 1):
                A[first + k, first + k + 1] = 1.0
            B[first + count - 1, machine] = 1.0
            names += [f"{self.machines[machine]}_added_delay[{k}]" for k in range(count)]
            first += count
        return replace(self, A=A, B=B, C=C, states=tuple(names))

    def pruned(self) -> SampledLoop:
        """Return the loop without the states that no torque command depends on: latches, counters, monitors."""
        keep = _influence(self.closed() != 0, (self.C != 0).any(axis=0))
        states = tuple(name for name, kept in zip(self.states, keep, strict=True) if kept)
        return replace(self, A=self.A[np.ix_(keep, keep)], B=self.B[keep], C=self.C[:, keep], states=states)


class LoopFamily:
    """The loop of a bed for any parameters and any additional delay of the machines' torques.

    Parameters
    ----------
    controller : Block
    plant : Block
        With closed gaps. Machines whose inverter has no dead time cannot be delayed by parts of a step; see
        `with_dead_times`.
    """

    def __init__(self, controller: Block, plant: Block) -> None:
        self.plant = plant
        self._controller = Linearisation(controller)
        self._plant = Linearisation(plant)
        self.machines = tuple(signal.name.removesuffix("_torque_ref") for signal in controller.outputs)
        self.sample_time = next(signal.value for signal in plant.parameters if signal.name == "sample_time")
        self._dead_times = {
            machine: next((s.value for s in plant.parameters if s.name == f"{machine}_inverter_dead_time"), 0.0)
            for machine in self.machines
        }
        self._has_dead_time = {s.name for s in plant.parameters}
        self._computation = next((s.value for s in plant.parameters if s.name == "computation_delay"), 0.0)
        self.names = tuple(dict.fromkeys(s.name for block in (controller, plant) for s in block.parameters))

    def dead_time(self, machine: str, parameters: Mapping[str, float] | None = None) -> float:
        """Return the dead time (s) of a machine's inverter."""
        return (parameters or {}).get(f"{machine}_inverter_dead_time", self._dead_times[machine])

    def delay(self, machine: str, parameters: Mapping[str, float] | None = None) -> float:
        """Return the time (s) that computation and dead time of a machine take together."""
        computation = (parameters or {}).get("computation_delay", self._computation)
        return computation + self.dead_time(machine, parameters)

    def loop(
        self, parameters: Mapping[str, float] | None = None, delays: Mapping[str, float] | None = None
    ) -> tuple[SampledLoop, tuple[int, ...]]:
        """Return the loop, and by how many whole steps the commands to each machine are delayed besides.

        The parts of a step are in the loop, exactly as the plant represents them.

        Parameters
        ----------
        parameters : mapping, optional
            Parameters of controller and plant that differ from the defaults.
        delays : mapping, optional
            Additional delay (s) of each machine's torque.
        """
        h = (parameters or {}).get("sample_time", self.sample_time)
        given, steps = dict(parameters or {}), []
        for machine in self.machines:
            total = self.dead_time(machine, parameters) + (delays or {}).get(machine, 0.0)
            whole = int(np.floor(total / h + _WHOLE))
            name = f"{machine}_inverter_dead_time"
            if name in self._has_dead_time:
                given[name] = max(0.0, total - whole * h)
            steps.append(whole)
        controller, plant = self._controller.at(given), self._plant.at(given)
        loop = _connected(controller, plant, self.machines, h)
        return loop.pruned(), tuple(steps)

    def delayed(
        self, parameters: Mapping[str, float] | None = None, delays: Mapping[str, float] | None = None
    ) -> SampledLoop:
        """Return the loop with all delays as states."""
        loop, steps = self.loop(parameters, delays)
        return loop.delayed(steps)


def with_dead_times(model: Model) -> Model:
    """Return the model in which every drive has a dead time that can be changed; it is zero where there was none.

    It stands in the place of the inverter's own, as the parameter ``<machine>_inverter_dead_time``.
    """
    inputs, parameters = [], list(model.parameters)
    for torque in model.inputs:
        if torque.drive.dead_time is not None:
            inputs.append(torque)
            continue
        symbol = sp.Symbol(f"{torque.name}_inverter_dead_time", nonnegative=True)
        parameters.append(Parameter(symbol, 0.0, "s", f"dead time of the inverter of {torque.name}"))
        inputs.append(replace(torque, drive=replace(torque.drive, dead_time=symbol)))
    return replace(model, inputs=tuple(inputs), parameters=tuple(parameters))


def _connected(controller: StateSpace, plant: StateSpace, machines: tuple[str, ...], h: float) -> SampledLoop:
    n_p, n_c = len(plant.A), len(controller.A)
    B_y, D_y = np.zeros((n_c, len(plant.outputs))), np.zeros((len(machines), len(plant.outputs)))
    places = {name: k for k, name in enumerate(plant.outputs)}
    for k, name in enumerate(controller.inputs):
        if name in places:
            B_y[:, places[name]] = controller.B[:, k]
            D_y[:, places[name]] = controller.D[:, k]
    commands = [plant.inputs.index(f"{machine}_torque_ref") for machine in machines]
    A = np.zeros((n_p + n_c, n_p + n_c))
    A[:n_p, :n_p], A[n_p:, :n_p], A[n_p:, n_p:] = plant.A, B_y @ plant.C, controller.A
    B = np.vstack([plant.B[:, commands], np.zeros((n_c, len(machines)))])
    C = np.hstack([D_y @ plant.C, controller.C])
    states = tuple(f"{block}.{name}" for block, system in (("plant", plant), ("controller", controller))
                   for name in system.states)  # fmt: skip
    return SampledLoop(A, B, C, machines, states, h)


def _influence(pattern: NDArray[np.bool_], wanted: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which states lead to the wanted ones; ``pattern[i, j]`` tells that state i follows from state j."""
    keep = wanted.copy()
    while True:
        more = keep | pattern[keep].any(axis=0)
        if (more == keep).all():
            return keep
        keep = more

r"""The controller as a block: supervision, speed and torque control, decoupling law, limits.

Every step runs in this order:

1. *Supervision.* An input that is not finite, or larger than plausible, is replaced by its last sound value; the
   fault is latched with the number of the signal, and the last torques are taken to zero along a ramp.
2. *Speed control.* PI (5.84); anti-windup by conditioning (Hanus): the integrator gets the control error that
   would have given the limited output.
3. *Load torque compensation* (5.52), (5.74): the machine's own flange torque, times `load_compensation`.
4. *Torque control.* Feedforward and integrator (5.99) on the testing torque from the sensors (5.95), (5.98). The
   integrator compares it with what the feedforward should give by now, the reference behind (5.57); it is limited,
   and stands while the machine is at its limit.
5. *Decoupling* (5.62), (5.78): torque for the acceleration, times `acceleration_torque`, and active damping. The
   other parts leave a reserve for the damping.
6. *Limits.* The torque-speed envelope, Figure 7.1.

The conventional controller (Figure 5.10) is the same block with all three switched off.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ptgen.block.block import Assign, Block, Call, Signal, Statement
from ptgen.control.decoupling import Decoupling
from ptgen.control.plausibility import plausible_speed, plausible_torque
from ptgen.control.tuning import Gains
from ptgen.elements import SensorKind
from ptgen.mechanism.model import Model, evaluate_matrix
from ptgen.plant.plant import signal_name
from ptgen.testbed.testbed import Tuning

__all__ = ["ControllerBlock", "controller_block"]


@dataclass(frozen=True)
class ControllerBlock:
    """The controller's block, and the parameter values that make it the conventional controller."""

    block: Block
    conventional: dict[str, float]
    references: dict[str, str]
    """Reference of a scenario (``torque.M1``) to input of the block."""


def controller_block(
    decoupling: Decoupling, gains: Gains, tuning: Tuning, full: Model, sample_time: float
) -> ControllerBlock:
    """Return the controller of a bed as a block."""
    return _Controller(decoupling, gains, tuning, full, sample_time).build()


def _symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, real=True)


class _Controller:
    def __init__(self, decoupling: Decoupling, gains: Gains, tuning: Tuning, full: Model, sample_time: float) -> None:
        self.design = decoupling
        self.gains = gains
        self.tuning = tuning
        self.full = full
        self.sample_time = sample_time
        self.torque_machines = decoupling.actuators[: decoupling.torque_count]
        self.speed_machines = decoupling.actuators[decoupling.torque_count :]
        self.sensors = self._used_sensors()
        self.parameters: dict[str, Signal] = {}
        self.states: dict[str, Signal] = {}
        self.inputs: dict[str, Signal] = {}
        self.statements: list[Statement] = []

    # -- what is used

    def _used_sensors(self) -> list[int]:
        law = self.design.law
        speeds = {self._speed_sensor(machine) for machine in range(len(self.design.machines))}
        return [
            k
            for k, name in enumerate(self.design.sensors)
            if name in speeds
            or any(entry != 0 for entry in law.R[:, k])
            or any(entry != 0 for entry in law.estimate_sensors[:, k])
        ]

    def _speed_sensor(self, machine: int) -> str:
        velocity = next(iter(self.design.model.inputs[machine].row))
        return next(s.name for s in self.design.model.sensors if s.kind is SensorKind.SPEED and s.of == velocity)

    def _parameter(
        self,
        name: str,
        unit: str,
        text: str,
        value: float,
        least: float | None = 0.0,
        allowed: bool = True,
        most: float | None = None,
    ) -> sp.Symbol:
        signal = Signal(name, unit, text, value=value, least=least, least_allowed=allowed, most=most)
        self.parameters.setdefault(name, signal)
        return _symbol(name)

    def _model_parameters(self, expression: sp.Expr) -> sp.Expr:
        """Declare the bed's parameters that occur in an expression, and return it over plain symbols."""
        known = {parameter.symbol: parameter for parameter in self.design.model.parameters}
        table = {}
        for symbol in sorted(expression.free_symbols, key=lambda s: s.name):
            if symbol in known:
                p = known[symbol]
                least = None if p.signed else 0.0
                table[symbol] = self._parameter(symbol.name, p.unit, p.description, p.value, least, not p.positive)
            else:
                table[symbol] = _symbol(symbol.name)
        return expression.subs(table)

    def _state(self, name: str, unit: str, text: str, value: float = 0.0) -> sp.Symbol:
        self.states[name] = Signal(name, unit, text, value=value)
        return _symbol(name)

    def _assign(self, target: str, expression: sp.Expr, source: str = "") -> sp.Symbol:
        self.statements.append(Assign(target, expression, source))
        return _symbol(target)

    # -- the block

    def build(self) -> ControllerBlock:
        design, law = self.design, self.design.law
        h = self._parameter("sample_time", "s", "step of the controller", self.sample_time, allowed=False)
        self._parameter(
            "fault_ramp",
            "s",
            "time in which the torque goes to zero after a fault",
            self.tuning.fault_ramp,
            allowed=False,
        )
        references = self._references()
        measured = self._supervise([*references.values(), *(design.sensors[k] for k in self.sensors)])
        load = self._parameter("load_compensation", "", "switch of the load torque compensation, 0 to 1", 1.0, most=1.0)
        accelerate = self._parameter(
            "acceleration_torque", "", "switch of the acceleration torque, 0 to 1", 1.0, most=1.0
        )
        limits = {machine: self._limit(machine, measured) for machine in range(len(design.machines))}
        virtual: dict[int, sp.Expr] = {}
        commands: dict[int, sp.Symbol] = {}
        for position, machine in enumerate(self.speed_machines, start=design.torque_count):
            compensation = load * self._sensor_sum(law.R[machine, :], measured)
            virtual[position], commands[machine] = self._speed_control(
                machine, position, compensation, limits[machine], measured, h
            )
        for index, machine in enumerate(self.torque_machines):
            estimate = self._sensor_sum(law.estimate_sensors[index, :], measured) + load * self._virtual_sum(
                law.estimate_virtual[index, :], virtual
            )
            estimate = estimate + load * self._unread_torque(machine, virtual)
            others = law.P[machine, :].copy()
            others[index] = sp.Integer(0)
            decoupling = accelerate * self._virtual_sum(others, virtual)
            commands[machine] = self._torque_control(index, machine, estimate, decoupling, limits[machine], measured, h)
        outputs = self._release(commands, h)
        block = Block(
            name="controller",
            description=f"controller of the bed {design.model.name}",
            parameters=tuple(self.parameters.values()),
            inputs=tuple(self.inputs.values()),
            outputs=outputs,
            states=tuple(self.states.values()),
            step=tuple(self.statements),
            faults=tuple(self.inputs),
        )
        return ControllerBlock(block, self._conventional(), references)

    def _conventional(self) -> dict[str, float]:
        values = {"load_compensation": 0.0, "acceleration_torque": 0.0}
        for machine in self.torque_machines:
            name = self.design.machines[machine]
            values[f"{name}_damping"] = 0.0
            values[f"{name}_torque_model"] = 0.0
            values[f"{name}_torque_integral_gain"] = self.gains.conventional_integral[name]
        return values

    def _references(self) -> dict[str, str]:
        design = self.design
        result = {}
        for index, machine in enumerate(self.torque_machines):
            result[f"torque.{design.machines[machine]}"] = signal_name(design.outputs[index]) + "_ref"
        for machine in self.speed_machines:
            result[f"speed.{design.machines[machine]}"] = f"{design.machines[machine]}_speed_ref"
        return result

    # -- supervision

    def _supervise(self, names: list[str]) -> dict[str, sp.Symbol]:
        fault = self._state("fault", "", "0, or the number of the input that failed")
        sound = []
        result = {}
        for number, name in enumerate(names, start=1):
            unit = "rad/s" if "_speed" in name else "N m"
            text = "reference" if name.endswith("_ref") else "measured"
            self.inputs[name] = Signal(name, unit, text)
            bound = self._parameter(
                f"{name}_plausible", unit, f"largest plausible {name}", self._plausible(name), allowed=False
            )
            self._state(f"{name}_held", unit, f"last sound value of {name}")
            self.statements.append(
                Call("guard", (f"{name}_held", f"{name}_sound"), (name, bound.name, f"{name}_held"), "supervision")
            )
            sound.append((number, _symbol(f"{name}_sound")))
            result[name] = _symbol(f"{name}_held")
        for number, flag in sound:
            unseen = sp.And(fault < sp.Rational(1, 2), flag < sp.Rational(1, 2))
            self._assign(
                "fault", sp.Piecewise((sp.Integer(number), unseen), (fault, True)), "the first fault is latched"
            )
        return result

    def _plausible(self, name: str) -> float:
        for machine in self.design.machines:
            if name in (f"{machine}_speed_ref", f"{machine}_speed"):
                return plausible_speed(self.full, machine)
        signals = {
            **{signal_name(place) + "_ref": form for place, form in self.full.signals.items()},
            **self.full.signals,
        }
        return plausible_torque(self.full, signals[name])

    # -- controllers

    def _limit(self, machine: int, measured: dict[str, sp.Symbol]) -> sp.Symbol:
        name, drive = self.design.machines[machine], self.design.model.inputs[machine].drive
        rated = self._model_parameters(drive.speed_rated)
        speed = measured[self._speed_sensor(machine)]
        available = self._model_parameters(drive.torque_max) * rated / sp.Max(rated, sp.Abs(speed))
        return self._assign(f"{name}_available", available, "torque-speed envelope, Figure 7.1")

    def _sensor_sum(self, row: sp.Matrix, measured: dict[str, sp.Symbol]) -> sp.Expr:
        terms = [
            self._model_parameters(sp.factor(row[k])) * measured[name]
            for k, name in enumerate(self.design.sensors)
            if row[k] != 0
        ]
        return sp.Add(*terms)

    def _virtual_sum(self, row: sp.Matrix, virtual: dict[int, sp.Expr]) -> sp.Expr:
        terms = [
            self._model_parameters(sp.factor(row[position])) * value
            for position, value in virtual.items()
            if row[position] != 0
        ]
        return sp.Add(*terms)

    def _speed_control(
        self,
        machine: int,
        position: int,
        compensation: sp.Expr,
        limit: sp.Symbol,
        measured: dict[str, sp.Symbol],
        h: sp.Symbol,
    ) -> tuple[sp.Expr, sp.Symbol]:
        name = self.design.machines[machine]
        gain = self._parameter(
            f"{name}_speed_gain",
            "N m s/rad",
            f"proportional gain of the speed of {name}",
            self.gains.speed[name],
            allowed=False,
        )
        integral_gain = self._parameter(
            f"{name}_speed_integral_gain",
            "N m/rad",
            f"integral gain of the speed of {name}",
            self.gains.speed_integral[name],
        )
        integral = self._state(f"{name}_speed_integral", "N m", f"integrator of the speed control of {name}")
        error = self._assign(
            f"{name}_speed_error", measured[f"{name}_speed_ref"] - measured[self._speed_sensor(machine)]
        )
        asked = self._assign(f"{name}_asked", gain * error + integral, "PI speed control (5.84)")
        compensate = self._assign(f"{name}_compensation", compensation, "load torque compensation (5.52), (5.74)")
        share = self._model_parameters(sp.factor(self.design.law.P[machine, position]))
        command = self._assign(
            f"{name}_command", sp.Max(-limit, sp.Min(limit, share * asked + compensate)), "torque-speed envelope"
        )
        realised = self._assign(f"{name}_virtual", (command - compensate) / share, "what the limit leaves of it")
        conditioned = error + (realised - asked) / gain
        self._assign(integral.name, integral + h * integral_gain * conditioned, "conditioning anti-windup")
        return realised, command

    def _unread_torque(self, machine: int, virtual: dict[int, sp.Expr]) -> sp.Expr:
        """Return the torque that accelerates what lies between the sensors and the place of the testing torque."""
        name = self.design.machines[machine]
        terms = []
        for position, value in virtual.items():
            other = self.design.machines[self.design.actuators[position]]
            inertia = self.gains.sensor_inertia[name][other]
            symbol = self._parameter(
                f"{name}_sensor_inertia_{other}",
                "kg m^2",
                f"torque of {name} that its sensors miss, per acceleration of {other}",
                inertia,
                None,
            )
            rotor = self._model_parameters(
                self.design.model.body_inertias[
                    next(iter(self.design.model.inputs[self.design.actuators[position]].row))
                ]
            )
            terms.append(symbol * value / rotor)
        return sp.Add(*terms)

    def _torque_control(
        self,
        index: int,
        machine: int,
        estimate: sp.Expr,
        decoupling: sp.Expr,
        limit: sp.Symbol,
        measured: dict[str, sp.Symbol],
        h: sp.Symbol,
    ) -> sp.Symbol:
        design, name = self.design, self.design.machines[machine]
        place = signal_name(design.outputs[index])
        self._parameter(f"{name}_damping", "N m s/rad", f"active damping by {name} (5.81)", self.gains.damping[name])
        self._parameter(
            f"{name}_inertia_estimate",
            "kg m^2",
            f"inertia that {name} accelerates (5.78)",
            self.gains.inertia_estimate[name],
            allowed=False,
        )
        feedforward = self._parameter(
            f"{name}_feedforward", "", f"share of the torque reference fed forward to {name}", self.tuning.feedforward
        )
        proportional = self._parameter(
            f"{name}_torque_gain", "", f"proportional gain of the torque control of {name}", 0.0
        )
        integral_gain = self._parameter(
            f"{name}_torque_integral_gain",
            "1/s",
            f"integral gain of the torque control of {name}",
            self.gains.torque_integral[name],
        )
        reserve = self._parameter(
            f"{name}_damping_reserve",
            "",
            f"share of the torque of {name} kept for damping",
            self.tuning.damping_reserve,
            most=1.0,
        )
        bound = self._parameter(
            f"{name}_torque_integral_limit",
            "N m",
            f"limit of the torque integrator of {name}",
            self._integral_limit(index, machine),
        )
        integral = self._state(f"{name}_torque_integral", "N m", f"integrator of the torque control of {name}")
        torque = self._assign(f"{place}_estimate", estimate, "testing torque from the sensors (5.95), (5.98)")
        reference = measured[f"{place}_ref"]
        expected = self._expected_torque(name, reference, h)
        error = self._assign(f"{name}_torque_error", expected - torque)
        share = self._model_parameters(sp.factor(design.law.P[machine, index]))
        virtual = self._assign(
            f"{name}_virtual", feedforward * reference + proportional * error + integral, "torque control (5.99)"
        )
        wanted = self._assign(
            f"{name}_wanted", share * virtual + decoupling, "with the acceleration torque (5.62), (5.78)"
        )
        room = (1 - reserve) * limit
        kept = self._assign(f"{name}_kept", sp.Max(-room, sp.Min(room, wanted)), "reserve for active damping")
        row = self.design.law.R[machine, :]
        damp = self._assign(f"{name}_damping_torque", self._sensor_sum(row, measured), "active damping (5.62), (5.78)")
        command = self._assign(f"{name}_command", sp.Max(-limit, sp.Min(limit, kept + damp)), "torque-speed envelope")
        # The integrator stands while the machine is at its limit and the error would drive it further.
        beyond = (wanted - kept) * error * share
        grown = integral + h * integral_gain * error
        limited = sp.Max(-bound, sp.Min(bound, grown))
        self._assign(integral.name, sp.Piecewise((integral, beyond > 0), (limited, True)), "limited integrator")
        return command

    def _expected_torque(self, name: str, reference: sp.Symbol, h: sp.Symbol) -> sp.Expr:
        """Return the torque that the feedforward alone should give by now: the reference behind (5.57).

        The controller corrects what differs from it. Against the bare reference the integrator would charge during
        every change and let the torque overshoot.
        """
        stiffness = self.gains.stiffness[name]
        c = self._parameter(
            f"{name}_model_stiffness", "N m/rad", f"stiffness in the torque model of {name}", float(f"{stiffness:.6g}")
        )
        d = self._parameter(
            f"{name}_model_damping", "N m s/rad", f"damping in the torque model of {name}", self.gains.damping[name]
        )
        share = self._parameter(
            f"{name}_torque_model", "", f"switch of the torque model of {name}, 0 to 1", 1.0, most=1.0
        )
        model = self._state(f"{name}_model_torque", "N m", f"torque that the feedforward to {name} should give")
        rate = self._state(f"{name}_model_rate", "N m/s", f"rate of the torque model of {name}")
        force = c * (reference - model) - d * rate
        self._assign(rate.name, rate + h * force / _symbol(f"{name}_inertia_estimate"), "torque model (5.57), (5.76)")
        self._assign(model.name, model + h * rate)
        return share * model + (1 - share) * reference

    def _integral_limit(self, index: int, machine: int) -> float:
        share = float(evaluate_matrix(sp.Matrix([[self.design.law.P[machine, index]]]), self.design.values)[0, 0])
        torque_max = self.full.values[self.full.inputs[machine].drive.torque_max]
        return float(f"{abs(0.5 * torque_max / share):.3g}")

    # -- outputs

    def _release(self, commands: dict[int, sp.Symbol], h: sp.Symbol) -> tuple[Signal, ...]:
        fault = _symbol("fault")
        authority = self._state("authority", "", "1, going to 0 along the ramp after a fault", 1.0)
        failed = fault > sp.Rational(1, 2)
        ramped = sp.Max(0, authority - h / _symbol("fault_ramp"))
        self._assign("authority", sp.Piecewise((ramped, failed), (authority, True)), "ramp to zero torque")
        outputs = []
        for machine, name in enumerate(self.design.machines):
            last = self._state(f"{name}_last", "N m", f"last torque of {name} before a fault")
            self._assign(last.name, sp.Piecewise((last, failed), (commands[machine], True)))
            self._assign(f"{name}_torque_ref", last * authority)
            outputs.append(Signal(f"{name}_torque_ref", "N m", f"air-gap torque reference of {name}"))
        return tuple(outputs)

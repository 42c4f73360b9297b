"""Friction capacities of a step: what slipping elements exert and elements at rest can hold, at mid-step."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from ptgen.block.block import Assign, Signal, element
from ptgen.elements import Friction
from ptgen.mechanism.model import LinearForm, Model
from ptgen.plant.layout import Layout, identifier, signal_name
from ptgen.plant.signals import PlantSignals

__all__ = ["Capacities", "actuation"]


class Capacities:
    r"""The statements that give ``slide`` and ``rest``.

    Everything that a capacity depends on is evaluated at mid-step, as the mean of its value at the start and of the one
    that is predicted for the end with the last torques; at the start of the step it would cost an order of accuracy.

    .. math::
        c_i(w) = \mu\,\bigl(r(\varphi)\,(T_c + k_T |T| + (T_s - T_c)\,e^{-|w| / \omega_s}) + k \min(|w|, \omega_k)
            + k_v |w|\bigr), \qquad c^s_i = \mu\,r(\varphi)\,(T_s + k_T |T|)

    The viscous term stands here for actuated elements only; otherwise it belongs to the linear part of the bed.

    Parameters
    ----------
    model : Model
    layout : Layout
    signals : PlantSignals

    References
    ----------
    Source (3.12), (3.34), (3.35), end of Section 3.8.
    """

    def __init__(self, model: Model, layout: Layout, signals: PlantSignals) -> None:
        self.model = model
        self.layout = layout
        self.signals = signals
        self.rippling = [friction for friction in model.frictions if friction.ripple is not None]

    def inputs(self) -> list[Signal]:
        """Return the actuations."""
        return [
            Signal(actuation(friction), "", f"actuation of {friction.name}, 0 to 1", least=0.0, most=1.0)
            for friction in self.model.frictions
            if friction.actuated
        ]

    def states(self) -> list[Signal]:
        """Return the angles on which capacities depend."""
        return [
            Signal(_angle(friction).name, "rad", f"angle of {friction.name}, within one revolution")
            for friction in self.rippling
        ]

    def loads(self) -> dict[str, LinearForm]:
        """Return the torques on which capacities depend, by the name of their signal."""
        places = dict.fromkeys(f.load.place for f in self.model.frictions if f.load is not None)
        return {signal_name(place): self.model.signals[place] for place in places}

    def at_start(self) -> list[Assign]:
        """Return the loads at the start of the step."""
        return [
            Assign(f"{name}_start", self.signals.over(name, form, lambda k: element("x", k)))
            for name, form in self.loads().items()
        ]

    def at_mid_step(self, predicted: Callable[[int], sp.Expr]) -> list[Assign]:
        """Return the capacities; `predicted` gives the entries of the state array at the end of the step."""
        statements = [
            Assign(f"{name}_end", self.signals.over(name, form, predicted), "predicted")
            for name, form in self.loads().items()
        ]
        for i, friction in enumerate(self.model.frictions):
            statements += self._of(i, friction, predicted)
        return statements

    def turned(self) -> list[Assign]:
        """Return the angles at the end of the step, kept within one revolution."""
        h = sp.Symbol("sample_time", positive=True)
        turn = sp.Float(float(2 * sp.pi))
        statements = []
        for friction in self.rippling:
            i = self.model.frictions.index(friction)
            angle = _angle(friction) + h * (element("w_start", i) + element("w_plus", i)) / 2
            name = f"{identifier(friction)}_turned"
            turned = sp.Symbol(name, real=True)
            statements.append(Assign(name, angle))
            statements.append(Assign(_angle(friction).name, turned - turn * sp.floor(turned / turn + sp.Float(0.5))))
        return statements

    def _of(self, i: int, friction: Friction, predicted: Callable[[int], sp.Expr]) -> list[Assign]:
        statements = []
        kinetic, static = friction.coulomb, friction.at_rest
        if friction.load is not None:
            load = signal_name(friction.load.place)
            mean = (sp.Symbol(f"{load}_start", real=True) + sp.Symbol(f"{load}_end", real=True)) / 2
            share = friction.load.coefficient * sp.Abs(mean)
            kinetic, static = kinetic + share, static + share
        speed = sp.Symbol(f"{identifier(friction)}_mid_speed", real=True)
        if friction.stribeck_speed is not None:
            kinetic = kinetic + (friction.at_rest - friction.coulomb) * sp.exp(-speed / friction.stribeck_speed)
        if friction.ripple is not None:
            ripple = friction.ripple
            h = sp.Symbol("sample_time", positive=True)
            angle = _angle(friction) + h * element("w_start", i) / 2
            factor = sp.Symbol(f"{identifier(friction)}_ripple", real=True)
            wave = 1 + ripple.amplitude * sp.sin(ripple.order * angle + ripple.phase)
            statements.append(Assign(factor.name, wave, "capacity over the angle"))
            kinetic, static = factor * kinetic, factor * static
        if friction.saturated is not None:
            kinetic = kinetic + friction.saturated.slope * sp.Min(speed, friction.saturated.speed)
        if friction.actuated:
            mu = sp.Symbol(actuation(friction), real=True)
            kinetic, static = mu * (kinetic + friction.viscous * speed), mu * static
        if speed in sp.sympify(kinetic).free_symbols:
            row = self.signals.friction_rows[i, :]
            end = sum((row[k] * predicted(k) for k in range(self.layout.n_z) if row[k] != 0), sp.Integer(0))
            statements.insert(0, Assign(speed.name, sp.Abs(element("w_start", i) + end) / 2, "speed at mid-step"))
        source = "capacities at mid-step, (3.12), (3.34), (3.35)"
        statements.append(Assign(str(element("slide", i)), kinetic, source))
        statements.append(Assign(str(element("rest", i)), static))
        return statements


def actuation(friction: Friction) -> str:
    """Return the name of the input that actuates a friction element."""
    return f"{identifier(friction)}_actuation"


def _angle(friction: Friction) -> sp.Symbol:
    return sp.Symbol(f"{identifier(friction)}_angle", real=True)

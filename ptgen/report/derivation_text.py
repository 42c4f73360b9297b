"""A derivation as text for the terminal, written for test bed engineers who are no control experts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import sympy as sp
from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from ptgen.mechanism.modes import Mode
from ptgen.report.derivation import Derivation
from ptgen.report.formulas import Equation, text_expression
from ptgen.report.friction_law import TEXT, friction_law
from ptgen.report.motion import Motion
from ptgen.report.quantities import percent, readable
from ptgen.report.stability_text import stability_text

__all__ = ["derivation_text"]


def derivation_text(found: Derivation) -> Iterator[RenderableType]:
    """Yield the parts of a derivation; formulas must not be wrapped."""
    yield Text(found.title, style="bold")
    for heading, parts in (
        ("States", _states(found)),
        ("Equations of motion", (*_motion(found.motion), *_gaps(found))),
        ("Reduction", _reduction(found)),
        ("Reduced model", _reduced(found)),
        ("Relative degrees", _degrees(found)),
        ("Decoupling matrix", _matrix(found)),
        ("Law", _law(found)),
        ("Testing torque from sensors", _estimates(found)),
        ("Other friction states", _friction_states(found)),
        ("Gains", _gains(found)),
        ("Stability in continuous time", stability_text(found.stability)),
        ("Closed loop", _closed_loop(found)),
    ):
        yield Text(f"\n{heading}\n{'=' * len(heading)}", style="bold cyan")
        yield from parts


def _states(found: Derivation) -> Iterator[RenderableType]:
    for title, model in (("full model", found.model), ("reduced model", found.reduced)):
        twists = ", ".join(model.twists) or "none"
        yield Text(f"{title}, order {model.order}")
        yield Text(f"  velocities: {', '.join(model.coordinates)}")
        yield Text(f"  twists:     {twists}")
    if names := [friction.name for friction in found.model.frictions]:
        yield Text(f"friction elements: {', '.join(names)} (their velocities come first)")


def _motion(equations: Motion) -> Iterator[RenderableType]:
    yield Text("Each body is accelerated by the torques that act on it:")
    yield from _lines(equations.balances)
    if equations.shafts:
        yield Text("Torque of each shaft, positive when it drives the right-hand neighbour, from its twist φ:")
        yield from _lines(equations.shafts)
        yield from _lines(equations.twists)
    if equations.slips:
        what = "while it sticks, any torque up to the same size, or to the limit that is given"
        yield Text(f"Friction, while it slips with the velocity w ({what}):")
        for slip in equations.slips:
            law = friction_law(slip.friction, TEXT)
            velocity = Equation((), slip.velocity).text().removeprefix("0 = ")
            yield Text(f"  T_fr({slip.friction.name}) = {law.slipping},  w = {velocity}")
            if not law.same:
                yield Text(f"      at rest {law.at_rest}")
    yield from _abbreviations(equations)


def _gaps(found: Derivation) -> Iterator[RenderableType]:
    if found.gaps:
        yield Text("These shafts have a gap, inside of which they carry no torque; in the equations it is closed:")
        for spring in found.gaps:
            gap = sp.sympify(spring.backlash)
            width = readable(float(gap.subs(found.values)), "rad")
            yield Text(f"  T({spring.name}) = 0 within {text_expression(gap)} = {width}")


def _abbreviations(equations: Motion) -> Iterator[RenderableType]:
    if equations.abbreviations:
        yield Text("with")
        for symbol, expression in equations.abbreviations.items():
            yield Text(f"  {symbol.name} = {text_expression(expression)}")


def _lines(equations: Sequence[Equation]) -> Iterator[Text]:
    for equation in equations:
        yield Text(f"  {equation.text()}")


def _reduction(found: Derivation) -> Iterator[RenderableType]:
    table = Table("rule", "element", "why", box=box.SIMPLE_HEAD, pad_edge=False)
    for rule in found.rules:
        table.add_row(Text(rule.rule), Text(rule.element), Text(rule.why))
    yield table
    locked = f"locked: {', '.join(found.locked)}; others free" if found.locked else "friction elements free"
    yield Text(f"modes before -> after (frequency, damping ratio; {locked})")
    for number in range(max(len(found.modes_before), len(found.modes_after))):
        before, after = _mode(found.modes_before, number), _mode(found.modes_after, number)
        yield Text(f"  {before:>24} -> {after}".rstrip())


def _mode(modes: Sequence[Mode], number: int) -> str:
    if number >= len(modes):
        return "left out"
    mode = modes[number]
    if mode.frequency_hz == 0:
        return "rigid body"
    return f"{mode.frequency_hz:.4g} Hz, {percent(mode.damping_ratio)}"


def _reduced(found: Derivation) -> Iterator[RenderableType]:
    equations = found.reduced_motion
    values = dict(found.values)
    for symbol, expression in equations.abbreviations.items():
        values[symbol] = float(expression.subs(values))
    yield Text("The equations that the law is made from; below each its numbers in SI units:")
    for equation in (*equations.balances, *equations.shafts, *equations.twists):
        yield Text(f"  {equation.text()}")
        yield Text(f"      {equation.at(values).text()}", style="dim")
    yield from _abbreviations(equations)
    if found.used_definitions:
        yield Text("equivalent shafts:")
        for symbol, made in found.used_definitions.items():
            value = readable(found.values[symbol], "N m/rad")
            yield Text(f"  {symbol.name} = {text_expression(made)} = {value}")


def _degrees(found: Derivation) -> Iterator[RenderableType]:
    decoupling = found.decoupling
    yield Text("How often an output must be differentiated until an air-gap torque shows:")
    for index, (output, degree) in enumerate(zip(decoupling.outputs, decoupling.relative_degrees, strict=True)):
        machine = decoupling.machines[decoupling.actuators[index]]
        kind = "torque" if index < decoupling.torque_count else "speed"
        yield Text(f"  {output}: {degree} ({kind}, controlled by {machine})")
    total = sum(decoupling.relative_degrees)
    form = decoupling.normal_form
    if form is None:
        yield Text("no vector relative degree is needed: every machine works for its own quantity")
        return
    yield Text(
        f"total {total} of order {decoupling.system.order}: internal dynamics of order {decoupling.internal_order}"
    )
    if decoupling.internal_order:
        yield Text(f"  {', '.join(form.internal_names)}, which the outputs do not show")
        polynomial = form.internal_polynomial
        if polynomial is not None:
            yield Text(f"  undamped: {text_expression(sp.factor(polynomial.as_expr()))} = 0")
        yield Text(f"  eigenvalues (1/s): {', '.join(_complex(value) for value in found.internal_eigenvalues)}")
    yield Text(f"normal form: {', '.join(form.names)}")


def _complex(value: complex) -> str:
    return f"{value.real:.4g}" if abs(value.imag) < 1e-9 else f"{value.real:.4g} {value.imag:+.4g}j"


def _matrix(found: Derivation) -> Iterator[RenderableType]:
    decoupling = found.decoupling
    values = found.values
    needed = "; it must be regular" if decoupling.structure == "decoupling" else ""
    yield Text(f"What each air-gap torque contributes to the first derivative that shows it{needed}:")
    table = Table("output", *decoupling.machines, box=box.SIMPLE_HEAD, pad_edge=False)
    for index, output in enumerate(decoupling.outputs):
        row = decoupling.matrix[index, :]
        table.add_row(Text(output), *(f"{float(sp.sympify(entry).subs(values)):.5g}" for entry in row))
    yield table
    for index, output in enumerate(decoupling.outputs):
        for column, machine in enumerate(decoupling.machines):
            entry = decoupling.matrix[index, column]
            if entry != 0:
                yield Text(f"  [{output}, {machine}] = {text_expression(sp.factor(entry))}")
    for finding in decoupling.findings:
        yield Text(f"{finding}; so every machine works for its own quantity, with active damping")
    if decoupling.findings:
        return
    numbers = np.array(decoupling.matrix.subs(values).tolist(), dtype=float)
    scaled = numbers / np.abs(numbers).max(axis=1, keepdims=True)
    yield Text(f"regular: condition number {np.linalg.cond(scaled):.3g} with rows scaled to one")


def _law(found: Derivation) -> Iterator[RenderableType]:
    yield Text("Air-gap torque of each machine; v is what its torque or speed controller asks for:")
    for equation in found.law.values():
        yield Text(f"  {equation.text()}", style="bold")
        yield from _notes(equation)


def _estimates(found: Derivation) -> Iterator[RenderableType]:
    for equation in found.estimates:
        yield Text(f"  {equation.text()}", style="bold")
        yield from _notes(equation)


def _notes(equation: Equation) -> Iterator[Text]:
    written = [Equation((), (term,)).text().removeprefix("0 = ") for term in equation.right]
    width = max(map(len, written), default=0)
    for text, term in zip(written, equation.right, strict=True):
        yield Text(f"      {text:<{width}}   {term.note}", style="dim")


def _friction_states(found: Derivation) -> Iterator[RenderableType]:
    if not found.friction_states:
        yield Text("no element couples or limits slip: the law holds in every state")
    for state in found.friction_states:
        taken, other = ("slipping", "sticks") if state.sticks else ("locked", "slips")
        yield Text(f"The law takes {state.element} for {taken}. While it {other}:")
        yield Text(f"  {state.text}", style="dim" if state.decouples else "bold")


def _gains(found: Derivation) -> Iterator[RenderableType]:
    table = Table("machine", "gain", "value", "unit", box=box.SIMPLE_HEAD, pad_edge=False)
    table.columns[2].justify = "right"
    for gain in found.gains:
        table.add_row(Text(gain.machine), gain.description, f"{gain.value:.5g}", gain.unit)
    yield table
    settings = ", ".join(f"{name} = {value:.4g}" for name, value in found.conventional.items())
    yield Text(f"The conventional controller is the same one with {settings}.")


def _closed_loop(found: Derivation) -> Iterator[RenderableType]:
    """Show the slowest and the least damped poles of the emitted code in closed loop, per controller."""
    yield Text("Poles of controller and full plant as they run: sampled, lag and dead time, free friction elements.")
    for name, poles in found.closed_loop.items():
        unstable = [pole for pole in poles if pole.is_unstable]
        stable = [pole for pole in poles if 0 <= pole.damping_ratio < 1 and pole.z.real > 0]
        swinging = sorted({(pole.frequency_hz, pole.damping_ratio) for pole in stable})
        shown = ", ".join(f"{frequency:.4g} Hz with {100 * damping:.3g} %" for frequency, damping in swinging[:6])
        yield Text(f"  {name}: oscillating poles and their damping: {shown or 'none'}")
        if unstable:
            counted = "1 pole is" if len(unstable) == 1 else f"{len(unstable)} poles are"
            yield Text(f"  {name}: {counted} UNSTABLE", style="bold red")

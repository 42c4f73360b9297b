"""Derivations, modes and beds as plain data: what the command line prints as JSON."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import sympy as sp

from ptgen.analysis.closed_loop import Pole
from ptgen.control.decoupling import Decoupling
from ptgen.mechanism.modes import Mode
from ptgen.project import Project
from ptgen.report.derivation import Derivation
from ptgen.report.formulas import Equation
from ptgen.report.friction_law import PLAIN, friction_law
from ptgen.report.motion import Slip
from ptgen.report.stability_plain import stability_json

__all__ = ["bed_json", "derivation_json", "modes_json"]


def bed_json(project: Project) -> dict[str, Any]:
    """Return what a checked bed consists of."""
    bed, model = project.testbed, project.model
    return {
        "ok": True,
        "name": bed.name,
        "title": bed.title,
        "file": bed.file,
        "digest": bed.digest,
        "sample_time": bed.sample_time,
        "components": len(bed.components),
        "connections": len(bed.connections),
        "machines": list(bed.machines),
        "torque": dict(bed.roles.torque),
        "speed": list(bed.roles.speed),
        "order": model.order,
        "reduced_order": project.reduced.model.order,
        "frictions": [friction.name for friction in model.frictions],
        "outputs": list(project.design.decoupling.outputs),
        "assumed": list(bed.assumed),
    }


def modes_json(modes: Iterable[Mode], locked: Iterable[str], free: Iterable[str]) -> dict[str, Any]:
    """Return modes with their frequencies, damping ratios and shapes."""
    return {
        "modes": [
            {"frequency_hz": mode.frequency_hz, "damping_ratio": mode.damping_ratio, "shape": dict(mode.shape)}
            for mode in modes
        ],
        "locked": list(locked),
        "free": list(free),
    }


def derivation_json(found: Derivation) -> dict[str, Any]:
    """Return a derivation; formulas are texts that sympy reads, numbers are in SI units."""
    decoupling = found.decoupling
    return {
        "name": found.name,
        "title": found.title,
        "model": {
            "states": list(found.model.states),
            "order": found.model.order,
            "inputs": [torque.name for torque in found.model.inputs],
            "frictions": [friction.name for friction in found.model.frictions],
            "friction_laws": {slip.friction.name: _friction(slip) for slip in found.motion.slips},
            "gaps": {spring.name: found.values[sp.sympify(spring.backlash)] for spring in found.gaps},
        },
        "reduced": {
            "states": list(found.reduced.states),
            "order": found.reduced.order,
            "rules": [
                {"rule": rule.rule, "element": rule.element, "why": rule.why, "numbers": dict(rule.numbers)}
                for rule in found.rules
            ],
            "parameters": dict(found.reduced_parameters),
            "definitions": {symbol.name: sp.sstr(made) for symbol, made in found.definitions.items()},
            "modes_before": _short(found.modes_before),
            "modes_after": _short(found.modes_after),
        },
        "outputs": list(decoupling.outputs),
        "structure": decoupling.structure,
        "findings": list(decoupling.findings),
        "relative_degree": list(decoupling.relative_degrees),
        "total_relative_degree": sum(decoupling.relative_degrees),
        "internal_dynamics_order": decoupling.internal_order,
        "internal_eigenvalues": [{"re": value.real, "im": value.imag} for value in found.internal_eigenvalues],
        "normal_form": _normal_form(decoupling),
        "decoupling_matrix": _entries(decoupling.matrix),
        "law": {name: sp.sstr(expression) for name, expression in decoupling.law_expressions().items()},
        "law_terms": {name: _terms(equation) for name, equation in found.law.items()},
        "estimates": {equation.left[0].name: _terms(equation) for equation in found.estimates},
        "gains": _gains(found),
        "conventional": dict(found.conventional),
        "closed_loop": {name: _poles(poles) for name, poles in found.closed_loop.items()},
        "friction_states": [
            {"element": state.element, "sticks": state.sticks, "decouples": state.decouples, "text": state.text}
            for state in found.friction_states
        ],
        "stability": stability_json(found.stability),
        "values": {symbol.name: value for symbol, value in found.values.items()},
    }


def _normal_form(decoupling: Decoupling) -> dict[str, Any] | None:
    form = decoupling.normal_form
    if form is None:
        return None
    polynomial = form.internal_polynomial
    return {
        "states": list(form.names),
        "transform": _entries(form.transform),
        "closed": _entries(form.closed),
        "internal": _entries(form.internal),
        "internal_polynomial": None if polynomial is None else sp.sstr(polynomial.as_expr()),
    }


def _entries(matrix: sp.Matrix) -> list[list[str]]:
    return [[sp.sstr(sp.factor(matrix[row, column])) for column in range(matrix.cols)] for row in range(matrix.rows)]


def _friction(slip: Slip) -> dict[str, Any]:
    law = friction_law(slip.friction, PLAIN)
    return {
        "role": slip.friction.role.value,
        "velocity": {term.name: sp.sstr(term.coefficient) for term in slip.velocity},
        "slipping": law.slipping,
        "at_rest": law.at_rest,
        "load": slip.friction.load.place if slip.friction.load is not None else None,
        "actuated": slip.friction.actuated,
        "one_way": slip.friction.one_way,
    }


def _short(modes: Iterable[Mode]) -> list[dict[str, float]]:
    return [{"frequency_hz": mode.frequency_hz, "damping_ratio": mode.damping_ratio} for mode in modes]


def _poles(poles: Iterable[Pole]) -> list[dict[str, float]]:
    return [{"frequency_hz": pole.frequency_hz, "damping_ratio": pole.damping_ratio} for pole in poles]


def _terms(equation: Equation) -> list[dict[str, str]]:
    return [
        {"signal": term.name, "coefficient": sp.sstr(term.coefficient), "purpose": term.note} for term in equation.right
    ]


def _gains(found: Derivation) -> dict[str, list[Mapping[str, Any]]]:
    result: dict[str, list[Mapping[str, Any]]] = {}
    for gain in found.gains:
        entry = {"description": gain.description, "value": gain.value, "unit": gain.unit}
        result.setdefault(gain.machine, []).append(entry)
    return result

"""Short names for the stiffness of condensed twists, so that laws read as people write them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from ptgen.elements import Parameter
from ptgen.mechanism import exact
from ptgen.mechanism.model import LinearForm, Model, evaluate_matrix

__all__ = ["AbbreviatedModel", "abbreviate"]


@dataclass(frozen=True)
class AbbreviatedModel:
    """A model whose stiffness matrix consists of plain symbols, and what these stand for."""

    model: Model
    definitions: Mapping[sp.Symbol, sp.Expr]


def abbreviate(model: Model) -> AbbreviatedModel:
    """Name every entry of the stiffness matrix that is no symbol already.

    A torque ``row . e`` becomes ``(row C^-1) (C e)``: in the first factor the stiffnesses cancel, what is left are
    ratios, as in (5.7) of the source.
    """
    size = len(model.twists)
    C = model.stiffness
    short = C.copy()
    definitions: dict[sp.Symbol, sp.Expr] = {}
    for i in range(size):
        for j in range(i, size):
            if C[i, j] == 0 or C[i, j].is_Symbol:
                continue
            name = model.twists[i] if i == j else f"{model.twists[i]}_{model.twists[j]}"
            symbol = sp.Symbol(f"{name}_equivalent_stiffness", **({"positive": True} if i == j else {"real": True}))
            definitions[symbol] = C[i, j]
            short[i, j] = short[j, i] = symbol
    mass, inertias = _short_mass(model)
    if not definitions and not inertias:
        return AbbreviatedModel(model, {})

    def shorten(form: LinearForm) -> LinearForm:
        if not definitions or all(entry == 0 for entry in form.e):
            return form
        ratios = exact.solve(C.T, form.e.T).T
        return replace(form, e=exact.canonical(ratios * short))

    parameters = tuple(
        Parameter(
            symbol,
            float(evaluate_matrix(sp.Matrix([[expression]]), model.values)[0, 0]),
            "N m/rad",
            f"equivalent stiffness {symbol.name.removesuffix('_equivalent_stiffness')}",
            positive=bool(symbol.is_positive),
            signed=not symbol.is_positive,
        )
        for symbol, expression in definitions.items()
    ) + tuple(
        Parameter(
            symbol,
            float(evaluate_matrix(sp.Matrix([[expression]]), model.values)[0, 0]),
            "kg m^2",
            f"equivalent inertia {symbol.name.removesuffix('_equivalent_inertia')}",
            positive=bool(symbol.is_positive),
            signed=not symbol.is_positive,
        )
        for symbol, expression in inertias.items()
    )
    signals = {name: shorten(form) for name, form in model.signals.items()}
    return AbbreviatedModel(
        replace(model, mass=mass, stiffness=short, signals=signals, parameters=model.parameters + parameters),
        {**definitions, **inertias},
    )


def _short_mass(model: Model) -> tuple[sp.Matrix, dict[sp.Symbol, sp.Expr]]:
    """Return the inertia matrix with names for its entries, if it couples coordinates; and what they stand for."""
    mass = model.mass.copy()
    size = mass.shape[0]
    if all(mass[i, j] == 0 for i in range(size) for j in range(i)):
        return mass, {}
    definitions: dict[sp.Symbol, sp.Expr] = {}
    names = [name.removesuffix(".shaft").replace(".", "_") for name in model.coordinates]
    for i in range(size):
        for j in range(i, size):
            if mass[i, j] == 0 or mass[i, j].is_Symbol:
                continue
            name = names[i] if i == j else f"{names[i]}_{names[j]}"
            symbol = sp.Symbol(f"{name}_equivalent_inertia", **({"positive": True} if i == j else {"real": True}))
            definitions[symbol] = model.mass[i, j]
            mass[i, j] = mass[j, i] = symbol
    return mass, definitions

"""Friction elements that hold the same motion, so that their torques are not unique while they stick."""

from __future__ import annotations

import itertools
from collections.abc import Mapping

import networkx as nx
import sympy as sp

from ptgen.mechanism import exact
from ptgen.mechanism.model import Model

__all__ = ["dependent_sets", "is_dependent", "rank_deficient"]


def dependent_sets(model: Model) -> tuple[tuple[str, ...], ...]:
    """Return the sets of friction elements whose velocities depend on each other at the parameters of the bed.

    Each set is as small as possible, and none shares an element with another one unless one combination ties them.
    """
    rows = _rows(model)
    names = [friction.name for friction in model.frictions]
    graph = nx.Graph()
    for combination in rows.T.nullspace():
        members = [name for name, factor in zip(names, combination, strict=True) if factor != 0]
        nx.add_path(graph, members)
        graph.add_nodes_from(members)
    sets = [tuple(name for name in names if name in part) for part in nx.connected_components(graph)]
    return tuple(sorted(sets, key=lambda members: names.index(members[0])))


def is_dependent(model: Model) -> bool:
    """Tell whether some friction elements of the model hold the same motion, or do at some ratio of those that change.

    Ratios that change are looked at one by one, the others as they are at the start, and two by two where both are the
    same: with two equal ratios the clutches of a gearbox hold the same motion.
    """
    G = model.friction_rows
    if rank_deficient(model, G):
        return True
    changing = [parameter for parameter in model.changing if parameter.symbol in G.free_symbols]
    spans = {parameter.symbol: parameter.span for parameter in changing if parameter.span is not None}
    for symbol, (least, most) in spans.items():
        if _loses_rank(model, {symbol: symbol}, symbol, least, most):
            return True
    for one, other in itertools.combinations(spans, 2):
        least, most = max(spans[one][0], spans[other][0]), min(spans[one][1], spans[other][1])
        if least <= most and _loses_rank(model, {one: one, other: one}, one, least, most):
            return True
    return False


def rank_deficient(model: Model, rows: sp.Matrix) -> bool:
    """Tell whether rows over the coordinates of a model depend on each other at the parameters of the bed."""
    return exact.rank(_valued(model, rows)) < len(rows.tolist())


def _loses_rank(model: Model, kept: Mapping[sp.Symbol, sp.Symbol], ratio: sp.Symbol, least: float, most: float) -> bool:
    """Tell whether the friction rows depend on each other for some value of `ratio` in its range."""
    rows = _valued(model, model.friction_rows, kept)
    if exact.rank(rows) < rows.shape[0]:
        return True
    if ratio not in rows.free_symbols:
        return False
    gram = sp.Poly(sp.numer(sp.together((rows * rows.T).det(method="berkowitz"))), ratio)
    return bool(int(gram.count_roots(sp.Rational(str(least)), sp.Rational(str(most)))) > 0)


def _rows(model: Model) -> sp.Matrix:
    """Return the friction rows with the parameters at their values, as exact numbers."""
    return _valued(model, model.friction_rows)


def _valued(model: Model, rows: sp.Matrix, kept: Mapping[sp.Symbol, sp.Symbol] | None = None) -> sp.Matrix:
    """Return rows with the parameters at their values, but those in `kept` replaced by others."""
    values = {symbol: sp.Rational(str(model.values[symbol])) for symbol in rows.free_symbols}
    values |= {symbol: other for symbol, other in (kept or {}).items() if symbol in values}
    return rows.subs(values) if values else rows

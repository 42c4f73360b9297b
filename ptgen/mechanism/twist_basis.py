"""Twist states that belong to machines: each is what one machine twists the bed by while the others stand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp

from ptgen.mechanism import exact
from ptgen.mechanism.model import LinearForm, Model

__all__ = ["TwistBasis", "twists_of"]


@dataclass(frozen=True)
class TwistBasis:
    """A model over other twist states.

    Attributes
    ----------
    model : Model
    former : Matrix (n_e, n_e)
        The former twists in the new ones.
    """

    model: Model
    former: sp.Matrix


def twists_of(model: Model, coordinates: Sequence[int]) -> TwistBasis:
    """Return the model with the twists of the given coordinates as states, as far as they are independent.

    Then the stiffness matrix is that which these machines see, and their own torques are its rows times the twists;
    around a differential or another node the torque of each shaft would else be a fraction of stiffnesses. A model with
    a single twist is left as it is.

    Parameters
    ----------
    model : Model
    coordinates : sequence of int
        Which coordinates come first, such as those of the machines that control a torque.
    """
    E, n_e = model.twist_rows, len(model.twists)
    if n_e < 2:
        return TwistBasis(model, sp.eye(n_e))
    order = [*coordinates, *(k for k in range(E.shape[1]) if k not in coordinates)]
    columns = [order[k] for k in exact.independent_rows(E[:, order].T)]
    W = E[:, columns]

    def over_new(form: LinearForm) -> LinearForm:
        return replace(form, e=exact.canonical(form.e * W))

    renamed = replace(
        model,
        twists=tuple(model.coordinates[k].removesuffix(".shaft").replace(".", "_") for k in columns),
        twist_rows=exact.solve(W, E),
        stiffness=exact.canonical(W.T * model.stiffness * W),
        damping=exact.canonical(W.T * model.damping * W),
        signals={name: over_new(form) for name, form in model.signals.items()},
        spring_rows={name: exact.canonical(row * W) for name, row in model.spring_rows.items()},
        contact_twists=exact.canonical(model.contact_twists * W) if model.contacts else model.contact_twists,
    )
    return TwistBasis(renamed, W)

"""Loss torques that are known as functions of the speed: friction that no sensor has to give (source (5.96))."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from ptgen.elements import Friction, FrictionRole
from ptgen.mechanism.mechanism import Mechanism

__all__ = ["component_of_loss", "loss_element", "with_known_losses"]

_SUFFIX = ".known_loss"


def with_known_losses(mechanism: Mechanism, flanges: Sequence[str]) -> Mechanism:
    """Return the mechanism with a friction element at each of `flanges`, such as ``"gearbox2.input"``."""
    elements = tuple(
        Friction(
            loss_element(flange),
            {flange: sp.Integer(1)},
            coulomb=sp.Integer(0),
            viscous=sp.Integer(0),
            role=FrictionRole.LOSS,
        )
        for flange in flanges
    )
    return replace(mechanism, frictions=mechanism.frictions + elements)


def loss_element(flange: str) -> str:
    """Return the name of the friction element at a flange."""
    return f"{flange.split('.', 1)[0]}{_SUFFIX}"


def component_of_loss(friction: str) -> str:
    """Return the component of such an element by the element's name."""
    return friction.removesuffix(_SUFFIX)

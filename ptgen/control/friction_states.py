"""What becomes of a law when a friction element is not in the state that the law was made for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ptgen.control.decoupling import check_structure
from ptgen.elements import Friction
from ptgen.errors import ControlError, ModelError
from ptgen.mechanism.mechanism import Mechanism
from ptgen.mechanism.reduction import is_left_to_integrators, reduce_mechanism
from ptgen.testbed.testbed import ReductionSettings, Roles, Structure

__all__ = ["FrictionState", "other_friction_states"]


@dataclass(frozen=True)
class FrictionState:
    """The other state of a friction element.

    Attributes
    ----------
    element : str
    sticks : bool
        Whether it sticks in that state; the law takes it for slipping then.
    decouples : bool
        Whether the same roles could be decoupled in that state.
    text : str
        What happens then.
    """

    element: str
    sticks: bool
    decouples: bool
    text: str


def other_friction_states(
    mechanism: Mechanism, settings: ReductionSettings, roles: Roles, structure: Structure, twists: int
) -> tuple[FrictionState, ...]:
    """Examine the roles with every coupling or slip-limiting element in its other state, one at a time.

    Parameters
    ----------
    mechanism : Mechanism
        The bed before reduction.
    settings : ReductionSettings
        With the elements that the law takes for locked.
    roles : Roles
    structure : {"decoupling", "individual"}
    twists : int
        Of the reduced model that the law was made from.
    """
    return tuple(
        _examined(mechanism, settings, roles, structure, twists, friction)
        for friction in mechanism.frictions
        if not is_left_to_integrators(friction)
    )


def _examined(
    mechanism: Mechanism,
    settings: ReductionSettings,
    roles: Roles,
    structure: Structure,
    twists: int,
    friction: Friction,
) -> FrictionState:
    name, sticks = friction.name, friction.name not in settings.locked
    locked = (*settings.locked, name) if sticks else tuple(other for other in settings.locked if other != name)
    try:
        other = reduce_mechanism(mechanism.with_numbers(), _with_locked(settings, locked))
        more = len(other.model.twists) - twists
        check_structure(other, roles)
    except (ControlError, ModelError) as error:
        return FrictionState(name, sticks, False, "; ".join(problem.what for problem in error.problems))
    if structure == "decoupling":
        return FrictionState(name, sticks, True, "the outputs could be decoupled as well, by another law")
    text = "the outputs could be decoupled"
    if sticks and more > 0:
        text += (
            f"; the bed then has {more} twist{'s' if more > 1 else ''} more, which the damping of this law does not "
            f'reach: a law made for it, [reduction] locked = ["{name}"], damps all of them'
        )
    return FrictionState(name, sticks, True, text)


def _with_locked(settings: ReductionSettings, locked: Sequence[str]) -> ReductionSettings:
    """Return the settings with other locked elements."""
    return settings.model_copy(update={"locked": tuple(locked)})

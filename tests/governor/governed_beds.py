"""Beds with any governor, from stages that are computed once."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ptgen.block.block import Block
from ptgen.project import Project
from ptgen.testbed import GovernorKind, GovernorSettings

SHARED = ("mechanism", "model", "plant_model", "reduced", "design", "plant", "prediction")
"""Stages that the governor does not change."""

UNTOUCHED = ("fault", "running", "authority", "refused", "reset", "reset_before", "reset_request")


def governed(project: Project, kind: GovernorKind, **settings: object) -> Project:
    """Return the bed with a governor of that kind in place of its own."""
    chosen = GovernorSettings.model_validate({"kind": kind, **settings})
    result = Project(replace(project.testbed, governor=chosen))
    for name in SHARED:
        vars(result)[name] = getattr(project, name)
    return result


def calm(block: Block, values: dict[str, np.ndarray], shares: np.ndarray) -> None:
    """Scale random signals by `shares` (batch,), so that limits are kept in part of the cases; in place."""
    for name in values:
        if name not in UNTOUCHED and not name.endswith(("_time", "_side", "_swings", "_ratio", "_now")):
            values[name] = values[name] * shares

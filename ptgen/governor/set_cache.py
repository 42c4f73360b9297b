"""Constraint sets, kept by their content: the same loop with the same limits and settings is worked out once."""

from __future__ import annotations

import dataclasses
import hashlib
import io
import zipfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ptgen.errors import PtgenError
from ptgen.files import cache_folder, write_file
from ptgen.governor.constraint_set import ConstraintSet, TorqueLimit, constraint_set
from ptgen.governor.prediction import Prediction
from ptgen.testbed.governor_settings import GovernorSettings

__all__ = ["cached_constraint_set"]

_FORMAT = 1
"""Part of every key; goes up when sets are worked out in another way."""

_DIGITS = 11
"""Digits of the matrices that count: the last ones differ from machine to machine."""


def cached_constraint_set(
    prediction: Prediction,
    limits: Sequence[TorqueLimit],
    settings: GovernorSettings,
    progress: Callable[[float], None] | None = None,
    *,
    check: bool = True,
) -> ConstraintSet:
    """Return `constraint_set` of the same arguments, from the cache if it is there, and keep it there if not.

    The cache lies in ``$XDG_CACHE_HOME/ptgen``, by default ``~/.cache/ptgen``; a file that cannot be read is worked out
    anew, and a folder that cannot be written is passed over.

    Raises
    ------
    ControlError
        As `constraint_set`.
    """
    key = _key(prediction, limits, settings, check)
    try:
        file = cache_folder() / f"governor-{key}.npz"
    except PtgenError:
        return constraint_set(prediction, limits, settings, progress, check=check)
    found = _read(file, prediction, limits, settings)
    if found is None:
        found = constraint_set(prediction, limits, settings, progress, check=check)
        _keep(file, found)
    elif progress is not None:
        progress(1.0)
    return found


def _key(prediction: Prediction, limits: Sequence[TorqueLimit], settings: GovernorSettings, check: bool) -> str:
    numbers = [
        np.char.mod(f"%.{_DIGITS}e", matrix.ravel()).tolist()
        for matrix in (prediction.A, prediction.B, prediction.C, prediction.D)
    ]
    shape = (*prediction.C.shape, prediction.sample_time)
    chosen = (settings.horizon, settings.reserve, settings.stationary_reserve, settings.removal, check)
    content = repr((_FORMAT, shape, numbers, [dataclasses.astuple(limit) for limit in limits], chosen))
    return hashlib.sha256(content.encode()).hexdigest()[:24]


def _keep(file: Path, found: ConstraintSet) -> None:
    stream = io.BytesIO()
    arrays: dict[str, Any] = {f"steps_{i}": steps for i, steps in enumerate(found.steps)}
    arrays |= {"binding": found.binding, "numbers": np.array([found.horizon, found.looked_at, found.programs])}
    np.savez_compressed(stream, **arrays)
    try:
        write_file(file, stream.getvalue())
    except PtgenError:
        return  # the cache saves time, nothing else


def _read(
    file: Path, prediction: Prediction, limits: Sequence[TorqueLimit], settings: GovernorSettings
) -> ConstraintSet | None:
    try:
        stream = io.BytesIO(file.read_bytes())
        if not zipfile.is_zipfile(stream):
            return None
        with np.load(stream) as content:
            horizon, looked_at, programs = (int(value) for value in content["numbers"])
            steps = tuple(content[f"steps_{i}"].astype(np.int64) for i in range(len(prediction.machines)))
            binding = content["binding"]
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None
    if binding.shape != (len(prediction.machines), looked_at + 1):
        return None
    return ConstraintSet(
        prediction=prediction,
        limits=tuple(limits),
        reserve=settings.reserve,
        stationary_reserve=settings.stationary_reserve,
        removal=settings.removal,
        horizon=horizon,
        steps=steps,
        looked_at=looked_at,
        binding=binding,
        programs=programs,
    )

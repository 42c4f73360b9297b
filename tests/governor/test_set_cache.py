"""The cache of constraint sets: by content, and of no consequence but time."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from ptgen.governor import set_cache
from ptgen.governor.constraint_set import torque_limits
from ptgen.governor.prediction import predict_loop
from ptgen.governor.set_cache import cached_constraint_set
from ptgen.testbed.governor_settings import GovernorSettings


@pytest.fixture
def asked(projects, tmp_path, monkeypatch):
    """What a set is asked for with, a cache of its own, and a count of how often one was worked out."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    project = projects["back_to_back"]
    prediction = predict_loop(project.design, project.testbed)
    settings = GovernorSettings(removal=0.05)
    worked, original = [], set_cache.constraint_set

    def counted(*arguments, **named):
        worked.append(1)
        return original(*arguments, **named)

    monkeypatch.setattr(set_cache, "constraint_set", counted)
    return (prediction, torque_limits(project.design.decoupling.model), settings), worked, tmp_path / "ptgen"


def same(one, other) -> bool:
    plain = ("limits", "reserve", "stationary_reserve", "removal", "horizon", "looked_at", "programs")
    return all(getattr(one, name) == getattr(other, name) for name in plain) and all(
        np.array_equal(a, b) for a, b in zip((*one.steps, one.binding), (*other.steps, other.binding), strict=True)
    )


def test_the_second_time_it_is_read(asked):
    arguments, worked, folder = asked
    first = cached_constraint_set(*arguments)
    told = []
    second = cached_constraint_set(*arguments, told.append)
    assert same(first, second)
    assert len(worked) == 1
    assert told == [1.0]
    assert [file.suffix for file in folder.iterdir()] == [".npz"]


def test_everything_that_matters_is_part_of_the_key(asked):
    (prediction, limits, settings), worked, _ = asked
    cached_constraint_set(prediction, limits, settings)
    changed = [
        (dataclasses.replace(prediction, A=prediction.A * 0.999), limits, settings),
        (prediction, tuple(dataclasses.replace(limit, largest=limit.largest * 1.01) for limit in limits), settings),
        (prediction, limits, settings.model_copy(update={"removal": 0.06})),
        (prediction, limits, settings.model_copy(update={"reserve": 0.06})),
        (prediction, limits, settings.model_copy(update={"stationary_reserve": 0.03})),
        (prediction, limits, settings.model_copy(update={"horizon": 1.0})),
    ]
    for count, arguments in enumerate(changed, start=2):
        cached_constraint_set(*arguments)
        assert len(worked) == count


def test_rounding_is_no_part_of_the_key(asked):
    (prediction, limits, settings), worked, _ = asked
    cached_constraint_set(prediction, limits, settings)
    cached_constraint_set(dataclasses.replace(prediction, A=prediction.A * (1 + 1e-15)), limits, settings)
    assert len(worked) == 1


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04 broken", b"\x93NUMPY"])
def test_a_broken_file_is_worked_out_anew(asked, content):
    arguments, worked, folder = asked
    first = cached_constraint_set(*arguments)
    (file,) = folder.iterdir()
    file.write_bytes(content)
    assert same(first, cached_constraint_set(*arguments))
    assert len(worked) == 2
    assert same(first, cached_constraint_set(*arguments))
    assert len(worked) == 2

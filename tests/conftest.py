"""What all tests share: the repository, and the shipped beds with every stage computed at most once."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import Phase, settings

from ptgen.project import Project

# Symbolic work has no steady run time, so a time limit per example would only fail at random; and making a failing
# bed smaller takes minutes, while the bed that failed is printed anyway.
settings.register_profile("ptgen", max_examples=50, deadline=None, phases=(Phase.explicit, Phase.reuse, Phase.generate))
settings.load_profile("ptgen")


@pytest.fixture(scope="session")
def root() -> Path:
    """The root of the repository."""
    return Path(__file__).resolve().parents[1]


@pytest.fixture(scope="session")
def projects(root: Path) -> dict[str, Project]:
    """Every bed in ``testbeds/`` by its name."""
    beds = [Project.read(path) for path in sorted((root / "testbeds").glob("*.toml"))]
    return {project.testbed.name: project for project in beds}


TORQUE_BEDS = [
    "all_wheel_drive",
    "back_to_back",
    "differential",
    "differential_gearboxes",
    "differential_governed",
    "differential_output_torque",
    "transmission",
    "transmission_fixed_gear",
]
"""The shipped beds that control one torque."""


@pytest.fixture(
    scope="session", params=sorted(["centre_differential", "centre_differential_locked", "clutch_rig", *TORQUE_BEDS])
)
def project(request: pytest.FixtureRequest, projects: dict[str, Project]) -> Project:
    """One shipped bed after the other."""
    return projects[request.param]


@pytest.fixture(scope="session", params=TORQUE_BEDS)
def torque_project(request: pytest.FixtureRequest, projects: dict[str, Project]) -> Project:
    """One shipped bed after the other that controls one torque."""
    return projects[request.param]

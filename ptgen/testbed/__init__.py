"""Test bed and scenario files: read, checked, in SI units."""

from ptgen.testbed.governor_settings import GovernorKind, GovernorSettings
from ptgen.testbed.profile import Profile
from ptgen.testbed.reading import load
from ptgen.testbed.scenario import Scenario, load_scenario
from ptgen.testbed.schema import json_schema
from ptgen.testbed.shift_plan import Shift
from ptgen.testbed.testbed import Connection, ReductionSettings, Roles, Testbed, Tuning

__all__ = [
    "Connection",
    "GovernorKind",
    "GovernorSettings",
    "Profile",
    "ReductionSettings",
    "Roles",
    "Scenario",
    "Shift",
    "Testbed",
    "Tuning",
    "json_schema",
    "load",
    "load_scenario",
]

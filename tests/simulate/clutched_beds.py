"""Test beds with clutches and brakes."""

from __future__ import annotations

MACHINE = """
[components.{name}]
type = "machine"
inertia = "1 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"
inverter = {{ model = "lag", dead_time = "137 us", time_constant = "250 us" }}
"""

FLANGE = """
[components.{name}]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "38 kN m/rad"
damping = "2 N m s/rad"
"""

CLUTCHED = f"""\
[testbed]
name = "clutched"
sample_time = "100 us"
connections = ["M1 - flange1 - clutch1 - flange2 - M2"]
{MACHINE.format(name="M1")}
{MACHINE.format(name="M2")}
{FLANGE.format(name="flange1")}
{FLANGE.format(name="flange2")}
[components.clutch1]
type = "clutch"
capacity = "200 N m"
static = "250 N m"

[control]
speed = ["M1", "M2"]
"""
"""Two machines and a clutch in between."""

BRAKED = f"""\
[testbed]
name = "braked"
sample_time = "100 us"
connections = ["M1 - flange1 - brakeA - brakeB - flange2 - M2"]
{MACHINE.format(name="M1")}
{MACHINE.format(name="M2")}
{FLANGE.format(name="flange1")}
{FLANGE.format(name="flange2")}
[components.brakeA]
type = "brake"
capacity = "200 N m"

[components.brakeB]
type = "brake"
capacity = "100 N m"
actuated = false

[control]
torque = {{ M1 = "flange1" }}
speed = ["M2"]
"""
"""Two brakes on one shaft."""

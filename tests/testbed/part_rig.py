"""A bed of two machines with a part between them, whose file is still to be named."""

from __future__ import annotations

__all__ = ["BED"]

BED = """
[testbed]
name = "rig"
sample_time = "100 us"
connections = ["M1 - shaft1 - gears.input", "gears.output - shaft2 - M2"]
[components.gears]
type = "part"
file = "one.toml"
[components.shaft1]
type = "shaft"
stiffness = "20 kN m/rad"
[components.shaft2]
type = "shaft"
stiffness = "20 kN m/rad"
[components.M1]
type = "machine"
inertia = "0.4 kg m^2"
torque_max = "900 N m"
speed_rated = "3200 rpm"
speed_max = "8000 rpm"
[components.M2]
type = "machine"
inertia = "0.4 kg m^2"
torque_max = "900 N m"
speed_rated = "3200 rpm"
speed_max = "8000 rpm"
[control]
speed = ["M1", "M2"]
"""

"""Test bed files for tests: a plain description, written as TOML and read by the ordinary reader."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ptgen.testbed import Testbed, load

_UNITS = {
    "inertia": "kg m^2",
    "stiffness": "N m/rad",
    "damping": "N m s/rad",
    "radius": "m",
    "torque": "N m",
    "speed": "rad/s",
    "coulomb": "N m",
    "viscous": "N m s/rad",
}


@dataclass
class Bed:
    """A bed under construction; numbers are in SI units."""

    components: dict[str, dict[str, object]] = field(default_factory=dict)
    chains: list[str] = field(default_factory=list)
    torque: dict[str, str] = field(default_factory=dict)
    speed: list[str] = field(default_factory=list)
    reduction: dict[str, object] = field(default_factory=dict)
    control: dict[str, object] = field(default_factory=dict)

    def add(self, name: str, kind: str, **fields: object) -> str:
        """Add a component and return its name."""
        self.components[name] = {"type": kind, **fields}
        return name

    def machine(self, name: str, inertia: float = 1.0) -> str:
        """Add a machine with an ideal inverter."""
        return self.add(name, "machine", inertia=inertia, torque_max=1000.0, speed_rated=300.0, speed_max=900.0)

    def text(self) -> str:
        """Return the file."""
        lines = ["[testbed]", 'name = "bed"', 'sample_time = "100 us"', f"connections = {json.dumps(self.chains)}"]
        for name, fields in self.components.items():
            lines += ["", f"[components.{name}]", *(f"{key} = {_value(key, value)}" for key, value in fields.items())]
        pairs = ", ".join(f"{machine} = {json.dumps(place)}" for machine, place in self.torque.items())
        lines += ["", "[control]", f"torque = {{ {pairs} }}", f"speed = {json.dumps(self.speed)}"]
        lines += [f"{key} = {_value(key, value)}" for key, value in self.control.items()]
        lines += ["", "[reduction]", *(f"{key} = {json.dumps(value)}" for key, value in self.reduction.items())]
        return "\n".join(lines) + "\n"

    def load(self) -> Testbed:
        """Write the file to a directory of its own and read it."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "bed.toml"
            file.write_text(self.text(), encoding="utf-8")
            return load(file)


def _value(key: str, value: object) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{name} = {_value(name, part)}" for name, part in value.items()) + " }"
    unit = next((unit for start, unit in _UNITS.items() if key.startswith(start)), "")
    return json.dumps(f"{value!r} {unit}") if unit and isinstance(value, float) else json.dumps(value)


def two_machines(middle: Sequence[str], bed: Bed | None = None, place: str = "flange1") -> Bed:
    """Return a bed of two machines with the named components of `bed` between them."""
    bed = bed or Bed()
    bed.machine("M1")
    bed.machine("M2", 2.0)
    bed.chains.append(" - ".join(["M1", *middle, "M2"]))
    bed.torque, bed.speed = {"M1": place}, ["M2"]
    return bed


def differential_bed(
    kind: str = "differential",
    shafts: Sequence[float] = (57e3, 45e3, 70e3),
    flanges: Sequence[str] = ("flange1", "flange2", "flange3"),
    place: str = "diff.input",
    **changes: object,
) -> Bed:
    """Return three machines around a differential; unequal shafts, and torque flanges where they are named."""
    bed = Bed()
    for index, inertia in enumerate((1.0, 10.3, 8.0), start=1):
        bed.machine(f"M{index}", inertia)
        bed.add(f"cardan{index}", "shaft", stiffness=shafts[index - 1], damping=2.0 * index)
        if f"flange{index}" in flanges:
            bed.add(f"flange{index}", "torque_flange", inertia=0.03 + 0.002 * index, stiffness=380e3, damping=0.5)
    friction = {"limited_slip": {"coulomb": 20.0, "load": 0.15, "viscous": 0.05}}
    bed.add("diff", kind, **{**DIFFERENTIALS[kind], **friction, **changes})
    middle = [f"flange{index} - " if f"flange{index}" in flanges else "" for index in (1, 2, 3)]
    bed.chains.append(f"M1 - {middle[0]}cardan1 - diff.input")
    bed.chains += [
        f"diff.output{k} - cardan{k + 1}" + (f" - flange{k + 1}" if middle[k] else "") + f" - M{k + 1}" for k in (1, 2)
    ]
    bed.torque, bed.speed = {"M1": place}, ["M2", "M3"]
    return bed


DIFFERENTIALS: dict[str, dict[str, object]] = {
    "differential": {"ratio": 1.91, "inertia": 0.022, "inertia_pinion": 0.04, "pinion_ratio": 0.9},
    "bevel_differential": {
        "ratio": 2.5,
        "radius_output1": 0.08,
        "radius_output2": 0.06,
        "radius_pinion": 0.05,
        "inertia_drive": 0.01,
        "inertia_cage": 0.05,
        "inertia_output1": 0.012,
        "inertia_output2": 0.009,
        "inertia_pinion": 0.003,
    },
    "epicyclic_differential": {
        "radius_ring": 0.09,
        "radius_sun": 0.04,
        "planets": 3,
        "inertia_carrier": 0.05,
        "inertia_ring": 0.03,
        "inertia_sun": 0.01,
        "inertia_planet": 0.002,
    },
}

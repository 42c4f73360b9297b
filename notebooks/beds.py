"""Beds for the notebooks: read by ptgen from text, with ptgen's symbols replaced by those of a notebook.

A bed is described in the words of a test bed file, written to a temporary file and read from there, so that the
notebooks go the same way as a user. The root of the project is found from the place of this file.
"""

import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

import sympy as sp

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from ptgen.project import Project
from ptgen.testbed import load

MACHINE = """
[components.{name}]
type = "machine"
inertia = "{inertia} kg m^2"
torque_max = "1000 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"
"""


def machine(name: str, inertia: float = 5.0) -> str:
    """Return the table of a machine; what the notebooks do not use has any value."""
    return MACHINE.format(name=name, inertia=inertia)


def table(name: str, kind: str, **values: object) -> str:
    """Return the table of a component; values are texts, numbers or inner tables."""
    lines = [f"{key} = {_toml(value)}" for key, value in values.items()]
    return "\n".join(["", f"[components.{name}]", f'type = "{kind}"', *lines, ""])


def _toml(value: object) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{value}"' if isinstance(value, str) else str(value)


def bed(connections: list[str], *tables: str, torque: dict[str, str], speed: list[str], reduction: str = "") -> Project:
    """Return the project of a bed that is described by its chains, its components and its roles."""
    head = f'[testbed]\nname = "bed"\nsample_time = "100 us"\nconnections = {connections}\n'
    roles = f"\n[control]\ntorque = {_toml(torque)}\nspeed = {speed}\n"
    return read(head + "".join(tables) + roles + (f"\n[reduction]\n{reduction}\n" if reduction else ""))


def shipped(name: str, more: str = "") -> Project:
    """Return the project of a bed of the directory testbeds, with `more` text at the end of its file."""
    return read((ROOT / "testbeds" / f"{name}.toml").read_text(encoding="utf-8") + more)


def read(text: str) -> Project:
    """Write a test bed file, and read it with ptgen."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "bed.toml"
        path.write_text(text, encoding="utf-8")
        return Project(load(path))


def rename(value, names: Mapping[str, object]):
    """Replace ptgen's symbols by name; a value is an expression or a matrix of them."""
    replaced = {symbol: names[symbol.name] for symbol in value.free_symbols if symbol.name in names}
    return value.subs(replaced, simultaneous=True) if hasattr(value, "subs") else value


def with_definitions(names: Mapping[str, object], definitions: Mapping[sp.Symbol, sp.Expr]) -> dict[str, object]:
    """Return `names` and the parameters of equivalent shafts, spelled out in them."""
    spelled = dict(names)
    for symbol, expression in definitions.items():
        while expression.free_symbols & set(definitions):
            expression = expression.subs(dict(definitions))
        spelled.setdefault(symbol.name, rename(expression, names))
    return spelled


def rates(model, names: Mapping[str, object], inputs: list, frictions: list, states: list) -> list:
    """Return the accelerations of a model's coordinates as expressions over the given variables."""
    form = model.accelerations()
    variables = [
        (form.z, states[: len(model.coordinates)]),
        (form.e, states[len(model.coordinates) :]),
        (form.u, inputs),
        (form.f, frictions),
    ]
    total = sp.zeros(len(model.coordinates), 1)
    for matrix, values in variables:
        if matrix.shape[1]:
            total += rename(matrix, names) * sp.Matrix(values)
    return list(total)


def signal(model, name: str, names: Mapping[str, object], inputs: list, frictions: list, states: list):
    """Return a sensor or place of a model as an expression over the given variables."""
    form = model.without_acceleration(model.signals[name])
    variables = [
        (form.z, states[: len(model.coordinates)]),
        (form.e, states[len(model.coordinates) :]),
        (form.u, inputs),
        (form.f, frictions),
    ]
    return sum(
        ((rename(matrix, names) * sp.Matrix(values))[0] for matrix, values in variables if matrix.shape[1]),
        sp.Integer(0),
    )

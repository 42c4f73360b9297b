"""The section ``[references]`` of scenarios: what the machines are to do."""

from __future__ import annotations

from pathlib import Path

from ptgen.errors import Problem, nearest
from ptgen.testbed.problems import dotted, shown
from ptgen.testbed.profile import Profile, read_profile
from ptgen.testbed.testbed import Testbed

__all__ = ["read_references"]

_UNITS = {"torque": "N m", "speed": "rad/s", "speed_mean": "rad/s", "speed_difference": "rad/s"}


def read_references(table: object, testbed: Testbed, folder: Path) -> tuple[dict[str, Profile], list[Problem]]:
    """Read ``[references]``; what has no entry gets a reference of zero.

    Parameters
    ----------
    table : object
        What stands in the section.
    testbed : Testbed
    folder : Path
        Where measurement files are looked for.

    Returns
    -------
    references : dict of str to Profile
        With the keys of `ptgen.testbed.scenario.Scenario`.
    problems : list of Problem
        All problems of the section.
    """
    wanted = _wanted(testbed)
    references = {key: Profile((0.0,), (0.0,), "lines") for key in wanted}
    if not isinstance(table, dict):
        remedy = 'write [references] with torque.M1 = { time = ["0 s"], value = ["0 N m"] }'
        return references, [Problem("references", f"must be a table, got {shown(table)}", remedy)]
    problems: list[Problem] = []
    for kind_name, machines in table.items():
        if kind_name not in _UNITS:
            where = dotted("references", kind_name)
            problems.append(Problem(where, "is an unknown kind of reference", nearest(kind_name, _UNITS)))
            continue
        if not isinstance(machines, dict):
            where = dotted("references", kind_name)
            what = f"must be a table of machines, got {shown(machines)}"
            problems.append(Problem(where, what, f"write {kind_name}.M1 = {{ time = [...], value = [...] }}"))
            continue
        for machine, entry in machines.items():
            key = f"{kind_name}.{machine}"
            if key not in wanted:
                problems.append(_unwanted(kind_name, machine, testbed, wanted))
                continue
            profile, found = read_profile(entry, _UNITS[kind_name], folder, "references", kind_name, machine)
            problems += found
            if profile is not None:
                references[key] = profile
    return references, problems


def _wanted(testbed: Testbed) -> list[str]:
    """Return the references of a bed: of each machine, or of each pair its mean and its difference."""
    paired = {machine for members in testbed.tuning.speed_pairs.values() for machine in members}
    wanted = []
    for machine in testbed.machines:
        if machine not in paired:
            wanted.append(f"{'torque' if machine in testbed.roles.torque else 'speed'}.{machine}")
    for pair in testbed.tuning.speed_pairs:
        wanted += [f"speed_mean.{pair}", f"speed_difference.{pair}"]
    return wanted


def _unwanted(kind: str, machine: str, testbed: Testbed, wanted: list[str]) -> Problem:
    where = dotted("references", kind, machine)
    pairs = testbed.tuning.speed_pairs
    pair = next((name for name, members in pairs.items() if machine in members), None)
    if pair is not None:
        what = f'the speed of "{machine}" is given by the pair "{pair}" of the bed "{testbed.name}"'
        return Problem(where, what, f"write speed_mean.{pair} and speed_difference.{pair}")
    if kind in ("speed_mean", "speed_difference"):
        what = f'{shown(machine)} is no pair of speeds of the bed "{testbed.name}"'
        return Problem(where, what, nearest(f"{kind}.{machine}", wanted))
    if machine in testbed.machines:
        other = "torque" if kind == "speed" else "speed"
        what = f'machine "{machine}" controls its {other} in the bed "{testbed.name}", not its {kind}'
        if other == "torque":
            what = f'machine "{machine}" controls a torque in the bed "{testbed.name}", not its speed'
        return Problem(where, what, f"write {other}.{machine}, or change its role in [control] of the bed")
    what = f'{shown(machine)} is no machine of the bed "{testbed.name}"'
    return Problem(where, what, nearest(f"{kind}.{machine}", wanted))

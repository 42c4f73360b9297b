"""Sensors that fail in closed loop: what the controller says of it, and when.

Run as a program it prints the table of docs/controller.md.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library

START = 0.3
END = 1.5

Failure = Callable[[float, float], float]
"""From the true value, and the one at the moment of the failure, to what the sensor says."""

SPEED: dict[str, Failure] = {
    "frozen": lambda true, last: last,
    "drops to zero": lambda true, last: 0.0,
    "sign flipped": lambda true, last: -true,
    "reads 10 % too much": lambda true, last: 1.1 * true,
    "reads half": lambda true, last: 0.5 * true,
    "offset 5 rad/s": lambda true, last: true + 5.0,
    "offset 50 rad/s": lambda true, last: true + 50.0,
}
TORQUE: dict[str, Failure] = {
    "frozen": lambda true, last: last,
    "drops to zero": lambda true, last: 0.0,
    "sign flipped": lambda true, last: -true,
    "reads 10 % too much": lambda true, last: 1.1 * true,
    "reads half": lambda true, last: 0.5 * true,
    "offset 10 % of the machine": lambda true, last: true + 0.1,
    "offset 40 % of the machine": lambda true, last: true + 0.4,
}


@dataclass(frozen=True)
class Outcome:
    """What was said, and how long after the failure (s); no text if nothing was. Torques in shares of the machines'."""

    text: str
    after: float
    before: dict[str, float]
    worst: dict[str, float]
    held: dict[str, float]


def references(time: float) -> dict[str, float]:
    """Return a run with torque and acceleration: 300 N m, speeds that rise and fall by 100 rad/s per second."""
    speed = 100.0 * min(time, 0.6) - 60.0 * min(max(time - 0.9, 0.0), 0.6)
    return {"diff_input_torque_ref": 300.0 if time > 0.1 else 0.0, "M2_speed_ref": speed, "M3_speed_ref": speed}


def run(library: Library, signal: str, failure: Failure | None, parameters: dict[str, float] | None = None) -> Outcome:
    """Let a sensor of the bed `differential` fail after `START` seconds."""
    controller, plant = library.controller, library.plant
    params, plant_params = controller.parameters(parameters or {}), plant.defaults()
    _, state = controller.init(params)
    _, plant_state = plant.init(plant_params)
    inputs, commands = controller.inputs_type(), controller.outputs_type()
    driven, measured = plant.inputs_type(), plant.outputs_type()
    common = [s.name for s in controller.block.inputs if hasattr(measured, s.name)]
    outputs = [s.name for s in controller.block.outputs]
    step, last = params.sample_time, 0.0
    scale = float(getattr(params, {"1": "M1", "2": "M2", "3": "M3"}[signal.strip("Mflangetorquspd_")] + "_torque_max"))
    unit = scale if signal.startswith("flange") else 1.0
    before, worst = dict.fromkeys(outputs, 0.0), dict.fromkeys(outputs, 0.0)

    def shares() -> dict[str, float]:
        most = {name: getattr(params, name.replace("_torque_ref", "_torque_max")) for name in outputs}
        return {name: getattr(commands, name) / most[name] for name in outputs}

    for k in range(round(END / step)):
        for name in common:
            setattr(inputs, name, getattr(measured, name))
        for name, value in references(k * step).items():
            setattr(inputs, name, value)
        true = getattr(measured, signal) / unit
        if failure is not None and k * step >= START:
            setattr(inputs, signal, unit * failure(true, last))
        else:
            last = true
        status = controller.step_struct(state, params, inputs, commands)
        if status != 0:
            return Outcome(controller.status_text(status), k * step - START, before, worst, shares())
        if k * step < START:
            before = shares()
        else:
            worst = {name: max(worst[name], abs(share - before[name])) for name, share in shares().items()}
        for name in outputs:
            setattr(driven, name, getattr(commands, name))
        plant.step_struct(plant_state, plant_params, driven, measured)
    return Outcome("", END - START, before, worst, shares())


def main() -> None:
    root = Path(__file__).resolve().parents[2]
    library = build(Project.read(root / "testbeds" / "differential.toml"))
    print("| sensor | failure | status text | after |\n| --- | --- | --- | --- |")
    for signal, kinds in (
        ("M2_speed", SPEED),
        ("M1_speed", SPEED),
        ("flange2_torque", TORQUE),
        ("flange1_torque", TORQUE),
    ):
        for kind, failure in kinds.items():
            found = run(library, signal, failure)
            after = f"{1e3 * found.after:.0f} ms" if found.text else ""
            print(f"| `{signal}` | {kind} | {found.text or 'not found'} | {after} |")


if __name__ == "__main__":
    main()

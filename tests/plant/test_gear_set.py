"""The rigid model (3.42) of a gear set with six friction elements: shifts, standstill, power balance, stiff joints."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from gear_set_rig import ELEMENTS, GEARS, ORDER, Balance, Rig, rig, shift_course, shifted, turn

from ptgen.gears import gear_ratios, layout_of
from ptgen.mechanism import exact
from ptgen.testbed.parts import read_part, shipped_parts

pytestmark = pytest.mark.compile

MEMBERS = ("input", "a", "b", "output", "carrier1", "sun2", "ring3", "carrier4")


def through_all_gears(step: float, dwell: float) -> tuple[list[Balance], list, int]:
    return shifted(rig(), ORDER, step=step, dwell=dwell, ramp=dwell / 3, torque=100.0, speed=30.0)


def test_six_elements_act_on_four_degrees_of_freedom() -> None:
    model = rig().model
    assert model.coordinates[:4] == ("gears.A.left", "gears.B.left", "gears.C.left", "gears.D")
    assert exact.rank(model.friction_rows) == 4
    assert model.friction_rows.shape[0] == 6
    assert model.friction_rows[:4, :4] == sp.eye(4), "the first four are states themselves (4.74)"


def test_shifts_through_all_gears_and_reverse_leave_nothing_unsolved() -> None:
    _, ends, unsolved = through_all_gears(1e-4, 0.5)
    assert unsolved == 0
    part = read_part(shipped_parts()["nine-speed.toml"])
    component = part.model_validate({"type": "part", "file": "nine-speed.toml"})
    values = {p.symbol: p.value for p in component.parameters("g")}
    ratios = gear_ratios(layout_of(component.elements("g"), "g.input", "g.output", values, prefix="g."), GEARS)
    numeric = rig().numeric
    rows = np.vstack([numeric.friction_rows])
    for gear, end in zip(ORDER, ends, strict=False):
        slip = np.array([end[f"gears_{name}_speed"] for name in ELEMENTS])
        assert all(slip[ELEMENTS.index(name)] == 0.0 for name in GEARS[gear]), f"gear {gear}: {slip}"
        assert np.count_nonzero(slip) == 3
        # The input's speed follows from the slip of the open elements; the output's too, and their ratio is the gear's.
        z, *_ = np.linalg.lstsq(rows[:, :4], slip, rcond=None)
        assert rows[:, :4] @ z == pytest.approx(slip, abs=1e-9 * abs(slip).max())
        velocities = {name: np.array(rig().model.velocity_rows[f"gears.{name}"].subs(rig().model.values)[:4], float)
                      for name in ("input", "output")}  # fmt: skip
        ratio = float(velocities["input"] @ z) / float(velocities["output"] @ z)
        assert ratio == pytest.approx(ratios[gear], rel=1e-9), gear


def test_power_balance_closes_over_every_shift() -> None:
    balances, _, _ = through_all_gears(1e-5, 0.1)
    assert len(balances) == len(ORDER)
    assert max(balance.error for balance in balances) < 1e-6
    assert max(balance.friction / balance.turnover for balance in balances) > 0.01, "something did slip"


def test_power_balance_closes_with_the_order_of_the_step() -> None:
    errors = []
    for step in (2e-4, 1e-4, 5e-5):
        balances, _, _ = shifted(rig(), ["1", "2"], step=step, dwell=0.4, ramp=0.15, torque=100.0, speed=30.0)
        errors.append(balances[1].error)
    assert errors[1] < 1e-5
    assert errors[0] / errors[2] > 8.0, f"order 2 has 16: {errors}"


@pytest.mark.parametrize("torque", [0.0, 150.0, -80.0])
def test_all_six_hold_at_standstill_with_torques_of_least_norm(torque: float) -> None:
    built = rig()
    plant, numeric = built.plant, built.numeric
    params = plant.parameters({})
    _, state = plant.init(params)
    inputs = {f"gears_{name}_actuation": 1.0 for name in ELEMENTS}
    speeds = {"M1": 0.0, "M2": 0.0}
    for _ in range(20000):  # a little damping by the machines, so that the shafts come to rest
        inputs["M1_torque_ref"] = torque - 30.0 * speeds["M1"]
        inputs["M2_torque_ref"] = -2.0 * torque - 300.0 * speeds["M2"]
        status, outputs = plant.step(state, params, inputs)
        assert status == 0, plant.status_text(status)
        speeds = {name: outputs[f"{name}_speed"] for name in speeds}
    assert [outputs[f"gears_{name}_speed"] for name in ELEMENTS] == [0.0] * 6
    assert abs(outputs["M1_speed"]) < 1e-6 * max(1.0, abs(torque))
    T = np.array([outputs[f"gears_{name}_torque"] for name in ELEMENTS])
    K = plant.read(state, "K")
    weight = np.sqrt(np.diag(K))
    null = np.linalg.svd(K)[2][4:]
    assert abs(null @ (weight**2 * T)).max() < 1e-7 * max(1.0, abs(T).max()) * weight.max() ** 2, "none along the null"
    # What the torques do to the coordinates is what the shafts and machines do to them.
    e = plant.read(state, "x")[len(built.model.coordinates) :][: len(built.model.twists)]
    balance = numeric.twist_rows.T @ (numeric.stiffness @ e) + numeric.friction_rows.T @ T
    driven = numeric.input_rows.T @ np.array([torque, -2.0 * torque])
    assert balance == pytest.approx(driven, abs=1e-6 * max(1.0, abs(torque)))


def trace(built: Rig, step: float) -> np.ndarray:
    """Return the speeds of both machines over a shift from first to second gear, every millisecond."""
    plant = built.plant
    params = plant.parameters({"sample_time": step})
    _, state = plant.init(params)
    turn(built, state, "1", 30.0)
    outputs, recorded = plant.measure(state, params), []
    course = shift_course(["1", "2"], 0.1, 0.05, (np.arange(round(0.16 / step)) + 0.5) * step)
    for k, levels in enumerate(course):
        inputs = {"M1_torque_ref": 100.0, "M2_torque_ref": 400.0 * (30.0 - outputs["M2_speed"])}
        inputs |= {f"gears_{name}_actuation": level for name, level in zip(ELEMENTS, levels, strict=True)}
        status, outputs = plant.step(state, params, inputs)
        assert status == 0, plant.status_text(status)
        if (k + 1) % round(1e-3 / step) == 0:
            recorded.append([outputs["M1_speed"], outputs["M2_speed"]])
    return np.array(recorded)


def flexible(factor: float) -> str:
    values = ", ".join(
        f'"{m}.stiffness" = "{500 * factor} kN m/rad", "{m}.damping" = "{50 * factor**0.5} N m s/rad"' for m in MEMBERS
    )
    return f'model = "flexible"\nvalues = {{ {values} }}'


def test_flexible_model_tends_to_the_rigid_one_as_its_joints_grow_stiff() -> None:
    """The difference falls like 1/c, as the twist of a shaft under a given torque does."""
    rigid = trace(rig("20 us"), 2e-5)
    apart = [np.abs(trace(rig("20 us", flexible(factor)), 2e-5) - rigid).max() for factor in (1.0, 4.0, 16.0)]
    assert apart[0] / apart[1] == pytest.approx(4.0, rel=0.3)
    assert apart[1] / apart[2] == pytest.approx(4.0, rel=0.3)
    assert apart[2] < 2e-3 * rigid.max()

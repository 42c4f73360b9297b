"""The plant with a torque converter: stall, steady states, lock-up, power, and order two against SciPy's DOP853."""

from __future__ import annotations

import ctypes
import functools
import tempfile
from pathlib import Path

import numpy as np
import pytest
from plant.converter_bed import converter, converter_bed, converter_model
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from ptgen.emit.block_files import block_files, common_context
from ptgen.errors import ControlError
from ptgen.friction.event_fluid import EventFluid
from ptgen.friction.events import EventDriven
from ptgen.mechanism.model import Model
from ptgen.plant.plant import plant_block
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.compiler import compile_library
from ptgen.simulate.library import CompiledBlock

pytestmark = pytest.mark.compile

H = 1e-4
REFERENCE = 2000 * np.pi / 30
HELD = 1e9  # kg m^2


@functools.cache
def compiled(lockup: bool) -> tuple[Model, CompiledBlock]:
    """Return the model of a converter alone, and its plant."""
    model = converter_model(converter() if lockup else converter(lockup=None))
    block, folder = plant_block(model, H), Path(tempfile.mkdtemp(prefix="ptgen-converter-"))
    for file, text in block_files([block], common_context("loose", "converter", "0" * 16, "double")).items():
        (folder / file).write_text(text)
    compile_library(sorted(folder.glob("*.c")), folder / "loose.so")
    return model, CompiledBlock(block, "loose", ctypes.CDLL(str(folder / "loose.so")), "double")


class Loose:
    """A converter alone, step by step."""

    def __init__(self, pump: float, turbine: float, step: float = H, lockup: bool = True, **parameters: float) -> None:
        self.model, self.plant = compiled(lockup)
        self.params = self.plant.parameters({"sample_time": step, **parameters})
        status, self.state = self.plant.init(self.params)
        assert status == 0, self.plant.status_text(status)
        self.rows = np.array(
            [[float(entry) for entry in self.model.velocity_rows[f"tc.{side}"]] for side in ("pump", "turbine")]
        )
        x = self.plant.read(self.state, "x")
        x[:2] = self.start = np.linalg.solve(self.rows, [pump, turbine])
        self.plant.write(self.state, "x", x)
        self.inputs = {"tc_lockup_actuation": 0.0} if lockup else {}

    def step(self, pump: float = 0.0, turbine: float = 0.0, actuation: float | None = None) -> dict[str, float]:
        given = {**self.inputs, **({} if actuation is None else {"tc_lockup_actuation": actuation})}
        status, outputs = self.plant.step(
            self.state, self.params, {"P_torque_ref": pump, "T_torque_ref": turbine, **given}
        )
        assert status == 0
        return outputs

    @property
    def speeds(self) -> np.ndarray:
        return self.rows @ self.plant.read(self.state, "x")[:2]


FLUID = EventFluid(converter().elements("tc").fluids[0], REFERENCE)


@pytest.mark.parametrize("pump", [50.0, REFERENCE, 400.0])
def test_stall_torque(pump: float) -> None:
    outputs = Loose(pump, 0.0, tc_inertia_pump=HELD, tc_inertia_turbine=HELD).step()
    scale = (pump / REFERENCE) ** 2
    assert outputs["tc_fluid_pump_torque"] == pytest.approx(180 * scale, rel=1e-6)
    assert outputs["tc_fluid_turbine_torque"] == pytest.approx(360 * scale, rel=1e-6)


@pytest.mark.parametrize("lockup", [True, False])
def test_nothing_moves_at_rest(lockup: bool) -> None:
    loose = Loose(0.0, 0.0, lockup=lockup)
    for _ in range(5):
        outputs = loose.step()
    assert loose.speeds.tolist() == [0.0, 0.0]
    assert outputs["tc_fluid_pump_torque"] == outputs["tc_fluid_turbine_torque"] == 0.0


@pytest.mark.parametrize("pump", [-200.0, 120.0, 350.0])
@pytest.mark.parametrize("load", [0.2, 1.5])
def test_steady_state_is_where_the_maps_meet_the_load(pump: float, load: float) -> None:
    """A pump that is kept at its speed against a load that grows with the speed of the turbine."""
    loose = Loose(pump, 0.0, tc_inertia_pump=HELD)
    for _ in range(20000):
        outputs = loose.step(turbine=-load * loose.speeds[1])
    expected = brentq(lambda w: FLUID.torques(pump, w)[1] - load * w, -1.0 * abs(pump), 1.0 * abs(pump), xtol=1e-12)
    assert loose.speeds[1] == pytest.approx(expected, rel=1e-6)
    assert outputs["tc_fluid_turbine_torque"] == pytest.approx(load * expected, rel=1e-6)
    assert outputs["tc_fluid_pump_torque"] == pytest.approx(FLUID.torques(pump, expected)[0], rel=1e-6)


def test_locked_it_is_two_inertias_on_one_shaft() -> None:
    """(3.40) and (3.41) with one speed: the fluid has no torque, the clutch carries what the turbine needs."""
    loose, I_p, I_t, T_1, T_2 = Loose(30.0, 30.0), 0.1, 0.05, 150.0, 60.0
    for k in range(200):
        outputs = loose.step(T_1, -T_2, actuation=1.0)
        assert loose.speeds[0] == loose.speeds[1]
        assert loose.speeds[0] == pytest.approx(30.0 + (T_1 - T_2) / (I_p + I_t) * (k + 1) * H, rel=1e-9)
    assert outputs["tc_lockup_torque"] == pytest.approx((I_t * T_1 + I_p * T_2) / (I_p + I_t))
    assert abs(outputs["tc_fluid_pump_torque"]) < 1e-9 and abs(outputs["tc_fluid_turbine_torque"]) < 1e-9


def test_lock_up_engages_within_the_run() -> None:
    loose = Loose(200.0, 120.0)
    for _ in range(3000):
        outputs = loose.step(100.0, -100.0, actuation=0.5)
    assert outputs["tc_lockup_speed"] == 0.0
    assert outputs["tc_lockup_torque"] == pytest.approx(100.0)


@pytest.mark.parametrize(("pump", "turbine"), [(200.0, -150.0), (60.0, 220.0), (-180.0, 90.0), (-50.0, -160.0)])
def test_input_work_is_kinetic_energy_and_heat(pump: float, turbine: float) -> None:
    loose, inertias = Loose(pump, turbine), np.array([0.1, 0.05])
    T = np.array([40.0, -15.0])
    energy = [0.5 * inertias @ loose.speeds**2]
    powers = [[T @ loose.speeds, FLUID.torques(*loose.speeds) @ (loose.speeds * [1, -1])]]
    for _ in range(2000):
        outputs = loose.step(*T)
        torques = np.array([outputs["tc_fluid_pump_torque"], -outputs["tc_fluid_turbine_torque"]])
        powers.append([T @ loose.speeds, torques @ loose.speeds])
        energy.append(0.5 * inertias @ loose.speeds**2)
    assert min(heat for _, heat in powers) >= -1e-9
    work, heat = np.trapezoid(powers, dx=H, axis=0)
    assert heat > 100
    assert work == pytest.approx(energy[-1] - energy[0] + heat, abs=2e-6 * (energy[0] + heat))


# --- order

CASES = {
    "drive": (150.0, 20.0),
    "from reverse to drive": (120.0, -260.0),
    "from coast to drive": (40.0, 200.0),
    "both backward": (-30.0, -220.0),
}


def reference(start: tuple[float, float], T: np.ndarray, end: float) -> np.ndarray:
    inertias = np.array([0.1, 0.05])

    def rates(_: float, w: np.ndarray) -> np.ndarray:
        T_p, T_t = FLUID.torques(*w)
        return (T + np.array([-T_p, T_t])) / inertias

    return solve_ivp(rates, (0.0, end), start, "DOP853", rtol=1e-12, atol=1e-12, max_step=1e-3).y[:, -1]


@pytest.mark.parametrize("case", CASES)
def test_order_two(case: str) -> None:
    start, end = CASES[case], 0.2
    T = np.array([90.0, -20.0])
    expected = reference(start, T, end)
    errors = []
    for step in (2e-3, 1e-3, 5e-4):
        loose = Loose(*start, step)
        for _ in range(round(end / step)):
            loose.step(*T)
        errors.append(np.abs(loose.speeds - expected).max())
    assert errors[0] < 0.05
    assert errors[0] / errors[2] > 12, errors


@pytest.mark.parametrize("case", CASES)
def test_event_driven_reference_has_the_same_fluid(case: str) -> None:
    start, end = CASES[case], 0.1
    loose = Loose(*start)
    simulation, T = EventDriven(loose.model), np.array([90.0, -20.0])
    state = simulation.initial(loose.start)
    state = simulation.advance(state, end, T, {"tc.lockup": 0.0})
    found = loose.rows @ state.x
    assert found == pytest.approx(reference(start, T, end), rel=1e-8)
    assert state.contact_torque == pytest.approx(FLUID.torques(*found), rel=1e-6)


def test_lock_up_and_fluid_together_against_events() -> None:
    loose = Loose(180.0, 60.0)
    simulation, T = EventDriven(loose.model), np.array([90.0, -60.0])
    state = simulation.advance(simulation.initial(loose.start), 0.1, T, {"tc.lockup": 0.6})
    for _ in range(1000):
        loose.step(*T, actuation=0.6)
    assert loose.speeds[0] == loose.speeds[1] and state.mode.tolist() == [0]
    assert loose.speeds == pytest.approx(loose.rows @ state.x, abs=1e-3)


# --- in a bed


def test_torque_at_the_pump_flange_is_that_of_3_40(tmp_path: Path) -> None:
    plant = build(converter_bed(tmp_path, place="tc.pump")).plant
    params = plant.defaults()
    _, state = plant.init(params)
    names, rows = plant.block.declared("x").entries, []
    pump = next(k for k, name in enumerate(names) if "flange1.uut" in name)
    for k in range(6000):
        inputs = {"M1_torque_ref": 300.0, "M2_torque_ref": -100.0, "tc_lockup_actuation": 0.05 * (k > 4000)}
        _, outputs = plant.step(state, params, inputs)
        rows.append((plant.read(state, "x")[pump], outputs))
    for k in (3900, 5000, 5900):
        rate = (rows[k + 1][0] - rows[k - 1][0]) / (2 * H)
        outputs = rows[k][1]
        T_1 = 0.1 * rate + outputs["tc_lockup_torque"] + outputs["tc_fluid_pump_torque"]
        assert outputs["tc_fluid_pump_torque"] > 10
        assert outputs["tc_pump_torque"] == pytest.approx(T_1, rel=1e-2)


def test_linear_analyses_leave_the_fluid_out(tmp_path: Path) -> None:
    project = converter_bed(tmp_path)
    assert project.plant_model.fluids and not project.model.fluids
    assert not project.reduced.model.fluids and not project.reduced.full.fluids
    rules = {(rule.rule, rule.element) for rule in project.reduced.rules}
    assert {("leave out", "tc.fluid"), ("lock", "tc.lockup")} <= rules
    assert len(project.reduced.model.coordinates) == 2


def test_an_open_converter_parts_the_bed_for_control(tmp_path: Path) -> None:
    converter_bed(tmp_path)
    file = tmp_path / "bed.toml"
    file.write_text(file.read_text(encoding="utf-8").replace('locked = ["tc.lockup"]\n', ""), encoding="utf-8")
    with pytest.raises(ControlError, match=r'reduction. locked = ."tc.lockup"'):
        _ = Project.read(file).controller

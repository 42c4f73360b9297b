"""Speed control: Hanus's conditioning, the disturbance observer, and the experimental super-twisting."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from controller_steps import Compiled, Controller
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanism.bed_text import Bed, two_machines

from ptgen.emit.project import project_files
from ptgen.project import Project
from ptgen.simulate.build import build
from ptgen.simulate.library import Library

pytestmark = pytest.mark.compile

H = 1e-4
I_M2 = 2.0


def bed(kind: str, **control: object) -> Bed:
    made = two_machines(["flange1", "shaft1", "flange2"])
    for name in ("flange1", "flange2"):
        made.add(name, "torque_flange", inertia=0.03, stiffness=380e3)
    made.add("shaft1", "shaft", stiffness=20e3)
    made.control = {"speed_control": kind, **control}
    return made


@cache
def project(kind: str) -> Project:
    return Project(bed(kind).load())


@cache
def strong_project() -> Project:
    """Return the same bed with a machine that is never at its limit: no parameter allows more than the file."""
    made = bed("pi")
    made.components["M2"]["torque_max"] = 1e12
    return Project(made.load())


@cache
def library(kind: str) -> Library:
    return build(project(kind))


def controller(kind: str, **changes: float) -> Controller:
    return Controller(project(kind).controller, changes)


class Rotor:
    """The rotor of M2 alone with a held torque, exactly, under its controller with ideal load torque compensation."""

    def __init__(self, kind: str, **changes: float) -> None:
        self.controller, self.speed, self.torque = Compiled(library(kind), changes), 0.0, 0.0

    def run(self, steps: int, reference: float, disturbance: np.ndarray | float = 0.0) -> np.ndarray:
        speeds = np.empty(steps)
        loads = np.broadcast_to(disturbance, steps)
        for k in range(steps):
            speeds[k] = self.speed
            self.torque = self.controller.step(M2_speed_ref=reference, M2_speed=self.speed)["M2_torque_ref"]
            self.speed += H / I_M2 * (self.torque - float(loads[k]))
        return speeds


numbers = st.floats(-1, 1)


@settings(max_examples=100)
@given(numbers, numbers, numbers, numbers, st.floats(0, 1))
def test_the_integrator_gets_the_realisable_reference(
    wanted: float, speed: float, load: float, integral: float, share: float
) -> None:
    """Hanus: given the reference w + (u_r - u) / k_p, a controller without limits asks for u_r and ends the same."""
    limited = controller("pi", load_compensation=share)
    free = Controller(strong_project().controller, {"load_compensation": share})
    measured = {"M2_speed": 60 * speed, "flange2_torque": 2000 * load}
    for each in (limited, free):
        each.step(M2_speed_ref=60 * speed, **measured)
        each.states["M2_speed_integral"] = np.array(3000 * integral)
    reference = 60 * speed + 60 * wanted
    gain = float(limited.parameters["M2_speed_gain"])
    asked = gain * (reference - 60 * speed) + 3000 * integral
    command = limited.step(M2_speed_ref=reference, **measured)["M2_torque_ref"]
    realised = command + share * measured["flange2_torque"]
    assert abs(command) <= 1000.0
    realisable = reference + (realised - asked) / gain
    assert free.step(M2_speed_ref=realisable, **measured)["M2_torque_ref"] == pytest.approx(command, abs=1e-8)
    assert free.state("M2_speed_integral") == pytest.approx(limited.state("M2_speed_integral"), abs=1e-8)


@pytest.mark.parametrize("b", [0.0, 7.5, 1e3, 1e6, 1e12])
def test_observer_is_the_z_form_and_decays_whatever_the_bandwidth(b: float) -> None:
    """(5.90), (5.91) with the held torque of the sampled rotor: the error shrinks by 1 / (1 + h b) in every step."""
    rotor, load = Rotor("observer", M2_observer_bandwidth=b), 120.0
    a, beta = 1 / (1 + H * b), b / (1 + H * b)
    z = 0.0
    for k in range(60):
        before = rotor.speed
        rotor.run(1, 20.0, load)
        estimate = z - beta * I_M2 * before
        asked = rotor.controller.parameters.M2_speed_gain * (20.0 - before) + estimate
        assert rotor.torque == pytest.approx(np.clip(asked, -1000, 1000), rel=1e-9, abs=1e-6)
        assert estimate == pytest.approx(load * (1 - a**k), rel=1e-6, abs=1e-5)
        z = a * z + (1 - a) * (rotor.torque + beta * I_M2 * before)


def test_observer_does_not_wind_up() -> None:
    """After a second at the torque limit it knows the disturbance, no more, and the speed does not overshoot."""
    rotor = Rotor("observer")
    rotor.run(4000, 200.0, 150.0)
    assert rotor.torque == 1000.0
    bandwidth = project("observer").design.gains.observer_bandwidth["M2"]
    assert rotor.controller.state("M2_observer") == pytest.approx(150.0 * (1 - np.exp(-bandwidth * 0.4)), rel=1e-2)
    speeds = rotor.run(9000, 200.0, 150.0)
    assert speeds.max() < 200.5 and speeds[-1] == pytest.approx(200.0, abs=0.1)


def test_observer_bandwidth_may_change_while_the_machine_turns() -> None:
    rotor = Rotor("observer")
    rotor.run(8000, 100.0, 50.0)
    before = rotor.torque
    rotor.controller.set({"M2_observer_bandwidth": 40.0})
    rotor.run(1, 100.0, 50.0)
    assert rotor.torque == pytest.approx(before, abs=0.5)


def test_observer_and_pi_leave_the_same_area_after_a_disturbance() -> None:
    """Without further choice the observer's bandwidth is k_i / k_p: the area is d / k_i with both."""
    gains, load = project("pi").design.gains, 200.0
    assert gains.observer_bandwidth["M2"] == pytest.approx(gains.speed_integral["M2"] / gains.speed["M2"])
    for kind in ("pi", "observer"):
        area = -H * Rotor(kind).run(15000, 0.0, load).sum()
        assert area == pytest.approx(load / gains.speed_integral["M2"], rel=0.01), kind


def test_super_twisting_follows_a_growing_disturbance() -> None:
    """Less than half of the error of the PI controller is left, and the code says that it is experimental."""
    ramp = 400.0 * H * np.arange(10000)
    rest = {kind: abs(Rotor(kind).run(10000, 0.0, ramp)[-1]) for kind in ("pi", "super_twisting")}
    assert rest["pi"] == pytest.approx(400.0 / project("pi").design.gains.speed_integral["M2"], rel=0.02)
    assert rest["super_twisting"] < 0.5 * rest["pi"]
    emitted = "".join(t for t in project_files(project("super_twisting")).values() if isinstance(t, str))
    assert "EXPERIMENTAL" in emitted


def test_super_twisting_does_not_wind_up() -> None:
    rotor = Rotor("super_twisting")
    speeds = rotor.run(14000, 150.0)
    assert 149.0 < speeds[-1] < 151.0 and speeds.max() < 1.135 * 150.0


def test_each_machine_may_have_its_own_kind(projects: dict[str, Project]) -> None:
    from mechanism.bed_text import differential_bed

    made = differential_bed()
    made.control = {"speed_control": {"M2": "observer"}}
    names = {s.name for s in Project(made.load()).controller.states}
    assert {"M2_observer", "M3_speed_integral"} <= names and not {"M3_observer", "M2_speed_integral"} & names

"""The general procedure gives Section 5.7 of the source for its bed: matrices, polynomials, conditions, ranges."""

from __future__ import annotations

import pytest
import sympy as sp
from analysis.proof_beds import (
    Im1,
    Im2,
    c,
    d_des,
    g_t,
    g_w,
    geared,
    igb,
    in_source,
    is_zero,
    kff,
    ki1,
    ki2,
    kp1,
    kp2,
    s,
    switched,
)

from ptgen.analysis.characteristic import Factor, characteristic_factors
from ptgen.analysis.continuous_proof import continuous_proof
from ptgen.analysis.stability_conditions import (
    Condition,
    closed_form_ranges,
    hurwitz_determinant,
    real_pole_condition,
    stability_conditions,
)
from ptgen.analysis.symbolic_loop import LoopKind, SymbolicLoop, symbolic_loop
from ptgen.project import Project

CUBIC = s**3 + d_des / Im1 * s**2 + c * (1 + kp1) / Im1 * s + ki1 * c / Im1
QUADRATIC = s**2 + kp2 / Im2 * s + ki2 / Im2


@pytest.fixture(scope="module", params=["geared", "back_to_back"])
def bed(request: pytest.FixtureRequest, projects: dict[str, Project]) -> tuple[Project, dict[sp.Symbol, int]]:
    """The bed of Section 5.7, and the shipped one, whose ratio is one."""
    return (geared(), {}) if request.param == "geared" else (projects["back_to_back"], {igb: 1})


def open_loop(project: Project) -> SymbolicLoop:
    return symbolic_loop(project.design.decoupling, torque_loops=False)


def polynomial(factors: tuple[Factor, ...]) -> sp.Expr:
    return in_source(sp.Mul(*[factor.polynomial(s) for factor in factors]))


def test_states_and_references_are_those_of_the_source() -> None:
    loop = symbolic_loop(geared().design.decoupling)
    assert loop.states[:3] == ("M1.shaft", "M2.shaft", "twist shaft1")
    assert loop.states[3:] == ("integrator of the speed loop of M2", "integrator of the torque loop of M1")
    assert loop.references == ("shaft1", "M2_speed")
    assert open_loop(geared()).references == ("v_M1", "M2_speed")


def test_closed_speed_loop(bed: tuple[Project, dict[sp.Symbol, int]]) -> None:
    """(5.104), with neither damping nor acceleration torque."""
    project, ratio = bed
    loop = open_loop(project)
    off = {symbol: 0 for symbol in loop.A.free_symbols if symbol.name in ("M1_damping", "acceleration_torque")}
    A1 = sp.Matrix(
        [
            [0, 0, -c / Im1, 0],
            [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2],
            [1, -igb, 0, 0],
            [0, -ki2, 0, 0],
        ]
    )
    B1 = sp.Matrix([[1 / Im1, 0], [0, kp2 / Im2], [0, 0], [0, ki2]])
    assert is_zero(in_source(loop.at(off).A) - A1.subs(ratio))
    assert is_zero(in_source(loop.at(off).B) - B1.subs(ratio))


def test_closed_speed_loop_with_damping_and_acceleration_torque(bed: tuple[Project, dict[sp.Symbol, int]]) -> None:
    """(5.108), with the entry that only the acceleration gives."""
    project, ratio = bed
    loop = open_loop(project)
    A1 = sp.Matrix(
        [
            [
                -d_des / Im1,
                igb * d_des / Im1 - g_t * igb * kp2 / Im2,
                g_t * (1 - g_w) * igb**2 * c / Im2 - c / Im1,
                g_t * igb / Im2,
            ],
            [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2],
            [1, -igb, 0, 0],
            [0, -ki2, 0, 0],
        ]
    )
    B1 = sp.Matrix([[1 / Im1, g_t * igb * kp2 / Im2], [0, kp2 / Im2], [0, 0], [0, ki2]])
    assert is_zero(in_source(loop.A) - A1.subs(ratio))
    assert is_zero(in_source(loop.B) - B1.subs(ratio))


def test_both_loops_closed(bed: tuple[Project, dict[sp.Symbol, int]]) -> None:
    """(5.113)."""
    project, ratio = bed
    loop = symbolic_loop(project.design.decoupling)
    A2 = sp.Matrix(
        [
            [
                -d_des / Im1,
                igb * d_des / Im1 - g_t * igb * kp2 / Im2,
                g_t * (1 - g_w) * igb**2 * c / Im2 - c / Im1 - kp1 * c / Im1,
                g_t * igb / Im2,
                1 / Im1,
            ],
            [0, -kp2 / Im2, (1 - g_w) * igb * c / Im2, 1 / Im2, 0],
            [1, -igb, 0, 0, 0],
            [0, -ki2, 0, 0, 0],
            [0, 0, -ki1 * c, 0, 0],
        ]
    )
    B2 = sp.Matrix(
        [[(kff + kp1) / Im1, g_t * igb * kp2 / Im2], [0, kp2 / Im2], [0, 0], [0, ki2], [ki1, 0]],
    )
    assert is_zero(in_source(loop.A) - A2.subs(ratio))
    assert is_zero(in_source(loop.B) - B2.subs(ratio))


def test_polynomial_without_decoupling(bed: tuple[Project, dict[sp.Symbol, int]]) -> None:
    """(5.105) for any share of load compensation, and what makes it stable without any."""
    project, ratio = bed
    loop = open_loop(project)
    off = {symbol: 0 for symbol in loop.A.free_symbols if symbol.name in ("M1_damping", "acceleration_torque")}
    (factor,) = characteristic_factors(loop.at(off))
    printed = (
        s**4
        + kp2 / Im2 * s**3
        + (ki2 / Im2 + c / Im1 + (1 - g_w) * igb**2 * c / Im2) * s**2
        + c * kp2 / (Im1 * Im2) * s
        + c * ki2 / (Im1 * Im2)
    )
    assert factor.loops == ("torque loop of M1", "speed loop of M2")
    assert is_zero(in_source(factor.polynomial(s)) - printed.subs(ratio))
    coefficients = [sp.sympify(in_source(value)).subs(g_w, 0) for value in factor.coefficients]
    conditions = stability_conditions(coefficients, (kp2, ki2))
    assert [condition.expression for condition in conditions] == [kp2, ki2]
    assert is_zero(hurwitz_determinant(coefficients, 3) - (igb**2 * c**2 * kp2**2 / (Im1 * Im2**3)).subs(ratio))


def test_load_compensation_takes_damping_from_the_torque(bed: tuple[Project, dict[sp.Symbol, int]]) -> None:
    """(5.106): two zeros on the imaginary axis, whatever the speed control does."""
    loop = open_loop(bed[0])
    off = {symbol: 0 for symbol in loop.A.free_symbols if symbol.name in ("M1_damping", "acceleration_torque")}
    torque, speed = characteristic_factors(switched(loop.at(off), 1, 0))
    assert is_zero(in_source(torque.polynomial(s)) - (s**2 + c / Im1))
    assert is_zero(in_source(speed.polynomial(s)) - QUADRATIC)
    assert stability_conditions(torque.coefficients, ())[0].expression == 0


@pytest.mark.parametrize("switches", [(1, 1), (1, 0), (0, 1)])
def test_one_measure_decouples_the_polynomial(
    bed: tuple[Project, dict[sp.Symbol, int]], switches: tuple[int, int]
) -> None:
    """(5.109), (5.114): with the acceleration, not with its reference value, either measure does it."""
    torque, speed = characteristic_factors(switched(open_loop(bed[0]), *switches))
    assert is_zero(in_source(torque.polynomial(s)) - (s**2 + d_des / Im1 * s + c / Im1))
    assert is_zero(in_source(speed.polynomial(s)) - QUADRATIC)
    torque, speed = characteristic_factors(switched(symbolic_loop(bed[0].design.decoupling), *switches))
    assert (torque.loops, speed.loops) == (("torque loop of M1",), ("speed loop of M2",))
    assert is_zero(in_source(torque.polynomial(s)) - CUBIC)
    assert is_zero(in_source(speed.polynomial(s)) - QUADRATIC)


def test_damping_alone_does_not_decouple(bed: tuple[Project, dict[sp.Symbol, int]]) -> None:
    factors = characteristic_factors(switched(symbolic_loop(bed[0].design.decoupling), 0, 0))
    assert [factor.degree for factor in factors] == [5]


def test_admissible_gains_in_closed_form() -> None:
    """(5.110), (5.115)."""
    gains = (d_des, kp1, ki1)
    free = sp.Symbol("d_des", nonnegative=True)
    cubic = [value.subs(d_des, free) for value in sp.Poly(CUBIC, s).all_coeffs()]
    conditions = stability_conditions(cubic, (free, kp1, ki1))
    ranges = {item.gain: item for item in closed_form_ranges(conditions, (free, kp1, ki1))}
    assert (ranges[free].lower, ranges[free].upper) == (0, None)
    assert (ranges[kp1].lower, ranges[kp1].upper) == (-1, None)
    assert ranges[ki1].lower == 0
    assert is_zero(ranges[ki1].upper - free / Im1 * (1 + kp1))
    assert gains[0].is_positive  # that is why another symbol has to stand for the damping above
    quadratic = sp.Poly(QUADRATIC, s).all_coeffs()
    conditions = stability_conditions(quadratic, (kp2, ki2))
    real = real_pole_condition(quadratic, (kp2, ki2))
    assert real is not None
    (bound,) = closed_form_ranges((real,), (kp2, ki2), conditions)
    assert bound.gain == ki2
    assert is_zero(bound.upper - kp2**2 / (4 * Im2))


def test_the_proof_of_the_bed_carries_these_ranges(projects: dict[str, Project]) -> None:
    project = projects["back_to_back"]
    proof = continuous_proof(project.design, project.reduced)
    torque, speed = proof.setting("decoupling").factors
    damping, proportional, integral = torque.gains
    assert (damping.closed_form.lower, proportional.closed_form.lower, integral.closed_form.lower) == (0, -1, 0)
    assert is_zero(in_source(integral.closed_form.upper) - d_des / Im1 * (1 + kp1))
    value = project.design.gains.damping["M1"] / 5.0
    assert integral.intervals == ((0.0, pytest.approx(value)),)
    assert speed.gains[1].real_poles is not None
    assert is_zero(in_source(speed.gains[1].real_poles) - kp2**2 / (4 * Im2))
    assert all(gain.is_admissible for factor in (torque, speed) for gain in factor.gains)


def test_without_damping_no_integral_torque_gain_is_stable(projects: dict[str, Project]) -> None:
    """What the text after (5.115) says, of k_i1."""
    project = projects["back_to_back"]
    loop = symbolic_loop(project.design.decoupling)
    damping = project.design.decoupling.damping[0]
    factors = characteristic_factors(switched(loop.at({damping: 0}), 1, 1))
    gains = [gain for gain in loop.gains if gain != damping]
    conditions = stability_conditions(factors[0].coefficients, gains)
    assert Condition(sp.Integer(0), "coefficient of s^2") in conditions


def test_observer_splits_the_speed_loop() -> None:
    """(5.85)-(5.93): the poles are those of the observer and of the P control, and never complex."""
    loop = symbolic_loop(geared().design.decoupling, speed_control=LoopKind.SPEED_OBSERVER)
    rate = sp.Symbol("M2_observer_bandwidth", real=True)
    factors = characteristic_factors(switched(loop, 1, 1))
    speed = [in_source(factor.polynomial(s)) for factor in factors if factor.loops == ("speed loop of M2",)]
    assert len(speed) == 2
    assert is_zero(sp.expand(sp.Mul(*speed) - (s + rate) * (s + kp2 / Im2)))

"""Torques, losses and power flow in gears, against closed forms and the balance of every member."""

from __future__ import annotations

import pytest
from gear_layouts import NINE_SPEED_GEARS, NINE_SPEED_TEETH, Gearing, dual_clutch, nine_speed

from ptgen.gears import Gear, GearAnalysis, Layout, analyse_gears
from ptgen.gears.statics import Balance, balance

ETA = 0.98


@pytest.fixture(scope="module")
def found() -> GearAnalysis:
    return analyse_gears(nine_speed(loss=1 - ETA), NINE_SPEED_GEARS)


def balances(gear: Gear) -> list[Balance]:
    assert gear.drive is not None and gear.coast is not None
    return [gear.ideal, gear.drive, gear.coast]


def residuals(layout: Layout, one: Balance) -> dict[str, float]:
    """Return what does not balance on each member."""
    rest = dict.fromkeys(layout.members, 0.0)
    rest[layout.input] += one.input_torque
    rest[layout.output] -= one.output_torque
    for train in layout.trains:
        for flange, torque in one.trains[train.name].torques.items():
            rest[train.members[flange]] -= torque
    for element in layout.elements:
        for member, factor in element.row.items():
            rest[member] -= one.elements.get(element.name, 0.0) * float(factor)
    return rest


@pytest.mark.parametrize("gear", [name for name in NINE_SPEED_GEARS if name != "N"])
def test_torques_balance_on_every_member(found: GearAnalysis, gear: str) -> None:
    own = found.gear(gear)
    assert own is not None
    for one in balances(own):
        assert max(map(abs, residuals(found.layout, one).values())) < 1e-9
        for load in one.trains.values():
            assert sum(load.torques.values()) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("gear", [name for name in NINE_SPEED_GEARS if name != "N"])
def test_what_the_teeth_lose_is_what_does_not_come_out(found: GearAnalysis, gear: str) -> None:
    own = found.gear(gear)
    assert own is not None
    assert own.ideal.output_torque == pytest.approx(float(own.ratio))
    assert own.ideal.efficiency == pytest.approx(1.0)
    for one in balances(own)[1:]:
        lost = sum(power or 0.0 for load in one.trains.values() for power in load.powers.values())
        put_in = 1.0 if one.input_torque > 0 else -one.output_torque / float(own.ratio)
        assert lost == pytest.approx(put_in * (1 - one.efficiency), abs=1e-9)
        assert one.consistent == 1
        for load in one.trains.values():
            rolling = abs(load.rolling_power)
            share = (1 - ETA) if load.rolling_power > 0 else 1 / ETA - 1
            assert sum(power or 0.0 for power in load.powers.values()) == pytest.approx(share * rolling, abs=1e-9)


def test_block_loses_nothing(found: GearAnalysis) -> None:
    sixth = found.gear("6")
    assert sixth is not None and sixth.drive is not None
    assert sixth.drive.efficiency == pytest.approx(1.0, abs=1e-12)


def test_reduction_with_held_ring_in_closed_form(found: GearAnalysis) -> None:
    """Second gear is set 3 with its ring held: the sun drives, T_c = T_s (1 + g eta)."""
    second = found.gear("2")
    assert second is not None and second.drive is not None and second.coast is not None
    g = NINE_SPEED_TEETH["P3"][1] / NINE_SPEED_TEETH["P3"][0]
    assert second.drive.efficiency == pytest.approx((1 + g * ETA) / (1 + g))
    assert second.coast.efficiency == pytest.approx((1 + g) / (1 + g / ETA))


def test_overdrive_with_held_sun_in_closed_form(found: GearAnalysis) -> None:
    """Eighth gear is set 4 with its sun held: the carrier drives the ring, and the rolling power flows to the ring."""
    eighth = found.gear("8")
    assert eighth is not None and eighth.drive is not None
    g = NINE_SPEED_TEETH["P4"][1] / NINE_SPEED_TEETH["P4"][0]
    # T_r = -g T_s eta, T_c = -(T_s + T_r): out over in is (T_r / T_c) (omega_r / omega_c).
    assert eighth.drive.efficiency == pytest.approx((g * ETA / (1 + g * ETA)) * (1 + g) / g)


def test_pairs_in_series_multiply_their_efficiencies() -> None:
    gearing = Gearing()
    gearing.pair("G1", 20, 40, loss=0.01)
    gearing.pair("G2", 25, 75, loss=0.02)
    gearing.clutch("K")
    gearing.member("input", "K.input")
    gearing.member("shaft", "K.output", "G1.input")
    gearing.member("layshaft", "G1.output", "G2.input")
    gearing.member("output", "G2.output")
    (gear,) = analyse_gears(gearing.layout()).gears
    assert float(gear.ratio) == 6.0 and str(gear.formula) == "i1*i2"
    assert gear.drive is not None and gear.coast is not None
    assert gear.drive.efficiency == pytest.approx(0.99 * 0.98)
    assert gear.coast.efficiency == pytest.approx(0.99 * 0.98)


def test_elements_side_by_side_share_the_torque_by_least_norm_and_it_is_said() -> None:
    gearing = Gearing()
    gearing.clutch("K1", "K2")
    gearing.member("input", "K1.input", "K2.input")
    gearing.member("output", "K1.output", "K2.output")
    layout = gearing.layout()
    assert [gear.engaged for gear in analyse_gears(layout).gears] == [("K1",), ("K2",)]
    both = balance(layout, ("K1", "K2"), {"input": 1.0, "output": 1.0}, losses=False)
    assert both is not None
    assert dict(both.elements) == pytest.approx({"K1": 0.5, "K2": 0.5})
    assert both.undetermined == ("K1", "K2")


def test_self_locking_gear_has_no_coast() -> None:
    """A set with nearly equal gears, driven at the carrier's side of a huge reduction, cannot be driven back."""
    gearing = Gearing()
    gearing.set("P1", 99, 100, loss=0.02, double=True)
    gearing.brake("B")
    gearing.member("input", "P1.carrier")
    gearing.member("held", "P1.ring", "B.left")
    gearing.member("output", "P1.sun")
    (gear,) = analyse_gears(gearing.layout()).gears
    assert abs(float(gear.ratio)) > 90
    assert gear.drive is not None and gear.drive.efficiency < 0.5
    assert gear.coast is None


def test_power_circulates_where_a_clutch_carries_more_than_comes_in(found: GearAnalysis) -> None:
    fifth = found.gear("5")
    second = found.gear("2")
    assert fifth is not None and second is not None
    assert fifth.ideal.recirculating > 0.5 and "P4" in fifth.ideal.circle
    assert second.ideal.recirculating == 0.0 and second.ideal.circle == ()


def test_torques_of_nine_speed_elements_by_hand(found: GearAnalysis) -> None:
    """In second gear D closes the lever of set 1: its carrier takes all, so D carries -T_ring of set 1 and so on."""
    second = found.gear("2")
    assert second is not None
    g3 = 84 / 36
    assert second.ideal.elements["C"] == pytest.approx(-g3)  # the ring is pushed backwards: T_r = -g T_s... held
    assert second.ideal.elements["D"] == pytest.approx(1.0)
    assert second.ideal.elements["E"] == pytest.approx(-1.0)  # from the carrier to the member b, against its sense


def test_dual_clutch_carries_the_whole_torque() -> None:
    found = analyse_gears(dual_clutch())
    for gear in found.gears:
        clutch = next(name for name in gear.engaged if name.startswith("K"))
        assert gear.ideal.elements[clutch] == pytest.approx(1.0)

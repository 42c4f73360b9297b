"""Bad shift tables and bad layouts: each problem names the part, the element and a remedy."""

from __future__ import annotations

from gear_layouts import NINE_SPEED_GEARS, Gearing, nine_speed

from ptgen.gears import gear_ratios, shift_table_problems


def texts(table: dict[str, list[str]]) -> list[str]:
    return [problem.text() for problem in shift_table_problems(nine_speed(), table)]


def test_gear_that_ties_up() -> None:
    (text,) = texts({"1": ["A", "B", "D"]})
    assert text.startswith("gears.1: ties up: with A, B and D engaged the input cannot turn; engage other elements")
    assert "A, B and C give -4.932" in text


def test_gear_that_is_none() -> None:
    (text,) = texts({"1": ["B", "C"]})
    assert "gears.1: is no gear: with B and C engaged the output turns independently of the input" in text
    assert "B, C and D give 2.315" in text


def test_neutral_may_be_neutral_but_not_tie_up() -> None:
    assert texts({"N": ["B", "C"]}) == []
    (text,) = texts({"N": ["A", "D", "E"]})
    assert "ties up" in text


def test_unknown_element_with_the_nearest() -> None:
    (text,) = texts({"1": ["B", "C", "X"]})
    assert text == 'gears.1: "X" is no shift element; known are: A, B, C, D, E, F'


def test_the_same_gear_twice() -> None:
    (text,) = texts({"4": ["B", "C", "F"], "5": ["C", "D", "F"]})
    assert text.startswith("gears.5: is the same gear as 4: C and F make both")


def test_all_problems_at_once() -> None:
    assert len(texts({"1": ["A", "B", "D"], "2": ["X"], "3": ["A"]})) == 3


def test_ratios_leave_out_what_is_no_gear() -> None:
    assert list(gear_ratios(nine_speed(), {"1": ["A", "B", "D"], "2": ["C", "D", "E"], "3": ["X"]})) == ["2"]


def with_more(*more: tuple[str, str, str]) -> Gearing:
    """A reduction with a held ring and a direct gear, and clutches between other members."""
    gearing = Gearing()
    gearing.set("P1", 30, 60)
    gearing.brake("B")
    gearing.clutch("K", *(name for name, _, _ in more))
    joined = {
        "input": ["P1.sun", "K.input"],
        "ring": ["P1.ring", "B.left"],
        "output": ["P1.carrier", "K.output"],
        "idle": [],
    }
    for name, first, second in more:
        joined[first].append(f"{name}.input")
        joined[second].append(f"{name}.output")
    for member, flanges in joined.items():
        gearing.member(member, *flanges)
    return gearing


def test_element_that_can_never_matter() -> None:
    layout = with_more(("X", "input", "idle")).layout("two-speed")
    (problem,) = shift_table_problems(layout, {"1": ["B"], "2": ["K"]})
    assert problem.where == "components.X"
    assert "no gear of two-speed needs X" in problem.what and '"idle"' in problem.what
    assert "remove it" in problem.remedy


def test_element_on_one_member() -> None:
    (problem,) = shift_table_problems(with_more(("X", "input", "input")).layout(), {})
    assert problem.where == "components.X" and "both flanges of X are on one member" in problem.what


def test_set_connected_to_itself() -> None:
    gearing = Gearing()
    gearing.set("P1", 30, 60)
    gearing.set("P2", 30, 70)
    gearing.brake("B")
    gearing.member("input", "P1.sun")
    gearing.member("ring", "P1.ring", "B.left")
    gearing.member("output", "P1.carrier", "P2.sun", "P2.carrier")
    (problem,) = shift_table_problems(gearing.layout(), {"1": ["B"]})
    assert problem.where == "components.P2"
    assert 'sun and carrier of P2 are both on the member "output"' in problem.what and "one block" in problem.what
    assert "clutch" in problem.remedy


def test_pair_on_one_shaft_cannot_turn() -> None:
    gearing = Gearing()
    gearing.pair("G1", 20, 40)
    gearing.clutch("K")
    gearing.member("input", "K.input")
    gearing.member("output", "K.output", "G1.input", "G1.output")
    problems = shift_table_problems(gearing.layout(), {})
    assert any("gear pair cannot turn" in problem.what for problem in problems)
    assert any("output" in problem.what and "even with all elements open" in problem.what for problem in problems)


def test_the_shipped_table_is_sound_whatever_its_order() -> None:
    assert shift_table_problems(nine_speed(), dict(reversed(list(NINE_SPEED_GEARS.items())))) == []

"""The sections ``[gears]`` and ``[[shifts]]`` of scenarios: what they come to, and what cannot be."""

from __future__ import annotations

import itertools
import tempfile
import tomllib
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_bed import BED

from ptgen.components.component import Component
from ptgen.components.part import Part
from ptgen.errors import TestbedError
from ptgen.gears import GearAnalysis, State, analyse_gears, handover, layout_of_part
from ptgen.testbed import Profile, Scenario, Shift, Testbed, json_schema, load, load_scenario
from ptgen.testbed.shift_plan import NEUTRAL, ShiftCourse, ShiftWish

HEAD = '[scenario]\nduration = "20 s"\nrecord_every = "1 ms"\n'
GEARS = "gears = { 1 = 5.5, 2 = 3.3, 3 = 2.3, R = -3.4 }"
SINGLE = f"""
[components.gb]
type = "single_clutch_gearbox"
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
ratio = 5.5
{GEARS}
clutch = {{ capacity = "600 N m" }}
"""
DOUBLE = f"""
[components.gb]
type = "double_clutch_gearbox"
inertia_input = "0.13 kg m^2"
inertia_output = "0.4 kg m^2"
ratio1 = 5.5
ratio2 = 3.3
{GEARS}
clutch1 = {{ capacity = "600 N m" }}
clutch2 = {{ capacity = "600 N m" }}
"""
NINE = '\n[components.gb]\ntype = "part"\nfile = "nine-speed.toml"\n'
DUAL = NINE.replace("nine-speed", "seven-speed-dual-clutch")
KINDS = {"single": SINGLE, "double": DOUBLE, "nine": NINE, "dual": DUAL}


@cache
def bed(kind: str, reduction: str = "") -> Testbed:
    file = Path(tempfile.mkdtemp()) / "bed.toml"
    text = BED.replace("flange1 - shaft1 - M2", "flange1 - shaft1 - gb - M2")
    file.write_text(text + KINDS[kind] + reduction, encoding="utf-8")
    return load(file)


def read(kind: str, folder: Path, text: str, reduction: str = "") -> Scenario:
    (folder / "case.toml").write_text(HEAD + text, encoding="utf-8")
    return load_scenario(folder / "case.toml", bed(kind, reduction))


def at(profile: Profile, time: float) -> float:
    if profile.shape == "steps":
        return profile.value[max(0, int(np.searchsorted(profile.time, time, side="right")) - 1)]
    return float(np.interp(time, profile.time, profile.value))


def shift(time: str, to: str, **more: object) -> str:
    lines = [f'component = "gb"\ntime = "{time}"\nto = "{to}"', *(f"{key} = {value}" for key, value in more.items())]
    return "[[shifts]]\n" + "\n".join(lines) + "\n"


def test_without_gears_all_is_open(tmp_path: Path) -> None:
    scenario = read("nine", tmp_path, "")
    assert scenario.gears == {} and scenario.shifts == ()
    assert all(profile == Profile((0.0,), (0.0,), "lines") for profile in scenario.actuations.values())


def test_gear_at_the_start_of_a_part_closes_its_elements(tmp_path: Path) -> None:
    scenario = read("nine", tmp_path, '[gears]\ngb = "1"\n')
    closed = {name for name, profile in scenario.actuations.items() if profile.value == (1.0,)}
    assert closed == {f"gb.{element}" for element in bed("nine").components["gb"].gear_elements()["1"]}
    assert scenario.gears == {"gb": "1"}


def test_overlapping_shift_exchanges_one_element_and_leaves_the_others(tmp_path: Path) -> None:
    table = bed("nine").components["gb"].gear_elements()
    (off,), (on,) = set(table["1"]) - set(table["2"]), set(table["2"]) - set(table["1"])
    scenario = read("nine", tmp_path, '[gears]\ngb = "1"\n' + shift("2 s", "2", release='"0.4 s"', overlap='"0.1 s"'))
    assert scenario.shifts == (Shift("gb", "1", "2", 2.0, 2.6, "overlapping"),)
    assert scenario.actuations[f"gb.{off}"] == Profile((0.0, 2.0, 2.4), (1.0, 1.0, 0.0), "lines")
    assert scenario.actuations[f"gb.{on}"].time == pytest.approx((0.0, 2.3, 2.6))
    assert scenario.actuations[f"gb.{on}"].value == (0.0, 0.0, 1.0)
    for element in set(table["1"]) & set(table["2"]):
        assert scenario.actuations[f"gb.{element}"] == Profile((0.0,), (1.0,), "lines")


def test_default_is_that_both_elements_move_together(tmp_path: Path) -> None:
    scenario = read("double", tmp_path, '[gears]\ngb = "1"\n' + shift("2 s", "2"))
    assert scenario.actuations["gb.clutch1"] == Profile((0.0, 2.0, 2.3), (1.0, 1.0, 0.0), "lines")
    assert scenario.actuations["gb.clutch2"] == Profile((0.0, 2.0, 2.3), (0.0, 0.0, 1.0), "lines")
    assert scenario.ratios == {"gb.ratio1": Profile((0.0,), (5.5,), "lines"), **scenario.ratios}
    assert scenario.shifts == (Shift("gb", "1", "2", 2.0, 2.3, "overlapping"),)


def test_shift_without_overlap_has_a_pause(tmp_path: Path) -> None:
    text = '[gears]\ngb = "2"\n' + shift("2 s", "1", kind='"non-overlapping"', pause='"0.5 s"', apply='"0.2 s"')
    scenario = read("double", tmp_path, text)
    assert scenario.actuations["gb.clutch2"] == Profile((0.0, 2.0, 2.3), (1.0, 1.0, 0.0), "lines")
    assert scenario.actuations["gb.clutch1"] == Profile((0.0, 2.8, 3.0), (0.0, 0.0, 1.0), "lines")
    assert scenario.shifts[0].kind == "non-overlapping" and scenario.shifts[0].end == pytest.approx(3.0)
    # a pause alone says so, too
    assert read("double", tmp_path, text.replace('kind = "non-overlapping"\n', "")).shifts == scenario.shifts


def test_single_clutch_opens_changes_its_ratio_and_closes(tmp_path: Path) -> None:
    scenario = read("single", tmp_path, '[gears]\ngb = "2"\n' + shift("2 s", "1"))
    assert scenario.shifts == (Shift("gb", "2", "1", 2.0, 2.8, "non-overlapping"),)
    assert scenario.actuations["gb.clutch"].time == pytest.approx((0.0, 2.0, 2.3, 2.5, 2.8))
    assert scenario.actuations["gb.clutch"].value == (1.0, 1.0, 0.0, 0.0, 1.0)
    assert scenario.ratios["gb"] == Profile((0.0, 2.3, 2.5), (3.3, 3.3, 5.5), "lines")


def test_double_clutch_uses_the_free_clutch_and_sets_its_ratio_before(tmp_path: Path) -> None:
    text = '[gears]\ngb = "2"\n' + shift("2 s", "3") + shift("4 s", "2") + shift("6 s", "R") + shift("8 s", "N")
    scenario = read("double", tmp_path, text)
    # gear 2 is that of the second stage as the bed has it, so nothing has to be set there
    assert at(scenario.actuations["gb.clutch2"], 0.0) == 1.0 and at(scenario.ratios["gb.ratio2"], 0.0) == 3.3
    for time, clutch, ratio in ((3.0, 1, 2.3), (5.0, 2, 3.3), (7.0, 1, -3.4)):
        assert at(scenario.actuations[f"gb.clutch{clutch}"], time) == 1.0
        assert at(scenario.actuations[f"gb.clutch{3 - clutch}"], time) == 0.0
        assert at(scenario.ratios[f"gb.ratio{clutch}"], time) == ratio
    assert at(scenario.ratios["gb.ratio1"], 5.999) == 2.3 and at(scenario.ratios["gb.ratio1"], 6.0) == -3.4
    assert all(at(scenario.actuations[f"gb.clutch{k}"], 9.0) == 0.0 for k in (1, 2))
    assert [s.before + s.to for s in scenario.shifts] == ["23", "32", "2R", "RN"]


def test_own_profiles_and_shares_of_the_capacity(tmp_path: Path) -> None:
    own = '{ time = ["0.1 s", "0.2 s", "0.6 s"], value = [0, "30 %", 0.8] }'
    text = '[gears]\ngb = "1"\n' + shift("2 s", "2", **{"elements.clutch2": own}) + shift("4 s", "3", hold=0.5)
    scenario = read("double", tmp_path, text)
    course = scenario.actuations["gb.clutch2"]
    assert course.time == pytest.approx((0.0, 2.1, 2.2, 2.6, 4.0, 4.3))
    assert course.value == (0.0, 0.0, 0.3, 0.8, 0.8, 0.0)
    assert scenario.shifts[0].end == pytest.approx(2.6)
    assert scenario.actuations["gb.clutch1"].value[-1] == 0.5


AS_RATIO = '\n[reduction]\nas_ratio = ["gb"]\n'


def test_ratio_for_control_moves_with_the_shift(tmp_path: Path) -> None:
    text = '[gears]\ngb = "1"\n' + shift("2 s", "2") + shift("4 s", "1", kind='"non-overlapping"')
    course = read("double", tmp_path, text, AS_RATIO).ratios["gb"]
    assert course == Profile(course.time, (5.5, 5.5, 3.3, 3.3, 5.5), "lines")
    assert course.time == pytest.approx((0.0, 2.0, 2.3, 4.3, 4.5))
    given = text + '[ratios]\ngb = { time = ["2.1 s", "2.2 s"], value = [5.5, 3.3] }\n'
    assert read("double", tmp_path, given, AS_RATIO).ratios["gb"].time == (2.1, 2.2)
    moved = text.replace('to = "2"', 'to = "2"\nratio_time = ["0.1 s", "0.25 s"]')
    assert read("double", tmp_path, moved, AS_RATIO).ratios["gb"].time[1:3] == pytest.approx((2.1, 2.25))


def test_ratio_for_control_of_a_part(tmp_path: Path) -> None:
    scenario = read("nine", tmp_path, '[gears]\ngb = "2"\n' + shift("2 s", "1") + shift("5 s", "N"), AS_RATIO)
    table = bed("nine", AS_RATIO).gear_tables["gb"].gears
    course = scenario.ratios["gb"]
    assert course.value == (table["2"], table["2"], table["1"])
    assert "gb" in bed("nine", AS_RATIO).ratios and at(course, 20.0) == table["1"], "neutral has no ratio of its own"


START = '[gears]\ngb = "1"\n'
OPEN = '{ time = ["0 s", "0.2 s"], value = [%s, %s] }'


@pytest.mark.parametrize(
    ("kind", "text", "where", "what", "remedy"),
    [
        ("double", '[gears]\ngbx = "1"\n', "gears.gbx", "is no component", 'did you mean "gb"'),
        ("double", '[gears]\nM1 = "1"\n', "gears.M1", "has no gears", "gb"),
        ("double", '[gears]\ngb = "9"\n', "gears.gb", "is no gear", "known are"),
        ("double", "[gears]\ngb = 1\n", "gears.gb", "must be a text", "quotation marks"),
        ("double", 'gears = "1"\n', "gears", "must be a table", "write [gears]"),
        ("double", "[shifts]\na = 1\n", "shifts", "must be a list", "two brackets"),
        ("double", shift("1 s", "4"), "shifts[0].to", "is no gear", "known are"),
        ("double", shift("1 s", "N"), "shifts[0].to", "in gear N already", "another gear"),
        ("double", START + shift("1 s", "1"), "shifts[0].to", "in gear 1 already", "another gear"),
        ("double", START + shift("30 s", "2"), "shifts[0].time", "has ended", "earlier"),
        ("double", START + shift("1 s", "2") + shift("1.2 s", "3"), "shifts[1].time", "before the shift", "1.3 s"),
        ("double", START + shift("1.2 s", "3") + shift("1 s", "2"), "shifts[0].time", "before the shift", "1.3 s"),
        ("double", START + shift("1 s", "2", hold=1.5), "shifts[0].hold", "from 0 to 1", "share"),
        ("double", START + shift("1 s", "2", release='"0 s"'), "shifts[0].release", "must be > 0 s", "check"),
        ("double", START + shift("1 s", "2", kind='"quick"'), "shifts[0].kind", "overlapping", "known are"),
        ("double", START + shift("1 s", "2", overlap='"0.5 s"'), "shifts[0].overlap", "not be longer", "shorten"),
        (
            "double",
            START + shift("1 s", "2", kind='"overlapping"', pause='"0.5 s"'),
            "shifts[0].pause",
            "no place",
            "non-overlapping",
        ),
        (
            "double",
            START + shift("1 s", "2", kind='"non-overlapping"', overlap='"0.1 s"'),
            "shifts[0].overlap",
            "no place",
            "remove",
        ),
        ("single", START + shift("1 s", "2", kind='"overlapping"'), "shifts[0].kind", "cannot shift", "non-overl"),
        ("nine", START + shift("1 s", "6", kind='"overlapping"'), "shifts[0].kind", "B, D and E", "shift to 4 first"),
        (
            "dual",
            START + shift("1 s", "7", kind='"overlapping"'),
            "shifts[0].kind",
            "S1 and S7 hold",
            "shift to 4 first",
        ),
        ("dual", START + shift("1 s", "7", overlap='"0.1 s"'), "shifts[0].overlap", "no load", "non-overlapping"),
        ("dual", START + shift("1 s", "2", preselect='"0 s"'), "shifts[0].preselect", "must be > 0 s", "check"),
        ("double", START + shift("1 s", "2", duration=3), "shifts[0].duration", "unknown key", "known are"),
        ("double", START + '[[shifts]]\ntime = "1 s"\nto = "2"\n', "shifts[0].component", "is missing", "add"),
        ("double", START + "[actuations.gb]\nclutch1 = " + OPEN % (1, 0), "actuations.gb.clutch1", "is set by", "shif"),
        (
            "double",
            START + shift("1 s", "2") + '[ratios]\n"gb.ratio1" = { time = ["0 s"], value = [5] }\n',
            'ratios."gb.ratio1"',
            "is set by",
            "remove",
        ),
        (
            "double",
            START + shift("1 s", "2", **{"elements.clutch3": OPEN % (0, 1)}),
            "shifts[0].elements.clutch3",
            "is no actuated element",
            "clutch2",
        ),
        (
            "double",
            START + shift("1 s", "2", **{"elements.clutch2": OPEN % (0.2, 1)}),
            "shifts[0].elements.clutch2.value",
            "begins at 0.2",
            "begin with 0",
        ),
        (
            "double",
            START + shift("1 s", "2", **{"elements.clutch1": OPEN % (1, 0.5)}),
            "shifts[0].elements.clutch1.value",
            "is open in gear 2",
            "end with 0",
        ),
        (
            "double",
            START + shift("1 s", "2", **{"elements.clutch2": OPEN % (0, 0)}),
            "shifts[0].elements.clutch2.value",
            "is engaged in gear 2",
            "end with 1",
        ),
        (
            "double",
            START + shift("1 s", "2", **{"elements.clutch2": OPEN % (0, 2)}),
            "shifts[0].elements.clutch2.value[1]",
            "from 0 to 1",
            "share",
        ),
        (
            "double",
            START + shift("1 s", "2", ratio_time='["0 s", "0.1 s"]'),
            "shifts[0].ratio_time",
            "no ratio for control",
            "as_ratio",
        ),
        (
            "double",
            START + shift("1 s", "2", ratio_time='["0.2 s", "0.1 s"]'),
            "shifts[0].ratio_time",
            "must rise",
            "exchange",
        ),
    ],
)
def test_what_cannot_be(kind: str, text: str, where: str, what: str, remedy: str, tmp_path: Path) -> None:
    top = text.startswith("gears =")
    (tmp_path / "case.toml").write_text(text + HEAD if top else HEAD + text, encoding="utf-8")
    with pytest.raises(TestbedError) as caught:
        load_scenario(tmp_path / "case.toml", bed(kind))
    found = {problem.where: problem for problem in caught.value.problems}
    assert list(found) == [where], found
    assert what in found[where].what and remedy in found[where].remedy, found


def test_all_problems_at_once(tmp_path: Path) -> None:
    text = (
        '[gears]\ngb = "9"\n'
        + shift("1 s", "4")
        + shift("2 s", "2", hold=3)
        + "[ratios]\nM1 = { time = [], value = [] }\n"
    )
    with pytest.raises(TestbedError) as caught:
        read("double", tmp_path, text)
    assert {problem.where for problem in caught.value.problems} == {
        "gears.gb",
        "shifts[0].to",
        "shifts[1].hold",
        "ratios.M1",
    }


def test_bed_without_gears_says_so(tmp_path: Path) -> None:
    (tmp_path / "bed.toml").write_text(BED, encoding="utf-8")
    (tmp_path / "case.toml").write_text(HEAD + '[gears]\ngb = "1"\n', encoding="utf-8")
    with pytest.raises(TestbedError, match="no component of the bed has gears"):
        load_scenario(tmp_path / "case.toml", load(tmp_path / "bed.toml"))


DURATION = st.floats(0.01, 1.0)


@st.composite
def wishes(draw: st.DrawFn, gears: tuple[str, ...]) -> list[ShiftWish]:
    """Return shifts from gear to gear; each begins after a gap, of any kind that its component allows."""
    found = []
    for _ in range(draw(st.integers(1, 6))):
        release, apply = draw(DURATION), draw(DURATION)
        overlap = draw(st.none() | st.floats(0.0, min(release, apply)))
        found.append(
            ShiftWish(
                draw(st.sampled_from(gears)),
                draw(st.floats(0.0, 1.0)),
                draw(st.sampled_from(["overlapping", "non-overlapping", None])),
                release,
                apply,
                draw(DURATION),
                overlap,
                draw(st.floats(0.1, 1.0)),
                preselect=draw(DURATION),
            )
        )
    return found


def component(kind: str) -> Component:
    return bed(kind).components["gb"]


@cache
def analysis(kind: str) -> GearAnalysis | None:
    part = component(kind)
    return analyse_gears(layout_of_part(part), part.gear_elements()) if isinstance(part, Part) else None


@pytest.mark.parametrize("kind", KINDS)
@given(data=st.data())
def test_courses_are_continuous_and_end_in_the_wanted_gear(kind: str, data: st.DataObject) -> None:
    """Pressed from 0 to 1, no jumps, what is engaged at the end is the gear, and open clutches change their ratios."""
    ways = component(kind).engagements()
    gears = (*ways, NEUTRAL)
    start = data.draw(st.sampled_from(gears))
    course = ShiftCourse("gb", component(kind), start, {}, analysis(kind))
    done: list[Shift] = []
    for wish in data.draw(wishes(gears)):
        if wish.to == course.gear:
            continue
        if wish.kind == "overlapping" and course.obstacle(wish.to):
            continue
        done.append(course.shift(replace(wish, start=course.end + wish.start)))
        held = {name for name, profile in course.actuations().items() if profile.value[-1] > 0}
        assert held == {f"gb.{element}" for element in course.engaged.elements}
        assert course.gear == done[-1].to and course.end == done[-1].end
    for profile in course.actuations().values():
        assert profile.shape == "lines" and all(0.0 <= value <= 1.0 for value in profile.value)
        assert all(b > a for a, b in itertools.pairwise(profile.time))
        slopes = np.abs(np.diff(profile.value)) / np.diff(profile.time)
        assert np.all(slopes < 1.01 / 0.005), "no ramp is shorter than it was asked for"
    assert all(one.end <= other.start + 1e-9 for one, other in itertools.pairwise(done))
    for key, ratio in course.ratios().items():
        clutch = {"gb": "gb.clutch", "gb.ratio1": "gb.clutch1", "gb.ratio2": "gb.clutch2"}[key]
        pressed = course.actuations().get(clutch, Profile((0.0,), (0.0,), "lines"))
        for (t0, v0), (t1, v1) in itertools.pairwise(zip(ratio.time, ratio.value, strict=True)):
            if v0 != v1:
                begin = t1 if ratio.shape == "steps" else t0
                assert at(pressed, begin) == pytest.approx(0.0, abs=1e-6)
                assert at(pressed, t1) == pytest.approx(0.0, abs=1e-6)
                assert at(pressed, 0.5 * (begin + t1)) == pytest.approx(0.0, abs=1e-6)
    ratios = {key.removeprefix("gb.").replace("gb", "ratio"): ratio for key, ratio in course.ratios().items()}
    assert all(ratios[key].value[-1] == value for key, value in course.engaged.ratios.items())


PARTS = [kind for kind in KINDS if analysis(kind) is not None]


@pytest.mark.parametrize("kind", PARTS)
@given(data=st.data())
def test_nothing_ties_up_and_idle_elements_change_around_the_handover(kind: str, data: st.DataObject) -> None:
    """Of both elements that hand over the load, one at a time makes no tie-up with all others that are pressed."""
    found = analysis(kind)
    assert found is not None
    tie_ups = {frozenset(one.engaged) for one in found.combinations if one.state is State.TIE_UP}
    gears = (*component(kind).engagements(), NEUTRAL)
    start = data.draw(st.sampled_from(gears))
    course = ShiftCourse("gb", component(kind), start, {}, found)
    for wish in data.draw(wishes(gears)):
        order = handover(found, course.gear, wish.to)
        if order is None or (wish.kind == "overlapping" and order.obstacle):
            continue
        done = course.shift(replace(wish, start=course.end + wish.start))
        begin, end = done.start + 1e-6, done.end - 1e-6
        courses = {name.removeprefix("gb."): profile for name, profile in course.actuations().items()}
        for time in np.linspace(begin, end, 101):
            pressed = {name for name, profile in courses.items() if at(profile, time) > 1e-9}
            assert pressed - set(order.release) not in tie_ups, (done, time, pressed)
            assert pressed - (set(order.apply) - set(order.release)) not in tie_ups, (done, time, pressed)
            if done.kind == "non-overlapping":
                assert pressed not in tie_ups, (done, time, pressed)

        def moves(names: Iterable[str], courses=courses, begin=begin, end=end) -> list[float]:
            """Return the times in the shift between which elements go from open to closed or back."""
            corners = []
            for name in names:
                course = courses[name]
                for pair in itertools.pairwise(zip(course.time, course.value, strict=True)):
                    if (pair[0][1] == 0.0) != (pair[1][1] == 0.0) and begin < pair[1][0] < end + 1e-3:
                        corners += [pair[0][0], pair[1][0]]
            return corners or [np.nan]

        load = moves({*order.release, *order.apply})
        assert not max(moves({*order.before.release, *order.before.apply})) > min(load) + 1e-9
        assert not min(moves({*order.after.release, *order.after.apply})) < max(load) - 1e-9


def test_dual_clutch_preselects(tmp_path: Path) -> None:
    scenario = read("dual", tmp_path, START + shift("2 s", "2", preselect='"0.1 s"', overlap='"0.2 s"'))
    courses = {name.removeprefix("gb."): profile for name, profile in scenario.actuations.items()}
    assert courses["S2"] == Profile((0.0, 2.0, 2.1), (0.0, 0.0, 1.0), "lines")
    assert courses["K1"].time == pytest.approx((0.0, 2.1, 2.4)) and courses["K1"].value == (1.0, 1.0, 0.0)
    assert courses["K2"].time == pytest.approx((0.0, 2.2, 2.5)) and courses["K2"].value == (0.0, 0.0, 1.0)
    assert courses["S1"].time == pytest.approx((0.0, 2.5, 2.6)) and courses["S1"].value == (1.0, 1.0, 0.0)
    assert scenario.shifts[0].kind == "overlapping" and scenario.shifts[0].end == pytest.approx(2.6)


def test_gears_of_one_branch_change_while_its_clutch_is_open(tmp_path: Path) -> None:
    scenario = read("dual", tmp_path, START + shift("2 s", "3", pause='"0.4 s"'))
    courses = {name.removeprefix("gb."): profile for name, profile in scenario.actuations.items()}
    assert courses["K1"].time == pytest.approx((0.0, 2.0, 2.3, 2.7, 3.0)) and courses["K1"].value[2:4] == (0.0, 0.0)
    assert courses["S1"].time == pytest.approx((0.0, 2.3, 2.5)) and courses["S1"].value[-1] == 0.0
    assert courses["S3"].time == pytest.approx((0.0, 2.5, 2.7)) and courses["S3"].value[-1] == 1.0
    assert scenario.shifts[0].kind == "non-overlapping"


def test_clutch_takes_the_load_from_neutral_when_the_synchroniser_has_closed(tmp_path: Path) -> None:
    scenario = read("dual", tmp_path, shift("2 s", "1") + shift("4 s", "N"))
    assert scenario.actuations["gb.S1"].time == pytest.approx((0.0, 2.0, 2.2, 4.3, 4.5))
    assert scenario.actuations["gb.K1"].time == pytest.approx((0.0, 2.2, 2.5, 4.0, 4.3))


def test_idle_elements_of_a_gear_set_change_one_after_the_other(tmp_path: Path) -> None:
    """Fourth gear needs C and F only, so B may give way to D before F gives way to E."""
    scenario = read("nine", tmp_path, START.replace("1", "4") + shift("2 s", "2"))
    courses = {name.removeprefix("gb."): profile for name, profile in scenario.actuations.items()}
    assert courses["B"].time == pytest.approx((0.0, 2.0, 2.1)) and courses["D"].time == pytest.approx((0.0, 2.1, 2.2))
    assert courses["F"].time == courses["E"].time == pytest.approx((0.0, 2.2, 2.5))
    back = read("nine", tmp_path, START.replace("1", "2") + shift("2 s", "4"))
    assert back.actuations["gb.D"].time == pytest.approx((0.0, 2.3, 2.4))
    assert back.actuations["gb.B"].time == pytest.approx((0.0, 2.4, 2.5))


def test_shift_that_could_tie_up_on_the_way_does_not_overlap(tmp_path: Path) -> None:
    scenario = read("nine", tmp_path, START + shift("2 s", "6"))
    assert scenario.shifts[0].kind == "non-overlapping"


SCHEMA = jsonschema.Draft202012Validator(json_schema("scenario"))


def test_schema_of_scenarios() -> None:
    jsonschema.Draft202012Validator.check_schema(json_schema("scenario"))
    for path in sorted((Path(__file__).parents[2] / "scenarios").glob("*.toml")):
        SCHEMA.validate(tomllib.loads(path.read_text(encoding="utf-8")))
    more = START + shift("1 s", "2", **{"elements.clutch2": OPEN % (0, 1)})
    SCHEMA.validate(tomllib.loads(HEAD + more))
    for wrong in (more.replace("to =", "too ="), more.replace('"1 s"', "1"), START.replace('"1"', "1")):
        assert not SCHEMA.is_valid(tomllib.loads(HEAD + wrong))

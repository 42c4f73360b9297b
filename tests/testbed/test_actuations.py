"""The section ``[actuations]`` of scenario files."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable
from pathlib import Path

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from small_bed import BED

from ptgen.elements import Friction, FrictionRole
from ptgen.errors import Problem, TestbedError
from ptgen.testbed import Profile, Scenario, Testbed, load, load_scenario

HEAD = '[scenario]\nduration = "2 s"\nrecord_every = "1 ms"\n'
RAMP = '{ time = ["0 s", "1 s"], value = [0, 1] }'
OPEN = Profile((0.0,), (0.0,), "lines")


def friction(name: str, *, actuated: bool) -> Friction:
    return Friction(
        name, {}, sp.Integer(100), sp.Integer(0), FrictionRole.COUPLING, static=sp.Integer(120), actuated=actuated
    )


class Clutched(Testbed):
    """The small bed with friction elements that belong to no component, so that every kind of name occurs."""

    @property
    def frictions(self) -> tuple[Friction, ...]:
        return (
            friction("clutch1", actuated=True),
            friction("trans.brakeA", actuated=True),
            friction("trans.brakeB", actuated=True),
            friction("diff.loss", actuated=False),
        )


@pytest.fixture(scope="module")
def clutched(tmp_path_factory: pytest.TempPathFactory) -> Testbed:
    path = tmp_path_factory.mktemp("bed") / "bed.toml"
    path.write_text(BED, encoding="utf-8")
    bed = load(path)
    return Clutched(**{field.name: getattr(bed, field.name) for field in dataclasses.fields(bed)})


Read = Callable[[str], Scenario]
Only = Callable[[str], Problem]


@pytest.fixture
def read(tmp_path: Path, clutched: Testbed) -> Read:
    def reader(text: str) -> Scenario:
        path = tmp_path / "case.toml"
        path.write_text(HEAD + text, encoding="utf-8")
        return load_scenario(path, clutched)

    return reader


@pytest.fixture
def problem(read: Read) -> Only:
    def only(text: str) -> Problem:
        with pytest.raises(TestbedError) as caught:
            read(text)
        (found,) = caught.value.problems
        assert found.what and found.remedy
        return found

    return only


def test_actuated_elements_in_order(clutched: Testbed) -> None:
    assert clutched.actuated == ("clutch1", "trans.brakeA", "trans.brakeB")


@pytest.mark.parametrize("text", ["", "[actuations]\n", "[actuations.trans]\n"])
def test_elements_without_an_entry_stay_open(read: Read, text: str) -> None:
    assert read(text).actuations == {"clutch1": OPEN, "trans.brakeA": OPEN, "trans.brakeB": OPEN}


@pytest.mark.parametrize(
    "text",
    [
        f'[actuations]\nclutch1 = {RAMP}\n"trans.brakeA" = {RAMP}\n',
        f"[actuations]\nclutch1 = {RAMP}\ntrans.brakeA = {RAMP}\n",
        f"[actuations]\nclutch1 = {RAMP}\n[actuations.trans]\nbrakeA = {RAMP}\n",
        f"[actuations]\nclutch1 = {RAMP}\n[actuations.trans.brakeA]\n" + 'time = ["0 s", "1 s"]\nvalue = [0, 1]\n',
    ],
)
def test_dots_in_names(read: Read, text: str) -> None:
    ramp = Profile((0.0, 1.0), (0.0, 1.0), "lines")
    assert read(text).actuations == {"clutch1": ramp, "trans.brakeA": ramp, "trans.brakeB": OPEN}


def test_steps_percent_and_whole_numbers(read: Read) -> None:
    entry = '{ time = ["0 s", "10 ms"], value = ["40 %", 1], shape = "steps" }'
    assert read(f"[actuations]\nclutch1 = {entry}\n").actuations["clutch1"] == Profile((0.0, 0.01), (0.4, 1.0), "steps")


@pytest.mark.parametrize(
    ("text", "where", "what", "remedy"),
    [
        ("clutch1 = 1", "clutch1", "must be a table, got 1", "write it as a table"),
        ('clutch1 = { time = ["0 s"], value = [1.5] }', "clutch1.value[0]", "from 0 to 1, got 1.5", "0 for open"),
        ('clutch1 = { time = ["0 s"], value = [-1e-9] }', "clutch1.value[0]", "from 0 to 1, got -1e-09", "0 for open"),
        ('clutch1 = { time = ["0 s"], value = [nan] }', "clutch1.value[0]", "must be a finite number", "0.5"),
        ('clutch1 = { time = ["0 s"], value = [true] }', "clutch1.value[0]", "a plain number, got True", "0.5"),
        ('clutch1 = { time = ["0 s"], value = ["1 N m"] }', "clutch1.value[0]", "another dimension", "0.5"),
        ('clutch1 = { time = ["0 s"], value = ["zu"] }', "clutch1.value[0]", "must be a number", "0.5"),
        ("clutch1 = { time = [0], value = [1] }", "clutch1.time[0]", "must be a string with its unit", '"100 us"'),
        ('clutch1 = { time = ["0 s"], value = [1], shap = 1 }', "clutch1.shap", "unknown key", '"shape"'),
        ('clutch1 = { file = "a.csv", column = "n" }', "clutch1.time", "is missing", 'time = "t"'),
        (f"clutch2 = {RAMP}", "clutch2", '"clutch2" is no friction element of the bed "small"', '"clutch1"'),
        (f"brakeA = {RAMP}", "brakeA", "is no friction element", '"trans.brakeA"'),
        (f"trans = {RAMP}", "trans", "is no friction element", "trans.brakeA"),
        (f'"trans.brakeC" = {RAMP}', '"trans.brakeC"', "is no friction element", '"trans.brake'),
        (f"trans.brakeC = {RAMP}", "trans.brakeC", '"trans.brakeC" is no friction element', '"trans.brake'),
        (f"tran.brakeA = {RAMP}", "tran.brakeA", '"tran.brakeA" is no friction element', '"trans.brakeA"'),
        (f"trans.brakeA.x = {RAMP}", "trans.brakeA.time", "is missing", "add time"),
        (f"diff.loss = {RAMP}", "diff.loss", "is not actuated", "leave it out: only clutches and brakes"),
        (f'trans.brakeA = {RAMP}\n"trans.brakeA" = {RAMP}', '"trans.brakeA"', "an entry already", "remove one"),
    ],
)
def test_mistakes(read: Read, text: str, where: str, what: str, remedy: str) -> None:
    with pytest.raises(TestbedError) as caught:
        read(f"[actuations]\n{text}\n")
    found = {problem.where: problem for problem in caught.value.problems}
    assert what in found[f"actuations.{where}"].what and remedy in found[f"actuations.{where}"].remedy


def test_actuations_that_are_no_table(tmp_path: Path, clutched: Testbed) -> None:
    path = tmp_path / "case.toml"
    path.write_text("actuations = 3\n" + HEAD, encoding="utf-8")
    with pytest.raises(TestbedError, match="actuations: must be a table, got 3"):
        load_scenario(path, clutched)


def test_all_problems_at_once(read: Read) -> None:
    text = '[references]\nspeed.M7 = {}\n[actuations]\nclutch1 = { time = ["0 s", "1 s", "2 s"], value = [2, 0, -1] }\n'
    with pytest.raises(TestbedError) as caught:
        read(text + f"diff.loss = {RAMP}\nx = 1\n")
    places = ["references.speed.M7", "actuations.clutch1.value[0]", "actuations.clutch1.value[2]"]
    assert [p.where for p in caught.value.problems] == [*places, "actuations.diff.loss", "actuations.x"]


def test_a_bed_without_actuated_elements_says_so(tmp_path: Path) -> None:
    bed, path = tmp_path / "bed.toml", tmp_path / "case.toml"
    bed.write_text(BED, encoding="utf-8")
    path.write_text(f"{HEAD}[actuations]\nclutch1 = {RAMP}\n", encoding="utf-8")
    small = load(bed)
    assert (small.actuated, small.frictions) == ((), ())
    with pytest.raises(TestbedError, match="no friction element of the bed is actuated"):
        load_scenario(path, small)


# --- measurement files


@pytest.mark.parametrize(("unit", "values"), [("", "0.25,1"), ('unit = "%", ', "25,100"), ('unit = "", ', "0.25,1")])
def test_file(read: Read, tmp_path: Path, unit: str, values: str) -> None:
    first, second = values.split(",")
    (tmp_path / "run.csv").write_text(f"t,a\n0,{first}\n1,{second}\n", encoding="utf-8")
    entry = f'{{ file = "run.csv", {unit}time = "t", column = "a" }}'
    assert read(f"[actuations]\nclutch1 = {entry}\n").actuations["clutch1"] == Profile((0.0, 1.0), (0.25, 1.0), "lines")


@pytest.mark.parametrize(
    ("old", "new", "key", "what", "remedy"),
    [
        ("1,1", "1,1.01", "file", 'run.csv, line 3, column "a": must be from 0 to 1, got 1.01', "0 for open"),
        ("1,1", "1,nan", "file", "must be a finite number", "correct the cell"),
        (
            'time = "t"',
            'time = "t", unit = "rpm"',
            "unit",
            'must be "%", or absent for plain numbers',
            "leave unit out",
        ),
    ],
)
def test_mistakes_in_files(problem: Only, tmp_path: Path, old: str, new: str, key: str, what: str, remedy: str) -> None:
    (tmp_path / "run.csv").write_text("t,a\n0,0\n1,1\n".replace(old, new), encoding="utf-8")
    entry = '{ file = "run.csv", time = "t", column = "a" }'.replace(old, new)
    found = problem(f"[actuations]\nclutch1 = {entry}\n")
    assert found.where == f"actuations.clutch1.{key}" and what in found.what and remedy in found.remedy


def test_references_need_a_unit(problem: Only) -> None:
    found = problem('[references]\nspeed.M2 = { file = "run.csv", time = "t", column = "n" }\n')
    assert found.where == "references.speed.M2.unit" and "is missing" in found.what and "rad/s" in found.remedy


# --- whatever stands in the section

QUICK = settings(
    max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


@QUICK
@given(
    st.lists(
        st.tuples(st.floats(0, 1e6), st.floats(0, 1)), min_size=1, max_size=8, unique_by=lambda point: f"{point[0]:.9g}"
    ),
    st.sampled_from(["lines", "steps"]),
)
def test_what_is_written_is_read(tmp_path: Path, clutched: Testbed, points: list[tuple[float, float]], shape) -> None:
    points = sorted((float(f"{time:.9g}"), value) for time, value in points)
    time, value = json.dumps([f"{time:.9g} s" for time, _ in points]), json.dumps([value for _, value in points])
    path = tmp_path / "case.toml"
    entry = f'{{ time = {time}, value = {value}, shape = "{shape}" }}'
    path.write_text(f"{HEAD}[actuations]\ntrans.brakeB = {entry}\n", encoding="utf-8")
    found = load_scenario(path, clutched).actuations["trans.brakeB"]
    assert found.value == tuple(value for _, value in points) and found.shape == shape
    assert found.time == pytest.approx(tuple(time for time, _ in points), rel=1e-14)


NAMES = st.sampled_from(["clutch1", "trans", "brakeA", "trans.brakeA", "diff", "loss", "time", "value", "file", "x"])
LEAVES = st.one_of(st.floats(), st.integers(-(10**400), 10**400), st.booleans(), st.sampled_from(["0 s", "1", "lines"]))
TABLES = st.recursive(
    LEAVES | st.lists(LEAVES, max_size=3),
    lambda inner: st.dictionaries(NAMES | st.text(max_size=4), inner, max_size=4),
    max_leaves=12,
)


def toml(value: object) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{toml(str(key))} = {toml(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value.replace("\x7f", "")) if isinstance(value, str) else repr(value)


@QUICK
@given(TABLES)
def test_whatever_stands_there(tmp_path: Path, clutched: Testbed, table: object) -> None:
    path = tmp_path / "case.toml"
    path.write_text(f"actuations = {toml(table)}\n{HEAD}", encoding="utf-8")
    try:
        scenario = load_scenario(path, clutched)
    except TestbedError as error:
        problems = error.problems
    else:
        assert set(scenario.actuations) == set(clutched.actuated)
        assert all(0 <= value <= 1 for profile in scenario.actuations.values() for value in profile.value)
        return
    assert problems and all(problem.what and problem.remedy for problem in problems)


def test_tables_of_any_depth_are_problems(read: Read) -> None:
    deep = ".".join("a" * 5000)
    for key in ("clutch1", "trans", "x", "clutch1.time"):
        with pytest.raises(TestbedError):
            read(f"[actuations]\n{key}.{deep} = 1\n")


def test_a_clutch_that_is_always_pressed_is_not_actuated(tmp_path: Path) -> None:
    clutch = '[components.clutch1]\ntype = "clutch"\ncapacity = "100 N m"\nactuated = false\n[control]'
    text = BED.replace("shaft1 - M2", "shaft1 - clutch1 - M2").replace("[control]", clutch)
    bed, path = tmp_path / "bed.toml", tmp_path / "case.toml"
    path.write_text(f"{HEAD}[actuations]\nclutch1 = {RAMP}\n", encoding="utf-8")
    bed.write_text(text, encoding="utf-8")
    with pytest.raises(TestbedError, match=r"is not actuated; write actuated = true in \[components.clutch1\]"):
        load_scenario(path, load(bed))
    bed.write_text(text.replace("actuated = false", ""), encoding="utf-8")
    assert load_scenario(path, load(bed)).actuations["clutch1"].value == (0.0, 1.0)

"""Scenario files and the measurement files that they name."""

from __future__ import annotations

import importlib.util
import math
import sys
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from small_bed import BED

from ptgen.errors import Problem, TestbedError
from ptgen.testbed import Scenario, Testbed, load, load_scenario

HEAD = '[scenario]\nduration = "2 s"\nrecord_every = "1 ms"\n[references]\n'


@pytest.fixture
def small(tmp_path: Path) -> Testbed:
    path = tmp_path / "bed.toml"
    path.write_text(BED, encoding="utf-8")
    return load(path)


@pytest.fixture
def read(tmp_path: Path, small: Testbed) -> Callable[[str], Scenario]:
    def reader(text: str) -> Scenario:
        path = tmp_path / "case.toml"
        path.write_text(text, encoding="utf-8")
        return load_scenario(path, small)

    return reader


@pytest.fixture
def problem(read: Callable[[str], Scenario]) -> Callable[[str], Problem]:
    def only(text: str) -> Problem:
        with pytest.raises(TestbedError) as caught:
            read(text)
        assert caught.value.file.endswith("case.toml")
        (found,) = caught.value.problems
        assert found.what and found.remedy
        return found

    return only


Read = Callable[[str], Scenario]
Only = Callable[[str], Problem]


def test_references(read: Read) -> None:
    scenario = read(
        HEAD.replace("[ref", 'title = "A"\ndescription = "B"\n[ref')
        + 'torque.M1 = { time = ["0 s", "500 ms"], value = ["0 N m", "0.4 kN m"] }\n'
        + 'speed.M2 = { time = ["1 s"], value = ["60 rpm"], shape = "steps" }\n'
    )
    assert (scenario.name, scenario.title, scenario.description) == ("case", "A", "B")
    assert (scenario.duration, scenario.record_every) == (2.0, 1e-3)
    torque, speed = scenario.references["torque.M1"], scenario.references["speed.M2"]
    assert (torque.time, torque.value, torque.shape) == ((0.0, 0.5), (0.0, 400.0), "lines")
    assert speed.shape == "steps" and speed.value[0] == pytest.approx(2 * math.pi)


def test_missing_references_are_zero(read: Read) -> None:
    for text in (HEAD, HEAD.replace("[references]\n", "")):
        scenario = read(text)
        assert set(scenario.references) == {"torque.M1", "speed.M2"}
        assert all(p.time == (0.0,) and p.value == (0.0,) for p in scenario.references.values())


@pytest.mark.parametrize(
    ("old", "new", "where", "what", "remedy"),
    [
        ("[scenario]", "[scenaro]\n[scenario]", "scenaro", "unknown section", '"scenario"'),
        ("record_every", "titl = 1\nrecord_every", "scenario.titl", "unknown key", '"title"'),
        ('duration = "2 s"\n', "", "scenario.duration", "is missing", "add duration"),
        ('"2 s"', '"-2 s"', "scenario.duration", "must be > 0 s", "check the sign"),
        ('"2 s"', '"2 m"', "scenario.duration", "another dimension", "with its unit"),
        ('"1 ms"', '"160 us"', "scenario.record_every", "multiple of the sampling time, 0.0001 s", '"0.0002 s"'),
        ('"2 s"', '"1.00005 s"', "scenario.duration", "multiple of the sampling time", "write e.g. "),
        ('"2 s"', '"1e14 s"', "scenario.duration", "too long", "shorten it"),
        ('"1 ms"', '"3 s"', "scenario.record_every", "must not exceed the duration", "more often"),
        ("[references]", "[references]\ntorqe.M1 = {}", "references.torqe", "unknown kind", '"torque"'),
        ("[references]", "[references]\ntorque = 3", "references.torque", "table of machines", "write torque.M1"),
        ("[references]", "[references]\ntorque.M1 = 3", "references.torque.M1", "must be a table", "as a table"),
        (
            "[references]",
            '[references]\ntorque.M2 = { time = ["0 s"], value = ["0 N m"] }',
            "references.torque.M2",
            'machine "M2" controls its speed',
            "write speed.M2",
        ),
        (
            "[references]",
            '[references]\nspeed.M1 = { time = ["0 s"], value = ["0 rpm"] }',
            "references.speed.M1",
            'machine "M1" controls a torque',
            "write torque.M1",
        ),
        ("[references]", "[references]\nspeed.M7 = {}", "references.speed.M7", '"M7" is no machine', '"speed.M2"'),
    ],
)
def test_mistakes(problem: Only, old: str, new: str, where: str, what: str, remedy: str) -> None:
    found = problem(HEAD.replace(old, new, 1))
    assert found.where == where and what in found.what and remedy in found.remedy


@pytest.mark.parametrize(
    ("points", "where", "what", "remedy"),
    [
        ('time = ["0 s", "1 s"], value = ["0 N m"]', ".value", "as many entries as time (2), got 1", "one value"),
        ("time = [], value = []", ".time", "is empty", 'time = ["0 s"]'),
        ('time = ["1 s", "0 s"], value = ["0 N m", "1 N m"]', ".time[1]", "must be after 1 s, got 0 s", "in order"),
        ('time = ["1 s", "1 s"], value = ["0 N m", "1 N m"]', ".time[1]", "must be after 1 s", 'shape = "steps"'),
        ('time = ["-1 s", "1 s"], value = ["0 N m", "1 N m"]', ".time[0]", "not be before 0 s", "shift"),
        ('time = ["0 s"], value = ["1 rpm"]', ".value[0]", "another dimension", '"400 N m"'),
        ('time = [0], value = ["1 N m"]', ".time[0]", "must be a string with its unit", '"100 us"'),
        ('time = ["0 s"], value = ["1 N m"], shape = "step"', ".shape", 'must be "lines" or "steps"', '"steps"'),
        ('time = ["0 s"], value = ["1 N m"], shap = 1', ".shap", "unknown key", '"shape"'),
        ('time = "0 s", value = ["1 N m"]', ".time", "must be a list", "brackets"),
        ('time = ["0 s"]', ".value", "is missing", "add value"),
    ],
)
def test_mistakes_in_points(problem: Only, points: str, where: str, what: str, remedy: str) -> None:
    found = problem(HEAD + f"torque.M1 = {{ {points} }}\n")
    assert found.where == "references.torque.M1" + where
    assert what in found.what and remedy in found.remedy


def test_all_problems_at_once(read: Read) -> None:
    with pytest.raises(TestbedError) as caught:
        read('[scenario]\nduration = "2"\n[references]\nspeed.M7 = {}\ntorque.M1 = {}\n')
    assert {p.where for p in caught.value.problems} == {
        "scenario.duration",
        "scenario.record_every",
        "references.speed.M7",
        "references.torque.M1.time",
        "references.torque.M1.value",
    }


def test_missing_section(problem: Only) -> None:
    found = problem("[references]\n")
    assert found.where == "scenario" and found.what == "is missing" and "duration" in found.remedy


def test_references_that_are_no_table(problem: Only) -> None:
    assert problem("references = 3\n" + HEAD.replace("[references]\n", "")).where == "references"


# --- measurement files

CSV = HEAD + 'speed.M2 = { file = "run.csv", time = "t", column = "n", unit = "rpm" }\n'


@pytest.mark.parametrize("text", ["t,n\n0,0\n1,60\n", "\ufefft;x;n\r\n0;;0\r\n\r\n1;;6e1\r\n", '"t"\t"n"\n0\t0\n1\t60'])
def test_csv(read: Read, tmp_path: Path, text: str) -> None:
    (tmp_path / "run.csv").write_text(text, encoding="utf-8", newline="")
    profile = read(CSV).references["speed.M2"]
    assert profile.time == (0.0, 1.0) and profile.value == pytest.approx((0.0, 2 * math.pi))


def test_csv_time_unit(read: Read, tmp_path: Path) -> None:
    (tmp_path / "run.csv").write_text("t,n\n0,0\n500,60\n", encoding="utf-8")
    text = CSV.replace('time = "t"', 'time = "t", time_unit = "ms", shape = "steps"')
    profile = read(text).references["speed.M2"]
    assert profile.time == pytest.approx((0.0, 0.5)) and profile.shape == "steps"


@pytest.mark.parametrize(
    ("text", "key", "what", "remedy"),
    [
        ("t,m\n0,0\n", "column", 'run.csv has no column "n"', "known are: m, t"),
        ("s,n\n0,0\n", "time", 'run.csv has no column "t"', "known are: n, s"),
        ("t,n\n0,0\n1,x\n", "file", 'run.csv, line 3, column "n": must be a finite number, got "x"', "decimal point"),
        ("t,n\n0,nan\n", "file", 'line 2, column "n": must be a finite number', "correct the cell"),
        ("t,n\n0,0\n1\n", "file", 'line 3, column "n": must be a finite number, got ""', "correct the cell"),
        ("t,n\n0,0\n0,1\n", "file", "run.csv, line 3: time must be after 0 s, got 0 s", "in order"),
        ("t,n\n-1,0\n", "file", "run.csv, line 2: time must not be before 0 s", "shift the times"),
        ("t,n\n", "file", "run.csv holds no values", "check the recording"),
        ("", "time", 'no column "t"', "write the names of the columns into the first line"),
        ("t,n\n0," + "1" * 200_000, "file", "run.csv is no CSV file", "export it again"),
    ],
)
def test_mistakes_in_csv(problem: Only, tmp_path: Path, text: str, key: str, what: str, remedy: str) -> None:
    (tmp_path / "run.csv").write_text(text, encoding="utf-8")
    found = problem(CSV)
    assert found.where == f"references.speed.M2.{key}"
    assert what in found.what and remedy in found.remedy


def test_csv_in_another_encoding(problem: Only, tmp_path: Path) -> None:
    (tmp_path / "run.csv").write_bytes("t,n,ü\n0,0,0\n".encode("latin-1"))
    assert problem(CSV).remedy == "save it in the encoding UTF-8"


@pytest.mark.parametrize(
    ("old", "new", "key", "what", "remedy"),
    [
        ('"run.csv"', '"missing.csv"', "file", "missing.csv does not exist", "beside the scenario file"),
        ('"run.csv"', '"run.xls"', "file", "must be a .csv, .parquet or .mf4 file", "convert it"),
        ('"run.csv"', '""', "file", "must not be empty", "name a .csv"),
        ('"run.csv"', '"a\\u0000b.csv"', "file", "does not exist", "beside"),
        ('time = "t", ', "", "time", "is missing", 'add time = "t"'),
        (', column = "n"', "", "column", "is missing", "add column"),
        ('unit = "rpm"', 'unit = "Nm"', "unit", 'must be a unit such as rpm or rad/s, got "Nm"', 'unit = "rad/s"'),
        ('unit = "rpm"', 'unit = "rpm", time_unit = "m"', "time_unit", "such as s, ms", 'time_unit = "s"'),
        ('unit = "rpm"', 'unit = "rpm", colum = 3', "colum", "unknown key", '"column"'),
    ],
)
def test_mistakes_in_recordings(problem: Only, old: str, new: str, key: str, what: str, remedy: str) -> None:
    found = problem(CSV.replace(old, new))
    assert found.where == f"references.speed.M2.{key}"
    assert what in found.what and remedy in found.remedy


@pytest.mark.parametrize(
    ("suffix", "module", "extra"), [("parquet", "pyarrow.parquet", "parquet"), ("mf4", "asammdf", "mdf")]
)
def test_missing_extra(
    problem: Only, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, module: str, extra: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    (tmp_path / f"run.{suffix}").write_bytes(b"x")
    found = problem(CSV.replace("run.csv", f"run.{suffix}"))
    assert found.where == "references.speed.M2.file"
    assert "which is not installed" in found.what and f"install ptgen[{extra}]" in found.remedy


@pytest.mark.skipif(importlib.util.find_spec("pyarrow") is None, reason="needs pyarrow")
def test_parquet(read: Read, problem: Only, tmp_path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    text = CSV.replace("run.csv", "run.parquet")
    pyarrow.parquet.write_table(pyarrow.table({"t": [0.0, 1.0], "n": [0, 60]}), tmp_path / "run.parquet")
    assert read(text).references["speed.M2"].value == pytest.approx((0.0, 2 * math.pi))
    assert problem(text.replace('"n"', '"m"')).remedy == "known are: n, t"
    (tmp_path / "run.parquet").write_bytes(b"no parquet")
    assert "is no Parquet file" in problem(text).what


@pytest.mark.skipif(importlib.util.find_spec("asammdf") is None, reason="needs asammdf")
@pytest.mark.filterwarnings("default")
def test_mf4(read: Read, problem: Only, tmp_path: Path) -> None:
    import asammdf
    import numpy as np

    with asammdf.MDF() as recording:
        recording.append(asammdf.Signal(np.array([0.0, 60.0]), np.array([0.0, 1.0]), name="n"))
        recording.save(tmp_path / "run.mf4")
    text = CSV.replace("run.csv", "run.mf4").replace('time = "t", ', "")
    assert read(text).references["speed.M2"].value == pytest.approx((0.0, 2 * math.pi))
    assert 'no channel "m"' in problem(text.replace('"n"', '"m"')).what


class FakeMdf:
    """Stands in for asammdf, which is an extra: a recording with one channel of two samples."""

    channels_db: dict[str, Any] = {"n": ()}  # noqa: RUF012  as in asammdf

    def __init__(self, path: Path) -> None:
        if path.read_bytes() != b"mdf":
            raise RuntimeError("no MDF block")

    def __enter__(self) -> FakeMdf:
        return self

    def __exit__(self, *_: object) -> None: ...

    def __contains__(self, name: str) -> bool:
        return name in self.channels_db

    def get(self, name: str) -> Any:
        import numpy as np

        return types.SimpleNamespace(timestamps=np.array([0.0, 1.0]), samples=np.array([0, 60]))


def test_mf4_through_its_interface(read: Read, problem: Only, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "asammdf", types.SimpleNamespace(MDF=FakeMdf))  # type: ignore[arg-type]
    path = tmp_path / "run.mf4"
    path.write_bytes(b"mdf")
    text = CSV.replace("run.csv", "run.mf4").replace('time = "t", ', "")
    assert read(text).references["speed.M2"].value == pytest.approx((0.0, 2 * math.pi))
    assert 'no channel "m"' in problem(text.replace('"n"', '"m"')).what
    path.write_bytes(b"x")
    assert "is no MF4 file (no MDF block)" in problem(text).what

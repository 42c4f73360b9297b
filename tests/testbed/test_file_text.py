"""What can be wrong with a file before a single key is read."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from ptgen.errors import Problem, TestbedError
from ptgen.testbed import load


def only(path: Path | str) -> Problem:
    with pytest.raises(TestbedError) as caught:
        load(path)
    (problem,) = caught.value.problems
    return problem


def test_missing_file(tmp_path: Path) -> None:
    problem = only(tmp_path / "bed.toml")
    assert problem == Problem("", "does not exist", "check the path of the test bed file")


def test_directory(tmp_path: Path) -> None:
    problem = only(tmp_path)
    assert problem.what == "is a directory" and problem.remedy == "name the test bed file inside it"


@pytest.mark.parametrize("name", ["x\0y", "x" * 5000])
def test_impossible_path(name: str) -> None:
    problem = only(name)
    assert problem.what.startswith("cannot be read") and problem.remedy == "check path and permissions"


def test_unreadable_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(self: Path) -> bytes:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_bytes", refuse)
    assert only(tmp_path / "bed.toml").what == "cannot be read (Permission denied)"


def test_wrong_encoding(tmp_path: Path) -> None:
    path = tmp_path / "bed.toml"
    path.write_bytes('[testbed]\ntitle = "Prüfstand"\n'.encode("latin-1"))
    problem = only(path)
    assert problem.what == "is not UTF-8 (byte 0xfc in line 2)"
    assert problem.remedy == "save it in the encoding UTF-8"


def test_utf16(tmp_path: Path) -> None:
    path = tmp_path / "bed.toml"
    path.write_bytes("[testbed]".encode("utf-16"))
    assert only(path).remedy == "save it in the encoding UTF-8"


def test_byte_order_mark_and_windows_line_ends(tmp_path: Path, change: Callable[..., str]) -> None:
    path = tmp_path / "bed.toml"
    path.write_bytes(change("small", "small").replace("\n", "\r\n").encode("utf-8-sig"))
    assert load(path).name == "small"


@pytest.mark.parametrize(
    ("text", "where", "what", "remedy"),
    [
        ('[testbed]\nname "x"\n', "line 2, column 6", "a key without a value", 'write key = "value"'),
        ("[testbed]\nname = x\n", "line 2, column 8", "not a value", "put texts and quantities into quotation"),
        ('[testbed]\nname = "x\n', "line 2, column 10", "a text that does not end", "close the quotation marks"),
        ('[testbed]\nname = "x', "line 2, column 10", "a text that does not end", "close the quotation marks"),
        ('[a]\nb = ["x"', "line 2, column 9", "a list that does not end", "close the bracket ]"),
        ('[a]\nb = { c = "x"', "line 2, column 14", "a table that does not end", "close the brace }"),
        ("[testbed\n", "line 1, column 9", "is no TOML (Expected ']'", "correct this line"),
        ('[a]\nb = "x"\nb = "y"\n', "line 3, column 8", "the key stands twice", "remove one, or rename it"),
        ('[a]\nb = { c = "x" }\n[a.b]\n', "line 3, column 5", "the table [a.b] stands twice", "merge the two"),
        (
            "[components.M1]\n[components.M1]\n",
            "line 2, column 15",
            "the table [components.M1] stands twice in the file",
            "merge the two, or rename one",
        ),
    ],
)
def test_syntax(tmp_path: Path, text: str, where: str, what: str, remedy: str) -> None:
    path = tmp_path / "bed.toml"
    path.write_text(text, encoding="utf-8")
    problem = only(path)
    assert problem.where == where
    assert problem.what.startswith(what)
    assert problem.remedy.startswith(remedy)


@pytest.mark.parametrize("text", ["a = " + "[" * 5000, "a = " + "9" * 5000, "a = 1" + "0" * 400])
def test_extremes(tmp_path: Path, text: str) -> None:
    path = tmp_path / "bed.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(TestbedError):
        load(path)


def test_empty_file_names_every_section(tmp_path: Path) -> None:
    path = tmp_path / "bed.toml"
    path.write_text("", encoding="utf-8")
    with pytest.raises(TestbedError) as caught:
        load(path)
    assert [problem.where for problem in caught.value.problems] == ["testbed", "components", "control"]
    assert all(problem.what == "is missing" for problem in caught.value.problems)
    assert "sample_time" in caught.value.problems[0].remedy

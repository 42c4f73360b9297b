"""Whatever stands in a file, reading it ends with a test bed or with problems, never with a traceback."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
from small_bed import BED

from ptgen.components.catalogue import CATALOGUE
from ptgen.errors import TestbedError
from ptgen.testbed import Scenario, Testbed, load, load_scenario
from ptgen.testbed.problems import dotted

ROOT = Path(__file__).parents[2]
TEXTS = [BED, *(path.read_text(encoding="utf-8") for path in sorted((ROOT / "testbeds").glob("*.toml")))]
SCENARIO = (ROOT / "scenarios" / "differential-run.toml").read_text(encoding="utf-8")
QUICK = settings(
    max_examples=150,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)


def read(folder: Path, content: bytes) -> Testbed | None:
    path = folder / "bed.toml"
    path.write_bytes(content)
    try:
        return load(path)
    except TestbedError as error:
        found = error
    assert found.problems
    for problem in found.problems:
        assert problem.what and problem.remedy
        assert "\n" not in problem.text(found.file)
    return None


@QUICK
@given(st.binary(max_size=300))
@example(b"\xff\xfe[\x00")
@example(b"a = 1e" + b"9" * 400)
def test_bytes(tmp_path: Path, content: bytes) -> None:
    assert read(tmp_path, content) is None


# --- tables that look like a bed

WORDS = ["M1", "M2", "flange1", "diff", "diff.input", "M1 - flange1 - M2", "100 us", "3 N m", "-1", "nan s", "", "x y"]
KEYS = ["testbed", "components", "control", "reduction", "name", "type", "sample_time", "connections", "torque"]
KEYS += ["speed", "M1", "flange1", "inertia", "stiffness", "inverter", "model", "keep", "assumed", "a.b", "", "é\n"]
LEAVES = st.one_of(
    st.sampled_from(WORDS),
    st.sampled_from(sorted(CATALOGUE)),
    st.text(max_size=8),
    st.integers(-(10**400), 10**400),
    st.floats(),
    st.booleans(),
)
VALUES = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3), st.dictionaries(st.sampled_from(KEYS) | st.text(max_size=5), inner, max_size=4)
    ),
    max_leaves=12,
)


def toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{quoted(key)} = {toml(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return quoted(value)
    return repr(value)


def quoted(text: str) -> str:
    return json.dumps(re.sub("[\ud800-\udfff]", "", text).replace("\x7f", ""))


def document(table: dict[str, Any]) -> bytes:
    return "\n".join(f"{quoted(key)} = {toml(value)}" for key, value in table.items()).encode()


@QUICK
@given(st.dictionaries(st.sampled_from(KEYS), VALUES, max_size=5))
def test_tables(tmp_path: Path, table: dict[str, Any]) -> None:
    assert read(tmp_path, document(table)) is None


SECTIONS = st.fixed_dictionaries(
    {
        "testbed": st.fixed_dictionaries(
            {"name": st.sampled_from(WORDS), "sample_time": LEAVES, "connections": st.lists(LEAVES, max_size=4)},
            optional={"assumed": VALUES, "title": VALUES},
        ),
        "components": st.dictionaries(
            st.sampled_from(KEYS),
            st.fixed_dictionaries(
                {"type": st.sampled_from(sorted(CATALOGUE))},
                optional=dict.fromkeys(("inertia", "stiffness", "ratio", "loss", "inverter"), VALUES),
            ),
            max_size=4,
        ),
        "control": VALUES | st.fixed_dictionaries({"torque": VALUES, "speed": VALUES}),
    },
    optional={"reduction": VALUES},
)


@QUICK
@given(SECTIONS)
def test_sections(tmp_path: Path, table: dict[str, Any]) -> None:
    read(tmp_path, document(table))


# --- mutations of real files


@st.composite
def mutated(draw: st.DrawFn, text: str) -> bytes:
    """Return the text with lines and words exchanged, doubled or removed, and a few bytes changed."""
    for _ in range(draw(st.integers(1, 3))):
        parts = re.split(r"(\n)" if draw(st.booleans()) else r"([\s\"=,.]+)", text)
        here, there = (draw(st.integers(0, len(parts) - 1)) for _ in range(2))
        match draw(st.sampled_from(["remove", "double", "exchange", "insert"])):
            case "remove":
                del parts[here]
            case "double":
                parts.insert(there, parts[here])
            case "exchange":
                parts[here], parts[there] = parts[there], parts[here]
            case "insert":
                parts.insert(here, draw(st.text(max_size=3) | LEAVES.map(toml)))
        text = "".join(parts)
    content = bytearray(text, "utf-8", "surrogatepass")
    if content and draw(st.integers(0, 4)) == 0:
        content[draw(st.integers(0, len(content) - 1))] = draw(st.integers(0, 255))
    return bytes(content)


@QUICK
@given(st.sampled_from(TEXTS).flatmap(mutated))
def test_mutations(tmp_path: Path, content: bytes) -> None:
    read(tmp_path, content)


@pytest.fixture(scope="module")
def differential() -> Testbed:
    return load(ROOT / "testbeds" / "differential.toml")


@QUICK
@given(mutated(SCENARIO) | VALUES.map(lambda value: document({"scenario": value, "references": value})))
def test_scenarios(tmp_path: Path, differential: Testbed, content: bytes) -> None:
    path = tmp_path / "scenario.toml"
    path.write_bytes(content)
    try:
        scenario = load_scenario(path, differential)
    except TestbedError as error:
        problems = error.problems
    else:
        assert isinstance(scenario, Scenario)
        return
    assert problems and all(problem.what and problem.remedy for problem in problems)


@QUICK
@given(st.binary(max_size=80), st.sampled_from([b"", b"t,n\n", b"t;n\n0;1\n"]))
def test_measurement_files(tmp_path: Path, differential: Testbed, content: bytes, start: bytes) -> None:
    (tmp_path / "run.csv").write_bytes(start + content)
    path = tmp_path / "scenario.toml"
    path.write_text(
        '[scenario]\nduration = "1 s"\nrecord_every = "1 ms"\n[references]\n'
        'speed.M2 = { file = "run.csv", time = "t", column = "n", unit = "rpm" }\n',
        encoding="utf-8",
    )
    try:
        load_scenario(path, differential)
    except TestbedError as error:
        places = [problem.where for problem in error.problems]
    else:
        return
    assert places and all(place.startswith("references.speed.M2.") for place in places)


def test_places_with_odd_keys() -> None:
    assert dotted("a", "b c", 3, "") == 'a."b c"[3].""'

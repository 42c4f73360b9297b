"""New values for keys of a bed file: all other bytes stay."""

from __future__ import annotations

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ptgen.errors import TestbedError
from ptgen.testbed.rewriting import with_control

spaces = st.text(" \t", max_size=3)
comments = st.one_of(st.just(""), st.text("abc #=[]\"'", max_size=8).map(lambda text: f" # {text}"))
KEYS = ("speed_bandwidth", "torque_bandwidth", "damping_ratio")
CHANGES = {"speed_bandwidth": "7 Hz", "torque_bandwidth": "3.21 rad/s", "damping_ratio": 0.71}
TEXTS = {"speed_bandwidth": '"7 Hz"', "torque_bandwidth": '"3.21 rad/s"', "damping_ratio": "0.71"}


@st.composite
def files(draw: st.DrawFn) -> tuple[list[str], list[str]]:
    """Return the lines of a file, and those that it has to have with `CHANGES`."""
    others = [
        'speed = ["M2", "M3"]',
        'torque = { M1 = "flange1" , }'.replace(" , ", " "),
        'speed_pairs = { rear = [ "M2",  "M3" ] }',
        "feedforward=0.5",
    ]
    entries: list[tuple[str, str]] = []
    for line in draw(st.lists(st.sampled_from(others), min_size=1, unique=True)):
        text = draw(spaces) + line + draw(spaces) + draw(comments)
        entries.append((text, text))
    present = draw(st.lists(st.sampled_from(KEYS), unique=True))
    for key in present:
        old = "1.0" if key == "damping_ratio" else '"30 rad/s"'
        start, end = f"{draw(spaces)}{key}{draw(spaces)}={draw(spaces)}", draw(spaces) + draw(comments)
        entries.append((start + old + end, start + TEXTS[key] + end))
    entries = draw(st.permutations(entries))
    gaps = st.lists(st.sampled_from(["", "# a comment", "  # speed_bandwidth = 3"]), max_size=2)
    before, after = ["# top"], ["# top"]
    for extra in (draw(gaps), ["[testbed]  # x", 'name="b"'], draw(gaps), ["[control]"]):
        before, after = before + extra, after + extra
    last = len(entries) - 1
    for k, (old_line, new_line) in enumerate(entries):
        extra = draw(gaps)
        indent = new_line[: len(new_line) - len(new_line.lstrip())]
        added = [f"{indent}{key} = {TEXTS[key]}" for key in CHANGES if key not in present] if k == last else []
        before, after = [*before, old_line, *extra], [*after, new_line, *added, *extra]
    for extra in (draw(gaps), draw(st.sampled_from([[], ["[control.losses.g]", "speed=[]"], ["[reduction]", ""]]))):
        before, after = before + extra, after + extra
    return before, after


@given(files(), st.sampled_from(["\n", "\r\n"]), st.sampled_from(["", "\ufeff"]), st.booleans())
def test_only_the_values_change(lines: tuple[list[str], list[str]], newline: str, mark: str, ended: bool) -> None:
    end = newline if ended else ""
    before, after = (mark + newline.join(part) + end for part in lines)
    assert with_control(before.encode(), CHANGES).decode() == after


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            'control = { speed = ["M2"],speed_bandwidth="1 Hz" } # z\n[testbed]\n',
            'control = { speed = ["M2"],speed_bandwidth="7 Hz" } # z\n[testbed]\n',
        ),
        ('control.speed = []\n[testbed]\n', 'control.speed = []\ncontrol.speed_bandwidth = "7 Hz"\n[testbed]\n'),
        ("[control]\nspeed_bandwidth = '1 Hz' # c\n", "[control]\nspeed_bandwidth = '7 Hz' # c\n"),
        ('["control"]\n"speed_bandwidth"="1 Hz"', '["control"]\n"speed_bandwidth"="7 Hz"'),
        (
            "[control.losses.g]\na=1\n[testbed]\n[control]\nspeed=[]\n\n# z\n[reduction]\n",
            '[control.losses.g]\na=1\n[testbed]\n[control]\nspeed=[]\nspeed_bandwidth = "7 Hz"\n\n# z\n[reduction]\n',
        ),
    ],
)  # fmt: skip
def test_other_ways_to_write_the_section(before: str, after: str) -> None:
    assert with_control(before.encode(), {"speed_bandwidth": "7 Hz"}).decode() == after
    assert tomllib.loads(after)["control"]["speed_bandwidth"] == "7 Hz"


def test_what_cannot_be_kept_is_not_touched(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tomlkit.dumps", lambda document: "something else")
    with pytest.raises(TestbedError, match='write it yourself: speed_bandwidth = "7 Hz"') as caught:
        with_control(b"[control]\n", {"speed_bandwidth": "7 Hz"}, "bed.toml")
    assert caught.value.file == "bed.toml"

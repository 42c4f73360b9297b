"""What hands over the load, and what changes without load before and after it."""

from __future__ import annotations

import functools

import pytest
from test_freewheels import TABLE, two_speed

from ptgen.gears import GearAnalysis, analyse_gears, handover, layout_of_part, way_round
from ptgen.testbed.parts import read_part, shipped_parts


@functools.cache
def analysis(part: str) -> GearAnalysis:
    kind = read_part(shipped_parts()[f"{part}.toml"])
    component = kind.model_validate({"type": "part", "file": f"{part}.toml"})
    return analyse_gears(layout_of_part(component), component.gear_elements())


def order(part: str, start: str, end: str) -> str:
    """Return before | release, between, apply | after, as signed elements."""
    found = handover(analysis(part), start, end)
    assert found is not None

    def signed(opening: tuple[str, ...], closing: tuple[str, ...]) -> str:
        return " ".join([*(f"-{name}" for name in opening), *(f"+{name}" for name in closing)])

    middle = [signed(found.release, ()), signed(found.between.release, found.between.apply), signed((), found.apply)]
    return " | ".join(
        [
            signed(found.before.release, found.before.apply),
            " ".join(part for part in middle if part),
            signed(found.after.release, found.after.apply),
        ]
    )


@pytest.mark.parametrize(
    ("part", "start", "end", "wanted"),
    [
        ("seven-speed-dual-clutch", "1", "2", "+S2 | -K1 +K2 | -S1"),
        ("seven-speed-dual-clutch", "2", "1", "+S1 | -K2 +K1 | -S2"),
        ("seven-speed-dual-clutch", "R", "1", "+S1 | -K2 +K1 | -SR"),
        ("seven-speed-dual-clutch", "1", "7", " | -K1 -S1 +S7 +K1 | "),
        ("seven-speed-dual-clutch", "R", "2", " | -K2 -SR +S2 +K2 | "),
        ("seven-speed-dual-clutch", "N", "4", "+S4 | +K2 | "),
        ("seven-speed-dual-clutch", "4", "N", " | -K2 | -S4"),
        ("nine-speed", "1", "2", " | -B +D | "),
        ("nine-speed", "2", "4", " | -E +F | -D +B"),
        ("nine-speed", "4", "6", "-B +D | -C +E | "),
        ("nine-speed", "4", "8", "-B +A | -C +E | "),
        ("nine-speed", "1", "6", " | -B -C +D +F | "),
        ("nine-speed", "N", "1", "+B +E | +C | "),
        ("six-speed-lepelletier", "1", "2", " | -D +C | "),
    ],
)
def test_order_of_the_elements(part: str, start: str, end: str, wanted: str) -> None:
    assert order(part, start, end) == wanted


@pytest.mark.parametrize(
    ("part", "start", "end", "why", "through"),
    [
        ("seven-speed-dual-clutch", "1", "3", "S1 and S3 hold", "2"),
        ("seven-speed-dual-clutch", "7", "1", "S7 and S1 hold", "4"),
        ("seven-speed-dual-clutch", "R", "2", "SR and S2 hold", "1"),
        ("nine-speed", "1", "6", "B, D and E could", "4"),
        ("nine-speed", "R", "2", "ties up", "1"),
        ("six-speed-lepelletier", "1", "5", "ties up", "3"),
    ],
)
def test_what_must_not_overlap_says_why_and_knows_a_way_round(
    part: str, start: str, end: str, why: str, through: str
) -> None:
    found = analysis(part)
    way = handover(found, start, end)
    assert way is not None and why in way.obstacle
    assert way_round(found, start, end) == through


@pytest.mark.parametrize("part", ["nine-speed", "six-speed-lepelletier", "seven-speed-dual-clutch"])
def test_every_shift_arrives(part: str) -> None:
    found = analysis(part)
    gears = {gear.name: set(gear.engaged) for gear in found.listed} | {"N": set(found.neutral or ())}
    for start, held in gears.items():
        for end in gears.keys() - {start}:
            way = handover(found, start, end)
            assert way is not None
            now = set(held)
            for opening, closing in (
                (way.before.release, way.before.apply),
                (way.release, ()),
                (way.between.release, way.between.apply),
                ((), way.apply),
                (way.after.release, way.after.apply),
            ):
                assert now >= set(opening) and not now & set(closing)
                now = (now - set(opening)) | set(closing)
            assert now == gears[end], (start, end)


def test_freewheels_are_left_to_themselves() -> None:
    found = analyse_gears(two_speed(), TABLE)
    up, down = handover(found, "1", "2"), handover(found, "2", "1")
    assert up is not None and (up.release, up.apply, up.obstacle) == ((), ("K",), "")
    assert down is not None and (down.release, down.apply, down.obstacle) == (("K",), (), "")
    assert handover(found, "1", "3") is None and way_round(found, "1", "3") is None

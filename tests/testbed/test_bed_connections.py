"""Chains, topology, loops and roles of a test bed file."""

from __future__ import annotations

import pytest
from small_bed import BED, Bench

MACHINE = """
[components.{0}]
type = "machine"
inertia = "1 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"
"""
SHAFT = '\n[components.{0}]\ntype = "shaft"\nstiffness = "50 kN m/rad"\n'
FLANGE = '\n[components.{0}]\ntype = "torque_flange"\nstiffness = "380 kN m/rad"\ninertia = "0.03 kg m^2"\n'
INERTIA = '\n[components.{0}]\ntype = "inertia"\ninertia = "1 kg m^2"\n'
GEARBOX = '\n[components.{0}]\ntype = "gearbox"\nratio = {1}\ninertia = "1 kg m^2"\n'
DIFF = '\n[components.{0}]\ntype = "differential"\nratio = 2\ninertia = "1 kg m^2"\ninertia_pinion = "1 kg m^2"\n'


def bed(chains: list[str], *components: str, torque: str = "", speed: str = "") -> str:
    head = f'[testbed]\nname = "bed"\nsample_time = "1 ms"\nconnections = {chains}\n'.replace("'", '"')
    return head + "".join(components) + f"\n[control]\ntorque = {{ {torque} }}\nspeed = [{speed}]\n"


def two(chains: list[str], *components: str) -> str:
    """Return a bed of two speed-controlled machines and other components."""
    return bed(chains, MACHINE.format("M1"), MACHINE.format("M2"), *components, speed='"M1", "M2"')


# --- how chains are followed


@pytest.mark.parametrize(
    ("chains", "links", "backward"),
    [
        (["M1 - f - s - M2"], ["M1.shaft f.machine", "f.uut s.left", "s.right M2.shaft"], set()),
        (["M1 - s - f - M2"], ["M1.shaft s.left", "s.right f.uut", "f.machine M2.shaft"], {"f"}),
        (["M1 - f.uut - s - M2"], ["M1.shaft f.uut", "f.machine s.left", "s.right M2.shaft"], {"f"}),
        (["M1 - f - s.right - M2"], ["M1.shaft f.machine", "f.uut s.right", "s.left M2.shaft"], {"s"}),
        (["M1 - f", "f - s - M2"], ["M1.shaft f.machine", "f.uut s.left", "s.right M2.shaft"], set()),
        (["f - s - M2", "M1 - f"], ["f.uut s.left", "s.right M2.shaft", "M1.shaft f.machine"], set()),
        (["M1 - s - f", "f - M2"], ["M1.shaft s.left", "s.right f.uut", "f.machine M2.shaft"], {"f"}),
        (["M1 - f", "f.machine - s - M2"], ["M1.shaft f.uut", "f.machine s.left", "s.right M2.shaft"], {"f"}),
        (["M1 - s.right", "s.left - f - M2"], ["M1.shaft s.right", "s.left f.uut", "f.machine M2.shaft"], {"s", "f"}),
        (["M2 - s  -\tf - M1"], ["M2.shaft s.left", "s.right f.uut", "f.machine M1.shaft"], {"f"}),
    ],
)
def test_chains(bench: Bench, chains: list[str], links: list[str], backward: set[str]) -> None:
    text = two(chains, FLANGE.format("f"), SHAFT.format("s")).replace("\t", "\\t")
    read = bench.load(text)
    assert [f"{link.left} {link.right}" for link in read.connections] == links
    assert {name for name, sign in read.orientation.items() if sign == -1} == backward


def test_torque_flange_between_two_machines_faces_the_left_one(bench: Bench) -> None:
    assert bench.load(two(["M1 - f - M2"], FLANGE.format("f"))).orientation["f"] == 1


def test_torque_flange_faces_the_nearer_machine_beyond_other_parts(bench: Bench) -> None:
    parts = (SHAFT.format("s"), INERTIA.format("j"), FLANGE.format("f"), SHAFT.format("t"))
    assert bench.load(two(["M1 - s - j - f - t - M2"], *parts)).orientation["f"] == -1


# --- mistakes in chains


@pytest.mark.parametrize(
    ("chains", "what", "remedy"),
    [
        (["M1 - s - M2", "M1"], "at least two components", 'separate them by " - "'),
        (["M1 - s - M2", ""], "at least two components", 'separate them by " - "'),
        (["M1 - s - M2", "M1-s - M2"], "names no component", 'separate components by " - " with spaces'),
        (["M1 - s - M2", "M1 - t"], '"t" names no component', "known are: M1, M2, s"),
        (["M1 - s - M2", "M1 - M22"], '"M22" names no component', 'did you mean "M2"?'),
        (["M1 - s - M2", "s.lft - M2"], '"s.lft" names no flange: "s" is a shaft', 'did you mean "left"?'),
        (["M1 - s - M2", "s. - M2"], '"s." names no flange', "known are: left, right"),
        (["M1 - s - M2", "s - M1 - s"], '"M1" stands in the middle of a chain, but has one', 'end the chain at "M1"'),
    ],
)
def test_mistakes_in_chains(bench: Bench, chains: list[str], what: str, remedy: str) -> None:
    problem = bench.problem(two(chains, SHAFT.format("s")), "testbed.connections[1]")
    assert what in problem.what and remedy in problem.remedy


def test_differential_flange_must_be_named(bench: Bench) -> None:
    problem = bench.problem(two(["M1 - d"], DIFF.format("d")), "testbed.connections[0]")
    assert problem.what == '"d" has 3 flanges, and none is named'
    assert problem.remedy == 'write "d.input" or "d.output1" or "d.output2"'


def test_differential_in_the_middle(bench: Bench) -> None:
    problem = bench.problem(two(["M1 - d.input - M2"], DIFF.format("d")), "testbed.connections[0]")
    assert "stands in the middle of a chain, but has 3 flanges" in problem.what
    assert problem.remedy == 'end the chain at "d" and begin another one there'


# --- topology


def test_flange_connected_twice(bench: Bench) -> None:
    found = bench.problems(two(["M1 - s - M2", "M1 - t - j"], *map(SHAFT.format, "st"), INERTIA.format("j")))
    problem = found["testbed.connections[1]"]
    assert problem.what.startswith('"M1.shaft" is connected twice, to "s.left" and to "t.left"')
    assert problem.remedy == "remove one connection, or name the flanges that are meant"


def test_flange_left_open(bench: Bench) -> None:
    text = two(["M1 - d.input", "d.output1 - M2"], DIFF.format("d"))
    problem = bench.problem(text, "components.d")
    assert problem.what == 'flange "d.output2" is not connected'
    assert "connect it in testbed.connections" in problem.remedy


def test_inertia_may_end_a_shaft(bench: Bench) -> None:
    text = two(["M1 - d.input", "d.output1 - M2", "d.output2 - j"], DIFF.format("d"), INERTIA.format("j"))
    assert len(bench.load(text).connections) == 3


def test_component_never_connected(bench: Bench) -> None:
    problem = bench.problem(two(["M1 - s - M2"], SHAFT.format("s"), SHAFT.format("t")), "components.t")
    assert problem.what == "is never connected"
    assert problem.remedy == 'add "t" to a chain in testbed.connections, or remove the component'


def test_separate_parts(bench: Bench) -> None:
    text = two(["M1 - s - j", "i - t - M2"], *map(SHAFT.format, "st"), *map(INERTIA.format, "ij"))
    problem = bench.problem(text, "testbed.connections")
    assert problem.what == "the bed falls into 2 parts that are not connected: (M1, s, j) and (M2, t, i)"
    assert problem.remedy == "connect them, or describe each part as a bed of its own"


def test_component_connected_to_itself(bench: Bench) -> None:
    found = bench.problems(two(["M1 - M2", "s.right - s.left"], SHAFT.format("s")))
    problem = found["testbed.connections[1]"]
    assert problem.what == 'connects "s" to itself ("s.right" to "s.left")'
    assert problem.remedy == "put a component between the flanges, or name the right one"


def test_chains_in_opposite_directions(bench: Bench) -> None:
    text = two(["s.left - M1", "s.right - M2"], SHAFT.format("s"))
    problem = bench.problem(text, "components.s")
    assert "opposite directions" in problem.what and "turn one of the chains around" in problem.remedy
    assert bench.load(two(["j.left - M1", "j.right - M2"], INERTIA.format("j"))).orientation["j"] == 1


# --- rigid loops


@pytest.mark.parametrize(("first", "second"), [(1.0, 1.0), (2.5, 0.4), (3.3, 7.7), (-1.0, 2.0)])
def test_loop_that_can_turn(bench: Bench, first: float, second: float) -> None:
    """Two differentials whose outputs are joined in pairs keep a degree of freedom whatever the ratios."""
    parts = (DIFF.format("d"), DIFF.format("e"), GEARBOX.format("g", first), GEARBOX.format("h", second))
    chains = ["M1 - d.input", "d.output1 - g - e.output1", "d.output2 - h - e.output2", "M2 - e.input"]
    assert bench.load(two(chains, *parts)).name == "bed"


def test_contradiction_names_the_smallest_set(bench: Bench) -> None:
    """A gearbox that turns one output of a differential against the other holds its input."""
    parts = (MACHINE.format("M1"), SHAFT.format("s"), DIFF.format("d"), GEARBOX.format("a", "-1.0"))
    text = bed(["M1 - s - d.input", "d.output1 - a - d.output2"], *parts, speed='"M1"')
    problem = bench.problem(text, "testbed.connections")
    assert problem.what.startswith("the rigid loop through d, a has gear ratios that contradict each other")
    assert problem.what.endswith('(at rest: "d.input")')
    assert bench.load(text.replace("ratio = -1.0", "ratio = -1.0001")).name == "bed"
    assert problem.remedy == "correct a ratio (all decimals count), or put a shaft into the loop"


def test_shaft_opens_a_loop(bench: Bench) -> None:
    parts = (DIFF.format("d"), GEARBOX.format("a", "-1.0"), SHAFT.format("s"), SHAFT.format("t"))
    chains = ["M1 - s - d.input", "d.output1 - a - t - d.output2"]
    assert bench.load(bed(chains, MACHINE.format("M1"), *parts, speed='"M1"')).machines == ("M1",)


# --- roles


def roles(torque: str, speed: str) -> str:
    start = BED.index("[control]")
    return BED[:start] + f"[control]\ntorque = {{ {torque} }}\nspeed = [{speed}]\n"


@pytest.mark.parametrize(
    ("torque", "speed", "where", "what", "remedy"),
    [
        ("", "", "control", "no machine has a role: there are 2", "write e.g. torque = "),
        ('M1 = "flange1"', "", "control", "M2 has no role (2 machines, 1 controlled", "add it to control.speed"),
        ('M1 = "flange1"', '"M2", "M1"', "control.speed[1]", '"M1" has two roles', 'remove "M1"'),
        ('M1 = "flange1"', '"M2", "M2"', "control.speed[1]", '"M2" is listed twice', "remove one"),
        ('M1 = "flange1"', '"M2", "M3"', "control.speed[1]", '"M3" is no machine of the bed', "known are: M1, M2"),
        ('M1 = "flange1"', '"M2", "shaft1"', "control.speed[1]", '"shaft1" is a shaft, and only a', "M1, M2"),
        ('M1 = "flange1", M2 = "flange1"', "", "control.torque.M2", '"flange1" is controlled twice', "another place"),
        ('M1 = "flang1"', '"M2"', "control.torque.M1", '"flang1" names no component', 'did you mean "flange1"?'),
        ('M1 = "flange1.lft"', '"M2"', "control.torque.M1", "no torque is defined", '"flange1.uut"'),
        ('M1 = "M2"', '"M2"', "control.torque.M1", '"M2" is a machine, where no torque', '"shaft1.right"'),
        ('M1 = "M1.shaft"', '"M2"', "control.torque.M1", "is a machine", 'that it drives, "flange1.machine"'),
        ('flange1 = "flange1"', '"M1", "M2"', "control.torque.flange1", "is a torque_flange, and only", "M1, M2"),
    ],
)
def test_mistakes_in_roles(bench: Bench, torque: str, speed: str, where: str, what: str, remedy: str) -> None:
    found = bench.problems(roles(torque, speed))
    problem = found.pop(where)
    assert what in problem.what and remedy in problem.remedy
    assert all(other.what.startswith("more controlled quantities") for other in found.values()), found


def test_more_quantities_than_machines(bench: Bench) -> None:
    problem = bench.problems(roles('M1 = "flange1", M2 = "shaft1"', '"M2"'))["control"]
    assert problem.what == "more controlled quantities than machines (2 machines, 3 controlled quantities)"
    assert problem.remedy == "give every machine one role"


@pytest.mark.parametrize("place", ["flange1", "shaft1", "flange1.uut", "shaft1.left"])
def test_places_of_two_flange_components(bench: Bench, place: str) -> None:
    assert bench.load(roles(f'M1 = "{place}"', '"M2"')).roles.torque == {"M1": place}


def test_places_of_a_differential(bench: Bench) -> None:
    chains = ["M1 - d.input", "d.output1 - M2", "d.output2 - j"]
    parts = (MACHINE.format("M1"), MACHINE.format("M2"), DIFF.format("d"), INERTIA.format("j"))
    for place in ("d.outputs", "d.input", "d.output2", "j.left"):
        assert bench.load(bed(chains, *parts, torque=f'M1 = "{place}"', speed='"M2"')).roles.torque["M1"] == place
    problem = bench.problem(bed(chains, *parts, torque='M1 = "j.right"', speed='"M2"'), "control.torque.M1")
    assert problem.what == '"j.right" is not connected, so it carries no torque'
    assert problem.remedy == "choose a flange that is connected"
    for place, hint in (("d", "known are: d.input, d.output1"), ("j", "j.left"), ("d.output", '"d.outputs"')):
        text = bed(chains, *parts, torque=f'M1 = "{place}"', speed='"M2"')
        assert hint in bench.problem(text, "control.torque.M1").remedy


def test_bed_without_machines(bench: Bench) -> None:
    text = bed(["i - s - j"], INERTIA.format("i"), SHAFT.format("s"), INERTIA.format("j"))
    problem = bench.problem(text, "components")
    assert problem.what == "the bed has no machine" and 'type = "machine"' in problem.remedy
    assert bench.problems(text.replace("[control]", "[contrl]")).keys() == {"components", "control", "contrl"}


def test_empty_control(bench: Bench) -> None:
    problem = bench.problem(BED[: BED.index("[control]")] + "[control]\n", "control")
    assert problem.what == "no machine has a role: there are 2" and "torque = " in problem.remedy


def test_missing_control(bench: Bench) -> None:
    problem = bench.problem(BED[: BED.index("[control]")], "control")
    assert problem.what == "is missing" and "add [control]" in problem.remedy


def test_component_of_unknown_type_is_no_unknown_component(bench: Bench) -> None:
    text = two(["M1 - s - M2", "M1 - ss"], SHAFT.format("s").replace('"shaft"', '"shaf"'))
    found = bench.problems(text)
    assert set(found) == {"components.s.type", "testbed.connections[1]"}
    assert found["testbed.connections[1]"].remedy == 'did you mean "s"?'

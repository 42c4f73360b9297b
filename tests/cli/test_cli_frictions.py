"""Friction elements on the command line: their kinds, those that hold the same motion, actuations, methods."""

from __future__ import annotations

import pytest

MACHINE = """
[components.{name}]
type = "machine"
inertia = "1 kg m^2"
torque_max = "500 N m"
speed_rated = "3000 rpm"
speed_max = "6000 rpm"
"""

FLANGE = """
[components.{name}]
type = "torque_flange"
inertia = "0.03 kg m^2"
stiffness = "38 kN m/rad"
"""

BRAKED = f"""\
[testbed]
name = "braked"
sample_time = "100 us"
connections = ["M1 - flange1 - brakeA - brakeB - flange2 - M2"]
{MACHINE.format(name="M1")}
{MACHINE.format(name="M2")}
{FLANGE.format(name="flange1")}
{FLANGE.format(name="flange2")}

[components.brakeA]
type = "brake"
capacity = "200 N m"

[components.brakeB]
type = "brake"
capacity = "100 N m"
static = "120 N m"
actuated = false

[control]
torque = {{ M1 = "flange1" }}
speed = ["M2"]
"""

SENTENCE = '"brakeA" and "brakeB" hold the same motion: their torques are not unique, those of least norm are reported'

SCENARIO = """\
[scenario]
duration = "5 ms"
record_every = "1 ms"

[actuations]
{entry}
"""


@pytest.fixture
def braked(tmp_path):
    path = tmp_path / "braked.toml"
    path.write_text(BRAKED, encoding="utf-8")
    return path


@pytest.fixture
def scenario(tmp_path):
    def written(entry):
        path = tmp_path / "case.toml"
        path.write_text(SCENARIO.format(entry=entry), encoding="utf-8")
        return path

    return written


def test_check_lists_friction_elements_and_what_they_share(cli, braked):
    text = cli("check", braked).stdout
    assert "\n    brakeA: coupling, actuated\n    brakeB: coupling, stronger at rest\n" in text
    assert SENTENCE in text
    found = cli.json("check", braked)
    assert found["dependent"] == [["brakeA", "brakeB"]]
    assert found["friction_elements"] == [
        {"name": "brakeA", "kinds": ["coupling", "actuated"]},
        {"name": "brakeB", "kinds": ["coupling", "stronger at rest"]},
    ]


def test_independent_elements_share_nothing(cli):
    found = cli.json("check", "testbeds/differential.toml")
    assert found["dependent"] == []
    assert [element["name"] for element in found["friction_elements"]] == found["frictions"]
    assert all("load-dependent" in element["kinds"] for element in found["friction_elements"])
    assert "hold the same" not in cli("check", "testbeds/differential.toml").stdout
    assert "friction elements" not in cli("check", "testbeds/back-to-back.toml").stdout


def test_modal_tells_when_locked_elements_share_a_motion(cli, braked):
    lock = ("--lock", "brakeA", "--lock", "brakeB")
    found = cli.json("modal", braked, *lock)
    assert (found["dependent"], found["locked"], found["free"]) == ([["brakeA", "brakeB"]], ["brakeA", "brakeB"], [])
    assert SENTENCE in cli("modal", braked, *lock).stdout
    assert cli.json("modal", braked, "--lock", "brakeA")["dependent"] == []
    assert "hold the same" not in cli("modal", braked, "--lock", "brakeB").stdout
    assert len(cli.json("modal", braked, "--lock", "brakeA")["modes"]) == len(found["modes"])


def test_three_elements_that_share_two_motions(cli, tmp_path):
    """A clutch between two braked shafts: each two of the three hold everything."""
    clutch = '[components.clutch1]\ntype = "clutch"\ncapacity = "100 N m"\n\n[control]'
    path = tmp_path / "three.toml"
    text = BRAKED.replace("brakeA - brakeB", "brakeA - clutch1 - brakeB").replace("[control]", clutch)
    path.write_text(text, encoding="utf-8")
    found = cli.json("modal", path, *(part for name in ("brakeA", "clutch1", "brakeB") for part in ("--lock", name)))
    assert [set(names) for names in found["dependent"]] == [{"brakeA", "clutch1", "brakeB"}]
    two = cli.json("modal", path, "--lock", "brakeA", "--lock", "brakeB")
    assert two["dependent"] == []


def test_problems_of_actuations_are_told(cli, braked, scenario):
    entries = 'brakeA = { time = ["0 s"], value = [2] }\nbrakeB = { time = ["0 s"], value = [1] }\nbrakeC = 1'
    path = scenario(entries)
    problems = cli.json("simulate", braked, "-s", path, code=2)["problems"]
    assert {problem["where"]: problem["remedy"] for problem in problems} == {
        "actuations.brakeA.value[0]": "write 0 for open, 1 for the full capacity, or a share in between",
        "actuations.brakeB": "write actuated = true in [components.brakeB] of the bed, or leave it out",
        "actuations.brakeC": 'did you mean "brakeA"?',
    }
    assert {problem["file"] for problem in problems} == {str(path)}


@pytest.mark.compile
@pytest.mark.parametrize("method", ["emitted", "events"])
def test_simulate_with_each_method(cli, braked, scenario, method):
    path = scenario('brakeA = { time = ["0 s", "2 ms"], value = [0, 1] }')
    found = cli.json("simulate", braked, "-s", path, "--method", method)
    assert (found["method"], found["steps"]) == (method, 50)
    assert found["signals"]["brakeA_actuation"]["final"] == 1.0
    assert "brakeA_actuation" in cli("simulate", braked, "-s", path, "--method", method).stdout


def test_simulate_knows_its_methods(cli, braked, scenario):
    assert "events" in cli("simulate", braked, "-s", scenario(""), "--method", "exact", code=2).output

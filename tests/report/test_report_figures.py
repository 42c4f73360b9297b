"""Figures: what they show, and that nothing lies on top of anything."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import numpy as np
import pytest
from components.loose_component import CASES, case
from hypothesis import given
from hypothesis import strategies as st
from mechanism.bed_text import differential_bed

from ptgen.components.catalogue import CATALOGUE
from ptgen.components.inertia import Inertia
from ptgen.components.shaft import Shaft
from ptgen.errors import PtgenError
from ptgen.mechanism.modes import modes
from ptgen.project import Project
from ptgen.report.bed_drawing import bed_figure
from ptgen.report.bed_layout import layout
from ptgen.report.bed_symbols import _SYMBOLS
from ptgen.report.bed_tree import chains, component_lines
from ptgen.report.destinations import check_destination
from ptgen.report.figures import save_figure
from ptgen.report.modes_figure import modes_figure, paths
from ptgen.report.quantities import readable
from ptgen.report.recording_figure import panels, recording_figure
from ptgen.simulate.recording import Recording
from ptgen.testbed import Connection, ReductionSettings, Roles, Testbed, Tuning


def bed_of(components, connections):
    orientation = dict.fromkeys(components, 1)
    return Testbed(
        "x", "x", "x.toml", "", 1e-4, components, connections, orientation, Roles({}, ()), Tuning(), ReductionSettings()
    )


@st.composite
def beds(draw):
    """Any topology: trees, loops, parts that do not hang together, either direction."""
    kinds = draw(st.lists(st.sampled_from(sorted(CATALOGUE)), min_size=1, max_size=14))
    # The layout needs the flanges of a component only, none of its values.
    components = {f"{kind}{index}": CATALOGUE[kind].model_construct() for index, kind in enumerate(kinds)}
    flanges = [f"{name}.{flange}" for name, part in components.items() for flange in part.flange_names()]
    shuffled = draw(st.permutations(flanges))
    pairs = list(zip(shuffled[::2], shuffled[1::2], strict=False))
    kept = draw(st.integers(0, len(pairs)))
    connections = [Connection(a, b) for a, b in pairs[:kept] if a.partition(".")[0] != b.partition(".")[0]]
    return bed_of(components, tuple(connections))


@given(beds())
def test_nothing_is_laid_out_on_top_of_anything(bed):
    found = layout(bed)
    assert set(found.places) == set(bed.components)
    assert len(found.wires) == len(bed.connections)
    points = [*found.places.values(), *(point for wire in found.wires for point in wire.passes)]
    for (x0, y0), (x1, y1) in itertools.combinations(points, 2):
        assert x0 != x1 or abs(y0 - y1) >= 1 - 1e-9
    for wire in found.wires:
        ends = [found.places[flange.partition(".")[0]][0] for flange in (wire.left, wire.right)]
        way = [ends[0], *(x for x, _ in wire.passes), ends[1]]
        assert all(abs(b - a) <= 1 for a, b in itertools.pairwise(way))
    assert found == layout(bed)


def test_a_chain_is_straight_and_runs_to_the_right():
    parts = {f"s{k}": Shaft(type="shaft", stiffness="1 N m/rad") for k in range(6)}
    bed = bed_of(parts, tuple(Connection(f"s{k}.right", f"s{k + 1}.left") for k in range(5)))
    assert list(layout(bed).places.values()) == [(float(k), 0.0) for k in range(6)]


def test_outputs_stand_in_their_order(projects):
    places = layout(projects["differential"].testbed).places
    assert places["M1"][1] == places["diff"][1] == (places["M2"][1] + places["M3"][1]) / 2
    assert places["M2"][1] > places["M3"][1]
    assert places["cardan2"][1] == places["flange2"][1] == places["M2"][1]


def texts(figure):
    return {text.get_text() for axes in figure.axes for text in axes.texts}


def test_every_component_is_drawn_with_its_name(project):
    assert set(project.testbed.components) <= texts(bed_figure(project.testbed))


@pytest.mark.parametrize("kind", sorted(CATALOGUE))
def test_every_type_of_component_can_be_drawn(kind, tmp_path):
    class Bare(Inertia):
        type_name = kind
        flanges = CATALOGUE[kind].flanges

    bed = bed_of({"part": Bare(type="inertia", inertia="1 kg m^2")}, ())
    save_figure(bed_figure(bed), tmp_path / "bed.svg")
    assert (tmp_path / "bed.svg").stat().st_size > 1000


def test_every_type_of_component_has_a_symbol():
    """What has none becomes a box with its name in it."""
    assert {*CATALOGUE, "part"} == set(_SYMBOLS)


@pytest.mark.parametrize("name", CASES)
def test_values_of_every_example_are_drawn(name):
    component = case(name)
    drawn = texts(bed_figure(bed_of({"part": component}, ())))
    assert "part" in drawn
    (values,) = [text for text in drawn if any(digit.isdigit() for digit in text)] or [""]
    for key, word in (("backlash", "gap 0.5 deg"), ("play", "gap 0.1 deg"), ("capacity", "300 N m")):
        assert (getattr(component, key, None) is not None) == (word in values)


@pytest.mark.parametrize("name", CASES)
def test_tree_shows_every_value_in_the_units_of_people(name):
    component = case(name)
    lines = "\n".join(component_lines(bed_of({"part": component}, ()), "part"))
    assert all(key in lines for key, value in component if value is not None and key != "type")
    assert " rad" not in re.sub(r"/rad|rad/s", "", lines)
    assert "True" not in lines and "False" not in lines


def test_names_do_not_overlap(project):
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure = bed_figure(project.testbed)
    renderer = FigureCanvasAgg(figure).get_renderer()
    boxes = [text.get_window_extent(renderer) for text in figure.axes[0].texts if text.get_text()]
    for a, b in itertools.combinations(boxes, 2):
        assert not a.overlaps(b), (a, b)
    assert all(figure.bbox.contains(*corner) for box in boxes for corner in (box.min, box.max))


def test_chains_pass_every_connection(project):
    bed = project.testbed
    found = chains(bed)
    ends = {"all_wheel_drive": 7, "back_to_back": 1, "clutch_rig": 1, "transmission": 1, "transmission_fixed_gear": 1}
    assert len(found) == ends.get(bed.name, 3)
    assert sum(len(chain) for chain in found) == 2 * len(bed.connections)


def test_paths_hold_every_velocity_once(project):
    shape = modes(project.model)[0].shape
    found = paths(project.testbed, list(shape))
    names = [name for path in found for name in path.bodies]
    assert sorted(names) == sorted(shape)
    assert all(len(path.elastic) == len(path.bodies) - 1 for path in found)
    assert found[0].bodies[0] == "M1.shaft"


def test_gears_are_no_shafts(projects):
    project = projects["differential_gearboxes"]
    trunk = paths(project.testbed, list(modes(project.model)[0].shape))[0]
    assert trunk.bodies == ("M1.shaft", "flange1.uut", "gearbox1.input", "gearbox1.output", "diff.input")
    assert trunk.elastic == (True, True, False, True)


def test_rigid_modes_share_their_axes(project):
    found = modes(project.model)
    figure = modes_figure(found, project.testbed)
    drawn = [axes.get_title(loc="left") for axes in figure.axes if axes.get_visible()]
    elastic = [mode for mode in found if mode.frequency_hz > 0]
    assert len(drawn) == len(elastic) + 1
    assert drawn[0].startswith("rigid body")
    first = elastic[0]
    assert drawn[1] == f"{first.frequency_hz:.3g} Hz, damping {100 * first.damping_ratio:.3g} %"


@pytest.fixture
def recording(project):
    time = np.linspace(0.0, 1.0, 50)
    names = [signal.name for signal in (*project.plant.outputs, *project.controller.outputs)]
    names += list(project.design.controller.references.values())
    random = np.random.default_rng(0)
    signals = {name: random.normal(size=50) for name in names}
    units = {name: "rad/s" if "speed" in name else "N m" for name in names}
    return Recording(time, signals, units, 10_000, 0.1, 1e-4)


def test_recordings_are_drawn_in_panels(project, recording, tmp_path):
    drawn = {panel.title: panel for panel in panels(recording, project)}
    slips = {"friction velocities", "friction torques"} if project.model.frictions else set()
    wanted = {"speeds", "measured torques", "air-gap torques, commanded"}
    wanted |= {"controlled torque"} if project.testbed.roles.torque else set()
    assert set(drawn) == wanted | slips
    machines = len(project.testbed.machines)
    styles = [curve.style for curve in drawn["speeds"].curves]
    assert styles.count("signal") == machines
    assert styles.count("reference") == len(project.testbed.roles.speed)
    assert [curve.style for curve in drawn["air-gap torques, commanded"].curves].count("limit") == 2 * machines
    figure = recording_figure(recording, project, title="a run")
    assert [axes.get_title(loc="left") for axes in figure.axes] == list(drawn)
    assert figure.axes[0].get_ylabel() == "rpm"
    save_figure(figure, tmp_path / "run.svg")


def test_limits_follow_the_envelope(projects):
    project = projects["back_to_back"]
    rated = project.model.values[project.model.inputs[0].drive.speed_rated]
    speed = np.array([0.0, rated, -2 * rated])
    signals = {"M1_speed": speed, "M1_torque_ref": np.zeros(3)}
    found = panels(Recording(np.arange(3.0), signals, {}, 3, 1.0, 1.0), project)
    limits = [c.values for panel in found for c in panel.curves if c.style == "limit"]
    np.testing.assert_allclose(limits, [[3050, 3050, 1525], [-3050, -3050, -1525]])


def test_peaks_survive_in_long_recordings(projects):
    project = projects["back_to_back"]
    size = 1_000_001
    speed = np.zeros(size)
    speed[654_321] = 100.0
    recording = Recording(np.arange(size) * 1e-4, {"M1_speed": speed}, {"M1_speed": "rad/s"}, size, 1.0, 1e-4)
    (line,) = recording_figure(recording, project).axes[0].lines
    assert len(line.get_xdata()) < 50_000
    assert line.get_ydata().max() == pytest.approx(954.93, abs=0.01)
    assert (line.get_xdata()[0], line.get_xdata()[-1]) == (0.0, pytest.approx(100.0))


@pytest.mark.parametrize("suffix", ["svg", "pdf", "png"])
def test_equal_figures_are_equal_files(projects, tmp_path, suffix):
    bed = projects["differential"].testbed
    files = [tmp_path / f"{name}.{suffix}" for name in "ab"]
    for path in files:
        save_figure(bed_figure(bed), path)
    assert files[0].read_bytes() == files[1].read_bytes()


def test_destinations(tmp_path):
    check_destination(tmp_path / "a.SVG", (".svg", ".png"), "-o")
    for path, word in (
        (tmp_path / "a.gif", ".svg or .png"),
        (tmp_path / "a", "none"),
        (tmp_path / "none" / "a.svg", "does not exist"),
    ):
        with pytest.raises(PtgenError, match=word):
            check_destination(path, (".svg", ".png"), "-o")
    Path(tmp_path / "folder.svg").mkdir()
    with pytest.raises(PtgenError, match="is a folder"):
        check_destination(tmp_path / "folder.svg", (".svg", ".png"), "-o")


@pytest.mark.parametrize(
    ("value", "unit", "wanted"),
    [
        (0.0, "rad/s", "0 rpm"),
        (930.0, "N m", "930 N m"),
        (-20e3, "N m", "-20 kN m"),
        (57e3, "N m/rad", "57 kN m/rad"),
        (0.25e-3, "s", "250 us"),
        (1.91, "", "1.91"),
    ],
)
def test_quantities_as_people_write_them(value, unit, wanted):
    assert readable(value, unit) == wanted


def test_a_pair_of_speeds_is_drawn_as_two_references():
    bed = differential_bed()
    bed.control = {"speed_pairs": {"rear": ["M2", "M3"]}}
    project = Project(bed.load())
    signals = {
        name: np.full(3, value) for name, value in (("rear_speed_mean_ref", 5.0), ("rear_speed_difference_ref", 4.0))
    }
    recording = Recording(np.arange(3.0), signals, dict.fromkeys(signals, "rad/s"), 3, 0.1, 1e-4)
    (panel,) = panels(recording, project)
    assert [float(curve.values[0]) for curve in panel.curves] == [7.0, 3.0]
    assert {curve.style for curve in panel.curves} == {"reference"}

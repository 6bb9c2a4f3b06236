"""The figure of a measured profile: its marks hold what the steps found, for file and page alike."""

import csv
import json
from itertools import pairwise

import numpy as np
import pytest
from drawn_words import can_be_read
from numpy.testing import assert_array_equal

import nonhertz as nh
from nonhertz.amounts import display_units
from nonhertz.figures.measured import COLUMNS, measured_steps
from nonhertz.figures.value import Across, Figure, Line, Panel, Points
from nonhertz.measured import Trace, prepare
from nonhertz.plot import measured_figure
from nonhertz.plot.sheets import NUMBERS
from nonhertz.web.view.uploads import answer_to_file

STEPS = ["level", "align", "trim", "outliers", "smooth"]


def trace(points: int = 701) -> Trace:
    """A crown of 2 m with corners 1.4 mm deep, tilted, off the middle, rough, with two grains of dust."""
    roller = nh.Roller(diameter=15.0, length=20.0, profile=nh.profile.crown(radius=2000.0), corner_radius=1.5)
    y = np.linspace(-9.99, 9.99, points)
    height = 1e-3 * y - roller.relief(y) + 1e-4 * np.random.default_rng(1).standard_normal(points)
    height[[points // 3, points // 2]] += 0.01
    return Trace(y + 3.0, height, name="roller.txt")


@pytest.fixture(scope="module")
def measured():
    return prepare(trace())


@pytest.fixture(scope="module")
def figure(measured):
    return measured_steps(measured, measured.fit("crown"))


def panel_of(figure: Figure, name: str) -> Panel:
    return next(panel for panel in figure.panels if panel.name == name)


def lines_of(panel: Panel) -> dict[str, Line]:
    return {mark.name: mark for mark in panel.marks if isinstance(mark, Line)}


def test_every_step_shows_the_points_before_and_after_it(measured, figure):
    assert [panel.name for panel in figure.panels] == [
        *STEPS, "roughness", "profile", "residual", "corner-low", "corner-high"
    ]  # fmt: skip
    for before, after in pairwise(measured.states[:-1]):
        panel = panel_of(figure, after.name)
        for name, state in (("before", before), ("after", after)):
            assert_array_equal(lines_of(panel)[name].x, state.y)
            assert_array_equal(lines_of(panel)[name].y, state.height)
        assert after.words.rstrip(".") in panel.remark
        assert after.words in panel.description
        low, high = panel.along.range
        assert low < min(before.y[0], after.y[0]) < max(before.y[-1], after.y[-1]) < high


def test_what_a_step_removed_and_the_ends_of_the_land_are_marked(measured, figure):
    outliers = measured.states[4]
    assert outliers.removed[0].size == 2
    (points,) = (mark for mark in panel_of(figure, "outliers").marks if isinstance(mark, Points))
    assert_array_equal((points.x, points.y), outliers.removed)
    ends = [mark.x for mark in panel_of(figure, "smooth").marks if isinstance(mark, Across)]
    assert tuple(ends) == measured.points.land
    (roughness,) = lines_of(panel_of(figure, "roughness")).values()
    assert_array_equal(roughness.y, measured.states[5].removed_height)


def test_relief_and_residual_are_those_of_the_last_points(measured, figure):
    profile = lines_of(panel_of(figure, "profile"))
    assert_array_equal(profile["measured"].y, measured.relief)
    fit, land = measured.fit("crown"), measured.points.on_land
    assert_array_equal(profile["crown"].y, fit.relief(land.y))
    (residual,) = lines_of(panel_of(figure, "residual")).values()
    on_land = np.isin(measured.points.y, land.y)
    assert residual.y == pytest.approx(measured.relief[on_land] - fit.relief(land.y), abs=1e-12)
    corner = lines_of(panel_of(figure, "corner-high"))["after"]
    beyond = measured.points.y > measured.points.land[1]
    assert_array_equal(corner.y[-beyond.sum() :], measured.relief[beyond])
    assert "profile" not in panel_of(measured_steps(measured), "profile").remark
    assert "residual" not in [panel.name for panel in measured_steps(measured).panels]


def test_the_scale_is_that_of_the_land_not_of_its_corners(measured, figure):
    for before, after in pairwise(measured.states[:-1]):
        panel = panel_of(figure, after.name)
        low, high = panel.upright.range
        for state in (before, after):
            middle = 3.0 if state.name in {"raw", "level"} else 0.0
            land = state.height[np.abs(state.y - middle) < 8.4]
            assert low < land.min() < land.max() < high
        # The crown drops 8.5^2 / 4000 mm, 18 um, the corners by 1.4 mm.
        assert high - low < 0.09
        assert panel.upright.cut
        assert "axis cut, heights to -13" in panel.remark  # um
    deep, shallow = panel_of(figure, "profile").upright.range
    assert shallow < 0.0
    assert 0.018 < deep < 0.03


def test_of_many_points_the_extremes_are_drawn():
    measured = prepare(trace(20001))
    raw = measured.states[0]
    line = lines_of(panel_of(measured_steps(measured), "level"))["before"]
    assert len(line.x) <= 3 * COLUMNS
    places = np.searchsorted(raw.y, line.x)
    assert_array_equal((raw.y[places], raw.height[places]), (line.x, line.y))
    for part, drawn in ((raw.y < 3.0, line.x < 3.0), (raw.y >= 3.0, line.x >= 3.0)):
        assert raw.height[part].max() == line.y[drawn].max()
        assert raw.height[part].min() == line.y[drawn].min()


def test_page_and_file_draw_the_same_value():
    source = trace()
    text = "\n".join(f"{y:.6f}\t{1e3 * height:.6f}" for y, height in zip(source.y, source.height, strict=True))
    sent = json.loads(answer_to_file(text.encode(), "roller.txt", {"height_unit": "um"}))["steps"]
    read = Trace(np.round(source.y, 6), np.round(1e3 * source.height, 6) / 1e3, name="roller.txt")
    sheet = measured_figure(prepare(read))
    drawn = NUMBERS[sheet].to_json()
    assert [panel["name"] for panel in sent["panels"]] == [panel["name"] for panel in drawn["panels"]]
    for ours, theirs in zip(sent["panels"], drawn["panels"], strict=True):
        assert len(ours["marks"]) == len(theirs["marks"])
        for mark, other in zip(ours["marks"], theirs["marks"], strict=True):
            assert np.ravel(mark.get("y", 0.0)) == pytest.approx(np.ravel(other.get("y", 0.0)), abs=1e-12)
    with display_units("us"):
        assert panel_of(measured_steps(prepare(read)), "level").upright.title() == "Height [µin]"


@pytest.mark.parametrize("options", [{}, {"corner": "cut"}, {"align": False, "trim": False}])
def test_words_of_the_sheet_can_be_read(options):
    measured = prepare(trace(), **options)
    can_be_read(measured_figure(measured, "A measured roller", measured.fit("crown")))


def test_csv_has_every_line(measured, figure):
    _, *rows = csv.reader(figure.to_csv().splitlines())
    assert {row[0] for row in rows} == {panel.name for panel in figure.panels}
    smooth = [row for row in rows if row[:2] == ["smooth", "after"]]
    assert [float(row[3]) for row in smooth] == measured.states[5].height.tolist()


def test_a_flat_line_without_steps_is_drawn():
    flat = nh.measured.Measured(Trace(np.linspace(0.0, 10.0, 101), np.zeros(101)))
    (panel,) = measured_steps(flat).panels
    deep, shallow = panel.upright.range
    assert shallow < 0.0 < deep
    can_be_read(measured_figure(flat.smoothed()))

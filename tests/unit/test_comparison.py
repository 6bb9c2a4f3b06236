"""Strips beside a plane grid: what is compared, and where they are said to differ."""

import csv
import dataclasses
import io
import itertools
import json

import numpy as np
import pytest
from drawn_words import can_be_read
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz import plot
from nonhertz.comparison import ComparedQuantity
from nonhertz.comparison.value import differences
from nonhertz.figures.comparison import compared_methods
from nonhertz.files.comparisons import as_object, as_table
from nonhertz.files.results import key_by_key
from nonhertz.result.edges import EdgeKind
from nonhertz.result.ends import away_from_ends

HALF_SPACE = {"side_faces": "none", "depth": "none"}
CELLS = (48, 96)


def roller(**changes):
    return nh.Roller(**({"diameter": 20, "length": 20} | HALF_SPACE | changes))


CASES = {
    "crown": (nh.Contact(roller(profile=nh.profile.crown(1000)), nh.Plate()), {"load": 3e3, "tilt": 0.3e-3}),
    "sharp": (nh.Contact(roller(), nh.Plate()), {"load": 20e3}),
    "approach": (nh.Contact(roller(profile=nh.profile.crown(2000)), nh.Plate()), {"approach": 0.01, "moment": 500.0}),
    "ellipse": (
        nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(100)), nh.Body()),
        {"load": 1e3, "accuracy": 1e-5},
    ),
    "free": (
        nh.Contact(*(nh.Roller(diameter=20, length=20, side_faces="free", depth="none") for _ in "ab")),
        {"load": 20e3, "tilt": 0.3e-3},
    ),
}


@pytest.fixture(scope="module")
def found():
    return {name: nh.compare(contact, **given, cells=CELLS) for name, (contact, given) in CASES.items()}


@pytest.mark.parametrize("name", CASES)
def test_quantities_are_those_of_the_solutions(found, name):
    one = found[name]
    of_patch, semi, parabola = one.patch, one.semi_elliptic, one.parabolic
    assert (semi.element, parabola.element) == (nh.SEMI_ELLIPTIC, nh.PARABOLIC)
    for quantity in ("approach", "tilt", "load"):
        each = one.quantity(quantity)
        expected = [getattr(solution, quantity) for solution in (of_patch, semi, parabola)]
        assert [each.patch, each.semi_elliptic, each.parabolic] == expected
    assert (one.quantity("contact from").semi_elliptic, one.quantity("contact to").semi_elliptic) == semi.contact_y[0]
    assert one.patch.cells == CELLS
    assert one.contact == CASES[name][0]
    with pytest.raises(KeyError):
        one.quantity("nothing")


def test_the_middle_is_that_of_hertz(found):
    one = found["ellipse"].quantity("pressure at y = 0 mm")
    exact = nh.hertz.point_contact(load=1e3, radius_x=10, radius_y=100, compliance=found["ellipse"].contact.compliance)
    # 48 cells across; strips are held to 1e-4; the parabola's bias is 0.6 %.
    assert_allclose(one.patch, exact.max_pressure, rtol=5e-4)
    assert_allclose(one.semi_elliptic, exact.max_pressure, rtol=1e-4)
    assert_allclose(one.differences, [0.0, 6.1e-3], rtol=0, atol=6e-4)


def test_a_moment_of_rounding_is_none(found):
    assert found["sharp"].quantity("moment").patch == 0.0
    assert np.isnan(found["sharp"].quantity("moment").differences).all()
    assert found["approach"].quantity("moment").patch == pytest.approx(500.0)


def test_differences_are_relative_unless_they_are_positions():
    assert ComparedQuantity("load", "N", -2.0, -3.0, -1.0).differences == (-0.5, 0.5)
    assert ComparedQuantity("end", "mm", -2.0, -3.0, -1.0, absolute=True).differences == (-1.0, 1.0)


def test_differences_along_the_line(found):
    one = found["crown"]
    semi, patch = one.semi_elliptic, one.patch
    relative = one.along(semi)
    assert np.isnan(relative[semi.line_load == 0.0]).any()
    at = int(np.argmin(np.abs(semi.y)))
    expected = np.interp(semi.y[at], patch.y, patch.centre_pressure)
    assert_allclose(relative[at], semi.centre_pressure[at] / expected - 1.0, rtol=1e-12)


def test_a_strip_without_a_partner_is_told_from_one_that_only_ends_earlier(found):
    semi, patch = found["crown"].semi_elliptic, found["crown"].patch
    load = semi.line_load.copy()
    middle = load.size // 2
    load[middle] = 0.0
    half_width = np.where(load > 0.0, semi.element_half_width, 0.0)
    holed = dataclasses.replace(semi, line_load=load, element_half_width=half_width)
    assert differences(holed, patch)[middle] == -1.0
    # Beyond its end a strip without load lies in a cell that the contact only reaches.
    assert np.all(np.isnan(differences(semi, patch)[semi.line_load == 0.0]))
    nothing = dataclasses.replace(patch, pressure=np.zeros_like(patch.pressure))
    assert np.isinf(differences(semi, nothing)[semi.line_load > 0.0]).all()


@pytest.mark.parametrize("name", CASES)
def test_stretches_hold_all_that_differs_by_more_than_one_per_cent(found, name):
    one = found[name]
    for solution in one.strips:
        relative = one.along(solution)
        mine = [each for each in one.stretches if each.element == solution.element.name]
        within = np.zeros(solution.strips, dtype=bool)
        for each in mine:
            inside = (solution.edges[:-1] >= each.low) & (solution.edges[1:] <= each.high)
            assert np.isin(each.at, solution.y[inside])
            assert each.largest == relative[solution.y == each.at] == max(relative[inside], key=abs)
            within |= inside
        assert np.all(np.abs(np.nan_to_num(relative[~within])) <= 0.01)
        # Those next to each other are farther apart than the contact is wide.
        assert all(b.low - a.high > solution.max_half_width for a, b in itertools.pairwise(mine))
        assert all(abs(each.largest) > 0.01 for each in mine)


def test_strips_that_differ_are_a_stretch_of_their_own(found):
    one = found["ellipse"]
    semi, at = one.semi_elliptic, one.semi_elliptic.strips // 2
    load = semi.line_load.copy()
    load[at - 1 : at + 1] *= 1.02, 1.05
    injected = dataclasses.replace(one, semi_elliptic=dataclasses.replace(semi, line_load=load))
    (stretch,) = (each for each in injected.stretches if each.element == "semi-elliptic" and each.low < 0.0 < each.high)
    assert (stretch.low, stretch.high, stretch.at) == (semi.edges[at - 1], semi.edges[at + 1], semi.y[at])
    assert stretch.largest == pytest.approx(0.05, abs=0.005)


def test_maxima_are_compared_a_half_width_from_sharp_ends(found):
    one = found["sharp"]
    each = one.quantity("maximum pressure")
    assert "unbounded" in str(each.remark)
    border = abs(one.semi_elliptic.max_pressure_y)
    assert_allclose(abs(one.quantity("position").patch), border, rtol=0, atol=0.02)
    # What is left is a number of both; a cell is half a half-width long here.
    assert_allclose(each.differences, 0.0, rtol=0, atol=0.04)
    assert found["crown"].quantity("maximum pressure").remark is None


def test_away_from_sharp_ends(found):
    semi = found["sharp"].semi_elliptic
    assert semi.edge_pressure[0].kind is EdgeKind.SINGULAR
    border = abs(semi.max_pressure_y)
    y = np.array([-border - 0.01, -border + 0.01, 0.0])
    assert away_from_ends(semi, y).tolist() == [False, True, True]


@pytest.mark.parametrize("name", CASES)
def test_stations_are_three_places_in_contact(found, name):
    one = found[name]
    low, high = one.semi_elliptic.contact_y[0][0], one.semi_elliptic.contact_y[-1][1]
    places = [station.y for station in one.stations]
    assert all(low < y < high for y in places)
    assert len(set(places)) == 3
    assert [station.reason for station in one.stations] == [
        "middle",
        "largest difference in MPa",
        "near the more loaded end",
    ]
    for y in places:
        assert one.patch.across(y)[1].max() > 0.0


def test_the_more_loaded_end_is_that_of_the_tilt(found):
    contact, given = CASES["crown"]
    assert found["crown"].stations[2].y > 0.0
    turned = nh.compare(contact, load=given["load"], tilt=-given["tilt"], cells=CELLS)
    assert_allclose(turned.stations[2].y, -found["crown"].stations[2].y, rtol=1e-6)


def test_an_approach_that_only_strips_feel_is_refused(monkeypatch, found):
    nothing = dataclasses.replace(found["crown"].patch, pressure=np.zeros(CELLS))
    monkeypatch.setattr("nonhertz.comparison.methods.solve_patch", lambda *_, **__: nothing)
    with pytest.raises(nh.InputError, match="bring the bodies into contact"):
        nh.compare(CASES["crown"][0], approach=1e-3)


@pytest.mark.parametrize("name", CASES)
def test_json_and_table_hold_the_same_numbers(found, name):
    one = found[name]
    value = json.loads(key_by_key(as_object(one, "A title")))
    assert value == json.loads(json.dumps(as_object(one, "A title")))
    assert value["title"] == "A title"
    assert value["patch"]["centre_pressure"] == one.patch.centre_pressure.tolist()
    assert [each["name"] for each in value["quantities"]] == [each.name for each in one.quantities]
    rows = list(csv.DictReader(io.StringIO(as_table(one))))
    assert len(rows) == one.semi_elliptic.strips + one.parabolic.strips
    of_semi = [row for row in rows if row["element"] == "semi-elliptic"]
    assert [float(row["y [mm]"]) for row in of_semi] == one.semi_elliptic.y.tolist()
    shown = [float(row["difference"]) if row["difference"] else None for row in of_semi]
    assert shown == value["semi_elliptic"]["difference"]


@pytest.mark.parametrize("name", ["crown", "sharp"])
def test_nothing_on_the_sheet_overlaps_or_leaves_the_paper(found, name):
    sheet = plot.comparison(found[name], title="A roller")
    can_be_read(sheet)
    upper, slim, *cuts = sheet.axes
    assert len(cuts) == 3
    assert all(axes.has_data() for axes in sheet.axes)
    assert upper.get_xlim() == slim.get_xlim()
    assert upper.get_position().x0 == pytest.approx(slim.get_position().x0)
    assert [text.get_text() for text in upper.get_legend().get_texts()] == [
        *(mark.name for mark in compared_methods(found[name]).panels[0].marks if mark.name)
    ]


@pytest.mark.parametrize("name", CASES)
def test_the_figure_has_the_numbers_of_all_methods(found, name):
    compared = found[name]
    figure = compared_methods(compared)
    along, differences, *cuts = figure.panels
    _, semi, parabola = (mark for mark in along.marks if mark.name)
    for drawn, solution in ((semi, compared.semi_elliptic), (parabola, compared.parabolic)):
        pressed = solution.line_load > 0.0
        assert drawn.name.startswith(f"{solution.strips} {solution.element.name} strips, ")
        assert (drawn.x.tolist(), drawn.y.tolist()) == (
            solution.y[pressed].tolist(),
            solution.centre_pressure[pressed].tolist(),
        )
    of_semi = next(mark for mark in differences.marks if mark.name == semi.name)
    assert_allclose(of_semi.y, np.clip(compared.along(compared.semi_elliptic), -1.0, 1.0))
    for cut, station in zip(cuts, compared.stations, strict=True):
        *shapes, cells = cut.marks
        x, pressure = compared.patch.across(station.y)
        assert np.isin(x[pressure > 0.0], cells.x).all()
        assert cells.y.max() == pressure.max()
        for shape, solution in zip(shapes, compared.strips, strict=True):
            # Over the width the shape bears the load of the strips.
            load = np.interp(station.y, solution.y, solution.line_load)
            assert np.trapezoid(shape.y, shape.x) == pytest.approx(load, rel=2e-3)
    head, *rows = csv.reader(io.StringIO(figure.to_csv()))
    assert head == ["panel", "line", "over", "place", "value", "unit"]
    assert {row[2] for row in rows} == {"y [mm]", "x [mm]"}
    assert {row[0] for row in rows} == {"pressure", "difference", "across A", "across B", "across C"}
    assert {row[1] for row in rows} == {mark.name for mark in along.marks if mark.name}
    assert "at most" in figure.description

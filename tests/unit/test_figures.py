"""Figures as values: what is drawn is what the solution says, for every reader alike."""

import csv
import json
import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.amounts import display_units
from nonhertz.figures import bearing, contact, perspective, stress
from nonhertz.figures.loads import roller_loads
from nonhertz.figures.overlay import compared_contacts
from nonhertz.figures.roller import roller_lines
from nonhertz.figures.value import (
    SERIES,
    Across,
    Area,
    Axis,
    Bar,
    Bars,
    Cells,
    Contours,
    Figure,
    Line,
    Mark,
    Panel,
    Points,
    Words,
)
from nonhertz.plot.drawer import sheet_of
from nonhertz.plot.marks import typeset
from nonhertz.subsurface import axial_plane, cross_section, extremes


@pytest.fixture(scope="module")
def solution():
    roller = nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(1000.0))
    return nh.solve(nh.Contact(roller, nh.Plate()), load=5e3, tilt=5e-4, strips=61)


def test_json_has_numbers_in_units_of_the_program_and_what_is_read(solution):
    figure = contact.pressure(solution)
    sent = json.loads(json.dumps(figure.to_json(), allow_nan=False))
    upper, lower = sent["panels"]
    assert (upper["name"], lower["name"]) == ("pressure", "half-width")
    line = next(mark for mark in upper["marks"] if mark["kind"] == "line")
    assert max(line["y"]) == solution.centre_pressure.max()
    assert (upper["upright"]["factor"], upper["upright"]["title"]) == (1.0, "Pressure p₀ [MPa]")
    with display_units("us"):
        read = figure.to_json()["panels"][0]
    assert read["upright"]["unit"] == "ksi"
    assert read["upright"]["factor"] == pytest.approx(0.1450377)
    assert next(mark for mark in read["marks"] if mark["kind"] == "line") == line


def test_what_is_not_finite_is_sent_as_null():
    line = Line(np.array([0.0, 1.0, 2.0]), np.array([1.0, math.nan, math.inf]))
    figure = Figure(Axis("y"), [Panel("one", "One", Axis("p"), [line, Across(1.0)], "")])
    assert figure.to_json()["panels"][0]["marks"] == [
        {"kind": "line", "x": [0.0, 1.0, 2.0], "y": [1.0, None, None]},
        {"kind": "across", "x": 1.0},
    ]


def test_csv_has_every_point_of_every_line(solution):
    figure = contact.pressure(solution)
    head, *rows = csv.reader(figure.to_csv().splitlines())
    assert head == ["panel", "line", "y [mm]", "value", "unit"]
    pressed = int((solution.line_load > 0.0).sum())
    assert len(rows) == 2 * (pressed + 2 * len(solution.contact_y))
    assert {(panel, unit) for panel, _, _, _, unit in rows} == {("pressure", "MPa"), ("half-width", "mm")}


def test_csv_of_colours_has_both_places_and_the_value(solution):
    head, *rows = csv.reader(contact.footprint(solution).to_csv().splitlines())
    assert head == ["panel", "line", "y [mm]", "x [mm]", "value", "unit"]
    outline = {float(y): (float(x), float(p)) for _, _, y, x, p, _ in rows}
    for y, half_width, p in zip(solution.y, solution.half_width, solution.centre_pressure, strict=True):
        if p > 0.0:
            assert outline[y] == (half_width, pytest.approx(p, rel=1e-12))
    assert {(name, unit) for _, name, _, _, _, unit in rows} == {("p", "MPa")}
    z = np.linspace(0.0, 1.0, 21)
    field = axial_plane(solution, solution.y, z, body="a")
    largest = stress.extremes_by_name(extremes(solution, body="a"))
    head, *rows = csv.reader(stress.along_contact(solution, field, largest).to_csv().splitlines())
    assert head == ["panel", "line", "y [mm]", "z [mm]", "value", "unit"]
    values = [float(row[4]) for row in rows if row[1] == "σ"]
    assert values == field.von_mises.ravel().tolist()
    assert [float(row[3]) for row in rows[:21]] == z.tolist()
    points = [row for row in rows if row[1].startswith("max. von Mises")]
    assert [(float(row[2]), float(row[3]), *row[4:]) for row in points] == [
        (largest["von_mises"].y, largest["von_mises"].z, "", "")
    ]


def test_csv_of_cells_has_their_middles_and_blanks_where_nothing_is():
    values = np.array([[1.0, math.nan], [3.0, 4.0], [5.0, 6.0]])
    cells = Cells(np.array([0.0, 1.0, 3.0, 4.0]), np.array([0.0, 2.0, 6.0]), values)
    panel = Panel("map", "Map", Axis("y", "y", "mm"), [cells], "", colours=Axis("p", "p", "MPa"))
    assert Figure(Axis("Angle", "angle", "°"), [panel]).to_csv().splitlines() == [
        "panel,line,angle [°],y [mm],value,unit",
        "map,p,0.5,1.0,1.0,MPa",
        "map,p,0.5,4.0,,MPa",
        "map,p,2.0,1.0,3.0,MPa",
        "map,p,2.0,4.0,4.0,MPa",
        "map,p,3.5,1.0,5.0,MPa",
        "map,p,3.5,4.0,6.0,MPa",
    ]


def test_every_kind_of_mark_is_drawn(solution):
    sheet = sheet_of(contact.pressure(solution), "A roller")
    sheet.draw_without_rendering()
    assert len(sheet.axes) == 2
    unknown = Figure(Axis("y"), [Panel("one", "One", Axis("p"), [Mark()], "")])
    with pytest.raises(TypeError, match="cannot draw Mark"):
        sheet_of(unknown)


@pytest.mark.parametrize(
    ("words", "expected"),
    [("-8.3 to 2", "−8.3 to 2"), ("non-convex", "non-convex"), ("s^0.5", "s$^{0.5}$"), ("$", r"\$")],
)
def test_words_are_typeset(words, expected):
    assert typeset(words) == expected


def test_words_on_an_end_without_limit_name_its_law():
    roller = nh.Roller(diameter=20.0, length=20.0)
    figure = contact.pressure(nh.solve(nh.Contact(roller, nh.Plate()), load=20e3))
    upper = figure.panels[0]
    assert upper.upright.cut
    assert "axis cut" in upper.remark
    laws = [mark for mark in upper.marks if isinstance(mark, Words) and "unbounded" in mark.words]
    assert [mark.side for mark in laws] == ["left", "right"]


def test_the_footprint_is_the_area_of_the_strips(solution):
    figure = contact.footprint(solution)
    (panel,) = figure.panels
    (area,) = (mark for mark in panel.marks if isinstance(mark, Area))
    pressed = solution.line_load > 0.0
    assert area.x[1:-1].tolist() == solution.y[pressed].tolist()
    assert area.half_height[1:-1].tolist() == solution.half_width[pressed].tolist()
    assert area.values[1:-1] == pytest.approx(solution.centre_pressure[pressed], rel=1e-12)
    # Across it is a semi-ellipse: over the width the force per length is that of the strip.
    share = np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, 2001))
    across = area.values[1:-1] * (1.0 - share[:, None] ** 2) ** area.power
    force = area.half_height[1:-1] * np.trapezoid(across, share, axis=0)
    assert force == pytest.approx(solution.line_load[pressed], rel=1e-5)
    assert panel.colours.range == (0.0, pytest.approx(solution.max_pressure))
    assert not panel.colours.cut


def test_a_parabolic_footprint_is_wider_and_shows_the_hertz_half_width():
    roller = nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(1000.0), side_faces="none")
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=5e3, strips=61, element=nh.PARABOLIC)
    (panel,) = contact.footprint(solution).panels
    (area,) = (mark for mark in panel.marks if isinstance(mark, Area))
    lines = [mark for mark in panel.marks if isinstance(mark, Line)]
    assert [float(line.y[10] / area.half_height[10]) for line in lines] == pytest.approx(
        [-math.sqrt(2 / 3), math.sqrt(2 / 3)]
    )
    force = area.values * area.half_height * 4.0 / 3.0
    assert force[1:-1] == pytest.approx(solution.line_load[solution.line_load > 0.0], rel=1e-12)


def test_stress_below_the_surface_is_the_field_with_the_largest_marked(solution):
    overall = extremes(solution, body="a")
    z = np.linspace(0.0, 1.0, 21)
    field = axial_plane(solution, solution.y, z, body="a")
    figure = stress.along_contact(solution, field, stress.extremes_by_name(overall), station=2.0)
    (panel,) = figure.panels
    contours = next(mark for mark in panel.marks if isinstance(mark, Contours))
    assert contours.values is field.von_mises or np.array_equal(contours.values, field.von_mises)
    points = {mark.symbol: mark for mark in panel.marks if isinstance(mark, Points)}
    assert (points["circle"].x[0], points["circle"].y[0]) == (overall.von_mises.y, overall.von_mises.z)
    bars = [(mark.low, mark.high) for mark in panel.marks if isinstance(mark, Bar)]
    assert bars == list(solution.contact_y)
    assert [mark.x for mark in panel.marks if isinstance(mark, Across)][-1] == 2.0
    assert panel.upright.range == (1.0, 0.0), "depth points down"
    # Sent, values are rounded to a hundred-thousandth of the largest.
    sent = next(mark for mark in figure.to_json()["panels"][0]["marks"] if mark["kind"] == "contours")
    assert np.array(sent["values"]) == pytest.approx(field.von_mises, abs=1e-5 * field.von_mises.max())
    largest = extremes(solution, 2.0, body="a")
    section = cross_section(solution, 2.0, np.linspace(-0.5, 0.5, 11), z, body="a")
    across = stress.across_contact(solution, section, stress.extremes_by_name(largest))
    triangle = next(mark for mark in across.panels[0].marks if isinstance(mark, Points) and mark.symbol == "triangle")
    place = largest.orthogonal_shear
    assert triangle.x.tolist() == [-place.x, place.x]


def test_a_map_has_the_pressure_of_every_roller_and_is_pale_without_load():
    roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    loaded = nh.bearing.solve(
        nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184), radial=5e3
    )
    figure = bearing.pressure_maps(loaded, points=21)
    assert [panel.name for panel in figure.panels] == ["map-inner", "map-outer"]
    for panel, ring in zip(figure.panels, ("inner", "outer"), strict=True):
        (cells,) = (mark for mark in panel.marks if isinstance(mark, Cells))
        pressure = loaded.unrolled_pressure(ring, y=np.linspace(-5.0, 5.0, 21)).pressure
        # The roller opposite the load is at both ends.
        assert cells.values.shape == (15, 21)
        for roller_number, degrees in enumerate(np.degrees(loaded.angle)):
            column = int(np.searchsorted(cells.x, (degrees + 180.0) % 360.0 - 180.0)) - 1
            assert np.nan_to_num(cells.values[column]) == pytest.approx(pressure[roller_number], rel=1e-12)
    turned = [words for _, words in figure.along.ticks]
    assert turned == ["180°", "225°", "270°", "315°", "0°", "45°", "90°", "135°", "180°"]


@pytest.mark.parametrize("words", ["|τ_xz| 5 MPa", "roller_2 s^0.5"])
def test_directions_of_stresses_are_typeset_and_underscores_of_users_are_not(words):
    expected = words.replace("τ_xz", "τ$_{xz}$").replace("s^0.5", "s$^{0.5}$")
    assert typeset(words) == expected


@pytest.fixture(scope="module")
def sliced():
    roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184)
    return nh.bearing.solve(row, radial=5e3, method="slices")


def test_loads_rise_to_a_round_number_and_are_written_as_csv(sliced):
    figure = roller_loads(sliced)
    (panel,) = figure.panels
    bars = [mark for mark in panel.marks if isinstance(mark, Bars)]
    for ring, mark in enumerate(bars):
        assert mark.x.tolist() == sliced.angle.tolist()
        assert mark.y.tolist() == sliced.load[:, ring].tolist()
    assert panel.upright.range == (0.0, 2000.0)
    assert 1500.0 < sliced.load.max() < 2000.0
    assert "of 13 rollers loaded" in panel.remark
    head, *rows = figure.to_csv().splitlines()
    assert head == "panel,line,angle [rad],value,unit"
    assert [float(row.split(",")[3]) for row in rows] == [*sliced.load[:, 0], *sliced.load[:, 1]]


def test_a_roller_by_slices_has_steps_of_line_load_and_no_pressure(sliced):
    figure = roller_lines(sliced)
    assert [panel.name for panel in figure.panels] == ["line", "relief"]
    assert figure.conditions.startswith("Roller 1 at 0.0 degrees, the most loaded; ")
    lines = [mark for mark in figure.panels[0].marks if isinstance(mark, Line)]
    for line, load in zip(lines, sliced.load[0], strict=True):
        assert np.trapezoid(line.y, line.x) == pytest.approx(load, rel=1e-9)
    idle = int(sliced.load[:, 0].argmin())
    marks = [mark for panel in roller_lines(sliced, idle).panels for mark in panel.marks]
    assert [mark.words for mark in marks if isinstance(mark, Words)] == ["no load"]


def test_cases_over_each_other_have_colours_and_dashes_of_their_own():
    crown = nh.Roller(diameter=10, length=10, profile=nh.profile.crown(radius=500))
    contact = nh.Contact(crown, nh.Plate())
    found = {str(load): nh.solve(contact, load=load) for load in (100.0, 200.0, 400.0)}
    figure = compared_contacts(found)
    upper, *_ = figure.panels
    lines = [mark for mark in upper.marks if isinstance(mark, Line)]
    assert [line.name for line in lines] == ["1  100.0", "2  200.0", "3  400.0"]
    assert [(line.colour, line.dash) for line in lines] == [*SERIES[:3]]
    assert upper.upright.range[1] > max(each.max_pressure for each in found.values())
    rows = list(csv.reader(figure.to_csv().splitlines()))[1:]
    named = {(panel, line.name) for panel in ("pressure", "half-width", "separation") for line in lines}
    assert {(row[0], row[1]) for row in rows} == named
    sheet = sheet_of(figure)
    legends = [ax.get_legend() for ax in sheet.axes]
    assert [text.get_text() for text in legends[0].get_texts()] == [line.name for line in lines]
    assert legends[1:] == [None, None]


def test_ridges_in_perspective_are_the_pressures_above_slanted_lines():
    roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=1200), corner_radius=0.3)
    rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13, clearance=0.0184)
    loaded = nh.bearing.solve(row, radial=10e3, tilt=3e-4)
    figure = perspective.pressure_ridges(loaded)
    for panel, ring in zip(figure.panels, (0, 1), strict=True):
        lines = [mark for mark in panel.marks if isinstance(mark, Line)]
        stands = [line for line in lines if line.colour == "faint"]
        ridges = [line for line in lines if line.colour != "faint"]
        assert len(stands) == 13
        assert len(ridges) == np.count_nonzero(loaded.load[:, ring])
        heights = [ridge.y - np.interp(ridge.x, stand.x, stand.y) for ridge in ridges for stand in stands
                   if stand.x[0] <= ridge.x[0] and ridge.x[-1] <= stand.x[-1]]  # fmt: skip
        assert len(heights) == len(ridges)
        # However narrow, the peak at the end of the land is drawn.
        assert max(height.max() for height in heights) == pytest.approx(loaded.max_pressure[:, ring].max(), rel=1e-3)
        assert abs(loaded.max_pressure_y[:, ring][loaded.max_pressure[:, ring].argmax()]) > 4.5
        assert all(height.min() >= -1e-9 for height in heights)
        assert [bool(ridge.name) for ridge in ridges] == [True] + [False] * (len(ridges) - 1)

"""Figures as values: what is drawn is what the solution says, for every reader alike."""

import csv
import json
import math

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.amounts import read_in
from nonhertz.figures import contact
from nonhertz.figures.value import Across, Axis, Figure, Line, Mark, Panel, Words
from nonhertz.plot.drawer import sheet_of, typeset


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
    with read_in("us"):
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
    laws = [mark for mark in upper.marks if isinstance(mark, Words) and "no limit" in mark.words]
    assert [mark.side for mark in laws] == ["left", "right"]

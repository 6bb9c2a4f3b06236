"""Figures of studies as values, and as they are drawn: lines, maps, distributions, shares and profiles."""

import csv
import itertools

import numpy as np
import pytest
from matplotlib.figure import Figure as Sheet

import nonhertz as nh
from nonhertz.figures.dent import around_dent
from nonhertz.figures.studies import distribution, lines_over, map_over, profile_band, variance_shares
from nonhertz.figures.value import Across, Axis, Bars, Cells, Contours, Figure, Line, Span, Whiskers, Words
from nonhertz.plot.drawer import sheet_of
from nonhertz.plot.studies import histogram, study_lines, study_map
from nonhertz.plot.style import sheet_style

LOAD, PRESSURE = Axis("Load", "load", "N"), Axis("Pressure", "p", "MPa")


def rows(figure):
    return list(csv.reader(figure.to_csv().splitlines()))


def test_numbers_over_categories_are_points_and_words_in_csv():
    panel = lines_over(
        Axis("Faces", "faces", categories=("free", "none")), np.arange(2.0), {"": np.array([1.0, 2.0])}, PRESSURE
    )
    (line,) = panel.marks
    assert (line.dash, line.marked) == ("none", True)
    figure = Figure(panel.along, [panel])
    assert rows(figure) == [
        ["panel", "line", "faces", "value", "unit"],
        ["p", "p", "free", "1.0", "MPa"],
        ["p", "p", "none", "2.0", "MPa"],
    ]
    (axes,) = sheet_of(figure).axes
    assert [text.get_text() for text in axes.get_xticklabels()] == ["free", "none"]
    assert axes.get_xlim() == (-0.5, 1.5)


@pytest.mark.parametrize(("largest", "logarithmic"), [(29.0, False), (31.0, True)])
def test_a_wide_range_of_numbers_has_a_logarithmic_axis(largest, logarithmic):
    panel = lines_over(
        LOAD, np.array([1e3, 2e3]), {"a": np.array([1.0, 2.0]), "b": np.array([np.nan, largest])}, PRESSURE
    )
    assert panel.upright.logarithmic is logarithmic
    assert panel.upright.range[0] < 1.0 < largest < panel.upright.range[1]
    assert panel.along.title() == "Load [kN]"
    assert panel.description == f"Pressure over load: 1 to {largest:g} MPa."
    assert [(mark.colour, mark.dash) for mark in panel.marks] == [("first", "solid"), ("second", "dashed")]


def test_no_two_of_many_lines_look_alike():
    lines = {str(number): np.array([1.0, 2.0]) for number in range(20)}
    looks = [(mark.colour, mark.dash) for mark in lines_over(LOAD, np.array([1.0, 2.0]), lines, PRESSURE).marks]
    assert len(set(looks)) == 20


def test_a_map_has_its_numbers_and_labels_that_do_not_overlap():
    x, y = np.linspace(0.0, 1.0, 30), np.linspace(0.0, 2.0, 40)
    values = np.tanh(20.0 * (x[:, None] - 0.4 * y - 0.1))  # many levels close to one line
    panel = map_over(Axis("x", "x"), x, Axis("y", "y"), y, values, PRESSURE)
    (contours,) = panel.marks
    assert isinstance(contours, Contours)
    assert contours.values is values
    assert panel.colours.range == (values.min(), values.max())
    axes = study_map(x, y, values.T, x_label="x", y_label="y", label="p")
    axes.figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in axes.texts]
    assert boxes
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))


@pytest.mark.parametrize(
    ("value", "words"), [(2.0, "Pressure:\n2 MPa everywhere"), (np.nan, "Pressure:\nno row has a number")]
)
def test_a_map_of_one_number_or_none_is_words(value, words):
    x = np.array([0.0, 1.0])
    panel = map_over(LOAD, x, Axis("Tilt"), x, np.full((2, 2), value), PRESSURE)
    assert [mark.words for mark in panel.marks if isinstance(mark, Words)] == [words]
    assert panel.colours is None


def test_words_above_a_histogram_do_not_overlap_and_its_tail_is_a_share():
    values = 2000.0 + 200.0 * np.random.default_rng(1).lognormal(0.0, 1.0, 600)
    near = {0.01: (2018.0, 2024.0), 0.5: (2190.0, 2210.0), 0.99: (3500.0, 5000.0)}
    with sheet_style():
        sheet = Sheet(figsize=(3.3, 2.3), layout="constrained")
        ax = histogram(values, sheet.add_subplot(), label="x", quantiles=near, limits=[2300.0])
        sheet.draw_without_rendering()
    boxes = [text.get_window_extent() for text in ax.texts]
    assert len(boxes) == 4
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
    assert all(box.y0 >= ax.get_window_extent().y1 for box in boxes)
    panel = distribution(Axis("x", "x", "MPa"), values, near, [2300.0])
    (bars,) = (mark for mark in panel.marks if isinstance(mark, Bars))
    last = bars.x[-1] + 0.5 * bars.width[-1]
    beyond = np.count_nonzero(values > last)
    assert beyond + bars.y.sum() == 600
    assert panel.remark == f"{100 * beyond / 600:.2g} % above {last:.4g} MPa, up to {values.max():.4g} MPa"
    assert ax.get_xlabel().splitlines()[1].startswith(f"{100 * beyond / 600:.2g} % above")
    assert [(mark.low, mark.high) for mark in panel.marks if isinstance(mark, Span)] == list(near.values())
    assert [mark.words for mark in panel.marks if isinstance(mark, Across)] == ["1 %", "50 %", "99 %", "limit"]
    # The two bars over a bin of equal width hold what numpy counts there.
    edges = np.append(bars.x - 0.5 * bars.width, last)
    np.testing.assert_array_equal(bars.y, np.histogram(values[values <= last], edges)[0])


def test_numbers_of_several_decades_are_on_a_logarithmic_axis():
    assert histogram([1.0, 2.0, 11.0], label="x").get_xscale() == "log"
    assert histogram([1.0, 2.0, 9.0], label="x").get_xscale() == "linear"
    assert histogram([-1.0, 2.0, 11.0], label="x").get_xscale() == "linear"
    assert histogram([np.nan], label="x").texts[0].get_text() == "no sample has a number"


def test_a_short_logarithmic_axis_has_numbers_within_decades():
    ax = histogram(np.geomspace(30.0, 600.0, 50), label="x")
    ax.figure.draw_without_rendering()
    low, high = ax.get_xlim()
    words = [
        text.get_text() for place, text in zip(ax.get_xticks(), ax.get_xticklabels(), strict=True) if low < place < high
    ]
    assert words == ["50", "100", "200", "500"]


def test_shares_stand_beside_names_with_their_intervals():
    first, total = np.array([0.6, 0.1]), np.array([0.8, 0.2])
    ends = np.array([first - 0.1, first + 0.1]), np.array([total - 0.05, total + 0.05])
    panel = variance_shares(["load", "a very long name of an input"], first, total, ends)
    assert [mark.y.tolist() for mark in panel.marks if isinstance(mark, Bars)] == [total.tolist(), first.tolist()]
    whiskers = [mark for mark in panel.marks if isinstance(mark, Whiskers)]
    assert [mark.low.tolist() for mark in whiskers] == [pair[0].tolist() for pair in ends]
    figure = Figure(panel.along, [panel])
    assert ["indices", "alone", "load", "0.6", ""] in rows(figure)
    assert ["indices", "interval, alone", "load", "0.7", ""] in rows(figure)
    sheet = sheet_of(figure)
    sheet.draw_without_rendering()
    (axes,) = sheet.axes
    widths = sorted(bar.get_width() for bar in axes.patches)
    assert widths == sorted([*first, *total])
    longest = max(text.get_window_extent().x0 for text in axes.get_yticklabels())
    assert longest >= 0.0, "names are not cut"


def test_a_band_of_profiles_has_its_bounds_in_csv_and_points_down():
    y = np.linspace(-5.0, 5.0, 11)
    relief = 1e-4 * y**2
    panel = profile_band(y, relief, (0.9 * relief, 1.2 * relief), label="most profiles")
    assert panel.upright.range[0] > panel.upright.range[1]
    table = {
        name: float(value) for _, name, place, value, _ in rows(Figure(panel.along, [panel]))[1:] if place == "5.0"
    }
    assert table == {"least": 0.9 * relief[-1], "nominal": relief[-1], "most": 1.2 * relief[-1]}
    (axes,) = sheet_of(Figure(panel.along, [panel])).axes
    assert axes.get_legend().get_title().get_text() == "most profiles"
    assert axes.get_ylabel() == "Relief [µm]"


def test_panels_with_axes_of_their_own_say_in_csv_over_what():
    panels = [distribution(axis, np.arange(1.0, 9.0)) for axis in (LOAD, PRESSURE)]
    head, *table = rows(Figure(panels[0].along, panels))
    assert head == ["panel", "line", "over", "place", "value", "unit"]
    assert {row[2] for row in table} == {"load [N]", "p [MPa]"}


def test_lines_of_plain_arrays_have_a_legend_with_a_heading():
    ax = study_lines([1, 2], {"low": [1.0, 2.0], "high": [2.0, 3.0]}, x_label="x", y_label="y [mm]", key="Tilt")
    legend = ax.get_legend()
    assert (legend.get_title().get_text(), [text.get_text() for text in legend.get_texts()]) == (
        "Tilt",
        ["low", "high"],
    )
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x", "y [mm]")


@pytest.mark.slow
def test_a_dent_has_its_stress_and_where_it_adds_damage():
    roller = nh.Roller(diameter=20, length=8, profile=nh.profile.crown(radius=100))
    solution = nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=300.0)
    dent, model = nh.patch.Dent(depth=0.002, diameter=0.3), nh.life.model("zaretsky")
    overrolled = nh.life.overrolled(solution, dent, body="b", cell=0.03)
    figure = around_dent(overrolled, model)
    stress, damage = figure.panels
    (cells,) = (mark for mark in stress.marks if isinstance(mark, Cells))
    np.testing.assert_array_equal(cells.values, getattr(overrolled, model.stress).max(axis=-1).T)
    assert 0.5 * (cells.x[1:] + cells.x[:-1]) == pytest.approx(overrolled.y)
    (line,) = (mark for mark in damage.marks if isinstance(mark, Line))
    total = overrolled.excess(model, overrolled.x[-1])
    assert line.y[20] == overrolled.excess(model, line.x[20]) / total
    left, right, bar = sheet_of(figure, "A dent").axes
    assert (left.get_aspect(), bar.get_ylabel()) == (1.0, "Largest shear [MPa]")
    assert right.get_position().x0 > left.get_position().x1

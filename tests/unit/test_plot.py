"""Drawings of a solution: what is drawn is what the solution says, and files come out the same every time."""

from dataclasses import replace
from functools import cache
from xml.etree import ElementTree

import matplotlib as mpl
import numpy as np
import pytest
from drawn_words import can_be_read, words
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz import plot
from nonhertz.amounts import format_digits
from nonhertz.errors import without_accuracy_warnings
from nonhertz.plot.style import INK, SIZE
from nonhertz.result.along import contact_lines
from nonhertz.result.area import element_peak
from nonhertz.result.outcome import Judgement
from nonhertz.result.solution import Solution

TWO_CRESTS = nh.profile.tabulated([-10, -5, 0, 5, 10], [0.02, 0.0, 0.02, 0.0, 0.02])


def roller(length: float = 20.0, **given: object) -> nh.Roller:
    return nh.Roller(**{"diameter": 20.0, "length": length, **given})  # type: ignore[arg-type]


#: The roller and what is prescribed.
CASES = {
    "crowned": (roller(profile=nh.profile.crown(1000.0)), {"load": 5e3, "tilt": 5e-4, "strips": 61}),
    "parabolic": (
        roller(profile=nh.profile.crown(1000.0)), {"load": 5e3, "tilt": 5e-4, "strips": 61, "element": nh.PARABOLIC}
    ),
    "point": (nh.Body(diameter=20.0, profile=nh.profile.crown(30.0)), {"load": 500.0}),
    "sharp": (roller(), {"load": 20e3, "tilt": 5e-4}),
    "lifted": (roller(), {"load": 2e3, "tilt": 2.5e-3, "strips": 41}),
    "twins": (roller(profile=TWO_CRESTS), {"load": 2e3, "strips": 60}),
    "hollow": (roller(profile=TWO_CRESTS), {"load": 2e3, "tilt": 2e-4}),
    "endless": (roller(profile=nh.profile.logarithmic(0.006, 19.0)), {"load": 10e3, "tilt": -7e-4, "strips": 61}),
    "straight": (roller(), {"load": 20e3}),
    "short": (roller(length=0.2), {"load": 100.0}),
    "spiked": (roller(profile=nh.profile.crown(4000.0), side_faces="none"), {"load": 20e3}),
}  # fmt: skip


@cache
def solved(name: str) -> Solution:
    body, given = CASES[name]
    with without_accuracy_warnings():
        return nh.solve(nh.Contact(body, nh.Plate()), **given)  # type: ignore[arg-type]


def judged(solution: Solution, **changed: object) -> Solution:
    return replace(solution, judgement=Judgement.of(**{**vars(solution.judgement), **changed}))


@pytest.fixture(params=["parabolic", "point", "sharp", "lifted", "hollow", "endless", "short"])
def solution(request):
    return solved(request.param)


@pytest.fixture
def ax():
    return Figure().add_subplot()


class TestPressure:
    def test_lines_are_the_strips(self, solution, ax):
        assert plot.pressure(solution, ax) is ax
        left, right = ax.figure.axes
        lines = [*left.lines, *right.lines]
        line, half_width = (
            next(line for line in lines if line.get_label() == name) for name in ("pressure p₀", "half-width b")
        )
        pressed = solution.line_load > 0.0
        for drawn, values in ((line, solution.centre_pressure), (half_width, solution.half_width)):
            assert_allclose(drawn.get_xdata(), contact_lines(solution).y, rtol=0, atol=0)
            # Between the ends of its pieces, where they are zero.
            inner = drawn.get_ydata() > 0.0
            assert_allclose(drawn.get_xdata()[inner], solution.y[pressed], rtol=0, atol=0)
            assert_allclose(drawn.get_ydata()[inner], values[pressed], rtol=0, atol=0)
            ends = drawn.get_xdata()[drawn.get_ydata() == 0.0]
            assert_allclose(ends, np.ravel(solution.contact_y), rtol=0, atol=0)
        # Everything is inside the axes, which start from zero.
        assert left.get_ylim()[0] == right.get_ylim()[0] == 0.0
        assert left.get_ylim()[1] > solution.max_pressure
        assert right.get_ylim()[1] > solution.half_width.max()
        assert left.get_xlim()[0] < solution.contact_y[0][0] < solution.contact_y[-1][1] < left.get_xlim()[1]

    @pytest.mark.slow
    @pytest.mark.parametrize("width", [3.2, 6.4], ids=["narrow", "wide"])
    def test_a_pressure_that_rises_again_at_a_land_end_says_so(self, width):
        ax = Figure(figsize=(width, 4.8)).add_subplot()
        cornered = roller(profile=nh.profile.crown(1500.0), corner_radius=0.8)
        with without_accuracy_warnings():
            solution = nh.solve(nh.Contact(cornered, nh.Plate()), load=20e3)
        plot.pressure(solution, ax)
        shown = [text for text in ax.texts if text.get_text().startswith("land end, ")]
        assert len(shown) == 2
        for text in shown:
            y, height = text.xy  # type: ignore[attr-defined]
            peak = solution.centre_pressure[np.abs(solution.y - y).argmin()]
            assert text.get_text() == f"land end, {peak:.4g} MPa"
            assert abs(y) == pytest.approx(9.2, abs=0.05)
            # No line runs through the words.
            box = text.get_window_extent().transformed(ax.transData.inverted())
            under = (solution.y >= box.x0) & (solution.y <= box.x1)
            assert peak <= solution.centre_pressure[under].max() <= height <= box.y0

    def test_singular_ends_have_exponent_and_strength(self, ax):
        solution = solved("straight")
        plot.pressure(solution, ax)
        low, high = (text for text in ax.texts if "unbounded" in text.get_text())
        for text, end in zip((low, high), solution.edge_pressure, strict=True):
            expected = f"unbounded, p ∼ K / s$^{{0.226}}$\nK = {format_digits(end.strength, 4)} MPa mm$^{{0.226}}$"
            assert text.get_text() == expected
        # Each stands on the inner side of its end.
        assert (low.get_ha(), high.get_ha()) == ("left", "right")
        assert low.xy[0] < -9.0  # type: ignore[attr-defined]
        assert high.xy[0] > 9.0  # type: ignore[attr-defined]

    def test_a_singular_end_does_not_set_the_scale(self, ax):
        solution = solved("spiked")
        plot.pressure(solution, ax)
        assert_allclose(ax.get_ylim()[1], 1.6 * solution.max_pressure, rtol=1e-12)
        assert ax.get_ylim()[1] < solution.centre_pressure.max()
        shown = " ".join(text.get_text() for text in ax.texts)
        assert f"{solution.centre_pressure.max():.0f}" not in shown
        assert f"{solution.max_pressure:.0f} MPa" in shown

    def test_the_maximum_near_a_singular_end_is_beyond_a_half_width(self, ax):
        solution = solved("sharp")
        plot.pressure(solution, ax)
        marker = next(line for line in ax.lines if line.get_marker() == "o")
        ((y, pressure),) = marker.get_xydata()
        away = np.abs(solution.y) < 10.0 - solution.half_width
        assert solution.centre_pressure[away].max() < pressure < solution.centre_pressure.max()
        assert solution.y[away].max() < y < solution.y[~away & (solution.y > 0.0)].min()
        assert_allclose(10.0 - y, np.interp(y, solution.y, solution.half_width), rtol=1e-12)


class TestFootprint:
    def test_outline_is_the_half_width(self, solution, ax):
        plot.footprint(solution, ax)
        pieces = [line.get_xydata() for line in ax.lines if line.get_color() == INK]
        assert len(pieces) == len(solution.contact_y)
        for piece, (low, high) in zip(pieces, solution.contact_y, strict=True):
            assert_allclose(piece[0], piece[-1], rtol=0, atol=0)
            # It ends with the last strip, within which a contact may run out.
            ends = piece[:, 0].min(), piece[:, 0].max()
            assert_allclose(ends, (low, high), rtol=0, atol=0.5 * np.diff(solution.edges).max())
            inside = (solution.y > low) & (solution.y < high)
            for sign in (-1.0, 1.0):
                side = {y: x for y, x in piece if sign * x > 0.0}
                assert_allclose(
                    [side[y] for y in solution.y[inside]],
                    sign * solution.element_half_width[inside],
                    rtol=1e-15,
                )

    def test_colours_are_the_pressure(self, solution, ax):
        plot.footprint(solution, ax)
        meshes = [item for item in ax.collections if isinstance(item, QuadMesh)]
        highest = max(float(mesh.get_array().max()) for mesh in meshes)
        last = element_peak(solution)
        # At equal load the parabola's middle is 3/4 q/a against 2/pi q/b.
        own = 0.75 * np.pi / 2.0 * np.sqrt(2.0 / 3.0) if solution.element is nh.PARABOLIC else 1.0
        assert_allclose(highest, own * solution.centre_pressure.max(), rtol=1e-12)
        assert_allclose(last, own * solution.max_pressure, rtol=1e-12)
        assert {mesh.get_clim() for mesh in meshes} == {(0.0, last)}


class TestProfile:
    def test_lines_are_the_surfaces_in_micrometres(self, solution, ax):
        assert plot.profile(solution, ax) is ax
        before, after = (line for line in ax.lines if len(line.get_xdata()) == solution.strips)
        finite = np.isfinite(solution.interference)
        for line, expected in ((before, -1e3 * solution.interference), (after, 1e3 * solution.gap)):
            assert_allclose(line.get_xdata(), solution.y, rtol=0, atol=0)
            assert_allclose(line.get_ydata()[finite], expected[finite], rtol=1e-15)
            assert np.all(np.isnan(line.get_ydata()[~finite]))


@pytest.mark.slow
class TestFigures:
    def test_title_is_taken_as_it_is_written(self, tmp_path):
        sheet = plot.figures(solved("point"), title="$5_{ and $6^^")["pressure"]
        assert "$5_{ and $6^^" in words(sheet)
        plot.save(sheet, tmp_path / "dollars")

    @pytest.mark.slow
    def test_no_words_overlap_or_leave_the_paper(self, solution):
        for sheet in plot.figures(solution, title="A roller").values():
            can_be_read(sheet)

    def test_footprint_has_a_true_panel_and_a_stretched_one(self):
        sheet = plot.figures(solved("crowned"))["footprint"]
        sheet.draw_without_rendering()
        true, stretched, _ = sheet.axes
        assert true.get_title(loc="left") == "True proportions"
        factor = float(stretched.get_title(loc="left").split()[2])
        assert factor >= 5.0
        for axes, expected in ((true, 1.0), (stretched, factor)):
            origin, along, across = axes.transData.transform([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])
            assert_allclose((across - origin)[1] / (along - origin)[0], expected, rtol=1e-2)
        assert_allclose(true.get_xlim(), stretched.get_xlim(), rtol=1e-2)

    def test_nothing_in_contact_is_drawn_too(self, tmp_path):
        nothing = np.zeros(61)
        apart = replace(solved("crowned"), line_load=nothing, element_half_width=nothing, load=0.0, moment=0.0)
        apart = judged(apart, contact_y=())
        for name, sheet in plot.figures(apart).items():
            plot.save(sheet, tmp_path / name)


@pytest.mark.slow
class TestSave:
    def test_writes_both_files_beside_the_stem(self, tmp_path):
        sheet = plot.figures(solved("point"))["footprint"]
        svg, png = plot.save(sheet, tmp_path / "case.v2")
        assert (svg, png) == (tmp_path / "case.v2.svg", tmp_path / "case.v2.png")
        assert ElementTree.parse(svg).getroot().tag == "{http://www.w3.org/2000/svg}svg"
        assert png.read_bytes().startswith(b"\x89PNG")
        assert png.stat().st_size > 10_000

    def test_same_solution_gives_the_same_file_whatever_the_settings_around(self, tmp_path):
        sheets = plot.figures(solved("hollow"), title="Twice")
        svg = {name: plot.save(sheet, tmp_path / name)[0].read_bytes() for name, sheet in sheets.items()}
        assert plot.save(sheets["profile"], tmp_path / "again")[0].read_bytes() == svg["profile"]
        with mpl.rc_context({"font.size": 14.0, "font.family": "DejaVu Serif", "svg.hashsalt": None}):
            for name, sheet in plot.figures(solved("hollow"), title="Twice").items():
                assert plot.save(sheet, tmp_path / name)[0].read_bytes() == svg[name]


@pytest.mark.parametrize("what", ["pressure", "footprint", "profile"])
def test_a_solution_draws_itself(what, ax):
    solution = solved("crowned")
    assert solution.plot(what, ax) is ax
    own = solution.plot(what)
    assert own.figure is not ax.figure
    assert words(own.figure) == words(ax.figure)
    assert own.xaxis.label.get_fontsize() == SIZE
    with pytest.raises(nh.InputError, match="what = 'shape' must be one of 'pressure', 'footprint', 'profile'"):
        solution.plot("shape")


def test_strips_are_a_dataframe():
    solution = solved("crowned")
    frame = solution.to_dataframe()
    assert list(frame.columns) == list(frame.attrs["units"]) == list(solution.table())
    assert (frame["line_load"] * frame["strip_width"]).sum() == pytest.approx(solution.load)

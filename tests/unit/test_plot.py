"""Drawings of a solution: what is drawn is what the solution says, and files come out the same every time."""

import gc
import subprocess
import sys
import warnings
import weakref
from dataclasses import dataclass, replace
from xml.etree import ElementTree

import matplotlib as mpl
import numpy as np
import pytest
from drawn_words import can_be_read, words
from matplotlib.collections import QuadMesh
from matplotlib.figure import Figure
from numpy.testing import assert_allclose
from numpy.typing import ArrayLike, NDArray

import nonhertz as nh
from nonhertz import plot
from nonhertz.model.body import Body, Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.corner import Chamfer
from nonhertz.model.profile import Profile
from nonhertz.plot.axial import mark_unlimited
from nonhertz.plot.contact_area import colour_limit
from nonhertz.plot.overlay import compared_contacts
from nonhertz.plot.style import INK, SIZE
from nonhertz.result.outcome import Judgement
from nonhertz.result.solution import EdgeKind, EdgePressure, ErrorEstimate, SingularEnd, Solution, Status
from nonhertz.solver.one import solve as solve_one
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Even(Profile):
    """Relief ``second y^2 + fourth y^4``: a crown, or with a negative ``second`` a hollow between crests."""

    second: float
    fourth: float = 0.0

    def relief(self, y: ArrayLike) -> Array:
        y = np.asarray(y, dtype=float)
        return self.second * y**2 + self.fourth * y**4


@dataclass(frozen=True)
class EndlessAtEnds(Profile):
    """A logarithmic relief, infinite at |y| = half and beyond."""

    amplitude: float
    half: float

    def relief(self, y: ArrayLike) -> Array:
        rest = 1.0 - (np.asarray(y, dtype=float) / self.half) ** 2
        return np.where(rest > 0.0, -self.amplitude * np.log(np.where(rest > 0.0, rest, 1.0)), np.inf)


def springs(
    contact: Contact,
    approach: float,
    tilt: float = 0.0,
    strips: int = 61,
    reach: float = 10.0,
    element: Element = SEMI_ELLIPTIC,
    status: Status = Status.CONVERGED,
    singular: bool = False,
    spike: float = 1.0,
) -> Solution:
    """Return a solution in which every strip answers for itself: right in shape, without the solver.

    A strip with interference d has the half-width of a Hertz contact that is d deep and the load of a line
    contact. The last strip's load is multiplied by ``spike``.
    """
    edges = -reach * np.cos(np.linspace(0.0, np.pi, strips + 1))
    y, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    interference = approach + tilt * y - contact.separation(y)
    touching = interference > 0.0
    curvature = contact.curvature(y)
    half_width = np.sqrt(np.where(touching, interference, 0.0) / (5.0 * curvature))
    line_load = half_width**2 * curvature / (4.0 * contact.compliance)
    line_load[-1] *= spike
    ends = tuple(sharp(edges[at]) if singular and touching[at] else run_out(edges[at]) for at in (0, -1))
    return Solution(
        contact=contact,
        element=element,
        status=status,
        approach=approach,
        tilt=tilt,
        load=float(line_load @ width),
        moment=float((line_load * y) @ width),
        stiffness=np.eye(2),
        edges=edges,
        line_load=line_load,
        element_half_width=half_width / element.hertz_ratio,
        gap=np.where(touching, 0.0, -0.8 * interference),
        iterations=7,
        judgement=Judgement.of(
            contact_y=runs(edges, touching),
            edge_pressure=ends,  # type: ignore[arg-type]
            singular_ends=singular_among(ends),
            peaks_at_corner=False,
            error_estimate=ErrorEstimate(approach=1e-4, load=0.0, max_pressure=1e-3, moment=0.0, tilt=0.0),
            findings=(),
        ),
    )


def singular_among(ends: tuple[EdgePressure, ...]) -> tuple[SingularEnd, ...]:
    return tuple(SingularEnd(end.y, end.kind) for end in ends if end.kind is EdgeKind.SINGULAR)


def with_ends(solution: Solution, *ends: EdgePressure) -> Solution:
    return judged(solution, edge_pressure=ends, singular_ends=singular_among(ends))


def judged(solution: Solution, **changed: object) -> Solution:
    return replace(solution, judgement=Judgement.of(**{**vars(solution.judgement), **changed}))


def run_out(y: float) -> EdgePressure:
    return EdgePressure(float(y), EdgeKind.RUN_OUT, 0.0, 0.0, 0.0, 0.0, None, None, 0.0, "")


def sharp(y: float, strength: float | None = 656.4) -> EdgePressure:
    return EdgePressure(float(y), EdgeKind.SINGULAR, 3000.0, 0.003, 0.5, 1.0 / 3.0, strength, 0.1, 2.0 / 3.0, "")


def runs(edges: NDArray[np.float64], touching: NDArray[np.bool_]) -> tuple[tuple[float, float], ...]:
    """The outer edges of every run of touching strips."""
    change = np.flatnonzero(np.diff(np.concatenate([[False], touching, [False]])))
    return tuple((float(edges[i]), float(edges[j])) for i, j in change.reshape(-1, 2))


def crowned(**options: object) -> Solution:
    roller = Roller(diameter=20.0, length=20.0, profile=Even(1.0 / 4000.0))
    return springs(Contact(roller, Plate()), approach=0.03, tilt=0.5e-3, **options)  # type: ignore[arg-type]


CASES = {
    "crowned": crowned(),
    "parabolic": crowned(element=PARABOLIC),
    "point": springs(Contact(Body(diameter=20.0), Body(profile=Even(1.0 / 60.0))), approach=0.02, reach=1.4),
    "sharp": springs(Contact(Roller(diameter=20.0, length=20.0), Plate()), 0.03, tilt=1e-3, singular=True),
    "lifted": springs(Contact(Roller(diameter=20.0, length=20.0), Plate(length=20.3)), 0.01, tilt=2.5e-3, strips=41),
    "hollow": springs(
        Contact(Roller(diameter=20.0, length=20.0, profile=Even(-4e-4, 4e-6)), Plate()),
        approach=-0.003,
        tilt=2e-4,
    ),
    "endless": springs(
        Contact(Roller(diameter=20.0, length=20.0, profile=EndlessAtEnds(0.006, 9.95)), Plate()),
        0.025,
        tilt=-7e-4,
    ),
}


# Two crests of one height.
TWINS = springs(Contact(Roller(diameter=20.0, length=20.0, profile=Even(-4e-4, 4e-6)), Plate()), approach=-0.003)
CASES["straight"] = springs(Contact(Roller(diameter=20.0, length=20.0), Plate()), 0.03, singular=True)
CASES["twins"] = with_ends(TWINS, sharp(-10.0), sharp(10.0))
CASES["short"] = springs(Contact(Roller(diameter=20.0, length=0.2), Plate()), 0.02, reach=0.1, singular=True)

# The crest of a crowned roller, and a sharp end that is far above it.
SPIKED = crowned(singular=True, spike=6.0)
CASES["spiked"] = SPIKED


@pytest.fixture(params=CASES)
def solution(request):
    return CASES[request.param]


@pytest.fixture
def ax():
    return Figure().add_subplot()


class TestPressure:
    def test_lines_are_the_strips(self, solution, ax):
        assert plot.pressure(solution, ax) is ax
        left, right = ax.figure.axes
        pressure, half_width = left.lines, right.lines[0]
        line = next(line for line in pressure if len(line.get_xdata()) == solution.strips)
        assert_allclose(line.get_xdata(), solution.y, rtol=0, atol=0)
        assert_allclose(line.get_ydata(), solution.centre_pressure, rtol=0, atol=0)
        assert_allclose(half_width.get_xdata(), solution.y, rtol=0, atol=0)
        assert_allclose(half_width.get_ydata(), solution.half_width, rtol=0, atol=0)

    def test_everything_is_inside_the_axes_and_starts_from_zero(self, solution, ax):
        plot.pressure(solution, ax)
        left, right = ax.figure.axes
        assert left.get_ylim()[0] == right.get_ylim()[0] == 0.0
        assert left.get_ylim()[1] > solution.max_pressure
        assert right.get_ylim()[1] > solution.half_width.max()
        low, high = left.get_xlim()
        assert low < solution.contact_y[0][0]
        assert high > solution.contact_y[-1][1]

    def test_a_maximum_at_a_corner_says_so(self, ax):
        plot.pressure(judged(crowned(), peaks_at_corner=True), ax)
        (shown,) = (text.get_text() for text in ax.texts if "MPa" in text.get_text())
        assert shown.endswith(" mm (corner: rises with refinement)")

    @pytest.mark.slow
    @pytest.mark.parametrize(("load", "largest"), [(20e3, False), (60e3, True)])
    def test_a_pressure_that_rises_again_at_a_land_end_says_so(self, load, largest, ax):
        roller = Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(1500.0), corner_radius=0.8)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", nh.AccuracyWarning)
            solution = solve_one(Contact(roller, Plate()), load=load)
        plot.pressure(solution, ax)
        shown = [text for text in ax.texts if "land end" in text.get_text()]
        assert [text.get_text().endswith(" mm (land end)") for text in shown] == ([True] if largest else [False, False])
        for text in shown if not largest else ():
            y, pressure = text.xy  # type: ignore[attr-defined]
            at = np.abs(solution.y - y).argmin()
            assert text.get_text() == f"land end, {pressure:.0f} MPa"
            assert pressure == solution.centre_pressure[at]
            assert abs(y) == pytest.approx(9.2, abs=0.05)
            inner = np.abs(solution.y) < 9.1
            assert pressure > 1.05 * solution.centre_pressure[inner].min()
        beside = [text.get_text() for text in compared_contacts({"one": solution, "other": solution}).axes[0].texts]
        assert sum(text.startswith("land end, ") for text in beside) == 4
        assert solution.max_pressure > 1500.0

    def test_singular_ends_have_exponent_and_strength(self, ax):
        plot.pressure(CASES["straight"], ax)
        labels = [text for text in ax.texts if "singular" in text.get_text()]
        expected = "singular: $p$ ∼ $K$ / $s^{0.333}$\n$K$ = 656.4 MPa mm$^{0.333}$"
        assert [text.get_text() for text in labels] == [expected] * 2
        # Each stands on the inner side of its end, by an arrow.
        low, high = labels
        assert (low.get_ha(), high.get_ha()) == ("left", "right")
        assert low.xy[0] < -9.0  # type: ignore[attr-defined]
        assert high.xy[0] > 9.0  # type: ignore[attr-defined]
        assert [line.get_xdata()[0] for line in ax.lines if line.get_marker() == "^"] == [-10.0, 10.0]

    def test_singular_end_does_not_set_the_scale(self, ax):
        plot.pressure(SPIKED, ax)
        crest = crowned().max_pressure
        assert_allclose(ax.get_ylim()[1], 1.6 * crest, rtol=1e-12)
        spike = SPIKED.centre_pressure.max()
        assert ax.get_ylim()[1] < spike
        shown = " ".join(text.get_text() for text in ax.texts)
        assert f"{spike:.0f}" not in shown
        assert f"{crest:.0f} MPa" in shown

    def test_the_maximum_near_a_singular_end_is_beyond_a_half_width(self, ax):
        solution = CASES["sharp"]
        plot.pressure(solution, ax)
        marker = next(line for line in ax.lines if line.get_marker() == "o")
        ((y, pressure),) = marker.get_xydata()
        away = solution.y < 10.0 - solution.half_width
        assert solution.centre_pressure[away].max() < pressure < solution.centre_pressure.max()
        assert solution.y[away].max() < y < solution.y[~away].min()
        assert_allclose(10.0 - y, np.interp(y, solution.y, solution.half_width), rtol=1e-12)

    def test_both_of_two_equal_maxima_are_marked(self, ax):
        plot.pressure(TWINS, ax)
        marker = next(line for line in ax.lines if line.get_marker() == "o")
        low, high = marker.get_xdata()
        assert_allclose(low, -high, rtol=1e-12)
        assert f"MPa at $y$ = −{high:.2f} and {high:.2f} mm" in " ".join(text.get_text() for text in ax.texts)

    def test_unconverged_result_says_so(self, ax):
        plot.pressure(crowned(status=Status.STAGNATED), ax)
        assert ax.get_title(loc="left").endswith("NOT CONVERGED")


class TestFootprint:
    def test_outline_is_the_half_width(self, solution, ax):
        plot.footprint(solution, ax)
        pieces = [line.get_xydata() for line in ax.lines if line.get_color() == INK]
        assert len(pieces) == len(solution.contact_y)
        for piece, (low, high) in zip(pieces, solution.contact_y, strict=True):
            assert_allclose(piece[0], piece[-1], rtol=0, atol=0)
            assert_allclose((piece[:, 0].min(), piece[:, 0].max()), (low, high), rtol=0, atol=1e-9)
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
        last = colour_limit(solution)
        # At equal load the parabola's middle is 3/4 q/a against 2/pi q/b.
        own = 0.75 * np.pi / 2.0 * np.sqrt(2.0 / 3.0) if solution.element is PARABOLIC else 1.0
        assert_allclose(highest, own * solution.centre_pressure.max(), rtol=1e-12)
        assert_allclose(last, own * solution.max_pressure, rtol=1e-12)
        assert {mesh.get_clim() for mesh in meshes} == {(0.0, last)}

    @pytest.mark.parametrize(("name", "factor"), [("crowned", np.pi / 2.0), ("parabolic", 4.0 / 3.0)])
    def test_integral_of_the_colours_is_the_line_load(self, name, factor, ax):
        solution = CASES[name]
        plot.footprint(solution, ax)
        (mesh,) = (item for item in ax.collections if isinstance(item, QuadMesh))
        across = mesh.get_coordinates()[:, 1:-1, 1]
        field = mesh.get_array()[:, 1:-1]
        integral = np.trapezoid(field, across, axis=0)
        touching = solution.line_load > 0.0
        assert_allclose(integral, solution.line_load[touching], rtol=2e-3)
        assert_allclose(integral, factor * field[field.shape[0] // 2] * across[-1], rtol=2e-3)

    def test_parabola_shows_the_hertz_half_width_as_well(self, ax):
        solution = CASES["parabolic"]
        plot.footprint(solution, ax)
        dotted = [line for line in ax.lines if line.get_color() == "white"]
        assert_allclose(dotted[1].get_ydata()[1:-1], solution.half_width[solution.line_load > 0.0], rtol=1e-12)
        assert "parabolic strips' own width" in ax.get_title(loc="left")


class TestProfile:
    def test_lines_are_the_surfaces_in_micrometres(self, solution, ax):
        assert plot.profile(solution, ax) is ax
        before, after = (line for line in ax.lines if len(line.get_xdata()) == solution.strips)
        finite = np.isfinite(solution.interference)
        for line, expected in ((before, -1e3 * solution.interference), (after, 1e3 * solution.gap)):
            assert_allclose(line.get_xdata(), solution.y, rtol=0, atol=0)
            assert_allclose(line.get_ydata()[finite], expected[finite], rtol=1e-15)
            assert np.all(np.isnan(line.get_ydata()[~finite]))

    def test_a_cut_axis_says_so(self, ax):
        plot.profile(CASES["endless"], ax)
        assert ax.get_title(loc="left").endswith("; axis cut, the relief is infinite at an end")
        steep = springs(Contact(Roller(diameter=20.0, length=20.0, profile=Even(1e-3)), Plate()), 0.01)
        plot.profile(steep, ax)
        reach = 1e3 * (steep.contact.separation(steep.y[-1]) - steep.approach)
        assert ax.get_title(loc="left").endswith(f"; axis cut, the undeformed distance reaches {reach:.1f} µm")


@pytest.mark.slow
class TestFigures:
    def test_title_is_taken_as_it_is_written(self, tmp_path):
        sheet = plot.figures(CASES["point"], title="$5_{ and $6^^")["pressure"]
        assert "$5_{ and $6^^" in words(sheet)
        plot.save(sheet, tmp_path / "dollars")

    @pytest.mark.slow
    def test_no_words_overlap_or_leave_the_paper(self, solution):
        for sheet in plot.figures(solution, title="A roller").values():
            can_be_read(sheet)

    def test_footprint_has_a_true_panel_and_a_stretched_one(self):
        sheet = plot.figures(CASES["crowned"])["footprint"]
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
        apart = springs(Contact(Roller(diameter=20.0, length=20.0), Plate()), -0.01)
        for name, sheet in plot.figures(apart).items():
            plot.save(sheet, tmp_path / name)

    @pytest.mark.slow
    def test_neither_pyplot_nor_matplotlib_is_imported_before_drawing(self):
        check = "import sys, nonhertz.plot; sys.exit('matplotlib' in sys.modules)"
        subprocess.run([sys.executable, "-c", check], check=True)
        check = (
            "import sys, matplotlib.figure, nonhertz.plot.sheets as s; s.sheet(3.0); "
            "sys.exit('matplotlib.pyplot' in sys.modules)"
        )
        subprocess.run([sys.executable, "-c", check], check=True)


@pytest.mark.slow
class TestSave:
    def test_writes_both_files_beside_the_stem(self, tmp_path):
        sheet = plot.figures(CASES["point"])["footprint"]
        svg, png = plot.save(sheet, tmp_path / "case.v2")
        assert (svg, png) == (tmp_path / "case.v2.svg", tmp_path / "case.v2.png")
        assert ElementTree.parse(svg).getroot().tag == "{http://www.w3.org/2000/svg}svg"
        assert png.read_bytes().startswith(b"\x89PNG")
        assert png.stat().st_size > 10_000

    @pytest.mark.parametrize("name", ["pressure", "footprint", "profile"])
    @pytest.mark.slow
    def test_same_solution_gives_the_same_file(self, name, tmp_path):
        first, again, anew = tmp_path / "first", tmp_path / "again", tmp_path / "anew"
        sheet = plot.figures(CASES["hollow"], title="Twice")[name]
        svg, _ = plot.save(sheet, first)
        assert plot.save(sheet, again)[0].read_bytes() == svg.read_bytes()
        assert (
            plot.save(plot.figures(CASES["hollow"], title="Twice")[name], str(anew))[0].read_bytes() == svg.read_bytes()
        )

    def test_file_does_not_depend_on_the_settings_around(self, tmp_path):
        sheets = plot.figures(CASES["hollow"])
        svg = {name: plot.save(sheet, tmp_path / name)[0].read_bytes() for name, sheet in sheets.items()}
        with mpl.rc_context({"font.size": 14.0, "font.family": "DejaVu Serif", "svg.hashsalt": None}):
            for name, sheet in plot.figures(CASES["hollow"]).items():
                assert plot.save(sheet, tmp_path / name)[0].read_bytes() == svg[name]

    def test_figures_leave_nothing_behind(self):
        sheet = plot.figures(CASES["crowned"])["pressure"]
        remains = weakref.ref(sheet)
        sheet.draw_without_rendering()
        del sheet
        gc.collect()
        assert remains() is None


def test_what_has_no_limit_is_said_at_its_end():
    sharp = solve_one(Contact(Roller(diameter=15.0, length=20.0), Plate()), load=8e3, strips=21)
    chamfered = Roller(diameter=15.0, length=20.0, chamfer=Chamfer(length=2.0, angle=0.3, blend_radius=0.0))
    cornered = solve_one(Contact(chamfered, Plate()), load=8e3)
    ax = Figure().add_subplot()
    mark_unlimited([sharp, sharp, cornered], ax, ["red", "red", "blue"])
    assert [(text.xy[0], text.get_ha(), text.get_color()) for text in ax.texts] == [
        (pytest.approx(y, abs=0.05), side, colour)
        for y, side, colour in (
            (-10.0, "left", INK),
            (10.0, "right", INK),
            (-8.0, "left", "blue"),
            (8.0, "right", "blue"),
        )
    ]
    ax = plot.pressure(cornered, Figure().add_subplot())
    marked = [(text.xy[0], text.get_ha()) for text in ax.texts if text.get_text() == "no limit at a corner"]
    assert marked == [(pytest.approx(-8.0, abs=0.5), "left"), (pytest.approx(8.0, abs=0.5), "right")]


@pytest.mark.parametrize("what", ["pressure", "footprint", "profile"])
def test_a_solution_draws_itself(what, ax):
    solution = crowned()
    assert solution.plot(what, ax) is ax
    own = solution.plot(what)
    assert own.figure is not ax.figure
    assert words(own.figure) == words(ax.figure)
    assert own.xaxis.label.get_fontsize() == SIZE
    with pytest.raises(nh.InputError, match="what = 'shape' must be one of 'pressure', 'footprint', 'profile'"):
        solution.plot("shape")


def test_strips_are_a_dataframe():
    solution = crowned()
    frame = solution.to_dataframe()
    assert list(frame.columns) == list(frame.attrs["units"]) == list(solution.table())
    assert (frame["line_load"] * frame["strip_width"]).sum() == pytest.approx(solution.load)

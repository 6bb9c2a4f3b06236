"""Drawings of the stress below a contact: fields, landmarks and scales are those of the solution."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pytest
from drawn_words import can_be_read, words
from matplotlib.axes import Axes
from matplotlib.contour import QuadContourSet
from matplotlib.figure import Figure
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz import plot
from nonhertz.result.solution import Solution
from nonhertz.subsurface import Extremes, Field, extremes, stress


@dataclass(frozen=True)
class Found:
    solution: Solution
    overall: Extremes
    section: Extremes
    planes: dict[str, Field]

    @classmethod
    def of(cls, solution: Solution, body: str, station: float | None = None):
        overall = extremes(solution, body=body)
        section = extremes(solution, overall.von_mises.y if station is None else station, body=body)
        return cls(solution, overall, section, plot.stress_planes(solution, section))

    def axial(self, ax: Axes) -> Axes:
        return plot.axial_stress(self.solution, self.planes["axial-plane"], self.overall, ax, station=0.5)

    def across(self, ax: Axes) -> Axes:
        return plot.section_stress(self.solution, self.planes["cross-section"], self.section, ax)

    @cached_property
    def sheets(self) -> dict[str, Figure]:
        return plot.stress_figures(self.solution, self.overall, self.section, "A roller", self.planes)


def solved(crown: float, load: float, tilt: float, **body: object) -> Solution:
    roller = nh.Body(diameter=20.0, profile=nh.profile.crown(radius=crown), side_faces="none", **body)  # type: ignore[arg-type]
    return nh.solve(nh.Contact(roller, nh.Body()), load=load, tilt=tilt)


@pytest.fixture(scope="module")
def point():
    # The combined radii are 10 and 100 mm; off the middle, so that y is seen to be y.
    return Found.of(solved(100.0, 1000.0, 0.003), "b", station=0.5)


@pytest.fixture(scope="module")
def sharp():
    return Found.of(solved(4000.0, 20e3, 0.5e-3, length=20.0), "a")


@pytest.fixture
def ax():
    return Figure().add_subplot()


def contours(ax: Axes) -> tuple[QuadContourSet, QuadContourSet]:
    bands, lines = sorted(
        (item for item in ax.collections if isinstance(item, QuadContourSet)), key=lambda c: not c.filled
    )
    return bands, lines


def marks(ax: Axes) -> dict[str, list[list[float]]]:
    return {line.get_marker(): line.get_xydata().tolist() for line in ax.lines if line.get_marker() in "oD^"}


def key(ax: Axes) -> list[str]:
    return [text.get_text() for text in ax.get_legend().get_texts()]


@pytest.mark.slow
def test_contour_lines_lie_where_the_stress_is_theirs(point, ax):
    assert point.axial(ax) is ax
    _, lines = contours(ax)
    assert len(lines.levels) >= 5
    drawn = 0
    for level, pieces in zip(lines.levels, lines.allsegs, strict=True):
        places = np.concatenate([*pieces, np.empty((0, 2))])[::7]
        # On the surface itself the stress has the strips' steps.
        y, z = places[places[:, 1] > 0.03].T
        drawn += y.size
        assert_allclose(stress(point.solution, 0.0, y, z, body="b").von_mises, level, rtol=2e-2)
    assert drawn > 30


def test_the_axial_plane_points_down_and_marks_the_largest_of_the_body(point, ax):
    point.axial(ax)
    deepest, surface = ax.get_ylim()
    assert_allclose((deepest, surface), (3.0 * point.solution.half_width.max(), 0.0), rtol=1e-12)
    found = point.overall
    expected = {"o": found.von_mises, "D": found.shear, "^": found.orthogonal_shear}
    assert marks(ax) == {marker: [[each.y, each.z]] for marker, each in expected.items()}
    assert expected["o"].y > 0.1
    assert ax.get_title(loc="left").endswith("; along the contact, body b, x = 0 mm; true proportions")
    aside = f"at x = ±{found.orthogonal_shear.x:.3f} mm, y = "
    assert [aside in label for label in key(ax)[:3]] == [False, False, True]


def test_the_cross_section_is_true_and_marks_both_sides(point, ax):
    assert point.across(ax) is ax
    ax.figure.draw_without_rendering()
    origin, across, down = ax.transData.transform([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])
    assert_allclose(origin[1] - down[1], across[0] - origin[0], rtol=1e-9)
    found = point.section
    shear = found.orthogonal_shear
    assert marks(ax) == {
        "o": [[0.0, found.von_mises.z]],
        "D": [[0.0, found.shear.z]],
        "^": [[-shear.x, shear.z], [shear.x, shear.z]],
    }
    half_width = float(np.interp(0.5, point.solution.y, point.solution.half_width))
    (surface,) = (line.get_xdata() for line in ax.lines if line.get_marker() == "None")
    assert_allclose(surface, [-half_width, half_width], rtol=1e-12)
    assert ax.get_title(loc="left").endswith("; across the contact, body b, y = 0.5 mm; true proportions")


@pytest.mark.parametrize("name", ["point", "sharp"])
@pytest.mark.slow
def test_sheets_are_to_scale_and_no_words_overlap(name, request):
    sheets = request.getfixturevalue(name).sheets
    assert list(sheets) == ["axial-plane", "cross-section"]
    for sheet in sheets.values():
        assert any("A roller" in text for text in words(sheet))
        can_be_read(sheet)
        assert sheet.axes[1].get_ylabel() == "Von Mises stress [MPa]"
    axes = sheets["axial-plane"].axes[0]
    origin, along, down = axes.transData.transform([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])
    _, _, said = axes.get_title(loc="left").rpartition("stretched ")
    assert_allclose((origin[1] - down[1]) / (along[0] - origin[0]), float(said.split()[0]), rtol=1e-9)

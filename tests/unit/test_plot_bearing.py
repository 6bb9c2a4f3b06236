"""Figures of bearings: what is drawn are the solution's numbers, and every figure says what it is of."""

import math

import numpy as np
import pytest
from crowned_rows import RINGS, pair, row
from drawn_words import can_be_read, words
from matplotlib.collections import QuadMesh
from matplotlib.container import BarContainer
from matplotlib.figure import Figure
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh
from nonhertz import plot
from nonhertz.figures.displacement import MULTIPLES

B = nh.bearing


@pytest.fixture(scope="module")
def tilted():
    return B.solve(row(), radial=5e3, tilt=5e-4)


@pytest.fixture(scope="module")
def both():
    return B.solve(pair(), radial=4e3, axial=1e3)


@pytest.fixture(scope="module")
def sideways():
    return B.solve(row(), radial=(0.0, 5e3))


def polar():
    return Figure().add_subplot(projection="polar")


def flat():
    return Figure().add_subplot()


def labelled(axes, start):
    return next(line for line in axes.lines if str(line.get_label()).startswith(start))


class TestLoads:
    @pytest.mark.parametrize("number", [0, 1])
    def test_bars_are_the_loads_at_both_rings(self, both, number):
        axes = plot.bearing_loads(both, polar(), row=number)
        bars = [each for each in axes.containers if isinstance(each, BarContainer)]
        load = both.load[12 * number : 12 * number + 12]
        for column, (container, ring) in enumerate(zip(bars, ("inner", "outer"), strict=True)):
            assert container.get_label() == f"load at the {ring} ring"
            loaded = load[:, column] > 0.0
            assert_allclose([bar.get_height() for bar in container], 1e-3 * load[loaded, column], rtol=1e-12)
            middles = np.array([bar.get_x() + 0.5 * bar.get_width() for bar in container])
            off = middles - both.angle[:12][loaded]
            assert np.all(np.abs(off) < math.pi / 12.0)  # within the roller's pitch
            assert np.all(np.sign(off) == (-1.0 if column == 0 else 1.0))

    def test_y_points_down_and_z_right(self, tilted):
        axes = plot.bearing_loads(tilted, polar())
        axes.figure.draw_without_rendering()
        centre = axes.transAxes.transform((0.5, 0.5))
        along_y, along_z = (axes.transData.transform((angle, 1.0)) - centre for angle in (0.0, 0.5 * math.pi))
        assert along_y[1] < -10.0 < abs(along_y[0])
        assert along_z[0] > 10.0 > abs(along_z[1])

    def test_the_arrow_points_where_the_force_does(self, sideways):
        axes = plot.bearing_loads(sideways, polar())
        axes.figure.draw_without_rendering()
        (arrow,) = (text for text in axes.texts if getattr(text, "arrow_patch", None))
        start, end = axes.transData.transform([arrow.xyann, arrow.xy])
        way = (end - start) / np.linalg.norm(end - start)
        assert_allclose(way, [1.0, 0.0], atol=1e-6)
        assert "5 kN" in words(axes.figure)


class TestPressure:
    @pytest.mark.parametrize("ring", ["inner", "outer"])
    def test_cells_are_the_pressures_of_rollers(self, sideways, ring):
        axes = plot.bearing_pressure(sideways, flat(), ring=ring)
        (mesh,) = axes.findobj(QuadMesh)
        corners, drawn = mesh.get_coordinates(), mesh.get_array()
        found = sideways.unrolled_pressure(ring)
        middles = 0.5 * (corners[0, 1:, 0] + corners[0, :-1, 0])
        assert_allclose(np.diff(corners[0, :, 0]), 360.0 / 13.0, rtol=1e-9)
        for j, angle in enumerate(np.degrees(found.angle)):
            away = np.mod(middles - angle + 180.0, 360.0) - 180.0
            at = int(np.abs(away).argmin())
            assert abs(away[at]) < 1e-6
            assert_array_equal(np.ma.filled(drawn[:, at], 0.0), found.pressure[j])
        # Half a turn to both sides of z, along which the load points; the roller that is cut there is drawn twice.
        assert axes.get_xlim() == (-90.0, 270.0)
        assert drawn.shape[1] == 15
        assert corners[0, 0, 0] <= -90.0
        assert corners[0, -1, 0] >= 270.0
        assert_array_equal(np.ma.filled(drawn[:, 0], 0.0), np.ma.filled(drawn[:, 13], 0.0))

    def test_the_largest_is_marked_and_colours_reach_to_it(self, tilted):
        figure = Figure()
        axes = [plot.bearing_pressure(tilted, figure.add_subplot(2, 1, k + 1), ring=r) for k, r in enumerate(RINGS)]
        for column, each in enumerate(axes):
            (mesh,) = each.findobj(QuadMesh)
            assert mesh.get_clim() == (0.0, tilted.max_pressure.max())
            most = tilted.max_pressure[:, column].argmax()
            marker = next(line for line in each.lines if line.get_marker() == "o")
            assert_allclose(marker.get_xydata(), [[0.0, tilted.max_pressure_y[most, column]]], atol=1e-9)
            assert f"largest {tilted.max_pressure[most, column]:.4g} MPa at 0°" in each.get_title(loc="right")


class TestRoller:
    def test_lines_are_the_pressures_of_the_most_loaded(self, tilted):
        axes = plot.most_loaded_roller(tilted, flat())
        assert axes.get_title(loc="left") == "Roller 1 at 0.0 degrees, the most loaded"
        for ring in RINGS:
            contact, line = tilted.contact(0, ring), labelled(axes, ring)
            pressed = contact.line_load > 0.0
            assert_array_equal(line.get_xdata()[1:-1], contact.y[pressed])
            assert_allclose(line.get_ydata()[1:-1], contact.centre_pressure[pressed], rtol=1e-12, atol=1e-9)
            # The line falls to zero where the contact ends, not at the next strip.
            assert_array_equal(line.get_xdata()[[0, -1]], [contact.contact_y[0][0], contact.contact_y[-1][1]])
            assert_array_equal(line.get_ydata()[[0, -1]], 0.0)

    def test_the_relief_is_in_micrometres(self, tilted):
        axes = plot.roller_relief(tilted, flat())
        for ring in RINGS:
            y, relief = labelled(axes, ring).get_xydata().T
            # Of a crown: y^2 / (2 R), and the rings are straight.
            assert_allclose(relief, 1e3 * y**2 / 1200.0, rtol=1e-3, atol=1e-6)
        low, high = axes.get_ylim()
        assert low > high  # downwards
        assert "µm" in axes.get_ylabel()


class TestDisplacement:
    def test_the_state_is_marked_with_its_tangent(self, tilted):
        axes = plot.displacement_against_load(tilted, flat())
        marker = labelled(axes, f"radial, {1e3 * tilted.displacement[1]:.4g} µm by strips")
        assert_allclose(marker.get_xydata(), [[5.0, 1e3 * tilted.displacement[1]]], rtol=1e-6)
        tangent = labelled(axes, "tangent: stiffness of the state")
        slope = np.ptp(tangent.get_ydata()) / np.ptp(tangent.get_xdata())  # um/kN
        more = B.solve(row(), radial=5.05e3, tilt=5e-4)
        assert_allclose(slope, 1e3 * (more.displacement[1] - tilted.displacement[1]) / 0.05, rtol=1e-2)

    @pytest.mark.parametrize("radial", [5e3, (3e3, 4e3)])
    def test_the_curve_goes_through_states_by_slices(self, radial):
        found = B.solve(row(), radial=radial, method="slices")
        axes = plot.displacement_against_load(found, flat())
        dots = next(line for line in axes.lines if line.get_marker() == ".")
        assert_allclose(dots.get_xdata(), 5.0 * MULTIPLES, rtol=1e-8)
        way = np.atleast_1d(radial) / 5e3
        for load, moved in dots.get_xydata()[[0, 3]]:
            alone = (
                B.solve(row(), radial=tuple(np.resize(1e3 * load * way, way.size)), method="slices")
                if way.size == 2
                else B.solve(row(), radial=1e3 * load, method="slices")
            )
            assert_allclose(moved, 1e3 * alone.displacement[1:3][: way.size] @ way, rtol=1e-6)
        # The line between states: exact slopes leave it little room.
        line = labelled(axes, "radial by slices")
        between = B.solve(row(), radial=tuple(3.0e3 * way) if way.size == 2 else 3.0e3, method="slices")
        drawn = np.interp(3.0, *line.get_xydata().T)
        assert_allclose(drawn, 1e3 * between.displacement[1:3][: way.size] @ way, rtol=5e-3)

    def test_strips_draw_the_curve_of_strips(self, tilted):
        axes = plot.displacement_against_load(tilted, flat())
        line = labelled(axes, "radial by strips")
        for radial in (3e3, 5e3, 6.4e3):
            found = B.solve(row(), radial=radial, tilt=5e-4)
            assert_allclose(np.interp(1e-3 * radial, *line.get_xydata().T), 1e3 * found.displacement[1], rtol=2e-3)


class TestFigures:
    def test_all_four_and_fewer_where_there_is_less(self, tilted):
        assert list(plot.bearing_figures(tilted)) == ["loads", "pressure", "perspective", "roller", "displacement"]
        assert list(plot.bearing_figures(B.solve(row(), radial=5e3, method="slices"))) == ["loads", "displacement"]
        assert list(plot.bearing_figures(B.solve(row(), radial=0.0))) == ["loads"]

    @pytest.mark.slow
    @pytest.mark.parametrize("name", ["tilted", "both"])
    def test_no_word_leaves_the_sheet(self, name, request):
        title = (
            "A long title with a $ in it that goes on and on, and which is longer than what fits in a line of a page"
        )
        for figure in plot.bearing_figures(request.getfixturevalue(name), title).values():
            assert " ".join(words(figure)).replace("\n", " ").count(title) == 1
            can_be_read(figure)


@pytest.mark.parametrize("what", ["loads", "pressure", "roller", "relief", "displacement"])
def test_a_bearing_draws_itself(what, tilted):
    given = polar() if what == "loads" else flat()
    assert tilted.plot(what, given) is given
    own = tilted.plot(what)
    assert sorted(words(own.figure)) == sorted(words(given.figure))

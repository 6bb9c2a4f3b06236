"""What results say of themselves where they are printed."""

import html
import re

import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.result.brief import HasHtml, plain_text

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(2000))
CONTACT = nh.Contact(ROLLER, nh.Ring(diameter=80))


def quietly(solve, *arguments, **given):
    with without_accuracy_warnings():
        return solve(*arguments, **given)


@pytest.fixture(scope="module")
def solved():
    return nh.solve(CONTACT, load=5e3, tilt=0.2e-3)


def test_a_solution_is_printed_in_ten_lines_at_most(solved):
    said = repr(solved).splitlines()
    assert len(said) <= 10
    assert said[1].strip() == (
        "roller (diameter 20 mm, length 20 mm; ends free, depth finite) against ring (diameter 80 mm; depth none)"
    )
    assert "load 5.0000 kN" in repr(solved)
    assert "tilt 0.20000 mrad" in repr(solved)
    assert f"approach {1e3 * solved.approach:.3f} µm, error about" in repr(solved)
    assert re.search(r"maximum pressure \d+\.\d MPa at y = \S+ mm, error about", repr(solved))
    assert "both ends run out" in repr(solved)


def test_maxima_that_mirror_each_other_are_two_places_and_neighbours_one():
    sharp = quietly(nh.solve, nh.Contact(nh.Roller(diameter=20, length=20), nh.Ring(diameter=80)), load=20e3)
    low, high = re.search(r"maximum pressure \S+ MPa at y = (\S+) and (\S+) mm, away from", repr(sharp)).groups()
    assert float(low) == -float(high) == pytest.approx(-abs(sharp.max_pressure_y), abs=1e-3)
    even = quietly(nh.solve, CONTACT, load=5e3, strips=20)
    assert re.search(r"maximum pressure \S+ MPa at y = \S+ mm", repr(even))


def test_notebooks_see_the_pressure_drawn(solved):
    page = solved._repr_html_()
    points = re.search(r'points="([^"]*)"', page)[1].split()
    assert len(points) == solved.strips
    heights = [float(point.partition(",")[2]) for point in points]
    assert heights[int(solved.centre_pressure.argmax())] == min(heights) < 20.0
    assert heights[0] == max(heights)
    assert "<li>" in page
    assert "load 5.0000 kN" in page


def test_plane_grids_and_batches_are_printed_too():
    patch = quietly(nh.patch.solve, CONTACT, load=5e3, cells=(32, 64))
    assert len(repr(patch).splitlines()) <= 10
    assert "32 x 64 cells" in repr(patch)
    many = quietly(nh.solve_many, CONTACT, approach=[[5e-3, 6e-3], [7e-3, -1.0]], strips=21)
    said = repr(many)
    assert "3 of 4 cases converged, shape 2 x 2" in said
    assert "approach 5.0000 to 7.0000 µm" in said
    assert "failed: case (1, 1): approach = -1.0" in said


def test_notebooks_see_every_result_as_it_prints():
    case = nh.new_case(changes={"solver.strips": 21})
    study = nh.sweep(case, over={"load.load": [5e3, 6e3]}, quantities=("approach",))
    for result in (study, nh.solve_many(CONTACT, load=[5e3, 6e3], strips=41), nh.compare(CONTACT, load=5e3)):
        name, *lines = repr(result).splitlines()
        shown = result._repr_html_()
        assert f"<strong>{name}</strong>" in shown
        assert re.findall("<li>(.*?)</li>", shown) == [html.escape(line.strip()) for line in lines] != []


def test_what_notebooks_are_shown_is_escaped():
    class Result(HasHtml):
        def __repr__(self):
            return plain_text("<b>", ["<script>alert(1)</script>", "a & b"])

    shown = Result()._repr_html_()
    assert "<script>" not in shown
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in shown
    assert "<strong>&lt;b&gt;</strong>" in shown
    assert "a &amp; b" in shown

"""Rollers on a half-space along the line, against converged results of an independent program (data/*.json).

Approach, middle and strength are claims of `nonhertz verify`; 90 strips are asked to be enough for all of it. The
crown of the references is the parabola y^2 / 8000; the circle of `nh.profile.crown(4000)` differs from it by
3e-7 of the approach, far below any tolerance here.
"""

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

import nonhertz as nh
from nonhertz.verify import half_space

HALF_LENGTH = 10.0
CASES = dict(zip(("BH1", "B0", "D"), half_space.REFERENCES, strict=True))
every_case = pytest.mark.parametrize("name", CASES)
with_sharp_ends = pytest.mark.parametrize("name", ["B0", "D"])


def reference(name):
    return json.loads((Path(__file__).parent / "data" / f"{name}.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def solutions():
    return {
        name: nh.solve(
            half_space.on_strips(each).contact,
            load=each.load,
            tilt=each.tilt,
            accuracy=2e-5 if name == "BH1" else None,  # the others have sharp ends
        )
        for name, each in CASES.items()
    }


@every_case
def test_ninety_strips_are_enough(solutions, name):
    solution, each = solutions[name], CASES[name]
    assert solution.strips <= 90
    middle = int(np.argmin(np.abs(solution.y)))
    found = [solution.approach, solution.centre_pressure[middle], solution.half_width[middle]]
    np.testing.assert_allclose(found, [each.approach, each.pressure, each.half_width], rtol=each.tolerance, atol=0.0)
    # 3e-4 of BH1's moment; without tilt there is none, to the same share of load times 2 mm, BH1's arm.
    assert solution.moment == pytest.approx(each.moment or 0.0, abs=3e-4 * 2.0 * each.load)


def test_the_tilted_contact_ends_where_the_ellipse_ends(solutions):
    expected = reference("BH1")
    ((low, high),) = solutions["BH1"].contact_y
    # The end is known to a strip, 1 % of the contact's length there.
    np.testing.assert_allclose([low, high], expected["contact_y"], rtol=0.0, atol=0.15)
    np.testing.assert_allclose(solutions["BH1"].max_pressure, expected["max_pressure"], rtol=1e-4, atol=0.0)
    assert abs(solutions["BH1"].max_pressure_y - expected["max_pressure_y"]) < 0.25


def distances(name, nearest):
    """Reference points at least ``nearest`` mm inside the end of the contact."""
    expected = reference(name)
    y = np.array(expected["y"])
    low, high = expected.get("contact_y", (-HALF_LENGTH, HALF_LENGTH))
    inside = (y > low + nearest) & (y < high - nearest)
    return y[inside], np.array(expected["pressure"])[inside], np.array(expected["half_width"])[inside]


@every_case
@pytest.mark.parametrize(("nearest", "rtol"), [(2.0, 0.002), (0.5, 0.01)])
def test_pressure_along_the_line(solutions, name, nearest, rtol):
    # To reach: 1 % up to 0.5 mm from the end. A smooth curve through the strips' values joins them.
    y, pressure, _ = distances(name, nearest)
    assert y.size > 30
    along = PchipInterpolator(solutions[name].y, solutions[name].centre_pressure)
    np.testing.assert_allclose(along(y), pressure, rtol=rtol, atol=0.0)


@with_sharp_ends
def test_pressure_close_to_a_sharp_end(solutions, name):
    # To reach: 3 % up to 0.1 mm, a third of the half-width, from the singularity.
    y, pressure, _ = distances(name, 0.1)
    assert np.max(np.abs(y)) > 9.89
    along = PchipInterpolator(solutions[name].y, solutions[name].centre_pressure)
    np.testing.assert_allclose(along(y), pressure, rtol=0.03, atol=0.0)


@every_case
def test_half_width_along_the_line(solutions, name):
    y, _, half_width = distances(name, 0.5)
    along = PchipInterpolator(solutions[name].y, solutions[name].half_width)
    np.testing.assert_allclose(along(y), half_width, rtol=0.01, atol=0.0)


@with_sharp_ends
def test_pressure_by_strength_and_correction(solutions, name):
    # Documented: 2 % up to half a half-width. Nearer than 0.01 mm the rectangles of the references are too wide.
    expected, edge = reference(name), solutions[name].edge_pressure[1]
    distance, pressure = HALF_LENGTH - np.abs(expected["y"]), np.array(expected["pressure"])
    near = (distance > 0.01) & (distance < 0.5 * solutions[name].half_width[-1])
    assert np.count_nonzero(near) >= 4
    np.testing.assert_allclose(edge.at(distance[near]), pressure[near], rtol=0.02, atol=0.0)

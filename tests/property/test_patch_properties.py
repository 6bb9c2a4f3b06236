"""What holds for every contact on a plane grid, whatever its shape."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import nonhertz as nh

# Drawn waves and dents may be narrower than these few cells, which is said, and changes none of the laws.
pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")]
lawful = settings(derandomize=True, max_examples=6, deadline=None)
BODIES = nh.Contact(nh.Body(diameter=20, length=20, side_faces="none"), nh.Plate())
CELLS = (20, 28)
TOLERANCE = 1e-10
# Far more than a solution to TOLERANCE leaves, far less than anything that a mistake would.
RTOL = 1e-6


@st.composite
def gaps(draw):
    """A paraboloid with waves askew and a dent or two, in contact in any number of pieces."""
    radius_y = draw(st.floats(20.0, 5000.0))
    waves = nh.patch.Waviness(
        amplitude=draw(st.floats(0.0, 1e-3)),
        wavelength=draw(st.floats(0.2, 4.0)),
        direction=draw(st.floats(-1.5, 1.5)),
        phase=draw(st.floats(0.0, 6.0)),
    )
    dent = nh.patch.Dent(
        x=draw(st.floats(-0.1, 0.1)),
        y=draw(st.floats(-1.0, 1.0)),
        depth=draw(st.floats(1e-4, 5e-3)),
        diameter=draw(st.floats(0.1, 2.0)),
        shoulder=draw(st.floats(0.0, 1e-3)),
    )
    return lambda x, y: x**2 / 20.0 + y**2 / (2.0 * radius_y) + waves(x, y) + dent(x, y)


loads = st.floats(100.0, 10e3)
tilts = st.floats(-1e-3, 1e-3)


def solve(gap, **prescribed):
    return nh.patch.solve(BODIES, gap=gap, cells=CELLS, tolerance=TOLERANCE, **prescribed)


def on(solution):
    """The region of a solution, to solve again on the same cells."""
    half = 0.5 * solution.dx, 0.5 * solution.dy
    return ((solution.x[0] - half[0], solution.x[-1] + half[0]), (solution.y[0] - half[1], solution.y[-1] + half[1]))


@lawful
@given(gaps(), loads, tilts, st.floats(0.1, 10.0))
def test_gap_and_load_grow_together(gap, load, tilt, factor):
    # Linear elasticity: lengths across the gap and pressures by one factor.
    first = solve(gap, load=load, tilt=tilt)
    again = nh.patch.solve(
        BODIES,
        gap=lambda x, y: factor * gap(x, y),
        load=factor * load,
        tilt=factor * tilt,
        cells=CELLS,
        tolerance=TOLERANCE,
        region=on(first),
    )
    np.testing.assert_allclose(again.pressure, factor * first.pressure, rtol=0.0, atol=RTOL * again.max_pressure)
    np.testing.assert_allclose(again.approach, factor * first.approach, rtol=RTOL, atol=1e-9)


@lawful
@given(gaps(), loads, tilts)
def test_mirrored_bodies_have_mirrored_pressures(gap, load, tilt):
    first = solve(gap, load=load, tilt=tilt)
    (x_low, x_high), (y_low, y_high) = on(first)
    across = nh.patch.solve(
        BODIES,
        gap=lambda x, y: gap(-x, y),
        load=load,
        tilt=tilt,
        cells=CELLS,
        tolerance=TOLERANCE,
        region=((-x_high, -x_low), (y_low, y_high)),
    )
    np.testing.assert_allclose(across.pressure[::-1], first.pressure, rtol=0.0, atol=RTOL * first.max_pressure)
    along = nh.patch.solve(
        BODIES,
        gap=lambda x, y: gap(x, -y),
        load=load,
        tilt=-tilt,
        cells=CELLS,
        tolerance=TOLERANCE,
        region=((x_low, x_high), (-y_high, -y_low)),
    )
    np.testing.assert_allclose(along.pressure[:, ::-1], first.pressure, rtol=0.0, atol=RTOL * first.max_pressure)
    np.testing.assert_allclose(along.moment, -first.moment, rtol=0.0, atol=RTOL * load)


@pytest.mark.parametrize("stiffer", [0.2, 7.0])
def test_modulus_and_load_grow_together(stiffer):
    def of(factor):
        steel = nh.Material(factor * 207000.0, 0.3)
        roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(1000), material=steel)
        return nh.patch.solve(nh.Contact(roller, nh.Plate(material=steel)), load=factor * 3e3, cells=CELLS)

    soft, stiff = of(1.0), of(stiffer)
    np.testing.assert_allclose(stiff.pressure, stiffer * soft.pressure, rtol=0.0, atol=RTOL * stiff.max_pressure)
    np.testing.assert_allclose(stiff.approach, soft.approach, rtol=RTOL, atol=0.0)

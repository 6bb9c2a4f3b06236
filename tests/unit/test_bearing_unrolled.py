"""Rollers of a bearing side by side: load zone, unrolled pressure, tables."""

import math

import numpy as np
import pytest
from crowned_rows import pair, row
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh

B = nh.bearing


@pytest.fixture(scope="module")
def tilted():
    return B.solve(row(), radial=5e3, tilt=1e-3)


@pytest.fixture(scope="module")
def both():
    return B.solve(pair(), radial=4e3, axial=1e3)


def gauss(low, high, points):
    x, weight = np.polynomial.legendre.leggauss(points)
    return 0.5 * (high + low) + 0.5 * (high - low) * x, 0.5 * (high - low) * weight


# Load zone
@pytest.mark.parametrize(
    ("clearance", "radial", "speed", "loaded"),
    [
        (-0.01, 0.0, 0.0, 13),
        # Some 0.1 um beyond the clearance; the next roller is 0.1 (1 - cos 27.7 deg) / 2 mm away.
        (0.1, 100.0, 0.0, 1),
        (0.1, 100.0, 5e3, 1),  # speed presses the others on the outer ring alone
        (0.0, 2e3, 0.0, 7),  # those with cos(angle) > 0, whatever the load
    ],
)
def test_rollers_that_the_inner_ring_loads_are_the_load_zone(clearance, radial, speed, loaded):
    found = B.solve(row(clearance=clearance), radial=radial, speed=speed, method="slices")
    assert_allclose(found.load_zone, [2.0 * math.pi * loaded / 13.0], rtol=1e-15)
    assert_array_equal(found.loaded_share, [loaded / 13.0])
    assert np.count_nonzero(found.load[:, 1]) == (13 if speed else loaded)


def test_every_row_has_its_load_zone(both):
    loaded = both.load[:, 0] > 0.0
    assert_allclose(both.load_zone, 2.0 * math.pi * np.array([loaded[:12].sum(), loaded[12:].sum()]) / 12.0)
    assert both.loaded_share[0] > both.loaded_share[1] > 0.0  # the axial force presses on the first row


# Pressure
@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_pressures_integrate_to_the_loads(tilted, ring):
    column = ["inner", "outer"].index(ring)
    places, along = gauss(-5.0, 5.0, 400)
    pressure = tilted.unrolled_pressure(ring, y=places).pressure
    for j, load in enumerate(tilted.load[:, column]):
        contact = tilted.contact(j, ring)
        if contact is None:
            assert load == 0.0
            assert not pressure[j].any()
            continue
        # Across: the places where a semi-ellipse becomes smooth, x = b sin t, with the half-widths of the strips.
        t, across = gauss(-0.5 * math.pi, 0.5 * math.pi, 24)
        half_width = np.interp(places, contact.y, contact.half_width)
        line_load = (pressure[j][:, None] * np.cos(t) ** 2 * half_width[:, None]) @ across
        # Between strips pressures and half-widths are interpolated: 1e-3 with a hundred of them.
        assert_allclose(line_load @ along, load, rtol=2e-3)
        assert_allclose((line_load * places) @ along, tilted.moment[j, column], rtol=5e-3, atol=1e-3 * load)


def test_pressures_are_those_of_the_contacts(tilted):
    contact = tilted.contact(1, "outer")
    inside = contact.line_load > 0.0
    found = tilted.unrolled_pressure("outer", y=contact.y[inside])
    assert_allclose(found.pressure[1], contact.centre_pressure[inside], rtol=1e-12)
    assert_array_equal(found.angle, tilted.angle)


def test_rows_have_their_own_rollers_and_one_grid(both):
    first, second = (both.unrolled_pressure("inner", row=k) for k in (0, 1))
    assert first.pressure.shape == second.pressure.shape == (12, first.y.size)
    assert_allclose(first.y[[0, -1]], [-5.0, 5.0])
    for k, found in enumerate((first, second)):
        assert found.row == k
        assert_array_equal(found.pressure.any(axis=1), both.load[12 * k : 12 * k + 12, 0] > 0.0)
    # No end is sharp: the grid of 401 misses no more than a hundredth of the maximum pressure.
    assert_allclose(first.pressure.max(), both.max_pressure[:12, 0].max(), rtol=1e-2)


def test_what_is_not_there_is_refused(tilted):
    with pytest.raises(nh.InputError, match="row = 1 must be a whole number"):
        tilted.unrolled_pressure(row=1)
    with pytest.raises(nh.InputError, match="y = 0 must be a row of numbers"):
        tilted.unrolled_pressure(y=0)
    sliced = B.solve(row(), radial=5e3, method="slices")
    with pytest.raises(nh.InputError, match="method = 'slices' must be 'strips' for pressures"):
        sliced.unrolled_pressure()


# Tables
def test_a_table_has_a_line_a_contact(both):
    frame = both.to_dataframe()
    assert len(frame) == 48
    line = frame[(frame["row"] == 1) & (frame["roller"] == 3) & (frame["ring"] == "outer")].iloc[0]
    for name in ("load", "moment", "approach", "tilt", "contact_angle", "max_pressure"):
        assert line[name] == getattr(both, name)[15, 1]
    assert line["angle"] == both.angle[15]
    assert line["rib_load"] == 0.0
    assert frame["rib_load"].sum() == pytest.approx(both.rib_load.sum(), rel=1e-14)
    assert frame.groupby("ring")["load"].sum()["inner"] == pytest.approx(both.load[:, 0].sum(), rel=1e-14)
    assert set(frame.attrs["units"]) == set(frame.columns) - {"row", "roller", "ring"}


def test_slices_have_no_pressures_in_the_table():
    frame = B.solve(row(), radial=5e3, method="slices").to_dataframe()
    assert frame["max_pressure"].isna().all()
    assert frame["load"].notna().all()


def test_states_are_a_line_each():
    many = B.solve_many(row(), radial=np.array([2e3, 5e3])[:, None], tilt=[0.0, 1e-3, 2e-3], method="slices")
    frame = many.to_dataframe()
    assert frame.index.names == ["radial", "tilt"]
    assert frame.loc[(5e3, 2e-3), "moment_z"] == many.force[1, 2, 4]
    assert frame.loc[(5e3, 2e-3), "displacement_y"] == many.displacement[1, 2, 1]
    assert frame.loc[(2e3, 1e-3), "max_load_outer"] == many.load[0, 1, :, 1].max()
    assert frame.loc[(2e3, 1e-3), "loaded_share_0"] == many[0, 1].loaded_share[0]
    assert frame["force_y"].to_numpy() == pytest.approx([2e3] * 3 + [5e3] * 3, rel=1e-8)
    assert set(frame.attrs["units"]) == set(frame.columns) - {"loaded_share_0", "converged"}
    assert B.solve_many(row(), radial=[1e3, 2e3], method="slices").to_dataframe().index.name == "radial"


def test_a_state_without_a_balance_has_no_numbers():
    many = B.solve_many(row(), radial=[2e3, 5e3], method="slices")
    object.__setattr__(many, "converged", np.array([True, False]))
    frame = many.to_dataframe()
    assert frame.iloc[1].drop("converged").isna().all()
    assert frame.iloc[0].notna().all()


def test_the_contacts_of_a_bearing_have_labelled_dimensions():
    solution = B.solve(row(), radial=5e3, method="slices")
    data = solution.to_xarray()
    assert data["load"].dims == ("roller", "ring")
    np.testing.assert_array_equal(data["load"].sel(ring="outer"), solution.load[:, 1])
    assert data["load"].attrs["units"] == "N"
    assert "max_pressure" not in data
    np.testing.assert_array_equal(data["angle"], solution.angle)

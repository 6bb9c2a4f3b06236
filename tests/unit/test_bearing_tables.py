"""Tables of forces on a bearing: against solved states, and as other programs read them."""

import csv
import dataclasses
import re
import warnings

import numpy as np
import pytest
from crowned_rows import row
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.bearing import equilibrium
from nonhertz.files import force_tables

B = nh.bearing
ROW = row(clearance=0.01, radius=1200.0)
Y, Z, TILT = np.linspace(-0.02, 0.03, 6), np.linspace(-0.01, 0.02, 4), np.linspace(-1e-3, 5e-4, 5)


@pytest.fixture(scope="module")
def found():
    return B.table(ROW, y=Y, z=Z, about_z=TILT, method="slices")


def test_its_points_are_states_of_the_bearing(found):
    assert found.names == ("y", "z", "about_z")
    assert found.force.shape == (6, 4, 5, 5)
    assert found.stiffness.shape == (6, 4, 5, 5, 5)
    assert found.converged.all()
    for at in [(5, 0, 0), (0, 3, 4), (2, 2, 2)]:
        motions = {"radial_displacement": (Y[at[0]], Z[at[1]]), "tilt": TILT[at[2]]}
        alone = B.solve(ROW, **motions, method="slices")
        assert_allclose(found.displacement[at], alone.displacement, atol=1e-15)
        assert_allclose(found.force[at], alone.force, rtol=1e-9, atol=1e-6)
        assert_allclose(found.stiffness[at], alone.stiffness, rtol=1e-7, atol=1e-3)


def test_fixed_motions_are_in_it():
    fixed = B.table(ROW, y=[0.0, 0.02], z=0.004, about_y=2e-4, method="slices")
    assert_allclose(fixed.displacement, [[0.0, 0.0, 0.004, 2e-4, 0.0], [0.0, 0.02, 0.004, 2e-4, 0.0]], atol=0)


def test_between_points_forces_are_within_the_bound(found):
    rng = np.random.default_rng(4)
    y, z, tilt = (rng.uniform(axis[0], axis[-1], 60) for axis in found.axes)
    exact = [B.solve(ROW, radial_displacement=(y[k], z[k]), tilt=tilt[k], method="slices").force for k in range(y.size)]
    for kind in ("linear", "cubic"):
        off = np.abs(found.interpolated(kind=kind, y=y, z=z, about_z=tilt) - exact)
        assert np.all(off.max(axis=0) <= found.sampled_error(kind))
        # A bound that is far above what there is would say nothing.
        assert np.all(off.max(axis=0)[1:] > 0.2 * found.sampled_error(kind)[1:])
    assert np.all(found.sampled_error("cubic")[1:3] < 0.6 * found.sampled_error("linear")[1:3])


def test_at_its_points_interpolation_is_exact(found):
    at = found.interpolated(y=Y[:, None], z=Z[2], about_z=TILT)
    assert at.shape == (6, 5, 5)
    assert_allclose(at, found.force[:, 2], rtol=1e-12, atol=1e-9)


def test_halving_the_cells_quarters_what_linear_interpolation_is_off_by():
    # Straight rollers under preload stay in contact all along: without a kink the error is that of a parabola.
    preloaded = dataclasses.replace(ROW, roller=nh.Roller(diameter=9.0, length=10.0), clearance=-0.04)
    coarse, fine = (
        B.table(preloaded, y=np.linspace(-0.012, 0.012, n), method="slices", checks=1000).sampled_error()[1]
        for n in (9, 17)
    )
    assert coarse / fine == pytest.approx(4.0, rel=0.15)


@pytest.mark.slow
def test_a_table_by_maps_is_that_by_strips():
    grid = {"y": [0.01, 0.02], "about_z": [0.0, 3e-4]}
    maps = B.maps(ROW, load=4e3, tilt=6e-4, accuracy=1e-3)
    by_maps, by_strips = B.table(ROW, **grid, method=maps), B.table(ROW, **grid, checks=0)
    assert_allclose(by_maps.force[..., 1], by_strips.force[..., 1], rtol=2e-3, atol=1.0)
    assert np.all(np.isnan(by_strips.sampled_error()))
    assert "interpolated" not in repr(by_strips)
    with pytest.raises(nh.InputError, match="method = 'maps too small' must reach to loads of"):
        B.table(ROW, y=[0.0, 0.2], method=maps)


def test_a_turning_outer_ring_flings_rollers_as_in_single_states():
    options = {"speed": 20e3, "turning": "outer", "method": "slices"}
    expected = B.solve(ROW, radial_displacement=0.02, tilt=(0.0, 0.0), **options).force
    flung = B.table(ROW, y=[0.0, 0.02], **options)
    assert_allclose(flung.force[1], expected, rtol=1e-9, atol=1e-6)
    assert "at 20000 1/min of the outer ring" in repr(flung)
    assert not np.allclose(B.table(ROW, y=[0.0, 0.02], **options | {"turning": "inner"}).force[1], expected, rtol=1e-3)


def test_states_without_a_balance_are_gaps(monkeypatch, tmp_path):
    # Far moves of the ring take more steps.
    for steps in range(1, 40):
        monkeypatch.setattr(equilibrium, "STEPS", steps)
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            gaps = B.table(ROW, y=[0.01, 0.012, 0.2, 0.3], about_z=2e-3, speed=20e3, method="slices")
        if gaps.converged[:2].all():
            break
    assert gaps.converged.tolist() == [True, True, False, False]
    assert re.search("No equilibrium was found for . of 7 states of the bearing; see converged", str(said[0].message))
    assert said[0].category is nh.AccuracyWarning
    assert np.all(np.isnan(gaps.force[2:]))
    low, high = gaps.force[:2, 1]
    assert low < gaps.interpolated(y=0.011)[1] < high
    assert len(gaps.checked_force) == 1
    with pytest.raises(nh.InputError, match="kind = 'cubic' must not be used"):
        gaps.interpolated(kind="cubic", y=0.011)
    force_tables.write(tmp_path / "gaps.csv", gaps)
    assert (tmp_path / "gaps.csv").read_text().splitlines()[-1].endswith("nan,0")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, "y = 0.0 must be an array if no other displacement is"),
        ({"y": [0.0]}, r"y = \[0.0\] must be a number or two or more that ascend"),
        ({"z": [0.0, 0.0]}, r"z = \[0.0, 0.0\] must be a number or two or more that ascend"),
        ({"about_y": [0.0, 1.0]}, "must be a small angle"),
        ({"y": np.arange(1000), "z": np.arange(1000)}, "grid of y, z = 'too large' must be at most 200000 points, not"),
    ],
)
def test_grids_that_are_none_are_refused(given, said):
    with pytest.raises(nh.InputError, match=said):
        B.table(ROW, method="slices", **given)


@pytest.mark.parametrize(
    ("kind", "given", "said"),
    [
        ("linear", {"y": 0.0, "z": 0.0}, "about_z must be given: give y, z, about_z"),
        ("linear", {"y": 0.0, "z": 0.0, "about_z": 0.0, "x": 0.0}, "x = 0.0 must be left out: it does not vary"),
        ("linear", {"y": [0.0, 0.04], "z": 0.0, "about_z": 0.0}, "y = 0.04 must lie in the range of the table, -0.02"),
    ],
)
def test_points_that_are_not_in_it_are_refused(found, kind, given, said):
    with pytest.raises(nh.InputError, match=said):
        found.interpolated(kind=kind, **given)


def test_a_spline_needs_four_points():
    small = B.table(ROW, y=[0.0, 0.01, 0.02], method="slices")
    with pytest.raises(nh.InputError, match="kind = 'cubic' must not be used with 3 points along y: it needs 4"):
        small.interpolated(kind="cubic", y=0.01)


# Files


def test_csv_has_a_line_for_each_state(found, tmp_path):
    path = force_tables.write(tmp_path / "new" / "table.csv", found)
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 120
    at = 1 * 20 + 3 * 5 + 2
    named = {"y [mm]": Y[1], "z [mm]": Z[3], "about_z [rad]": TILT[2], "x [mm]": 0.0, "converged": 1.0}
    named |= {"force_y [N]": found.force[1, 3, 2, 1], "moment_z [N mm]": found.force[1, 3, 2, 4]}
    named |= {"force_y_by_z [N/mm]": found.stiffness[1, 3, 2, 1, 2]}
    named |= {"moment_z_by_about_z [N mm/rad]": found.stiffness[1, 3, 2, 4, 4]}
    for name, value in named.items():
        assert float(rows[at][name]) == pytest.approx(value, rel=1e-9, abs=1e-12)
    assert len(rows[0]) == 5 + 5 + 25 + 1


@pytest.mark.parametrize(
    ("path", "said"),
    [
        (3, "path = 3 must be the name of a file to write"),
        ("table.txt", "path = .* must be a file ending in .csv"),
        ("taken/table.csv", "path = .* must be a directory, not a file"),
    ],
)
def test_files_that_cannot_be_are_refused(found, tmp_path, path, said):
    (tmp_path / "taken").write_text("")
    with pytest.raises(nh.InputError, match=said):
        force_tables.write(tmp_path / path if isinstance(path, str) else path, found)
    assert [each.name for each in tmp_path.iterdir()] == ["taken"]

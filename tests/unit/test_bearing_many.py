"""Many states of a bearing, and maps of its contacts."""

import dataclasses
import pickle

import numpy as np
import pytest
from crowned_rows import row, washers
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.bearing import equilibrium
from nonhertz.figures.displacement import displacement_against_load
from nonhertz.native import core

B = nh.bearing


@pytest.fixture(scope="module")
def maps():
    return B.maps(row(), load=3e3, tilt=1e-3, accuracy=1e-3)


def test_states_are_those_of_one_at_a_time():
    radial, tilt = np.array([500.0, 4e3, 9e3])[:, None], np.array([0.0, 5e-4])
    found = B.solve_many(row(), radial=radial, tilt=tilt, method="slices")
    assert found.converged.shape == (3, 2)
    assert found.converged.all()
    for at in np.ndindex(3, 2):
        alone = B.solve(row(), radial=float(radial[at[0], 0]), tilt=float(tilt[at[1]]), method="slices")
        assert_allclose(found.displacement[at], alone.displacement, rtol=1e-7, atol=1e-11)
        assert_allclose(found.load[at], alone.load, rtol=1e-7, atol=1e-5)
        assert_allclose(found[at].stiffness, alone.stiffness, rtol=1e-6, atol=1e-4)
    assert len(found) == 3
    assert "6 of 6 states converged, shape 3 x 2" in repr(found)
    with pytest.raises(IndexError):
        found[0]
    assert_allclose(pickle.loads(pickle.dumps(found)).load, found.load)
    # Together these are more steps than one search may take.
    assert B.solve_many(row(), radial=np.full(120, 3e3), tilt=5e-4, method="slices").converged.all()


def test_all_motions_at_once_lead_back_to_the_forces():
    found = B.solve_many(row(), radial=np.array([500.0, 9e3]), tilt=5e-4, method="slices")
    again = B.solve_many(row(), displacement=found.displacement[None], method="slices")
    assert again.converged.shape == (1, 2)
    assert_allclose(again.force[0], found.force, rtol=1e-7, atol=1e-4)
    # Along z and about y as well: the same a quarter turn on is the same force, turned.
    turned = np.array([[0.0, 0.0, 0.03, 0.0, 0.0], [0.0, 0.03, 0.0, 0.0, 0.0]])
    even = dataclasses.replace(row(), rollers=12)
    along_z, along_y = B.solve_many(even, displacement=turned, method="slices").force
    assert along_z[2] > 1e3
    assert_allclose(along_z[[2, 1]], along_y[[1, 2]], rtol=1e-9, atol=1e-9 * along_z[2])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"displacement": [0.0, 0.01]}, r"displacement = \(2,\) must be of shape \(..., 5\)"),
        ({"displacement": [0.0, 0.0, 0.0, 0.0, 1.0]}, r"displacement = 1.0 must be a small angle"),
        ({"displacement": np.zeros(5), "tilt": 1e-3}, "tilt = 0.001 must not be given together with displacement"),
    ],
)
def test_motions_that_are_none_are_refused(given, said):
    with pytest.raises(nh.InputError, match=said):
        B.solve_many(row(), method="slices", **given)


@pytest.mark.slow
def test_maps_lead_to_the_loads_of_strips(maps):
    assert "2 contacts, loads up to 3 kN" in repr(maps)
    by_maps = B.solve(row(), radial=6e3, tilt=3e-4, method=maps)
    by_strips = B.solve(row(), radial=6e3, tilt=3e-4)
    assert_allclose(by_maps.load, by_strips.load, rtol=2e-3, atol=3.0)
    assert_allclose(by_maps.displacement, by_strips.displacement, rtol=2e-3, atol=1e-7)
    many = B.solve_many(row(), radial=[2e3, 6e3], tilt=3e-4, method=maps)
    assert_allclose(many.load[1], by_maps.load, rtol=1e-6, atol=1e-3)


def test_displacements_against_load_are_those_of_maps_with_the_ring_that_turns(maps):
    state = B.solve(row(), radial=3e3, speed=15e3, turning="outer", method=maps)
    curve = displacement_against_load(state, maps).panels[0].marks[0]
    again = B.solve(row(), radial=1.5 * 3e3, speed=15e3, turning="outer", method=maps)
    assert curve.name == "radial by maps"
    assert curve.y[-1] == pytest.approx(again.displacement[1], rel=1e-6)


def test_maps_that_are_too_small_or_of_another_bearing_are_refused(maps):
    with pytest.raises(nh.InputError, match="method = 'maps too small' must reach to loads of"):
        B.solve(row(), radial=20e3, method=maps)
    with pytest.raises(nh.InputError, match="must be maps of this bearing"):
        B.solve(row(clearance=0.0), radial=1e3, method=maps)


def test_a_state_without_a_balance_is_said_to_have_none(monkeypatch):
    monkeypatch.setattr(equilibrium, "STEPS", 1)
    found = B.solve_many(row(), radial=[0.0, 30e3], tilt=1e-3, method="slices")
    assert found.converged.tolist() == [True, False]
    with pytest.raises(nh.ConvergenceError, match="State 1 of the bearing has no equilibrium"):
        found[1]
    with pytest.raises(nh.ConvergenceError, match="the loads may leave the inner ring unsupported"):
        B.solve(row(), radial=30e3, tilt=1e-3, method="slices")


def test_strips_are_laid_for_states_that_can_be_balanced_alone(monkeypatch):
    thrust = washers(10.0, 60.0, 14)
    # Beyond the rollers' ends no sum of their loads acts.
    found = B.solve_many(thrust, axial=1e3, moment=[1e3, 36e3])
    assert found.converged.tolist() == [True, False]
    assert_allclose(found.force[0], [1e3, 0.0, 0.0, 0.0, 1e3], rtol=1e-8, atol=1e-5)
    monkeypatch.setattr(core, "StripLaw", None)
    with pytest.raises(nh.ConvergenceError, match="the loads may leave the inner ring unsupported"):
        B.solve(thrust, moment=100e3)


def test_rollers_without_a_balance_are_told_where_all_motions_are_given(monkeypatch):
    given = {"displacement": [[0.0, 0.03, 0.0, 0.0, 1e-4]], "speed": 3000.0, "method": "slices"}
    assert B.solve_many(row(), **given).converged.all()
    monkeypatch.setattr(equilibrium, "STEPS", 2)
    assert not B.solve_many(row(), **given).converged.any()

"""Ribs: where rollers' ends touch them, how, and what they bear."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import nonhertz as nh

B = nh.bearing
PLAIN = {"side_faces": "none", "depth": "none"}


def row(design="NJ", **given):
    roller = nh.Roller(diameter=9.0, length=10.0, corner_radius=0.4, profile=nh.profile.crown(1200.0), **PLAIN)
    rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    return B.CylindricalRollerBearing(roller=roller, **rings, rollers=13, design=design, **given)


def tapered(**given):
    cone = nh.Roller(diameter=nh.TabulatedDiameter((-6, 6), (11, 10)), length=12.0)
    rings = {"inner": nh.Ring(diameter=41), "outer": nh.Ring(diameter=-62.5)}
    return B.TaperedRollerBearing(roller=cone, **rings, rollers=14, contact_angle=0.2, **given)


def separation(contact, rib, pitch, inclined, half, side, inner, around, up):
    """Distance between flank and sphere, from the cone about the bearing's axis itself.

    At ``around`` [mm] along its circle and ``up`` [mm] along its generator from the place of the contact.
    """
    n_x, n_r, _ = contact.motion[0]
    centre = -side * (rib.end_radius - half)
    x_c, r_c = centre * np.cos(inclined), 0.5 * pitch - centre * np.sin(inclined)
    x, r = x_c - rib.end_radius * n_x, r_c - rib.end_radius * n_r
    # The generator is square to the normal; the circle is walked in space.
    x, r = x - up * n_r, r + up * n_x
    turn = around / r
    place = np.array([x, r * np.cos(turn), r * np.sin(turn)])
    return rib.end_radius - np.linalg.norm(place - np.array([x_c, r_c, 0.0]))


@pytest.mark.parametrize("crown", [None, 300.0])
@pytest.mark.parametrize("kind", ["inner", "outer", "tapered"])
def test_curvatures_are_those_of_a_sphere_on_a_cone(kind, crown):
    rib = B.Rib(60.0 if kind == "outer" else 80.0, 3.3, crown)
    bearing = tapered(rib=rib) if kind == "tapered" else row("NUP", rib=rib)
    inclined = 0.5 * sum(bearing.contact_angles) if kind == "tapered" else 0.0
    contact = bearing.rib_contacts[2 if kind == "outer" else 0]
    half = 0.5 * bearing.roller_length
    at = (rib, bearing.pitch, inclined, half, -1, kind != "outer")

    def apart(around, up):
        return -separation(contact, *at, around, up)

    assert apart(0.0, 0.0) == pytest.approx(0.0, abs=1e-12)
    step = 0.02
    around = (apart(step, 0.0) + apart(-step, 0.0)) / step**2
    along = (apart(0.0, step) + apart(0.0, -step)) / step**2 + (0.0 if crown is None else 1.0 / crown)
    assert 1.0 / contact.radius_around == pytest.approx(around, rel=1e-5)
    assert 1.0 / contact.radius_along == pytest.approx(along, rel=1e-5)


def test_a_sphere_on_a_flat_flank_is_that_of_hertz():
    contact = row("NJ", rib=B.Rib(100.0, 0.0)).rib_contacts[0]
    modulus = 1.0 / (np.pi * contact.compliance)
    assert contact.law.stiffness == pytest.approx(4.0 / 3.0 * modulus * 10.0, rel=1e-9)


def test_the_axial_load_goes_through_every_roller():
    found = B.solve(row(), radial=4e3, axial=900.0)
    contacts = found.bearing.rib_contacts
    assert [each.ring for each in contacts] == ["inner", "outer", "outer"]
    along = np.array([each.motion[0, 0] for each in contacts])
    assert_allclose(found.each_rib_load @ along, 0.0, atol=1e-6)
    assert np.sum(found.each_rib_load[:, 0]) * along[0] == pytest.approx(900.0, rel=1e-9)
    # The outer rib at the rollers' low ends is not reached.
    assert_allclose(found.each_rib_load[:, 1], 0.0)
    assert_allclose(found.rib_load[:, 0], found.each_rib_load[:, 0])
    # Both ribs push rollers in one sense of rotation, which the raceways bear by a pressure that is off the middle.
    pair = found.each_rib_load @ np.array([each.motion[0, 2] for each in contacts])
    assert_allclose(found.moment[:, 0] - found.moment[:, 1] + pair, 0.0, atol=1e-5)
    assert np.all(np.abs(found.moment[:2]) > 100.0)


def test_two_ways_are_borne_alike():
    both = row("NUP", axial_clearance=0.1)
    up, down = (B.solve(both, radial=4e3, axial=axial, method="slices") for axial in (700.0, -700.0))
    assert_allclose(down.displacement, up.displacement * [-1, 1, 1, 1, 1], rtol=1e-7, atol=1e-9)
    assert_allclose(down.rib_load, up.rib_load, rtol=1e-7, atol=1e-4)
    of_inner = [rib.motion[0, 0] * (rib.ring == "inner") for rib in both.rib_contacts]
    # To what is left of the balance, over the loads.
    assert np.sum(up.each_rib_load @ of_inner) == pytest.approx(700.0, abs=1e-9 * up.load.sum())
    # Ring and rollers move through the clearance before ribs bear.
    stiff = B.solve(row("NUP"), radial=4e3, axial=700.0, method="slices")
    assert up.displacement[0] - stiff.displacement[0] == pytest.approx(0.05, rel=1e-6)


def test_the_ellipse_on_a_rib_is_that_of_hertz():
    found = B.solve(row(), radial=4e3, axial=900.0, method="slices")
    most = int(np.argmax(found.each_rib_load[:, 0]))
    ellipse = found.rib_contact(most)
    contact = found.bearing.rib_contacts[0]
    assert ellipse.load == found.rib_load[most, 0]
    area = np.pi * ellipse.half_width * ellipse.half_length
    assert ellipse.max_pressure == pytest.approx(1.5 * ellipse.load / area, rel=1e-9)
    assert ellipse.approach == pytest.approx((ellipse.load / contact.law.stiffness) ** (2.0 / 3.0), rel=1e-9)
    assert B.solve(row(axial_clearance=0.05), radial=4e3, axial=0.0, method="slices").rib_contact(0, "outer") is None


def test_a_contact_beyond_the_flank_is_said():
    near = row(rib=B.Rib(400.0, 3.3, edge=3.2))
    with pytest.warns(nh.AccuracyWarning) as raised:
        found = B.solve(near, radial=4e3, axial=900.0, method="slices")
    assert tuple(str(each.message) for each in raised) == found.warnings
    for said, ring in zip(found.warnings, ("inner", "outer"), strict=True):
        assert f"roller 1 with a rib of the {ring} ring reaches 0." in said
    assert B.solve(row(), radial=4e3, axial=10.0, method="slices").warnings == ()


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (lambda: row(rib=B.Rib(100.0, 4.2)), "rib.height = 4.2 must be less than the radius of the rollers' ends, 4.1"),
        (lambda: row(rib=B.Rib(40.0, 3.9)), None),
        (lambda: row("NJ", rib=B.Rib(9e5, 4.0)), None),
        (lambda: row(axial_clearance=-0.1), "axial_clearance = -0.1 must"),
        (lambda: B.Rib(100.0, 3.0, edge=3.5), "edge = 3.5 must be less than the height of the contact, 3 mm"),
        (lambda: B.Rib.of_flank(end_radius=100.0, angle=2.0), "angle = 2.0 must be less than a right angle"),
        (
            lambda: B.solve(row(), radial=1e3, axial=-5.0),
            "axial = -5.0 must act along \\+x, the only direction in which",
        ),
        (lambda: B.solve(row("N"), radial=1e3, axial=5.0), "axial = 5.0 must be zero for a bearing whose inner ring"),
    ],
)
def test_ribs_that_cannot_be_are_refused(made, said):
    if said is None:
        made()
        return
    with pytest.raises(nh.InputError, match=said):
        made()


def test_turned_round_a_rib_bears_the_other_way():
    # Without clearance, rollers that are pressed outwards touch the conical flanks of both ribs.
    loose = row(axial_clearance=0.02)
    pair = B.Paired(bearings=(loose, loose), x=(-8.0, 8.0), turned=(False, True))
    found = B.solve(pair, radial=6e3, axial=-500.0, method="slices")
    assert_allclose(found.rib_load[found.rollers_of(0)], 0.0)
    assert np.sum(found.rib_load[found.rollers_of(1), 0]) > 499.0


@pytest.mark.parametrize("arrangement", ["X", "O"])
@pytest.mark.parametrize("design", ["NJ", "NF"])
def test_the_clearance_of_a_pair_lies_between_ribs(arrangement, design):
    """From the middle the inner ring moves by half of it before the ribs of one row press: all else is the same."""
    moved = [
        B.solve(
            B.paired(row(design), arrangement, 30.0, clearance=clearance), radial=5e3, axial=1e3, method="slices"
        ).displacement[0]
        for clearance in (0.0, 0.2, 1.0)
    ]
    assert_allclose(np.diff(moved), [0.1, 0.4], atol=1e-6)


def test_a_pair_that_is_free_along_the_axis_has_no_clearance():
    with pytest.raises(
        nh.InputError, match=r"pair\.clearance = 0\.2 must be zero for rows that do not locate the inner ring"
    ):
        B.paired(row("NU"), "X", 30.0, clearance=0.2)

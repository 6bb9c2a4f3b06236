"""Stress below solved contacts: the verbs, their values and their complaints."""

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.subsurface import Field, axial_plane, cross_section, extremes, memory, passage, stress, volume
from nonhertz.subsurface.evaluation import PORTION

RING = nh.Ring(diameter=80)


@pytest.fixture(scope="module")
def tilted():
    profile = nh.profile.iso_logarithmic(diameter=20, length=20)
    roller = nh.Roller(diameter=20, length=20, profile=profile, side_faces="mirror")
    ring = nh.Ring(diameter=80, length=24, depth=10, side_faces="mirror")
    return nh.solve(nh.Contact(roller, ring), load=20e3, tilt=5e-4, accuracy=1e-5)


@pytest.fixture(scope="module")
def plane_strain():
    """Return equal rollers whose ends coincide, mirrored for ever: Hertz's line contact from end to end."""
    roller = nh.Roller(diameter=20, length=10, side_faces="mirror", images="series")
    return nh.solve(nh.Contact(roller, roller), load=10e3, strips=11)


@pytest.fixture(scope="module")
def patched():
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000), side_faces="mirror")
    return nh.patch.solve(nh.Contact(roller, nh.Plate()), load=4e3, cells=(32, 64))


# A field


def test_what_follows_from_the_six_components():
    stress_ = np.array([[-3.0, -5.0, -9.0, 0.5, 2.0, -1.0], [100.0, 0.0, 0.0, 0.0, 0.0, 0.0]])
    field = Field("a", *np.zeros((3, 2)), stress_)
    tensor = np.array([[-3.0, -1.0, 2.0], [-1.0, -5.0, 0.5], [2.0, 0.5, -9.0]])
    np.testing.assert_array_equal(field.tensor[0], tensor)
    np.testing.assert_allclose(field.principal[0], np.sort(np.linalg.eigvals(tensor))[::-1], rtol=1e-12)
    deviator = tensor - np.trace(tensor) / 3.0 * np.eye(3)
    np.testing.assert_allclose(field.von_mises, [np.sqrt(1.5 * np.sum(deviator**2)), 100.0], rtol=1e-12)
    np.testing.assert_allclose(field.max_shear[1], 50.0, rtol=1e-12)
    assert (field.tau_xz[0], field.tau_yz[0], field.tau_xy[0]) == (2.0, 0.5, -1.0)
    assert (field.sigma_x[0], field.sigma_y[0], field.sigma_z[0]) == (-3.0, -5.0, -9.0)


# Where there is no material


@pytest.fixture(scope="module")
def thin():
    """Return a roller with a wall of 2 mm on a ring as thick."""
    roller = nh.Roller(diameter=20, length=20, bore=16, profile=nh.profile.crown(radius=2000))
    return nh.solve(nh.Contact(roller, nh.Ring(diameter=80, depth=2)), load=4e3, strips=21)


def test_points_without_material_are_refused_or_nan(thin):
    # Wall, bore, wall opposite, beyond the diameter; beside the bore, beside the roller, and below its far side.
    x, z = np.array([0.0, 0.0, 0.0, 0.0, 8.5, 10.5, 8.0]), np.array([1.9, 2.1, 19.0, 20.1, 10.0, 10.0, 17.0])
    field = stress(thin, x, 1.0, z)
    held = np.array([True, False, True, False, True, False, False])
    np.testing.assert_array_equal(np.isfinite(field.stress).all(axis=1), held)
    np.testing.assert_array_equal(np.isfinite(field.principal).all(axis=1), held)
    assert field.warnings == (
        "4 of 7 points lie outside the material of body a, in its bore or beyond its surface: they are NaN.",
    )
    assert np.isnan(passage(thin, 1.0, [1.0, 3.0]).von_mises).tolist() == [False, True]
    for body, words in (("a", "whose wall is 2 mm thick"), ("b", "which is 2 mm thick")):
        with pytest.raises(nh.InputError, match=f"z = 3.0 must lie in the material of body {body}, {words} at y = 1"):
            stress(thin, 0.0, 1.0, 3.0, body=body)
    displaced = stress(thin, 0.0, 1.0, [1.9, 2.1], body="b", displacement=True).displacement
    assert np.isfinite(displaced).all(axis=1).tolist() == [True, False]


# The verbs


def test_planes_and_volumes_are_points_in_rows_and_columns(tilted):
    y, z, x = np.array([-3.0, 2.0]), np.array([0.1, 0.2, 0.4]), np.array([-0.1, 0.0])
    plane = axial_plane(tilted, y, z, x=0.1)
    section = cross_section(tilted, 2.0, x, z)
    block = volume(tilted, x, y, z)
    assert (plane.shape, section.shape, block.shape) == ((2, 3), (2, 3), (2, 2, 3))
    np.testing.assert_array_equal(plane.stress[1, 2], stress(tilted, 0.1, 2.0, 0.4).stress)
    np.testing.assert_array_equal(block.stress[:, 1], section.stress)


@pytest.mark.slow
def test_threads_and_portions_change_no_digit(tilted):
    points = np.random.default_rng(3).uniform(-1.0, 1.0, (3, 2 * PORTION + 5)) * [[0.5], [9.0], [1.0]]
    points[2] = np.abs(points[2])
    done: list[tuple[int, int]] = []
    alone = stress(tilted, *points, threads=1, displacement=True, callback=lambda *counts: done.append(counts))
    together = stress(tilted, *points, threads=3, displacement=True)
    np.testing.assert_array_equal(alone.stress, together.stress)
    np.testing.assert_array_equal(alone.displacement, together.displacement)
    assert done[-1] == (points.shape[1], points.shape[1])
    last = stress(tilted, *points[:, -1])
    np.testing.assert_array_equal(alone.stress[-1], last.stress)


def test_memory_is_what_the_result_takes(tilted):
    points = 2000
    field = stress(tilted, 0.1, np.linspace(-9.0, 9.0, 40)[:, None], np.linspace(0.1, 1.0, 50), threads=1)
    assert field.stress.nbytes <= memory(points) <= field.stress.nbytes + 11 * 2**20
    assert memory(points, displacement=True) - memory(points) == 24 * points


def test_images_free_the_side_face_of_shear(tilted):
    on_face = stress(tilted, [0.1, 0.2], 10.0, [0.05, 0.3])
    near = stress(tilted, [0.1, 0.2], 9.0, [0.05, 0.3])
    largest = np.abs(near.stress).max()
    assert np.abs(near.tau_yz).max() > 1e-3 * largest
    # One image of the other face is not mirrored about this one; it is 30 mm away.
    assert np.abs([on_face.tau_yz, on_face.tau_xy]).max() < 1e-4 * largest


ALONG = np.linspace(-10.0, 10.0, 41)
DIAMETERS = {
    "taper": nh.TabulatedDiameter((-10.0, 10.0), (19.0, 21.0)),
    "barrel": nh.TabulatedDiameter(tuple(ALONG), tuple(20.0 - 0.01 * ALONG**2)),
}


def profiled(diameter=20.0, **more):
    profile = nh.profile.iso_logarithmic(diameter=20, length=20)
    return nh.Roller(diameter=diameter, length=20, profile=profile, **more)


STRAIN = {"depth": "plane-strain"}
SURFACES = {
    "whole": (profiled(), nh.Ring(diameter=80, length=21, depth=10)),
    "taper": (nh.Ring(diameter=-200, length=24, depth=15), profiled(DIAMETERS["taper"])),
    "barrel": (profiled(DIAMETERS["barrel"]), nh.Plate()),
    "calibrated": (profiled(side_faces="calibrated", **STRAIN), nh.Plate(length=22, side_faces="calibrated", depth=20)),
    "weight": (profiled(side_faces=1.2, images=3, depth="diameter"), nh.Plate(length=20, side_faces=(1.5, "free"))),
    "series": (profiled(side_faces=(1.2, "calibrated"), images="series", depth=12), nh.Plate()),
    "one face": (profiled(side_faces=("none", "calibrated"), depth="none"), nh.Plate(length=20, side_faces="mirror")),
    "cylinder": (profiled(side_faces="mirror", depth="cylinder"), nh.Ring(diameter=60, length=20)),
    # Together they weigh more than 1, and are limited.
    "limited": (profiled(side_faces=1.8, **STRAIN), nh.Roller(diameter=15, length=20, side_faces="calibrated")),
}
QUICK = ("taper", "calibrated", "limited")


@pytest.mark.filterwarnings("ignore:The images about the side face:nonhertz.AccuracyWarning")
@pytest.mark.parametrize(
    "case", [each if each in QUICK else pytest.param(each, marks=pytest.mark.slow) for each in SURFACES]
)
def test_both_surfaces_together_move_by_the_interference_that_was_solved(case):
    contact = nh.Contact(*SURFACES[case])
    solution = nh.solve(contact, load=20e3, tilt=2e-4)
    y = solution.y[solution.line_load > 0.0]
    moved = sum(stress(solution, 0.0, y, 0.0, body=body, displacement=True).displacement[:, 2] for body in "ab")
    interference = solution.approach + solution.tilt * y - contact.separation(y)
    off = np.abs(moved - interference) / interference.max()
    # Strips in pieces move the surface by what the solver's own strips do, but for their steps.
    assert off[np.abs(y) < 9.0].max() < 1e-3
    assert off.max() < 1.5e-3


@pytest.mark.parametrize("diameter", [20.0, *DIAMETERS.values()])
def test_surfaces_of_equal_bodies_each_move_by_half_of_the_interference(diameter):
    contact = nh.Contact(nh.Roller(diameter=diameter, length=20), nh.Roller(diameter=diameter, length=20))
    solution = nh.solve(contact, load=20e3)
    y = np.linspace(-9.5, 9.5, 9)  # not the centres of strips
    for body in "ab":
        moved = stress(solution, 0.0, y, 0.0, body=body, displacement=True).displacement[:, 2]
        np.testing.assert_allclose(moved, 0.5 * (solution.approach + solution.tilt * y), rtol=1e-3)


@pytest.mark.filterwarnings("ignore:The estimated error:nonhertz.AccuracyWarning")
@pytest.mark.parametrize("faces", ["mirror", "calibrated", pytest.param("free", marks=pytest.mark.slow)])
def test_the_plane_grid_is_displaced_as_its_solution_says(patched, faces):
    if faces == "free":
        roller, ring = nh.Roller(diameter=20, length=8), nh.Ring(diameter=80, length=8, depth=10)
        dent = nh.patch.Dent(x=0.2, y=3.5, depth=5e-4, diameter=2.0)
        patched = nh.patch.solve(nh.Contact(roller, ring), load=4e3, cells=(32, 64), features=[dent])
    elif faces == "calibrated":
        roller, plate = nh.Roller(diameter=20, length=8, side_faces=faces), nh.Plate(length=9, side_faces=1.2)
        patched = nh.patch.solve(nh.Contact(roller, plate), load=4e3, cells=(32, 64))
    contact = patched.contact
    column = int(np.abs(patched.x).argmin()) + 3
    moved = sum(
        stress(patched, patched.x[column], patched.y, 0.0, body=body, displacement=True).displacement[:, 2]
        for body in "ab"
    )
    gap = patched.x[column] ** 2 * contact.curvature(patched.y) / 2.0 + contact.separation(patched.y)
    if faces == "free":
        gap += dent(patched.x[column], patched.y)
    wanted = patched.gap[column] + patched.approach - gap
    # Next to a free face the grid averages a logarithm over its cells.
    inner = np.abs(patched.y) < (2.6 if faces == "free" else np.inf)
    np.testing.assert_allclose(moved[inner], wanted[inner], rtol=3e-5 if faces == "free" else 1e-5, atol=0.0)
    np.testing.assert_allclose(moved[1:-1], wanted[1:-1], rtol=5e-4, atol=0.0)
    np.testing.assert_allclose(moved, wanted, rtol=1.6e-3, atol=0.0)


def test_a_body_of_another_poisson_ratio_has_another_field():
    soft = nh.Ring(diameter=80, material=nh.Material(207000.0, 0.1))
    solution = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20), soft), load=5e3, strips=21)
    of_a, of_b = (stress(solution, 0.1, 0.0, 0.1, body=body) for body in "ab")
    assert float(of_a.sigma_z) == pytest.approx(float(of_b.sigma_z), rel=1e-2)
    assert float(of_b.sigma_y) > 0.5 * float(of_a.sigma_y)


# Over a pass, and the largest


def test_over_a_pass_the_amplitudes_of_a_line_contact(plane_strain):
    b, p0 = plane_strain.half_width[0], plane_strain.max_pressure
    seen = passage(plane_strain, 1.0, np.array([0.5, 0.786151, 0.704292]) * b, body="a")
    # McEwen's field; see hertz.LineContact.stress.
    assert seen.orthogonal_shear[0] == pytest.approx(0.25 * p0, rel=1e-6)
    assert seen.orthogonal_shear_x[0] == pytest.approx(0.866025 * b, rel=1e-3)
    assert seen.shear[1] == pytest.approx(0.300283 * p0, rel=1e-5)
    assert seen.von_mises[2] == pytest.approx(0.557516 * p0, rel=1e-5)
    assert seen.von_mises_x[2] == pytest.approx(0.0, abs=1e-6)
    np.testing.assert_array_equal(seen.orthogonal_shear_range, 2.0 * seen.orthogonal_shear)


def test_over_a_pass_close_to_the_surface_the_narrow_peak_is_found(plane_strain):
    z = 0.03 * plane_strain.half_width[0]
    seen = passage(plane_strain, 0.0, z)
    x = np.linspace(0.0, 2.0, 20001) * plane_strain.half_width[0]
    shear = np.abs(stress(plane_strain, x, 0.0, z).tau_xz)
    assert float(seen.orthogonal_shear) == pytest.approx(shear.max(), rel=2e-4)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:The estimated error of the maximum pressure")
def test_over_a_pass_of_a_dent_the_range_is_from_one_side_to_the_other():
    roller = nh.Roller(diameter=20, length=4, profile=nh.profile.crown(radius=500))
    dent = nh.patch.Dent(x=0.1, y=0.0, depth=0.002, diameter=0.6)
    dented = nh.patch.solve(nh.Contact(roller, nh.Plate()), load=800.0, cells=(48, 48), features=[dent])
    seen = passage(dented, 0.0, 0.08)
    x = np.linspace(-0.6, 0.6, 1201)
    shear = stress(dented, x, 0.0, 0.08).tau_xz
    assert float(seen.orthogonal_shear_range) == pytest.approx(np.ptp(shear), rel=2e-3)
    assert float(seen.orthogonal_shear) == pytest.approx(np.abs(shear).max(), rel=2e-3)
    assert float(seen.orthogonal_shear_range) < 1.99 * float(seen.orthogonal_shear)


@pytest.mark.slow
def test_the_largest_of_the_body_is_no_less_than_of_any_section_and_found_on_a_fine_net_too(tilted):
    overall, section = extremes(tilted), extremes(tilted, station=4.5)
    for name in ("von_mises", "shear", "orthogonal_shear"):
        whole, part = getattr(overall, name), getattr(section, name)
        assert whole.max >= part.max * (1.0 - 1e-6)
        assert (part.y, part.z > 0.0, whole.x >= 0.0) == (4.5, True, True)
        there = stress(tilted, whole.x, whole.y, whole.z)
        again = {"von_mises": there.von_mises, "shear": there.max_shear, "orthogonal_shear": abs(there.tau_xz)}[name]
        assert whole.max == pytest.approx(float(again), rel=1e-9)
    assert overall.warnings == ()
    block = volume(tilted, np.linspace(0.0, 0.4, 9), np.linspace(3.0, 6.0, 13), np.linspace(0.1, 0.4, 31))
    assert overall.von_mises.max * (1.0 - 2e-3) <= block.von_mises.max() <= overall.von_mises.max * (1.0 + 1e-6)


@pytest.fixture(scope="module")
def chamfered():
    contact = nh.Contact(
        nh.Roller(diameter=20, length=20, profile=nh.profile.chamfer(20, 1.0), side_faces="mirror"), RING
    )
    return nh.solve(contact, load=20e3)


def test_below_a_corner_the_field_is_that_of_the_strips_on_finer_grids_too(chamfered):
    last = np.flatnonzero(chamfered.line_load)[-1]
    y, b = chamfered.y[last], chamfered.half_width[last]
    halved = np.unique(np.concatenate([chamfered.edges, 0.5 * (chamfered.edges[1:] + chamfered.edges[:-1])]))
    finer = nh.solve(chamfered.contact, load=20e3, strips=halved)
    depths = np.array([0.2, 0.5, 1.0]) * b
    found = stress(chamfered, 0.0, y, depths).von_mises
    # Point loads summed elsewhere, and a plane grid.
    assert found == pytest.approx([3379.0, 2268.0, 1508.0], rel=0.01)
    assert found == pytest.approx(stress(finer, 0.0, y, depths).von_mises, rel=5e-3)


@pytest.mark.slow
def test_towards_a_corner_where_the_contact_ends_nothing_is_searched_and_that_is_said(chamfered):
    found = extremes(chamfered)
    assert abs(found.von_mises.y) < 9.0 - 0.9 * chamfered.half_width.max()
    assert found.warnings == (
        "The stress grows without limit towards the corners of the profile at y = -9 and 9 mm: the region "
        "within a half-width of them was not searched.",
    )


ENDS = {
    "chamfers of 5 degrees": (nh.profile.chamfer(20, 1.5, np.radians(5)), 10e3, [-8.5, 8.5]),
    "chamfers of 45 degrees, light": (nh.profile.chamfer(20, 0.3), 100.0, [-9.7, 9.7]),
    "a crown that runs out before its chamfer": (nh.profile.crown(radius=2000) + nh.profile.chamfer(20, 1.0), 3e3, []),
    "a bend that turns far too little": (nh.profile.tapered_ends(straight=14, angle=1e-4), 10e3, [-10.0, 10.0]),
    "both sides of a groove": (
        nh.profile.tabulated([-10, -2.1, -2, 2, 2.1, 10], [0, 0, 0.1, 0.1, 0, 0], interpolation="linear"),
        10e3,
        [-10.0, -2.1, 2.1, 10.0],
    ),
}


@pytest.mark.parametrize("name", ENDS)
def test_a_contact_ends_at_corners_that_it_presses_against(name):
    profile, load, expected = ENDS[name]
    solution = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile), RING), load=load)
    assert [end.y for end in solution.singular_ends] == pytest.approx(expected)


def test_a_run_out_that_ends_next_to_a_bend_stays_one():
    crowned = nh.profile.crown(radius=2000)
    free = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20, profile=crowned), RING), load=3e3)
    # The chamfer begins right where the contact ends anyway.
    width = 10.0 - free.contact_y[0][1] - 1e-3
    both = nh.Roller(diameter=20, length=20, profile=crowned + nh.profile.chamfer(20, width))
    assert nh.solve(nh.Contact(both, RING), load=3e3).singular_ends == ()


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")
def test_the_largest_is_found_up_to_where_a_contact_runs_out():
    tapered = nh.Roller(diameter=20, length=20, profile=nh.profile.tapered_ends(straight=10, angle=0.004))
    solution = nh.solve(nh.Contact(tapered, RING), load=2e3, tilt=4e-4, strips=21)
    end = solution.contact_y[-1][1]
    block = volume(
        solution, np.linspace(0.0, 0.1, 5), np.linspace(end - 1.0, end - 1e-3, 41), np.linspace(0.0, 0.3, 31)
    )
    assert extremes(solution).von_mises.max >= block.von_mises.max() * (1.0 - 2e-3)


@pytest.mark.slow
def test_towards_a_sharp_end_nothing_is_searched_and_that_is_said():
    contact = nh.Contact(nh.Roller(diameter=20, length=20), RING)
    # On the surface next to what is left out, the strips' semi-ellipse is not quite the pressure of the cells.
    below = (0.05, np.inf)
    found = extremes(nh.patch.solve(contact, load=10e3, cells=(24, 128)), depths=below)
    solution = nh.solve(contact, load=10e3)
    of_strips = extremes(solution, depths=below)
    for each in (found, of_strips):
        assert abs(each.von_mises.y) < 10.0 - 0.9 * solution.half_width[0]
        assert "without limit towards the sharp ends at y = -10 and 10 mm" in each.warnings[0]
    assert found.von_mises.max == pytest.approx(of_strips.von_mises.max, rel=0.03)


def test_a_depth_of_minus_nothing_is_the_surface(tilted):
    for depth in (0.0, -0.0):
        assert float(stress(tilted, 0.0, 1.0, depth).sigma_z) < -1000.0


def test_parabolic_strips_have_the_field_of_the_contact_that_they_stand_for():
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=3000)), RING)
    found = [
        extremes(nh.solve(contact, load=6e3, element=element, strips=31), 0.0)
        for element in (nh.SEMI_ELLIPTIC, nh.PARABOLIC)
    ]
    for name in ("von_mises", "shear", "orthogonal_shear"):
        # The parabola's own bias of half a per cent in pressure stays.
        one, other = (getattr(each, name).max for each in found)
        assert other == pytest.approx(one, rel=0.01)


# Complaints


@pytest.mark.slow
@pytest.mark.parametrize("depths", [(1.2, np.inf), (0.0, 0.4), (0.4, 1.0)])
def test_the_largest_stresses_within_depths(plane_strain, depths):
    half_width, pressure = plane_strain.max_half_width, plane_strain.max_pressure
    low, high = depths[0] * half_width, depths[1] * half_width
    found = extremes(plane_strain, depths=(low, high))
    # The exact field of Hertz's line contact, on a grid whose steps cost less than 1e-5.
    line = nh.hertz.line_contact(line_load=1e3, radius=5.0, compliance=plane_strain.contact.compliance)
    assert line.max_pressure == pytest.approx(pressure, rel=1e-6)
    x, z = np.meshgrid(
        np.linspace(0.0, 2.0 * half_width, 801), np.linspace(low, min(high, low + 2.0 * half_width), 401)
    )
    exact = Field("a", x, 0.0 * x, z, line.stress(x, z, 0.3))
    assert found.von_mises.max == pytest.approx(exact.von_mises.max(), rel=1e-4)
    assert found.shear.max == pytest.approx(exact.max_shear.max(), rel=1e-4)
    assert found.orthogonal_shear.max == pytest.approx(np.abs(exact.tau_xz).max(), rel=1e-4)
    assert all(low <= each.z <= high for each in (found.von_mises, found.shear, found.orthogonal_shear))

"""The error that a solution estimates of itself bounds the error that it has, and is no idle bound.

The true error is taken against the same model on strips four times as narrow as the automatic ones, where the
contact ends in a hundred times less than an equal strip. Where a kink within the contact bears the greatest pressure
the approach still converges, and that pressure has no limit that an estimate could state; away from sharp ends and
corners at which a contact ends it has one.
"""

import functools
import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.files.starting import starting_case
from nonhertz.model.profile import Profile

# Few strips, of which a large estimate is said.
pytestmark = pytest.mark.filterwarnings("ignore:The .* is uncertain:nonhertz.AccuracyWarning")

# error <= FACTOR * estimate, over the whole catalogue and all grids.
FACTOR = 1.0
GRIDS = ("auto", 21, 41, 81)
BODIES = {"half-spaces": {"side_faces": "none", "depth": "none"}, "mirrored": {"side_faces": "mirror"}, "whole": {}}
profile = nh.profile


@dataclass(frozen=True)
class Wave(Profile):
    """A hump of ``height`` taken off in the middle of 20 mm: contact at both ends only."""

    height: float

    def relief(self, y):
        return 0.5 * self.height * (1.0 + np.cos(0.1 * np.pi * np.asarray(y, dtype=float)))


LOGARITHMIC = profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)
CATALOGUE = {
    "ellipse": (profile.crown(100), {"load": 1000}),
    "slender ellipse": (profile.crown(1000), {"load": 1000}),
    "very slender ellipse": (profile.crown(1e4), {"load": 1000}),
    "tilted ellipse": (profile.crown(4000), {"load": 3000, "tilt": -5e-4}),
    "ellipse by approach": (profile.crown(1000), {"approach": 0.01}),
    "crown over sharp ends": (profile.crown(4000), {"load": 20e3}),
    "logarithmic": (LOGARITHMIC, {"load": 40e3}),
    "logarithmic, tilted": (LOGARITHMIC, {"load": 40e3, "tilt": -1e-3}),
    "logarithmic, by moment": (LOGARITHMIC, {"load": 20e3, "moment": 30e3}),
    "ISO by approach": (profile.iso_logarithmic(20, 20), {"approach": 0.03}),
    "partial crown": (profile.partial_crown(500, 12), {"load": 20e3}),
    "partial crown with a kink": (profile.partial_crown(500, 12, blended=False), {"load": 20e3}),
    "tapered ends": (profile.tapered_ends(14, 1e-3), {"load": 20e3}),
    "tapered ends, tilted": (profile.tapered_ends(14, 1e-3), {"load": 10e3, "tilt": 4e-4}),
    "chamfer": (profile.chamfer(20, 0.5), {"load": 20e3}),
    "straight": (profile.straight(), {"load": 20e3}),
    "straight, half lifted": (profile.straight(), {"load": 5e3, "tilt": 1e-3}),
    "two intervals": (Wave(0.05), {"load": 5e3}),
    "two intervals by approach": (Wave(0.05), {"approach": 0.02}),
    "parabolic ellipse": (profile.crown(1000), {"load": 1000, "element": nh.PARABOLIC}),
    "parabolic logarithmic": (LOGARITHMIC, {"load": 40e3, "tilt": -1e-3, "element": nh.PARABOLIC}),
}
SINGULAR = (
    "crown over sharp ends",
    "partial crown",
    "chamfer",
    "straight",
    "straight, half lifted",
    "two intervals",
)
AT_A_CORNER = (
    ("partial crown with a kink", "half-spaces"),
    ("partial crown with a kink", "mirrored"),
    ("partial crown with a kink", "whole"),
    ("tapered ends", "mirrored"),
    ("tapered ends", "whole"),
    ("tapered ends, tilted", "mirrored"),
    ("tapered ends, tilted", "whole"),
)
QUANTITIES = ("approach", "load", "max_pressure")


both = pytest.mark.parametrize("bodies", ["half-spaces", pytest.param("mirrored", marks=pytest.mark.slow), "whole"])


@functools.cache
def solved(name, bodies, strips):
    shape, arguments = CATALOGUE[name]
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=shape, **BODIES[bodies]), nh.Plate())
    return nh.solve(contact, strips=_finer(name, bodies) if strips == "finer" else strips, **arguments)


def _finer(name, bodies):
    """Edges of the automatic strips and three more within each."""
    automatic = solved(name, bodies, "auto")
    half = 0.5 * automatic.strip_width
    edges = np.append(automatic.y - half, automatic.y[-1] + half[-1])
    fine = np.interp(np.arange(4 * automatic.strips + 1) / 4.0, np.arange(edges.size), edges)
    return np.clip(fine, -10.0, 10.0)


def error_and_estimate(name, bodies, strips, quantity):
    solution, finer = solved(name, bodies, strips), solved(name, bodies, "finer")
    # That of the approach is relative to what of it deforms the bodies.
    whole = finer.penetration if quantity == "approach" else getattr(finer, quantity)
    error = abs(getattr(solution, quantity) - getattr(finer, quantity)) / abs(whole)
    return error, getattr(solution.error_estimate, quantity)


@both
@pytest.mark.parametrize("name", CATALOGUE)
def test_the_estimate_is_an_upper_bound_and_more_strips_make_it_smaller(name, bodies):
    for quantity in QUANTITIES:
        if quantity == "max_pressure" and (name, bodies) in AT_A_CORNER:
            continue  # there is no maximum to be off from
        for strips in GRIDS:
            error, estimate = error_and_estimate(name, bodies, strips, quantity)
            # What is prescribed is met to rounding and the loop's tolerance, which no estimate needs to cover.
            assert error <= FACTOR * estimate + 1e-9, (quantity, strips)
    by_approach = "approach" in CATALOGUE[name][1]
    few, many = (solved(name, bodies, strips).error_estimate for strips in (21, "finer"))
    assert 0.0 < (many.load if by_approach else many.approach) < (few.load if by_approach else few.approach)
    if by_approach:  # what is prescribed has no error
        assert solved(name, bodies, "auto").error_estimate.approach == 0.0


# Equal strips find a smooth greatest pressure far better than half as many of them would suggest: there the
# estimate is wider.
@both
def test_the_estimate_is_not_an_idle_bound(bodies):
    for quantity, most in {"approach": 20.0, "load": 30.0, "max_pressure": 60.0}.items():
        pairs = [error_and_estimate(name, bodies, strips, quantity) for name in CATALOGUE for strips in GRIDS]
        ratios = [estimate / error for error, estimate in pairs if error > 1e-9 and math.isfinite(estimate)]
        assert len(ratios) >= 8
        # An error may cross zero, so single ratios say nothing.
        # Weaker singularities of free ends leave smaller errors under the same estimates.
        assert np.median(ratios) < most * (1.2 if bodies == "whole" else 1.0), quantity


@both
@pytest.mark.parametrize("name", SINGULAR)
def test_away_from_singular_ends_the_maximum_is_known(name, bodies):
    error, estimate = error_and_estimate(name, bodies, "auto", "max_pressure")
    assert solved(name, bodies, "auto").singular_ends
    assert error < 2e-3
    assert estimate < 0.02


@pytest.mark.parametrize(("name", "bodies"), AT_A_CORNER)
def test_a_maximum_at_a_corner_within_has_no_finite_estimate(name, bodies):
    solution = solved(name, bodies, "auto")
    assert solution.peaks_at_corner
    assert solution.error_estimate.max_pressure == math.inf


def test_the_estimate_of_an_ellipse_bounds_the_error_against_hertz():
    # Against the closed form, not against finer strips.
    compliance = 2.0 * nh.Material(modulus=207000, poisson=0.3).compliance
    exact = nh.hertz.point_contact(radius_x=10, radius_y=100, load=1000, compliance=compliance)
    for strips in GRIDS:
        solution = solved("ellipse", "half-spaces", strips)
        # The crown is a circle, not a parabola: 3e-5 of the relief at the contact's end, less of the approach.
        assert abs(solution.approach / exact.approach - 1.0) <= solution.error_estimate.approach + 1e-5
        error, stated = abs(solution.max_pressure / exact.max_pressure - 1.0), solution.error_estimate.max_pressure
        assert error <= stated + 1e-5
        assert strips != "auto" or stated < 10.0 * error


@pytest.mark.slow
def test_a_maximum_in_a_smooth_stretch_is_not_as_uncertain_as_a_corner_elsewhere():
    # The roughest strips on the corners of a hollow roller made 5 % of 3e-5; 1500 strips give 2145.35 MPa.
    bored = nh.Case.of(tomllib.loads(starting_case("cylindrical")), Path(), changes={"body.a.bore": 6.0})
    found = bored.solve()
    assert abs(found.max_pressure_y) < 2.0
    assert abs(found.max_pressure / 2145.35 - 1.0) <= found.error_estimate.max_pressure < 1e-3


def cornered(radius):
    shape = {"corner_radius": 0.3, "profile": profile.crown(radius), "side_faces": "none", "depth": "none"}
    return nh.Contact(nh.Roller(diameter=9, length=10, **shape), nh.Ring(diameter=-55.5))


# On a rounded corner, whose peak takes narrower strips than the approach does, and in the middle.
@pytest.mark.parametrize(("radius", "accuracy"), [(1200, 1e-3), (400, 1.5e-4)])
def test_the_accuracy_asked_of_the_largest_pressure_is_met(radius, accuracy):
    contact, given = cornered(radius), {"load": 4000, "tilt": 1.5e-4}
    aim = {"accuracy": accuracy, "accuracy_of": "pressure"}
    usual, found = nh.solve(contact, **given), nh.solve(contact, **given, **aim)
    assert usual.error_estimate.max_pressure > accuracy >= found.error_estimate.max_pressure
    assert not found.findings
    edges = np.interp(np.arange(2 * found.strips + 1) / 2.0, np.arange(found.strips + 1), found.edges)
    true = nh.solve(contact, **given, strips=edges)
    assert abs(found.max_pressure / true.max_pressure - 1.0) <= found.error_estimate.max_pressure
    assert nh.solve_many(contact, load=[4000], tilt=1.5e-4, **aim).max_pressure[0] == found.max_pressure


def test_an_accuracy_of_the_largest_pressure_that_no_strips_have_on_a_corner_is_warned_of():
    with pytest.warns(nh.AccuracyWarning, match=r"accuracy of 0\.0003 is not met: the error of the maximum pressure"):
        nh.solve(cornered(1200), load=4000, tilt=1.5e-4, accuracy=3e-4, accuracy_of="pressure")


# Rounded corners whose peak is narrower than strips of the coarsest accuracy: 12 and 8 % too low, estimated at 8 and
# 3 %; and one so fine that the usual accuracy missed it: 27 % too low with an estimate of 1.5 %.
@pytest.mark.parametrize(
    ("roller", "other", "given", "accuracy"),
    [
        (
            {"diameter": 26.2096, "length": 65.5239, "profile": profile.partial_crown(782.24, 46.7189)}
            | {"corner_radius": 2.54884, "side_faces": "none", "depth": "none"},
            -66.8428,
            {"load": 131843.0},
            1e-3,
        ),
        (
            {"diameter": 6.11597, "length": 6.11597, "profile": profile.partial_crown(146.293, 4.13992)}
            | {"corner_radius": 0.152416, "depth": "none"},
            None,
            {"approach": 0.0050776, "tilt": 0.00016807},
            1e-3,
        ),
        (
            {"diameter": 7.34379, "length": 5.14065, "profile": profile.partial_crown(181.284, 2.24224)}
            | {"corner_radius": 0.00474183, "depth": "none"},
            43.8592,
            {"load": 1816.05},
            1e-4,
        ),
    ],
)
@pytest.mark.slow
def test_a_peak_narrower_than_its_strips_is_in_the_estimate(roller, other, given, accuracy):
    contact = nh.Contact(nh.Roller(**roller), nh.Body(diameter=other))
    true, found = (nh.solve(contact, **given, accuracy=each) for each in (3e-6, accuracy))
    assert abs(found.max_pressure / true.max_pressure - 1.0) <= found.error_estimate.max_pressure


@pytest.mark.parametrize("strips", [21, 41, 81])
@pytest.mark.parametrize("ends", [{"side_faces": "none", "depth": "none"}, {"side_faces": "mirror"}, {}])
def test_strips_wider_than_the_half_width_say_what_a_sharp_end_hides(ends, strips):
    contact = nh.Contact(nh.Roller(diameter=32.0, length=80.0, **ends), nh.Plate())
    true, found = (nh.solve(contact, load=13e3, strips=each) for each in ("auto", strips))
    assert abs(found.max_pressure / true.max_pressure - 1.0) <= found.error_estimate.max_pressure


@pytest.mark.parametrize("radius", [4000.0, 4500.0])
def test_of_few_strips_the_last_counts_where_the_overlap_falls_by_a_tenth_over_a_half_width(radius):
    # One that runs out shortly before the end looks like one that reaches it; with 0.11 and 0.098 here.
    body = nh.Roller(diameter=400.0, length=20.0, profile=profile.crown(radius), side_faces="none", depth="none")
    found = nh.solve(nh.Contact(body, nh.Plate()), approach=0.054, strips=9)
    at_end, inside = 0.054 - body.relief([10.0, 10.0 - found.half_width[-1]])
    excess = found.centre_pressure[-1] / found.max_pressure - 1.0
    assert excess > 0.1
    # The last strip's mean is lower than the peak within it: four times its excess.
    assert (found.error_estimate.max_pressure > 4.0 * excess) == (at_end < 0.9 * inside) == (radius == 4000.0)

"""Laws that hold for every solution: similarity, symmetry, contact conditions, balance, consistency.

Half of the drawn bodies are half-spaces, half are finite: faces free, mirrored or neither, on one side or both, thick
or not.
"""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import nonhertz as nh
from nonhertz.bodies.depths import plane_strain_depth
from nonhertz.model.profile import Profile

# Faces that come to lie together may ask for more weight than has a solution; the laws hold with what is used.
pytestmark = pytest.mark.filterwarnings(
    "ignore:The images about:nonhertz.AccuracyWarning",
    "ignore:The .* is uncertain:nonhertz.AccuracyWarning",  # on few strips
)
lawful = settings(derandomize=True, max_examples=30, deadline=None)
# The Newton loop meets the contact conditions to 1e-11; two solves then differ by that times the condition of
# the system, which the profiles below keep under 1000.
SAME = 1e-8
LENGTH = 20.0


@dataclass(frozen=True)
class Drawn(Profile):
    """A crown, a wave along the axis and a taper; ``stretch`` magnifies all lengths."""

    crown: float
    wave: float
    phase: float
    taper: float
    offset: float = 0.0
    stretch: float = 1.0

    def relief(self, y):
        s = np.asarray(y, dtype=float) / (0.5 * LENGTH * self.stretch)
        shape = self.crown * s**2 + self.wave * np.sin(4.0 * s + self.phase) + self.taper * s
        return self.stretch * (shape + self.offset)

    def mirrored(self):
        return replace(self, phase=np.pi - self.phase, taper=-self.taper)


@dataclass(frozen=True)
class Extent:
    """Where both bodies end and how thick they are; lengths in mm for a roller that is 20 mm long."""

    side_faces: tuple = ("none", "none")
    images: int | str = 1
    depth: str | float = "none"
    ring_length: float | None = None
    ring_side_faces: tuple = ("none", "none")
    ring_depth: str | float = "none"

    def roller(self, stretch):
        return {"side_faces": self.side_faces, "images": self.images, "depth": _stretched(self.depth, stretch)}

    def ring(self, stretch):
        if self.ring_length is None:
            return {"depth": _stretched(self.ring_depth, stretch)}
        length, depth = stretch * self.ring_length, _stretched(self.ring_depth, stretch)
        return {"length": length, "side_faces": self.ring_side_faces, "depth": depth}

    def mirrored(self):
        return replace(self, side_faces=self.side_faces[::-1], ring_side_faces=self.ring_side_faces[::-1])


def _stretched(depth, by):
    return depth if isinstance(depth, str) else by * depth


@dataclass(frozen=True)
class Press:
    """A contact and what is prescribed, with everything that a law may want to change."""

    profile: Drawn
    extent: Extent
    load: float
    tilt: float
    element: object
    strips: int
    modulus: float = 207000.0
    diameter: float = 20.0

    @property
    def contact(self):
        stretch = self.profile.stretch
        material = nh.Material(self.modulus, 0.3)
        roller = nh.Roller(
            diameter=self.diameter * stretch,
            length=LENGTH * stretch,
            profile=self.profile,
            material=material,
            **self.extent.roller(stretch),
        )
        other = nh.Material(0.6 * self.modulus, 0.2)
        ring = nh.Ring(diameter=-3.0 * roller.diameter, material=other, **self.extent.ring(stretch))
        return nh.Contact(roller, ring)

    def solved(self, **prescribed):
        given_ = prescribed or {"load": self.load, "tilt": self.tilt}
        return nh.solve(self.contact, strips=self.strips, element=self.element, **given_)


def number(low, high):
    """A thousandth of the range is fine enough, and 1e-310 is no profile."""
    return st.integers(0, 1000).map(lambda k: low + (high - low) * k / 1000.0)


profiles = st.builds(Drawn, number(0.0, 0.04), number(0.0, 2e-3), number(0.0, 6.3), number(-2e-3, 2e-3))
IMAGES = ["none", "mirror", "calibrated", 0.6]


def presses_with(images, ring_lengths, side_faces):
    """Half of them between half-spaces, half between finite bodies."""
    faces = st.sampled_from(side_faces)
    finite = st.builds(
        Extent,
        st.tuples(faces, faces),
        st.sampled_from(images),
        st.sampled_from(["plane-strain", "diameter", 4.0]),
        st.sampled_from(ring_lengths),
        st.tuples(faces, faces),
        st.sampled_from(["none", 5.0]),
    )
    return st.builds(
        Press,
        profiles,
        st.one_of(st.just(Extent()), finite),
        number(500.0, 30e3),
        number(-8e-4, 8e-4),
        st.sampled_from([nh.SEMI_ELLIPTIC, nh.PARABOLIC]),
        st.integers(12, 40),
    )


presses = presses_with([1, 3, "series"], [None, LENGTH, 24.0], [*IMAGES, "free"])


def assert_same(found, expected, scale=None):
    """Equal within SAME of the largest entry, or of ``scale``."""
    scale = np.max(np.abs(expected)) if scale is None else scale
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=SAME * scale)


def assert_same_pressures(found, expected):
    assert_same(found.line_load, expected.line_load)
    assert_same(found.half_width, expected.half_width)


# Similarity


@lawful
@given(presses, number(0.05, 20.0))
def test_a_magnified_contact_has_the_same_pressures(press, by):
    small = press.solved()
    large = replace(press, profile=replace(press.profile, stretch=by)).solved(load=by**2 * press.load, tilt=press.tilt)
    assert_same(large.centre_pressure, small.centre_pressure)
    assert_same(large.half_width, by * small.half_width)
    assert_same(large.approach, by * small.approach, by * np.max(small.interference))
    assert_same(large.moment, by**3 * small.moment, by**3 * small.load * LENGTH)


@lawful
@given(presses, number(0.01, 10.0))
def test_a_softer_contact_under_less_load_has_the_same_shape(press, by):
    hard = press.solved()
    soft = replace(press, modulus=by * press.modulus).solved(load=by * press.load, tilt=press.tilt)
    assert_same(soft.half_width, hard.half_width)
    assert_same(soft.approach, hard.approach, np.max(hard.interference))
    assert_same(soft.centre_pressure, by * hard.centre_pressure)


# Symmetry


@lawful
@given(presses)
def test_a_mirrored_contact_has_the_mirrored_solution(press):
    solution = press.solved()
    other_way = replace(press, profile=press.profile.mirrored(), extent=press.extent.mirrored(), tilt=-press.tilt)
    mirrored = other_way.solved()
    assert_same(mirrored.line_load, solution.line_load[::-1])
    assert_same(mirrored.half_width, solution.half_width[::-1])
    assert_same(mirrored.moment, -solution.moment, solution.load * LENGTH)
    assert_same(mirrored.approach, solution.approach, np.max(solution.interference))


@lawful
@given(presses)
def test_it_does_not_matter_which_body_is_a(press):
    solution = press.solved()
    swapped = nh.solve(
        nh.Contact(press.contact.b, press.contact.a),
        load=press.load,
        tilt=press.tilt,
        strips=press.strips,
        element=press.element,
    )
    assert_same_pressures(swapped, solution)


@lawful
@given(presses, number(-50.0, 50.0))
def test_moving_both_bodies_along_y_moves_the_answer(press, by):
    solution = press.solved()
    a, b = (replace(body, position=by) for body in (press.contact.a, press.contact.b))
    moved = nh.solve(nh.Contact(a, b), load=press.load, tilt=press.tilt, strips=press.strips, element=press.element)
    # The approach is measured on y = 0, the moment about it.
    assert_same_pressures(moved, solution)
    assert_same(moved.approach + moved.tilt * by, solution.approach, np.max(solution.interference))
    assert_same(moved.moment - by * moved.load, solution.moment, solution.load * (LENGTH + abs(by)))


@lawful
@given(presses, number(-1.0, 1.0))
def test_a_constant_relief_only_shifts_the_approach(press, by):
    solution = press.solved()
    thinner = replace(press, profile=replace(press.profile, offset=by)).solved()
    assert_same_pressures(thinner, solution)
    assert_same(thinner.approach - by, solution.approach, np.max(solution.interference))


@lawful
@given(presses, number(-5e-4, 5e-4))
def test_a_taper_is_a_tilt(press, slope):
    solution = press.solved()
    tapered = replace(press.profile, taper=press.profile.taper + slope * 0.5 * LENGTH)
    turned = replace(press, profile=tapered, tilt=press.tilt + slope).solved()
    assert_same_pressures(turned, solution)
    assert_same(turned.approach, solution.approach, np.max(solution.interference))


# Contact conditions and balance, without the solver's own loops


def images(body):
    """Yield (sign, offset, weight): a load at y acts also at sign * y + offset."""
    (low, high), (at_low, at_high) = body.faces, body.face_weights
    to_and_fro = min(at_low, 1.0) * min(at_high, 1.0)
    for k in range(body.images):
        for face, weight, other, away in ((low, at_low, at_high, -1.0), (high, at_high, at_low, 1.0)):
            if weight > 0.0:
                shift = 2.0 * k * (high - low) if k > 0 else 0.0
                yield -1.0, 2.0 * face + away * shift, weight * to_and_fro**k
                if other > 0.0 and k < body.images - 1:
                    yield 1.0, -away * (shift + 2.0 * (high - low)), weight * min(other, 1.0) * to_and_fro**k


def sunk(body, depth, y, low, high):
    """Displacement at ``depth`` below y under a unit load on each strip, times 1 / K: summed point loads."""
    node, weight = np.polynomial.legendre.leggauss(20)
    place = 0.5 * (low + high) + 0.5 * np.abs(high - low) * node[:, None]
    distance = np.hypot(place[:, None, :] - y[:, None], depth)
    load = weight[:, None, None] * 0.5 * np.abs(high - low)
    return np.sum(load * (1.0 / distance + depth**2 / (2.0 * (1.0 - body.material.poisson) * distance**3)), axis=0)


def influence(press, y, low, high, a):
    """Displacement and flattening at y of strips from ``low`` to ``high`` under unit load."""
    displacement, flattening = 0.0, 0.0
    contact = press.contact
    for body in (contact.a, contact.b):
        depth = {"none": None, "plane-strain": None, "diameter": body.diameter}.get(body.depth, body.depth)
        if body.depth == "plane-strain":
            depth = body.diameter * plane_strain_depth(press.element, body.material.poisson)
        for sign, offset, weight in ((1.0, 0.0, 1.0), *images(body)):
            start, end = np.sort([sign * low + offset, sign * high + offset], axis=0)
            upper = press.element.functions((end - y[:, None]) / a)
            lower = press.element.functions((start - y[:, None]) / a)
            by = weight * body.material.compliance
            displacement += by * (upper[0] - lower[0])
            flattening += by * (upper[2] - lower[2])
            if depth is not None:
                displacement -= by * sunk(body, depth, y, start, end)
    return displacement, flattening


# No coincident ends, where weights may have to be lowered, and no series.
@lawful
@given(presses_with([1, 2, 3], [None, 24.0], IMAGES))
def test_contact_is_closed_and_the_rest_is_open(press):
    solution = press.solved()
    touching = solution.line_load > 0.0
    a, q = solution.element_half_width[touching], solution.line_load[touching]
    low, high = solution.edges[:-1][touching], solution.edges[1:][touching]
    contact = press.contact
    of_displacement, of_flattening = influence(press, solution.y, low, high, a)
    displacement = of_displacement @ q
    flattened = of_flattening[touching] @ (q / a**2)
    interference = solution.approach + solution.tilt * solution.y - contact.separation(solution.y)
    gap, depth = displacement - interference, np.max(interference)
    # 1e-9 of the approach is allowed anywhere.
    assert np.max(np.abs(gap[touching])) < 1e-9 * depth
    assert np.min(gap) > -1e-9 * depth
    np.testing.assert_allclose(flattened, contact.curvature(solution.y[touching]), rtol=1e-9, atol=0.0)
    assert np.all(solution.line_load >= 0.0)
    assert np.all(solution.element_half_width[~touching] == 0.0)
    np.testing.assert_allclose(solution.gap, gap, rtol=0.0, atol=1e-9 * depth)


@lawful
@given(presses, number(-0.7, 0.7))
def test_pressures_balance_what_is_prescribed(press, arm):
    moment = arm * 0.5 * LENGTH * press.load
    solution = press.solved(load=press.load, moment=moment)
    pieces = solution.line_load * solution.strip_width
    assert abs(np.sum(pieces) - press.load) < 1e-9 * press.load
    assert abs(np.sum(pieces * solution.y) - moment) < 1e-9 * press.load * LENGTH
    assert abs(solution.load - press.load) < 1e-9 * press.load
    assert abs(solution.moment - moment) < 1e-9 * press.load * LENGTH


# Consistency


@lawful
@given(presses)
def test_the_four_pairs_of_prescribed_quantities_agree(press):
    solution = press.solved()
    # A moment that no pressure on half as many strips can bear leaves no estimate, which is warned of.
    assume(abs(solution.moment) < 0.7 * 0.5 * LENGTH * solution.load)
    first = {"load": solution.load, "approach": solution.approach}
    second = {"tilt": solution.tilt, "moment": solution.moment}
    for pair in (("approach", "tilt"), ("approach", "moment"), ("load", "moment")):
        again = press.solved(**{name: (first | second)[name] for name in pair})
        assert_same_pressures(again, solution)
        assert_same(again.approach, solution.approach, np.max(solution.interference))
        assert_same(again.tilt * LENGTH, solution.tilt * LENGTH, np.max(solution.interference))


@lawful
@given(presses, number(1.01, 3.0))
def test_more_load_means_more_approach_and_a_larger_contact(press, by):
    less, more = press.solved(), press.solved(load=by * press.load, tilt=press.tilt)
    assert more.approach > less.approach
    assert np.all(more.line_load[less.line_load > 0.0] > 0.0)
    assert more.max_pressure > less.max_pressure


@lawful
@given(presses)
def test_stiffness_is_positive_and_nearly_symmetric(press):
    # Collocation at centres makes it symmetric to the order of the strips: 1e-5 in these cases.
    stiffness = press.solved().stiffness
    scaled = stiffness / np.array([[1.0, LENGTH], [LENGTH, LENGTH**2]])
    assert scaled[0, 0] > 0.0
    assert np.linalg.det(scaled) > 0.0
    assert abs(scaled[0, 1] - scaled[1, 0]) < 1e-4 * scaled[0, 0]


@settings(derandomize=True, max_examples=20, deadline=None)
@given(presses)
@pytest.mark.slow
def test_the_automatic_grid_agrees_with_many_equal_strips(press):
    # 201 equal strips are off by 2e-3 themselves where a sharp end carries half of a lifted roller.
    automatic, equal = replace(press, strips="auto").solved(), replace(press, strips=201).solved()
    assert abs(automatic.approach - equal.approach) < 0.005 * np.max(equal.interference)
    assert abs(automatic.moment - equal.moment) < 0.005 * press.load * LENGTH

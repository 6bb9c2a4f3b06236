"""The pressure at the ends of a contact: its kind, exponent, strength and convention."""

import math
import pickle

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bodies.ends import edge_powers, ends
from nonhertz.errors import without_accuracy_warnings
from nonhertz.result.ends import away_from_ends
from nonhertz.result.maximum import values_that_count

HALF_SPACE = {"side_faces": "none", "depth": "none"}
CROWN = nh.profile.crown(radius=4000)


def solved(a, b, **options):
    with without_accuracy_warnings():
        return nh.solve(nh.Contact(a, b), **({"load": 20e3} | options))


def roller(**options):
    return nh.Roller(**({"diameter": 20.0, "length": 20.0} | options))


def test_a_contact_that_ends_inside_the_bodies_runs_out():
    solution = solved(roller(profile=CROWN), nh.Plate(), load=3e3)
    for edge, y in zip(solution.edge_pressure, (solution.contact_y[0][0], solution.contact_y[-1][1]), strict=True):
        assert edge.kind is nh.EdgeKind.RUN_OUT
        assert (edge.y, edge.pressure, edge.exponent, edge.strength) == (y, 0.0, 0.0, None)
        assert edge.converges
        assert str(edge.convention) == "the contact ends before both bodies do"


def test_a_tilted_contact_has_ends_of_two_kinds():
    solution = solved(roller(profile=CROWN), nh.Plate(), tilt=3e-3)
    low, high = solution.edge_pressure
    assert (low.kind, high.kind) == (nh.EdgeKind.RUN_OUT, nh.EdgeKind.SINGULAR)
    assert low.y > -10.0
    assert high.y == 10.0
    assert high.strip_width == pytest.approx(solution.strip_width[-1], rel=1e-12)
    assert high.pressure == pytest.approx(solution.centre_pressure[-1], rel=1e-12)
    assert not high.converges
    width = np.interp(solution.max_pressure_y, solution.y, solution.half_width)
    assert 10.0 - solution.max_pressure_y == pytest.approx(width, rel=1e-9)  # as near that end as counts
    places = np.array([-10.0, 10.0 - 2.0 * width, 10.0 - 0.5 * width])
    assert away_from_ends(solution, places).tolist() == [True, True, False]


@pytest.mark.parametrize(
    ("weight", "modulus", "kappa"), [(0.0, 207e3, 0.0), (1.0, 207e3, 0.5), (1.0, 103.5e3, 1.0 / 3.0), (1.6, 207e3, 0.8)]
)
def test_the_exponent_follows_from_kappa(weight, modulus, kappa):
    plate = nh.Plate(material=nh.Material(modulus, 0.3))
    edge = solved(roller(side_faces=weight, depth="none"), plate).edge_pressure[1]
    assert edge.image_weight == pytest.approx(kappa, rel=1e-12, abs=1e-15)
    assert math.cos(math.pi * edge.exponent) == pytest.approx(kappa, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("strips", [25, 41, 161])
def test_the_strength_depends_little_on_the_strips(strips):
    # Wide enough for equal strips to have some near the end. Fitted to the powers themselves it would change by 4 %.
    contact = nh.Contact(roller(length=2.0, **HALF_SPACE), nh.Plate())
    coarse, fine = (nh.solve(contact, load=8e3, strips=number).edge_pressure[1].strength for number in (strips, 641))
    assert coarse == pytest.approx(fine, rel=0.006)


def test_a_solution_from_another_process_has_the_same_strength():
    solution = solved(roller(), nh.Plate())
    sent = pickle.loads(pickle.dumps(solution))
    assert [edge.strength for edge in sent.edge_pressure] == [edge.strength for edge in solution.edge_pressure]


def test_nearly_whole_mirrors_are_called_finite_and_weak_singularities_have_no_strength():
    def edge(modulus):
        return solved(roller(), nh.Plate(material=nh.Material(modulus, 0.3))).edge_pressure[1]

    assert edge(207e3 * 2e3).kind is nh.EdgeKind.FINITE
    weak = edge(207e3 * 50.0)
    assert (weak.kind, weak.strength) == (nh.EdgeKind.SINGULAR, None)
    assert 0.0 < weak.exponent < 0.1


@pytest.mark.parametrize("moduli", [(310e3, 0.26, 70e3, 0.33), (207e3, 0.3, 110e3, 0.34), (1e3, 0.4, 3e3, 0.1)])
def test_rounding_of_kappa_leaves_a_finite_end_its_error_estimate(moduli):
    a = roller(material=nh.Material(*moduli[:2]))
    b = roller(material=nh.Material(*moduli[2:]))
    solution = solved(a, b, load=1e3)
    assert solution.edge_pressure[1].kind is nh.EdgeKind.FINITE
    assert math.isfinite(solution.error_estimate.max_pressure)


def test_coarse_strips_do_not_make_two_faces_one():
    solution = solved(roller(), roller(length=20.02), strips=41)
    assert solution.edge_pressure[1].kind is nh.EdgeKind.SINGULAR
    assert [end.y for end in solution.singular_ends] == [-10.0, 10.0]


def test_strips_that_end_before_the_contact_are_said_to():
    solution = solved(roller(), nh.Plate(), strips=np.linspace(-9.9, 9.9, 42))
    for edge, y in zip(solution.edge_pressure, (-9.9, 9.9), strict=True):
        assert (edge.kind, edge.y, edge.converges) == (nh.EdgeKind.CUT_OFF, y, False)
    assert sum("while the contact continues" in sentence for sentence in solution.warnings) == 2


def test_each_face_whose_images_weigh_less_than_asked_is_named():
    solution = solved(roller(side_faces=5.0), roller(length=30.0, side_faces=5.0))
    named = [f"y = {y} mm" for y in (-10, -15, 10, 15)]
    assert all(any(place in sentence and "lowered" in sentence for sentence in solution.warnings) for place in named)


@pytest.mark.parametrize(
    ("other", "modulus"), [(nh.Plate(), 207e3), (nh.Plate(material=nh.Material(70e3, 0.33)), 207e3)]
)
def test_a_free_end_has_the_exponents_of_its_wedge(other, modulus):
    solution = solved(roller(side_faces="free", depth="none", material=nh.Material(modulus, 0.3)), other)
    (face, _), edge = ends(solution.contact), solution.edge_pressure[0]
    first, second, _ = edge_powers(face.image_weight, face.free)
    assert 0.0 < face.free < 1.0
    assert (edge.exponent, edge.correction_exponent) == pytest.approx((-first, second - first), rel=1e-12)


def test_too_few_strips_near_the_end_give_no_strength():
    edge = solved(roller(**HALF_SPACE), nh.Plate(), strips=41).edge_pressure[1]
    assert (edge.kind, edge.strength) == (nh.EdgeKind.SINGULAR, None)


def test_coincident_mirrored_ends_are_finite():
    for edge in solved(roller(), roller()).edge_pressure:
        assert edge.kind is nh.EdgeKind.FINITE
        assert (edge.image_weight, edge.exponent, edge.strength) == (pytest.approx(1.0), 0.0, None)
        assert edge.converges


def test_a_face_a_little_further_out_leaves_the_exponent_and_takes_the_strength():
    near, far = (
        solved(roller(side_faces="mirror"), nh.Plate(length=length, side_faces="mirror")).edge_pressure[1]
        for length in (20.2, 22.0)
    )
    assert near.exponent == pytest.approx(far.exponent) == pytest.approx(1.0 / 3.0)
    assert near.strength is None
    assert far.strength > 0.0


FREED = "ends with its side face freed by images of weight 1"


@pytest.mark.parametrize(
    ("a", "b", "convention"),
    [
        (roller(**HALF_SPACE), nh.Plate(), "a ends as a half-space, b continues"),
        (roller(), nh.Plate(), "a ends with its side face free, b continues"),
        (roller(side_faces="mirror"), nh.Plate(), f"a {FREED}, b continues"),
        (
            roller(side_faces="calibrated"),
            nh.Plate(length=20.0, side_faces="calibrated"),
            f"a {FREED}, b {FREED}",
        ),
        (
            roller(effective_length=19.0),
            nh.Plate(),
            "a can touch only up to here, 0.5 mm short of its side face, b continues",
        ),
        (roller(length=30.0), nh.Plate(length=20.0, side_faces="none"), "a continues, b ends as a half-space"),
    ],
)  # fmt: skip
def test_the_convention_says_what_ends_and_what_is_freed(a, b, convention):
    solution = solved(a, b)
    assert [str(edge.convention) for edge in solution.edge_pressure] == [convention] * 2
    singular = solution.edge_pressure[1].kind is nh.EdgeKind.SINGULAR
    assert any(f"({convention})" in sentence for sentence in solution.warnings) is singular


# Corners of the profile


def test_a_contact_that_presses_against_a_chamfer_does_not_run_out():
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.chamfer(20, 1.0))
    solution = nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=20e3)
    for edge, place in zip(solution.edge_pressure, (-9.0, 9.0), strict=True):
        assert edge.kind is nh.EdgeKind.CORNER
        assert edge.y == pytest.approx(place, abs=1e-12)
        assert edge.pressure > 2.0 * solution.centre_pressure[solution.strips // 2]
        assert not edge.converges
    assert [end.kind for end in solution.singular_ends] == [nh.EdgeKind.CORNER] * 2
    # The last strip's pressure is anything; away from the corners there is a maximum.
    assert solution.max_pressure < 0.2 * solution.edge_pressure[0].pressure
    assert solution.error_estimate.max_pressure < 0.02
    assert sum("ends at a corner of the profile" in sentence for sentence in solution.warnings) == 2


def test_the_border_before_an_end_between_two_strips_is_on_the_side_of_the_contact():
    # A corner between the centres of wide strips: what counts ends a half-width before it, not next to it.
    y, half_width = np.array([0.0, 1.0, 2.0, 3.0]), np.full(4, 0.3)
    places, pressures, _ = values_that_count(y, np.array([1.0, 3.0, 9.0, 5.0]), half_width, np.array([1.8]))
    at = places[pressures > 0.0].tolist()
    assert at == pytest.approx([0.0, 1.0, 3.0, 1.5, 2.1])
    # Between the end and the next strip the power of the distance, across the end a straight line.
    assert pressures[pressures > 0.0][-2] == pytest.approx(3.0**0.5 * 9.0**0.5)
    assert pressures[-1] == pytest.approx(9.0 * (5.0 / 9.0) ** (np.log(0.3 / 0.2) / np.log(1.2 / 0.2)))

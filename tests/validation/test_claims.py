"""The claims of `nonhertz verify` hold, and fail when what they rest on is a little off. (Those on cost show times.)"""

from dataclasses import replace

import numpy as np
import pytest

import nonhertz as nh
from nonhertz import verify
from nonhertz.bearing import bearings as rows
from nonhertz.bearing import standard, verb
from nonhertz.bearing.strips import StripLaw
from nonhertz.bodies import images, whole_roller
from nonhertz.bodies.depths import plane_strain
from nonhertz.errors import without_accuracy_warnings
from nonhertz.life import capacity
from nonhertz.life.lamina import lamina_stiffness
from nonhertz.patch import convolution, free_faces, inverse, kernel
from nonhertz.solver import one
from nonhertz.subsurface.inside import Inside
from nonhertz.verify import bearings, fatigue_life, plane_grid, subsurface_stress
from nonhertz.verify.claim import forget

SLOW = {"plane-strain", "plane-grid", "free-ends", "subsurface", "fatigue-life", "bearings"}
SECTIONS = [
    pytest.param(name, marks=[pytest.mark.slow] if name in SLOW else []) for name in verify.CATALOGUE if name != "cost"
]


@pytest.fixture(autouse=True)
def _nothing_solved_before():
    forget()
    yield
    forget()


def failed(claims):
    """What of some claims, or of a section by name, does not hold."""
    with without_accuracy_warnings():
        checks = [each.check() for each in (verify.claims(claims) if isinstance(claims, str) else claims)]
    assert any(check.passed is not None for check in checks)
    return [check.claim.quantity for check in checks if check.passed is False]


@pytest.mark.parametrize("name", SECTIONS)
def test_every_claim_holds(name):
    assert failed(name) == []


OF_COMPLIANCE = ["hertz-ellipse", "line-limits", "half-space", "profiled-roller", "load-compression", "finite-bodies"]


@pytest.mark.parametrize(
    "name", [*OF_COMPLIANCE, *(pytest.param(name, marks=pytest.mark.slow) for name in ("plane-strain", "plane-grid"))]
)
def test_a_solver_with_five_per_cent_too_much_compliance_fails(monkeypatch, name):
    # The closed forms take the materials' own compliance, the solver that of the contact.
    right = nh.Contact.compliance.fget
    monkeypatch.setattr(nh.Contact, "compliance", property(lambda contact: 1.05 * right(contact)))
    claims = failed(name)
    assert claims
    if name in {"hertz-ellipse", "line-limits"}:
        assert {claim.partition(",")[0] for claim in claims} >= {nh.SEMI_ELLIPTIC.name, nh.PARABOLIC.name}


@pytest.mark.parametrize("name", ["finite-bodies", "edge-exponents", "quarter-space", "whole-roller"])
def test_images_that_weigh_a_tenth_too_little_are_noticed(monkeypatch, name):
    right = images.chains
    monkeypatch.setattr(images, "chains", lambda *args: {place: 0.9 * w for place, w in right(*args).items()})
    assert failed(name)


@pytest.mark.slow
def test_free_faces_that_add_a_tenth_too_little_on_cells_are_noticed(monkeypatch):
    right = free_faces.face_terms
    monkeypatch.setattr(
        free_faces, "face_terms", lambda *args: ((far, 0.9 * image, 0.9 * plane) for far, image, plane in right(*args))
    )
    beside = "both bodies end: pressure at y = 0.25 mm over that at 8 mm, strips"
    assert {"straight: approach", "together: moment", beside} <= set(failed("free-ends"))


@pytest.mark.parametrize(
    "name", ["finite-bodies", "whole-roller", pytest.param("plane-strain", marks=pytest.mark.slow)]
)
def test_a_depth_a_tenth_too_small_is_noticed(monkeypatch, name):
    right = plane_strain.plane_strain_depth
    monkeypatch.setattr(plane_strain, "plane_strain_depth", lambda *args: 0.9 * right(*args))
    assert failed(name)


def test_a_whole_roller_that_is_five_per_cent_softer_at_large_is_noticed(monkeypatch):
    right = whole_roller.WholeRoller.displacement
    monkeypatch.setattr(whole_roller.WholeRoller, "displacement", lambda *args: 1.05 * right(*args))
    claims = failed("whole-roller")
    assert claims
    assert all("whole roller" in claim or "hollow roller" in claim for claim in claims)


def test_a_kernel_of_strips_that_is_five_per_cent_off_is_noticed(monkeypatch):
    right = one.influence_of

    def softer(*arguments):
        found = right(*arguments)
        return replace(found, terms=found.terms * [1.0, 1.0, 1.05])

    monkeypatch.setattr(one, "influence_of", softer)
    claims = failed(plane_grid.of_case(plane_grid.TILTED_CROWN))
    assert {"tilted crown: approach", "tilted crown: pressure in the middle"} <= set(claims)


def test_a_table_that_is_five_per_cent_off_contradicts_what_strips_do_far_away(monkeypatch):
    monkeypatch.setitem(vars(nh.SEMI_ELLIPTIC), "table", 1.05 * nh.SEMI_ELLIPTIC.table)
    case = plane_grid.TILTED_CROWN
    with pytest.raises(nh.ConvergenceError, match="leaves a gap"):
        nh.solve(case.contact, **case.given)


def test_a_kernel_of_cells_that_is_five_per_cent_off_is_noticed_by_the_last_check(monkeypatch):
    right = kernel.rectangles
    for module in (convolution, inverse):
        monkeypatch.setattr(module, "rectangles", lambda *edges: 1.05 * right(*edges))
    case = plane_grid.TILTED_CROWN
    with pytest.raises(nh.ConvergenceError, match="a separate check of their solution failed"):
        nh.compare(case.contact, **case.given)


def test_slices_that_are_five_per_cent_too_stiff_are_noticed(monkeypatch):
    monkeypatch.setattr(standard, "lamina_stiffness", lambda *given: 1.05 * lamina_stiffness(*given))
    claims = [claim for case in bearings.known.LAMINA_CASES for claim in bearings.laminae(case)]
    assert sum(claim.endswith("displacement") for claim in failed(claims)) == 3


def test_normals_of_raceways_that_are_two_milliradians_off_are_noticed(monkeypatch):
    # Slices take theirs elsewhere, where the rollers' own loads have to be along them.
    right = rows.raceway_motion
    monkeypatch.setattr(rows, "raceway_motion", lambda angle, **more: right(angle + 2e-3, **more))
    claims = failed([*bearings.in_space("strips"), *bearings.in_space("slices")])
    assert [claim.partition(":")[0] for claim in claims] == ["two HR30306J, strips"] * 2


@pytest.mark.slow
def test_contacts_of_bearings_that_are_a_per_cent_too_stiff_are_noticed(monkeypatch):
    right = StripLaw.pressed
    monkeypatch.setattr(StripLaw, "pressed", lambda *args: 1.01 * right(*args))
    assert "NU 206: displacement" in failed(bearings.by_hand())


@pytest.mark.slow
def test_a_stiffness_that_is_a_hundredth_of_a_per_cent_off_is_noticed(monkeypatch):
    right = bearings.balanced

    def off(*args, **more):
        found = right(*args, **more)
        return found._replace(stiffness=1.0001 * found.stiffness)

    monkeypatch.setattr(bearings, "balanced", off)
    monkeypatch.setattr(verb, "balanced", off)
    assert len(failed([bearings.derivatives("strips"), bearings.derivatives("slices")])) == 2


def stress_scaled(monkeypatch, factors):
    right = Inside.stress
    monkeypatch.setattr(Inside, "stress", lambda inside, points: factors * right(inside, points))


@pytest.mark.slow
def test_a_field_that_is_five_per_cent_off_is_noticed(monkeypatch):
    stress_scaled(monkeypatch, 1.05)
    assert len(failed(subsurface_stress.plane_strain())) == 2
    assert len(failed(subsurface_stress.on_cells())) == 3
    assert len(failed(subsurface_stress.on_circle())) == 3


@pytest.mark.slow
def test_a_shear_stress_that_is_five_per_cent_off_is_out_of_balance(monkeypatch):
    stress_scaled(monkeypatch, np.where(np.arange(6) == subsurface_stress.TAU_XZ, 1.05, 1.0))
    roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000))
    solution = nh.solve(nh.Contact(roller, nh.Plate()), load=6e3)
    assert any("balance" in claim for claim in failed(subsurface_stress.balance(lambda: solution)))


def test_images_below_the_surface_that_weigh_a_tenth_too_little_are_noticed(monkeypatch):
    right = Inside.of.__func__

    def lighter(cls, solution, name):
        inside = right(cls, solution, name)
        weight = np.where(np.arange(len(inside.terms)) > 0, 0.9, 1.0)
        return replace(inside, terms=inside.terms * np.column_stack([np.ones((weight.size, 2)), weight]))

    monkeypatch.setattr(Inside, "of", classmethod(lighter))
    assert failed(subsurface_stress.plane_strain())


def test_stresses_of_lives_that_are_five_per_cent_off_are_noticed(monkeypatch):
    stress_scaled(monkeypatch, 1.05)
    claims = failed(fatigue_life.of_line())
    by_volume = {"lundberg-palmgren", "ioannides-harris", "zaretsky", "weibull"}
    assert {claim.partition(":")[0] for claim in claims if "relative life" in claim} == by_volume
    assert sum("integral" in claim for claim in claims) == 3


def test_a_reduction_that_is_five_per_cent_off_is_noticed(monkeypatch):
    monkeypatch.setattr(capacity, "MATERIAL_FACTOR", 1.05 * capacity.MATERIAL_FACTOR)
    assert {"ISO 281: C_r", "ISO/TS 16281: Q_ci", "ISO/TS 16281: Q_ce"} <= set(failed(fatigue_life.of_standard()))


def test_pressures_that_are_five_per_cent_off_are_noticed(monkeypatch):
    right = fatigue_life.laminae_of

    def off(solution, model):
        found = right(solution, model)
        return replace(found, factor=1.05 * found.factor)

    monkeypatch.setattr(fatigue_life, "laminae_of", off)
    assert sum("that differs most" in claim for claim in failed(fatigue_life.of_standard())) == 2

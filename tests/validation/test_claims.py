"""The claims hold, and fail when what they rest on is a little off. (Those on cost show times.)"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from fnmatch import fnmatch
from typing import Any

import numpy as np
import pytest

import claims
import nonhertz as nh
from claims import bearings, fatigue_life, plane_grid
from claims.claim import forget
from nonhertz.bearing import equilibrium, roller_bearing, standard, verb
from nonhertz.bodies import depths, images
from nonhertz.errors import without_accuracy_warnings
from nonhertz.life import capacity
from nonhertz.native import core
from nonhertz.patch import convolution, free_faces, inverse
from nonhertz.strip import model, problem
from nonhertz.subsurface.field import TAU_XZ
from nonhertz.subsurface.inside import Inside

SLOW = {"plane-strain", "plane-grid", "free-ends", "subsurface", "fatigue-life", "bearings"}


@pytest.fixture(autouse=True)
def _nothing_solved_before():
    forget()
    yield
    forget()


def failed(patterns):
    """The ids of those claims with an id like one of the patterns that do not hold."""
    sections = claims.chosen(each.partition("/")[0] for each in patterns)
    asked = [c for name in sections for c in claims.claims(name) if any(fnmatch(c.id, each) for each in patterns)]
    with without_accuracy_warnings():
        checks = [each.check() for each in asked]
    assert any(check.passed is not None for check in checks)
    return [check.claim.id for check in checks if check.passed is False]


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[pytest.mark.slow] * (name in SLOW)) for name in claims.CATALOGUE if name != "cost"],
)
def test_every_claim_holds(name):
    assert failed([f"{name}/*"]) == []


@pytest.fixture(autouse=True)
def _contacts_forget(monkeypatch):
    """What is made of a contact before and after a mistake is not the same."""
    monkeypatch.setattr(problem, "get_or_compute", lambda contact, what, make: make())


@dataclass(frozen=True)
class Mistake:
    """What is made of something right in some places; the claims that are asked, and those that have to fail.

    ``number`` is how many fail, where it is known.
    """

    what: str
    places: list[tuple[Any, str]]
    wrong: Callable[[Any], Any]
    asked: list[str]
    fail: list[str]
    number: int | None = None


def times(factor):
    return lambda right: lambda *given, **more: factor * right(*given, **more)


def changed(change):
    return lambda right: lambda *given, **more: change(right(*given, **more))


def without_images(inside):
    weight = np.where(np.arange(len(inside.terms)) > 0, 0.9, 1.0)
    return replace(inside, terms=inside.terms * np.column_stack([np.ones((weight.size, 2)), weight]))


# The closed forms take the materials' own compliance, the solver that of the contact.
COMPLIANCE = (
    "five per cent too much compliance", [(nh.Contact, "compliance")],
    lambda right: property(lambda contact: 1.05 * right.func(contact)),
)  # fmt: skip
IMAGES = (
    "images that weigh a tenth too little", [(images, "chains")],
    changed(lambda found: {place: 0.9 * weight for place, weight in found.items()}),
)  # fmt: skip


def stiffer(right):
    """Let strips answer with one per cent more load, moment and stiffness."""

    def law_of(law):
        made = right(law)
        factor = np.array([1.01] * 6 + [1.0])
        return core.PythonLaw(lambda *asked: factor * law.answer(*asked)) if isinstance(made, core.GroupLaw) else made

    return law_of


DEPTH = ("a depth a tenth too small", [(depths, "plane_strain_depth")], times(0.9))
FIELD = ("a field five per cent off", [(Inside, "stress")], times(1.05))
BOTH_ELEMENTS = ["*/semi-elliptic*", "*/parabolic*"]
FAST = [
    Mistake(*COMPLIANCE, ["hertz-ellipse/*"], BOTH_ELEMENTS),
    Mistake(*COMPLIANCE, ["line-limits/*"], BOTH_ELEMENTS),
    *(
        Mistake(*COMPLIANCE, [f"{name}/*"], ["*"])
        for name in ("half-space", "profiled-roller", "load-compression", "finite-bodies")
    ),
    *(
        Mistake(*IMAGES, [f"{name}/*"], ["*"])
        for name in ("finite-bodies", "edge-exponents", "quarter-space", "whole-roller")
    ),
    *(Mistake(*DEPTH, [f"{name}/*"], ["*"]) for name in ("finite-bodies", "whole-roller")),
    Mistake(
        "a kernel of strips five per cent off", [(model, "influence_of")],
        changed(lambda found: replace(found, terms=found.terms * [1.0, 1.0, 1.05])), ["plane-grid/tilted-crown*"],
        ["*/tilted-crown-approach", "*/tilted-crown-pressure-in-the-middle"],
    ),
    Mistake(
        "slices five per cent too stiff", [(standard, "lamina_stiffness")], times(1.05), ["bearings/*-mrad-*"],
        [f"*/{line}-0-mrad-displacement" for line in ("0-um-straight", "40.6-um-straight", "40.6-um-profile")],
    ),
    # Slices take theirs elsewhere, where the rollers' own loads have to be along them.
    Mistake(
        "normals of raceways two milliradians off", [(roller_bearing, "raceway_motion")],
        lambda right: lambda angle, **more: right(angle + 2e-3, **more), ["bearings/two-hr*"],
        ["*/two-hr30306j-strips-what-is*", "*/two-hr30306j-strips-what-the*"], 2,
    ),
    Mistake(
        "images below the surface that weigh a tenth too little", [(Inside, "of")],
        lambda right: classmethod(lambda _, *given: without_images(right(*given))), ["subsurface/line-*-any-stress*"],
        ["*"],
    ),
    Mistake(
        *FIELD, ["fatigue-life/*line-contact", "fatigue-life/*integral*"],
        [f"*/{name}-relative*" for name in ("lundberg-palmgren", "ioannides-harris", "zaretsky", "weibull")]
        + [f"*/{name}-integral*" for name in ("lundberg-palmgren", "zaretsky", "weibull")], 7,
    ),
    Mistake(
        "a reduction five per cent off", [(capacity, "MATERIAL_FACTOR")], lambda right: 1.05 * right,
        ["fatigue-life/iso-281*", "fatigue-life/iso-ts*"], ["*/iso-281-c-r", "*/*q-ci", "*/*q-ce"],
    ),
    Mistake(
        "pressures on slices five per cent off", [(fatigue_life, "laminae_of")],
        changed(lambda found: replace(found, factor=1.05 * found.factor)), ["fatigue-life/*differs-most"], ["*"], 2,
    ),
]  # fmt: skip
LATE = [
    *(Mistake(*COMPLIANCE, [f"{name}/*"], ["*"]) for name in ("plane-strain", "plane-grid")),
    Mistake(*DEPTH, ["plane-strain/*"], ["*"]),
    Mistake(
        "free faces that add a tenth too little on cells", [(free_faces, "face_terms")],
        changed(lambda terms: ((far, 0.9 * image, 0.9 * plane) for far, image, plane in terms)), ["free-ends/*"],
        ["*/straight-approach", "*/together-moment", "*/both-bodies-end-*-y-0.25-mm-*-strips"],
    ),
    Mistake(
        "contacts of bearings a per cent too stiff", [(equilibrium, "for_core")], stiffer, ["bearings/nu-206*"],
        ["*/nu-206-displacement"],
    ),
    Mistake(
        "a stiffness a hundredth of a per cent off", [(bearings, "solve_balance"), (verb, "solve_balance")],
        changed(lambda found: found._replace(stiffness=1.0001 * found.stiffness)), ["bearings/*-error-of-k*"], ["*"], 2,
    ),
    Mistake(*FIELD, ["subsurface/line-*-any-stress*"], ["*"], 2),
    Mistake(*FIELD, ["subsurface/circle*"], ["*/circle-largest*", "*/circle-plane-grid-largest*"], 6),
    Mistake(
        "a shear stress five per cent off", [(Inside, "stress")],
        times(np.where(np.arange(6) == TAU_XZ, 1.05, 1.0)), ["subsurface/*balance*"], ["*"],
    ),
]  # fmt: skip


@pytest.mark.parametrize(
    "mistake",
    [*FAST, *(pytest.param(each, marks=pytest.mark.slow) for each in LATE)],
    ids=lambda each: f"{each.what}, {each.asked[0].partition('/')[0]}",
)
def test_a_mistake_is_noticed(monkeypatch, mistake):
    for owner, name in mistake.places:
        monkeypatch.setattr(owner, name, mistake.wrong(getattr(owner, name)))
    ids = failed(mistake.asked)
    for pattern in mistake.fail:
        assert any(fnmatch(each, pattern) for each in ids), pattern
    assert mistake.number in {None, len(ids)}


def test_a_whole_roller_that_is_five_per_cent_softer_at_large_is_noticed_by_whole_rollers_alone(monkeypatch):
    softer = property(lambda of: core.AxisOfRoller(of.below.core, of.whole.core, of.radius, of.middle, 1.05 * of.share))
    monkeypatch.setattr(depths.AxisOfRoller, "core", softer)
    ids = failed(["whole-roller/*"])
    assert ids
    assert all(fnmatch(each, "*/whole-roller*") or fnmatch(each, "*/hollow-roller*") for each in ids)


def test_a_table_that_is_five_per_cent_off_contradicts_what_strips_do_far_away(monkeypatch):
    right = nh.SEMI_ELLIPTIC.core
    wrong = core.Element(right, 1.05 * right.table)
    monkeypatch.setattr(type(nh.SEMI_ELLIPTIC), "core", property(lambda of: wrong))
    case = plane_grid.TILTED_CROWN
    with pytest.raises(nh.ConvergenceError, match="leaves a gap"):
        nh.solve(case.contact, **case.given)


def test_a_kernel_of_cells_that_is_five_per_cent_off_is_noticed_by_the_last_check(monkeypatch):
    for module in (convolution, inverse):
        monkeypatch.setattr(module, "rectangles", times(1.05)(module.rectangles))
    case = plane_grid.TILTED_CROWN
    with pytest.raises(nh.ConvergenceError, match="a separate check of their solution failed"):
        nh.compare(case.contact, **case.given)

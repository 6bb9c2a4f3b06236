"""The sections of the validation page, and that they can fail. (That on cost has nothing to fail by.)"""

import importlib
from dataclasses import replace

import pytest
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.bearing import bearings as rows
from nonhertz.bearing import standard, verb
from nonhertz.bearing.strips import StripLaw
from nonhertz.bodies import images, whole_roller
from nonhertz.bodies.depths import plane_strain
from nonhertz.life.lamina import lamina_stiffness
from nonhertz.patch import convolution, free_faces, inverse, kernel
from nonhertz.solver import one
from nonhertz.verify import bearings, plane_grid

PAPER = ("hertz_ellipse", "line_limits", "profiled_roller", "load_compression")
BODIES = ("half_space", "plane_strain", "finite_bodies", "edge_exponents", "quarter_space", "whole_roller")
GRID = ("plane_grid", "free_ends")
BELOW = ("subsurface_stress", "fatigue_life")
MODULES = (*PAPER, *BODIES, *GRID, *BELOW, "bearings")
# CI runs `nonhertz verify` as well: half a minute that a developer need not wait for all day.
# The paper's single strip is among the sections, whose error nothing tells.
pytestmark = [
    pytest.mark.campaign,
    pytest.mark.filterwarnings("ignore:The discretisation error of:nonhertz.AccuracyWarning"),
    pytest.mark.filterwarnings("ignore:The maximum pressure is uncertain:nonhertz.AccuracyWarning"),
    pytest.mark.filterwarnings("ignore:The contact of roller .* with a rib:nonhertz.AccuracyWarning"),
]
over_modules = pytest.mark.parametrize("module", MODULES)


def section(module):
    return importlib.import_module(f"nonhertz.verify.{module}").section()


@pytest.fixture(scope="module")
def sections():
    return {module: section(module) for module in MODULES}


@over_modules
def test_no_check_fails(sections, module):
    failed = [check for check in sections[module].checks if check.passed is False]
    assert not failed
    assert any(check.passed for check in sections[module].checks)


@over_modules
def test_the_text_has_all_its_numbers(sections, module):
    # A pair of braces may be LaTeX; a number's name in one is not.
    text = sections[module].text
    assert "nan" not in text
    assert ":.1f}" not in text
    assert "**Found.**" in text


@over_modules
def test_pictures_can_be_drawn(sections, module):
    for picture in sections[module].pictures:
        figure = Figure(figsize=(6.7, picture.height), layout="constrained")
        picture.draw(figure)
        figure.draw_without_rendering()
        assert all(axes.has_data() for axes in figure.axes)


@pytest.mark.parametrize("module", [*PAPER, "half_space", "plane_strain", "finite_bodies", "plane_grid"])
def test_a_solver_with_five_per_cent_too_much_compliance_fails(monkeypatch, module):
    # The closed forms take the materials' own compliance, the solver that of the contact.
    right = nh.Contact.compliance.fget
    monkeypatch.setattr(nh.Contact, "compliance", property(lambda contact: 1.05 * right(contact)))
    failed = [check.claim for check in section(module).checks if check.passed is False]
    assert failed
    if module in {"hertz_ellipse", "line_limits"}:
        assert {claim.partition(",")[0] for claim in failed} >= {nh.SEMI_ELLIPTIC.name, nh.PARABOLIC.name}


@pytest.mark.parametrize("module", ["finite_bodies", "edge_exponents", "quarter_space", "whole_roller"])
def test_images_that_weigh_a_tenth_too_little_are_noticed(monkeypatch, module):
    right = images._chains
    monkeypatch.setattr(images, "_chains", lambda *args: {place: 0.9 * w for place, w in right(*args).items()})
    assert section(module).failed > 0


def test_free_faces_that_add_a_tenth_too_little_on_cells_are_noticed(monkeypatch):
    right = free_faces._terms
    monkeypatch.setattr(
        free_faces, "_terms", lambda *args: ((far, 0.9 * image, 0.9 * plane) for far, image, plane in right(*args))
    )
    failed = [check.claim for check in section("free_ends").checks if check.passed is False]
    assert {
        "straight: approach",
        "together: moment",
        "both bodies end: pressure at y = 0.25 mm over that at 8 mm, strips",
    } <= set(failed)


def test_a_depth_a_tenth_too_small_is_noticed(monkeypatch):
    right = plane_strain.plane_strain_depth
    monkeypatch.setattr(plane_strain, "plane_strain_depth", lambda *args: 0.9 * right(*args))
    assert section("plane_strain").failed > 0
    assert section("finite_bodies").failed > 0
    assert section("whole_roller").failed > 0


def test_a_whole_roller_that_is_five_per_cent_softer_at_large_is_noticed(monkeypatch):
    right = whole_roller.WholeRoller.displacement
    monkeypatch.setattr(whole_roller.WholeRoller, "displacement", lambda *args: 1.05 * right(*args))
    failed = [check.claim for check in section("whole_roller").checks if check.passed is False]
    assert failed
    assert all("whole roller" in claim or "hollow roller" in claim for claim in failed)


def too_soft_strips(monkeypatch):
    right = one.influence_of

    def softer(*arguments):
        found = right(*arguments)
        return replace(found, terms=found.terms * [1.0, 1.0, 1.05])

    monkeypatch.setattr(one, "influence_of", softer)


def too_soft_cells(monkeypatch):
    right = kernel.rectangles
    for module in (convolution, inverse):
        monkeypatch.setattr(module, "rectangles", lambda *edges: 1.05 * right(*edges))


def tilted_crown():
    return next(case for case in plane_grid._CASES if case.name == "tilted crown")


def test_a_kernel_of_strips_that_is_five_per_cent_off_is_noticed(monkeypatch):
    too_soft_strips(monkeypatch)
    found = nh.compare(tilted_crown().contact, **tilted_crown().given)
    failed = [check.claim for check in plane_grid._checks(tilted_crown(), found) if check.passed is False]
    assert {"tilted crown: approach", "tilted crown: pressure in the middle"} <= set(failed)


def test_a_table_that_is_five_per_cent_off_contradicts_what_strips_do_far_away(monkeypatch):
    monkeypatch.setitem(vars(nh.SEMI_ELLIPTIC), "table", 1.05 * nh.SEMI_ELLIPTIC.table)
    with pytest.raises(nh.ConvergenceError, match="leaves a gap"):
        nh.solve(tilted_crown().contact, **tilted_crown().given)


def test_a_kernel_of_cells_that_is_five_per_cent_off_is_noticed_by_the_last_check(monkeypatch):
    too_soft_cells(monkeypatch)
    with pytest.raises(nh.ConvergenceError, match="a separate check of their solution failed"):
        nh.compare(tilted_crown().contact, **tilted_crown().given)


def claims_that_fail(checks):
    return [check.claim for check in checks if check.passed is False]


def test_slices_that_are_five_per_cent_too_stiff_are_noticed(monkeypatch):
    monkeypatch.setattr(standard, "lamina_stiffness", lambda *given: 1.05 * lamina_stiffness(*given))
    failed = claims_that_fail(bearings._laminae())
    assert sum(claim.endswith("displacement") for claim in failed) == 3


def test_normals_of_raceways_that_are_two_milliradians_off_are_noticed(monkeypatch):
    # Slices take theirs elsewhere, where the rollers' own loads have to be along them.
    right = rows.raceway_motion
    monkeypatch.setattr(rows, "raceway_motion", lambda angle, **more: right(angle + 2e-3, **more))
    failed = claims_that_fail(bearings._in_space())
    assert [claim.partition(":")[0] for claim in failed] == ["two HR30306J, strips"] * 2


def test_contacts_of_bearings_that_are_a_per_cent_too_stiff_are_noticed(monkeypatch):
    right = StripLaw.pressed
    monkeypatch.setattr(StripLaw, "pressed", lambda *args: 1.01 * right(*args))
    failed = claims_that_fail(bearings._by_hand(bearings._Nu206.solved()))
    assert "NU 206: displacement" in failed


def test_a_stiffness_that_is_a_hundredth_of_a_per_cent_off_is_noticed(monkeypatch):
    right = bearings.balanced

    def off(*args, **more):
        found = right(*args, **more)
        return found._replace(stiffness=1.0001 * found.stiffness)

    monkeypatch.setattr(bearings, "balanced", off)
    monkeypatch.setattr(verb, "balanced", off)
    assert len(claims_that_fail(bearings._derivatives())) == 2

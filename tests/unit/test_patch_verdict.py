"""The last check: no solution leaves that breaks a condition, whatever went wrong before it."""

from dataclasses import replace

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.prescription import Prescription
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.surface import Surface
from nonhertz.patch.verdict import displacement, find_complaint

PLAIN = {"side_faces": "none", "depth": "none"}
BODIES = {
    name: nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(1000), **given), nh.Plate())
    for name, given in (
        ("half-spaces", PLAIN),
        ("faces and depth", {}),
        ("images", {"images": 3}),
        ("free", {"side_faces": "free"}),
    )
}
CONTACT = BODIES["faces and depth"]
GIVEN = Prescription(load=3e3, moment=2e3)
BY_MOTION = Prescription(approach=0.01, tilt=2e-4)
GAP = Surface.checked(CONTACT, None, ())
CELLS = (23, 41)  # of which blocks of rows are no multiple
TOLERANCE = 1e-8


@pytest.fixture(scope="module")
def solution():
    return nh.patch.solve(CONTACT, load=3e3, moment=2e3, cells=CELLS)


@pytest.mark.parametrize("name", BODIES)
def test_its_displacement_is_that_of_the_iterations(name):
    found = nh.patch.solve(BODIES[name], load=3e3, tilt=2e-4, cells=CELLS)
    places = np.argwhere(np.ones(CELLS))[::7]
    rigid = found.approach + found.tilt * found.y
    theirs = found.gap + rigid - nh.patch.undeformed_gap(BODIES[name], found.x[:, None], found.y)
    # Sums in another order.
    np.testing.assert_allclose(displacement(found, places), theirs[tuple(places.T)], rtol=1e-11, atol=0.0)


def one_cell(array, index, value):
    changed = array.copy()
    changed[index] = value
    return changed


def peak(solution):
    return np.unravel_index(solution.pressure.argmax(), CELLS)


def skewed(solution):
    """Pressures of no load and no moment that pull nowhere when added."""
    change = np.zeros(CELLS)
    i, j = peak(solution)
    change[i, j], change[i + 2, j] = -10.0, 10.0
    return change


TAMPERED = {
    "The approach is nan": lambda s: {"approach": np.nan},
    "The pressure of a cell is not a finite number": lambda s: {"pressure": one_cell(s.pressure, peak(s), np.nan)},
    "The gap of a cell is not a number": lambda s: {"gap": one_cell(s.gap, (0, 0), np.nan)},
    "A cell is in tension, 1 MPa": lambda s: {"pressure": one_cell(s.pressure, (0, 0), -1.0)},
    "The load came to 1500 N instead of 3000 N": lambda s: {"pressure": 0.5 * s.pressure},
    "The load came to 3003 N instead of 3000 N": lambda s: {"load": 1.001 * s.load},
    "The moment came to 2002 N mm instead of 2000 N mm": lambda s: {"moment": 1.001 * s.moment},
    "The moment came to 1750 N mm instead of 2000": lambda s: {"pressure": s.pressure[:, ::-1].copy()},
    "Cells under pressure are apart or overlap by 1e-09 mm": lambda s: {"gap": one_cell(s.gap, peak(s), 1e-9)},
    "Cells without pressure overlap by 1e-09 mm": lambda s: {"gap": one_cell(s.gap, (0, 0), -1e-9)},
    "The gap is not that of the bodies": lambda s: {"approach": 1.001 * s.approach},
    "The gap is not that of the bodies under these": lambda s: {"pressure": s.pressure[::-1].copy() + skewed(s)},
}


@pytest.mark.parametrize("sentence", TAMPERED)
def test_what_is_changed_after_the_solve_is_seen(solution, sentence):
    assert find_complaint(solution, GAP, GIVEN, TOLERANCE) == ""
    tampered = replace(solution, **TAMPERED[sentence](solution))
    assert find_complaint(tampered, GAP, GIVEN, TOLERANCE).startswith(sentence)


def test_another_approach_or_tilt_than_prescribed_is_seen():
    found = nh.patch.solve(CONTACT, approach=0.01, tilt=2e-4, cells=CELLS)
    assert find_complaint(found, GAP, BY_MOTION, TOLERANCE) == ""
    assert find_complaint(replace(found, approach=0.0101), GAP, BY_MOTION, TOLERANCE).startswith("The approach came to")
    assert find_complaint(replace(found, tilt=2.1e-4), GAP, BY_MOTION, TOLERANCE).startswith(
        "The tilt came to 0.00021 rad"
    )


def test_pressure_on_cells_without_a_body_is_seen(solution):
    def cut(x, y):
        return np.where(x < 0.0, np.inf, GAP(x, y))

    assert find_complaint(solution, cut, GIVEN, TOLERANCE).startswith(
        "Cells without a body, where the gap is infinite, carry"
    )


def test_a_wrong_convolution_does_not_leave_the_package(monkeypatch):
    true = Convolution.__call__
    monkeypatch.setattr(Convolution, "__call__", lambda self, pressure: 1.001 * true(self, pressure))
    with pytest.raises(nh.ConvergenceError, match="separate check of their solution failed") as caught:
        nh.patch.solve(CONTACT, load=3e3, cells=CELLS)
    assert caught.value.solution.status is nh.Status.REFUTED
    assert caught.value.solution.load == pytest.approx(3e3)


def test_a_gap_that_changes_its_mind_does_not_leave_the_package():
    asked = []

    def gap(x, y):
        asked.append(1)
        return x**2 / 20.0 + y**2 / 2000.0 + 1e-5 * len(asked) * y

    with pytest.raises(nh.ConvergenceError, match="a gap that returns different values when called again"):
        nh.patch.solve(CONTACT, load=3e3, gap=gap, cells=CELLS, region=((-0.3, 0.3), (-5.0, 5.0)))

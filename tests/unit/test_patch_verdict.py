"""The last check: no solution leaves that breaks a condition, whatever went wrong before it."""

from dataclasses import replace

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.prescription import Prescription
from nonhertz.patch.convolution import Convolution
from nonhertz.patch.settle import settle
from nonhertz.patch.surface import Surface
from nonhertz.patch.verdict import complaint, displacement

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


def tampered(solution, case):
    peak = np.unravel_index(solution.pressure.argmax(), CELLS)
    return {
        "approach is nan": lambda: replace(solution, approach=np.nan),
        "pressure is nan": lambda: replace(solution, pressure=one_cell(solution.pressure, peak, np.nan)),
        "gap is nan": lambda: replace(solution, gap=one_cell(solution.gap, (0, 0), np.nan)),
        "pulls": lambda: replace(solution, pressure=one_cell(solution.pressure, (0, 0), -1.0)),
        "half the load": lambda: replace(solution, pressure=0.5 * solution.pressure),
        "load misstated": lambda: replace(solution, load=1.001 * solution.load),
        "moment misstated": lambda: replace(solution, moment=1.001 * solution.moment),
        "moment of another": lambda: replace(solution, pressure=solution.pressure[:, ::-1].copy()),
        "apart in contact": lambda: replace(solution, gap=one_cell(solution.gap, peak, 1e-9)),
        "overlap elsewhere": lambda: replace(solution, gap=one_cell(solution.gap, (0, 0), -1e-9)),
        "another approach": lambda: replace(solution, approach=1.001 * solution.approach),
        "pressure turned": lambda: replace(solution, pressure=solution.pressure[::-1].copy() + skewed(solution)),
    }[case]()


def skewed(solution):
    """Pressures of no load and no moment that pull nowhere when added."""
    change = np.zeros(CELLS)
    i, j = np.unravel_index(solution.pressure.argmax(), CELLS)
    change[i, j], change[i + 2, j] = -10.0, 10.0
    return change


@pytest.mark.parametrize(
    ("case", "sentence"),
    [
        ("approach is nan", "The approach is nan"),
        ("pressure is nan", "The pressure of a cell is not a finite number"),
        ("gap is nan", "The gap of a cell is not a number"),
        ("pulls", "A cell is in tension, 1 MPa"),
        ("half the load", "The load came to 1500 N instead of 3000 N"),
        ("load misstated", "The load came to 3003 N instead of 3000 N"),
        ("moment misstated", "The moment came to 2002 N mm instead of 2000 N mm"),
        ("moment of another", "The moment came to 1750 N mm instead of 2000"),
        ("apart in contact", "Cells that bear a pressure are apart or overlap by 1e-09 mm"),
        ("overlap elsewhere", "Cells without pressure overlap by 1e-09 mm"),
        ("another approach", "The gap is not that of the bodies under these pressures"),
        ("pressure turned", "The gap is not that of the bodies under these pressures"),
    ],
)
def test_what_is_changed_after_the_solve_is_seen(solution, case, sentence):
    assert complaint(solution, GAP, GIVEN, TOLERANCE) == ""
    assert complaint(tampered(solution, case), GAP, GIVEN, TOLERANCE).startswith(sentence)


def test_another_approach_or_tilt_than_prescribed_is_seen():
    found = nh.patch.solve(CONTACT, approach=0.01, tilt=2e-4, cells=CELLS)
    assert complaint(found, GAP, BY_MOTION, TOLERANCE) == ""
    assert complaint(replace(found, approach=0.0101), GAP, BY_MOTION, TOLERANCE).startswith("The approach came to")
    assert complaint(replace(found, tilt=2.1e-4), GAP, BY_MOTION, TOLERANCE).startswith("The tilt came to 0.00021 rad")


def test_pressure_on_cells_without_a_body_is_seen(solution):
    def cut(x, y):
        return np.where(x < 0.0, np.inf, GAP(x, y))

    assert complaint(solution, cut, GIVEN, TOLERANCE).startswith(
        "Cells without a body, where the gap is infinite, bear"
    )


def test_a_wrong_convolution_does_not_leave_the_package(monkeypatch):
    true = Convolution.__call__
    monkeypatch.setattr(Convolution, "__call__", lambda self, pressure: 1.001 * true(self, pressure))
    with pytest.raises(nh.ConvergenceError, match="separate check of their solution failed") as caught:
        nh.patch.solve(CONTACT, load=3e3, cells=CELLS)
    assert caught.value.solution.status is nh.Status.REFUTED
    assert caught.value.solution.load == pytest.approx(3e3)


def test_a_state_at_another_load_does_not_leave_the_package(monkeypatch):
    def half(task, pressure, rigid, tolerance):
        lesser = replace(task, target=(0.5 * task.target[0], task.target[1]))
        return settle(lesser, pressure, rigid, tolerance)

    monkeypatch.setattr("nonhertz.patch.cascade.settle", half)
    with pytest.raises(nh.ConvergenceError, match="The load came to 1500 N instead of 3000 N"):
        nh.patch.solve(CONTACT, load=3e3, cells=CELLS)


def test_a_gap_that_changes_its_mind_does_not_leave_the_package():
    asked = []

    def gap(x, y):
        asked.append(1)
        return x**2 / 20.0 + y**2 / 2000.0 + 1e-5 * len(asked) * y

    with pytest.raises(nh.ConvergenceError, match="a gap that returns different values when called again"):
        nh.patch.solve(CONTACT, load=3e3, gap=gap, cells=CELLS, region=((-0.3, 0.3), (-5.0, 5.0)))

"""Waves as short as the contact is wide, against the plane grid, which lets the pressure across have any shape."""

from dataclasses import dataclass

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.profile.base import Formula
from nonhertz.result.checks import MODEL_ERROR, MOST_UNEVEN, checks

HALF_SPACE = {"side_faces": "none", "depth": "none"}
HALF_WIDTH = 0.4  # about that of the contact below
LEFT = 4e-4  # the plane grid's own error at 64 x 1024 cells, as stated, and that of the strips


@dataclass(frozen=True)
class Waves(Formula):
    """Relief height (1 - cos(2 pi y / length)) / 2 on a crown of 1500 mm."""

    height: float
    length: float

    def relief_at(self, y):
        return 0.5 * self.height * (1.0 - np.cos(2.0 * np.pi * y / self.length)) + y**2 / 3000.0


def waved(height, length):
    return nh.Contact(nh.Roller(diameter=20, length=20, profile=Waves(height, length), **HALF_SPACE), nh.Plate())


def solved(contact, **options):
    with without_accuracy_warnings():
        return nh.solve(contact, load=10e3, **options)


def unevenness(solution):
    made = checks(solution, solution.judgement.judged(solution).checks, ())
    (check,) = (each for each in made if each.assumption.startswith("Relief that varies slowly"))
    return check.value


@pytest.mark.slow
@pytest.mark.parametrize(("height", "half_widths"), [(0.8e-3, 1.0), (1.6e-3, 0.75), (1.6e-3, 1.5)])
def test_what_short_waves_cost_the_approach_is_within_what_is_said(height, half_widths):
    contact = waved(height, half_widths * HALF_WIDTH)
    strips = solved(contact, accuracy=1e-5)
    grid = nh.patch.solve(contact, load=10e3, cells=(64, 1024))
    assert abs(strips.approach / grid.approach - 1.0) < MODEL_ERROR * unevenness(strips) ** 2 + LEFT


@pytest.mark.slow
def test_waves_that_matter_are_warned_of_alone_and_in_a_batch():
    contact = waved(1.6e-3, HALF_WIDTH)
    with pytest.warns(nh.AccuracyWarning) as said:
        solution = nh.solve(contact, load=10e3)
    assert any("bodies depart by" in str(each.message) for each in said)
    assert unevenness(solution) > MOST_UNEVEN
    with pytest.warns(nh.AccuracyWarning, match="2 of 2 cases strain the model"):
        found = nh.solve_many(contact, load=[9e3, 10e3])
    assert any("Such short waves" in sentence for sentence in found.warnings[1])


@pytest.mark.parametrize("half_widths", [4.0, 8.0])
def test_longer_waves_are_no_waves_within_a_half_width(half_widths):
    assert unevenness(solved(waved(1.6e-3, half_widths * HALF_WIDTH))) < 0.2 * MOST_UNEVEN

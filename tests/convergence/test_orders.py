"""How fast the strips converge.

The error of equal strips goes up and down with the place of the contact's end within its strip, and crosses
zero now and then. An order is therefore fitted either to the root mean square of neighbouring counts, or to a
sequence of counts that keeps that place.
"""

from dataclasses import dataclass

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.model.profile import Profile

HALF_SPACE = {"side_faces": "none", "depth": "none"}
EXACT = nh.hertz.point_contact(radius_x=10, radius_y=100, load=1000, compliance=2 * nh.Material(207000, 0.3).compliance)


@dataclass(frozen=True)
class Parabola(Profile):
    radius: float

    def relief(self, y):
        return np.asarray(y, dtype=float) ** 2 / (2.0 * self.radius)


def errors(strips):
    """Relative errors in approach, greatest pressure and stiffness of equal strips on abs(y) <= 1.3 a."""
    body = nh.Body(diameter=20, length=2.6 * EXACT.half_length, profile=Parabola(100.0), side_faces="none")
    solution = nh.solve(nh.Contact(body, nh.Plate()), load=1000, strips=strips)
    return np.array(
        [
            solution.approach / EXACT.approach - 1.0,
            solution.max_pressure / EXACT.max_pressure - 1.0,
            solution.stiffness[0, 0] / EXACT.stiffness - 1.0,
        ]
    )


def order(counts, values):
    """Exponent of the power law fitted to |error| over the number of strips, per column."""
    return -np.polyfit(np.log(counts), np.log(np.abs(values)), 1)[0]


@pytest.fixture(scope="module")
def typical_errors():
    """Root mean square over thirteen neighbouring counts, at four levels."""
    levels = np.array([40, 80, 160, 320])
    squares = [np.mean([errors(n) ** 2 for n in range(level, level + 13)], axis=0) for level in levels]
    return levels, np.sqrt(squares)


def test_orders_of_approach_and_pressure_are_at_least_three_halves_and_that_of_stiffness_one(typical_errors):
    # The figures to reach. The stiffness is a derivative by the place of the contact's end: one order less.
    approach, pressure, stiffness = order(*typical_errors)
    assert approach > 1.5  # 1.7 here, and 2 asymptotically
    assert pressure > 1.5
    assert stiffness > 1.0


def test_order_is_nearly_two_where_the_end_keeps_its_place_in_its_strip():
    # Multiples of 26: 2 a is then 20, 40, 80 ... strips, and a strip's edge lies on the end every time.
    counts = np.array([26, 52, 104, 208])
    found = np.array([errors(n) for n in counts])
    # Ratios of neighbours, not a fit: each halving of the width must pay.
    orders = np.log2(np.abs(found[:-1, 0] / found[1:, 0]))
    assert np.all((orders > 1.8) & (orders < 2.2))


def orders_at_a_sharp_end(element, **bodies):
    """Orders of the approach of a straight roller on a plate, from 20, 40, 80 ... equal strips."""
    contact = nh.Contact(nh.Roller(diameter=20, length=20, **bodies), nh.Plate())
    counts = (20, 40, 80, 160, 320)
    steps = np.diff([nh.solve(contact, load=20e3, strips=n, element=element).approach for n in counts])
    return np.log2(steps[:-1] / steps[1:])


@pytest.mark.filterwarnings("ignore:The maximum pressure is uncertain")  # of few strips
@pytest.mark.parametrize("element", [nh.SEMI_ELLIPTIC, nh.PARABOLIC], ids=lambda e: e.name)
def test_order_at_a_sharp_end_is_one(element):
    # p ~ s^(-1/2) at the end: what one strip makes of that is off in proportion to its width.
    orders = orders_at_a_sharp_end(element, **HALF_SPACE)
    assert np.all((orders > 0.7) & (orders < 1.1))
    assert np.all(np.diff(orders) > 0.0)  # on the way to 1

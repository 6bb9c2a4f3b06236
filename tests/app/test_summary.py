"""What the summary and the result say about the pressure where a contact ends."""

import math
import re

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.result.solution import Solution
from nonhertz.show.summary import summary_rows


def solved(roller: nh.Body, against: nh.Body, tilt: float = 0.0, load: float = 20e3, **more: object) -> Solution:
    with without_accuracy_warnings():
        return nh.solve(nh.Contact(roller, against), load=load, tilt=tilt, **more)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def sharp():
    """A straight roller on a plate, both half-spaces."""
    roller = nh.Roller(diameter=20, length=20, side_faces="none", depth="none")
    return solved(roller, nh.Plate(depth="none"), tilt=0.5e-3)


def rows(solution: Solution) -> dict[str, tuple[str, str]]:
    """Return values and remarks by name; what follows under a name is ``name+``."""
    found: dict[str, tuple[str, str]] = {}
    name = ""
    for title, value, remark in summary_rows(solution):
        name = title or f"{name}+"
        found[name] = (value, remark)
    return found


def test_a_singular_end_has_a_strength_beside_the_maximum(sharp):
    shown = rows(sharp)
    high = sharp.edge_pressure[1]
    assert shown["edge at y = 10 mm"] == ("singular", f"p ~ K / s^0.5, K = {high.strength:.4g} MPa mm^0.5")
    assert shown["edge at y = -10 mm"][0] == "singular"
    assert f"{sharp.centre_pressure.max():.0f}" not in str(shown)


def test_the_maximum_is_a_half_width_from_a_singular_end(sharp):
    shown = rows(sharp)
    pressure, error = shown["maximum pressure"]
    where, away = shown["maximum pressure+"]
    assert re.fullmatch(r"error about [\d.]+ %", error)
    assert away == "away from singular ends"
    y = float(where.removeprefix("at y = ").removesuffix(" mm"))
    # Five digits are printed.
    assert 10.0 - y == pytest.approx(np.interp(y, sharp.y, sharp.half_width), abs=1e-3)
    between = np.interp(y, sharp.y, sharp.centre_pressure)
    assert float(pressure.removesuffix(" MPa")) == pytest.approx(between, rel=3e-3)
    assert between < 0.5 * sharp.centre_pressure.max()


def test_a_strength_that_too_few_strips_leave_unknown_is_called_so():
    coarse = solved(nh.Roller(diameter=20, length=20), nh.Plate(), strips=7)
    shown = rows(coarse)
    assert shown["edge at y = 10 mm"] == ("singular", "p ~ K / s^0.226, K unknown")
    assert shown["maximum pressure+"][1] == "away from singular ends"


def test_strips_that_end_before_the_contact_are_said_to_cut_it_off():
    cut = solved(nh.Roller(diameter=20, length=20), nh.Plate(), strips=np.linspace(-5.0, 6.0, 45))
    shown = rows(cut)
    value, remark = shown["edge at y = 6 mm"]
    assert remark == "cut off by the strips"
    assert float(value.removesuffix(" MPa")) == pytest.approx(cut.edge_pressure[1].pressure, rel=1e-4)
    # The end strips bear the most, and only because they are the last.
    assert shown["maximum pressure"][1] == "cut off by the strips"


def test_a_maximum_at_a_corner_of_the_profile_has_no_limit():
    tapered = nh.Roller(diameter=20, length=20, profile=nh.profile.tapered_ends(straight=10, angle=10e-3))
    cornered = solved(tapered, nh.Plate(), load=5e3)
    assert {edge.kind for edge in cornered.edge_pressure} == {nh.EdgeKind.RUN_OUT}
    assert rows(cornered)["maximum pressure"][1] == "unbounded, at a corner of the profile"


@pytest.mark.parametrize("tilt", [math.radians(2.0), -math.radians(2.0)])
def test_a_tilt_that_leaves_one_end_in_contact_is_remarked_and_strains_nothing(tilt):
    roller = nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(4000.0))
    found = solved(roller, nh.Plate(), tilt=tilt)
    pressed = found.edges[1:][found.line_load > 0.0] - found.edges[:-1][found.line_load > 0.0]
    (remark,) = found.remarks
    touching, common = dict(remark.numbers)["parts"].values
    assert touching == pytest.approx(pressed.sum(), abs=2.0 * pressed.max())
    assert common == 20.0
    assert str(remark) == f"Only {touching:.3g} of 20 mm are in contact, at one end."
    assert rows(found)["contact along y"][1] == str(remark)
    assert remark not in found.findings


def test_a_hollow_profile_that_touches_at_both_ends_is_remarked_as_such():
    hollow = nh.Roller(diameter=15.0, length=20.0, corner_radius=0.5, profile=nh.profile.crown(-3000.0))
    (remark,) = solved(hollow, nh.Ring(diameter=80.0, length=24.0), load=2e3).remarks
    assert str(remark).endswith("of 20 mm are in contact, at both ends.")


@pytest.mark.parametrize(
    ("radius", "tilt", "load"),
    [(4000.0, 0.5e-3, 20e3), (4000.0, 3e-3, 20e3), (200.0, 0.0, 2e3), (200.0, 0.01, 2e3)],
)
def test_what_bears_on_most_of_its_length_or_in_its_middle_is_not_remarked(radius, tilt, load):
    roller = nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(radius))
    assert solved(roller, nh.Plate(), tilt=tilt, load=load).remarks == ()

"""What keeps numbers of several cases in a report from being compared."""

from __future__ import annotations

import warnings
from dataclasses import replace

import pytest

import nonhertz as nh
from nonhertz.files.bearingfile import BearingCase, starting_bearing
from nonhertz.files.held import parsed
from nonhertz.report import settled, settled_bearings
from nonhertz.report.basis import basis
from nonhertz.report.bearing.basis import bearing_basis
from nonhertz.strip.element import PARABOLIC

ROLLER = nh.Roller(diameter=15.0, length=15.0, profile=nh.profile.iso_logarithmic(diameter=15.0, length=15.0))
RING = nh.Ring(diameter=60.0)
CASE = nh.Case(nh.Contact(ROLLER, RING), {"load": 4e3}, {"strips": 15})


def against(**changes: object) -> list[str]:
    """Return the sentences on CASE beside a changed one."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        return basis(settled([CASE, replace(CASE, **changes)]))


def contact(a: object = ROLLER, b: object = RING) -> dict[str, object]:
    return {"contact": nh.Contact(a, b)}


def test_equal_cases_compare() -> None:
    assert against() == []


@pytest.mark.parametrize(
    ("changes", "begins", "contains"),
    [
        ({"prescribed": {"load": 5e3}}, "Pressures, approaches and lives are those of different loads:", "5 kN"),
        ({"prescribed": {"load": 4e3, "tilt": 1e-3}}, "Results are those of different alignment:", "a tilt of 1 mrad"),
        (
            contact(b=replace(RING, depth=12.0)),
            "Approaches not comparable, since displacement of body b is measured against different points:",
            "a point 12 mm below the surface (case (2))",
        ),
        (
            contact(replace(ROLLER, effective_length=14.0)),
            "Loads per length differ with the length over which the bodies can touch:",
            "15 mm (case (1)); 14 mm, an effective length (case (2))",
        ),
        (
            contact(b=replace(RING, material=nh.MATERIALS["bronze"])),
            "Pressures and approaches are those of different materials of body b:",
            "bronze (case (2))",
        ),
        ({"solver": {"strips": 15, "element": PARABOLIC}}, "Differences of a few per cent", "parabolic (case (2))"),
        ({"solver": {"strips": 17}}, "Small differences may come from the grids", "17 strips (case (2))"),
        (
            contact(nh.Roller(diameter=15.0, length=15.0)),
            "Maximum pressures not comparable:",
            "away from singular ends, where the pressure has no limit (case (2))",
        ),
    ],
)
def test_each_difference_is_named(changes: dict[str, object], begins: str, contains: str) -> None:
    (sentence,) = [each for each in against(**changes) if each.startswith(begins)]
    assert contains in sentence


def test_side_faces_are_named_and_with_them_what_is_measured() -> None:
    sentences = against(**contact(replace(ROLLER, side_faces="mirror")))
    assert [each.partition(",")[0] for each in sentences] == [
        "Approaches not comparable",
        "Pressures near the ends not comparable",
    ]
    assert sentences[1].endswith("free (case (1)); mirror (case (2)).")


def test_bearings_by_slices_or_with_other_loads_do_not_compare() -> None:
    document = parsed(starting_bearing(), "bearing.toml")
    one = BearingCase.of(document, CASE.path)
    slices = replace(one, solver={"method": "slices"})
    heavy = replace(slices, prescribed=one.prescribed | {"radial": 2e4})
    assert bearing_basis(settled_bearings([slices, slices])) == []
    (sentence,) = bearing_basis(settled_bearings([slices, heavy]))
    assert sentence.startswith("Displacements, pressures and lives are those of different loads: under ")
    loose = replace(slices, bearing=replace(one.bearing, clearance=0.04))
    (sentence,) = bearing_basis(settled_bearings([slices, loose]))
    assert sentence.endswith("; 40 µm (case (2)).")

"""The nomenclature page and the code name the same things, with the same units."""

from __future__ import annotations

import dataclasses
import inspect
import re
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.files.results import UNITS
from nonhertz.inputs.fields import Input, Quantities, Quantity
from nonhertz.model.profile import PARAMETERS
from nonhertz.strip.element import Element

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "nomenclature.md"
CLASSES = {
    "`Solution`": nh.Solution,
    "`ErrorEstimate`": nh.ErrorEstimate,
    "`EdgePressure`": nh.EdgePressure,
    "`Contact`": nh.Contact,
    "`Body`": nh.Body,
    "`TabulatedDiameter`": nh.TabulatedDiameter,
    "`Material`": nh.Material,
    "`hertz.PointContact`": nh.hertz.PointContact,
    "`hertz.LineContact`": nh.hertz.LineContact,
    "`Element`": Element,
    "`subsurface.Field`": nh.subsurface.Field,
    "`subsurface.Passage`": nh.subsurface.Passage,
    "`subsurface.Extreme`": nh.subsurface.Extreme,
    "`life.Life`": nh.life.Life,
    "`strength.Strength`": nh.strength.Strength,
    "`strength.Check`": nh.strength.Check,
    "`bearing.Rating`": nh.bearing.Rating,
    "`maps.MapPoint`": nh.maps.MapPoint,
    "`maps.SampledErrors`": nh.maps.SampledErrors,
}


def tables() -> dict[str, dict[str, str]]:
    """Return for every section of the page its names and their units."""
    sections = re.split(r"^## ", PAGE.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    rows = {}
    for section in sections:
        heading, _, body = section.partition("\n")
        cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in body.splitlines() if "|" in line]
        rows[heading.strip()] = {cell[1].strip("`"): cell[2] for cell in cells if cell[1].startswith("`")}
    return rows


def public(cls: type) -> set[str]:
    """Return the public attributes that a class has, its own and those of the classes that it is made of.

    What describes its fields is not among them.
    """
    of_fields = {field.name for field in dataclasses.fields(cls)}
    of_classes = {name for each in cls.__mro__[:-1] for name in vars(each)}
    of_judgement = {"judgement"}  # whose parts are listed
    return {name for name in (of_fields | of_classes) - set(vars(Input)) - of_judgement if not name.startswith("_")}


def test_every_section_is_of_something_in_the_code():
    assert set(tables()) == {"`solve`", "Profile parameters", *CLASSES}


@pytest.mark.parametrize("heading", CLASSES)
def test_a_class_has_the_names_that_the_page_lists(heading):
    assert set(tables()[heading]) == public(CLASSES[heading])


def test_the_verb_has_the_arguments_that_the_page_lists():
    assert set(tables()["`solve`"]) == set(inspect.signature(nh.solve).parameters)


def test_rollers_rings_and_plates_add_nothing_of_their_own():
    for kind in (nh.Roller, nh.Ring, nh.Plate):
        assert public(kind) <= public(nh.Body)


def test_profile_parameters_have_the_units_that_the_page_lists():
    # The page writes 1 where there is no unit.
    every = [named for each in PARAMETERS.values() for named in each.descriptions.items()]
    units = {name: each.unit or "1" for name, each in every if isinstance(each, Quantity | Quantities)}
    assert tables()["Profile parameters"] == units


def test_results_on_disk_have_the_units_that_the_page_lists():
    listed = tables()["`Solution`"]
    assert set(UNITS) <= set(listed)
    for name, unit in UNITS.items():
        if isinstance(unit, str):
            assert listed[name] == unit, name


def test_one_name_has_one_unit_everywhere():
    units: dict[str, set[str]] = {}
    for heading, rows in tables().items():
        # Errors are named after what they are relative to, and a stiffness is a matrix or a number.
        if heading not in {"`ErrorEstimate`", "`maps.SampledErrors`"}:
            for name, unit in rows.items():
                units.setdefault(name, set()).add(unit)
    assert {name: found for name, found in units.items() if len(found) > 1} == {
        "stiffness": {"N/mm", "N/mm, N/rad; N, N mm/rad"}
    }

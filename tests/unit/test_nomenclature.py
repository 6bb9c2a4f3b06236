"""The nomenclature page and the code name the same things, with the same units."""

import dataclasses
import importlib
import inspect
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import nonhertz as nh
from nonhertz.files.results import Key, units_of
from nonhertz.files.schemas import RESULTS
from nonhertz.inputs.descriptions import Quantities, Quantity
from nonhertz.model.profile import PARAMETERS

PAGE = Path(__file__).parents[2] / "docs" / "reference" / "nomenclature.md"
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")[:3]]
    for line in PAGE.read_text(encoding="utf-8").replace(r"\|", "").splitlines()
    if re.match(r"\|[^|]*\| `", line)
]
MODULES = ("bearing", "hertz", "life", "maps", "strength", "subsurface")
LISTED = {name.strip("`"): unit for _, name, unit in ROWS}


def public_names() -> set[str]:
    """Return the fields, attributes and arguments of all that is public."""
    modules = [nh, nh.profile, *(importlib.import_module(f"nonhertz.{name}") for name in MODULES)]
    names: set[str] = set()
    for each in (getattr(module, name) for module in modules for name in dir(module) if not name.startswith("_")):
        if inspect.isclass(each):
            names |= set(dir(each))
            names |= {field.name for field in dataclasses.fields(each)} if dataclasses.is_dataclass(each) else set()
        elif inspect.isfunction(each):
            names |= set(inspect.signature(each).parameters)
    return names


def test_every_name_of_the_page_is_in_the_code_and_there_once():
    assert len(LISTED) == len(ROWS) > 90
    assert set(LISTED) - public_names() == set()


def every_key(keys: tuple[Key, ...]) -> Iterator[Key]:
    """Yield keys and those of the objects in them."""
    for key in keys:
        yield key
        yield from every_key(key.keys)


@pytest.mark.parametrize("kind", RESULTS)
def test_keys_of_results_say_what_they_are_and_have_the_units_that_the_page_lists(kind):
    _, keys, _ = RESULTS[kind]
    assert len({key.name for key in keys}) == len(keys)
    for key in every_key(keys):
        assert key.meaning, key.name
        # The page writes exponents by their symbols, and no revolutions.
        if isinstance(key.unit, str) and key.unit and key.name in LISTED and "exponent" not in key.unit:
            # Without a unit there: damage has none of its own, and density is of damage or of a material.
            listed = {LISTED[key.name]} if LISTED[key.name] else {"as damage", "t/mm^3"}
            assert key.unit.removesuffix(" revolutions") in listed, key.name
    if kind == "result":
        assert {name for name, unit in units_of(keys).items() if isinstance(unit, str)} <= LISTED.keys()


@pytest.mark.parametrize("kind", PARAMETERS)
def test_profile_parameters_have_the_units_that_the_page_lists(kind):
    # The page writes 1 where there is no unit.
    for name, each in PARAMETERS[kind].descriptions.items():
        if isinstance(each, Quantity | Quantities):
            assert LISTED[name] == (each.unit or "1"), name

"""The page in US units: the same numbers, sentences and fields in those, files as they are."""

import copy
import json
import re
import tomllib
from collections.abc import Iterator
from typing import Any

import pytest

from nonhertz.amounts import display_units
from nonhertz.files.starting import BEARING_TEMPLATES, TEMPLATES, starting_bearing, starting_case
from nonhertz.web.server.guard import UNITS as HEADER
from nonhertz.web.view import jobs

STARTING = tomllib.loads(starting_case())
SHARP = copy.deepcopy(STARTING)
SHARP["body"]["a"].pop("profile")
OF_SI = re.compile(r"(?:\d |\[)(?:mm|[uµ]m|nm|MPa|GPa|k?N)(?!\w)")
US_ALONE = {HEADER: "us"}


def texts(found: Any, leaving: tuple[str, ...] = ("title", "document", "text", "sliders")) -> Iterator[str]:
    """All text of an answer but for what somebody wrote."""
    if isinstance(found, dict):
        for name, value in found.items():
            if name not in leaving:
                yield from texts(value)
    elif isinstance(found, list):
        for value in found:
            yield from texts(value)
    elif isinstance(found, str):
        yield found


# The circles in the figure of the loads are at round numbers of what is read.
def numbers(found: Any, leaving: tuple[str, ...] = ("ms", "sliders", "factor", "loads")) -> Iterator[float]:
    if isinstance(found, dict):
        for name, value in found.items():
            if name not in leaving:
                yield from numbers(value)
    elif isinstance(found, list):
        for value in found:
            yield from numbers(value)
    elif isinstance(found, int | float):
        yield float(found)


def in_us_units(job: Any, *arguments: Any) -> Any:
    with display_units("us"):
        return json.loads(job(*arguments))


def in_si_units(found: Any) -> list[str]:
    return [text for text in texts(found) if OF_SI.search(text)]


CASES = {name: tomllib.loads(starting_case(name)) for name in TEMPLATES} | {"start": STARTING, "sharp": SHARP}
SOME = ("start", "sharp", "spherical")


@pytest.mark.parametrize("name", SOME)
def test_of_a_contact_sentences_change_and_numbers_do_not(name):
    usual, found = json.loads(jobs.solve(CASES[name], True, "a")), in_us_units(jobs.solve, CASES[name], True, "a")
    assert in_si_units(usual)
    assert in_si_units(found) == []
    assert list(numbers(found)) == list(numbers(usual))


@pytest.mark.parametrize(("name", "method"), [("cylindrical", "strips"), ("tapered-pair", "slices")])
def test_of_a_bearing_sentences_change_and_numbers_do_not(name, method):
    assert name in BEARING_TEMPLATES
    document = tomllib.loads(starting_bearing(name))
    usual = json.loads(jobs.load(document, method))
    found = in_us_units(jobs.load, document, method)
    assert in_si_units(usual)
    assert in_si_units(found) == []
    assert list(numbers(found)) == list(numbers(usual))

"""Mistakes stand at their fields, in the sentences of the command line, and go when they are mended."""

import copy
import tomllib
from pathlib import Path
from typing import Any

import pytest
from desk import packed
from numpy.testing import assert_allclose

from nonhertz.errors import CaseError
from nonhertz.files.casefile import Case
from nonhertz.files.starting import starting_case

pytestmark = pytest.mark.browser

SAME = 1e-9  # a prescribed load is met to the rounding of a sum over strips
SHOWN = "each => ({ colour: getComputedStyle(each).color, edge: getComputedStyle(each).borderLeftColor })"


def sentences_of(path: str, value: Any) -> tuple[str, ...]:
    """What the command line says of the starting case with one key changed."""
    document = tomllib.loads(starting_case())
    *way, last = path.split(".")
    table = document
    for key in way:
        table = table[key]
    table[last] = value
    with pytest.raises(CaseError) as caught:
        Case.of(document, Path("case.toml"))
    return caught.value.mistakes


def test_a_mistake_stands_at_its_field_until_it_is_mended(desk):
    good, coloured = desk.numbers, desk.page.locator("#verdict").evaluate(SHOWN)
    desk.write("load.load", "20 furlong")
    (sentence,) = sentences_of("load.load", "20 furlong")
    field = desk.field("load.load")
    place = desk.page.locator('.field[data-path="load.load"] .mistake')
    assert place.inner_text() == sentence
    assert field.get_attribute("aria-invalid") == "true"
    assert place.get_attribute("id") in field.get_attribute("aria-describedby").split()
    assert desk.page.locator("#state").inner_text() == "last good result"
    assert desk.numbers == good  # still there, dimmed
    assert float(desk.page.locator("#figures .drawing").first.evaluate("each => getComputedStyle(each).opacity")) < 1.0
    grey, verdict, number = (desk.page.locator(each).first.evaluate(SHOWN) for each in ("#state", "#verdict", ".value"))
    assert verdict["colour"] == number["colour"] == grey["colour"]
    assert verdict["edge"] != coloured["edge"]

    desk.write("load.load", "20 kN")
    assert not place.is_visible()
    assert field.get_attribute("aria-invalid") is None
    assert desk.mistakes == []
    assert desk.numbers == good


def test_the_list_on_top_leads_to_the_fields(desk):
    desk.write("body.a.diameter", "-20")
    desk.page.wait_for_function("() => location.hash !== ''")  # written a moment after the last key
    first = desk.page.evaluate("() => location.hash")
    desk.write("load.load", "20 furlong")
    assert desk.page.locator("#mistakes-title").inner_text() == "2 mistakes"
    assert len(desk.mistakes) == 2
    desk.page.wait_for_function("first => location.hash !== first", arg=first)
    fragment = desk.page.evaluate("() => location.hash")
    desk.page.locator("#mistakes-list a").first.click()
    assert desk.page.evaluate("() => document.activeElement.name") == "body.a.diameter"
    assert desk.page.evaluate("() => location.hash") == fragment  # which holds the case
    desk.photograph("mistakes")


def test_what_is_written_in_a_case_is_never_html(open_desk):
    document = tomllib.loads(starting_case())
    nasty = '<img src=x onerror="document.title=1"></script><b>bold</b>'
    document["title"] = nasty
    document["body"]["a"]["material"] = nasty
    document[nasty] = nasty
    desk = open_desk(f"#c={packed(document)}")
    assert nasty[:8] in desk.mistakes[0] + desk.mistakes[-1]
    assert desk.page.locator("img, main b").count() == 0
    mended = copy.deepcopy(document)
    mended["body"]["a"]["material"] = "steel"
    del mended[nasty]
    desk = open_desk(f"#c={packed(mended)}")
    assert desk.page.locator("h1").inner_text() == nasty
    assert desk.page.locator("img").count() == 0


def test_the_program_may_be_away_for_a_while(open_desk):
    desk = open_desk()
    desk.page.route("**/solve", lambda route: route.abort(), times=1)
    before = desk.answers
    desk.type(desk.field("load.load"), "25 kN")
    desk.page.locator("#notice:visible").wait_for()
    assert "nonhertz serve" in desk.page.locator("#notice").inner_text()
    desk.wait_for_answer(before)  # asked again by itself
    assert not desk.page.locator("#notice").is_visible()
    assert_allclose(desk.numbers["Load"], 25000.0, rtol=SAME)
    # The browser itself writes of the request that was cut off.
    desk.forgive("ERR_FAILED")
